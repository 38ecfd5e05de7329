//! Dual numbers: a value and its derivative.

use crate::signs::signs;
use std::fmt;
use symspline::{Q, Scalar};

/// `value + slope ε` with `ε² = 0`, ordered by the value and then by the slope.
///
/// `ε` has no inverse; but knots with different values have differences with an inverse, and no others are divided by.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Dual {
    pub value: Q,
    pub slope: Q,
}

impl Dual {
    /// A constant.
    pub fn constant(value: Q) -> Self {
        Self { value, slope: Q::int(0) }
    }

    /// The number by which is differentiated.
    pub fn variable(value: Q) -> Self {
        Self { value, slope: Q::int(1) }
    }

    fn plus(&self, other: &Self) -> Self {
        Self { value: self.value.clone() + &other.value, slope: self.slope.clone() + &other.slope }
    }

    fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negative())
    }

    fn negative(&self) -> Self {
        Self { value: -self.value.clone(), slope: -self.slope.clone() }
    }

    fn times(&self, other: &Self) -> Self {
        let slope = self.slope.clone() * &other.value + self.value.clone() * &other.slope;
        Self { value: self.value.clone() * &other.value, slope }
    }

    fn over(&self, other: &Self) -> Self {
        let value = self.value.clone() / &other.value;
        let slope = (self.slope.clone() - value.clone() * &other.slope) / &other.value;
        Self { value, slope }
    }
}

signs!(Dual);

impl Scalar for Dual {
    const EXACT: bool = true;

    fn int(n: i64) -> Self {
        Self::constant(Q::int(n))
    }
}

impl fmt::Display for Dual {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} + {} ε", self.value, self.slope)
    }
}
