//! Laws of the ranges and boxes of rational splines.

use crate::rational_strategies::{nurbs, nurbs_surface, rational};
use crate::strategies::{ANY, Kind, cases, probes};
use proptest::prelude::*;
use symspline::{Error, Q, Scalar};

const LOW: Kind = ANY.of_degree(0, 4);

/// An accuracy, sometimes larger than everything.
fn accuracy() -> impl Strategy<Value = Q> {
    prop_oneof![Just(Q::frac(1, 100)), Just(Q::int(3)), Just(Q::int(1 << 40))]
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn values_of_a_quotient_are_within_its_range(f in rational(LOW), accuracy in accuracy()) {
        let range = match f.range(&accuracy) {
            Err(Error::Weight { .. }) => return Ok(()),
            range => range?,
        };
        prop_assert!(range.least.value.clone() - &range.least.bound <= accuracy);
        prop_assert!(range.greatest.bound.clone() - &range.greatest.value <= accuracy);
        for x in probes(f.space()) {
            for value in [f.at(&x)?, f.at_left(&x)?] {
                prop_assert!(range.least.bound <= value && value <= range.greatest.bound);
            }
        }
        for extremum in [&range.least, &range.greatest] {
            let met = [f.at(&extremum.parameter)?, f.at_left(&extremum.parameter)?];
            prop_assert!(met.contains(&extremum.value));
        }
    }

    #[test]
    fn rational_curves_are_in_their_boxes(c in nurbs::<2>(LOW), accuracy in accuracy()) {
        let Ok((low, high)) = c.control_box() else { return Ok(()) };
        let sides = c.bounding_box(&accuracy)?;
        for x in probes(c.space()) {
            let point = c.at(&x)?;
            for (axis, side) in sides.iter().enumerate() {
                prop_assert!(side.least.bound <= point[axis] && point[axis] <= side.greatest.bound);
                prop_assert!(low[axis] <= side.least.bound && side.greatest.bound <= high[axis]);
            }
        }
    }

    #[test]
    fn rational_surfaces_are_in_their_boxes(s in nurbs_surface::<3>(ANY.of_degree(0, 2))) {
        let Ok((low, high)) = s.control_box() else { return Ok(()) };
        // An accuracy in proportion: a small part of the box takes very many halvings where the surface is nearly flat.
        let width = (high - low).iter().fold(Q::int(0), |width, side| if *side > width { side.clone() } else { width });
        let accuracy = width * Q::frac(1, 8) + Q::frac(1, 1000);
        let sides = s.bounding_box(&accuracy)?;
        for side in &sides {
            prop_assert!(side.least.value.clone() - &side.least.bound <= accuracy);
        }
        let vs = probes(s.v());
        for u in probes(s.u()) {
            for v in &vs {
                let point = s.at(&u, v)?;
                for (axis, side) in sides.iter().enumerate() {
                    prop_assert!(side.least.bound <= point[axis] && point[axis] <= side.greatest.bound);
                }
            }
        }
    }
}

#[test]
fn weights_that_are_not_positive_have_no_range() {
    use symspline::{RationalFunction, Spline, SplineSpace, Weighted};
    let space = SplineSpace::bezier(2, 0.0, 1.0).unwrap();
    let lifted = [1.0, -0.5, 1.0].map(|weight| Weighted { point: 1.0, weight }).to_vec();
    let f = RationalFunction::from_lifted(Spline::new(space, lifted).unwrap()).unwrap();
    assert_eq!(f.range(&0.1).unwrap_err(), Error::Weight { index: 1, weight: "-0.5".into() });
}
