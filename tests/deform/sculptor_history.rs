//! Sculptors against a model that keeps whole shapes, and errors that change nothing.

use crate::rational_strategies::nurbs;
use crate::sculptor::{Share, eighths, is_loose, material, reaches, share};
use crate::strategies::{ANY, Kind, cases, curve, number, probes, surface};
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use proptest::test_runner::TestCaseResult;
use symspline::{
    Breadth, Curve, DeformError, Elastic, Error, Forces, Interval, Material, Q, Rational, Reach, Restorable,
    Scalar, Sculptor, SplineSpace, Surface,
};

const FLAT: Kind = ANY.of_degree(0, 3).few(2);

/// What a user may do.
#[derive(Clone, Debug)]
enum Step {
    Grab([Index; 2], [Share; 2]),
    Drag(Q),
    Push(Q),
    Commit,
    Cancel,
    Undo,
    Redo,
    Refine([Index; 2], i64, usize),
    Forces([Index; 2], Q),
    Move(Index, Q),
}

fn steps(count: usize) -> impl Strategy<Value = Vec<Step>> {
    let places = || [any::<Index>(), any::<Index>()];
    let step = prop_oneof![
        4 => (places(), [share(), share()]).prop_map(|(at, shares)| Step::Grab(at, shares)),
        4 => number().prop_map(Step::Drag),
        2 => number().prop_map(Step::Push),
        3 => Just(Step::Commit),
        1 => Just(Step::Cancel),
        4 => Just(Step::Undo),
        3 => Just(Step::Redo),
        1 => (places(), 2_i64..=6, 1_usize..5).prop_map(|(at, distance, count)| Step::Refine(at, distance, count)),
        1 => (places(), number()).prop_map(|(at, by)| Step::Forces(at, by)),
        1 => (any::<Index>(), number()).prop_map(|(i, by)| Step::Move(i, by)),
    ];
    vec(step, count)
}

/// A sculptor that copies the shape before every edit.
struct Model<S: Restorable<Q>> {
    shape: S,
    done: Vec<S>,
    undone: Vec<S>,
    held: Option<(S, S::Parameter, Elastic<Q>)>,
}

impl<S: Restorable<Q> + PartialEq> Model<S> {
    fn commit(&mut self) -> bool {
        match self.held.take().filter(|(before, ..)| *before != self.shape) {
            Some((before, ..)) => self.edited(before),
            None => return false,
        }
        true
    }

    fn edited(&mut self, before: S) {
        self.done.push(before);
        self.undone.clear();
    }

    fn cancel(&mut self) -> bool {
        self.held.take().map(|(before, ..)| self.shape = before).is_some()
    }

    fn undo(&mut self) -> bool {
        if self.cancel() {
            return true;
        }
        let Some(before) = self.done.pop() else { return false };
        self.undone.push(std::mem::replace(&mut self.shape, before));
        true
    }

    fn redo(&mut self) -> bool {
        let Some(after) = self.undone.pop_if(|_| self.held.is_none()) else { return false };
        self.done.push(std::mem::replace(&mut self.shape, after));
        true
    }
}

