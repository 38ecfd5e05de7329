//! Laws of single forces: the point is where it should be, and nothing that is held has moved.

use crate::body::{Body, Wish, moving, wish};
use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::strategies::{ANY, Kind, cases, curve, surface};
use proptest::prelude::*;
use symspline::{Coeff, DeformError, Error, Q, Scalar, Spread};

const SMALL: Kind = ANY.of_degree(0, 3).few(3);
const FEW: Kind = ANY.of_degree(0, 2).few(2);

/// The point moves onto the target; displacements times stiffness are the load, on control points that may move.
fn is_pulled<S: Body>(shape: &S, wish: &Wish, spread: Spread) -> Result<(), TestCaseError> {
    let Some(elastic) = shape.body(wish)? else { return Ok(()) };
    let elastic = elastic.with_spread(spread);
    let at = shape.place(&wish.places[0]);
    let pull = match elastic.pull(shape, &at) {
        Err(Error::Deform(DeformError::NoHold { .. })) => return Ok(()),
        other => other?,
    };
    let mut moved = shape.clone();
    let target = S::vector(&wish.numbers);
    let force = pull.move_to(&mut moved, &target)?;
    prop_assert_eq!(moved.derivative_of(&at, S::VALUE)?, target);
    let displaced = moved.moved_from(shape)?;
    let loads = elastic.gradient(&displaced)?;
    let moves = moving(&elastic);
    for (i, moves) in moves.iter().enumerate() {
        if !moves {
            prop_assert!(displaced[i].vanishes(), "control point {} is held", i);
        } else if spread == Spread::Point && S::DIRECTIONS.len() == 1 {
            let share = shape.reach(&at, S::VALUE)?.into_iter().filter(|(j, _)| *j == i);
            let share = share.fold(Q::int(0), |sum, (_, w)| sum + w);
            prop_assert_eq!(&loads[i], &force.scaled(&share));
        }
    }
    // Another force on top: they add up.
    pull.push(&mut moved, &force.scaled(&-Q::int(1)))?;
    prop_assert!(moved.moved_from(shape)?.iter().all(Coeff::vanishes));
    Ok(())
}

/// With point loads: no displacement that moves the point as far costs less, since ours is across all that leave it in place.
fn is_least<S: Body>(shape: &S, wish: &Wish) -> Result<(), TestCaseError> {
    let Some(elastic) = shape.body(wish)? else { return Ok(()) };
    let elastic = elastic.with_spread(Spread::Point);
    let at = shape.place(&wish.places[0]);
    let (row, moves) = (shape.influence(&at, S::VALUE)?, moving(&elastic));
    let pull = match elastic.pull(shape, &at) {
        Err(Error::Deform(DeformError::NoHold { .. })) => {
            prop_assert!(row.terms().iter().all(|(i, _)| !moves[*i]));
            return Ok(());
        }
        other => other?,
    };
    prop_assert!(*pull.give() > Q::int(0));
    let mut other: Vec<Q> = wish
        .numbers
        .iter()
        .cycle()
        .zip(&moves)
        .map(|(x, m)| if *m { x.clone() } else { Q::int(0) })
        .collect();
    // Take out what moves the point.
    let value = row.apply(&other).unwrap_or_else(|| Q::int(0));
    for (i, by) in pull.response().moves(&[value / pull.give()])? {
        other[i] -= by;
    }
    let mut ours = vec![Q::int(0); other.len()];
    for (i, by) in pull.response().moves(&[Q::int(1)])? {
        ours[i] = by;
    }
    let loads = elastic.gradient(&ours)?;
    prop_assert_eq!(Q::dot(loads.iter().zip(&other)), Q::int(0));
    Ok(())
}

fn spread() -> impl Strategy<Value = Spread> {
    prop_oneof![Just(Spread::Hat), Just(Spread::Point)]
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn points_of_curves_move_onto_targets(shape in curve::<2>(SMALL), wish in wish(), spread in spread()) {
        is_pulled(&shape, &wish, spread)?;
    }

    #[test]
    fn points_of_rational_curves_move_onto_targets(shape in nurbs::<2>(SMALL), wish in wish(), spread in spread()) {
        is_pulled(&shape, &wish, spread)?;
    }

    #[test]
    fn points_of_surfaces_move_onto_targets(shape in surface::<2>(FEW, FEW), wish in wish(), spread in spread()) {
        is_pulled(&shape, &wish, spread)?;
    }

    #[test]
    fn points_of_rational_surfaces_move_onto_targets(shape in nurbs_surface::<2>(FEW), wish in wish(), spread in spread()) {
        is_pulled(&shape, &wish, spread)?;
    }

    #[test]
    fn point_loads_cost_least(shape in curve::<2>(SMALL), sheet in surface::<2>(FEW, FEW), wish in wish()) {
        is_least(&shape, &wish)?;
        is_least(&sheet, &wish)?;
    }
}
