//! The convex hull of control points in the plane, in which the curve lies.
//!
//! Points in the order of their coordinates are walked once from left to right and once back; whatever is not a left turn
//! goes. Signs of areas are all it needs, so over an exact field it is exact.

use crate::scalar::{Scalar, larger};
use crate::spline::Curve;
use crate::vector::cross2;
use nalgebra::SVector;
use std::cmp::Ordering;

impl<T: Scalar> Curve<T, 2> {
    /// The corners of the convex hull of the control points, as indices of control points: counter-clockwise from the
    /// leftmost one (the lowest of those), without points between others on a side.
    ///
    /// If all points are on a line these are its two ends, if they coincide a single one. In `f64` areas are rounded:
    /// points that are hardly corners may be kept or left out.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![1.0, 4.0], vector![1.0, 1.0], vector![2.0, 0.0]];
    /// let curve = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points)?;
    /// assert_eq!(curve.control_hull(), [0, 3, 1]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn control_hull(&self) -> Vec<usize> {
        hull(self.coeffs())
    }
}

/// The corners of the convex hull of some points, counter-clockwise from the leftmost.
fn hull<T: Scalar>(points: &[SVector<T, 2>]) -> Vec<usize> {
    let order = |x: &T, y: &T| x.partial_cmp(y).expect("finite points are ordered");
    let by_place = |&i: &usize, &j: &usize| -> Ordering {
        let (c, d) = (&points[i], &points[j]);
        order(&c[0], &d[0]).then_with(|| order(&c[1], &d[1]))
    };
    let mut sorted: Vec<usize> = (0..points.len()).collect();
    sorted.sort_by(by_place);
    sorted.dedup_by(|i, j| points[*i] == points[*j]);
    if sorted.len() < 3 {
        return sorted;
    }
    // Products of the coordinates of a tiny or a huge polygon leave the range of floating point.
    let size = points.iter().flatten().map(T::magnitude).fold(T::zero(), larger);
    let unit = (0..6).fold(T::one(), |unit, _| unit * T::frac(1, 1 << 52));
    let safe = T::EXACT || size.is_zero() || unit < size && size < T::one() / &unit;
    let scaled = (!safe).then(|| points.iter().map(|point| point.map(|x| x / &size)).collect::<Vec<_>>());
    let points = scaled.as_deref().unwrap_or(points);
    let turns_left = |i: usize, j: usize, k: usize| {
        let [to, on] = [(i, j), (j, k)].map(|(a, b)| [0, 1].map(|x| points[b][x].clone() - &points[a][x]));
        cross2(&to.into(), &on.into()) > T::zero()
    };
    let chain = |walk: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for k in walk {
            while let [.., i, j] = chain[..] {
                if turns_left(i, j, k) {
                    break;
                }
                chain.pop();
            }
            chain.push(k);
        }
        // The last is the first of the other chain.
        chain.pop();
        chain
    };
    let mut corners = chain(&mut sorted.iter().copied());
    corners.extend(chain(&mut sorted.iter().rev().copied()));
    corners
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::vector;

    #[test]
    fn degenerate_hulls() {
        let point = vector![1.0, 2.0];
        assert_eq!(hull(&[point]), [0]);
        assert_eq!(hull(&[point; 3]).len(), 1);
        assert_eq!(hull(&[vector![2.0, 2.0], vector![0.0, 0.0], vector![1.0, 1.0]]), [1, 0]);
        assert_eq!(hull(&[vector![0.0, 2.0], vector![0.0, 0.0], vector![0.0, 1.0]]), [1, 0]);
    }

    #[test]
    fn size_does_not_matter() {
        for size in [1e-323, 1e-200, 1.0, 1e200, f64::MAX] {
            let corners = [[-size, -size], [size, -size], [0.0, 0.0], [size, size], [-size, size]];
            assert_eq!(hull(&corners.map(Into::into)), [0, 1, 3, 4], "{size:e}");
        }
    }

    #[test]
    fn points_on_a_side_are_no_corners() {
        let square: Vec<_> = (0..9).map(|i| vector![f64::from(i % 3), f64::from(i / 3)]).collect();
        assert_eq!(hull(&square), [0, 2, 8, 6]);
    }
}
