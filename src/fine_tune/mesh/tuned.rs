//! A Doo-Sabin surface fine tuned by control values on the edges of its mesh [Miura, 4.3, 4.4].
//!
//! The surface is [converted](crate::DooSabin::converted) into one of Catmull and Clark's, where it has the degree of its product with a
//! linear scale. The values ask for lengths and angles of the edges of that mesh, which cannot all be had if the surface is to hold
//! together. Springs decide.

use super::net::{Constants, Net, Vector};
use super::newton::relax;
use super::rest::{check_legs, check_scale, legs, scaled_legs};
use super::springs::MeshSprings;
use crate::error::{Error, Result};
use crate::fine_tune::frame::Frame;
use crate::fine_tune::minimise::Limits;
use crate::mesh::catmull_clark::CatmullClark;
use crate::mesh::doo_sabin::DooSabin;
use nalgebra::{Matrix3, SVD};
use std::ops::ControlFlow;

/// How far the springs have come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The steps taken.
    pub iteration: usize,
    /// The energy (14).
    pub energy: f64,
    /// The length of the gradient, as [`MeshSprings::tolerance`] measures it.
    pub gradient: f64,
}

/// A surface whose control mesh is a net of springs at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct RelaxedMesh {
    /// The surface.
    pub surface: CatmullClark<f64, 3>,
    /// The surface before, which is the one tuned with values of 1.
    pub invariant: CatmullClark<f64, 3>,
    /// The energy (14) where the springs were released.
    pub energy_before: f64,
    /// The energy (14) of the surface.
    pub energy: f64,
    /// Its three sums, times their constants: of lengths, of angles in loops, of angles between neighbours.
    pub terms: [f64; 3],
    /// The steps it took.
    pub iterations: usize,
    /// What is left of the gradient, as [`MeshSprings::tolerance`] measures it.
    pub gradient: f64,
    /// Whether the gradient is within the tolerance. If not, the steps were too few, somebody stopped it, rounding allows no less,
    /// or an edge was pressed to nothing, which a length deviation of 1 or more hints at.
    pub converged: bool,
    /// The largest deviation of an edge's length, relative to what the control values ask for.
    pub length_deviation: f64,
    /// The largest deviation of an angle in a loop from what the control values ask for, in radians.
    pub angle_deviation: f64,
}

