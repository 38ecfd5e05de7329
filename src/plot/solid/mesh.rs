//! Meshes: points, normals, a value a vertex, and faces.

use crate::error::{Error, Result};
use crate::plot::solid::Point3;
use crate::plot::solid::normals::{areas, from_areas};

/// The largest number of vertices, and of corners of faces.
const MOST: usize = 1 << 23;

/// A surface in space made of flat faces, with normals for smooth shading and a value at each vertex, if it has one.
///
/// Faces are polygons by the indices of their corners, counter-clockwise seen from the side the normals point to. Triangles
/// and quadrangles are usual; larger ones should be convex.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::plot::Mesh;
/// let corners = vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0], vector![0.0, 1.0, 0.0]];
/// let square = Mesh::new(corners, [[0, 1, 2, 3]])?.with_values([0.0, 1.0, 2.0, 1.0].map(Some))?;
/// assert_eq!(square.normals()[0], vector![0.0, 0.0, 1.0]);
/// assert_eq!(square.triangles().collect::<Vec<_>>(), [[0, 1, 2], [0, 2, 3]]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    positions: Vec<Point3>,
    normals: Vec<Point3>,
    values: Vec<Option<f64>>,
    /// The corners of all faces, and where each face ends in them.
    corners: Vec<usize>,
    ends: Vec<usize>,
}

impl Mesh {
    /// The mesh with the given faces and normals from the faces around each vertex; no values.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::IndexOutOfRange`] for a corner that is no vertex; [`Error::TooFewPoints`] for a face
    /// of fewer than three corners; [`Error::TooLarge`].
    pub fn new(positions: Vec<Point3>, faces: impl IntoIterator<Item = impl AsRef<[usize]>>) -> Result<Self> {
        let (mut corners, mut ends) = (Vec::new(), Vec::new());
        for face in faces {
            let face = face.as_ref();
            if face.len() < 3 {
                return Err(Error::TooFewPoints { expected: 3, found: face.len() });
            }
            if let Some(index) = face.iter().find(|index| **index >= positions.len()) {
                return Err(Error::IndexOutOfRange { index: *index, length: positions.len() });
            }
            check_count(corners.len() + face.len())?;
            corners.extend_from_slice(face);
            ends.push(corners.len());
        }
        let mut mesh =
            Self { normals: Vec::new(), values: vec![None; positions.len()], positions, corners, ends };
        mesh.normals = from_areas(&areas(&mesh.positions, mesh.faces()));
        mesh.checked()
    }

    /// The mesh with the given normals, of unit length.
    pub(super) fn with_normals(self, normals: Vec<Point3>) -> Result<Self> {
        Self { normals, ..self }.checked()
    }

    /// The same mesh with a value a vertex; where there is none it is drawn grey.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one a vertex; [`Error::NotFinite`].
    pub fn with_values(self, values: impl IntoIterator<Item = Option<f64>>) -> Result<Self> {
        let values: Vec<_> = values.into_iter().take(MOST + 1).collect();
        if values.len() != self.positions.len() {
            return Err(Error::CoefficientCount { expected: self.positions.len(), found: values.len() });
        }
        Self { values, ..self }.checked()
    }

