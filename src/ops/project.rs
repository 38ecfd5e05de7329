//! The best approximation in a given space, in the sense of least squares.
//!
//! The coefficients `d` of the `g` in the target space with the least `∫ |f - g|²` solve
//!
//! ```text
//! G d = H c        G_ij = ∫ M_i M_j,   H_ij = ∫ M_i N_j
//! ```
//! with the basis `M` of the target and `N` of the source: `f - g` is orthogonal to the target. Over `Q` this is exact.
//! Rows are divided by `∫ M_i`, so that pivots do not depend on the lengths of spans. Where the ends are held the first
//! and last coefficients are known beforehand, and the others solve the rows that remain.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::linalg::BandedSystem;
use crate::map::LinearMap;
use crate::ops::bound::Approximation;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

/// How many times bounds of approximations halve the pieces of the difference.
pub(crate) const HALVINGS: usize = 2;

/// What an approximation keeps of a spline at its ends: 0 nothing, 1 the value, 2 also the first derivative, and so on.
///
/// # Examples
/// ```
/// use symspline::{Contact, Function, SplineSpace};
/// let square = Function::monomial(2, 0.0, 1.0)?;
/// let line = square.projected(&SplineSpace::bezier(1, 0.0, 1.0)?, Contact::both(1))?;
/// assert_eq!(line.spline.coeffs(), [0.0, 1.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Contact {
    /// How many derivatives are kept at the start, the value counting as the first.
    pub start: usize,
    /// How many are kept at the end.
    pub end: usize,
}

impl Contact {
    /// Nothing is kept.
    pub const FREE: Self = Self::both(0);

