//! The one font, the widths of its texts, and texts broken to fit.
//!
//! Widths are those of DejaVu Sans. Another font, which a viewer may put in its place, is usually narrower.

use std::sync::{Arc, LazyLock};

use resvg::usvg;

use crate::plot::svg::{FAMILY, escaped};

static FONTS: LazyLock<Arc<usvg::fontdb::Database>> = LazyLock::new(|| {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(include_bytes!("../../assets/fonts/DejaVuSans.ttf").to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    Arc::new(fonts)
});

/// The size of numbers at ticks, of legends and of texts inside a plot.
pub(super) const SMALL: f64 = 11.0;

/// How usvg reads our figures: with our font and no other.
pub(super) fn options() -> usvg::Options<'static> {
    usvg::Options { font_family: "DejaVu Sans".into(), fontdb: FONTS.clone(), ..Default::default() }
}

/// The width of one line of text, in pixels.
pub(super) fn width(text: &str, size: f64) -> f64 {
    // Measured large, since glyph advances may be rounded; the text stands alone in its picture.
    let svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='10'>\
         <text font-family='{FAMILY}' font-size='100' xml:space='preserve'>{}</text></svg>",
        escaped(text)
    );
    let Ok(tree) = usvg::Tree::from_str(&svg, &options()) else { return 0.0 };
    let boxes = tree.root().children().iter().map(|node| f64::from(node.abs_bounding_box().width()));
    boxes.fold(0.0, f64::max) * size / 100.0
}

/// A text of one or more lines, all set in one size.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Block {
    pub(super) lines: Vec<String>,
    pub(super) size: f64,
    /// The width of the longest line.
    pub(super) width: f64,
}

impl Block {
    /// Breaks a text between words so that it fits into `room` pixels; a word too long makes all smaller.
    pub(super) fn new(text: &str, size: f64, room: f64) -> Self {
        let mut lines: Vec<String> = Vec::new();
        for word in text.split_whitespace() {
            let longer = lines.last().map(|line| format!("{line} {word}"));
            match (longer, lines.last_mut()) {
                (Some(longer), Some(line)) if width(&longer, size) <= room => *line = longer,
                _ => lines.push(word.to_owned()),
            }
        }
        let widest = lines.iter().map(|line| width(line, size)).fold(0.0, f64::max);
        let shrink = if widest > room { room / widest } else { 1.0 };
        Self { lines, size: size * shrink, width: widest * shrink }
    }

    /// Sets a text on one line, smaller if it is longer than `room` pixels.
    pub(super) fn line(text: &str, size: f64, room: f64) -> Self {
        let wide = width(text, size);
        let shrink = if wide > room { room / wide } else { 1.0 };
        Self { lines: vec![text.to_owned()], size: size * shrink, width: wide * shrink }
    }

    /// From one baseline to the next.
    pub(super) fn leading(&self) -> f64 {
        1.3 * self.size
    }

    /// The height of all lines; nothing for an empty text.
    pub(super) fn height(&self) -> f64 {
        self.lines.len() as f64 * self.leading()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_scale_and_add() {
        let wide = width("mm", 12.0);
        assert!((wide - 2.0 * width("m", 12.0)).abs() < 0.01);
        assert!((width("mm", 24.0) - 2.0 * wide).abs() < 0.01);
        assert!(width("iii", 12.0) < wide);
        // The advance of 'm' in DejaVu Sans is 1995 of 2048 units.
        assert!((width("m", 2048.0) - 1995.0).abs() < 1.0);
    }

    #[test]
    fn long_texts_break_and_long_words_shrink() {
        let block = Block::new("curvature of the profile", 12.0, 80.0);
        assert!(block.lines.len() > 1 && block.size == 12.0);
        let block = Block::new("Donaudampfschifffahrtsgesellschaft", 12.0, 80.0);
        assert!(block.lines.len() == 1 && block.size < 12.0 && block.width <= 80.0 + 1e-9);
        assert_eq!(Block::new("", 12.0, 80.0).height(), 0.0);
    }
}
