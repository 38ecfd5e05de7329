//! Warps: the warping functions, a curve warp step by step and in variants, regions of a surface punched out, and letters
//! pushed through a surface. After figures 11.18 to 11.24 of The NURBS Book.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use support::{Outcome, Plane, Point, pair, seen, shaded, target, write};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path};
use symspline::{
    Assigned, Bump, Gravity, Polygons, Refinement, Region, Reshaped, SplineSpace, Surface, UnitNormal, Warp,
};

fn main() -> Outcome<()> {
    steps()?;
    variants()?;
    punches()?;
    letters()
}

const WEIGHTS: [(f64, &str, Color); 3] =
    [(0.2, "w = 1/5", Color::BLUE), (1.0, "w = 1", Color::GREEN), (30.0, "w = 30", Color::VERMILLION)];

/// A cubic that falls and rises.
fn base() -> Outcome<Plane> {
    let points = [[0.0, 0.3], [0.9, 0.0], [2.1, 0.15], [3.2, 0.55], [4.4, 0.6], [5.4, 0.25], [6.4, 0.3]];
    Ok(Plane::new(SplineSpace::uniform(3, 4, 0.0, 1.0)?, points.map(|[x, y]| vector![x, y]).to_vec())?)
}

const INTERVAL: (f64, f64) = (0.3, 0.7);

fn bumped(curve: &Plane, weight: f64, by: Point, tolerance: Option<f64>) -> Outcome<Reshaped<Plane, f64>> {
    let region = Region::new(INTERVAL.0, INTERVAL.1).refined(Refinement::Count(16));
    let region = tolerance.map_or(region.clone(), |tolerance| region.thinned(tolerance));
    let bump = Bump::new(weight)?;
    Ok(Warp::along(region, |at| bump.at(&at.share), by).apply_by_chords(curve)?)
}

/// The curve refined, its control points moved, and as many knots removed as it can do without.
fn steps() -> Outcome<()> {
    let mut functions = Panel::new().title("Warping functions").x_label("t").y_label("f(t)").height(150.0);
    for (weight, name, color) in WEIGHTS {
        let bump = Bump::new(weight)?;
        let graph = (0..=200).map(|i| f64::from(i) / 200.0).map(|t| (t, bump.at(&t)));
        functions = functions.polyline(graph, Style::line(color).width(1.8)).label(name);
    }
    let (curve, by) = (base()?, vector![0.0, 0.8]);
    let refined = bumped(&curve, 4.0, by * 0.0, None)?.shape;
    let moved = bumped(&curve, 4.0, by, None)?;
    let thin = bumped(&curve, 4.0, by, Some(0.005))?;
    println!(
        "{} knots inserted, {} points moved, {} knots removed, off by at most {:.5}",
        thin.inserted.len(),
        thin.moved,
        thin.removed.len(),
        thin.bound
    );
    let ends = [curve.at(&INTERVAL.0)?, curve.at(&INTERVAL.1)?].map(pair);
    let with_polygon = |title: String, curve: &Plane, color: Color| -> Outcome<Panel> {
        let polygon = curve.coeffs().iter().copied().map(pair);
        Ok(Panel::new()
            .title(title)
            .equal_axes()
            .height(135.0)
            .x_range(-0.2, 6.6)
            .y_range(-0.1, 1.4)
            .marked_polyline(polygon, Marker::Circle, Style::line(Color::LIGHT_GRAY).marker_radius(2.5))
            .path(curve_path(curve, 1e-4)?, Style::line(color).width(2.0))
            .markers(ends, Marker::Square, Style::line(Color::BLACK).marker_radius(3.0)))
    };
    let middle = curve.at(&0.5)?;
    let arrow = [middle, middle + by].map(pair);
    let figure = Figure::new(760.0)
        .title("A curve warp, step by step")
        .panel(functions)
        .panel(
            with_polygon(
                "(a) The curve, the interval, and by what it is warped".into(),
                &curve,
                Color::BLUE,
            )?
            .polyline(arrow, Style::line(Color::VERMILLION).width(1.5)),
        )
        .panel(with_polygon(
            format!("(b) Refined: {} control points", refined.coeffs().len()),
            &refined,
            Color::BLUE,
        )?)
        .panel(with_polygon(
            format!("(c) {} control points moved, w = 4", moved.moved),
            &moved.shape,
            Color::VERMILLION,
        )?)
        .panel(with_polygon(
            format!("(d) Knots removed: {} control points, within 0.005", thin.shape.coeffs().len()),
            &thin.shape,
            Color::VERMILLION,
        )?);
    write(&figure, &target("shape_warps_steps"))
}

/// A function for a warp.
type Profile = fn(f64) -> f64;

