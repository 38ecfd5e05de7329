//! Forces along curves and over areas in floats: what samples converge to, and areas bounded by curves.

use nalgebra::{SVector, vector};
use symspline::limits::MAX_SAMPLES;
use symspline::{
    Area, Breadth, Cells, Curve, DeformError, Elastic, Error, Forces, Function, Material, Polygons,
    SplineSpace, Spread, TensorSpline, circle, segment,
};

type Plane = TensorSpline<f64, f64>;

/// A plane of floats, held at its edges.
fn plane(spans: usize) -> symspline::Result<(Plane, Elastic<f64>)> {
    let space = SplineSpace::uniform(3, spans, 0.0, 1.0)?;
    let plane = Plane::constant(space.clone(), space, 0.0)?;
    let material = Material::new(1.0, 0.01)?;
    let elastic = Elastic::of(&plane, &material, &[Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)])?;
    Ok((plane, elastic))
}

fn distance(one: &Plane, other: &Plane) -> f64 {
    one.coeffs().iter().zip(other.coeffs()).fold(0.0, |most, (x, y)| most.max((x - y).abs()))
}

#[test]
fn finer_samples_converge() -> symspline::Result<()> {
    let (plane, elastic) = plane(9)?;
    let points = [[0.1, 0.2], [0.3, 0.9], [0.7, 0.1], [0.9, 0.7]].map(SVector::from);
    let path = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points.to_vec())?;
    let force = Function::monomial(2, 0.0, 1.0)?;
    let disc = circle(&vector![0.5, 0.45], &0.3)?;
    let along = |samples| -> symspline::Result<Plane> {
        let mut pushed = plane.clone();
        Forces::new(&elastic, &plane)?.along(&path, &force, samples)?.push(&mut pushed)?;
        Ok(pushed)
    };
    let over = |cells| -> symspline::Result<Plane> {
        let mut pushed = plane.clone();
        Forces::new(&elastic, &plane)?
            .over(&disc, &Cells::Counts(cells, cells), |_| Ok(1.0))?
            .push(&mut pushed)?;
        Ok(pushed)
    };
    let (exact, size) = (along(40_000)?, distance(&along(40_000)?, &plane));
    let off = |samples| -> symspline::Result<f64> { Ok(distance(&along(samples)?, &exact) / size) };
    // The midpoint rule: errors fall with the square of the distance; hats bend at knots, so not evenly.
    assert!(off(50)? < 3e-3 && off(500)? < 3e-5 && off(5000)? < 3e-7, "{:?}", [off(50), off(500), off(5000)]);
    let (exact, size) = (over(1000)?, distance(&over(1000)?, &plane));
    let off = |cells| -> symspline::Result<f64> { Ok(distance(&over(cells)?, &exact) / size) };
    assert!(off(10)? < 0.06 && off(100)? < 0.006, "{:?}", [off(10), off(100)]);
    Ok(())
}

/// The load of control point `(i, j)` is `∫ N_i(u(t)) N_j(v(t)) f(t) dt`: compositions and products know it too.
#[test]
fn exact_loads_are_integrals_of_compositions() -> symspline::Result<()> {
    let u = SplineSpace::clamped(3, [0.0, 0.2, 0.5, 0.5, 0.6, 1.0])?;
    let v = SplineSpace::periodic(2, [0.0, 0.25, 0.7], 1.0)?;
    let plane = Plane::constant(u.clone(), v.clone(), 0.0)?;
    let material = Material::new(1.0, 0.01)?.with_hardness(1.0)?;
    let elastic = Elastic::of(&plane, &material, &[Breadth::Whole, Breadth::Whole])?;
    let points = [[0.1, 0.2], [0.3, 0.99], [0.9, 0.0], [0.9, 0.7], [0.5, 0.5]].map(SVector::from);
    let path = Curve::new(SplineSpace::clamped(3, [0.0, 0.4, 1.0])?, points.to_vec())?;
    let force = Function::new(SplineSpace::clamped(2, [0.0, 0.3, 1.0])?, vec![1.0, -2.0, 3.0, 0.5])?;
    let point_load = elastic.clone().with_spread(Spread::Point);
    let mut forces = Forces::new(&point_load, &plane)?;
    let load = forces.along_exactly(&path, &force)?.load()?;
    for (flat, load) in load.iter().enumerate() {
        let mut unit = vec![0.0; plane.coeffs().len()];
        unit[flat] = 1.0;
        let along = Plane::new(u.clone(), v.clone(), unit)?.composed(&path)?;
        let expected = (&along * &force).integral()?;
        assert!((load - expected).abs() < 1e-14, "{flat}: {load} {expected}");
    }
    let mut sampled = Forces::new(&elastic, &plane)?;
    let mut exact = Forces::new(&elastic, &plane)?;
    let sampled = sampled.along(&path, &force, 20_000)?.load()?;
    for (x, y) in exact.along_exactly(&path, &force)?.load()?.iter().zip(&sampled) {
        assert!((x - y).abs() < 1e-9);
    }
    let out = segment(&vector![0.5, 0.5], &vector![0.5, 1.5])?;
    let line = Function::monomial(1, 0.0, 1.0)?;
    assert!(matches!(exact.along_exactly(&out, &line), Err(Error::LeavesDomain { .. })));
    Ok(())
}

