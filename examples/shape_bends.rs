//! Flat parts and bends: straight stretches in a curve, a plane part in a surface, curves bent about a circle and a parabola, and
//! sheets bent about a cylinder.
//!
//! Each tool is given where to work, refines there, moves the control points that have influence nowhere else, and says what
//! became of it.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::{SVector, vector};
use support::{Outcome, Plane, Point, pair, target, write};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path};
use symspline::{
    Axis, Bend, Curve, Direction, Flatten, Onto, Refinement, Round, Side, Sphere, SplineSpace, Surface,
};

fn main() -> Outcome<()> {
    write(&flattened_curves()?, &target("shape_flatten"))?;
    write(&bent_curves()?, &target("shape_bends"))?;
    write(&bent_sheets()?, &target("shape_bends_surface"))
}

/// A panel without a frame of numbers around it.
fn panel(title: &str, height: f64) -> Panel {
    Panel::new().title(title).equal_axes().height(height)
}

fn line(color: Color) -> Style {
    Style::line(color).width(2.0)
}

/// A curve over the domain from 0 to 1 with even knots.
fn curve(points: &[[f64; 2]]) -> Outcome<Plane> {
    let space = SplineSpace::uniform(3, points.len() - 3, 0.0, 1.0)?;
    Ok(Plane::new(space, points.iter().map(|p| vector![p[0], p[1]]).collect())?)
}

fn flattened_curves() -> Outcome<Figure> {
    let hill = curve(&[
        [0.0, 0.0],
        [0.6, 0.9],
        [1.8, 2.6],
        [3.2, 3.1],
        [4.6, 2.0],
        [6.0, 2.7],
        [7.4, 1.7],
        [8.2, 0.3],
        [9.0, 0.0],
    ])?;
    let (origin, direction): (Point, Point) = (vector![0.0, 1.6], vector![1.0, 0.05]);
    let onto = Onto::line_along(origin, direction, vector![0.2, 1.0])?;
    let (start, end) = (0.3, 0.75);
    let fine = Refinement::Count(14);
    let by_side =
        Flatten::new(onto.clone()).on_side(Side::Positive).refined(Refinement::Count(30)).apply(&hill)?;
    let local = Flatten::new(onto.clone()).local_to((start, end)).refined(fine.clone()).apply(&hill)?;
    let whole = Flatten::new(onto).whole((start, end)).refined(fine.clone()).apply(&hill)?;
    let ruler = |panel: Panel, height: f64, slope: f64| {
        let ends = [(-0.3, height - 0.3 * slope), (9.3, height + 9.3 * slope)];
        panel.polyline(ends, Style::line(Color::GRAY).dashed()).label("line")
    };
    let mut first = ruler(panel("A line that meets the curve, along W = (1/5, 1)", 250.0), 1.6, 0.05)
        .path(curve_path(&hill, 1e-3)?, line(Color::GRAY))
        .label("original");
    for (name, color, done) in [
        ("control points above", Color::BLUE, &by_side),
        ("control points local to [0.3, 0.75]", Color::VERMILLION, &local),
        ("all of [0.3, 0.75]", Color::GREEN, &whole),
    ] {
        report(name, done.projected.len(), &done.flat, done.changed.as_deref());
        first = first.path(curve_path(&done.shape, 1e-3)?, line(color)).label(name);
    }
    let ends = [start, end].map(|x| hill.at(&x));
    let [a, b] = ends;
    first = first.markers([pair(a?), pair(b?)], Marker::Circle, Color::BLACK).label("C(0.3), C(0.75)");

    let onto = Onto::line(vector![0.0, 3.4], vector![1.0, -0.05])?;
    let away = Flatten::new(onto.clone()).local_to((start, end)).until_flat(40).apply(&hill)?;
    let part = Flatten::new(onto)
        .local_to((start, end))
        .within_segment(vector![4.2, 3.2], vector![9.0, 3.0])
        .refined(fine)
        .apply(&hill)?;
    report("line above", away.projected.len(), &away.flat, away.changed.as_deref());
    let mut second = ruler(panel("A line that does not meet it, at a right angle", 230.0), 3.4, -0.05)
        .path(curve_path(&hill, 1e-3)?, line(Color::GRAY))
        .label("original");
    for (name, color, done) in [
        ("local to [0.3, 0.75]", Color::VERMILLION, &away),
        ("projections right of x = 4.2 alone", Color::BLUE, &part),
    ] {
        second = second.path(curve_path(&done.shape, 1e-3)?, line(color)).label(name);
    }

    let bump = bump()?;
    let plane = Onto::plane(vector![0.0, 0.0, 1.1], vector![0.0, 0.0, 1.0])?;
    let cut = Flatten::new(plane).on_side(Side::Positive).until_flat(2000);
    let flat = cut.refined(Refinement::Count(18)).apply(&bump)?;
    report("surface", flat.projected.len(), &flat.flat, flat.changed.as_deref());
    let mut third = panel("A surface, and what is above the plane z = 1.1 projected onto it", 260.0);
    third = wires(third, &bump, vector![0.0, 0.0, 0.0], Color::GRAY)?.label("original");
    third = wires(third, &flat.shape, vector![5.2, 0.0, 0.0], Color::BLUE)?.label("flattened");
    Ok(Figure::new(1000.0).title("Flattening").panel(first).panel(second).panel(third))
}