fn follows_the_model<S: Restorable<Q> + PartialEq>(
    shape: &S,
    material: &Material<Q>,
    steps: Vec<Step>,
    place: impl Fn(&S, &[Index; 2]) -> S::Parameter,
    by: impl Fn(&Q) -> S::Point,
) -> TestCaseResult {
    let mut sculptor = Sculptor::new(shape.clone(), material.clone()).with_limit(1000);
    let mut model = Model { shape: shape.clone(), done: vec![], undone: vec![], held: None };
    let one = Q::int(1);
    for step in steps {
        match step {
            Step::Grab(at, shares) => {
                let at = place(&model.shape, &at);
                let reach = reaches(&model.shape, &shares);
                let mut breadths = Vec::new();
                for (direction, reach) in S::DIRECTIONS.iter().zip(&reach) {
                    breadths.push(
                        reach.breadth(model.shape.space_along(*direction), S::coordinate(&at, *direction))?,
                    );
                }
                let body = Elastic::of(&model.shape, material, &breadths);
                let pull = body.and_then(|body| Ok((body.pull(&model.shape, &at)?, body)));
                match (pull, sculptor.grab_with(&at, reach)) {
                    (Ok((_, body)), Ok(_)) => {
                        model.commit();
                        model.held = Some((model.shape.clone(), at, body));
                    }
                    (Err(expected), Err(found)) => prop_assert!(is_loose(&found) && found == expected),
                    (expected, found) => prop_assert!(false, "{:?} {:?}", expected.is_ok(), found.is_ok()),
                }
            }
            Step::Drag(x) => match &model.held {
                None => prop_assert_eq!(sculptor.drag_to(&by(&x)), Err(DeformError::NothingHeld.into())),
                Some((before, at, body)) => {
                    model.shape = before.clone();
                    let target = by(&x);
                    let force = body.pull(before, at)?.move_to(&mut model.shape, &target)?;
                    prop_assert_eq!(sculptor.drag_to(&target)?, force);
                }
            },
            Step::Push(x) => match &model.held {
                None => prop_assert_eq!(sculptor.push(&by(&x)), Err(DeformError::NothingHeld.into())),
                Some((before, at, body)) => {
                    model.shape = before.clone();
                    body.pull(before, at)?.push(&mut model.shape, &by(&x))?;
                    sculptor.push(&by(&x))?;
                }
            },
            Step::Commit => prop_assert_eq!(sculptor.commit(), model.commit()),
            Step::Cancel => prop_assert_eq!(sculptor.cancel(), model.cancel()),
            Step::Undo => prop_assert_eq!(sculptor.undo(), model.undo()),
            Step::Redo => prop_assert_eq!(sculptor.redo(), model.redo()),
            Step::Refine(at, distance, count) => {
                let at = place(&model.shape, &at);
                let spaces = S::DIRECTIONS.iter().map(|d| model.shape.space_along(*d));
                let distances: Vec<Q> = spaces.map(|space| eighths(space, distance)).collect();
                if sculptor.refine(&at, &distances, &vec![count; distances.len()])? > 0 {
                    model.commit();
                    let before = std::mem::replace(&mut model.shape, sculptor.shape().clone());
                    let here = |shape: &S| shape.derivative_of(&at, S::VALUE);
                    prop_assert_eq!(here(&before)?, here(&model.shape)?);
                    model.edited(before);
                }
            }
            Step::Forces(at, x) => {
                let at = place(&model.shape, &at);
                let Ok(body) = sculptor.elastic(&at) else { continue };
                let mut forces = Forces::new(&body, &model.shape)?;
                forces.at(&at, by(&x))?.at(&at, by(&one))?;
                sculptor.push_all(&forces)?;
                model.commit();
                let before = model.shape.clone();
                forces.push(&mut model.shape)?;
                model.edited(before);
            }
            Step::Move(i, x) => {
                let i = i.index(model.shape.control_count());
                let moves = [(i, by(&x)), (i, by(&one))];
                sculptor.move_points(&moves)?;
                model.commit();
                let before = model.shape.clone();
                model.shape.move_points(&moves)?;
                model.edited(before);
            }
        }
        prop_assert_eq!(sculptor.shape(), &model.shape);
        prop_assert_eq!(sculptor.edits(), (model.done.len(), model.undone.len()));
        prop_assert_eq!(sculptor.pull().is_some(), model.held.is_some());
    }
    while model.undo() {
        prop_assert!(sculptor.undo());
        prop_assert_eq!(sculptor.shape(), &model.shape);
    }
    prop_assert!(!sculptor.undo());
    prop_assert_eq!(sculptor.shape(), shape);
    Ok(())
}

