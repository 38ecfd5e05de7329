//! Constraints that tie coordinates together: a direction of a tangent, a distance from a line, an area.

use crate::coeff::Coeff;
use crate::constrain::least::least_moves;
use crate::constrain::sparse::SparseRow;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::constraints::Constraints;
use crate::shape::controlled::Controlled;
use crate::shape::drag::Drag;
use crate::spline::Curve;
use crate::vector::dot;
use nalgebra::SVector;

/// Constraints on vectors, and further ones that each take one number: linear functionals of all coordinates of the control
/// points.
///
/// # Examples
/// The end of a curve slides along a line while its start stays:
/// ```
/// use nalgebra::vector;
/// use symspline::{Constraints, Curve, Q, Scalar, SplineSpace};
/// let points = [[0, 0], [1, 2], [3, 2], [4, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let curve = Curve::new(SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?, points.to_vec())?;
/// let [start, end] = [0, 2].map(Q::int);
/// // How far the end is above the line x = y, but for a factor.
/// let across = vector![Q::int(-1), Q::int(1)];
/// let held = Constraints::on(&curve).point(&start)?.coupled().along(&end, 0, &across)?.prepare()?;
/// let zero = vector![Q::int(0), Q::int(0)];
/// let moved = held.dragged(&curve, &[zero], &[Q::int(4)])?;
/// assert_eq!(moved.at(&end)?, vector![Q::int(2), Q::int(2)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Coupled<'a, T: Scalar, S: Controlled<T>, const N: usize> {
    base: Constraints<'a, T, S>,
    /// Rows over all coordinates: that of axis `a` of control point `i` has index `i N + a`.
    rows: Vec<SparseRow<T>>,
}

impl<'a, T: Scalar, S: Controlled<T, Point = SVector<T, N>>, const N: usize> Constraints<'a, T, S> {
    /// These constraints, and some that tie coordinates together.
    pub fn coupled(self) -> Coupled<'a, T, S, N> {
        Coupled { base: self, rows: Vec::new() }
    }
}

impl<T: Scalar, S: Controlled<T, Point = SVector<T, N>>, const N: usize> Coupled<'_, T, S, N> {
    /// The component `n · C^(order)` of a derivative.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`], [`Error::NotFinite`].
    pub fn along(self, at: &S::Parameter, order: S::Order, n: &SVector<T, N>) -> Result<Self> {
        let row = self.base.shape.influence(at, order)?;
        let terms = row.terms().iter().flat_map(|(i, r)| (0..N).map(move |a| (i * N + a, r.clone() * &n[a])));
        self.components(SparseRow::new(terms))
    }

    /// Any linear functional of the coordinates: axis `a` of control point `i` of the list has index `i N + a`.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`], [`Error::NotFinite`].
    pub fn components(mut self, row: SparseRow<T>) -> Result<Self> {
        row.check(self.base.shape.control_count() * N)?;
        self.rows.push(row);
        Ok(self)
    }

    /// The matrix of these constraints.
    ///
    /// # Errors
    /// As [`Constraints::prepare`]. Conditions are counted one for each coordinate of the vector constraints, then those
    /// that take one number.
    pub fn prepare(&self) -> Result<CoupledDrag<T, N>> {
        let of_axis = |row: &SparseRow<T>, axis: usize| {
            SparseRow::new(row.terms().iter().map(|(i, w)| (i * N + axis, w.clone())))
        };
        let vectors = self.base.wanted.len();
        let wanted = self.base.wanted.iter().flat_map(|wanted| (0..N).map(|axis| of_axis(&wanted.row, axis)));
        let rows = wanted.chain(self.rows.iter().cloned());
        let free: Vec<SparseRow<T>> = rows.map(|row| row.without(|i| !self.base.may_move(i / N))).collect();
        let (indices, matrix) = least_moves(&free, |i| self.base.price(i / N), self.base.excess)?;
        let drag = Drag::new(self.base.shape.control_count(), indices, matrix, free.len());
        Ok(CoupledDrag { vectors, drag })
    }
}

impl<T: Scalar> Coupled<'_, T, Curve<T, 2>, 2> {
    /// The area `½ ∫ x y' - y x'` that the curve sweeps around the origin, that of a closed curve its inside; to first order
    /// in the change, so an area asked for is met up to the area of the change itself.
    ///
    /// # Errors
    /// As [`SplineSpace::gram`](crate::SplineSpace::gram).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Constraints, Curve, Q, Scalar, SplineSpace};
    /// // Half of the unit square; its area is to grow by 1/10.
    /// let points = [[1, 0], [1, 1], [0, 1]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let curve = Curve::new(SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?, points.to_vec())?;
    /// let zero = vector![Q::int(0), Q::int(0)];
    /// let ends = Constraints::on(&curve).point(&Q::int(0))?.point(&Q::int(2))?;
    /// let grown = ends.coupled().area()?.prepare()?.dragged(&curve, &[zero.clone(), zero], &[Q::frac(1, 10)])?;
    /// assert_eq!(grown.coeffs()[1], vector![Q::frac(11, 10), Q::frac(11, 10)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn area(self) -> Result<Self> {
        let curve = self.base.shape;
        let space = curve.space();
        let ahead = space.gram(space, 0, 1)?.apply(curve.coeffs())?;
        let behind = space.gram(space, 1, 0)?.apply(curve.coeffs())?;
        let half = T::frac(1, 2);
        let row = |i: usize| {
            let swept = ahead[i].minus(&behind[i]);
            [(2 * i, swept[1].clone() * &half), (2 * i + 1, -swept[0].clone() * &half)]
        };
        let row = SparseRow::new((0..space.dim()).flat_map(row));
        self.components(row)
    }
}

