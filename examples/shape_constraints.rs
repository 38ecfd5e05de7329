//! Curves dragged by points, tangents and curvatures while other things stay: always the least movement of control points.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use support::{Outcome, Plane, after, before, target, write};
use symspline::plot::{Color, Figure, Panel};
use symspline::{
    Analyse, Constraints, CurvatureHandle, Error, Relief, ShapeError, SplineSpace, with_tangent,
};

/// Where the constraints are.
const X: f64 = 0.5;

fn main() -> Outcome<()> {
    let curve = arch()?;
    let figure = Figure::new(1000.0)
        .title("One, two and three constraints")
        .panel(one(&curve)?)
        .panel(two(&curve)?)
        .panel(three(&curve)?)
        .panel(curvature(&curve)?);
    write(&figure, &target("constraints"))?;
    let figure = Figure::new(1000.0)
        .title("Which control points may move")
        .panel(free(&curve)?)
        .panel(tension(&curve)?)
        .panel(relieved()?);
    write(&figure, &target("constraints_free"))
}

/// The curve of the example: eight control points, five spans.
fn arch() -> Outcome<Plane> {
    let space = SplineSpace::clamped(3, [0.0, 0.2, 0.4, 0.6, 0.8, 1.0])?;
    let points = [
        (0.0, 0.0),
        (0.06, 0.2),
        (0.2, 0.34),
        (0.42, 0.36),
        (0.6, 0.3),
        (0.78, 0.26),
        (0.92, 0.2),
        (1.0, 0.0),
    ];
    Ok(Plane::new(space, points.map(|(x, y)| vector![x, y]).to_vec())?)
}

/// Position alone, and the tangent alone.
fn one(curve: &Plane) -> Outcome<Panel> {
    let mut panel = before("One constraint: the point, or the tangent whatever the point does", curve)?;
    let point = Constraints::on(curve).point(&X)?.prepare()?;
    let tangent = Constraints::on(curve).derivative(&X, 1)?.prepare()?;
    let point = point.dragged(curve, &[vector![0.0, 0.08]])?;
    panel = after(panel, &point, X, Color::BLUE, "point up")?;
    let tangent = tangent.dragged(curve, &[vector![0.0, -1.2]])?;
    after(panel, &tangent, X, Color::VERMILLION, "tangent turned")
}

/// Direction and length of the tangent, the point held.
fn two(curve: &Plane) -> Outcome<Panel> {
    let mut panel = before("Two constraints: the tangent changes, the point stays", curve)?;
    let held = Constraints::on(curve).point(&X)?.derivative(&X, 1)?.prepare()?;
    let still = vector![0.0, 0.0];
    let tangent = curve.derivative_at(&X, 1)?;
    let turned = held.dragged(curve, &[still, vector![0.0, 1.2]])?;
    panel = after(panel, &turned, X, Color::BLUE, "turned")?;
    let longer = held.dragged(curve, &[still, tangent * 1.5])?;
    panel = after(panel, &longer, X, Color::VERMILLION, "longer")?;
    // The direction alone, its length left to the least movement.
    let free = with_tangent(curve, &X, &vector![1.0, 1.0])?;
    after(panel, &free, X, Color::GREEN, "direction (1, 1), any length")
}

/// The tangent while point and second derivative stay; the point while the curvature stays.
fn three(curve: &Plane) -> Outcome<Panel> {
    let mut panel = before("Three constraints", curve)?;
    let held = Constraints::on(curve).point(&X)?.derivative(&X, 1)?.derivative(&X, 2)?.prepare()?;
    let still = vector![0.0, 0.0];
    let turned = held.dragged(curve, &[still, vector![0.0, 1.2], still])?;
    panel = after(panel, &turned, X, Color::BLUE, "tangent, second derivative held")?;
    let up = held.dragged(curve, &[vector![0.0, 0.08], still, still])?;
    println!(
        "curvature {:.6} before, {:.6} after the point moved",
        curve.curvature_at(&X)?,
        up.curvature_at(&X)?
    );
    after(panel, &up, X, Color::VERMILLION, "point, curvature held")
}