/// Weights, directions, distances, and other functions.
fn variants() -> Outcome<()> {
    let curve = base()?;
    let panel = |title: &str| -> Outcome<Panel> {
        Ok(Panel::new()
            .title(title)
            .equal_axes()
            .height(150.0)
            .x_range(0.4, 6.0)
            .path(curve_path(&curve, 1e-4)?, Style::line(Color::GRAY).width(1.5))
            .label("original"))
    };
    let add = |panel: Panel, curve: &Plane, color: Color, name: String| -> Outcome<Panel> {
        Ok(panel.path(curve_path(curve, 1e-4)?, Style::line(color).width(1.8)).label(name))
    };
    let mut weights = panel("Weights")?;
    for (weight, name, color) in WEIGHTS {
        weights =
            add(weights, &bumped(&curve, weight, vector![0.0, 0.8], None)?.shape, color, name.to_owned())?;
    }
    let mut directions = panel("Directions, w = 20")?;
    for (degrees, color) in [(60.0_f64, Color::BLUE), (90.0, Color::GREEN), (120.0, Color::VERMILLION)] {
        let angle = degrees.to_radians();
        let by = vector![angle.cos(), angle.sin()] * 0.8;
        directions = add(directions, &bumped(&curve, 20.0, by, None)?.shape, color, format!("{degrees}°"))?;
    }
    let mut distances = panel("Distances, w = 4")?;
    for (distance, color) in [(0.3, Color::BLUE), (0.6, Color::GREEN), (0.9, Color::VERMILLION)] {
        let shape = bumped(&curve, 4.0, vector![0.0, distance], None)?.shape;
        distances = add(distances, &shape, color, format!("d = {distance}"))?;
    }
    let mut others = panel("Along the normal, with other functions")?;
    let waves: [(&str, Profile, Color); 2] = [
        ("a wave that fades", |t| (18.0 * t).sin() * (1.0 - t) * t * 4.0, Color::BLUE),
        ("steps", |t| if (8.0 * t) as usize % 2 == 1 { 1.0 } else { 0.0 }, Color::VERMILLION),
    ];
    for (name, f, color) in waves {
        let region = Region::new(0.2, 0.8).refined(Refinement::Count(60));
        let along = |at: &Assigned<f64>| Ok(Some(curve.unit_normal(&at.parameter)? * (0.35 * f(at.share))));
        let warped = Warp::new(region, along).apply(&curve)?.shape;
        others = add(others, &warped, color, name.to_owned())?;
    }
    let figure = Figure::new(760.0).title("Curve warps").panel(weights).panel(directions).panel(distances);
    write(&figure.panel(others), &target("shape_warps_curves"))
}

/// A sheet over the unit square, a little bent.
fn sheet() -> Outcome<Surface<f64, 3>> {
    let space = SplineSpace::uniform(3, 3, 0.0, 1.0)?;
    let nodes = space.greville();
    let point = |u: f64, v: f64| vector![u, v, 0.12 * (3.0 * u).sin() - 0.1 * v * v];
    let row = |u: &f64| nodes.iter().map(|v| point(*u, *v)).collect::<Vec<_>>();
    Ok(Surface::new(space.clone(), space, nodes.iter().flat_map(row).collect())?)
}

/// The curve of a line in the parameter plane on the surface.
fn traced(surface: &Surface<f64, 3>, corners: &[(f64, f64)]) -> symspline::Result<Vec<(f64, f64)>> {
    let between = |pair: &[(f64, f64)]| {
        let ((a, b), (c, d)) = (pair[0], pair[1]);
        (0..=20).map(move |i| f64::from(i) / 20.0).map(move |t| (a + t * (c - a), b + t * (d - b)))
    };
    let all = corners.windows(2).flat_map(between);
    all.map(|(u, v)| Ok(seen(surface.at(&u, &v)?))).collect()
}

