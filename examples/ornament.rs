//! Ornamental curves: loops whose derivative is scaled down towards their middle and up again.
//!
//! The angle of the tangent stays what it was at each parameter, so that the loops turn as before; only how far each
//! stretch of them goes is the scale's. No deformation of the plane does this to a curve that crosses itself.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use std::f64::consts::TAU;
use support::{Outcome, Plane, pair, target, write};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path, graph_path};
use symspline::{Analyse, EventKind, Function, SplineSpace, Turning};

fn main() -> Outcome<()> {
    // Down for the first half, up for the second.
    let alpha = Function::new(SplineSpace::uniform(2, 4, 0.0, 1.0)?, vec![1.0, 0.8, 0.25, 0.25, 0.8, 1.0])?;
    let two_loops = traced(48, |t| {
        let angle = 3.0 * TAU * t;
        vector![9.0 * t, 0.0] + vector![-angle.sin(), 0.8 * angle.cos()] * 1.4
    })?;
    let spirals = Function::new(SplineSpace::uniform(2, 2, 0.0, 1.0)?, vec![1.0, 0.6, 0.02, 1.0])?;
    let rounds = traced(180, |t| vector![(6.0 * TAU * t).cos(), (6.0 * TAU * t).sin()])?;
    let mut figure = Figure::new(1000.0).title("Ornamental curves");
    for (name, curve, alpha) in [("Two loops", two_loops, alpha), ("Six rounds of a circle", rounds, spirals)]
    {
        let tuned = curve.fine_tuned(&alpha)?;
        let turns = |curve: &Plane| Ok::<f64, symspline::Error>(curve.turning_angle()?.middle() / TAU);
        println!("{name}: {:.6} turns before, {:.6} after", turns(&curve)?, turns(&tuned)?);
        let mut plane = Panel::new().title(name).equal_axes().height(330.0);
        let mut graph = Panel::new().y_label("κ").height(170.0);
        for (name, curve, color) in [("original", &curve, Color::GREEN), ("tuned", &tuned, Color::VERMILLION)]
        {
            let profile = curve.profile()?;
            println!(
                "  {name:<9} degree {}, {} extrema of curvature, proved",
                curve.degree(),
                profile.count(EventKind::Maximum) + profile.count(EventKind::Minimum)
            );
            plane = plane.path(curve_path(curve, 1e-3)?, Style::line(color).width(2.0)).label(name);
            graph = graph.curvature(&profile, color).label(name);
        }
        plane = plane.markers([pair(curve.at(&0.0)?)], Marker::Circle, Style::line(Color::BLACK));
        let scale = Panel::new()
            .y_label("α")
            .x_label("parameter")
            .height(110.0)
            .path(graph_path(&alpha, 1e-4)?, Style::line(Color::BLUE).width(2.0))
            .label("scale function");
        figure = figure.panel(plane).panel(graph).panel(scale);
    }
    write(&figure, &target("ornament"))
}

/// A cubic through points of a curve, evenly spaced in its parameter.
fn traced(spans: usize, at: impl Fn(f64) -> support::Point) -> Outcome<Plane> {
    let space = SplineSpace::uniform(3, spans, 0.0, 1.0)?;
    let parameters = space.greville();
    let points: Vec<_> = parameters.iter().map(|t| at(*t)).collect();
    Ok(Plane::interpolating(&space, &parameters, &points)?)
}
