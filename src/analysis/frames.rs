//! Frames along curves, and torsion.
//!
//! The Frenet frame in space has the tangent `C' / |C'|`, the normal towards which the curve turns, and their cross
//! product, the binormal. It turns about the tangent by the torsion
//!
//! ```text
//! τ = (C' × C'')·C''' / |C' × C''|²
//! ```
//!
//! a unit of length, positive for a right-handed screw, and has no meaning where the curvature vanishes. A
//! rotation-minimising frame does not turn about the tangent at all. From one point to the next it is carried by two
//! reflections, [Wang, Table I]: at the plane between the points, and at the one that then takes the old tangent to the
//! new one. For steps of length `h` the error is of the order of `h⁴`.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::rational::spline::NurbsCurve;
use crate::scalar::{Real, Scalar, larger};
use crate::spline::Curve;
use crate::vector::{cross3, dot, unit};
use nalgebra::{SVector, vector};

/// A point of a curve with orthonormal axes, the first along the curve. They are right-handed.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame<T, const N: usize> {
    /// The point.
    pub point: SVector<T, N>,
    axes: [SVector<T, N>; N],
}

impl<T, const N: usize> Frame<T, N> {
    /// All axes: tangent, normal, and in space the binormal.
    pub fn axes(&self) -> &[SVector<T, N>; N] {
        &self.axes
    }

    /// The unit tangent.
    pub fn tangent(&self) -> &SVector<T, N> {
        &self.axes[0]
    }

    /// The unit normal.
    pub fn normal(&self) -> &SVector<T, N> {
        &self.axes[1]
    }
}

impl<T> Frame<T, 3> {
    /// The unit binormal, across tangent and normal.
    pub fn binormal(&self) -> &SVector<T, 3> {
        &self.axes[2]
    }
}

fn stationary<T: Scalar>(x: &T) -> Error {
    Error::Stationary { parameter: x.to_string() }
}

/// The frame in the plane from point and derivative.
fn plane_frame<T: Real>(derivatives: Vec<SVector<T, 2>>, x: &T) -> Result<Frame<T, 2>> {
    let (tangent, _) = unit(&derivatives[1]).ok_or_else(|| stationary(x))?;
    let normal = vector![-tangent[1].clone(), tangent[0].clone()];
    Ok(Frame { point: derivatives[0].clone(), axes: [tangent, normal] })
}

/// The Frenet frame from point and two derivatives.
fn frenet_frame<T: Real>(derivatives: Vec<SVector<T, 3>>, x: &T) -> Result<Frame<T, 3>> {
    let (tangent, _) = unit(&derivatives[1]).ok_or_else(|| stationary(x))?;
    let turn = unit(&derivatives[2]).and_then(|(second, _)| unit(&cross3(&tangent, &second)));
    let (binormal, _) = turn.ok_or_else(|| Error::Straight { parameter: x.to_string() })?;
    let normal = cross3(&binormal, &tangent);
    Ok(Frame { point: derivatives[0].clone(), axes: [tangent, normal, binormal] })
}

/// The torsion from three derivatives. First and second are brought to size one, so that no product overflows or
/// vanishes.
fn torsion<T: Scalar>(derivatives: &[SVector<T, 3>], x: &T) -> Result<T> {
    let of_size_one = |d: &SVector<T, 3>| {
        let size = d.iter().map(T::magnitude).reduce(larger).expect("three components");
        (!size.is_zero()).then(|| (d.map(|x| x / &size), size))
    };
    let straight = || Error::Straight { parameter: x.to_string() };
    let (first, speed) = of_size_one(&derivatives[1]).ok_or_else(|| stationary(x))?;
    let (second, size) = of_size_one(&derivatives[2]).ok_or_else(straight)?;
    let binormal = cross3(&first, &second);
    let square = dot(&binormal, &binormal);
    if square.is_zero() {
        return Err(straight());
    }
    let torsion = dot(&binormal, &derivatives[3]) / square / speed / size;
    if torsion.is_finite() { Ok(torsion) } else { Err(Error::NotFinite { what: "torsion", index: 0 }) }
}

