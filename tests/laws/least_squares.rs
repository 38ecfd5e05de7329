//! Laws of least squares.

use crate::oracle::rank;
use crate::strategies::{ANY, CLAMPED, Kind, cases, curve, function, number, point, probes};
use nalgebra::SVector;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Coeff, Curve, Ends, Error, Function, Q, Scalar, Spline, SplineSpace};

const SMALL: Kind = ANY.of_degree(0, 4);

/// Parameters picked with repetition, in order.
fn parameters(space: &SplineSpace<Q>, picks: &[Index]) -> Vec<Q> {
    let places = probes(&space.bisected().expect("rational spans have middles"));
    let mut parameters: Vec<Q> = picks.iter().map(|pick| pick.get(&places).clone()).collect();
    parameters.sort();
    parameters
}

/// Enough picks for every space, and some more.
fn picks() -> impl Strategy<Value = Vec<Index>> {
    vec(any::<Index>(), 60)
}

/// The inner products of the residual with the basis, `Σ_k N_i(x_k) (f(x_k) - d_k)`.
fn residual<C: Coeff<Q>>(f: &Spline<Q, C>, parameters: &[Q], data: &[C]) -> symspline::Result<Vec<C>> {
    let mut sums = vec![data[0].zero_like(); f.space().dim()];
    for (x, datum) in parameters.iter().zip(data) {
        let difference = f.at(x)?.minus(datum);
        let weights = f.space().basis(x)?.to_dense(f.space().dim());
        sums.iter_mut().zip(&weights).for_each(|(sum, w)| sum.add_scaled(w, &difference));
    }
    Ok(sums)
}

fn determined(space: &SplineSpace<Q>, parameters: &[Q]) -> bool {
    let row = |x: &Q| space.basis(x).expect("inside the domain").to_dense(space.dim());
    rank(parameters.iter().map(row).collect()) == space.dim()
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn splines_of_the_space_are_reproduced(c in curve::<2>(SMALL)) {
        let parameters = probes(&c.space().bisected()?);
        let fit = Curve::least_squares(c.space(), &parameters, &c.eval(&parameters)?, Ends::Free)?;
        prop_assert_eq!(&fit, &c);
        prop_assert_eq!(fit.largest_squared_residual(&parameters, &c.eval(&parameters)?)?, Q::int(0));
    }

    #[test]
    fn splines_of_the_space_are_reproduced_with_held_ends(f in function(CLAMPED.of_degree(0, 4))) {
        let parameters = probes(&f.space().bisected()?);
        let fit = Function::least_squares(f.space(), &parameters, &f.eval(&parameters)?, Ends::Held);
        // One coefficient cannot hold two ends.
        match f.space().dim() {
            1 => prop_assert_eq!(fit, Err(Error::CoefficientCount { expected: 2, found: 1 })),
            _ => prop_assert_eq!(fit?, f),
        }
    }

    #[test]
    fn the_residual_is_orthogonal_to_the_space(
        f in function(SMALL),
        picks in picks(),
        data in vec(point::<2>(), 60),
    ) {
        let space = f.space();
        let parameters = parameters(space, &picks);
        let fit = Curve::least_squares(space, &parameters, &data, Ends::Free);
        if determined(space, &parameters) {
            let sums = residual(&fit?, &parameters, &data)?;
            prop_assert!(sums.iter().all(|sum| *sum == SVector::<Q, 2>::zeros()));
        } else {
            let refused = matches!(fit, Err(Error::Undetermined { .. } | Error::Singular { .. }));
            prop_assert!(refused, "{fit:?}");
        }
    }

    #[test]
    fn held_ends_are_held_and_the_rest_is_orthogonal(
        f in function(CLAMPED.of_degree(1, 4)),
        picks in picks(),
        data in vec(number(), 60),
    ) {
        let space = f.space();
        let (mut parameters, (a, b)) = (parameters(space, &picks), space.domain());
        let last = parameters.len() - 1;
        (parameters[0], parameters[last]) = (a.clone(), b.clone());
        prop_assume!(determined(space, &parameters));
        let fit = Function::least_squares(space, &parameters, &data, Ends::Held)?;
        prop_assert_eq!((&fit.at(a)?, &fit.at(b)?), (&data[0], &data[data.len() - 1]));
        let sums = residual(&fit, &parameters, &data)?;
        prop_assert!(sums[1..sums.len() - 1].iter().all(|sum| *sum == Q::int(0)));
    }

    #[test]
    fn no_other_spline_is_nearer(f in function(SMALL), picks in picks(), data in vec(number(), 60)) {
        let parameters = parameters(f.space(), &picks);
        prop_assume!(determined(f.space(), &parameters));
        let fit = Function::least_squares(f.space(), &parameters, &data, Ends::Free)?;
        let squares = |g: &Function<Q>| {
            let square = |(value, datum): (Q, &Q)| (value.clone() - datum) * (value - datum);
            g.eval(&parameters).map(|values| values.into_iter().zip(&data).map(square).sum::<Q>())
        };
        prop_assert!(squares(&fit)? <= squares(&f)?);
        prop_assert!(squares(&fit)? < squares(&f)? || fit == f);
    }

    #[test]
    fn interpolation_is_least_squares_without_residual(
        f in function(CLAMPED.of_degree(0, 5).smooth(1)),
        data in vec(number(), 48),
    ) {
        let (parameters, data) = (f.space().greville(), &data[..f.space().dim()]);
        let interpolant = Function::interpolating(f.space(), &parameters, data)?;
        prop_assert_eq!(Function::least_squares(f.space(), &parameters, data, Ends::Free)?, interpolant);
    }

    #[test]
    fn ends_are_held_in_clamped_spaces_only(f in function(SMALL)) {
        let parameters = probes(&f.space().bisected()?);
        let fit = Function::least_squares(f.space(), &parameters, &f.eval(&parameters)?, Ends::Held);
        prop_assert_eq!(fit.err() == Some(Error::NotClamped), !f.space().is_clamped());
    }

    #[test]
    fn the_largest_residual_is_the_largest(
        c in curve::<2>(SMALL),
        picks in picks(),
        data in vec(point::<2>(), 60),
    ) {
        let parameters = parameters(c.space(), &picks);
        let square = |(x, datum): (&Q, &SVector<Q, 2>)| {
            let difference = c.at(x).unwrap() - datum;
            difference.iter().map(|d| d.clone() * d).sum::<Q>()
        };
        let expected = parameters.iter().zip(&data).map(square).max();
        prop_assert_eq!(Some(c.largest_squared_residual(&parameters, &data)?), expected);
    }
}
