//! A face in profile, sculpted from a straight line by forces, after Figure 4 of the paper: a change of medium breadth whose force
//! is not in its middle, a broad one of the whole curve, a narrow one; and then lips and a chin, with more control points there.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use support::{Outcome, Plane, Point, pair, target, write};
use symspline::plot::{Color, Figure, Marker, Panel, Style, curve_path};
use symspline::{Breadth, Material, Reach, Sculptor, SplineSpace, Spread};

/// How far apart the stages are drawn.
const STEP: f64 = 0.5;

type Grip = (f64, Point, Reach<f64>);

fn main() -> Outcome<()> {
    let space = SplineSpace::uniform(3, 40, 0.0, 1.0)?;
    let points = space.greville().into_iter().map(|u| vector![0.0, 1.0 - u]).collect();
    let material = Material::new(1.0, 0.02)?;
    let mut sculptor = Sculptor::new(Plane::new(space, points)?, material).with_spread(Spread::Point);

    let forehead = (0.22, vector![0.13, 0.0], Reach::Fixed(Breadth::Range(1..28)));
    let face = (0.5, vector![0.12, 0.0], Reach::All);
    let nose = (0.53, vector![0.125, -0.015], Reach::Nearest(9));
    let mut panel = Panel::new().equal_axes().height(500.0).x_range(-0.1, 2.4).y_range(-0.03, 1.12);
    for (stage, (title, grip)) in
        [("a  medium, off the middle", forehead), ("b  broad", face), ("c  narrow", nose)]
            .into_iter()
            .enumerate()
    {
        panel = step(panel, &mut sculptor, stage, title, &[grip])?;
    }
    // Lips are smaller than the control points are apart.
    let inserted = sculptor.refine(&0.68, &[0.13], &[28])?;
    println!("{inserted} knots for the mouth and the chin");
    let near = |u: f64, x: f64, y: f64, distance: f64| (u, vector![x, y], Reach::Within(distance));
    let details = [
        near(0.75, 0.045, 0.0, 0.2),
        near(0.375, -0.03, 0.0, 0.11),
        near(0.59, -0.035, 0.01, 0.05),
        near(0.63, 0.02, 0.0, 0.035),
        near(0.664, -0.018, 0.0, 0.028),
        near(0.695, 0.02, 0.0, 0.035),
        near(0.745, -0.028, 0.0, 0.05),
        near(0.81, 0.05, -0.015, 0.09),
        near(0.9, -0.03, 0.02, 0.09),
    ];
    let panel = step(panel, &mut sculptor, 3, "d  lips and chin", &details)?;
    println!("{} edits can be undone", sculptor.edits().0);
    let face = sculptor.shape().translated(&vector![4.0 * STEP, 0.0])?;
    let panel = panel.path(curve_path(&face, 1e-4)?, Style::line(Color::BLACK).width(2.2)).text(
        (4.0 * STEP - 0.05, 1.05),
        "the profile",
        Style::line(Color::BLACK),
    );
    let figure = Figure::new(1100.0).title("A profile sculpted from a straight line").panel(panel);
    write(&figure, &target("deform_profile"))
}

/// Some grips, one after the other, each let go at once; drawn with the curve before, what moved, and the forces.
fn step(
    panel: Panel,
    sculptor: &mut Sculptor<f64, Plane>,
    stage: usize,
    title: &str,
    grips: &[Grip],
) -> Outcome<Panel> {
    let aside = vector![STEP * stage as f64, 0.0];
    let shifted = |curve: &Plane| curve.translated(&aside);
    let before = sculptor.shape().clone();
    let mut arrows = Vec::new();
    let mut moved = Vec::new();
    for (at, by, reach) in grips {
        let start = sculptor.shape().at(at)?;
        let pull = sculptor.grab_with(at, [reach.clone()])?;
        moved.extend_from_slice(pull.response().indices());
        sculptor.drag_to(&(start + by))?;
        sculptor.commit();
        arrows.extend(arrow(start + aside, start + by + aside));
    }
    moved.sort_unstable();
    moved.dedup();
    let after = sculptor.shape();
    println!("{title}: {} of {} control points moved", moved.len(), after.coeffs().len());
    let point = |i: &usize| pair(after.coeffs()[*i] + aside);
    let held = (0..after.coeffs().len()).filter(|i| moved.binary_search(i).is_err());
    let held: Vec<_> = held.map(|i| point(&i)).collect();
    // One legend for all stages.
    let named = |panel: Panel, name: &str| if stage == 0 { panel.label(name) } else { panel };
    let panel = panel.path(curve_path(&shifted(&before)?, 1e-4)?, Style::line(Color::GRAY).width(1.0));
    let panel = named(panel, "before");
    let panel = panel.markers(held, Marker::Circle, Style::line(Color::LIGHT_GRAY).width(0.8));
    let panel = named(panel, "control points held");
    let moved = moved.iter().map(point);
    let panel = panel.markers(moved, Marker::Circle, Style::line(Color::VERMILLION).width(0.8));
    let panel = named(panel, "moved");
    let panel = panel.path(curve_path(&shifted(after)?, 1e-4)?, Style::line(Color::BLACK).width(1.6));
    let panel = named(panel, "after");
    let panel = named(panel.segments(arrows, Style::line(Color::BLUE).width(1.4)), "dragged");
    Ok(panel.text((aside[0] - 0.05, 1.05), title, Style::line(Color::BLACK)))
}

/// A line with a head.
fn arrow(from: Point, to: Point) -> Vec<((f64, f64), (f64, f64))> {
    let along = to - from;
    let length = along.norm();
    let along = along * (0.018_f64.min(0.5 * length) / length);
    let across = vector![-along[1], along[0]] * 0.6;
    [(from, to), (to - along + across, to), (to - along - across, to)]
        .map(|(p, q)| (pair(p), pair(q)))
        .to_vec()
}