impl DooSabin<f64, 3> {
    /// The surface with the steps along each edge of its mesh multiplied by a control value, as nearly as it holds together.
    ///
    /// The [converted](Self::converted) mesh has, for an edge with value `a`, two edges `J` along it, which should become `a J`. Its other
    /// edges `V` run around old vertices, each between two of those in its [loop](crate::EdgeLoops), and should become
    /// `V + ((a_prev - 1) J_next + (a_next - 1) J_prev) / 4`, or other shares of them where knot intervals differ. That gives the
    /// lengths `l_opt` of edges and the angles `θa_opt` between successive edges of a loop; angles `θb` between neighbours around a vertex
    /// should stay. The vertices are moved from where they are to
    /// least energy
    ///
    /// ```text
    /// E = k_l Σ (l_opt - l)² + k_a Σ (θa_opt - θa)² + k_b Σ (θb_opt - θb)²          [Miura, (14)]
    /// ```
    /// nearby, in units of the longest side of the bounding box of the control mesh, so that a surface and its enlargements come out
    /// alike. The topology is that of the converted mesh: what is closed stays closed; so are the knot intervals.
    ///
    /// What [`MeshSprings::fixed`] or [`MeshSprings::moving`] keep does not move at all. If they keep nothing, the result is moved as a
    /// whole to where its vertices are nearest to what they were. If all values are 1 nothing moves.
    ///
    /// More meshes than one may be at rest.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one value an edge;
    /// [`TuneError::EdgeScale`](crate::TuneError::EdgeScale) unless they are positive; [`Error::NoLength`] if all points coincide;
    /// [`TuneError::ZeroEdge`](crate::TuneError::ZeroEdge) if an edge of the converted mesh vanishes, or should, but for rounding beside the
    /// longest;
    /// [`TuneError::SpringConstant`](crate::TuneError::SpringConstant), [`Error::BadTolerance`], [`Error::IndexOutOfRange`] for unusable springs;
    /// [`Error::NotFinite`] on overflow; [`Error::TooLarge`].
    ///
    /// # Examples
    /// A cube of which one edge becomes longer:
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Boundary, ControlMesh, DooSabin, MeshSprings};
    /// let corner = |k: i32| vector![f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)];
    /// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    /// let cube = DooSabin::new(ControlMesh::new((0..8).map(corner).collect(), faces)?, Boundary::Smooth);
    /// let mut alpha = vec![1.0; 12];
    /// alpha[0] = 1.3;
    /// let tuned = cube.fine_tuned(&alpha, &MeshSprings::default())?;
    /// assert!(tuned.converged && tuned.energy < 0.5 * tuned.energy_before);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned(&self, alpha: &[f64], springs: &MeshSprings) -> Result<RelaxedMesh> {
        self.fine_tuned_watched(alpha, springs, |_| ControlFlow::Continue(()))
    }

    /// The same, watched: `watch` is told how far the springs have come before each step, and may stop them there.
    ///
    /// # Errors
    /// Those of [`fine_tuned`](Self::fine_tuned).
    pub fn fine_tuned_watched(
        &self,
        alpha: &[f64],
        springs: &MeshSprings,
        mut watch: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<RelaxedMesh> {
        let coarse = self.mesh().topology();
        springs.check(coarse)?;
        check_scale(alpha, coarse.edge_count())?;
        let frame = Frame::of(self.mesh().points())?;
        let invariant = self.converted()?;
        let fine = invariant.mesh().topology();
        let points: Vec<Vector> = invariant.mesh().points().iter().map(|point| frame.inward(point)).collect();
        let found = legs(fine, &points);
        let wanted = scaled_legs(self, fine, &points, alpha);
        check_legs(&found)?;
        check_legs(&wanted)?;
        let largest = springs.stretch.max(springs.bend).max(springs.shape);
        let constants = Constants {
            stretch: springs.stretch / largest,
            bend: springs.bend / largest,
            shape: springs.shape / largest,
            uniform: springs.uniform,
        };
        let free = springs.free(coarse);
        let mut net = Net::new(fine, &points, [&wanted, &found], &free, springs.moving.is_none(), &constants);
        let mut x = net.coordinates();
        let limits = Limits {
            gradient: springs.tolerance,
            iterations: springs.iterations,
            evaluations: springs.iterations.saturating_mul(8),
        };
        let mut told = |iteration, value: f64, gradient| {
            watch(&Progress { iteration, energy: largest * value, gradient }).is_continue()
        };
        let descent = relax(&mut x, &limits, springs.descend, &mut net, &mut told);
        if !(largest * descent.before).is_finite() {
            return Err(Error::NotFinite { what: "energy", index: 0 });
        }

        net.lay(&x);
        let (sums, [length_deviation, angle_deviation]) = net.parts();
        let mut moved = invariant.mesh().points().to_vec();
        if descent.iterations > 0 {
            if net.free == points.len() {
                let start: Vec<Vector> = net.vertices.iter().map(|v| points[*v]).collect();
                bring_back(&mut net.points, &start);
            }
            for (v, point) in net.vertices.iter().zip(&net.points).take(net.free) {
                moved[*v] = frame.outward(point);
            }
        }
        let intervals = invariant.intervals().unwrap_or_default().to_vec();
        let mesh = invariant.mesh().with_points(moved)?;
        Ok(RelaxedMesh {
            surface: CatmullClark::with_intervals(mesh, intervals, invariant.boundary())?,
            invariant,
            energy_before: largest * descent.before,
            energy: largest * descent.value,
            terms: sums.map(|sum| largest * sum),
            iterations: descent.iterations,
            gradient: descent.gradient,
            converged: descent.converged,
            length_deviation,
            angle_deviation,
        })
    }
}

/// Moves points as a whole to where the sum of their squared distances from `start` is least [Kabsch].
fn bring_back(points: &mut [Vector], start: &[Vector]) {
    let mean = |points: &[Vector]| points.iter().sum::<Vector>() / points.len() as f64;
    let (from, to) = (mean(points), mean(start));
    let spread: Matrix3<f64> = points.iter().zip(start).map(|(p, s)| (s - to) * (p - from).transpose()).sum();
    let svd = SVD::new(spread, true, true);
    let (Some(u), Some(v)) = (svd.u, svd.v_t) else {
        return;
    };
    // No mirror image: the axis that matters least is turned over. Singular values decrease.
    let sign = (u.determinant() * v.determinant()).signum();
    let turn = u * Matrix3::from_diagonal(&Vector::new(1.0, 1.0, sign)) * v;
    points.iter_mut().for_each(|point| *point = to + turn * (*point - from));
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Rotation3, vector};

    #[test]
    fn what_was_moved_as_a_whole_is_brought_back() {
        let start: Vec<Vector> =
            (0..9).map(|k| vector![f64::from(k % 3), f64::from(k / 3), f64::from(k * k % 5)]).collect();
        let flat: Vec<Vector> = start.iter().map(|p| vector![p[0], p[1], 0.0]).collect();
        for start in [start, flat] {
            let turn = Rotation3::from_euler_angles(0.7, -2.0, 1.1);
            let mut points: Vec<Vector> = start.iter().map(|p| turn * p + vector![3.0, -1.0, 2.0]).collect();
            bring_back(&mut points, &start);
            assert!(points.iter().zip(&start).all(|(p, s)| (p - s).norm() < 1e-13));
        }
    }
}
