//! Surfaces fine-tuned by scaling their derivatives [Miura, section 3], with Gaussian and mean curvature as colours.
//!
//! A patch with its boundary held, its middle pulled and pushed (Fig. 11); a long surface along its shorter direction, with
//! curvatures held across the boundary (Fig. 12); a rectangle in the middle of a surface with each of the three fits (Fig. 13);
//! a patch of the Utah teapot that goes on fitting its neighbours; and a hull whose keel and deck stay by the choice of the
//! scale alone, without any rotation.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use std::f64::consts::PI;
use support::solid::{Sheet, hull, teapot};
use support::{Outcome, target};
use symspline::plot::{
    Color, ColorScale, Figure, Mesh, Panel, Scene, View, control_net, knot_lines, write_glb,
};
use symspline::{
    Direction, Edge, Edges, Fit, NearestScale, Norm, Path, SplineSpace, SurfaceCondition, TensorSpline,
};

type Field = TensorSpline<f64>;

fn main() -> Outcome<()> {
    patch()?;
    long()?;
    rectangle()?;
    pot()?;
    ship()
}

/// A bicubic surface over the unit square, `rows` by `columns` control points, with heights.
fn sheet(rows: usize, columns: usize, size: (f64, f64), height: impl Fn(f64, f64) -> f64) -> Outcome<Sheet> {
    let space = |count: usize| SplineSpace::uniform(3, count - 3, 0.0, 1.0);
    let (u, v) = (space(rows)?, space(columns)?);
    let (us, vs) = (u.greville(), v.greville());
    let point = |x: &f64, y: &f64| vector![size.0 * x, size.1 * y, height(*x, *y)];
    let points = us.iter().flat_map(|x| vs.iter().map(move |y| point(x, y))).collect();
    Ok(Sheet::new(u, v, points)?)
}

/// A scale function with the same degree in both directions, of values one but for some.
fn scale(
    degree: usize,
    domain: [(f64, f64); 2],
    (rows, columns): (usize, usize),
    values: &[(usize, usize, f64)],
) -> Outcome<Field> {
    let space = |(a, b): (f64, f64), count: usize| SplineSpace::uniform(degree, count - degree, a, b);
    let mut all = vec![1.0; rows * columns];
    values.iter().for_each(|(i, j, value)| all[i * columns + j] = *value);
    Ok(Field::new(space(domain[0], rows)?, space(domain[1], columns)?, all)?)
}

const UNIT: [(f64, f64); 2] = [(0.0, 1.0); 2];

/// Surfaces before and after: Gaussian and mean curvature of each, one scale of colours for all.
struct Comparison<'a> {
    name: &'a str,
    title: &'a str,
    surfaces: &'a [(&'a str, &'a Sheet)],
    view: View,
    size: (usize, usize),
    /// How much of the area the colours show without clipping.
    share: f64,
    net: bool,
}

impl Comparison<'_> {
    fn write(&self) -> Outcome<()> {
        type Curvature = fn(&Sheet, &f64, &f64) -> symspline::Result<f64>;
        let kinds: [(Curvature, &str); 2] = [
            (Sheet::gaussian_curvature_at, "Gaussian curvature"),
            (Sheet::mean_curvature_at, "mean curvature"),
        ];
        let mut figure = Figure::new(1100.0).title(self.title);
        for (curvature, label) in kinds {
            let sampled = |(_, sheet): &(&str, &Sheet)| Mesh::sampled(*sheet, 96, 96, curvature);
            let meshes = self.surfaces.iter().map(sampled).collect::<symspline::Result<Vec<Mesh>>>()?;
            let all: Vec<&Mesh> = meshes.iter().collect();
            let colors = ColorScale::about_zero(&all, self.share)?;
            let view = self.view.clone().framing(&all)?;
            let mut panel = Panel::new().color_bar(&colors, label);
            for (mesh, (caption, sheet)) in meshes.iter().zip(self.surfaces) {
                let mut scene = Scene::new().mesh(mesh, &colors).lines(
                    knot_lines(*sheet, 80)?,
                    Color::new(70, 70, 70),
                    1.2,
                );
                if self.net {
                    scene = scene.lines(control_net(sheet), Color::new(120, 120, 120), 1.0);
                }
                panel = panel.picture(*caption, scene.image(&view, self.size.0, self.size.1)?);
            }
            figure = figure.panel(panel);
            let kind = label.split(' ').next().unwrap_or_default().to_lowercase();
            let last = meshes.last().ok_or("no surfaces")?;
            write_glb(target(&format!("{}_{kind}.glb", self.name)), &[(last, (&colors).into())])?;
        }
        let path = target(self.name);
        figure.write_svg(path.with_extension("svg"))?;
        figure.write_png(path.with_extension("png"), 1.5)?;
        println!("wrote {} as SVG and PNG, and its last surface as glb", path.display());
        Ok(())
    }
}

