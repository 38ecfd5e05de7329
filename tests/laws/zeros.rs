//! Laws of zeros of splines: of products of known factors, and of whatever coefficients there are.

use crate::strategies::{ANY, SMOOTH, cases, coeffs, function, number, space};
use proptest::collection::btree_map;
use proptest::prelude::*;
use proptest::sample::Index;
use std::cmp::Ordering;
use symspline::roots::RootValue;
use symspline::{Certified, Function, Place, Q, Result, Scalar, Zero};

/// The product of a positive spline and powers of `x - root`, and the roots, which lie in its domain: at knots or
/// anywhere.
fn product() -> impl Strategy<Value = (Function<Q>, Vec<(Q, usize)>)> {
    let place = (any::<Index>(), 0_i64..=12);
    let roots = btree_map(place.prop_map(|(i, share)| (i.index(1 << 20), share)), 1_usize..=3, 0..=3);
    (space(ANY.of_degree(0, 3)), coeffs(number().boxed()), roots, any::<bool>()).prop_map(
        |(space, c, roots, at_knots)| {
            let breaks = space.breaks();
            let positive = (0..space.dim()).map(|i| c[i % c.len()].abs() + Q::frac(1, 5)).collect();
            let mut f = Function::new(space, positive).expect("as many coefficients");
            if f.space().is_periodic() {
                f = f.restricted(&f.domain().0.clone(), &f.domain().1.clone()).expect("the domain");
            }
            let (a, b) = (f.domain().0.clone(), f.domain().1.clone());
            let mut known: Vec<(Q, usize)> = Vec::new();
            for ((i, share), multiplicity) in roots {
                let root = match at_knots {
                    true => breaks[i % breaks.len()].0.clone(),
                    false => &a + (&b - &a) * Q::frac(share, 12),
                };
                if known.iter().all(|(x, _)| *x != root) {
                    let factor = Function::monomial(1, a.clone(), b.clone()).expect("a line");
                    let factor = factor.translated(&-root.clone()).expect("a line");
                    f = (0..multiplicity).fold(f, |f, _| &f * &factor);
                    known.push((root, multiplicity));
                }
            }
            known.sort();
            (f, known)
        },
    )
}

/// The sign that a function has between two zeros.
fn sign_at(f: &Function<Q>, x: &Q) -> Ordering {
    f.at(x).expect("inside the domain").cmp(&Q::int(0))
}

/// Checks that a function has the signs that its zeros say, and no zero between them.
fn check_signs(f: &Function<Q>, zeros: &[Zero<Q>]) -> std::result::Result<(), TestCaseError> {
    let (a, b) = f.domain();
    let lows = [a].into_iter().chain(zeros.iter().map(|zero| zero.place.bounds().1));
    let highs = zeros.iter().map(|zero| zero.place.bounds().0).chain([b]);
    for (i, (low, high)) in lows.zip(highs).enumerate() {
        if low == high {
            continue;
        }
        prop_assert!(low < high, "zeros are apart and in order");
        let signs =
            [i.checked_sub(1).and_then(|i| zeros[i].after), zeros.get(i).and_then(|zero| zero.before)];
        for share in [1, 17, 500, 983, 999] {
            let x = low + (high - low) * Q::frac(share, 1000);
            let sign = sign_at(f, &x);
            prop_assert_ne!(sign, Ordering::Equal);
            prop_assert!(signs.iter().flatten().all(|expected| *expected == sign), "{:?} at {}", signs, x);
        }
    }
    Ok(())
}

/// Values that are zero now and then, so that zero intervals appear.
fn sparse() -> impl Strategy<Value = Function<Q>> {
    (space(ANY), coeffs(prop_oneof![2 => Just(Q::int(0)), 1 => number()].boxed())).prop_map(|(space, c)| {
        let c = (0..space.dim()).map(|i| c[i % c.len()].clone()).collect();
        Function::new(space, c).expect("as many coefficients")
    })
}

