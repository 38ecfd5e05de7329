//! From SVG to pixels.

use resvg::{tiny_skia, usvg};

use crate::error::{Error, Result};
use crate::plot::text::options;

/// No side of a picture may be longer, in pixels.
const LONGEST: f64 = 16384.0;
/// No picture may have more pixels: they take 400 MB.
const LARGEST: f64 = 1e8;

/// The PNG file of an SVG document, `scale` pixels for each of its pixels.
///
/// # Errors
/// [`Error::Drawing`] if the picture would have no pixels or too many.
pub(super) fn png(svg: &str, scale: f64) -> Result<Vec<u8>> {
    let fail = |message: String| Error::Drawing { message };
    let tree = usvg::Tree::from_str(svg, &options()).map_err(|error| fail(error.to_string()))?;
    let size = tree.size();
    let sides = [size.width(), size.height()].map(|side| (f64::from(side) * scale).round());
    // Both are false for NaN.
    let fits = sides.iter().all(|side| (1.0..=LONGEST).contains(side)) && sides[0] * sides[1] <= LARGEST;
    if !fits {
        let [width, height] = sides;
        return Err(fail(format!("a picture of {width} x {height} px is empty or too large")));
    }
    let [width, height] = sides.map(|side| side as u32);
    let none = || fail(format!("no memory for {width} x {height} px"));
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or_else(none)?;
    // Scales that are no whole multiples leave a part of a pixel at the edge.
    pixels.fill(tiny_skia::Color::WHITE);
    let scale = scale as f32;
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| fail(error.to_string()))
}
