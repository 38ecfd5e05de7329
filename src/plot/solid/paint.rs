//! Where meshes have their colours from.

use crate::plot::solid::color_scale::ColorScale;
use crate::plot::style::Color;

/// The colour of vertices without a value.
pub(super) const GREY: Color = Color::new(165, 165, 165);

/// Where a mesh has its colours from: one colour, or its values. Vertices without values are grey.
#[derive(Clone, Debug, PartialEq)]
pub enum Paint {
    /// One colour for all.
    Plain(Color),
    /// The colours of the values.
    Values(ColorScale),
}

impl From<Color> for Paint {
    fn from(color: Color) -> Self {
        Self::Plain(color)
    }
}

impl From<&ColorScale> for Paint {
    fn from(scale: &ColorScale) -> Self {
        Self::Values(scale.clone())
    }
}
