//! The operators of one variable along `u` or along `v`.
//!
//! Along `u` they act on the spline of rows. Along `v` they act the same way on the transposed grid: no operator is
//! written for surfaces.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::limits::check_dim;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::spline::TensorSpline;
use std::fmt;

/// One of the two parameters of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Along the first parameter.
    U,
    /// Along the second parameter.
    V,
}

impl Direction {
    /// The direction across this one.
    pub fn other(self) -> Self {
        match self {
            Self::U => Self::V,
            Self::V => Self::U,
        }
    }
}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::U => "u",
            Self::V => "v",
        })
    }
}

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The space along `direction`.
    pub fn space(&self, direction: Direction) -> &SplineSpace<T> {
        match direction {
            Direction::U => self.u(),
            Direction::V => self.v(),
        }
    }

    /// The surface after `operator`, any operator of one variable, along `direction`.
    ///
    /// # Errors
    /// Those of `operator`; [`CoefficientCount`](crate::Error::CoefficientCount) if it changes the length of rows;
    /// [`TooLarge`](crate::Error::TooLarge), though only after `operator` has run.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction::U, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// let halves = grid.along(U, |rows| rows.inserted(&[0.5]))?;
    /// assert_eq!(halves.coeffs(), [0.0, 1.0, 1.0, 3.0, 2.0, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn along<D: Coeff<T>>(
        &self,
        direction: Direction,
        operator: impl FnOnce(&Spline<T, Row<C>>) -> Result<Spline<T, Row<D>>>,
    ) -> Result<TensorSpline<T, D>> {
        match direction {
            Direction::U => {
                TensorSpline::from_spline_of_rows(operator(&self.spline_of_rows())?, self.v().clone())
            }
            Direction::V => Ok(self.transposed().along(Direction::U, operator)?.transposed()),
        }
    }

    /// Refuses `target` along `direction` if the grid became too large.
    fn check_size(&self, direction: Direction, target: &SplineSpace<T>) -> Result<()> {
        check_dim((self.coeffs().len() / self.space(direction).dim()).saturating_mul(target.dim()))
    }

    /// The curve across `direction` that is left when `functional` has taken in that direction.
    ///
    /// # Errors
    /// Those of `functional`; [`CoefficientCount`](crate::Error::CoefficientCount) if it changes the length of rows.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction::U, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// let means = grid.contracted(U, |rows| rows.integral())?;
    /// assert_eq!(means.coeffs(), [1.0, 3.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn contracted<D: Coeff<T>>(
        &self,
        direction: Direction,
        functional: impl FnOnce(&Spline<T, Row<C>>) -> Result<Row<D>>,
    ) -> Result<Spline<T, D>> {
        match direction {
            Direction::U => Spline::new(self.v().clone(), functional(&self.spline_of_rows())?.0),
            Direction::V => self.transposed().contracted(Direction::U, functional),
        }
    }

    /// The curve on the surface at the parameter `x` in `direction`: `v -> S(x, v)` for `U`, `u -> S(u, x)` for `V`.
    ///
    /// # Errors
    /// [`OutsideDomain`](crate::Error::OutsideDomain).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.isocurve(Direction::V, &0.0)?.coeffs(), [0.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn isocurve(&self, direction: Direction, x: &T) -> Result<Spline<T, C>> {
        self.contracted(direction, |rows| rows.at(x))
    }

    /// The partial derivative, one degree lower along `direction`.
    ///
    /// # Errors
    /// As [`Spline::derivative`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.derivative(Direction::U)?.coeffs(), [2.0, 4.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn derivative(&self, direction: Direction) -> Result<Self> {
        self.along(direction, Spline::derivative)
    }

    /// The partial derivative of order `k` in `u` and `l` in `v`.
    ///
    /// # Errors
    /// As [`Spline::nth_derivative`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.partial(1, 1)?.coeffs(), [2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn partial(&self, k: usize, l: usize) -> Result<Self> {
        let along_u = self.along(Direction::U, |rows| rows.nth_derivative(k))?;
        along_u.along(Direction::V, |rows| rows.nth_derivative(l))
    }

    /// The antiderivative along `direction`, zero at the start of the domain.
    ///
    /// # Errors
    /// As [`Spline::antiderivative`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction, SplineSpace, TensorSpline};
    /// let step = SplineSpace::bezier(0, 0.0, 2.0)?;
    /// let one = TensorSpline::constant(step.clone(), step, 1.0)?;
    /// assert_eq!(one.antiderivative(Direction::V)?.coeffs(), [0.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn antiderivative(&self, direction: Direction) -> Result<Self> {
        self.along(direction, Spline::antiderivative)
    }

    /// The same surface in larger spaces.
    ///
    /// # Errors
    /// As [`Spline::embedded`]; [`TooLarge`](crate::Error::TooLarge).
    ///
    /// # Examples
    /// ```
    /// use symspline::{SplineSpace, TensorSpline};
    /// let [line, parabola] = [1, 2].map(|degree| SplineSpace::bezier(degree, 0.0, 1.0));
    /// let (line, parabola) = (line?, parabola?);
    /// let grid = TensorSpline::new(line.clone(), line.clone(), vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.embedded(&line, &parabola)?.coeffs(), [0.0, 0.5, 1.0, 2.0, 3.5, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn embedded(&self, u: &SplineSpace<T>, v: &SplineSpace<T>) -> Result<Self> {
        check_dim(u.dim().saturating_mul(v.dim()))?;
        self.along(Direction::U, |rows| rows.embedded(u))?.along(Direction::V, |rows| rows.embedded(v))
    }

    /// The same surface with `knots` inserted along `direction`.
    ///
    /// # Errors
    /// As [`Spline::inserted`]; [`TooLarge`](crate::Error::TooLarge).
    pub fn inserted(&self, direction: Direction, knots: &[T]) -> Result<Self> {
        let target = self.space(direction).refined(knots)?;
        self.check_size(direction, &target)?;
        self.along(direction, |rows| rows.embedded(&target))
    }

    /// The same surface, `raise` degrees higher along `direction`.
    ///
    /// # Errors
    /// As [`Spline::elevated`].
    pub fn elevated(&self, direction: Direction, raise: usize) -> Result<Self> {
        self.check_size(direction, &self.space(direction).elevated(raise)?)?;
        self.along(direction, |rows| rows.elevated(raise))
    }

    /// The same surface with clamped ends in both directions.
    ///
    /// # Errors
    /// As [`Spline::clamped_ends`].
    pub fn clamped_ends(&self) -> Result<Self> {
        self.along(Direction::U, Spline::clamped_ends)?.along(Direction::V, Spline::clamped_ends)
    }

    /// The part of the surface from `a` to `b` along `direction`.
    ///
    /// # Errors
    /// As [`Spline::restricted`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.restricted(Direction::U, &0.5, &1.0)?.coeffs(), [1.0, 3.0, 2.0, 5.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn restricted(&self, direction: Direction, a: &T, b: &T) -> Result<Self> {
        self.along(direction, |rows| rows.restricted(a, b))
    }

    /// The two parts of the surface before and after `x` along `direction`.
    ///
    /// # Errors
    /// As [`Spline::split`].
    pub fn split(&self, direction: Direction, x: &T) -> Result<(Self, Self)> {
        let (a, b) = self.space(direction).domain();
        Ok((self.restricted(direction, a, x)?, self.restricted(direction, x, b)?))
    }

    /// The surface run through backwards along `direction`.
    ///
    /// # Errors
    /// As [`Spline::reversed`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let grid = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?;
    /// assert_eq!(grid.reversed(Direction::V)?.coeffs(), [1.0, 0.0, 5.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn reversed(&self, direction: Direction) -> Result<Self> {
        self.along(direction, Spline::reversed)
    }
}
