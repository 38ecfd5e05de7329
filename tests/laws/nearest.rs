//! Laws of nearest points of curves, over `f64`: dense sampling, closed forms, and what must not change them.

use crate::rational_strategies::nurbs;
use crate::strategies::{ANY, Kind, cases, curve, indices, insertable};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use symspline::{Curve, Foot, Nearest, NurbsCurve, SplineSpace, circle, ellipse};

const ACCURACY: f64 = 1e-9;

/// A point of the size of generated coefficients.
pub fn place<const N: usize>() -> impl Strategy<Value = SVector<f64, N>> {
    let coordinate = prop_oneof![3 => (-20_i32..20).prop_map(|i| f64::from(i) / 4.0), 1 => -10.0..10.0_f64];
    prop::collection::vec(coordinate, N).prop_map(|x| SVector::from_fn(|i, _| x[i]))
}

/// The parameters of `count` places a span, knots included.
pub fn samples(space: &SplineSpace<f64>, count: usize) -> Vec<f64> {
    let breaks: Vec<f64> = space.breaks().into_iter().map(|(t, _)| t).collect();
    let inside = |ends: &[f64]| {
        let (a, b) = (ends[0], ends[1]);
        (0..count).map(move |i| a + (b - a) * i as f64 / count as f64).collect::<Vec<_>>()
    };
    breaks.windows(2).flat_map(inside).chain(breaks.last().copied()).collect()
}

/// How far a point of a curve of size 1 moves if its parameter is rounded.
pub fn grain(space: &SplineSpace<f64>) -> f64 {
    let breaks = space.breaks();
    let largest = breaks.iter().map(|(t, _)| t.abs()).fold(0.0, f64::max);
    let shortest = breaks.windows(2).map(|ends| ends[1].0 - ends[0].0).fold(f64::INFINITY, f64::min);
    16.0 * (space.degree() + 1) as f64 * f64::EPSILON * largest / shortest
}

/// Both one-sided values of a curve, polynomial or rational.
pub trait Valued<const N: usize> {
    fn both(&self, x: f64) -> [SVector<f64, N>; 2];
    fn space_of(&self) -> &SplineSpace<f64>;
}

impl<const N: usize> Valued<N> for Curve<f64, N> {
    fn both(&self, x: f64) -> [SVector<f64, N>; 2] {
        [self.at(&x).expect("inside the domain"), self.at_left(&x).expect("inside the domain")]
    }

    fn space_of(&self) -> &SplineSpace<f64> {
        self.space()
    }
}

impl<const N: usize> Valued<N> for NurbsCurve<f64, N> {
    fn both(&self, x: f64) -> [SVector<f64, N>; 2] {
        [self.at(&x).expect("inside the domain"), self.at_left(&x).expect("inside the domain")]
    }

    fn space_of(&self) -> &SplineSpace<f64> {
        self.space()
    }
}

/// What holds for every curve and point. `size` is that of all coordinates, `ratio` that of the weights.
fn check<const N: usize>(
    c: &impl Valued<N>,
    point: &SVector<f64, N>,
    nearest: &Nearest<f64, N>,
    accuracy: f64,
    (size, ratio): (f64, f64),
) -> Result<(), TestCaseError> {
    let rounding = (1e-13 + ratio * grain(c.space_of())) * size;
    let Nearest { feet, bound, .. } = nearest;
    prop_assert!(*bound >= 0.0 && *bound <= feet[0].distance);
    prop_assert!(feet[0].distance - bound <= accuracy + rounding, "{} {bound}", feet[0].distance);
    let (a, b) = c.space_of().domain();
    for foot in feet {
        prop_assert!(feet[0].distance <= foot.distance && foot.distance <= bound + 2.0 * accuracy + rounding);
        prop_assert!((a..=b).contains(&&foot.parameter));
        let off = c.both(foot.parameter).map(|value| (value - foot.point).norm());
        prop_assert!(off[0].min(off[1]) <= rounding, "{off:?}");
        prop_assert!(((foot.point - point).norm() - foot.distance).abs() <= rounding);
    }
    for x in samples(c.space_of(), 64) {
        for value in c.both(x) {
            let distance = (value - point).norm();
            prop_assert!(distance >= bound - rounding, "{distance} at {x} below {bound}");
            // What is well within the accuracy belongs to a foot or a stretch.
            if distance <= feet[0].distance + 0.5 * accuracy - rounding {
                let within = (distance + rounding, size);
                prop_assert!(belongs(c, point, x, value, nearest, within), "{x}: {nearest:?}");
            }
        }
    }
    Ok(())
}

