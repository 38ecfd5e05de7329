//! Laws of composition.

use crate::strategies::{ANY, CLAMPED, Kind, OPEN, cases, function, number, probes};
use nalgebra::SVector;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Coeff, Curve, Error, Function, Q, Scalar, Spline, SplineSpace};

/// An outer space but for its domain and where its knots may be.
#[derive(Clone, Debug)]
struct Outer {
    degree: usize,
    shape: usize,
    places: Vec<(Index, usize)>,
    margins: [i64; 2],
    coeffs: Vec<[Q; 2]>,
}

fn outer(high: usize) -> impl Strategy<Value = Outer> {
    let places = vec((any::<Index>(), 1_usize..=4), 0..=4);
    let coeffs = vec([number(), number()], 48);
    (0..=high, 0_usize..3, places, [0_i64..3, 0_i64..3], coeffs)
        .prop_map(|(degree, shape, places, margins, coeffs)| Outer { degree, shape, places, margins, coeffs })
}

impl Outer {
    /// The space with knots among `knots`, whose domain holds `[low, high]`; `smooth` derivatives are splines.
    fn space(&self, low: &Q, high: &Q, knots: &[Q], smooth: usize) -> SplineSpace<Q> {
        let p = self.degree;
        let a = low.clone() - Q::int(self.margins[0]);
        let b = high.clone() + Q::int(self.margins[1]);
        let b = if a == b { b + Q::int(1) } else { b };
        let inside: Vec<&Q> = knots.iter().filter(|t| a < **t && **t < b).collect();
        let mut chosen: Vec<(Q, usize)> = Vec::new();
        if !inside.is_empty() {
            chosen = self.places.iter().map(|(at, m)| (at.get(&inside).to_owned().clone(), *m)).collect();
            chosen.sort();
            chosen.dedup_by(|x, y| x.0 == y.0);
        }
        let copies = chosen.into_iter().flat_map(|(t, m)| std::iter::repeat_n(t, m.min(p + 1 - smooth)));
        let space = if self.shape == 2 {
            SplineSpace::periodic(p, [a.clone()].into_iter().chain(copies), b - a)
        } else {
            SplineSpace::clamped(p, [a].into_iter().chain(copies).chain([b]))
        };
        let space = space.expect("ascending knots");
        if self.shape == 1 && p > 0 { space.unclamped_ends().unwrap_or(space) } else { space }
    }

    fn function(&self, space: &SplineSpace<Q>, which: usize) -> Function<Q> {
        let coeffs = self.coeffs[..space.dim()].iter().map(|c| c[which].clone()).collect();
        Function::new(space.clone(), coeffs).expect("as many coefficients as the space has")
    }

    fn curve(&self, space: &SplineSpace<Q>) -> Curve<Q, 2> {
        let coeffs =
            self.coeffs[..space.dim()].iter().map(|c| SVector::from_fn(|i, _| c[i].clone())).collect();
        Curve::new(space.clone(), coeffs).expect("as many coefficients as the space has")
    }
}

/// The same spline with ascending or descending coefficients that are not all the same.
fn sorted(g: &Function<Q>, down: bool) -> Function<Q> {
    let mut coeffs = g.coeffs().to_vec();
    coeffs.sort();
    // Strictly, so that no span is flat.
    coeffs.iter_mut().enumerate().for_each(|(i, c)| *c += Q::frac(i as i64, 3));
    if down {
        coeffs.reverse();
    }
    Function::new(g.space().clone(), coeffs).expect("as many coefficients as the space has")
}

/// The values of a function at the probes of its space.
fn values(g: &Function<Q>) -> Vec<Q> {
    probes(g.space()).iter().map(|x| g.at(x).expect("probes are in the domain")).collect()
}

fn extremes(values: &[Q]) -> (Q, Q) {
    let (low, high) = (values.iter().min(), values.iter().max());
    (low.expect("a value").clone(), high.expect("a value").clone())
}

/// An inner function and an outer space such that all cuts are rational: the inner function is monotone and the knots are among its values,
/// or it is piecewise linear, or there are no knots.
fn pair(smooth: usize) -> impl Strategy<Value = (Outer, SplineSpace<Q>, Function<Q>)> {
    let low = smooth.min(1);
    let kind = |kind: Kind, low, high| function(kind.of_degree(low, high).smooth(smooth));
    let monotone = (kind(OPEN, 1, 3), any::<bool>(), outer(3)).prop_map(move |(g, down, outer)| {
        let g = sorted(&g, down);
        let values = values(&g);
        let (a, b) = extremes(&values);
        (outer, a, b, values, g)
    });
    let linear = (kind(ANY, low, 1), vec(number(), 4), outer(4)).prop_map(move |(g, mut knots, outer)| {
        let (a, b) = extremes(g.coeffs());
        // Some knots where the inner function has its own, and ends.
        knots.extend(g.coeffs().iter().cloned());
        (outer, a, b, knots, g)
    });
    let free = (kind(ANY, low, 4), outer(3)).prop_map(move |(g, outer)| {
        let (a, b) = extremes(g.coeffs());
        (outer, a, b, Vec::new(), g)
    });
    prop_oneof![3 => monotone, 3 => linear, 1 => free].prop_map(move |(mut outer, a, b, knots, g)| {
        outer.degree = outer.degree.max(smooth);
        let space = outer.space(&a, &b, &knots, smooth);
        (outer, space, g)
    })
}