/// The rotation-minimising frames at `parameters`, where `point_and_slope` evaluates the curve.
fn rotation_minimising<T: Real>(
    parameters: &[T],
    start: Option<&SVector<T, 3>>,
    point_and_slope: impl Fn(&T) -> Result<Vec<SVector<T, 3>>>,
) -> Result<Vec<Frame<T, 3>>> {
    let mut frames: Vec<Frame<T, 3>> = Vec::with_capacity(parameters.len());
    for (index, x) in parameters.iter().enumerate() {
        if index > 0 && parameters[index - 1] > *x {
            return Err(Error::ParametersDecrease { index });
        }
        // Refuses what is not a number.
        let derivatives = point_and_slope(x)?;
        let (tangent, _) = unit(&derivatives[1]).ok_or_else(|| stationary(x))?;
        let point = derivatives[0].clone();
        let normal = match (frames.last(), start) {
            (Some(last), _) => reflected_twice(last, &point, &tangent),
            (None, Some(start)) => start.clone(),
            (None, None) => some_axis(&tangent),
        };
        // What is along the tangent is taken away: all of it of a start, rounding afterwards.
        let across = unit(&normal).map(|(normal, _)| normal.plus_scaled(&-dot(&normal, &tangent), &tangent));
        let (normal, _) = across.as_ref().and_then(unit).ok_or(Error::AlongTangent)?;
        let binormal = cross3(&tangent, &normal);
        frames.push(Frame { point, axes: [tangent, normal, binormal] });
    }
    Ok(frames)
}

/// The normal of `last` carried to the next point.
fn reflected_twice<T: Real>(
    last: &Frame<T, 3>,
    point: &SVector<T, 3>,
    tangent: &SVector<T, 3>,
) -> SVector<T, 3> {
    let reflect =
        |v: &SVector<T, 3>, across: &SVector<T, 3>| v.plus_scaled(&-(dot(v, across) * T::int(2)), across);
    // Where the curve has come back to the same point: the smallest rotation that takes tangent to tangent.
    let step = unit(&point.minus(&last.point)).map_or_else(|| last.tangent().clone(), |(step, _)| step);
    let (normal, turned) = (reflect(last.normal(), &step), reflect(last.tangent(), &step));
    match unit(&tangent.minus(&turned)) {
        Some((second, _)) => reflect(&normal, &second),
        None => normal,
    }
}

/// The axis that is the farthest from the direction `tangent`.
fn some_axis<T: Real>(tangent: &SVector<T, 3>) -> SVector<T, 3> {
    let nearer = |i: usize, j: usize| if tangent[j].magnitude() < tangent[i].magnitude() { j } else { i };
    let mut axis = SVector::<T, 3>::zeros();
    axis[nearer(nearer(0, 1), 2)] = T::one();
    axis
}

impl<T: Real> Curve<T, 2> {
    /// The frame at `x`, from the right: the tangent, and as normal the tangent turned left.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::Stationary`] where the derivative vanishes.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 0.0], vector![3.0, 4.0]])?;
    /// let frame = line.frame_at(&0.0)?;
    /// assert_eq!((frame.tangent(), frame.normal()), (&vector![0.6, 0.8], &vector![-0.8, 0.6]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn frame_at(&self, x: &T) -> Result<Frame<T, 2>> {
        plane_frame(self.derivatives_at(x, 1)?, x)
    }
}

impl<T: Real> NurbsCurve<T, 2> {
    /// The frame at `x`, as that of a [polynomial curve](Curve::<T, 2>::frame_at).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::Stationary`] where the derivative vanishes.
    pub fn frame_at(&self, x: &T) -> Result<Frame<T, 2>> {
        plane_frame(self.derivatives_at(x, 1)?, x)
    }
}

