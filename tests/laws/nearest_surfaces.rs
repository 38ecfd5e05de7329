//! Laws of nearest points of surfaces, over `f64`.

use crate::nearest::{grain, place, samples};
use crate::rational_strategies::nurbs_surface;
use crate::strategies::{ANY, Kind, cases, surface};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use symspline::{Direction, Nearest, NurbsSurface, SplineSpace, Surface, TensorSpline, Weighted, circle};

/// Few patches of low degree.
const SMALL: Kind = ANY.of_degree(0, 3).few(1);

/// What holds for every surface and point; `at` gives values.
fn check(
    (u, v): (&SplineSpace<f64>, &SplineSpace<f64>),
    at: impl Fn(f64, f64) -> SVector<f64, 3>,
    point: &SVector<f64, 3>,
    nearest: &Nearest<(f64, f64), 3>,
    (accuracy, size, ratio): (f64, f64, f64),
) -> Result<(), TestCaseError> {
    let rounding = (1e-12 + ratio * (grain(u) + grain(v))) * size;
    let Nearest { feet, bound, .. } = nearest;
    prop_assert!(*bound >= 0.0 && *bound <= feet[0].distance);
    prop_assert!(feet[0].distance - bound <= accuracy + rounding, "{} {bound}", feet[0].distance);
    for foot in feet {
        prop_assert!(feet[0].distance <= foot.distance && foot.distance <= bound + 2.0 * accuracy + rounding);
        prop_assert!(((foot.point - point).norm() - foot.distance).abs() <= rounding);
        let (x, y) = foot.parameter;
        prop_assert!(u.domain().0 <= &x && &x <= u.domain().1 && v.domain().0 <= &y && &y <= v.domain().1);
        let inside = |space: &SplineSpace<f64>, x: f64| space.breaks().iter().all(|(t, _)| *t != x);
        if inside(u, x) && inside(v, y) {
            prop_assert!((at(x, y) - foot.point).norm() <= rounding);
        }
    }
    for x in samples(u, 12) {
        for y in samples(v, 12) {
            let distance = (at(x, y) - point).norm();
            prop_assert!(distance >= bound - rounding, "{distance} at {x}, {y} below {bound}");
        }
    }
    Ok(())
}

/// The least weight at samples of all patches, so that both sides of jumps are among them.
fn lightest(s: &NurbsSurface<f64, 3>) -> symspline::Result<f64> {
    let breaks = [s.u(), s.v()].map(|space| space.breaks().into_iter().map(|(t, _)| t).collect::<Vec<_>>());
    let mut least = f64::INFINITY;
    for along in breaks[0].windows(2) {
        let strip = s.lifted().restricted(Direction::U, &along[0], &along[1])?;
        for across in breaks[1].windows(2) {
            let patch = strip.restricted(Direction::V, &across[0], &across[1])?;
            for u in samples(patch.u(), 8) {
                for v in samples(patch.v(), 8) {
                    least = least.min(patch.at(&u, &v)?.weight);
                }
            }
        }
    }
    Ok(least)
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn sampling_finds_nothing_nearer(s in surface::<3>(SMALL, SMALL), point in place::<3>(), coarse in any::<bool>()) {
        let Ok(s) = s.to_f64() else { return Ok(()) };
        let size = s.coeffs().iter().map(SVector::amax).fold(1.0, f64::max) + point.amax();
        let accuracy = if coarse { 0.01 } else { 1e-8 } * size;
        let nearest = s.nearest(&point, accuracy)?;
        check((s.u(), s.v()), |u, v| s.at(&u, &v).expect("inside"), &point, &nearest, (accuracy, size, 1.0))?;
    }

    #[test]
    fn sampling_finds_nothing_nearer_on_rational_surfaces(s in nurbs_surface::<3>(SMALL.of_degree(0, 2)), point in place::<3>()) {
        let Ok(s) = s.to_f64() else { return Ok(()) };
        let (heaviest, lightest) = (s.weights().map(|w| w.abs()).fold(0.0, f64::max), lightest(&s)?);
        let points = s.lifted().coeffs().iter().map(|c| c.point.amax()).fold(0.0, f64::max);
        let size = points / lightest + 1.0 + point.amax();
        let nearest = s.nearest(&point, 1e-8 * size)?;
        let ratio = heaviest / lightest;
        check((s.u(), s.v()), |u, v| s.at(&u, &v).expect("inside"), &point, &nearest, (1e-8 * size, size, ratio))?;
    }

    #[test]
    fn points_of_the_surface_are_found(s in surface::<3>(SMALL, SMALL), at in (0.0..=1.0_f64, 0.0..=1.0_f64)) {
        let Ok(s) = s.to_f64() else { return Ok(()) };
        let inside = |space: &SplineSpace<f64>, share: f64| {
            let (a, b) = space.domain();
            (a + (b - a) * share).clamp(*a, *b)
        };
        let point = s.at(&inside(s.u(), at.0), &inside(s.v(), at.1))?;
        let size = s.coeffs().iter().map(SVector::amax).fold(1.0, f64::max);
        // Feet are found to 2^-36 of the coordinates.
        let rounding = (4e-11 + grain(s.u()) + grain(s.v())) * size;
        prop_assert!(s.projector()?.foot(&point)?.distance <= rounding);
        prop_assume!(rounding < 1e-8 * size);
        for (u, v) in s.parameters_of(&point, 1e-8 * size)? {
            let near = |u: f64, v: f64| (s.at(&u, &v).expect("inside") - point).norm() <= 1.1e-8 * size;
            // At a jump it may be the other side.
            let beside = |space: &SplineSpace<f64>, x: f64| space.breaks().iter().any(|(t, copies)| *t == x && *copies > space.degree());
            prop_assert!(near(u, v) || beside(s.u(), u) || beside(s.v(), v));
        }
    }

    #[test]
    fn spheres_have_their_distances(point in place::<3>()) {
        let sphere = sphere()?;
        let projector = sphere.projector()?;
        let from_centre = point.norm();
        let foot = projector.foot(&point)?;
        prop_assert!((foot.distance - (from_centre - 1.0).abs()).abs() <= 1e-10 * (1.0 + from_centre));
        if from_centre > 0.1 {
            prop_assert!((foot.point - point / from_centre).norm() <= 1e-4);
        }
    }
}

