//! Polygons of cubic B-spline curves, refined by steps.
//!
//! The leg from `P_i` to `P_{i+1}` has the knot interval `d_i`, the length of a segment of the curve. A step puts a point on each leg
//! and moves each vertex,
//!
//! ```text
//! E_i = ((d_i + 2 d_{i+1}) P_i + (d_i + 2 d_{i-1}) P_{i+1}) / (2 (d_{i-1} + d_i + d_{i+1}))
//! V_i = (d_i E_{i-1} + (d_{i-1} + d_i) P_i + d_{i-1} E_i) / (2 (d_{i-1} + d_i))
//! ```
//! and halves the intervals [Sederberg, 1998]. A leg of
//! interval 0, as there are many after [`ControlPolygon::converted`](crate::ControlPolygon::converted), is a double knot: it
//! is not halved and gets no point. A vertex between two of them is on the curve, and stays.

use crate::error::Result;
use crate::mesh::boundary::Boundary;
use crate::mesh::polygon_space;
use crate::scalar::Scalar;
use crate::spline::Curve;
use nalgebra::SVector;

const DEGREE: usize = 3;

/// A polygon, closed or open, with a knot interval a leg, that controls a cubic B-spline curve.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{CubicPolygon, Q, Scalar};
/// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
/// let square = CubicPolygon::closed(vec![q(0, 0), q(8, 0), q(8, 8), q(0, 8)])?;
/// assert_eq!(square.refined(1)?.points()[..3], [q(4, 0), q(7, 1), q(8, 4)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CubicPolygon<T: Scalar, const N: usize> {
    points: Vec<SVector<T, N>>,
    /// Of an open polygon one more before the first leg and one after the last.
    intervals: Vec<T>,
    closed: bool,
}

impl<T: Scalar, const N: usize> CubicPolygon<T, N> {
    /// The closed polygon with equal knot intervals.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`](crate::Error::TooFewPoints) for fewer than three, [`Error::NotFinite`](crate::Error::NotFinite),
    /// [`Error::TooLarge`](crate::Error::TooLarge).
    pub fn closed(points: Vec<SVector<T, N>>) -> Result<Self> {
        let intervals = vec![T::one(); points.len()];
        Self::from_parts(points, intervals, true)
    }

    /// The open polygon of at least four points with equal knot intervals: the curve begins near the second point if the boundary is
    /// [`Boundary::Open`]. Otherwise the first two and the last two intervals are 0, and the curve begins at the first point.
    ///
    /// # Errors
    /// As [`closed`](Self::closed).
    pub fn open(points: Vec<SVector<T, N>>, boundary: Boundary) -> Result<Self> {
        let mut intervals = vec![T::one(); points.len() + 1];
        if let (Boundary::Smooth | Boundary::Corners, [a, b, .., c, d]) = (boundary, &mut intervals[..]) {
            [a, b, c, d].into_iter().for_each(|interval| *interval = T::zero());
        }
        Self::from_parts(points, intervals, false)
    }

    /// The polygon with other knot intervals: one a leg, and of an open polygon one before the first leg and one after the last.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`](crate::Error::CoefficientCount), [`Error::NotFinite`](crate::Error::NotFinite),
    /// [`MeshError::NegativeInterval`](crate::MeshError::NegativeInterval); [`MeshError::Torn`](crate::MeshError::Torn) if
    /// three neighbours are 0; [`Error::UnusedCoefficient`](crate::Error::UnusedCoefficient) if the third interval of an open polygon is, or the
    /// last but two.
    pub fn with_intervals(self, intervals: Vec<T>) -> Result<Self> {
        Self::from_parts(self.points, intervals, self.closed)
    }

    /// The polygon with the given intervals, checked.
    pub(super) fn from_parts(points: Vec<SVector<T, N>>, intervals: Vec<T>, closed: bool) -> Result<Self> {
        polygon_space::check(DEGREE, closed, &points, &intervals)?;
        Ok(Self { points, intervals, closed })
    }

    /// The vertices.
    pub fn points(&self) -> &[SVector<T, N>] {
        &self.points
    }

    /// The knot intervals: of the legs, and of an open polygon one before the first leg and one after the last.
    pub fn intervals(&self) -> &[T] {
        &self.intervals
    }

    /// Whether a leg joins the last vertex with the first.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The polygon after `depth` steps: of the same curve, with knots in the middle of all segments.
    ///
    /// A closed polygon begins with the point on leg 0 and ends with vertex 0, moved. If leg 0 has no interval, it begins with vertex 0.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge); [`Error::NotFinite`](crate::Error::NotFinite) on overflow, and what
    /// [`with_intervals`](Self::with_intervals) refuses if intervals are rounded to 0.
    pub fn refined(&self, depth: usize) -> Result<Self> {
        polygon_space::check_depth(&self.intervals, depth)?;
        (0..depth).try_fold(self.clone(), |polygon, _| polygon.halved())
    }

