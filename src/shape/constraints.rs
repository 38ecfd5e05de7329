//! Constraints on points and derivatives, met by the least movement of control points.

use crate::coeff::Coeff;
use crate::constrain::least::{Excess, least_moves};
use crate::constrain::sparse::SparseRow;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::drag::Drag;
use std::collections::{BTreeMap, BTreeSet};

/// What is constrained: derivatives at places of a curve or surface, or any linear functional of the control points.
///
/// Each constraint is one row of `B d = b`, for every coordinate alike, with the changes `b` left open. Of all movements
/// of control points that meet them the least is taken: `Σ w_i |d_i|²`, with weights one unless others are given.
/// [`prepare`](Self::prepare) makes the matrix `A` with `d = A b` once, and every drag after that is one product
/// [NURBS, section 11.5; FB]. For surfaces this is what algorithm A11.1 does; its return codes 1 and 2 are the errors
/// [`ShapeError::Overdetermined`] and [`ShapeError::Dependent`].
///
/// # Examples
/// The tangent in the middle is changed while the point stays:
/// ```
/// use nalgebra::vector;
/// use symspline::{Constraints, Curve, Q, Scalar, SplineSpace};
/// let points = [[0, 0], [1, 2], [3, 2], [4, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let curve = Curve::new(SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?, points.to_vec())?;
/// let half = Q::frac(1, 2);
/// let held = Constraints::on(&curve).derivative(&half, 0)?.derivative(&half, 1)?.prepare()?;
/// let mut bent = curve.clone();
/// let (zero, up) = (vector![Q::int(0), Q::int(0)], vector![Q::int(0), Q::int(1)]);
/// held.drag(&mut bent, &[zero, up.clone()])?;
/// assert_eq!(bent.at(&half)?, curve.at(&half)?);
/// assert_eq!(bent.derivative_at(&half, 1)?, curve.derivative_at(&half, 1)? + up);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Constraints<'a, T: Scalar, S: Controlled<T>> {
    pub(crate) shape: &'a S,
    pub(crate) wanted: Vec<Wanted<T, S>>,
    pub(crate) held: BTreeSet<usize>,
    pub(crate) free: Option<BTreeSet<usize>>,
    pub(crate) weights: BTreeMap<usize, T>,
    pub(crate) excess: Excess,
}

/// One constraint.
#[derive(Clone, Debug)]
pub(crate) struct Wanted<T: Scalar, S: Controlled<T>> {
    pub row: SparseRow<T>,
    /// Where which derivative is meant, unless it is a row given.
    pub derivative: Option<(S::Parameter, S::Order)>,
}

impl<T: Scalar, S: Controlled<T>> Wanted<T, S> {
    /// By how much a shape is off `target`.
    pub(crate) fn gap(&self, shape: &S, target: &S::Point) -> Result<S::Point> {
        if let Some((at, order)) = &self.derivative {
            return Ok(target.minus(&shape.derivative_of(at, *order)?));
        }
        self.row.terms().iter().try_fold(target.clone(), |gap, (i, w)| {
            Ok(gap.plus_scaled(&-w.clone(), &shape.control_point(*i)?))
        })
    }
}

impl<'a, T: Scalar, S: Controlled<T>> Constraints<'a, T, S> {
    /// No constraints yet on `shape`.
    pub fn on(shape: &'a S) -> Self {
        let (held, weights) = (BTreeSet::new(), BTreeMap::new());
        Self { shape, wanted: Vec::new(), held, free: None, weights, excess: Excess::Refused }
    }

