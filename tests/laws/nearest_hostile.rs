//! What nearest points do with input that is wrong, extreme or degenerate: values or typed errors, soon.

use nalgebra::{SVector, vector};
use std::time::Instant;
use symspline::{Curve, Error, NurbsCurve, NurbsSurface, Result, Spline, SplineSpace, Surface, Weighted};

/// What takes longer hangs, in seconds: a hundred times what it takes, for machines with other work to do.
const SOON: f64 = 60.0;

fn soon<T>(ask: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let answer = ask();
    assert!(start.elapsed().as_secs_f64() < SOON, "{:?}", start.elapsed());
    answer
}

fn wave(i: usize) -> SVector<f64, 2> {
    vector![(1.3 * i as f64).sin(), (2.1 * i as f64).cos()]
}

fn bezier(points: Vec<SVector<f64, 2>>) -> Result<Curve<f64, 2>> {
    Curve::new(SplineSpace::bezier(points.len() - 1, 0.0, 1.0)?, points)
}

#[test]
fn what_is_no_point_or_tolerance_is_refused() -> Result<()> {
    let c = bezier((0..4).map(wave).collect())?;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = Err(Error::NotFinite { what: "coordinate", index: 1 });
        assert_eq!(c.nearest(&vector![0.0, bad], 1e-9).map(|_| ()), refused);
        assert_eq!(c.projector()?.foot(&vector![0.0, bad]).map(|_| ()), refused);
        assert_eq!(c.parameters_of(&vector![0.0, bad], 1e-9).map(|_| ()), refused);
    }
    for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        assert!(matches!(c.nearest(&vector![0.0, 0.0], bad), Err(Error::BadTolerance { .. })));
        assert!(matches!(c.parameters_of(&vector![0.0, 0.0], bad), Err(Error::BadTolerance { .. })));
    }
    let far = c.parameters_of(&vector![0.0, 1e3], 1.0);
    assert!(matches!(far, Err(Error::TooFar { .. })));
    Ok(())
}

#[test]
fn all_sizes() -> Result<()> {
    for size in [1e300, 1e150, 1.0, 1e-150, 1e-300, 5e-324] {
        let c = bezier((0..4).map(|i| wave(i) * size).collect())?;
        for from in [1e300, 1e150, 1.0, 1e-150, 1e-300, 0.0] {
            let point = vector![0.3, -0.4] * from;
            let nearest = soon(|| c.nearest(&point, f64::max(1e-300, 1e-9 * size)))?;
            let distance = nearest.feet[0].distance;
            let sampled = (0..=100).map(|i| {
                let off = c.at(&(f64::from(i) / 100.0)).expect("inside") - point;
                let largest = off.amax();
                if largest > 0.0 { (off / largest).norm() * largest } else { 0.0 }
            });
            let sampled = sampled.fold(f64::INFINITY, f64::min);
            assert!(
                nearest.bound <= distance && distance <= sampled * (1.0 + 1e-9) + 1e-320,
                "{size} {from}: {distance} {sampled}"
            );
            assert!(distance - nearest.bound <= 2e-9 * (size + from) + 1e-300);
        }
    }
    let c = bezier(vec![vector![-f64::MAX, 0.0]; 2])?;
    let beyond = c.nearest(&vector![f64::MAX, 0.0], 1.0);
    assert_eq!(beyond.map(|_| ()), Err(Error::NotFinite { what: "distance", index: 0 }));
    Ok(())
}

#[test]
fn points_only() -> Result<()> {
    for p in [0, 1, 3, 12] {
        let c = bezier(vec![vector![3.0, 4.0]; p + 1])?;
        let nearest = c.nearest(&vector![0.0, 0.0], 1e-9)?;
        assert_eq!((nearest.feet.len(), nearest.along.len(), nearest.feet[0].distance), (1, 1, 5.0));
        let nearest = c.nearest(&vector![3.0, 4.0], 1e-9)?;
        assert_eq!((nearest.feet.len(), nearest.along.len(), nearest.bound), (1, 1, 0.0));
    }
    Ok(())
}