/// Constraints that tie coordinates together with their matrix, ready to be dragged.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct CoupledDrag<T, const N: usize> {
    /// The number of constraints on vectors.
    vectors: usize,
    drag: Drag<T>,
}

impl<T: Scalar, const N: usize> CoupledDrag<T, N> {
    /// Changes the constrained vectors and numbers. On an error the shape stays as it is.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] for a wrong number of vectors or numbers, or another number of control points than that
    /// of the shape for which this was prepared; [`Error::NotFinite`] on overflow.
    pub fn drag<S: Controlled<T, Point = SVector<T, N>>>(
        &self,
        shape: &mut S,
        vectors: &[SVector<T, N>],
        numbers: &[T],
    ) -> Result<()> {
        if vectors.len() != self.vectors {
            return Err(Error::CoefficientCount { expected: self.vectors, found: vectors.len() });
        }
        self.drag.check(shape)?;
        let changes: Vec<T> = vectors.iter().flat_map(|v| v.iter()).chain(numbers).cloned().collect();
        let mut moves: Vec<(usize, SVector<T, N>)> = Vec::new();
        for (index, by) in self.drag.moves(&changes)? {
            let (i, axis) = (index / N, index % N);
            if moves.last().is_none_or(|(last, _)| *last != i) {
                moves.push((i, SVector::zeros()));
            }
            if let Some((_, moved)) = moves.last_mut() {
                moved[axis] = by;
            }
        }
        shape.move_points(&moves)
    }

    /// The shape after such changes.
    ///
    /// # Errors
    /// As [`drag`](Self::drag).
    pub fn dragged<S: Controlled<T, Point = SVector<T, N>>>(
        &self,
        shape: &S,
        vectors: &[SVector<T, N>],
        numbers: &[T],
    ) -> Result<S> {
        let mut dragged = shape.clone();
        self.drag(&mut dragged, vectors, numbers)?;
        Ok(dragged)
    }
}

/// The curve whose tangent at `x` has the given direction, through the same point there, with the least movement of control
/// points; how long the derivative becomes is left to that.
///
/// # Errors
/// [`Error::OutsideDomain`]; [`Error::NoLength`] for a zero direction; [`Error::NotFinite`]; [`ShapeError::TangentReversed`] if the
/// derivative would vanish or point the other way, as it does from a turn by a right angle on; those of
/// [`Constraints::prepare`].
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Curve, Q, Scalar, SplineSpace, with_tangent};
/// let points = [[0, 0], [1, 2], [3, 2], [4, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
/// let curve = Curve::new(SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?, points.to_vec())?;
/// let turned = with_tangent(&curve, &Q::int(1), &vector![Q::int(2), Q::int(1)])?;
/// let tangent = turned.derivative_at(&Q::int(1), 1)?;
/// assert_eq!(tangent[0], Q::int(2) * &tangent[1]);
/// assert_eq!(turned.at(&Q::int(1))?, curve.at(&Q::int(1))?);
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn with_tangent<T: Scalar, S, const N: usize>(shape: &S, x: &T, direction: &SVector<T, N>) -> Result<S>
where
    S: Controlled<T, Parameter = T, Order = usize, Point = SVector<T, N>>,
{
    if let Some(index) = direction.iter().position(|x| !x.is_finite()) {
        return Err(Error::NotFinite { what: "direction", index });
    }
    let size = |a: &usize| direction[*a].magnitude();
    let pivot = (0..N).reduce(|a, b| if size(&a) < size(&b) { b } else { a });
    let pivot = pivot.filter(|a| !direction[*a].is_zero()).ok_or(Error::NoLength)?;
    let old = shape.derivative_of(x, 1)?;
    let mut wanted = Constraints::on(shape).point(x)?.coupled();
    let mut numbers = Vec::with_capacity(N);
    for axis in (0..N).filter(|axis| *axis != pivot) {
        // Perpendicular to the direction.
        let mut across = SVector::<T, N>::zeros();
        across[axis] = T::one();
        across[pivot] = -direction[axis].clone() / &direction[pivot];
        numbers.push(-dot(&across, &old));
        wanted = wanted.along(x, 1, &across)?;
    }
    let turned = wanted.prepare()?.dragged(shape, &[SVector::zeros()], &numbers)?;
    // The two are parallel: one component tells, and no product overflows.
    let along = turned.derivative_of(x, 1)?[pivot].clone();
    match direction[pivot] > T::zero() {
        forward if forward && along > T::zero() || !forward && along < T::zero() => Ok(turned),
        _ => Err(ShapeError::TangentReversed.into()),
    }
}
