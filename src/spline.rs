//! Splines: coefficients in a space.

use crate::coeff::{Coeff, check_shapes, replace};
use crate::error::{Error, Result};
use crate::limits::check_degree;
use crate::polar::polar_value;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::window::derivatives;
use nalgebra::SVector;

/// A spline `f(x) = Σ c_i N_i(x)` with coefficients `c_i` of any kind.
///
/// - A parameter outside the domain is an error, one rounding outside too.
/// - Values are right limits inside the domain and the left limit at its end; [`at_left`](Self::at_left) gives the
///   other side of a jump.
/// - Two splines are equal (`==`) if space and coefficients are; [`same_function`](Self::same_function) compares
///   what they describe.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Curve, SplineSpace};
/// let space = SplineSpace::clamped(2, [0.0, 1.0, 2.0])?;
/// let curve = Curve::new(space, vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![3.0, 2.0], vector![4.0, 0.0]])?;
/// assert_eq!(curve.at(&1.0)?, vector![2.0, 2.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Spline<T, C = T> {
    space: SplineSpace<T>,
    coeffs: Vec<C>,
}

/// A scalar spline.
pub type Function<T> = Spline<T, T>;

/// A spline curve in `N` dimensions.
pub type Curve<T, const N: usize> = Spline<T, SVector<T, N>>;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The spline with `coeffs` in `space`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`], [`Error::Ragged`] if coefficients are rows of different lengths, [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, SplineSpace};
    /// let space = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let wrong = Function::new(space, vec![1.0]);
    /// assert_eq!(wrong.unwrap_err(), Error::CoefficientCount { expected: 2, found: 1 });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn new(space: SplineSpace<T>, coeffs: Vec<C>) -> Result<Self> {
        if coeffs.len() != space.dim() {
            return Err(Error::CoefficientCount { expected: space.dim(), found: coeffs.len() });
        }
        check_shapes(&coeffs)?;
        // Most often all are finite: look at all of them without a branch first.
        if coeffs.iter().fold(true, |all, c| all & c.all_finite()) {
            return Ok(Self { space, coeffs });
        }
        let index = coeffs.iter().position(|c| !c.all_finite());
        Err(Error::NotFinite { what: "coefficient", index: index.expect("some coefficient is not finite") })
    }

    /// The spline that has the value `value` all over `space`.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// assert_eq!(Function::constant(SplineSpace::bezier(3, 0.0, 1.0)?, 7.0)?.at(&0.3)?, 7.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn constant(space: SplineSpace<T>, value: C) -> Result<Self> {
        let coeffs = vec![value; space.dim()];
        Self::new(space, coeffs)
    }

    /// The space.
    #[inline]
    pub fn space(&self) -> &SplineSpace<T> {
        &self.space
    }

    /// The degree.
    #[inline]
    pub fn degree(&self) -> usize {
        self.space.degree()
    }

    /// Start and end of the domain.
    #[inline]
    pub fn domain(&self) -> (&T, &T) {
        self.space.domain()
    }

    /// The coefficients, of a curve its control points.
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
    /// let mut f = symspline::Function::monomial(1, 0.0, 1.0)?;
    /// f.replace_coeffs(vec![(1, 5.0)])?;
    /// assert_eq!(f.coeffs(), [0.0, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn replace_coeffs(&mut self, new: Vec<(usize, C)>) -> Result<()> {
        replace(&mut self.coeffs, new)
    }

    /// Coefficient `i` of the unrolled space.
    pub(crate) fn coeff(&self, i: usize) -> &C {
        &self.coeffs[self.space.slot(i)]
    }

    /// The value at `x`: the right limit, at the end of the domain the left one.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    #[inline]
    pub fn at(&self, x: &T) -> Result<C> {
        Ok(self.on_span(self.space.locate(x)?, x))
    }

    /// As [`at`](Self::at), starting the search for the span at `span`, which becomes the span of `x`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; then `span` stays.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let line = Function::monomial(1, 0.0, 1.0)?;
    /// let mut span = 0;
    /// assert_eq!(line.at_near(&0.25, &mut span)?, 0.25);
    /// assert_eq!(line.at_near(&0.75, &mut span)?, 0.75);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[inline]
    pub fn at_near(&self, x: &T, span: &mut usize) -> Result<C> {
        *span = self.space.locate_near(x, *span)?;
        Ok(self.on_span(*span, x))
    }

    /// The left limit at `x`; at the start of an open domain the right one, at the seam the one from the far end.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let step = Function::new(SplineSpace::clamped(0, [0.0, 1.0, 2.0])?, vec![3.0, 5.0])?;
    /// assert_eq!((step.at_left(&1.0)?, step.at(&1.0)?), (3.0, 5.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn at_left(&self, x: &T) -> Result<C> {
        let (a, b) = self.domain();
        let x = if self.space.is_periodic() && x == a { b } else { x };
        Ok(self.on_span(self.space.locate_left(x)?, x))
    }

    /// Value and derivatives of orders `0 ..= order` at `x`, from the right; beyond the degree they are zero.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let square = Function::new(SplineSpace::bezier(2, 0.0, 1.0)?, vec![0.0, 0.0, 1.0])?;
    /// assert_eq!(square.derivatives_at(&0.5, 3)?, [0.25, 1.0, 2.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn derivatives_at(&self, x: &T, order: usize) -> Result<Vec<C>> {
        check_degree(order)?;
        Ok(self.derivatives_on(self.space.locate(x)?, x, order))
    }

    /// The derivative of order `order` at `x`, from the right.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// assert_eq!(Function::monomial(2, 0.0, 1.0)?.derivative_at(&0.5, 1)?, 1.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn derivative_at(&self, x: &T, order: usize) -> Result<C> {
        check_degree(order)?;
        let derivatives = self.derivatives_on(self.space.locate(x)?, x, order);
        Ok(derivatives.into_iter().next_back().expect("there is at least the value"))
    }

    /// Value and derivatives at `x` of the polynomial of span `k`.
    pub(crate) fn derivatives_on(&self, k: usize, x: &T, order: usize) -> Vec<C> {
        let window = (k - self.degree()..=k).map(|i| self.coeff(i).clone()).collect();
        derivatives(self.space.knots(), k, window, x, order)
    }

    /// The value at `x` of the polynomial of span `k`.
    #[inline]
    pub(crate) fn on_span(&self, k: usize, x: &T) -> C {
        match self.degree() {
            0 => self.coeff(k).clone(),
            1 => self.on_span_of_order::<2>(k, x),
            2 => self.on_span_of_order::<3>(k, x),
            3 => self.on_span_of_order::<4>(k, x),
            4 => self.on_span_of_order::<5>(k, x),
            5 => self.on_span_of_order::<6>(k, x),
            _ => self.space.basis_on(k, x).apply(&self.coeffs),
        }
    }

    /// [`on_span`](Self::on_span) for `ORDER = p + 1` known to the compiler: nothing is allocated.
    #[inline]
    fn on_span_of_order<const ORDER: usize>(&self, k: usize, x: &T) -> C {
        let mut weights: [T; ORDER] = std::array::from_fn(|_| T::zero());
        polar_value(self.space.knots(), (k, k), |_| x, &mut weights, (k + 1 - ORDER, &self.coeffs))
    }

    /// The spline over the same space with every coefficient replaced.
    pub(crate) fn map_coeffs<D: Coeff<T>>(&self, f: impl Fn(&C) -> D) -> Result<Spline<T, D>> {
        Spline::new(self.space.clone(), self.coeffs.iter().map(f).collect())
    }

    /// The same spline over another field: `knot` converts knots, `component` the scalars of the coefficients.
    ///
    /// # Errors
    /// The first error of either conversion, and those of [`SplineSpace::new`] if the converted knots do not serve.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let f = Function::new(SplineSpace::bezier(1, 0.0, 0.1)?, vec![0.5, 2.0])?;
    /// let exact = f.map_scalars(|&x| Q::try_from(x))?;
    /// assert_eq!(exact.at(&Q::int(0))?, Q::frac(1, 2));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn map_scalars<U: Scalar>(
        &self,
        mut convert: impl FnMut(&T) -> Result<U>,
    ) -> Result<Spline<U, C::Over<U>>> {
        let space = self.space.map_scalars(&mut convert)?;
        let coeffs = self.coeffs.iter().map(|c| c.try_map(&mut convert)).collect::<Result<_>>()?;
        Spline::new(space, coeffs)
    }
}

impl<T: Scalar> Function<T> {
    /// The function `x^power` on `[a, b]`, a single polynomial.
    ///
    /// # Errors
    /// [`Error::DegreeTooHigh`], [`Error::EmptyDomain`], [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// assert_eq!(Function::monomial(2, 1.0, 3.0)?.coeffs(), [1.0, 3.0, 9.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn monomial(power: usize, a: T, b: T) -> Result<Self> {
        let space = SplineSpace::bezier(power, a.clone(), b.clone())?;
        // The polar form of x^power is the product of its arguments.
        let blossom = |j: usize| {
            let factors = std::iter::repeat_n(&a, power - j).chain(std::iter::repeat_n(&b, j));
            factors.fold(T::one(), |product, x| product * x)
        };
        Spline::new(space, (0..=power).map(blossom).collect())
    }
}
