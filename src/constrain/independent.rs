//! Rows that the others follow from, in floating point.
//!
//! Where many rows depend on few, none of them exactly since all are rounded, the order decides what is taken for new: a row that
//! is small by itself must not be blown up to say something. So the longest row is taken first, all others are made orthogonal
//! to it, then the longest rest, and so on until only rounding is left (Gram-Schmidt with pivoting).

use crate::functional::Functional;
use crate::scalar::{Scalar, larger};

/// The indices of rows that the other rows follow from up to rounding, in the order to take them. Weights on `dim` coefficients
/// are of one scale, at most about one. Over an exact field nothing is left out.
pub(crate) fn independent<T: Scalar>(rows: &[Functional<T>], dim: usize) -> Vec<usize> {
    if T::EXACT {
        return (0..rows.len()).collect();
    }
    let mut rests: Vec<Vec<T>> = rows.iter().map(|row| row.to_dense(dim)).collect();
    let square = |row: &[T]| T::dot(row.iter().zip(row));
    let least = T::frac(1, 1 << 40);
    let mut open: Vec<usize> = (0..rows.len()).collect();
    let mut taken = Vec::new();
    let mut first = T::zero();
    while taken.len() < dim {
        let longest =
            open.iter().map(|i| (square(&rests[*i]), *i)).reduce(|a, b| if b.0 > a.0 { b } else { a });
        let Some((length, i)) = longest else { break };
        first = larger(first, length.clone());
        let worthy = length > first.clone() * &least * &least && length.is_finite();
        if !worthy {
            break;
        }
        taken.push(i);
        open.retain(|j| *j != i);
        let row = std::mem::take(&mut rests[i]);
        for j in &open {
            let rest = &mut rests[*j];
            let part = T::dot(rest.iter().zip(&row)) / &length;
            rest.iter_mut().zip(&row).for_each(|(x, y)| *x -= part.clone() * y);
        }
    }
    taken
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_no_condition() {
        let rows =
            [[1.0, 1.0, 0.0], [1e-16, -1e-16, 0.0], [0.5, 0.5, 1e-15], [0.0, 1e-3, 0.0], [0.3, 0.1, 0.0]];
        let rows = rows.map(|row| Functional::new(0, row));
        let mut found = independent(&rows, 3);
        assert_eq!(found[0], 0);
        found.sort_unstable();
        assert_eq!(found, [0, 4]);
    }
}
