//! Laws of interpolation with derivatives.

use crate::oracle::rank;
use crate::strategies::{ANY, CLAMPED, Kind, OPEN, cases, curve, function, point, probes, surface};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{Curve, Error, Function, Q, Row, Scalar, Spline, SplineSpace};

/// Degrees whose collocation matrices are quickly eliminated.
const SMALL: Kind = ANY.of_degree(0, 4);

/// `count` parameters in order, some of them several times.
fn parameters(space: &SplineSpace<Q>, count: usize, places: &[Index], copies: &[usize]) -> Vec<Q> {
    let probes = probes(&space.bisected().expect("rational spans have middles"));
    let drawn = places.iter().zip(copies).flat_map(|(place, n)| vec![place.get(&probes).clone(); *n]);
    let mut drawn: Vec<Q> = drawn.take(count).collect();
    drawn.sort();
    drawn
}

fn some() -> impl Strategy<Value = (Vec<Index>, Vec<usize>)> {
    (
        vec(any::<Index>(), 48),
        vec(prop_oneof![4 => Just(1_usize), 2 => Just(2), 1 => Just(3), 1 => Just(5)], 48),
    )
}

/// The order of the derivative that each datum is.
fn orders(parameters: &[Q]) -> Vec<usize> {
    (0..parameters.len()).map(|k| parameters[..k].iter().filter(|x| **x == parameters[k]).count()).collect()
}

fn jets<C: symspline::Coeff<Q>>(f: &Spline<Q, C>, parameters: &[Q]) -> symspline::Result<Vec<C>> {
    parameters.iter().zip(orders(parameters)).map(|(x, d)| f.derivative_at(x, d)).collect()
}

fn matrix(space: &SplineSpace<Q>, parameters: &[Q]) -> Vec<Vec<Q>> {
    let row = |(x, d)| space.basis_derivative(x, d).expect("inside the domain").to_dense(space.dim());
    parameters.iter().zip(orders(parameters)).map(row).collect()
}

proptest! {
    #![proptest_config(cases(96))]

    #[test]
    fn data_determine_a_spline_exactly_if_the_matrix_is_regular(f in function(SMALL), (places, copies) in some()) {
        let space = f.space();
        let parameters = parameters(space, space.dim(), &places, &copies);
        let result = Function::osculating(space, &parameters, &jets(&f, &parameters)?);
        if let Some(order) = orders(&parameters).into_iter().find(|d| *d > space.degree()) {
            prop_assert_eq!(result, Err(Error::DegreeTooLow { degree: space.degree(), needed: order }));
        } else if rank(matrix(space, &parameters)) == space.dim() {
            prop_assert_eq!(result?, f);
        } else {
            let early = matches!(result, Err(Error::Undetermined { .. }));
            let late = matches!(result, Err(Error::Singular { .. }));
            prop_assert!(early || late && space.is_periodic(), "{result:?}");
        }
    }

    #[test]
    fn the_data_are_met(f in function(SMALL), (places, copies) in some(), data in vec(point::<2>(), 48)) {
        let space = f.space();
        let parameters = parameters(space, space.dim(), &places, &copies);
        if let Ok(c) = Curve::osculating(space, &parameters, &data[..space.dim()]) {
            prop_assert_eq!(&jets(&c, &parameters)?, &data[..space.dim()]);
        }
    }

    #[test]
    fn jets_at_both_ends_determine_a_polynomial(c in curve::<2>(CLAMPED.few(0)), at in any::<Index>()) {
        let (p, (a, b)) = (c.degree(), c.domain());
        let at = at.index(p + 2);
        let parameters = [vec![a.clone(); at], vec![b.clone(); p + 1 - at]].concat();
        prop_assert_eq!(Curve::osculating(c.space(), &parameters, &jets(&c, &parameters)?)?, c);
    }

    #[test]
    fn a_jet_in_one_span_leaves_the_others_free(f in function(OPEN.of_degree(1, 4)), at in any::<Index>()) {
        let (space, p) = (f.space(), f.degree());
        prop_assume!(space.dim() > p + 1);
        let x = at.get(&probes(space)).clone();
        let parameters = vec![x; space.dim()];
        let result = Function::osculating(space, &parameters, &vec![Q::int(1); space.dim()]);
        prop_assert_eq!(result, Err(Error::DegreeTooLow { degree: p, needed: p + 1 }));
    }

    #[test]
    fn values_alone_are_interpolated(c in curve::<2>(SMALL), (places, _) in some()) {
        let space = c.space();
        let mut parameters = parameters(space, 48, &places, &[1; 48]);
        parameters.dedup();
        parameters.truncate(space.dim());
        let data = c.eval(&parameters)?;
        prop_assert_eq!(
            Curve::osculating(space, &parameters, &data),
            Curve::interpolating(space, &parameters, &data)
        );
    }
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn rows_ride_along(s in surface::<2>(SMALL.few(2), SMALL.of_degree(0, 2).few(1)), (places, copies) in some()) {
        let rows = s.spline_of_rows();
        let parameters = parameters(s.u(), s.u().dim(), &places, &copies);
        let Ok(data) = jets(&rows, &parameters) else { return Ok(()) };
        if let Ok(found) = Spline::<Q, Row<_>>::osculating(s.u(), &parameters, &data) {
            prop_assert_eq!(found, rows);
        }
    }
}

