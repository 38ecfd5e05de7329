//! Weights as a shape tool, after section 11.3 of The NURBS Book: a point of a curve pulled toward a control point in equal steps
//! and pushed away, a point pulled by two weights along a line and aside, and a point of a surface pushed.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::{SVector, vector};
use support::{Outcome, Point, pair, target, write};
use symspline::plot::{Color, Figure, Marker, Panel, Style};
use symspline::{NurbsCurve, NurbsSurface, SplineSpace, WeightPairPull, WeightPull, WeightRange};

type Curve = NurbsCurve<f64, 2>;
type Space = SVector<f64, 3>;

fn main() -> Outcome<()> {
    one_weight()?;
    two_weights()?;
    surface()
}

/// A cubic with eight control points, all of weight 1 but two.
fn curve(weights: [f64; 2]) -> Outcome<Curve> {
    let points: [[f64; 2]; 9] = [
        [0.0, 0.0],
        [0.15, 0.45],
        [0.55, 0.75],
        [0.95, 0.35],
        [1.35, 1.0],
        [1.85, 0.95],
        [2.1, 0.3],
        [2.6, 0.6],
        [3.0, 0.1],
    ];
    let space = SplineSpace::uniform(3, 6, 0.0, 1.0)?;
    let mut all = vec![1.0; points.len()];
    all[4..6].copy_from_slice(&weights);
    Ok(Curve::new(space, points.map(Point::from).to_vec(), all)?)
}

fn samples(curve: &Curve) -> Outcome<Vec<(f64, f64)>> {
    let at = |i: i32| Ok(pair(curve.at(&(f64::from(i) / 600.0))?));
    (0..=600).map(at).collect()
}

/// A panel with the control polygon of a curve.
fn polygon(title: &str, curve: &Curve) -> Outcome<Panel> {
    let points = curve.points()?;
    let panel = Panel::new().title(title).equal_axes().height(300.0).y_range(-0.05, 1.12).x_range(-0.1, 3.1);
    Ok(panel.marked_polyline(points.into_iter().map(pair), Marker::Circle, Style::line(Color::LIGHT_GRAY)))
}

fn one_weight() -> Outcome<()> {
    let curve = curve([0.2, 1.0])?;
    let at = curve.space().node(4)?;
    // Weights from a fifth to five.
    let pull = WeightPull::new(&curve, &at, 4)?.within(WeightRange::new(0.02, 20.0)?);
    let mut pulled = polygon("One weight: equal pulls toward P4 (u = t4), and a push", &curve)?;
    let step = 0.9 / 4.0;
    println!("one weight: from {} with the share {:.3}", pull.weight(), pull.share());
    let mut moving = curve.clone();
    for (i, fraction) in [0.0, step, 2.0 * step, 3.0 * step, 4.0 * step].into_iter().enumerate() {
        pull.apply(&mut moving, &fraction)?;
        let weight = pull.weight_for(&fraction)?;
        println!("  {fraction:>6.3} of the way: weight {weight:>7.3}");
        pulled = pulled
            .polyline(samples(&moving)?, Style::line(Color::nth(i)).width(1.8))
            .label(format!("w4 = {weight:.2}"));
    }
    let push = pull.push_limit().ok_or("there is a limit")? * 0.98;
    pull.apply(&mut moving, &push)?;
    pulled = pulled
        .polyline(samples(&moving)?, Style::line(Color::BLACK).dashed())
        .label(format!("w4 = {:.2}", pull.weight_for(&push)?));
    // The lines that points move along meet at the control point.
    let mut rays = Vec::new();
    for u in [-0.16, -0.08, 0.0, 0.08, 0.16] {
        let here = WeightPull::new(&curve, &(at + u), 4)?;
        rays.push((pair(here.point_at_weight(&0.0)?), pair(*here.control_point())));
    }
    pulled = pulled.segments(rays, Style::line(Color::GRAY).width(0.7).dashed());
    println!("  a pull by all of the way: {}", pull.weight_for(&1.0).err().ok_or("refused")?);
    println!("  a push by too much: {}", pull.weight_for(&(2.0 * push)).err().ok_or("refused")?);
    let spots = (0..=4).map(|i| pair(pull.point_at(&(step * f64::from(i)))));
    pulled = pulled.markers(spots, Marker::Square, Style::line(Color::BLACK));

    // The geometric meaning: four points of a line.
    let [r, m] = [pull.point_at_weight(&0.0)?, pull.point_at_weight(&1.0)?];
    let mut meaning = polygon("The weight is the cross ratio (P4, R; M, P)", &curve)?;
    for (i, (weight, name)) in [(0.02, "w4 = 0.02"), (0.2, "w4 = 0.2"), (1.0, "w4 = 1")].iter().enumerate() {
        pull.apply(&mut moving, &pull.fraction_for(weight)?)?;
        meaning = meaning.polyline(samples(&moving)?, Style::line(Color::nth(i)).width(1.8)).label(*name);
    }
    let spots = [(r, "R"), (*pull.point(), "P"), (m, "M"), (*pull.control_point(), "P4")];
    meaning = meaning.segments([(pair(r), pair(*pull.control_point()))], Style::line(Color::GRAY).width(0.7));
    for (spot, name) in spots {
        meaning = meaning.markers([pair(spot)], Marker::Square, Style::line(Color::BLACK)).text(
            pair(spot),
            name,
            Style::line(Color::BLACK),
        );
    }
    let figure = Figure::new(1000.0).title("One weight of a curve").panel(pulled).panel(meaning);
    write(&figure, &target("weights_one"))
}

