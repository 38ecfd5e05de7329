//! What shapes are bent about: where the ray from the centre `O` through a control point `P` meets a circle, line, curve, sphere,
//! plane or surface, as the share `s = OR / OP` of the way.
//!
//! Where it does more than once, the meeting nearest to `P` counts.

use crate::analysis::certify::Certified;
use crate::analysis::crossings::Crossings;
use crate::analysis::meet::report::LineMeetings;
use crate::analysis::zeros::Place;
use crate::coeff::Coeff;
use crate::error::Result;
use crate::error::shape::ShapeError;
use crate::rational::spline::{NurbsCurve, NurbsSurface};
use crate::roots::RootValue;
use crate::scalar::Scalar;
use crate::shape::root::{distance, divided, root, size, sure_dot};
use crate::spline::Curve;
use crate::tensor::spline::Surface;
use crate::vector::dot;
use nalgebra::SVector;

/// Something shapes can be bent about.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Bendable, Q, Round, Scalar, Sphere};
/// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
/// // A circle about the centre of the bend, and one beside it.
/// assert_eq!(Round(Q::int(2)).share(&q(0, 0), &q(3, 4))?, Some(Q::frac(2, 5)));
/// let circle = Sphere { centre: q(1, 0), radius: Q::int(1) };
/// assert_eq!(circle.share(&q(0, 0), &q(4, 0))?, Some(Q::frac(1, 2)));
/// assert_eq!(circle.share(&q(0, 0), &q(-4, 0))?, None);
/// # Ok::<(), symspline::Error>(())
/// ```
pub trait Bendable<T: Scalar, const N: usize> {
    /// The positive share `s` of the way from `centre` to `point`, which differ, after which the ray is on the bend curve or
    /// surface; the nearest to 1 of several, nothing if there is none.
    ///
    /// # Errors
    /// [`ShapeError::NoRoot`] if it is not in the field.
    fn share(&self, centre: &SVector<T, N>, point: &SVector<T, N>) -> Result<Option<T>>;
}

/// The share nearest to 1 of those that are positive; the smaller of two.
fn nearest<T: Scalar>(shares: impl IntoIterator<Item = T>) -> Option<T> {
    let off = |s: &T| (s.clone() - T::one()).magnitude();
    let nearer = |best: T, s: T| {
        let (far, near) = (off(&best), off(&s));
        if near < far || (near == far && s < best) { s } else { best }
    };
    shares.into_iter().filter(|s| *s > T::zero() && s.is_finite()).reduce(nearer)
}

/// A circle (in the plane), sphere (in space) or cylinder (about an axis of centres) of this radius about the centre of the bend
/// itself [NURBS, (11.64)]: `s = r / |P - O|`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Round<T>(
    /// The radius.
    pub T,
);

impl<T: Scalar, const N: usize> Bendable<T, N> for Round<T> {
    fn share(&self, centre: &SVector<T, N>, point: &SVector<T, N>) -> Result<Option<T>> {
        Ok(nearest([self.0.clone() / distance(&point.minus(centre))?]))
    }
}

/// A circle in the plane or a sphere in space, wherever the centre of the bend is.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere<T, const N: usize> {
    /// Its centre.
    pub centre: SVector<T, N>,
    /// Its radius.
    pub radius: T,
}

impl<T: Scalar, const N: usize> Bendable<T, N> for Sphere<T, N> {
    /// The roots of `a s² + 2 b s + c`, with a quarter of the discriminant as `a (r² - h²)`, where `h` is the distance of the line from
    /// the centre: that cancels less than `b² - a c` far from the sphere.
    fn share(&self, centre: &SVector<T, N>, point: &SVector<T, N>) -> Result<Option<T>> {
        let way = point.minus(centre);
        let length = size(&way);
        let (way, off) = (divided(&way, &length), divided(&centre.minus(&self.centre), &length));
        let radius = self.radius.clone() / &length;
        let (a, b) = (way.squared_size(), dot(&way, &off));
        let c = off.squared_size() - radius.clone() * &radius;
        let height = off.plus_scaled(&(-(b.clone() / &a)), &way);
        let square = a.clone() * (radius.clone() * radius - height.squared_size());
        if square < T::zero() {
            return Ok(None);
        }
        let root = root(&square)?;
        // The larger root in size first, whose sum does not cancel; the product of both is `c / a`.
        let sum = if b < T::zero() { root - b } else { -(root + b) };
        if sum.is_zero() {
            return Ok(None);
        }
        Ok(nearest([sum.clone() / a, c / sum]))
    }
}

