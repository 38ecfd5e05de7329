//! Laws of interpolation.

use crate::oracle::rank;
use crate::strategies::{ANY, CLAMPED, Kind, RING, cases, curve, function, number, point, probes};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Curve, Error, Function, Q, Scalar, SplineSpace, approximation_space, interpolation_space};

/// Degrees whose collocation matrices are quickly eliminated.
const SMALL: Kind = ANY.of_degree(0, 4);

/// `count` parameters, distinct as far as there are enough places, in order.
fn parameters(space: &SplineSpace<Q>, count: usize, drop: &[Index]) -> Vec<Q> {
    let mut places = probes(&space.bisected().expect("rational spans have middles"));
    for place in drop {
        if places.len() > count {
            places.remove(place.index(places.len()));
        }
    }
    places.truncate(count);
    let missing = count - places.len();
    places.extend(vec![places[places.len() - 1].clone(); missing]);
    places
}

fn collocation(space: &SplineSpace<Q>, parameters: &[Q]) -> Vec<Vec<Q>> {
    let row = |x: &Q| space.basis(x).expect("inside the domain").to_dense(space.dim());
    parameters.iter().map(row).collect()
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn splines_are_reproduced_from_their_greville_values(c in curve::<2>(CLAMPED.smooth(1))) {
        let parameters = c.space().greville();
        let values = c.eval(&parameters)?;
        prop_assert_eq!(Curve::interpolating(c.space(), &parameters, &values)?, c);
    }

    #[test]
    fn interpolation_succeeds_exactly_if_the_matrix_is_regular(
        f in function(SMALL),
        drop in vec(any::<Index>(), 48),
    ) {
        let parameters = parameters(f.space(), f.space().dim(), &drop);
        let result = Function::interpolating(f.space(), &parameters, &f.eval(&parameters)?);
        if rank(collocation(f.space(), &parameters)) == f.space().dim() {
            prop_assert_eq!(result?, f);
        } else {
            let refused = matches!(result, Err(Error::Undetermined { .. } | Error::Singular { .. }));
            prop_assert!(refused, "{result:?}");
            let late = matches!(result, Err(Error::Singular { .. }));
            prop_assert!(f.space().is_periodic() || !late, "an open space is judged before solving");
        }
    }

    #[test]
    fn rings_are_reproduced_wherever_they_are_determined(
        c in curve::<2>(RING.of_degree(0, 4)),
        drop in vec(any::<Index>(), 48),
    ) {
        let parameters = parameters(c.space(), c.space().dim(), &drop);
        prop_assume!(rank(collocation(c.space(), &parameters)) == c.space().dim());
        prop_assert_eq!(Curve::interpolating(c.space(), &parameters, &c.eval(&parameters)?)?, c);
    }

    #[test]
    fn an_interpolant_has_the_data(
        f in function(SMALL),
        drop in vec(any::<Index>(), 48),
        data in vec(point::<2>(), 48),
    ) {
        let space = f.space();
        let parameters = parameters(space, space.dim(), &drop);
        prop_assume!(rank(collocation(space, &parameters)) == space.dim());
        let data = &data[..space.dim()];
        let c = Curve::interpolating(space, &parameters, data)?;
        prop_assert_eq!(&c.eval(&parameters)?, data);
        prop_assert_eq!(c.largest_squared_residual(&parameters, data)?, Q::int(0));
    }

    #[test]
    fn a_gap_without_parameters_is_found(f in function(CLAMPED.of_degree(0, 4))) {
        // All parameters in the first half of the first span: the other spans are free.
        let (space, breaks) = (f.space(), f.space().breaks());
        prop_assume!(breaks.len() > 2);
        let step = (breaks[1].0.clone() - &breaks[0].0) / Q::int(2 * space.dim() as i64);
        let parameter = |i: usize| breaks[0].0.clone() + Q::int(i as i64) * &step;
        let parameters: Vec<Q> = (0..space.dim()).map(parameter).collect();
        let result = Function::interpolating(space, &parameters, &f.eval(&parameters)?);
        prop_assert_eq!(result.err(), Some(Error::Undetermined { index: space.degree() + 1 }));
    }

    #[test]
    fn the_interpolation_space_always_serves(
        start in number(),
        gaps in vec((1_i64..9, 1_i64..9), 1..8),
        degree in 0_usize..6,
        data in vec(number(), 8),
    ) {
        let mut parameters = vec![start];
        for (n, d) in gaps {
            parameters.push(parameters[parameters.len() - 1].clone() + Q::frac(n, d));
        }
        let count = parameters.len();
        let space = interpolation_space(degree, &parameters);
        if count < degree + 1 {
            prop_assert_eq!(space.err(), Some(Error::TooFewPoints { expected: degree + 1, found: count }));
            return Ok(());
        }
        let space = space?;
        prop_assert_eq!((space.degree(), space.dim()), (degree, count));
        let f = Function::interpolating(&space, &parameters, &data[..count])?;
        prop_assert_eq!(&f.eval(&parameters)?, &data[..count]);
        for controls in degree + 1..=count {
            let space = approximation_space(degree, &parameters, controls)?;
            prop_assert_eq!((space.degree(), space.dim()), (degree, controls));
            Function::least_squares(&space, &parameters, &data[..count], symspline::Ends::Free)?;
        }
    }
}
