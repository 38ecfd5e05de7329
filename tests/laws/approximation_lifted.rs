//! Laws of approximations of surfaces and of rational splines: the operators of one variable on rows and weighted points.
//!
//! Over `Q` they hold with `==`; over `f64` the results are taken as the exact numbers they are, and bounds hold for those.

use crate::rounding;
use crate::strategies::{ANY, Kind, SMOOTH, cases, indices, insertable, number, point, probes, space};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::Direction::{U, V};
use symspline::{
    Coeff, Contact, Continuity, Error, NurbsCurve, NurbsSurface, Q, Scalar, Spline, SplineSpace, Surface,
    TensorSpline, circle,
};

const FLAT: Kind = ANY.of_degree(0, 2);
const CURVED: Kind = SMOOTH.of_degree(1, 3);

/// A surface over any two spaces.
fn surface() -> impl Strategy<Value = Surface<Q, 2>> {
    (space(FLAT), space(FLAT), vec(point::<2>(), 64)).prop_map(|(u, v, points)| {
        let coeffs = points.into_iter().cycle().take(u.dim() * v.dim()).collect();
        TensorSpline::new(u, v, coeffs).expect("as many coefficients as the grid has")
    })
}

/// A surface in floating point, with points up to 1.
fn rounded_surface() -> impl Strategy<Value = Surface<f64, 2>> {
    (rounding::function(), rounding::function()).prop_map(|(f, g)| {
        let (u, v) = (f.space().clone(), g.space().clone());
        let points = f.coeffs().iter().flat_map(|x| g.coeffs().iter().map(move |y| vector![*x, x - y]));
        let coeffs = points.collect();
        TensorSpline::new(u, v, coeffs).expect("as many coefficients as the grid has")
    })
}

/// A rational curve with weights between 1/9 and 9.
fn nurbs(kind: Kind) -> impl Strategy<Value = NurbsCurve<Q, 2>> {
    let weight = (1_i64..=9, 1_i64..=9).prop_map(|(n, d)| Q::frac(n, d));
    (space(kind), vec(point::<2>(), 48), vec(weight, 48)).prop_map(|(space, points, weights)| {
        let n = space.dim();
        NurbsCurve::new(space, points[..n].to_vec(), weights[..n].to_vec()).expect("positive weights")
    })
}

/// The same in floating point.
fn rounded_nurbs() -> impl Strategy<Value = NurbsCurve<f64, 2>> {
    (rounding::function(), vec(-100.0_f64..100.0, 48), vec(0.1_f64..10.0, 48)).prop_map(|(f, y, weights)| {
        let points: Vec<_> = f.coeffs().iter().zip(&y).map(|(x, y)| vector![*x, *y]).collect();
        let n = points.len();
        NurbsCurve::new(f.space().clone(), points, weights[..n].to_vec()).expect("positive weights")
    })
}

/// That values of surfaces are within `bound`, on a grid.
fn near(s: &Surface<Q, 2>, r: &Surface<Q, 2>, bound: &Q) -> Result<(), TestCaseError> {
    let square = bound.clone() * bound;
    for u in probes(s.u()) {
        for v in probes(s.v()) {
            let off = s.at(&u, &v)?.minus(&r.at(&u, &v)?);
            prop_assert!(Coeff::<Q>::squared_size(&off) <= square, "{u} {v}");
        }
    }
    Ok(())
}

/// That points of rational curves are within `bound`, from both sides.
fn close(f: &NurbsCurve<Q, 2>, g: &NurbsCurve<Q, 2>, bound: &Q) -> Result<(), TestCaseError> {
    let square = bound.clone() * bound;
    let (a, b) = f.domain();
    for x in probes(f.space()) {
        let left = if x == *a { b } else { &x };
        for (c, d) in [(f.at(&x)?, g.at(&x)?), (f.at_left(left)?, g.at_left(left)?)] {
            prop_assert!(Coeff::<Q>::squared_size(&c.minus(&d)) <= square, "{x}");
        }
    }
    Ok(())
}

