//! Curves and surfaces prepared for fine tuning.

use crate::any::Any;
use crate::error::{Error, Result};
use crate::family::{AnySpline, AnySurface};
use crate::number::{Field, Flat, flat};
use crate::over::{AnySpace, Coords, Over};
use crate::tools::condition::{AnyCondition, AnySurfaceCondition, mismatch, paired};
use nalgebra::SVector;
use std::fmt::Debug;
use symspline::{
    Curve, Edges, FineTuner, Hold, Norm, Path, Q, SplineSpace, Surface, SurfaceTuner, TensorSpline,
};

/// How a tuner holds what it tunes.
#[derive(Clone, Debug, PartialEq)]
pub enum Keeping<H, C> {
    /// The start alone.
    Free,
    /// By putting the ends or edges back.
    Holding(H),
    /// By the nearest scale function that meets conditions.
    Nearest(Vec<C>, Norm),
}

/// One text for a curve or surface in space and spaces over the same field.
macro_rules! over_scales {
    ($shape:expr, $scales:expr, $s:ident, $scale:ident => $body:expr) => {
        match ($shape, $scales) {
            (Any::F2($s), Over::Float($scale)) => $body,
            (Any::F3($s), Over::Float($scale)) => $body,
            (Any::Q2($s), Over::Exact($scale)) => $body,
            (Any::Q3($s), Over::Exact($scale)) => $body,
            (s, scale) => Err(mismatch(s, scale)),
        }
    };
}

/// A curve or surface prepared for fine tuning by scale functions with coefficients in one space.
pub trait Tuner: Debug + Send + Sync {
    /// The spaces of the tuned shapes, one for each parameter.
    fn spaces(&self) -> Vec<AnySpace>;

    /// The shape tuned by the scale function with these coefficients.
    ///
    /// # Errors
    /// Those of [`FineTuner::tuned`].
    fn tuned(&self, alpha: &Coords) -> Result<crate::Value>;

    /// Writes the coordinates of the control points of the tuned shape, over floats.
    ///
    /// # Errors
    /// Those of [`FineTuner::tune_into`]; [`Error::Fields`] if the tuner is exact.
    fn tune_into(&self, alpha: &[f64], coords: &mut [f64]) -> Result<()>;
}

/// A tuner that is told positive scale functions, or any.
#[derive(Debug)]
struct Tunes<K>(K);

macro_rules! tunes {
    ($tuner:ident, $any:ty, $kind:ident, $spaces:expr) => {
        impl<T: Field, const N: usize> Tuner for Tunes<$tuner<T, N>>
        where
            $any: From<$kind<T, N>>,
            AnySpace: From<SplineSpace<T>>,
            SVector<T, N>: Flat<T> + Send + Sync,
        {
            fn spaces(&self) -> Vec<AnySpace> {
                let spaces: fn(&$tuner<T, N>) -> Vec<AnySpace> = $spaces;
                spaces(&self.0)
            }

            fn tuned(&self, alpha: &Coords) -> Result<crate::Value> {
                Ok(<$any>::from(self.0.tuned(&T::all_of(alpha)?)?).into())
            }

            fn tune_into(&self, alpha: &[f64], coords: &mut [f64]) -> Result<()> {
                let alpha = T::all_of(&Over::Float(alpha.to_vec()))?;
                let mut points = vec![SVector::<T, N>::zeros(); coords.len() / N];
                if coords.len() % N != 0 {
                    return Err(Error::Torn { count: coords.len(), dim: N });
                }
                self.0.tune_into(&alpha, &mut points)?;
                for (x, y) in coords.iter_mut().zip(points.iter().flat_map(|p| p.iter())) {
                    *x = f64::of(&y.clone().number())?;
                }
                Ok(())
            }
        }
    };
}

tunes!(FineTuner, AnySpline, Curve, |t| vec![t.space().clone().into()]);
tunes!(SurfaceTuner, AnySurface, Surface, |t| vec![t.u().clone().into(), t.v().clone().into()]);

