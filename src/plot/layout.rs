//! Where everything on a figure goes, in pixels.
//!
//! All plot areas begin and end at the same x. The left margin holds the widest numbers and labels of any
//! panel; since ranges, and with them numbers, depend on the width that is left, the margins grow until
//! they suffice.

use kurbo::{Point, Rect};

use crate::error::{Error, Result};
use crate::plot::axis::{Range, Step, Tick};
use crate::plot::header::{Entry, Placed, header};
use crate::plot::panel::Panel;
use crate::plot::scale::{Scaled, scaled};
use crate::plot::text::{Block, SMALL, width};

/// The free border of the figure.
const OUTER: f64 = 14.0;
/// Between panels.
const GAP: f64 = 16.0;
/// The least width of a plot area.
const NARROWEST: f64 = 60.0;
/// The length of the marks outside the frame.
pub(super) const TICK: f64 = 4.0;
const LABEL: f64 = 12.5;
const HEADLINE: f64 = 17.0;

/// A plot area with all that stands around it.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    pub(super) area: Rect,
    pub(super) x: Range,
    pub(super) y: Range,
    pub(super) x_ticks: Vec<Tick>,
    pub(super) y_ticks: Vec<Tick>,
    /// Whether numbers stand under the x axis.
    pub(super) numbered: bool,
    pub(super) title: Placed,
    pub(super) legend: Vec<Entry>,
    /// Placed by the middle of its first baseline.
    pub(super) x_label: Placed,
    /// Placed by the middle of its first baseline, which runs upwards.
    pub(super) y_label: Placed,
}

impl Frame {
    /// The pixel of a point of the data.
    pub(super) fn place(&self, point: Point) -> Point {
        let (kx, ky) = (self.area.width() / self.x.span(), self.area.height() / self.y.span());
        Point::new(self.area.x0 + (point.x - self.x.lo) * kx, self.area.y1 - (point.y - self.y.lo) * ky)
    }
}

/// A figure with everything in its place.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub(super) width: f64,
    pub(super) height: f64,
    /// Placed by the middle of its first baseline.
    pub(super) title: Placed,
    pub(super) frames: Vec<Frame>,
}

/// Margins left and right of the plot areas.
#[derive(Clone, Copy)]
struct Margins {
    left: f64,
    right: f64,
}

/// Places panels below each other.
///
/// # Errors
/// [`Error::Drawing`] if the texts leave no room for the plots, or data and ranges do not fit each other.
pub(super) fn layout(title: &str, width: f64, panels: &[Panel]) -> Result<Layout> {
    let (margins, sized) = fitted(panels, width)?;
    let headline = Block::new(title, HEADLINE, width - 2.0 * OUTER);
    let mut cursor = OUTER + headline.height();
    let title = Placed { at: Point::new(width / 2.0, OUTER + 0.9 * headline.size), block: headline };
    cursor += if title.block.lines.is_empty() { 0.0 } else { 8.0 };
    let mut frames = Vec::new();
    for (i, (panel, sized)) in panels.iter().zip(sized).enumerate() {
        cursor += match i {
            0 => 0.0,
            _ if panel.x_from_above => GAP - 4.0,
            _ => GAP,
        };
        let frame = framed(panel, sized, cursor, margins, width);
        let last = !panels.get(i + 1).is_some_and(|next| next.x_from_above);
        cursor = frame.area.y1;
        if last {
            let label = &frame.x_label.block;
            cursor += if panel.gallery.is_empty() { TICK + 1.6 * SMALL } else { 0.0 };
            cursor += if label.lines.is_empty() { 0.0 } else { label.height() + 4.0 };
        }
        check_reach(panel, &frame)?;
        frames.push(frame);
    }
    Ok(Layout { width, height: (cursor + OUTER).ceil(), title, frames })
}