/// A tolerance that is often zero.
fn tolerance() -> impl Strategy<Value = Q> {
    prop_oneof![2 => Just(Q::int(0)), 3 => (1_i64..=40).prop_map(|n| Q::frac(n * n, 8)), 1 => Just(Q::int(1_000_000_000))]
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn knots_inserted_along_both_directions_go_again(s in surface(), us in indices(3), vs in indices(3)) {
        let minimal = s.approximated_along(U, |rows| rows.without_spare_knots(&Q::int(0)))?.spline;
        let minimal = minimal.approximated_along(V, |rows| rows.without_spare_knots(&Q::int(0)))?.spline;
        prop_assert!(minimal.same_function(&s)?);
        let (us, vs) = (insertable(minimal.u(), &us), insertable(minimal.v(), &vs));
        let fine = minimal.inserted(U, &us)?.inserted(V, &vs)?;
        let back = fine.approximated_along(V, |rows| rows.without_spare_knots(&Q::int(0)))?;
        let both = back.spline.approximated_along(U, |rows| rows.without_spare_knots(&Q::int(0)))?;
        prop_assert_eq!((back.bound + both.bound, both.spline), (Q::int(0), minimal));
    }

    #[test]
    fn degrees_raised_along_both_directions_come_down(s in surface(), i in 0_usize..3, j in 0_usize..3) {
        let raised = s.elevated(U, i)?.elevated(V, j)?;
        let lower = raised.approximated_along(U, |rows| rows.degree_lowered(i))?;
        let back = lower.spline.approximated_along(V, |rows| rows.degree_lowered(j))?;
        prop_assert_eq!(lower.bound + back.bound, Q::int(0));
        prop_assert!(back.spline.same_function(&s)?);
        prop_assert_eq!([back.spline.u().degree(), back.spline.v().degree()], [s.u().degree(), s.v().degree()]);
    }

    #[test]
    fn the_residual_of_a_projected_surface_is_orthogonal(
        (s, [u, v]) in (surface(), [0_usize..=2, 0..=2]),
        (i, j) in (any::<prop::sample::Index>(), any::<prop::sample::Index>()),
    ) {
        let target = |space: &SplineSpace<Q>, degree: usize| {
            let (a, b) = space.domain();
            SplineSpace::uniform(degree, 2, a.clone(), b.clone())
        };
        let (u, v) = (target(s.u(), u)?, target(s.v(), v)?);
        let plane = s.projected(&u, &v)?;
        near(&s, &plane.spline, &plane.bound)?;
        let mut basis = vec![Q::int(0); u.dim() * v.dim()];
        let one = i.index(u.dim()) * v.dim() + j.index(v.dim());
        basis[one] = Q::int(1);
        let basis = TensorSpline::new(u, v, basis)?;
        let residual = s.difference(&plane.spline)?;
        prop_assert_eq!(residual.times(&basis)?.integral()?, vector![Q::int(0), Q::int(0)]);
    }

    #[test]
    fn simplified_surfaces_are_the_same_and_no_larger(s in surface(), i in 0_usize..2, us in indices(2), vs in indices(2)) {
        let (us, vs) = (insertable(s.u(), &us), insertable(s.v(), &vs));
        let large = s.inserted(U, &us)?.inserted(V, &vs)?.elevated(V, i)?;
        let simple = large.simplified()?;
        prop_assert!(simple.same_function(&s)?);
        prop_assert!(simple.u().dim() <= s.u().dim() && simple.v().dim() <= s.v().dim());
        prop_assert_eq!(simple.simplified()?, simple);
    }

    #[test]
    fn surfaces_simplified_within_a_tolerance_are_near(s in surface(), tolerance in tolerance()) {
        let simple = s.simplified_within(&tolerance)?;
        prop_assert!(simple.bound <= tolerance);
        near(&s, &simple.spline, &simple.bound)?;
    }

    #[test]
    fn knots_of_rational_curves_go_within_a_tolerance(f in nurbs(FLAT), places in indices(3), tolerance in tolerance()) {
        let knots = insertable(f.space(), &places);
        let fine = f.through(|lifted| lifted.inserted(&knots))?;
        let thin = fine.approximated(&tolerance, |lifted, tolerance| lifted.without_spare_knots(tolerance))?;
        prop_assert!(thin.bound <= tolerance);
        prop_assert!(thin.spline.space().dim() <= fine.space().dim());
        close(&f, &thin.spline, &thin.bound)?;
        // A knot that goes at a cost may keep others from going. Without one all that were inserted go.
        let exact = fine.lifted().without_spare_knots(&Q::int(0))?.spline;
        prop_assert!(exact.space().dim() <= f.space().dim());
    }

    #[test]
    fn rational_degrees_are_reduced_within_a_tolerance(f in nurbs(CURVED), eighths in 1_i64..9) {
        let tolerance = Q::frac(eighths * 1_000_000_000, 8);
        let reduced =
            f.approximated(&tolerance, |lifted, _| lifted.degree_reduced(1, Continuity::Breaks, Contact::FREE));
        match reduced {
            Ok(near) => {
                prop_assert!(near.bound <= tolerance);
                close(&f, &near.spline, &near.bound)?;
            }
            Err(error) => prop_assert!(matches!(error, Error::OutOfTolerance { .. }), "{error}"),
        }
    }

    #[test]
    fn elevated_rational_curves_come_down_exactly(f in nurbs(ANY.of_degree(0, 3)), raise in 0_usize..3) {
        let raised = f.through(|lifted| lifted.elevated(raise))?;
        let lowered = raised.approximated(&Q::int(0), |lifted, _| lifted.degree_lowered(raise))?;
        prop_assert_eq!(lowered.bound, Q::int(0));
        prop_assert!(lowered.spline.same_function(&f)?);
        prop_assert_eq!(lowered.spline.degree(), f.degree());
    }

    #[test]
    fn rational_surfaces_lose_what_was_added(s in surface(), weights in vec(1_i64..9, 64), us in indices(2)) {
        let weights = weights.into_iter().cycle().map(Q::int).take(s.coeffs().len()).collect();
        let f = NurbsSurface::new(s.u().clone(), s.v().clone(), s.coeffs().to_vec(), weights)?;
        let knots = insertable(s.u(), &us);
        let fine = f.through(|lifted| lifted.inserted(U, &knots)?.elevated(V, 1))?;
        let back = fine.approximated(&Q::int(0), |lifted, tolerance| lifted.simplified_within(tolerance))?;
        prop_assert_eq!(back.bound, Q::int(0));
        prop_assert!(back.spline.u().dim() <= s.u().dim() && back.spline.v().dim() <= s.v().dim());
        for (u, v) in probes(s.u()).iter().zip(&probes(s.v())) {
            prop_assert_eq!(back.spline.at(u, v)?, f.at(u, v)?);
        }
    }

    #[test]
    fn rounded_surfaces_are_certified(s in rounded_surface(), hundredths in 1_u8..100) {
        let tolerance = f64::from(hundredths) / 50.0;
        let exact = s.to_exact()?;
        let simple = s.simplified_within(&tolerance)?;
        prop_assert!(simple.bound <= tolerance);
        near(&exact, &simple.spline.to_exact()?, &Q::try_from(simple.bound)?)?;
        for direction in [U, V] {
            let thin = s.approximated_along(direction, |rows| rows.without_spare_knots(&tolerance))?;
            prop_assert!(thin.bound <= tolerance);
            near(&exact, &thin.spline.to_exact()?, &Q::try_from(thin.bound)?)?;
        }
    }

    #[test]
    fn rounded_rational_curves_are_certified(f in rounded_nurbs(), exponent in -12_i32..4) {
        let tolerance = 10.0_f64.powi(exponent);
        let exact = f.to_exact()?;
        let thin = f.approximated(&tolerance, |lifted, tolerance| lifted.without_spare_knots(tolerance))?;
        let simple = f.approximated(&tolerance, |lifted, tolerance| lifted.simplified_within(tolerance))?;
        for near in [thin, simple] {
            prop_assert!(near.bound <= tolerance);
            close(&exact, &near.spline.to_exact()?, &Q::try_from(near.bound)?)?;
        }
        let raised = f.through(|lifted| lifted.elevated(1))?;
        let lowered = raised.approximated(&tolerance, |lifted, _| lifted.degree_lowered(1));
        match lowered {
            Ok(near) => close(&raised.to_exact()?, &near.spline.to_exact()?, &Q::try_from(near.bound)?)?,
            Err(error) => prop_assert!(matches!(error, Error::OutOfTolerance { .. }), "{error}"),
        }
    }

    #[test]
    fn rows_of_one_entry_are_numbers(f in crate::strategies::function(FLAT), c in number(), tolerance in tolerance()) {
        // A function times a constant along v is simplified as the function is.
        let rows: Vec<Q> = f.coeffs().to_vec();
        let v = SplineSpace::bezier(0, Q::int(0), Q::int(1))?;
        let s = TensorSpline::new(f.space().clone(), v, rows)?.scaled(&c)?;
        let thin = s.approximated_along(U, |rows| rows.without_spare_knots(&tolerance))?;
        let alone = f.scaled(&c)?.without_spare_knots(&tolerance)?;
        prop_assert_eq!((thin.spline.coeffs(), thin.bound), (alone.spline.coeffs(), alone.bound));
    }
}

