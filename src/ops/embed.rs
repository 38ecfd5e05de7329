//! The same spline in a larger space: knot insertion, degree elevation, clamping, Bezier pieces.
//!
//! Coefficient `j` of a finer space of the same degree is the polar value of the spline at the `p` knots after `j`
//! of that space; one degree higher it is the mean of the `p + 1` polar values that leave out one knot each
//! [Ramshaw, 1989]. Arguments that are knots of both spaces cost nothing, and the others lie between the knots around
//! them, so that every step is a convex combination: nothing is amplified, on whatever knots.
//!
//! Only outer knots may make a step extrapolate, where the target is unclamped and its outer knots are new.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::map::LinearMap;
use crate::ops::elevate::SpanWalk;
use crate::ops::run::Run;
use crate::polar::{polar_value, take_run};
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar> SplineSpace<T> {
    /// The map that gives a spline of this space its coefficients in `target`.
    ///
    /// Linear in the number of knots. Each row sums to one.
    ///
    /// # Errors
    /// Unless `target` [contains](Self::contains) this space: [`DomainMismatch`](crate::Error::DomainMismatch),
    /// [`DegreeTooLow`](crate::Error::DegreeTooLow), [`TooSmooth`](crate::Error::TooSmooth),
    /// [`NotPeriodic`](crate::Error::NotPeriodic).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let coarse = SplineSpace::clamped(1, [0.0, 2.0])?;
    /// let map = coarse.embedding(&SplineSpace::clamped(1, [0.0, 0.5, 2.0])?)?;
    /// assert_eq!(map.apply(&[4.0, 8.0])?, [4.0, 5.0, 8.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn embedding(&self, target: &Self) -> Result<LinearMap<T>> {
        let mut steps = self.embedding_steps(target)?.into_iter();
        let first = steps.next().unwrap_or_else(|| LinearMap::identity(self.dim()));
        steps.try_fold(first, |done, step| step.after(&done))
    }

    /// The embedding as a chain of maps: one a raised degree, one for the knots; none if the spaces are equal.
    fn embedding_steps(&self, target: &Self) -> Result<Vec<LinearMap<T>>> {
        self.check_within(target)?;
        let mut steps = Vec::new();
        let mut space = self.clone();
        while space.degree() < target.degree() {
            let raised = space.elevated(1)?;
            steps.push(space.elevation_rows(&raised));
            space = raised;
        }
        if space != *target {
            steps.push(space.insertion_rows(target));
        }
        Ok(steps)
    }

    /// The rows into a space of the same degree whose domain lies within this one's, and which has every knot of
    /// this one there: each a polar value at the target's own knots.
    pub(crate) fn insertion_rows(&self, target: &Self) -> LinearMap<T> {
        let (p, tau) = (self.degree(), target.knots());
        let mut map = LinearMap::empty(self.dim(), target.dim());
        let (mut args, mut free) = (Vec::with_capacity(p), Vec::with_capacity(p));
        let mut walk = SpanWalk::new(self);
        for j in 0..target.dim() {
            let k = walk.span_right_of(larger(&tau[j], target.domain().0));
            args.clear();
            args.extend(&tau[j + 1..=j + p]);
            map.push_with(|weights| self.polar_into(k, &args, &mut free, weights));
        }
        map
    }

    /// The coefficients in `target` of the spline with `coeffs` here: those of [`insertion_rows`](Self::insertion_rows), in
    /// low degrees without a table.
    pub(crate) fn inserted_coeffs<C: Coeff<T>>(&self, target: &Self, coeffs: &[C]) -> Vec<C> {
        match self.degree() {
            1 => self.inserted_of_order::<2, C>(target, coeffs),
            2 => self.inserted_of_order::<3, C>(target, coeffs),
            3 => self.inserted_of_order::<4, C>(target, coeffs),
            4 => self.inserted_of_order::<5, C>(target, coeffs),
            5 => self.inserted_of_order::<6, C>(target, coeffs),
            _ => self.inserted_by_values(target, coeffs),
        }
    }

    /// [`inserted_coeffs`](Self::inserted_coeffs) as the definition has it: each coefficient a polar value.
    fn inserted_by_values<C: Coeff<T>>(&self, target: &Self, coeffs: &[C]) -> Vec<C> {
        let (p, tau) = (self.degree(), target.knots());
        let mut walk = SpanWalk::new(self);
        let mut weights = vec![T::zero(); p + 1];
        let (mut args, mut free) = (Vec::with_capacity(p), Vec::with_capacity(p));
        let coeff = |j: usize| {
            let k = walk.span_right_of(larger(&tau[j], target.domain().0));
            args.clear();
            args.extend(&tau[j + 1..=j + p]);
            let (lo, hi) = take_run(self.knots(), k, &args, &mut free);
            let arg = |r: usize| free[r];
            polar_value(self.knots(), (lo, hi), arg, &mut weights[..=free.len()], (hi - p, coeffs))
        };
        (0..target.dim()).map(coeff).collect()
    }

    /// [`inserted_coeffs`](Self::inserted_coeffs) for `ORDER = p + 1` known to the compiler.
    fn inserted_of_order<const ORDER: usize, C: Coeff<T>>(&self, target: &Self, coeffs: &[C]) -> Vec<C> {
        let tau = target.knots();
        let k = SpanWalk::new(self).span_right_of(larger(&tau[0], target.domain().0));
        let mut run = Run::<T, ORDER>::new(self.knots(), k, &tau[1..ORDER]);
        let coeff = |j: usize| {
            let value = run.polar(coeffs);
            run.advance(&tau[j + 1], &tau[j + ORDER]);
            value
        };
        (0..target.dim()).map(coeff).collect()
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The same function as a spline of `target`.
    ///
    /// # Errors
    /// As [`SplineSpace::embedding`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function, SplineSpace};
    /// let line = Function::monomial(1, 0.0, 2.0)?;
    /// assert_eq!(line.embedded(&SplineSpace::clamped(2, [0.0, 1.0, 2.0])?)?.coeffs(), [0.0, 0.5, 1.5, 2.0]);
    /// let steps = SplineSpace::clamped(0, [0.0, 1.0, 2.0])?;
    /// assert_eq!(line.embedded(&steps).unwrap_err(), Error::DegreeTooLow { degree: 0, needed: 1 });
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn embedded(&self, target: &SplineSpace<T>) -> Result<Self> {
        self.space().check_within(target)?;
        let raised = self.elevated(target.degree() - self.degree())?;
        if raised.space() == target {
            return Ok(raised);
        }
        Spline::new(target.clone(), raised.space().inserted_coeffs(target, raised.coeffs()))
    }

    /// The same function with `knots` inserted, each as often as it is listed, in any order.
    ///
    /// Computes what [NURBS, A5.1] and A5.4 do, all knots at once and in linear time.
    ///
    /// # Errors
    /// As [`SplineSpace::refined`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let f = Function::new(SplineSpace::bezier(2, 0.0, 1.0)?, vec![0.0, 2.0, 0.0])?;
    /// assert_eq!(f.inserted(&[0.5])?.coeffs(), [0.0, 1.0, 1.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "knot insertion")]
    pub fn inserted(&self, knots: &[T]) -> Result<Self> {
        let target = self.space().refined(knots)?;
        let coeffs = self.space().inserted_coeffs(&target, self.coeffs());
        Spline::new(target, coeffs)
    }

    /// The same function with clamped ends; a periodic one is opened at its seam.
    ///
    /// # Errors
    /// None for a valid spline.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let hat = Function::new(SplineSpace::new(1, [-1.0, 0.0, 1.0, 2.0])?, vec![0.0, 1.0])?;
    /// let ring = Function::new(SplineSpace::periodic(2, [0.0, 1.0, 2.0], 3.0)?, vec![0.0, 2.0, 0.0])?;
    /// assert_eq!(hat.clamped_ends()?.coeffs(), [0.0, 1.0]);
    /// assert_eq!(ring.clamped_ends()?.coeffs(), [1.0, 2.0, 0.0, 0.0, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn clamped_ends(&self) -> Result<Self> {
        self.embedded(&self.space().clamped_ends()?)
    }

    /// The same function with unclamped ends; a periodic one is opened and keeps its unrolled knots.
    ///
    /// For a clamped spline the new outer coefficients extrapolate the end polynomials: in `f64` they lose digits
    /// where the end spans are shorter than the outer knot spacing.
    ///
    /// # Errors
    /// As [`SplineSpace::unclamped_ends`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let ring = Function::new(SplineSpace::periodic(2, [0.0, 1.0, 2.0], 3.0)?, vec![0.0, 2.0, 0.0])?;
    /// assert_eq!(ring.unclamped_ends()?.coeffs(), [0.0, 2.0, 0.0, 0.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn unclamped_ends(&self) -> Result<Self> {
        self.embedded(&self.space().unclamped_ends()?)
    }
}
