//! How large a change of coefficients is.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::linalg::BandedSystem;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;

/// How large a change of the coefficients of a spline is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Norm {
    /// `Σ |e_i|²`: the coefficients move little.
    #[default]
    Coefficients,
    /// `∫ |e|²`: the function moves little, whatever its knots are.
    L2,
}

impl Norm {
    /// `W^-1 r` for each of some rows `r` of a space, `W` the matrix of the squared norm.
    pub(crate) fn changes<T: Scalar>(self, space: &SplineSpace<T>, rows: &[Vec<T>]) -> Result<Vec<Vec<T>>> {
        if self == Self::Coefficients || rows.is_empty() {
            return Ok(rows.to_vec());
        }
        let n = space.dim();
        let gram = space.gram(space, 0, 0)?;
        let border = if space.is_periodic() { space.degree().min(n) } else { 0 };
        let mut system = BandedSystem::new(n, border);
        for (i, (first, weights)) in gram.rows().enumerate() {
            // Divided by the mass of the basis function, so that pivots do not depend on the lengths of spans.
            let mass = weights.iter().fold(T::zero(), |sum, w| sum + w);
            let scaled: Vec<T> = weights.iter().map(|w| w.clone() / &mass).collect();
            let mut right = Row(rows.iter().map(|row| row[i].clone()).collect::<Vec<T>>());
            right.divide(&mass);
            system.push(first, &scaled, right);
        }
        let solved = system.solve()?;
        let column = |k: usize| solved.iter().map(|row| row[k].clone()).collect();
        Ok((0..rows.len()).map(column).collect())
    }
}