/// Whether the distance descends from `x` to a foot, or the foot is that place.
fn belongs<const N: usize>(
    c: &impl Valued<N>,
    point: &SVector<f64, N>,
    x: f64,
    value: SVector<f64, N>,
    nearest: &Nearest<f64, N>,
    (most, size): (f64, f64),
) -> bool {
    let same = |foot: &Foot<f64, N>| (foot.point - value).norm() <= 1e-6 * size;
    let (a, b) = c.space_of().domain();
    let near = |from: f64, to: f64| {
        (0..=256).all(|i| {
            let y = (from + (to - from) * f64::from(i) / 256.0).clamp(from.min(to), from.max(to));
            c.both(y).iter().any(|value| (value - point).norm() <= most)
        })
    };
    let descends = |to: f64| {
        let (low, high) = (x.min(to), x.max(to));
        near(low, high) || (c.space_of().is_periodic() && near(*a, low) && near(high, *b))
    };
    nearest.feet.iter().any(|foot| same(foot) || descends(foot.parameter))
        || nearest.along.iter().any(|(from, to)| [x.clamp(*from, *to), *from, *to].into_iter().any(descends))
}

fn size<const N: usize>(c: &Curve<f64, N>, point: &SVector<f64, N>) -> f64 {
    c.coeffs().iter().map(SVector::amax).fold(1.0, f64::max) + point.amax()
}