/// Whether `value` is that of `f` at `x` from one side or the other.
fn is_limit<C: Coeff<Q>>(f: &Spline<Q, C>, x: &Q, value: &C) -> symspline::Result<bool> {
    let left = if x == f.domain().0 { f.at(x)? } else { f.at_left(x)? };
    Ok(*value == f.at(x)? || *value == left)
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn values_are_values_of_values((outer, space, g) in pair(0)) {
        let f = outer.curve(&space);
        let composed = f.composed(&g)?;
        prop_assert_eq!(composed.degree(), f.degree() * g.degree());
        prop_assert_eq!((composed.domain(), composed.space().is_periodic()), (g.domain(), g.space().is_periodic()));
        for x in probes(composed.space()).iter().chain(&probes(g.space())) {
            prop_assert!(is_limit(&f, &g.at(x)?, &composed.at(x)?)?, "right of {x}");
            prop_assert!(is_limit(&f, &g.at_left(x)?, &composed.at_left(x)?)?, "left of {x}");
        }
    }

    #[test]
    fn composition_is_a_map((outer, space, g) in pair(0)) {
        let f = outer.curve(&space);
        let (target, map) = space.composition(&g)?;
        prop_assert_eq!(Curve::new(target, map.apply(f.coeffs())?)?, f.composed(&g)?);
    }

    #[test]
    fn chain_rule((outer, space, g) in pair(1)) {
        let f = outer.curve(&space);
        let expected = f.derivative()?.composed(&g)?.times(&g.derivative()?)?;
        prop_assert!(f.composed(&g)?.derivative()?.same_function(&expected)?);
    }

    #[test]
    fn products_are_composed_by_factors((outer, space, g) in pair(0)) {
        let [f, h] = [0, 1].map(|which| outer.function(&space, which));
        let expected = &f.composed(&g)? * &h.composed(&g)?;
        prop_assert!((&f * &h).composed(&g)?.same_function(&expected)?);
    }

    #[test]
    fn composition_is_associative(
        h in function(CLAMPED.of_degree(1, 2).smooth(1)),
        (one, two) in (outer(2), outer(2)),
        (down, up) in any::<(bool, bool)>(),
    ) {
        let h = sorted(&h, down);
        let inner = values(&h);
        let (a, b) = extremes(&inner);
        let one = Outer { shape: 0, margins: [0, 0], degree: one.degree.max(1), ..one };
        let g = sorted(&one.function(&one.space(&a, &b, &inner, 1), 0), up);
        let outer: Vec<Q> = inner.iter().map(|x| g.at(x)).collect::<Result<_, _>>()?;
        let (a, b) = extremes(&outer);
        let f = two.curve(&two.space(&a, &b, &outer, 0));
        let (left, right) = (f.composed(&g)?.composed(&h)?, f.composed(&g.composed(&h)?)?);
        prop_assert!(left.same_function(&right)?);
    }

    #[test]
    fn identity_changes_nothing(f in function(ANY.of_degree(0, 4))) {
        let (a, b) = f.domain();
        let identity = Function::monomial(1, a.clone(), b.clone())?;
        prop_assert_eq!(f.composed(&identity)?, f.clamped_ends()?);
        prop_assert_eq!(f.reparametrised_by(&identity)?, f.clamped_ends()?);
        let (low, high) = extremes(f.coeffs());
        let wide = Function::monomial(1, low - Q::int(1), high)?;
        let same = wide.composed(&f)?;
        prop_assert_eq!(same, if f.space().is_periodic() { f } else { f.clamped_ends()? });
    }

    #[test]
    fn affine_functions_move_and_turn(f in function(ANY.of_degree(0, 4)), start in number(), n in 1_i64..9, d in 1_i64..9) {
        let end = start.clone() + Q::frac(n, d);
        let (a, b) = f.domain();
        let onto = |c: &Q, d: &Q| Function::new(SplineSpace::bezier(1, start.clone(), end.clone())?, vec![c.clone(), d.clone()]);
        let moved = f.reparametrised(&start, &end)?;
        prop_assert_eq!(f.composed(&onto(a, b)?)?, moved.clamped_ends()?);
        prop_assert_eq!(f.reparametrised_by(&onto(a, b)?)?, moved.clamped_ends()?);
        prop_assert_eq!(f.composed(&onto(b, a)?)?, moved.reversed()?.clamped_ends()?);
    }

    #[test]
    fn increasing_functions_reparametrise(
        g in function(OPEN.of_degree(1, 3).smooth(1)),
        outer in outer(3),
        down: bool,
    ) {
        let g = sorted(&g, down);
        let (a, b) = extremes(&values(&g));
        let tight = Outer { margins: [0, 0], ..outer };
        let f = tight.curve(&tight.space(&a, &b, &values(&g), 0));
        let moved = f.reparametrised_by(&g);
        if down {
            prop_assert!(matches!(moved, Err(Error::NotIncreasing { .. })), "{moved:?}");
            return Ok(());
        }
        prop_assert_eq!(moved?, f.composed(&g)?);
        let wide = Outer { margins: [1, 0], ..tight };
        let wide = wide.curve(&wide.space(&a, &b, &[], 0)).reparametrised_by(&g);
        prop_assert!(matches!(wide, Err(Error::DomainMismatch { .. })), "{wide:?}");
    }

    #[test]
    fn what_leaves_the_domain_is_refused((outer, _, g) in pair(0), cut in 1_i64..9) {
        let values = values(&g);
        let (low, high) = extremes(&values);
        prop_assume!(low < high);
        let end = low.clone() + (high.clone() - &low) * Q::frac(cut, 10);
        let outer = Outer { margins: [0, 0], ..outer };
        for (a, b) in [(&low, &end), (&end, &high)] {
            // Coefficients reach further than values.
            let f = outer.curve(&outer.space(a, b, &[], 0));
            match f.composed(&g) {
                Err(Error::LeavesDomain { parameter, value, .. }) => {
                    let x: Q = parameter.parse()?;
                    let there = g.at(&x)?;
                    let left = g.at_left(&x)?;
                    prop_assert!(there < *a || there > *b || left < *a || left > *b);
                    prop_assert!(value == there.to_string() || value == left.to_string());
                }
                other => return Err(TestCaseError::fail(format!("{other:?}"))),
            }
        }
    }

    #[test]
    fn square_roots_are_rational_or_enclosed(n in 1_i64..60, d in 1_i64..30) {
        let square = Function::monomial(2, Q::int(0), Q::int(8))?;
        let knot = Q::frac(n, d);
        let f = Function::new(SplineSpace::clamped(1, [Q::int(0), knot.clone(), Q::int(64)])?, [0, 1, 0].map(Q::int).to_vec())?;
        let root = |n: &num_bigint::BigInt| n.sqrt();
        let (p, q) = (root(&knot.numer()), root(&knot.denom()));
        let guess = Q::from(p) / Q::from(q);
        match f.composed(&square) {
            Ok(composed) => {
                prop_assert_eq!(&guess * &guess, knot);
                prop_assert_eq!(&composed.space().breaks()[1].0, &guess);
            }
            Err(Error::IrrationalPreimage { knot: text, start, end }) => {
                let (start, end): (Q, Q) = (start.parse()?, end.parse()?);
                prop_assert!(&guess * &guess != knot && text == knot.to_string());
                prop_assert!(&start * &start < knot && knot < &end * &end && end - start <= Q::frac(8, 1 << 20));
            }
            Err(other) => return Err(TestCaseError::fail(other.to_string())),
        }
    }
}

