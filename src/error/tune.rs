//! Why fine tuning refused.

/// Why fine tuning refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum TuneError {
    /// Over an exact field an area can be kept where the curve itself meets all other conditions, and only there.
    #[error("an area is kept exactly only if the curve itself meets all other conditions")]
    AreaElsewhere,
    /// No scale function with all its values at or above the floor meets the conditions.
    #[error("no scale function of this space that keeps above the floor meets the conditions{}", if *.proved { "" } else { ", as far as was searched" })]
    NoPositiveScale {
        /// Whether it is proved that none has all its values at or above the floor.
        proved: bool,
    },
    /// A spring constant is not a positive number.
    #[error("the spring constant {constant} is not a positive number")]
    SpringConstant {
        /// The constant.
        constant: String,
    },
    /// The ends of a line of control points cannot be held by a similarity, because one of the chords has no length.
    #[error(
        "line {line} of control points along {direction} is closed before or after scaling: no rotation and scaling holds its ends"
    )]
    NoChord {
        /// Along which parameter the line runs.
        direction: String,
        /// Its index.
        line: usize,
    },
    /// A direction in which the surface is periodic has no edges to hold.
    #[error("the surface is periodic in {direction}: it has no edges there")]
    NoEdge {
        /// The direction.
        direction: String,
    },
    /// A part that goes all around a periodic surface does not close along this path.
    #[error("the part goes all around in {direction}, but along this path nothing closes it")]
    Open {
        /// The direction.
        direction: String,
    },
    /// An edge of a rectangle inside the surface is not held.
    #[error("edge {edge} lies inside the surface and has to be held")]
    FreeEdge {
        /// The edge.
        edge: String,
    },
    /// A value of a scale on the edges of a mesh is not a positive number.
    #[error("the scale on edge {edge} is {value}, which is not a positive number")]
    EdgeScale {
        /// The edge of the mesh.
        edge: usize,
        /// The value.
        value: String,
    },
    /// An edge of a converted mesh has no length, or is to have none, so that it makes no angle with others.
    #[error(
        "edge {edge} of the converted mesh has no length, or none is asked for: its angles are undefined"
    )]
    ZeroEdge {
        /// The edge of the converted mesh.
        edge: usize,
    },
}
