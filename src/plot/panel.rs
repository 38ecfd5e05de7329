//! A panel: one pair of axes and what is drawn between them.

use kurbo::{BezPath, Point};

use crate::error::{Error, Result};
use crate::plot::axis::Range;
use crate::plot::gallery::Gallery;
use crate::plot::series::{Data, Series};
use crate::plot::solid::{ColorScale, Image};
use crate::plot::style::{Marker, Style};

/// One pair of axes with series, drawn in the order in which they were added.
///
/// Data are finite `f64` in data coordinates, y upwards. Ranges come from the data with a margin of some
/// pixels, so that every series and its markers lie inside. The outputs of
/// [`Figure`](crate::plot::Figure) check the numbers, not these methods.
///
/// # Examples
/// ```
/// # use symspline::plot::{Color, Panel, Style};
/// let panel = Panel::new()
///     .title("A parabola")
///     .x_label("x")
///     .polyline((0..=20).map(|i| f64::from(i) / 10.0).map(|x| (x, x * x)), Color::BLUE)
///     .label("x²")
///     .v_lines([1.0], Style::line(Color::GRAY).width(0.8).dashed())
///     .text((1.0, 1.0), "here the slope is 2", Color::BLACK);
/// # let _ = panel;
/// ```
#[derive(Clone, Debug, Default)]
#[must_use]
pub struct Panel {
    pub(super) title: String,
    pub(super) x_label: String,
    pub(super) y_label: String,
    pub(super) equal_axes: bool,
    pub(super) x_from_above: bool,
    pub(super) x_range: Option<Range>,
    pub(super) y_range: Option<Range>,
    pub(super) height: Option<f64>,
    pub(super) series: Vec<Series>,
    pub(super) gallery: Gallery,
}

