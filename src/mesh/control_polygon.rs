//! Polygons cut by Chaikin's rule: quadratic B-spline curves.
//!
//! Vertex `P_i` has the knot interval `d_i`, the length of the segment of the curve near it; the segments of `P_i` and `P_{i+1}` meet
//! on the leg between them. A step cuts the leg into parts for the halves of both,
//!
//! ```text
//! (d_i + 2 d_{i+1}) P_i + d_i P_{i+1}        d_{i+1} P_i + (2 d_i + d_{i+1}) P_{i+1}
//! -----------------------------------  and   ---------------------------------------
//!         2 (d_i + d_{i+1})                           2 (d_i + d_{i+1})
//! ```
//! each with half the interval; of equal intervals these are `3/4, 1/4` and `1/4, 3/4` [Miura, (9), (10)]. A vertex without
//! interval is where two segments meet in a corner: it stays, as one vertex.
//!
//! [`Curve::closed`](crate::Spline::closed) is the uniform closed curve at once, and
//! [`fine_tuned_closed`](crate::Curve::fine_tuned_closed) fine tunes it.

use crate::error::Result;
use crate::limits::check_dim;
use crate::mesh::boundary::Boundary;
use crate::mesh::cubic_polygon::CubicPolygon;
use crate::mesh::polygon_space;
use crate::scalar::Scalar;
use crate::spline::Curve;
use nalgebra::SVector;

const DEGREE: usize = 2;

/// A polygon, closed or open, with a knot interval a vertex, that controls a quadratic B-spline curve.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Boundary, ControlPolygon, Q, Scalar};
/// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
/// let triangle = ControlPolygon::closed(vec![q(0, 0), q(8, 0), q(0, 8)])?;
/// assert_eq!(triangle.chaikin(1)?.points()[..3], [q(2, 0), q(6, 0), q(6, 2)]);
///
/// let bow = ControlPolygon::open(vec![q(0, 0), q(8, 0), q(8, 8)], Boundary::Smooth)?;
/// assert_eq!(bow.chaikin(1)?.points(), [q(0, 0), q(4, 0), q(8, 4), q(8, 8)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ControlPolygon<T: Scalar, const N: usize> {
    points: Vec<SVector<T, N>>,
    intervals: Vec<T>,
    closed: bool,
}

impl<T: Scalar, const N: usize> ControlPolygon<T, N> {
    /// The closed polygon with equal knot intervals.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`](crate::Error::TooFewPoints) for fewer than three, [`Error::NotFinite`](crate::Error::NotFinite),
    /// [`Error::TooLarge`](crate::Error::TooLarge).
    pub fn closed(points: Vec<SVector<T, N>>) -> Result<Self> {
        let intervals = vec![T::one(); points.len()];
        Self { points, intervals, closed: true }.checked()
    }

    /// The open polygon with equal knot intervals: the curve begins in the middle of the first leg if the boundary is
    /// [`Boundary::Open`]. Otherwise the first and the last interval are 0, and the curve begins at the first point.
    ///
    /// # Errors
    /// As [`closed`](Self::closed).
    pub fn open(points: Vec<SVector<T, N>>, boundary: Boundary) -> Result<Self> {
        let mut intervals = vec![T::one(); points.len()];
        if let (Boundary::Smooth | Boundary::Corners, [first, .., last]) = (boundary, &mut intervals[..]) {
            (*first, *last) = (T::zero(), T::zero());
        }
        Self { points, intervals, closed: false }.checked()
    }

    /// The polygon with other knot intervals, one a vertex. An open curve begins at the first point if its interval is 0.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`](crate::Error::CoefficientCount), [`Error::NotFinite`](crate::Error::NotFinite),
    /// [`MeshError::NegativeInterval`](crate::MeshError::NegativeInterval); [`MeshError::Torn`](crate::MeshError::Torn) if
    /// two neighbours are 0; [`Error::UnusedCoefficient`](crate::Error::UnusedCoefficient) for 0 at the second vertex of an open polygon, or the last
    /// but one.
    pub fn with_intervals(self, intervals: Vec<T>) -> Result<Self> {
        Self { intervals, ..self }.checked()
    }

    /// The vertices.
    pub fn points(&self) -> &[SVector<T, N>] {
        &self.points
    }

    /// The knot interval of each vertex.
    pub fn intervals(&self) -> &[T] {
        &self.intervals
    }

    /// Whether a leg joins the last vertex with the first.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The polygon after `depth` steps of Chaikin's rule: of the same curve, with knots in the middle of all segments.
    ///
    /// Of a closed polygon with `m` vertices, none of interval 0, the vertices on leg `i` after a step are `2 i` and `2 i + 1`.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge); [`Error::NotFinite`](crate::Error::NotFinite) on overflow, and what
    /// [`with_intervals`](Self::with_intervals) refuses if intervals are rounded to 0.
    pub fn chaikin(&self, depth: usize) -> Result<Self> {
        polygon_space::check_depth(&self.intervals, depth)?;
        let halved = |polygon: Self| {
            let half = |v: usize| polygon.intervals[v].clone() / T::int(2);
            let (points, intervals) = polygon.cut(2).map(|(v, point)| (point, half(v))).unzip();
            Self { points, intervals, ..polygon }.checked()
        };
        (0..depth).try_fold(self.clone(), |polygon, _| halved(polygon))
    }

