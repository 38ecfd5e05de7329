//! Laws of arc length, over `f64`: every total is off by its bound at most, and bounds are as small as asked for.

use crate::rational_strategies::nurbs;
use crate::strategies::{ANY, Kind, OPEN, cases, curve, functions};
use nalgebra::{SVector, vector};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};
use symspline::{
    ArcLength, Coeff, Curve, Error, Function, NurbsCurve, Q, Result, SplineSpace, arc_by_angles, circle,
    ellipse,
};

const EPS: f64 = f64::EPSILON;
const KIND: Kind = ANY.of_degree(0, 6);

/// The length of the control polygon, in proportion to which data are rounded.
fn polygon<const N: usize>(points: &[SVector<f64, N>]) -> f64 {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(c, d)| (d - c).norm()).sum()
}

/// What may be off when coordinates are rounded, and when knots are, which a short span far from zero feels.
fn noise<const N: usize>(points: &[SVector<f64, N>], space: &SplineSpace<f64>) -> f64 {
    let far = points.iter().map(|c| c.norm()).fold(0.0, f64::max);
    let knots = space.knots();
    let widths = knots.windows(2).map(|ends| ends[1] - ends[0]).filter(|width| *width > 0.0);
    let blur = knots.iter().map(|t| t.abs()).fold(0.0, f64::max) / widths.fold(f64::INFINITY, f64::min);
    1e2 * EPS * (1.0 + space.degree() as f64) * (20.0 + blur) * (polygon(points) + points.len() as f64 * far)
}

fn agree<const N: usize>(one: &ArcLength<N>, two: &ArcLength<N>, noise: f64) -> bool {
    (one.total() - two.total()).abs() <= one.bound() + two.bound() + noise
}

