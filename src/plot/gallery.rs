//! Pictures beside each other in a panel, with bars that say which colour stands for which value.
//!
//! All pictures of a row are equally high, and as wide as their pixels ask for. Bars stand at the right.

use kurbo::{Point, Rect};

use crate::error::Result;
use crate::plot::axis::{Range, Step, Tick};
use crate::plot::solid::{ColorScale, Image};
use crate::plot::style::{Color, Style};
use crate::plot::svg::{Anchor, Face, Svg, polyline};
use crate::plot::text::{Block, SMALL, width};

/// Between pictures, and before and between bars.
const GAP: f64 = 14.0;
const CAPTION: f64 = 12.0;
/// The width of a bar, and the height of the points at its ends where values lie beyond.
const BAR: f64 = 15.0;
const TIP: f64 = 11.0;
const TICK: f64 = 4.0;
/// A bar is no higher, in pixels and in heights of the row.
const TALLEST: f64 = 320.0;
const SHARE: f64 = 0.86;
/// The least size of pictures.
const LEAST: f64 = 20.0;
/// The height of a row of bars alone.
const HEIGHT: f64 = 180.0;
/// The least width of a bar with its numbers: rows below each other then have pictures of one size.
const LEAST_BAR: f64 = 88.0;
/// The stops of a gradient.
const STOPS: usize = 48;
const INK: Color = Color::new(38, 38, 38);
const FRAME: Style = Style::line(Color::new(120, 120, 120)).width(1.0);

/// What a panel of pictures shows.
#[derive(Clone, Debug, Default)]
pub(super) struct Gallery {
    pub(super) pictures: Vec<(String, Image)>,
    pub(super) bars: Vec<(ColorScale, String)>,
}

/// A gallery in its place, from the upper left corner of the panel's area.
#[derive(Debug)]
pub(super) struct Hung<'a> {
    pub(super) height: f64,
    pictures: Vec<(Rect, Block, &'a Image)>,
    bars: Vec<Bar<'a>>,
}

#[derive(Debug)]
struct Bar<'a> {
    /// With the points at its ends.
    area: Rect,
    scale: &'a ColorScale,
    ticks: Vec<Tick>,
    label: Block,
}

impl Gallery {
    pub(super) fn is_empty(&self) -> bool {
        self.pictures.is_empty() && self.bars.is_empty()
    }

    /// Places everything on `room` pixels of width, and at most the given height.
    pub(super) fn hung(&self, room: f64, height: Option<f64>) -> Hung<'_> {
        // Ticks depend on the height, that on the widths of labels, and these on ticks: once around is enough.
        let guess = self.height(room, 70.0 * self.bars.len() as f64, height.unwrap_or(f64::INFINITY));
        let labelled = |(scale, label): &'_ (ColorScale, String)| {
            let long = bar_height(guess);
            let ticks = ticks(scale, long);
            let label = Block::new(label, SMALL + 0.5, long);
            let widest = ticks.iter().map(|tick| width(&tick.label, SMALL)).fold(0.0, f64::max);
            let wide = (BAR + TICK + 4.0 + widest + 6.0 + label.height()).max(LEAST_BAR);
            (ticks, label, wide)
        };
        let labelled: Vec<_> = self.bars.iter().map(labelled).collect();
        let bars_width: f64 = labelled.iter().map(|(.., wide)| wide + GAP).sum();
        let width_of = |inner: f64| self.aspects().map(|aspect| aspect * inner).collect::<Vec<_>>();
        let loose = self.height(room, bars_width, f64::INFINITY);
        let blocks = |inner: f64| {
            let wide = width_of(inner);
            let captions = self.pictures.iter().zip(wide);
            captions.map(|((caption, _), wide)| Block::new(caption, CAPTION, wide)).collect::<Vec<_>>()
        };
        let highest = |blocks: &[Block]| blocks.iter().map(Block::height).fold(0.0, f64::max);
        let above = highest(&blocks(loose));
        let above = if above > 0.0 { above + 4.0 } else { 0.0 };
        let inner =
            self.height(room, bars_width, height.map_or(f64::INFINITY, |height| height - above)).max(LEAST);
        let (blocks, wide) = (blocks(inner), width_of(inner));
        let gaps = GAP * wide.len().saturating_sub(1) as f64;
        let mut x = ((room - wide.iter().sum::<f64>() - gaps - bars_width) / 2.0).max(0.0);
        let mut pictures = Vec::new();
        for ((block, wide), (_, image)) in blocks.into_iter().zip(wide).zip(&self.pictures) {
            pictures.push((Rect::new(x, above, x + wide, above + inner), block, image));
            x += wide + GAP;
        }
        let mut bars = Vec::new();
        let long = bar_height(inner);
        for ((scale, _), (ticks, label, wide)) in self.bars.iter().zip(labelled) {
            let top = above + (inner - long) / 2.0;
            bars.push(Bar { area: Rect::new(x, top, x + BAR, top + long), scale, ticks, label });
            x += wide + GAP;
        }
        Hung { height: above + inner, pictures, bars }
    }

    fn aspects(&self) -> impl Iterator<Item = f64> {
        self.pictures.iter().map(|(_, image)| image.width() as f64 / image.height() as f64)
    }

    /// The height of the pictures beside bars of the given width.
    fn height(&self, room: f64, bars: f64, highest: f64) -> f64 {
        if self.pictures.is_empty() {
            return HEIGHT.min(highest);
        }
        let free = room - bars - GAP * (self.pictures.len() - 1) as f64;
        (free / self.aspects().sum::<f64>()).min(highest).max(LEAST)
    }
}

