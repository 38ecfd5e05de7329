//! Control meshes as they are drawn: faces, smooth or flat, and edges.

use crate::error::Result;
use crate::mesh::control_mesh::ControlMesh;
use crate::plot::solid::Point3;
use crate::plot::solid::mesh::Mesh;

/// The faces of a control mesh, shaded smoothly; [`Mesh::faceted`] shows each by itself.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::ControlMesh;
/// use symspline::plot::Mesh;
/// let points = vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0], vector![0.0, 1.0, 0.0]];
/// let square = ControlMesh::new(points, [[0, 1, 2, 3]])?;
/// assert_eq!(Mesh::try_from(&square)?.normals()[2], vector![0.0, 0.0, 1.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
impl TryFrom<&ControlMesh<f64, 3>> for Mesh {
    type Error = crate::error::Error;

    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge) for more than a picture takes.
    fn try_from(mesh: &ControlMesh<f64, 3>) -> Result<Self> {
        Self::new(mesh.points().to_vec(), mesh.topology().faces())
    }
}

impl Mesh {
    /// The same mesh with faces that look flat: each has its corners and its normal for itself. Values are kept.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::plot::Mesh;
    /// let roof = vec![vector![-1.0, 0.0, 0.0], vector![0.0, 0.0, 1.0], vector![0.0, 1.0, 1.0], vector![1.0, 0.0, 0.0]];
    /// let roof = Mesh::new(roof, [[0, 1, 2], [1, 3, 2]])?.faceted()?;
    /// assert_eq!(roof.positions().len(), 6);
    /// assert!(roof.normals()[1][0] < 0.0 && roof.normals()[3][0] > 0.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    ///
    /// # Errors
    /// None for a mesh that there is: it has no more vertices then than corners.
    pub fn faceted(&self) -> Result<Self> {
        let corners = || self.faces().flatten();
        let positions = corners().map(|v| self.positions()[*v]).collect();
        let values: Vec<_> = corners().map(|v| self.values()[*v]).collect();
        let faces = self.faces().scan(0, |start, face| {
            let own: Vec<usize> = (*start..*start + face.len()).collect();
            *start += face.len();
            Some(own)
        });
        Self::new(positions, faces)?.with_values(values)
    }
}

/// The edges of a control mesh that are picked by their index, as lines to draw.
///
/// # Examples
/// Edges in two colours, by their knot intervals:
/// ```
/// use nalgebra::vector;
/// use symspline::plot::{Color, Scene, edge_lines};
/// use symspline::{Boundary, ControlMesh, DooSabin};
/// let corners = vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0], vector![0.0, 1.0, 0.0]];
/// let converted = DooSabin::new(ControlMesh::new(corners, [[0, 1, 2, 3]])?, Boundary::Smooth).converted()?;
/// let lines = |whole: bool| edge_lines(converted.mesh(), |e| converted.intervals().is_none_or(|d| (d[e] > 0.0) == whole));
/// let scene = Scene::new().lines(lines(true), Color::YELLOW, 2.0).lines(lines(false), Color::VERMILLION, 2.0);
/// assert_eq!(lines(true).len() + lines(false).len(), converted.mesh().topology().edge_count());
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn edge_lines(mesh: &ControlMesh<f64, 3>, pick: impl Fn(usize) -> bool) -> Vec<[Point3; 2]> {
    let picked = (0..mesh.topology().edge_count()).filter(|e| pick(*e));
    picked.map(|e| mesh.topology().ends(e).map(|v| mesh.points()[v])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::solid::scene::Scene;
    use crate::plot::solid::view::View;
    use crate::plot::style::Color;
    use nalgebra::vector;

    fn pyramid() -> ControlMesh<f64, 3> {
        let points = vec![
            vector![1.0, 1.0, 0.0],
            vector![-1.0, 1.0, 0.0],
            vector![-1.0, -1.0, 0.0],
            vector![1.0, -1.0, 0.0],
            vector![0.0, 0.0, 1.0],
        ];
        let faces: [&[usize]; 5] = [&[3, 2, 1, 0], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];
        ControlMesh::new(points, faces).unwrap()
    }

    #[test]
    fn faces_look_flat_with_normals_of_their_own() {
        let mesh = Mesh::try_from(&pyramid()).unwrap();
        assert_eq!((mesh.positions().len(), mesh.faces().count()), (5, 5));
        let mesh = mesh.with_values((0..5).map(|v| Some(f64::from(v)))).unwrap();
        let flat = mesh.faceted().unwrap();
        assert_eq!((flat.positions().len(), flat.faces().count()), (16, 5));
        for (face, own) in mesh.faces().zip(flat.faces()) {
            let first = flat.normals()[own[0]];
            for (v, w) in face.iter().zip(own) {
                assert_eq!(
                    (flat.positions()[*w], flat.values()[*w]),
                    (mesh.positions()[*v], mesh.values()[*v])
                );
                assert_eq!(flat.normals()[*w], first);
                assert!((flat.positions()[*w] - flat.positions()[own[0]]).dot(&first).abs() < 1e-15);
            }
        }
    }

    /// From above the four upper edges are seen in their colour, the lower ones are the rim.
    #[test]
    fn picked_edges_are_seen_in_their_colours() {
        let mesh = pyramid();
        let shaded = Mesh::try_from(&mesh).unwrap().faceted().unwrap();
        let upper = |e: usize| mesh.topology().ends(e).contains(&4);
        let lines = edge_lines(&mesh, upper);
        assert_eq!(lines.len(), 4);
        assert!(lines.iter().all(|ends| ends.contains(&mesh.points()[4])));
        let scene = Scene::new().mesh(&shaded, Color::WHITE).lines(lines, Color::VERMILLION, 4.0);
        let seen = |elevation: f64| {
            let image = scene.image(&View::new(-90.0, elevation), 101, 101).unwrap();
            // The round ends of lines stick out at the rim, so only the middle is looked at.
            let middle = image
                .pixels()
                .iter()
                .enumerate()
                .filter(|(i, _)| [i / 101, i % 101].iter().all(|at| (20..=80).contains(at)));
            middle.filter(|(_, pixel)| **pixel == Color::VERMILLION).count()
        };
        assert!(seen(90.0) > 300, "{}", seen(90.0));
        assert_eq!(seen(-90.0), 0);
    }

    #[test]
    fn dots_lie_on_lines_and_are_hidden_by_what_is_in_front() {
        let mesh = pyramid();
        let shaded = Mesh::try_from(&mesh).unwrap();
        let lines = edge_lines(&mesh, |_| true);
        let scene = Scene::new().mesh(&shaded, Color::WHITE).lines(lines, Color::BLACK, 5.0);
        let scene = scene.dots([mesh.points()[4]], Color::BLUE, 21.0);
        let seen = |elevation: f64| {
            let image = scene.image(&View::new(-90.0, elevation), 101, 101).unwrap();
            image.pixels().iter().filter(|pixel| **pixel == Color::BLUE).count()
        };
        // The area of the disc less its rim, where pixels are mixed.
        assert!((280..=350).contains(&seen(90.0)), "{}", seen(90.0));
        assert_eq!(seen(-90.0), 0);
    }
}
