//! Laws of two weights: points go exactly to targets in a triangle, and along a line with the ratio of the weights kept.

use crate::rational_strategies::{nurbs, nurbs_surface, weight};
use crate::strategies::cases;
use crate::weights::{Law, P, SMALL, Shape, TINY, only_these_changed, picked, proved, refused};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Coeff, Error, Q, Scalar, ShapeError, WeightPairPull, WeightRange};

fn two_weights_move_the_point<S: Shape<N>, const N: usize>(
    shape: &S,
    place: Index,
    picks: [Index; 2],
    corners: [Q; 3],
) -> Law {
    let (at, picks) = picked(shape, place, &picks)?;
    let [r, s] = [picks[0], picks[1]];
    let row = shape.influence(&at, S::VALUE)?;
    let pull = match WeightPairPull::new(shape, &at, [shape.pick(r), shape.pick(s)]) {
        Ok(pull) => pull,
        Err(Error::Weight { index, .. }) => {
            prop_assert!(shape.kept()[index].weight <= Q::int(0));
            return Ok(());
        }
        Err(Error::Shape(ShapeError::PickedTwice { index })) => {
            prop_assert!(r == s && index == r);
            return Ok(());
        }
        Err(error) => {
            prop_assert_eq!(error, ShapeError::NoBase { parameter: format!("{at:?}") }.into());
            let total = [r, s].map(|k| row.weight(k).cloned().unwrap_or_default());
            prop_assert!(total[0].clone() + &total[1] >= Q::int(1));
            return Ok(());
        }
    };
    let p = shape.derivative_of(&at, S::VALUE)?;
    let [a, b] = pull.shares();
    let rest = Q::int(1) - a - b;
    let [p_r, p_s] = pull.control_points();
    let mixed =
        |c: &Q, d: &Q| pull.base().scaled(&(Q::int(1) - c - d)).plus_scaled(c, p_r).plus_scaled(d, p_s);
    prop_assert_eq!(&mixed(a, b), &p);
    // Anywhere inside.
    let mut moving = shape.clone();
    let sum = corners[0].clone() + &corners[1] + &corners[2];
    let [c, d] = [0, 1].map(|i| corners[i].clone() / &sum);
    let target = mixed(&c, &d);
    match pull.weights_for(&target, &Q::int(0)) {
        Ok(weights) => {
            let expected = [(0, &c, a), (1, &d, b)]
                .map(|(i, to, from)| pull.weights()[i].clone() * to / from * &rest / (Q::int(1) - &c - &d));
            prop_assert_eq!(&weights, &expected);
            prop_assert_eq!(pull.coordinates(&target, &Q::int(0))?, [c, d]);
            // A range with these at its ends allows them, a smaller one does not.
            let [low, high] =
                if weights[0] < weights[1] { [&weights[0], &weights[1]] } else { [&weights[1], &weights[0]] };
            let ranged = pull.clone().within(WeightRange::new(low.clone(), high.clone())?);
            prop_assert_eq!(&ranged.weights_for(&target, &Q::int(0))?, &weights);
            for (least, most) in [
                (low.clone() * Q::int(2), high.clone() * Q::int(2)),
                (low.clone() / Q::int(2), high.clone() / Q::int(2)),
            ] {
                let ranged = pull.clone().within(WeightRange::new(least, most)?);
                let told = matches!(
                    refused(ranged.weights_for(&target, &Q::int(0))),
                    Some(ShapeError::WeightOutOfRange { .. })
                );
                prop_assert!(told);
            }
            let done = pull.apply_to(&mut moving, &target, &Q::int(0));
            let [x, y] = weights;
            if proved(shape, &moving, &[(r, x), (s, y)], done)? {
                prop_assert_eq!(&moving.derivative_of(&at, S::VALUE)?, &target);
                only_these_changed(shape, &moving, &[r, s])?;
            }
        }
        Err(error) => {
            prop_assert_eq!(error, ShapeError::FlatTriangle.into());
            let [x, y] = [p_r, p_s].map(|q| q - pull.base());
            let dot = |x: &P<N>, y: &P<N>| Q::dot(x.iter().zip(y.iter()));
            prop_assert_eq!(dot(&x, &y) * dot(&x, &y), dot(&x, &x) * dot(&y, &y));
        }
    }
    along_the_line(shape, &at, &pull, &corners)?;
    Ok(())
}

