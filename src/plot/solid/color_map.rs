//! Colours for numbers: maps from `[0, 1]` to colours.
//!
//! Colours lie on lines between a few anchors in the space Oklab of B. Ottosson, where equal distances look alike. The
//! diverging map goes from dark blue by nearly white to dark orange, with the same lightness at the same distance from the
//! middle; in the sequential map lightness grows evenly. Blue and orange, and lightness, stay apart for colour-blind
//! readers.

use crate::plot::style::Color;

/// Anchors as lightness, chroma and hue in degrees.
const DIVERGING: [[f64; 3]; 9] = [
    [0.36, 0.120, 260.0],
    [0.50, 0.140, 256.0],
    [0.65, 0.130, 250.0],
    [0.80, 0.085, 240.0],
    [0.955, 0.006, 90.0],
    [0.80, 0.105, 68.0],
    [0.65, 0.155, 52.0],
    [0.50, 0.145, 40.0],
    [0.36, 0.110, 32.0],
];
const SEQUENTIAL: [[f64; 3]; 6] = [
    [0.27, 0.100, 285.0],
    [0.40, 0.120, 268.0],
    [0.53, 0.095, 232.0],
    [0.66, 0.105, 182.0],
    [0.79, 0.145, 135.0],
    [0.92, 0.150, 104.0],
];

/// A map from `[0, 1]` to colours.
///
/// # Examples
/// ```
/// use symspline::plot::{Color, ColorMap};
/// let map = ColorMap::through(&[Color::BLACK, Color::WHITE]);
/// assert_eq!((map.at(-1.0), map.at(1.0)), (Color::BLACK, Color::WHITE));
/// let ends = [ColorMap::diverging().at(0.0), ColorMap::diverging().at(1.0)];
/// assert!(ends[0].blue > ends[0].red && ends[1].red > ends[1].blue);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ColorMap {
    /// In Oklab: lightness, green to red, blue to yellow.
    anchors: Vec<[f64; 3]>,
}

impl ColorMap {
    /// Blue below the middle, orange above: for values about zero.
    pub fn diverging() -> Self {
        Self { anchors: DIVERGING.map(from_hue).to_vec() }
    }

    /// From dark blue by green to light yellow: for values that are small or large.
    pub fn sequential() -> Self {
        Self { anchors: SEQUENTIAL.map(from_hue).to_vec() }
    }

    /// The map through given colours at equal distances; grey without any.
    pub fn through(colors: &[Color]) -> Self {
        let anchors: Vec<_> = colors.iter().map(|color| lab(linear(*color))).collect();
        Self { anchors: if anchors.is_empty() { vec![lab(linear(Color::GRAY))] } else { anchors } }
    }

    /// The colour of `x`; below 0 that of 0, above 1 that of 1.
    pub fn at(&self, x: f64) -> Color {
        encoded(self.linear_at(x))
    }

    /// The same as parts of light.
    pub(super) fn linear_at(&self, x: f64) -> [f64; 3] {
        let x = if x.is_nan() { 0.0 } else { x.clamp(0.0, 1.0) };
        let place = x * (self.anchors.len() - 1) as f64;
        let i = (place as usize).min(self.anchors.len().saturating_sub(2));
        let (from, to) = (self.anchors[i], self.anchors[(i + 1).min(self.anchors.len() - 1)]);
        let share = place - i as f64;
        rgb(std::array::from_fn(|k| from[k] + (to[k] - from[k]) * share)).map(|part| part.clamp(0.0, 1.0))
    }
}

fn from_hue([lightness, chroma, hue]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = hue.to_radians().sin_cos();
    [lightness, chroma * cos, chroma * sin]
}

/// Parts of light of a colour.
pub(super) fn linear(color: Color) -> [f64; 3] {
    let part = |byte: u8| {
        let x = f64::from(byte) / 255.0;
        if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
    };
    [color.red, color.green, color.blue].map(part)
}

/// The colour nearest to parts of light.
pub(super) fn encoded(light: [f64; 3]) -> Color {
    let byte = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        let x = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
        (255.0 * x).round() as u8
    };
    let [red, green, blue] = light.map(byte);
    Color::new(red, green, blue)
}

/// From light to Oklab.
fn lab([r, g, b]: [f64; 3]) -> [f64; 3] {
    let cones = [
        0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b,
        0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b,
        0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b,
    ];
    let [l, m, s] = cones.map(f64::cbrt);
    [
        0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
        1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
        0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
    ]
}

/// From Oklab to light, which may lie outside `[0, 1]`.
fn rgb([lightness, a, b]: [f64; 3]) -> [f64; 3] {
    let cones = [
        lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b,
        lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b,
        lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b,
    ];
    let [l, m, s] = cones.map(|x| x * x * x);
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lightness(map: &ColorMap, x: f64) -> f64 {
        lab(map.linear_at(x))[0]
    }

    #[test]
    fn colours_go_to_oklab_and_back() {
        for color in [Color::BLACK, Color::WHITE, Color::BLUE, Color::VERMILLION, Color::new(1, 254, 3)] {
            assert_eq!(encoded(rgb(lab(linear(color)))), color);
        }
        let [white, a, b] = lab([1.0; 3]);
        assert!((white - 1.0).abs() < 1e-6 && a.abs() < 1e-6 && b.abs() < 1e-6);
    }

    #[test]
    fn anchors_are_colours_of_a_screen() {
        for anchor in DIVERGING.iter().chain(&SEQUENTIAL) {
            let parts = rgb(from_hue(*anchor));
            assert!(parts.iter().all(|part| (-1e-3..=1.001).contains(part)), "{anchor:?}: {parts:?}");
        }
    }

    #[test]
    fn lightness_tells_the_value() {
        let (diverging, sequential) = (ColorMap::diverging(), ColorMap::sequential());
        for i in 0..100 {
            let (x, next) = (f64::from(i) / 200.0, f64::from(i + 1) / 200.0);
            assert!(lightness(&diverging, next) > lightness(&diverging, x));
            assert!((lightness(&diverging, x) - lightness(&diverging, 1.0 - x)).abs() < 2e-3);
            assert!(lightness(&sequential, 2.0 * next) > lightness(&sequential, 2.0 * x));
        }
        let white = diverging.at(0.5);
        assert!(white.red > 230 && white.green > 230 && white.blue > 230);
    }

    #[test]
    fn ends_hold_beyond() {
        let map = ColorMap::sequential();
        assert_eq!((map.at(-3.0), map.at(7.0)), (map.at(0.0), map.at(1.0)));
        assert_eq!(map.at(f64::NAN), map.at(0.0));
        assert_eq!(ColorMap::through(&[]).at(0.3), Color::GRAY);
        assert_eq!(ColorMap::through(&[Color::BLUE]).at(0.3), Color::BLUE);
    }
}
