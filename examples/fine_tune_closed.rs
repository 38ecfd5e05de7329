//! Fine tuning of closed curves, which a free end would open: the outline of a cat, and the curve of a pentagon.
//!
//! Two ways keep them closed. Springs relax the control polygon towards the lengths and angles of the unclosed curve, after
//! Miura, Cheng and Wang. The nearest scale function with which the curve closes does it exactly: every tangent keeps its
//! direction, and the curvature is κ / α everywhere.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use support::{Outcome, Plane, data, pair, points, target, write};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path, graph_path};
use symspline::{
    Analyse, Condition, Ends, EventKind, Function, NearestScale, Norm, SplineSpace, Springs, chord_length,
};

fn main() -> Outcome<()> {
    let polygon = [[0.0, 0.0], [4.0, 0.0], [5.0, 2.5], [2.0, 5.0], [-1.0, 2.5]].map(|[x, y]| vector![x, y]);
    let pentagon = Plane::closed(2, polygon.to_vec())?;
    // Each control value belongs to the joint in the middle of a leg: the bottom one is raised.
    let alpha = Function::closed(1, vec![2.2, 1.0, 1.0, 1.0, 1.0])?;
    report("Chaikin's curve of a pentagon", "pentagon", &pentagon, &alpha)?;

    let cat = cat(48)?;
    let scales = SplineSpace::uniform_periodic(2, 12, 0.0, 1.0)?;
    let mut values = vec![1.0; 12];
    (values[3], values[4], values[8]) = (1.5, 1.5, 0.8);
    report("Outline of a cat", "cat", &cat, &Function::new(scales, values)?)
}

/// A closed cubic near measured points.
fn cat(spans: usize) -> Outcome<Plane> {
    let points = points(&data("closed_points_cat.csv"))?;
    let parameters = chord_length(&points)?;
    let space = SplineSpace::uniform_periodic(3, spans, 0.0, 1.0)?;
    let open = points.len() - 1;
    Ok(Plane::least_squares(&space, &parameters[..open], &points[..open], Ends::Free)?)
}

fn report(title: &str, file: &str, curve: &Plane, alpha: &Function<f64>) -> Outcome<()> {
    let free = curve.fine_tuned(alpha)?;
    let relaxed = curve.fine_tuned_closed(alpha, &Springs::default())?;
    let nearest = NearestScale::prepare(curve, alpha.space(), &[Condition::End], Norm::L2)?.to(alpha)?;
    let closed = curve.fine_tuned(&nearest)?;
    println!(
        "{title}: springs relaxed from {:.4} to {:.4} in {} steps",
        relaxed.energy_before, relaxed.energy, relaxed.iterations
    );
    println!("{:>16}{:>14}{:>18}{:>16}{:>9}", "", "gap", "|κ_D α / κ - 1|", "tangent turns", "extrema");
    let mut plane = Panel::new().title("Curves").equal_axes().height(420.0);
    let mut graph = Panel::new().title("Curvature").y_label("κ").height(220.0).x_label("parameter");
    for (name, tuned, own, color) in [
        ("original", curve, None, Color::GRAY),
        ("not closed", &free, Some(alpha), Color::SKY),
        ("springs", &relaxed.curve, Some(alpha), Color::VERMILLION),
        ("nearest scale", &closed, Some(&nearest), Color::GREEN),
    ] {
        let profile = tuned.profile()?;
        let gap = (tuned.at_left(&1.0)? - tuned.at(&0.0)?).norm();
        let (mut off, mut turn) = (Vec::new(), 0.0_f64);
        for x in (0..500).map(|i| (f64::from(i) + 0.5) / 500.0) {
            let law = own.map_or(Ok(1.0), |alpha| alpha.at(&x))?;
            off.push((tuned.curvature_at(&x)? * law / curve.curvature_at(&x)? - 1.0).abs());
            turn = turn.max(curve.derivative_at(&x, 1)?.angle(&tuned.derivative_at(&x, 1)?).to_degrees());
        }
        off.sort_by(f64::total_cmp);
        let extrema = profile.count(EventKind::Maximum) + profile.count(EventKind::Minimum);
        println!("{name:>16}{gap:>14.1e}{:>18.1e}{turn:>15.2}°{extrema:>9}", off[off.len() / 2]);
        plane = plane.path(curve_path(tuned, 1e-3)?, Style::line(color).width(2.0)).label(name);
        graph = graph.curvature(&profile, color).label(name);
    }
    println!("{:>16}{:>32}", "", "(median)");
    plane = plane.markers([pair(curve.at(&0.0)?)], Marker::Circle, Style::line(Color::BLACK)).label("start");
    let scales = Panel::new()
        .title("Scale functions")
        .y_label("α")
        .height(140.0)
        .path(graph_path(alpha, 1e-4)?, Style::line(Color::BLUE).width(2.0))
        .label("wanted")
        .path(graph_path(&nearest, 1e-4)?, Style::line(Color::GREEN).width(2.0))
        .label("nearest that closes");
    let figure = Figure::new(1000.0).title(title).panel(plane).panel(scales).panel(graph);
    write(&figure, &target(&format!("closed_{file}")))
}
