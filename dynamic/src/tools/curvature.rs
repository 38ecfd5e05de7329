//! Curvature of curves, with its proofs.

use crate::Any;
use crate::error::Result;
use crate::family::{AnyRational, AnySpline};
use crate::number::{Field, Number};
use crate::over::Over;
use crate::tools::places::{Spot, any_curve, float_curve, sign, spot};
use crate::value::Value;
use std::fmt::Debug;
use symspline::roots::RootValue;
use symspline::{Analyse, Bounds, CurvatureProfile, Q, Turning};

/// The curvatures at parameters, over floats; see [`Analyse::curvature_at`].
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch) for what is no curve over floats, and those of the library.
pub fn curvatures(curve: &Value, parameters: &[f64]) -> Result<Vec<f64>> {
    float_curve!(curve, "curvature over floats", c => Ok(c.curvature_profile(parameters)?))
}

/// The tips of a curvature comb, over floats; see [`Analyse::curvature_comb`].
///
/// # Errors
/// As [`curvatures`].
pub fn comb(curve: &Value, parameters: &[f64], scale: f64) -> Result<Vec<f64>> {
    float_curve!(curve, "curvature over floats", c => {
        Ok(c.curvature_comb(parameters, &scale)?.iter().flat_map(|(_, tip)| tip.iter().copied()).collect())
    })
}

/// The squared curvature, a rational function; see [`Analyse::curvature_squared`].
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch) for what is no curve, and those of the library.
pub fn curvature_squared(curve: &Value) -> Result<AnyRational> {
    any_curve!(curve, "curvature", T, c => { let _: Option<T>; Ok(c.curvature_squared()?.into()) })
}

/// The torsion, a rational function; see [`Analyse::torsion`].
///
/// # Errors
/// As [`curvature_squared`].
pub fn torsion(curve: &Value) -> Result<AnyRational> {
    any_curve!(curve, "torsion", T, c => { let _: Option<T>; Ok(c.torsion()?.into()) })
}

/// A function with the sign of the curvature, or of its slope; see [`Analyse::bend_condition`] and [`Analyse::slope_condition`].
///
/// # Errors
/// As [`curvature_squared`].
pub fn condition(curve: &Value, slope: bool) -> Result<AnySpline> {
    any_curve!(curve, "curvature", T, c => {
        let _: Option<T>;
        Ok(if slope { c.slope_condition()? } else { c.bend_condition()? }.into())
    })
}

/// An event of a curvature; see [`Event`](symspline::Event).
#[derive(Clone, Debug, PartialEq)]
pub struct AnyEvent {
    /// What happens, in words: "maximum", "inflection", ...
    pub kind: String,
    /// Where.
    pub spot: Spot,
    /// The curvature before and after.
    pub curvature: [Bounds; 2],
    /// The turn of the direction.
    pub turn: f64,
}

/// A stretch on which the curvature rises (1), falls (-1) or stays (0): start, end, trend.
pub type Stretch = (Number, Number, i8);

/// The curvature of a curve along its parameter; see [`CurvatureProfile`].
pub trait Profile: Debug + Send + Sync + std::any::Any {
    /// All events.
    fn events(&self) -> Vec<AnyEvent>;
    /// Parameters, curvatures and slopes to draw.
    fn samples(&self) -> [Vec<f64>; 3];
    /// The stretches between events.
    fn runs(&self) -> Vec<Stretch>;
    /// The trend between two parameters, if there is one.
    ///
    /// # Errors
    /// Those of [`CurvatureProfile::trend_on`].
    fn trend_on(&self, a: &Number, b: &Number) -> Result<Option<i8>>;
    /// The scale of a comb.
    fn comb_scale(&self, length: f64) -> f64;
    /// The logarithmic curvature graph.
    fn log_log(&self) -> Vec<[f64; 2]>;
    /// Where the events of two profiles first differ in kind, if they do.
    fn differs_at(&self, other: &dyn Profile) -> Option<usize>;
}