#[test]
fn high_degrees() -> Result<()> {
    for p in [20, 60, 200, 512] {
        let c = bezier((0..=p).map(|i| vector![i as f64 / p as f64, (0.9 * i as f64).sin()]).collect())?;
        let point = vector![0.4, 0.3];
        let nearest = soon(|| c.nearest(&point, 1e-6))?;
        let sampled = (0..=300).map(|i| (c.at(&(f64::from(i) / 300.0)).expect("inside") - point).norm());
        let sampled = sampled.fold(f64::INFINITY, f64::min);
        assert!(nearest.feet[0].distance <= sampled + 1e-9, "{p}");
        assert!(nearest.bound <= sampled && nearest.feet[0].distance - nearest.bound <= 1e-6, "{p}");
    }
    let space = SplineSpace::bezier(70, 0.0, 1.0)?;
    let points =
        (0..71 * 71).map(|k| vector![(k / 71) as f64, (k % 71) as f64, (0.1 * k as f64).sin()]).collect();
    let s = Surface::new(space.clone(), space, points)?;
    let point = vector![30.0, 31.0, 5.0];
    let nearest = soon(|| s.nearest(&point, 1e-6))?;
    assert!(nearest.bound <= nearest.feet[0].distance && nearest.feet[0].distance < 6.5);
    Ok(())
}

#[test]
fn cusps_and_returns() -> Result<()> {
    // (x², x³) and a line run forth and back.
    let cusp = bezier(vec![vector![1.0, -1.0], vector![-1.0, 1.0], vector![-1.0, -1.0], vector![1.0, 1.0]])?;
    for point in
        [vector![-1.0, 0.0], vector![0.0, 0.0], vector![-0.25, 0.0], vector![0.3, 0.0], vector![-1e-5, 0.0]]
    {
        let nearest = soon(|| cusp.nearest(&point, 1e-9))?;
        let sampled = (0..=2000).map(|i| (cusp.at(&(f64::from(i) / 2000.0)).expect("inside") - point).norm());
        let sampled = sampled.fold(f64::INFINITY, f64::min);
        assert!(nearest.feet[0].distance <= sampled + 1e-12 && nearest.bound <= sampled);
        assert!(nearest.feet[0].distance - nearest.bound <= 1e-9 && nearest.feet.len() <= 2, "{nearest:?}");
    }
    let back = bezier(vec![vector![0.0, 0.0], vector![2.0, 0.0], vector![0.0, 0.0]])?;
    let nearest = soon(|| back.nearest(&vector![0.5, 1.0], 1e-9))?;
    assert_eq!(nearest.feet.len(), 2, "{nearest:?}");
    // At the turn the curve stands still.
    assert_eq!(soon(|| back.nearest(&vector![3.0, 0.0], 1e-9))?.feet.len(), 1);
    Ok(())
}

/// Local minima that differ by much less than the accuracy, far more of them than can be told.
#[test]
fn ripples() -> Result<()> {
    let space = SplineSpace::uniform_periodic(3, 3000, 0.0, 1.0)?;
    let ripple = |height: f64| {
        let point = |i: usize| {
            let angle = std::f64::consts::TAU * i as f64 / 3000.0;
            let r = 1.0 + if i.is_multiple_of(2) { height } else { -height };
            vector![r * angle.cos(), r * angle.sin()]
        };
        Curve::new(space.clone(), (0..3000).map(point).collect())
    };
    for height in [1e-3, 1e-9, 1e-12, 0.0] {
        for accuracy in [1e-2, 1e-6, 1e-10, 1e-14] {
            let nearest = soon(|| ripple(height)?.nearest(&vector![0.0, 0.0], accuracy))?;
            assert!((nearest.feet[0].distance - 1.0).abs() < 2.0 * height + 1e-5);
            assert!(nearest.feet[0].distance - nearest.bound <= accuracy.max(1e-13));
        }
    }
    Ok(())
}