#[test]
fn an_elevated_circle_is_reduced_exactly() -> symspline::Result<()> {
    let round = circle(&vector![Q::int(3), Q::int(-1)], &Q::frac(5, 2))?;
    let raised = round.through(|lifted| lifted.elevated(2)?.inserted(&[Q::frac(1, 7)]))?;
    let reduced = raised.approximated(&Q::int(0), |lifted, _| lifted.degree_lowered(2))?;
    assert_eq!((reduced.spline, reduced.bound), (round.clone(), Q::int(0)));
    let projected = round
        .through(|lifted| lifted.elevated(2))?
        .approximated(&Q::int(0), |lifted, _| lifted.degree_reduced(2, Continuity::Kept, Contact::FREE))?;
    assert_eq!((projected.spline, projected.bound), (round, Q::int(0)));
    Ok(())
}

#[test]
fn circles_of_any_size_have_a_bound() -> symspline::Result<()> {
    for radius in [1e-300, 1e-160, 1.0, 1e160, 1e200, 1e300] {
        let round = circle(&vector![0.0, 0.0], &radius)?;
        for tolerance in [0.0, 1e-3 * radius, radius, 1e300, f64::MAX] {
            let thin =
                round.approximated(&tolerance, |lifted, tolerance| lifted.without_spare_knots(tolerance))?;
            assert!(thin.bound <= tolerance, "{radius:e} {tolerance:e} {:e}", thin.bound);
            for i in 0..=40 {
                let x = f64::from(i) / 40.0 * round.domain().1;
                let off: SVector<f64, 2> = (thin.spline.at(&x)? - round.at(&x)?) / radius;
                assert!(off.norm() <= thin.bound / radius + 1e-12);
            }
        }
    }
    Ok(())
}

#[test]
fn an_overflow_is_no_bound() -> symspline::Result<()> {
    // The middle is further from the line through the ends than any float.
    let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0])?;
    let peak = Spline::new(space, vec![f64::MAX, -f64::MAX, f64::MAX])?;
    assert_eq!(
        peak.without_knot(2, symspline::Keep::Left),
        Err(Error::NotFinite { what: "bound", index: 0 })
    );
    assert_eq!(peak.without_spare_knots(&f64::MAX)?.spline, peak);
    let rows =
        TensorSpline::new(peak.space().clone(), SplineSpace::bezier(0, 0.0, 1.0)?, peak.coeffs().to_vec())?;
    let kept = rows.approximated_along(U, |rows| rows.without_spare_knots(&f64::MAX))?;
    assert_eq!((kept.spline, kept.bound), (rows, 0.0));
    Ok(())
}
