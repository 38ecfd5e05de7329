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
use crate::limits::check_dim;
use crate::rational::spline::NurbsCurve;
use crate::scalar::{Real, Scalar};
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
    let point = |(x, y): (i64, i64)| centre.plus_scaled(&T::int(x), a).plus_scaled(&T::int(y), b);
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
/// centre may differ in the last bits, by `2^-40` of themselves, and a right angle may be missed by as much without a piece
/// more.
///
/// # Errors
/// [`Error::NotOnCircle`] unless both points have the same distance from `centre`, which is not zero (nor so small that its
/// square is); [`Error::NotFinite`] if the square of a distance overflows.
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
    let squares = [&here, &last].map(|end| dot(end, end));
    if let Some(index) = squares.iter().position(|square| !square.is_finite()) {
        return Err(Error::NotFinite { what: "squared distance", index });
    }
    let [square, other] = squares;
    let slack = if T::EXACT { T::zero() } else { square.clone() * T::frac(1, 1 << 40) };
    if square.is_zero() || (other - &square).magnitude() > slack {
        return Err(Error::NotOnCircle);
    }
    let mut ends = Vec::with_capacity(5);
    ends.push(here.clone());
    // A quarter at a time while more than a quarter is left.
    loop {
        let (across, along) = (cross2(&here, &last), dot(&here, &last));
        let within_quarter = across > T::zero() && along >= -slack.clone();
        if within_quarter || ends.len() == 4 {
            ends.push(last);
            break;
        }
        here = vector![-here[1].clone(), here[0].clone()];
        ends.push(here.clone());
    }
    let rational = |before: &T, k: T| [T::one(), T::one() / (k * before)];
    arcs(centre, [from, to], &square, &ends, rational)
}

/// The arc of the circle around `centre` with `radius` that starts at the angle `start` and turns by `sweep`, over `[0, 1]`.
///
/// Angles are in radians, counter-clockwise from the right; a negative `sweep` turns clockwise, and one beyond a full turn
/// runs over the circle again. There is one piece for each begun quarter, with the weights `1, cos(θ/2), 1` of its angle `θ`:
/// the middle of its parameters is the middle of its angle.
///
/// # Errors
/// [`Error::NotFinite`]; [`Error::NotOnCircle`] if the square of the radius is zero, [`Error::TooLarge`] for very many turns.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use std::f64::consts::PI;
/// let half = symspline::arc_by_angles(&vector![1.0, 0.0], &2.0, &0.0, &-PI)?;
/// assert!((half.at(&0.5)? - vector![1.0, -2.0]).norm() < 1e-15);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn arc_by_angles<T: Real>(
    centre: &SVector<T, 2>,
    radius: &T,
    start: &T,
    sweep: &T,
) -> Result<NurbsCurve<T, 2>> {
    let square = radius.clone() * radius;
    if let Some(index) = [&square, start, sweep].iter().position(|x| !x.is_finite()) {
        return Err(Error::NotFinite { what: "radius or angle", index });
    }
    if square.is_zero() {
        return Err(Error::NotOnCircle);
    }
    // A right angle that rounding made larger is still one piece.
    let quarters = (sweep.to_f64().abs() / std::f64::consts::FRAC_PI_2 - 1e-9).ceil().max(1.0) as usize;
    check_dim(quarters.saturating_mul(2))?;
    let arm = |i: usize| {
        let angle = start.clone() + sweep.clone() * T::frac(i as i64, quarters as i64);
        let (sin, cos) = angle.sin_cos();
        vector![cos * radius, sin * radius]
    };
    let ends: Vec<_> = (0..=quarters).map(arm).collect();
    let [from, to] = [&ends[0], &ends[quarters]].map(|end| end + centre);
    arcs(centre, [&from, &to], &square, &ends, |_, k| [k.sqrt(), T::one()])
}

/// The arcs between neighbouring `ends`, as seen from the centre, each less than half a turn. `weigh` gives `w_1` and `w_2`
/// from `w_0` and `k`.
fn arcs<T: Scalar>(
    centre: &SVector<T, 2>,
    [from, to]: [&SVector<T, 2>; 2],
    square: &T,
    ends: &[SVector<T, 2>],
    weigh: impl Fn(&T, T) -> [T; 2],
) -> Result<NurbsCurve<T, 2>> {
    let (mut points, mut weights) = (vec![from.clone()], vec![T::one()]);
    for pair in ends.windows(2) {
        let k = (square.clone() + dot(&pair[0], &pair[1])) / (T::int(2) * square);
        let middle = (&pair[0] + &pair[1]).scaled(&(T::one() / (T::int(2) * &k)));
        points.extend([middle + centre, &pair[1] + centre]);
        weights.extend(weigh(&weights[weights.len() - 1], k));
    }
    let pieces = ends.len() - 1;
    // The ends are what was given, not rounded sums.
    points[2 * pieces] = to.clone();
    let inner = (1..pieces).flat_map(|i| [i, i]);
    let breaks = [0].into_iter().chain(inner).chain([pieces]).map(|i| T::frac(i as i64, pieces as i64));
    NurbsCurve::new(SplineSpace::clamped(2, breaks)?, points, weights)
}
