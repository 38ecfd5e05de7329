//! Laws of rational surfaces.

use crate::oracle::{Side, basis};
use crate::rational_strategies::{nurbs_surface, surface_and_divisor, two_nurbs_surfaces};
use crate::strategies::{ANY, Kind, SMOOTH, cases, indices, insertable, number, point, probes};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use symspline::Direction::{U, V};
use symspline::{
    Coeff, Error, NurbsCurve, NurbsSurface, Q, Rational, Rectangle, Scalar, Spline, SplineSpace, Surface,
    TensorSpline, arc, circle,
};

const LOW: Kind = ANY.of_degree(0, 3);

/// A few pairs of parameters, each probe of either direction among them.
fn pairs(u: &SplineSpace<Q>, v: &SplineSpace<Q>) -> Vec<(Q, Q)> {
    let (us, vs) = (probes(u), probes(v));
    let most = us.len().max(vs.len());
    (0..most).map(|i| (us[i % us.len()].clone(), vs[(2 * i + 1) % vs.len()].clone())).collect()
}

/// The value from the recurrence, on both axes.
fn value<C: Coeff<Q>>(f: &TensorSpline<Q, C>, u: &Q, v: &Q) -> C {
    let (n, m) = (basis(f.u(), u, Side::Right), basis(f.v(), v, Side::Right));
    let mut sum = f.coeffs()[0].zero_like();
    for (i, a) in n.iter().enumerate() {
        for (j, b) in m.iter().enumerate() {
            let coeff = f.coeff(i % f.u().dim(), j % f.v().dim()).expect("a coefficient");
            sum.add_scaled(&(a.clone() * b), coeff);
        }
    }
    sum
}

fn choose(n: usize, k: usize) -> Q {
    (0..k).fold(Q::int(1), |c, i| c * Q::int((n - i) as i64) / Q::int(i as i64 + 1))
}

