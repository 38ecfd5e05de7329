//! Outlines of letters from TrueType and OpenType fonts.
//!
//! A font holds letters, not a drawing: [`outlines`] is told a text, and [`read`](crate::read) of a font refuses. Coordinates are those of the font,
//! in its units with the y axis pointing up, and exact: whole numbers, halves where TrueType implies a point. Letters
//! stand next to each other by their advance widths, without kerning or shaping. Each contour is a closed curve: quadratic in TrueType,
//! cubic in fonts with PostScript outlines.

use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use crate::outline::{Outline, Point, Segment};
use nalgebra::vector;
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, MetadataProvider};

/// How many letters a text may have.
const MOST: usize = 1 << 16;

/// The contours of the letters of a text, one closed curve each, named by the letter.
///
/// # Errors
/// [`Problem::Syntax`]: of the file if it is no font, of the letter if the font has not got it or cannot draw it.
///
/// # Examples
/// ```
/// let font = std::fs::read("../assets/fonts/DejaVuSans.ttf").expect("a font of this project");
/// let outlines = symspline_files::font::outlines(&font, "so")?;
/// let names: Vec<_> = outlines.iter().map(|entry| entry.name.as_deref()).collect();
/// // The o has an inside.
/// assert_eq!(names, [Some("s"), Some("o"), Some("o")]);
/// # Ok::<(), symspline_files::FileError>(())
/// ```
pub fn outlines(bytes: &[u8], text: &str) -> Result<Vec<Entry>> {
    let font = FontRef::new(bytes).map_err(|error| Problem::Syntax(format!("font: {error}")).of_file())?;
    if text.chars().count() > MOST {
        return Err(Problem::Syntax(format!("the text has more than {MOST} letters")).of_file());
    }
    let (size, location) = (Size::unscaled(), LocationRef::default());
    let (letters, glyphs, metrics) =
        (font.charmap(), font.outline_glyphs(), font.glyph_metrics(size, location));
    let mut entries = Vec::new();
    let mut advance = 0.0;
    for letter in text.chars() {
        let at = |problem: Problem| problem.at(Place::Entry(format!("letter {letter:?}")));
        let missing = || at(Problem::Syntax("the font has no such letter".into()));
        let glyph = letters.map(letter).ok_or_else(missing)?;
        let mut pen = Pen { advance, outlines: Vec::new() };
        if let Some(outline) = glyphs.get(glyph) {
            let drawn = outline.draw(DrawSettings::unhinted(size, location), &mut pen);
            drawn.map_err(|error| at(Problem::Syntax(error.to_string())))?;
        }
        for outline in &mut pen.outlines {
            outline.close();
            if let Some(value) = outline.value().map_err(at)? {
                entries.push(Entry::named(letter, value));
            }
        }
        advance += f64::from(metrics.advance_width(glyph).unwrap_or(0.0));
    }
    Ok(entries)
}

/// Contours as they are drawn.
struct Pen {
    advance: f64,
    outlines: Vec<Outline>,
}

impl Pen {
    fn point(&self, x: f32, y: f32) -> Point {
        vector![f64::from(x) + self.advance, f64::from(y)]
    }

    fn put(&mut self, segment: Segment) {
        if let Some(outline) = self.outlines.last_mut() {
            outline.segments.push(segment);
        }
    }
}

impl OutlinePen for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.outlines.push(Outline::at(self.point(x, y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.put(Segment::Line(self.point(x, y)));
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        self.put(Segment::Quadratic([self.point(cx, cy), self.point(x, y)]));
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        self.put(Segment::Cubic([self.point(ax, ay), self.point(bx, by), self.point(x, y)]));
    }

    fn close(&mut self) {
        if let Some(outline) = self.outlines.last_mut() {
            outline.close();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use symspline_dynamic::{Coords, Over, Value};

    fn font() -> Vec<u8> {
        std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/fonts/DejaVuSans.ttf")).unwrap()
    }

    fn corners(entry: &Entry) -> Vec<f64> {
        let Value::Spline(curve) = &entry.value else { panic!() };
        let Coords::Float(all) = curve.coords().unwrap() else { panic!() };
        all
    }

    /// The bar of DejaVu Sans, by fontTools: (430, 1565) (430, -483) (260, -483) (260, 1565), advance 690.
    #[test]
    fn a_bar_is_a_rectangle() {
        let bars = outlines(&font(), "||").unwrap();
        assert_eq!(bars.len(), 2);
        let (first, second) = (corners(&bars[0]), corners(&bars[1]));
        assert_eq!(first, [430.0, 1565.0, 430.0, -483.0, 260.0, -483.0, 260.0, 1565.0, 430.0, 1565.0]);
        let moved: Vec<f64> = first.chunks(2).flat_map(|p| [p[0] + 690.0, p[1]]).collect();
        assert_eq!(moved, second);
    }

    #[test]
    fn round_letters_are_closed_quadratics() {
        for entry in outlines(&font(), "Qé8").unwrap() {
            let Value::Spline(curve) = &entry.value else { panic!() };
            let (a, b) = curve.domain();
            assert_eq!(curve.at(&a).unwrap(), curve.at(&b).unwrap());
            assert!(matches!(curve.space(), Over::Float(s) if s.degree() <= 2));
        }
    }

    #[test]
    fn what_is_missing_is_named() {
        let missing = outlines(&font(), "a\u{10ffff}").unwrap_err();
        assert_eq!(missing.to_string(), "input: letter '\\u{10ffff}': the font has no such letter");
        assert!(outlines(b"no font", "a").is_err());
        assert_eq!(outlines(&font(), " \u{a0}").unwrap(), []);
    }
}
