//! From data to pixels: the ranges and sizes of panels that share an x axis.
//!
//! Panels of one group have one width `W` and one x range. A panel with equal axes needs a scale of
//!
//! ```text
//! k <= W / Δx,   k <= (H - 2 pad) / Δy   pixels per unit;
//! ```
//!
//! the smallest bound over the group is the scale of all, and ranges grow about their centres to fill `W` and
//! `H` with it.

use crate::error::{Error, Result};
use crate::plot::axis::Range;
use crate::plot::panel::Panel;
use crate::plot::series::{Data, multiplicities};

/// Free pixels between the data and the frame.
const PAD: f64 = 14.0;
/// The same above and below data with texts, which stand above their points.
const TEXT_PAD: f64 = 22.0;
/// The height of a plot area if nothing is said, and the least one at equal axes.
const HEIGHT: f64 = 180.0;
/// How high a plot area of equal axes becomes by itself, in widths.
const TALLEST: f64 = 0.75;

/// The height of a mark for a knot, and the distance of stacked marks.
pub(super) const KNOT: f64 = 6.0;
/// The free pixels between stacked marks.
pub(super) const KNOT_GAP: f64 = 2.5;

/// A plot area before it has its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scaled {
    pub(super) x: Range,
    pub(super) y: Range,
    pub(super) height: f64,
}

/// The ranges and heights of panels that share x, on plot areas of the given width.
///
/// # Errors
/// [`Error::Drawing`] if the data are too far apart or too near to each other for ticks in `f64`.
pub(super) fn scaled(group: &[Panel], width: f64) -> Result<Vec<Scaled>> {
    let equal = group.iter().any(|panel| panel.equal_axes);
    let x = match Range::union(group.iter().filter_map(|panel| panel.x_range)) {
        Some(set) => set,
        None => {
            let hull = Range::union(group.iter().filter_map(Panel::hull_x)).unwrap_or(Range::UNIT);
            let hull = if equal { hull } else { hull.widened() };
            hull.padded(PAD, PAD, width)
        }
    };
    let mut plots: Vec<Scaled> = group.iter().map(|panel| plot(panel, x, width)).collect();
    if equal {
        equalize(group, &mut plots, width);
    }
    if plots.iter().all(|plot| plot.x.is_countable() && plot.y.is_countable()) {
        return Ok(plots);
    }
    Err(Error::Drawing { message: "the data are too far apart or too near to each other for f64".into() })
}

/// A panel on its own, at equal axes with the y range of the bare data.
fn plot(panel: &Panel, x: Range, width: f64) -> Scaled {
    let hull = panel.hull_y().unwrap_or(Range::UNIT);
    if panel.equal_axes {
        let y = panel.y_range.unwrap_or(hull);
        // A maximum is never NaN: one point gets the least height.
        let fitted =
            (y.span() * width / x.span() + 2.0 * pad(panel)).max(HEIGHT).min((TALLEST * width).max(HEIGHT));
        return Scaled { x, y, height: panel.height.unwrap_or(fitted.round()) };
    }
    let height = panel.height.unwrap_or(HEIGHT);
    let above = pad(panel).min(height / 3.0);
    let below = PAD.max(knot_height(panel) + 4.0).min(height / 2.0);
    let y = panel.y_range.unwrap_or_else(|| hull.widened().padded(below, above, height));
    Scaled { x, y, height }
}

/// Makes the scales of x and y equal where they must be.
fn equalize(group: &[Panel], plots: &mut [Scaled], width: f64) {
    let bound = |(panel, plot): (&Panel, &Scaled)| {
        let free = if panel.y_range.is_some() {
            plot.height
        } else {
            plot.height - 2.0 * pad(panel).min(plot.height / 3.0)
        };
        if panel.equal_axes && !plot.y.is_flat() { free / plot.y.span() } else { f64::INFINITY }
    };
    let Some(x) = plots.first().map(|plot| plot.x) else { return };
    let along = if x.is_flat() { f64::INFINITY } else { width / x.span() };
    let scale = group.iter().zip(&*plots).map(bound).fold(along, f64::min);
    let scale = if scale.is_finite() { scale } else { width / x.widened().span() };
    for (panel, plot) in group.iter().zip(plots) {
        plot.x = x.about_centre(width / scale);
        if panel.equal_axes {
            plot.y = plot.y.about_centre(plot.height / scale);
        }
    }
}

