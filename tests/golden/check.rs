//! One comparison for every category: exactly over `Q`, and over `f64` within a bound.

use crate::data::{Case, Field, cases};
use nalgebra::SVector;
use symspline::{Coeff, Q, Result, Scalar, Spline, SplineSpace};

/// What a case asks for: indices and degrees, knots, and rows of numbers (points, rows of a matrix).
#[derive(Clone, Debug, PartialEq)]
pub struct Answer<T> {
    pub integers: Vec<usize>,
    pub knots: Vec<T>,
    pub rows: Vec<Vec<T>>,
}

impl<T: Scalar> Answer<T> {
    /// An answer of rows alone.
    pub fn rows(rows: Vec<Vec<T>>) -> Self {
        Self { integers: Vec::new(), knots: Vec::new(), rows }
    }

    /// Degree, knots and coefficients of a spline.
    pub fn spline<C: Coeff<T>>(spline: &Spline<T, C>) -> Self {
        let space: &SplineSpace<T> = spline.space();
        Self {
            integers: vec![space.degree(), space.dim()],
            knots: space.knots().to_vec(),
            rows: spline.coeffs().iter().map(|c| c.components().cloned().collect()).collect(),
        }
    }
}

impl Answer<Q> {
    /// Degree, knots and coefficients as the file gives them, under these keys.
    pub fn expected_spline(case: Case, degree: &str, knots: &str, coeffs: &str) -> Self {
        let rows: Vec<Vec<Q>> = case.get(coeffs).rows();
        let integers = vec![case.get(degree).integer(), rows.len()];
        Self { integers, knots: case.get(knots).numbers(), rows }
    }
}

/// The coordinates of a point as a row.
pub fn row<T: Scalar, const N: usize>(point: SVector<T, N>) -> Vec<T> {
    point.iter().cloned().collect()
}

/// A category of the golden file: how the library answers a case, and what the file says.
pub trait Golden {
    const CATEGORY: &'static str;
    /// The number of cases the category has.
    const CASES: usize;
    /// The bound over `f64`, in units of `f64::EPSILON * size`.
    const FACTOR: f64;

    /// What the library finds, over any field.
    fn found<T: Field>(case: Case) -> Result<Answer<T>>;

    /// What the file says.
    fn expected(case: Case) -> Answer<Q>;

    /// The size of row `k` of the answer, with which the bound over `f64` scales: the largest number of the whole
    /// answer, unless a category says otherwise.
    fn size(_case: Case, expected: &Answer<Q>, _k: usize) -> f64 {
        largest(expected.rows.iter().flatten())
    }
}

/// Checks every case of a category over both fields.
pub fn check<G: Golden>() {
    for_each(G::CATEGORY, G::CASES, |case| {
        assert_eq!(G::found::<Q>(case)?, G::expected(case), "{} (found on the left)", case.id());
        check_floats(case.id(), &G::found::<f64>(case)?, &G::expected(case), G::FACTOR, |k| {
            G::size(case, &G::expected(case), k)
        });
        Ok(())
    });
}

/// Runs `check` on every case of a category, of which there are `count`.
pub fn for_each(category: &str, count: usize, check: impl Fn(Case) -> Result<()>) {
    let all = cases(category);
    assert_eq!(all.len(), count, "the number of cases of {category}");
    for case in all {
        check(case).unwrap_or_else(|error| panic!("{}: {error}", case.id()));
    }
}

/// Checks an answer over `f64`: indices and knots with `==`, since knots pass through operators unchanged, and row `k`
/// within `factor * EPSILON * size(k)`.
pub fn check_floats(
    place: &str,
    found: &Answer<f64>,
    expected: &Answer<Q>,
    factor: f64,
    size: impl Fn(usize) -> f64,
) {
    assert_eq!(found.integers, expected.integers, "{place} in f64 (found on the left)");
    let knots: Vec<f64> = expected.knots.iter().map(Q::to_f64).collect();
    assert_eq!(found.knots, knots, "knots of {place} in f64 (found on the left)");
    assert_eq!(found.rows.len(), expected.rows.len(), "rows of {place} in f64");
    for (k, (x, q)) in found.rows.iter().zip(&expected.rows).enumerate() {
        check_row(&format!("{place}, row {k}"), x, q, size(k), factor);
    }
}

/// Checks that `found` differs from `expected` by at most `factor * EPSILON * size`.
pub fn check_row(place: &str, found: &[f64], expected: &[Q], size: f64, factor: f64) {
    assert_eq!(found.len(), expected.len(), "{place}");
    let allowed = factor * f64::EPSILON * size;
    for (x, exact) in found.iter().zip(expected) {
        let image = Q::try_from(*x).unwrap_or_else(|error| panic!("{place}: {error}"));
        let error = (image - exact).abs().to_f64();
        assert!(error <= allowed, "{place}: {x} instead of {exact}, off by {error:e}, allowed {allowed:e}");
    }
}

/// The largest magnitude.
pub fn largest<'a>(numbers: impl IntoIterator<Item = &'a Q>) -> f64 {
    numbers.into_iter().map(|q| q.abs().to_f64()).fold(0.0, f64::max)
}

/// How large the derivative of order `k` of a spline of `degree` with coefficients up to `size` may be at most, if
/// the shortest span has length `h`: each order takes differences, which may double, times `degree / h`.
pub fn derivative_size(size: f64, degree: usize, h: f64, k: usize) -> f64 {
    (0..k).fold(size, |size, d| size * 2.0 * degree.saturating_sub(d).max(1) as f64 / h)
}

/// The length of the shortest span.
pub fn shortest_span(knots: &[Q]) -> f64 {
    let lengths = knots.windows(2).map(|pair| (pair[1].clone() - &pair[0]).to_f64());
    lengths.filter(|&h| h > 0.0).fold(f64::INFINITY, f64::min)
}

/// Calls `$f::<$T, N>($case)` with `N` the number of coordinates of the case's points.
macro_rules! in_dimension {
    ($f:ident::<$T:ty>($case:expr)) => {
        match $case.dimension() {
            1 => $f::<$T, 1>($case),
            2 => $f::<$T, 2>($case),
            3 => $f::<$T, 3>($case),
            n => panic!("points of {n} coordinates in {}", $case.id()),
        }
    };
}
pub(crate) use in_dimension;
