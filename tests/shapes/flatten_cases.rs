//! Flattening: single cases and refusals.

use nalgebra::vector;
use symspline::{Curve, Error, Flatten, Onto, Part, Q, Scalar, Side, SplineSpace, Surface};

/// A flat part elsewhere does not count: refinement goes on until there is one in the part.
#[test]
fn what_is_flat_already_does_not_end_the_refinement() -> symspline::Result<()> {
    let space = SplineSpace::clamped(2, (0..9).map(Q::int))?;
    let height = |i: i64| if i < 4 { 0 } else { 2 + i % 3 };
    let curve = Curve::new(space, (0..10).map(|i| vector![Q::int(i), Q::int(height(i))]).collect())?;
    let zero = || vector![Q::int(0), Q::int(0)];
    let tool = Flatten::new(Onto::line(zero(), vector![Q::int(1), Q::int(0)])?);
    let start = vec![(Q::int(0), Q::int(2))];
    let local = tool.clone().local_to((Q::int(5), Q::int(7)));
    assert_eq!(local.apply(&curve)?.flat, vec![start.clone()]);
    let done = local.until_flat(100).apply(&curve)?;
    assert_eq!(done.flat[0], start);
    let inside = |part: &Vec<(Q, Q)>| Q::int(5) <= part[0].0 && part[0].1 <= Q::int(7);
    assert!(done.flat.len() > 1 && done.flat[1..].iter().all(inside));
    // Where all is flat and nothing is to be projected nothing is to be done.
    let idle = tool.clone().local_to((Q::int(0), Q::int(2))).on_side(Side::Positive).until_flat(0);
    assert_eq!(idle.apply(&curve)?.projected, Vec::<usize>::new());
    // A side without enough control points is refined, though another part is flat.
    let [above, below] = [Side::Positive, Side::Negative].map(|side| tool.clone().on_side(side));
    let bump = |i: i64| if i == 6 { 1 } else { -i64::from(i > 3) };
    let space = SplineSpace::clamped(2, (0..9).map(Q::int))?;
    let bumpy = Curve::new(space, (0..10).map(|i| vector![Q::int(i), Q::int(bump(i))]).collect())?;
    let once = above.apply(&bumpy)?;
    assert_eq!((once.projected, once.flat), (vec![6], vec![start]));
    let done = above.until_flat(200).apply(&bumpy)?;
    assert!(done.flat.len() > 1 && done.projected.len() > 2);
    assert!(below.apply(&bumpy)?.flat.len() > 1);
    Ok(())
}

/// Rules that make no sense are refused, not met by nothing.
#[test]
fn rules_of_no_sense_are_refused() -> symspline::Result<()> {
    let curve = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 1.0], vector![1.0, 2.0]])?;
    let (zero, bad) = (|| vector![0.0, 0.0], || vector![0.0, f64::NAN]);
    let tool = || Flatten::new(Onto::line(zero(), vector![1.0, 0.0]).expect("a line"));
    assert!(matches!(Onto::line(bad(), vector![1.0, 0.0]), Err(Error::NotFinite { .. })));
    for rule in [
        tool().within_segment(zero(), bad()),
        tool().within_polygon(vec![zero(), bad(), zero()]),
        tool().within_ball(bad(), 1.0),
        tool().in_front_of(zero(), bad()),
        tool().in_front_of(bad(), vector![1.0, 1.0]),
    ] {
        assert!(matches!(rule.apply(&curve), Err(Error::NotFinite { .. })), "{rule:?}");
    }
    for radius in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(tool().within_ball(zero(), radius).apply(&curve), Err(Error::BadTolerance { .. })));
    }
    let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    let sheet = Surface::new(line.clone(), line, vec![vector![0.0, 0.0, 1.0]; 4])?;
    let flat = Flatten::new(Onto::plane(vector![0.0, 0.0, 0.0], vector![0.0, 0.0, 1.0])?);
    let over = |corners: &[[f64; 2]]| flat.clone().whole(Part::Polygon(corners.to_vec())).apply(&sheet);
    assert!(matches!(over(&[[0.0, 0.0], [1.0, 1.0]]), Err(Error::TooFewPoints { .. })));
    assert!(matches!(over(&[[0.0, 0.0], [1.0, 1.0], [f64::NAN, 0.0]]), Err(Error::NotFinite { .. })));
    for radius in [-1.0, f64::NAN] {
        assert!(flat.clone().whole(Part::Disc { centre: [0.5, 0.5], radius }).apply(&sheet).is_err());
    }
    Ok(())
}
