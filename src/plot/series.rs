//! What a panel shows: curves, points, combs, lines and texts in data coordinates.

use kurbo::{BezPath, PathEl, Point, Shape};

use crate::error::{Error, Result};
use crate::plot::axis::Range;
use crate::plot::style::{Marker, Style};

/// The data of a series.
#[derive(Clone, Debug)]
pub(super) enum Data {
    Path(BezPath),
    /// A polyline, with or without markers at its points.
    Chain(Vec<Point>, Option<Marker>),
    Markers(Vec<Point>, Marker),
    Segments(Vec<(Point, Point)>),
    /// Teeth from feet to tips, and the line along the tips.
    Comb(Vec<(Point, Point)>),
    VLines(Vec<f64>),
    HLines(Vec<f64>),
    /// Marks on the x axis, stacked where a value repeats.
    Knots(Vec<f64>),
    Text(Point, String),
}

/// Data with their looks.
#[derive(Clone, Debug)]
pub(super) struct Series {
    pub(super) data: Data,
    pub(super) style: Style,
    pub(super) label: Option<String>,
}

impl Series {
    /// The values of x that must be seen.
    pub(super) fn hull_x(&self) -> Option<Range> {
        match &self.data {
            Data::VLines(values) | Data::Knots(values) => Range::hull(values.iter().copied()),
            _ => Range::hull(self.extreme_points().into_iter().map(|point| point.x)),
        }
    }

    /// The values of y that must be seen.
    pub(super) fn hull_y(&self) -> Option<Range> {
        match &self.data {
            Data::HLines(values) => Range::hull(values.iter().copied()),
            _ => Range::hull(self.extreme_points().into_iter().map(|point| point.y)),
        }
    }

    /// Refuses numbers that cannot be drawn.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the place of the point, tooth or value in its series;
    /// [`Error::Drawing`] for a style with a negative length or an opacity outside `[0, 1]`.
    pub(super) fn check(&self) -> Result<()> {
        let ends = |teeth: &[(Point, Point)]| {
            teeth.iter().position(|(foot, tip)| !(foot.is_finite() && tip.is_finite()))
        };
        let wrong = |points: &[Point]| points.iter().position(|point| !point.is_finite());
        let (what, index) = match &self.data {
            Data::Path(path) => ("path point", wrong(&path_points(path))),
            Data::Chain(points, _) => ("polyline point", wrong(points)),
            Data::Markers(points, _) => ("marker", wrong(points)),
            Data::Segments(segments) => ("segment", ends(segments)),
            Data::Comb(teeth) => ("comb tooth", ends(teeth)),
            Data::VLines(values) | Data::HLines(values) => {
                ("line", values.iter().position(|value| !value.is_finite()))
            }
            Data::Knots(values) => ("knot", values.iter().position(|value| !value.is_finite())),
            Data::Text(at, _) => ("text position", wrong(&[*at])),
        };
        if let Some(index) = index {
            return Err(Error::NotFinite { what, index });
        }
        let Style { width, opacity, fill_opacity, marker_radius, .. } = self.style;
        let lengths = [width, marker_radius].into_iter().all(|length| (0.0..=1e4).contains(&length));
        let parts = [opacity, fill_opacity].into_iter().all(|part| (0.0..=1.0).contains(&part));
        if lengths && parts {
            return Ok(());
        }
        Err(Error::Drawing {
            message: "a style has a length outside [0, 10000] or an opacity outside [0, 1]".into(),
        })
    }

    /// Points whose hull is that of the drawing: of a path its extremes, not its control points.
    fn extreme_points(&self) -> Vec<Point> {
        match &self.data {
            Data::Path(path) => {
                let boxes = path.segments().map(|segment| segment.bounding_box());
                let corners = boxes.flat_map(|b| [Point::new(b.x0, b.y0), Point::new(b.x1, b.y1)]);
                corners.collect()
            }
            Data::Chain(points, _) | Data::Markers(points, _) => points.clone(),
            Data::Segments(pairs) | Data::Comb(pairs) => {
                pairs.iter().flat_map(|(foot, tip)| [*foot, *tip]).collect()
            }
            Data::VLines(_) | Data::HLines(_) | Data::Knots(_) => Vec::new(),
            Data::Text(at, _) => vec![*at],
        }
    }
}

/// The values without repetition, ascending, with the number of times each occurs.
pub(super) fn multiplicities(values: &[f64]) -> Vec<(f64, usize)> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.chunk_by(|a, b| a == b).map(|run| (run[0], run.len())).collect()
}

fn path_points(path: &BezPath) -> Vec<Point> {
    let points = |element: PathEl| match element {
        PathEl::MoveTo(a) | PathEl::LineTo(a) => vec![a],
        PathEl::QuadTo(a, b) => vec![a, b],
        PathEl::CurveTo(a, b, c) => vec![a, b, c],
        PathEl::ClosePath => Vec::new(),
    };
    path.iter().flat_map(points).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::style::Color;

    fn series(data: Data) -> Series {
        Series { data, style: Color::BLUE.into(), label: None }
    }

    #[test]
    fn hulls_are_those_of_the_curve() {
        let arch = BezPath::from_svg("M0 0C0 4 4 4 4 0").unwrap();
        let arch = series(Data::Path(arch));
        assert_eq!(arch.hull_y(), Some(Range { lo: 0.0, hi: 3.0 }));
        assert_eq!(series(Data::Knots(vec![2.0, -1.0])).hull_x(), Some(Range { lo: -1.0, hi: 2.0 }));
        assert_eq!(series(Data::Knots(vec![2.0])).hull_y(), None);
        assert_eq!(series(Data::Path(BezPath::new())).hull_x(), None);
    }

    #[test]
    fn the_place_of_nan_is_named() {
        let points = vec![Point::ZERO, Point::new(1.0, f64::NAN)];
        let refused = series(Data::Chain(points, None)).check();
        assert_eq!(refused, Err(Error::NotFinite { what: "polyline point", index: 1 }));
        let mut path = BezPath::new();
        path.move_to((0.0, 0.0));
        path.curve_to((1.0, 0.0), (f64::INFINITY, 0.0), (2.0, 0.0));
        let refused = series(Data::Path(path)).check();
        assert_eq!(refused, Err(Error::NotFinite { what: "path point", index: 2 }));
    }

    #[test]
    fn repeated_knots_are_counted() {
        assert_eq!(multiplicities(&[1.0, 0.0, 0.0, -0.0]), [(-0.0, 3), (1.0, 1)]);
    }
}
