//! Exact solutions of dense linear systems.
//!
//! Each row is multiplied by its common denominator and each right-hand side by its own; the integer system is
//! [lifted](super::lift). A column that depends on those before it modulo one prime is either found to do so truly, from the
//! exact solution of the independent part, or the next prime is tried.

use super::Q;
use super::dot::{Part, lcm};
use super::lift::{Dependent, Lifting};
use super::modular::Prime;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use nalgebra::DMatrix;
use num_bigint::BigInt;
use num_traits::{One, Zero};

/// Smaller systems are solved faster by elimination.
pub(super) const LEAST: usize = 6;

/// The solution `x` of `matrix x = right`, a square matrix of at least one row with right-hand sides of that length.
///
/// # Errors
/// [`Error::Singular`] with the first column that depends on those before it.
pub(super) fn solve(matrix: &DMatrix<Q>, right: &DMatrix<Q>) -> Result<DMatrix<Q>> {
    let n = matrix.nrows();
    let scales: Vec<BigInt> = (0..n).map(|i| common_denominator(matrix.row(i).iter())).collect();
    let mut entries = Vec::with_capacity(n * n);
    for (i, scale) in scales.iter().enumerate() {
        entries.extend(matrix.row(i).iter().map(|x| whole(x, scale)));
    }
    let mut prime = Prime::first();
    let lifting = loop {
        match Lifting::new(n, &entries, prime) {
            Ok(lifting) => break lifting,
            Err(dependent) if is_dependent(n, &entries, &dependent, prime) => {
                return Err(Error::Singular { row: dependent.column });
            }
            Err(_) => prime = prime.next(),
        }
    };
    let mut solution = DMatrix::from_element(n, right.ncols(), Q::zero());
    for (column, mut x) in right.column_iter().zip(solution.column_iter_mut()) {
        let scaled: Vec<Q> =
            column.iter().zip(&scales).map(|(b, scale)| b * Q::from(scale.clone())).collect();
        let scale = common_denominator(scaled.iter());
        let whole: Vec<BigInt> = scaled.iter().map(|b| whole(b, &scale)).collect();
        let (numerators, denominator) = lifting.solve(&whole);
        let mut values: Vec<Q> = numerators.into_iter().map(Q::from).collect();
        Q::divide(&mut values, &Q::from(denominator * scale));
        x.iter_mut().zip(values).for_each(|(x, value)| *x = value);
    }
    Ok(solution)
}

/// Whether a column that depends on those before it modulo a prime does so truly.
fn is_dependent(n: usize, entries: &[BigInt], dependent: &Dependent, prime: Prime) -> bool {
    let Dependent { column, rows } = dependent;
    if *column == 0 {
        return (0..n).all(|i| entries[i * n].is_zero());
    }
    let part: Vec<BigInt> =
        rows.iter().flat_map(|i| entries[i * n..i * n + column].iter().cloned()).collect();
    let right: Vec<BigInt> = rows.iter().map(|i| entries[i * n + column].clone()).collect();
    // Rows that are independent modulo a prime are independent.
    let Ok(lifting) = Lifting::new(*column, &part, prime) else { return false };
    let (weights, denominator) = lifting.solve(&right);
    (0..n).filter(|i| !rows.contains(i)).all(|i| {
        let row = entries[i * n..].iter().zip(&weights);
        row.map(|(a, w)| a * w).sum::<BigInt>() == &entries[i * n + column] * &denominator
    })
}

/// The least common denominator.
fn common_denominator<'a>(values: impl Iterator<Item = &'a Q>) -> BigInt {
    let (mut multiple, mut most) = (None, 0);
    for x in values {
        let Part { odd, twos, .. } = Part::new(x);
        most = most.max(twos);
        if let Some(odd) = odd {
            multiple = Some(lcm(multiple, &odd));
        }
    }
    multiple.unwrap_or_else(BigInt::one) << most
}

