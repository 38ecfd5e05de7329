//! Colours, strokes and marker shapes.
//!
//! The palette is the one of Okabe and Ito, whose colours stay apart for colour-blind readers.

/// An opaque sRGB colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color {
    /// The red part.
    pub red: u8,
    /// The green part.
    pub green: u8,
    /// The blue part.
    pub blue: u8,
}

impl Color {
    /// Black.
    pub const BLACK: Self = Self::new(0, 0, 0);
    /// Okabe-Ito blue.
    pub const BLUE: Self = Self::new(0, 114, 178);
    /// Okabe-Ito vermillion.
    pub const VERMILLION: Self = Self::new(213, 94, 0);
    /// Okabe-Ito bluish green.
    pub const GREEN: Self = Self::new(0, 158, 115);
    /// Okabe-Ito reddish purple.
    pub const PURPLE: Self = Self::new(204, 121, 167);
    /// Okabe-Ito orange.
    pub const ORANGE: Self = Self::new(230, 159, 0);
    /// Okabe-Ito sky blue.
    pub const SKY: Self = Self::new(86, 180, 233);
    /// Okabe-Ito yellow: too light for thin lines, good for fills.
    pub const YELLOW: Self = Self::new(240, 228, 66);
    /// A middle grey for control polygons and other help lines.
    pub const GRAY: Self = Self::new(128, 128, 128);
    /// A light grey for what should stay in the background.
    pub const LIGHT_GRAY: Self = Self::new(200, 200, 200);
    /// White.
    pub const WHITE: Self = Self::new(255, 255, 255);
    /// The colours to give to one curve after another.
    pub const CYCLE: [Self; 7] =
        [Self::BLUE, Self::VERMILLION, Self::GREEN, Self::PURPLE, Self::ORANGE, Self::SKY, Self::BLACK];

    /// The colour with the given parts.
    pub const fn new(red: u8, green: u8, blue: u8) -> Self {
        Self { red, green, blue }
    }

    /// The colour of the `i`-th curve: [`Color::CYCLE`], around and around.
    pub const fn nth(i: usize) -> Self {
        Self::CYCLE[i % Self::CYCLE.len()]
    }

    /// The colour as SVG writes it.
    #[cfg(feature = "plot")]
    pub(super) fn hex(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.red, self.green, self.blue)
    }
}

/// How a stroke is broken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dash {
    /// Not at all.
    #[default]
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Dashes and dots in turn.
    DashDot,
}

impl Dash {
    /// Lengths of strokes and gaps, in units of the line width.
    #[cfg(feature = "plot")]
    pub(super) const fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[4.5, 2.5],
            Self::Dotted => &[1.0, 1.8],
            Self::DashDot => &[5.0, 2.0, 1.0, 2.0],
        }
    }
}

/// The shape of a marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    /// A circle.
    Circle,
    /// A square with horizontal sides.
    Square,
    /// A square on its corner.
    Diamond,
    /// A triangle that points up.
    Up,
    /// A triangle that points down.
    Down,
    /// A cross of two diagonals.
    Cross,
    /// A short vertical line through the point.
    Tick,
}

/// How a series is drawn: stroke, fill and opacity, in pixels of the unscaled figure.
///
/// A [`Color`] is a style too: a solid line of that colour. Lengths must be finite and not negative and
/// opacities lie in `[0, 1]`; the outputs of [`Figure`](crate::plot::Figure) refuse anything else.
///
/// # Examples
/// ```
/// # use symspline::plot::{Color, Style};
/// let guide = Style::line(Color::GRAY).width(0.8).dashed().opacity(0.7);
/// assert_ne!(guide, Style::from(Color::GRAY));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// No colour: no stroke.
    pub(super) stroke: Option<Color>,
    pub(super) width: f64,
    pub(super) dash: Dash,
    /// No colour: no fill. Markers then are filled white.
    pub(super) fill: Option<Color>,
    pub(super) fill_opacity: f64,
    pub(super) opacity: f64,
    /// Half the width of a marker.
    pub(super) marker_radius: f64,
}

impl Style {
    /// A solid line of 1.6 px.
    pub const fn line(color: Color) -> Self {
        Self {
            stroke: Some(color),
            width: 1.6,
            dash: Dash::Solid,
            fill: None,
            fill_opacity: 1.0,
            opacity: 1.0,
            marker_radius: 3.5,
        }
    }

    /// A filled area or marker without a stroke.
    pub const fn area(color: Color) -> Self {
        Self { stroke: None, fill: Some(color), ..Self::line(color) }
    }

    /// The same with a stroke of `px` pixels.
    pub const fn width(self, px: f64) -> Self {
        Self { width: px, ..self }
    }

    /// The same with a broken stroke.
    pub const fn dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// The same with dashes.
    pub const fn dashed(self) -> Self {
        self.dash(Dash::Dashed)
    }

    /// The same with dots.
    pub const fn dotted(self) -> Self {
        self.dash(Dash::Dotted)
    }

    /// The same filled, with an opacity of the fill alone.
    pub const fn filled(self, color: Color, opacity: f64) -> Self {
        Self { fill: Some(color), fill_opacity: opacity, ..self }
    }

    /// The same as a whole more or less see-through: 0 is invisible, 1 is opaque.
    pub const fn opacity(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// The same with markers that reach `px` pixels to each side of their points.
    pub const fn marker_radius(self, px: f64) -> Self {
        Self { marker_radius: px, ..self }
    }
}

impl From<Color> for Style {
    fn from(color: Color) -> Self {
        Self::line(color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cycle_repeats() {
        assert_eq!(Color::nth(0), Color::nth(Color::CYCLE.len()));
        assert_eq!(Color::nth(1).hex(), "#d55e00");
    }
}
