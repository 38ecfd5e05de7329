//! Laws of the motions that cost nothing, and of stiffness matrices by quadrature.

use crate::strategies::{ANY, Kind, cases, space};
use nalgebra::DMatrix;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::{Breadth, DeformError, Error, Material, Q, Result, Scalar, SplineSpace, Stiffness};

const SHAPE: Kind = ANY.of_degree(0, 6);

fn weight() -> impl Strategy<Value = Q> {
    select(vec![Q::int(0), Q::int(0), Q::int(1), Q::frac(1, 3)])
}

fn material() -> impl Strategy<Value = Material<Q>> {
    vec(weight(), 0..5).prop_map(|weights| Material::of_orders(weights).expect("weights from zero on"))
}

fn rank(rows: &[Vec<Q>]) -> usize {
    let mut rows = rows.to_vec();
    let mut rank = 0;
    for column in 0..rows.first().map_or(0, Vec::len) {
        let Some(pivot) = (rank..rows.len()).find(|i| !num_traits::Zero::is_zero(&rows[*i][column])) else {
            continue;
        };
        rows.swap(rank, pivot);
        let (above, below) = rows.split_at_mut(rank + 1);
        for row in below {
            let factor = row[column].clone() / &above[rank][column];
            row.iter_mut().zip(&above[rank]).for_each(|(x, y)| *x -= factor.clone() * y);
        }
        rank += 1;
    }
    rank
}

/// How many motions of all coefficients cost nothing, by multiplicities.
fn dimension(space: &SplineSpace<Q>, material: &Material<Q>) -> usize {
    let p = space.degree();
    let Some(k) = material.weights().iter().position(|w| *w > Q::int(0)).filter(|k| *k <= p) else {
        return space.dim();
    };
    let breaks = space.breaks();
    let broken = |(_, m): &(Q, usize)| (m + k).saturating_sub(p + 1);
    let inside = breaks[1..breaks.len() - 1].iter().map(broken).sum::<usize>();
    match k {
        0 => 0,
        _ if space.is_periodic() => (inside + broken(&breaks[0])).max(1),
        _ => k + inside,
    }
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn motions_that_cost_nothing_are_found(
        space in space(SHAPE), material in material(), places in vec(any::<Index>(), 1..8), whole in any::<bool>(),
    ) {
        let listed = || Breadth::Listed(places.iter().map(|i| i.index(space.dim())).collect());
        let breadth = if whole { Breadth::Whole } else { listed() };
        let moving = breadth.coeffs(&space)?;
        let matrix = material.matrix(&space)?;
        let basis = material.null_space(&space, &breadth)?;
        for x in &basis {
            prop_assert!(matrix.apply(x)?.iter().all(|y| *y == Q::int(0)));
            prop_assert!((0..space.dim()).all(|i| moving.contains(&i) || x[i] == Q::int(0)));
        }
        prop_assert_eq!(rank(&basis), basis.len());
        let full = matrix.to_matrix()?;
        let part: Vec<Vec<Q>> =
            moving.iter().map(|i| moving.iter().map(|j| full[(*i, *j)].clone()).collect()).collect();
        prop_assert_eq!(basis.len(), moving.len() - rank(&part));
        if whole {
            prop_assert_eq!(basis.len(), dimension(&space, &material));
        }
        match Stiffness::new(&space, &material, &breadth) {
            Ok(_) => prop_assert!(basis.is_empty()),
            Err(Error::Deform(DeformError::NullSpace { dimension, .. })) => {
                prop_assert_eq!(dimension, basis.len());
            }
            Err(other) => return Err(other.into()),
        }
    }
}

