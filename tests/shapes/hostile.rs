//! Shape tools given what nobody should give them: values or typed errors, and shapes left as they were on an error.

use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{
    Constraints, Controlled, CurvatureHandle, Curve, Direction, Drag, Error, Excess, Function, LegPoint,
    NurbsCurve, Q, RationalFunction, Relief, Row, Scalar, ShapeError, Spline, SplineSpace, WeightPairPull,
    WeightPull, WeightRange, Weighted, confined, cross_ratio, with_tangent,
};

type P = SVector<f64, 2>;
type Law = Result<(), TestCaseError>;

/// Coordinates of all sizes.
fn coordinate() -> impl Strategy<Value = f64> {
    let sizes = [0.0, 1e300, -1e300, 1e-300, 1e308, 5e-324, 1e155, 1e-160, 1e6, 1e-6];
    prop_oneof![4 => -2.0..2.0_f64, 5 => proptest::sample::select(sizes.to_vec())]
}

/// Numbers of all sizes, and what is none.
fn wild() -> impl Strategy<Value = f64> {
    prop_oneof![8 => coordinate(), 1 => Just(f64::NAN), 1 => Just(f64::INFINITY)]
}

/// Spaces with huge and tiny spans, clamped, unclamped and periodic, rings of one coefficient among them.
fn spans() -> impl Strategy<Value = SplineSpace<f64>> {
    let gap = proptest::sample::select(vec![1.0, 1.0, 1.0, 0.0, 0.0, 1e-6, 1e6, 1e300, 1e-300]);
    let start = proptest::sample::select(vec![0.0, -1e300, 100.0]);
    (0_usize..4, 0_usize..3, vec(gap, 1..9), start).prop_filter_map("no space", |(p, ends, gaps, start)| {
        let walk = |at: &mut f64, gap: &f64| {
            *at += gap;
            Some(*at)
        };
        let knots: Vec<f64> = [start].into_iter().chain(gaps.iter().scan(start, walk)).collect();
        let last = knots[knots.len() - 1];
        let space = match ends {
            0 => SplineSpace::clamped(p, knots),
            1 => SplineSpace::new(p, knots),
            _ => SplineSpace::periodic(p, knots.into_iter().filter(|t| *t < last), last - start),
        };
        space.ok()
    })
}

/// What is asked for.
#[derive(Clone, Debug)]
struct Asked {
    /// Parameters, by their places.
    at: Vec<(Index, f64)>,
    /// A parameter that may be none.
    anywhere: Option<f64>,
    vectors: Vec<P>,
    number: f64,
    pick: Index,
    orders: Vec<usize>,
}

impl Asked {
    fn parameters(&self, space: &SplineSpace<f64>) -> Vec<f64> {
        let breaks: Vec<f64> = space.breaks().into_iter().map(|(t, _)| t).collect();
        let inside = |(place, share): &(Index, f64)| match place.index(breaks.len()) {
            i if *share < 0.4 || i + 1 == breaks.len() => breaks[i],
            i => breaks[i] + (breaks[i + 1] - breaks[i]) * share,
        };
        let mut at: Vec<f64> = self.at.iter().map(inside).collect();
        if let Some(x) = self.anywhere {
            at[0] = x;
        }
        at
    }
}

fn asked() -> impl Strategy<Value = Asked> {
    let at = vec((any::<Index>(), 0.0..1.0_f64), 4);
    let anywhere = prop_oneof![7 => Just(None), 1 => wild().prop_map(Some)];
    let vectors = vec((wild(), wild()).prop_map(|(x, y)| vector![x, y]), 4);
    (at, anywhere, vectors, wild(), any::<Index>(), vec(0_usize..5, 3)).prop_map(
        |(at, anywhere, vectors, number, pick, orders)| Asked { at, anywhere, vectors, number, pick, orders },
    )
}

