//! Laws of denominators: what has no zero is let in, whatever its coefficients; what has one is refused, in finite time.

use crate::strategies::{ANY, CLAMPED, Kind, cases, function, probes, space};
use proptest::prelude::*;
use symspline::{
    Error, Function, Interval, Q, Rational, RationalFunction, Rectangle, Scalar, SplineSpace, TensorSpline,
};

const LOW: Kind = ANY.of_degree(0, 4);

/// One over `bottom`.
fn inverse(bottom: &Function<Q>) -> symspline::Result<RationalFunction<Q>> {
    RationalFunction::from_quotient(&Function::constant(bottom.space().clone(), Q::int(1))?, bottom)
}

/// One over a surface.
fn inverse_surface(bottom: &TensorSpline<Q>) -> symspline::Result<Rational<Rectangle, Q>> {
    let one = TensorSpline::constant(bottom.u().clone(), bottom.v().clone(), Q::int(1))?;
    Rational::<Rectangle, Q>::from_quotient(&one, bottom)
}

/// Whether it was refused for a zero that is there.
fn refused<T>(result: &symspline::Result<T>) -> bool {
    matches!(result, Err(Error::Pole | Error::Undecided))
}

/// `c_0 + c_1 x + c_2 x² + ...` on `[a, b]`.
fn polynomial(coeffs: &[Q], a: &Q, b: &Q) -> Function<Q> {
    let powers = coeffs.iter().enumerate().map(|(k, c)| {
        Function::monomial(k, a.clone(), b.clone()).and_then(|power| power.scaled(c)).expect("a monomial")
    });
    powers.reduce(|f, g| f + g).expect("at least one coefficient")
}

/// The scalar surface `f(u) g(v)`.
fn outer(f: &Function<Q>, g: &Function<Q>) -> TensorSpline<Q> {
    let coeffs = f.coeffs().iter().flat_map(|c| g.coeffs().iter().map(move |d| c.clone() * d)).collect();
    TensorSpline::new(f.space().clone(), g.space().clone(), coeffs).expect("a grid")
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn a_square_and_more_has_no_zero(g in function(LOW), floor in 1_i64..100) {
        let largest = g.coeffs().iter().map(Q::abs).max().expect("a coefficient");
        let floor = (largest.clone() * &largest + Q::int(1)) / Q::int(floor * floor * floor);
        let bottom = g.times(&g)?.translated(&floor)?;
        let (over, under) = (inverse(&bottom)?, inverse(&-&bottom)?);
        for x in probes(bottom.space()) {
            let square = g.at(&x)? * g.at(&x)?;
            prop_assert_eq!(over.at(&x)?, Q::int(1) / (square + &floor));
            prop_assert_eq!(under.at(&x)?, -over.at(&x)?);
        }
        // The denominator is positive however it came.
        prop_assert!(probes(bottom.space()).iter().all(|x| under.denominator().unwrap().at(x).unwrap() > Q::int(0)));
    }

    #[test]
    fn a_change_of_sign_is_a_zero(f in function(LOW)) {
        let values = probes(f.space()).iter().map(|x| Ok((f.at(x)?, f.at_left(x)?))).collect::<Result<Vec<_>, Error>>()?;
        let any = |test: &dyn Fn(&Q) -> bool| values.iter().any(|(y, z)| test(y) || test(z));
        let zero = Q::int(0);
        if any(&|y| *y <= zero) && any(&|y| *y >= zero) {
            prop_assert!(refused(&inverse(&f)));
        }
    }

    #[test]
    fn a_double_zero_is_refused(p in 1_i64..40, q in 1_i64..40, raise in 0_usize..5, flip in any::<bool>()) {
        prop_assume!(p < q);
        let root = Q::frac(p, q);
        let square = polynomial(&[root.clone() * &root, Q::int(-2) * &root, Q::int(1)], &Q::int(0), &Q::int(1));
        let square = square.elevated(raise)?;
        let bottom = if flip { -square } else { square };
        prop_assert!(refused(&inverse(&bottom)));
    }

    #[test]
    fn an_irrational_double_zero_is_refused(d in 2_i64..30, raise in 0_usize..7, flip in any::<bool>()) {
        let irrational = (1..6).all(|i| i * i != d);
        prop_assume!(irrational);
        // (x² - d)²
        let quartic = polynomial(&[d * d, 0, -2 * d, 0, 1].map(Q::int), &Q::int(0), &Q::int(7));
        let quartic = quartic.elevated(raise)?;
        let bottom = if flip { -quartic } else { quartic };
        prop_assert!(refused(&inverse(&bottom)));
    }

    #[test]
    fn a_zero_anywhere_is_found(space in space(CLAMPED.of_degree(1, 4)), i in any::<prop::sample::Index>()) {
        // Ones, but for one coefficient that pulls the spline below zero under its peak.
        let i = i.index(space.dim());
        let coeffs = (0..space.dim()).map(|j| Q::int(if i == j { -10_000_000_000 } else { 1 })).collect();
        let f = Function::new(space, coeffs)?;
        let negative = probes(f.space()).iter().any(|x| f.at(x).unwrap() <= Q::int(0));
        if negative {
            prop_assert!(refused(&inverse(&f)));
        }
    }

    #[test]
    fn close_to_zero_is_not_zero(p in 1_i64..40, q in 1_i64..40, digits in 1_u32..19) {
        prop_assume!(p < q);
        let (root, floor) = (Q::frac(p, q), Q::frac(1, 10_i64.pow(digits)));
        let bottom = [root.clone() * &root + &floor, Q::int(-2) * &root, Q::int(1)];
        let f = inverse(&polynomial(&bottom, &Q::int(0), &Q::int(1)))?;
        prop_assert_eq!(f.at(&root)?, Q::int(1) / floor);
    }
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn surfaces_without_zero_are_let_in(
        f in function(ANY.of_degree(0, 2)), g in function(ANY.of_degree(0, 2)), floor in 1_i64..100,
    ) {
        let wave = outer(&f, &g);
        let largest = wave.coeffs().iter().map(Q::abs).max().expect("a coefficient");
        let floor = (largest.clone() * &largest + Q::int(1)) / Q::int(floor * floor);
        let bottom = wave.times(&wave)?.translated(&floor)?;
        let (over, under) = (inverse_surface(&bottom)?, inverse_surface(&-&bottom)?);
        for u in probes(f.space()) {
            for v in probes(g.space()) {
                let y = f.at(&u)? * g.at(&v)?;
                prop_assert_eq!(over.at(&u, &v)?, Q::int(1) / (y.clone() * &y + &floor));
                prop_assert_eq!(under.at(&u, &v)?, -over.at(&u, &v)?);
            }
        }
    }

    #[test]
    fn surfaces_with_a_zero_are_refused(f in function(ANY.of_degree(0, 2)), g in function(ANY.of_degree(0, 2))) {
        let zero = |f: &Function<Q>| probes(f.space()).iter().any(|x| f.at(x).unwrap() == Q::int(0));
        prop_assume!(zero(&f) || zero(&g));
        let wave = outer(&f, &g);
        prop_assert!(refused(&inverse_surface(&wave)));
        prop_assert!(refused(&inverse_surface(&wave.times(&wave)?)));
    }
}

