//! Subdivision surfaces: control meshes, and the limits of Doo and Sabin's and of Catmull and Clark's rules.
#![allow(clippy::print_stdout, reason = "the example reports on standard output")]

mod support;

use support::subdivided::{Solid, smooth, wired};
use support::{Outcome, data, target};
use symspline::io::obj;
use symspline::plot::{Figure, Mesh, Panel, View};
use symspline::{Boundary, CatmullClark, DooSabin};

/// A file, where it is looked at from (azimuth and elevation in degrees), and how often it is subdivided.
const SHAPES: [(&str, f64, f64, usize); 5] = [
    ("cube", -25.0, 22.0, 4),
    ("pyramid", -60.0, 24.0, 4),
    ("torus", -65.0, 42.0, 3),
    ("pawn", -60.0, 24.0, 2),
    ("helmet", -62.0, 20.0, 3),
];

fn main() -> Outcome<()> {
    println!(
        "mesh       vertices   edges   faces  boundaries   faces after subdivision: Doo-Sabin  Catmull-Clark"
    );
    let mut figure = Figure::new(1500.0).title("Subdivision surfaces");
    for (name, azimuth, elevation, depth) in SHAPES {
        let mesh = obj::read_file(data(&format!("subd_{name}.obj")))?;
        let view = View::new(azimuth, elevation).framing(&[&Mesh::try_from(&mesh)?])?;
        let doo_sabin = DooSabin::new(mesh.clone(), Boundary::Smooth).refined(depth)?.limit_mesh()?;
        let catmull_clark = CatmullClark::new(mesh.clone(), Boundary::Smooth).refined(depth)?.limit_mesh()?;
        let panel = Panel::new()
            .title(name)
            .picture("control mesh", wired(&mesh, &view, |_| false)?)
            .picture("Doo-Sabin", smooth(&doo_sabin, &view)?)
            .picture("Catmull-Clark", smooth(&catmull_clark, &view)?);
        figure = figure.panel(panel);
        report(name, &mesh, [&doo_sabin, &catmull_clark]);
    }
    let path = target("subdivide");
    figure.write_svg(path.with_extension("svg"))?;
    figure.write_png(path.with_extension("png"), 1.0)?;
    println!("wrote {} as SVG and PNG", path.display());
    Ok(())
}

fn report(name: &str, mesh: &Solid, fine: [&Solid; 2]) {
    let coarse = mesh.topology();
    let [doo_sabin, catmull_clark] = fine.map(|mesh| mesh.topology().face_count());
    println!(
        "{name:<10} {:>8} {:>7} {:>7} {:>11} {doo_sabin:>35} {catmull_clark:>14}",
        coarse.vertex_count(),
        coarse.edge_count(),
        coarse.face_count(),
        coarse.boundaries().len(),
    );
}
