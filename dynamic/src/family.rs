//! The kinds of splines: of one parameter or two, polynomial or rational.

use crate::any::{Any, Family};
use crate::error::Result;
use crate::number::Field;
use nalgebra::SVector;
use symspline::{Coeff, Interval, Q, Rational, Rectangle, Spline, SplineSpace, TensorSpline};

/// Polynomial splines of one parameter: functions and curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Splines;

/// Polynomial splines of two parameters: functions and surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surfaces;

/// Rational splines of one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rationals;

/// Rational splines of two parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RationalSurfaces;

/// A spline of one parameter over either field: a function, or a curve in two or three dimensions.
pub type AnySpline = Any<Splines>;

/// A spline of two parameters over either field: a function, or a surface in two or three dimensions.
pub type AnySurface = Any<Surfaces>;

/// A rational spline of one parameter over either field.
pub type AnyRational = Any<Rationals>;

/// A rational spline of two parameters over either field.
pub type AnyRationalSurface = Any<RationalSurfaces>;

macro_rules! family {
    ($family:ident, $kinds:expr, ($T:ident, $C:ident) => $of:ty, $s:ident: $spaces:expr, $points:expr, $weights:expr) => {
        impl Family for $family {
            type Of<$T: Field, $C: Coeff<$T>> = $of;

            const KINDS: [&'static str; 2] = $kinds;

            fn spaces<$T: Field, $C: Coeff<$T>>($s: &$of) -> Vec<SplineSpace<$T>> {
                $spaces
            }

            fn points<$T: Field, $C: Coeff<$T>>($s: &$of) -> Result<Vec<$C>> {
                $points
            }

            fn weights<$T: Field, $C: Coeff<$T>>($s: &$of) -> Option<Vec<$T>> {
                $weights
            }

            fn to_exact<C: Coeff<f64>>(of: &Self::Of<f64, C>) -> Result<Self::Of<Q, C::Over<Q>>> {
                Ok(of.to_exact()?)
            }

            fn to_f64<C: Coeff<Q>>(of: &Self::Of<Q, C>) -> Result<Self::Of<f64, C::Over<f64>>> {
                Ok(of.to_f64()?)
            }
        }

        family!(@from $family, $T, $C, $of, F1, f64, f64);
        family!(@from $family, $T, $C, $of, F2, f64, SVector<f64, 2>);
        family!(@from $family, $T, $C, $of, F3, f64, SVector<f64, 3>);
        family!(@from $family, $T, $C, $of, Q1, Q, Q);
        family!(@from $family, $T, $C, $of, Q2, Q, SVector<Q, 2>);
        family!(@from $family, $T, $C, $of, Q3, Q, SVector<Q, 3>);
    };
    (@from $family:ident, $T:ident, $C:ident, $of:ty, $variant:ident, $field:ty, $coeff:ty) => {
        const _: () = {
            type $T = $field;
            type $C = $coeff;
            impl From<$of> for Any<$family> {
                fn from(of: $of) -> Self {
                    Self::$variant(of)
                }
            }
        };
    };
}

family!(Splines, ["function", "curve"], (T, C) => Spline<T, C>, s:
    vec![s.space().clone()], Ok(s.coeffs().to_vec()), { let _ = s; None });
family!(Surfaces, ["function of two parameters", "surface"], (T, C) => TensorSpline<T, C>, s:
    vec![s.u().clone(), s.v().clone()], Ok(s.coeffs().to_vec()), { let _ = s; None });
family!(Rationals, ["rational function", "rational curve"], (T, C) => Rational<Interval, T, C>, s:
    vec![s.space().clone()], Ok(s.points()?), Some(s.weights().cloned().collect()));
family!(RationalSurfaces, ["rational function of two parameters", "rational surface"], (T, C) => Rational<Rectangle, T, C>, s:
    vec![s.u().clone(), s.v().clone()], Ok(s.points()?), Some(s.weights().cloned().collect()));
