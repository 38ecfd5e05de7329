//! Laws of grips: what a drag moves, and where to.

use crate::rational_strategies::{nurbs, nurbs_surface};
use crate::strategies::{ANY, Kind, RING, cases, curve, function, number, point, probes, space, surface};
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestCaseResult;
use symspline::{
    Breadth, Coeff, DeformError, Direction, Elastic, Error, Function, LinearMap, Material, Q, Reach,
    Restorable, Scalar, Sculptor, SplineSpace, Spread, Stiffness,
};

const SMALL: Kind = ANY.of_degree(0, 4);
const FLAT: Kind = ANY.of_degree(0, 3).few(2);

/// A material that resists everything.
pub fn material() -> impl Strategy<Value = Material<Q>> {
    let weight = |least: i64| (least..=5, 1_i64..=3).prop_map(|(n, d)| Q::frac(n, d));
    (weight(1), weight(0), weight(0))
        .prop_map(|weights| Material::of_orders(<[Q; 3]>::from(weights)).expect("weights"))
}

/// What [`Reach`] says, with distances in eighths of the domain.
#[derive(Clone, Debug)]
pub enum Share {
    All,
    Whole,
    Nearest(usize),
    Eighths(i64),
}

pub fn share() -> impl Strategy<Value = Share> {
    prop_oneof![
        1 => Just(Share::All),
        1 => Just(Share::Whole),
        3 => (1_usize..=6).prop_map(Share::Nearest),
        2 => (1_i64..=9).prop_map(Share::Eighths),
    ]
}

pub fn eighths(space: &SplineSpace<Q>, count: i64) -> Q {
    let (a, b) = space.domain();
    (b.clone() - a) * Q::frac(count, 8)
}

impl Share {
    pub fn reach(&self, space: &SplineSpace<Q>) -> Reach<Q> {
        match self {
            Self::All => Reach::All,
            Self::Whole => Reach::Fixed(Breadth::Whole),
            Self::Nearest(count) => Reach::Nearest(*count),
            Self::Eighths(count) => Reach::Within(eighths(space, *count)),
        }
    }
}

pub fn reaches<S: Restorable<Q>>(shape: &S, shares: &[Share; 2]) -> Vec<Reach<Q>> {
    S::DIRECTIONS.iter().zip(shares).map(|(d, share)| share.reach(shape.space_along(*d))).collect()
}

/// Whether there is nothing there to hold.
pub fn is_loose(error: &Error) -> bool {
    matches!(error, Error::Deform(DeformError::NothingMoves | DeformError::NoHold { .. }))
}

/// The coefficients, by brute force, with influence on no span that reaches farther from `at` than `distance`.
fn within(space: &SplineSpace<Q>, at: &Q, distance: &Q) -> Vec<usize> {
    let (from, to) = (at.clone() - distance, at.clone() + distance);
    let (a, b) = space.domain();
    let length = b.clone() - a;
    let covered = |k: usize| {
        let turns = if space.is_periodic() { -1..=1 } else { 0..=0 };
        let all = space.is_periodic() && to.clone() - &from >= length;
        all || turns.into_iter().any(|turn| {
            let [start, end] = [k, k + 1].map(|k| space.knots()[k].clone() + length.clone() * Q::int(turn));
            from <= start && end <= to
        })
    };
    let reaches = |k: usize, i: usize| (k - space.degree()..=k).any(|j| space.slot(j) == i);
    (0..space.dim()).filter(|i| space.spans().all(|k| !reaches(k, *i) || covered(k))).collect()
}