/// The unit sphere: half circles turned about the z axis.
fn sphere() -> symspline::Result<NurbsSurface<f64, 3>> {
    turned(&|x: f64| vector![x, 0.0])
}

/// What comes of turning a half circle about the z axis, after its distance from the axis was changed.
fn turned(change: &impl Fn(f64) -> SVector<f64, 2>) -> symspline::Result<NurbsSurface<f64, 3>> {
    let full = circle(&vector![0.0, 0.0], &1.0)?.into_lifted();
    let half = symspline::arc_by_angles(
        &vector![0.0, 0.0],
        &1.0,
        &(-std::f64::consts::FRAC_PI_2),
        &std::f64::consts::PI,
    )?
    .into_lifted();
    let row = |around: &Weighted<f64, SVector<f64, 2>>| {
        let entry = |along: &Weighted<f64, SVector<f64, 2>>| {
            let r = change(along.point[0] / along.weight)[0] * along.weight;
            let point = vector![around.point[0] * r, around.point[1] * r, around.weight * along.point[1]];
            Weighted { point, weight: around.weight * along.weight }
        };
        half.coeffs().iter().map(entry).collect::<Vec<_>>()
    };
    let rows = full.coeffs().iter().map(row).collect();
    NurbsSurface::from_lifted(TensorSpline::from_rows(full.space().clone(), half.space().clone(), rows)?)
}

fn quickly<T>(what: &str, ask: impl FnOnce() -> T) -> T {
    let start = std::time::Instant::now();
    let answer = ask();
    assert!(start.elapsed().as_secs_f64() < 60.0, "{what} took {:?}", start.elapsed());
    answer
}

#[test]
fn the_centre_of_a_sphere_is_near_all_of_it() -> symspline::Result<()> {
    let nearest = quickly("centre", || sphere()?.nearest(&vector![0.0, 0.0, 0.0], 1e-9))?;
    assert_eq!(nearest.feet.len(), 1);
    assert_eq!(nearest.along, [((0.0, 0.0), (1.0, 1.0))]);
    assert!((nearest.bound - 1.0).abs() < 2e-9);
    Ok(())
}