#[test]
fn curves_and_polygons_bound_the_same_areas() -> symspline::Result<()> {
    let (plane, elastic) = plane(8)?;
    let load =
        |area: &dyn Fn(&mut Forces<'_, f64, Plane>) -> symspline::Result<()>| -> symspline::Result<f64> {
            let mut forces = Forces::new(&elastic, &plane)?;
            area(&mut forces)?;
            Ok(forces.load()?.iter().sum())
        };
    // An octagon as a polygon, as an open curve that ends where it starts, and as a ring; on rows through corners too.
    let corner = |k: i32| {
        let (x, y) = [(2, 0), (1, 1), (0, 2), (-1, 1), (-2, 0), (-1, -1), (0, -2), (1, -1)][(k % 8) as usize];
        (0.5 + 0.125 * f64::from(x), 0.5 + 0.125 * f64::from(y))
    };
    let polygon = Polygons::new([(0..8).map(corner)])?;
    let knots = (0..=8).map(f64::from);
    let points = (0..=8).map(|k| SVector::from(<[f64; 2]>::from(corner(k)))).collect();
    let curve = Curve::new(SplineSpace::clamped(1, knots)?, points)?;
    let ring = SplineSpace::periodic(1, (0..8).map(f64::from), 8.0)?;
    // Coefficient 0 of a ring of degree 1 is the value at knot 1.
    let round = Curve::new(ring, (1..=8).map(|k| SVector::from(<[f64; 2]>::from(corner(k)))).collect())?;
    // Odd numbers of cells without a common factor: no middle is on the boundary.
    for cells in [Cells::Counts(7, 9), Cells::Counts(1, 3), Cells::Counts(101, 103)] {
        let by_polygon = load(&|forces| forces.over(&polygon, &cells, |_| Ok(1.0)).map(|_| ()))?;
        for curve in [&curve, &round] {
            let by_curve = load(&|forces| forces.over(curve, &cells, |_| Ok(1.0)).map(|_| ()))?;
            assert!((by_curve - by_polygon).abs() <= 1e-14, "{by_curve} {by_polygon}");
        }
    }
    let us: Vec<f64> = (0..200).map(|i| f64::from(i) * 0.005 + 0.0007).collect();
    for v in [0.25, 0.3, 0.375, 0.4999, 0.5, 0.625, 0.7499] {
        let wanted = polygon.inside(&us, &v)?;
        assert_eq!(round.inside(&us, &v)?, if v == 0.25 { vec![false; 200] } else { wanted.clone() });
        assert_eq!(curve.inside(&us, &v)?, if v == 0.25 { vec![false; 200] } else { wanted });
    }
    // A disc: its area times the integral of a hat, half a span's length twice over.
    let disc = circle(&vector![0.5, 0.5], &0.25)?;
    let total = load(&|forces| forces.over(&disc, &Cells::Spacing(0.002), |_| Ok(1.0)).map(|_| ()))?;
    let expected = std::f64::consts::PI / 16.0 / 64.0;
    assert!((total / expected - 1.0).abs() < 1e-3, "{total} {expected}");
    Ok(())
}

#[test]
fn impossible_areas_are_refused() -> symspline::Result<()> {
    let (plane, elastic) = plane(5)?;
    let mut forces = Forces::new(&elastic, &plane)?;
    let open = segment(&vector![0.1, 0.1], &vector![0.9, 0.2])?;
    let refused = forces.over(&open, &Cells::Counts(3, 3), |_| Ok(1.0)).map(|_| ());
    assert!(matches!(refused, Err(Error::Deform(DeformError::OpenBoundary { .. }))));
    let jump = SplineSpace::new(1, [0.0, 0.0, 1.0, 1.0, 2.0, 2.0])?;
    let points = [[0.1, 0.1], [0.5, 0.1], [0.5, 0.5], [0.1, 0.1]].map(SVector::from);
    let jumps = Curve::new(jump, points.to_vec())?;
    let refused = forces.over(&jumps, &Cells::Counts(3, 3), |_| Ok(1.0)).map(|_| ());
    assert!(
        matches!(refused, Err(Error::Deform(DeformError::OpenBoundary { parameter })) if parameter == "1")
    );
    // A thin triangle that no middle hits.
    let thin = Polygons::new([[(0.0, 0.0), (1.0, 0.999), (1.0, 1.0)]])?;
    let refused = forces.over(&thin, &Cells::Counts(2, 1), |_| Ok(1.0)).map(|_| ());
    assert!(matches!(refused, Err(Error::Deform(DeformError::NoSamples))));
    let none = Polygons::new(Vec::<Vec<(f64, f64)>>::new())?;
    assert!(forces.over(&none, &Cells::Counts(2, 1), |_| Ok(1.0)).is_err());
    let disc = circle(&vector![0.5, 0.5], &0.25)?;
    for cells in [
        Cells::Counts(usize::MAX, 2),
        Cells::Counts(0, 2),
        Cells::Spacing(1e-9),
        Cells::Spacing(1e-300),
        Cells::Spacing(0.0),
        Cells::Spacing(f64::NAN),
    ] {
        assert!(forces.over(&disc, &cells, |_| Ok(1.0)).is_err());
    }
    for force in [f64::NAN, f64::INFINITY] {
        assert!(matches!(
            forces.over(&disc, &Cells::Counts(4, 4), |_| Ok(force)),
            Err(Error::NotFinite { .. })
        ));
        assert!(matches!(forces.along_by(&open, 4, |_, _| Ok(force)), Err(Error::NotFinite { .. })));
    }
    for samples in [0, usize::MAX] {
        assert!(forces.along_by(&open, samples, |_, _| Ok(1.0)).is_err());
    }
    let far = circle(&vector![1e300, 0.5], &1e300)?;
    assert!(forces.over(&far, &Cells::Counts(4, 4), |_| Ok(1.0)).is_err());
    let tiny = circle(&vector![0.5, 0.5], &1e-300)?;
    forces.over(&tiny, &Cells::Counts(4, 4), |_| Ok(1.0)).map(|_| ()).ok();
    assert!(forces.load()?.iter().all(|load| load.is_finite()));
    Ok(())
}

