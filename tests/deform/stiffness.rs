//! Laws of the stiffness of one direction: it is the energy, its factors solve with it, and what costs nothing is refused.

use crate::body::{Wish, wish};
use crate::strategies::{ANY, Kind, cases, curve, number, point, probes, space};
use nalgebra::{DMatrix, SVector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{
    Breadth, DeformError, Error, Function, Material, Q, Result, Scalar, SplineSpace, Stiffness, solve_dense,
};

const LOW: Kind = ANY.of_degree(0, 4);
/// Spaces on which second derivatives are splines.
const TWICE: Kind = ANY.smooth(2);

fn pure(order: usize) -> Result<Material<Q>> {
    Material::of_orders((0..=order).map(|k| Q::int(i64::from(k == order))))
}

/// The stiffness matrix on the coefficients that may move, dense.
fn dense(space: &SplineSpace<Q>, wish: &Wish, moving: &[usize]) -> Result<DMatrix<Q>> {
    let whole = wish.first_material()?.matrix(space)?.to_matrix()?;
    Ok(DMatrix::from_fn(moving.len(), moving.len(), |i, j| whole[(moving[i], moving[j])].clone()))
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn the_matrix_is_the_gram_matrix_of_derivatives(space in space(TWICE), order in 0..=2_usize) {
        let (ours, gram) = (pure(order)?.matrix(&space)?, space.gram(&space, order, order)?);
        prop_assert_eq!(ours.to_matrix()?, gram.to_matrix()?);
    }

    #[test]
    fn the_energy_is_a_sum_over_spans(curve in curve::<2>(LOW), order in 0..=3_usize) {
        let breaks = curve.space().breaks();
        let mut sum = Q::int(0);
        for ends in breaks.windows(2) {
            let piece = curve.restricted(&ends[0].0, &ends[1].0)?;
            if order <= piece.space().degree() {
                let derivative = piece.nth_derivative(order)?;
                sum += derivative.inner(&derivative)?;
            }
        }
        prop_assert_eq!(&pure(order)?.energy(&curve)?, &sum);
        let loads = pure(order)?.matrix(curve.space())?.apply(curve.coeffs())?;
        let product = loads.iter().zip(curve.coeffs()).fold(Q::int(0), |sum, (k, c)| sum + Q::dot(k.iter().zip(c.iter())));
        prop_assert_eq!(product, sum);
    }

    #[test]
    fn solutions_solve(space in space(LOW), wish in wish(), load in vec(point::<2>(), 100)) {
        let breadth = wish.first_breadth(&space);
        let Ok(moving) = breadth.coeffs(&space) else { return Ok(()) };
        let matrix = dense(&space, &wish, &moving)?;
        let load: Vec<SVector<Q, 2>> = load.into_iter().cycle().take(space.dim()).collect();
        let right = DMatrix::from_fn(moving.len(), 2, |i, k| load[moving[i]][k].clone());
        match (Stiffness::new(&space, &wish.first_material()?, &breadth), solve_dense(&matrix, &right)) {
            (Ok(stiffness), Ok(expected)) => {
                let solved = stiffness.solved(&load)?;
                for (i, d) in solved.iter().enumerate() {
                    let rank = moving.iter().position(|k| *k == i);
                    let one = rank.map_or(SVector::from([Q::int(0), Q::int(0)]), |r| {
                        SVector::from([expected[(r, 0)].clone(), expected[(r, 1)].clone()])
                    });
                    prop_assert_eq!(d, &one);
                }
            }
            (Err(Error::Deform(DeformError::NullSpace { order, dimension, coefficient })), Err(Error::Singular { .. })) => {
                let weights = wish.first_material()?.weights().to_vec();
                prop_assert_eq!(order, weights.iter().position(|w| *w != Q::int(0)));
                prop_assert!(dimension >= 1 && dimension <= moving.len() && moving.contains(&coefficient));
            }
            (found, expected) => prop_assert!(false, "{:?} instead of {:?}", found, expected),
        }
    }

    #[test]
    fn floats_solve_too(space in space(LOW), wish in wish(), load in vec(number(), 100)) {
        let breadth = wish.first_breadth(&space);
        let (Ok(floats), Ok(moving)) = (space.map_scalars(|x| Ok(x.to_f64())), breadth.coeffs(&space)) else { return Ok(()) };
        let material = wish.first_material()?;
        let rounded = Material::of_orders(material.weights().iter().map(Q::to_f64))?;
        let (Ok(exact), found) = (
            Stiffness::new(&floats.map_scalars(|x| Q::try_from(*x))?, &material, &Breadth::Listed(moving.clone())),
            Stiffness::new(&floats, &rounded, &Breadth::Listed(moving)),
        ) else {
            return Ok(());
        };
        let load: Vec<Q> = load.into_iter().cycle().take(space.dim()).collect();
        let image: Vec<f64> = load.iter().map(Q::to_f64).collect();
        let load = image.iter().map(|x| Q::try_from(*x)).collect::<Result<Vec<_>>>()?;
        let expected = exact.solved(&load)?;
        // A chain of few links: what spans of very different lengths leave of the digits.
        let spans: Vec<f64> = floats.knots().windows(2).map(|w| w[1] - w[0]).filter(|h| *h > 0.0).collect();
        let (short, long) = spans.iter().fold((f64::MAX, 0.0_f64), |(s, l), h| (s.min(*h), l.max(*h)));
        if long > 100.0 * short {
            return Ok(());
        }
        let solved = found?.solved(&image)?;
        let size = expected.iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
        for (x, y) in solved.iter().zip(&expected) {
            prop_assert!((x - y.to_f64()).abs() <= 1e-6 * size, "{} instead of {}", x, y.to_f64());
        }
    }

    /// Whatever the knots, floats refuse what exact numbers refuse, for the same number of motions.
    #[test]
    fn floats_refuse_the_same(space in space(ANY.of_degree(0, 5)), wish in wish()) {
        let (Ok(floats), Ok(moving)) = (space.map_scalars(|x| Ok(x.to_f64())), wish.first_breadth(&space).coeffs(&space)) else {
            return Ok(());
        };
        let material = wish.first_material()?;
        let rounded = Material::of_orders(material.weights().iter().map(Q::to_f64))?;
        let exact = Stiffness::new(&floats.map_scalars(|x| Q::try_from(*x))?, &material, &Breadth::Listed(moving.clone()));
        let found = Stiffness::new(&floats, &rounded, &Breadth::Listed(moving));
        match (exact, found) {
            (Err(Error::Deform(DeformError::NullSpace { order, dimension, .. })), Err(Error::Deform(DeformError::NullSpace { order: o, dimension: d, .. }))) => {
                prop_assert_eq!((order, dimension), (o, d));
            }
            (Err(Error::Deform(DeformError::NullSpace { dimension, .. })), found) => {
                prop_assert!(false, "{} motions, {:?}", dimension, found.is_ok());
            }
            _ => {}
        }
    }

    #[test]
    fn hats_share_out_loads(space in space(LOW), at in any::<prop::sample::Index>()) {
        let stiffness = Stiffness::new(&space, &pure(0)?, &Breadth::Whole)?;
        let forcing = stiffness.forcing().to_matrix()?;
        let breaks = space.breaks();
        let count = breaks.len() - usize::from(space.is_periodic());
        prop_assert_eq!(forcing.shape(), (count, space.dim()));
        // Hats add up to one.
        let moment = space.moment(0)?.to_dense(space.dim());
        for (i, whole) in moment.iter().enumerate() {
            prop_assert_eq!(&forcing.column(i).iter().sum::<Q>(), whole);
        }
        // Each entry is the integral of a product.
        let j = at.index(count);
        let mut hat = vec![Q::int(0); count];
        hat[j] = Q::int(1);
        let ends: Vec<Q> = breaks.iter().map(|(knot, _)| knot.clone()).collect();
        let lines = if space.is_periodic() {
            let (a, b) = space.domain();
            SplineSpace::periodic(1, ends[..count].iter().cloned(), b.clone() - a)?
        } else {
            SplineSpace::clamped(1, ends)?
        };
        let hat = Function::new(lines, hat)?;
        for i in 0..space.dim() {
            let mut one = vec![Q::int(0); space.dim()];
            one[i] = Q::int(1);
            let basis = Function::new(space.clone(), one)?;
            prop_assert_eq!(&forcing[(j, i)], &basis.inner(&hat)?);
        }
        // A force is shared by the breaks on both sides.
        let x = at.get(&probes(&space)).clone();
        let k = breaks.windows(2).position(|w| w[0].0 <= x && x <= w[1].0).expect("inside");
        let right = (x.clone() - &breaks[k].0) / (breaks[k + 1].0.clone() - &breaks[k].0);
        let load = stiffness.hat_load(&x)?.to_dense(space.dim());
        for (i, found) in load.iter().enumerate() {
            let (left_row, right_row) = (&forcing[(k, i)], &forcing[((k + 1) % count, i)]);
            prop_assert_eq!(found, &(left_row * (Q::int(1) - &right) + right_row * &right));
        }
    }

    #[test]
    fn windows_hold_the_nearest_nodes(space in space(ANY.of_degree(1, 4)), at in any::<prop::sample::Index>(), count in 1..6_usize) {
        let x = at.get(&probes(&space)).clone();
        let found = Breadth::Around(x.clone(), count).coeffs(&space)?;
        prop_assert_eq!(found.len(), count.min(space.dim()));
        if space.is_periodic() {
            return Ok(());
        }
        prop_assert!(found.windows(2).all(|w| w[1] == w[0] + 1));
        let nodes = space.greville();
        let farthest = found.iter().map(|i| (nodes[*i].clone() - &x).abs()).max().expect("some");
        for (i, node) in nodes.iter().enumerate().filter(|(i, _)| !found.contains(i)) {
            prop_assert!((node.clone() - &x).abs() >= farthest, "{}", i);
        }
    }
}

/// A long chain that only bends, held at its ends: the condition of its matrix is `n⁴`, and still most digits are right.
#[test]
fn long_chains_keep_their_digits() -> Result<()> {
    let space = SplineSpace::uniform(3, 2000, 0.0, 1.0)?;
    let stiffness = Stiffness::new(&space, &Material::new(0.0, 1.0)?, &Breadth::BetweenEnds(2))?;
    let answer = stiffness.response(&space.basis(&0.5)?)?;
    // A clamped beam under a force in the middle: 1 / 192 for length and stiffness one.
    let middle = Function::new(space, answer.clone())?.at(&0.5)?;
    assert!((middle * 192.0 - 1.0).abs() < 1e-6, "{}", middle * 192.0);
    let n = answer.len();
    let skew = (0..n).map(|i| (answer[i] - answer[n - 1 - i]).abs()).fold(0.0, f64::max);
    assert!(skew < 1e-7 * middle, "{skew:e}");
    Ok(())
}

/// Spans from tiny to huge: floats count the free motions that there are.
#[test]
fn free_motions_of_uneven_splines_are_counted() -> Result<()> {
    let knots: Vec<f64> = (0..12).map(|i| f64::from(i) + if i > 6 { 1000.0 } else { 0.0 }).collect();
    let space = SplineSpace::clamped(3, knots)?;
    let bending = Material::new(0.0, 1.0)?;
    for (breadth, expected) in [(Breadth::Whole, 2), (Breadth::Range(0..13), 1), (Breadth::Range(1..14), 1)] {
        let found = Stiffness::new(&space, &bending, &breadth).unwrap_err();
        let told =
            matches!(found, Error::Deform(DeformError::NullSpace { dimension, .. }) if dimension == expected);
        assert!(told, "{found}");
    }
    Stiffness::new(&space, &bending, &Breadth::Range(0..12))?;
    Ok(())
}
