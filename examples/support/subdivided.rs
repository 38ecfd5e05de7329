//! Pictures of control meshes and of the surfaces they control.

use super::Outcome;
use symspline::ControlMesh;
use symspline::plot::{Color, Image, Mesh, Scene, View, edge_lines};

pub type Solid = ControlMesh<f64, 3>;

const SIZE: (usize, usize) = (640, 560);
const STONE: Color = Color::new(150, 172, 196);
const LINE: Color = Color::new(92, 112, 140);
const WHOLE: Color = Color::new(247, 200, 30);
const NONE: Color = Color::new(214, 40, 40);

/// Flat faces, and edges in two colours: red those that `none` picks.
pub fn wired(mesh: &Solid, view: &View, none: impl Fn(usize) -> bool) -> Outcome<Image> {
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

/// A smooth surface, with the lines of its mesh if there are not too many.
pub fn smooth(mesh: &Solid, view: &View) -> Outcome<Image> {
    let faces = Mesh::try_from(mesh)?;
    let mut scene = Scene::new().mesh(&faces, STONE);
    if mesh.points().len() < 10_000 {
        scene = scene.lines(edge_lines(mesh, |_| true), LINE, 1.2);
    }
    Ok(scene.image(view, SIZE.0, SIZE.1)?)
}
