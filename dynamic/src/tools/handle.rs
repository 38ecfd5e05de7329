//! Curvatures and tangents of curves changed at one place.

use crate::error::Result;
use crate::number::{Field, Number};
use crate::over::{Coords, Over};
use crate::shape;
use crate::tools::constraints::Wishes;
use crate::tools::edit::Of;
use crate::tools::shape::{Shape, point};
use crate::value::Value;
use nalgebra::SVector;
use symspline::{Controlled, CurvatureHandle, Q, with_tangent};

/// A place of a curve where the curvature is changed; see [`CurvatureHandle`].
pub type AnyHandle = Over<CurvatureHandle<f64>, CurvatureHandle<Q>>;

impl From<CurvatureHandle<f64>> for AnyHandle {
    fn from(handle: CurvatureHandle<f64>) -> Self {
        Self::Float(handle)
    }
}

impl From<CurvatureHandle<Q>> for AnyHandle {
    fn from(handle: CurvatureHandle<Q>) -> Self {
        Self::Exact(handle)
    }
}

impl AnyHandle {
    /// The handle of a curve, with further wishes.
    ///
    /// # Errors
    /// [`Error::NoSuch`](crate::Error::NoSuch) for what is no curve, and those of [`CurvatureHandle::of`].
    pub fn of_curve(curve: &Value, x: &Number, wishes: &Wishes) -> Result<Self> {
        shape!(curve curve, "curvature handle", T, s => Ok(CurvatureHandle::of(wishes.on::<T, _>(s)?, &T::of(x)?)?.into()))
    }

    /// The curve with a vector added to the second derivative.
    ///
    /// # Errors
    /// [`Error::Fields`](crate::Error::Fields), and those of [`CurvatureHandle::push`].
    pub fn pushed(&self, curve: &Value, by: &Coords) -> Result<Value> {
        shape!(curve curve, "curvature handle", T, s => {
            let mut s = s.clone();
            Of::<T>::of(self)?.push(&mut s, &point(by)?)?;
            Ok(s.value())
        })
    }

    /// The curve with a multiple of the first derivative added to the second.
    ///
    /// # Errors
    /// As [`pushed`](Self::pushed).
    pub fn slid(&self, curve: &Value, amount: &Number) -> Result<Value> {
        shape!(curve curve, "curvature handle", T, s => {
            let mut s = s.clone();
            Of::<T>::of(self)?.slide(&mut s, &T::of(amount)?)?;
            Ok(s.value())
        })
    }

    /// The curve with its curvature multiplied.
    ///
    /// # Errors
    /// As [`pushed`](Self::pushed).
    pub fn scaled(&self, curve: &Value, factor: &Number) -> Result<Value> {
        fn scaled<T: Field, S, const N: usize>(
            handle: &CurvatureHandle<T>,
            curve: &S,
            factor: &T,
        ) -> Result<Value>
        where
            S: Shape<T> + Controlled<T, Parameter = T, Order = usize, Point = SVector<T, N>>,
        {
            let mut curve = curve.clone();
            handle.scale(&mut curve, factor)?;
            Ok(curve.value())
        }
        match curve {
            Value::Spline(any) => {
                crate::each_curve!(any, T, s => scaled(Of::<T>::of(self)?, s, &T::of(factor)?), Err(curve.none_of("curvature")))
            }
            Value::Rational(any) => {
                crate::each_curve!(any, T, s => scaled(Of::<T>::of(self)?, s, &T::of(factor)?), Err(curve.none_of("curvature")))
            }
            other => Err(other.none_of("curvature handle")),
        }
    }

    /// The curve with a given curvature, over floats.
    ///
    /// # Errors
    /// [`Error::Fields`](crate::Error::Fields) for an exact handle, and those of [`CurvatureHandle::set`].
    pub fn set(&self, curve: &Value, kappa: f64) -> Result<Value> {
        use crate::any::Any::{F2, F3};
        let handle: &CurvatureHandle<f64> = Of::<f64>::of(self)?;
        macro_rules! set {
            ($s:expr) => {{
                let mut s = $s.clone();
                handle.set(&mut s, &kappa)?;
                Ok(s.value())
            }};
        }
        match curve {
            Value::Spline(F2(s)) => set!(s),
            Value::Spline(F3(s)) => set!(s),
            Value::Rational(F2(s)) => set!(s),
            Value::Rational(F3(s)) => set!(s),
            other => Err(other.none_of("setting of the curvature, by square roots,")),
        }
    }
}

/// The curve whose tangent at a place has a direction; see [`with_tangent`].
///
/// # Errors
/// [`Error::NoSuch`](crate::Error::NoSuch) for what is no curve, and those of [`with_tangent`].
pub fn tangent_turned(curve: &Value, x: &Number, direction: &Coords) -> Result<Value> {
    match curve {
        Value::Spline(any) => {
            crate::each_curve!(any, T, s => Ok(with_tangent(s, &T::of(x)?, &point(direction)?)?.value()), Err(curve.none_of("tangent")))
        }
        Value::Rational(any) => {
            crate::each_curve!(any, T, s => Ok(with_tangent(s, &T::of(x)?, &point(direction)?)?.value()), Err(curve.none_of("tangent")))
        }
        other => Err(other.none_of("tangent")),
    }
}