/// A length with what is certified of it.
fn contains<const N: usize>(length: &ArcLength<N>, exact: f64) -> bool {
    (length.total() - exact).abs() <= length.bound() + 2.0 * EPS * exact
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn the_length_is_between_chords_and_polygon(c in curve::<3>(KIND)) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let length = c.arc_length(&1e-10)?;
        let (mut chords, mut polygons) = (0.0, 0.0);
        for piece in c.bezier_pieces()? {
            let (a, b) = piece.domain();
            let at = |i: usize| piece.at(&(a + (b - a) * (i as f64 / 256.0)).min(*b));
            let points = (0..=256).map(at).collect::<Result<Vec<_>>>()?;
            chords += points.windows(2).map(|ends| (ends[1] - ends[0]).norm()).sum::<f64>();
            let whole = piece.coeffs().windows(2).map(|ends| (ends[1] - ends[0]).norm());
            polygons += whole.sum::<f64>();
        }
        let noise = length.bound() + noise(c.coeffs(), c.space());
        prop_assert!(chords <= length.total() + noise, "{chords} {}", length.total());
        prop_assert!(length.total() <= polygons + noise, "{polygons} {}", length.total());
        // Chords are near, so that the length cannot be far below the polygon where it should be near it.
        prop_assert!(length.total() <= 1.02 * chords + noise, "{chords} {}", length.total());
    }

    /// Curves whose hodograph is the square of a complex spline `u + i v` have the speed `u² + v²`.
    #[test]
    fn pythagorean_hodographs_have_exact_lengths(
        [u, v] in functions(OPEN.of_degree(0, 3), OPEN.of_degree(0, 3)),
        accuracy in 3..13_i32,
    ) {
        let (x, y) = (&(&u * &u) - &(&v * &v), &u * &v);
        let speed = &(&u * &u) + &(&v * &v);
        let (x, y) = (x.antiderivative()?, y.scaled(&Q::from(2))?.antiderivative()?);
        let space = x.space().union(y.space())?;
        let (x, y) = (x.embedded(&space)?, y.embedded(&space)?);
        let points = x.coeffs().iter().zip(y.coeffs()).map(|(x, y)| vector![x.clone(), y.clone()]).collect();
        let Ok(c) = Curve::new(space, points)?.to_f64() else { return Ok(()) };
        let (accuracy, exact) = (10_f64.powi(-accuracy), speed.integral()?.to_f64());
        let length = c.arc_length(&accuracy)?;
        let noise = noise(c.coeffs(), c.space());
        prop_assert!((length.total() - exact).abs() <= length.bound() + noise, "{} {exact}", length.total());
        prop_assert!(length.bound() <= accuracy * exact + noise, "{:e} {exact:e}", length.bound());
        let [low, mid, high] = [0.0, 0.37, 1.0].map(|t| c.domain().0 * (1.0 - t) + c.domain().1 * t);
        for x in [low, mid, high] {
            let up_to = speed.integral_between(speed.domain().0, &Q::try_from(x)?);
            let Ok(up_to) = up_to else { continue };
            prop_assert!((length.at(&x)? - up_to.to_f64()).abs() <= length.bound() + noise);
        }
    }

    #[test]
    fn bounds_are_as_small_as_asked_for_and_overlap(c in curve::<2>(KIND), rational in nurbs::<2>(KIND.of_degree(0, 3))) {
        let lengths = |accuracy: i32| -> Result<_> {
            let accuracy = 10_f64.powi(-accuracy);
            Ok((c.to_f64()?.arc_length(&accuracy)?, rational.to_f64()?.arc_length(&accuracy)?))
        };
        let Ok(fine) = lengths(12) else { return Ok(()) };
        for accuracy in [1, 4, 8] {
            let coarse = lengths(accuracy)?;
            prop_assert!(agree(&coarse.0, &fine.0, 0.0) && agree(&coarse.1, &fine.1, 0.0));
            let bound = |fine: &ArcLength<2>| 10_f64.powi(-accuracy) * fine.total();
            prop_assert!(coarse.0.bound() <= bound(&fine.0) + fine.0.bound());
            prop_assert!(coarse.1.bound() <= bound(&fine.1) + fine.1.bound());
        }
        prop_assert!(fine.0.bound() <= 1e-12 * fine.0.total() + noise(c.to_f64()?.coeffs(), c.to_f64()?.space()));
    }

    #[test]
    fn operators_that_keep_the_curve_keep_its_length(c in curve::<3>(KIND)) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let (length, noise) = (c.arc_length(&1e-11)?, noise(c.coeffs(), c.space()));
        let (a, b) = c.domain();
        let middle = a + (b - a) * 0.4;
        let same = [c.reversed()?, c.elevated(2)?, c.reparametrised(&(4.0 * a), &(4.0 * b))?, c.inserted(&[middle]).unwrap_or(c.clone())];
        for other in same {
            prop_assert!(agree(&length, &other.arc_length(&1e-11)?, noise));
        }
        let lifted = NurbsCurve::from_polynomial(&c)?.arc_length(&1e-11)?;
        prop_assert!(agree(&length, &lifted, noise), "{} {}", length.total(), lifted.total());
        let (left, right) = c.split(&middle)?;
        let parts = (left.arc_length(&1e-11)?, right.arc_length(&1e-11)?);
        let sum = parts.0.total() + parts.1.total();
        let bound = length.bound() + parts.0.bound() + parts.1.bound() + noise;
        prop_assert!((sum - length.total()).abs() <= bound);
        prop_assert!((length.at(&middle)? - parts.0.total()).abs() <= bound);
    }

    #[test]
    fn motions_keep_lengths_and_scalings_scale_them(c in curve::<2>(KIND), exponent in -900..900_i32) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let (length, noise) = (c.arc_length(&1e-11)?, noise(c.coeffs(), c.space()));
        let turn = |c: &SVector<f64, 2>| vector![0.6 * c[0] - 0.8 * c[1] + 0.25, 0.8 * c[0] + 0.6 * c[1] - 7.0];
        let moved = Curve::new(c.space().clone(), c.coeffs().iter().map(turn).collect())?;
        prop_assert!(agree(&length, &moved.arc_length(&1e-11)?, noise + 1e3 * EPS));
        // By a power of two nothing is rounded.
        let scale = f64::from(exponent).exp2();
        let scaled = c.scaled(&scale)?.arc_length(&1e-11)?;
        prop_assert_eq!(scaled.total(), scale * length.total());
        prop_assert_eq!(scaled.bound(), scale * length.bound());
    }

    #[test]
    fn rational_operators_keep_lengths(c in nurbs::<2>(KIND.of_degree(0, 4))) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let length = c.arc_length(&1e-10)?;
        let points: Vec<_> = c.lifted().coeffs().iter().map(|c| c.point / c.weight.abs().max(1e-300)).collect();
        let noise = noise(&points, c.space());
        prop_assert!(agree(&length, &c.reversed()?.arc_length(&1e-10)?, noise));
        prop_assert!(agree(&length, &c.elevated(1)?.arc_length(&1e-10)?, noise));
        let (mut chords, ends) = (0.0, c.space().breaks());
        for ends in ends.windows(2) {
            let (a, b) = (ends[0].0, ends[1].0);
            let at = |i: usize| if i == 256 { c.at_left(&b) } else { c.at(&(a + (b - a) * (i as f64 / 256.0))) };
            let points = (0..=256).map(at).collect::<Result<Vec<_>>>()?;
            chords += points.windows(2).map(|ends| (ends[1] - ends[0]).norm()).sum::<f64>();
        }
        prop_assert!(chords <= length.total() + length.bound() + noise);
    }

    #[test]
    fn parameters_and_lengths_are_inverse(c in curve::<2>(KIND), share in 0.0_f64..=1.0) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let length = c.arc_length(&1e-10)?;
        let s = share * length.total();
        let x = length.parameter_at(&s)?;
        let (a, b) = c.domain();
        prop_assert!(*a <= x && x <= *b);
        // A parameter is rounded, and that moves along the curve by the speed.
        let bezier = c.bezier_pieces()?;
        let speed = |piece: &Curve<f64, 2>| {
            let (a, b) = piece.domain();
            let p = piece.degree() as f64;
            let legs = piece.coeffs().windows(2).map(|ends| (ends[1] - ends[0]).norm());
            legs.fold(0.0, f64::max) * p / (b - a) * a.abs().max(b.abs())
        };
        let blur = 8.0 * EPS * bezier.iter().map(speed).fold(0.0, f64::max) + 16.0 * EPS * length.total();
        prop_assert!((length.at(&x)? - s).abs() <= blur, "{} {s} {blur}", length.at(&x)?);
        let lower = length.at(&(a + (x - a) * 0.7))?;
        prop_assert!(lower <= length.at(&x)? + blur);
    }

    #[test]
    fn even_parameters_are_at_equal_lengths(c in nurbs::<3>(KIND.of_degree(1, 3)), count in 1..12_usize) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let length = c.arc_length(&1e-9)?;
        let x = length.evenly(count)?;
        let points = c.points().unwrap_or_default();
        prop_assume!(!points.is_empty());
        prop_assert_eq!((x.len(), &x[0], &x[count]), (count + 1, c.domain().0, c.domain().1));
        prop_assert!(x.is_sorted());
        // A parameter is rounded: the length is reached between its neighbours.
        let (a, b) = c.domain();
        let near = 8.0 * EPS * a.abs().max(b.abs());
        let up_to = |x: f64| match c.restricted(a, &x.min(*b)).and_then(|part| part.arc_length(&1e-9)) {
            Ok(part) => (part.total(), part.bound()),
            Err(_) => (0.0, f64::INFINITY),
        };
        for (i, x) in x.iter().enumerate() {
            let s = length.total() * i as f64 / count as f64;
            let (low, high) = (up_to(x - near), up_to(x + near));
            let blur = length.bound() + noise(&points, c.space());
            prop_assert!(low.0 - low.1 - blur <= s && s <= high.0 + high.1 + blur, "{low:?} {s} {high:?}");
        }
    }

    #[test]
    fn arcs_have_the_length_of_their_angle(
        angles in (-7.0..7.0_f64, 0.01..6.2_f64),
        centre in (-1e3..1e3_f64, -1e3..1e3_f64),
        radius in 1e-3..1e3_f64,
        ratio in 0.01..100.0_f64,
    ) {
        let centre = vector![centre.0, centre.1];
        let Ok(arc) = arc_by_angles(&centre, &radius, &angles.0, &angles.1) else { return Ok(()) };
        let (length, exact) = (arc.arc_length(&1e-11)?, radius * angles.1);
        let noise = 1e2 * EPS * (radius + centre.norm());
        prop_assert!((length.total() - exact).abs() <= length.bound() + noise);
        // Another parameter: the same curve.
        let (a, b) = arc.domain();
        let other = arc.moebius(a, b, &ratio)?.arc_length(&1e-11)?;
        prop_assert!((other.total() - exact).abs() <= other.bound() + noise);
    }

    #[test]
    fn parabolas_have_their_closed_form(steep in 1e-3..1e3_f64, x in 0.1..10.0_f64) {
        // y = steep t²
        let points = vec![vector![-x, steep * x * x], vector![0.0, -steep * x * x], vector![x, steep * x * x]];
        let parabola = Curve::new(SplineSpace::bezier(2, -x, x)?, points)?;
        let slope = 2.0 * steep * x;
        let exact = x * (1.0 + slope * slope).sqrt() + slope.asinh() / (2.0 * steep);
        let length = parabola.arc_length(&1e-12)?;
        prop_assert!((length.total() - exact).abs() <= length.bound() + 8.0 * EPS * exact);
        prop_assert!(length.bound() <= 1e-12 * exact);
        prop_assert!((length.at(&0.0)? - exact / 2.0).abs() <= length.bound());
    }

    #[test]
    fn ellipses_have_their_perimeter(ratio in 1e-4..1.0_f64) {
        let rim = ellipse(&vector![1.0, 2.0], &vector![1.0, 0.0], &vector![0.0, ratio])?;
        let length = rim.arc_length(&1e-11)?;
        prop_assert!((length.total() - perimeter(1.0, ratio)).abs() <= length.bound() + 1e-13);
        prop_assert!(length.bound() <= 2e-11 * length.total());
    }

    #[test]
    fn what_is_no_accuracy_or_parameter_is_refused(c in curve::<2>(KIND), bad in prop_oneof![Just(0.0), Just(-1.0), Just(f64::NAN), Just(f64::INFINITY)]) {
        let Ok(c) = c.to_f64() else { return Ok(()) };
        let refused = matches!(c.arc_length(&bad), Err(Error::BadTolerance { .. }));
        prop_assert!(refused);
        let length = c.arc_length(&1e-3)?;
        let (a, b) = length.domain();
        for x in [a.next_down(), b.next_up(), f64::NAN, f64::INFINITY] {
            let refused = matches!(length.at(&x), Err(Error::OutsideDomain { .. }));
            prop_assert!(refused);
        }
        for s in [-f64::MIN_POSITIVE, length.total().next_up(), f64::NAN] {
            let refused = matches!(length.parameter_at(&s), Err(Error::OutsideDomain { .. }));
            prop_assert!(refused);
        }
        let [none, most] = [0, usize::MAX].map(|count| length.evenly(count));
        let refused = matches!((none, most), (Err(Error::TooFewPoints { .. }), Err(Error::TooLarge { .. })));
        prop_assert!(refused);
        prop_assert_eq!(length.parameter_at(&0.0)?, a);
        prop_assert!(length.total() == 0.0 || length.parameter_at(&length.total())? == b);
    }

    #[test]
    fn no_points_make_a_panic_or_take_long(
        p in 0..9_usize,
        points in proptest::collection::vec((any::<f64>(), any::<f64>()), 12),
        weights in proptest::collection::vec(any::<f64>(), 12),
    ) {
        let space = SplineSpace::uniform(p, 3, -1.0, 1.0)?;
        let points: Vec<_> = points[..space.dim()].iter().map(|(x, y)| vector![*x, *y]).collect();
        let weights = weights[..space.dim()].iter().map(|w| w.abs().max(1e-300)).collect();
        if let Ok(length) = Curve::new(space.clone(), points.clone()).and_then(|c| c.arc_length(&1e-12)) {
            prop_assert!(length.total() >= 0.0 && length.bound() >= 0.0);
            prop_assert!(length.evenly(7)?.is_sorted());
        }
        if let Ok(length) = NurbsCurve::new(space, points, weights).and_then(|c| c.arc_length(&1e-12)) {
            prop_assert!(length.total() >= 0.0 && length.bound() >= 0.0);
            prop_assert!(length.evenly(7)?.is_sorted());
        }
    }
}

