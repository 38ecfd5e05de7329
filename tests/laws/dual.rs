//! Laws of dual functionals, of the coefficients of powers, of piecewise powers and of quasi-interpolation.

use crate::oracle::{self, Side, raised, unit};
use crate::strategies::{ANY, OPEN, RING, cases, curve, function, functions, number, probes, space, spaces};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Error, Function, PowerForm, Q, Scalar, SplineSpace};

/// The polynomial with these coefficients.
fn polynomial(coeffs: &[Q], x: &Q) -> Q {
    coeffs.iter().rev().fold(Q::int(0), |sum, c| sum * x + c)
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn dual_functionals_see_their_own_basis_function_alone(space in space(ANY.of_degree(0, 5))) {
        for i in 0..space.dim() {
            let dual = space.dual_functional(i)?;
            for j in 0..space.dim() {
                prop_assert_eq!(dual.of(&unit(&space, j))?, Q::int(i64::from(i == j)), "{} {}", i, j);
            }
        }
    }

    #[test]
    fn dual_functionals_give_the_coefficients(c in curve::<2>(ANY)) {
        for (i, point) in c.coeffs().iter().enumerate() {
            prop_assert_eq!(&c.space().dual_functional(i)?.of(&c)?, point);
        }
    }

    #[test]
    fn dual_functionals_take_derivatives_of_anything(space in space(OPEN), coeffs in vec(number(), 11)) {
        let p = space.degree();
        // The derivatives of a polynomial, and its coefficients by powers.
        let derivative = |c: Vec<Q>, _: usize| -> Vec<Q> {
            c.into_iter().enumerate().skip(1).map(|(r, c)| Q::int(r as i64) * c).collect()
        };
        for i in 0..space.dim() {
            let dual = space.dual_functional(i)?;
            let values: Vec<Q> = (0..=p)
                .map(|d| polynomial(&(0..d).fold(coeffs[..=p].to_vec(), derivative), dual.point()))
                .collect();
            let mut expected = Q::int(0);
            for (k, c) in coeffs[..=p].iter().enumerate() {
                expected += c.clone() * &space.monomial_coeffs(k)?[i];
            }
            prop_assert_eq!(dual.apply(&values)?, expected);
        }
    }

    #[test]
    fn marsdens_identity(space in space(OPEN), y in number()) {
        let f = Function::new(space.clone(), space.marsden_coeffs(&y)?)?;
        for x in probes(&space) {
            prop_assert_eq!(f.at(&x)?, raised(&(y.clone() - &x), space.degree()));
        }
    }

    #[test]
    fn powers_have_the_coefficients_it_says(space in space(OPEN)) {
        for k in 0..=space.degree() {
            let f = Function::new(space.clone(), space.monomial_coeffs(k)?)?;
            for x in probes(&space) {
                prop_assert_eq!(f.at(&x)?, raised(&x, k));
            }
        }
    }

    #[test]
    fn piecewise_powers_have_the_values_of_the_spline(f in function(ANY)) {
        let form = f.to_power_form();
        for x in probes(f.space()) {
            prop_assert_eq!(form.at(&x)?, oracle::value(&f, &x, Side::Right));
        }
    }

    #[test]
    fn a_spline_comes_back_from_its_powers(c in curve::<2>(ANY)) {
        prop_assert_eq!(c.to_power_form().to_spline(c.space(), &Q::int(0))?, c);
    }

    #[test]
    fn powers_go_into_any_space_that_holds_the_spline([f, g] in functions(ANY, ANY)) {
        let union = f.space().union(g.space())?;
        prop_assert_eq!(f.to_power_form().to_spline(&union, &Q::int(0))?, f.embedded(&union)?);
    }

    #[test]
    fn powers_are_refused_exactly_where_no_spline_is((f, target) in (function(ANY.of_degree(0, 4)), space(ANY.of_degree(0, 4)))) {
        let target = SplineSpace::new(target.degree(), {
            // The same knots moved onto the domain of f.
            let ((a, b), (c, d)) = (f.domain(), target.domain());
            let stretch = (b.clone() - a) / (d.clone() - c);
            target.knots().iter().map(|t| a.clone() + (t.clone() - c) * &stretch).collect::<Vec<_>>()
        });
        let Ok(target) = target else { return Ok(()) };
        match f.to_power_form().to_spline(&target, &Q::int(0)) {
            Ok(spline) => prop_assert!(spline.same_function(&f)?),
            Err(Error::DegreeTooLow { .. }) => prop_assert!(target.degree() < f.degree()),
            Err(Error::TooSmooth { .. }) => {
                // The projection is another function, whatever it is.
                prop_assert!(!f.quasi_interpolated(&target)?.spline.same_function(&f)?);
            }
            Err(error) => prop_assert!(false, "{error}"),
        }
    }

    #[test]
    fn the_smallest_spline_is_the_same_function_and_minimal(f in function(ANY)) {
        let small = f.to_power_form().to_smallest_spline()?;
        prop_assert!(small.same_function(&f)?);
        prop_assert!(f.space().clamped_ends()?.contains(small.space()) || small.degree() < f.degree());
        // One copy less of any knot, and it does not fit.
        let breaks = small.space().breaks();
        for i in 1..breaks.len() - 1 {
            let copies = |(j, (t, m)): (usize, &(Q, usize))| vec![t.clone(); m - usize::from(i == j)];
            let knots: Vec<Q> = breaks.iter().enumerate().flat_map(copies).collect();
            let smaller = SplineSpace::new(small.degree(), knots)?;
            let refused = f.to_power_form().to_smallest_spline()?.to_power_form().to_spline(&smaller, &Q::int(0));
            let is_too_smooth = matches!(refused, Err(Error::TooSmooth { .. }));
            prop_assert!(is_too_smooth);
        }
        let top = small.to_power_form();
        prop_assert!(small.degree() == 0 || top.pieces().iter().any(|piece| piece[small.degree()] != Q::int(0)));
    }

    #[test]
    fn the_smallest_spline_does_not_see_a_larger_space([f, g] in functions(ANY.of_degree(0, 4), ANY.of_degree(0, 4))) {
        let large = f.embedded(&f.space().union(g.space())?)?;
        prop_assert_eq!(large.to_power_form().to_smallest_spline()?, f.to_power_form().to_smallest_spline()?);
    }

    #[test]
    fn what_is_not_refused_is_within_the_tolerance(
        f in function(OPEN.of_degree(1, 4)),
        shift in 1_i64..9,
        tolerance in prop_oneof![Just(Q::frac(1, 1000)), Just(Q::int(30)), Just(Q::int(1 << 60))],
    ) {
        // One piece is lifted, so that the pieces hardly ever join.
        let form = f.to_power_form();
        let mut pieces = form.pieces().to_vec();
        pieces[0][0] += Q::int(shift);
        let lifted = PowerForm::new(form.breaks().to_vec(), pieces)?;
        match lifted.to_spline(f.space(), &tolerance) {
            Ok(spline) => {
                for x in probes(f.space()) {
                    prop_assert!((spline.at(&x)? - lifted.at(&x)?).abs() <= tolerance);
                }
            }
            Err(error) => {
                let is_too_smooth = matches!(error, Error::TooSmooth { .. });
                prop_assert!(is_too_smooth);
            }
        }
    }

    #[test]
    fn a_ring_takes_only_pieces_that_join_at_the_seam(f in function(RING.of_degree(1, 4))) {
        // With the line x added the inside is as smooth as before, but the ends no longer meet.
        let form = f.to_power_form();
        let mut pieces = form.pieces().to_vec();
        for (piece, start) in pieces.iter_mut().zip(form.breaks()) {
            piece[0] += start;
            piece[1] += Q::int(1);
        }
        let rising = PowerForm::new(form.breaks().to_vec(), pieces)?.to_spline(f.space(), &Q::int(0));
        let (seam, multiplicity) = f.space().breaks().swap_remove(0);
        let needed = f.degree() + 1;
        if multiplicity == needed {
            prop_assert_eq!(rising?.at(&seam)?, f.at(&seam)? + seam);
        } else {
            let knot = seam.to_string();
            prop_assert_eq!(rising, Err(Error::TooSmooth { knot, multiplicity, needed }));
        }
    }

    #[test]
    fn quasi_interpolation_leaves_splines_of_the_space(c in curve::<2>(ANY)) {
        let near = c.quasi_interpolated(c.space())?;
        prop_assert_eq!((near.spline, near.bound), (c, Q::int(0)));
    }

    #[test]
    fn quasi_interpolation_into_a_larger_space_is_the_embedding([f, g] in functions(ANY.of_degree(0, 4), ANY.of_degree(0, 4))) {
        let union = f.space().union(g.space())?;
        prop_assert_eq!(f.quasi_interpolated(&union)?.spline, f.embedded(&union)?);
    }

    #[test]
    fn quasi_interpolation_reproduces_polynomials(space in space(OPEN), coeffs in vec(number(), 11)) {
        let coeffs = &coeffs[..=space.degree()];
        let f = space.quasi_interpolant(|x| Ok(polynomial(coeffs, x)))?;
        for x in probes(&space) {
            prop_assert_eq!(f.at(&x)?, polynomial(coeffs, &x));
        }
    }

    #[test]
    fn quasi_interpolation_is_linear([space, other] in spaces(ANY.of_degree(0, 4), ANY.of_degree(0, 4)), (c, d) in (vec(number(), 48), vec(number(), 48))) {
        let f = Function::new(other.clone(), c[..other.dim()].to_vec())?;
        let g = Function::new(other.clone(), d[..other.dim()].to_vec())?;
        let sum = f.plus_scaled(&Q::int(3), &g)?.quasi_interpolated(&space)?.spline;
        let (f, g) = (f.quasi_interpolated(&space)?.spline, g.quasi_interpolated(&space)?.spline);
        prop_assert_eq!(f.plus_scaled(&Q::int(3), &g)?, sum);
    }

    #[test]
    fn quasi_interpolation_is_local(f in function(ANY.of_degree(0, 4)), (i, by) in (any::<prop::sample::Index>(), number())) {
        let space = f.space();
        let spans: Vec<usize> = space.spans().collect();
        let k = *i.get(&spans);
        let (a, b) = (&space.knots()[k], &space.knots()[k + 1]);
        let bumped = space.quasi_interpolant(|x| Ok(f.at(x)? + if a <= x && x < b { by.clone() } else { Q::int(0) }))?;
        let under: Vec<usize> = (k - f.degree()..=k).map(|j| space.slot(j)).collect();
        for j in (0..space.dim()).filter(|j| !under.contains(j)) {
            prop_assert_eq!(&bumped.coeffs()[j], &f.coeffs()[j]);
        }
    }
}