fn zeros_over<T: Certified>(f: &Function<T>) -> Result<Vec<Zero<T>>> {
    f.zeros()
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn zeros_of_products_are_those_of_their_factors((f, known) in product()) {
        let zeros = f.zeros()?;
        let found: Vec<(Q, usize)> = zeros
            .iter()
            .map(|zero| match &zero.place {
                Place::At(RootValue::Exact(x)) => (x.clone(), zero.multiplicity),
                place => panic!("{place:?} is no rational zero"),
            })
            .collect();
        prop_assert_eq!(found, known);
        check_signs(&f, &zeros)?;
    }

    #[test]
    fn signs_are_as_zeros_say(f in function(ANY)) {
        check_signs(&f, &f.zeros()?)?;
    }

    #[test]
    fn zero_intervals_are_zero(f in sparse()) {
        let zeros = f.zeros()?;
        check_signs(&f, &zeros)?;
        for zero in zeros {
            if let Place::Along(start, end) = zero.place {
                for i in 0..=8 {
                    // A jump at the end of the interval has its right limit there.
                    prop_assert_eq!(sign_at(&f, &(&start + (&end - &start) * Q::frac(i, 9))), Ordering::Equal);
                }
            }
        }
    }

    #[test]
    fn isolated_zeros_are_zeros(f in function(ANY)) {
        for zero in f.zeros()? {
            match &zero.place {
                Place::At(RootValue::Exact(x)) => {
                    let both = [f.at(x)?, f.at_left(x)?].map(|value| value.cmp(&Q::int(0)));
                    prop_assert!(both.contains(&Ordering::Equal) || both[0] != both[1] || x == f.domain().0);
                }
                // Irrational: an odd one changes the sign.
                Place::At(RootValue::Enclosed(low, high)) => {
                    let reach = low.abs() + high.abs();
                    prop_assert!(high - low <= reach * Q::frac(1, 1 << 50));
                    // The upper bound may be a knot where the function jumps.
                    let changes = sign_at(&f, low) != f.at_left(high)?.cmp(&Q::int(0));
                    prop_assert_eq!(changes, zero.multiplicity % 2 == 1);
                    prop_assert_eq!(changes, zero.changes_sign());
                }
                Place::Along(..) => {}
            }
        }
    }

    #[test]
    fn floats_have_the_zeros_of_their_exact_images(f in prop_oneof![function(ANY).boxed(), sparse().boxed(), product().prop_map(|(f, _)| f).boxed()]) {
        // Rounding takes zeros apart, but not those of the rounded function.
        let Ok(rounded) = f.to_f64() else { return Ok(()) };
        let (found, expected) = (rounded.zeros()?, zeros_over(&rounded.to_exact()?)?);
        prop_assert_eq!(found.len(), expected.len());
        for (zero, exact) in found.iter().zip(&expected) {
            prop_assert_eq!(
                (zero.multiplicity, zero.before, zero.after),
                (exact.multiplicity, exact.before, exact.after)
            );
            let ((low, high), (least, most)) = (zero.place.bounds(), exact.place.bounds());
            let (low, high) = (Q::try_from(*low)?, Q::try_from(*high)?);
            prop_assert!(low <= *most && *least <= high);
            prop_assert_eq!(matches!(zero.place, Place::Along(..)), matches!(exact.place, Place::Along(..)));
        }
    }

    #[test]
    fn zeros_of_the_derivative_hold_the_extrema(f in function(SMOOTH.of_degree(1, 4))) {
        let slope = f.derivative()?.zeros()?;
        let (a, b) = f.domain();
        let lows = [a].into_iter().chain(slope.iter().map(|zero| zero.place.bounds().1));
        let highs = slope.iter().map(|zero| zero.place.bounds().0).chain([b]);
        // Between them the function only rises or only falls.
        for (low, high) in lows.zip(highs).filter(|(low, high)| low < high) {
            let values = (1..8).map(|i| f.at(&(low + (high - low) * Q::frac(i, 8))));
            let values = values.collect::<Result<Vec<Q>>>()?;
            prop_assert!(values.is_sorted() || values.iter().rev().is_sorted());
        }
    }

    #[test]
    fn zeros_do_not_depend_on_the_space(f in function(ANY.of_degree(0, 4))) {
        let zeros = f.zeros()?;
        prop_assert_eq!(&f.elevated(1)?.zeros()?, &zeros);
        prop_assert_eq!(&f.scaled(&Q::frac(7, 3))?.zeros()?, &zeros);
        let flipped = f.scaled(&Q::int(-1))?.zeros()?;
        prop_assert!(flipped.iter().zip(&zeros).all(|(one, other)| one.place == other.place
            && one.before == other.before.map(Ordering::reverse)
            && one.multiplicity == other.multiplicity));
    }
}