#[test]
fn weights_of_any_size_and_sign() -> Result<()> {
    for tiny in [1e-3, 1e-20, 1e-100, 1e-300] {
        for weights in [[1.0, tiny, 1.0, 1.0], [tiny, 1.0, 1.0, tiny], [tiny; 4], [1.0, tiny, tiny, 1.0]] {
            let space = SplineSpace::bezier(3, 0.0, 1.0)?;
            let c = NurbsCurve::new(space, (0..4).map(wave).collect(), weights.to_vec())?;
            for point in [vector![0.2, 0.1], vector![5.0, -3.0], c.at(&0.5)?] {
                let nearest = soon(|| c.nearest(&point, 1e-9))?;
                let sampled =
                    (0..=1000).map(|i| (c.at(&(f64::from(i) / 1000.0)).expect("inside") - point).norm());
                let sampled = sampled.fold(f64::INFINITY, f64::min);
                assert!(
                    nearest.feet[0].distance <= sampled + 1e-9 && nearest.bound <= sampled + 1e-13,
                    "{weights:?}"
                );
                // With lighter ones at the far end parameters are too coarse.
                let coarse = tiny < 1e-3 && weights[3] < 1e-3;
                assert!(
                    coarse || nearest.feet[0].distance - nearest.bound <= 2e-9,
                    "{weights:?} {nearest:?}"
                );
            }
        }
    }
    // A negative weight in the middle; the denominator 1 - 1.9 · 2 x (1 - x) stays positive.
    let lift = |point: SVector<f64, 2>, weight: f64| Weighted { point: point * weight, weight };
    let lifted =
        vec![lift(vector![0.0, 0.0], 1.0), lift(vector![1.0, 1.0], -0.9), lift(vector![2.0, 0.0], 1.0)];
    let c = NurbsCurve::from_lifted(Spline::new(SplineSpace::bezier(2, 0.0, 1.0)?, lifted)?)?;
    for point in [vector![1.0, 0.0], vector![1.0, -30.0], vector![-5.0, -5.0]] {
        let nearest = soon(|| c.nearest(&point, 1e-9))?;
        let sampled = (0..=1000).map(|i| (c.at(&(f64::from(i) / 1000.0)).expect("inside") - point).norm());
        let sampled = sampled.fold(f64::INFINITY, f64::min);
        assert!(nearest.feet[0].distance <= sampled + 1e-9 && nearest.bound <= sampled);
        assert!(nearest.feet[0].distance - nearest.bound <= 1e-9);
    }
    Ok(())
}

#[test]
fn spans_of_any_length() -> Result<()> {
    let tiny = f64::MIN_POSITIVE * 16.0;
    let all = [vec![0.0, tiny, 1.0], vec![1.0, 1.0_f64.next_up(), 2.0], vec![-1e300, 0.0, 1e-300, 1e300]];
    for knots in all {
        let space = SplineSpace::clamped(3, knots)?;
        let (a, b) = (*space.domain().0, *space.domain().1);
        let c = Curve::new(space.clone(), (0..space.dim()).map(wave).collect())?;
        for point in [vector![0.2, 0.1], vector![5.0, -3.0], wave(0), wave(2)] {
            let nearest = soon(|| c.nearest(&point, 1e-9))?;
            assert!(nearest.feet.iter().all(|foot| (a..=b).contains(&foot.parameter)));
            assert!(nearest.bound <= nearest.feet[0].distance);
        }
    }
    Ok(())
}

/// A ruled surface through a cone's tip, and one folded to a line.
#[test]
fn degenerate_surfaces() -> Result<()> {
    let (line, arc) = (SplineSpace::bezier(1, 0.0, 1.0)?, SplineSpace::bezier(2, 0.0, 1.0)?);
    let tip = vector![0.0, 0.0, 1.0];
    let cone = vec![tip, tip, tip, vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0], vector![0.0, 1.0, 0.0]];
    let cone = Surface::new(line.clone(), arc.clone(), cone)?;
    let nearest = soon(|| cone.nearest(&vector![0.0, 0.0, 2.0], 1e-9))?;
    assert_eq!((nearest.feet.len(), nearest.feet[0].distance), (1, 1.0));
    assert_eq!(nearest.along, [((0.0, 0.0), (0.0, 1.0))]);
    for point in [tip, vector![0.0, 0.0, -1.0], vector![1.0, 1.0, 5.0]] {
        let nearest = soon(|| cone.nearest(&point, 1e-9))?;
        assert!(nearest.feet[0].distance - nearest.bound <= 1e-9);
    }
    let folded = (0..6).map(|k| vector![(k / 3) as f64 + (k % 3) as f64, 0.0, 0.0]).collect();
    let folded = Surface::new(line, arc, folded)?;
    for point in [vector![1.5, 1.0, 0.0], vector![1.5, 0.0, 0.0], vector![9.0, 1.0, 0.0]] {
        let nearest = soon(|| folded.nearest(&point, 1e-6))?;
        let exact = if point[0] > 3.0 { point - vector![3.0, 0.0, 0.0] } else { vector![0.0, point[1], 0.0] };
        assert!((nearest.feet[0].distance - exact.norm()).abs() <= 1e-6 && nearest.bound <= exact.norm());
    }
    Ok(())
}

