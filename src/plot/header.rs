//! What stands above a plot area: the title at the left, the legend at the right, never over a curve.

use kurbo::Point;

use crate::plot::panel::Panel;
use crate::plot::series::{Data, Series};
use crate::plot::text::{Block, SMALL};

const TITLE: f64 = 13.5;
/// The height of a row of the legend.
const ROW: f64 = 18.0;
const ENTRY_GAP: f64 = 18.0;
const SWATCH_GAP: f64 = 6.0;

/// A text at its place: `at` is the left end of the first baseline, or its middle.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub(super) block: Block,
    pub(super) at: Point,
}

/// An entry of a legend.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) series: usize,
    /// The left end of the sample, on its middle line.
    pub(super) swatch: Point,
    pub(super) swatch_width: f64,
    pub(super) text: Placed,
}

/// The header of a plot area.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub(super) title: Placed,
    pub(super) legend: Vec<Entry>,
    /// The height, with the distance from the plot area; none if there is nothing to say.
    pub(super) height: f64,
}

/// Places title and legend beside each other if they fit, else below each other.
pub(super) fn header(panel: &Panel, left: f64, right: f64, top: f64) -> Header {
    let room = right - left;
    let title = Block::new(&panel.title, TITLE, room);
    let rows = rows(panel, room);
    let title_width = if title.lines.is_empty() { 0.0 } else { title.width + ENTRY_GAP };
    let beside = title.lines.len() <= 1
        && rows.len() <= 1
        && rows.iter().all(|row| title_width + row_width(row) <= room);
    let legend_top = if beside { top } else { top + title.height() };
    let legend_height = rows.len() as f64 * ROW;
    let height = if beside { legend_height.max(title.height()) } else { legend_height + title.height() };
    let mut legend = Vec::new();
    for (i, row) in rows.into_iter().enumerate() {
        let middle = legend_top + (i as f64 + 0.5) * ROW;
        let mut x = right - row_width(&row);
        for item in row {
            let next = x + item.width() + ENTRY_GAP;
            legend.push(item.placed(x, middle));
            x = next;
        }
    }
    let baseline = top + 0.5 * ROW + 0.36 * title.size;
    let height = if height > 0.0 { height + 5.0 } else { 0.0 };
    Header { title: Placed { block: title, at: Point::new(left, baseline) }, legend, height }
}

/// An entry without a place.
struct Item {
    series: usize,
    swatch_width: f64,
    text: Block,
}

impl Item {
    fn new(i: usize, series: &Series, room: f64) -> Option<Self> {
        let swatch_width = match series.data {
            Data::Markers(..) | Data::VLines(_) | Data::Knots(_) => 10.0,
            Data::Text(..) => 0.0,
            _ => 26.0,
        };
        let text = Block::line(series.label.as_ref()?, SMALL, room - swatch_width - SWATCH_GAP);
        Some(Self { series: i, swatch_width, text })
    }

    fn width(&self) -> f64 {
        self.swatch_width + SWATCH_GAP + self.text.width
    }

    fn placed(self, x: f64, middle: f64) -> Entry {
        let at = Point::new(x + self.swatch_width + SWATCH_GAP, middle + 0.36 * self.text.size);
        let (swatch, swatch_width) = (Point::new(x, middle), self.swatch_width);
        Entry { series: self.series, swatch, swatch_width, text: Placed { block: self.text, at } }
    }
}

/// The entries of a legend in as many rows as they need.
fn rows(panel: &Panel, room: f64) -> Vec<Vec<Item>> {
    let mut rows: Vec<Vec<Item>> = Vec::new();
    let items = panel.series.iter().enumerate().filter_map(|(i, series)| Item::new(i, series, room));
    for item in items {
        let has_room = |row: &&mut Vec<Item>| row_width(row) + ENTRY_GAP + item.width() <= room;
        match rows.last_mut().filter(has_room) {
            Some(row) => row.push(item),
            None => rows.push(vec![item]),
        }
    }
    rows
}

fn row_width(row: &[Item]) -> f64 {
    row.iter().map(|item| item.width() + ENTRY_GAP).sum::<f64>() - ENTRY_GAP
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::style::Color;

    fn arch() -> Panel {
        Panel::new().polyline([(0.0, 0.0), (1.0, 2.0), (3.0, 1.0)], Color::BLUE).label("an arch")
    }

    #[test]
    fn a_legend_stands_beside_a_short_title() {
        let short = header(&arch().title("Short"), 50.0, 600.0, 20.0);
        assert!((short.legend[0].text.at.y - short.title.at.y).abs() < 3.0);
        let text = &short.legend[0].text;
        assert!((text.at.x + text.block.width - 600.0).abs() < 1e-9);
    }

    #[test]
    fn a_legend_stands_below_a_long_title() {
        let title = "A title so long that no legend has any room beside it, whatever its words may be";
        let long = header(&arch().title(title), 50.0, 600.0, 20.0);
        assert!(long.legend[0].text.at.y > long.title.at.y + 10.0);
        assert!(long.legend[0].text.at.y < 20.0 + long.height);
    }

    #[test]
    fn a_long_legend_breaks_into_rows() {
        let panel = (0..12).fold(Panel::new(), |panel, i| {
            panel.markers([(0.0, 0.0)], crate::plot::Marker::Circle, Color::nth(i)).label("one of a dozen")
        });
        let wide = header(&panel, 50.0, 600.0, 20.0);
        assert_eq!(wide.legend.len(), 12);
        assert!(wide.legend.iter().all(|entry| entry.swatch.x >= 50.0));
        assert!(wide.legend[11].swatch.y > wide.legend[0].swatch.y);
    }

    #[test]
    fn nothing_takes_no_room() {
        assert_eq!(header(&Panel::new(), 50.0, 600.0, 20.0).height, 0.0);
    }
}
