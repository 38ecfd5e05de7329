//! Laws of the knot that puts a parameter halfway between two nodes.

use crate::strategies::{ANY, CLAMPED, RING, cases, probes, space};
use proptest::prelude::*;
use symspline::{Error, Halfway, Q, Regime, Scalar, ShapeError, SplineSpace};

/// That the leg of `found` has the mean `x` in the space with the knot.
fn is_halfway(space: &SplineSpace<Q>, x: &Q, found: &Halfway<Q>) -> Result<(), TestCaseError> {
    let finer = space.refined(found.knot.as_slice())?;
    let [left, right] = [finer.node(found.leg)?, finer.node(found.leg + 1)?];
    prop_assert_eq!((left.clone() + &right) / Q::int(2), x.clone());
    prop_assert!(left <= *x && *x <= right);
    prop_assert_eq!(finer.between_nodes(found.leg)?, x.clone());
    Ok(())
}

/// The bounds of the knot that the regime promises.
fn is_in_its_regime(space: &SplineSpace<Q>, x: &Q, found: &Halfway<Q>) -> Result<(), TestCaseError> {
    let (k, p) = (space.nearest_node(x)?, space.degree());
    let u = |j: usize| &space.knots()[k + j];
    let Some(knot) = &found.knot else {
        prop_assert_eq!(found.regime, Regime::There);
        return Ok(());
    };
    let (low, high) = match found.regime {
        Regime::Central => (1, p),
        Regime::LeftGap => (0, 1),
        Regime::RightGap => (p, p + 1),
        Regime::There => return Err(TestCaseError::fail("a knot where none is needed")),
    };
    prop_assert!(u(low) <= knot && knot <= u(high));
    Ok(())
}

proptest! {
    #![proptest_config(cases(64))]

    /// Inside a clamped space there is always a knot, unless so many copies are there that another would tear the space apart.
    #[test]
    fn a_knot_puts_a_parameter_halfway(space in space(CLAMPED.of_degree(2, 6).smooth(1))) {
        let (a, b) = space.domain();
        for x in probes(&space) {
            if x == *a || x == *b {
                let error = space.halfway_knot_or_copy(&x).err();
                let refused = matches!(error, None | Some(Error::Shape(ShapeError::NoHalfwayKnot { .. })));
                prop_assert!(refused);
                continue;
            }
            let found = space.halfway_knot_or_copy(&x)?;
            is_halfway(&space, &x, &found)?;
            is_in_its_regime(&space, &x, &found)?;
            match space.halfway_knot(&x) {
                Ok(strict) => prop_assert_eq!(strict, found),
                Err(error) => {
                    let knot = found.knot.expect("a knot that is there");
                    prop_assert!(space.knots().contains(&knot));
                    prop_assert_eq!(error, ShapeError::KnotThere { knot: knot.to_string() }.into());
                }
            }
        }
    }

    #[test]
    fn elsewhere_it_is_found_or_refused(space in space(ANY.of_degree(2, 5))) {
        for x in probes(&space) {
            match space.halfway_knot_or_copy(&x) {
                Ok(found) => is_halfway(&space, &x, &found)?,
                Err(error) => {
                    let told = matches!(error, Error::Shape(ShapeError::NoHalfwayKnot { .. } | ShapeError::KnotThere { .. }));
                    prop_assert!(told);
                }
            }
        }
    }

    /// In a ring with as many coefficients as a support needs there is always one, also across the seam.
    #[test]
    fn rings_have_one_everywhere(space in space(RING.of_degree(2, 3).smooth(2))) {
        if space.dim() > space.degree() + 1 {
            for x in probes(&space) {
                is_halfway(&space, &x, &space.halfway_knot_or_copy(&x)?)?;
            }
        }
    }
}
