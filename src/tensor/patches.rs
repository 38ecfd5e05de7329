//! The polynomial patches that a surface consists of.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::scalar::Scalar;
use crate::tensor::spline::TensorSpline;

/// The Bernstein coefficients of every patch, those along `v` next to each other; patches row by row.
pub(crate) fn patches<T: Scalar, C: Coeff<T>>(surface: &TensorSpline<T, C>) -> Result<Vec<Vec<C>>> {
    let (p, q) = (surface.u().degree(), surface.v().degree());
    let pieces = surface.embedded(&surface.u().pieces(p)?, &surface.v().pieces(q)?)?;
    let width = pieces.v().dim();
    let patch = |rows: &[C], first: usize| -> Vec<C> {
        rows.chunks(width).flat_map(|row| &row[first..=first + q]).cloned().collect()
    };
    let strip = |rows: &[C]| (0..width).step_by(q + 1).map(|j| patch(rows, j)).collect::<Vec<_>>();
    Ok(pieces.coeffs().chunks((p + 1) * width).flat_map(strip).collect())
}