/// Control points and weights as texts, in which what is no number equals itself.
fn texts<S: Controlled<f64>>(shape: &S) -> Vec<String> {
    let text = |i: usize| format!("{:?} {:?}", shape.control_point(i), shape.control_weight(i));
    (0..shape.control_count()).map(text).collect()
}

/// Edits a shape, which on an error stays as it was.
fn edited<S: Controlled<f64>>(shape: &mut S, edit: impl FnOnce(&mut S) -> Result<(), Error>) -> Law {
    let before = texts(shape);
    if edit(shape).is_err() {
        prop_assert_eq!(before, texts(shape));
    }
    Ok(())
}

/// All tools but those of weights.
fn pounded<S>(shape: &S, asked: &Asked) -> Law
where
    S: Controlled<f64, Point = P, Parameter = f64, Order = usize, Index = usize>,
{
    let (space, g, v) = (shape.space_along(Direction::U), &asked.number, &asked.vectors);
    let [x, start, end, z] = &asked.parameters(space)[..] else { unreachable!("four parameters") };
    let (n, i) = (shape.control_count(), asked.pick.index(shape.control_count()));
    let mut moving = shape.clone();
    let drags = [
        Drag::by_one(shape, x, i),
        Drag::by_nearest(shape, x),
        Drag::by_neighbours(shape, x, None),
        Drag::by_neighbours(shape, x, Some(g)),
        Drag::by_shares(shape, x, &[(i, *g), ((i + 1) % n, 1.0 - g)]),
    ];
    for drag in drags.into_iter().flatten() {
        edited(&mut moving, |shape| drag.apply(shape, &v[..1]))?;
    }
    let wanted = [x, start, end].into_iter().zip(&asked.orders);
    if let Ok(wanted) =
        wanted.into_iter().try_fold(Constraints::on(shape), |all, (x, k)| all.derivative(x, *k))
    {
        for excess in [Excess::Refused, Excess::LeastSquares] {
            let Ok(held) = wanted.clone().with_excess(excess).prepare() else { continue };
            edited(&mut moving, |shape| held.drag(shape, &v[..3]))?;
            edited(&mut moving, |shape| held.meet(shape, &v[..3]))?;
        }
        for relief in [Relief::Knots, Relief::Degree] {
            let _ = wanted.relieved(relief);
        }
        if let Ok(held) = wanted.coupled().along(z, 1, &v[3]).and_then(|coupled| coupled.prepare()) {
            edited(&mut moving, |shape| held.drag(shape, &v[..3], &[*g]))?;
        }
    }
    let _ = with_tangent(shape, x, &v[0]);
    if let Ok(handle) = CurvatureHandle::prepare(shape, x) {
        edited(&mut moving, |shape| handle.slide(shape, g))?;
        edited(&mut moving, |shape| handle.scale(shape, g))?;
        edited(&mut moving, |shape| handle.set(shape, g))?;
    }
    let legs =
        [LegPoint::new(shape, Direction::U, i, *g), LegPoint::at(shape, Direction::U, i, &v[0], &v[1][0])];
    for leg in legs.into_iter().flatten() {
        let _ = leg.is_knot(shape);
        if let Ok((finer, k)) = leg.inserted(shape) {
            prop_assert!(k < finer.control_count());
        }
    }
    if let Ok((finer, k)) = confined(shape, Direction::U, x, (start, end)) {
        prop_assert!(k < finer.control_count());
    }
    let _ = (space.node_placing_knot(x), space.halfway_knot(x), space.halfway_knot_or_copy(x));
    let _ = cross_ratio([&v[0], &v[1], &v[2], &v[3]], g);
    Ok(())
}

