//! Laws of partial derivatives and antiderivatives.

use super::{BOTH, SIDE, SMALL, SMOOTH_SIDE, across, outer};
use crate::strategies::{
    OPEN, RING, SMOOTH, cases, field, fields, function, number, probe_pairs, surface_and_field,
};
use proptest::prelude::*;
use proptest::sample::select;
use symspline::Direction::{U, V};
use symspline::{Error, Q, Scalar};

/// Degrees small enough for products, and at least 1, where a derivative lowers the degree.
const FACTOR: crate::strategies::Kind = SMOOTH.few(2).of_degree(1, 3);

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn partial_derivatives_commute(s in field(SIDE.smooth(2), SIDE.smooth(2))) {
        let mixed = s.partial(1, 1)?;
        prop_assert_eq!(&s.derivative(U)?.derivative(V)?, &mixed);
        prop_assert_eq!(&s.derivative(V)?.derivative(U)?, &mixed);
        prop_assert_eq!(s.partial(2, 0)?, s.derivative(U)?.derivative(U)?);
        prop_assert_eq!(s.partial(0, 2)?, s.derivative(V)?.derivative(V)?);
        prop_assert_eq!(s.partial(1, 2)?, s.transposed().partial(2, 1)?.transposed());
        prop_assert_eq!(s.partial(0, 0)?, s);
    }

    #[test]
    fn derivatives_at_are_values_of_derivatives(s in field(SIDE.smooth(2), SIDE.smooth(2))) {
        for k in 0..=2 {
            for l in 0..=2 {
                let partial = s.partial(k, l)?;
                for (u, v) in probe_pairs(&s) {
                    prop_assert_eq!(&s.derivatives_at(&u, &v, 2)?[k][l], &partial.at(&u, &v)?);
                }
            }
        }
    }

    #[test]
    fn derivatives_of_products_of_functions_are_known(
        f in function(SMOOTH_SIDE),
        g in function(SMOOTH_SIDE),
    ) {
        let s = outer(&f, &g)?;
        prop_assert_eq!(s.derivative(U)?, outer(&f.derivative()?, &g)?);
        prop_assert_eq!(s.derivative(V)?, outer(&f, &g.derivative()?)?);
    }

    #[test]
    fn the_derivative_is_linear([s, t] in fields([FACTOR; 2], [FACTOR; 2]), w in number()) {
        for direction in BOTH {
            let sum = s.plus_scaled(&w, &t)?.derivative(direction)?;
            let sums = s.derivative(direction)?.plus_scaled(&w, &t.derivative(direction)?)?;
            prop_assert!(sum.same_function(&sums)?);
        }
    }

    #[test]
    fn leibniz((s, f) in surface_and_field::<2>([FACTOR; 2], [FACTOR; 2])) {
        for direction in BOTH {
            let left = (&f * &s).derivative(direction)?;
            let right = &(&f.derivative(direction)? * &s) + &(&f * &s.derivative(direction)?);
            prop_assert!(left.same_function(&right)?);
        }
    }

    #[test]
    fn the_derivative_of_an_antiderivative_is_the_surface(
        s in field(OPEN.few(2), SIDE),
        direction in select(BOTH.to_vec()),
    ) {
        let s = if direction == U { s } else { s.transposed() };
        let antiderivative = s.antiderivative(direction)?;
        prop_assert_eq!(antiderivative.space(across(direction)), s.space(across(direction)));
        prop_assert_eq!(&antiderivative.derivative(direction)?, &s);
        let start = antiderivative.isocurve(direction, s.space(direction).domain().0)?;
        prop_assert!(start.coeffs().iter().all(|c| *c == Q::int(0)));
    }

    #[test]
    fn a_ring_has_an_antiderivative_if_every_row_has(
        s in field(RING.few(2), SIDE),
        smooth in field(RING.few(2).of_degree(1, 5).smooth(1), SIDE),
        direction in select(BOTH.to_vec()),
    ) {
        let (s, smooth) = if direction == U { (s, smooth) } else { (s.transposed(), smooth.transposed()) };
        let means = s.contracted(direction, |rows| rows.integral())?;
        let closes = means.coeffs().iter().all(|mean| *mean == Q::int(0));
        match s.antiderivative(direction) {
            Err(error) => prop_assert!(!closes && matches!(error, Error::NonZeroMean { .. }), "{error:?}"),
            Ok(antiderivative) => {
                prop_assert!(closes);
                prop_assert_eq!(antiderivative.derivative(direction)?, s);
            }
        }
        // A derivative has mean zero.
        let back = smooth.derivative(direction)?.antiderivative(direction)?;
        prop_assert!(back.derivative(direction)?.same_function(&smooth.derivative(direction)?)?);
    }

    #[test]
    fn what_may_jump_has_no_derivative(s in field(SMALL, SMALL)) {
        for direction in BOTH {
            let space = s.space(direction);
            prop_assert_eq!(s.derivative(direction).err(), space.derivative_space().err());
            let refused = matches!(s.derivative(direction), Err(Error::Discontinuous { .. }));
            let breaks = space.breaks();
            let inside = if space.is_periodic() { &breaks[1..] } else { &breaks[1..breaks.len() - 1] };
            prop_assert_eq!(refused, inside.iter().any(|(_, copies)| *copies > space.degree()));
        }
    }
}