/// Both have the same values, also on the boundary.
fn agree<const N: usize>(f: &NurbsSurface<Q, N>, g: &NurbsSurface<Q, N>) -> Result<(), TestCaseError> {
    for (u, v) in pairs(f.u(), f.v()).iter().chain(&pairs(g.u(), g.v())) {
        prop_assert_eq!(f.at(u, v)?, g.at(u, v)?);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(20))]

    #[test]
    fn a_value_is_the_quotient_of_values(f in nurbs_surface::<3>(LOW)) {
        let (numerator, denominator) = (f.numerator()?, f.denominator()?);
        let all = pairs(f.u(), f.v());
        let expected: Vec<_> = all
            .iter()
            .map(|(u, v)| value(&numerator, u, v).scaled(&(Q::int(1) / value(&denominator, u, v))))
            .collect();
        prop_assert_eq!(&f.eval(&all)?, &expected);
        for ((u, v), expected) in all.iter().zip(&expected) {
            prop_assert_eq!(&f.at(u, v)?, expected);
            prop_assert_eq!(&f.isocurve(U, u)?.at(v)?, expected);
            prop_assert_eq!(&f.isocurve(V, v)?.at(u)?, expected);
        }
        let (us, vs) = (probes(f.u()), probes(f.v()));
        let grid = f.eval_grid(&us, &vs)?;
        prop_assert_eq!(grid.len(), us.len() * vs.len());
        for (i, u) in us.iter().enumerate() {
            prop_assert_eq!(&grid[i * vs.len() + vs.len() - 1], &f.at(u, &vs[vs.len() - 1])?);
        }
    }

    #[test]
    fn derivatives_times_the_denominator_are_those_of_the_numerator(f in nurbs_surface::<2>(LOW), order in 0_usize..4) {
        let (numerator, denominator) = (f.numerator()?, f.denominator()?);
        for (x, y) in pairs(f.u(), f.v()) {
            let found = f.derivatives_at(&x, &y, order)?;
            let a = numerator.derivatives_at(&x, &y, order)?;
            let w = denominator.derivatives_at(&x, &y, order)?;
            for (k, l) in (0..=order).flat_map(|k| (0..=order).map(move |l| (k, l))) {
                let mut product = a[k][l].zero_like();
                for (i, j) in (0..=k).flat_map(|i| (0..=l).map(move |j| (i, j))) {
                    product.add_scaled(&(choose(k, i) * choose(l, j) * &w[i][j]), &found[k - i][l - j]);
                }
                prop_assert_eq!(&product, &a[k][l]);
            }
        }
    }

    #[test]
    fn tangents_and_forms_come_from_the_derivatives(f in nurbs_surface::<3>(LOW)) {
        for (u, v) in pairs(f.u(), f.v()) {
            let all = f.derivatives_at(&u, &v, 1)?;
            let [s, su, sv] = f.tangents_at(&u, &v)?;
            prop_assert_eq!([&s, &su, &sv], [&all[0][0], &all[1][0], &all[0][1]]);
            let form = f.first_form_at(&u, &v)?;
            let dot = |c: &SVector<Q, 3>, d: &SVector<Q, 3>| Q::dot(c.iter().zip(d.iter()));
            prop_assert_eq!([form.uu, form.uv, form.vv], [dot(&su, &su), dot(&su, &sv), dot(&sv, &sv)]);
            let minor = |i: usize, j: usize| su[i].clone() * &sv[j] - su[j].clone() * &sv[i];
            prop_assert_eq!(f.normal_at(&u, &v)?, vector![minor(1, 2), minor(2, 0), minor(0, 1)]);
        }
    }

    #[test]
    fn linear_operators_change_no_value(
        f in nurbs_surface::<2>(LOW), raise in 0_usize..3, u_places in indices(2), v_places in indices(2),
    ) {
        let (us, vs) = (insertable(f.u(), &u_places), insertable(f.v(), &v_places));
        agree(&f, &f.through(|lifted| lifted.inserted(U, &us)?.inserted(V, &vs))?)?;
        agree(&f, &f.through(|lifted| lifted.elevated(U, raise))?)?;
        agree(&f, &f.through(|lifted| lifted.elevated(V, raise))?)?;
        agree(&f, &f.through(|lifted| lifted.clamped_ends())?)?;
        let turned = f.through(|lifted| Ok(lifted.transposed()))?;
        for (u, v) in pairs(f.u(), f.v()) {
            prop_assert_eq!(turned.at(&v, &u)?, f.at(&u, &v)?);
        }
        for direction in [U, V] {
            let back = f.through(|lifted| lifted.reversed(direction)?.reversed(direction))?;
            prop_assert!(back.same_function(&f)?);
        }
    }

    #[test]
    fn named_operators_are_those_of_the_lifted_surface(f in nurbs_surface::<2>(LOW), places in indices(2)) {
        let lifted = f.lifted();
        for direction in [U, V] {
            let space = lifted.space(direction);
            let knots = insertable(space, &places);
            let (a, b) = space.domain();
            let x = a.clone() + (b.clone() - a) * Q::frac(2, 7);
            prop_assert_eq!(f.inserted(direction, &knots)?.into_lifted(), lifted.inserted(direction, &knots)?);
            prop_assert_eq!(f.elevated(direction, 1)?.into_lifted(), lifted.elevated(direction, 1)?);
            prop_assert_eq!(f.reversed(direction)?.into_lifted(), lifted.reversed(direction)?);
            let part = lifted.restricted(direction, a, &x)?;
            prop_assert_eq!(f.restricted(direction, a, &x)?.into_lifted(), part);
            let (before, after) = f.split(direction, &x)?;
            prop_assert_eq!((before.into_lifted(), after.into_lifted()), lifted.split(direction, &x)?);
        }
        prop_assert_eq!(f.clamped_ends()?.into_lifted(), lifted.clamped_ends()?);
        prop_assert_eq!(f.transposed()?.into_lifted(), lifted.transposed());
        let (u, v) = (f.u().pieces(f.u().degree())?, f.v().pieces(f.v().degree())?);
        prop_assert_eq!(f.embedded(&u, &v)?.into_lifted(), lifted.embedded(&u, &v)?);
    }

    #[test]
    fn parts_keep_their_values(f in nurbs_surface::<2>(LOW)) {
        let ((a, b), (c, d)) = (f.u().domain(), f.v().domain());
        let middle = |a: &Q, b: &Q| a.clone() + (b.clone() - a) * Q::frac(2, 7);
        let (u, v) = (middle(a, b), middle(c, d));
        let part = f.through(|lifted| lifted.restricted(U, a, &u)?.restricted(V, &v, d))?;
        prop_assert_eq!((part.u().domain(), part.v().domain()), ((a, &u), (&v, d)));
        for (x, y) in pairs(part.u(), part.v()) {
            if x != u {
                prop_assert_eq!(part.at(&x, &y)?, f.at(&x, &y)?);
            }
        }
    }

    #[test]
    fn multiples_and_translations_are_pointwise(f in nurbs_surface::<2>(LOW), s in number(), by in point::<2>()) {
        let (scaled, moved) = (f.scaled(&s)?, f.translated(&by)?);
        for (u, v) in pairs(f.u(), f.v()) {
            let y = f.at(&u, &v)?;
            prop_assert_eq!(scaled.at(&u, &v)?, y.scaled(&s));
            prop_assert_eq!(moved.at(&u, &v)?, y + &by);
        }
        prop_assert!(f.sum(&f)?.same_function(&f.scaled(&Q::int(2))?)?);
        prop_assert_eq!(f.sum(&f)?.denominator()?, f.denominator()?);
    }
}

