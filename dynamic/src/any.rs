//! A kind of spline over either field, in one dimension, two or three.

use crate::error::{Error, Result};
use crate::number::{Field, flat};
use crate::over::{AnySpace, Coords};
use nalgebra::{SVector, Vector2, Vector3};
use std::fmt::Debug;
use symspline::{Coeff, Q, SplineSpace};

/// A kind of spline: what it is over a field and a type of coefficients.
pub trait Family: Clone + Copy + Debug + PartialEq + 'static {
    /// The type over a field and a type of coefficients.
    type Of<T: Field, C: Coeff<T>>: Clone + Debug + PartialEq;

    /// What it is called with values that are numbers, and with points.
    const KINDS: [&'static str; 2];

    /// The spaces it is over, one for each parameter.
    fn spaces<T: Field, C: Coeff<T>>(of: &Self::Of<T, C>) -> Vec<SplineSpace<T>>;

    /// Its control points, for a surface row by row, each row of one `u`.
    ///
    /// # Errors
    /// Those of the library: a weight may be zero.
    fn points<T: Field, C: Coeff<T>>(of: &Self::Of<T, C>) -> Result<Vec<C>>;

    /// Its weights, if it is rational.
    fn weights<T: Field, C: Coeff<T>>(of: &Self::Of<T, C>) -> Option<Vec<T>>;

    /// The same over the rationals.
    ///
    /// # Errors
    /// Those of the library.
    fn to_exact<C: Coeff<f64>>(of: &Self::Of<f64, C>) -> Result<Self::Of<Q, C::Over<Q>>>;

    /// The same rounded to floats.
    ///
    /// # Errors
    /// Those of the library.
    fn to_f64<C: Coeff<Q>>(of: &Self::Of<Q, C>) -> Result<Self::Of<f64, C::Over<f64>>>;
}

/// A kind of spline over `f64` (`F`) or the rationals (`Q`), whose values are numbers (1) or points with two or three coordinates.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the letter is the field, the digit the dimension")]
pub enum Any<F: Family> {
    F1(F::Of<f64, f64>),
    F2(F::Of<f64, Vector2<f64>>),
    F3(F::Of<f64, Vector3<f64>>),
    Q1(F::Of<Q, Q>),
    Q2(F::Of<Q, SVector<Q, 2>>),
    Q3(F::Of<Q, SVector<Q, 3>>),
}

/// One text for all: `each!(any, s => ...)` has `s` what is inside; `each!(any, T, s => ...)` has `T` its field besides.
#[macro_export]
macro_rules! each {
    ($any:expr, $s:ident => $body:expr) => {
        match $any {
            $crate::Any::F1($s) => $body,
            $crate::Any::F2($s) => $body,
            $crate::Any::F3($s) => $body,
            $crate::Any::Q1($s) => $body,
            $crate::Any::Q2($s) => $body,
            $crate::Any::Q3($s) => $body,
        }
    };
    ($any:expr, $T:ident, $s:ident => $body:expr) => {
        match $any {
            $crate::Any::F1($s) => $crate::each!(@ f64, $T, $body),
            $crate::Any::F2($s) => $crate::each!(@ f64, $T, $body),
            $crate::Any::F3($s) => $crate::each!(@ f64, $T, $body),
            $crate::Any::Q1($s) => $crate::each!(@ ::symspline::Q, $T, $body),
            $crate::Any::Q2($s) => $crate::each!(@ ::symspline::Q, $T, $body),
            $crate::Any::Q3($s) => $crate::each!(@ ::symspline::Q, $T, $body),
        }
    };
    (@ $field:ty, $T:ident, $body:expr) => {{
        type $T = $field;
        $body
    }};
}

/// One text for what has points as values, in two dimensions or three; for numbers the other text.
#[macro_export]
macro_rules! each_curve {
    ($any:expr, $T:ident, $s:ident => $body:expr, $other:expr) => {
        match $any {
            $crate::Any::F2($s) => $crate::each!(@ f64, $T, $body),
            $crate::Any::F3($s) => $crate::each!(@ f64, $T, $body),
            $crate::Any::Q2($s) => $crate::each!(@ ::symspline::Q, $T, $body),
            $crate::Any::Q3($s) => $crate::each!(@ ::symspline::Q, $T, $body),
            $crate::Any::F1(_) | $crate::Any::Q1(_) => $other,
        }
    };
}