/// The multiple of `x` by a common denominator.
fn whole(x: &Q, scale: &BigInt) -> BigInt {
    let (num, den) = x.parts();
    &*num * (scale / &*den)
}

#[cfg(test)]
mod tests {
    use super::super::modular::FIRST;
    use super::super::tests::rational;
    use super::*;
    use crate::dense::eliminated;
    use proptest::collection::vec;
    use proptest::prelude::*;

    fn matrix(rows: usize, columns: usize, values: &[Q]) -> DMatrix<Q> {
        DMatrix::from_fn(rows, columns, |i, j| values[(i * columns + j) % values.len()].clone())
    }

    fn number() -> impl Strategy<Value = Q> {
        let few = (-3..=3i64, 1..=4i64).prop_map(|(p, q)| Q::frac(p, q));
        let image = (-1e3..1e3f64, -300..300i32).prop_map(|(x, k)| Q::try_from(x * 2_f64.powi(k)).unwrap());
        // Multiples of the prime are zero modulo the prime.
        let unlucky = (-2..=2i64).prop_map(|k| Q::int(k * FIRST as i64));
        prop_oneof![4 => few, 2 => rational().prop_map(Q::from), 2 => image, 1 => unlucky]
    }

    /// Systems of up to six rows whose entries are of one kind or of many.
    fn system() -> impl Strategy<Value = (DMatrix<Q>, DMatrix<Q>)> {
        let few = vec((-2..=2i64).prop_map(Q::int), 36);
        let entries = prop_oneof![few, vec(number(), 36)];
        (1..=6_usize, 0..=3_usize, entries, vec(number(), 18))
            .prop_map(|(n, count, entries, sides)| (matrix(n, n, &entries), matrix(n, count, &sides)))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        #[test]
        fn solutions_are_those_of_elimination((matrix, right) in system()) {
            prop_assert_eq!(solve(&matrix, &right), eliminated(&matrix, &right));
        }

        #[test]
        fn singular_systems_are_singular_at_the_same_column(
            n in 2..=6_usize, rank in 1..=5_usize, left in vec(number(), 36), other in vec(number(), 36)
        ) {
            prop_assume!(rank < n);
            let product = matrix(n, rank, &left) * matrix(rank, n, &other);
            let right = matrix(n, 1, &left);
            let found = solve(&product, &right);
            prop_assert!(found.is_err());
            prop_assert_eq!(found, eliminated(&product, &right));
        }
    }

    #[test]
    fn an_unlucky_prime_is_passed_over() {
        let p = Q::int(FIRST as i64);
        let one = Q::int(1);
        // The determinant is p, and that of the leading part of the other is.
        for entries in [[&one, &one, &one, &(&p + &one)], [&p, &one, &one, &p]] {
            let matrix = matrix(2, 2, &entries.map(Q::clone));
            let right = DMatrix::from_column_slice(2, 1, &[Q::int(3), Q::frac(1, 7)]);
            let solution = solve(&matrix, &right).unwrap();
            assert_eq!(matrix * solution, right);
        }
    }

    #[test]
    fn long_systems_have_the_solution_they_were_made_of() {
        let n = 40;
        let value = |i: usize| Q::try_from((0.7 * (i * i % 1009) as f64).cos()).unwrap();
        let matrix = DMatrix::from_fn(n, n, |i, j| value(31 * i + 17 * j + i * j));
        let solution = DMatrix::from_fn(n, 2, |i, j| value(i + 1000 * j) / Q::int(1 + i as i64));
        assert_eq!(solve(&matrix, &(&matrix * &solution)), Ok(solution));
    }

    #[test]
    fn zero_is_the_solution_for_zero() {
        let matrix = matrix(5, 5, &(0..7).map(|i| Q::frac(i * i, 3)).collect::<Vec<_>>());
        let zero = DMatrix::from_element(5, 2, Q::zero());
        assert_eq!(solve(&matrix, &zero), Ok(zero));
    }
}