/// Fig. 11: the middle value of the scale down to -1.7 and up to 16, the boundary held.
fn patch() -> Outcome<()> {
    let before = sheet(4, 4, (3.0, 3.0), |u, v| 2.4 * u * (1.0 - u) + 1.6 * v * (1.0 - v))?;
    let tuned = |middle: f64| -> Outcome<Sheet> {
        let alpha = scale(2, UNIT, (3, 3), &[(1, 1, middle)])?;
        let held = before.fine_tuned_holding(&alpha, Path::Both, Edges::all(Fit::Position))?;
        let gap = before.path_gap(&alpha)?;
        println!(
            "middle value {middle:>4}: scale from {:.3} to {:.3}, paths end up to {:.3} apart, forced by {:.1e}",
            alpha.range(&1e-6)?.least.value,
            alpha.range(&1e-6)?.greatest.value,
            gap.bound,
            held.forced
        );
        Ok(held.surface)
    };
    let (less, more) = (tuned(-1.7)?, tuned(16.0)?);
    Comparison {
        name: "surface_patch",
        title: "A bicubic patch, 3 x 3 values of the scale, the middle one changed, boundary held",
        surfaces: &[("before", &before), ("middle value -1.7", &less), ("middle value 16", &more)],
        view: View::new(-58.0, 28.0),
        size: (760, 520),
        share: 0.97,
        net: true,
    }
    .write()
}

/// Fig. 12: two middle values of 3 x 4 down to -0.8 on a surface of 6 x 12 control points, along the shorter direction.
fn long() -> Outcome<()> {
    let wave = |u: f64, v: f64| 1.1 * (3.1 * u).sin() * (1.0 + 0.25 * (5.0 * v).sin());
    let before = sheet(6, 12, (2.0, 6.0), wave)?;
    let alpha = scale(2, UNIT, (3, 4), &[(1, 1, -0.8), (1, 2, -0.8)])?;
    let held = before.fine_tuned_holding(&alpha, Path::VThenU, Edges::all(Fit::Curvature))?;
    println!("6 x 12 control points: forced by {:.3} to hold curvatures", held.forced);
    Comparison {
        name: "surface_long",
        title: "6 x 12 control points, 3 x 4 values of the scale, two of them -0.8, tuned along the shorter direction",
        surfaces: &[("before", &before), ("after, curvatures held across the boundary", &held.surface)],
        view: View::new(-30.0, 32.0),
        size: (1100, 620),
        share: 0.95,
        net: false,
    }
    .write()
}

/// Fig. 13: the middle of a surface flattened by a middle value of 4, with each fit to the rest.
fn rectangle() -> Outcome<()> {
    let hill = |u: f64, v: f64| 1.6 * (-5.0 * ((u - 0.5).powi(2) + (v - 0.5).powi(2))).exp();
    let before = sheet(13, 13, (3.0, 3.0), hill)?;
    let alpha = scale(2, [(0.1, 0.9); 2], (3, 3), &[(1, 1, 4.0)])?;
    let mut found = Vec::new();
    for (fit, name) in [(Fit::Position, "C0"), (Fit::Tangent, "G1"), (Fit::Curvature, "G2")] {
        let local = before.fine_tuned_on(&alpha, Path::UThenV, Edges::all(fit))?;
        let whole = local.joined()?;
        let (outside, inside) = ((0.05, 0.5), (0.5, 0.35));
        println!(
            "{name}: outside moved by {:.1e}, a point inside by {:.3}, {} x {} control points",
            (whole.at(&outside.0, &outside.1)? - before.at(&outside.0, &outside.1)?).norm(),
            (whole.at(&inside.0, &inside.1)? - before.at(&inside.0, &inside.1)?).norm(),
            whole.u().dim(),
            whole.v().dim()
        );
        found.push(whole);
    }
    Comparison {
        name: "surface_rectangle",
        title: "A rectangle fine-tuned by a middle value of 4, fitting the rest with C0, G1 and G2",
        surfaces: &[("before", &before), ("C0", &found[0]), ("G1", &found[1]), ("G2", &found[2])],
        view: View::new(-55.0, 34.0),
        size: (700, 520),
        share: 0.95,
        net: false,
    }
    .write()
}

