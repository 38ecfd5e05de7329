//! Doo and Sabin's surfaces.

use crate::error::Result;
use crate::mesh::boundary::Boundary;
use crate::mesh::catmull_clark::CatmullClark;
use crate::mesh::control_mesh::ControlMesh;
use crate::mesh::face_rule::{CONVERSION, FaceRule, Waves};
use crate::scalar::Scalar;
use nalgebra::SVector;

/// A Doo-Sabin surface: a control mesh, knot intervals, and what becomes of the boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct DooSabin<T: Scalar, const N: usize> {
    mesh: ControlMesh<T, N>,
    boundary: Boundary,
}

impl<T: Scalar, const N: usize> DooSabin<T, N> {
    /// The surface of a mesh whose knot intervals are all equal.
    pub fn new(mesh: ControlMesh<T, N>, boundary: Boundary) -> Self {
        Self { mesh, boundary }
    }

    /// The control mesh.
    pub fn mesh(&self) -> &ControlMesh<T, N> {
        &self.mesh
    }

    /// What becomes of the boundary.
    pub fn boundary(&self) -> Boundary {
        self.boundary
    }

    /// The same surface, or nearly, as a Catmull-Clark surface over knot intervals 0 and 1.
    pub fn converted(&self) -> Result<CatmullClark<T, N>> {
        let coarse = self.mesh.topology();
        let fine = coarse.shrunk(self.boundary != Boundary::Open)?;
        let points = corners(&self.mesh, &CONVERSION)?;
        let along = coarse.half_edge_count();
        let interval = |e: usize| if e < along { T::zero() } else { T::one() };
        let intervals = (0..fine.edge_count()).map(interval).collect();
        CatmullClark::with_intervals(ControlMesh::over(fine.into(), points)?, intervals, self.boundary)
    }
}

/// The corners of all faces, moved by a rule.
fn corners<T: Scalar, const N: usize>(
    mesh: &ControlMesh<T, N>,
    rule: &FaceRule,
) -> Result<Vec<SVector<T, N>>> {
    let topology = mesh.topology();
    let (mut face, mut waves) = (Vec::new(), Waves::default());
    let mut moved = Vec::with_capacity(topology.half_edge_count());
    for f in 0..topology.face_count() {
        face.clear();
        face.extend(topology.face(f).map(|v| mesh.points()[v].clone()));
        rule.apply(&face, &mut waves, &mut moved)?;
    }
    Ok(moved)
}