    /// The same at both ends.
    pub const fn both(count: usize) -> Self {
        Self { start: count, end: count }
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The spline `g` of `target` with the least `∫ |f - g|²` among those that keep what `contact` says at the ends.
    ///
    /// If `target` contains the space of this spline, it is this spline. A periodic target is fine; then nothing can be
    /// kept at the ends.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`]. To keep anything the target must be clamped ([`Error::NotClamped`]), have the degree for
    /// it ([`Error::DegreeTooLow`]) and coefficients for both ends ([`Error::CoefficientCount`]).
    /// [`Error::DegreeTooHigh`] if both degrees add up to more than [`MAX_DEGREE`](crate::limits::MAX_DEGREE).
    /// [`Error::NotFinite`] on overflow; [`Error::Singular`] if in `f64` the spans differ too much.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Contact, Function, Q, Scalar, SplineSpace};
    /// let square = Function::monomial(2, Q::int(0), Q::int(1))?;
    /// let line = square.projected(&SplineSpace::bezier(1, Q::int(0), Q::int(1))?, Contact::FREE)?;
    /// assert_eq!(line.spline.coeffs(), [Q::frac(-1, 6), Q::frac(5, 6)]);
    /// assert!(line.bound >= Q::frac(1, 6));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "least squares")]
    #[doc(alias = "L2")]
    pub fn projected(&self, target: &SplineSpace<T>, contact: Contact) -> Result<Approximation<Self, T>> {
        let spline = self.projection(target, contact)?;
        let bound = self.distance_bound_halved(&spline, HALVINGS)?;
        Ok(Approximation { spline, bound })
    }

    /// The spline of [`projected`](Self::projected) without a bound.
    pub(crate) fn projection(&self, target: &SplineSpace<T>, contact: Contact) -> Result<Self> {
        self.space().check_same_domain(target)?;
        check_contact(target, contact)?;
        if target.contains(self.space()) {
            return self.embedded(target);
        }
        let start = self.end_coeffs(target, contact.start, false)?;
        let end = self.end_coeffs(target, contact.end, true)?;
        self.projection_between(target, start, end)
    }

    /// The spline of `target` with the least `∫ |f - g|²` among those whose first coefficients are `start` and whose last are
    /// `end`, not more than there are. A periodic target takes none.
    pub(crate) fn projection_between(
        &self,
        target: &SplineSpace<T>,
        start: Vec<C>,
        end: Vec<C>,
    ) -> Result<Self> {
        let contact = Contact { start: start.len(), end: end.len() };
        let (n, known) = (target.dim(), contact.start + contact.end);
        if known == n {
            return Spline::new(target.clone(), start.into_iter().chain(end).collect());
        }
        let fixed = |j: usize| match (j + contact.end).checked_sub(n) {
            _ if j < contact.start => Some(&start[j]),
            Some(k) if known > 0 => end.get(k),
            _ => None,
        };
        let (a, b) = self.domain();
        let factors = target.gram_factors(self.space(), 0, 0, a, b)?;
        let right = factors.left.apply(&factors.blocks.apply(&factors.right.apply(self.coeffs())?)?)?;
        let gram = target.gram(target, 0, 0)?;
        let border = if target.is_periodic() { target.degree().min(n) } else { 0 };
        let mut system = BandedSystem::new(n - known, border);
        for (i, mut value) in right.into_iter().enumerate().take(n - contact.end).skip(contact.start) {
            let (first, weights) = free_row(&gram, i, contact, &mut value, fixed);
            let mass = gram.row(i).1.iter().fold(T::zero(), |sum, w| sum + w);
            let scaled: Vec<T> = weights.iter().map(|w| w.clone() / &mass).collect();
            value.scale(&(T::one() / &mass));
            system.push(first, &scaled, value);
        }
        let free = system.solve()?;
        Spline::new(target.clone(), start.into_iter().chain(free).chain(end).collect())
    }

    /// The first `count` coefficients in the clamped space `target` (the last ones if `at_end`) of the splines there that
    /// have the value and derivatives of this one at that end, in the order of the space.
    ///
    /// With `e^(l)_i` the coefficients of the derivative of order `l`, counted from the end, `e^(l)_0` is its end value, and
    /// `e^(l)_{i+1} = e^(l)_i + (t_{i+q+1} - t_{i+l+1}) / (q - l) e^(l+1)_i`, knots counted from that end as well.
    fn end_coeffs(&self, target: &SplineSpace<T>, count: usize, at_end: bool) -> Result<Vec<C>> {
        if count == 0 {
            return Ok(Vec::new());
        }
        let (q, t) = (target.degree(), target.knots());
        let knot = |k: usize| if at_end { &t[t.len() - 1 - k] } else { &t[k] };
        let (a, b) = self.domain();
        let mut derivatives = self.derivatives_at(if at_end { b } else { a }, count - 1)?;
        if self.space().is_clamped() {
            // The end value without rounding.
            derivatives[0] = self.coeffs()[if at_end { self.coeffs().len() - 1 } else { 0 }].clone();
        }
        let mut row: Vec<C> = Vec::with_capacity(count);
        for (l, value) in derivatives.into_iter().enumerate().rev() {
            // `row` holds the derivative of order l + 1; make it that of order l.
            let mut lower = vec![value];
            for (i, leg) in row.into_iter().enumerate() {
                let mut next = lower[i].clone();
                let (far, near) = (knot(i + q + 1), knot(i + l + 1));
                let width = far.clone() - near;
                next.add_scaled(&(width / T::int((q - l) as i64)), &leg);
                lower.push(next);
            }
            row = lower;
        }
        if at_end {
            row.reverse();
        }
        Ok(row)
    }
}

/// Row `i` of a Gram matrix on the coefficients that are not known, numbered from the first of them; the known ones go
/// to the right hand side.
fn free_row<'a, T: Scalar, C: Coeff<T>>(
    gram: &LinearMap<T>,
    i: usize,
    contact: Contact,
    value: &mut C,
    fixed: impl Fn(usize) -> Option<&'a C>,
) -> (usize, Vec<T>) {
    let (first, weights) = gram.row(i);
    let mut free = Vec::with_capacity(weights.len());
    let mut start = None;
    for (j, w) in (first..).zip(weights) {
        match fixed(j) {
            Some(known) => value.add_scaled(&-w.clone(), known),
            None => {
                start.get_or_insert(j - contact.start);
                free.push(w.clone());
            }
        }
    }
    (start.unwrap_or(0), free)
}

/// That a space can keep what `contact` says.
fn check_contact<T: Scalar>(target: &SplineSpace<T>, contact: Contact) -> Result<()> {
    if contact == Contact::FREE {
        return Ok(());
    }
    if !target.is_clamped() {
        return Err(Error::NotClamped);
    }
    let needed = contact.start.max(contact.end) - 1;
    if needed > target.degree() {
        return Err(Error::DegreeTooLow { degree: target.degree(), needed });
    }
    let known = contact.start + contact.end;
    if known > target.dim() {
        return Err(Error::CoefficientCount { expected: known, found: target.dim() });
    }
    Ok(())
}