/// Uneven weights and spans cost digits: a spline of moderate degree.
const LOW: Kind = ANY.of_degree(0, 5);

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn sampling_finds_nothing_nearer(c in curve::<3>(ANY), point in place::<3>(), coarse in any::<bool>()) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let size = size(&c, &point);
        let accuracy = if coarse { 0.05 } else { ACCURACY } * size;
        check(&c, &point, &c.nearest(&point, accuracy)?, accuracy, (size, 1.0))?;
    }

    #[test]
    fn sampling_finds_nothing_nearer_on_rational_curves(c in nurbs::<2>(LOW), point in place::<2>()) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let pieces = c.lifted().bezier_pieces()?;
        let coeffs = || pieces.iter().flat_map(|piece| piece.coeffs());
        let heaviest = coeffs().map(|c| c.weight.abs()).fold(0.0, f64::max);
        let weights = |x: &f64| [c.lifted().at(x), c.lifted().at_left(x)].map(|value| value.expect("inside").weight);
        let lightest = samples(c.space(), 64).iter().flat_map(weights).fold(heaviest, f64::min);
        let size = coeffs().map(|c| c.point.amax()).fold(0.0, f64::max) / lightest + 1.0 + point.amax();
        check(&c, &point, &c.nearest(&point, ACCURACY * size)?, ACCURACY * size, (size, heaviest / lightest))?;
    }

    #[test]
    fn single_feet_are_among_all(c in curve::<2>(ANY), points in prop::collection::vec(place::<2>(), 4)) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let projector = c.projector()?;
        for (point, foot) in points.iter().zip(projector.feet(&points)?) {
            let size = size(&c, point);
            prop_assert_eq!(foot, projector.foot(point)?);
            let nearest = projector.nearest(point, ACCURACY * size)?;
            prop_assert!((foot.distance - nearest.feet[0].distance).abs() <= (4e-11 + grain(c.space())) * size);
            prop_assert!(foot.distance >= nearest.bound);
        }
    }

    #[test]
    fn feet_inside_are_perpendicular(c in curve::<2>(ANY.of_degree(1, 4).smooth(1)), point in place::<2>()) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let size = size(&c, &point);
        let breaks = c.space().breaks();
        let nearest = c.nearest(&point, 1e-6 * size)?;
        for foot in nearest.feet {
            let x = foot.parameter;
            let span = breaks.windows(2).find(|ends| ends[0].0 <= x && x <= ends[1].0).expect("inside the domain");
            let share = (x - span[0].0) / (span[1].0 - span[0].0);
            if !(1e-6..1.0 - 1e-6).contains(&share) || nearest.along.iter().any(|(a, b)| *a <= x && x <= *b) {
                continue;
            }
            let tangent = c.derivative_at(&x, 1)? * (span[1].0 - span[0].0);
            prop_assert!(tangent.dot(&(foot.point - point)).abs() <= (1e-6 + 100.0 * grain(c.space())) * size * size);
        }
    }

    #[test]
    fn points_of_the_curve_are_found(c in curve::<3>(ANY), at in 0.0..=1.0_f64) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let (a, b) = c.domain();
        let x = (a + (b - a) * at).clamp(*a, *b);
        let point = c.at(&x)?;
        let size = size(&c, &point);
        let nearest = c.nearest(&point, ACCURACY * size)?;
        // Feet are found to 2^-36 of the coordinates.
        let rounding = (4e-11 + grain(c.space())) * size;
        prop_assert!(nearest.feet[0].distance <= rounding, "{nearest:?}");
        prop_assert_eq!(nearest.bound, 0.0);
        prop_assume!(rounding < 1e-9 * size);
        let found = c.parameters_of(&point, 1e-8 * size)?;
        prop_assert!(found.iter().all(|y| c.both(*y).iter().any(|q| (q - point).norm() <= 1.01e-8 * size)));
        let closest = found.iter().any(|y| (y - x).abs() <= 1e-3 * (b - a));
        let flat = nearest.along.iter().any(|(low, high)| *low <= x && x <= *high);
        prop_assert!(closest || flat || c.space().is_periodic() || c.nearest(&point, 1e-8 * size)?.along.iter().any(|(low, high)| *low <= x && x <= *high), "{x} {found:?}");
    }

    #[test]
    fn reversal_and_finer_spaces_change_nothing(
        c in curve::<2>(ANY.of_degree(0, 6)), point in place::<2>(), places in indices(3), raise in 0_usize..2,
    ) {
        let finer = c.elevated(raise)?.inserted(&insertable(c.space(), &places))?;
        let reversed = c.reversed()?;
        let [Ok(c), Ok(finer), Ok(reversed)] = [c, finer, reversed].map(|c| c.to_f64()) else { return Ok(()) };
        let size = size(&c, &point);
        let distance = |c: &Curve<f64, 2>| c.nearest(&point, ACCURACY * size).map(|n| (n.bound, n.feet[0].distance));
        let (bound, least) = distance(&c)?;
        let rounding = (1e-12 + grain(c.space()).max(grain(finer.space())).max(grain(reversed.space()))) * size;
        for other in [finer, reversed] {
            let (other_bound, other_least) = distance(&other)?;
            prop_assert!(other_bound <= least + rounding && bound <= other_least + rounding);
        }
    }

    #[test]
    fn motions_and_powers_of_two_change_nothing(c in curve::<2>(ANY.of_degree(0, 6)), point in place::<2>(), e in -900_i32..900) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let size = size(&c, &point);
        let near = c.nearest(&point, ACCURACY * size)?;
        let turn = |p: &SVector<f64, 2>| vector![1.0 - p[1], 2.0 + p[0]];
        let turned = Curve::new(c.space().clone(), c.coeffs().iter().map(turn).collect())?;
        let moved = turned.nearest(&turn(&point), ACCURACY * size)?;
        prop_assert!((moved.feet[0].distance - near.feet[0].distance).abs() <= 2.0 * ACCURACY * size);
        prop_assume!(c.coeffs().iter().any(|p| p.amax() > 0.0));
        let factor = 2.0_f64.powi(e);
        let scaled = Curve::new(c.space().clone(), c.coeffs().iter().map(|p| p * factor).collect())?;
        let scaled = scaled.nearest(&(point * factor), ACCURACY * size * factor)?;
        // Scales are powers of two: nothing is rounded.
        prop_assert_eq!(scaled.bound, near.bound * factor);
        prop_assert_eq!(&scaled.along, &near.along);
        prop_assert!((scaled.feet[0].distance - near.feet[0].distance * factor).abs() <= 1e-15 * factor * size);
        prop_assert_eq!(scaled.feet.len(), near.feet.len());
    }

    #[test]
    fn a_polynomial_is_a_rational_one(c in curve::<2>(LOW), point in place::<2>(), weight in 0.1..10.0_f64) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let size = size(&c, &point);
        let lifted = NurbsCurve::new(c.space().clone(), c.coeffs().to_vec(), vec![weight; c.coeffs().len()])?;
        let (one, other) = (c.nearest(&point, ACCURACY * size)?, lifted.nearest(&point, ACCURACY * size)?);
        prop_assert!((one.feet[0].distance - other.feet[0].distance).abs() <= 2.0 * ACCURACY * size);
        prop_assert!(other.bound <= one.feet[0].distance && one.bound <= other.feet[0].distance);
    }

    #[test]
    fn circles_have_their_distances(centre in place::<2>(), radius in 0.1..5.0_f64, point in place::<2>()) {
        let c = circle(&centre, &radius)?;
        let from_centre = (point - centre).norm();
        let nearest = c.nearest(&point, ACCURACY)?;
        prop_assert!((nearest.feet[0].distance - (from_centre - radius).abs()).abs() <= 1e-13 * 20.0);
        if from_centre > 1e-3 {
            let foot = centre + (point - centre) * (radius / from_centre);
            prop_assert!((nearest.feet[0].point - foot).norm() <= 1e-8);
        }
    }
}