fn of_space(space: &SplineSpace<Q>, at: &Index) -> Q {
    at.get(&probes(space)).clone()
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn a_curve_is_sculpted_as_by_one_who_copies_it(
        f in curve::<2>(ANY.of_degree(0, 3)), material in material(), steps in steps(16),
    ) {
        let by = |x: &Q| vector![x.clone(), Q::int(1) - x];
        follows_the_model(&f, &material, steps, |f, at| of_space(f.space(), &at[0]), by)?;
    }

    #[test]
    fn a_rational_curve_is_sculpted_as_by_one_who_copies_it(
        f in nurbs::<2>(FLAT), material in material(), steps in steps(12),
    ) {
        let by = |x: &Q| vector![x.clone(), Q::int(1) - x];
        follows_the_model(&f, &material, steps, |f, at| of_space(f.lifted().space(), &at[0]), by)?;
    }
}

proptest! {
    #![proptest_config(cases(6))]

    #[test]
    fn a_surface_is_sculpted_as_by_one_who_copies_it(
        f in surface::<2>(FLAT.of_degree(0, 2), FLAT.of_degree(0, 2)), material in material(), steps in steps(10),
    ) {
        let place = |f: &Surface<Q, 2>, at: &[Index; 2]| (of_space(f.u(), &at[0]), of_space(f.v(), &at[1]));
        let by = |x: &Q| vector![x.clone(), Q::int(1) - x];
        follows_the_model(&f, &material, steps, place, by)?;
    }
}

type Plane = Curve<f64, 2>;

fn wave(ring: bool) -> Plane {
    let space = if ring {
        SplineSpace::uniform_periodic(3, 24, 0.0, 3.0)
    } else {
        SplineSpace::uniform(3, 21, 0.0, 3.0)
    };
    let points = (0..24)
        .map(|i| vector![0.1 * f64::from(i), if i % 3 == 0 { -0.0 } else { (0.7 * f64::from(i)).sin() }]);
    Curve::new(space.expect("a space"), points.collect()).expect("a curve")
}

/// Knots and control points, bit by bit.
fn bits<S: Restorable<f64, Stored = SVector<f64, 2>>>(shape: &S) -> Vec<u64> {
    let knots = S::DIRECTIONS.iter().flat_map(|d| shape.space_along(*d).knots().iter());
    knots.chain(shape.stored().iter().flat_map(|p| p.iter())).map(|x| x.to_bits()).collect()
}

proptest! {
    #![proptest_config(cases(16))]

    #[test]
    fn undoing_restores_every_bit(
        ring in any::<bool>(),
        steps in vec((0.0..3.0, -2.0..2.0, 3_usize..12, 0.1..0.9), 1..8),
    ) {
        let f = wave(ring);
        let material = Material::new(0.3, 0.1)?.with_hardness(0.01)?;
        let mut sculptor = Sculptor::new(f, material);
        let mut before = Vec::new();
        for (at, by, count, distance) in steps {
            let reach = [Reach::Within(distance)];
            let now = bits(sculptor.shape());
            if sculptor.refine(&at, &[distance], &[count])? > 0 {
                before.push(now);
            }
            let now = bits(sculptor.shape());
            let start = match sculptor.grab_with(&at, reach) {
                Err(error) if is_loose(&error) => continue,
                other => { other?; *sculptor.start().expect("held") }
            };
            sculptor.drag_to(&vector![start[0] + by, start[1] - by])?;
            sculptor.drag_to(&start)?;
            prop_assert_eq!(&bits(sculptor.shape()), &now);
            let target = start + vector![by, 1.0];
            sculptor.drag_to(&target)?;
            prop_assert!((sculptor.shape().at(&at)? - target).norm() <= 1e-13);
            before.push(now);
        }
        sculptor.commit();
        let last = bits(sculptor.shape());
        prop_assert_eq!(sculptor.edits(), (before.len(), 0));
        for bits_before in before.iter().rev() {
            prop_assert!(sculptor.undo());
            prop_assert_eq!(&bits(sculptor.shape()), bits_before);
        }
        while sculptor.redo() {}
        prop_assert_eq!(bits(sculptor.shape()), last);
    }
}

