//! Bilinear maps, kept as rows of weights on pairs of coefficients.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::limits::check_entries;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use nalgebra::DMatrix;

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

    /// The bilinear map `(c, d) -> self(left c, right d)`.
    ///
    /// Rows over the seam of a periodic space become as wide as the space.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] if the maps do not give as many coefficients as this one takes;
    /// [`Error::TooLarge`] for a row of more than [`MAX_ENTRIES`](crate::limits::MAX_ENTRIES) weights.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// // f' g as one map of the coefficients of f and g.
    /// let space = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let slope = space.differentiation()?;
    /// let product = space.derivative_space()?.multiplication(&space)?;
    /// let both = product.after(&slope, &symspline::LinearMap::identity(2))?;
    /// assert_eq!(both.apply(&[1.0, 3.0], &[1.0, 4.0])?, [2.0, 8.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn after(&self, left: &LinearMap<T>, right: &LinearMap<T>) -> Result<Self> {
        for (map, expected) in [(left, self.dims.0), (right, self.dims.1)] {
            if map.target_dim() != expected {
                return Err(Error::CoefficientCount { expected, found: map.target_dim() });
            }
        }
        let dims = (left.source_dim(), right.source_dim());
        let row = |row: &BilinearRow<T>| {
            let mut window = Window::default();
            for (i, j, weight) in row.entries() {
                window.add_outer(weight, left.row(i % self.dims.0), right.row(j % self.dims.1));
            }
            window.into_row(dims.0, dims.1)
        };
        Ok(Self { dims, rows: self.rows.iter().map(row).collect::<Result<_>>()? })
    }

    /// The bilinear map `(c, d) -> map(self(c, d))`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] if `map` does not take as many coefficients as this map gives; [`Error::TooLarge`] as for
    /// [`after`](Self::after).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// // (f g)' as one map of the coefficients of f and g.
    /// let space = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let slope = space.product_space(&space)?.differentiation()?;
    /// let both = space.multiplication(&space)?.then(&slope)?;
    /// assert_eq!(both.apply(&[0.0, 1.0], &[0.0, 1.0])?, [0.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn then(&self, map: &LinearMap<T>) -> Result<Self> {
        if map.source_dim() != self.rows.len() {
            return Err(Error::CoefficientCount { expected: map.source_dim(), found: self.rows.len() });
        }
        let row = |(first, weights): (usize, &[T])| {
            let mut window = Window::default();
            for (k, factor) in (first..).zip(weights) {
                let entries = self.rows[k % self.rows.len()].entries();
                window.weights.extend(entries.map(|(i, j, weight)| (i, j, factor.clone() * weight)));
            }
            window.into_row(self.dims.0, self.dims.1)
        };
        Ok(Self { dims: self.dims, rows: map.rows().map(row).collect::<Result<_>>()? })
    }

    /// Row `i` as a dense matrix, left by right: the bilinear form of target coefficient `i`.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`]; [`Error::TooLarge`] for more than [`MAX_ENTRIES`](crate::limits::MAX_ENTRIES) entries.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::matrix;
    /// use symspline::SplineSpace;
    /// let lines = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// assert_eq!(lines.multiplication(&lines)?.to_matrix(1)?, matrix![0.0, 0.5; 0.5, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn to_matrix(&self, i: usize) -> Result<DMatrix<T>> {
        let row = self.rows.get(i).ok_or(Error::IndexOutOfRange { index: i, length: self.rows.len() })?;
        check_entries(self.dims.0, self.dims.1)?;
        let mut matrix = DMatrix::from_element(self.dims.0, self.dims.1, T::zero());
        for (i, j, weight) in row.entries() {
            matrix[(i % self.dims.0, j % self.dims.1)] += weight;
        }
        Ok(matrix)
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

impl<T> BilinearRow<T> {
    /// The weights with the indices they belong to, before wrapping.
    fn entries(&self) -> impl Iterator<Item = (usize, usize, &T)> {
        let (left, right) = self.first;
        (left..)
            .zip(&self.weights)
            .flat_map(move |(i, row)| (right..).zip(row).map(move |(j, weight)| (i, j, weight)))
    }
}

/// A growing window of weights on index pairs.
pub(crate) struct Window<T> {
    weights: Vec<(usize, usize, T)>,
}

impl<T> Default for Window<T> {
    fn default() -> Self {
        Self { weights: Vec::new() }
    }
}

impl<T: Scalar> Window<T> {
    /// Adds `weight` times the product of two rows.
    pub(crate) fn add_outer(&mut self, weight: &T, left: (usize, &[T]), right: (usize, &[T])) {
        for (i, l) in (left.0..).zip(left.1) {
            let scaled = weight.clone() * l;
            self.weights.extend((right.0..).zip(right.1).map(|(j, r)| (i, j, scaled.clone() * r)));
        }
    }

    /// The window as a row.
    pub(crate) fn into_row(self, left_dim: usize, right_dim: usize) -> Result<BilinearRow<T>> {
        let indices = || self.weights.iter().map(|(i, j, _)| (*i, *j));
        let Some(low) = indices().reduce(|a, b| (a.0.min(b.0), a.1.min(b.1))) else {
            return Ok(BilinearRow { first: (0, 0), weights: Vec::new() });
        };
        let high = indices().fold(low, |a, b| (a.0.max(b.0), a.1.max(b.1)));
        let (height, width) = (high.0 - low.0 + 1, high.1 - low.1 + 1);
        check_entries(height, width)?;
        let mut weights = vec![vec![T::zero(); width]; height];
        for (i, j, weight) in self.weights {
            weights[i - low.0][j - low.1] += weight;
        }
        Ok(BilinearRow { first: (low.0 % left_dim, low.1 % right_dim), weights })
    }
}