#[test]
fn two_feet_on_the_axis_of_a_parabola() -> symspline::Result<()> {
    // Of y = x² at height h: x² = h - 1/2.
    for spans in [1, 2, 7] {
        for height in [0.6, 1.0, 2.0, 3.0] {
            let space = SplineSpace::uniform(2, spans, -2.0, 2.0)?;
            let line = symspline::Function::monomial(1, -2.0, 2.0)?.elevated(1)?.embedded(&space)?;
            let square = symspline::Function::monomial(2, -2.0, 2.0)?.embedded(&space)?;
            let points = line.coeffs().iter().zip(square.coeffs()).map(|(x, y)| vector![*x, *y]).collect();
            let nearest = Curve::new(space, points)?.nearest(&vector![0.0, height], 1e-10)?;
            let mut found: Vec<f64> = nearest.feet.iter().map(|foot| foot.parameter).collect();
            found.sort_by(f64::total_cmp);
            let x = (height - 0.5_f64).sqrt();
            assert_eq!(found.len(), 2, "{nearest:?}");
            assert!((found[0] + x).abs() < 1e-9 && (found[1] - x).abs() < 1e-9, "{found:?}");
            assert!(nearest.along.is_empty());
        }
    }
    Ok(())
}

#[test]
fn the_centre_of_curvature_has_one_foot() -> symspline::Result<()> {
    // From (0, 1/2) the distance from y = x² grows with the fourth power.
    for (a, b) in [(-1.0, 1.0), (-1.0, 1.7)] {
        let points = vec![vector![a, a * a], vector![0.5 * (a + b), a * b], vector![b, b * b]];
        let parabola = Curve::new(SplineSpace::bezier(2, a, b)?, points)?;
        let nearest = parabola.nearest(&vector![0.0, 0.5], 1e-10)?;
        assert_eq!(nearest.feet.len(), 1, "{nearest:?}");
        assert!(nearest.feet[0].parameter.abs() < 0.02 && (nearest.feet[0].distance - 0.5).abs() <= 1e-10);
        assert!(nearest.along.iter().all(|(from, to)| from.abs() < 0.02 && to.abs() < 0.02));
        assert!(nearest.bound >= 0.5 - 2e-10);
    }
    Ok(())
}

#[test]
fn the_centre_of_a_circle_is_near_all_of_it() -> symspline::Result<()> {
    let nearest = circle(&vector![3.0, 4.0], &5.0)?.nearest(&vector![3.0, 4.0], 1e-9)?;
    assert_eq!((nearest.feet.len(), nearest.along), (1, vec![(0.0, 1.0)]));
    assert!((nearest.bound - 5.0).abs() < 2e-9 && (nearest.feet[0].distance - 5.0).abs() < 1e-13);
    Ok(())
}

#[test]
fn the_centre_of_an_ellipse_has_two_feet() -> symspline::Result<()> {
    for thin in [0.5, 0.9, 0.999, 1.0 - 1e-6] {
        let e = ellipse(&vector![0.0, 0.0], &vector![1.0, 0.0], &vector![0.0, thin])?;
        let nearest = e.nearest(&vector![0.0, 0.0], 1e-11)?;
        assert_eq!(nearest.feet.len(), 2, "{thin} {nearest:?}");
        assert!(
            nearest
                .feet
                .iter()
                .all(|foot| (foot.point[1].abs() - thin).abs() < 1e-11 && foot.point[0].abs() < 1e-2)
        );
    }
    Ok(())
}

