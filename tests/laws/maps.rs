//! Laws of linear and bilinear maps, rows that wrap included.

use crate::strategies::{cases, number};
use nalgebra::{DMatrix, DVector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{BilinearMap, BilinearRow, Error, Functional, LinearMap, Q, Scalar};

/// A map from `source` to `target` numbers; rows may be empty, or longer than the source and wrap more than once.
fn map(source: usize, target: usize) -> impl Strategy<Value = LinearMap<Q>> {
    vec((0..source, vec(number(), 0..=source + 3)), target).prop_map(move |rows| {
        let rows = rows.into_iter().map(|(first, weights)| Functional::new(first, weights));
        LinearMap::from_rows(source, rows).expect("rows start inside")
    })
}

fn bilinear(left: usize, right: usize, target: usize) -> impl Strategy<Value = BilinearMap<Q>> {
    let row = (0..left, 0..right, 1_usize..4, 1_usize..4, vec(number(), 9));
    vec(row, target).prop_map(move |rows| {
        let row = |(i, j, height, width, weights): (usize, usize, usize, usize, Vec<Q>)| BilinearRow {
            first: (i, j),
            weights: weights.chunks(3).take(height).map(|w| w[..width].to_vec()).collect(),
        };
        BilinearMap::from_rows(left, right, rows.into_iter().map(row)).expect("rows start inside")
    })
}

fn vector(dim: usize) -> impl Strategy<Value = Vec<Q>> {
    vec(number(), dim)
}

fn dual(x: &[Q], y: &[Q]) -> Q {
    Q::dot(x.iter().zip(y))
}

fn combination(x: &[Q], s: &Q, y: &[Q]) -> Vec<Q> {
    x.iter().zip(y).map(|(x, y)| x.clone() + s.clone() * y).collect()
}

proptest! {
    #![proptest_config(cases(128))]

    #[test]
    fn application_is_linear(
        (a, x, y) in (1_usize..6, 0_usize..6).prop_flat_map(|(n, m)| (map(n, m), vector(n), vector(n))),
        s in number(),
    ) {
        let expected = combination(&a.apply(&x)?, &s, &a.apply(&y)?);
        prop_assert_eq!(a.apply(&combination(&x, &s, &y))?, expected);
    }

    #[test]
    fn the_matrix_acts_like_the_map(
        (a, x) in (1_usize..6, 0_usize..6).prop_flat_map(|(n, m)| (map(n, m), vector(n))),
    ) {
        let image = a.to_matrix()? * DVector::from_vec(x.clone());
        prop_assert_eq!(a.apply(&x)?, image.as_slice());
    }

    #[test]
    fn after_is_composition(
        (a, b, x) in (1_usize..6, 1_usize..6, 0_usize..6)
            .prop_flat_map(|(n, m, l)| (map(n, m), map(m, l), vector(n))),
    ) {
        let composed = b.after(&a)?;
        prop_assert_eq!(composed.apply(&x)?, b.apply(&a.apply(&x)?)?);
        prop_assert_eq!(composed.to_matrix()?, b.to_matrix()? * a.to_matrix()?);
        prop_assert_eq!((composed.source_dim(), composed.target_dim()), (a.source_dim(), b.target_dim()));
    }

    #[test]
    fn composition_associates(
        (a, b, c) in (1_usize..5, 1_usize..5, 1_usize..5, 1_usize..5)
            .prop_flat_map(|(n, m, l, k)| (map(n, m), map(m, l), map(l, k))),
    ) {
        prop_assert_eq!(c.after(&b)?.after(&a)?.to_matrix()?, c.after(&b.after(&a)?)?.to_matrix()?);
    }

    #[test]
    fn the_transpose_is_dual(
        (a, x, y) in (1_usize..6, 1_usize..6).prop_flat_map(|(n, m)| (map(n, m), vector(n), vector(m))),
    ) {
        let transposed = a.transpose();
        prop_assert_eq!(dual(&a.apply(&x)?, &y), dual(&x, &transposed.apply(&y)?));
        prop_assert_eq!(transposed.to_matrix()?, a.to_matrix()?.transpose());
        prop_assert_eq!(transposed.transpose().to_matrix()?, a.to_matrix()?);
    }

    #[test]
    fn a_functional_is_pulled_back_through_the_map(
        (a, x, b) in (1_usize..6, 1_usize..6).prop_flat_map(|(n, m)| (map(n, m), vector(n), map(m, 3))),
    ) {
        for (first, weights) in b.rows() {
            let functional = Functional::new(first, weights);
            let pulled = a.pull_back(&functional);
            prop_assert_eq!(pulled.apply(&x), functional.apply(&a.apply(&x)?));
        }
    }

    #[test]
    fn the_identity_is_neutral(
        (n, a) in (1_usize..6, 1_usize..6).prop_flat_map(|(n, m)| (Just(n), map(n, m))),
    ) {
        let (before, after) = (LinearMap::identity(n), LinearMap::identity(a.target_dim()));
        prop_assert_eq!(a.after(&before)?.to_matrix()?, a.to_matrix()?);
        prop_assert_eq!(after.after(&a)?.to_matrix()?, a.to_matrix()?);
        prop_assert_eq!(before.to_matrix()?, DMatrix::<Q>::identity(n, n));
    }

    #[test]
    fn wrong_counts_are_refused(
        (a, x) in (1_usize..5, 1_usize..5, 0_usize..9).prop_flat_map(|(n, m, k)| (map(n, m), vector(k))),
    ) {
        prop_assert_eq!(a.apply(&x).is_ok(), x.len() == a.source_dim());
        let other = LinearMap::<Q>::identity(x.len());
        prop_assert_eq!(a.after(&other).is_ok(), x.len() == a.source_dim());
    }

    #[test]
    fn a_fixed_factor_leaves_a_linear_map(
        (b, x, y) in (1_usize..5, 1_usize..5, 1_usize..5)
            .prop_flat_map(|(n, m, l)| (bilinear(n, m, l), vector(n), vector(m))),
    ) {
        let image = b.apply(&x, &y)?;
        prop_assert_eq!(&b.fix_left(&x)?.apply(&y)?, &image);
        prop_assert_eq!(&b.swapped().apply(&y, &x)?, &image);
        prop_assert_eq!(&b.swapped().swapped(), &b);
        let by_hand = |row: &BilinearRow<Q>| {
            let mut sum = Q::int(0);
            for (k, weights) in row.weights.iter().enumerate() {
                for (l, w) in weights.iter().enumerate() {
                    sum += w.clone() * &x[(row.first.0 + k) % x.len()] * &y[(row.first.1 + l) % y.len()];
                }
            }
            sum
        };
        prop_assert_eq!(b.rows().iter().map(by_hand).collect::<Vec<Q>>(), image);
    }

    #[test]
    fn bilinear_maps_are_linear_on_either_side(
        (b, x, y, v, w) in (1_usize..5, 1_usize..5, 1_usize..5)
            .prop_flat_map(|(n, m, l)| (bilinear(n, m, l), vector(n), vector(m), vector(n), vector(m))),
        s in number(),
    ) {
        let left = combination(&b.apply(&x, &y)?, &s, &b.apply(&v, &y)?);
        prop_assert_eq!(b.apply(&combination(&x, &s, &v), &y)?, left);
        let right = combination(&b.apply(&x, &y)?, &s, &b.apply(&x, &w)?);
        prop_assert_eq!(b.apply(&x, &combination(&y, &s, &w))?, right);
    }

    #[test]
    fn maps_of_two_directions_are_kronecker_products(
        a in (1_usize..5, 1_usize..5).prop_flat_map(|(n, m)| map(n, m)),
        b in (1_usize..5, 1_usize..5).prop_flat_map(|(n, m)| map(n, m)),
    ) {
        prop_assert_eq!(a.tensor(&b)?.to_matrix()?, a.to_matrix()?.kronecker(&b.to_matrix()?));
    }
}

#[test]
fn large_maps_of_two_directions_are_refused() {
    let long = LinearMap::<f64>::identity(1 << 20);
    assert!(matches!(long.tensor(&long), Err(Error::TooLarge { .. })));
    let wide = LinearMap::from_rows(usize::MAX, [Functional::new(usize::MAX - 1, [1.0])]).expect("a row");
    assert!(matches!(wide.tensor(&wide), Err(Error::TooLarge { .. })));
}
