//! Splines as paths.
//!
//! Pieces up to degree 3 become cubic Bezier arcs exactly. A piece of higher degree is cut in halves until the cubic
//! with its end points and end derivatives is within the tolerance all along: the difference of the two is a
//! polynomial, whose control values bound it.

use crate::error::{Error, Result};
use crate::space::SplineSpace;
use crate::spline::{Curve, Function, Spline};
use kurbo::{BezPath, Point};
use nalgebra::{SVector, vector};

/// How often a piece may be halved; each halving gains a factor of 16.
const MAX_HALVINGS: usize = 12;

/// A plane curve as a path, no further than `tolerance` from it (in the unit of its points). Jumps start anew.
///
/// # Errors
/// [`Error::BadTolerance`] unless `tolerance` is positive and finite, or if 4096 arcs for one piece do not reach it.
///
/// # Examples
/// ```
/// use symspline::{Curve, SplineSpace, plot::curve_path};
/// use nalgebra::vector;
/// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 0.0], vector![3.0, 6.0]])?;
/// assert_eq!(curve_path(&line, 1e-3)?.to_svg(), "M0,0 L3,6");
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn curve_path(curve: &Curve<f64, 2>, tolerance: f64) -> Result<BezPath> {
    if !(tolerance.is_finite() && tolerance > 0.0) {
        return Err(Error::BadTolerance { tolerance: tolerance.to_string() });
    }
    let mut path = BezPath::new();
    let mut end: Option<Point> = None;
    for piece in curve.bezier_pieces()? {
        let start = point(&piece.coeffs()[0]);
        if end != Some(start) {
            path.move_to(start);
        }
        draw(&mut path, piece, tolerance, MAX_HALVINGS)?;
        end = path.elements().last().and_then(kurbo::PathEl::end_point);
    }
    Ok(path)
}

/// The graph `(x, f(x))` of a scalar spline as a path, no further than `tolerance` from it (in the unit of the values).
///
/// # Errors
/// As [`curve_path`].
pub fn graph_path(function: &Function<f64>, tolerance: f64) -> Result<BezPath> {
    let (a, b) = function.domain();
    let along = Spline::new(SplineSpace::bezier(1, *a, *b)?, vec![vector![*a, 0.0], vector![*b, 0.0]])?;
    let up =
        Spline::new(function.space().clone(), function.coeffs().iter().map(|y| vector![0.0, *y]).collect())?;
    curve_path(&along.sum(&up)?, tolerance)
}

/// Adds the arc of one polynomial piece, from the current point.
fn draw(path: &mut BezPath, piece: Curve<f64, 2>, tolerance: f64, halvings: usize) -> Result<()> {
    let cubic = match piece.degree() {
        0 | 1 => {
            path.line_to(point(&piece.coeffs()[piece.degree()]));
            return Ok(());
        }
        2 | 3 => piece.elevated(3 - piece.degree())?,
        _ => hermite(&piece)?,
    };
    let within = |difference: &Curve<f64, 2>| difference.coeffs().iter().all(|c| c.norm() <= tolerance);
    if piece.degree() > 3 && !within(&piece.difference(&cubic)?) {
        if halvings == 0 {
            return Err(Error::BadTolerance { tolerance: tolerance.to_string() });
        }
        let (a, b) = piece.domain();
        let (left, right) = piece.split(&(0.5 * (a + b)))?;
        draw(path, left, tolerance, halvings - 1)?;
        return draw(path, right, tolerance, halvings - 1);
    }
    let [_, c, d, e] = cubic.coeffs() else { unreachable!("a cubic piece has four coefficients") };
    path.curve_to(point(c), point(d), point(e));
    Ok(())
}

/// The cubic with the ends and end derivatives of a piece of higher degree.
fn hermite(piece: &Curve<f64, 2>) -> Result<Curve<f64, 2>> {
    let (c, p) = (piece.coeffs(), piece.degree());
    let third = p as f64 / 3.0;
    let inner = |end: &SVector<f64, 2>, next: &SVector<f64, 2>| end + third * (next - end);
    let coeffs = vec![c[0], inner(&c[0], &c[1]), inner(&c[p], &c[p - 1]), c[p]];
    Spline::new(SplineSpace::bezier(3, *piece.domain().0, *piece.domain().1)?, coeffs)
}

fn point(coeff: &SVector<f64, 2>) -> Point {
    Point::new(coeff[0], coeff[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{ParamCurve, PathSeg};

    #[test]
    fn cubics_are_exact_and_jumps_start_anew() {
        let space = SplineSpace::clamped(3, [0.0, 1.0, 1.0, 1.0, 1.0, 2.0]).unwrap();
        let points = (0..8).map(|i| vector![f64::from(i), f64::from(i * i % 5)]).collect();
        let path = curve_path(&Spline::new(space, points).unwrap(), 1e-3).unwrap();
        assert_eq!(path.to_svg(), "M0,0 C1,1 2,4 3,4 M4,1 C5,0 6,1 7,4");
    }

    #[test]
    fn higher_degrees_stay_within_the_tolerance() {
        let points = vec![[0.0, 0.0], [1.0, 5.0], [2.0, -4.0], [3.0, 9.0], [4.0, -3.0], [5.0, 0.0]];
        let points = points.into_iter().map(SVector::from).collect();
        let curve = Curve::new(SplineSpace::bezier(5, 0.0, 1.0).unwrap(), points).unwrap();
        let path = curve_path(&curve, 1e-4).unwrap();
        let arcs: Vec<PathSeg> = path.segments().collect();
        assert!(arcs.len() > 2);
        for (arc, k) in arcs.iter().flat_map(|arc| (0..=8).map(move |k| (arc, k))) {
            // The first coordinate is 5 times the parameter, on every arc.
            let drawn = arc.eval(f64::from(k) / 8.0);
            let distance = (point(&curve.at(&(drawn.x / 5.0).min(1.0)).unwrap()) - drawn).hypot();
            assert!(distance <= 1e-4, "{distance}");
        }
    }

    #[test]
    fn graphs_run_along_the_domain() {
        let square = Function::monomial(2, 0.0, 3.0).unwrap();
        assert_eq!(graph_path(&square, 1e-3).unwrap().to_svg(), "M0,0 C1,0 2,3 3,9");
    }

    #[test]
    fn tolerances_must_be_positive() {
        let line = Function::monomial(1, 0.0, 1.0).unwrap();
        for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(graph_path(&line, tolerance), Err(Error::BadTolerance { .. })));
        }
    }

    #[test]
    fn tolerances_out_of_reach_are_refused() {
        let points = vec![[0.0, 0.0], [1e9, 5e9], [2e9, -4e9], [3e9, 9e9], [4e9, -3e9], [5e9, 0.0]];
        let points = points.into_iter().map(SVector::from).collect();
        let curve = Curve::new(SplineSpace::bezier(5, 0.0, 1.0).unwrap(), points).unwrap();
        assert!(matches!(curve_path(&curve, 1e-9), Err(Error::BadTolerance { .. })));
    }
}