/// A closed curve: the foot at the seam counts once if the space is periodic, else at both ends.
#[test]
fn seams() -> symspline::Result<()> {
    let ring = SplineSpace::uniform_periodic(3, 8, 0.0, 1.0)?;
    let on_circle = |i: usize| {
        let angle = std::f64::consts::TAU * (i as f64 - 2.0 + 1.0) / 8.0;
        vector![angle.cos(), angle.sin()]
    };
    let c = Curve::new(ring, (0..8).map(on_circle).collect())?;
    let start = c.at(&0.0)?;
    let nearest = c.nearest(&(start * 3.0), 1e-9)?;
    assert_eq!(nearest.feet.len(), 1);
    let x = nearest.feet[0].parameter;
    assert!(x.min(1.0 - x) < 1e-6);
    assert_eq!(c.parameters_of(&start, 1e-9)?.len(), 1);

    let nearest = circle(&vector![0.0, 0.0], &1.0)?.nearest(&vector![4.0, 0.0], 1e-9)?;
    let mut ends: Vec<f64> = nearest.feet.iter().map(|foot| foot.parameter).collect();
    ends.sort_by(f64::total_cmp);
    assert_eq!(ends, [0.0, 1.0]);
    Ok(())
}

#[test]
fn corners_and_jumps() -> symspline::Result<()> {
    let corner = Curve::new(
        SplineSpace::clamped(1, [0.0, 1.0, 2.0])?,
        vec![vector![-1.0, -1.0], vector![0.0, 0.0], vector![1.0, -1.0]],
    )?;
    let nearest = corner.nearest(&vector![0.0, 2.0], 1e-9)?;
    assert_eq!((nearest.feet.len(), nearest.feet[0].parameter, nearest.feet[0].distance), (1, 1.0, 2.0));
    // Below, the two sides are equally near.
    assert_eq!(corner.nearest(&vector![0.0, -1.0], 1e-9)?.feet.len(), 2);

    let torn = SplineSpace::clamped(1, [0.0, 1.0, 1.0, 2.0])?;
    let points = vec![vector![-3.0, 0.0], vector![-1.0, 0.0], vector![1.0, 0.0], vector![3.0, 0.0]];
    let nearest = Curve::new(torn, points)?.nearest(&vector![0.0, 0.0], 1e-9)?;
    assert_eq!(nearest.feet.iter().map(|foot| foot.parameter).collect::<Vec<_>>(), [1.0, 1.0]);
    assert_eq!(nearest.feet.iter().map(|foot| foot.point[0]).sum::<f64>(), 0.0);

    let steps =
        Curve::new(SplineSpace::clamped(0, [0.0, 1.0, 3.0])?, vec![vector![1.0, 0.0], vector![-1.0, 0.0]])?;
    let nearest = steps.nearest(&vector![0.0, 0.0], 1e-9)?;
    assert_eq!((nearest.feet.len(), nearest.along), (2, vec![(0.0, 1.0), (1.0, 3.0)]));
    assert_eq!(steps.nearest(&vector![-3.0, 0.0], 1e-9)?.along, [(1.0, 3.0)]);
    Ok(())
}

/// A point on the small part of a curve with a part a billion times larger.
#[test]
fn a_small_part_of_a_large_curve() -> symspline::Result<()> {
    let (s, t) = (39.0 / 14.0, 53.0 / 14.0);
    let space = SplineSpace::new(2, [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, s, s, t, t, t])?;
    let mut points = vec![vector![0.0, 0.0, 0.0]; 10];
    (points[5], points[7], points[9]) =
        (vector![3.0, 1e-6, 0.0], vector![9.0, 0.0, 0.0], vector![0.0, 0.0, -9_000_000_063.0]);
    let c = Curve::new(space, points)?;
    let point = c.at(&(t * 0.627_623_571_547_552_2))?;
    let nearest = c.nearest(&point, 9.0)?;
    assert!(nearest.feet[0].distance <= 4e-11 * 9e9 && nearest.bound == 0.0, "{nearest:?}");
    Ok(())
}

#[test]
fn crossings_are_passed_twice() -> symspline::Result<()> {
    let loop_points = vec![vector![-1.0, 0.0], vector![3.0, 3.0], vector![-3.0, 3.0], vector![1.0, 0.0]];
    let c = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, loop_points)?;
    // By symmetry it crosses itself where x = 0: (2 t - 1) (1 - 10 t + 10 t²) = 0.
    let t = 0.5 - (0.25 - 0.1_f64).sqrt();
    let crossing = c.at(&t)?;
    assert!(crossing[0].abs() < 1e-14);
    let mut found = c.parameters_of(&crossing, 1e-9)?;
    found.sort_by(f64::total_cmp);
    assert_eq!(found.len(), 2);
    assert!((found[0] - t).abs() < 1e-9 && (found[1] - (1.0 - t)).abs() < 1e-9);
    Ok(())
}
