//! Subdivision surfaces: control meshes, the Doo-Sabin surface as a Catmull-Clark surface over knot intervals 0 and 1
//! [Miura, Fig. 16].
//!
//! A yellow edge has knot interval 1, a red one 0.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use support::{Outcome, data, target};
use symspline::io::obj;
use symspline::plot::{Color, Figure, Image, Mesh, Panel, Scene, View, edge_lines};
use symspline::{Boundary, ControlMesh, DooSabin};

type Solid = ControlMesh<f64, 3>;

const SIZE: (usize, usize) = (640, 560);
const STONE: Color = Color::new(150, 172, 196);
const WHOLE: Color = Color::new(247, 200, 30);
const NONE: Color = Color::new(214, 40, 40);

/// A file, and where it is looked at from: azimuth and elevation in degrees.
const SHAPES: [(&str, f64, f64); 5] = [
    ("cube", -25.0, 22.0),
    ("pyramid", -60.0, 24.0),
    ("torus", -65.0, 42.0),
    ("pawn", -60.0, 24.0),
    ("helmet", -35.0, 24.0),
];

fn main() -> Outcome<()> {
    println!(
        "mesh       vertices   edges   faces  boundaries   converted: vertices   edges of interval 0 and 1"
    );
    let mut figure =
        Figure::new(1180.0).title("Control meshes, and Doo-Sabin surfaces converted [Miura, Fig. 16]");
    for (name, azimuth, elevation) in SHAPES {
        let mesh = obj::read_file(data(&format!("subd_{name}.obj")))?;
        let view = View::new(azimuth, elevation).framing(&[&Mesh::try_from(&mesh)?])?;
        let converted = DooSabin::new(mesh.clone(), Boundary::Smooth).converted()?;
        let none = |e: usize| converted.intervals().is_some_and(|intervals| intervals[e] == 0.0);
        let panel = Panel::new()
            .title(name)
            .picture("control mesh", drawn(&mesh, &view, |_| false)?)
            .picture("converted: knot intervals 1 and 0", drawn(converted.mesh(), &view, none)?);
        // Here come the refined surfaces (d)-(f): `DooSabin::refined`, `CatmullClark::refined`, and fine tuned ones.
        figure = figure.panel(panel);
        report(name, &mesh, converted.mesh(), none);
    }
    let path = target("subdivide");
    figure.write_svg(path.with_extension("svg"))?;
    figure.write_png(path.with_extension("png"), 1.0)?;
    println!("wrote {} as SVG and PNG", path.display());
    Ok(())
}

/// Flat faces, edges in two colours, and vertices as dots.
fn drawn(mesh: &Solid, view: &View, none: impl Fn(usize) -> bool) -> Outcome<Image> {
    let faces = Mesh::try_from(mesh)?.faceted()?;
    let fine = mesh.points().len() > 300;
    let (width, dots) = if fine { (2.0, 0.0) } else { (4.0, 11.0) };
    let scene = Scene::new()
        .mesh(&faces, STONE)
        .lines(edge_lines(mesh, |e| !none(e)), WHOLE, width)
        .lines(edge_lines(mesh, &none), NONE, width)
        .dots(mesh.points().iter().copied(), Color::BLACK, dots);
    Ok(scene.image(view, SIZE.0, SIZE.1)?)
}

fn report(name: &str, mesh: &Solid, converted: &Solid, none: impl Fn(usize) -> bool) {
    let (coarse, fine) = (mesh.topology(), converted.topology());
    let zeros = (0..fine.edge_count()).filter(|e| none(*e)).count();
    println!(
        "{name:<10} {:>8} {:>7} {:>7} {:>11} {:>21} {:>15} and {:>6}",
        coarse.vertex_count(),
        coarse.edge_count(),
        coarse.face_count(),
        coarse.boundaries().len(),
        fine.vertex_count(),
        zeros,
        fine.edge_count() - zeros,
    );
}