fn two_weights() -> Outcome<()> {
    let curve = curve([0.05, 0.05])?;
    let at = curve.space().between_nodes(4)?;
    let pull = WeightPairPull::on_leg(&curve, &at, 4)?;
    let (p, q) = (*pull.point(), pull.goal());
    let aside = p + (q - p) * 0.62 + (pull.control_points()[0] - pull.control_points()[1]) * 0.24;
    let ways = [("along the line from R to Q, the ratio kept", p + (q - p) * 0.62), ("aside", aside)];
    let mut figure = Figure::new(1000.0).title("Two weights of a curve");
    println!("two weights: from 0.05 and 0.05");
    for (name, to) in ways {
        let mut panel = polygon(&format!("Pulled {name}"), &curve)?;
        panel = panel.polyline(samples(&curve)?, Style::line(Color::BLUE).width(1.8)).label("w4 = w5 = 0.05");
        let mut moved = curve.clone();
        pull.apply_to(&mut moved, &to, &0.0)?;
        let [w4, w5] = pull.weights_for(&to, &0.0)?;
        println!("  {name}: {w4:.3} and {w5:.3}");
        panel = panel
            .polyline(samples(&moved)?, Style::line(Color::VERMILLION).width(1.8))
            .label(format!("w4 = {w4:.2}, w5 = {w5:.2}"));
        let [left, right] = pull.control_points().map(pair);
        let base = pair(*pull.base());
        panel = panel
            .polyline([base, left, right, base], Style::line(Color::GREEN).width(0.9).dashed())
            .label("the triangle in reach")
            .segments([(base, pair(q)), (pair(p), pair(to))], Style::line(Color::GRAY).width(0.9));
        for (spot, name) in [(*pull.base(), "R"), (p, "P"), (q, "Q"), (to, "target")] {
            panel = panel.markers([pair(spot)], Marker::Square, Style::line(Color::BLACK)).text(
                pair(spot),
                name,
                Style::line(Color::BLACK),
            );
        }
        figure = figure.panel(panel);
    }
    write(&figure, &target("weights_two"))
}

/// A point of space as it is drawn.
fn drawn(p: &Space) -> (f64, f64) {
    (p[0] - 0.7 * p[1], 0.12 * p[0] + 0.3 * p[1] + p[2])
}

fn surface() -> Outcome<()> {
    let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    let points = (0..49).map(|i| {
        let [x, y] = [f64::from(i / 7), f64::from(i % 7)];
        let hill = 3.0 * (-((x - 4.0).powi(2) + (y - 3.0).powi(2)) / 1.2).exp();
        vector![x, y, hill]
    });
    let mut weights = vec![1.0; 49];
    weights[4 * 7 + 3] = 3.0;
    let surface = NurbsSurface::new(space.clone(), space, points.collect(), weights)?;
    let at = (0.64, 0.5);
    let pull = WeightPull::new(&surface, &at, (4, 3))?;
    let push = pull.push_limit().ok_or("there is a limit")? * 0.9;
    let mut figure = Figure::new(1000.0).title("One weight of a surface, at u = 0.64, v = 0.5");
    let ways = [("before", 0.0), ("pushed away from P43", push), ("pulled toward P43", 0.7)];
    for (name, fraction) in ways {
        let weight = pull.weight_for(&fraction)?;
        let version = pull.applied(&surface, &fraction)?;
        println!("surface, {name}: weight {weight:.3}");
        let title = format!("{name}: w43 = {weight:.2}");
        let mut panel = Panel::new().title(title).height(290.0).x_range(-4.4, 6.2).y_range(-0.2, 4.8);
        for i in 0..=24 {
            let fixed = f64::from(i) / 24.0;
            let along = |u: bool| -> Outcome<Vec<(f64, f64)>> {
                let one = |j: i32| {
                    let x = f64::from(j) / 120.0;
                    let (u, v) = if u { (x, fixed) } else { (fixed, x) };
                    Ok(drawn(&version.at(&u, &v)?))
                };
                (0..=120).map(one).collect()
            };
            panel = panel.polyline(along(true)?, Style::line(Color::BLUE).width(0.8));
            panel = panel.polyline(along(false)?, Style::line(Color::SKY).width(0.8));
        }
        let (spot, control) = (drawn(&pull.point_at(&fraction)), drawn(pull.control_point()));
        panel = panel
            .segments(
                [(drawn(&pull.point_at_weight(&0.0)?), control)],
                Style::line(Color::VERMILLION).dashed(),
            )
            .markers([spot, control], Marker::Square, Style::line(Color::VERMILLION))
            .text(control, "P43", Style::line(Color::VERMILLION));
        figure = figure.panel(panel);
    }
    write(&figure, &target("weights_surface"))
}
