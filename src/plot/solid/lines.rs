//! Lines on surfaces: along knots, and between control points.

use crate::error::Result;
use crate::plot::solid::Point3;
use crate::plot::solid::mesh::check_count;
use crate::plot::solid::sample::Meshed;
use crate::tensor::spline::Surface;

/// The lines of a surface along its knots and borders, each with `steps` pieces.
///
/// # Errors
/// [`Error::TooLarge`](crate::Error::TooLarge).
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::plot::knot_lines;
/// use symspline::{SplineSpace, Surface};
/// let (u, v) = (SplineSpace::clamped(1, [0.0, 1.0, 2.0])?, SplineSpace::bezier(1, 0.0, 1.0)?);
/// let points = (0..6).map(|i| vector![f64::from(i / 2), f64::from(i % 2), 0.0]).collect();
/// assert_eq!(knot_lines(&Surface::new(u, v, points)?, 10)?.len(), 5);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn knot_lines<S: Meshed>(surface: &S, steps: usize) -> Result<Vec<Vec<Point3>>> {
    let spaces = surface.spaces();
    let knots = spaces.map(|space| space.breaks().into_iter().map(|(knot, _)| knot).collect::<Vec<_>>());
    let count = (knots[0].len() + knots[1].len()).saturating_mul(steps.saturating_add(1));
    check_count(count)?;
    let steps = steps.max(1);
    let places = spaces.map(|space| {
        let (a, b) = space.domain();
        let inside = (1..steps).map(|i| a + (b - a) * (i as f64 / steps as f64));
        [*a].into_iter().chain(inside).chain([*b]).collect::<Vec<f64>>()
    });
    let at = |u: f64, v: f64| surface.tangents(u, v).map(|[point, ..]| point);
    let along_v = knots[0].iter().map(|u| places[1].iter().map(|v| at(*u, *v)).collect());
    let along_u = knots[1].iter().map(|v| places[0].iter().map(|u| at(*u, *v)).collect());
    along_v.chain(along_u).collect()
}

/// The control net of a surface: the rows of its control points, then the columns.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::plot::control_net;
/// use symspline::{SplineSpace, Surface};
/// let (u, v) = (SplineSpace::bezier(2, 0.0, 1.0)?, SplineSpace::bezier(1, 0.0, 1.0)?);
/// let points = (0..6).map(|i| vector![f64::from(i / 2), f64::from(i % 2), 0.0]).collect();
/// assert_eq!(control_net(&Surface::new(u, v, points)?).len(), 3 + 2);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn control_net(surface: &Surface<f64, 3>) -> Vec<Vec<Point3>> {
    let columns = surface.transposed();
    surface.rows().chain(columns.rows()).map(<[Point3]>::to_vec).collect()
}
