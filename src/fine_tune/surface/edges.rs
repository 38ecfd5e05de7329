//! What stays in place at the four edges of a surface.

use crate::error::Result;
use crate::error::tune::TuneError;
use crate::scalar::Scalar;
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::Surface;
use std::fmt;

/// An edge of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Edge {
    /// Where `u` starts.
    UStart,
    /// Where `u` ends.
    UEnd,
    /// Where `v` starts.
    VStart,
    /// Where `v` ends.
    VEnd,
}

impl Edge {
    /// All four.
    pub const ALL: [Self; 4] = [Self::UStart, Self::UEnd, Self::VStart, Self::VEnd];

    /// The direction that leads away from the edge, across it.
    pub fn direction(self) -> Direction {
        match self {
            Self::UStart | Self::UEnd => U,
            Self::VStart | Self::VEnd => V,
        }
    }

    /// Whether its direction ends there.
    pub fn is_end(self) -> bool {
        matches!(self, Self::UEnd | Self::VEnd)
    }
}

impl fmt::Display for Edge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", if self.is_end() { "end" } else { "start" }, self.direction())
    }
}

/// How a surface fits at an edge to what it was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Fit {
    /// Not at all.
    #[default]
    Free,
    /// The boundary curve stays: `C0`.
    Position,
    /// The first derivatives too: `C1`, hence `G1`.
    Tangent,
    /// The second derivatives too: `C2`, hence `G2`, the curvatures.
    Curvature,
}

impl Fit {
    /// The order of the derivatives that stay, if any do.
    pub fn order(self) -> Option<usize> {
        match self {
            Self::Free => None,
            Self::Position => Some(0),
            Self::Tangent => Some(1),
            Self::Curvature => Some(2),
        }
    }
}

/// How a surface fits at each edge.
///
/// # Examples
/// ```
/// use symspline::{Fit, Edge, Edges};
/// let edges = Edges::all(Fit::Position).with(Edge::VEnd, Fit::Tangent);
/// assert_eq!((edges.fit(Edge::UStart), edges.fit(Edge::VEnd)), (Fit::Position, Fit::Tangent));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Edges([Fit; 4]);

impl Edges {
    /// The same at all edges.
    pub const fn all(fit: Fit) -> Self {
        Self([fit; 4])
    }

    /// Where `direction` starts and ends, free at the other two edges.
    pub const fn across(direction: Direction, fit: Fit) -> Self {
        match direction {
            U => Self([fit, fit, Fit::Free, Fit::Free]),
            V => Self([Fit::Free, Fit::Free, fit, fit]),
        }
    }

    /// The same but for one edge.
    #[must_use]
    pub const fn with(mut self, edge: Edge, fit: Fit) -> Self {
        self.0[edge as usize] = fit;
        self
    }

    /// The fit at an edge.
    pub const fn fit(&self, edge: Edge) -> Fit {
        self.0[edge as usize]
    }

    /// The orders held where `direction` starts and ends.
    pub(crate) fn orders(&self, direction: Direction) -> [Option<usize>; 2] {
        match direction {
            U => [self.0[0], self.0[1]],
            V => [self.0[2], self.0[3]],
        }
        .map(Fit::order)
    }

    /// Refuses to hold edges where the surface has none.
    pub(crate) fn check<T: Scalar, const N: usize>(&self, surface: &Surface<T, N>) -> Result<()> {
        for direction in [U, V] {
            if surface.space(direction).is_periodic() && self.orders(direction) != [None, None] {
                return Err(TuneError::NoEdge { direction: direction.to_string() }.into());
            }
        }
        Ok(())
    }
}
