//! Surfaces pulled by one control point and by four, and shaped by constraints on points and tangents.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::{SVector, vector};
use support::{Outcome, net, seen, shaded, target, write};
use symspline::plot::{Color, Figure, Marker, Panel, Style};
use symspline::{Constraints, Drag, Scalar, SplineSpace, Surface};

type Sheet = Surface<f64, 3>;

fn main() -> Outcome<()> {
    let sheet = sheet()?;
    pulls(&sheet)?;
    points(&sheet)?;
    tangents(&sheet)
}

/// A bicubic sheet over the unit square, eight by eight control points.
fn sheet() -> Outcome<Sheet> {
    let space = SplineSpace::uniform(3, 5, 0.0, 1.0)?;
    let nodes = space.greville();
    let row = |u: &f64| nodes.iter().map(|v| vector![*u, *v, 0.05 * (6.0 * u).sin()]).collect::<Vec<_>>();
    Ok(Sheet::new(space.clone(), space, nodes.iter().flat_map(row).collect())?)
}

fn panel(title: &str) -> Panel {
    Panel::new().title(title).equal_axes().x_range(-0.05, 1.5).y_range(-0.1, 1.1).height(310.0)
}

/// The surface, with its control net if asked for and a mark on a point.
fn picture(title: &str, surface: &Sheet, with_net: bool, at: &(f64, f64)) -> Outcome<Panel> {
    let mut panel = shaded(panel(title), surface, 40)?;
    if with_net {
        panel = net(panel, surface, Color::VERMILLION);
    }
    let spot = seen(surface.at(&at.0, &at.1)?);
    Ok(panel.markers([spot], Marker::Square, Style::line(Color::GREEN)))
}

fn up(by: f64) -> SVector<f64, 3> {
    vector![0.0, 0.0, by]
}

/// One control point, and four that share the way by their nodes.
fn pulls(sheet: &Sheet) -> Outcome<()> {
    let at = (0.55, 0.55);
    let one = Drag::by_nearest(sheet, &at)?;
    let four = Drag::by_neighbours(sheet, &at, None)?;
    println!("one control point moves by {:.3} of the way", one.rows().map(|row| row[0]).sum::<f64>());
    let shares: Vec<String> = four.rows().map(|row| format!("{:.3}", row[0])).collect();
    println!("four by {}", shares.join(", "));
    let figure = Figure::new(900.0)
        .title("The point at u = v = 0.55 moved up by 0.3")
        .panel(picture("(a) By one control point, the net", &one.applied(sheet, &[up(0.3)])?, true, &at)?)
        .panel(picture("(b) By one control point", &one.applied(sheet, &[up(0.3)])?, false, &at)?)
        .panel(picture("(c) By four, the net", &four.applied(sheet, &[up(0.3)])?, true, &at)?);
    write(&figure, &target("surface_pulls"))
}

/// A point moved by all control points with influence, and by three.
fn points(sheet: &Sheet) -> Outcome<()> {
    let at = (0.5, 0.5);
    let all = Constraints::on(sheet).point(&at)?.prepare()?;
    let few = Constraints::on(sheet).point(&at)?.freeing(&[(2, 3), (3, 3), (5, 3)])?.prepare()?;
    let largest = |drag: &Drag<f64>| drag.rows().map(|row| row[0]).fold(0.0, f64::max);
    println!("{} control points move, by {:.3} at most", all.matrix().indices().len(), largest(all.matrix()));
    println!("{} control points move, by {:.3} at most", few.matrix().indices().len(), largest(few.matrix()));
    let figure = Figure::new(900.0)
        .title("The point in the middle moved up by 0.15, least movement")
        .panel(picture(
            "(a) By all control points with influence",
            &all.dragged(sheet, &[up(0.15)])?,
            true,
            &at,
        )?)
        .panel(picture("(b) By three control points", &few.dragged(sheet, &[up(0.15)])?, true, &at)?);
    write(&figure, &target("surface_points"))
}

/// Tangents made longer, and turned about the normal, the point held.
fn tangents(sheet: &Sheet) -> Outcome<()> {
    let at = (0.5, 0.5);
    let held =
        Constraints::on(sheet).point(&at)?.derivative(&at, (1, 0))?.derivative(&at, (0, 1))?.prepare()?;
    let [point, along_u, along_v] = sheet.tangents_at(&at.0, &at.1)?;
    let still = SVector::zeros();
    let tension = held.dragged(sheet, &[still, along_u * 2.0, along_v * 2.0])?;
    // Both tangents turned by 60 degrees about the normal, which here stands nearly upright.
    let (sin, cos) = 60_f64.to_radians().sin_cos();
    let turned = |t: SVector<f64, 3>| vector![cos * t[0] - sin * t[1], sin * t[0] + cos * t[1], t[2]];
    let mut twisted = sheet.clone();
    held.meet(&mut twisted, &[point, turned(along_u), turned(along_v)])?;
    let [after, new_u, _] = twisted.tangents_at(&at.0, &at.1)?;
    println!(
        "the point moved by {:.1e}, the tangent is off by {:.1e}",
        (after - point).norm(),
        (new_u - turned(along_u)).norm()
    );
    println!("in rational numbers by {}", exactly(sheet)?);
    let figure = Figure::new(900.0)
        .title("Tangents at the middle changed, the point held")
        .panel(picture("(a) Three times as long", &tension, true, &at)?)
        .panel(picture("(b) Turned by 60 degrees", &twisted, true, &at)?);
    write(&figure, &target("surface_tangents"))
}

/// The same over the rationals: how far the point of the exact surface is off.
fn exactly(sheet: &Sheet) -> Outcome<symspline::Q> {
    use symspline::Q;
    let (sheet, half) = (sheet.to_exact()?, Q::frac(1, 2));
    let at = (half.clone(), half.clone());
    let held = Constraints::on(&sheet).point(&at)?.derivative(&at, (1, 0))?.prepare()?;
    let along = sheet.tangents_at(&half, &half)?[1].clone();
    let longer = held.dragged(&sheet, &[SVector::zeros(), along])?;
    let off = longer.at(&half, &half)? - sheet.at(&half, &half)?;
    Ok(off.iter().map(Q::abs).sum())
}