#[test]
fn in_floats_long_and_short_spans_keep_their_digits() -> symspline::Result<()> {
    // Cubics with two data at each break: the classical Hermite interpolant, on spans from 1e-6 to 1e6.
    let breaks: Vec<f64> = (-6..=6).map(|k| 10_f64.powi(k)).collect();
    let inner = breaks[1..breaks.len() - 1].iter().flat_map(|t| [*t; 2]);
    let space = SplineSpace::clamped(3, [breaks[0]].into_iter().chain(inner).chain([1e6]))?;
    let parameters: Vec<f64> = breaks.iter().flat_map(|t| [*t; 2]).collect();
    let data: Vec<f64> = breaks.iter().flat_map(|t| [t.ln(), 1.0 / t]).collect();
    let f = Function::osculating(&space, &parameters, &data)?;
    for t in breaks {
        let found = f.derivatives_at(&t, 1)?;
        assert!((found[0] - t.ln()).abs() < 1e-13 && (found[1] * t - 1.0).abs() < 1e-11, "{t}: {found:?}");
    }
    Ok(())
}

#[test]
fn what_does_not_fit_is_refused() -> symspline::Result<()> {
    let space = SplineSpace::bezier(2, 0.0, 1.0)?;
    let fit = |x: &[f64], d: &[f64]| Function::osculating(&space, x, d).unwrap_err();
    assert_eq!(fit(&[0.0, 0.0], &[1.0; 2]), Error::TooFewPoints { expected: 3, found: 2 });
    assert_eq!(fit(&[0.0; 4], &[1.0; 4]), Error::CoefficientCount { expected: 3, found: 4 });
    assert_eq!(fit(&[0.0; 3], &[1.0; 2]), Error::CoefficientCount { expected: 3, found: 2 });
    assert_eq!(fit(&[0.5, 0.0, 1.0], &[1.0; 3]), Error::ParametersDecrease { index: 1 });
    assert_eq!(fit(&[0.0, f64::NAN, 1.0], &[1.0; 3]), Error::ParametersDecrease { index: 1 });
    assert_eq!(fit(&[0.0, 0.0, 1.0], &[1.0, f64::NAN, 1.0]), Error::NotFinite { what: "point", index: 1 });
    assert!(matches!(fit(&[0.0, 0.5, 1.5], &[1.0; 3]), Error::OutsideDomain { .. }));
    let long = SplineSpace::clamped(2, [0.0, 1.0, 2.0, 3.0])?;
    let gap = Function::osculating(&long, &[0.0, 0.0, 0.0, 3.0, 3.0], &[1.0; 5]);
    assert!(gap.is_ok());
    let gap = Function::osculating(&long, &[0.0, 0.0, 0.5, 0.5, 3.0], &[1.0; 5]);
    assert_eq!(gap, Err(Error::Undetermined { index: 3 }));
    // Far out of range nothing is made up.
    let tiny = SplineSpace::bezier(3, 0.0, 1e-200)?;
    let result = Function::osculating(&tiny, &[0.0, 0.0, 1e-200, 1e-200], &[0.0, 1e200, 1.0, 0.0]);
    if let Ok(f) = result {
        assert!((f.at(&5e-201)? - 0.625).abs() < 1e-12);
    }
    Ok(())
}