/// The perimeter of an ellipse by the arithmetic-geometric mean: `2π (a² - Σ 2^(n-1) c_n²) / M(a, b)`.
fn perimeter(a: f64, b: f64) -> f64 {
    let (mut x, mut y, mut power, mut sum) = (a, b, 0.5, 0.0);
    let mut square = a * a - b * b;
    for _ in 0..12 {
        sum += power * square;
        square = ((x - y) / 2.0).powi(2);
        (x, y, power) = (x.midpoint(y), (x * y).sqrt(), 2.0 * power);
    }
    TAU * (a * a - sum) / x
}

/// The curve with these coordinates, all on one domain.
fn curve_of(x: &Function<f64>, y: &Function<f64>) -> Result<Curve<f64, 2>> {
    let space = x.space().union(y.space())?;
    let (x, y) = (x.embedded(&space)?, y.embedded(&space)?);
    Curve::new(space, x.coeffs().iter().zip(y.coeffs()).map(|(x, y)| vector![*x, *y]).collect())
}

#[test]
fn the_cusp_has_its_length() -> Result<()> {
    // (t², t³) has the speed |t| √(4 + 9 t²).
    for (a, b) in [(-1.0, 1.0), (-1.0, 0.7), (-0.1, 3.0), (0.0, 1.0), (-2.0, 1e-9)] {
        let power = |n| Function::monomial(n, a, b);
        let cusp = curve_of(&power(2)?, &power(3)?)?;
        let up_to = |t: f64| ((4.0 + 9.0 * t * t).powf(1.5) - 8.0) / 27.0;
        let up_to = |t: f64| if t.abs() < 1e-4 { t * t } else { up_to(t) };
        let length = cusp.arc_length(&1e-12)?;
        assert!(contains(&length, up_to(a) + up_to(b)), "{} {}", length.total(), up_to(a) + up_to(b));
        assert!(length.bound() <= 1e-12 * length.total());
        for s in length.evenly(50)? {
            let exact = if s < 0.0 { up_to(a) - up_to(s) } else { up_to(a) + up_to(s) };
            assert!((length.at(&s)? - exact).abs() <= length.bound() + 4.0 * EPS);
        }
    }
    Ok(())
}

