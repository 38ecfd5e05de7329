//! Laws of calculus, as expressions over random exact splines.

use crate::calc::evaluate::{Names, evaluate};
use proptest::prelude::*;
use symspline::{Function, Q, Scalar, SplineSpace};
use symspline_dynamic::{AnySpline, Number, Value};

/// A spline over [0, 2] of degree 1 to 3 that is continuous, with knots in sixths, `dim` coordinates.
fn spline(dim: usize) -> impl Strategy<Value = Value> {
    let knots = prop::collection::btree_set(1..12_i64, 0..4);
    (1..4_usize, knots).prop_flat_map(move |(degree, knots)| {
        let inner = knots.iter().map(|k| Q::frac(*k, 6));
        let breaks: Vec<Q> = [Q::int(0)].into_iter().chain(inner).chain([Q::int(2)]).collect();
        let space = SplineSpace::clamped(degree, breaks).unwrap();
        let numbers = prop::collection::vec((-9..10_i64, 1..5_i64), space.dim() * dim);
        numbers.prop_map(move |numbers| {
            let coords = numbers.iter().map(|(p, q)| Q::frac(*p, *q)).collect();
            let coords = symspline_dynamic::Coords::Exact(coords);
            AnySpline::new(space.clone().into(), dim, coords).unwrap().into()
        })
    })
}

fn names(bound: &[(&str, &Value)]) -> Names {
    bound.iter().map(|(name, value)| ((*name).to_owned(), (*value).clone())).collect()
}

/// The expression is 1: a law holds.
fn holds(text: &str, names: &Names) -> bool {
    evaluate(text, names).unwrap().0 == Number::Exact(Q::int(1)).into()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn leibniz(f in spline(1), c in spline(2)) {
        let names = names(&[("f", &f), ("C", &c)]);
        prop_assert!(holds("same(diff(f * C), diff(f) * C + f * diff(C))", &names));
        prop_assert!(holds("same(diff(dot(C, C)), 2 * dot(C, diff(C)))", &names));
    }

    #[test]
    fn fundamental_theorem(f in spline(1), c in spline(3), a in 0..12_i64, b in 0..12_i64) {
        let names = names(&[("f", &f), ("C", &c)]);
        prop_assert!(holds("same(diff(integral(C)), C)", &names));
        prop_assert!(holds("same(at(C, 0) + integral(diff(C)), C)", &names));
        let (a, b) = (format!("{a}/6"), format!("{b}/6"));
        let law = &format!("same(at(f, {b}) - at(f, {a}), integral(diff(f), {a}, {b}))");
        prop_assert!(holds(law, &names));
    }

    #[test]
    fn fine_tuning_by_its_formula(f in spline(1), c in spline(2)) {
        // D = C(a) + ∫ α C' starts where C does and has the derivative α C'.
        let names = names(&[("a", &f), ("C", &c)]);
        let tuned = "(at(C, 0) + integral(a * diff(C)))";
        let law = &format!("same(diff({tuned}), a * diff(C)) * same(at({tuned}, 0), at(C, 0))");
        prop_assert!(holds(law, &names));
    }

    #[test]
    fn rings_and_coordinates(f in spline(1), g in spline(1), c in spline(2)) {
        let names = names(&[("f", &f), ("g", &g), ("C", &c)]);
        prop_assert!(holds("same((f + g) * (f - g), f * f - g * g)", &names));
        prop_assert!(holds("same(-(f * C), curve(-f * x(C), -f * y(C)))", &names));
        prop_assert!(holds("same(inner(f, g), integral(f * g, 0, 2))", &names));
        prop_assert!(holds("same(cross(C, f * C), 0 * f)", &names));
    }

    #[test]
    fn chain_rule(c in spline(2)) {
        // Broken lines meet rational knots at rational parameters; g goes up, down and up.
        let names = names(&[("C", &c)]);
        let g = "reparam(uniform(1, 0, 5/3, 1/2, 2), 0, 2)";
        let law = &format!("same(diff(C @ {g}), diff({g}) * (diff(C) @ {g}))");
        prop_assert!(holds(law, &names));
    }

    #[test]
    fn edits_keep_the_function(c in spline(3), k in 1..4_usize) {
        let names = names(&[("C", &c)]);
        let law = &format!("same(simplify(insert(elevate(C, {k}), 1/7, 5/3)), C)");
        prop_assert!(holds(law, &names));
        let law = &format!("same(reduce(elevate(C, {k}), {k}), C)");
        prop_assert!(holds(law, &names));
        prop_assert!(holds("same(reverse(reverse(C)), C)", &names));
        prop_assert!(holds("same(join(restrict(C, 0, 1), restrict(C, 1, 2)), C)", &names));
        prop_assert!(holds("same(reparam(C, 0, 1) @ (param(0, 2) / 2), C)", &names));
        prop_assert!(holds("same(clamp(C), rational(C))", &names));
    }
}

#[test]
fn a_law_that_does_not_hold_is_seen() {
    let f = Function::monomial(2, Q::int(0), Q::int(2)).unwrap();
    let names = names(&[("f", &Value::Spline(f.into()))]);
    assert!(!holds("same(diff(f * f), diff(f) * diff(f))", &names));
}