/// The free pixels above and below the data of a panel with equal axes, and above those of any other.
fn pad(panel: &Panel) -> f64 {
    let texts = panel.series.iter().any(|series| matches!(series.data, Data::Text(..)));
    if texts { TEXT_PAD } else { PAD }
}

/// How high the knots of a panel are stacked.
fn knot_height(panel: &Panel) -> f64 {
    let highest = |data: &Data| match data {
        Data::Knots(values) => multiplicities(values).iter().map(|(_, m)| *m).max().unwrap_or(0),
        _ => 0,
    };
    let stacked = panel.series.iter().map(|series| highest(&series.data)).max().unwrap_or(0);
    stacked as f64 * (KNOT + KNOT_GAP)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::style::Color;

    fn square(side: f64) -> Panel {
        Panel::new().equal_axes().polyline([(0.0, 0.0), (side, 0.0), (side, side)], Color::BLUE)
    }

    #[test]
    fn equal_axes_have_one_scale() {
        let tall = Panel::new().equal_axes().polyline([(0.0, 0.0), (1.0, 40.0)], Color::BLUE);
        let wide = Panel::new().equal_axes().polyline([(0.0, 0.0), (40.0, 1.0)], Color::BLUE);
        let dot = Panel::new().equal_axes().polyline([(3.0, 5.0)], Color::BLUE);
        let line = Panel::new().equal_axes().polyline([(0.0, 7.0), (3.0, 7.0)], Color::BLUE);
        let pole = Panel::new().equal_axes().polyline([(3.0, 7.0), (3.0, 8.0)], Color::BLUE);
        let set = square(2.0).x_range(-1.0, 9.0).y_range(0.0, 1.0).height(300.0);
        let low = square(1.0).height(40.0).text((0.5, 0.5), "text", Color::BLACK);
        for panel in [tall, wide, dot, line, pole, low, set, Panel::new().equal_axes()] {
            let plot = scaled(std::slice::from_ref(&panel), 600.0).unwrap()[0];
            let (kx, ky) = (600.0 / plot.x.span(), plot.height / plot.y.span());
            assert!((kx - ky).abs() <= 1e-12 * kx, "{kx} and {ky}: {plot:?}");
            let centre = |range: Range| range.lo + range.hi;
            let (Some(x), Some(y)) = (panel.hull_x(), panel.hull_y()) else { continue };
            if panel.x_range.is_none() {
                assert!(plot.x.lo < x.lo && x.hi < plot.x.hi && plot.y.lo < y.lo && y.hi < plot.y.hi);
                assert!(
                    (centre(plot.x) - centre(x)).abs() < 1e-9 && (centre(plot.y) - centre(y)).abs() < 1e-9
                );
            }
        }
    }

    #[test]
    fn shared_panels_have_one_range() {
        let group = [
            Panel::new().polyline([(0.0, 0.0), (1.0, 1.0)], Color::BLUE),
            Panel::new().polyline([(0.5, 0.0), (3.0, 9.0)], Color::BLUE).x_from_above(),
        ];
        let plots = scaled(&group, 500.0).unwrap();
        assert_eq!(plots[0].x, plots[1].x);
        assert!(plots[0].x.lo < 0.0 && plots[0].x.hi > 3.0);
    }

    #[test]
    fn set_ranges_are_kept() {
        let panel = Panel::new().polyline([(0.0, 0.0), (1.0, 1.0)], Color::BLUE).x_range(0.2, 0.4);
        let plots = scaled(&[panel.y_range(-2.0, 2.0)], 500.0).unwrap();
        assert_eq!((plots[0].x, plots[0].y), (Range { lo: 0.2, hi: 0.4 }, Range { lo: -2.0, hi: 2.0 }));
    }

    #[test]
    fn measureless_data_are_refused() {
        let panel = Panel::new().polyline([(-1e308, 0.0), (1e308, 1.0)], Color::BLUE);
        assert!(matches!(scaled(&[panel], 500.0), Err(Error::Drawing { .. })));
    }
}
