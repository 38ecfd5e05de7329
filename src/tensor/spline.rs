//! Tensor-product splines: a grid of coefficients over two spaces.

use crate::coeff::{Coeff, check_shapes, replace};
use crate::error::{Error, Result};
use crate::exact::Q;
use crate::limits::check_dim;
use crate::ops::convert::{image, rounded};
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use nalgebra::SVector;

/// A spline of two parameters, `S(u, v) = Σ c_ij N_i(u) M_j(v)`, with coefficients of any kind.
///
/// Coefficients stand row by row in one list, `c_ij` at `i * v.dim() + j`. Either space may be periodic, or both.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{SplineSpace, Surface};
/// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
/// let corners = vec![vector![0.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 1.0]];
/// let saddle = Surface::new(line.clone(), line, corners)?;
/// assert_eq!(saddle.at(&0.5, &0.5)?, vector![0.5, 0.5, 0.25]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct TensorSpline<T, C = T> {
    u: SplineSpace<T>,
    v: SplineSpace<T>,
    coeffs: Vec<C>,
}

/// A spline surface in `N` dimensions.
pub type Surface<T, const N: usize> = TensorSpline<T, SVector<T, N>>;

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The spline with `coeffs`, row by row, over the spaces `u` and `v`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`], [`Error::NotFinite`]; [`Error::TooLarge`] for more than
    /// [`MAX_DIM`](crate::limits::MAX_DIM) coefficients.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let wrong = TensorSpline::new(line.clone(), line, vec![1.0, 2.0, 3.0]);
    /// assert_eq!(wrong.unwrap_err(), Error::CoefficientCount { expected: 4, found: 3 });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn new(u: SplineSpace<T>, v: SplineSpace<T>, coeffs: Vec<C>) -> Result<Self> {
        let expected = u.dim().saturating_mul(v.dim());
        check_dim(expected)?;
        if coeffs.len() != expected {
            return Err(Error::CoefficientCount { expected, found: coeffs.len() });
        }
        check_shapes(&coeffs)?;
        match coeffs.iter().position(|c| !c.all_finite()) {
            Some(index) => Err(Error::NotFinite { what: "coefficient", index }),
            None => Ok(Self { u, v, coeffs }),
        }
    }

    /// The spline with the given rows of coefficients, one row for each coefficient of `u`.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::Ragged`] if a row is not as long as the first.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::from_rows(line.clone(), line.clone(), vec![vec![0.0, 1.0], vec![2.0, 5.0]])?;
    /// assert_eq!(grid.coeffs(), [0.0, 1.0, 2.0, 5.0]);
    /// let ragged = TensorSpline::from_rows(line.clone(), line, vec![vec![0.0, 1.0], vec![2.0]]);
    /// assert_eq!(ragged.unwrap_err(), Error::Ragged { index: 1 });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn from_rows(u: SplineSpace<T>, v: SplineSpace<T>, rows: Vec<Vec<C>>) -> Result<Self> {
        if rows.len() != u.dim() {
            return Err(Error::CoefficientCount { expected: u.dim(), found: rows.len() });
        }
        if let Some(index) = rows.iter().position(|row| row.len() != rows[0].len()) {
            return Err(Error::Ragged { index });
        }
        let mut coeffs = Vec::with_capacity(rows.len().saturating_mul(rows.first().map_or(0, Vec::len)));
        rows.into_iter().for_each(|row| coeffs.extend(row));
        Self::new(u, v, coeffs)
    }

    /// The spline that has the value `value` everywhere.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let one = TensorSpline::constant(SplineSpace::bezier(2, 0.0, 1.0)?, SplineSpace::bezier(1, 0.0, 1.0)?, 1.0)?;
    /// assert_eq!(one.at(&0.25, &0.5)?, 1.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn constant(u: SplineSpace<T>, v: SplineSpace<T>, value: C) -> Result<Self> {
        let count = u.dim().saturating_mul(v.dim());
        check_dim(count)?;
        Self::new(u, v, vec![value; count])
    }

    /// The space in `u`.
    #[inline]
    pub fn u(&self) -> &SplineSpace<T> {
        &self.u
    }

    /// The space in `v`.
    #[inline]
    pub fn v(&self) -> &SplineSpace<T> {
        &self.v
    }

    /// The coefficients, row by row: `c_ij` at `i * v.dim() + j`.
    #[inline]
    pub fn coeffs(&self) -> &[C] {
        &self.coeffs
    }

    /// The coefficients, moved out.
    pub fn into_coeffs(self) -> Vec<C> {
        self.coeffs
    }

    /// Puts new coefficients in the place of others. On an error nothing has changed.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`], [`Error::NotFinite`], [`Error::Ragged`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let mut grid = TensorSpline::new(line.clone(), line, vec![0.0; 4])?;
    /// grid.replace_coeffs(vec![(3, 1.0)])?;
    /// assert_eq!(grid.at(&1.0, &0.5)?, 0.5);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn replace_coeffs(&mut self, new: Vec<(usize, C)>) -> Result<()> {
        replace(&mut self.coeffs, new)
    }

    /// The coefficients of one `u` index each.
    #[inline]
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[C]> {
        self.coeffs.chunks_exact(self.v.dim())
    }

    /// Row `i` of the unrolled space in `u`.
    #[inline]
    pub(crate) fn row(&self, i: usize) -> &[C] {
        let first = self.u.slot(i) * self.v.dim();
        &self.coeffs[first..first + self.v.dim()]
    }

    /// Coefficient `c_ij`, if there is one.
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!((grid.coeff(1, 0), grid.coeff(0, 2)), (Some(&2.0), None));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn coeff(&self, i: usize, j: usize) -> Option<&C> {
        self.rows().nth(i)?.get(j)
    }

    /// The spline `(u, v) -> S(v, u)`: rows and columns exchanged.
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.transposed().coeffs(), [0.0, 2.0, 1.0, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn transposed(&self) -> Self {
        let coeffs = transposed(&self.coeffs, self.v.dim());
        Self { u: self.v.clone(), v: self.u.clone(), coeffs }
    }

    /// The same coefficients as a spline in `u` of rows.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Row, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line.clone(), vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.spline_of_rows().at(&0.5)?, Row(vec![1.0, 3.0]));
    /// assert_eq!(TensorSpline::from_spline_of_rows(grid.spline_of_rows(), line)?, grid);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn spline_of_rows(&self) -> Spline<T, Row<C>> {
        let rows = self.rows().map(|row| Row(row.to_vec())).collect();
        Spline::new(self.u.clone(), rows).expect("a grid has finite rows of one length")
    }

    /// The surface whose rows are the coefficients of `rows`, over `v`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless the rows are as long as `v` asks for; [`Error::TooLarge`].
    ///
    /// # Examples
    /// See [`spline_of_rows`](Self::spline_of_rows).
    pub fn from_spline_of_rows(rows: Spline<T, Row<C>>, v: SplineSpace<T>) -> Result<Self> {
        let u = rows.space().clone();
        Self::from_rows(u, v, rows.into_coeffs().into_iter().map(|row| row.0).collect())
    }

    /// The spline over the same spaces with every coefficient replaced.
    pub(crate) fn map_coeffs<D: Coeff<T>>(&self, f: impl Fn(&C) -> D) -> Result<TensorSpline<T, D>> {
        TensorSpline::new(self.u.clone(), self.v.clone(), self.coeffs.iter().map(f).collect())
    }

    /// The same spline over another field, as [`Spline::map_scalars`].
    ///
    /// # Errors
    /// The first error of the conversion, and those of [`SplineSpace::new`] if the converted knots do not serve.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// let exact = grid.map_scalars(|&x| Q::try_from(x))?;
    /// assert_eq!(exact.at(&Q::frac(1, 3), &Q::int(0))?, Q::frac(2, 3));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn map_scalars<U: Scalar>(
        &self,
        mut convert: impl FnMut(&T) -> Result<U>,
    ) -> Result<TensorSpline<U, C::Over<U>>> {
        let (u, v) = (self.u.map_scalars(&mut convert)?, self.v.map_scalars(&mut convert)?);
        let coeffs = self.coeffs.iter().map(|c| c.try_map(&mut convert)).collect::<Result<_>>()?;
        TensorSpline::new(u, v, coeffs)
    }
}