/// Says what became of it.
fn report(name: &str, projected: usize, flat: &[Vec<(f64, f64)>], changed: Option<&[(f64, f64)]>) {
    println!("{name}: {projected} control points projected, flat {flat:.4?}, changed {changed:.4?}");
}

fn bent_curves() -> Outcome<Figure> {
    let strip = curve(&(0..13).map(|i| [f64::from(i) - 6.0, 0.0]).collect::<Vec<_>>())?;
    let on = |centre: Point, about: Sphere<f64, 2>, ratio: f64| -> symspline::Result<Plane> {
        Bend::new(centre, about, ratio).on(0.3, 0.7).refined(Refinement::Count(12)).apply(&strip)
    };
    let middle = vector![0.0, -2.4];
    let circle = Sphere { centre: middle, radius: 2.0 };
    let ring: Vec<(f64, f64)> = (0..=120)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 120.0)
        .map(|a| (2.0 * a.cos(), 2.0 * a.sin() - 2.4))
        .collect();
    let start = |title: &str, height: f64| -> Outcome<Panel> {
        let panel = panel(title, height)
            .polyline(ring.clone(), Style::line(Color::GRAY).dashed())
            .label("bend circle");
        Ok(panel.path(curve_path(&strip, 1e-3)?, line(Color::GRAY)).label("original"))
    };
    let mut ratios = start("Cross ratios, about the centre of the circle", 330.0)?;
    for (ratio, name, color) in [
        (0.5, "λ = 1/2", Color::PURPLE),
        (1.0, "λ = 1", Color::VERMILLION),
        (2.0, "λ = 2", Color::GREEN),
        (5.0, "λ = 5", Color::BLUE),
    ] {
        ratios = ratios.path(curve_path(&on(middle, circle.clone(), ratio)?, 1e-3)?, line(color)).label(name);
    }
    let mut centres = start("Bend centres, λ = 1", 330.0)?;
    for (centre, name, color) in [
        (middle, "centre of the circle", Color::VERMILLION),
        (vector![0.0, -1.4], "on the axis of symmetry", Color::GREEN),
        (vector![0.7, -1.7], "elsewhere", Color::BLUE),
    ] {
        let bent = on(centre, circle.clone(), 1.0)?;
        centres = centres.path(curve_path(&bent, 1e-3)?, line(color)).label(name).markers(
            [pair(centre)],
            Marker::Circle,
            color,
        );
    }

    let wavy = curve(&[
        [-5.0, 0.4],
        [-4.0, 1.2],
        [-2.9, 2.0],
        [-1.9, 2.3],
        [-0.8, 1.5],
        [0.0, 1.2],
        [0.8, 1.5],
        [1.9, 2.3],
        [2.9, 2.0],
        [4.0, 1.2],
        [5.0, 0.4],
    ])?;
    // y = 2.6 - x² / 9.
    let parabola = Plane::new(
        SplineSpace::bezier(2, -5.0, 5.0)?,
        [-5.0, 0.0, 5.0]
            .into_iter()
            .zip([2.6 - 25.0 / 9.0, 2.6 + 25.0 / 9.0, 2.6 - 25.0 / 9.0])
            .map(|(x, y)| vector![x, y])
            .collect(),
    )?;
    let bend = Bend::new(vector![0.0, -6.0], parabola.clone(), 1.0)
        .on(0.1875, 0.8125)
        .refined(Refinement::Count(14));
    let bent = bend.apply(&wavy)?;
    let inflections = |c: &Plane| -> Outcome<usize> {
        use symspline::{Analyse, EventKind};
        Ok(c.profile()?.count(EventKind::Inflection))
    };
    println!("inflections: {} before, {} after the parabolic bend", inflections(&wavy)?, inflections(&bent)?);
    let parabolic = panel("About a parabola, λ = 1: two inflections less", 260.0)
        .path(curve_path(&parabola, 1e-3)?, Style::line(Color::GRAY).dashed())
        .label("bend parabola")
        .path(curve_path(&wavy, 1e-3)?, line(Color::GRAY))
        .label("original")
        .path(curve_path(&bent, 1e-3)?, line(Color::VERMILLION))
        .label("bent");
    Ok(Figure::new(1000.0).title("Bends of curves").panel(ratios).panel(centres).panel(parabolic))
}