    /// All meshes in one, in their order.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::plot::Mesh;
    /// let triangle = Mesh::new(vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![0.0, 1.0, 0.0]], [[0, 1, 2]])?;
    /// let two = Mesh::joined([&triangle, &triangle])?;
    /// assert_eq!(two.faces().last(), Some(&[3, 4, 5][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn joined<'a>(meshes: impl IntoIterator<Item = &'a Self>) -> Result<Self> {
        let mut all = Self::default();
        for mesh in meshes {
            check_count(all.positions.len() + mesh.positions.len())?;
            check_count(all.corners.len() + mesh.corners.len())?;
            let (vertices, corners) = (all.positions.len(), all.corners.len());
            all.corners.extend(mesh.corners.iter().map(|i| vertices + i));
            all.ends.extend(mesh.ends.iter().map(|end| corners + end));
            all.positions.extend_from_slice(&mesh.positions);
            all.normals.extend_from_slice(&mesh.normals);
            all.values.extend_from_slice(&mesh.values);
        }
        Ok(all)
    }

    /// The points of the vertices.
    pub fn positions(&self) -> &[Point3] {
        &self.positions
    }

    /// The unit normals of the vertices.
    pub fn normals(&self) -> &[Point3] {
        &self.normals
    }

    /// The values of the vertices.
    pub fn values(&self) -> &[Option<f64>] {
        &self.values
    }

    /// The corners of each face.
    pub fn faces(&self) -> impl Iterator<Item = &[usize]> {
        let start = |i: usize| if i == 0 { 0 } else { self.ends[i - 1] };
        self.ends.iter().enumerate().map(move |(i, end)| &self.corners[start(i)..*end])
    }

    /// The faces cut into triangles, from the first corner of each.
    pub fn triangles(&self) -> impl Iterator<Item = [usize; 3]> {
        self.faces().flat_map(|face| face[1..].windows(2).map(|pair| [face[0], pair[0], pair[1]]))
    }

    /// The sides of all faces as pairs of corners, each once, as lines to draw.
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let sides = |face: &[usize]| {
            let next = face.iter().cycle().skip(1);
            face.iter().zip(next).map(|(a, b)| [*a.min(b), *a.max(b)]).collect::<Vec<_>>()
        };
        let mut edges: Vec<[usize; 2]> = self.faces().flat_map(sides).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    fn checked(self) -> Result<Self> {
        check_count(self.positions.len())?;
        let wrong = |p: &Point3| !p.iter().all(|x| x.is_finite());
        if let Some(index) = self.positions.iter().position(wrong) {
            return Err(Error::NotFinite { what: "vertex", index });
        }
        if let Some(index) = self.normals.iter().position(wrong) {
            return Err(Error::NotFinite { what: "normal", index });
        }
        match self.values.iter().position(|value| value.is_some_and(|value| !value.is_finite())) {
            Some(index) => Err(Error::NotFinite { what: "value", index }),
            None => Ok(self),
        }
    }
}

/// Refuses meshes too large for a picture.
pub(super) fn check_count(count: usize) -> Result<()> {
    if count <= MOST { Ok(()) } else { Err(Error::TooLarge { count, limit: MOST }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::vector;

    fn square() -> Vec<Point3> {
        vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0], vector![0.0, 1.0, 0.0]]
    }

    #[test]
    fn wrong_faces_are_refused() {
        let refused = |faces: &[&[usize]]| Mesh::new(square(), faces).unwrap_err();
        assert_eq!(refused(&[&[0, 1, 2], &[0, 4, 1]]), Error::IndexOutOfRange { index: 4, length: 4 });
        assert_eq!(refused(&[&[0, 1]]), Error::TooFewPoints { expected: 3, found: 2 });
        let mut bad = square();
        bad[2][1] = f64::NAN;
        assert_eq!(Mesh::new(bad, [[0, 1, 2]]), Err(Error::NotFinite { what: "vertex", index: 2 }));
    }

    #[test]
    fn wrong_values_are_refused() {
        let mesh = Mesh::new(square(), [[0, 1, 2, 3]]).unwrap();
        let count = mesh.clone().with_values([Some(1.0)]);
        assert_eq!(count, Err(Error::CoefficientCount { expected: 4, found: 1 }));
        let nan = mesh.clone().with_values([None, Some(1.0), Some(f64::NAN), None]);
        assert_eq!(nan, Err(Error::NotFinite { what: "value", index: 2 }));
        let endless = mesh.with_values(std::iter::repeat(None));
        assert!(matches!(endless, Err(Error::CoefficientCount { .. })));
    }

    #[test]
    fn edges_occur_once() {
        let mesh = Mesh::new(square(), [[0, 1, 2], [0, 2, 3]]).unwrap();
        assert_eq!(mesh.edges(), [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3]]);
    }

    #[test]
    fn joined_meshes_keep_faces_and_values() {
        let one = Mesh::new(square(), [[0, 1, 2, 3]]).unwrap();
        let two = one.clone().with_values([1.0, 2.0, 3.0, 4.0].map(Some)).unwrap();
        let all = Mesh::joined([&one, &two]).unwrap();
        assert_eq!(all.faces().collect::<Vec<_>>(), [[0, 1, 2, 3], [4, 5, 6, 7]]);
        assert_eq!((all.values()[3], all.values()[7]), (None, Some(4.0)));
        assert_eq!(Mesh::joined([]).unwrap(), Mesh::default());
    }
}
