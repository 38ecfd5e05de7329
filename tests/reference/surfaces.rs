//! The scale functions of [Miura] Figs. 11 and 12, and what the paper says of them; its surfaces are not printed.

use nalgebra::{SVector, vector};
use symspline::{Edges, Fit, Path, Q, Result, Scalar, SplineSpace, Surface, SurfaceTuner, TensorSpline};

/// A biquadratic scale function of values one, but for some.
fn scale(rows: usize, columns: usize, changed: &[(usize, usize, Q)]) -> Result<TensorSpline<Q>> {
    let space = |count: usize| SplineSpace::uniform(2, count - 2, Q::int(0), Q::int(1));
    let mut values = vec![Q::int(1); rows * columns];
    changed.iter().for_each(|(i, j, value)| values[i * columns + j] = value.clone());
    TensorSpline::new(space(rows)?, space(columns)?, values)
}

/// A bicubic plane surface.
fn plane(rows: i64, columns: i64) -> Result<Surface<Q, 2>> {
    let space = |count: i64| SplineSpace::uniform(3, count as usize - 3, Q::int(0), Q::int(1));
    let point = |i: i64, j: i64| vector![Q::frac(6 * i + j % 2, 6), Q::frac(6 * j + i * i % 5, 6)];
    let points = (0..rows).flat_map(|i| (0..columns).map(move |j| point(i, j))).collect();
    Surface::new(space(rows)?, space(columns)?, points)
}

#[test]
fn negative_values_of_figures_11_and_12_leave_the_scale_positive() -> Result<()> {
    let middle = |value: Q| scale(3, 3, &[(1, 1, value)]);
    let accuracy = Q::frac(1, 1000);
    let less = middle(Q::frac(-17, 10))?;
    assert_eq!(less.at(&Q::frac(1, 2), &Q::frac(1, 2))?, Q::frac(13, 40));
    assert_eq!(less.range(&accuracy)?.least.value, Q::frac(13, 40));
    assert_eq!(middle(Q::int(16))?.range(&accuracy)?.greatest.value, Q::frac(19, 4));
    let two = scale(3, 4, &[(1, 1, Q::frac(-4, 5)), (1, 2, Q::frac(-4, 5))])?;
    assert_eq!(two.range(&accuracy)?.least.value, Q::frac(1, 10));
    for alpha in [less, two] {
        assert!(alpha.positive_bound()? > Q::int(0));
    }
    Ok(())
}

#[test]
fn figure_11_holds_its_boundary_and_figure_12_its_curvatures() -> Result<()> {
    let patch = plane(4, 4)?;
    let alpha = scale(3, 3, &[(1, 1, Q::int(16))])?;
    // Degrees 3 and 2 without inner knots make one patch of degree 5.
    let held = patch.fine_tuned_holding(&alpha, Path::Both, Edges::all(Fit::Position))?;
    assert_eq!((held.surface.u().dim(), held.surface.v().dim()), (6, 6));
    assert_eq!(held.forced, Q::int(0));

    let long = plane(6, 12)?;
    let alpha = scale(3, 4, &[(1, 1, Q::frac(-4, 5)), (1, 2, Q::frac(-4, 5))])?;
    let held = long.fine_tuned_holding(&alpha, Path::VThenU, Edges::all(Fit::Curvature))?;
    let (a, b) = (Q::int(0), Q::int(1));
    for x in [Q::int(0), Q::frac(2, 7), Q::int(1)] {
        for (u, v) in [(&a, &x), (&b, &x), (&x, &a), (&x, &b)] {
            let [found, was] = [&held.surface, &long].map(|s| s.derivatives_at(u, v, 2));
            let (found, was) = (found?, was?);
            let across = |jet: &[Vec<SVector<Q, 2>>], k: usize| match v == &x {
                true => jet[k][0].clone(),
                false => jet[0][k].clone(),
            };
            for k in 0..=2 {
                assert_eq!(across(&found, k), across(&was, k), "({u}, {v}) {k}");
            }
        }
    }
    Ok(())
}

/// Ends of degree 3 + 2 and one copy more, three copies of each inner knot of the surface, four of each of the scale.
#[test]
fn table_1_has_as_many_control_points_as_its_sizes_say() -> Result<()> {
    for (size, values, expected) in [
        ((4, 4), (3, 3), (6, 6)),
        ((4, 4), (3, 4), (6, 10)),
        ((5, 5), (3, 3), (9, 9)),
        ((4, 8), (3, 3), (6, 18)),
        ((6, 12), (3, 4), (12, 34)),
    ] {
        let (surface, alpha) = (plane(size.0, size.1)?, scale(values.0, values.1, &[])?);
        let tuner = SurfaceTuner::free(&surface, (alpha.u(), alpha.v()), Path::Both)?;
        assert_eq!((tuner.u().dim(), tuner.v().dim()), expected, "{size:?}");
    }
    Ok(())
}
