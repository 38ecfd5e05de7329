//! Linear edits of control points, prepared.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;

/// A linear edit: control point `i` moves by `Σ_j A_ij d_j`, where the vectors `d_j` say what is asked for.
///
/// The matrix is made once; each edit after that is one product [NURBS, (11.76) and (11.78); FB (5)].
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Drag<T> {
    /// The number of control points of the shapes it is for.
    count: usize,
    indices: Vec<usize>,
    /// One row of `columns` entries for each index.
    matrix: Vec<T>,
    columns: usize,
}

impl<T: Scalar> Drag<T> {
    /// The edit of shapes of `count` control points with the given rows.
    pub(crate) fn new(count: usize, indices: Vec<usize>, matrix: Vec<T>, columns: usize) -> Self {
        debug_assert_eq!(matrix.len(), indices.len() * columns);
        Self { count, indices, matrix, columns }
    }

    /// The control points that move, as places in the list.
    pub fn indices(&self) -> &[usize] {
        &self.indices
    }

    /// How many vectors an edit takes.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The rows of `A`, one for each of [`indices`](Self::indices).
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[T]> {
        self.matrix.chunks_exact(self.columns)
    }

    /// By what the control points move.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is a vector for each column; [`Error::Ragged`] if these are rows of different
    /// lengths.
    pub fn moves<C: Coeff<T>>(&self, by: &[C]) -> Result<Vec<(usize, C)>> {
        if by.len() != self.columns {
            return Err(Error::CoefficientCount { expected: self.columns, found: by.len() });
        }
        if let Some(index) = by.iter().position(|vector| !vector.same_shape(&by[0])) {
            return Err(Error::Ragged { index });
        }
        let sum = |row: &[T]| C::combine(row.iter().zip(by)).expect("at least one column");
        Ok(self.indices.iter().zip(self.rows()).map(|(i, row)| (*i, sum(row))).collect())
    }

    /// Edits `shape`. On an error it stays as it is.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is a vector for each column, and as many control points as the shape had for
    /// which this was prepared; [`Error::NotFinite`] on overflow; [`Error::Ragged`] if vectors are rows of another length than the
    /// control points.
    pub fn apply<S: Controlled<T>>(&self, shape: &mut S, by: &[S::Point]) -> Result<()> {
        self.check(shape)?;
        shape.move_points(&self.moves(by)?)
    }

    /// Refuses shapes with another number of control points.
    pub(crate) fn check<S: Controlled<T>>(&self, shape: &S) -> Result<()> {
        match shape.control_count() {
            found if found != self.count => Err(Error::CoefficientCount { expected: self.count, found }),
            _ => Ok(()),
        }
    }

    /// The edited shape.
    ///
    /// # Errors
    /// As [`apply`](Self::apply).
    pub fn applied<S: Controlled<T>>(&self, shape: &S, by: &[S::Point]) -> Result<S> {
        let mut edited = shape.clone();
        self.apply(&mut edited, by)?;
        Ok(edited)
    }
}