#[test]
fn the_cardioid_has_its_length() -> Result<()> {
    // r = 1 - cos θ with t = tan θ/2, the cusp at t = 0: the length from there is 4 (1 - cos θ/2).
    for (a, b) in [(-2.0, 3.0), (0.0, 1.0), (-1e-3, 50.0)] {
        let power = |n: usize| Function::monomial(n, a, b);
        let bottom = power(0)?.sum(&power(2)?)?;
        let bottom = bottom.times(&bottom)?;
        let x = power(2)?.sum(&power(4)?.scaled(&-1.0)?)?.scaled(&2.0)?;
        let top = curve_of(&x, &power(3)?.scaled(&4.0)?)?;
        let cardioid = NurbsCurve::from_quotient(&top, &bottom)?;
        let up_to = |t: f64| 4.0 * (1.0 - 1.0 / (1.0 + t * t).sqrt());
        let length = cardioid.arc_length(&1e-10)?;
        assert!((length.total() - up_to(a) - up_to(b)).abs() <= length.bound() + 1e-11, "{a} {b}");
        assert!(length.bound() <= 1e-9, "{}", length.bound());
    }
    Ok(())
}

#[test]
fn circles_and_quarters() -> Result<()> {
    let whole = circle(&vector![3.0, -1.0], &0.5)?;
    let length = whole.arc_length(&1e-12)?;
    assert!(contains(&length, PI) && length.bound() <= 2e-12 * PI);
    // Exact at the knots.
    for (i, knot) in whole.space().breaks().iter().enumerate() {
        let share = i as f64 / (whole.space().breaks().len() - 1) as f64;
        assert!((length.at(&knot.0)? - share * PI).abs() <= length.bound());
    }
    let points = vec![vector![1.0, 0.0], vector![1.0, 1.0], vector![0.0, 1.0]];
    let quarter = NurbsCurve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points, vec![1.0, 1.0, 2.0])?;
    let length = quarter.arc_length(&1e-13)?;
    assert!((length.total() - PI / 2.0).abs() <= 4.0 * EPS);
    let angle = |x: f64| quarter.at(&x).map(|c| c[1].atan2(c[0]));
    for (i, x) in length.evenly(90)?.into_iter().enumerate() {
        assert!((angle(x)? - (i as f64).to_radians()).abs() <= 8.0 * EPS);
    }
    Ok(())
}