#[test]
fn the_oldest_edits_are_forgotten_first() {
    let material = Material::new(1.0, 1.0).expect("a material");
    let mut sculptor = Sculptor::new(wave(false), material).with_limit(2);
    for height in [1.0, 2.0, 3.0] {
        sculptor.grab(&1.0).expect("a hold");
        sculptor.drag_to(&vector![0.0, height]).expect("a drag");
    }
    sculptor.commit();
    assert_eq!(sculptor.edits(), (2, 0));
    assert!(sculptor.undo() && sculptor.undo() && !sculptor.undo());
    assert!((sculptor.shape().at(&1.0).expect("inside")[1] - 1.0).abs() < 1e-13);
    let mut none = sculptor.with_limit(0);
    assert_eq!(none.edits(), (0, 0));
    none.move_points(&[(3, vector![1.0, 1.0])]).expect("a move");
    assert!(!none.undo() && !none.redo());
}

#[test]
fn what_cannot_be_done_changes_nothing() {
    let material = Material::new(1.0, 1.0).expect("a material");
    let mut sculptor = Sculptor::new(wave(false), material);
    let mut held = sculptor.clone();
    held.grab(&1.0).expect("a hold");
    held.drag_to(&vector![1.0, 2.0]).expect("a drag");
    let same = |sculptor: &mut Sculptor<f64, Plane>, tried: &dyn Fn(&mut Sculptor<f64, Plane>) -> Error| {
        let before = (bits(sculptor.shape()), sculptor.edits(), sculptor.pull().cloned());
        let error = tried(sculptor);
        assert_eq!(before, (bits(sculptor.shape()), sculptor.edits(), sculptor.pull().cloned()));
        error
    };
    for sculptor in [&mut sculptor, &mut held] {
        for at in [-1.0, 3.1, f64::NAN, f64::INFINITY] {
            let error = same(sculptor, &|s| s.grab(&at).map(|_| ()).unwrap_err());
            assert!(matches!(error, Error::OutsideDomain { .. }));
            let error = same(sculptor, &|s| s.refine(&at, &[0.1], &[5]).unwrap_err());
            assert!(matches!(error, Error::OutsideDomain { .. }));
        }
        for reach in [
            Reach::Nearest(0),
            Reach::Within(0.0),
            Reach::Within(-1.0),
            Reach::Within(f64::NAN),
            Reach::Fixed(Breadth::Listed(vec![])),
            Reach::Fixed(Breadth::BetweenEnds(12)),
        ] {
            let error = same(sculptor, &|s| s.grab_with(&1.0, [reach.clone()]).map(|_| ()).unwrap_err());
            assert!(matches!(error, Error::Deform(DeformError::NothingMoves)));
        }
        let far = [Reach::Fixed(Breadth::Range(18..20))];
        let error = same(sculptor, &|s| s.grab_with(&0.1, far.clone()).map(|_| ()).unwrap_err());
        assert!(matches!(error, Error::Deform(DeformError::NoHold { .. })));
        let whole = [Breadth::Whole];
        let error = same(sculptor, &|s| s.grab_with(&1.0, whole.clone()).map(|_| ()).unwrap_err());
        assert!(matches!(error, Error::Deform(DeformError::NullSpace { .. })));
        let error = same(sculptor, &|s| s.grab_with(&1.0, [Reach::All, Reach::All]).map(|_| ()).unwrap_err());
        assert_eq!(error, Error::CoefficientCount { expected: 1, found: 2 });
        for distance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = same(sculptor, &|s| s.refine(&1.0, &[distance], &[30]).unwrap_err());
            assert!(matches!(error, Error::EmptyDomain { .. }));
        }
        for count in [usize::MAX, 1 << 40] {
            let error = same(sculptor, &|s| s.refine(&1.0, &[0.5], &[count]).unwrap_err());
            assert!(matches!(error, Error::TooLarge { .. }));
        }
        same(sculptor, &|s| s.refine(&1.0, &[1e-15], &[30]).unwrap_err());
        let moves = [(3, vector![1.0, 1.0]), (24, vector![1.0, 1.0])];
        let error = same(sculptor, &|s| s.move_points(&moves).unwrap_err());
        assert!(matches!(error, Error::IndexOutOfRange { .. }));
    }
    let error = same(&mut sculptor, &|s| s.drag_to(&vector![0.0, 0.0]).unwrap_err());
    assert_eq!(error, DeformError::NothingHeld.into());
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = same(&mut held, &|s| s.drag_to(&vector![0.0, wrong]).unwrap_err());
        assert!(matches!(error, Error::NotFinite { .. }));
        let error = same(&mut held, &|s| s.push(&vector![wrong, 0.0]).unwrap_err());
        assert!(matches!(error, Error::NotFinite { .. }));
    }
}

