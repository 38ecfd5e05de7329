//! Numbers and identities from the literature. Facts only; each file names its source in the first line.

mod miura;
mod miura_local;
mod moments;
mod nurbs_book;
mod nurbs_pulls;
mod nurbs_weights;
mod subdivision;
mod subdivision_surfaces;
mod surfaces;
mod vassilev;

use nalgebra::SVector;
use symspline::Q;

/// A point with integer coordinates.
fn point<const N: usize>(coordinates: [i64; N]) -> SVector<Q, N> {
    SVector::from(coordinates.map(Q::from))
}