fn along_the_line<S: Shape<N>, const N: usize>(
    shape: &S,
    at: &S::Parameter,
    pull: &WeightPairPull<Q, P<N>>,
    corners: &[Q; 3],
) -> Law {
    let ([r, s], p, q) = (pull.indices(), pull.point(), pull.goal());
    let lowest = pull.push_limit();
    let [a, b] = pull.shares();
    let tau = a.clone() + b;
    prop_assert_eq!(&lowest, &(-tau.clone() / (Q::int(1) - &tau)));
    prop_assert_eq!(&p.plus_scaled(&lowest, &(q.clone() - p)), pull.base());
    let part = corners[0].clone() / (corners[0].clone() + &corners[1]);
    let fraction = lowest.clone() + (Q::int(1) - &lowest) * part;
    let mut moving = shape.clone();
    if *p == q {
        prop_assert_eq!(refused(pull.weights_along(&fraction)), Some(ShapeError::Fixed));
        return Ok(());
    }
    let weights = pull.weights_along(&fraction)?;
    let [x, y] = &weights;
    prop_assert_eq!(x.clone() * &pull.weights()[1], y.clone() * &pull.weights()[0]);
    let done = pull.apply_along(&mut moving, &fraction);
    if proved(shape, &moving, &[(r, x.clone()), (s, y.clone())], done)? {
        prop_assert_eq!(moving.derivative_of(at, S::VALUE)?, p.plus_scaled(&fraction, &(q - p)));
        only_these_changed(shape, &moving, &[r, s])?;
    }
    let [low, high] = [lowest, Q::int(1)].map(|fraction| refused(pull.weights_along(&fraction)));
    let pushed = matches!(low, Some(ShapeError::PushTooFar { .. }));
    let pulled = matches!(high, Some(ShapeError::PullTooFar { .. }));
    prop_assert!(pushed && pulled);
    // The range offered is the largest with both weights in it.
    let [low, high] = if x < y { [x, y] } else { [y, x] };
    let around = WeightRange::new(low.clone() / Q::int(2), high.clone() * Q::int(2))?;
    let ranged = pull.clone().within(around.clone());
    for (limit, beyond) in [(ranged.push_limit(), -1), (ranged.pull_limit(), 1)] {
        let ends = ranged.weights_along(&limit)?;
        prop_assert!(ends.contains(around.least()) || ends.contains(around.most()));
        // They are not only cut off there.
        prop_assert_eq!(ends[0].clone() * &pull.weights()[1], ends[1].clone() * &pull.weights()[0]);
        let fraction = limit.clone() + Q::frac(beyond, 1_000_000) * (Q::int(1) - limit);
        match refused(ranged.weights_along(&fraction)) {
            Some(ShapeError::WeightOutOfRange { index, .. }) => {
                let weights = pull.weights_along(&fraction)?;
                let outside = |w: &Q| w < around.least() || around.most() < w;
                let first = weights.iter().position(outside);
                prop_assert_eq!(first.map(|i| pull.indices()[i]), Some(index));
            }
            Some(ShapeError::PushTooFar { .. }) => {}
            other => prop_assert!(false, "{:?}", other),
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn two_curve_weights_move_the_point(c in nurbs::<2>(SMALL), at: Index, picks: [Index; 2], corners in [weight(), weight(), weight()]) {
        two_weights_move_the_point(&c, at, picks, corners)?;
    }

    #[test]
    fn two_surface_weights_move_the_point(s in nurbs_surface::<3>(TINY), at: Index, picks: [Index; 2], corners in [weight(), weight(), weight()]) {
        two_weights_move_the_point(&s, at, picks, corners)?;
    }
}
