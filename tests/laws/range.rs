//! Laws of bounds: ranges, boxes and hulls.

use crate::oracle::{self, Side};
use crate::strategies::{ANY, cases, curve, function, functions, indices, insertable, probes};
use nalgebra::SVector;
use proptest::prelude::*;
use symspline::{Curve, Function, Q, Scalar};

/// An accuracy, sometimes larger than everything.
fn accuracy() -> impl Strategy<Value = Q> {
    prop_oneof![
        Just(Q::frac(1, 1000)),
        Just(Q::int(3)),
        Just(Q::frac(1, 1_000_000_000)),
        Just(Q::int(1 << 40))
    ]
}

/// All values at the probes, from both sides.
fn values(f: &Function<Q>) -> Vec<Q> {
    let both = |x: Q| [Side::Left, Side::Right].map(|side| oracle::value(f, &x, side));
    probes(f.space()).into_iter().flat_map(both).collect()
}

/// Twice the area of a triangle, positive if it turns left.
fn area(a: &SVector<Q, 2>, b: &SVector<Q, 2>, c: &SVector<Q, 2>) -> Q {
    let (u, v) = (b - a, c - a);
    u[0].clone() * &v[1] - u[1].clone() * &v[0]
}

/// Whether a point is in the polygon with these corners, counter-clockwise; of two corners a segment, of one a point.
fn within(corners: &[SVector<Q, 2>], x: &SVector<Q, 2>) -> bool {
    let next = |i: usize| &corners[(i + 1) % corners.len()];
    let left = (0..corners.len()).all(|i| area(&corners[i], next(i), x) >= Q::int(0));
    let between = |axis: usize| {
        let side = corners.iter().map(|c| &c[axis]);
        side.clone().min() <= Some(&x[axis]) && Some(&x[axis]) <= side.max()
    };
    left && between(0) && between(1)
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn every_value_is_within_the_bounds(f in function(ANY), accuracy in accuracy()) {
        let range = f.range(&accuracy)?;
        for value in values(&f) {
            prop_assert!(range.least.bound <= value && value <= range.greatest.bound);
        }
    }

    #[test]
    fn bounds_are_as_near_as_asked_and_within_the_coefficients(f in function(ANY), accuracy in accuracy()) {
        let range = f.range(&accuracy)?;
        prop_assert!(range.least.value.clone() - &range.least.bound <= accuracy);
        prop_assert!(range.greatest.bound.clone() - &range.greatest.value <= accuracy);
        let (low, high) = f.coefficient_range();
        prop_assert!(low <= range.least.bound && range.least.bound <= range.least.value);
        prop_assert!(range.greatest.value <= range.greatest.bound && range.greatest.bound <= high);
    }

    #[test]
    fn extreme_values_are_met_where_it_says(f in function(ANY), accuracy in accuracy()) {
        let range = f.range(&accuracy)?;
        for end in [range.least, range.greatest] {
            let met = [Side::Left, Side::Right].map(|side| oracle::value(&f, &end.parameter, side));
            prop_assert!(met.contains(&end.value));
        }
    }

    #[test]
    fn the_vertex_of_a_parabola_is_enclosed(f in function(ANY.of_degree(0, 2)), accuracy in accuracy()) {
        let range = f.range(&accuracy)?;
        let mut candidates = values(&f);
        for piece in oracle::powers(&f) {
            let coeff = |i: usize| piece.coeffs.get(i).cloned().unwrap_or(Q::int(0));
            if coeff(2) != Q::int(0) {
                let vertex = -coeff(1) / (Q::int(2) * coeff(2));
                if piece.a <= vertex && vertex <= piece.b {
                    candidates.push((coeff(2) * &vertex + coeff(1)) * &vertex + coeff(0));
                }
            }
        }
        let (least, greatest) = (candidates.iter().min().unwrap(), candidates.iter().max().unwrap());
        prop_assert!(range.least.bound <= *least && *least <= range.least.value);
        prop_assert!(range.greatest.value <= *greatest && *greatest <= range.greatest.bound);
    }

    #[test]
    fn the_mirrored_function_has_the_mirrored_range(f in function(ANY), accuracy in accuracy()) {
        let (range, mirrored) = (f.range(&accuracy)?, f.scaled(&Q::int(-1))?.range(&accuracy)?);
        prop_assert_eq!((-mirrored.least.bound, -mirrored.least.value), (range.greatest.bound, range.greatest.value));
        prop_assert_eq!((-mirrored.greatest.bound, -mirrored.greatest.value), (range.least.bound, range.least.value));
        prop_assert_eq!(mirrored.least.parameter, range.greatest.parameter);
    }

    #[test]
    fn ranges_do_not_depend_on_the_space(f in function(ANY), places in indices(3), raise in 0_usize..2) {
        let accuracy = Q::frac(1, 100);
        let (one, other) = (f.range(&accuracy)?, f.elevated(raise)?.inserted(&insertable(f.space(), &places))?.range(&accuracy)?);
        prop_assert!(one.least.bound <= other.least.value && other.least.bound <= one.least.value);
        prop_assert!(one.greatest.value <= other.greatest.bound && other.greatest.value <= one.greatest.bound);
    }

    #[test]
    fn the_range_of_a_sum_is_within_the_sum_of_ranges([f, g] in functions(ANY.of_degree(0, 4), ANY.of_degree(0, 4))) {
        let accuracy = Q::frac(1, 100);
        let [range_f, range_g, sum] = [f.range(&accuracy)?, g.range(&accuracy)?, (&f + &g).range(&accuracy)?];
        prop_assert!(range_f.least.bound + range_g.least.bound <= sum.least.value);
        prop_assert!(sum.greatest.value <= range_f.greatest.bound + range_g.greatest.bound);
    }

    #[test]
    fn a_curve_lies_in_its_boxes(c in curve::<3>(ANY)) {
        let (low, high) = c.control_box();
        let sides = c.bounding_box(&Q::frac(1, 100))?;
        for x in probes(c.space()) {
            for point in [Side::Left, Side::Right].map(|side| oracle::value(&c, &x, side)) {
                for (axis, side) in sides.iter().enumerate() {
                    prop_assert!(side.least.bound <= point[axis] && point[axis] <= side.greatest.bound);
                    prop_assert!(low[axis] <= side.least.bound && side.greatest.bound <= high[axis]);
                }
            }
        }
        prop_assert!((0..3).all(|i| c.coeffs().iter().any(|p| p[i] == low[i]) && c.coeffs().iter().any(|p| p[i] == high[i])));
    }

    #[test]
    fn the_hull_holds_the_curve_and_its_points(c in curve::<2>(ANY)) {
        let hull: Vec<_> = c.control_hull().into_iter().map(|i| c.coeffs()[i].clone()).collect();
        prop_assert!(c.coeffs().iter().all(|point| within(&hull, point)));
        for x in probes(c.space()) {
            prop_assert!(within(&hull, &oracle::value(&c, &x, Side::Left)));
            prop_assert!(within(&hull, &oracle::value(&c, &x, Side::Right)));
        }
    }

    #[test]
    fn the_hull_is_convex(points in prop::collection::vec((-3_i64..=3, -3_i64..=3), 1..12)) {
        let points: Vec<_> = points.into_iter().map(|(x, y)| SVector::from([Q::int(x), Q::int(y)])).collect();
        let space = symspline::SplineSpace::bezier(points.len() - 1, Q::int(0), Q::int(1))?;
        let hull = Curve::new(space, points.clone())?.control_hull();
        let corner = |i: usize| &points[hull[i % hull.len()]];
        if hull.len() > 2 {
            for i in 0..hull.len() {
                // Every corner turns left: as a whole once round, since all points are on the left of every side.
                prop_assert!(area(corner(i), corner(i + 1), corner(i + 2)) > Q::int(0));
                prop_assert!(points.iter().all(|x| area(corner(i), corner(i + 1), x) >= Q::int(0)));
            }
        } else {
            prop_assert!(points.iter().all(|x| within(&[corner(0).clone(), corner(1).clone()], x)));
        }
    }
}