/// The second derivative across and along the tangent.
fn curvature(curve: &Plane) -> Outcome<Panel> {
    let mut panel =
        before("Curvature: doubled, turned round, and kept while the second derivative slides", curve)?;
    let handle = CurvatureHandle::prepare(curve, &X)?;
    for (factor, color) in [(2.0, Color::BLUE), (-1.0, Color::ORANGE)] {
        let mut bent = curve.clone();
        handle.scale(&mut bent, &factor)?;
        panel = after(panel, &bent, X, color, &format!("κ times {factor}"))?;
    }
    let mut slid = curve.clone();
    handle.slide(&mut slid, &6.0)?;
    println!("curvature {:.6} after sliding", slid.curvature_at(&X)?);
    after(panel, &slid, X, Color::VERMILLION, "slid, κ kept")
}

/// The same change with four, two and one control points.
fn free(curve: &Plane) -> Outcome<Panel> {
    let mut panel = before("One point, moved by four control points, by two and by one", curve)?;
    let choices =
        [(vec![2, 3, 4, 5], Color::BLUE), (vec![3, 4], Color::ORANGE), (vec![3], Color::VERMILLION)];
    for (free, color) in choices {
        let held = Constraints::on(curve).point(&X)?.freeing(&free)?.prepare()?;
        let shares: Vec<String> = held.matrix().rows().map(|row| format!("{:.4}", row[0])).collect();
        println!("control points {free:?} move by {} of the change", shares.join(", "));
        let moved = held.dragged(curve, &[vector![0.04, -0.08]])?;
        panel = after(panel, &moved, X, color, &format!("{} free", free.len()))?;
    }
    Ok(panel)
}

/// A longer tangent makes the curve tight; with one control point it moves away; too many wishes are refused.
fn tension(curve: &Plane) -> Outcome<Panel> {
    let x = 0.556;
    let mut panel = before("A tangent made longer and shorter at u = 0.556", curve)?;
    let tangent = curve.derivative_at(&x, 1)?;
    let three = Constraints::on(curve).derivative(&x, 1)?.freeing(&[3, 4, 5])?.prepare()?;
    panel = after(panel, &three.dragged(curve, &[tangent * 0.8])?, x, Color::BLUE, "longer, three free")?;
    let single = Constraints::on(curve).derivative(&x, 1)?.freeing(&[4])?.prepare()?;
    panel = after(panel, &single.dragged(curve, &[tangent * 0.4])?, x, Color::ORANGE, "longer, one free")?;
    let both = Constraints::on(curve).point(&x)?.derivative(&x, 1)?;
    let pair = both.clone().freeing(&[3, 4])?.prepare()?;
    let shorter = pair.dragged(curve, &[vector![0.0, 0.0], tangent * -0.5])?;
    panel = after(panel, &shorter, x, Color::VERMILLION, "shorter, point held, two free")?;
    match both.freeing(&[4])?.prepare() {
        Err(Error::Shape(refused @ ShapeError::Overdetermined { .. })) => println!("refused: {refused}"),
        other => return Err(format!("expected a refusal, found {other:?}").into()),
    }
    Ok(panel)
}

/// Seven points on one cubic span: knots make room.
fn relieved() -> Outcome<Panel> {
    let space = SplineSpace::bezier(3, 0.0, 1.0)?;
    let points = [(0.0, 0.0), (0.3, 0.3), (0.7, 0.3), (1.0, 0.0)].map(|(x, y)| vector![x, y]);
    let curve = Plane::new(space, points.to_vec())?;
    let panel = before("Seven points of one cubic: knots are inserted until they can move", &curve)?;
    let places: Vec<f64> = (0..7).map(|i| f64::from(i) / 6.0).collect();
    let wanted = places.iter().try_fold(Constraints::on(&curve), |wanted, x| wanted.point(x))?;
    let (finer, held) = wanted.relieved(Relief::Knots)?;
    println!("{} control points for 7 points", finer.coeffs().len());
    let wave: Vec<_> = (0..7).map(|i| vector![0.0, if i % 2 == 0 { 0.0 } else { 0.06 }]).collect();
    let moved = held.dragged(&finer, &wave)?;
    let panel = after(panel, &moved, X, Color::VERMILLION, "every second point up")?;
    let marks = places.iter().map(|x| Ok(support::pair(moved.at(x)?))).collect::<Outcome<Vec<_>>>()?;
    let style = symspline::plot::Style::line(Color::VERMILLION);
    Ok(panel.markers(marks, symspline::plot::Marker::Circle, style))
}
