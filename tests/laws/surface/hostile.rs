//! What surfaces must refuse, with an error that says why, and without a panic.

use super::{BOTH, SIDE};
use crate::strategies::{cases, field, fields, space};
use nalgebra::vector;
use proptest::prelude::*;
use proptest::sample::select;
use symspline::Direction::{U, V};
use symspline::limits::{MAX_DEGREE, MAX_DIM};
use symspline::{
    Error, Functional, LinearMap, Q, Result, Row, Scalar, Spline, SplineSpace, Surface, TensorSpline,
};

/// The bilinear grid with the values 0, 1, 2, 5 at its corners.
fn grid() -> Result<TensorSpline<f64>> {
    let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])
}

/// All that is asked at one point.
fn at_a_point(s: &TensorSpline<Q>, u: &Q, v: &Q) -> Vec<Option<Error>> {
    vec![
        s.at(u, v).err(),
        s.eval(&[(u.clone(), v.clone())]).err(),
        s.eval_grid(std::slice::from_ref(u), std::slice::from_ref(v)).err(),
        s.tangents_at(u, v).err(),
        s.derivatives_at(u, v, 0).err(),
        s.derivatives_at(u, v, 2).err(),
        s.derivative_at(u, v, 1, 0).err(),
    ]
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn parameters_outside_are_refused(s in field(SIDE, SIDE)) {
        let step = Q::frac(1, 1_000_000_000_000);
        let ((a, b), (c, d)) = (s.u().domain(), s.v().domain());
        for (space, inside, direction) in [(s.u(), c, U), (s.v(), a, V)] {
            let (start, end) = space.domain();
            for x in [start.clone() - &step, end.clone() + &step] {
                let expected = space.locate(&x).err();
                prop_assert!(matches!(expected, Some(Error::OutsideDomain { .. })), "{expected:?}");
                let (u, v) = if direction == U { (&x, inside) } else { (inside, &x) };
                let all = at_a_point(&s, u, v);
                prop_assert!(all.iter().all(|error| *error == expected), "{all:?}");
                let others = [
                    s.isocurve(direction, &x).err(),
                    s.split(direction, &x).err(),
                    s.restricted(direction, start, &x).err(),
                    s.inserted(direction, std::slice::from_ref(&x)).err(),
                    s.integral_between((a, c), (u, v)).err(),
                    s.integral_between((u, v), (b, d)).err(),
                ];
                prop_assert!(others.iter().all(|error| *error == expected), "{others:?}");
            }
        }
        prop_assert!(s.at(a, c).is_ok() && s.at(b, d).is_ok());
    }

    #[test]
    fn wrong_counts_are_refused((u, v) in (space(SIDE), space(SIDE)), found in 0_usize..60) {
        let (m, n) = (u.dim(), v.dim());
        if found != m * n {
            let given = TensorSpline::new(u.clone(), v.clone(), vec![Q::int(0); found]);
            prop_assert_eq!(given.unwrap_err(), Error::CoefficientCount { expected: m * n, found });
        }
        if found != m {
            let given = TensorSpline::from_rows(u.clone(), v.clone(), vec![vec![Q::int(0); n]; found]);
            prop_assert_eq!(given.unwrap_err(), Error::CoefficientCount { expected: m, found });
        }
        if found != n {
            let rows = vec![vec![Q::int(0); found]; m];
            let given = TensorSpline::from_rows(u.clone(), v.clone(), rows.clone());
            let wrong = Error::CoefficientCount { expected: m * n, found: m * found };
            prop_assert_eq!(&given.unwrap_err(), &wrong);
            let rows = Spline::new(u.clone(), rows.into_iter().map(Row).collect())?;
            let given = TensorSpline::from_spline_of_rows(rows, v.clone());
            prop_assert_eq!(given.unwrap_err(), wrong);
        }
        if m > 1 {
            let mut rows = vec![vec![Q::int(0); n]; m];
            rows[m - 1].push(Q::int(1));
            let ragged = Error::Ragged { index: m - 1 };
            prop_assert_eq!(&TensorSpline::from_rows(u.clone(), v, rows.clone()).unwrap_err(), &ragged);
            prop_assert_eq!(Spline::new(u, rows.into_iter().map(Row).collect()).unwrap_err(), ragged);
        }
    }

    #[test]
    fn mismatched_domains_are_refused(
        [s, t] in fields([SIDE; 2], [SIDE; 2]),
        direction in select(BOTH.to_vec()),
    ) {
        let (a, b) = t.space(direction).domain();
        let longer = b.clone() + Q::int(1);
        let t = t.along(direction, |rows| rows.reparametrised(a, &longer))?;
        let expected = s.space(direction).union(t.space(direction)).err();
        prop_assert!(matches!(expected, Some(Error::DomainMismatch { .. })), "{expected:?}");
        let all = [s.sum(&t).err(), s.difference(&t).err(), s.times(&t).err(), s.same_function(&t).err()];
        prop_assert!(all.iter().all(|error| *error == expected), "{all:?}");
        prop_assert!(s.embedded(t.u(), t.v()).is_err());
    }

    #[test]
    fn operators_that_change_the_length_of_rows_are_refused(
        s in field(SIDE, SIDE),
        direction in select(BOTH.to_vec()),
    ) {
        let (m, n) = (s.space(direction).dim(), s.u().dim() * s.v().dim() / s.space(direction).dim());
        let with_one_more = |row: &Row<Q>| Row(row.iter().chain(&row[..1]).cloned().collect());
        let found = s.along(direction, |rows| {
            Spline::new(rows.space().clone(), rows.coeffs().iter().map(with_one_more).collect())
        });
        prop_assert_eq!(found.unwrap_err(), Error::CoefficientCount { expected: m * n, found: m * (n + 1) });
        let found = s.along::<Q>(direction, |rows| Spline::new(rows.space().clone(), vec![Row(vec![]); m]));
        prop_assert_eq!(found.unwrap_err(), Error::CoefficientCount { expected: m * n, found: 0 });
        let found = s.contracted(direction, |rows| Ok(with_one_more(&rows.coeffs()[0])));
        prop_assert_eq!(found.unwrap_err(), Error::CoefficientCount { expected: n, found: n + 1 });
        let found = s.contracted::<Q>(direction, |_| Ok(Row(vec![])));
        prop_assert_eq!(found.unwrap_err(), Error::CoefficientCount { expected: n, found: 0 });
    }

    #[test]
    fn rows_of_other_lengths_do_not_add(s in field(SIDE, SIDE)) {
        let rows = s.spline_of_rows();
        let longer = |row: &Row<Q>| Row(row.iter().chain(&row[..1]).cloned().collect());
        let long = Spline::new(rows.space().clone(), rows.coeffs().iter().map(longer).collect())?;
        let empty = Spline::new(rows.space().clone(), vec![Row(Vec::<Q>::new()); rows.space().dim()])?;
        for other in [&long, &empty] {
            let moved = rows.translated(&other.coeffs()[0]);
            for error in [rows.sum(other).err(), other.difference(&rows).err(), moved.err()] {
                prop_assert!(matches!(error, Some(Error::Ragged { .. })), "{error:?}");
            }
            prop_assert!(rows.same_function(other).is_err());
        }
        let (_, end) = rows.domain();
        prop_assert!(rows.join(&long.reparametrised(end, &(end.clone() + Q::int(1)))?).is_err());
    }
}