impl<T: Scalar> Curve<T, 3> {
    /// The torsion at `x`, from the right; positive for a right-handed screw.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::Stationary`] where the derivative vanishes; [`Error::Straight`] where the
    /// curvature does; [`Error::NotFinite`] where the torsion overflows.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Q, Scalar, SplineSpace};
    /// // (x, x², x³)
    /// let points = [[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 3, 3]].map(|c| vector![c[0], c[1], c[2]].map(|i| Q::frac(i, 3)));
    /// let twisted = Curve::new(SplineSpace::bezier(3, Q::int(0), Q::int(1))?, points.to_vec())?;
    /// assert_eq!(twisted.torsion_at(&Q::int(0))?, Q::int(3));
    /// assert_eq!(twisted.torsion_at(&Q::int(1))?, Q::frac(3, 19));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn torsion_at(&self, x: &T) -> Result<T> {
        torsion(&self.derivatives_at(x, 3)?, x)
    }
}

impl<T: Scalar> NurbsCurve<T, 3> {
    /// The torsion at `x`, as that of a [polynomial curve](Curve::torsion_at).
    ///
    /// # Errors
    /// As [`Curve::torsion_at`].
    pub fn torsion_at(&self, x: &T) -> Result<T> {
        torsion(&self.derivatives_at(x, 3)?, x)
    }
}

impl<T: Real> Curve<T, 3> {
    /// The Frenet frame at `x`, from the right.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::Stationary`] where the derivative vanishes; [`Error::Straight`] where the
    /// curvature does, so that no normal is distinguished.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![0.0, 0.0, 5.0], vector![1.0, 0.0, 5.0], vector![1.0, 1.0, 5.0]];
    /// let bend = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    /// let frame = bend.frame_at(&0.0)?;
    /// assert_eq!(frame.axes(), &[vector![1.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![0.0, 0.0, 1.0]]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn frame_at(&self, x: &T) -> Result<Frame<T, 3>> {
        frenet_frame(self.derivatives_at(x, 2)?, x)
    }

    /// Frames at `parameters` that do not turn about the tangent from one to the next.
    ///
    /// The first normal is `start`, without its part along the tangent; or that of some axis of space, if none is
    /// given. On plane curves the frames are exact; else they differ from the rotation-minimising ones by the fourth
    /// power of the distances of the parameters. A jump or a corner between two parameters is stepped over like any
    /// other way.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::ParametersDecrease`]; [`Error::Stationary`] where the derivative vanishes;
    /// [`Error::AlongTangent`] if `start` is along the tangent or zero.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Error, SplineSpace};
    /// let points = vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0]];
    /// let bend = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    /// let frames = bend.rotation_minimising_frames(&[0.0, 0.5, 1.0], Some(&vector![0.0, 0.0, 2.0]))?;
    /// assert!(frames.iter().all(|frame| *frame.normal() == vector![0.0, 0.0, 1.0]));
    /// let along = bend.rotation_minimising_frames(&[0.0], Some(&vector![1.0, 0.0, 0.0]));
    /// assert_eq!(along, Err(Error::AlongTangent));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "double reflection")]
    pub fn rotation_minimising_frames(
        &self,
        parameters: &[T],
        start: Option<&SVector<T, 3>>,
    ) -> Result<Vec<Frame<T, 3>>> {
        rotation_minimising(parameters, start, |x| self.derivatives_at(x, 1))
    }
}

impl<T: Real> NurbsCurve<T, 3> {
    /// The Frenet frame at `x`, as that of a [polynomial curve](Curve::<T, 3>::frame_at).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::Stationary`]; [`Error::Straight`].
    pub fn frame_at(&self, x: &T) -> Result<Frame<T, 3>> {
        frenet_frame(self.derivatives_at(x, 2)?, x)
    }

    /// Frames that do not turn about the tangent, as those of a [polynomial curve](Curve::rotation_minimising_frames).
    ///
    /// # Errors
    /// As [`Curve::rotation_minimising_frames`].
    pub fn rotation_minimising_frames(
        &self,
        parameters: &[T],
        start: Option<&SVector<T, 3>>,
    ) -> Result<Vec<Frame<T, 3>>> {
        rotation_minimising(parameters, start, |x| self.derivatives_at(x, 1))
    }
}
