//! Triangles and lines to pixels, the nearer ones in front.
//!
//! A sample at the middle of a part of a pixel belongs to a triangle if all three barycentric coordinates are at least 0; of
//! all triangles there the nearest gives the colour. A pixel is the mean of its samples, as light.

use crate::plot::solid::color_map::encoded;
use crate::plot::style::Color;
use std::ops::Range;

/// Samples along each side of a pixel.
pub(super) const SAMPLES: usize = 2;

/// Some rows of a picture as they grow. Places are `[x, y, nearness]` in pixels of the whole picture.
#[derive(Debug)]
pub(super) struct Raster {
    /// In samples.
    width: usize,
    rows: Range<usize>,
    nearness: Vec<f64>,
    light: Vec<[f32; 3]>,
}

impl Raster {
    /// Empty rows in one colour, given as light.
    pub(super) fn new(width: usize, rows: Range<usize>, ground: [f64; 3]) -> Self {
        let (width, rows) = (width * SAMPLES, rows.start * SAMPLES..rows.end * SAMPLES);
        let count = width * rows.len();
        let light = vec![ground.map(|part| part as f32); count];
        Self { width, rows, nearness: vec![f64::NEG_INFINITY; count], light }
    }

    /// Draws a triangle; `light` gives the colour at barycentric coordinates. One without area is not seen.
    pub(super) fn triangle(&mut self, corners: [[f64; 3]; 3], light: impl Fn([f64; 3]) -> [f64; 3]) {
        let [a, b, c] = corners.map(|[x, y, z]| [x * SAMPLES as f64 - 0.5, y * SAMPLES as f64 - 0.5, z]);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if !area.is_normal() {
            return;
        }
        let columns = covered([a[0], b[0], c[0]], &(0..self.width));
        let rows = covered([a[1], b[1], c[1]], &self.rows);
        for row in rows {
            let y = row as f64;
            for column in columns.clone() {
                let x = column as f64;
                let v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
                let w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
                let u = 1.0 - v - w;
                if u >= -1e-12 && v >= -1e-12 && w >= -1e-12 {
                    self.put(row, column, u * a[2] + v * b[2] + w * c[2], || light([u, v, w]));
                }
            }
        }
    }

    /// Draws a line of some width with round ends, where it is not behind something by more than `lift`.
    pub(super) fn line(&mut self, ends: [[f64; 3]; 2], width: f64, lift: f64, light: [f64; 3]) {
        let [a, b] = ends.map(|[x, y, z]| [x * SAMPLES as f64 - 0.5, y * SAMPLES as f64 - 0.5, z + lift]);
        let (radius, along) = (width * SAMPLES as f64 / 2.0, [b[0] - a[0], b[1] - a[1]]);
        let square = along[0] * along[0] + along[1] * along[1];
        if !square.is_finite() {
            return;
        }
        let columns = covered([a[0].min(b[0]) - radius, a[0].max(b[0]) + radius, a[0]], &(0..self.width));
        let rows = covered([a[1].min(b[1]) - radius, a[1].max(b[1]) + radius, a[1]], &self.rows);
        for row in rows {
            for column in columns.clone() {
                let d = [column as f64 - a[0], row as f64 - a[1]];
                let share = ((d[0] * along[0] + d[1] * along[1]) / square.max(1e-300)).clamp(0.0, 1.0);
                let off = [d[0] - share * along[0], d[1] - share * along[1]];
                if off[0] * off[0] + off[1] * off[1] <= radius * radius {
                    self.put(row, column, a[2] + share * (b[2] - a[2]), || light);
                }
            }
        }
    }

    /// The pixels, row by row.
    pub(super) fn pixels(&self) -> Vec<Color> {
        let mean = |row: usize, column: usize| {
            let mut sum = [0.0; 3];
            for i in 0..SAMPLES * SAMPLES {
                let (down, right) = (row * SAMPLES + i / SAMPLES, column * SAMPLES + i % SAMPLES);
                let light = self.light[down * self.width + right];
                (0..3).for_each(|k| sum[k] += f64::from(light[k]));
            }
            encoded(sum.map(|part| part / (SAMPLES * SAMPLES) as f64))
        };
        let (rows, columns) = (self.rows.len() / SAMPLES, self.width / SAMPLES);
        (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (row, column)))
            .map(|(i, j)| mean(i, j))
            .collect()
    }

    fn put(&mut self, row: usize, column: usize, nearness: f64, light: impl FnOnce() -> [f64; 3]) {
        let sample = (row - self.rows.start) * self.width + column;
        if nearness > self.nearness[sample] {
            self.nearness[sample] = nearness;
            self.light[sample] = light().map(|part| part as f32);
        }
    }
}