proptest! {
    #![proptest_config(cases(10))]

    #[test]
    fn sums_and_products_are_pointwise([f, g] in two_nurbs_surfaces::<3>(ANY.of_degree(0, 2))) {
        let (sum, difference) = (f.sum(&g)?, f.difference(&g)?);
        let (dot, cross) = (f.dot(&g)?, f.cross(&g)?);
        for (u, v) in pairs(f.u(), f.v()).iter().chain(&pairs(g.u(), g.v())) {
            let (c, d) = (f.at(u, v)?, g.at(u, v)?);
            prop_assert_eq!(sum.at(u, v)?, &c + &d);
            prop_assert_eq!(difference.at(u, v)?, &c - &d);
            prop_assert_eq!(dot.at(u, v)?, Q::dot(c.iter().zip(d.iter())));
            let minor = |i: usize, j: usize| c[i].clone() * &d[j] - c[j].clone() * &d[i];
            prop_assert_eq!(cross.at(u, v)?, vector![minor(1, 2), minor(2, 0), minor(0, 1)]);
        }
    }

    #[test]
    fn the_product_with_the_divisor_is_the_dividend((f, g) in surface_and_divisor::<2>(ANY.of_degree(0, 1))) {
        let (product, quotient) = (f.times(&g)?, f.divided(&g)?);
        for (u, v) in pairs(f.u(), f.v()).iter().chain(&pairs(g.u(), g.v())) {
            prop_assert_eq!(product.at(u, v)?, f.at(u, v)?.scaled(&g.at(u, v)?));
            prop_assert_eq!(quotient.at(u, v)?, f.at(u, v)?.scaled(&(Q::int(1) / g.at(u, v)?)));
        }
        prop_assert!(product.divided(&g)?.same_function(&f)?);
        prop_assert!(quotient.times(&g)?.same_function(&f)?);
        prop_assert!(!f.same_function(&f.translated(&vector![Q::int(0), Q::frac(1, 7)])?)?);
    }

    #[test]
    fn partial_derivatives_are_rational_surfaces(f in nurbs_surface::<2>(SMOOTH.of_degree(0, 2))) {
        let (along_u, along_v) = (f.derivative(U)?, f.derivative(V)?);
        for (u, v) in pairs(f.u(), f.v()) {
            let all = f.derivatives_at(&u, &v, 1)?;
            prop_assert_eq!(&along_u.at(&u, &v)?, &all[1][0]);
            prop_assert_eq!(&along_v.at(&u, &v)?, &all[0][1]);
        }
    }

    #[test]
    fn partial_derivatives_of_any_order_are_of_so_many_times_the_degrees(
        f in nurbs_surface::<2>(ANY.of_degree(1, 2).smooth(2)),
        k in 0_usize..3,
        l in 0_usize..3,
    ) {
        let derived = f.partial(k, l)?;
        let degrees = [f.u(), f.v()].map(|space| (k + l + 1) * space.degree());
        prop_assert_eq!([derived.u(), derived.v()].map(|space| space.degree()), degrees);
        for (u, v) in pairs(f.u(), f.v()) {
            prop_assert_eq!(&derived.at(&u, &v)?, &f.derivatives_at(&u, &v, k + l)?[k][l]);
        }
    }

    #[test]
    fn mixed_derivatives_commute(f in nurbs_surface::<2>(ANY.of_degree(1, 1).smooth(1))) {
        let (uv, vu) = (f.derivative(U)?.derivative(V)?, f.derivative(V)?.derivative(U)?);
        prop_assert!(uv.same_function(&vu)?);
        for (u, v) in pairs(f.u(), f.v()) {
            prop_assert_eq!(&uv.at(&u, &v)?, &f.derivatives_at(&u, &v, 1)?[1][1]);
        }
    }
}

