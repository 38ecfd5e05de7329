//! The least change of coefficients that meets linear conditions.
//!
//! ```text
//! c' = c + W^-1 R^T (R W^-1 R^T)^-1 (t - R c)          R c' = t,  |c' - c|_W least
//! ```
//! with the conditions as rows of `R` [NURBS, section 11.5; FB (1)-(5)]. The rows are made orthogonal once, so that each
//! edit after that takes a few sums. Rows that depend on others are fine as long as their targets agree.

use crate::coeff::Coeff;
use crate::constrain::norm::{CoeffSpace, Norm};
use crate::constrain::orthogonal::{Change, Split, Step, split};
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::limits::check_entries;
use crate::ops::bound::epsilon;
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::spline::Spline;

/// Conditions on the coefficients of one space, prepared for edits of least change.
///
/// # Examples
/// ```
/// use symspline::{Error, Function, LeastChange, Norm, Q, Scalar, SplineSpace};
/// // Through 1 in the middle, with the integral as it is.
/// let space = SplineSpace::bezier(2, Q::int(0), Q::int(1))?;
/// let rows = [space.basis(&Q::frac(1, 2))?, space.moment(0)?];
/// let change = LeastChange::new(&space, &rows, Norm::L2)?;
/// let f = Function::new(space, vec![Q::int(0); 3])?;
/// let edited = change.edited(&f, &[Q::int(1), Q::int(0)])?;
/// assert_eq!(edited.coeffs(), [Q::int(-2), Q::int(4), Q::int(-2)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct LeastChange<T, S = SplineSpace<T>> {
    space: S,
    rows: Vec<Functional<T>>,
    /// What the rows are divided by before they are taken apart, so that no square overflows or vanishes.
    sizes: Vec<T>,
    splits: Vec<Vec<T>>,
    /// The step of each row that does not depend on those before it.
    own: Vec<Option<usize>>,
    steps: Vec<Step<T>>,
}

impl<T: Scalar, S: CoeffSpace<T> + Clone> LeastChange<T, S> {
    /// The conditions that `rows` have given values on the coefficients of splines of `space`, with the change measured by
    /// `norm`.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for more than [`MAX_ENTRIES`](crate::limits::MAX_ENTRIES) numbers; [`Error::NotFinite`];
    /// [`Error::IndexOutOfRange`] if a row starts past the last coefficient; [`Error::DegreeTooHigh`] and
    /// [`Error::Singular`] from the Gram matrix.
    pub fn new(space: &S, rows: &[Functional<T>], norm: Norm) -> Result<Self> {
        let n = space.dim();
        check_entries(rows.len(), n)?;
        for row in rows {
            if row.first() >= n {
                return Err(Error::IndexOutOfRange { index: row.first(), length: n });
            }
            if let Some(index) = row.weights().iter().position(|w| !w.is_finite()) {
                return Err(Error::NotFinite { what: "weight", index });
            }
        }
        let mut dense: Vec<Vec<T>> = rows.iter().map(|row| row.to_dense(n)).collect();
        let sizes: Vec<T> = dense.iter().map(|row| size(row)).collect();
        if !T::EXACT {
            dense.iter_mut().zip(&sizes).for_each(|(row, size)| T::divide(row, size));
        }
        let changes = norm.changes(space, &dense)?;
        let (mut steps, mut splits, mut own) = (Vec::new(), Vec::new(), Vec::new());
        for (row, change) in dense.iter().zip(&changes) {
            let Split { shares, rest } = split(&steps, row, Change::Given(change.clone()));
            own.push(rest.is_some().then_some(steps.len()));
            splits.push(shares);
            steps.extend(rest);
        }
        Ok(Self { space: space.clone(), rows: rows.to_vec(), sizes, splits, own, steps })
    }

    /// The space of the splines.
    pub fn space(&self) -> &S {
        &self.space
    }

    /// How many conditions do not follow from those before them.
    pub fn rank(&self) -> usize {
        self.steps.len()
    }