/// One text for two of the same field and dimension; [`Error::Fields`] or [`Error::Dimensions`] if they are not.
#[macro_export]
macro_rules! alike {
    ($left:expr, $right:expr, $s:ident, $t:ident => $body:expr) => {
        match ($left, $right) {
            ($crate::Any::F1($s), $crate::Any::F1($t)) => $body,
            ($crate::Any::F2($s), $crate::Any::F2($t)) => $body,
            ($crate::Any::F3($s), $crate::Any::F3($t)) => $body,
            ($crate::Any::Q1($s), $crate::Any::Q1($t)) => $body,
            ($crate::Any::Q2($s), $crate::Any::Q2($t)) => $body,
            ($crate::Any::Q3($s), $crate::Any::Q3($t)) => $body,
            (left, right) => Err(left.unlike(right).into()),
        }
    };
}

/// One text for something and a numeric one of the same field: a curve and a scale function, say.
#[macro_export]
macro_rules! with_function {
    ($any:expr, $function:expr, $s:ident, $f:ident => $body:expr) => {
        match ($any, $function) {
            ($crate::Any::F1($s), $crate::Any::F1($f)) => $body,
            ($crate::Any::F2($s), $crate::Any::F1($f)) => $body,
            ($crate::Any::F3($s), $crate::Any::F1($f)) => $body,
            ($crate::Any::Q1($s), $crate::Any::Q1($f)) => $body,
            ($crate::Any::Q2($s), $crate::Any::Q1($f)) => $body,
            ($crate::Any::Q3($s), $crate::Any::Q1($f)) => $body,
            (left, right) => Err(left.unlike_function(right).into()),
        }
    };
}

impl<F: Family> Any<F> {
    /// Whether it is over the rationals.
    pub fn is_exact(&self) -> bool {
        matches!(self, Self::Q1(_) | Self::Q2(_) | Self::Q3(_))
    }

    /// "exact" or "float".
    pub fn field(&self) -> &'static str {
        if self.is_exact() { Q::NAME } else { f64::NAME }
    }

    /// How many coordinates its values have.
    pub fn dim(&self) -> usize {
        match self {
            Self::F1(_) | Self::Q1(_) => 1,
            Self::F2(_) | Self::Q2(_) => 2,
            Self::F3(_) | Self::Q3(_) => 3,
        }
    }

    /// What it is called: "function", "curve", ...
    pub fn kind(&self) -> &'static str {
        F::KINDS[usize::from(self.dim() > 1)]
    }

    /// The spaces it is over, one for each parameter.
    pub fn spaces(&self) -> Vec<AnySpace> {
        each!(self, s => F::spaces(s).into_iter().map(AnySpace::from).collect())
    }

    /// The coordinates of its control points, one after the other; for a surface row by row, each row of one `u`.
    ///
    /// # Errors
    /// Those of the library: a weight may be zero.
    pub fn coords(&self) -> Result<Coords> {
        Ok(each!(self, s => flat(&F::points(s)?)))
    }

    /// Its weights, if it is rational.
    pub fn weights(&self) -> Option<Coords> {
        each!(self, s => F::weights(s).map(Field::coords))
    }

    /// The same over the rationals, without loss.
    ///
    /// # Errors
    /// Those of the library.
    pub fn to_exact(&self) -> Result<Self> {
        Ok(match self {
            Self::F1(s) => Self::Q1(F::to_exact(s)?),
            Self::F2(s) => Self::Q2(F::to_exact(s)?),
            Self::F3(s) => Self::Q3(F::to_exact(s)?),
            exact => exact.clone(),
        })
    }

    /// The same with all numbers rounded to nearest.
    ///
    /// # Errors
    /// Those of the library: knots may fall together.
    pub fn to_float(&self) -> Result<Self> {
        Ok(match self {
            Self::Q1(s) => Self::F1(F::to_f64(s)?),
            Self::Q2(s) => Self::F2(F::to_f64(s)?),
            Self::Q3(s) => Self::F3(F::to_f64(s)?),
            float => float.clone(),
        })
    }

    /// Why these two do not go together.
    #[doc(hidden)]
    pub fn unlike<G: Family>(&self, other: &Any<G>) -> Error {
        match self.is_exact() == other.is_exact() {
            true => Error::Dimensions { left: self.dim(), right: other.dim() },
            false => Error::Fields { left: self.field(), right: other.field() },
        }
    }

    /// Why `other` is no function over this one's field.
    #[doc(hidden)]
    pub fn unlike_function<G: Family>(&self, other: &Any<G>) -> Error {
        match self.is_exact() == other.is_exact() {
            true => Error::Dimensions { left: 1, right: other.dim() },
            false => Error::Fields { left: self.field(), right: other.field() },
        }
    }
}
