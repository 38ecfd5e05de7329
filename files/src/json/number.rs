//! Numbers as they stand in JSON texts.

use crate::error::Problem;
use serde::de::{self, Deserializer, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::fmt;
use symspline::{Q, Scalar};
use symspline_dynamic::Field;

/// Up to this size programs agree on whole numbers in JSON; larger ones are text.
const WHOLE: f64 = 9_007_199_254_740_991.0;

/// A number as it stands in a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Text {
    Float(f64),
    Exact(Q),
}

impl Serialize for Text {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Float(x) if !x.is_finite() => {
                Err(serde::ser::Error::custom(format!("{x} is not a number")))
            }
            Self::Float(x) => serializer.serialize_f64(*x),
            Self::Exact(x) => serializer.collect_str(x),
        }
    }
}

impl<'de> Deserialize<'de> for Text {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Numbers;

        impl Visitor<'_> for Numbers {
            type Value = Text;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or a text \"p/q\"")
            }

            fn visit_f64<E: de::Error>(self, x: f64) -> Result<Text, E> {
                if x.is_finite() {
                    Ok(Text::Float(x))
                } else {
                    Err(E::custom("a number is too large for a float"))
                }
            }

            fn visit_i64<E: de::Error>(self, n: i64) -> Result<Text, E> {
                Ok(Text::Float(n as f64))
            }

            fn visit_u64<E: de::Error>(self, n: u64) -> Result<Text, E> {
                Ok(Text::Float(n as f64))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Text, E> {
                text.parse().map(Text::Exact).map_err(E::custom)
            }
        }
        deserializer.deserialize_any(Numbers)
    }
}

/// A count, an index, a degree: a whole number, also where it is written `2.0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Count(pub(crate) usize);

impl Serialize for Count {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Count {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let x = f64::deserialize(deserializer)?;
        match x.fract() == 0.0 && (0.0..=WHOLE).contains(&x) {
            true => Ok(Self(x as usize)),
            false => {
                Err(de::Error::custom(format!("{x} does not count: a whole number from 0 on is expected")))
            }
        }
    }
}

/// A field as it is read and written.
pub(super) trait Written: Field {
    fn read(text: &Text) -> Result<Self, Problem>;

    fn text(&self) -> Text;
}

impl Written for f64 {
    fn read(text: &Text) -> Result<Self, Problem> {
        match text {
            Text::Float(x) => Ok(*x),
            Text::Exact(x) => {
                Err(Problem::Syntax(format!("\"{x}\" is a text: numbers of the field \"float\" are not")))
            }
        }
    }

    fn text(&self) -> Text {
        Text::Float(*self)
    }
}

impl Written for Q {
    fn read(text: &Text) -> Result<Self, Problem> {
        match text {
            Text::Exact(x) => Ok(x.clone()),
            Text::Float(x) if x.fract() == 0.0 && x.abs() <= WHOLE => Ok(Self::int(*x as i64)),
            Text::Float(x) => Err(Problem::Syntax(format!("{x} is not exact: write a text \"p/q\""))),
        }
    }

    fn text(&self) -> Text {
        Text::Exact(self.clone())
    }
}
