//! Laws of values, derivatives at points, and the two directions.

use super::{BOTH, SIDE};
use crate::oracle::surface_value;
use crate::strategies::{RING, cases, field, probe_pairs, probes, surface};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::{Direction, Q, Result, Row, Scalar, Spline, SplineSpace, TensorSpline};

/// The patch that holds what is right of and above `(u, v)`, as a surface of its own.
fn patch(s: &TensorSpline<Q>, u: &Q, v: &Q) -> Result<TensorSpline<Q>> {
    let span = |space: &SplineSpace<Q>, x: &Q| {
        let k = space.locate(x)?;
        Ok::<_, symspline::Error>((space.knots()[k].clone(), space.knots()[k + 1].clone()))
    };
    let ((a, b), (c, d)) = (span(s.u(), u)?, span(s.v(), v)?);
    s.restricted(Direction::U, &a, &b)?.restricted(Direction::V, &c, &d)
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn values_are_sums_of_basis_functions(s in field(SIDE, SIDE)) {
        for (u, v) in probe_pairs(&s) {
            prop_assert_eq!(s.at(&u, &v)?, surface_value(&s, &u, &v), "at {} {}", u, v);
        }
    }

    #[test]
    fn a_grid_scattered_points_and_single_points_agree(
        s in surface::<3>(SIDE, SIDE),
        places in vec((any::<Index>(), any::<Index>()), 0..9),
    ) {
        let (all_u, all_v) = (probes(s.u()), probes(s.v()));
        let us: Vec<Q> = places.iter().map(|(i, _)| i.get(&all_u).clone()).collect();
        let vs: Vec<Q> = all_v.iter().chain(places.iter().map(|(_, j)| j.get(&all_v))).cloned().collect();
        let pairs: Vec<(Q, Q)> = us.iter().flat_map(|u| vs.iter().map(|v| (u.clone(), v.clone()))).collect();
        let singles = pairs.iter().map(|(u, v)| s.at(u, v)).collect::<Result<Vec<_>>>()?;
        prop_assert_eq!(&s.eval(&pairs)?, &singles);
        prop_assert_eq!(&s.eval_grid(&us, &vs)?, &singles);
        prop_assert!(s.eval_grid(&us, &[])?.is_empty());
        // Backwards, the hints are all wrong.
        let reversed: Vec<(Q, Q)> = pairs.iter().rev().cloned().collect();
        prop_assert!(s.eval(&reversed)?.iter().eq(singles.iter().rev()));
    }

    #[test]
    fn derivatives_at_a_point_are_those_of_its_patch(
        s in field(SIDE, SIDE),
        order in 0_usize..5,
        place in any::<Index>(),
    ) {
        let (u, v) = place.get(&probe_pairs(&s)).clone();
        let (found, patch) = (s.derivatives_at(&u, &v, order)?, patch(&s, &u, &v)?);
        prop_assert_eq!(found.len(), order + 1);
        for (k, row) in found.iter().enumerate() {
            prop_assert_eq!(row.len(), order + 1);
            for (l, one) in row.iter().enumerate() {
                prop_assert_eq!(one, &patch.partial(k, l)?.at(&u, &v)?, "order {} {}", k, l);
                prop_assert_eq!(one, &s.derivative_at(&u, &v, k, l)?, "order {} {}", k, l);
            }
        }
    }

    #[test]
    fn tangents_are_the_first_derivatives(s in surface::<2>(SIDE, SIDE)) {
        for (u, v) in probe_pairs(&s) {
            let all = s.derivatives_at(&u, &v, 1)?;
            let [value, along_u, along_v] = s.tangents_at(&u, &v)?;
            prop_assert_eq!([&value, &along_u, &along_v], [&all[0][0], &all[1][0], &all[0][1]]);
            prop_assert_eq!(value, s.at(&u, &v)?);
        }
    }

    #[test]
    fn tangents_wrap_around_tori(
        s in surface::<3>(RING.few(1).of_degree(1, 7), RING.few(2).of_degree(1, 6)),
    ) {
        for (u, v) in probe_pairs(&s) {
            let all = s.derivatives_at(&u, &v, 1)?;
            let [value, along_u, along_v] = s.tangents_at(&u, &v)?;
            prop_assert_eq!([&value, &along_u, &along_v], [&all[0][0], &all[1][0], &all[0][1]]);
        }
        // The seams are the same point unless the surface jumps there.
        let ((a, b), (c, d)) = (s.u().domain(), s.v().domain());
        if s.u().breaks()[0].1 <= s.u().degree() {
            prop_assert_eq!(s.at(a, c)?, s.at(b, c)?);
        }
        if s.v().breaks()[0].1 <= s.v().degree() {
            prop_assert_eq!(s.at(a, c)?, s.at(a, d)?);
        }
    }

    #[test]
    fn an_isocurve_runs_across_its_direction(s in surface::<2>(SIDE, SIDE), place in any::<Index>()) {
        let (u, v) = place.get(&probe_pairs(&s)).clone();
        let (across, along) = (s.isocurve(Direction::U, &u)?, s.isocurve(Direction::V, &v)?);
        prop_assert_eq!((across.space(), along.space()), (s.v(), s.u()));
        for y in probes(s.v()) {
            prop_assert_eq!(across.at(&y)?, s.at(&u, &y)?);
        }
        for x in probes(s.u()) {
            prop_assert_eq!(along.at(&x)?, s.at(&x, &v)?);
        }
    }

    #[test]
    fn transposing_exchanges_the_directions(s in field(SIDE, SIDE)) {
        let t = s.transposed();
        prop_assert_eq!((t.u(), t.v()), (s.v(), s.u()));
        prop_assert_eq!((t.space(Direction::U), t.space(Direction::V)), (s.v(), s.u()));
        for i in 0..s.u().dim() {
            for j in 0..s.v().dim() {
                prop_assert_eq!(t.coeff(j, i), s.coeff(i, j));
            }
        }
        for (u, v) in probe_pairs(&s) {
            prop_assert_eq!(t.at(&v, &u)?, s.at(&u, &v)?);
        }
        prop_assert_eq!(t.transposed(), s);
    }

    #[test]
    fn coefficients_stand_row_by_row(s in field(SIDE, SIDE)) {
        let (m, n) = (s.u().dim(), s.v().dim());
        for (i, row) in s.rows().enumerate() {
            prop_assert_eq!(row, &s.coeffs()[i * n..(i + 1) * n]);
            for (j, c) in row.iter().enumerate() {
                prop_assert_eq!(s.coeff(i, j), Some(c));
            }
        }
        prop_assert_eq!((s.rows().len(), s.coeff(m, 0), s.coeff(0, n)), (m, None, None));
        let rows = s.rows().map(<[Q]>::to_vec).collect();
        prop_assert_eq!(&TensorSpline::from_rows(s.u().clone(), s.v().clone(), rows)?, &s);
        prop_assert_eq!(&TensorSpline::from_spline_of_rows(s.spline_of_rows(), s.v().clone())?, &s);
        prop_assert_eq!(s.clone().into_coeffs(), s.coeffs());
    }

    #[test]
    fn a_surface_is_a_spline_of_rows(s in field(SIDE, SIDE)) {
        let rows = s.spline_of_rows();
        for (u, v) in probe_pairs(&s) {
            let Row(row) = rows.at(&u)?;
            prop_assert_eq!(Spline::new(s.v().clone(), row)?.at(&v)?, s.at(&u, &v)?);
        }
    }

    #[test]
    fn a_constant_surface_is_constant(s in field(SIDE, SIDE), c in crate::strategies::point::<2>()) {
        let constant = TensorSpline::constant(s.u().clone(), s.v().clone(), c.clone())?;
        for (u, v) in probe_pairs(&s) {
            let [value, along_u, along_v] = constant.tangents_at(&u, &v)?;
            prop_assert_eq!((&value, &constant.at(&u, &v)?), (&c, &c));
            prop_assert!(along_u.iter().chain(along_v.iter()).all(|x| *x == Q::int(0)));
        }
    }

    #[test]
    fn exact_and_back_is_nowhere(s in field(SIDE, SIDE), direction in select(BOTH.to_vec())) {
        // Halves of integers are exact in both fields.
        let half = |x: &Q| Ok::<_, symspline::Error>(Q::int((x.to_f64() * 2.0) as i64 % 1000) / Q::int(2));
        let coeffs = s.coeffs().iter().map(half).collect::<Result<Vec<Q>>>()?;
        let plain = |space: &SplineSpace<Q>| {
            let (p, dim) = (space.degree(), space.dim());
            match space.is_periodic() {
                true => SplineSpace::uniform_periodic(p, dim, Q::int(-1), Q::int(dim as i64 - 1)),
                false => SplineSpace::uniform(p, dim - p, Q::int(0), Q::int((dim - p) as i64)),
            }
        };
        let (u, v) = (plain(s.u())?, plain(s.v())?);
        let exact = TensorSpline::new(u, v, coeffs)?;
        let floats = exact.to_f64()?;
        prop_assert_eq!(&floats.to_exact()?, &exact);
        prop_assert_eq!(floats.space(direction), &exact.space(direction).map_scalars(|t| Ok(t.to_f64()))?);
    }
}
