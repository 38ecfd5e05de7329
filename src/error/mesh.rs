//! What is wrong with a mesh.

use crate::error::obj::ObjError;

/// What is wrong with a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum MeshError {
    /// A mesh without faces.
    #[error("a mesh needs faces")]
    NoFaces,
    /// A face with fewer than three corners, or one that comes to a vertex twice.
    #[error("face {face} is degenerate: it has fewer than three corners or comes to a vertex twice")]
    DegenerateFace {
        /// Its place in the list of faces.
        face: usize,
    },
    /// A corner is no vertex.
    #[error("corner {corner} of face {face} is vertex {vertex}, but there are {count}")]
    NoSuchVertex {
        /// The face.
        face: usize,
        /// The corner's place in the face.
        corner: usize,
        /// The vertex that it names.
        vertex: usize,
        /// How many vertices there are.
        count: usize,
    },
    /// More than two faces meet in an edge.
    #[error("the edge between the vertices {from} and {to} is in {faces} faces")]
    NonManifoldEdge {
        /// One end.
        from: usize,
        /// The other end.
        to: usize,
        /// How many faces there are at it.
        faces: usize,
    },
    /// Two faces run through an edge in the same direction.
    #[error("the faces {first} and {second} both run from vertex {from} to vertex {to}: one is turned over")]
    InconsistentFaces {
        /// Where the edge begins.
        from: usize,
        /// Where it ends.
        to: usize,
        /// One face.
        first: usize,
        /// The other face.
        second: usize,
    },
    /// The faces at a vertex do not make one fan.
    #[error("the faces at vertex {vertex} hang together in this vertex alone")]
    NonManifoldVertex {
        /// The vertex.
        vertex: usize,
    },
    /// A vertex is in no face.
    #[error("vertex {vertex} is in no face")]
    UnusedVertex {
        /// The vertex.
        vertex: usize,
    },
    /// Nothing is left of a surface whose boundary is open.
    #[error("the surface is empty: no {what} has all its neighbours")]
    NothingInside {
        /// What would be needed: "vertex" or "face".
        what: &'static str,
    },
    /// Cosines of whole fractions of a turn that are not in the field of the coordinates.
    #[error("the weights of a face with {sides} sides are not rational: take floats")]
    IrrationalWeights {
        /// How many sides there are.
        sides: usize,
    },
    /// Subdivision does not draw an element to a point.
    #[error("{what} {index} does not shrink to a point")]
    NoLimit {
        /// What it is: "face" or "vertex".
        what: &'static str,
        /// Its place among them.
        index: usize,
    },
    /// Knot intervals around a vertex are so irregular that its limit is not known.
    #[error(
        "the limit of vertex {vertex} is not known: the knot intervals around it differ from step to step"
    )]
    Unsettled {
        /// The vertex.
        vertex: usize,
    },
    /// A knot interval is negative.
    #[error("knot interval {index} is {interval}, which is negative")]
    NegativeInterval {
        /// Its place in the list.
        index: usize,
        /// The interval.
        interval: String,
    },
    /// So many knot intervals in a row vanish that a curve would jump there.
    #[error("{count} knot intervals from {index} on vanish: the curve would be torn")]
    Torn {
        /// The place of the first in the list.
        index: usize,
        /// How many there are in a row, the degree of the curve.
        count: usize,
    },
    /// No mesh was read: see [`ObjError`].
    #[error(transparent)]
    Obj(#[from] ObjError),
    /// Loops of opposite edges go through vertices with four edges.
    #[error("vertex {vertex} has {edges} edges: only of four are two opposite to two")]
    NoOppositeEdges {
        /// The vertex.
        vertex: usize,
        /// How many edges there are at it.
        edges: usize,
    },
}
