//! Areas of the parameter plane.

use crate::analysis::crossings::Crossings;
use crate::analysis::zeros::Zero;
use crate::error::Result;
use crate::error::deform::DeformError;
use crate::rational::spline::NurbsCurve;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::polygon::{Polygons, is_inside};
use crate::spline::Curve;
use crate::vector::extent;
use nalgebra::vector;

/// An area of the parameter plane of a surface, by the even-odd rule: bounded by [`Polygons`] over any field, or in `f64` by a
/// closed curve, polynomial or rational. A list of areas is what lies in an odd number of them.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Area, DeformError, Error, circle, segment};
/// let disc = circle(&vector![1.0, 1.0], &0.5)?;
/// assert_eq!(disc.inside(&[0.4, 0.6, 1.4, 1.6], &1.0)?, [false, true, true, false]);
/// let ring = [disc, circle(&vector![1.0, 1.0], &0.25)?];
/// assert_eq!(ring[..].inside(&[0.6, 1.0, 1.4], &1.0)?, [true, false, true]);
/// let open = segment(&vector![0.0, 0.0], &vector![1.0, 1.0])?;
/// assert!(matches!(open.inside(&[0.5], &0.2), Err(Error::Deform(DeformError::OpenBoundary { .. }))));
/// # Ok::<(), symspline::Error>(())
/// ```
pub trait Area<T> {
    /// The lowest and the highest corner of a box around the area.
    ///
    /// # Errors
    /// [`DeformError::NoSamples`] for an area without bounds; [`Error::NotFinite`](crate::Error::NotFinite).
    fn bounds(&self) -> Result<[(T, T); 2]>;

    /// Which of the points `(u, v)` are in the area, for each `u` of a list.
    ///
    /// Of points on a curve that bounds the area nothing is promised. A call looks at the whole curve once.
    ///
    /// # Errors
    /// [`DeformError::OpenBoundary`] for a curve that is not closed, but for rounding; those of [`Crossings::crossings`].
    fn inside(&self, us: &[T], v: &T) -> Result<Vec<bool>>;
}

/// Edges and corners belong to the area.
impl<T: Scalar> Area<T> for Polygons<T> {
    fn bounds(&self) -> Result<[(T, T); 2]> {
        let corners = self.edges().iter().map(|[corner, _]| [corner.clone(), corner.clone()]);
        corners.reduce(around).ok_or_else(|| DeformError::NoSamples.into())
    }

    fn inside(&self, us: &[T], v: &T) -> Result<Vec<bool>> {
        let meets = |[(_, c), (_, d)]: &&[(T, T); 2]| (c <= v && v <= d) || (d <= v && v <= c);
        let near: Vec<&[(T, T); 2]> = self.edges().iter().filter(meets).collect();
        let edges = || near.iter().map(|[(a, c), (b, d)]| [(a, c), (b, d)]);
        Ok(us.iter().map(|u| is_inside(edges(), (u, v))).collect())
    }
}

impl<T: Scalar, A: Area<T>> Area<T> for [A] {
    fn bounds(&self) -> Result<[(T, T); 2]> {
        let each = self.iter().map(A::bounds).collect::<Result<Vec<_>>>()?;
        each.into_iter().reduce(around).ok_or_else(|| DeformError::NoSamples.into())
    }

    fn inside(&self, us: &[T], v: &T) -> Result<Vec<bool>> {
        self.iter().try_fold(vec![false; us.len()], |mut odd, area| {
            odd.iter_mut().zip(area.inside(us, v)?).for_each(|(odd, inside)| *odd ^= inside);
            Ok(odd)
        })
    }
}

/// By how much of its size a closed curve may miss itself.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// What of a row is inside the curve is told by where it crosses the row, each place proved.
macro_rules! bounded_by_curves {
    ($($curve:ident)*) => {$(
        impl Area<f64> for $curve<f64, 2> {
            fn bounds(&self) -> Result<[(f64, f64); 2]> {
                let size = extent(&self.control_points()?).max(f64::MIN_POSITIVE);
                let [u, v] = self.bounding_box(&(size * 1e-9))?;
                Ok([(u.least.bound, v.least.bound), (u.greatest.bound, v.greatest.bound)])
            }

            fn inside(&self, us: &[f64], v: &f64) -> Result<Vec<bool>> {
                let (space, size) = (self.space(), extent(&self.control_points()?));
                let (start, end) = space.domain();
                for (knot, copies) in space.breaks() {
                    let jumps = copies > space.degree();
                    let left = match knot == *start {
                        true if jumps || !space.is_periodic() => *end,
                        false if jumps && knot != *end => knot,
                        _ => continue,
                    };
                    if extent(&[self.at(&knot)? - self.at_left(&left)?]) > size * ROUNDING {
                        return Err(DeformError::OpenBoundary { parameter: left.to_string() }.into());
                    }
                }
                let zeros = self.crossings(&vector![0.0, 1.0], v)?;
                let crossed = crossed(&zeros, start, |t| Ok(self.at(t)?[0]))?;
                let beyond = |u: &f64| crossed.len() - crossed.partition_point(|x| x <= u);
                Ok(us.iter().map(|u| beyond(u) % 2 == 1).collect())
            }
        }
    )*};
}

bounded_by_curves!(Curve NurbsCurve);

/// Where a curve that is closed at `seam` passes from one side of a row to the other, ascending.
fn crossed(zeros: &[Zero<f64>], seam: &f64, coordinate: impl Fn(&f64) -> Result<f64>) -> Result<Vec<f64>> {
    let place = |zero: &Zero<f64>| {
        let (low, high) = zero.place.bounds();
        coordinate(&(low / 2.0 + high / 2.0))
    };
    let changes = zeros.iter().filter(|zero| zero.changes_sign());
    let mut places = changes.map(place).collect::<Result<Vec<f64>>>()?;
    // The ends may lie on both sides of the row, and be on it or not: rounding tells.
    let first = zeros.first().and_then(|zero| zero.before.or(zero.after));
    let last = zeros.last().and_then(|zero| zero.after.or(zero.before));
    if first != last {
        places.push(coordinate(seam)?);
    }
    places.sort_by(f64::total_cmp);
    Ok(places)
}

/// The box around two boxes.
fn around<T: Scalar>([a, b]: [(T, T); 2], [c, d]: [(T, T); 2]) -> [(T, T); 2] {
    let less = |x: T, y: T| if y < x { y } else { x };
    let more = |x: T, y: T| if y > x { y } else { x };
    [(less(a.0, c.0), less(a.1, c.1)), (more(b.0, d.0), more(b.1, d.1))]
}
