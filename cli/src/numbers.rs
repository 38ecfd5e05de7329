//! Numbers, points and places as arguments. All are read exactly: `0.1` is a tenth, `1/3` a third, `1e-3` a thousandth.

use std::str::FromStr;
use symspline::{Q, Scalar};
use symspline_dynamic::{Coords, Field, Number, Over};

/// The largest power of ten that a number may be written with: floats end before.
const MAX_EXPONENT: u32 = 400;

/// A number as it is written: `p`, `p/q`, a decimal, or a decimal with a power of ten.
pub fn number(text: &str) -> Result<Q, String> {
    let refused = || format!("'{}' is not a number", text.chars().take(40).collect::<String>());
    let Some((digits, exponent)) = text.split_once(['e', 'E']) else {
        return text.parse().map_err(|_| refused());
    };
    if digits.contains('/') {
        return Err(refused());
    }
    let digits: Q = digits.parse().map_err(|_| refused())?;
    let power: i32 = exponent.parse().map_err(|_| refused())?;
    if power.unsigned_abs() > MAX_EXPONENT {
        return Err(format!("the power of ten in '{text}' is beyond {MAX_EXPONENT}"));
    }
    let scale = (0..power.unsigned_abs()).fold(Q::int(1), |scale, _| scale * Q::int(10));
    Ok(if power < 0 { digits / scale } else { digits * scale })
}

/// One number of either field.
#[derive(Clone, Debug, PartialEq)]
pub struct One(pub Q);

impl FromStr for One {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        number(text).map(Self)
    }
}

impl One {
    /// As a number of either field.
    pub fn number(&self) -> Number {
        Over::Exact(self.0.clone())
    }

    /// As a number of one field.
    pub fn of<T: Field>(&self) -> symspline_dynamic::Result<T> {
        T::of(&self.number())
    }
}

/// Numbers with commas between them: a point, a vector, knots.
#[derive(Clone, Debug, PartialEq)]
pub struct List(pub Vec<Q>);

impl FromStr for List {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.split(',').map(|part| number(part.trim())).collect::<Result<_, _>>().map(Self)
    }
}

impl List {
    /// As coordinates of either field.
    pub fn coords(&self) -> Coords {
        Over::Exact(self.0.clone())
    }
}

/// A place on a curve, `u`, or on a surface, `u:v`.
#[derive(Clone, Debug, PartialEq)]
pub struct Place(pub Vec<Q>);

impl FromStr for Place {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.trim().split(':').map(|part| number(part.trim())).collect::<Result<_, _>>().map(Self)
    }
}

/// Places with commas between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Places(pub Vec<Place>);

impl FromStr for Places {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.split(',').map(Place::from_str).collect::<Result<_, _>>().map(Self)
    }
}

/// Two places with a comma between them: `a,b` on a curve, `u0:v0,u1:v1` on a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Interval {
    /// Where it starts.
    pub from: Place,
    /// Where it ends.
    pub to: Place,
}

impl FromStr for Interval {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match <[Place; 2]>::try_from(text.parse::<Places>()?.0) {
            Ok([from, to]) => Ok(Self { from, to }),
            Err(places) => Err(format!("two places are needed, not {}", places.len())),
        }
    }
}

/// Whole numbers with colons between them: the index of a control point of a curve, `i`, or of a surface, `i:j`; an order.
#[derive(Clone, Debug, PartialEq)]
pub struct Index(pub Vec<usize>);

impl FromStr for Index {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let whole = |part: &str| part.trim().parse().map_err(|_| format!("'{part}' is not a whole number"));
        text.split(':').map(whole).collect::<Result<_, _>>().map(Self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_exactly() {
        assert_eq!(number("1/3"), Ok(Q::frac(1, 3)));
        assert_eq!(number("-0.10"), Ok(Q::frac(-1, 10)));
        assert_eq!(number("2.5e-3"), Ok(Q::frac(1, 400)));
        assert_eq!(number("-3E2"), Ok(Q::int(-300)));
        for text in
            ["", "x", "1/0", "1/2e3", "1e", "e5", "1e401", "1e99999999999", "0x10", "nan", "inf", "--1"]
        {
            assert!(number(text).is_err(), "{text}");
        }
    }

    #[test]
    fn lists_places_and_intervals() {
        assert_eq!("1, -1/2".parse(), Ok(List(vec![Q::int(1), Q::frac(-1, 2)])));
        assert_eq!(
            "1:2,3".parse(),
            Ok(Places(vec![Place(vec![Q::int(1), Q::int(2)]), Place(vec![Q::int(3)])]))
        );
        assert!("1,2,3".parse::<Interval>().is_err() && "1,,2".parse::<List>().is_err());
        assert_eq!("2:0".parse(), Ok(Index(vec![2, 0])));
        assert!("-1".parse::<Index>().is_err());
    }
}
