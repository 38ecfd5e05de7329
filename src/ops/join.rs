//! Two splines end to end.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::parts::Parts;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// This spline followed by `other`, which starts where this one ends.
    ///
    /// The lower degree is raised, both are clamped, and the meeting parameter gets `p + 1` knots: nothing is asked
    /// of the values there, a jump stays a jump.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`] unless the domains meet.
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let (left, right) = Function::monomial(2, 0.0, 3.0)?.split(&1.0)?;
    /// assert_eq!(left.join(&right)?.at(&2.0)?, 4.0);
    /// assert_eq!(left.join_continuous(&right)?.space().dim(), 5);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn join(&self, other: &Self) -> Result<Self> {
        let (f, g) = meeting(self, other)?;
        let coeffs = f.coeffs().iter().chain(g.coeffs()).cloned().collect();
        Spline::new(joined_space(f.space(), g.space(), f.degree() + 1)?, coeffs)
    }

    /// As [`join`](Self::join) for splines that meet in value: `p` knots there, one coefficient shared.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`] unless the domains meet; [`Error::EndsDoNotMeet`] unless the clamped end
    /// coefficients are equal, without tolerance; [`Error::DegreeTooLow`] for degree 0.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, Function};
    /// let [f, g] = [Function::monomial(1, 0.0, 1.0)?, Function::monomial(2, 1.0, 2.0)?];
    /// assert_eq!(f.join_continuous(&g)?.coeffs(), [0.0, 0.5, 1.0, 2.0, 4.0]);
    /// assert!(matches!(f.join_continuous(&g.scaled(&2.0)?), Err(Error::EndsDoNotMeet { .. })));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn join_continuous(&self, other: &Self) -> Result<Self> {
        let (f, g) = meeting(self, other)?;
        if f.degree() == 0 {
            return Err(Error::DegreeTooLow { degree: 0, needed: 1 });
        }
        let (last, first) = (&f.coeffs()[f.coeffs().len() - 1], &g.coeffs()[0]);
        if last != first {
            return Err(Error::EndsDoNotMeet { left: format!("{last:?}"), right: format!("{first:?}") });
        }
        let coeffs = f.coeffs().iter().chain(&g.coeffs()[1..]).cloned().collect();
        Spline::new(joined_space(f.space(), g.space(), f.degree())?, coeffs)
    }
}

/// Both splines clamped and of the higher degree, if their domains meet.
fn meeting<T: Scalar, C: Coeff<T>>(
    f: &Spline<T, C>,
    g: &Spline<T, C>,
) -> Result<(Spline<T, C>, Spline<T, C>)> {
    if f.domain().1 != g.domain().0 {
        let text = |(a, b): (&T, &T)| format!("[{a}, {b}]");
        return Err(Error::DomainMismatch { left: text(f.domain()), right: text(g.domain()) });
    }
    let degree = f.degree().max(g.degree());
    let ready = |h: &Spline<T, C>| h.clamped_ends()?.elevated(degree - h.degree());
    Ok((ready(f)?, ready(g)?))
}

/// The space over both knot vectors with `copies` knots where they meet.
fn joined_space<T: Scalar>(f: &SplineSpace<T>, g: &SplineSpace<T>, copies: usize) -> Result<SplineSpace<T>> {
    let (left, right) = (f.parts(), g.parts());
    let mut inner = left.inner;
    inner.push((f.domain().1.clone(), copies));
    inner.extend(right.inner);
    SplineSpace::from_parts(f.degree(), Parts { left: left.left, inner, right: right.right })
}