/// Dragged to several places, pushed, let go, taken back and done again.
fn drags_are_exact<S: Restorable<Q> + PartialEq>(
    shape: &S,
    at: &S::Parameter,
    materials: &[Material<Q>],
    shares: &[Share; 2],
    by: [S::Point; 2],
) -> TestCaseResult {
    let reach = reaches(shape, shares);
    let mut sculptor = Sculptor::new(shape.clone(), materials[0].clone())
        .with_materials(materials[..S::DIRECTIONS.len()].to_vec())?
        .with_reach(reach.clone())?;
    match sculptor.grab(at) {
        Err(error) if is_loose(&error) => return Ok(()),
        other => other.map(|_| ())?,
    }
    let untouched = sculptor.clone();
    let one = Q::int(1);
    let start = shape.derivative_of(at, S::VALUE)?;
    let targets = by.map(|by| start.plus_scaled(&one, &by));
    sculptor.drag_to(&targets[0])?;
    prop_assert_eq!(&sculptor.shape().derivative_of(at, S::VALUE)?, &targets[0]);
    let force = sculptor.drag_to(&targets[1])?;
    prop_assert_eq!(&sculptor.shape().derivative_of(at, S::VALUE)?, &targets[1]);
    let mut once = untouched.clone();
    once.drag_to(&targets[1])?;
    prop_assert_eq!(sculptor.shape(), once.shape());
    let mut pushed = untouched;
    pushed.push(&force)?;
    prop_assert_eq!(sculptor.shape(), pushed.shape());

    let moving = S::DIRECTIONS.iter().zip(&reach).map(|(d, reach)| {
        let space = shape.space_along(*d);
        reach.breadth(space, S::coordinate(at, *d))?.coeffs(space)
    });
    let moving = moving.collect::<Result<Vec<_>, _>>()?;
    prop_assert_eq!(sculptor.resolution(at)?, moving.iter().map(Vec::len).collect::<Vec<_>>());
    let columns = shape.space_along(Direction::V).dim();
    for (flat, (new, old)) in sculptor.shape().stored().iter().zip(shape.stored()).enumerate() {
        let places = if moving.len() == 1 { vec![flat] } else { vec![flat / columns, flat % columns] };
        let moves = places.iter().zip(&moving).all(|(place, moving)| moving.contains(place));
        prop_assert!(moves || new == old);
    }

    let dragged = sculptor.shape().clone();
    let mut back = sculptor.clone();
    back.drag_to(&start)?;
    prop_assert_eq!(back.shape(), shape);
    prop_assert!(!back.commit() && back.edits() == (0, 0));
    prop_assert_eq!(sculptor.commit(), targets[1] != start);
    prop_assert_eq!(sculptor.undo(), targets[1] != start);
    prop_assert_eq!(sculptor.shape(), shape);
    sculptor.redo();
    prop_assert_eq!(sculptor.shape(), &dragged);
    Ok(())
}

fn place(space: &SplineSpace<Q>, at: &Index) -> Q {
    at.get(&probes(space)).clone()
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn a_grip_of_a_curve_moves_the_point_to_the_target_and_nothing_beyond_its_reach(
        f in curve::<2>(SMALL), at in any::<Index>(), by in [point::<2>(), point::<2>()],
        material in material(), shares in [share(), share()],
    ) {
        drags_are_exact(&f, &place(f.space(), &at), &[material], &shares, by)?;
    }

    #[test]
    fn a_grip_of_a_ring(
        f in function(RING.of_degree(0, 4)), at in any::<Index>(), by in [number(), number()],
        material in material(), shares in [share(), share()],
    ) {
        drags_are_exact(&f, &place(f.space(), &at), &[material], &shares, by)?;
    }

    #[test]
    fn a_grip_of_a_rational_curve(
        f in nurbs::<2>(FLAT), at in any::<Index>(), by in [point::<2>(), point::<2>()],
        material in material(), shares in [share(), share()],
    ) {
        let at = place(f.lifted().space(), &at);
        drags_are_exact(&f, &at, &[material], &shares, by)?;
    }
}

proptest! {
    #![proptest_config(cases(8))]

    #[test]
    fn a_grip_of_a_surface(
        f in surface::<3>(FLAT, FLAT), at in [any::<Index>(), any::<Index>()], by in [point::<3>(), point::<3>()],
        materials in [material(), material()], shares in [share(), share()],
    ) {
        let at = (place(f.u(), &at[0]), place(f.v(), &at[1]));
        drags_are_exact(&f, &at, &materials, &shares, by)?;
    }

    #[test]
    fn a_grip_of_a_rational_surface(
        f in nurbs_surface::<2>(FLAT.of_degree(0, 2)), at in [any::<Index>(), any::<Index>()],
        by in [point::<2>(), point::<2>()], materials in [material(), material()], shares in [share(), share()],
    ) {
        let at = (place(f.lifted().u(), &at[0]), place(f.lifted().v(), &at[1]));
        drags_are_exact(&f, &at, &materials, &shares, by)?;
    }
}