/// A line in the plane or a plane in space: `s = (Q - O)·N / (P - O)·N`.
#[derive(Clone, Debug, PartialEq)]
pub struct Flat<T, const N: usize> {
    /// A point of it.
    pub origin: SVector<T, N>,
    /// A vector across it.
    pub normal: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Bendable<T, N> for Flat<T, N> {
    fn share(&self, centre: &SVector<T, N>, point: &SVector<T, N>) -> Result<Option<T>> {
        let normal = divided(&self.normal, &size(&self.normal));
        let rate = sure_dot(&point.minus(centre), &normal);
        let height = dot(&self.origin.minus(centre), &normal);
        Ok(if rate.is_zero() { None } else { nearest([height / rate]) })
    }
}

/// The shares at the ends of a part of the ray that is on the bend curve, and 1 if that is in between.
fn overlap<T: Scalar>(ends: [T; 2]) -> impl Iterator<Item = T> {
    let one = T::one();
    let between = (ends[0] < one && one < ends[1]) || (ends[1] < one && one < ends[0]);
    ends.into_iter().chain(between.then_some(one))
}

/// The shares at which a ray meets a curve; over an exact field those in it.
fn curve_share<T: Certified, B: Crossings<T, 2>>(
    curve: &B,
    at: impl Fn(&T) -> Result<SVector<T, 2>>,
    [centre, point]: [&SVector<T, 2>; 2],
) -> Result<Option<T>> {
    let way = point.minus(centre);
    let length = size(&way);
    let way = divided(&way, &length);
    let share = |x: &T| -> Result<T> { Ok(dot(&at(x)?.minus(centre), &way) / way.squared_size() / &length) };
    let mut shares = Vec::new();
    for zero in curve.meet_line(centre, &way)? {
        match &zero.place {
            Place::At(_) if zero.multiplicity == 0 => {}
            Place::At(RootValue::Exact(x)) => shares.push((share(x)?, true)),
            Place::At(RootValue::Enclosed(start, end)) => {
                let middle = start.clone() + (end.clone() - start) / T::int(2);
                shares.push((share(&middle)?, !T::EXACT));
            }
            Place::Along(start, end) => {
                shares.extend(overlap([share(start)?, share(end)?]).map(|share| (share, true)));
            }
        }
    }
    let best = nearest(shares.iter().map(|(s, _)| s.clone()));
    match best {
        Some(s) if shares.contains(&(s.clone(), false)) => {
            Err(ShapeError::NoRoot { square: s.to_string() }.into())
        }
        best => Ok(best),
    }
}

impl<T: Certified> Bendable<T, 2> for Curve<T, 2> {
    fn share(&self, centre: &SVector<T, 2>, point: &SVector<T, 2>) -> Result<Option<T>> {
        curve_share(self, |x| self.at(x), [centre, point])
    }
}

impl<T: Certified> Bendable<T, 2> for NurbsCurve<T, 2> {
    fn share(&self, centre: &SVector<T, 2>, point: &SVector<T, 2>) -> Result<Option<T>> {
        curve_share(self, |x| self.at(x), [centre, point])
    }
}

/// The tolerance with which a line meets a bend surface, relative to the distance of centre and control point.
const TOLERANCE: f64 = 1.0 / (1_u64 << 36) as f64;

fn surface_share(
    meet: impl FnOnce(&SVector<f64, 3>, &f64) -> Result<LineMeetings>,
    [centre, point]: [&SVector<f64, 3>; 2],
) -> Result<Option<f64>> {
    let way = point - centre;
    let found = meet(&way, &(TOLERANCE * distance(&way)?))?;
    let along = found.overlaps.iter().flat_map(|part| overlap([part.along.0, part.along.1]));
    Ok(nearest(found.meetings.iter().map(|meeting| meeting.along).chain(along)))
}

impl Bendable<f64, 3> for Surface<f64, 3> {
    fn share(&self, centre: &SVector<f64, 3>, point: &SVector<f64, 3>) -> Result<Option<f64>> {
        surface_share(|way, tolerance| self.meet_line(centre, way, tolerance), [centre, point])
    }
}

impl Bendable<f64, 3> for NurbsSurface<f64, 3> {
    fn share(&self, centre: &SVector<f64, 3>, point: &SVector<f64, 3>) -> Result<Option<f64>> {
        surface_share(|way, tolerance| self.meet_line(centre, way, tolerance), [centre, point])
    }
}

/// Any function from centre and point to the share.
#[derive(Clone, Copy, Debug)]
pub struct ByShare<F>(
    /// The function.
    pub F,
);

impl<T: Scalar, const N: usize, F> Bendable<T, N> for ByShare<F>
where
    F: Fn(&SVector<T, N>, &SVector<T, N>) -> Result<Option<T>>,
{
    fn share(&self, centre: &SVector<T, N>, point: &SVector<T, N>) -> Result<Option<T>> {
        (self.0)(centre, point)
    }
}
