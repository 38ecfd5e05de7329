//! Points of a curve moved by control points: one, two, a new one at its own node, one that is confined to an interval, and
//! one made of a point of the control polygon; a patch of a surface moved by one and by four.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use support::{Outcome, Plane, Point, after, before, pair, polygon, target, write};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path};
use symspline::{Direction, Drag, Error, LegPoint, ShapeError, SplineSpace, confined};

fn main() -> Outcome<()> {
    let curve = wave()?;
    let figure = Figure::new(1000.0)
        .title("Points moved by control points")
        .panel(increments(&curve)?)
        .panel(off_the_node(&curve)?)
        .panel(two(&curve)?);
    write(&figure, &target("pulls"))?;
    let figure = Figure::new(1000.0)
        .title("More control points first")
        .panel(cusp()?)
        .panel(between(&curve)?)
        .panel(on_a_leg(&curve)?);
    write(&figure, &target("pulls_refined"))
}

/// A cubic with uneven knots: nodes 3 and 4 are 0.35 and 0.52.
fn wave() -> Outcome<Plane> {
    let space = SplineSpace::clamped(3, [0.0, 0.2, 0.35, 0.5, 0.71, 0.878, 1.0])?;
    let heights = [0.0, 0.35, 0.1, 0.0, 0.25, 0.3, 0.0, 0.1, 0.3];
    let points = (0..9).map(|i| vector![0.125 * f64::from(i), heights[i as usize]]);
    Ok(Plane::new(space, points.collect())?)
}

fn up(by: f64) -> [Point; 1] {
    [vector![0.0, by]]
}

/// One control point, again and again by one step: the way to it is looked up once.
fn increments(curve: &Plane) -> Outcome<Panel> {
    let drag = Drag::by_one(curve, &0.6, 4)?;
    let mut panel = before("One control point, three steps; the point is at u = 0.6", curve)?;
    let mut pulled = curve.clone();
    for (step, color) in [(1, Color::BLUE), (2, Color::ORANGE), (3, Color::VERMILLION)] {
        drag.apply(&mut pulled, &up(0.06))?;
        panel = after(panel, &pulled, 0.6, color, &format!("step {step}"))?;
    }
    Ok(panel)
}

/// Between two nodes the nearest control point moves the curve most beside the point; a knot puts a node there.
fn off_the_node(curve: &Plane) -> Outcome<Panel> {
    let x = 0.43;
    let panel = before("u = 0.43 between two nodes", curve)?;
    let nearest = Drag::by_nearest(curve, &x)?.applied(curve, &up(0.15))?;
    let panel = after(panel, &nearest, x, Color::BLUE, "by the nearest control point")?;
    let knot = curve.space().node_placing_knot(&x)?.ok_or("a node already")?;
    let finer = curve.inserted(&[knot])?;
    println!("a knot at {knot:.4} makes {x} node {}", finer.space().nearest_node(&x)?);
    let placed = Drag::by_nearest(&finer, &x)?.applied(&finer, &up(0.15))?;
    after(panel, &placed, x, Color::VERMILLION, "by a new one with its node there")
}

/// Two control points, evenly and not.
fn two(curve: &Plane) -> Outcome<Panel> {
    let x = 0.43;
    let mut panel = before("u = 0.43 moved by two control points", curve)?;
    for (gamma, color) in [(None, Color::BLUE), (Some(0.8), Color::VERMILLION)] {
        let drag = Drag::by_neighbours(curve, &x, gamma.as_ref())?;
        let name = gamma.map_or("γ by the nodes".to_owned(), |gamma| format!("γ = {gamma}"));
        panel = after(panel, &drag.applied(curve, &up(0.15))?, x, color, &name)?;
    }
    Ok(panel)
}

/// Where the knot is there already, one more would let the curve have a corner: the library refuses.
fn cusp() -> Outcome<Panel> {
    let space = SplineSpace::clamped(2, [0.0, 0.25, 0.5, 0.75, 1.0])?;
    let heights = [0.0, 0.25, 0.05, 0.05, 0.25, 0.0];
    let points = (0..6).map(|i| vector![0.2 * f64::from(i), heights[i as usize]]).collect();
    let curve = Plane::new(space, points)?;
    match curve.space().node_placing_knot(&0.5) {
        Err(Error::Shape(ShapeError::KnotThere { knot })) => println!("refused: {knot} is a knot already"),
        other => return Err(format!("expected a refusal, found {other:?}").into()),
    }
    let finer = curve.inserted(&[0.5])?;
    let pulled = Drag::by_one(&finer, &0.5, 3)?.applied(&finer, &up(0.15))?;
    let panel = before("Parabolas: why a knot is not inserted twice", &curve)?;
    after(panel, &pulled, 0.5, Color::VERMILLION, "inserted all the same")
}

/// A pull that changes nothing outside an interval.
fn between(curve: &Plane) -> Outcome<Panel> {
    let (start, x, end) = (0.45, 0.6, 0.75);
    let (finer, k) = confined(curve, Direction::U, &x, (&start, &end))?;
    let pulled = Drag::by_one(&finer, &x, k)?.applied(&finer, &up(0.1))?;
    let panel = before("Confined to an interval", curve)?;
    let free = Drag::by_nearest(curve, &x)?.applied(curve, &up(0.1))?;
    let panel = after(panel, &free, x, Color::BLUE, "not confined")?;
    let panel = after(panel, &pulled, x, Color::VERMILLION, "confined to the squares")?;
    Ok(panel.markers(
        [pair(curve.at(&start)?), pair(curve.at(&end)?)],
        Marker::Square,
        Style::line(Color::GREEN),
    ))
}

/// A point of the polygon made a control point, and moved.
fn on_a_leg(curve: &Plane) -> Outcome<Panel> {
    let leg = LegPoint::new(curve, Direction::U, 4, 0.5)?;
    let (finer, k) = leg.inserted(curve)?;
    let picked = finer.coeffs()[k];
    let mut moved = finer;
    moved.replace_coeffs(vec![(k, picked + vector![0.0, 0.15])])?;
    let panel = before("The middle of a leg made a control point", curve)?;
    let panel = polygon(panel, &moved, Color::VERMILLION)?;
    let panel = panel.path(curve_path(&moved, 1e-4)?, Style::line(Color::VERMILLION).width(1.8));
    let panel = panel.label("after it moved");
    Ok(panel.markers([pair(picked)], Marker::Square, Style::line(Color::GREEN)))
}
