//! Fine tuning of a portion of an airfoil, beside a free-form deformation of the same curve, and two portions tuned one after
//! the other without raising the degree.
//!
//! A free-form deformation moves one point of a 4 x 4 lattice around the curve: composed with the curve it is exact too, but of
//! degree 18, and its effect on the curvature is not asked for by anyone. Fine tuning changes the curvature of the portion by
//! the factor that the scale says, and nothing else.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use support::{Outcome, Plane, data, letter, points, target, write};
use symspline::plot::{Color, Figure, Panel, Style, curve_path, graph_path};
use symspline::{
    Analyse, Ends, EventKind, Function, Hold, LocallyTuned, Norm, SplineSpace, Surface, approximation_space,
    chord_length,
};

fn main() -> Outcome<()> {
    let airfoil = airfoil()?;
    compare(&airfoil)?;
    repeat(&letter("S")?)
}

/// A cubic near the points of an airfoil, from the trailing edge around the nose and back.
fn airfoil() -> Outcome<Plane> {
    let points = points(&data("airfoil_naca2412.csv"))?;
    let parameters = chord_length(&points)?;
    let space = approximation_space(3, &parameters, 32)?;
    Ok(Plane::least_squares(&space, &parameters, &points, Ends::Held)?)
}

/// The portion on the upper side that is tuned.
const PORTION: (f64, f64) = (0.25, 0.49);

fn compare(curve: &Plane) -> Outcome<()> {
    let (a, b) = PORTION;
    // Up to two and a half times the speed, so a curvature down to two fifths of what it was.
    let scales = SplineSpace::uniform(2, 8, a, b)?;
    let alpha = Function::constant(scales, 1.0)?.dragged(&(0.55 * a + 0.45 * b), 2.5, Norm::Coefficients)?;
    let held = |hold: Hold| -> symspline::Result<LocallyTuned<f64, 2>> { curve.fine_tuned_on(&alpha, hold) };
    let nearest = curve.fine_tuned_on_by_nearest(&alpha, 1, Norm::L2)?;
    let tangents = held(Hold::Tangents)?;
    let curvatures = held(Hold::Curvatures)?;
    let versions = [
        ("original", Color::GRAY, curve.clone()),
        ("free-form deformation", Color::PURPLE, deformed(curve)?),
        ("tangents held", Color::VERMILLION, tangents.joined()?),
        ("curvatures held", Color::ORANGE, curvatures.joined()?),
        ("nearest scale, G2", Color::GREEN, nearest.joined()?),
    ];
    println!("{:>22}{:>8}{:>10}{:>10}{:>14}", "", "degree", "controls", "extrema", "moved, most");
    let mut plane =
        Panel::new().title("The front of an airfoil").equal_axes().height(340.0).x_range(-0.02, 0.62);
    let mut graph =
        Panel::new().title("Curvature").y_label("κ").x_label("parameter").x_range(0.2, 0.5).y_range(0.0, 2.5);
    for (name, color, version) in &versions {
        let profile = version.profile()?;
        let extrema = profile.count(EventKind::Maximum) + profile.count(EventKind::Minimum);
        let moved =
            (0..=1000).map(|i| f64::from(i) / 1000.0).map(|x| Ok((version.at(&x)? - curve.at(&x)?).norm()));
        let moved = moved.collect::<symspline::Result<Vec<f64>>>()?.into_iter().fold(0.0, f64::max);
        println!("{name:>22}{:>8}{:>10}{extrema:>10}{moved:>14.5}", version.degree(), version.coeffs().len());
        plane = plane.path(curve_path(version, 1e-4)?, Style::line(*color).width(1.8)).label(*name);
        graph = graph.curvature(&profile, *color).label(*name);
    }
    let graph = graph.v_lines([a, b], Style::line(Color::GRAY).dashed());
    let scale = Panel::new()
        .title("Scale function")
        .y_label("α")
        .x_range(0.2, 0.5)
        .height(120.0)
        .path(graph_path(&alpha, 1e-4)?, Style::line(Color::BLUE).width(2.0));
    let figure = Figure::new(1000.0).title("Local fine tuning").panel(plane).panel(scale).panel(graph);
    write(&figure, &target("local_compare"))
}

/// The curve after one point of a bicubic lattice on its bounding box was moved, exactly.
fn deformed(curve: &Plane) -> Outcome<Plane> {
    let (low, high) = curve.control_box();
    let margin = 0.01 * (high - low).norm();
    let (low, high) = (low.add_scalar(-margin), high.add_scalar(margin));
    let [u, v] = [0, 1].map(|axis| SplineSpace::bezier(3, low[axis], high[axis]));
    let (u, v) = (u?, v?);
    let lattice = |(i, x): (usize, &f64)| {
        let row = v.greville().into_iter().enumerate();
        row.map(|(j, y)| vector![*x, if (i, j) == (2, 3) { y + 0.04 } else { y }]).collect::<Vec<_>>()
    };
    let points = u.greville().iter().enumerate().flat_map(lattice).collect();
    Ok(Surface::<f64, 2>::new(u, v, points)?.composed(curve)?)
}

/// Two portions of a letter one after the other, the second around the first. The outline is quadratic and stays so, and each
/// step says how far it is off.
fn repeat(letter: &Plane) -> Outcome<()> {
    let unit = 2048.0;
    let mut plane = Panel::new()
        .title("Two steps on a quadratic outline, tangents held")
        .equal_axes()
        .height(430.0)
        .path(curve_path(letter, 0.1)?, Style::line(Color::GRAY).width(1.8))
        .label("original");
    let stretch = |curve: &Plane| curve.restricted(&STRETCH.0, &STRETCH.1)?.profile();
    let mut graph = Panel::new().title("Curvature of the stretch").y_label("κ [1/unit]").x_label("parameter");
    graph = graph.curvature(&stretch(letter)?, Color::GRAY).label("original");
    let mut current = letter.clone();
    for (step, (a, b), values, color) in [
        (1, (2.5, 7.0), [1.0, 0.9, 1.6, 0.9, 1.0], Color::BLUE),
        (2, (2.5, 10.5), [1.0, 1.1, 1.4, 1.0, 1.0], Color::VERMILLION),
    ] {
        let alpha = Function::new(SplineSpace::uniform(1, 4, a, b)?, values.to_vec())?;
        let tuned = current.fine_tuned_on(&alpha, Hold::Tangents)?;
        let reduced = tuned.reduced(&(unit / 10_000.0))?;
        println!(
            "step {step}: degree {} reduced to {}, {} control points, off by at most {:.1e} em",
            tuned.joined()?.degree(),
            reduced.spline.degree(),
            reduced.spline.coeffs().len(),
            reduced.bound / unit
        );
        current = reduced.spline;
        let name = format!("after step {step}");
        plane = plane.path(curve_path(&current, 0.1)?, Style::line(color).width(1.8)).label(&name);
        graph = graph.curvature(&stretch(&current)?, color).label(&name);
    }
    let figure = Figure::new(1000.0).title("Repeated local fine tuning").panel(plane).panel(graph);
    write(&figure, &target("local_repeated"))
}

/// The smooth stretch of the letter that holds both portions.
const STRETCH: (f64, f64) = (2.0, 15.0);
