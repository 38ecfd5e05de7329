//! Doo-Sabin surfaces fine tuned by control values on the edges of their meshes [Miura, Fig. 16]: a cube on its corner, and a pawn
//! whose head and foot are tuned while the rest stays.
//!
//! A yellow edge has knot interval 1, a red one 0; for the pictures 0.05 stands for 0.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use nalgebra::vector;
use std::time::Instant;
use support::subdivided::{Solid, smooth, wired};
use support::{Outcome, data, target};
use symspline::io::obj;
use symspline::plot::{Figure, Mesh, Panel, View};
use symspline::{Boundary, ControlMesh, DooSabin, MeshSprings};

const DEPTH: usize = 3;

fn main() -> Outcome<()> {
    let cube = cube()?;
    // The corner at the top is 7; the neighbours of the one at the bottom stay.
    let alpha = cube.topology().edges().map(|ends| if ends.contains(&7) { 2.0 } else { 1.0 }).collect();
    let springs = MeshSprings { fixed: vec![1, 2, 4], ..MeshSprings::default() };
    let view = View::new(-20.0, 12.0);
    let cube = tuned("cube: 2 on the edges at its top, three vertices stay", &cube, alpha, &springs, view)?;

    let pawn = obj::read_file(data("subd_pawn.obj"))?;
    let high = |v: usize| pawn.points()[v][2];
    let (head, foot) = (|v: usize| high(v) > 0.385, |v: usize| high(v) < 0.13);
    let value = |[v, w]: [usize; 2]| match (head(v) && head(w), foot(v) && foot(w)) {
        (true, _) => 1.25,
        (_, true) => 0.85,
        _ => 1.0,
    };
    let alpha = pawn.topology().edges().map(value).collect();
    let moving = (0..pawn.topology().vertex_count()).filter(|v| high(*v) > 0.36 || high(*v) < 0.16);
    let springs = MeshSprings { moving: Some(moving.collect()), ..MeshSprings::default() };
    let pawn = tuned(
        "pawn: 1.25 on the head, 0.85 on the foot, the rest stays",
        &pawn,
        alpha,
        &springs,
        View::new(-60.0, 18.0),
    )?;

    let figure = Figure::new(1500.0).title("Fine-tuned Doo-Sabin surfaces [Miura, Fig. 16]");
    let figure = cube.into_iter().chain(pawn).fold(figure, Figure::panel);
    let path = target("fine_tune_mesh");
    figure.write_svg(path.with_extension("svg"))?;
    figure.write_png(path.with_extension("png"), 1.0)?;
    println!("wrote {} as SVG and PNG", path.display());
    Ok(())
}

/// A cube with the corner 0 at the bottom and 7 at the top.
fn cube() -> symspline::Result<Solid> {
    let along = [0.0, 1.0, 2.0].map(|k: f64| {
        let turn = std::f64::consts::TAU * k / 3.0;
        vector![turn.cos(), turn.sin(), std::f64::consts::FRAC_1_SQRT_2]
    });
    let corner = |k: usize| (0..3).filter(|axis| k >> axis & 1 == 1).map(|axis| along[axis]).sum();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    ControlMesh::new((0..8).map(corner).collect(), faces)
}

/// The meshes and the surfaces, before and after.
fn tuned(
    title: &str,
    mesh: &Solid,
    alpha: Vec<f64>,
    springs: &MeshSprings,
    view: View,
) -> Outcome<[Panel; 2]> {
    let surface = DooSabin::new(mesh.clone(), Boundary::Smooth);
    let start = Instant::now();
    let tuned = surface.fine_tuned(&alpha, springs)?;
    let time = start.elapsed();
    println!(
        "{title}\n  {} vertices, energy {:.4} to {:.4} (lengths {:.4}, loops {:.4}, neighbours {:.4}), {} steps, {:.0} ms",
        tuned.surface.mesh().points().len(),
        tuned.energy_before,
        tuned.energy,
        tuned.terms[0],
        tuned.terms[1],
        tuned.terms[2],
        tuned.iterations,
        time.as_secs_f64() * 1e3,
    );
    let all = [Mesh::try_from(mesh)?, Mesh::try_from(tuned.surface.mesh())?];
    let view = view.framing(&[&all[0], &all[1]])?;
    let shown = [&tuned.invariant, &tuned.surface].map(|surface| surface.with_least_interval(0.05));
    let [before, after] = shown;
    let (before, after) = (before?, after?);
    let meshes = Panel::new()
        .title(title)
        .picture("control mesh", wired(mesh, &view, |_| false)?)
        .picture(
            "converted: intervals 1 and 0",
            wired(before.mesh(), &view, |e| before.intervals().is_some_and(|d| d[e] < 1.0))?,
        )
        .picture("deformed", wired(after.mesh(), &view, |e| after.intervals().is_some_and(|d| d[e] < 1.0))?);
    let surfaces = Panel::new()
        .picture("Doo-Sabin", smooth(surface.refined(DEPTH)?.mesh(), &view)?)
        .picture("converted, as Catmull-Clark", smooth(before.refined(DEPTH)?.mesh(), &view)?)
        .picture("deformed", smooth(after.refined(DEPTH)?.mesh(), &view)?);
    Ok([meshes, surfaces])
}
