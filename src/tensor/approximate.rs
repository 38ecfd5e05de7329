//! Approximation of surfaces: the operators of one variable along `u` and along `v`, bounds added up.
//!
//! A row is as far off as its worst entry, and a surface lies between its coefficients: so the bound for the spline of
//! rows bounds the surface.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::ops::bound::{Approximation, check_tolerance, largest, left_of, sum_above};
use crate::ops::project::Contact;
use crate::ops::zone::Zone;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::TensorSpline;

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The surface after `operator`, any approximating operator of one variable, along `direction`.
    ///
    /// # Errors
    /// Those of `operator`; [`CoefficientCount`](crate::Error::CoefficientCount) if it changes the length of rows.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction::U, Q, Scalar, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(2))?;
    /// let grid = TensorSpline::new(line.clone(), line, [0, 1, 2, 5].map(Q::int).to_vec())?;
    /// let fine = grid.inserted(U, &[Q::int(1)])?;
    /// let back = fine.approximated_along(U, |rows| rows.removed(&Q::int(1), 1, &Q::int(0)))?;
    /// assert_eq!((back.spline, back.bound), (grid, Q::int(0)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn approximated_along(
        &self,
        direction: Direction,
        operator: impl FnOnce(&Spline<T, Row<C>>) -> Result<Approximation<Spline<T, Row<C>>, T>>,
    ) -> Result<Approximation<Self, T>> {
        let mut bound = T::zero();
        let spline = self.along(direction, |rows| {
            let near = operator(rows)?;
            bound = near.bound;
            Ok(near.spline)
        })?;
        Ok(Approximation { spline, bound })
    }

    /// The surface after an approximating operator along `u` and another along `v`.
    fn approximated_twice(
        &self,
        along_u: impl FnOnce(&Spline<T, Row<C>>) -> Result<Approximation<Spline<T, Row<C>>, T>>,
        along_v: impl FnOnce(&Spline<T, Row<C>>, &T) -> Result<Approximation<Spline<T, Row<C>>, T>>,
    ) -> Result<Approximation<Self, T>> {
        let first = self.approximated_along(U, along_u)?;
        let second = first.spline.approximated_along(V, |rows| along_v(rows, &first.bound))?;
        Ok(Approximation { spline: second.spline, bound: sum_above(first.bound, &second.bound) })
    }

    /// The surface over `u` and `v` with the least `∬ |S - R|²`, free at its boundary.
    ///
    /// # Errors
    /// As [`Spline::projected`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, SplineSpace, TensorSpline};
    /// let [line, parabola] = [1, 2].map(|degree| SplineSpace::bezier(degree, Q::int(0), Q::int(1)));
    /// let (line, parabola) = (line?, parabola?);
    /// let square = TensorSpline::new(parabola.clone(), line.clone(), [0, 0, 0, 0, 1, 1].map(Q::int).to_vec())?;
    /// let plane = square.projected(&line, &line)?;
    /// assert_eq!(plane.spline.at(&Q::int(0), &Q::int(1))?, Q::frac(-1, 6));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn projected(&self, u: &SplineSpace<T>, v: &SplineSpace<T>) -> Result<Approximation<Self, T>> {
        self.approximated_twice(
            |rows| rows.projected(u, Contact::FREE),
            |rows, _| rows.projected(v, Contact::FREE),
        )
    }

    /// The surface without the knots in a rectangle that it can do without, and as it is outside the rectangle between the
    /// corners `from` and `to`, as [`Spline::without_spare_knots_on`].
    ///
    /// A knot of one direction is one of the whole surface: it goes if nothing changes in the columns that reach beyond the
    /// rectangle, over inexact fields but for rounding. Half of the tolerance is for `u`, and what that leaves for `v`.
    ///
    /// # Errors
    /// As [`Spline::without_spare_knots_on`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction::U, Q, Scalar, SplineSpace, TensorSpline};
    /// let line = SplineSpace::clamped(1, (0..4).map(Q::int))?;
    /// let grid = TensorSpline::new(line.clone(), line, (0..16).map(|i| Q::int(i * i % 5)).collect())?;
    /// let fine = grid.inserted(U, &[Q::frac(3, 2)])?;
    /// let (from, to) = ((Q::int(1), Q::int(0)), (Q::int(2), Q::int(1)));
    /// assert_eq!(fine.without_spare_knots_on(&from, &to, &Q::int(0))?.spline, grid);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "knot removal")]
    pub fn without_spare_knots_on(
        &self,
        from: &(T, T),
        to: &(T, T),
        tolerance: &T,
    ) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        let half = tolerance.clone() * T::frac(1, 2);
        let first = self.thinned_along(U, (&from.0, &to.0), (&from.1, &to.1), &half)?;
        let rest = left_of(tolerance, &first.bound);
        let second = first.spline.thinned_along(V, (&from.1, &to.1), (&from.0, &to.0), &rest)?;
        let bound = sum_above(first.bound, &second.bound);
        // Rounding up may not pass what is certain.
        let bound = if bound < *tolerance { bound } else { tolerance.clone() };
        Ok(Approximation { spline: second.spline, bound })
    }

    /// Without spare knots along `direction`, changed between `own` in it and between `other` in the other one.
    fn thinned_along(
        &self,
        direction: Direction,
        own: (&T, &T),
        other: (&T, &T),
        tolerance: &T,
    ) -> Result<Approximation<Self, T>> {
        let space = match direction {
            U => self.v(),
            V => self.u(),
        };
        let (t, p) = (space.knots(), space.degree());
        let period = space.is_periodic().then(|| space.length());
        let across = Zone::<T, C>::of(space, other, &|_| T::zero());
        let reaches_out: Vec<bool> =
            (0..space.dim()).map(|j| !across.holds((&t[j], &t[j + p + 1]), period.as_ref())).collect();
        let beyond =
            |row: &Row<C>| largest(row.iter().zip(&reaches_out).filter(|(_, out)| **out).map(|(c, _)| c));
        self.approximated_along(direction, |rows| rows.thinned_in(tolerance, own, &beyond))
    }

    /// The same surface with the lowest degrees, and the fewest knots of those degrees, as [`Spline::simplified`].
    ///
    /// # Errors
    /// As [`Spline::simplified`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Direction, Q, Scalar, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(2))?;
    /// let grid = TensorSpline::new(line.clone(), line, [0, 1, 2, 5].map(Q::int).to_vec())?;
    /// let same = grid.elevated(Direction::U, 2)?.inserted(Direction::V, &[Q::int(1)])?;
    /// assert_eq!(same.simplified()?, grid);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn simplified(&self) -> Result<Self> {
        self.along(U, Spline::simplified)?.along(V, Spline::simplified)
    }

    /// Nearly the same surface with lower degrees and fewer knots, within `tolerance`: half of it is for `u`, and what
    /// that leaves for `v`.
    ///
    /// # Errors
    /// As [`Spline::simplified_within`].
    pub fn simplified_within(&self, tolerance: &T) -> Result<Approximation<Self, T>> {
        check_tolerance(tolerance)?;
        let half = tolerance.clone() * T::frac(1, 2);
        let mut near = self.approximated_twice(
            |rows| rows.simplified_within(&half),
            |rows, used| rows.simplified_within(&left_of(tolerance, used)),
        )?;
        if near.bound > *tolerance {
            // Rounding up may not pass what is certain.
            near.bound = tolerance.clone();
        }
        Ok(near)
    }
}
