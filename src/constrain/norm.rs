//! How large a change of coefficients is.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
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
    pub(crate) fn changes<T: Scalar>(
        self,
        space: &impl CoeffSpace<T>,
        rows: &[Vec<T>],
    ) -> Result<Vec<Vec<T>>> {
        if self == Self::Coefficients || rows.is_empty() {
            return Ok(rows.to_vec());
        }
        space.gram_solved(rows)
    }
}

/// A space whose elements are lists of coefficients: one of functions of one parameter, or two for functions of two,
/// coefficients row by row.
pub trait CoeffSpace<T: Scalar> {
    /// The number of coefficients.
    fn dim(&self) -> usize;

    /// `G^-1 r` for each of some rows `r`, `G` the Gram matrix of the basis.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] for a row of another length; [`Error::DegreeTooHigh`], [`Error::Singular`].
    fn gram_solved(&self, rows: &[Vec<T>]) -> Result<Vec<Vec<T>>>;
}

impl<T: Scalar> CoeffSpace<T> for SplineSpace<T> {
    fn dim(&self) -> usize {
        self.dim()
    }

    fn gram_solved(&self, rows: &[Vec<T>]) -> Result<Vec<Vec<T>>> {
        check_rows(rows, self.dim())?;
        let right = (0..self.dim()).map(|i| rows.iter().map(|row| row[i].clone()).collect());
        let solved = solved_by_gram(self, right)?;
        Ok((0..rows.len()).map(|k| solved.iter().map(|row| row[k].clone()).collect()).collect())
    }
}

/// The spaces of functions of two parameters: along `u`, along `v`.
pub type SpacePair<T> = (SplineSpace<T>, SplineSpace<T>);

/// `G = G_u ⊗ G_v`: solved along one direction after the other.
impl<T: Scalar> CoeffSpace<T> for SpacePair<T> {
    fn dim(&self) -> usize {
        self.0.dim() * self.1.dim()
    }

    fn gram_solved(&self, rows: &[Vec<T>]) -> Result<Vec<Vec<T>>> {
        let (m, n) = (self.0.dim(), self.1.dim());
        check_rows(rows, m * n)?;
        let strip = |i: usize| rows.iter().flat_map(|row| &row[i * n..(i + 1) * n]).cloned().collect();
        let across = solved_by_gram(&self.0, (0..m).map(strip))?;
        // Strip i has entry (k, j) of row k at k n + j.
        let columns =
            (0..n).map(|j| across.iter().flat_map(|strip| strip[j..].iter().step_by(n)).cloned().collect());
        let solved = solved_by_gram(&self.1, columns)?;
        // Column j has entry (i, k) at i rows + k.
        let row = |k: usize| {
            (0..m)
                .flat_map(|i| solved.iter().map(move |c| (i, c)))
                .map(|(i, c)| c[i * rows.len() + k].clone())
                .collect()
        };
        Ok((0..rows.len()).map(row).collect())
    }
}

/// Refuses rows of another length.
fn check_rows<T>(rows: &[Vec<T>], expected: usize) -> Result<()> {
    match rows.iter().find(|row| row.len() != expected) {
        Some(row) => Err(Error::CoefficientCount { expected, found: row.len() }),
        None => Ok(()),
    }
}

/// `G^-1` times a column of rows, one for each coefficient.
fn solved_by_gram<T: Scalar>(
    space: &SplineSpace<T>,
    right: impl Iterator<Item = Vec<T>>,
) -> Result<Vec<Row<T>>> {
    let n = space.dim();
    let gram = space.gram(space, 0, 0)?;
    let border = if space.is_periodic() { space.degree().min(n) } else { 0 };
    let mut system = BandedSystem::new(n, border);
    for ((first, weights), right) in gram.rows().zip(right) {
        // Divided by the mass of the basis function, so that pivots do not depend on the lengths of spans.
        let mass = weights.iter().fold(T::zero(), |sum, w| sum + w);
        let scaled: Vec<T> = weights.iter().map(|w| w.clone() / &mass).collect();
        let mut right = Row(right);
        right.divide(&mass);
        system.push(first, &scaled, right);
    }
    system.solve()
}
