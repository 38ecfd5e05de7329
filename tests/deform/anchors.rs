//! Laws of constraints held while the energy is least.

use crate::body::{Body, Wish, moving, wish};
use crate::rational_strategies::nurbs_surface;
use crate::strategies::{ANY, Kind, cases, curve, surface};
use nalgebra::vector;
use proptest::prelude::*;
use symspline::{
    Anchored, Coeff, Constraints, Controlled, Curve, Direction, Elastic, Error, Forces, NurbsSurface, Q,
    Scalar, ShapeError, SplineSpace, Surface,
};

const SMALL: Kind = ANY.of_degree(0, 3).few(3);
const FEW: Kind = ANY.of_degree(0, 2).few(2);

fn constraints<'a, S: Body>(shape: &'a S, wish: &Wish, count: usize) -> Result<Constraints<'a, Q, S>, Error> {
    let mut each = wish.places.iter().take(count).enumerate();
    each.try_fold(Constraints::on(shape), |all, (k, at)| all.derivative(&shape.place(at), S::order(k % 3)))
}

/// The loads on control points that may move are those of the forces at the constraints.
fn balances<S: Body>(
    elastic: &Elastic<Q>,
    held: &Anchored<Q, S>,
    loads: &[S::Point],
    forces: &[S::Point],
) -> Result<(), TestCaseError> {
    for (i, _) in moving(elastic).iter().enumerate().filter(|(_, moves)| **moves) {
        let mut expected = loads[0].zero_like();
        for (row, force) in held.rows().zip(forces) {
            expected.add_scaled(row.weight(i).unwrap_or(&Q::int(0)), force);
        }
        prop_assert_eq!(&loads[i], &expected, "control point {}", i);
    }
    Ok(())
}

