//! Elliptical arcs of paths as conics.

use crate::error::Problem;
use crate::outline::{Point, Segment};
use kurbo::{Arc, SvgArc};
use nalgebra::vector;
use symspline::arc_by_angles;

/// The conics of an arc, one for each begun quarter; a line where it has no radius, nothing where it has no length.
///
/// # Errors
/// [`symspline::Error::NotFinite`], and others of the library where numbers overflow.
pub(super) fn conics(arc: &SvgArc) -> Result<Vec<Segment>, Problem> {
    if arc.from == arc.to {
        return Ok(Vec::new());
    }
    let end = vector![arc.to.x, arc.to.y];
    let Some(found) = Arc::from_svg_arc(arc) else { return Ok(vec![Segment::Line(end)]) };
    let unit = arc_by_angles(&Point::zeros(), &1.0, &found.start_angle, &found.sweep_angle)?;
    let (sin, cos) = found.x_rotation.sin_cos();
    let onto = |p: Point| {
        let (x, y) = (p[0] * found.radii.x, p[1] * found.radii.y);
        vector![found.center.x + x * cos - y * sin, found.center.y + x * sin + y * cos]
    };
    let coeffs = unit.lifted().coeffs();
    let piece = |pair: &[symspline::Weighted<f64, Point>]| {
        Segment::Conic([onto(pair[0].project()), onto(pair[1].project())], pair[0].weight)
    };
    let mut segments: Vec<Segment> = coeffs[1..].chunks_exact(2).map(piece).collect();
    // The arc ends where the path says, not at a rounded place.
    if let Some(Segment::Conic(points, _)) = segments.last_mut() {
        points[1] = end;
    }
    Ok(segments)
}