/// A function of floats on `[0, 1]` with these inner knots.
fn float(degree: usize, knots: &[f64], coeffs: &[f64]) -> Function<f64> {
    let mut inner: Vec<f64> = knots.to_vec();
    inner.sort_by(f64::total_cmp);
    let breaks = [0.0].into_iter().chain(inner).chain([1.0]);
    let space = SplineSpace::clamped(degree, breaks).expect("ascending knots");
    let coeffs = coeffs[..space.dim()].to_vec();
    Function::new(space, coeffs).expect("as many coefficients as the space has")
}

proptest! {
    #![proptest_config(cases(64))]

    /// The parameter of the outer spline is rounded, so the bound grows with its slope.
    #[test]
    fn floats_are_near_the_exact_composition(
        (p, q) in (1_usize..=4, 1_usize..=4),
        (outer_knots, inner_knots) in (vec(1_i32..64, 0..=6), vec(1_i32..1024, 0..=6)),
        (outer, inner) in (vec(-1.0_f64..1.0, 16), vec(0.01_f64..0.99, 16)),
        at in vec(0.0_f64..=1.0, 8),
    ) {
        let distinct = |knots: Vec<i32>, of: f64| {
            let knots: std::collections::BTreeSet<i32> = knots.into_iter().collect();
            knots.into_iter().map(|k| f64::from(k) / of).collect::<Vec<f64>>()
        };
        let (outer_knots, inner_knots) = (distinct(outer_knots, 64.0), distinct(inner_knots, 1024.0));
        let (f, g) = (float(p, &outer_knots, &outer), float(q, &inner_knots, &inner));
        let composed = f.composed(&g)?;
        let (exact_f, exact_g) = (f.to_exact()?, g.to_exact()?);
        let slope = f.derivative()?.coeffs().iter().fold(0.0, |most: f64, c| most.max(c.abs()));
        for x in at {
            let expected = exact_f.at(&exact_g.at(&Q::try_from(x)?)?)?;
            let error = (Q::try_from(composed.at(&x)?)? - expected).abs().to_f64();
            let bound = 8.0 * (p * q + 1) as f64 * f64::EPSILON * (1.0 + slope);
            prop_assert!(error <= bound, "{error} above {bound}");
        }
    }
}
