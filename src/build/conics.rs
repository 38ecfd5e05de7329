//! Conics as rational quadratics, exact over any field: segments, conic arcs, circles and ellipses.
//!
//! The arc of a circle with centre `c` from `c + a` to `c + b`, less than half a turn, has the middle control point
//! `c + (a + b) / (2 k)` and weights `w_0, w_1, w_2` with
//!
//! ```text
//! w_1² / (w_0 w_2) = k = (1 + cos θ) / 2 = (a·a + a·b) / (2 a·a)         [NURBS, section 7.3]
//! ```
//! The usual choice `w_0 = w_2 = 1` needs a square root. `w_0 = w_1 = 1`, `w_2 = 1 / k` does not, and arcs in a row have
//! weights `..., e, 1, 1 / (e k), 1, ...`.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::rational::spline::NurbsCurve;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Spline};
use crate::vector::{cross2, dot};
use nalgebra::{SVector, vector};

/// The segment from `from` to `to` over `[0, 1]`.
///
/// # Errors
/// [`Error::NotFinite`].
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// let half = symspline::segment(&vector![0.0, 0.0], &vector![2.0, 4.0])?.at(&0.5)?;
/// assert_eq!(half, vector![1.0, 2.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn segment<T: Scalar, const N: usize>(from: &SVector<T, N>, to: &SVector<T, N>) -> Result<Curve<T, N>> {
    Spline::new(SplineSpace::bezier(1, T::zero(), T::one())?, vec![from.clone(), to.clone()])
}

/// The conic arc over `[0, 1]` with the given control points and weights: part of an ellipse, a parabola or a hyperbola as
/// `w_1²` is less than, equal to or greater than `w_0 w_2`.
///
/// # Errors
/// [`Error::NotFinite`]; [`Error::Weight`] for a weight that is not positive.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// let points = [vector![1.0, 0.0], vector![1.0, 1.0], vector![0.0, 1.0]];
/// let quarter = symspline::conic(&points, [1.0, 1.0, 2.0])?;
/// assert!((quarter.at(&0.3)?.norm() - 1.0).abs() < 1e-15);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn conic<T: Scalar, const N: usize>(
    points: &[SVector<T, N>; 3],
    weights: [T; 3],
) -> Result<NurbsCurve<T, N>> {
    NurbsCurve::new(SplineSpace::bezier(2, T::zero(), T::one())?, points.to_vec(), weights.to_vec())
}

/// The full ellipse `centre + a cos φ + b sin φ` over `[0, 1]`, starting at `centre + a`: four quarters of degree 2.
///
/// `a` and `b` are conjugate half-diameters, in the plane or in space; if they are perpendicular and of equal length it is
/// a circle. The weights are 1 and 2, so that everything is exact.
///
/// # Errors
/// [`Error::NotFinite`].
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Q, Scalar, ellipse};
/// let [o, a, b] = [[1, 1], [3, 0], [0, 2]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let point = ellipse(&o, &a, &b)?.at(&Q::frac(1, 10))? - &o;
/// assert_eq!(&point[0] * &point[0] / Q::int(9) + &point[1] * &point[1] / Q::int(4), Q::int(1));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn ellipse<T: Scalar, const N: usize>(
    centre: &SVector<T, N>,
    a: &SVector<T, N>,
    b: &SVector<T, N>,
) -> Result<NurbsCurve<T, N>> {
    // The corners of the square around the circle and the middles of its sides.
    const PLACES: [(i64, i64); 9] =
        [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let point = |(x, y): (i64, i64)| {
        let mut point = centre.clone();
        point.add_scaled(&T::int(x), a);
        point.add_scaled(&T::int(y), b);
        point
    };
    let quarters = [0, 1, 1, 2, 2, 3, 3, 4].map(|i| T::frac(i, 4));
    let weights = [1, 1, 2, 1, 1, 1, 2, 1, 1].map(T::int);
    NurbsCurve::new(SplineSpace::clamped(2, quarters)?, PLACES.map(point).to_vec(), weights.to_vec())
}

/// The full circle over `[0, 1]`, counter-clockwise from the right.
///
/// # Errors
/// [`Error::NotFinite`].
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Q, Scalar, circle};
/// let unit = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
/// let point = unit.at(&Q::frac(1, 7))?;
/// assert_eq!(&point[0] * &point[0] + &point[1] * &point[1], Q::int(1));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn circle<T: Scalar>(centre: &SVector<T, 2>, radius: &T) -> Result<NurbsCurve<T, 2>> {
    let zero = T::zero();
    ellipse(centre, &vector![radius.clone(), zero.clone()], &vector![zero, radius.clone()])
}

/// The arc of the circle around `centre`, counter-clockwise from `from` to `to`, over `[0, 1]`: one piece for each begun
/// quarter. If both points are the same it is the full circle.
///
/// Over an exact field the arc is exact, whatever the angle: no square root is needed. With `T = f64` the two distances from the
/// centre may differ in the last bits, by `2^-40` of themselves.
///
/// # Errors
/// [`Error::NotOnCircle`] unless both points have the same distance from `centre`, which is not zero.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Q, Scalar, arc};
/// let [o, from, to] = [[0, 0], [5, 0], [-3, -4]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let point = arc(&o, &from, &to)?.at(&Q::frac(9, 10))?;
/// assert_eq!(&point[0] * &point[0] + &point[1] * &point[1], Q::int(25));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn arc<T: Scalar>(
    centre: &SVector<T, 2>,
    from: &SVector<T, 2>,
    to: &SVector<T, 2>,
) -> Result<NurbsCurve<T, 2>> {
    let (mut here, last) = (from.minus(centre), to.minus(centre));
    let square = dot(&here, &here);
    let slack = if T::EXACT { T::zero() } else { square.clone() * T::frac(1, 1 << 40) };
    let level = (dot(&last, &last) - &square).magnitude() <= slack;
    if square.is_zero() || !level {
        return Err(Error::NotOnCircle);
    }
    let mut ends = Vec::with_capacity(5);
    ends.push(here.clone());
    // A quarter at a time while more than a quarter is left.
    loop {
        let (across, along) = (cross2(&here, &last), dot(&here, &last));
        let within_quarter = across > T::zero() && along >= T::zero();
        if within_quarter || ends.len() == 4 {
            ends.push(last);
            break;
        }
        here = vector![-here[1].clone(), here[0].clone()];
        ends.push(here.clone());
    }
    arcs(centre, &square, &ends)
}

/// The arcs between neighbouring `ends`, as seen from the centre, each less than half a turn.
fn arcs<T: Scalar>(centre: &SVector<T, 2>, square: &T, ends: &[SVector<T, 2>]) -> Result<NurbsCurve<T, 2>> {
    let (mut points, mut weights) = (vec![ends[0].clone()], vec![T::one()]);
    for pair in ends.windows(2) {
        let k = (square.clone() + dot(&pair[0], &pair[1])) / (T::int(2) * square);
        let mut middle = pair[0].clone();
        middle.add_scaled(&T::one(), &pair[1]);
        middle.scale(&(T::one() / (T::int(2) * &k)));
        let before = weights[weights.len() - 1].clone();
        points.extend([middle, pair[1].clone()]);
        weights.extend([T::one(), T::one() / (before * k)]);
    }
    let pieces = ends.len() - 1;
    let inner = (1..pieces).flat_map(|i| [i, i]);
    let breaks = [0].into_iter().chain(inner).chain([pieces]).map(|i| T::frac(i as i64, pieces as i64));
    let points = points.iter().map(|point| point + centre).collect();
    NurbsCurve::new(SplineSpace::clamped(2, breaks)?, points, weights)
}