    /// The point at `at`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn point(self, at: &S::Parameter) -> Result<Self> {
        self.derivative(at, S::VALUE)
    }

    /// A derivative at `at` [NURBS, (11.68) and (11.83)]: from the right at knots, at the end of the domain from the left.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`].
    pub fn derivative(mut self, at: &S::Parameter, order: S::Order) -> Result<Self> {
        let row = self.shape.influence(at, order)?;
        self.wanted.push(Wanted { row, derivative: Some((at.clone(), order)) });
        Ok(self)
    }

    /// Any linear functional of the control points, as an integral, a moment, a difference of two points.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`] if it weighs a control point that there is none of; [`Error::NotFinite`].
    ///
    /// # Examples
    /// The centre of the curve, in the sense of its parameter, is moved:
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Constraints, Curve, Q, Scalar, SparseRow, SplineSpace};
    /// let points = [[0, 0], [1, 2], [3, 2]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let curve = Curve::new(SplineSpace::bezier(2, Q::int(0), Q::int(1))?, points.to_vec())?;
    /// let mean = SparseRow::from_functional(&curve.space().moment(0)?, 3);
    /// let right = vector![Q::int(1), Q::int(0)];
    /// let moved = Constraints::on(&curve).row(mean)?.prepare()?.dragged(&curve, &[right.clone()])?;
    /// assert_eq!(moved.integral()?, curve.integral()? + right);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn row(mut self, row: SparseRow<T>) -> Result<Self> {
        row.check(self.shape.control_count())?;
        self.wanted.push(Wanted { row, derivative: None });
        Ok(self)
    }

    /// Control points that must not move.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    pub fn holding(mut self, indices: &[S::Index]) -> Result<Self> {
        for index in indices {
            self.held.insert(self.shape.flat(*index)?);
        }
        Ok(self)
    }

    /// Of all control points only these may move, unless they are held; a later call replaces an earlier one.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    pub fn freeing(mut self, indices: &[S::Index]) -> Result<Self> {
        self.free = Some(indices.iter().map(|index| self.shape.flat(*index)).collect::<Result<_>>()?);
        Ok(self)
    }

    /// How much the movement of a control point counts: with a larger weight it moves less.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`]; [`ShapeError::MovementWeight`] unless it is positive.
    pub fn weighing(mut self, index: S::Index, weight: T) -> Result<Self> {
        let index = self.shape.flat(index)?;
        if !(weight > T::zero() && weight.is_finite()) {
            return Err(ShapeError::MovementWeight { index, weight: weight.to_string() }.into());
        }
        self.weights.insert(index, weight);
        Ok(self)
    }

    /// What happens with constraints that cannot be met together.
    #[must_use]
    pub fn with_excess(mut self, excess: Excess) -> Self {
        self.excess = excess;
        self
    }

    /// The matrix of these constraints.
    ///
    /// One to three constraints take the closed form by cofactors [FB (6)], more an orthogonal decomposition; over an exact
    /// field both are exact. The cost does not depend on the number of control points.
    ///
    /// # Errors
    /// [`ShapeError::Overdetermined`] and [`ShapeError::Dependent`], with the constraints that clash, unless
    /// [`Excess::LeastSquares`] is asked for; [`Error::CoefficientCount`] without constraints; [`Error::TooLarge`];
    /// [`Error::NotFinite`] on overflow.
    pub fn prepare(&self) -> Result<Constrained<T, S>> {
        let free = |wanted: &Wanted<T, S>| wanted.row.without(|i| !self.may_move(i));
        let free: Vec<SparseRow<T>> = self.wanted.iter().map(free).collect();
        let (indices, matrix) = least_moves(&free, |i| self.price(i), self.excess)?;
        let drag = Drag::new(self.shape.control_count(), indices, matrix, free.len());
        Ok(Constrained { wanted: self.wanted.clone(), drag })
    }

    pub(crate) fn may_move(&self, flat: usize) -> bool {
        !self.held.contains(&flat) && self.free.as_ref().is_none_or(|free| free.contains(&flat))
    }

    pub(crate) fn price(&self, flat: usize) -> T {
        self.weights.get(&flat).cloned().unwrap_or_else(T::one)
    }
}

/// Constraints with their matrix, ready to be dragged.
#[derive(Clone, Debug)]
pub struct Constrained<T: Scalar, S: Controlled<T>> {
    wanted: Vec<Wanted<T, S>>,
    drag: Drag<T>,
}

impl<T: Scalar, S: Controlled<T>> Constrained<T, S> {
    /// The rows of `B`, in the order in which they were asked for.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &SparseRow<T>> {
        self.wanted.iter().map(|wanted| &wanted.row)
    }

    /// The matrix `A`.
    pub fn matrix(&self) -> &Drag<T> {
        &self.drag
    }

    /// Changes the constrained values by `changes`, one vector each; zero for those that stay. On an error the shape stays
    /// as it is.
    ///
    /// # Errors
    /// As [`Drag::apply`].
    pub fn drag(&self, shape: &mut S, changes: &[S::Point]) -> Result<()> {
        self.drag.apply(shape, changes)
    }

    /// The shape after such changes.
    ///
    /// # Errors
    /// As [`Drag::apply`].
    pub fn dragged(&self, shape: &S, changes: &[S::Point]) -> Result<S> {
        self.drag.applied(shape, changes)
    }

    /// Gives the constrained values the values `targets` [FB (2)]. On an error the shape stays as it is.
    ///
    /// # Errors
    /// As [`Drag::apply`]; [`Error::Weight`] if a row weighs a control point at infinity.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Constraints, Function, Q, Scalar, SplineSpace};
    /// let mut f = Function::constant(SplineSpace::clamped(3, [0, 1, 2].map(Q::int))?, Q::int(5))?;
    /// let held = Constraints::on(&f).point(&Q::int(0))?.point(&Q::int(1))?.prepare()?;
    /// held.meet(&mut f, &[Q::int(5), Q::int(7)])?;
    /// assert_eq!((f.at(&Q::int(0))?, f.at(&Q::int(1))?), (Q::int(5), Q::int(7)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn meet(&self, shape: &mut S, targets: &[S::Point]) -> Result<()> {
        if targets.len() != self.wanted.len() {
            return Err(Error::CoefficientCount { expected: self.wanted.len(), found: targets.len() });
        }
        self.drag.check(shape)?;
        let gap = |(wanted, target): (&Wanted<T, S>, &S::Point)| wanted.gap(shape, target);
        let changes = self.wanted.iter().zip(targets).map(gap).collect::<Result<Vec<_>>>()?;
        self.drag(shape, &changes)
    }
}