/// The margins and the panels between them; margins grow until they hold the labels.
fn fitted(panels: &[Panel], width: f64) -> Result<(Margins, Vec<Sized>)> {
    let mut margins = Margins { left: OUTER, right: OUTER };
    loop {
        let room = width - margins.left - margins.right;
        if room < NARROWEST {
            return Err(Error::Drawing { message: format!("a figure {width:?} px wide is too narrow") });
        }
        let sized = sized(panels, room)?;
        let need = needed(&sized);
        if need.left <= margins.left && need.right <= margins.right {
            return Ok((margins, sized));
        }
        let left = need.left.max(margins.left).ceil();
        margins = Margins { left, right: need.right.max(margins.right).ceil() };
    }
}

/// A panel with its ranges, ticks and labels, but no place yet.
struct Sized {
    plot: Scaled,
    x_ticks: Vec<Tick>,
    y_ticks: Vec<Tick>,
    numbered: bool,
    x_label: Block,
    y_label: Block,
}

impl Sized {
    /// Of a panel with pictures instead of axes.
    fn gallery(panel: &Panel, room: f64) -> Self {
        let height = panel.gallery.hung(room, panel.height).height;
        Self {
            plot: Scaled { x: Range::UNIT, y: Range::UNIT, height },
            x_ticks: Vec::new(),
            y_ticks: Vec::new(),
            numbered: false,
            x_label: Block::new(&panel.x_label, LABEL, room),
            y_label: Block::new("", LABEL, height),
        }
    }
}

fn sized(panels: &[Panel], room: f64) -> Result<Vec<Sized>> {
    let mut all = Vec::new();
    let shared =
        |one: &Panel, next: &Panel| next.x_from_above && one.gallery.is_empty() && next.gallery.is_empty();
    for group in panels.chunk_by(shared) {
        if let [panel] = group
            && !panel.gallery.is_empty()
        {
            all.push(Sized::gallery(panel, room));
            continue;
        }
        let label = group.iter().rev().map(|panel| panel.x_label.as_str()).find(|label| !label.is_empty());
        for (i, (panel, plot)) in group.iter().zip(scaled(group, room)?).enumerate() {
            let numbered = i + 1 == group.len();
            let x_label = label.filter(|_| numbered).unwrap_or_default();
            // The x step of a group is one for all its panels.
            let tied = panel.equal_axes && group.len() == 1;
            let (x_step, y_step) = steps(plot, room, tied);
            all.push(Sized {
                plot,
                x_ticks: x_step.ticks(plot.x),
                y_ticks: y_step.ticks(plot.y),
                numbered,
                x_label: Block::new(x_label, LABEL, room),
                y_label: Block::new(&panel.y_label, LABEL, plot.height),
            });
        }
    }
    Ok(all)
}

/// The steps of x and y, as small as their labels have room for: one step for both if they are `tied`.
fn steps(plot: Scaled, room: f64, tied: bool) -> (Step, Step) {
    let fits = |step: &Step| {
        let distance = step.length() * room / plot.x.span();
        widest(&step.ticks(plot.x)) + 14.0 <= distance
    };
    let most = ((room / 72.0) as usize).max(3);
    let mut all = (1..=most).rev().map(|intervals| Step::new(plot.x, intervals));
    let x = all.find(fits).unwrap_or_else(|| Step::new(plot.x, 1));
    let most = (plot.height / 36.0).max(5.0).min(plot.height / 14.0);
    let y = Step::new(plot.y, most as usize);
    if !tied {
        return (x, y);
    }
    let (fine, coarse) = if x.length() < y.length() { (x, y) } else { (y, x) };
    let readable = fits(&fine) && fine.length() * plot.height / plot.y.span() >= 2.0 * SMALL;
    if readable { (fine, fine) } else { (coarse, coarse) }
}

fn widest(marks: &[Tick]) -> f64 {
    marks.iter().map(|tick| width(&tick.label, SMALL)).fold(0.0, f64::max)
}

fn needed(all: &[Sized]) -> Margins {
    let left = |panel: &Sized| {
        let label = panel.y_label.height();
        OUTER + label + if label > 0.0 { 6.0 } else { 0.0 } + widest(&panel.y_ticks) + TICK + 4.0
    };
    let right = |panel: &Sized| if panel.numbered { 4.0 + widest(&panel.x_ticks) / 2.0 } else { 0.0 };
    Margins {
        left: all.iter().map(left).fold(OUTER, f64::max),
        right: all.iter().map(right).fold(OUTER, f64::max),
    }
}