/// A ring that is cut open meets itself but for rounding, and rows through its seam lose no crossing.
#[test]
fn rows_through_the_seam_of_a_closed_curve_are_filled_alike() -> symspline::Result<()> {
    let us: Vec<f64> = (0..41).map(|i| f64::from(i) * 0.025 + 0.0003).collect();
    for case in 0..400 {
        let radius = |i: usize| 0.2 + 0.2 * ((7 * case + 3 * i * i) as f64).sin().abs();
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / 7.0;
        let points =
            (0..7).map(|i| vector![0.5 + radius(i) * angle(i).cos(), 0.5 + radius(i) * angle(i).sin()]);
        let space = SplineSpace::uniform_periodic(2 + case % 3, 7, 0.0, 1.0)?;
        let ring = Curve::new(space, points.collect())?;
        let seam = ring.at(&0.0)?;
        let off_seam = |u: &f64| (u - seam[0]).abs() > 1e-3;
        for open in [ring.clamped_ends()?, ring.unclamped_ends()?] {
            for v in [0.0, 1e-17, 6e-17, -6e-17, 1.2e-16, -1.2e-16].map(|by| seam[1] + by) {
                let (whole, cut) = (ring.inside(&us, &v)?, open.inside(&us, &v)?);
                let differs = |i: &usize| off_seam(&us[*i]) && whole[*i] != cut[*i];
                assert_eq!((0..us.len()).find(differs), None, "{case} {v}");
            }
        }
    }
    Ok(())
}

/// A path along the border is on the surface, however its points are rounded.
#[test]
fn paths_along_the_border_do_not_leave() -> symspline::Result<()> {
    let (plane, elastic) = plane(4)?;
    let points = [0.3, 1.0, 0.1, 0.8, 0.2].map(|u| vector![u, 1.0]);
    let path = Curve::new(SplineSpace::clamped(3, [0.0, 0.4, 1.0])?, points.to_vec())?;
    let line = Function::monomial(1, 0.0, 1.0)?;
    let (mut sampled, mut exact) = (Forces::new(&elastic, &plane)?, Forces::new(&elastic, &plane)?);
    let sampled = sampled.along(&path, &line, 20_000)?.load()?;
    for (x, y) in exact.along_exactly(&path, &line)?.load()?.iter().zip(&sampled) {
        assert!((x - y).abs() < 1e-9);
    }
    Ok(())
}

#[test]
fn forces_are_finite_and_not_too_many() -> symspline::Result<()> {
    let rod = Function::constant(SplineSpace::uniform(1, 2, 0.0, 1.0)?, 0.0)?;
    let elastic = Elastic::of(&rod, &Material::new(1e-3, 0.0)?, &[Breadth::BetweenEnds(1)])?;
    let mut forces = Forces::new(&elastic, &rod)?;
    for wrong in [f64::NAN, f64::INFINITY] {
        let refused = [
            forces.at(&0.5, wrong).err(),
            forces.at_breaks(&[0.0, wrong, 0.0]).err(),
            forces.at_all([(0.5, wrong)]).err(),
        ];
        assert!(refused.iter().all(|error| matches!(error, Some(Error::NotFinite { .. }))), "{refused:?}");
    }
    assert!(forces.at_all(std::iter::repeat_n((0.5, 1.0), MAX_SAMPLES + 1)).is_err());
    assert_eq!(forces.load()?, [0.0; 3]);
    forces.at(&0.5, 1e308)?;
    assert!(matches!(forces.displacements(), Err(Error::NotFinite { .. })));
    let mut pushed = rod.clone();
    assert!(forces.push(&mut pushed).is_err() && pushed == rod);
    Ok(())
}
