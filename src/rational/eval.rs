//! Values, derivatives and basis functions of rational splines.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::rational::domain::{Interval, Rectangle};
use crate::rational::quotient::quotients;
use crate::rational::spline::{NurbsSurface, Rational};
use crate::row::Row;
use crate::scalar::{Real, Scalar};
use crate::tensor::form::{QuadraticForm, first_form, second_form};
use crate::vector::{cross3, unit_cross};
use crate::weighted::Weighted;
use nalgebra::SVector;

impl<T: Scalar, C: Coeff<T>> Rational<Interval, T, C> {
    /// The value at `x`, as [`Spline::at`](crate::Spline::at).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    #[inline]
    pub fn at(&self, x: &T) -> Result<C> {
        Ok(self.lifted().at(x)?.project())
    }

    /// The left limit at `x`, as [`Spline::at_left`](crate::Spline::at_left).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn at_left(&self, x: &T) -> Result<C> {
        Ok(self.lifted().at_left(x)?.project())
    }

    /// The values at many parameters, as [`Spline::eval`](crate::Spline::eval).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{RationalFunction, SplineSpace};
    /// let f = RationalFunction::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![0.0, 1.0], vec![1.0, 3.0])?;
    /// assert_eq!(f.eval(&[0.0, 0.5, 1.0])?, [0.0, 0.75, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn eval(&self, parameters: &[T]) -> Result<Vec<C>> {
        Ok(self.lifted().eval(parameters)?.iter().map(Weighted::project).collect())
    }

    /// Value and derivatives of orders `0 ..= order` at `x`, from the right, by the quotient rule [NURBS, section 4.3].
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, RationalFunction, Scalar};
    /// let [one, x] = [0, 1].map(|power| Function::monomial(power, Q::int(1), Q::int(2)));
    /// let inverse = RationalFunction::from_quotient(&one?, &x?)?;
    /// assert_eq!(inverse.derivatives_at(&Q::int(1), 3)?, [1, -1, 2, -6].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn derivatives_at(&self, x: &T, order: usize) -> Result<Vec<C>> {
        let lifted = self.lifted().derivatives_at(x, order)?;
        let columns: Vec<_> = lifted.into_iter().map(|derivative| vec![derivative]).collect();
        Ok(quotients(&columns).into_iter().flatten().collect())
    }

    /// The rational basis functions `R_i = w_i N_i / Σ w_j N_j` and their derivatives of orders `0 ..= order` at `x`, as
    /// functionals of the control points.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{RationalFunction, SplineSpace};
    /// let f = RationalFunction::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![5.0, 7.0], vec![1.0, 3.0])?;
    /// assert_eq!(f.basis_derivatives(&0.5, 0)?[0].weights(), [0.25, 0.75]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn basis_derivatives(&self, x: &T, order: usize) -> Result<Vec<Functional<T>>> {
        let basis = self.space().basis_derivatives(x, order)?;
        let first = basis[0].first();
        let weight = |i: usize| &self.lifted().coeffs()[self.space().slot(first + i)].weight;
        let lifted = |functional: &Functional<T>| {
            let shares = functional.weights().iter().enumerate().map(|(i, n)| n.clone() * weight(i));
            let point = Row(shares.collect::<Vec<T>>());
            let weight = point.iter().fold(T::zero(), |sum, share| sum + share);
            vec![Weighted { point, weight }]
        };
        let columns: Vec<_> = basis.iter().map(lifted).collect();
        Ok(quotients(&columns).into_iter().flatten().map(|row| Functional::new(first, row.0)).collect())
    }
}

impl<T: Scalar, C: Coeff<T>> Rational<Rectangle, T, C> {
    /// The value at `(u, v)`, as [`TensorSpline::at`](crate::TensorSpline::at).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    #[inline]
    pub fn at(&self, u: &T, v: &T) -> Result<C> {
        Ok(self.lifted().at(u, v)?.project())
    }

    /// The values at many points, as [`TensorSpline::eval`](crate::TensorSpline::eval).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn eval(&self, points: &[(T, T)]) -> Result<Vec<C>> {
        Ok(self.lifted().eval(points)?.iter().map(Weighted::project).collect())
    }

    /// The values on a grid, as [`TensorSpline::eval_grid`](crate::TensorSpline::eval_grid).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::TooLarge`].
    pub fn eval_grid(&self, us: &[T], vs: &[T]) -> Result<Vec<C>> {
        Ok(self.lifted().eval_grid(us, vs)?.iter().map(Weighted::project).collect())
    }

    /// All partial derivatives up to `order` in each direction, as [`TensorSpline::derivatives_at`](crate::TensorSpline::derivatives_at), by the quotient rule
    /// [NURBS, section 4.5].
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{NurbsSurface, SplineSpace};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let corners = vec![vector![0.0, 0.0], vector![0.0, 1.0], vector![1.0, 0.0], vector![1.0, 1.0]];
    /// let patch = NurbsSurface::new(line.clone(), line, corners, vec![1.0; 4])?;
    /// assert_eq!(patch.derivatives_at(&0.5, &0.5, 1)?[1][0], vector![1.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn derivatives_at(&self, u: &T, v: &T, order: usize) -> Result<Vec<Vec<C>>> {
        Ok(quotients(&self.lifted().derivatives_at(u, v, order)?))
    }

    /// The value and the first derivatives at `(u, v)`: `[S, S_u, S_v]`, as [`TensorSpline::tangents_at`](crate::TensorSpline::tangents_at).
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn tangents_at(&self, u: &T, v: &T) -> Result<[C; 3]> {
        let [value, along_u, along_v] = self.lifted().tangents_at(u, v)?;
        let (point, inverse) = (value.project(), T::one() / value.weight);
        let tangent = |derivative: Weighted<T, C>| {
            let mut tangent = derivative.point;
            tangent.add_scaled(&-derivative.weight, &point);
            tangent.scaled(&inverse)
        };
        let tangents = [tangent(along_u), tangent(along_v)];
        let [along_u, along_v] = tangents;
        Ok([point, along_u, along_v])
    }
}

impl<T: Scalar, const N: usize> NurbsSurface<T, N> {
    /// The first fundamental form at a point.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn first_form_at(&self, u: &T, v: &T) -> Result<QuadraticForm<T>> {
        let [_, along_u, along_v] = self.tangents_at(u, v)?;
        Ok(first_form(&along_u, &along_v))
    }
}

impl<T: Scalar> NurbsSurface<T, 3> {
    /// The normal `S_u × S_v` at a point, not of unit length.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn normal_at(&self, u: &T, v: &T) -> Result<SVector<T, 3>> {
        let [_, along_u, along_v] = self.tangents_at(u, v)?;
        Ok(cross3(&along_u, &along_v))
    }
}

impl<T: Real> NurbsSurface<T, 3> {
    /// The unit normal at a point.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::NoNormal`] where `S_u × S_v` vanishes.
    pub fn unit_normal_at(&self, u: &T, v: &T) -> Result<SVector<T, 3>> {
        let [_, along_u, along_v] = self.tangents_at(u, v)?;
        unit_cross(&along_u, &along_v).ok_or_else(|| Error::no_normal(u, v))
    }

    /// The second fundamental form at a point.
    ///
    /// # Errors
    /// As [`unit_normal_at`](Self::unit_normal_at).
    pub fn second_form_at(&self, u: &T, v: &T) -> Result<QuadraticForm<T>> {
        second_form(&self.derivatives_at(u, v, 2)?).ok_or_else(|| Error::no_normal(u, v))
    }
}