    /// The points of the curve where the segments of the legs on both sides of a vertex meet: of every vertex of a closed polygon, and of all but
    /// the first and the last of an open one.
    ///
    /// ```text
    /// (d_i L + d_{i-1} R) / (d_{i-1} + d_i),    L = (d_i P_{i-1} + (d_{i-2} + d_{i-1}) P_i) / (d_{i-2} + d_{i-1} + d_i)
    ///                                           R = ((d_i + d_{i+1}) P_i + d_{i-1} P_{i+1}) / (d_{i-1} + d_i + d_{i+1})
    /// ```
    pub fn limit_points(&self) -> Vec<SVector<T, N>> {
        let inside = if self.closed { 0..self.points.len() } else { 1..self.points.len() - 1 };
        inside.map(|i| self.limit_point(i as isize)).collect()
    }

    fn limit_point(&self, i: isize) -> SVector<T, N> {
        let [p, a, b, q] = [i - 2, i - 1, i, i + 1].map(|leg| self.interval(leg));
        let whole = a.clone() + b;
        if whole == T::zero() {
            return self.point(i).clone();
        }
        let left = mixed(self.point(i - 1), b, self.point(i), &(p.clone() + a));
        let right = mixed(self.point(i), &(b.clone() + q), self.point(i + 1), a);
        mixed(&left, b, &right, a)
    }

    /// The curve, of degree 3, over the knots that the intervals tell: coefficient `i` is vertex `i`, and the domain begins at
    /// vertex 1, at parameter 0. If leg 1 of a closed polygon has interval 0, it begins with the next leg that has one, and
    /// coefficient 1 is the vertex there.
    ///
    /// # Errors
    /// [`Error::SpanOutOfRange`](crate::Error::SpanOutOfRange), [`Error::NotFinite`](crate::Error::NotFinite) and the like for
    /// intervals that sum up badly in floats.
    pub fn curve(&self) -> Result<Curve<T, N>> {
        polygon_space::curve(DEGREE, self.closed, &self.points, &self.intervals)
    }

    fn halved(&self) -> Result<Self> {
        let (count, half) = (self.points.len() as isize, |i: isize| self.interval(i).clone() / T::int(2));
        let (mut points, mut intervals) = (Vec::new(), Vec::new());
        let legs = if self.closed { count } else { count - 1 };
        if !self.closed && *self.interval(0) != T::zero() {
            // The curve does not reach the first vertex.
            intervals.push(half(0));
        } else if !self.closed {
            points.push(self.points[0].clone());
            intervals.push(self.interval(-1).clone());
        }
        for i in 0..legs {
            if self.closed || i > 0 {
                points.push(self.vertex(i));
            }
            let whole = *self.interval(i) != T::zero();
            if whole {
                points.push(self.edge(i));
            }
            let parts = if !whole || !self.closed && (i == 0 || i == legs - 1) { 1 } else { 2 };
            intervals.extend((0..parts).map(|_| half(i)));
        }
        if !self.closed && *self.interval(legs - 1) != T::zero() {
            intervals.push(half(legs - 1));
        } else if !self.closed {
            points.extend(self.points.last().cloned());
            intervals.push(self.interval(legs).clone());
        }
        if self.closed && *self.interval(0) != T::zero() {
            // As the curve does, which begins after leg 0.
            points.rotate_left(1);
            intervals.rotate_left(1);
        }
        Self::from_parts(points, intervals, self.closed)
    }

    /// `E_i`.
    fn edge(&self, i: isize) -> SVector<T, N> {
        let [before, own, after] = [i - 1, i, i + 1].map(|leg| self.interval(leg));
        let weight = |other: &T| own.clone() + other + other;
        mixed(self.point(i), &weight(after), self.point(i + 1), &weight(before))
    }

    /// `V_i`.
    fn vertex(&self, i: isize) -> SVector<T, N> {
        let [before, after] = [i - 1, i].map(|leg| self.interval(leg));
        if before.clone() + after == T::zero() {
            return self.point(i).clone();
        }
        let between = mixed(&self.edge(i - 1), after, &self.edge(i), before);
        (between + self.point(i)) * T::frac(1, 2)
    }

    fn point(&self, i: isize) -> &SVector<T, N> {
        &self.points[i.rem_euclid(self.points.len() as isize) as usize]
    }

    /// The interval of leg `i`.
    fn interval(&self, i: isize) -> &T {
        let i = if self.closed { i } else { i + 1 };
        &self.intervals[i.rem_euclid(self.intervals.len() as isize) as usize]
    }
}

/// The mean of two points with weights, not both 0.
fn mixed<T: Scalar, const N: usize>(
    p: &SVector<T, N>,
    weight: &T,
    q: &SVector<T, N>,
    other: &T,
) -> SVector<T, N> {
    let share = other.clone() / (weight.clone() + other);
    p * (T::one() - &share) + q * share
}