#[test]
fn maps_refuse_ragged_rows() -> Result<()> {
    let map = LinearMap::from_rows(2, [Functional::new(0, [1.0, 1.0])])?;
    for rows in [[vec![1.0], vec![]], [vec![], vec![1.0]], [vec![1.0], vec![1.0, 2.0]]] {
        assert_eq!(map.apply(&rows.map(Row)), Err(Error::Ragged { index: 1 }));
    }
    Ok(())
}

#[test]
fn numbers_that_are_none_are_refused() -> Result<()> {
    let s = grid()?;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0_f64.next_down(), 1.0_f64.next_up()] {
        for (u, v) in [(bad, 0.5), (0.5, bad), (bad, bad)] {
            let outside = |error: Option<Error>| matches!(error, Some(Error::OutsideDomain { .. }));
            assert!(outside(s.at(&u, &v).err()) && outside(s.eval(&[(0.5, 0.5), (u, v)]).err()));
            assert!(outside(s.eval_grid(&[0.5, u], &[0.5, v]).err()));
            assert!(outside(s.tangents_at(&u, &v).err()) && outside(s.derivatives_at(&u, &v, 1).err()));
            assert!(outside(s.integral_between((&0.0, &0.0), (&u, &v)).err()));
        }
        for direction in BOTH {
            assert!(s.isocurve(direction, &bad).is_err() && s.split(direction, &bad).is_err());
            assert!(s.inserted(direction, &[bad]).is_err() && s.restricted(direction, &0.0, &bad).is_err());
        }
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let expected = Error::NotFinite { what: "coefficient", index: 3 };
        let coeffs = vec![0.0, 1.0, 2.0, bad];
        assert_eq!(TensorSpline::new(s.u().clone(), s.v().clone(), coeffs).unwrap_err(), expected);
        assert!(matches!(s.scaled(&bad), Err(Error::NotFinite { .. })));
        assert!(matches!(s.translated(&bad), Err(Error::NotFinite { .. })));
        assert!(TensorSpline::constant(s.u().clone(), s.v().clone(), bad).is_err());
    }
    // Overflow is found, not handed on.
    let huge = s.scaled(&3e307)?;
    for overflow in [huge.times(&huge), huge.scaled(&9.0), huge.difference(&huge.scaled(&-1.0)?)] {
        assert!(matches!(overflow, Err(Error::NotFinite { .. })), "{overflow:?}");
    }
    Ok(())
}