proptest! {
    #![proptest_config(cases(16))]

    /// Of two displacements that move the point as far, the other one costs more by exactly what their difference costs.
    #[test]
    fn a_point_force_moves_the_point_at_least_energy(
        f in function(SMALL), at in any::<Index>(), by in number(), material in material(),
        shares in [share(), share()], other in prop::collection::vec(number(), 48),
    ) {
        let at = place(f.space(), &at);
        let reach = reaches(&f, &shares);
        let mut sculptor =
            Sculptor::new(f.clone(), material.clone()).with_spread(Spread::Point).with_reach(reach.clone())?;
        match sculptor.grab(&at) {
            Err(error) if is_loose(&error) => return Ok(()),
            other => other.map(|_| ())?,
        }
        sculptor.drag_to(&(f.at(&at)? + &by))?;
        let least = sculptor.shape().difference(&f)?;
        sculptor.drag_to(&(f.at(&at)? + Q::int(1)))?;
        let unit = sculptor.shape().difference(&f)?;
        let mut coeffs = vec![Q::int(0); f.space().dim()];
        for i in reach[0].breadth(f.space(), &at)?.coeffs(f.space())? {
            coeffs[i] = other[i].clone();
        }
        let other = Function::new(f.space().clone(), coeffs)?;
        let other = other.difference(&unit.scaled(&other.at(&at)?)?)?;
        prop_assert_eq!(other.at(&at)?, Q::int(0));
        let energy = |f: &Function<Q>| material.energy(f);
        let sum = energy(&least.sum(&other)?)?;
        prop_assert_eq!(sum, energy(&least)? + energy(&other)?);
    }

    #[test]
    fn reach_within_a_distance_is_no_influence_beyond(
        space in space(ANY.of_degree(0, 5)), at in any::<Index>(), count in 0_i64..=9, nudge in any::<bool>(),
    ) {
        let at = place(&space, &at);
        let distance = eighths(&space, count) + if nudge { Q::frac(1, 1000) } else { Q::int(0) };
        let expected = within(&space, &at, &distance);
        let found = Reach::Within(distance).breadth(&space, &at)?.coeffs(&space);
        if expected.is_empty() {
            prop_assert!(matches!(found, Err(Error::Deform(DeformError::NothingMoves))));
        } else {
            prop_assert_eq!(found?, expected);
        }
    }

    #[test]
    fn refining_makes_room_and_changes_nothing(
        f in function(SMALL), at in any::<Index>(), distance in 1_i64..=9, count in 0_usize..9,
    ) {
        let at = place(f.space(), &at);
        let distance = eighths(f.space(), distance);
        let mut sculptor = Sculptor::new(f.clone(), Material::new(Q::int(1), Q::int(1))?)
            .with_reach([Reach::Within(distance.clone())])?;
        let before = sculptor.resolution(&at)?[0];
        let inserted = sculptor.refine(&at, &[distance], &[count])?;
        let after = sculptor.resolution(&at)?[0];
        prop_assert!(after >= count);
        prop_assert_eq!(inserted == 0, before >= count);
        prop_assert_eq!(sculptor.shape().space().dim(), f.space().dim() + inserted);
        // The ends, and where the seam halves what is missing one knot more.
        prop_assert!(inserted <= count + f.degree() + 5);
        for x in probes(sculptor.shape().space()) {
            prop_assert_eq!(sculptor.shape().at(&x)?, f.at(&x)?);
        }
        prop_assert_eq!(sculptor.undo(), inserted > 0);
        prop_assert_eq!(sculptor.shape(), &f);
    }

    /// The part of the stiffness matrix under the window, and hats integrated without their definition.
    #[test]
    fn the_stiffness_of_a_window_is_a_part_of_the_whole(
        space in space(SMALL), at in any::<Index>(), force in any::<Index>(), share in share(), material in material(),
    ) {
        let (at, x) = (place(&space, &at), place(&space, &force));
        let breadth = share.reach(&space).breadth(&space, &at)?;
        let Ok(moving) = breadth.coeffs(&space) else { return Ok(()) };
        let stiffness = Stiffness::new(&space, &material, &breadth)?;
        let hats = hats(&space);
        let load = hats.gram(&space, 0, 0)?.pull_back(&hats.basis(&x)?).to_dense(space.dim());
        prop_assert_eq!(&stiffness.hat_load(&x)?.to_dense(space.dim()), &load);
        let dense = |map: &LinearMap<Q>| {
            let unit = |i: usize| (0..space.dim()).map(|j| Q::int(i64::from(i == j))).collect::<Vec<_>>();
            (0..space.dim()).map(|i| map.apply(&unit(i))).collect::<Result<Vec<_>, _>>()
        };
        prop_assert_eq!(dense(stiffness.forcing())?, dense(&hats.gram(&space, 0, 0)?)?);
        let response = stiffness.response(&stiffness.hat_load(&x)?)?;
        prop_assert_eq!(&response, &stiffness.solved(&load)?);
        let answered = material.matrix(&space)?.apply(&response)?;
        for i in 0..space.dim() {
            let fits = if moving.contains(&i) { answered[i] == load[i] } else { response[i] == Q::int(0) };
            prop_assert!(fits);
        }
    }
}