/// Places a panel whose header begins at `top`.
fn framed(panel: &Panel, sized: Sized, top: f64, margins: Margins, width: f64) -> Frame {
    // Half a pixel off, frames of one pixel are sharp.
    let (left, right) = (margins.left + 0.5, width - margins.right + 0.5);
    let header = header(panel, left, right, top);
    let upper = (top + header.height).floor() + 0.5;
    let area = Rect::new(left, upper, right, upper + sized.plot.height);
    let numbers = if panel.gallery.is_empty() { TICK + 1.6 * SMALL } else { 0.0 };
    let below = area.y1 + numbers + 4.0 + 0.8 * sized.x_label.size;
    let (x_label, y_label) = (sized.x_label, sized.y_label);
    Frame {
        area,
        x: sized.plot.x,
        y: sized.plot.y,
        x_ticks: sized.x_ticks,
        y_ticks: sized.y_ticks,
        numbered: sized.numbered,
        title: header.title,
        legend: header.legend,
        x_label: Placed { at: Point::new(area.center().x, below), block: x_label },
        y_label: Placed { at: Point::new(OUTER + 0.8 * y_label.size, area.center().y), block: y_label },
    }
}

/// Refuses data so far outside the ranges set that no renderer could clip them.
fn check_reach(panel: &Panel, frame: &Frame) -> Result<()> {
    let (x, y) = (panel.hull_x().unwrap_or(frame.x), panel.hull_y().unwrap_or(frame.y));
    let ends = [frame.place(Point::new(x.lo, y.lo)), frame.place(Point::new(x.hi, y.hi))];
    if ends.iter().all(|end| end.x.abs() <= 1e7 && end.y.abs() <= 1e7) {
        return Ok(());
    }
    Err(Error::Drawing { message: "the data reach more than 10 000 000 px beyond the range".into() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::style::Color;

    fn arch() -> Panel {
        Panel::new().polyline([(0.0, 0.0), (1.0, 2.0), (3.0, 1.0)], Color::BLUE).label("an arch")
    }

    #[test]
    fn plot_areas_are_aligned_and_apart() {
        let wide_numbers = Panel::new().polyline([(0.0, 0.0), (1.0, 9e5)], Color::BLUE).y_label("long");
        let panels = [arch().title("A").x_label("x"), wide_numbers.x_from_above(), arch()];
        let frames = layout("Figure", 640.0, &panels).unwrap().frames;
        assert!(frames.iter().all(|f| f.area.x0 == frames[0].area.x0 && f.area.x1 == frames[0].area.x1));
        assert!(frames.windows(2).all(|pair| pair[0].area.y1 + 8.0 < pair[1].area.y0));
        assert_eq!(frames.iter().map(|f| f.numbered).collect::<Vec<_>>(), [false, true, true]);
        // The label of the group stands at its last panel.
        assert!(frames[0].x_label.block.lines.is_empty() && frames[1].x_label.block.lines == ["x"]);
    }

    #[test]
    fn all_labels_stay_on_the_sheet() {
        let long = "a label that is much longer than the side along which it is to be set ".repeat(3);
        let panel = arch().title(&long).x_label(&long).y_label(&long).label(&long).height(120.0);
        let sheet = layout(&long, 500.0, &[panel]).unwrap();
        let frame = &sheet.frames[0];
        let entry = &frame.legend[0].text;
        assert!(entry.at.x + entry.block.width <= 500.0);
        assert!(frame.x_label.at.y + frame.x_label.block.height() <= sheet.height);
        assert!(frame.y_label.block.width <= 120.0);
        assert!(frame.title.at.x + frame.title.block.width <= 500.0 && sheet.title.block.width <= 500.0);
    }

    #[test]
    fn narrow_figures_are_refused() {
        assert!(matches!(layout("", 80.0, &[arch()]), Err(Error::Drawing { .. })));
        let far = arch().x_range(0.0, 1e-9);
        assert!(matches!(layout("", 600.0, &[far]), Err(Error::Drawing { .. })));
    }
}