fn weighed(shape: &NurbsCurve<f64, 2>, asked: &Asked) -> Law {
    let x = &asked.parameters(shape.space())[0];
    let (i, n) = (asked.pick.index(shape.control_count()), shape.control_count());
    let mut moving = shape.clone();
    if let Ok(pull) = WeightPull::new(shape, x, i) {
        for fraction in asked.vectors.iter().flat_map(|v| v.iter()) {
            edited(&mut moving, |shape| pull.apply(shape, fraction))?;
        }
    }
    if let Ok(pull) = WeightPairPull::new(shape, x, [i, (i + 1) % n]) {
        for target in &asked.vectors {
            edited(&mut moving, |shape| pull.apply_to(shape, target, &asked.number))?;
            edited(&mut moving, |shape| pull.apply_along(shape, &target[0]))?;
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn tools_give_values_or_errors(
        space in spans(), points in vec((coordinate(), coordinate()), 40), asked in asked(),
        weights in vec(prop_oneof![5 => 0.1..5.0_f64, 1 => Just(1e-300), 1 => Just(1e300)], 40),
    ) {
        let n = space.dim();
        let points: Vec<P> = points[..n].iter().map(|(x, y)| vector![*x, *y]).collect();
        pounded(&Curve::new(space.clone(), points.clone())?, &asked)?;
        if let Ok(rational) = NurbsCurve::new(space, points, weights[..n].to_vec()) {
            pounded(&rational, &asked)?;
            weighed(&rational, &asked)?;
        }
    }
}

#[test]
fn rows_of_other_lengths_are_refused() {
    let line = SplineSpace::bezier(1, 0.0, 1.0).expect("a space");
    let rows = |rows: [&[f64]; 2]| rows.map(|row| Row(row.to_vec())).to_vec();
    let mut f = Spline::new(line.clone(), rows([&[0.0, 1.0], &[2.0, 3.0]])).expect("a spline");
    let mut r = RationalFunction::new(line, vec![1.0, 2.0], vec![1.0, 2.0]).expect("a rational function");
    let before = f.clone();
    let held = Constraints::on(&before).point(&0.0).unwrap().point(&1.0).unwrap().prepare().unwrap();
    assert_eq!(held.drag(&mut f, &rows([&[1.0, 2.0], &[3.0]])), Err(Error::Ragged { index: 1 }));
    for length in [1, 3] {
        let ones = vec![1.0; length];
        assert_eq!(held.drag(&mut f, &rows([&ones, &ones])), Err(Error::Ragged { index: 0 }));
        assert!(held.meet(&mut f, &rows([&ones, &ones])).is_err());
    }
    assert_eq!(f, before);
    // Moves of one control point add up, in whatever order they come.
    f.move_points(&[(1, Row(vec![1.0, 0.0])), (0, Row(vec![0.0, 5.0])), (1, Row(vec![1.0, 1.0]))]).unwrap();
    assert_eq!(f.coeffs(), rows([&[0.0, 6.0], &[4.0, 4.0]]));
    r.move_points(&[(0, 1.0), (0, 1.0), (1, 1.0)]).unwrap();
    assert_eq!(r.control_points(), Ok(vec![3.0, 3.0]));
    assert_eq!(r.control_weight(1), Ok(2.0));
}

#[test]
fn who_may_move_is_said_anew() {
    let space = SplineSpace::clamped(2, [0, 1, 2].map(Q::int)).expect("a space");
    let f = Function::constant(space, Q::int(0)).expect("a constant");
    let x = Q::frac(1, 2);
    let wanted = Constraints::on(&f).point(&x).unwrap().freeing(&[0]).unwrap().freeing(&[1, 2]).unwrap();
    assert_eq!(wanted.prepare().unwrap().matrix().indices(), [1, 2]);
    // What is held stays held, and those freed are no wishes that a refined shape could take over.
    let wanted = wanted.holding(&[1]).unwrap();
    assert_eq!(wanted.prepare().unwrap().matrix().indices(), [2]);
    let wanted = Constraints::on(&f).point(&x).unwrap().freeing(&[1]).unwrap();
    assert_eq!(wanted.relieved(Relief::Knots).map(|_| ()), Err(ShapeError::NotCarried.into()));
}

#[test]
fn sizes_do_not_matter() {
    for size in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
        let scaled = |[x, y]: [f64; 2]| vector![x * size, y * size];
        let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]].map(scaled).to_vec();
        let curve = Curve::new(SplineSpace::bezier(3, 0.0, 1.0).unwrap(), points).unwrap();
        // A point of a leg, and one off it.
        let at = |target| LegPoint::at(&curve, Direction::U, 0, &scaled(target), &0.0);
        assert!((at([0.5, 1.0]).unwrap().fraction() - 0.5).abs() < 1e-15, "{size}");
        assert!(matches!(at([0.5, 1.01]), Err(Error::TooFar { .. })), "{size}");
        for (tolerance, near) in [(0.99, false), (1.01, true)] {
            // The distance from the line through (1, 2) is 0.02 / √5.
            let tolerance = tolerance * 0.02 * size / 5.0_f64.sqrt();
            let leg = LegPoint::at(&curve, Direction::U, 0, &scaled([0.5, 1.02]), &tolerance);
            assert_eq!(leg.is_ok(), near, "{size}");
        }
        // Rounding is no distance.
        for i in 1..100 {
            let share = f64::from(i) / 100.0;
            let target = curve.coeffs()[0].lerp(&curve.coeffs()[2], 0.7).lerp(&curve.coeffs()[1], share);
            let tilted = Curve::new(curve.space().clone(), {
                let start = curve.coeffs()[0].lerp(&curve.coeffs()[2], 0.7);
                vec![start, curve.coeffs()[1], curve.coeffs()[2], curve.coeffs()[3]]
            });
            let leg = LegPoint::at(&tilted.unwrap(), Direction::U, 0, &target, &0.0);
            assert!((leg.unwrap().fraction() - share).abs() < 1e-14, "{size} {share}");
        }
        assert!(matches!(at([2.0, 4.0]), Err(Error::Shape(ShapeError::NotOnLeg { .. }))), "{size}");
        // A tangent, however long its direction.
        for length in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
            for sign in [1.0, -1.0] {
                let turned = with_tangent(&curve, &0.5, &vector![2.0 * length * sign, length * sign]);
                if sign > 0.0 {
                    let tangent = turned.unwrap().derivative_at(&0.5, 1).unwrap() / size;
                    assert!((tangent - vector![3.6, 1.8]).norm() < 1e-13, "{size} {length}");
                } else {
                    assert_eq!(turned, Err(ShapeError::TangentReversed.into()));
                }
            }
        }
        // A bend, with the part along the tangent as it was.
        let handle = CurvatureHandle::prepare(&curve, &0.3).unwrap();
        let parts = |curve: &Curve<f64, 2>| {
            let [_, d, e] = &curve.derivatives_at(&0.3, 2).unwrap()[..] else { unreachable!() };
            let (d, e) = (d / size, e / size);
            (d.dot(&e), d[0] * e[1] - d[1] * e[0])
        };
        let (along, across) = parts(&curve);
        let mut bent = curve.clone();
        handle.scale(&mut bent, &2.0).unwrap();
        let new = parts(&bent);
        assert!((new.0 - along).abs() < 1e-12 && (new.1 - 2.0 * across).abs() < 1e-11, "{size}: {new:?}");
    }
    let line = Curve::new(
        SplineSpace::bezier(1, 0.0, 1.0).unwrap(),
        vec![vector![-1e308, 0.0], vector![1e308, 0.0]],
    );
    let refused = LegPoint::at(&line.unwrap(), Direction::U, 0, &vector![0.0, 0.0], &0.0);
    assert!(matches!(refused, Err(Error::NotFinite { .. })));
    // Next to a large coordinate the squares of short ways are numbers, that of the coordinate is none.
    let ends = vec![vector![1e155, 0.0], vector![1.01e155, 0.0]];
    let far = Curve::new(SplineSpace::bezier(1, 0.0, 1.0).unwrap(), ends).unwrap();
    let off = LegPoint::at(&far, Direction::U, 0, &vector![1.005e155, 1e152], &0.0);
    assert!(matches!(off, Err(Error::TooFar { .. })), "{off:?}");
}