/// Regions of a surface, one a star that crosses itself, moved along the normal.
fn punches() -> Outcome<()> {
    let surface = sheet()?;
    let corner = |i: usize| {
        let angle = std::f64::consts::TAU * (0.25 + 0.4 * i as f64);
        (0.32 + 0.22 * angle.cos(), 0.5 + 0.26 * angle.sin())
    };
    let star: Vec<(f64, f64)> = (0..5).map(corner).collect();
    let arrow =
        vec![(0.62, 0.25), (0.78, 0.25), (0.78, 0.55), (0.88, 0.55), (0.7, 0.8), (0.55, 0.55), (0.62, 0.55)];
    let die = Polygons::new([star.clone(), arrow.clone()])?;
    let region = Region::new((0.05, 0.15), (0.95, 0.85)).refined(Refinement::Spacing(0.01));
    let along = |at: &Assigned<(f64, f64)>| {
        let normal = surface.unit_normal(&at.parameter)?;
        Ok(die.contains(&at.parameter).then(|| normal * 0.07))
    };
    let punched = Warp::new(region, along).apply(&surface)?;
    println!("{} knots inserted, {} points moved", punched.inserted.len(), punched.moved);
    let bump = Bump::new(6.0)?;
    let region = Region::new((0.15, 0.15), (0.85, 0.85)).refined(Refinement::Count(20)).thinned(0.002);
    let bumped = Warp::along(region, |at| bump.at_pair(&at.share), vector![0.0, 0.0, 0.35])
        .apply_by_chords(&surface)?;
    println!(
        "{} knots inserted, {} removed, off by at most {:.5}",
        bumped.inserted.len(),
        bumped.removed.len(),
        bumped.bound
    );
    let mut before = shaded(
        Panel::new().title("(a) The surface with two polygons").equal_axes().x_range(0.0, 1.5).height(270.0),
        &surface,
        30,
    )?;
    for (mut polygon, color) in [(star, Color::VERMILLION), (arrow, Color::BLUE)] {
        polygon.push(polygon[0]);
        before = before.polyline(traced(&surface, &polygon)?, Style::line(color).width(2.0));
    }
    let panel = |title: &str| Panel::new().title(title).equal_axes().x_range(0.0, 1.5).height(270.0);
    let after = shaded(panel("(b) Punched along the normal, by the even-odd rule"), &punched.shape, 120)?;
    let round = shaded(panel("(c) A bump over a rectangle, w = 6"), &bumped.shape, 50)?;
    let figure =
        Figure::new(900.0).title("Region warps of a surface").panel(before).panel(after).panel(round);
    write(&figure, &target("shape_warps_regions"))
}

/// The strokes of letters in a box two units wide and three high.
fn strokes() -> Vec<Vec<(f64, f64)>> {
    let letter = |left: f64, corners: &[(f64, f64)]| corners.iter().map(|(x, y)| (left + x, *y)).collect();
    let bowl = |y: f64| [(0.0, y), (1.5, y), (2.0, y - 0.4), (2.0, y - 1.1), (1.5, y - 1.5), (0.0, y - 1.5)];
    let r = [vec![(0.0, 0.0)], bowl(3.0).to_vec(), vec![(0.8, 1.5), (2.0, 0.0)]].concat();
    let b = [vec![(0.0, 0.0)], bowl(3.0).to_vec(), bowl(1.5)[1..].to_vec()].concat();
    let s = [
        (2.0, 2.6),
        (1.5, 3.0),
        (0.5, 3.0),
        (0.0, 2.6),
        (0.0, 2.0),
        (0.5, 1.6),
        (1.5, 1.4),
        (2.0, 1.0),
        (2.0, 0.4),
        (1.5, 0.0),
        (0.5, 0.0),
        (0.0, 0.4),
    ];
    vec![
        letter(0.0, &[(0.0, 0.0), (0.0, 3.0), (2.0, 0.0), (2.0, 3.0)]),
        letter(3.0, &[(0.0, 3.0), (0.0, 0.5), (0.5, 0.0), (1.5, 0.0), (2.0, 0.5), (2.0, 3.0)]),
        letter(6.0, &r),
        letter(9.0, &b),
        letter(12.0, &s),
    ]
}

/// Letters as polylines; what is near them is pulled up.
fn letters() -> Outcome<()> {
    let surface = sheet()?;
    let place = |(x, y): (f64, f64)| (0.08 + 0.06 * x, 0.34 + 0.12 * y);
    let lines: Vec<Vec<(f64, f64)>> =
        strokes().into_iter().map(|line| line.into_iter().map(place).collect()).collect();
    let field = Gravity::new(lines.clone(), 0.014)?;
    let region = Region::new((0.03, 0.28), (0.97, 0.76)).refined(Refinement::Spacing(0.006));
    let along = |at: &Assigned<(f64, f64)>| {
        let Some(pull) = field.pull(&at.parameter) else { return Ok(None) };
        Ok(Some(surface.unit_normal(&pull.foot)? * 0.05))
    };
    let warped = Warp::new(region, along).apply(&surface)?;
    println!("{} knots inserted, {} points moved", warped.inserted.len(), warped.moved);
    let mut before = shaded(
        Panel::new()
            .title("(a) Five polylines in the parameter plane, on the surface")
            .equal_axes()
            .x_range(0.0, 1.5)
            .height(290.0),
        &surface,
        30,
    )?;
    for line in &lines {
        before = before.polyline(traced(&surface, line)?, Style::line(Color::VERMILLION).width(2.0));
    }
    let after = Panel::new()
        .title("(b) Their gravity fields, pulled along the normal")
        .equal_axes()
        .x_range(0.0, 1.5)
        .height(290.0);
    let after = shaded(after, &warped.shape, 150)?;
    let figure = Figure::new(900.0).title("A polyline warp").panel(before).panel(after);
    write(&figure, &target("shape_warps_letters"))
}