/// The whole numbers of a range from the least of the values to the greatest.
fn covered(values: [f64; 3], range: &Range<usize>) -> Range<usize> {
    let low = values.iter().fold(f64::INFINITY, |low, x| low.min(*x));
    let high = values.iter().fold(f64::NEG_INFINITY, |high, x| high.max(*x));
    // Casts stop at the ends of usize.
    let (low, high) = (low.ceil().max(0.0) as usize, (high.floor() + 1.0).max(0.0) as usize);
    low.clamp(range.start, range.end)..high.clamp(range.start, range.end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::solid::color_map::linear;

    fn painted(raster: &Raster, color: Color) -> usize {
        raster.pixels().iter().filter(|pixel| **pixel == color).count()
    }

    fn empty() -> Raster {
        Raster::new(8, 0..6, linear(Color::WHITE))
    }

    #[test]
    fn nearer_triangles_hide_farther_ones() {
        let whole = |z: f64| [[-20.0, -20.0, z], [40.0, -20.0, z], [-20.0, 40.0, z]];
        let (near, far) = ((whole(1.0), Color::BLUE), (whole(-1.0), Color::GREEN));
        for order in [[near, far], [far, near]] {
            let mut raster = empty();
            order.iter().for_each(|(corners, color)| raster.triangle(*corners, |_| linear(*color)));
            assert_eq!(painted(&raster, Color::BLUE), 48);
        }
    }

    #[test]
    fn triangles_that_cross_share_the_picture() {
        // The plane z = x - 4 is in front of z = 0 on the right half.
        let level = [[-20.0, -20.0, 0.0], [40.0, -20.0, 0.0], [-20.0, 40.0, 0.0]];
        let slope = level.map(|[x, y, _]| [x, y, x - 4.0]);
        let mut raster = empty();
        raster.triangle(slope, |_| linear(Color::BLUE));
        raster.triangle(level, |_| linear(Color::GREEN));
        for (i, pixel) in raster.pixels().iter().enumerate() {
            assert_eq!(*pixel, if i % 8 < 4 { Color::GREEN } else { Color::BLUE }, "{i}");
        }
    }

    #[test]
    fn a_tilted_triangle_covers_the_right_pixels() {
        // Below the line y = x, the left and the lower side of a square.
        for corners in [
            [[0.0, 0.0, 3.0], [0.0, 6.0, -2.0], [6.0, 6.0, 9.0]],
            [[6.0, 6.0, 9.0], [0.0, 6.0, -2.0], [0.0, 0.0, 3.0]],
        ] {
            let mut raster = empty();
            raster.triangle(corners, |_| linear(Color::BLUE));
            for (i, pixel) in raster.pixels().iter().enumerate() {
                let (x, y) = (i % 8, i / 8);
                match x.cmp(&y) {
                    std::cmp::Ordering::Less => assert_eq!(*pixel, Color::BLUE),
                    std::cmp::Ordering::Equal if x < 6 => {
                        assert!(*pixel != Color::BLUE && *pixel != Color::WHITE);
                    }
                    _ => assert_eq!(*pixel, Color::WHITE),
                }
            }
        }
    }

    #[test]
    fn coordinates_are_those_of_the_place() {
        let mut raster = empty();
        let corners = [[0.0, 0.0, 0.0], [12.0, 0.0, 0.0], [0.0, 12.0, 0.0]];
        raster.triangle(corners, |[_, v, w]| [v, w, 0.0]);
        let pixel = encoded([2.5 / 12.0, 1.5 / 12.0, 0.0]);
        let found = raster.pixels()[8 + 2];
        assert!(found.red.abs_diff(pixel.red) <= 1 && found.green.abs_diff(pixel.green) <= 1);
    }

    #[test]
    fn lines_are_hidden_by_what_is_in_front() {
        let wall = [[4.0, -20.0, 0.0], [40.0, -20.0, 0.0], [4.0, 60.0, 0.0]];
        let mut raster = empty();
        raster.triangle(wall, |_| linear(Color::GREEN));
        raster.line([[0.0, 3.0, -1.0], [8.0, 3.0, -1.0]], 2.0, 0.5, linear(Color::BLUE));
        assert_eq!(painted(&raster, Color::BLUE), 8);
        raster.line([[0.0, 3.0, -1.0], [8.0, 3.0, -1.0]], 2.0, 1.5, linear(Color::BLUE));
        assert_eq!(painted(&raster, Color::BLUE), 16);
    }

    #[test]
    fn parts_of_a_picture_are_those_of_the_whole() {
        let drawn = |rows| {
            let mut raster = Raster::new(8, rows, linear(Color::WHITE));
            raster.triangle([[0.3, 0.1, 0.0], [7.1, 2.2, 1.0], [2.6, 5.9, 2.0]], |[_, v, w]| [v, w, 0.0]);
            raster.line([[0.0, 5.0, 3.0], [8.0, 0.5, 0.0]], 0.7, 0.1, linear(Color::BLUE));
            raster.pixels()
        };
        assert_eq!([drawn(0..1), drawn(1..4), drawn(4..6)].concat(), drawn(0..6));
    }

    #[test]
    fn odd_triangles_do_no_harm() {
        let mut raster = empty();
        for odd in [f64::NAN, f64::INFINITY, 1e300, -1e300] {
            raster.triangle([[odd, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, odd]], |_| [0.0; 3]);
            raster.line([[0.0, odd, 0.0], [100.0, 100.0, 0.0]], 1.0, 0.0, [0.0; 3]);
        }
        raster.triangle([[0.0; 3]; 3], |_| [0.0; 3]);
    }
}