#[test]
fn endless_directions_are_refused() {
    let points = vec![vector![0.0, 0.0], vector![1.0, 1.0], vector![2.0, 0.0]];
    let curve = Curve::new(SplineSpace::bezier(2, 0.0, 1.0).unwrap(), points).unwrap();
    for (index, direction) in [vector![f64::INFINITY, 1.0], vector![1.0, f64::NAN]].into_iter().enumerate() {
        let refused = Error::NotFinite { what: "direction", index };
        assert_eq!(with_tangent(&curve, &0.5, &direction), Err(refused));
    }
}

#[test]
fn nodes_are_nodes_but_for_rounding() {
    let space = SplineSpace::clamped(3, (0..8).map(|i| f64::from(i) / 7.0)).unwrap();
    for i in 1..space.dim() - 1 {
        let x = space.node(i).unwrap();
        for x in [x, x * (1.0 + f64::EPSILON), x * (1.0 - f64::EPSILON)] {
            assert_eq!(space.node_placing_knot(&x), Ok(None), "{x}");
        }
    }
}

#[test]
fn what_is_asked_for_twice_is_told_at_once() {
    let cubic = SplineSpace::bezier(3, Q::int(0), Q::int(1)).expect("a space");
    let f = Function::constant(cubic, Q::int(0)).expect("a constant");
    let mut wanted = Constraints::on(&f);
    for i in 0..40 {
        wanted = wanted.point(&Q::frac(i, 40)).unwrap();
    }
    let wanted = wanted.derivative(&Q::frac(7, 40), 1).unwrap().point(&Q::frac(7, 40)).unwrap();
    for relief in [Relief::Knots, Relief::Degree] {
        let refused = ShapeError::Dependent { condition: 41, on: vec![7] };
        assert_eq!(wanted.relieved(relief).map(|_| ()), Err(refused.into()));
    }
}