/// A curve prepared for fine tuning; see [`FineTuner`].
///
/// # Errors
/// [`Error::Fields`], [`Error::NoSuch`] for holding exact curves in space, and those of the library.
pub fn curve_tuner(
    curve: &AnySpline,
    scales: &AnySpace,
    keeping: &Keeping<Hold, AnyCondition>,
    signed: bool,
) -> Result<Box<dyn Tuner>> {
    if let (Any::Q3(_), Keeping::Holding(_)) = (curve, keeping) {
        return Err(crate::Value::from(curve.clone()).none_of("holding without square roots"));
    }
    macro_rules! holding {
        ($c:expr, $s:expr, $hold:expr) => {
            FineTuner::prepare($c, $s, $hold)
        };
    }
    if let Keeping::Holding(hold) = keeping {
        return match (curve, scales) {
            (Any::F2(c), Over::Float(s)) => Ok(boxed(holding!(c, s, *hold)?, signed)),
            (Any::F3(c), Over::Float(s)) => Ok(boxed(holding!(c, s, *hold)?, signed)),
            (Any::Q2(c), Over::Exact(s)) => Ok(boxed(holding!(c, s, *hold)?, signed)),
            (c, s) => Err(mismatch(c, s)),
        };
    }
    fn boxed<T: Field, const N: usize>(tuner: FineTuner<T, N>, signed: bool) -> Box<dyn Tuner>
    where
        Tunes<FineTuner<T, N>>: Tuner + 'static,
    {
        Box::new(Tunes(if signed { tuner.signed() } else { tuner }))
    }
    over_scales!(curve, scales, c, s => Ok(boxed(match keeping {
        Keeping::Nearest(conditions, norm) => {
            let conditions = conditions.iter().map(AnyCondition::of).collect::<Result<Vec<_>>>()?;
            FineTuner::constrained(c, s, &conditions, *norm)?
        }
        _ => FineTuner::free(c, s)?,
    }, signed)))
}

/// A surface prepared for fine tuning; see [`SurfaceTuner`].
///
/// # Errors
/// As [`curve_tuner`].
pub fn surface_tuner(
    surface: &AnySurface,
    scales: &[AnySpace; 2],
    path: Path,
    keeping: &Keeping<Edges, AnySurfaceCondition>,
    signed: bool,
) -> Result<Box<dyn Tuner>> {
    fn boxed<T: Field, const N: usize>(tuner: SurfaceTuner<T, N>, signed: bool) -> Box<dyn Tuner>
    where
        Tunes<SurfaceTuner<T, N>>: Tuner + 'static,
    {
        Box::new(Tunes(if signed { tuner.signed() } else { tuner }))
    }
    let scales = paired(scales)?;
    if let Keeping::Holding(edges) = keeping {
        return match (surface, &scales) {
            (Any::F2(s), Over::Float((u, v))) => {
                Ok(boxed(SurfaceTuner::prepare(s, (u, v), path, *edges)?, signed))
            }
            (Any::F3(s), Over::Float((u, v))) => {
                Ok(boxed(SurfaceTuner::prepare(s, (u, v), path, *edges)?, signed))
            }
            (Any::Q2(s), Over::Exact((u, v))) => {
                Ok(boxed(SurfaceTuner::prepare(s, (u, v), path, *edges)?, signed))
            }
            (Any::Q3(_), Over::Exact(_)) => {
                Err(crate::Value::from(surface.clone()).none_of("holding without square roots"))
            }
            (s, p) => Err(mismatch(s, p)),
        };
    }
    over_scales!(surface, &scales, s, p => Ok(boxed(match keeping {
        Keeping::Nearest(conditions, norm) => {
            let conditions = conditions.iter().map(AnySurfaceCondition::of).collect::<Result<Vec<_>>>()?;
            SurfaceTuner::constrained(s, (&p.0, &p.1), path, &conditions, *norm)?
        }
        _ => SurfaceTuner::free(s, (&p.0, &p.1), path)?,
    }, signed)))
}

/// The coefficients of a function of one or two parameters, for a [`Tuner`].
///
/// # Errors
/// [`Error::NoSuch`] for what is no function.
pub fn scale_coeffs(alpha: &crate::Value) -> Result<Coords> {
    use crate::Value::{Spline, Surface};
    match alpha {
        Spline(Any::F1(f)) => Ok(flat(f.coeffs())),
        Spline(Any::Q1(f)) => Ok(flat(f.coeffs())),
        Surface(Any::F1(f)) => Ok(flat::<f64, f64>(TensorSpline::coeffs(f))),
        Surface(Any::Q1(f)) => Ok(flat::<Q, Q>(TensorSpline::coeffs(f))),
        other => Err(other.none_of("fine tuning by")),
    }
}