#[test]
fn jumps_count_nothing() -> Result<()> {
    let space = SplineSpace::clamped(1, [0.0, 1.0, 1.0, 2.0])?;
    let points = vec![vector![0.0, 0.0], vector![3.0, 4.0], vector![100.0, 0.0], vector![100.0, 2.0]];
    let length = Curve::new(space, points)?.arc_length(&1e-9)?;
    assert_eq!((length.total(), length.at(&1.0)?, length.at(&1.5)?), (7.0, 5.0, 6.0));
    assert_eq!(length.parameter_at(&6.0)?, 1.5);
    Ok(())
}

#[test]
fn where_a_curve_stands_still_any_parameter_will_do() -> Result<()> {
    let space = SplineSpace::clamped(1, [0.0, 1.0, 2.0, 3.0])?;
    let points = [0.0, 2.0, 2.0, 3.0].map(|x| vector![x]).to_vec();
    let length = Curve::new(space.clone(), points)?.arc_length(&1e-9)?;
    assert!((1.0..=2.0).contains(&length.parameter_at(&2.0)?));
    assert_eq!((length.at(&1.5)?, length.total()), (2.0, 3.0));
    let point = Curve::constant(space, vector![1e300, -1e300, 5.0])?.arc_length(&1e-9)?;
    assert_eq!(
        (point.total(), point.bound(), point.at(&2.0)?, point.parameter_at(&0.0)?),
        (0.0, 0.0, 0.0, 0.0)
    );
    assert!(point.evenly(3)?.is_sorted());
    Ok(())
}

