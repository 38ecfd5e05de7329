//! Constraints along curves on a surface.

use crate::constrain::sparse::SparseRow;
use crate::error::{Error, Result};
use crate::limits::check_dim;
use crate::scalar::Scalar;
use crate::shape::constraints::Constraints;
use crate::shape::controlled::Controlled;
use crate::space::{SplineSpace, even};
use crate::spline::Curve;
use crate::tensor::along::Direction;

impl<T: Scalar> SplineSpace<T> {
    /// So many parameters at equal distances, from the start to the end of the domain; of a ring the end is left out. One
    /// alone is the start.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`] for none; [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// assert_eq!(SplineSpace::bezier(2, 0.0, 1.0)?.even_parameters(3)?, [0.0, 0.5, 1.0]);
    /// assert_eq!(SplineSpace::uniform_periodic(2, 3, 0.0, 1.0)?.even_parameters(2)?, [0.0, 0.5]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn even_parameters(&self, count: usize) -> Result<Vec<T>> {
        check_dim(count)?;
        if count == 0 {
            return Err(Error::TooFewPoints { expected: 1, found: 0 });
        }
        let (a, b) = self.domain();
        let steps = if self.is_periodic() { count } else { (count - 1).max(1) };
        Ok((0..count).map(|i| even(a, b, i, steps)).collect())
    }
}

impl<T: Scalar, S: Controlled<T, Parameter = (T, T), Order = (usize, usize)>> Constraints<'_, T, S> {
    /// The whole curve at the parameter `x` in `direction`: one constraint for each of its control points, along the other
    /// parameter. What is given for them are control points or changes of these.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::NotFinite`] for a control point of a rational isocurve at infinity.
    ///
    /// # Examples
    /// One edge of a surface is bent while the opposite one stays:
    /// ```
    /// use symspline::{Constraints, Direction, Q, Scalar, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(2, Q::int(0), Q::int(1))?;
    /// let mut plane = TensorSpline::constant(line.clone(), line, Q::int(0))?;
    /// let edges = Constraints::on(&plane).isocurve(Direction::U, &Q::int(0))?.isocurve(Direction::U, &Q::int(1))?;
    /// edges.prepare()?.meet(&mut plane, &[0, 0, 0, 0, 1, 0].map(Q::int))?;
    /// assert_eq!(plane.isocurve(Direction::U, &Q::int(1))?.coeffs(), [0, 1, 0].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn isocurve(mut self, direction: Direction, x: &T) -> Result<Self> {
        let (space, across) = (self.shape.space_along(direction), self.shape.space_along(direction.other()));
        let basis = space.basis(x)?;
        for j in 0..across.dim() {
            let place = |k: usize| {
                let i = space.slot(basis.first() + k);
                self.shape.flat_of(&if direction == Direction::U { [i, j] } else { [j, i] })
            };
            let places: Vec<usize> = (0..basis.weights().len()).map(place).collect();
            let weight = |(i, n): (&usize, &T)| Ok((*i, self.shape.control_weight(*i)? * n));
            let terms = places.iter().zip(basis.weights()).map(weight).collect::<Result<Vec<_>>>()?;
            let total = terms.iter().fold(T::zero(), |sum, (_, w)| sum + w);
            if total.is_zero() {
                return Err(Error::NotFinite { what: "control point of the isocurve", index: j });
            }
            self = self.row(SparseRow::new(terms.into_iter().map(|(i, w)| (i, w / &total))))?;
        }
        Ok(self)
    }

    /// So many points along a curve in the parameter plane, at [even parameters](SplineSpace::even_parameters) of it.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`] where the curve leaves the domain; those of [`SplineSpace::even_parameters`].
    pub fn along(self, path: &Curve<T, 2>, count: usize) -> Result<Self> {
        let places = path.space().even_parameters(count)?;
        let place = |t: &T| path.at(t).map(|at| (at[0].clone(), at[1].clone()));
        places.iter().try_fold(self, |constraints, t| constraints.point(&place(t)?))
    }
}