/// The surface of revolution of a profile in the plane of `x` and `z` around the `z`-axis.
fn revolved(profile: &NurbsCurve<Q, 2>) -> symspline::Result<NurbsSurface<Q, 3>> {
    let round = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
    let lift = |p: &SVector<Q, 2>, w: &Q| (p[0].clone(), p[1].clone(), w.clone());
    let (mut points, mut weights) = (Vec::new(), Vec::new());
    for (p, w) in profile.points()?.iter().zip(profile.weights()) {
        let (x, z, w) = lift(p, w);
        for (r, v) in round.points()?.iter().zip(round.weights()) {
            points.push(vector![x.clone() * &r[0], x.clone() * &r[1], z.clone()]);
            weights.push(w.clone() * v);
        }
    }
    NurbsSurface::new(profile.space().clone(), round.space().clone(), points, weights)
}

fn plane(x: i64, y: i64) -> SVector<Q, 2> {
    vector![Q::int(x), Q::int(y)]
}

/// Parameters inside and on the boundary of `[0, 1]`.
fn grid() -> Vec<Q> {
    (0..=20).map(|i| Q::frac(i, 20)).chain([Q::frac(1, 3), Q::frac(5, 7)]).collect()
}

#[test]
fn a_sphere_is_a_sphere() {
    let radius = Q::int(5);
    // From the south pole over (3, -4) on the way to the north pole.
    let meridian = arc(&plane(0, 0), &plane(0, -5), &plane(0, 5)).unwrap();
    let sphere = revolved(&meridian).unwrap();
    let squared = sphere.dot(&sphere).unwrap();
    let level =
        TensorSpline::constant(sphere.u().clone(), sphere.v().clone(), radius.clone() * &radius).unwrap();
    assert!(squared.same_function(&Rational::from_polynomial(&level).unwrap()).unwrap());
    assert!(sphere.normal_at(&Q::int(0), &Q::frac(1, 3)).unwrap().vanishes(), "at the pole");
    for u in grid() {
        for v in grid() {
            let [s, su, sv] = sphere.tangents_at(&u, &v).unwrap();
            let across = |c: &SVector<Q, 3>| Q::dot(c.iter().zip(s.iter()));
            assert_eq!((across(&su), across(&sv)), (Q::int(0), Q::int(0)));
            assert_eq!(Q::dot(s.iter().zip(s.iter())), Q::int(25));
        }
    }
}

#[test]
fn the_forms_of_a_sphere_are_proportional() {
    let meridian = arc(&plane(0, 0), &plane(0, -5), &plane(0, 5)).unwrap();
    let sphere = revolved(&meridian).unwrap().to_f64().unwrap();
    for (u, v) in [(0.1, 0.2), (0.5, 0.77), (0.9, 0.3)] {
        let (first, second) = (sphere.first_form_at(&u, &v).unwrap(), sphere.second_form_at(&u, &v).unwrap());
        let normal = sphere.unit_normal_at(&u, &v).unwrap();
        let side = normal.dot(&sphere.at(&u, &v).unwrap()).signum();
        for (one, two) in [(first.uu, second.uu), (first.uv, second.uv), (first.vv, second.vv)] {
            assert!((two * 5.0 + side * one).abs() <= 1e-13 * (first.uu + first.vv), "{one} {two}");
        }
    }
}

