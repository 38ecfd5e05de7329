//! How stiff the springs are that hold a fine-tuned mesh together.

use crate::error::tune::TuneError;
use crate::error::{Error, Result};
use crate::mesh::topology::Topology;

/// How the springs come to rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Descend {
    /// By conjugate gradients, softened by the stiffness of the mesh, which is renewed now and then.
    #[default]
    ConjugateGradients,
    /// By Gauss and Newton's steps, damped after Levenberg and Marquardt: the stiffness is new in each.
    GaussNewton,
}

/// How stiff the springs are that [`DooSabin::fine_tuned`](crate::DooSabin::fine_tuned) relaxes, and how far it goes.
///
/// # Examples
/// ```
/// use symspline::MeshSprings;
/// let springs = MeshSprings { bend: 2.0, fixed: vec![0, 3, 4], ..MeshSprings::default() };
/// assert_eq!((springs.stretch, springs.shape, MeshSprings::default().bend), (1.0, 1.0, 1.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSprings {
    /// The constant `k_l` of the edges, for lengths in units of the longest side of the bounding box of the mesh. It is 1.
    pub stretch: f64,
    /// The constant `k_a` of the joints of loops, for angles in radians. It is 1.
    pub bend: f64,
    /// The constant `k_b` of the angles between neighbours. It is 1.
    pub shape: f64,
    /// Whether all edges are of one material: then the constant of an edge is `k_l` times the mean length over its own, both at rest.
    /// They are not in (14), where long edges can press short ones to nothing.
    pub uniform: bool,
    /// Vertices of the mesh whose corners in the converted mesh stay. There are none.
    pub fixed: Vec<usize>,
    /// Corners that stay: vertices of the converted mesh, which are half-edges of the mesh. There are none.
    pub fixed_corners: Vec<usize>,
    /// If given, the only vertices of the mesh whose corners may move. Then the energy has those terms alone that change, and
    /// descending costs as much as this part is large.
    pub moving: Option<Vec<usize>>,
    /// How the springs come to rest.
    pub descend: Descend,
    /// The most steps. They are 2000.
    pub iterations: usize,
    /// The springs are at rest where the energy could fall by about half the square of this times the largest of the
    /// constants. It is `1e-7`.
    pub tolerance: f64,
}

impl Default for MeshSprings {
    fn default() -> Self {
        Self {
            stretch: 1.0,
            bend: 1.0,
            shape: 1.0,
            uniform: false,
            fixed: Vec::new(),
            fixed_corners: Vec::new(),
            moving: None,
            descend: Descend::default(),
            iterations: 2000,
            tolerance: 1e-7,
        }
    }
}

impl MeshSprings {
    /// Refuses springs without strength, vertices and corners that are none of the mesh, and tolerances that are none.
    pub(crate) fn check(&self, mesh: &Topology) -> Result<()> {
        for constant in [self.stretch, self.bend, self.shape] {
            if !(constant > 0.0 && constant.is_finite()) {
                return Err(TuneError::SpringConstant { constant: constant.to_string() }.into());
            }
        }
        if !(self.tolerance >= 0.0 && self.tolerance.is_finite()) {
            return Err(Error::BadTolerance { tolerance: self.tolerance.to_string() });
        }
        let within = |indices: &[usize], length: usize| match indices.iter().find(|i| **i >= length) {
            Some(&index) => Err(Error::IndexOutOfRange { index, length }),
            None => Ok(()),
        };
        within(&self.fixed, mesh.vertex_count())?;
        within(&self.fixed_corners, mesh.half_edge_count())?;
        within(self.moving.as_deref().unwrap_or_default(), mesh.vertex_count())
    }

    /// Whether each vertex of the converted mesh may move.
    pub(crate) fn free(&self, mesh: &Topology) -> Vec<bool> {
        let mut free = vec![self.moving.is_none(); mesh.half_edge_count()];
        let mut set = |v: &usize, value: bool| mesh.leaving(*v).for_each(|corner| free[corner] = value);
        self.moving.iter().flatten().for_each(|v| set(v, true));
        self.fixed.iter().for_each(|v| set(v, false));
        self.fixed_corners.iter().for_each(|corner| free[*corner] = false);
        free
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tetrahedron() -> Topology {
        Topology::new(4, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]).unwrap()
    }

    #[test]
    fn bad_springs_are_refused() {
        let (mesh, good) = (tetrahedron(), MeshSprings::default());
        for k in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let refused = Err(TuneError::SpringConstant { constant: k.to_string() }.into());
            assert_eq!(MeshSprings { stretch: k, ..good.clone() }.check(&mesh), refused);
            assert_eq!(MeshSprings { bend: k, ..good.clone() }.check(&mesh), refused);
            assert_eq!(MeshSprings { shape: k, ..good.clone() }.check(&mesh), refused);
        }
        for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(MeshSprings { tolerance, ..good.clone() }.check(&mesh).is_err());
        }
        let beyond = |index, length| Err(Error::IndexOutOfRange { index, length });
        assert_eq!(MeshSprings { fixed: vec![0, 4], ..good.clone() }.check(&mesh), beyond(4, 4));
        assert_eq!(MeshSprings { moving: Some(vec![5]), ..good.clone() }.check(&mesh), beyond(5, 4));
        assert_eq!(MeshSprings { fixed_corners: vec![12], ..good.clone() }.check(&mesh), beyond(12, 12));
        assert_eq!(good.check(&mesh), Ok(()));
    }

    #[test]
    fn what_is_fixed_does_not_move() {
        let mesh = tetrahedron();
        let count = |springs: MeshSprings| springs.free(&mesh).iter().filter(|free| **free).count();
        assert_eq!(count(MeshSprings::default()), 12);
        assert_eq!(count(MeshSprings { fixed: vec![1, 1], ..MeshSprings::default() }), 9);
        let part = MeshSprings { moving: Some(vec![0, 1]), fixed: vec![1], ..MeshSprings::default() };
        assert_eq!(count(part.clone()), 3);
        // The first corner of the first face is at vertex 0.
        assert_eq!(count(MeshSprings { fixed_corners: vec![0], ..part }), 2);
    }
}