#[test]
fn room_is_made_between_places_however_close() {
    let cubic = SplineSpace::bezier(3, Q::int(0), Q::int(1)).expect("a space");
    let f = Function::constant(cubic, Q::int(0)).expect("a constant");
    let mut wanted = Constraints::on(&f);
    for i in 1..6 {
        wanted = wanted.point(&Q::frac(i, 1_000_000_007)).unwrap();
    }
    let (finer, held) = wanted.relieved(Relief::Knots).unwrap();
    assert_eq!(finer.space().dim(), 5);
    let moved = held.dragged(&finer, &[1, -1, 1, -1, 1].map(Q::int)).unwrap();
    assert_eq!(moved.at(&Q::frac(2, 1_000_000_007)), Ok(Q::int(-1)));
}

#[test]
fn degrees_rise_as_far_as_derivatives_need() {
    // All orders at one place, and a value elsewhere: degree seven, from one.
    let line = SplineSpace::bezier(1, Q::int(0), Q::int(1)).expect("a space");
    let f = Function::constant(line, Q::int(0)).expect("a constant");
    let high = Constraints::on(&f).derivative(&Q::frac(1, 3), 7).unwrap();
    let (higher, held) = high.relieved(Relief::Degree).unwrap();
    assert_eq!(higher.degree(), 7);
    let bent = held.dragged(&higher, &[Q::int(1)]).unwrap();
    assert_eq!(bent.derivative_at(&Q::frac(1, 3), 7), Ok(Q::int(1)));
}

#[test]
fn a_new_control_point_has_a_weight_however_little_the_others_have() {
    let ends = [(0.0, 1e-20), (0.0, 0.0), (2e-20, 1e-20)].map(|(point, weight)| Weighted { point, weight });
    let lifted = Spline::new(SplineSpace::bezier(2, 0.0, 1.0).unwrap(), ends.to_vec()).unwrap();
    let mut f = RationalFunction::from_lifted(lifted).unwrap();
    let pull = WeightPull::from_zero(&f, &0.5, 1, 5.0).unwrap();
    pull.apply(&mut f, &0.25).unwrap();
    assert!((f.at(&0.5).unwrap() - 2.0).abs() < 1e-14);
}