fn is_anchored<S: Body>(shape: &S, wish: &Wish, count: usize) -> Result<(), TestCaseError> {
    let Some(elastic) = shape.body(wish)? else { return Ok(()) };
    let wanted = constraints(shape, wish, count)?;
    let held = match elastic.anchored(&wanted) {
        // That it is right to refuse them is a law of its own.
        Err(Error::Shape(ShapeError::Dependent { .. })) => return Ok(()),
        other => other?,
    };
    let moves = moving(&elastic);
    let stays = |shape: &S, before: &S| -> Result<bool, Error> {
        Ok(shape.moved_from(before)?.iter().zip(&moves).all(|(d, moves)| *moves || d.vanishes()))
    };
    let values = |shape: &S| -> Result<Vec<S::Point>, Error> {
        let each = wish.places.iter().take(count).enumerate();
        each.map(|(k, at)| shape.derivative_of(&shape.place(at), S::order(k % 3))).collect()
    };
    // Targets are met by the least energy.
    let targets: Vec<S::Point> = (0..count).map(|k| S::vector(&wish.numbers[3 * k..])).collect();
    let mut met = shape.clone();
    let forces = held.meet(&mut met, &targets)?;
    prop_assert_eq!(&values(&met)?, &targets);
    prop_assert!(stays(&met, shape)?);
    balances(&elastic, &held, &elastic.gradient(&met.moved_from(shape)?)?, &forces)?;
    // Forces act, and what is held stays.
    let mut acting = Forces::new(&elastic, &met)?;
    acting.at(&met.place(&wish.places[3]), S::vector(&wish.numbers[20..]))?;
    let mut pushed = met.clone();
    let reaction = held.push(&mut pushed, &acting)?;
    prop_assert_eq!(&values(&pushed)?, &targets);
    prop_assert!(stays(&pushed, &met)?);
    let mut loads = elastic.gradient(&pushed.moved_from(&met)?)?;
    loads.iter_mut().zip(acting.load()?).for_each(|(sum, load)| sum.add_scaled(&-Q::int(1), &load));
    balances(&elastic, &held, &loads, &reaction)?;
    // Without them: of all shapes with these values the one of least energy.
    let mut relaxed = pushed.clone();
    let forces = held.relax(&mut relaxed)?;
    prop_assert_eq!(&values(&relaxed)?, &targets);
    prop_assert!(stays(&relaxed, &pushed)?);
    balances(&elastic, &held, &elastic.gradient(&relaxed.control_points()?)?, &forces)?;
    let energy = |shape: &S| -> Result<Q, Error> {
        let (points, loads) = (shape.control_points()?, elastic.gradient(&shape.control_points()?)?);
        Ok(points
            .iter()
            .zip(&loads)
            .fold(Q::int(0), |sum, (c, k)| sum + Q::dot(c.components().zip(k.components()))))
    };
    let (before, after) = (energy(&pushed)?, energy(&relaxed)?);
    prop_assert!(
        after >= Q::int(0) && (after < before || relaxed.control_points()? == pushed.control_points()?)
    );
    Ok(())
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn constraints_of_curves_are_met_at_least_energy(shape in curve::<2>(SMALL), wish in wish(), count in 0..=3_usize) {
        is_anchored(&shape, &wish, count)?;
    }

    #[test]
    fn constraints_of_surfaces_are_met_at_least_energy(shape in surface::<2>(FEW, FEW), wish in wish(), count in 0..=3_usize) {
        is_anchored(&shape, &wish, count)?;
    }

    #[test]
    fn constraints_of_rational_surfaces_are_met_at_least_energy(shape in nurbs_surface::<2>(FEW), wish in wish(), count in 1..=2_usize) {
        is_anchored(&shape, &wish, count)?;
    }

    #[test]
    fn dependence_is_what_least_movements_see(shape in curve::<2>(SMALL), wish in wish(), count in 1..=4_usize) {
        let Some(elastic) = shape.body(&wish)? else { return Ok(()) };
        let moves = moving(&elastic);
        let wanted = constraints(&shape, &wish, count)?;
        let free: Vec<usize> = (0..moves.len()).filter(|i| moves[*i]).collect();
        let least = constraints(&shape, &wish, count)?.freeing(&free)?.prepare();
        match (elastic.anchored(&wanted), least) {
            (Ok(_), least) => prop_assert!(least.is_ok()),
            (Err(Error::Shape(ShapeError::Dependent { condition, on })), Err(Error::Shape(least))) => match least {
                ShapeError::Dependent { condition: other, on: others } => prop_assert_eq!((condition, on), (other, others)),
                ShapeError::Overdetermined { clashing, .. } => {
                    prop_assert_eq!(on.into_iter().chain([condition]).collect::<Vec<_>>(), clashing);
                }
                _ => prop_assert!(false, "{}", least),
            },
            (Err(error), least) => prop_assert!(false, "{} but {}", error, least.is_ok()),
        }
    }

    #[test]
    fn isocurves_are_met_all_along(shape in surface::<2>(FEW, FEW), wish in wish(), along_u in any::<bool>()) {
        let direction = if along_u { Direction::U } else { Direction::V };
        let x = if along_u { shape.place(&wish.places[0]).0 } else { shape.place(&wish.places[0]).1 };
        let Some(elastic) = shape.body(&wish)? else { return Ok(()) };
        let Ok(held) = elastic.anchored(&Constraints::on(&shape).isocurve(direction, &x)?) else { return Ok(()) };
        let count = shape.space(direction.other()).dim();
        let targets: Vec<_> = (0..count).map(|k| <Surface<Q, 2> as Body>::vector(&wish.numbers[k % 60..])).collect();
        let mut met = shape;
        held.meet(&mut met, &targets)?;
        let found = met.isocurve(direction, &x)?;
        prop_assert_eq!(found.coeffs(), &targets[..]);
    }

    #[test]
    fn isocurves_of_rational_surfaces_too(shape in nurbs_surface::<2>(FEW), wish in wish(), along_u in any::<bool>()) {
        let direction = if along_u { Direction::U } else { Direction::V };
        let x = if along_u { shape.place(&wish.places[0]).0 } else { shape.place(&wish.places[0]).1 };
        let Some(elastic) = shape.body(&wish)? else { return Ok(()) };
        let Ok(wanted) = Constraints::on(&shape).isocurve(direction, &x) else { return Ok(()) };
        let Ok(held) = elastic.anchored(&wanted) else { return Ok(()) };
        let targets: Vec<_> = (0..held.rows().len()).map(|k| <NurbsSurface<Q, 2> as Body>::vector(&wish.numbers[k % 60..])).collect();
        let mut met = shape;
        held.meet(&mut met, &targets)?;
        let found = met.isocurve(direction, &x)?;
        for (i, target) in targets.iter().enumerate() {
            if let Ok(point) = found.control_point(i) {
                prop_assert_eq!(&point, target);
            }
        }
    }

    #[test]
    fn embedded_curves_move_onto_curves_in_space(
        shape in surface::<2>(FEW, FEW), wish in wish(), target in curve::<2>(SMALL), count in 1..=3_usize, closed in any::<bool>(),
    ) {
        let Some(elastic) = shape.body(&wish)? else { return Ok(()) };
        let corners: Vec<_> = wish.places.iter().take(3).map(|at| {
            let (u, v) = shape.place(at);
            vector![u, v]
        }).collect();
        let space = if closed { SplineSpace::uniform_periodic(1, 3, Q::int(0), Q::int(1))? } else { SplineSpace::bezier(2, Q::int(0), Q::int(1))? };
        let path = Curve::new(space, corners)?;
        let held = match elastic.anchored(&Constraints::on(&shape).along(&path, count)?) {
            Err(Error::Shape(ShapeError::Dependent { .. })) => return Ok(()),
            other => other?,
        };
        let mut met = shape;
        held.meet_curve(&mut met, &target)?;
        let both = path.space().even_parameters(count)?.into_iter().zip(target.space().even_parameters(count)?);
        for (t, s) in both {
            let at = path.at(&t)?;
            prop_assert_eq!(met.at(&at[0], &at[1])?, target.at(&s)?);
        }
    }
}
