//! The linear operators of splines by name, on rational ones: they act on the lifted spline and change no value, so that
//! nothing needs to be proved again.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::rational::domain::{Interval, Rectangle};
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;

impl<T: Scalar, C: Coeff<T>> Rational<Interval, T, C> {
    /// The same spline in a larger space.
    ///
    /// # Errors
    /// As [`Spline::embedded`](crate::Spline::embedded).
    pub fn embedded(&self, target: &SplineSpace<T>) -> Result<Self> {
        Self::known(self.lifted().embedded(target)?)
    }

    /// The same spline with `knots` inserted.
    ///
    /// # Errors
    /// As [`Spline::inserted`](crate::Spline::inserted).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, RationalFunction, Scalar, SplineSpace};
    /// let space = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let f = RationalFunction::new(space, [0, 1].map(Q::int).to_vec(), [1, 3].map(Q::int).to_vec())?;
    /// let halves = f.inserted(&[Q::frac(1, 2)])?;
    /// assert_eq!(halves.points()?, [Q::int(0), Q::frac(3, 4), Q::int(1)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn inserted(&self, knots: &[T]) -> Result<Self> {
        Self::known(self.lifted().inserted(knots)?)
    }

    /// The same spline, `raise` degrees higher.
    ///
    /// # Errors
    /// As [`Spline::elevated`](crate::Spline::elevated).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, RationalFunction, Scalar, SplineSpace};
    /// let space = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let f = RationalFunction::new(space, [0, 1].map(Q::int).to_vec(), [1, 3].map(Q::int).to_vec())?;
    /// assert_eq!(f.elevated(1)?.points()?, [Q::int(0), Q::frac(3, 4), Q::int(1)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn elevated(&self, raise: usize) -> Result<Self> {
        Self::known(self.lifted().elevated(raise)?)
    }

    /// The same spline with clamped ends; a periodic one is opened.
    ///
    /// # Errors
    /// As [`Spline::clamped_ends`](crate::Spline::clamped_ends).
    pub fn clamped_ends(&self) -> Result<Self> {
        Self::known(self.lifted().clamped_ends()?)
    }

    /// The part from `a` to `b`, with clamped ends.
    ///
    /// # Errors
    /// As [`Spline::restricted`](crate::Spline::restricted).
    pub fn restricted(&self, a: &T, b: &T) -> Result<Self> {
        Self::known(self.lifted().restricted(a, b)?)
    }

    /// The two parts before and after `x`.
    ///
    /// # Errors
    /// As [`Spline::split`](crate::Spline::split).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, circle};
    /// let unit = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
    /// let (upper, lower) = unit.split(&Q::frac(1, 2))?;
    /// assert_eq!(upper.at(&Q::frac(1, 2))?, lower.at(&Q::frac(1, 2))?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn split(&self, x: &T) -> Result<(Self, Self)> {
        let (a, b) = self.domain();
        Ok((self.restricted(a, x)?, self.restricted(x, b)?))
    }

    /// The spline `x -> f(a + b - x)` on the same domain `[a, b]`.
    ///
    /// # Errors
    /// As [`Spline::reversed`](crate::Spline::reversed).
    pub fn reversed(&self) -> Result<Self> {
        Self::known(self.lifted().reversed()?)
    }

    /// The same spline over `[start, end]`, its parameter changed by the affine map; see also
    /// [`moebius`](Self::moebius).
    ///
    /// # Errors
    /// As [`Spline::reparametrised`](crate::Spline::reparametrised).
    pub fn reparametrised(&self, start: &T, end: &T) -> Result<Self> {
        Self::known(self.lifted().reparametrised(start, end)?)
    }
}

impl<T: Scalar, C: Coeff<T>> Rational<Rectangle, T, C> {
    /// The same surface in larger spaces.
    ///
    /// # Errors
    /// As [`TensorSpline::embedded`](crate::TensorSpline::embedded).
    pub fn embedded(&self, u: &SplineSpace<T>, v: &SplineSpace<T>) -> Result<Self> {
        Self::known(self.lifted().embedded(u, v)?)
    }

    /// The same surface with `knots` inserted along `direction`.
    ///
    /// # Errors
    /// As [`TensorSpline::inserted`](crate::TensorSpline::inserted).
    pub fn inserted(&self, direction: Direction, knots: &[T]) -> Result<Self> {
        Self::known(self.lifted().inserted(direction, knots)?)
    }

    /// The same surface, `raise` degrees higher along `direction`.
    ///
    /// # Errors
    /// As [`TensorSpline::elevated`](crate::TensorSpline::elevated).
    pub fn elevated(&self, direction: Direction, raise: usize) -> Result<Self> {
        Self::known(self.lifted().elevated(direction, raise)?)
    }

    /// The same surface with clamped ends in both directions.
    ///
    /// # Errors
    /// As [`TensorSpline::clamped_ends`](crate::TensorSpline::clamped_ends).
    pub fn clamped_ends(&self) -> Result<Self> {
        Self::known(self.lifted().clamped_ends()?)
    }

    /// The part from `a` to `b` along `direction`.
    ///
    /// # Errors
    /// As [`TensorSpline::restricted`](crate::TensorSpline::restricted).
    pub fn restricted(&self, direction: Direction, a: &T, b: &T) -> Result<Self> {
        Self::known(self.lifted().restricted(direction, a, b)?)
    }

    /// The two parts before and after `x` along `direction`.
    ///
    /// # Errors
    /// As [`TensorSpline::split`](crate::TensorSpline::split).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction::U, NurbsSurface, Q, Scalar, SplineSpace};
    /// use nalgebra::vector;
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let points = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[x, y]| vector![Q::int(x), Q::int(y)]).to_vec();
    /// let patch = NurbsSurface::new(line.clone(), line, points, [1, 1, 1, 3].map(Q::int).to_vec())?;
    /// let (before, after) = patch.split(U, &Q::frac(1, 2))?;
    /// assert_eq!(before.at(&Q::frac(1, 2), &Q::int(1))?, vector![Q::frac(3, 4), Q::int(1)]);
    /// assert_eq!(after.u().domain(), (&Q::frac(1, 2), &Q::int(1)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn split(&self, direction: Direction, x: &T) -> Result<(Self, Self)> {
        let (before, after) = self.lifted().split(direction, x)?;
        Ok((Self::known(before)?, Self::known(after)?))
    }

    /// The surface run through backwards along `direction`.
    ///
    /// # Errors
    /// As [`TensorSpline::reversed`](crate::TensorSpline::reversed).
    pub fn reversed(&self, direction: Direction) -> Result<Self> {
        Self::known(self.lifted().reversed(direction)?)
    }

    /// The surface `(u, v) -> S(v, u)`.
    ///
    /// # Errors
    /// None for a valid surface.
    pub fn transposed(&self) -> Result<Self> {
        Self::known(self.lifted().transposed())
    }
}
