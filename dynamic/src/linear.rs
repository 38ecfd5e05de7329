//! Linear images: a matrix applied to every value.

use crate::error::{Error, Result};
use crate::family::{AnyRational, AnyRationalSurface, AnySpline, AnySurface};
use crate::number::Field;
use crate::over::{Coords, Over};
use symspline::{Direction, Scalar};

/// The image of each of the points, `dim` coordinates each, of which the last `carried` are carried along.
fn images<T: Scalar>(matrix: &[T], coords: &[T], dim: usize, carried: usize) -> Vec<T> {
    let mut images = Vec::new();
    for point in coords.chunks_exact(dim + carried) {
        let (point, rest) = point.split_at(dim);
        images.extend(matrix.chunks_exact(dim).map(|row| T::dot(row.iter().zip(point))));
        images.extend(rest.iter().cloned());
    }
    images
}

/// The same for either field, and the dimension of the images.
fn image(matrix: &Coords, coords: &Coords, dim: usize, carried: usize) -> Result<(usize, Coords)> {
    if matrix.is_empty() || !matrix.len().is_multiple_of(dim) {
        return Err(Error::Torn { count: matrix.len(), dim });
    }
    let coords = match (matrix, coords) {
        (Over::Float(m), Over::Float(c)) => f64::coords(images(m, c, dim, carried)),
        (Over::Exact(m), Over::Exact(c)) => Field::coords(images(m, c, dim, carried)),
        (matrix, coords) => return Err(coords.unlike(matrix)),
    };
    Ok((matrix.len() / dim, coords))
}

macro_rules! linear {
    ($any:ty, $of:ident, $carried:expr, $coords:expr, $build:expr) => {
        impl $any {
            /// The image under a matrix, given row by row: as many rows as its values have coordinates, each as long as those here
            /// have. Exact but for rounding: control points go to control points.
            ///
            /// # Errors
            /// [`Error::Torn`], [`Error::Fields`], [`Error::Dimension`], and those of the library.
            pub fn transformed(&self, matrix: &Coords) -> Result<Self> {
                let $of = self;
                let (dim, coords) = image(matrix, &$coords?, self.dim(), $carried)?;
                $build(self, dim, coords)
            }
        }
    };
}

linear!(AnySpline, s, 0, s.coords(), |s: &Self, dim, coords| Self::new(s.space(), dim, coords));
linear!(AnySurface, s, 0, s.coords(), |s: &Self, dim, coords| {
    Self::new(s.space(Direction::U), s.space(Direction::V), dim, coords)
});
linear!(AnyRational, s, 1, Result::Ok(s.homogeneous()), |s: &Self, dim, coords| {
    Self::from_homogeneous(s.space(), dim, coords)
});
linear!(AnyRationalSurface, s, 1, Result::Ok(s.homogeneous()), |s: &Self, dim, coords| {
    Self::from_homogeneous(s.space(Direction::U), s.space(Direction::V), dim, coords)
});
