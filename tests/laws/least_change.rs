//! Laws of least changes under linear conditions.

use crate::strategies::{ANY, Kind, cases, curve, function, indices, number, point, probes};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Error, Function, Functional, LeastChange, Norm, Q, Scalar, SplineSpace};

const SMALL: Kind = ANY.of_degree(0, 3);
const NORMS: [Norm; 2] = [Norm::Coefficients, Norm::L2];

/// Values, derivatives, moments and sums of those, some of which depend on others.
fn rows(space: &SplineSpace<Q>, places: &[prop::sample::Index]) -> Vec<Functional<Q>> {
    let probes = probes(space);
    let mut rows = vec![space.moment(0).expect("a moment")];
    for place in places {
        let x = place.get(&probes);
        rows.push(space.basis(x).expect("inside"));
        if place.index(3) == 0 {
            let [one, two] = [0, rows.len() - 1].map(|i| rows[i].to_dense(space.dim()));
            let sum: Vec<Q> = one.iter().zip(&two).map(|(a, b)| a.clone() + b).collect();
            rows.push(Functional::new(0, sum));
        }
    }
    rows
}

/// The inner product that a norm stands for.
fn inner(norm: Norm, f: &Function<Q>, g: &Function<Q>) -> Q {
    match norm {
        Norm::Coefficients => Q::dot(f.coeffs().iter().zip(g.coeffs())),
        Norm::L2 => f.inner(g).expect("one space"),
    }
}

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn conditions_are_met_by_a_change_across_what_they_leave_free(
        f in function(SMALL), other in vec(number(), 48), places in indices(4), values in vec(number(), 12),
    ) {
        let space = f.space();
        let rows = rows(space, &places);
        // Targets that do not clash: those of some spline.
        let model = Function::new(space.clone(), values.iter().cycle().take(space.dim()).cloned().collect())?;
        let targets: Vec<Q> = rows.iter().map(|row| row.apply(model.coeffs())).collect();
        let other = Function::new(space.clone(), other[..space.dim()].to_vec())?;
        for norm in NORMS {
            let change = LeastChange::new(space, &rows, norm)?;
            let edited = change.edited(&f, &targets)?;
            for (row, target) in rows.iter().zip(&targets) {
                prop_assert_eq!(&row.apply(edited.coeffs()), target);
            }
            let free = change.edited(&other, &vec![Q::int(0); rows.len()])?;
            prop_assert_eq!(inner(norm, &free, &edited.difference(&f)?), Q::int(0));
            prop_assert_eq!(change.edited(&edited, &targets)?, edited);
            prop_assert!(change.rank() <= rows.len().min(space.dim()));
        }
    }

    #[test]
    fn a_condition_that_follows_must_agree(f in function(SMALL), place in indices(1), by in number()) {
        let space = f.space();
        let probes = probes(space);
        let x = place.first().map_or(&probes[0], |index| index.get(&probes));
        let row = space.basis(x)?;
        let double: Vec<Q> = row.to_dense(space.dim()).iter().map(|w| w.clone() + w).collect();
        let change = LeastChange::new(space, &[row, Functional::new(0, double)], Norm::L2)?;
        prop_assert_eq!(change.rank(), 1);
        let result = change.edited(&f, &[by.clone(), by.clone() * Q::int(2)]);
        prop_assert_eq!(&result?.at(x)?, &by);
        let clash = change.edited(&f, &[by.clone(), by * Q::int(2) + Q::int(1)]).unwrap_err();
        prop_assert_eq!(clash, Error::Clash { condition: 1 });
        // In floating point too.
        let f = f.to_f64()?;
        let x = x.to_f64();
        if f.domain().0 <= &x && &x <= f.domain().1 {
            let row = f.space().basis(&x)?;
            let triple: Vec<f64> = row.to_dense(f.space().dim()).iter().map(|w| w * 3.0).collect();
            let change = LeastChange::new(f.space(), &[row, Functional::new(0, triple)], Norm::Coefficients)?;
            prop_assert_eq!(change.rank(), 1);
            prop_assert!(change.edited(&f, &[0.3, 0.9]).is_ok());
            // Up to 1e-12 of the numbers at hand.
            let off = 1e-9 * f.coeffs().iter().fold(1.0, |m: f64, c| m.max(c.abs()));
            prop_assert!(change.edited(&f, &[0.3, 0.9 + off]).is_err());
        }
    }

    #[test]
    fn points_are_dragged_where_they_should_go(c in curve::<2>(SMALL), place in any::<prop::sample::Index>(), to in point::<2>()) {
        let probes = probes(c.space());
        let x = place.get(&probes);
        let basis = c.space().basis(x)?.to_dense(c.space().dim());
        for norm in NORMS {
            let dragged = c.dragged(x, to.clone(), norm)?;
            prop_assert_eq!(&dragged.at(x)?, &to);
            if norm == Norm::Coefficients {
                for (i, weight) in basis.iter().enumerate() {
                    prop_assert!(*weight != Q::int(0) || dragged.coeffs()[i] == c.coeffs()[i]);
                }
            }
        }
    }
}

#[test]
fn rows_are_checked() {
    let space = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let new = |row| LeastChange::new(&space, &[row], Norm::L2).map(|_| ()).unwrap_err();
    assert_eq!(new(Functional::new(2, [1.0])), Error::IndexOutOfRange { index: 2, length: 2 });
    assert_eq!(new(Functional::new(0, [1.0, f64::NAN])), Error::NotFinite { what: "weight", index: 1 });
    let change = LeastChange::new(&space, &[], Norm::L2).unwrap();
    let mut coeffs = [1.0, 2.0];
    change.edit(&mut coeffs, &[]).unwrap();
    assert_eq!(coeffs, [1.0, 2.0]);
    assert_eq!(change.edit(&mut coeffs, &[1.0]), Err(Error::CoefficientCount { expected: 0, found: 1 }));
}

#[test]
fn contradictions_are_seen_at_any_size() -> symspline::Result<()> {
    let space = SplineSpace::uniform(2, 3, 0.0, 1.0)?;
    let row = space.basis(&0.4)?;
    let change = LeastChange::new(&space, &[row.clone(), row], Norm::L2)?;
    for size in [1e-300, 1e-170, 1.0, 1e170, 1e300] {
        let f = Function::new(space.clone(), [1.0, 2.0, 0.5, 3.0, 1.0].map(|c| c * size).to_vec())?;
        let edited = change.edited(&f, &[2.0 * size, 2.0 * size])?;
        assert!((edited.at(&0.4)? / size - 2.0).abs() < 1e-14, "{size}");
        assert_eq!(
            change.edited(&f, &[2.0 * size, 3.0 * size]),
            Err(Error::Clash { condition: 1 }),
            "{size}"
        );
    }
    Ok(())
}