#[test]
fn zeros_along_lines_and_curves_are_refused() {
    let (zero, one) = (Q::int(-1), Q::int(1));
    let power = |k: usize| Function::monomial(k, zero.clone(), one.clone()).unwrap();
    let (x, x2) = (power(1), power(2));
    let unit = power(0);
    let term = |f: &Function<Q>, g: &Function<Q>| outer(f, g);
    // (u - v)², (u² + v² - 1/3)², u² + v², (u + v - 1/7)²
    let diagonal = term(&x, &unit) - term(&unit, &x);
    let round = term(&x2, &unit) + term(&unit, &x2);
    let circle = round.translated(&Q::frac(-1, 3)).unwrap();
    let oblique = (term(&x, &unit) + term(&unit, &x)).translated(&Q::frac(-1, 7)).unwrap();
    for bottom in [diagonal.times(&diagonal), circle.times(&circle), Ok(round), oblique.times(&oblique)] {
        assert!(refused(&inverse_surface(&bottom.unwrap())));
    }
    for bottom in [diagonal, circle, oblique] {
        assert!(refused(&inverse_surface(&bottom)));
    }
}

#[test]
fn a_zero_at_an_end_or_a_knot_is_a_pole() {
    let space = SplineSpace::clamped(1, [0, 1, 2].map(Q::int)).unwrap();
    for i in 0..3 {
        for sign in [1, -1] {
            let coeffs = (0..3).map(|j| Q::int(if i == j { 0 } else { sign })).collect();
            let f = Function::new(space.clone(), coeffs).unwrap();
            assert_eq!(inverse(&f).unwrap_err(), Error::Pole);
        }
    }
    let all_zero = Function::constant(space, Q::int(0)).unwrap();
    assert_eq!(inverse(&all_zero).unwrap_err(), Error::Pole);
}

#[test]
fn a_zero_at_a_corner_is_a_pole() {
    let space = SplineSpace::bezier(2, Q::int(0), Q::int(1)).unwrap();
    for corner in [0, 2, 6, 8] {
        for sign in [1, -1] {
            let coeffs = (0..9).map(|i| Q::int(if i == corner { 0 } else { sign })).collect();
            let bottom = TensorSpline::new(space.clone(), space.clone(), coeffs).unwrap();
            assert_eq!(inverse_surface(&bottom).unwrap_err(), Error::Pole);
        }
    }
}

