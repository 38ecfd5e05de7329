//! Pictures made of pixels.

use crate::error::{Error, Result};
use crate::plot::style::Color;
use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

/// No side of a picture may be longer, in pixels.
const LONGEST: usize = 8192;

/// A picture of opaque pixels, row by row from the upper left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    width: usize,
    pixels: Vec<Color>,
}

impl Image {
    /// The picture with `width` pixels a row.
    ///
    /// # Errors
    /// [`Error::Drawing`] for a picture without pixels or with a side longer than 8192 pixels;
    /// [`Error::CoefficientCount`] if the last row is not full.
    ///
    /// # Examples
    /// ```
    /// use symspline::plot::{Color, Image};
    /// let image = Image::new(2, vec![Color::BLACK, Color::WHITE, Color::WHITE, Color::BLACK])?;
    /// assert_eq!((image.width(), image.height()), (2, 2));
    /// assert_eq!(&image.to_png()?[1..4], b"PNG");
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn new(width: usize, pixels: Vec<Color>) -> Result<Self> {
        let height = pixels.len().checked_div(width).unwrap_or(0);
        check_size(width, height)?;
        match width * height {
            count if count == pixels.len() => Ok(Self { width, pixels }),
            count => Err(Error::CoefficientCount { expected: count + width, found: pixels.len() }),
        }
    }

    /// The number of pixels a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The number of rows.
    pub fn height(&self) -> usize {
        self.pixels.len() / self.width
    }

    /// The pixels, row by row.
    pub fn pixels(&self) -> &[Color] {
        &self.pixels
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// [`Error::Drawing`] if there is no memory for it.
    pub fn to_png(&self) -> Result<Vec<u8>> {
        let fail = |message: String| Error::Drawing { message };
        let none = || fail(format!("no memory for {} x {} px", self.width, self.height()));
        let mut map = Pixmap::new(self.width as u32, self.height() as u32).ok_or_else(none)?;
        for (pixel, color) in map.pixels_mut().iter_mut().zip(&self.pixels) {
            *pixel = PremultipliedColorU8::from_rgba(color.red, color.green, color.blue, 255)
                .expect("no part exceeds the opacity 255");
        }
        map.encode_png().map_err(|error| fail(error.to_string()))
    }

    /// The PNG file as an address for SVG.
    pub(in crate::plot) fn address(&self) -> Result<String> {
        Ok(format!("data:image/png;base64,{}", base64(&self.to_png()?)))
    }
}

/// Refuses sizes that no picture has.
pub(super) fn check_size(width: usize, height: usize) -> Result<()> {
    let fits = [width, height].iter().all(|side| (1..=LONGEST).contains(side));
    let refused =
        || Error::Drawing { message: format!("a picture of {width} x {height} px is empty or too large") };
    if fits { Ok(()) } else { Err(refused()) }
}

/// Bytes in letters, six bits each.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for triple in bytes.chunks(3) {
        let byte = |i: usize| u32::from(triple.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        let letter = |i: usize| match i <= triple.len() {
            true => char::from(LETTERS[(bits >> (18 - 6 * i)) as usize & 63]),
            false => '=',
        };
        text.extend((0..4).map(letter));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_become_letters() {
        let texts = ["", "f", "fo", "foo", "foob", "\u{ff}"].map(|text| base64(text.as_bytes()));
        assert_eq!(texts, ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "w78="]);
    }

    #[test]
    fn odd_sizes_are_refused() {
        assert!(matches!(Image::new(0, Vec::new()), Err(Error::Drawing { .. })));
        assert!(matches!(Image::new(0, vec![Color::WHITE]), Err(Error::Drawing { .. })));
        let refused = Image::new(2, vec![Color::WHITE; 3]);
        assert_eq!(refused, Err(Error::CoefficientCount { expected: 4, found: 3 }));
        assert!(matches!(Image::new(9000, vec![Color::WHITE; 9000]), Err(Error::Drawing { .. })));
    }

    #[test]
    fn pixels_keep_their_colours() {
        let pixels =
            vec![Color::BLUE, Color::VERMILLION, Color::WHITE, Color::BLACK, Color::GREEN, Color::SKY];
        let image = Image::new(3, pixels.clone()).unwrap();
        let read = Pixmap::decode_png(&image.to_png().unwrap()).unwrap();
        assert_eq!((read.width(), read.height()), (3, 2));
        let colors = read.pixels().iter().map(|p| Color::new(p.red(), p.green(), p.blue()));
        assert_eq!(colors.collect::<Vec<_>>(), pixels);
    }
}