/// The continuous functions that are linear between breaks.
fn hats(space: &SplineSpace<Q>) -> SplineSpace<Q> {
    let mut breaks: Vec<Q> = space.breaks().into_iter().map(|(knot, _)| knot).collect();
    let (a, b) = space.domain();
    if !space.is_periodic() {
        return SplineSpace::clamped(1, breaks).expect("breaks");
    }
    breaks.pop();
    SplineSpace::periodic(1, breaks, b.clone() - a).expect("breaks")
}

/// Every window of every ring of few coefficients.
#[test]
fn windows_across_the_seam_have_all_their_spans() {
    let material = Material::of_orders([1, 2, 3].map(Q::int)).expect("a material");
    for (degree, count) in (0..=3).flat_map(|degree| (1..=8).map(move |count| (degree, count))) {
        let space = SplineSpace::uniform_periodic(degree, count, Q::int(0), Q::int(1)).expect("a ring");
        let whole = material.matrix(&space).expect("a matrix");
        for range in (0..count).flat_map(|i| (1..=3.min(count)).map(move |length| i..i + length)) {
            let stiffness = Stiffness::new(&space, &material, &Breadth::Range(range)).expect("a stiffness");
            let load = stiffness.hat_load(&Q::frac(1, 3)).expect("inside");
            let answered = whole.apply(&stiffness.response(&load).expect("an answer")).expect("as many");
            let load = load.to_dense(count);
            assert!(stiffness.moving().iter().all(|i| answered[*i] == load[*i]));
        }
    }
}

#[test]
fn what_is_grabbed_again_is_answered_alike() {
    let space = SplineSpace::uniform(3, 30, 0.0, 1.0).expect("a space");
    let rod = Function::constant(space, 0.0).expect("a rod");
    let materials = [0.01, 0.5].map(|bending| Material::new(1.0, bending).expect("a material"));
    let mut sculptor =
        Sculptor::new(rod.clone(), materials[0].clone()).with_reach([Reach::Nearest(7)]).expect("one");
    for (k, at) in [0.3, 0.31, 0.9, 0.3, 0.3, 0.3, 0.5, 0.3, 0.3].into_iter().enumerate() {
        let (material, spread) = (&materials[k / 2 % 2], [Spread::Hat, Spread::Point][k % 2]);
        sculptor.set_materials([material.clone()]).expect("one");
        sculptor.set_spread(spread);
        let fresh =
            Elastic::of(&rod, material, &[Breadth::Around(at, 7)]).expect("a body").with_spread(spread);
        assert_eq!(sculptor.grab(&at).expect("a hold"), &fresh.pull(&rod, &at).expect("a hold"));
    }
}
