//! The sign of a scalar spline on its whole domain, proved.
//!
//! Values lie between Bernstein coefficients. Where those do not decide, a piece is bisected until they do, or until a
//! value shows the other sign.

use crate::bernstein::halves;
use crate::error::{Error, Result};
use crate::rational::domain::{Domain, Patches};
use crate::scalar::Scalar;

/// The sign that all values have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Positive,
    Negative,
}

/// The most bisections of one denominator.
const BISECTIONS: usize = 10_000;

/// The sign of the values of `f`.
///
/// # Errors
/// [`Error::Pole`] if there is a zero, [`Error::Undecided`] if too many bisections would be needed.
pub(crate) fn sign_of<D: Domain<T>, T: Scalar>(f: &D::Spline<T>) -> Result<Sign> {
    let (zero, coeffs) = (T::zero(), D::coeffs(f));
    if coeffs.iter().all(|c| *c > zero) {
        return Ok(Sign::Positive);
    }
    if coeffs.iter().all(|c| *c < zero) {
        return Ok(Sign::Negative);
    }
    let Patches { degrees: (p, q), patches } = D::patches(f)?;
    let first = patches[0][0].clone();
    let sign = if first > zero { Sign::Positive } else { Sign::Negative };
    let same = |x: &T| if sign == Sign::Positive { *x > zero } else { *x < zero };
    let mut waiting = patches;
    let mut bisections = 0;
    while let Some(patch) = waiting.pop() {
        // The corners are values of the spline.
        let corners = [0, q, p * (q + 1), p * (q + 1) + q];
        if !corners.iter().all(|&i| same(&patch[i])) {
            return Err(Error::Pole);
        }
        if patch.iter().all(same) {
            continue;
        }
        bisections += 1;
        if bisections > BISECTIONS {
            return Err(Error::Undecided);
        }
        waiting.extend(quarters(&patch, p, q));
    }
    Ok(sign)
}

/// The patch on the quarters of its rectangle; on two halves if one of the degrees is zero.
fn quarters<T: Scalar>(patch: &[T], p: usize, q: usize) -> Vec<Vec<T>> {
    let along_v: Vec<Vec<T>> = if q == 0 {
        vec![patch.to_vec()]
    } else {
        let rows: Vec<[Vec<T>; 2]> = patch.chunks(q + 1).map(halves).collect();
        [0, 1].map(|side| rows.iter().flat_map(|row| row[side].clone()).collect()).to_vec()
    };
    if p == 0 {
        return along_v;
    }
    let along_u = |patch: Vec<T>| {
        let column = |j: usize| halves(&patch[j..].iter().step_by(q + 1).cloned().collect::<Vec<T>>());
        let columns: Vec<[Vec<T>; 2]> = (0..=q).map(column).collect();
        [0, 1].map(|side| (0..=p).flat_map(|i| columns.iter().map(move |c| c[side][i].clone())).collect())
    };
    along_v.into_iter().flat_map(along_u).collect()
}
