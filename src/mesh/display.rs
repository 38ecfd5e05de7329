//! Surfaces to look at: short knot intervals made longer.

use crate::error::{Error, Result};
use crate::mesh::catmull_clark::CatmullClark;
use crate::scalar::Scalar;

impl<T: Scalar, const N: usize> CatmullClark<T, N> {
    /// The surface with all knot intervals at least as long as `least`.
    ///
    /// A [converted](crate::DooSabin::converted) surface has intervals 0, whose faces shrink to nothing. A small interval in their place,
    /// as 0.05, shows them [Miura, Figure 16], on a surface that is a little different. One with equal intervals stays as it is.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Boundary, ControlMesh, DooSabin};
    /// let points = vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![0.0, 1.0, 0.0], vector![0.0, 0.0, 1.0]];
    /// let mesh = ControlMesh::new(points, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
    /// let shown = DooSabin::new(mesh, Boundary::Smooth).converted()?.with_least_interval(0.05)?;
    /// assert!(shown.intervals().into_iter().flatten().all(|interval| [0.05, 1.0].contains(interval)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn with_least_interval(&self, least: T) -> Result<Self> {
        let Some(intervals) = self.intervals() else {
            return Ok(self.clone());
        };
        if !least.is_finite() {
            return Err(Error::NotFinite { what: "knot interval", index: 0 });
        }
        let raised = intervals.iter().map(|interval| if *interval < least { &least } else { interval });
        Self::with_intervals(self.mesh().clone(), raised.cloned().collect(), self.boundary())
    }
}