/// In one dimension, where all is about as near: what a proof leaves out, by rounding or to be quick, shows in the last
/// digits.
#[test]
fn nearly_constant_distances() -> Result<()> {
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (four, two) = (SplineSpace::bezier(4, 0.0, 1.0)?, SplineSpace::bezier(2, 0.0, 1.0)?);
    let origin = vector![0.0];
    for round in 0..160 {
        let height = [1e-3, 1e-9, 1e-10, 3e-11, 1e-11, 3e-12, 1e-12, 1e-13][round % 8];
        let mut points =
            |count: usize| -> Vec<_> { (0..count).map(|_| vector![1.0 + height * next()]).collect() };
        let (row, net) = (points(5), points(9));
        let spread = 6.0 * next();
        let weights = (0..9).map(|_| 10_f64.powf(-spread * next())).collect::<Vec<_>>();
        let c = Curve::new(four.clone(), row.clone())?;
        let rational = NurbsCurve::new(four.clone(), row, weights[..5].to_vec())?;
        let s = Surface::new(two.clone(), two.clone(), net.clone())?;
        let uneven = NurbsSurface::new(two.clone(), two.clone(), net, weights)?;
        let t = |i: i32| f64::from(i) / 1000.0;
        let line = |at: &dyn Fn(f64) -> f64| (0..=1000).map(|i| at(t(i))).fold(f64::INFINITY, f64::min);
        let pairs = || (0..=40).flat_map(|i| (0..=40).map(move |j| (t(25 * i), t(25 * j))));
        let square =
            |at: &dyn Fn(f64, f64) -> f64| pairs().map(|(u, v)| at(u, v)).fold(f64::INFINITY, f64::min);
        let told = [
            (c.nearest(&origin, 1.0)?.bound, c.projector()?.foot(&origin)?.distance),
            (rational.nearest(&origin, 1.0)?.bound, rational.projector()?.foot(&origin)?.distance),
            (s.nearest(&origin, 1.0)?.bound, s.projector()?.foot(&origin)?.distance),
            (uneven.nearest(&origin, 1.0)?.bound, uneven.projector()?.foot(&origin)?.distance),
        ];
        let sampled = [
            line(&|x| c.at(&x).expect("inside")[0]),
            line(&|x| rational.at(&x).expect("inside")[0]),
            square(&|u, v| s.at(&u, &v).expect("inside")[0]),
            square(&|u, v| uneven.at(&u, &v).expect("inside")[0]),
        ];
        for ((bound, distance), sampled) in told.into_iter().zip(sampled) {
            assert!(bound <= sampled, "{round}: {:e}", bound - sampled);
            assert!(distance <= sampled + 3e-11 && distance - bound <= 4e-11, "{round}: {distance} {bound}");
        }
    }
    Ok(())
}

/// A closed curve that jumps at its seam: the end is not the start.
#[test]
fn torn_seams() -> Result<()> {
    let space = SplineSpace::periodic(1, [0.0, 0.0, 1.0], 2.0)?;
    let c = Curve::new(space.clone(), (0..space.dim()).map(wave).collect())?;
    let (a, b) = (c.at(&0.0)?, c.at_left(&2.0)?);
    assert!((a - b).norm() > 0.1);
    assert_eq!(c.nearest(&a, 1e-9)?.feet[0].parameter, 0.0);
    assert_eq!(c.nearest(&b, 1e-9)?.feet[0].parameter, 2.0);
    Ok(())
}

/// A plane folded over itself, in a unit of billions: next to an edge that is a point the way to the foot is a long and
/// narrow valley.
#[test]
fn narrow_valleys() -> Result<()> {
    let (three, two) =
        (SplineSpace::bezier(3, 0.0, 1.0)?, SplineSpace::new(2, [0.0, 0.0, 0.0, 1.0, 2.0, 2.0])?);
    let mut points = vec![vector![0.0, 0.0, 0.0]; 12];
    (points[0], points[4], points[11]) =
        (vector![0.0, 0.0, 1e-6], vector![0.0, 0.0, 2e9], vector![0.0, -7e9, 0.0]);
    let s = Surface::new(three, two, points)?;
    let projector = s.projector()?;
    for (u, v) in [(0.147_226_770_855_133_28, 0.038_485_290_602_084_006), (0.1, 0.05), (0.2, 0.03)] {
        let point = s.at(&u, &v)?;
        assert!(soon(|| projector.foot(&point))?.distance <= 7e9 * 2_f64.powi(-36));
        assert!(soon(|| projector.nearest(&point, 0.5))?.feet[0].distance <= 0.5);
    }
    Ok(())
}
