//! What a projection tells.

use nalgebra::SVector;
use std::fmt::Debug;

mod sealed {
    /// Only the parameters of this file have it.
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for (f64, f64) {}
}

/// The parameters of a curve, `f64`, or of a surface, `(f64, f64)`.
pub trait Place: Copy + Debug + PartialEq + Send + Sync + sealed::Sealed {
    /// The parameter with these two coordinates; a curve has only the first.
    #[doc(hidden)]
    fn at(coordinates: [f64; 2]) -> Self;
}

impl Place for f64 {
    fn at(coordinates: [f64; 2]) -> Self {
        coordinates[0]
    }
}

impl Place for (f64, f64) {
    fn at(coordinates: [f64; 2]) -> Self {
        (coordinates[0], coordinates[1])
    }
}

/// A point of a curve or surface with its distance from a given point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot<X, const N: usize> {
    /// The parameter, in the domain.
    pub parameter: X,
    /// The point there; at a jump it may be the limit from the other side.
    pub point: SVector<f64, N>,
    /// How far it is from the given point.
    pub distance: f64,
}

/// All points of a curve or surface that are nearest to a given point, within an accuracy.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearest<X, const N: usize> {
    /// The feet: local minima of the distance that are within the accuracy of the least, nearest first. There is at
    /// least one.
    pub feet: Vec<Foot<X, N>>,
    /// Intervals of parameters, of surfaces rectangles from corner to corner, in which feet could not be told from each
    /// other, most often because the distance is the same all along. Each has at most one foot in [`feet`](Self::feet),
    /// the nearest found. From every parameter within the accuracy the distance descends to a foot or into one of
    /// these.
    pub along: Vec<(X, X)>,
    /// No point is nearer than this.
    pub bound: f64,
}