fn middle<T: Field>(root: &RootValue<T>) -> Number {
    let (low, high) = root.bounds();
    if low == high {
        return low.clone().number();
    }
    (T::frac(1, 2) * (low.clone() + high)).number()
}

impl<T: Field> Profile for CurvatureProfile<T> {
    fn events(&self) -> Vec<AnyEvent> {
        let one = |event: &symspline::Event<T>| AnyEvent {
            kind: format!("{:?}", event.kind).to_lowercase(),
            spot: spot(&event.place),
            curvature: event.curvature,
            turn: event.turn,
        };
        Self::events(self).iter().map(one).collect()
    }

    fn samples(&self) -> [Vec<f64>; 3] {
        let all = Self::samples(self);
        let column = |get: fn(&symspline::Sample) -> f64| all.iter().map(get).collect();
        [column(|s| s.parameter), column(|s| s.curvature), column(|s| s.slope)]
    }

    fn runs(&self) -> Vec<Stretch> {
        Self::runs(self).iter().map(|run| (middle(&run.start), middle(&run.end), sign(run.trend))).collect()
    }

    fn trend_on(&self, a: &Number, b: &Number) -> Result<Option<i8>> {
        Ok(Self::trend_on(self, &T::of(a)?, &T::of(b)?)?.map(sign))
    }

    fn comb_scale(&self, length: f64) -> f64 {
        Self::comb_scale(self, length)
    }

    fn log_log(&self) -> Vec<[f64; 2]> {
        Self::log_log(self)
    }

    fn differs_at(&self, other: &dyn Profile) -> Option<usize> {
        let other: &dyn std::any::Any = other;
        // A profile is over one field or the other.
        match other.downcast_ref::<CurvatureProfile<f64>>() {
            Some(other) => Self::differs_at(self, other),
            None => Self::differs_at(self, other.downcast_ref::<CurvatureProfile<Q>>()?),
        }
    }
}

/// The profile of a curve, passing over corners and jumps up to a tolerance if there is one; see [`Analyse::profile`].
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn profile(curve: &Value, tolerance: Option<f64>) -> Result<Box<dyn Profile>> {
    any_curve!(curve, "curvature profile", T, c => {
        let _: Option<T>;
        Ok(match tolerance {
            Some(tolerance) => Box::new(c.profile_within(tolerance)?) as Box<dyn Profile>,
            None => Box::new(c.profile()?),
        })
    })
}

/// Bounds of the total curvature; see [`Turning::total_curvature`].
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn total_curvature(curve: &Value, accuracy: f64) -> Result<Bounds> {
    any_curve!(curve, "total curvature", T, c => { let _: Option<T>; Ok(c.total_curvature(accuracy)?) })
}

/// Bounds of the angle by which a plane curve turns; see [`Turning::turning_angle`].
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn turning_angle(curve: &Value) -> Result<Bounds> {
    match curve {
        Value::Spline(Any::F2(c)) => Ok(c.turning_angle()?),
        Value::Spline(Any::Q2(c)) => Ok(c.turning_angle()?),
        Value::Rational(Any::F2(c)) => Ok(c.turning_angle()?),
        Value::Rational(Any::Q2(c)) => Ok(c.turning_angle()?),
        other => Err(other.none_of("turning angle")),
    }
}

/// The torsion at a parameter of a curve in space; see [`Curve::torsion_at`](symspline::Curve::torsion_at).
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn torsion_at(curve: &Value, x: &Number) -> Result<Number> {
    match curve {
        Value::Spline(Any::F3(c)) => Ok(Over::Float(c.torsion_at(&f64::of(x)?)?)),
        Value::Spline(Any::Q3(c)) => Ok(Over::Exact(c.torsion_at(&Q::of(x)?)?)),
        Value::Rational(Any::F3(c)) => Ok(Over::Float(c.torsion_at(&f64::of(x)?)?)),
        Value::Rational(Any::Q3(c)) => Ok(Over::Exact(c.torsion_at(&Q::of(x)?)?)),
        other => Err(other.none_of("torsion")),
    }
}
