//! Big fractions as they come, with nothing but the operators of `num_rational`: what exact arithmetic would cost.

#[path = "../../tests/fields/signs.rs"]
mod signs;

use num_rational::BigRational;
use signs::{signs, wrapped};
use symspline::{Q, Scalar};

/// A plain big fraction.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Plain(pub BigRational);

wrapped!(Plain);

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