#[test]
fn huge_and_tiny_numbers_give_a_value_or_an_error() {
    for size in [1e300, 1e-300, f64::MAX] {
        let material = Material::new(1.0, 1.0).expect("a material");
        let mut sculptor = Sculptor::new(wave(false), material);
        sculptor.grab(&1.0).expect("a hold");
        let start = bits(sculptor.shape());
        match sculptor.drag_to(&vector![size, -size]) {
            Ok(_) => assert!(sculptor.shape().coeffs().iter().all(|p| p.iter().all(|x| x.is_finite()))),
            Err(error) => {
                assert!(matches!(error, Error::NotFinite { .. }));
                assert_eq!(bits(sculptor.shape()), start);
            }
        }
        sculptor.undo();
        assert_eq!(bits(sculptor.shape()), start);
        let Ok(material) = Material::new(size, size) else { continue };
        let mut hard = Sculptor::new(wave(true), material.with_hardness(size).expect("a material"));
        if hard.grab(&1.0).is_ok() && hard.drag_to(&vector![1.0, 1.0]).is_ok() {
            assert!((hard.shape().at(&1.0).expect("inside") - vector![1.0, 1.0]).norm() < 1e-9);
        }
    }
    let nothing = Material::new(0.0, 0.0).expect("a material");
    let error = Sculptor::new(wave(false), nothing).grab(&1.0).map(|_| ()).unwrap_err();
    assert!(matches!(error, Error::Deform(DeformError::NullSpace { order: None, .. })));
}

#[test]
fn a_rational_circle_comes_back_bit_by_bit() {
    let half = f64::sqrt(0.5);
    let points = vec![vector![1.0, -0.0], vector![1.0, 1.0], vector![-0.0, 1.0]];
    let space = SplineSpace::bezier(2, 0.0, 1.0).expect("a space");
    let arc = Rational::<Interval, f64, _>::new(space, points, vec![1.0, half, 1.0]).expect("an arc");
    let stored = |sculptor: &Sculptor<f64, Rational<Interval, f64, SVector<f64, 2>>>| {
        let bits = |c: &symspline::Weighted<f64, SVector<f64, 2>>| {
            [c.point[0], c.point[1], c.weight].map(f64::to_bits)
        };
        sculptor.shape().stored().iter().map(bits).collect::<Vec<_>>()
    };
    let mut sculptor = Sculptor::new(arc, Material::new(1.0, 1.0).expect("a material"));
    let first = stored(&sculptor);
    assert_eq!(sculptor.refine(&0.3, &[0.25], &[3]), Ok(6));
    let refined = stored(&sculptor);
    sculptor.grab_with(&0.3, [Reach::Within(0.25)]).expect("a hold");
    sculptor.drag_to(&vector![1.3, 0.4]).expect("a drag");
    assert!((sculptor.shape().at(&0.3).expect("inside") - vector![1.3, 0.4]).norm() < 1e-14);
    assert!(sculptor.commit() && sculptor.undo());
    assert_eq!(stored(&sculptor), refined);
    assert!(sculptor.undo());
    assert_eq!(stored(&sculptor), first);
    assert!(sculptor.redo());
    assert_eq!(stored(&sculptor), refined);
}
