//! Removing knots from rings of so few coefficients that a knot sees itself coming round.
//!
//! With fewer than `p + 2` coefficients the equations of an insertion close to a circle, and going back is a small dense
//! system: least squares over the coefficients, which is exact where the knot can go without a change. The cost depends
//! on the degree alone.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::linalg::BandedSystem;
use crate::ops::bound::{Approximation, epsilon, finite, largest, sum_above};
use crate::ops::removal::Limit;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

/// The small ring `f`, off by `bound` so far, without `times(knot, copies)` copies of every knot, as far as `limit`
/// allows. A knot whose system cannot be solved in the field stays, unless it is forced out.
pub(crate) fn thin_tight<T: Scalar, C: Coeff<T>>(
    f: Spline<T, C>,
    bound: T,
    times: impl Fn(&T, usize) -> usize,
    limit: &Limit<T>,
) -> Result<Approximation<Spline<T, C>, T>> {
    let mut thin = Approximation { spline: f, bound };
    for (knot, copies) in thin.spline.space().round() {
        let seam = usize::from(knot == *thin.spline.domain().0);
        for _ in 0..times(&knot, copies).min(copies - seam) {
            let (spline, change) = match without_one(&thin.spline, &knot) {
                Err(Error::Singular { .. } | Error::NotFinite { .. }) if !matches!(limit, Limit::Forced) => {
                    break;
                }
                less => less?,
            };
            let bound = sum_above(thin.bound.clone(), &change);
            let fine = match limit {
                Limit::Forced => true,
                Limit::Exact => change.is_zero(),
                Limit::Within(tolerance) => bound <= *tolerance,
            };
            if !fine {
                break;
            }
            thin = Approximation { spline, bound };
        }
    }
    Ok(thin)
}

/// The ring with one copy of `knot` less that comes nearest in its coefficients, and a bound of the change.
fn without_one<T: Scalar, C: Coeff<T>>(f: &Spline<T, C>, knot: &T) -> Result<(Spline<T, C>, T)> {
    let fine = f.space();
    let mut round = fine.round();
    round.iter_mut().filter(|(t, _)| t == knot).for_each(|(_, copies)| *copies -= 1);
    round.retain(|(_, copies)| *copies > 0);
    let coarse = SplineSpace::from_round(f.degree(), &round, fine.domain().1)?;
    let insertion = coarse.embedding(fine)?;
    let back = insertion.transpose();
    let (normal, right) = (back.after(&insertion)?, back.apply(f.coeffs())?);
    let mut system = BandedSystem::new(coarse.dim(), coarse.dim());
    for ((first, weights), value) in normal.rows().zip(right) {
        system.push(first, weights, value);
    }
    let coarser = Spline::new(coarse, system.solve()?)?;
    let again = insertion.apply(coarser.coeffs())?;
    let lacks: Vec<C> = f.coeffs().iter().zip(&again).map(|(c, d)| c.minus(d)).collect();
    let change = largest(&lacks);
    if T::EXACT {
        return Ok((coarser, change));
    }
    let rounding = T::int(16 * (f.degree() as i64 + 1))
        * epsilon::<T>()
        * (largest(f.coeffs()) + largest(coarser.coeffs()));
    Ok((coarser, finite(change + rounding)?))
}
