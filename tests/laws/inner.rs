//! Laws of inner products and Gram matrices.

use crate::oracle::{self, unit};
use crate::strategies::{ANY, Kind, cases, curves, function, functions, number, probes, space, spaces};
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Functional, Q, Scalar, SplineSpace};

const SMALL: Kind = ANY.of_degree(0, 4);

fn choose(n: usize, k: usize) -> i64 {
    (0..k).fold(1, |c, i| c * (n - i) as i64 / (i as i64 + 1))
}

fn dual(x: &[Q], y: &[Q]) -> Q {
    Q::dot(x.iter().zip(y))
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn entries_are_inner_products_of_basis_functions(
        [f, g] in spaces(ANY.of_degree(0, 2), ANY.of_degree(0, 3)),
    ) {
        let gram = f.gram(&g, 0, 0)?.to_matrix()?;
        prop_assert_eq!(gram.shape(), (f.dim(), g.dim()));
        for i in 0..f.dim() {
            for j in 0..g.dim() {
                prop_assert_eq!(&gram[(i, j)], &unit(&f, i).inner(&unit(&g, j))?);
            }
        }
    }

    #[test]
    fn entries_of_derivatives_are_inner_products_of_derivatives(
        [f, g] in spaces(ANY.of_degree(1, 3).smooth(1), ANY.of_degree(1, 3).smooth(2)),
    ) {
        let gram = f.gram(&g, 1, 2)?.to_matrix()?;
        for i in 0..f.dim() {
            let first = unit(&f, i).derivative()?;
            for j in 0..g.dim() {
                prop_assert_eq!(&gram[(i, j)], &first.inner(&unit(&g, j).nth_derivative(2)?)?);
            }
        }
    }

    #[test]
    fn the_gram_map_gives_inner_products([f, g] in functions(SMALL, SMALL)) {
        let image = f.space().gram(g.space(), 0, 0)?.apply(g.coeffs())?;
        prop_assert_eq!(dual(f.coeffs(), &image), f.inner(&g)?);
        prop_assert_eq!(f.inner(&g)?, f.times(&g)?.integral()?);
        prop_assert_eq!(f.inner(&g)?, f.weighted_integral(&g)?);
    }

    #[test]
    fn inner_products_are_those_of_the_powers(f in function(ANY.of_degree(0, 3)), power in 0_usize..4) {
        let (a, b) = f.domain();
        let monomial = symspline::Function::monomial(power, a.clone(), b.clone())?;
        let expected: Q = oracle::powers(&f).iter().map(|piece| piece.moment(power, a, b)).sum();
        prop_assert_eq!(f.inner(&monomial)?, expected);
    }

    #[test]
    fn gram_matrices_are_symmetric(
        [f, g] in spaces(ANY.of_degree(1, 4).smooth(1), ANY.of_degree(1, 4).smooth(1)),
    ) {
        for (k, l) in [(0, 0), (0, 1), (1, 1)] {
            prop_assert_eq!(f.gram(&g, k, l)?.transpose().to_matrix()?, g.gram(&f, l, k)?.to_matrix()?);
        }
    }

    #[test]
    fn no_function_but_zero_has_norm_zero(f in function(SMALL)) {
        let square = dual(f.coeffs(), &f.space().gram(f.space(), 0, 0)?.apply(f.coeffs())?);
        prop_assert!(!square.is_negative());
        prop_assert_eq!(square == Q::int(0), f.coeffs().iter().all(|c| *c == Q::int(0)));
    }

    #[test]
    fn rows_sum_to_the_integrals_of_the_basis(space in space(SMALL)) {
        let gram = space.gram(&space, 0, 0)?;
        let (a, b) = space.domain();
        let masses = space.integral_between(a, b)?.to_dense(space.dim());
        prop_assert_eq!(gram.apply(&vec![Q::int(1); space.dim()])?, masses);
    }

    #[test]
    fn a_part_of_the_domain_has_the_gram_matrix_of_the_restrictions(
        [f, g] in functions(SMALL, SMALL),
        places in (any::<Index>(), any::<Index>()),
    ) {
        let probes = probes(&f.space().product_space(g.space())?);
        let (a, b) = (places.0.get(&probes), places.1.get(&probes));
        prop_assume!(a < b);
        let gram = f.space().gram_between(g.space(), 0, 0, a, b)?;
        let expected = f.restricted(a, b)?.inner(&g.restricted(a, b)?)?;
        prop_assert_eq!(dual(f.coeffs(), &gram.apply(g.coeffs())?), expected);
    }

    #[test]
    fn parts_add_up_to_the_whole(space in space(SMALL.smooth(1)), place in any::<Index>()) {
        let probes = probes(&space);
        let (a, b) = space.domain();
        let x = place.get(&probes);
        prop_assume!(a < x && x < b);
        for order in 0..2 {
            let part = |a: &Q, b: &Q| space.gram_between(&space, order, order, a, b)?.to_matrix();
            prop_assert_eq!(part(a, x)? + part(x, b)?, space.gram(&space, order, order)?.to_matrix()?);
        }
    }

    #[test]
    fn bernstein_polynomials_have_the_known_gram_matrix(
        p in 0_usize..6,
        q in 0_usize..6,
        a in number(),
        length in 1_i64..9,
    ) {
        let b = a.clone() + Q::int(length);
        let (f, g) = (SplineSpace::bezier(p, a.clone(), b.clone())?, SplineSpace::bezier(q, a, b)?);
        let gram = f.gram(&g, 0, 0)?.to_matrix()?;
        for i in 0..=p {
            for j in 0..=q {
                let share = Q::frac(choose(p, i) * choose(q, j), choose(p + q, i + j) * (p + q + 1) as i64);
                prop_assert_eq!(&gram[(i, j)], &(Q::int(length) * share));
            }
        }
    }

    #[test]
    fn inner_products_of_curves_sum_over_the_coordinates([c, d] in curves::<2>(SMALL, SMALL)) {
        let term = |axis: usize| c.coordinate(axis)?.inner(&d.coordinate(axis)?);
        prop_assert_eq!(c.inner(&d)?, term(0)? + term(1)?);
    }
}

#[test]
fn the_stiffness_of_lines_on_equal_spans_is_known() -> symspline::Result<()> {
    let lines = SplineSpace::uniform(1, 3, Q::int(0), Q::int(3))?;
    let row = |first: usize, weights: &[i64]| {
        Functional::new(first, weights.iter().copied().map(Q::int).collect::<Vec<_>>())
    };
    let expected = [row(0, &[1, -1]), row(0, &[-1, 2, -1]), row(1, &[-1, 2, -1]), row(2, &[-1, 1])];
    let expected = symspline::LinearMap::from_rows(4, expected)?;
    assert_eq!(lines.gram(&lines, 1, 1)?.to_matrix()?, expected.to_matrix()?);
    Ok(())
}