#[test]
fn a_torus_is_a_torus() {
    let (big, small) = (Q::int(7), Q::int(2));
    let torus = revolved(&circle(&plane(7, 0), &small).unwrap()).unwrap();
    for u in grid() {
        for v in grid() {
            let s = torus.at(&u, &v).unwrap();
            let round = s[0].clone() * &s[0] + s[1].clone() * &s[1];
            let all = round.clone() + s[2].clone() * &s[2] + big.clone() * &big - small.clone() * &small;
            assert_eq!(all.clone() * &all, Q::int(4) * &big * &big * round);
        }
    }
}

#[test]
fn a_flat_patch_of_wild_weights_is_flat() {
    let (u, v) =
        (SplineSpace::uniform(2, 3, Q::int(0), Q::int(1)), SplineSpace::uniform(1, 2, Q::int(0), Q::int(1)));
    let (u, v) = (u.unwrap(), v.unwrap());
    let count = u.dim() * v.dim();
    let points = (0..count as i64).map(|i| vector![Q::int(i % 3), Q::int(i / 3), Q::int(4)]).collect();
    let weights = (0..count as i64).map(|i| Q::frac(1 + 7 * i, 1 + (i * i) % 11)).collect();
    let patch = NurbsSurface::new(u.clone(), v.clone(), points, weights).unwrap();
    let height =
        Rational::<Rectangle, Q>::from_polynomial(&TensorSpline::constant(u, v, Q::int(4)).unwrap()).unwrap();
    assert!(patch.coordinate(2).unwrap().same_function(&height).unwrap());
    assert!(!patch.coordinate(1).unwrap().same_function(&height).unwrap());
}

#[test]
fn bad_surfaces_are_refused() {
    let line = SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap();
    let points = vec![Q::int(1); 4];
    let make = |points: &[Q], weights: &[i64]| {
        let weights = weights.iter().map(|w| Q::int(*w)).collect();
        Rational::<Rectangle, Q>::new(line.clone(), line.clone(), points.to_vec(), weights)
    };
    assert_eq!(make(&points, &[1, 1, 0, 1]).unwrap_err(), Error::Weight { index: 2, weight: "0".into() });
    assert_eq!(make(&points, &[1, 1, 1]).unwrap_err(), Error::CoefficientCount { expected: 4, found: 3 });
    assert_eq!(
        make(&points[..3], &[1, 1, 1]).unwrap_err(),
        Error::CoefficientCount { expected: 4, found: 3 }
    );
    let flat = make(&points, &[1, 2, 3, 4]).unwrap();
    assert!(matches!(flat.at(&Q::int(2), &Q::int(0)), Err(Error::OutsideDomain { .. })));
    assert!(matches!(flat.isocurve(V, &Q::int(2)), Err(Error::OutsideDomain { .. })));
    assert_eq!(flat.points().unwrap(), points);
}

#[test]
fn polynomial_surfaces_stay_what_they_are() {
    let line = SplineSpace::bezier(1, Q::int(0), Q::int(1)).unwrap();
    let corners =
        [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 1]].map(|c| SVector::from_column_slice(&c.map(Q::int)));
    let saddle: Surface<Q, 3> = Surface::new(line.clone(), line, corners.to_vec()).unwrap();
    let lifted: NurbsSurface<Q, 3> = Rational::from_polynomial(&saddle).unwrap();
    let half = Q::frac(1, 2);
    assert_eq!(
        lifted.derivatives_at(&half, &half, 2).unwrap(),
        saddle.derivatives_at(&half, &half, 2).unwrap()
    );
    let border: Spline<Q, SVector<Q, 3>> = saddle.isocurve(U, &half).unwrap();
    assert_eq!(lifted.isocurve(U, &half).unwrap().numerator().unwrap(), border);
}