#[test]
fn a_segment_back_and_forth_counts_every_time() -> Result<()> {
    // x = T_n(t) runs n times between -1 and 1.
    let mut before = Function::monomial(0, -1.0, 1.0)?;
    let mut now = Function::monomial(1, -1.0, 1.0)?;
    for n in 1..=10 {
        let chebyshev = Curve::new(
            now.space().clone(),
            now.coeffs().iter().map(|x| vector![3.0 * x, 4.0 * x]).collect(),
        )?;
        let length = chebyshev.arc_length(&1e-10)?;
        assert!(
            (length.total() - 10.0 * f64::from(n)).abs() <= length.bound() + 1e-13 * 3_f64.powi(n),
            "{n}"
        );
        let next = now.times(&Function::monomial(1, -1.0, 1.0)?)?.scaled(&2.0)?;
        (before, now) = (now, next.sum(&before.scaled(&-1.0)?)?);
    }
    Ok(())
}

#[test]
fn sizes_at_the_ends_of_the_range() -> Result<()> {
    let exact = 5_f64.sqrt() + 2_f64.asinh() / 2.0;
    for size in [5e307, 1e300, 1e150, 1e10, 1e-13, 1e-150, 1e-300] {
        let points = [[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]].map(|[x, y]| vector![size * x, size * y]);
        let c = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points.to_vec())?;
        for length in [c.arc_length(&1e-12)?, NurbsCurve::from_polynomial(&c)?.arc_length(&1e-12)?] {
            assert!((length.total() / size - exact).abs() <= 1e-14, "{size}");
            assert!(length.bound() <= 2e-12 * length.total(), "{size}");
            assert!((length.parameter_at(&(length.total() / 2.0))?).abs() <= 1e-15);
        }
    }
    // Far from the origin, and spans of all lengths.
    let far = [[0.0, 0.0], [0.5, 1.0], [1.0, 0.0]].map(|[x, y]| vector![1e10 + x, y - 1e10]);
    let near = far.map(|c| c - far[0]);
    for width in [1e-300, 1.0, 1e300] {
        let on =
            |points: [SVector<f64, 2>; 3]| Curve::new(SplineSpace::bezier(2, 0.0, width)?, points.to_vec());
        let (far, near) = (on(far)?.arc_length(&1e-12)?, on(near)?.arc_length(&1e-12)?);
        assert_eq!(far.total(), near.total());
        assert!(near.bound() <= 1e-12 * near.total());
    }
    Ok(())
}

#[test]
fn high_degrees_end() -> Result<()> {
    for p in [20, 60, 150, 512] {
        let space = SplineSpace::bezier(p, 0.0, 1.0)?;
        let points: Vec<_> =
            (0..=p).map(|i| vector![(12.7 * i as f64).cos(), (21.1 * i as f64).sin()]).collect();
        let c = Curve::new(space, points)?;
        let (coarse, fine) = (c.arc_length(&1e-2)?, c.arc_length(&1e-9)?);
        assert!(agree(&coarse, &fine, 0.0));
        assert!(p > 100 || fine.bound() <= 1e-8 * fine.total(), "{p} {}", fine.bound());
        let size = c.coeffs().iter().map(|c: &SVector<f64, 2>| c.squared_size()).fold(0.0, f64::max);
        assert!(size > 0.0);
    }
    Ok(())
}