    /// Changes `coeffs` as [`edited`](Self::edited) does.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`], [`Error::Clash`]; [`Error::NotFinite`] where overflow hides whether there is one. Then
    /// `coeffs` are as they were.
    pub fn edit<C: Coeff<T>>(&self, coeffs: &mut [C], targets: &[C]) -> Result<()> {
        let lengths = [(self.space.dim(), coeffs.len()), (self.rows.len(), targets.len())];
        if let Some(&(expected, found)) = lengths.iter().find(|(expected, found)| expected != found) {
            return Err(Error::CoefficientCount { expected, found });
        }
        let largest = coeffs.iter().map(extent).fold(T::zero(), larger);
        let mut multiples: Vec<C> = Vec::with_capacity(self.steps.len());
        for (i, (row, target)) in self.rows.iter().zip(targets).enumerate() {
            let mut target = target.clone();
            // What the steps before leave to be met.
            let mut gap = target.minus(&row.apply(coeffs));
            let mut mass = row.weights().iter().fold(T::zero(), |sum, w| sum + w.magnitude());
            if !T::EXACT {
                let by = &self.sizes[i];
                gap.divide(by);
                target.divide(by);
                mass /= by;
            }
            let mut size = larger(extent(&target), largest.clone() * mass);
            for ((share, multiple), step) in self.splits[i].iter().zip(&multiples).zip(&self.steps) {
                let weight = -share.clone() * &step.square;
                gap.add_scaled(&weight, multiple);
                size = larger(size, extent(multiple) * weight.magnitude());
            }
            match self.own[i] {
                Some(k) => {
                    gap.divide(&self.steps[k].square);
                    multiples.push(gap);
                }
                None if !size.is_finite() => return Err(Error::NotFinite { what: "condition", index: i }),
                None if clashes(&gap, &size) => return Err(Error::Clash { condition: i }),
                None => {}
            }
        }
        for (step, multiple) in self.steps.iter().zip(&multiples) {
            coeffs.iter_mut().zip(&step.change).for_each(|(c, w)| c.add_scaled(w, multiple));
        }
        Ok(())
    }

    /// The conditions.
    pub fn rows(&self) -> &[Functional<T>] {
        &self.rows
    }

    /// The orthogonal rows.
    pub(crate) fn steps(&self) -> &[Step<T>] {
        &self.steps
    }
}

impl<T: Scalar> LeastChange<T> {
    /// The spline nearest to `f` on whose coefficients the conditions have the values `targets`.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is a target for each condition; [`Error::DomainMismatch`] and
    /// [`Error::TooSmooth`] unless `f` is in the space; [`Error::Clash`] if a condition that follows from others has a target
    /// that does not; [`Error::NotFinite`] on overflow.
    pub fn edited<C: Coeff<T>>(&self, f: &Spline<T, C>, targets: &[C]) -> Result<Spline<T, C>> {
        let mut coeffs = if f.space() == &self.space {
            f.coeffs().to_vec()
        } else {
            f.embedded(&self.space)?.into_coeffs()
        };
        self.edit(&mut coeffs, targets)?;
        Spline::new(self.space.clone(), coeffs)
    }
}

/// The size of the largest weight of a row, or one if all vanish; one over an exact field.
fn size<T: Scalar>(row: &[T]) -> T {
    let largest = if T::EXACT { T::zero() } else { row.iter().map(T::magnitude).fold(T::zero(), larger) };
    if largest.is_zero() { T::one() } else { largest }
}

/// The size of the largest component; over an exact field nothing depends on it.
fn extent<T: Scalar, C: Coeff<T>>(c: &C) -> T {
    if T::EXACT { T::zero() } else { c.components().map(T::magnitude).fold(T::zero(), larger) }
}

/// Whether what a dependent condition leaves open is more than rounding of numbers of some size.
fn clashes<T: Scalar, C: Coeff<T>>(left: &C, size: &T) -> bool {
    if T::EXACT {
        return !left.vanishes();
    }
    extent(left) > size.clone() * epsilon::<T>() * T::int(1 << 12)
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The spline of this space that has the value `to` at `x`, with the least change of coefficients by `norm`: a point of
    /// the curve, or of the graph, dragged.
    ///
    /// With [`Norm::Coefficients`] coefficient `i` moves in proportion to `N_i(x)`, so only those move that have an
    /// influence at `x` [FB (7), one condition; NURBS, (11.2) for one coefficient].
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::NotFinite`]; those of [`LeastChange::new`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Norm, Q, Scalar, SplineSpace};
    /// let one = Function::constant(SplineSpace::clamped(2, [0, 1, 2, 3].map(Q::int))?, Q::int(1))?;
    /// let alpha = one.dragged(&Q::int(1), Q::int(2), Norm::Coefficients)?;
    /// assert_eq!(alpha.coeffs(), [1, 2, 2, 1, 1].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn dragged(&self, x: &T, to: C, norm: Norm) -> Result<Self> {
        LeastChange::new(self.space(), &[self.space().basis(x)?], norm)?.edited(self, &[to])
    }
}
