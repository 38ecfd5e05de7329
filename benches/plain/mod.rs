//! Big fractions as they come, with nothing but the operators of `num_rational`: what exact arithmetic would cost.

#[path = "../../tests/fields/signs.rs"]
mod signs;

use num_rational::BigRational;
use signs::signs;
use std::fmt;
use symspline::{Q, Scalar};

/// A plain big fraction.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Plain(pub BigRational);

impl Plain {
    fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    fn minus(&self, other: &Self) -> Self {
        Self(&self.0 - &other.0)
    }

    fn times(&self, other: &Self) -> Self {
        Self(&self.0 * &other.0)
    }

    fn over(&self, other: &Self) -> Self {
        Self(&self.0 / &other.0)
    }

    fn negative(&self) -> Self {
        Self(-&self.0)
    }
}

signs!(Plain);

impl Scalar for Plain {
    const EXACT: bool = true;

    fn int(n: i64) -> Self {
        Self(BigRational::from_integer(n.into()))
    }
}

impl From<Q> for Plain {
    fn from(q: Q) -> Self {
        Self(q.into())
    }
}

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