impl Panel {
    /// An empty panel.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the title, at the left above the plot area.
    pub fn title(self, title: impl Into<String>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// Sets the label of the x axis. Panels that share the axis show one label, the lowest that is not empty.
    pub fn x_label(self, label: impl Into<String>) -> Self {
        Self { x_label: label.into(), ..self }
    }

    /// Sets the label of the y axis.
    pub fn y_label(self, label: impl Into<String>) -> Self {
        Self { y_label: label.into(), ..self }
    }

    /// Gives x and y the same scale, as curves in the plane need it.
    ///
    /// The drawing is centred, ranges grow beyond the data or beyond those set until the scales agree, and
    /// the height follows from the data, within limits, unless [`Panel::height`] sets it.
    pub fn equal_axes(self) -> Self {
        Self { equal_axes: true, ..self }
    }

    /// Takes the x axis from the panel above: one range for both, numbers and label only below the lower one.
    ///
    /// A run of such panels shares the axis of the panel above the run. The first panel of a figure has
    /// none above; there it means nothing.
    pub fn x_from_above(self) -> Self {
        Self { x_from_above: true, ..self }
    }

    /// Sets the range of x; what lies outside is cut off. Panels that share x show all ranges set for one
    /// of them.
    pub fn x_range(self, lo: f64, hi: f64) -> Self {
        Self { x_range: Some(Range { lo, hi }), ..self }
    }

    /// Sets the range of y; what lies outside is cut off.
    pub fn y_range(self, lo: f64, hi: f64) -> Self {
        Self { y_range: Some(Range { lo, hi }), ..self }
    }

    /// Sets the height of the plot area, without title and labels, in pixels. The default is 180.
    pub fn height(self, px: f64) -> Self {
        Self { height: Some(px), ..self }
    }

    /// Draws a path of lines and Bézier curves.
    pub fn path(self, path: BezPath, style: impl Into<Style>) -> Self {
        self.with(Data::Path(path), style)
    }

    /// Draws the line through points.
    pub fn polyline(
        self,
        points: impl IntoIterator<Item = impl Into<Point>>,
        style: impl Into<Style>,
    ) -> Self {
        self.with(Data::Chain(collect(points), None), style)
    }

    /// Draws the line through points with a marker on each, as for a control polygon. A fill of the style
    /// fills the markers.
    pub fn marked_polyline(
        self,
        points: impl IntoIterator<Item = impl Into<Point>>,
        marker: Marker,
        style: impl Into<Style>,
    ) -> Self {
        self.with(Data::Chain(collect(points), Some(marker)), style)
    }

    /// Draws a marker on each point, filled white if the style has no fill.
    pub fn markers(
        self,
        points: impl IntoIterator<Item = impl Into<Point>>,
        marker: Marker,
        style: impl Into<Style>,
    ) -> Self {
        self.with(Data::Markers(collect(points), marker), style)
    }

    /// Draws a line from the first to the second point of each pair.
    pub fn segments(
        self,
        pairs: impl IntoIterator<Item = (impl Into<Point>, impl Into<Point>)>,
        style: impl Into<Style>,
    ) -> Self {
        self.with(Data::Segments(collect_pairs(pairs)), style)
    }

    /// Draws a comb: a thin, pale tooth from each foot on the curve to its tip, and the line along the tips.
    pub fn comb(
        self,
        teeth: impl IntoIterator<Item = (impl Into<Point>, impl Into<Point>)>,
        style: impl Into<Style>,
    ) -> Self {
        self.with(Data::Comb(collect_pairs(teeth)), style)
    }

    /// Draws vertical lines over the whole height, as for knots.
    pub fn v_lines(self, values: impl IntoIterator<Item = f64>, style: impl Into<Style>) -> Self {
        self.with(Data::VLines(values.into_iter().collect()), style)
    }

    /// Draws horizontal lines over the whole width, as for a bound.
    pub fn h_lines(self, values: impl IntoIterator<Item = f64>, style: impl Into<Style>) -> Self {
        self.with(Data::HLines(values.into_iter().collect()), style)
    }

    /// Draws knots as marks on the x axis: a value that occurs `m` times gets `m` marks, one above the other.
    pub fn knots(self, values: impl IntoIterator<Item = f64>, style: impl Into<Style>) -> Self {
        self.with(Data::Knots(values.into_iter().collect()), style)
    }

    /// Writes a text beside a point, in the colour of the stroke and on the side where there is room.
    ///
    /// A text is left out if its point lies outside the ranges.
    pub fn text(self, at: impl Into<Point>, text: impl Into<String>, style: impl Into<Style>) -> Self {
        self.with(Data::Text(at.into(), text.into()), style)
    }

    /// Enters the series added last into the legend; before any series, nothing.
    ///
    /// The legend is a row above the plot area: it never covers a curve.
    pub fn label(mut self, label: impl Into<String>) -> Self {
        if let Some(series) = self.series.last_mut() {
            series.label = Some(label.into());
        }
        self
    }

    /// Shows a picture with a caption above it, right of those before. A panel of pictures has no axes and no series.
    ///
    /// Pictures fill the width, all equally high, or the height that is set.
    pub fn picture(mut self, caption: impl Into<String>, image: Image) -> Self {
        self.gallery.pictures.push((caption.into(), image));
        self
    }

    /// Shows which colours values have, at the right of the pictures. A pointed end says that values lie beyond it.
    pub fn color_bar(mut self, scale: &ColorScale, label: impl Into<String>) -> Self {
        self.gallery.bars.push((scale.clone(), label.into()));
        self
    }

    /// Refuses what cannot be drawn.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::Drawing`], as the outputs of a figure document them.
    pub(super) fn check(&self) -> Result<()> {
        self.series.iter().try_for_each(Series::check)?;
        if !self.gallery.is_empty() && !self.series.is_empty() {
            return Err(Error::Drawing { message: "a panel shows pictures or series, not both".into() });
        }
        for range in [self.x_range, self.y_range].into_iter().flatten() {
            if let Some(index) = [range.lo, range.hi].iter().position(|end| !end.is_finite()) {
                return Err(Error::NotFinite { what: "end of a range", index });
            }
            if range.is_flat() || !range.is_countable() {
                let message = format!(
                    "the range from {:?} to {:?} is empty, too narrow or too wide",
                    range.lo, range.hi
                );
                return Err(Error::Drawing { message });
            }
        }
        match self.height {
            Some(height) if !(40.0..=16384.0).contains(&height) => Err(Error::Drawing {
                message: format!("a panel cannot be {height:?} px high: 40 to 16384 can"),
            }),
            _ => Ok(()),
        }
    }

    /// The values of x its data ask for.
    pub(super) fn hull_x(&self) -> Option<Range> {
        Range::union(self.series.iter().filter_map(Series::hull_x))
    }

    /// The values of y its data ask for.
    pub(super) fn hull_y(&self) -> Option<Range> {
        Range::union(self.series.iter().filter_map(Series::hull_y))
    }

    fn with(mut self, data: Data, style: impl Into<Style>) -> Self {
        self.series.push(Series { data, style: style.into(), label: None });
        self
    }
}

fn collect(points: impl IntoIterator<Item = impl Into<Point>>) -> Vec<Point> {
    points.into_iter().map(Into::into).collect()
}

fn collect_pairs(
    pairs: impl IntoIterator<Item = (impl Into<Point>, impl Into<Point>)>,
) -> Vec<(Point, Point)> {
    pairs.into_iter().map(|(a, b)| (a.into(), b.into())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::style::Color;

    #[test]
    fn ranges_are_checked() {
        let refused = Panel::new().x_range(0.0, f64::NAN).check();
        assert_eq!(refused, Err(Error::NotFinite { what: "end of a range", index: 1 }));
        assert!(matches!(Panel::new().y_range(1.0, 0.0).check(), Err(Error::Drawing { .. })));
        assert!(matches!(Panel::new().height(f64::NAN).check(), Err(Error::Drawing { .. })));
        assert_eq!(Panel::new().x_range(-1.0, 1.0).check(), Ok(()));
    }

    #[test]
    fn styles_are_checked() {
        let faded = Style::line(Color::BLUE).opacity(1.5);
        let refused = Panel::new().polyline([(0.0, 0.0)], faded).check();
        assert!(matches!(refused, Err(Error::Drawing { .. })));
    }
}
