//! Bilinear maps, kept as rows of weights on pairs of coefficients.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::map::LinearMap;
use crate::scalar::Scalar;

/// A bilinear map as rows: target coefficient `i` is `Σ w_kl c[k] d[l]` over a small window of index pairs.
///
/// # Examples
/// ```
/// use symspline::{BilinearMap, BilinearRow};
/// let product = BilinearMap::from_rows(1, 2, [BilinearRow { first: (0, 0), weights: vec![vec![1.0, 2.0]] }])?;
/// assert_eq!(product.apply(&[3.0], &[1.0, 10.0])?, [63.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct BilinearMap<T> {
    dims: (usize, usize),
    rows: Vec<BilinearRow<T>>,
}

/// One row of a [`BilinearMap`]: `weights[k][l]` belongs to the coefficients `first.0 + k` and `first.1 + l`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct BilinearRow<T> {
    /// The first indices, left and right.
    pub first: (usize, usize),
    /// One row of weights for each left index.
    pub weights: Vec<Vec<T>>,
}

impl<T: Scalar> BilinearMap<T> {
    /// The map with the given rows on `left_dim` by `right_dim` coefficients; all indices wrap.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`] if a row starts past the last coefficient of either side;
    /// [`Error::CoefficientCount`] if the weights of a row are ragged.
    pub fn from_rows(
        left_dim: usize,
        right_dim: usize,
        rows: impl IntoIterator<Item = BilinearRow<T>>,
    ) -> Result<Self> {
        let rows: Vec<_> = rows.into_iter().collect();
        let inside = |index: usize, length: usize| {
            if index < length { Ok(()) } else { Err(Error::IndexOutOfRange { index, length }) }
        };
        for BilinearRow { first: (left, right), weights } in &rows {
            inside(*left, left_dim)?;
            inside(*right, right_dim)?;
            let width = weights.first().map_or(0, Vec::len);
            if let Some(odd) = weights.iter().find(|row| row.len() != width) {
                return Err(Error::CoefficientCount { expected: width, found: odd.len() });
            }
        }
        Ok(Self { dims: (left_dim, right_dim), rows })
    }

    /// The numbers of coefficients it takes on the left and on the right.
    pub fn source_dims(&self) -> (usize, usize) {
        self.dims
    }

    /// The number of coefficients it gives.
    pub fn target_dim(&self) -> usize {
        self.rows.len()
    }

    /// The rows.
    pub fn rows(&self) -> &[BilinearRow<T>] {
        &self.rows
    }

    /// The image of numbers `left` and any coefficients `right`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] if either count is wrong.
    pub fn apply<C: Coeff<T>>(&self, left: &[T], right: &[C]) -> Result<Vec<C>> {
        self.fix_left(left)?.apply(right)
    }

    /// The linear map of the right argument that remains when the left one is `left`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] if the count is wrong.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let lines = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let times_x = lines.multiplication(&lines)?.fix_left(&[0.0, 1.0])?;
    /// assert_eq!(times_x.apply(&[1.0, 1.0])?, [0.0, 0.5, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fix_left(&self, left: &[T]) -> Result<LinearMap<T>> {
        if left.len() != self.dims.0 {
            return Err(Error::CoefficientCount { expected: self.dims.0, found: left.len() });
        }
        let mut map = LinearMap::empty(self.dims.1, self.rows.len());
        for row in &self.rows {
            let factor = |k: usize| &left[(row.first.0 + k) % left.len()];
            let width = row.weights.first().map_or(0, Vec::len);
            let weight = |l: usize| T::dot(row.weights.iter().enumerate().map(|(k, w)| (factor(k), &w[l])));
            map.push(row.first.1, |weights| weights.extend((0..width).map(weight)));
        }
        Ok(map)
    }

    /// The same map with its arguments exchanged.
    ///
    /// # Examples
    /// ```
    /// use symspline::{BilinearMap, BilinearRow};
    /// let product = BilinearMap::from_rows(1, 2, [BilinearRow { first: (0, 0), weights: vec![vec![1.0, 2.0]] }])?;
    /// assert_eq!(product.swapped().apply(&[1.0, 10.0], &[3.0])?, [63.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn swapped(&self) -> Self {
        let swap = |row: &BilinearRow<T>| {
            let width = row.weights.first().map_or(0, Vec::len);
            let column = |l: usize| row.weights.iter().map(|w| w[l].clone()).collect();
            BilinearRow { first: (row.first.1, row.first.0), weights: (0..width).map(column).collect() }
        };
        Self { dims: (self.dims.1, self.dims.0), rows: self.rows.iter().map(swap).collect() }
    }
}
