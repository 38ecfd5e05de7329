//! What the weights of an elastic material do [Vassilev, Fig. 5]: the same point of a sheet pulled to the same place with more
//! resistance to bending, and with a harder material; a curve with several of each.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use support::solid::Sheet;
use support::{Outcome, Plane, target};
use symspline::plot::{
    Color, ColorScale, Figure, Marker, Mesh, Panel, Scene, Style, View, curve_path, knot_lines,
};
use symspline::{Breadth, Elastic, Material, SplineSpace};

fn main() -> Outcome<()> {
    sheets()?;
    curves()
}

/// How much of a list of heights is above half of the largest.
fn breadth_at_half(heights: &[f64]) -> f64 {
    let most = heights.iter().copied().fold(0.0, f64::max);
    heights.iter().filter(|z| **z > most / 2.0).count() as f64 / heights.len() as f64
}

/// Fig. 5: one point of a flat bicubic sheet pulled upwards, all control points free.
fn sheets() -> Outcome<()> {
    let space = SplineSpace::uniform(3, 20, 0.0, 20.0)?;
    let nodes = space.greville();
    let points = nodes.iter().flat_map(|x| nodes.iter().map(move |y| vector![*x, *y, 0.0])).collect();
    let flat = Sheet::new(space.clone(), space, points)?;
    let (at, top) = ((10.0, 10.0), vector![10.0, 10.0, 6.0]);
    let mut sheets = Vec::new();
    for (stretching, bending, hardness) in [(1.0, 2.0, 0.1), (1.0, 20.0, 0.1), (1.0, 20.0, 0.5)] {
        let material = Material::new(stretching, bending)?.with_hardness(hardness)?;
        let elastic = Elastic::of(&flat, &material, &[Breadth::Whole, Breadth::Whole])?;
        let mut sheet = flat.clone();
        let force = elastic.pull(&flat, &at)?.move_to(&mut sheet, &top)?;
        let places: Vec<f64> = (0..=200).map(|i| f64::from(i) / 10.0).collect();
        let heights: Vec<f64> = sheet.eval_grid(&places, &[10.0])?.iter().map(|p| p[2]).collect();
        println!(
            "α = {stretching}, β = {bending}, γ = {hardness}: force {:.1}, energy {:.1}, {:.0} % of the middle line above half",
            force.norm(),
            material.energy(&sheet.isocurve(symspline::Direction::V, &10.0)?)?,
            100.0 * breadth_at_half(&heights)
        );
        let name = ["(a)", "(b)", "(c)"][sheets.len()];
        sheets.push((format!("{name} α = {stretching}, β = {bending}, γ = {hardness}"), sheet));
    }
    let height = |sheet: &Sheet, u: &f64, v: &f64| Ok(sheet.at(u, v)?[2]);
    let sampled = |(_, sheet): &(String, Sheet)| Mesh::sampled(sheet, 120, 120, height);
    let meshes = sheets.iter().map(sampled).collect::<symspline::Result<Vec<Mesh>>>()?;
    let all: Vec<&Mesh> = meshes.iter().collect();
    let colors = ColorScale::rising(&all, 1.0)?;
    let view = View::new(-60.0, 22.0).framing(&all)?;
    let mut panel = Panel::new().color_bar(&colors, "height");
    for (mesh, (caption, sheet)) in meshes.iter().zip(&sheets) {
        let lines = knot_lines(sheet, 80)?;
        let scene = Scene::new().mesh(mesh, &colors).lines(lines, Color::new(70, 70, 70), 1.2);
        panel = panel.picture(caption, scene.image(&view, 760, 500)?);
    }
    let figure = Figure::new(1100.0)
        .title("One point of a sheet of 23 x 23 control points pulled to the same height: resistance to bending, hardness")
        .panel(panel);
    support::write(&figure, &target("deform_sheets"))
}

/// A straight curve pulled at one point, with each of the three weights varied.
fn curves() -> Outcome<()> {
    let space = SplineSpace::uniform(3, 30, 0.0, 30.0)?;
    let flat = Plane::new(space.clone(), space.greville().iter().map(|x| vector![*x, 0.0]).collect())?;
    let rows = [
        (
            "(a) γ from 0.01 to 10, α = 1, β = 2",
            [(1.0, 2.0, 0.01), (1.0, 2.0, 0.1), (1.0, 2.0, 1.0), (1.0, 2.0, 10.0)],
        ),
        (
            "(b) α from 0 to 100, β = 2, γ = 0.1",
            [(0.0, 2.0, 0.1), (1.0, 2.0, 0.1), (10.0, 2.0, 0.1), (100.0, 2.0, 0.1)],
        ),
        (
            "(c) β from 0 to 200, α = 1, γ = 0.1",
            [(1.0, 0.0, 0.1), (1.0, 2.0, 0.1), (1.0, 20.0, 0.1), (1.0, 200.0, 0.1)],
        ),
    ];
    let colors = [Color::BLACK, Color::BLUE, Color::VERMILLION, Color::GREEN];
    let mut figure =
        Figure::new(900.0).title("A curve pulled by 6 at its middle, 33 control points, the ends held");
    for (title, materials) in rows {
        let mut panel =
            Panel::new().title(title).equal_axes().x_range(-0.5, 30.5).y_range(-1.2, 6.8).height(250.0);
        for ((stretching, bending, hardness), color) in materials.into_iter().zip(colors) {
            let material = Material::new(stretching, bending)?.with_hardness(hardness)?;
            let elastic = Elastic::of(&flat, &material, &[Breadth::BetweenEnds(1)])?;
            let mut curve = flat.clone();
            elastic.pull(&flat, &15.0)?.move_to(&mut curve, &vector![15.0, 6.0])?;
            let name = match title.as_bytes()[1] {
                b'a' => format!("γ = {hardness}"),
                b'b' => format!("α = {stretching}"),
                _ => format!("β = {bending}"),
            };
            panel = panel.path(curve_path(&curve, 1e-3)?, Style::line(color).width(1.8)).label(name);
        }
        figure = figure.panel(panel.markers([(15.0, 6.0)], Marker::Square, Style::line(Color::GRAY)));
    }
    support::write(&figure, &target("deform_curves"))
}
