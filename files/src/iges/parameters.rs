//! Parameters: numbers and texts between delimiters.

use crate::error::Problem;
use crate::nurbs::real::{self, shown};
use symspline::limits::MAX_DEGREE;

type Read<T> = Result<T, Problem>;

pub(super) fn wrong<T>(what: impl Into<String>) -> Read<T> {
    Err(Problem::Syntax(what.into()))
}

/// What ends a parameter, and what ends the last one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Delimiters {
    parameter: u8,
    record: u8,
}

impl Delimiters {
    /// Those that the text of a global section begins with: `1H,,1H;,`, or nothing for the usual ones.
    pub(super) fn of(global: &[u8]) -> Read<Self> {
        let text = global.trim_ascii_start();
        let (parameter, rest) = match text {
            [b'1', b'H', parameter, next, rest @ ..] if next == parameter => (*parameter, rest),
            [b',', rest @ ..] => (b',', rest),
            _ => return wrong("the global section does not begin with a delimiter"),
        };
        let record = match rest.trim_ascii_start() {
            [b'1', b'H', record, ..] => *record,
            [next, ..] if *next == parameter => b';',
            _ => return wrong("the global section does not tell the second delimiter"),
        };
        let possible = |b: u8| b.is_ascii_graphic() && !b.is_ascii_alphanumeric() && !b"+-.".contains(&b);
        match possible(parameter) && possible(record) && parameter != record {
            true => Ok(Self { parameter, record }),
            false => wrong("the global section tells delimiters that are not possible"),
        }
    }
}

/// A parameter as it stands.
#[derive(Clone, Debug, PartialEq)]
enum Parameter {
    Word(String),
    Text(Vec<u8>),
}

/// The parameters of an entity, after its kind.
#[derive(Debug)]
pub(super) struct Parameters {
    all: Vec<Parameter>,
}

impl Parameters {
    /// Takes a text apart, up to the delimiter of records.
    pub(super) fn of(text: &[u8], by: Delimiters) -> Read<Self> {
        let (mut all, mut rest) = (Vec::new(), text);
        loop {
            rest = rest.trim_ascii_start();
            let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
            let parameter = if digits > 0 && rest.get(digits) == Some(&b'H') {
                let count = String::from_utf8_lossy(&rest[..digits]).parse::<usize>();
                let inside = &rest[digits + 1..];
                let Some((letters, after)) = count.ok().and_then(|count| inside.split_at_checked(count))
                else {
                    return wrong("a text is longer than the parameters");
                };
                rest = after.trim_ascii_start();
                Parameter::Text(letters.to_vec())
            } else {
                let length = rest.iter().take_while(|b| **b != by.parameter && **b != by.record).count();
                let word = String::from_utf8_lossy(rest[..length].trim_ascii()).into_owned();
                rest = &rest[length..];
                Parameter::Word(word)
            };
            all.push(parameter);
            match rest.split_first() {
                Some((end, _)) if *end == by.record => return Ok(Self { all }),
                Some((end, after)) if *end == by.parameter => rest = after,
                Some(_) => return wrong("after a text there is no delimiter"),
                None => return wrong("the parameters have no end"),
            }
        }
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether none was written here.
    pub(super) fn is_blank(&self, i: usize) -> bool {
        matches!(self.all.get(i), None | Some(Parameter::Word(_))) && self.word(i).is_ok_and(str::is_empty)
    }

    fn word(&self, i: usize) -> Read<&str> {
        match self.all.get(i) {
            None => Ok(""),
            Some(Parameter::Word(word)) => Ok(word),
            Some(Parameter::Text(_)) => wrong(format!("parameter {i} is a text, not a number")),
        }
    }

    /// A whole number; 0 if it was left out.
    pub(super) fn whole(&self, i: usize) -> Read<i64> {
        match self.word(i)? {
            "" => Ok(0),
            word => word
                .parse()
                .or_else(|_| wrong(format!("parameter {i}: '{}' is not a whole number", shown(word)))),
        }
    }

    /// A finite number; 0 if it was left out.
    pub(super) fn real(&self, i: usize) -> Read<f64> {
        match self.word(i)? {
            "" => Ok(0.0),
            word => match real::read(word) {
                Some(x) => Ok(x),
                None => wrong(format!("parameter {i}: '{}' is not a finite number", shown(word))),
            },
        }
    }

    /// Numbers in a row, all of them there.
    pub(super) fn reals(&self, from: usize, count: usize) -> Read<Vec<f64>> {
        match from.checked_add(count) {
            Some(to) if to <= self.len() => (from..to).map(|i| self.real(i)).collect(),
            _ => wrong(format!(
                "{count} numbers from parameter {from} on are told, {} parameters are there",
                self.len()
            )),
        }
    }

    /// A degree and how many control points there are less one.
    pub(super) fn sizes(&self, last: usize, degree: usize) -> Read<(usize, usize)> {
        let (last, degree) = (self.whole(last)?, self.whole(degree)?);
        match (usize::try_from(last), usize::try_from(degree)) {
            (Ok(last), Ok(p)) if (1..=MAX_DEGREE).contains(&p) && last >= p && last < self.len() => {
                Ok((last + 1, p))
            }
            _ => wrong(format!("an upper index of {last} and degree {degree} are not possible here")),
        }
    }

    /// A text.
    pub(super) fn text(&self, i: usize) -> Option<String> {
        match self.all.get(i) {
            Some(Parameter::Text(letters)) => Some(String::from_utf8_lossy(letters).into_owned()),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn delimiters_are_those_of_the_global_section() {
        let of = |text: &str| Delimiters::of(text.as_bytes()).map(|by| [by.parameter, by.record]);
        assert_eq!(of("1H,,1H;,4Hpart"), Ok(*b",;"));
        assert_eq!(of(",,4Hpart"), Ok(*b",;"));
        assert_eq!(of("1H//1H!/4Hpart"), Ok(*b"/!"));
        assert_eq!(of(",1H!,"), Ok(*b",!"));
        for text in ["", "1H,", "1H,,1H,,", "1H1,", "1H11,1H;,", "4Hpart"] {
            assert!(of(text).is_err(), "{text}");
        }
    }

    #[test]
    fn texts_hold_delimiters_and_numbers_have_exponents() {
        let by = Delimiters { parameter: b',', record: b';' };
        let all = Parameters::of(b"126, 5Ha,;b ,,-1.5D+2 ,3; a comment", by).unwrap();
        assert_eq!((all.len(), all.whole(0), all.text(1)), (5, Ok(126), Some("a,;b ".to_owned())));
        assert_eq!(
            (all.is_blank(2), all.is_blank(1), all.real(2), all.real(3)),
            (true, false, Ok(0.0), Ok(-150.0))
        );
        assert!(all.real(1).is_err() && all.reals(3, 3).is_err() && all.reals(1, usize::MAX).is_err());
        for text in ["1,2", "5Habc;", "99999999999999999999Hx;", "2Hab c;", ""] {
            assert!(Parameters::of(text.as_bytes(), by).is_err(), "{text}");
        }
    }
}
