//! The `d` of a path.

use super::arc::conics;
use crate::error::Problem;
use crate::outline::{Outline, Point, Segment};
use kurbo::SvgArc;
use nalgebra::vector;
use svgtypes::{PathParser, PathSegment};

/// The subpaths of a path.
///
/// # Errors
/// [`Problem::Syntax`], and those of arcs whose numbers overflow.
pub(super) fn outlines(d: &str) -> Result<Vec<Outline>, Problem> {
    let mut pen = Pen::default();
    for segment in PathParser::from(d) {
        pen.take(segment.map_err(|error| Problem::Syntax(format!("path data: {error}")))?)?;
    }
    pen.outlines.retain(|outline| !outline.segments.is_empty());
    Ok(pen.outlines)
}

/// What was drawn so far.
#[derive(Default)]
struct Pen {
    outlines: Vec<Outline>,
    /// Where the current subpath started, and where the pen is.
    start: Point,
    at: Point,
    is_closed: bool,
    /// The last control point of a quadratic or a cubic, if that came last.
    quadratic: Option<Point>,
    cubic: Option<Point>,
}

impl Pen {
    fn take(&mut self, segment: PathSegment) -> Result<(), Problem> {
        let (quadratic, cubic) = (self.quadratic.take(), self.cubic.take());
        let at = self.at;
        let place = |abs: bool, x: f64, y: f64| if abs { vector![x, y] } else { at + vector![x, y] };
        let mirrored = |control: Option<Point>| control.map_or(at, |control| at + (at - control));
        match segment {
            PathSegment::MoveTo { abs, x, y } => {
                self.at = place(abs, x, y);
                self.start = self.at;
                self.outlines.push(Outline::at(self.at));
                self.is_closed = false;
            }
            PathSegment::LineTo { abs, x, y } => self.put([Segment::Line(place(abs, x, y))]),
            PathSegment::HorizontalLineTo { abs, x } => {
                self.put([Segment::Line(vector![if abs { x } else { at[0] + x }, at[1]])]);
            }
            PathSegment::VerticalLineTo { abs, y } => {
                self.put([Segment::Line(vector![at[0], if abs { y } else { at[1] + y }])]);
            }
            PathSegment::CurveTo { abs, x1, y1, x2, y2, x, y } => {
                self.cubic([place(abs, x1, y1), place(abs, x2, y2), place(abs, x, y)]);
            }
            PathSegment::SmoothCurveTo { abs, x2, y2, x, y } => {
                self.cubic([mirrored(cubic), place(abs, x2, y2), place(abs, x, y)]);
            }
            PathSegment::Quadratic { abs, x1, y1, x, y } => {
                self.quadratic([place(abs, x1, y1), place(abs, x, y)]);
            }
            PathSegment::SmoothQuadratic { abs, x, y } => {
                self.quadratic([mirrored(quadratic), place(abs, x, y)]);
            }
            PathSegment::EllipticalArc { abs, rx, ry, x_axis_rotation, large_arc, sweep, x, y } => {
                let to = place(abs, x, y);
                let arc = SvgArc {
                    from: (at[0], at[1]).into(),
                    to: (to[0], to[1]).into(),
                    radii: (rx.abs(), ry.abs()).into(),
                    x_rotation: x_axis_rotation.to_radians(),
                    large_arc,
                    sweep,
                };
                self.put(conics(&arc)?);
            }
            PathSegment::ClosePath { .. } => {
                if let Some(outline) = self.outlines.last_mut().filter(|_| !self.is_closed) {
                    outline.close();
                }
                self.at = self.start;
                self.is_closed = true;
            }
        }
        Ok(())
    }

    fn quadratic(&mut self, points: [Point; 2]) {
        self.put([Segment::Quadratic(points)]);
        self.quadratic = Some(points[0]);
    }

    fn cubic(&mut self, points: [Point; 3]) {
        self.put([Segment::Cubic(points)]);
        self.cubic = Some(points[1]);
    }

    fn put(&mut self, segments: impl IntoIterator<Item = Segment>) {
        if self.is_closed || self.outlines.is_empty() {
            self.outlines.push(Outline::at(self.at));
            self.is_closed = false;
        }
        let outline = self.outlines.last_mut().expect("one was begun");
        outline.segments.extend(segments);
        self.at = outline.end();
    }
}