#[test]
fn every_patch_of_a_surface_is_looked_at() {
    let (u, v) =
        (SplineSpace::uniform(1, 3, Q::int(0), Q::int(1)), SplineSpace::uniform(1, 2, Q::int(0), Q::int(1)));
    let (u, v) = (u.unwrap(), v.unwrap());
    for below in 0..12 {
        let coeffs = (0..12).map(|i| Q::int(if i == below { -1 } else { 1 })).collect();
        let bottom = TensorSpline::new(u.clone(), v.clone(), coeffs).unwrap();
        assert_eq!(inverse_surface(&bottom).unwrap_err(), Error::Pole);
    }
}

#[test]
fn a_limit_of_zero_at_a_jump_is_a_pole() {
    // From 1 down to 0, then a jump to 1.
    let space = SplineSpace::clamped(1, [0, 1, 1, 2].map(Q::int)).unwrap();
    let f = Function::new(space, [1, 0, 1, 1].map(Q::int).to_vec()).unwrap();
    assert_eq!(inverse(&f).unwrap_err(), Error::Pole);
    let steps = SplineSpace::clamped(0, [0, 1, 2].map(Q::int)).unwrap();
    let f = Function::new(steps.clone(), [1, -1].map(Q::int).to_vec()).unwrap();
    assert_eq!(inverse(&f).unwrap_err(), Error::Pole);
    let f = Function::new(steps, [-1, -3].map(Q::int).to_vec()).unwrap();
    assert_eq!(inverse(&f).unwrap().at(&Q::int(2)).unwrap(), Q::frac(-1, 3));
}

#[test]
fn many_pieces_that_need_a_look_are_no_reason_to_give_up() {
    // Each piece has the Bernstein coefficients 1, -9/10, 1: a few bisections each.
    let pieces = 12_000;
    let breaks = (0..=pieces).flat_map(|i| {
        let copies = if i == 0 || i == pieces { 1 } else { 2 };
        std::iter::repeat_n(Q::int(i), copies)
    });
    let space = SplineSpace::clamped(2, breaks).unwrap();
    let coeffs = (0..space.dim()).map(|i| if i % 2 == 0 { Q::int(1) } else { Q::frac(-9, 10) }).collect();
    let f = inverse(&Function::new(space, coeffs).unwrap()).unwrap();
    assert_eq!(f.at(&Q::frac(1, 2)).unwrap(), Q::int(20));
}

#[test]
fn a_sign_is_found_on_rings_and_without_clamped_ends() {
    let ring = SplineSpace::periodic(2, [0, 1, 2, 3].map(Q::int), Q::int(4)).unwrap();
    let coeffs = [Q::int(1), Q::frac(-1, 10), Q::int(1), Q::int(1)].to_vec();
    let f = inverse(&Function::new(ring.clone(), coeffs).unwrap()).unwrap();
    assert!(f.space().is_periodic());
    let coeffs = [Q::int(1), Q::frac(-1, 2), Q::int(1), Q::int(1)].to_vec();
    assert_eq!(inverse(&Function::new(ring, coeffs).unwrap()).unwrap_err(), Error::Pole);
    // Unclamped: the first coefficient is negative, the values on the domain are not.
    let open = SplineSpace::new(1, [-1, 0, 1, 2, 100].map(Q::int)).unwrap();
    let f = Function::new(open, [1, 2, 1].map(Q::int).to_vec()).unwrap();
    assert!(inverse(&f).is_ok());
    let outer = SplineSpace::new(2, [-100, -50, 0, 1, 2, 3].map(Q::int)).unwrap();
    let f = Function::new(outer, [-1, 100, 1].map(Q::int).to_vec()).unwrap();
    assert!(inverse(&f).is_ok(), "{:?}", f.clamped_ends());
}

#[test]
fn floating_point_denominators_end_too() {
    for root in [0.1, 1.0 / 3.0, 0.5, std::f64::consts::FRAC_1_SQRT_2] {
        for degree in [2, 5, 20, 60] {
            let space = SplineSpace::bezier(2, 0.0, 1.0).unwrap();
            let square = [root * root, -root * (1.0 - root), (1.0 - root) * (1.0 - root)].to_vec();
            let square = Function::new(space, square).unwrap().elevated(degree - 2).unwrap();
            let one = Function::constant(square.space().clone(), 1.0).unwrap();
            // Whether it still has a zero is a matter of rounding. That there is an answer is not.
            let _ = Rational::<Interval, f64>::from_quotient(&one, &square);
        }
    }
}