/// The breaks of a space of floats: no span much shorter than others.
fn moderate() -> impl Strategy<Value = SplineSpace<f64>> {
    (0..=5_usize, vec((0.2..2.0_f64, 1..4_usize), 1..12), any::<bool>()).prop_map(|(p, spans, ring)| {
        let mut knots = vec![0.0];
        let mut last = 0.0;
        for (length, copies) in &spans {
            last += length;
            knots.extend(std::iter::repeat_n(last, (*copies).min(p + 1)));
        }
        let inside = knots.iter().copied().filter(|t| *t < last);
        let built = if ring {
            SplineSpace::periodic(p, inside, last)
        } else {
            SplineSpace::clamped(p, inside.chain([last]))
        };
        built.expect("ascending knots")
    })
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn floats_find_the_same_dimension(space in moderate(), material in material(), held in 0..2_usize) {
        // In a smaller ring terms cancel, all of them or nearly.
        prop_assume!(space.dim() > space.degree());
        let floats = Material::of_orders(material.weights().iter().map(Q::to_f64))?;
        let exact = space.map_scalars(|x| Q::try_from(*x))?;
        let listed: Vec<usize> = (held.min(space.degree())..space.dim()).collect();
        let expected = material.null_space(&exact, &Breadth::Listed(listed.clone()))?;
        let found = floats.null_space(&space, &Breadth::Listed(listed))?;
        prop_assert_eq!(found.len(), expected.len());
        let matrix = floats.matrix(&space)?.to_matrix()?;
        for x in &found {
            let most = x.iter().fold(0.0_f64, |most, y| most.max(y.abs()));
            let image = matrix.clone() * nalgebra::DVector::from_vec(x.clone());
            prop_assert!(image.amax() <= 1e-11 * most * matrix.amax());
        }
    }

    /// Entries differ by rounding: at most `200 (p + 1) ε` of the largest term.
    #[test]
    fn quadrature_is_the_integral(space in moderate(), material in material()) {
        // In a smaller ring all terms cancel.
        prop_assume!(space.dim() > space.degree());
        let floats = Material::of_orders(material.weights().iter().map(Q::to_f64))?;
        let [exact, found] = [floats.matrix(&space)?, floats.matrix_by_quadrature(&space)?].map(|m| m.to_matrix());
        let (exact, found): (DMatrix<f64>, DMatrix<f64>) = (exact?, found?);
        let bound = 200.0 * (space.degree() + 1) as f64 * f64::EPSILON * exact.amax();
        prop_assert!((&exact - &found).amax() <= bound, "{} {}", (&exact - &found).amax(), exact.amax());
    }

    /// For each order of derivative `p - k + 1` nodes are enough, and one fewer is not.
    #[test]
    fn no_fewer_nodes_suffice(space in moderate(), order in 0..4_usize) {
        prop_assume!(order <= space.degree() && space.dim() > space.degree());
        let material = Material::of_orders((0..=order).map(|k| f64::from(u8::from(k == order))))?;
        let exact = material.matrix(&space)?.to_matrix()?;
        let nodes = space.degree() - order + 1;
        let by = |nodes: usize| material.matrix_by_rule(&space, nodes)?.to_matrix();
        let enough = 400.0 * (space.degree() + 1) as f64 * f64::EPSILON * exact.amax();
        prop_assert!((by(nodes)? - &exact).amax() <= enough);
        prop_assert!((by(nodes + 3)? - &exact).amax() <= enough);
        prop_assert!((by(nodes - 1)? - &exact).amax() > 1e-6 * exact.amax());
    }
}

#[test]
fn hostile_requests_are_refused() -> Result<()> {
    let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    let material = Material::new(1.0, 1.0)?;
    assert!(matches!(material.matrix_by_rule(&space, usize::MAX), Err(Error::TooLarge { .. })));
    let huge = Material::new(1e300, 1e300)?;
    assert!(matches!(
        huge.matrix_by_quadrature(&SplineSpace::uniform(3, 4, 0.0, 1e-20)?),
        Err(Error::NotFinite { .. })
    ));
    let nothing = Material::<f64>::of_orders([])?;
    let large = SplineSpace::uniform(1, 20_000, 0.0, 1.0)?;
    assert!(matches!(nothing.null_space(&large, &Breadth::Whole), Err(Error::TooLarge { .. })));
    assert_eq!(material.null_space(&space, &Breadth::Whole)?.len(), 1);
    Ok(())
}

/// The basis of bending on a long chain is still linear.
#[test]
fn long_chains_have_straight_motions() -> Result<()> {
    let space = SplineSpace::uniform(3, 1000, 0.0, 1.0)?;
    let basis = Material::new(0.0, 1.0)?.null_space(&space, &Breadth::Whole)?;
    assert_eq!(basis.len(), 2);
    let nodes = space.greville();
    for x in basis {
        let slope = (x[1002] - x[0]) / (nodes[1002] - nodes[0]);
        let most = x.iter().fold(0.0_f64, |most, y| most.max(y.abs()));
        let off = nodes.iter().zip(&x).map(|(t, y)| (x[0] + slope * t - y).abs()).fold(0.0, f64::max);
        assert!(off < 1e-6 * most, "{off} {most}");
    }
    Ok(())
}