#[test]
fn poles_of_a_sphere() -> symspline::Result<()> {
    for height in [0.5, 2.0, 1.0, 1.0 + 1e-7] {
        let nearest = quickly("pole", || sphere()?.nearest(&vector![0.0, 0.0, height], 1e-9))?;
        assert_eq!(nearest.feet.len(), 1, "{height} {nearest:?}");
        assert!((nearest.feet[0].distance - (height - 1.0).abs()).abs() < 1e-9);
        // All around the pole.
        let [((a, low), (b, high))] = nearest.along[..] else { panic!("{height} {nearest:?}") };
        assert!(a == 0.0 && b == 1.0 && low > 0.99 && high == 1.0, "{height} {nearest:?}");
    }
    Ok(())
}

#[test]
fn the_axis_of_a_cylinder() -> symspline::Result<()> {
    let full = circle(&vector![0.0, 0.0], &2.0)?.into_lifted();
    let row = |c: &Weighted<f64, SVector<f64, 2>>| {
        let at = |z: f64| Weighted { point: vector![c.point[0], c.point[1], c.weight * z], weight: c.weight };
        vec![at(0.0), at(3.0)]
    };
    let rows = full.coeffs().iter().map(row).collect();
    let lifted = TensorSpline::from_rows(full.space().clone(), SplineSpace::bezier(1, 0.0, 1.0)?, rows)?;
    let cylinder = NurbsSurface::from_lifted(lifted)?;
    let nearest = quickly("axis", || cylinder.nearest(&vector![0.0, 0.0, 1.0], 1e-9))?;
    assert_eq!(nearest.feet.len(), 1);
    let [((a, low), (b, high))] = nearest.along[..] else { panic!("{nearest:?}") };
    assert!(a == 0.0 && b == 1.0 && low > 0.3 && high < 0.35, "{nearest:?}");
    assert!((nearest.bound - 2.0).abs() < 2e-9);
    Ok(())
}

#[test]
fn a_saddle_has_two_feet_above_its_middle() -> symspline::Result<()> {
    // z = x² - y² on [-1, 1]²: from (0, 0, h) along x at x² = h - 1/2.
    let parabola = SplineSpace::bezier(2, -1.0, 1.0)?;
    let (line, square) = ([-1.0, 0.0, 1.0], [1.0, -1.0, 1.0]);
    let points = (0..9).map(|k| vector![line[k / 3], line[k % 3], square[k / 3] - square[k % 3]]).collect();
    let saddle = Surface::new(parabola.clone(), parabola, points)?;
    let nearest = saddle.nearest(&vector![0.0, 0.0, 0.75], 1e-10)?;
    assert_eq!(nearest.feet.len(), 2, "{nearest:?}");
    assert!(
        nearest
            .feet
            .iter()
            .all(|foot| (foot.parameter.0.abs() - 0.5).abs() < 1e-6 && foot.parameter.1.abs() < 1e-6)
    );
    assert!(nearest.along.is_empty());
    // Feet at an edge and at a corner.
    let foot = saddle.projector()?.foot(&vector![3.0, 0.0, 1.0])?;
    assert_eq!(foot.parameter, (1.0, 0.0));
    let foot = saddle.projector()?.foot(&vector![3.0, 3.0, 0.0])?;
    assert_eq!(foot.parameter, (1.0, 1.0));
    Ok(())
}

#[test]
fn a_point_in_a_long_valley_is_found() {
    // Collapsed sides, and coordinates of very different sizes.
    let (u, v) = (SplineSpace::clamped(1, [0.0, 1.0, 3.0]), SplineSpace::bezier(3, 0.0, 11.0 / 7.0));
    let (zero, tiny, deep) = (vector![0.0, 0.0, 0.0], 1.0 / 1_000_003.0, vector![0.0, 0.0, -5_000_000_035.0]);
    let middle = [deep, zero, zero, vector![1_000_000_007.0, 0.0, 0.0]];
    let end = [vector![0.0, -1.0, tiny], zero, vector![tiny, 0.0, tiny], deep];
    let points = [[zero; 4], middle, end].concat();
    let s = Surface::new(u.expect("ascending"), v.expect("a domain"), points).expect("a surface");
    let point = s.at(&1.581_756_087_324, &0.0).expect("inside");
    let foot = s.projector().and_then(|projector| projector.foot(&point)).expect("a foot");
    assert!(foot.distance <= 2.0 * 5e9 / (1_u64 << 36) as f64, "{foot:?}");
}
