//! Lengths, frames, nearest points.

use crate::Any;
use crate::error::Result;
use crate::over::Coords;
use crate::tools::places::float_curve;
use crate::tools::shape::point;
use crate::value::Value;
use nalgebra::SVector;
use std::fmt::Debug;
use symspline::{ArcLength, Frame, Projector};

/// Lengths along a curve; see [`ArcLength`].
pub trait Lengths: Debug + Send + Sync {
    /// The whole, and a bound of its error.
    fn total(&self) -> (f64, f64);
    /// The lengths up to parameters.
    ///
    /// # Errors
    /// Those of [`ArcLength::at`].
    fn at(&self, parameters: &[f64]) -> Result<Vec<f64>>;
    /// The parameters at lengths.
    ///
    /// # Errors
    /// Those of [`ArcLength::parameter_at`].
    fn parameters_at(&self, lengths: &[f64]) -> Result<Vec<f64>>;
    /// The parameters of equal parts.
    ///
    /// # Errors
    /// Those of [`ArcLength::evenly`].
    fn evenly(&self, count: usize) -> Result<Vec<f64>>;
}

impl<const N: usize> Lengths for ArcLength<N> {
    fn total(&self) -> (f64, f64) {
        (Self::total(self), self.bound())
    }

    fn at(&self, parameters: &[f64]) -> Result<Vec<f64>> {
        parameters.iter().map(|x| Ok(Self::at(self, x)?)).collect()
    }

    fn parameters_at(&self, lengths: &[f64]) -> Result<Vec<f64>> {
        lengths.iter().map(|s| Ok(self.parameter_at(s)?)).collect()
    }

    fn evenly(&self, count: usize) -> Result<Vec<f64>> {
        Ok(Self::evenly(self, count)?)
    }
}

/// The lengths along a curve over floats.
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn arc_length(curve: &Value, accuracy: f64) -> Result<Box<dyn Lengths>> {
    float_curve!(curve, "arc length over floats", c => Ok(Box::new(c.arc_length(&accuracy)?) as Box<dyn Lengths>))
}

fn frame<const N: usize>(frame: &Frame<f64, N>) -> Vec<f64> {
    frame.point.iter().copied().chain(frame.axes().iter().flat_map(|axis| axis.iter().copied())).collect()
}

/// The frames of a curve over floats: for each parameter the point and the axes; see [`Frame`].
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn frames(curve: &Value, parameters: &[f64]) -> Result<Vec<f64>> {
    float_curve!(curve, "frame over floats", c => {
        let mut all = Vec::new();
        for x in parameters {
            all.extend(frame(&c.frame_at(x)?));
        }
        Ok(all)
    })
}

/// Frames that do not turn about the tangent, of a curve in space over floats, as [`frames`].
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn still_frames(curve: &Value, parameters: &[f64], start: Option<&Coords>) -> Result<Vec<f64>> {
    let start = start.map(point::<f64, SVector<f64, 3>>).transpose()?;
    let all = match curve {
        Value::Spline(Any::F3(c)) => c.rotation_minimising_frames(parameters, start.as_ref())?,
        Value::Rational(Any::F3(c)) => c.rotation_minimising_frames(parameters, start.as_ref())?,
        other => return Err(other.none_of("rotation minimising frames over floats")),
    };
    Ok(all.iter().flat_map(frame).collect())
}

/// A foot: parameters, point, distance.
pub type AnyFoot = (Vec<f64>, Vec<f64>, f64);

/// All feet of a point; see [`Nearest`](symspline::Nearest).
#[derive(Clone, Debug, PartialEq)]
pub struct AllFeet {
    /// The feet, nearest first.
    pub feet: Vec<AnyFoot>,
    /// From where to where feet could not be told from each other.
    pub along: Vec<[Vec<f64>; 2]>,
    /// No point is nearer than this.
    pub bound: f64,
}

/// A shape prepared for nearest points; see [`Projector`].
pub trait Nears: Debug + Send + Sync {
    /// A foot of each point.
    ///
    /// # Errors
    /// Those of [`Projector::feet`].
    fn feet(&self, points: &Coords) -> Result<Vec<AnyFoot>>;
    /// All feet of a point, the stretches where they could not be told apart, and what no point is nearer than.
    ///
    /// # Errors
    /// Those of [`Projector::nearest`].
    fn nearest(&self, point: &Coords, accuracy: f64) -> Result<AllFeet>;
    /// The parameters at which the shape passes through a point.
    ///
    /// # Errors
    /// Those of [`Projector::parameters_of`].
    fn parameters_of(&self, point: &Coords, tolerance: f64) -> Result<Vec<Vec<f64>>>;
}

trait Numbers {
    fn list(&self) -> Vec<f64>;
}

impl Numbers for f64 {
    fn list(&self) -> Vec<f64> {
        vec![*self]
    }
}

impl Numbers for (f64, f64) {
    fn list(&self) -> Vec<f64> {
        vec![self.0, self.1]
    }
}

macro_rules! nears {
    ($parameter:ty, $N:literal) => {
        impl Nears for Projector<$parameter, $N> {
            fn feet(&self, points: &Coords) -> Result<Vec<AnyFoot>> {
                let points = crate::tools::shape::all_points::<f64, SVector<f64, $N>>(points)?;
                let all = Self::feet(self, &points)?;
                Ok(all
                    .iter()
                    .map(|f| (f.parameter.list(), f.point.iter().copied().collect(), f.distance))
                    .collect())
            }

            fn nearest(&self, to: &Coords, accuracy: f64) -> Result<AllFeet> {
                let found = Self::nearest(self, &point::<f64, _>(to)?, accuracy)?;
                let foot = |f: &symspline::Foot<$parameter, $N>| {
                    (f.parameter.list(), f.point.iter().copied().collect(), f.distance)
                };
                let along = found.along.iter().map(|(a, b)| [a.list(), b.list()]).collect();
                Ok(AllFeet { feet: found.feet.iter().map(foot).collect(), along, bound: found.bound })
            }

            fn parameters_of(&self, to: &Coords, tolerance: f64) -> Result<Vec<Vec<f64>>> {
                let all = Self::parameters_of(self, &point::<f64, _>(to)?, tolerance)?;
                Ok(all.iter().map(Numbers::list).collect())
            }
        }
    };
}

nears!(f64, 2);
nears!(f64, 3);
nears!((f64, f64), 2);
nears!((f64, f64), 3);

/// A shape over floats prepared for nearest points.
///
/// # Errors
/// [`NoSuch`](crate::Error::NoSuch), and those of the library.
pub fn projector(shape: &Value) -> Result<Box<dyn Nears>> {
    match shape {
        Value::Surface(Any::F2(s)) => Ok(Box::new(s.projector()?)),
        Value::Surface(Any::F3(s)) => Ok(Box::new(s.projector()?)),
        Value::RationalSurface(Any::F2(s)) => Ok(Box::new(s.projector()?)),
        Value::RationalSurface(Any::F3(s)) => Ok(Box::new(s.projector()?)),
        other => {
            float_curve!(other, "nearest points over floats", c => Ok(Box::new(c.projector()?) as Box<dyn Nears>))
        }
    }
}
