//! What does a polynomial approximation of the unit circle cost, in time and in coefficients, by tolerance and degree? The number of
//! coefficients is the last part of each name.

use nalgebra::vector;
use std::hint::black_box;
use symspline::{Q, Result, Scalar, circle};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    let mut group = criterion.benchmark_group("rational_polynomial");
    let unit = circle(&vector![0.0, 0.0], &1.0)?;
    for degree in [3, 5] {
        for tolerance in [1e-4, 1e-7, 1e-10] {
            let count = unit.polynomial_of_degree_within(degree, &tolerance)?.spline.space().dim();
            group.bench_function(format!("f64/degree {degree}/{tolerance:e}/{count}"), |b| {
                b.iter(|| black_box(&unit).polynomial_of_degree_within(degree, &tolerance));
            });
        }
    }
    let unit = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
    for digits in [2, 4] {
        let tolerance = Q::frac(1, 10_i64.pow(digits));
        let count = unit.polynomial_within(&tolerance)?.spline.space().dim();
        group.bench_function(format!("Q/degree 3/1e-{digits}/{count}"), |b| {
            b.iter(|| black_box(&unit).polynomial_within(&tolerance));
        });
    }
    group.finish();
    criterion.final_summary();
    Ok(())
}