#[test]
fn floats_are_as_near_as_they_can_be() {
    // Six conditions, of which the second derivatives are far larger than the values, on the four points of a cubic.
    let places = [(0, 0), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1)];
    let exact =
        Function::constant(SplineSpace::bezier(3, Q::int(0), Q::frac(1, 10)).unwrap(), Q::int(0)).unwrap();
    let float = exact.to_f64().unwrap();
    let (mut wanted, mut near) = (Constraints::on(&exact), Constraints::on(&float));
    for (i, k) in places {
        let x = Q::frac(i, 20);
        (wanted, near) = (wanted.derivative(&x, k).unwrap(), near.derivative(&x.to_f64(), k).unwrap());
    }
    let held = wanted.with_excess(Excess::LeastSquares).prepare().unwrap();
    let near = near.with_excess(Excess::LeastSquares).prepare().unwrap();
    let rows = held.matrix().rows().map(|row| row.iter().map(Q::to_f64).collect::<Vec<f64>>());
    let rows: Vec<(Vec<f64>, &[f64])> = rows.zip(near.matrix().rows()).collect();
    for j in 0..places.len() {
        let size = rows.iter().map(|(exact, _)| exact[j].abs()).fold(0.0, f64::max);
        for (exact, near) in &rows {
            assert!((exact[j] - near[j]).abs() <= 1e-9 * size, "{j}: {} {}", exact[j], near[j]);
        }
    }
}

#[test]
fn halfway_knots_that_are_there_but_for_rounding_are_told() {
    let told = |result: Result<symspline::Halfway<f64>, Error>| match result {
        Ok(found) => found.knot.is_none(),
        Err(error) => matches!(error, Error::Shape(ShapeError::KnotThere { .. })),
    };
    for degree in 2..5 {
        let space = SplineSpace::clamped(degree, (0..8).map(|i| f64::from(i) / 7.0)).unwrap();
        for i in 1..7 {
            let finer = space.refined(&[f64::from(i) / 7.0]).unwrap();
            for k in 0..finer.dim() - 1 {
                let x = finer.between_nodes(k).unwrap();
                let nodes = [k, k + 1].map(|i| finer.node(i).unwrap());
                // Elsewhere the nodes are those of the space, or another knot would do as well.
                let new =
                    nodes.iter().all(|node| !space.greville().iter().any(|old| (old - node).abs() < 1e-9));
                for x in [x, x * (1.0 + f64::EPSILON), x * (1.0 - f64::EPSILON)] {
                    assert!(!new || told(space.halfway_knot(&x)), "degree {degree}, knot {i}, {x}");
                }
            }
        }
    }
}

#[test]
fn limits_of_weights_are_inside_however_they_are_rounded() {
    let space = SplineSpace::bezier(3, 0.0, 1.0).unwrap();
    let points = [[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0]].map(|[x, y]| vector![x, y]).to_vec();
    for i in 1..200 {
        let share = f64::from(i) / 201.0;
        let weights = vec![1.0 + share, 1.0 / (3.0 + share), 0.7 + share / 3.0, 1.3];
        let curve = NurbsCurve::new(space.clone(), points.clone(), weights).unwrap();
        let range = WeightRange::new(0.1 + share / 7.0, 3.0 + share / 11.0).unwrap();
        let inside = |weight: &f64| range.least() <= weight && weight <= range.most();
        let pull = WeightPull::new(&curve, &share, 1).unwrap().within(range.clone());
        for limit in [pull.push_limit().unwrap(), pull.pull_limit().unwrap()] {
            assert!(inside(&pull.weight_for(&limit).unwrap()), "{i}");
        }
        let pull = WeightPairPull::new(&curve, &share, [1, 2]).unwrap().within(range.clone());
        for limit in [pull.push_limit(), pull.pull_limit()] {
            assert!(pull.weights_along(&limit).unwrap().iter().all(inside), "{i}");
        }
    }
}