type Space = SVector<f64, 3>;

/// A bicubic hill over [0, 4] x [0, 4].
fn bump() -> Outcome<Surface<f64, 3>> {
    let space = SplineSpace::uniform(3, 6, 0.0, 1.0)?;
    let nodes = space.greville();
    let height = |x: f64, y: f64| 2.6 * (-5.0 * ((x - 0.5).powi(2) + (y - 0.5).powi(2))).exp();
    let point = |x: f64, y: f64| vector![4.0 * x, 4.0 * y, height(x, y)];
    let points = nodes.iter().flat_map(|x| nodes.iter().map(move |y| point(*x, *y))).collect();
    Ok(Surface::new(space.clone(), space, points)?)
}

/// A plane sheet of degree 3 x 2 over [-4, 4] x [0, 3].
fn sheet() -> Outcome<Surface<f64, 3>> {
    let (u, v) = (SplineSpace::uniform(3, 12, 0.0, 1.0)?, SplineSpace::uniform(2, 3, 0.0, 1.0)?);
    let across = v.greville();
    let points = u
        .greville()
        .into_iter()
        .flat_map(|x| across.iter().map(move |y| vector![8.0 * x - 4.0, 3.0 * y, 0.0]));
    let points = points.collect();
    Ok(Surface::new(u, v, points)?)
}

/// A point of space seen from the front, the right and above.
fn seen(p: &Space) -> Point {
    vector![p[0] + 0.45 * p[1], p[2] + 0.32 * p[1]]
}

/// The isocurves of a surface, moved.
fn wires(mut panel: Panel, surface: &Surface<f64, 3>, by: Space, color: Color) -> Outcome<Panel> {
    for (direction, count) in [(Direction::U, 24), (Direction::V, 8)] {
        for k in 0..=count {
            let wire = surface.isocurve(direction, &(f64::from(k) / f64::from(count)))?;
            let points = wire.coeffs().iter().map(|p| seen(&(p + by))).collect();
            let path = curve_path(&Curve::new(wire.space().clone(), points)?, 1e-3)?;
            panel = panel.path(path, Style::line(color).width(0.9));
        }
    }
    Ok(panel)
}

fn bent_sheets() -> Outcome<Figure> {
    let flat = sheet()?;
    let mut figure = Figure::new(1000.0).title("Cylinder bends of a plane sheet, ends carried along");
    for (title, depth, radius, ratios) in [
        (
            "A cylinder that does not touch the sheet",
            1.8,
            1.2,
            [(0.5, "λ = 1/2"), (1.5, "λ = 3/2"), (-3.0, "λ = -3")],
        ),
        (
            "A cylinder that touches the sheet",
            1.2,
            1.2,
            [(0.3, "λ = 3/10"), (1.0, "λ = 1"), (-1.0, "λ = -1")],
        ),
    ] {
        let axis = Axis::new(vector![0.0, 0.0, -depth], vector![0.0, 1.0, 0.0])?;
        let mut view = panel(title, 300.0);
        for (k, ((ratio, name), color)) in
            ratios.into_iter().zip([Color::VERMILLION, Color::GREEN, Color::BLUE]).enumerate()
        {
            // Away from the cylinder only what is near the axis may bend: s > 1 / (1 - λ).
            let (a, b) = if ratio < 0.0 { (0.375, 0.625) } else { (0.3, 0.7) };
            let bend = Bend::new(axis.clone(), Round(radius), ratio).on(a, b).refined(Refinement::Count(10));
            let by = vector![9.5 * k as f64, 0.0, 0.0];
            view = wires(view, &bend.apply(&flat)?, by, color)?.label(name);
            for y in [0.0, 3.0] {
                let ring = (0..=60).map(|i| f64::from(i) * std::f64::consts::TAU / 60.0);
                let ring =
                    ring.map(|t| pair(seen(&(vector![radius * t.cos(), y, radius * t.sin() - depth] + by))));
                view = view.polyline(ring.collect::<Vec<_>>(), Style::line(Color::GRAY).width(1.2));
            }
        }
        figure = figure.panel(view);
    }
    Ok(figure)
}