/// A patch of the teapot's body, flattened and bulged, its tangent planes at all edges kept.
fn pot() -> Outcome<()> {
    let before = teapot()?.into_iter().nth(4).ok_or("the teapot has patches")?;
    // More values than the patch has control points, so that something is left to choose.
    let tuned = |value: f64| -> Outcome<Sheet> {
        let inner = (3..5).flat_map(|i| (3..5).map(move |j| (i, j, value))).collect::<Vec<_>>();
        let alpha = scale(3, UNIT, (8, 8), &inner)?;
        let held = before.fine_tuned_holding(&alpha, Path::Both, Edges::all(Fit::Tangent))?;
        println!("teapot, values {value}: forced by {:.1e} to keep tangent planes", held.forced);
        Ok(held.surface)
    };
    let (less, more) = (tuned(0.4)?, tuned(2.5)?);
    Comparison {
        name: "surface_teapot",
        title: "A patch of the Utah teapot, tangent planes held at all edges",
        surfaces: &[("before", &before), ("values 0.4 inside", &less), ("values 2.5 inside", &more)],
        view: View::new(-20.0, 18.0),
        size: (760, 560),
        share: 0.95,
        net: false,
    }
    .write()
}

/// A hull with fuller frames amidships, its keel and its deck kept by the choice of the scale: nothing is rotated, and
/// `∂T/∂v = α S_v` holds everywhere.
fn ship() -> Outcome<()> {
    let before = hull()?;
    let space = |direction: Direction| {
        let (a, b) = before.space(direction).domain();
        SplineSpace::uniform(3, 5, *a, *b)
    };
    let (u, v) = (space(Direction::U)?, space(Direction::V)?);
    let conditions = [Edge::VStart, Edge::VEnd].map(|edge| SurfaceCondition::Edge { edge, order: 0 });
    let nearest = NearestScale::on_surface(&before, (&u, &v), Path::UThenV, &conditions, Norm::L2)?;
    // The frames bend sharply where they turn upwards, and are nearly straight below and above.
    let (us, vs) = (u.greville(), v.greville());
    let wave =
        |x: &f64, y: &f64| 1.0 - 0.95 * (PI * x).sin().powi(2) * (1.0 - (2.0 * PI * (y - 0.1)).cos()) / 2.0;
    let values = us.iter().flat_map(|x| vs.iter().map(move |y| wave(x, y))).collect();
    let alpha = nearest.to(&Field::new(u, v, values)?)?;
    let after = before.fine_tuned(&alpha, Path::UThenV)?;
    let mut off = 0.0_f64;
    for edge in [Edge::VStart, Edge::VEnd] {
        let (a, b) = before.space(edge.direction()).domain();
        let end = if edge.is_end() { b } else { a };
        let [was, is] = [&before, &after].map(|sheet| sheet.isocurve(edge.direction(), end));
        off = off.max(was?.distance_bound(&is?)?);
    }
    println!(
        "hull: {} of 64 values are free, keel and deck are off by {off:.1e} at most",
        64 - nearest.rank()
    );
    Comparison {
        name: "surface_hull",
        title: "The Wigley hull with other frames, keel and deck kept by the choice of the scale",
        surfaces: &[("before", &before), ("after", &after)],
        view: View::new(9.0, 4.0),
        size: (1100, 560),
        share: 0.95,
        net: false,
    }
    .write()
}
