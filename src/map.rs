//! Linear maps between coefficient vectors, kept as rows of weights.
//!
//! An operator between spline spaces is one short row of weights a target coefficient, made from the knots alone.
//! Kept by the caller, such a map is a table: applying it again to other coefficients costs a few products a row.

use crate::coeff::{Coeff, check_shapes};
use crate::error::{Error, Result};
use crate::functional::{Functional, weigh};
use crate::gather::{Gather, wrap};
use crate::limits::check_entries;
use crate::scalar::Scalar;
use nalgebra::DMatrix;

/// A linear map as rows: target coefficient `i` is the functional `row(i)` of the source coefficients.
///
/// # Examples
/// ```
/// use symspline::{Functional, LinearMap};
/// let halve = LinearMap::from_rows(2, [Functional::new(0, [0.5, 0.5]), Functional::new(1, [1.0])])?;
/// assert_eq!(halve.apply(&[2.0, 4.0])?, [3.0, 4.0]);
/// assert_eq!(halve.transpose().apply(&[2.0, 4.0])?, [1.0, 5.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct LinearMap<T> {
    source_dim: usize,
    /// Row `i` has `weights[ends[i - 1]..ends[i]]` on the coefficients from `firsts[i]`.
    firsts: Vec<usize>,
    ends: Vec<usize>,
    weights: Vec<T>,
}

impl<T: Scalar> LinearMap<T> {
    /// The map with the given rows on `source_dim` coefficients.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`] if a row starts past the last coefficient (it may wrap after that).
    pub fn from_rows(source_dim: usize, rows: impl IntoIterator<Item = Functional<T>>) -> Result<Self> {
        let mut map = Self::empty(source_dim, 0);
        for row in rows {
            if row.first() >= source_dim {
                return Err(Error::IndexOutOfRange { index: row.first(), length: source_dim });
            }
            map.push(row.first(), |weights| weights.extend_from_slice(row.weights()));
        }
        Ok(map)
    }

    /// The identity on `dim` coefficients.
    pub fn identity(dim: usize) -> Self {
        let mut map = Self::empty(dim, dim);
        (0..dim).for_each(|i| map.push(i, |weights| weights.push(T::one())));
        map
    }

    /// A map without rows, with room for some.
    pub(crate) fn empty(source_dim: usize, rows: usize) -> Self {
        Self {
            source_dim,
            firsts: Vec::with_capacity(rows),
            ends: Vec::with_capacity(rows),
            weights: Vec::new(),
        }
    }

    /// Adds a row whose weights `fill` appends.
    #[inline]
    pub(crate) fn push(&mut self, first: usize, fill: impl FnOnce(&mut Vec<T>)) {
        fill(&mut self.weights);
        self.firsts.push(first);
        self.ends.push(self.weights.len());
    }

    /// Adds a row whose weights `fill` appends, and which returns where they start.
    #[inline]
    pub(crate) fn push_with(&mut self, fill: impl FnOnce(&mut Vec<T>) -> usize) {
        let first = fill(&mut self.weights);
        self.firsts.push(first);
        self.ends.push(self.weights.len());
    }

    /// The number of coefficients it takes.
    pub fn source_dim(&self) -> usize {
        self.source_dim
    }

    /// The number of coefficients it gives.
    pub fn target_dim(&self) -> usize {
        self.firsts.len()
    }