/// A grid of `columns` columns, column after column.
pub(crate) fn transposed<X: Clone>(grid: &[X], columns: usize) -> Vec<X> {
    let mut turned = Vec::with_capacity(grid.len());
    (0..columns).for_each(|j| turned.extend(grid[j..].iter().step_by(columns).cloned()));
    turned
}

impl<C: Coeff<f64>> TensorSpline<f64, C> {
    /// The same spline over the rationals, without loss, as [`Spline::to_exact`].
    ///
    /// # Errors
    /// As [`Spline::to_exact`].
    pub fn to_exact(&self) -> Result<TensorSpline<Q, C::Over<Q>>> {
        self.map_scalars(image)
    }
}

impl<C: Coeff<Q>> TensorSpline<Q, C> {
    /// The same spline with knots and coefficients correctly rounded, as [`Spline::to_f64`].
    ///
    /// # Errors
    /// As [`Spline::to_f64`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let grid = TensorSpline::constant(line.clone(), line, Q::frac(1, 3))?;
    /// assert_eq!(grid.to_f64()?.at(&0.5, &0.5)?, 1.0 / 3.0);
    /// assert_ne!(grid.to_f64()?.to_exact()?, grid);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn to_f64(&self) -> Result<TensorSpline<f64, C::Over<f64>>> {
        self.map_scalars(rounded)
    }
}
