//! The writer of SVG text.
//!
//! Coordinates are `f64` pixels with four decimals: far below what a screen or a printer resolves, at any
//! scale in use. Curves stay the Bézier paths they were.

use std::fmt::Write;

use kurbo::{BezPath, PathEl, Point, Rect};

use crate::plot::style::{Color, Style};

/// The font family as figures name it.
pub(super) const FAMILY: &str = "DejaVu Sans, sans-serif";

/// Where a text sits relative to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a line of text looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    pub(super) size: f64,
    pub(super) color: Color,
    pub(super) anchor: Anchor,
    /// Reads upwards.
    pub(super) upright: bool,
    /// Has a white rim, to be read on top of lines.
    pub(super) rim: bool,
}

/// An SVG document as it grows.
#[derive(Debug)]
pub(super) struct Svg {
    text: String,
}

impl Svg {
    /// A white sheet of the given size.
    pub(super) fn new(width: f64, height: f64) -> Self {
        let (w, h) = (number(width), number(height));
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" \
             font-family=\"{FAMILY}\">\n<rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n"
        );
        Self { text }
    }

    /// Draws path data.
    pub(super) fn path(&mut self, data: &str, style: &Style) {
        if data.is_empty() {
            return;
        }
        let mut marks = match style.fill {
            Some(color) if style.fill_opacity < 1.0 => {
                format!(" fill=\"{}\" fill-opacity=\"{}\"", color.hex(), number(style.fill_opacity))
            }
            Some(color) => format!(" fill=\"{}\"", color.hex()),
            None => " fill=\"none\"".into(),
        };
        if let Some(color) = style.stroke.filter(|_| style.width > 0.0) {
            marks += &format!(" stroke=\"{}\" stroke-width=\"{}\"", color.hex(), number(style.width));
            marks += " stroke-linejoin=\"round\"";
            let dashes: Vec<String> =
                style.dash.pattern().iter().map(|length| number(length * style.width.max(1.0))).collect();
            if !dashes.is_empty() {
                marks += &format!(" stroke-dasharray=\"{}\"", dashes.join(" "));
            }
        }
        if style.opacity < 1.0 {
            marks += &format!(" opacity=\"{}\"", number(style.opacity));
        }
        self.push(&format!("<path d=\"{data}\"{marks}/>"));
    }

    /// Writes one line of text; `at` is on its baseline.
    pub(super) fn line_of_text(&mut self, at: Point, text: &str, face: &Face) {
        let (x, y) = (number(at.x), number(at.y));
        let mut marks = match face.anchor {
            Anchor::Start => String::new(),
            Anchor::Middle => " text-anchor=\"middle\"".into(),
            Anchor::End => " text-anchor=\"end\"".into(),
        };
        if face.upright {
            marks += &format!(" transform=\"rotate(-90 {x} {y})\"");
        }
        if face.rim {
            marks +=
                " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
        }
        let (size, color) = (number(face.size), face.color.hex());
        let text = escaped(text);
        self.push(&format!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{color}\"{marks}>{text}</text>"
        ));
    }

    /// Shows a picture by its address.
    pub(super) fn image(&mut self, area: Rect, address: &str) {
        let [x, y, w, h] = [area.x0, area.y0, area.width(), area.height()].map(number);
        self.push(&format!(
            "<image x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" preserveAspectRatio=\"none\" href=\"{address}\"/>"
        ));
    }

    /// Fills a rectangle with colours from top to bottom.
    pub(super) fn gradient(&mut self, id: &str, area: Rect, colors: &[Color]) {
        let last = colors.len().saturating_sub(1).max(1) as f64;
        let stop = |(i, color): (usize, &Color)| {
            format!("<stop offset=\"{}\" stop-color=\"{}\"/>", number(i as f64 / last), color.hex())
        };
        let stops: String = colors.iter().enumerate().map(stop).collect();
        self.push(&format!(
            "<linearGradient id=\"{id}\" x1=\"0\" y1=\"0\" x2=\"0\" y2=\"1\">{stops}</linearGradient>"
        ));
        let [x, y, w, h] = [area.x0, area.y0, area.width(), area.height()].map(number);
        self.push(&format!("<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" fill=\"url(#{id})\"/>"));
    }

    /// Opens a group clipped to a rectangle, to be closed by [`Svg::close`].
    pub(super) fn open_clipped(&mut self, id: &str, area: Rect) {
        let [x, y, w, h] = [area.x0, area.y0, area.width(), area.height()].map(number);
        self.push(&format!(
            "<clipPath id=\"{id}\"><rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"/></clipPath>"
        ));
        self.push(&format!("<g clip-path=\"url(#{id})\">"));
    }

    /// Closes the group.
    pub(super) fn close(&mut self) {
        self.push("</g>");
    }

    /// The finished document.
    pub(super) fn finish(self) -> String {
        self.text + "</svg>\n"
    }

    fn push(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }
}

/// Path data of a path whose points are first moved by `place`.
pub(super) fn outline(path: &BezPath, place: impl Fn(Point) -> Point) -> String {
    let mut data = String::new();
    for element in path {
        let (letter, points) = match element {
            PathEl::MoveTo(a) => ('M', vec![a]),
            PathEl::LineTo(a) => ('L', vec![a]),
            PathEl::QuadTo(a, b) => ('Q', vec![a, b]),
            PathEl::CurveTo(a, b, c) => ('C', vec![a, b, c]),
            PathEl::ClosePath => ('Z', vec![]),
        };
        data.push(letter);
        let pairs: Vec<String> = points.into_iter().map(|point| pair(place(point))).collect();
        data += &pairs.join(" ");
    }
    data
}

/// Path data of a polyline.
pub(super) fn polyline(points: impl IntoIterator<Item = Point>) -> String {
    let mut data = String::new();
    for (i, point) in points.into_iter().enumerate() {
        let letter = if i == 0 { 'M' } else { 'L' };
        write!(data, "{letter}{}", pair(point)).expect("a String takes all text");
    }
    data
}

/// A point in path data.
fn pair(point: Point) -> String {
    format!("{},{}", number(point.x), number(point.y))
}

/// A number with at most four decimals.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// A text as XML content: its special characters escaped, characters that XML forbids replaced.
pub(super) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&apos;"),
            '\t' | '\n' | '\r' => safe.push(' '),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => safe.push('\u{fffd}'),
            _ => safe.push(character),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let texts = [1.0, -0.00001, 0.1 + 0.2, 12.34567, -250.0, 1e5].map(number);
        assert_eq!(texts, ["1", "0", "0.3", "12.3457", "-250", "100000"]);
    }

    #[test]
    fn texts_are_escaped() {
        assert_eq!(escaped("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot;\u{fffd}");
    }

    #[test]
    fn cubics_stay_cubics() {
        let path = BezPath::from_svg("M0 0C1 2 3 4 5 6Z").unwrap();
        assert_eq!(outline(&path, |point| point), "M0,0C1,2 3,4 5,6Z");
    }
}
