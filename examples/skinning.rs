//! A skin over sections, before and after three of them are fine-tuned [Miura, Fig. 9].
//!
//! A hull goes on from another surface with a common tangent plane, and ends with given tangents. Sections two to four are
//! fine-tuned, each on a portion of its own by a positive scale function with the knots of the section, the nearest to what is wanted
//! that keeps the ends of the portion with two derivatives. Then they are brought back to the degree and the knots of the section, so
//! that the skin has the same knots and as many control points as before. How far that is off is certified.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::{SVector, vector};
use support::{Outcome, target, write};
use symspline::plot::{Color, ColorScale, Figure, Mesh, Panel, Scene, View};
use symspline::{Curve, Direction, Function, Norm, Skin, SplineSpace, Surface};

type Section = Curve<f64, 3>;
type Sheet = Surface<f64, 3>;

/// Where the sections stand.
const PLACES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

fn main() -> Outcome<()> {
    let before = neighbour()?;
    let edge = before.isocurve(Direction::V, &1.0)?;
    let mut sections = vec![edge];
    for y in &PLACES[1..] {
        sections.push(section(*y)?);
    }
    // The parameters of the sections stay what they were measured to be.
    let places = Skin::through(&sections)?.by_chord_length()?.parameters().to_vec();
    let hull = skin(&sections, &places, &before)?;
    let mut tuned = sections.clone();
    println!(
        "{:>8}{:>10}{:>10}{:>12}{:>16}{:>14}",
        "section", "degree", "controls", "unreduced", "moved, most", "off, at most"
    );
    for (index, (a, b), value) in [(1, (0.1, 0.7), 3.0), (2, (0.2, 0.8), 0.12), (3, (0.3, 0.9), 3.0)] {
        let old = &sections[index];
        // The segmentation of the section: a wave over the portion, one at its ends.
        let breaks = old.space().restricted_space(&a, &b)?.breaks();
        let scales = SplineSpace::clamped(2, breaks.into_iter().map(|(t, _)| t))?;
        let wave = |t: f64| 1.0 + (value - 1.0) * (std::f64::consts::PI * (t - a) / (b - a)).sin().powi(2);
        let values = scales.greville().into_iter().map(wave).collect();
        let alpha = Function::new(scales, values)?;
        let local = old.fine_tuned_on_by_nearest(&alpha, 2, Norm::L2)?;
        let near = local.in_original_space()?;
        assert_eq!(near.spline.space(), old.space());
        println!(
            "{:>8}{:>10}{:>10}{:>12}{:>16.5}{:>14.1e}",
            index + 1,
            near.spline.degree(),
            near.spline.coeffs().len(),
            local.joined()?.coeffs().len(),
            near.spline.distance_bound_halved(old, 3)?,
            near.bound
        );
        tuned[index] = near.spline;
    }
    let deformed = skin(&tuned, &places, &before)?;
    assert!(deformed.u() == hull.u() && deformed.v() == hull.v());
    let (gap, angle) = meeting(&before, &deformed)?;
    println!("where the skin goes on from its neighbour: gap {gap:.1e}, angle between normals {angle:.1e}");
    draw(
        &before,
        [
            ("sections, and the surface it goes on from", &hull, &sections),
            ("sections 2, 3 and 4 fine-tuned", &deformed, &tuned),
        ],
    )
}

/// The skin through the sections, tangent to the surface before it, and level at its end.
fn skin(sections: &[Section], places: &[f64], before: &Sheet) -> Outcome<Sheet> {
    let level = Section::constant(sections[0].space().clone(), vector![0.0, 0.7, 0.0])?;
    let skin = Skin::through(sections)?.with_parameters(places)?;
    Ok(skin.continuing(before, &0.7, &1e-12)?.end_tangents(&level)?.surface(3)?)
}

/// The arch at place `y`, a cubic of thirty spans.
fn section(y: f64) -> Outcome<Section> {
    let space = SplineSpace::uniform(3, 30, 0.0, 1.0)?;
    let rise = 0.3 + 0.05 * (4.0 * y).cos();
    let point = |x: f64| vector![x, 1.2 * y, rise * (std::f64::consts::PI * x).sin()];
    let points = space.greville().into_iter().map(point).collect();
    Ok(Section::new(space, points)?)
}

/// The surface that the skin goes on from: the first arch drawn out.
fn neighbour() -> Outcome<Sheet> {
    let arch = section(PLACES[0])?;
    let far = arch.translated(&vector![0.0, -0.35, 0.0])?;
    Ok(Skin::through(&[far, arch])?.surface(1)?)
}

/// The largest gap between the edges, and the largest angle between the normals there, at a hundred parameters.
fn meeting(before: &Sheet, after: &Sheet) -> Outcome<(f64, f64)> {
    let (mut gap, mut angle) = (0.0_f64, 0.0_f64);
    for k in 0..=100 {
        let u = f64::from(k) / 100.0;
        let [p, pu, pv] = before.tangents_at(&u, &1.0)?;
        let [q, qu, qv] = after.tangents_at(&u, &0.0)?;
        let normals = [pu.cross(&pv).normalize(), qu.cross(&qv).normalize()];
        gap = gap.max((p - q).norm());
        angle = angle.max(normals[0].cross(&normals[1]).norm());
    }
    Ok((gap, angle))
}

/// Each skin with its sections, going on from its neighbour: shape, and mean curvature as colours.
fn draw(before: &Sheet, skins: [(&str, &Sheet, &Vec<Section>); 2]) -> Outcome<()> {
    let sampled = |(_, skin, _): &(&str, &Sheet, &Vec<Section>)| {
        Mesh::sampled(*skin, 160, 120, Sheet::mean_curvature_at)
    };
    let meshes = skins.iter().map(sampled).collect::<symspline::Result<Vec<Mesh>>>()?;
    let beside = Mesh::of(before, 160, 16)?;
    let colors = ColorScale::about_zero(&meshes.iter().collect::<Vec<_>>(), 0.95)?;
    let view = View::new(-50.0, 32.0).framing(&[&meshes[0], &meshes[1], &beside])?;
    let (gray, light) = (Color::new(170, 170, 170), Color::new(205, 210, 215));
    let mut shape = Panel::new();
    let mut curvature = Panel::new().color_bar(&colors, "mean curvature");
    for (mesh, (caption, _, sections)) in meshes.iter().zip(skins) {
        let mut plain = Scene::new().mesh(mesh, light).mesh(&beside, gray);
        let mut colored = Scene::new().mesh(mesh, &colors).mesh(&beside, gray);
        for section in sections {
            let points = (0..=160).map(|k| section.at(&(f64::from(k) / 160.0)));
            let points: Vec<SVector<f64, 3>> = points.collect::<symspline::Result<_>>()?;
            plain = plain.line(points.clone(), Color::GREEN, 3.0);
            colored = colored.line(points, Color::new(60, 60, 60), 1.5);
        }
        shape = shape.picture(caption, plain.image(&view, 900, 600)?);
        curvature = curvature.picture(caption, colored.image(&view, 900, 600)?);
    }
    let figure = Figure::new(1000.0).title("A skin deformed by fine tuning three of its sections");
    write(&figure.panel(shape).panel(curvature), &target("skinning"))
}