    /// Where the segments of the curve meet: a point a leg,
    ///
    /// ```text
    /// (d_{i+1} P_i + d_i P_{i+1}) / (d_i + d_{i+1})
    /// ```
    /// The first and the last of an open polygon are the ends of the curve.
    pub fn joints(&self) -> Vec<SVector<T, N>> {
        (0..self.leg_count()).map(|i| self.on_leg(i, self.next(i), 1)).collect()
    }

    /// The curve as that of a cubic polygon [Miura, (11), (12)]: with the points
    ///
    /// ```text
    /// (2 d_i + 3 d_{i+1}) P_i + d_i P_{i+1}        d_{i+1} P_i + (3 d_i + 2 d_{i+1}) P_{i+1}
    /// -------------------------------------  and   -----------------------------------------
    ///          3 (d_i + d_{i+1})                            3 (d_i + d_{i+1})
    /// ```
    /// on each leg, the knot interval 0 between them and `d_i` around vertex `i`.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge), [`Error::NotFinite`](crate::Error::NotFinite) on overflow.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{ControlPolygon, Q, Scalar};
    /// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
    /// let cubic = ControlPolygon::closed(vec![q(0, 0), q(12, 0), q(0, 12)])?.converted()?;
    /// assert_eq!(cubic.points()[..3], [q(2, 0), q(10, 0), q(10, 2)]);
    /// assert_eq!(cubic.intervals(), [0, 1, 0, 1, 0, 1].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn converted(&self) -> Result<CubicPolygon<T, N>> {
        check_dim(self.points.len().saturating_mul(2))?;
        let (around, points): (Vec<usize>, Vec<_>) = self.cut(3).unzip();
        // A leg of the new polygon goes around a vertex if both its ends come of it.
        let between = |j: usize| match (around[j], around[(j + 1) % around.len()]) {
            (v, w) if v == w => self.intervals[v].clone(),
            _ => T::zero(),
        };
        let legs = if self.closed { around.len() } else { around.len() - 1 };
        let mut intervals: Vec<T> = (0..legs).map(between).collect();
        if !self.closed {
            intervals.insert(0, self.intervals[0].clone());
            intervals.extend(self.intervals.last().cloned());
        }
        CubicPolygon::from_parts(points, intervals, self.closed)
    }

    /// The curve, of degree 2, over the knots that the intervals tell: coefficient `i` is vertex `i`, and the domain begins at the
    /// joint on leg 0, at parameter 0. If vertex 1 of a closed polygon has interval 0, it begins at the next joint, with coefficient 0 at
    /// vertex 1.
    ///
    /// # Errors
    /// [`Error::SpanOutOfRange`](crate::Error::SpanOutOfRange), [`Error::NotFinite`](crate::Error::NotFinite) and the like for
    /// intervals that sum up badly in floats.
    pub fn curve(&self) -> Result<Curve<T, N>> {
        polygon_space::curve(DEGREE, self.closed, &self.points, &self.intervals)
    }

    /// Two points a leg, with the vertex that each belongs to; a vertex of interval 0 has one alone.
    fn cut(&self, parts: i64) -> impl Iterator<Item = (usize, SVector<T, N>)> + '_ {
        (0..self.leg_count()).flat_map(move |i| {
            let next = self.next(i);
            // The far end of a leg comes first, but for vertex 0.
            let near = (i == 0 || self.intervals[i] != T::zero()).then(|| (i, self.on_leg(i, next, parts)));
            let far = next != 0 || self.intervals[0] != T::zero();
            near.into_iter().chain(far.then(|| (next, self.on_leg(next, i, parts))))
        })
    }

    /// The point on the leg from vertex `v` to `w` after `d_v / (d_v + d_w)` of one of `parts` equal parts.
    fn on_leg(&self, v: usize, w: usize, parts: i64) -> SVector<T, N> {
        let [near, far] = [v, w].map(|v| &self.intervals[v]);
        let share = near.clone() / ((near.clone() + far) * T::int(parts));
        &self.points[v] * (T::one() - &share) + &self.points[w] * share
    }

    fn next(&self, i: usize) -> usize {
        if i + 1 == self.points.len() { 0 } else { i + 1 }
    }

    fn leg_count(&self) -> usize {
        self.points.len() - usize::from(!self.closed)
    }

    fn checked(self) -> Result<Self> {
        polygon_space::check(DEGREE, self.closed, &self.points, &self.intervals)?;
        Ok(self)
    }
}
