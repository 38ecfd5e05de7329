//! Laws of embedding without a change of degree: insertion, clamping, Bezier pieces.

use crate::oracle::{self, Side};
use crate::strategies::{ANY, OPEN, RING, cases, curve, function, indices, insertable, probes, space};
use proptest::prelude::*;
use symspline::{Function, Q, Scalar};

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn insertion_changes_no_value(f in function(ANY), places in indices(5)) {
        let knots = insertable(f.space(), &places);
        let refined = f.inserted(&knots)?;
        prop_assert!(refined.same_function(&f)?);
        for x in probes(refined.space()) {
            prop_assert_eq!(refined.at(&x)?, oracle::value(&f, &x, Side::Right));
            prop_assert_eq!(refined.at_left(&x)?, oracle::value(&f, &x, Side::Left));
        }
    }

    #[test]
    fn many_insertions_at_once_are_one_after_the_other(c in curve::<2>(ANY), places in indices(5)) {
        let knots = insertable(c.space(), &places);
        let all = c.inserted(&knots)?;
        let one_by_one = knots.iter().try_fold(c, |c, t| c.inserted(std::slice::from_ref(t)))?;
        prop_assert_eq!(one_by_one, all);
    }

    #[test]
    fn inserted_coefficients_are_convex_combinations(space in space(ANY), places in indices(5)) {
        let map = space.embedding(&space.refined(&insertable(&space, &places))?)?;
        for (_, weights) in map.rows() {
            prop_assert_eq!(weights.iter().sum::<Q>(), Q::int(1));
            prop_assert!(weights.iter().all(|w| !w.is_negative()));
        }
    }

    #[test]
    fn an_inserted_coefficient_is_a_polar_value(f in function(ANY), places in indices(5)) {
        let refined = f.inserted(&insertable(f.space(), &places))?;
        let (p, t) = (f.degree(), refined.space().knots());
        for k in refined.space().spans() {
            let span = oracle::span_of(f.space(), &t[k], &t[k + 1]);
            for j in k - p..=k {
                let value = oracle::polar(&f, span, &t[j + 1..=j + p]);
                prop_assert_eq!(&refined.coeffs()[refined.space().slot(j)], &value);
            }
        }
    }

    #[test]
    fn embeddings_compose(space in space(ANY), places in (indices(3), indices(3)), raise in 0_usize..3) {
        let middle = space.refined(&insertable(&space, &places.0))?.elevated(raise)?;
        let last = middle.refined(&insertable(&middle, &places.1))?;
        let composed = middle.embedding(&last)?.after(&space.embedding(&middle)?)?;
        prop_assert_eq!(composed.to_matrix()?, space.embedding(&last)?.to_matrix()?);
    }

    #[test]
    fn the_embedding_acts_as_the_embedded_spline(
        f in function(ANY),
        places in indices(3),
        raise in 0_usize..3,
    ) {
        let target = f.space().elevated(raise)?.refined(&insertable(f.space(), &places))?;
        let embedded = f.embedded(&target)?;
        prop_assert_eq!(embedded.space(), &target);
        prop_assert_eq!(f.space().embedding(&target)?.apply(f.coeffs())?, embedded.coeffs());
    }

    #[test]
    fn constants_stay_constant(space in space(ANY), places in indices(5), raise in 0_usize..3) {
        let target = space.elevated(raise)?.refined(&insertable(&space, &places))?;
        let one = Function::constant(space, Q::frac(2, 3))?;
        prop_assert_eq!(one.embedded(&target)?, Function::constant(target, Q::frac(2, 3))?);
    }

    #[test]
    fn clamping_and_unclamping_change_no_value(f in function(ANY)) {
        let (clamped, unclamped) = (f.clamped_ends()?, f.unclamped_ends()?);
        prop_assert!(clamped.space().is_clamped() && !unclamped.space().is_periodic());
        for x in probes(f.space()) {
            let value = f.at(&x)?;
            prop_assert_eq!(&clamped.at(&x)?, &value);
            prop_assert_eq!(&unclamped.at(&x)?, &value);
        }
        let (a, b) = f.domain();
        prop_assert_eq!(&clamped.coeffs()[0], &f.at(a)?);
        prop_assert_eq!(clamped.coeffs().last().unwrap(), &f.at(b)?);
        prop_assert_eq!(unclamped.clamped_ends()?, clamped);
    }

    #[test]
    fn unclamped_ends_come_back(f in function(OPEN)) {
        let moved = f.unclamped_ends()?.embedded(f.space())?;
        prop_assert_eq!(moved, f);
    }

    #[test]
    fn an_opened_ring_keeps_its_coefficients(f in function(RING)) {
        let opened = f.unclamped_ends()?;
        // Unrolled coefficients beyond a double seam have no influence and are left out.
        let kept = opened.space().knots().len();
        prop_assert_eq!(&opened.space().knots()[..], &f.space().knots()[..kept]);
        prop_assert!(kept > f.space().dim() + f.degree());
        for (i, c) in opened.coeffs().iter().enumerate() {
            prop_assert_eq!(c, &f.coeffs()[f.space().slot(i)]);
        }
    }

    #[test]
    fn pieces_are_the_spline_on_their_intervals(f in function(ANY)) {
        let (pieces, breaks) = (f.bezier_pieces()?, f.space().breaks());
        prop_assert_eq!(pieces.len(), breaks.len() - 1);
        for (piece, ends) in pieces.iter().zip(breaks.windows(2)) {
            let (a, b) = (&ends[0].0, &ends[1].0);
            prop_assert_eq!(piece.domain(), (a, b));
            prop_assert_eq!(piece.coeffs().len(), f.degree() + 1);
            prop_assert_eq!(&piece.coeffs()[0], &f.at(a)?);
            prop_assert_eq!(&piece.coeffs()[f.degree()], &f.at_left(b)?);
            for x in probes(piece.space()) {
                let side = if x == *b { Side::Left } else { Side::Right };
                prop_assert_eq!(piece.at(&x)?, oracle::value(&f, &x, side));
            }
        }
    }

    #[test]
    fn pieces_compose_to_the_spline(f in function(ANY)) {
        let all = f.embedded(&f.space().pieces(f.degree())?)?;
        let recomposed = f.space().recomposition()?.apply(all.coeffs())?;
        prop_assert_eq!(recomposed, f.coeffs());
    }

    #[test]
    fn the_kernel_of_pieces_gives_what_their_map_gives(f in function(ANY)) {
        let map = f.space().embedding(&f.space().pieces(f.degree())?)?;
        let pieces = f.bezier_pieces()?;
        let coeffs: Vec<Q> = pieces.iter().flat_map(|piece| piece.coeffs()).cloned().collect();
        prop_assert_eq!(map.apply(f.coeffs())?, coeffs);
    }
}