/// Whether an operation was refused as too much.
fn too_much<X>(result: Result<X>) -> bool {
    matches!(result, Err(Error::TooLarge { .. } | Error::DegreeTooHigh { .. }))
}

#[test]
fn degrees_and_orders_are_limited() -> Result<()> {
    let s = grid()?;
    let plane = Surface::new(s.u().clone(), s.v().clone(), vec![vector![0.0, 0.0]; 4])?;
    let space =
        plane.along(U, |rows| Ok(rows.clone()))?.product_by(&s, |c, w| vector![c[0] * w, c[1], 0.0])?;
    for degree in [MAX_DEGREE + 1, usize::MAX / 2, usize::MAX] {
        assert!(too_much(s.derivatives_at(&0.5, &0.5, degree)));
        assert!(
            too_much(s.derivative_at(&0.5, &0.5, degree, 0))
                && too_much(s.derivative_at(&0.5, &0.5, 0, degree))
        );
        assert_eq!([s.partial(degree, 0), s.partial(0, degree)], [s.partial(2, 0), s.partial(0, 2)]);
        assert!(too_much(s.moment(degree, 0)) && too_much(s.moment(0, degree)));
        assert!(BOTH.iter().all(|&direction| too_much(s.elevated(direction, degree))));
        assert!(too_much(plane.area_moment([degree, 0])) && too_much(plane.area_moment([0, degree])));
        assert!(too_much(space.volume_moment([0, degree, 0])));
    }
    assert!(too_much(plane.area_moment([MAX_DEGREE, 1])) && too_much(space.volume_moment([MAX_DEGREE; 3])));
    let high = s.elevated(V, MAX_DEGREE - 1)?;
    assert!(too_much(high.times(&s)) && too_much(high.elevated(V, 1)) && too_much(high.antiderivative(V)));
    assert!(high.times(&s.derivative(V)?).is_ok() && high.antiderivative(U).is_ok());
    assert_eq!(plane.coordinate(2).unwrap_err(), Error::IndexOutOfRange { index: 2, length: 2 });
    Ok(())
}

#[test]
fn sizes_are_refused_before_anything_is_allocated() -> Result<()> {
    let side = SplineSpace::uniform(0, 1 << 14, 0.0, 1.0)?;
    assert_eq!(
        TensorSpline::constant(side.clone(), side.clone(), 1.0).unwrap_err(),
        Error::TooLarge { count: 1 << 28, limit: MAX_DIM }
    );
    assert!(too_much(TensorSpline::new(side.clone(), side, vec![1.0])));
    let many = SplineSpace::uniform(0, 1 << 20, 0.0, 1.0)?;
    let wall = TensorSpline::constant(many, SplineSpace::bezier(1, 0.0, 1.0)?, 1.0)?;
    let short =
        TensorSpline::constant(SplineSpace::bezier(1, 0.0, 1.0)?, SplineSpace::bezier(0, 0.0, 1.0)?, 1.0)?;
    assert!(too_much(wall.embedded(wall.u(), &SplineSpace::uniform(1, 1 << 10, 0.0, 1.0)?)));
    assert!(too_much(wall.elevated(V, MAX_DEGREE - 1)) && too_much(wall.elevated(U, 40)));
    let knots: Vec<f64> = (1..1 << 10).map(|i| f64::from(i) / 1024.0).collect();
    assert!(too_much(wall.inserted(V, &knots)) && too_much(wall.sum(&wall.transposed())));
    assert!(
        too_much(wall.times(&wall.transposed())) && too_much(wall.derivatives_at(&0.5, &0.5, usize::MAX))
    );
    // The pieces of a product may be too many where those of the factors are not.
    let high = SplineSpace::uniform(200, 40, 0.0, 1.0)?;
    let high = TensorSpline::constant(high.clone(), high, 1.0)?;
    assert!(too_much(high.times(&high)));
    // A grid of answers is as limited as one of coefficients.
    let parameters = vec![0.5; 1 << 14];
    assert!(too_much(short.eval_grid(&parameters, &parameters)));
    let row = vec![0.5; 1 << 20];
    assert!(wall.eval_grid(&[0.5], &row).is_ok_and(|values| values.len() == 1 << 20));
    assert!(wall.eval_grid(&row, &[0.5]).is_ok_and(|values| values.len() == 1 << 20));
    assert!(wall.eval_grid(&[], &parameters).is_ok_and(|values| values.is_empty()));
    Ok(())
}

#[test]
#[should_panic(expected = "the domains [0, 1] and [0, 2] differ")]
fn signs_panic_with_the_text_of_the_error() {
    let spaces = [1.0, 2.0].map(|b| SplineSpace::bezier(1, 0.0, b).expect("an interval"));
    let [s, t] = spaces.map(|u| TensorSpline::constant(u.clone(), u, 1.0).expect("a constant"));
    let _ = &s + &t;
}
