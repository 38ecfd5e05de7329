//! How many times an LU decomposition in `f64` does an exact solve of a dense system take, with one right-hand side and with
//! three?
//!
//! Dense systems of small fractions and of lossless images of `f64`, and Gram matrices of cubic splines over such knots.

#![allow(clippy::print_stdout, reason = "a bench reports")]

mod ratios;

use nalgebra::DMatrix;
use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers};
use ratios::{Candidate, candidate, compare};
use symspline::{Q, Result, Scalar, solve_dense};

fn main() -> Result<()> {
    for n in [3, 5, 10, 30, 100] {
        for count in [1, 3] {
            dense(n, count);
        }
    }
    for n in [10, 30] {
        gram(n)?;
    }
    Ok(())
}

fn dense(n: usize, count: usize) {
    // Rows of one wave would be dependent: no two rows here have a pattern in common.
    let order: Vec<usize> = numbers::random(n * n).map(|x| (1e6 * x) as usize).collect();
    let entry = |i: usize, j: usize| order[i * n + j];
    let square = |value: fn(usize) -> Q| DMatrix::from_fn(n, n, |i, j| value(entry(i, j)));
    let sides = |value: fn(usize) -> Q| DMatrix::from_fn(n, count, |i, j| value(3 * i + j));
    let floats = DMatrix::from_fn(n, n, |i, j| (FLOATS.value)(entry(i, j)));
    let float_sides = DMatrix::from_fn(n, count, |i, j| (FLOATS.value)(3 * i + j));
    compare_solves(
        &format!("dense {n}, {count} right"),
        (&floats, &float_sides),
        (&square(FRACTIONS.value), &sides(FRACTIONS.value)),
        (&square(IMAGES.value), &sides(IMAGES.value)),
    );
}

fn gram(n: usize) -> Result<()> {
    let floats = gram_matrix(&FLOATS, n)?;
    let (small, images) = (gram_matrix(&FRACTIONS, n)?, gram_matrix(&IMAGES, n)?);
    let sides = |numbers: &Numbers<Q>| DMatrix::from_fn(n, 1, |i, _| (numbers.value)(i));
    let float_sides = DMatrix::from_fn(n, 1, |i, _| (FLOATS.value)(i));
    compare_solves(
        &format!("Gram {n}, 1 right"),
        (&floats, &float_sides),
        (&small, &sides(&FRACTIONS)),
        (&images, &sides(&IMAGES)),
    );
    Ok(())
}

fn gram_matrix<T: Scalar>(numbers: &Numbers<T>, n: usize) -> Result<DMatrix<T>> {
    let space = numbers.space(3, n - 3)?;
    let gram = space.gram(&space, 0, 0)?;
    gram.to_matrix()
}

type System<'a, T> = (&'a DMatrix<T>, &'a DMatrix<T>);

fn compare_solves(what: &str, floats: System<'_, f64>, small: System<'_, Q>, images: System<'_, Q>) {
    for (matrix, right) in [small, images] {
        let solution = solve_dense(matrix, right).expect("a regular matrix");
        assert_eq!(matrix * &solution, *right);
        let bits = solution.iter().map(Q::bits).max().expect("a solution");
        println!("bits of the solution of {what}: at most {bits}");
    }
    let (matrix, right) = floats;
    let candidates: Vec<Candidate<'_>> = vec![
        candidate("LU", || matrix.clone().lu().solve(right)),
        candidate("f64", || solve_dense(matrix, right)),
        candidate("small", || solve_dense(small.0, small.1)),
        candidate("images", || solve_dense(images.0, images.1)),
    ];
    compare(what, candidates);
}