impl Hung<'_> {
    /// Draws everything, from a corner on.
    pub(super) fn draw(&self, svg: &mut Svg, corner: Point, id: &str) -> Result<()> {
        let by = corner.to_vec2();
        for (area, caption, image) in &self.pictures {
            svg.image(*area + by, &image.address()?);
            let face =
                Face { size: caption.size, color: INK, anchor: Anchor::Middle, upright: false, rim: false };
            for (i, line) in caption.lines.iter().enumerate() {
                let at = Point::new(area.center().x, 0.8 * caption.size + i as f64 * caption.leading());
                svg.line_of_text(at + by, line, &face);
            }
        }
        for (i, bar) in self.bars.iter().enumerate() {
            bar.draw(svg, corner, &format!("{id}-{i}"));
        }
        Ok(())
    }
}

impl Bar<'_> {
    /// The bar without the points at its ends.
    fn body(&self) -> Rect {
        let (below, above) = self.scale.clips();
        let end = |clips: bool| if clips { TIP } else { 0.0 };
        Rect::new(self.area.x0, self.area.y0 + end(above), self.area.x1, self.area.y1 - end(below))
    }

    fn draw(&self, svg: &mut Svg, corner: Point, id: &str) {
        let by = corner.to_vec2();
        let (area, body) = (self.area + by, self.body() + by);
        let colors: Vec<Color> =
            (0..=STOPS).map(|i| self.scale.map().at(1.0 - i as f64 / STOPS as f64)).collect();
        let tip = |base: f64, top: f64| {
            let points = [(area.x0, base), (area.center().x, top), (area.x1, base)];
            polyline(points.map(Point::from)) + "Z"
        };
        // A tip where values lie beyond the limits, in the colour they have; its base lies under the bar.
        if body.y0 > area.y0 {
            svg.path(&tip(body.y0 + 1.0, area.y0), &Style::area(colors[0]));
        }
        if body.y1 < area.y1 {
            svg.path(&tip(body.y1 - 1.0, area.y1), &Style::area(colors[STOPS]));
        }
        svg.gradient(id, body, &colors);
        let middle = area.center().x;
        let outline = [
            (area.x0, body.y0),
            (middle, area.y0),
            (area.x1, body.y0),
            (area.x1, body.y1),
            (middle, area.y1),
            (area.x0, body.y1),
        ];
        // Without a tip its point lies on the side of the bar.
        svg.path(&(polyline(outline.map(Point::from)) + "Z"), &FRAME);
        let (low, high) = self.scale.limits();
        let face = Face { size: SMALL, color: INK, anchor: Anchor::Start, upright: false, rim: false };
        let mut widest: f64 = 0.0;
        for tick in &self.ticks {
            let y = body.y1 - (tick.value - low) / (high - low) * body.height();
            svg.path(&polyline([Point::new(area.x1, y), Point::new(area.x1 + TICK, y)]), &FRAME);
            svg.line_of_text(Point::new(area.x1 + TICK + 4.0, y + 0.36 * SMALL), &tick.label, &face);
            widest = widest.max(width(&tick.label, SMALL));
        }
        let x = area.x1 + TICK + 4.0 + widest + 6.0 + 0.8 * self.label.size;
        let face = Face { size: self.label.size, anchor: Anchor::Middle, upright: true, ..face };
        for (i, line) in self.label.lines.iter().enumerate() {
            let at = Point::new(x + i as f64 * self.label.leading(), area.center().y);
            svg.line_of_text(at, line, &face);
        }
    }
}

fn bar_height(row: f64) -> f64 {
    (SHARE * row).min(TALLEST)
}

/// The ticks of a bar so many pixels high.
fn ticks(scale: &ColorScale, long: f64) -> Vec<Tick> {
    let (lo, hi) = scale.limits();
    let range = Range { lo, hi };
    let intervals = (long / 32.0).clamp(2.0, 10.0) as usize;
    Step::new(range, intervals).ticks(range)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::solid::ColorMap;

    fn image(width: usize, height: usize) -> Image {
        Image::new(width, vec![Color::SKY; width * height]).unwrap()
    }

    fn scale(low: f64, high: f64) -> ColorScale {
        ColorScale::new(ColorMap::diverging(), low, high).unwrap()
    }

    #[test]
    fn pictures_are_equally_high_and_fill_the_row() {
        let pictures = vec![("wide".into(), image(40, 20)), ("high".into(), image(10, 20))];
        let gallery = Gallery { pictures, bars: vec![(scale(-1.0, 1.0), "label".into())] };
        let hung = gallery.hung(600.0, None);
        let [wide, high] = [0, 1].map(|i| hung.pictures[i].0);
        assert!(
            (wide.height() - high.height()).abs() < 1e-9 && (wide.width() - 4.0 * high.width()).abs() < 1e-9
        );
        assert!(wide.x0 >= 0.0 && wide.x1 + GAP <= high.x0 + 1e-9 && high.x1 < hung.bars[0].area.x0);
        assert!(hung.bars[0].area.x1 < 580.0 && hung.bars[0].area.y1 <= hung.height);
        let low = gallery.hung(600.0, Some(100.0));
        assert!((low.height - 100.0).abs() < 1e-9);
    }

    #[test]
    fn ticks_lie_on_the_bar() {
        for (low, high) in [(-1.0, 1.0), (0.0, 3e-7), (-2e5, 1e6)] {
            for long in [30.0, 200.0, 320.0] {
                let ticks = ticks(&scale(low, high), long);
                assert!((2..=11).contains(&ticks.len()), "{low} {high} {long}");
                assert!(ticks.iter().all(|tick| low <= tick.value && tick.value <= high));
            }
        }
        let labels: Vec<String> =
            ticks(&scale(-1.0, 1.0), 130.0).into_iter().map(|tick| tick.label).collect();
        assert_eq!(labels, ["−1.0", "−0.5", "0", "0.5", "1.0"]);
    }
}