#[test]
fn a_foot_in_exactly_a_knot_is_found_once() {
    use symspline::SplineSpace;
    let space = SplineSpace::clamped(3, [0.0, 0.1, 0.3, 1.0]).expect("knots ascend");
    let line = Function::new(space.clone(), space.greville().iter().map(|x| x - 0.3).collect());
    let zeros = line.and_then(|line| line.zeros()).expect("a line has a zero");
    assert_eq!(zeros.len(), 1);
    let (low, high) = zeros[0].place.bounds();
    assert!(high - low < 1e-15 && (low - 0.3).abs() < 1e-15);
}

#[test]
fn lines_and_planes_are_met() {
    use nalgebra::vector;
    use symspline::{Crossings, Curve, SplineSpace, circle};
    // The unit circle and y = 3/5: in ±4/5, exactly.
    let unit = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1)).expect("a circle");
    let line = [vector![Q::int(7), Q::frac(3, 5)], vector![Q::int(-2), Q::int(0)]];
    let places = unit.meet_line(&line[0], &line[1]).expect("places");
    let points: Vec<_> = places
        .iter()
        .map(|zero| match &zero.place {
            Place::At(RootValue::Exact(x)) => unit.at(x).expect("inside"),
            place => panic!("{place:?}"),
        })
        .collect();
    assert_eq!(points, [[4, 3], [-4, 3]].map(|c| vector![Q::frac(c[0], 5), Q::frac(c[1], 5)]));
    assert_eq!(unit.crossings(&vector![Q::int(0), Q::int(5)], &Q::int(3)).expect("places").len(), 2);
    // Nearly touching: one part in 10^30 below and above the top, and at it.
    let tiny = (0..30).fold(Q::int(1), |tiny, _| tiny / Q::int(10));
    let direction = vector![Q::int(1), Q::int(0)];
    let count = |y: Q| unit.meet_line(&vector![Q::int(0), y], &direction).expect("places").len();
    assert_eq!([count(Q::int(1) - &tiny), count(Q::int(1)), count(Q::int(1) + &tiny)], [2, 1, 0]);
    // A space curve with a straight span in the plane z = 1, another through it.
    let space = SplineSpace::clamped(1, [0, 1, 2, 3].map(Q::int)).expect("knots ascend");
    let points = [[0, 0, 1], [1, 0, 1], [2, 5, 3], [0, 0, -1]].map(|c| c.map(Q::int).into());
    let path = Curve::<Q, 3>::new(space, points.to_vec()).expect("four points");
    let places = path.crossings(&vector![Q::int(0), Q::int(0), Q::int(2)], &Q::int(2)).expect("places");
    let places: Vec<_> = places.into_iter().map(|zero| zero.place).collect();
    assert_eq!(places, [Place::Along(Q::int(0), Q::int(1)), Place::At(RootValue::Exact(Q::frac(5, 2)))]);
}

#[test]
fn feet_are_where_the_distance_turns() {
    use nalgebra::vector;
    use symspline::{Crossings, circle};
    let unit = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1)).expect("a circle");
    let feet = unit.feet(&vector![Q::int(3), Q::int(0)]).expect("feet");
    // Near and far; the seam of the circle, which is no ring here, shows both ends.
    let bounds: Vec<_> = feet.iter().map(|zero| zero.place.bounds().0.clone()).collect();
    assert_eq!(bounds, [Q::int(0), Q::frac(1, 2), Q::int(1)]);
    let all = unit.feet(&vector![Q::int(0), Q::int(0)]).expect("feet");
    assert_eq!(all[0].place, Place::Along(Q::int(0), Q::int(1)));
}