    /// First index and weights of row `i`; indices past the last coefficient wrap to the first.
    ///
    /// # Panics
    /// If there is no such row.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let slope = SplineSpace::bezier(1, 0.0, 0.5)?.differentiation()?;
    /// assert_eq!(slope.row(0), (0, &[-2.0, 2.0][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn row(&self, i: usize) -> (usize, &[T]) {
        let start = if i == 0 { 0 } else { self.ends[i - 1] };
        (self.firsts[i], &self.weights[start..self.ends[i]])
    }

    /// The rows, each with its first index.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = (usize, &[T])> {
        (0..self.target_dim()).map(|i| self.row(i))
    }

    /// The map of two directions, this one across and `other` along, on coefficients row by row.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Functional, LinearMap};
    /// let mean = LinearMap::from_rows(2, [Functional::new(0, [0.5, 0.5])])?;
    /// assert_eq!(mean.tensor(&LinearMap::identity(2))?.apply(&[1.0, 2.0, 5.0, 8.0])?, [3.0, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "kronecker")]
    pub fn tensor(&self, other: &Self) -> Result<Self> {
        let (m, n) = (self.source_dim, other.source_dim);
        check_entries(m, n)?;
        check_entries(self.target_dim(), other.target_dim())?;
        let mut map = Self::empty(m * n, self.target_dim() * other.target_dim());
        for (i, across) in self.rows() {
            for (j, along) in other.rows() {
                // Whole rows where the weights along wrap.
                let (start, width) = if j + along.len() > n { (0, n) } else { (j, along.len()) };
                let length = across.len().saturating_sub(1) * n + width;
                check_entries(map.weights.len() + length, 1)?;
                map.push(i * n + start, |weights| {
                    let first = weights.len();
                    weights.resize(first + length, T::zero());
                    for (k, share) in across.iter().enumerate() {
                        for (l, weight) in along.iter().enumerate() {
                            weights[first + k * n + wrap(j + l, n) - start] += share.clone() * weight;
                        }
                    }
                });
            }
        }
        Ok(map)
    }

    /// The image of `coeffs`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] if their number is not [`source_dim`](Self::source_dim); [`Error::Ragged`] if they are
    /// rows of different lengths.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, LinearMap};
    /// let identity = LinearMap::identity(2);
    /// assert_eq!(identity.apply(&[1.0, 2.0])?, [1.0, 2.0]);
    /// assert_eq!(identity.apply(&[1.0]), Err(Error::CoefficientCount { expected: 2, found: 1 }));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn apply<C: Coeff<T>>(&self, coeffs: &[C]) -> Result<Vec<C>> {
        self.check_source(coeffs)?;
        Ok(self.images(coeffs).collect())
    }

    /// Writes the image of `coeffs` to `out`, and allocates nothing where coefficients do not: for what is applied again and
    /// again, as while a point is dragged.
    ///
    /// # Errors
    /// Those of [`apply`](Self::apply), and [`Error::CoefficientCount`] if the length of `out` is not
    /// [`target_dim`](Self::target_dim). Then `out` is as it was.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, SplineSpace};
    /// let space = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let raise = space.embedding(&space.elevated(1)?)?;
    /// let mut out = [0.0; 3];
    /// for end in [2.0, 4.0] {
    ///     raise.apply_into(&[0.0, end], &mut out)?;
    ///     assert_eq!(out, [0.0, end / 2.0, end]);
    /// }
    /// let short = raise.apply_into(&[0.0, 1.0], &mut out[..2]);
    /// assert_eq!(short, Err(Error::CoefficientCount { expected: 3, found: 2 }));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn apply_into<C: Coeff<T>>(&self, coeffs: &[C], out: &mut [C]) -> Result<()> {
        self.check_source(coeffs)?;
        if out.len() != self.target_dim() {
            return Err(Error::CoefficientCount { expected: self.target_dim(), found: out.len() });
        }
        out.iter_mut().zip(self.images(coeffs)).for_each(|(place, image)| *place = image);
        Ok(())
    }

    fn check_source<C: Coeff<T>>(&self, coeffs: &[C]) -> Result<()> {
        if coeffs.len() != self.source_dim {
            return Err(Error::CoefficientCount { expected: self.source_dim, found: coeffs.len() });
        }
        check_shapes(coeffs)
    }

    /// The image of `coeffs`, row by row.
    #[inline]
    fn images<C: Coeff<T>>(&self, coeffs: &[C]) -> impl ExactSizeIterator<Item = C> {
        let mut start = 0;
        self.firsts.iter().zip(&self.ends).map(move |(first, end)| {
            let weights = &self.weights[start..*end];
            start = *end;
            weigh(*first, weights, coeffs)
        })
    }

    /// The map `self ∘ first`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] if `first` does not give as many coefficients as `self` takes.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// // The second derivative of a quadratic is one map.
    /// let space = SplineSpace::bezier(2, 0.0, 1.0)?;
    /// let twice = space.derivative_space()?.differentiation()?.after(&space.differentiation()?)?;
    /// assert_eq!(twice.row(0), (0, &[2.0, -4.0, 2.0][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn after(&self, first: &Self) -> Result<Self> {
        if first.target_dim() != self.source_dim {
            return Err(Error::CoefficientCount { expected: self.source_dim, found: first.target_dim() });
        }
        if first.is_identity() {
            return Ok(self.clone());
        }
        let mut gather = Gather::new(first.source_dim);
        let mut composed = Self::empty(first.source_dim, self.target_dim());
        for (start, weights) in self.rows() {
            for (k, w) in weights.iter().enumerate() {
                let (inner, factors) = first.row(wrap(start + k, self.source_dim));
                factors.iter().enumerate().for_each(|(l, f)| gather.add(inner + l, w.clone() * f));
            }
            composed.push_with(|weights| gather.drain_into(weights));
        }
        Ok(composed)
    }

    fn is_identity(&self) -> bool {
        let keeps = |(i, row): (usize, (usize, &[T]))| row.0 == i && *row.1 == [T::one()];
        self.target_dim() == self.source_dim && self.rows().enumerate().all(keeps)
    }

    /// The functional `functional ∘ self`: what `functional` sees of the coefficients before the map.
    ///
    /// # Panics
    /// If the map has no rows.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// // The slope at 1/2, as a functional of the coefficients of a quadratic.
    /// let space = SplineSpace::bezier(2, 0.0, 1.0)?;
    /// let slope = space.differentiation()?.pull_back(&space.derivative_space()?.basis(&0.5)?);
    /// assert_eq!(slope.weights(), [-1.0, 0.0, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn pull_back(&self, functional: &Functional<T>) -> Functional<T> {
        let mut gather = Gather::new(self.source_dim);
        for (k, w) in functional.weights().iter().enumerate() {
            let (first, factors) = self.row((functional.first() + k) % self.target_dim());
            factors.iter().enumerate().for_each(|(l, f)| gather.add(first + l, w.clone() * f));
        }
        let mut weights = Vec::new();
        let first = gather.drain_into(&mut weights);
        Functional::new(first, weights)
    }

    /// The transposed map.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let slope = SplineSpace::bezier(1, 0.0, 0.5)?.differentiation()?;
    /// assert_eq!(slope.transpose().apply(&[1.0])?, [-2.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn transpose(&self) -> Self {
        let mut columns: Vec<Vec<(usize, &T)>> = vec![Vec::new(); self.source_dim];
        for (i, (first, weights)) in self.rows().enumerate() {
            for (k, w) in weights.iter().enumerate() {
                columns[wrap(first + k, self.source_dim)].push((i, w));
            }
        }
        let mut gather = Gather::new(self.target_dim());
        let mut transposed = Self::empty(self.target_dim(), self.source_dim);
        for column in columns {
            column.into_iter().for_each(|(i, w)| gather.add(i, w.clone()));
            transposed.push_with(|weights| gather.drain_into(weights));
        }
        transposed
    }

    /// The dense matrix, `target_dim` by `source_dim`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for more than [`MAX_ENTRIES`](crate::limits::MAX_ENTRIES) entries.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::matrix;
    /// use symspline::SplineSpace;
    /// let slope = SplineSpace::bezier(2, 0.0, 1.0)?.differentiation()?;
    /// assert_eq!(slope.to_matrix()?, matrix![-2.0, 2.0, 0.0; 0.0, -2.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn to_matrix(&self) -> Result<DMatrix<T>> {
        check_entries(self.target_dim(), self.source_dim)?;
        let mut matrix = DMatrix::from_element(self.target_dim(), self.source_dim, T::zero());
        for (i, (first, weights)) in self.rows().enumerate() {
            for (k, w) in weights.iter().enumerate() {
                matrix[(i, (first + k) % self.source_dim)] += w;
            }
        }
        Ok(matrix)
    }
}
