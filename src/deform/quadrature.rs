//! Stiffness matrices by quadrature.
//!
//! [`Material::matrix`] integrates the polynomial pieces. Gauss rules do too, if they have nodes enough: on a span `N_i^(k) N_j^(k)`
//! has degree `2 (p - k)`, for which `p - k + 1` nodes suffice and no fewer [Vassilev, (33)].

use crate::analysis::length::gauss::Rule;
use crate::deform::material::{Bands, Material};
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::limits::MAX_DEGREE;
use crate::map::LinearMap;
use crate::space::SplineSpace;

impl Material<f64> {
    /// The stiffness matrix by Gauss rules with the least sufficient number of nodes: what [`matrix`](Self::matrix) gives, up to
    /// rounding.
    ///
    /// # Errors
    /// [`Error::TooLarge`]; [`Error::NotFinite`] if an entry is beyond the range.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Material, SplineSpace};
    /// let space = SplineSpace::clamped(3, [0.0, 1.0, 3.0, 4.0])?;
    /// let material = Material::of_orders([0.5, 1.0, 2.0])?;
    /// let (exact, quadrature) = (material.matrix(&space)?, material.matrix_by_quadrature(&space)?);
    /// assert!((exact.to_matrix()? - quadrature.to_matrix()?).amax() < 1e-13);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn matrix_by_quadrature(&self, space: &SplineSpace<f64>) -> Result<LinearMap<f64>> {
        self.by_rules(space, |order| space.degree() - order + 1)
    }

    /// The stiffness matrix by one Gauss rule for all orders of derivatives: exact for order `k` from `p - k + 1` nodes on.
    ///
    /// With fewer it is the matrix of another energy, which lets more motions pass.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for more nodes than the highest degree could use; [`Error::NotFinite`] if an entry is beyond the range.
    ///
    /// # Examples
    /// The midpoint sees of `x²` the mean slope alone:
    /// ```
    /// use symspline::{Material, SplineSpace};
    /// let (space, stretching) = (SplineSpace::bezier(2, 0.0, 1.0)?, Material::new(1.0, 0.0)?);
    /// let parabola = [0.0, 0.0, 1.0];
    /// let energy = |nodes| Ok(stretching.matrix_by_rule(&space, nodes)?.apply(&parabola)?[2]);
    /// assert_eq!(energy(1), Ok::<f64, symspline::Error>(1.0));
    /// assert!((energy(2)? - 4.0 / 3.0).abs() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn matrix_by_rule(&self, space: &SplineSpace<f64>, nodes: usize) -> Result<LinearMap<f64>> {
        let limit = MAX_DEGREE + 1;
        if nodes > limit {
            return Err(Error::TooLarge { count: nodes, limit });
        }
        self.by_rules(space, |_| nodes)
    }

    fn by_rules(&self, space: &SplineSpace<f64>, nodes: impl Fn(usize) -> usize) -> Result<LinearMap<f64>> {
        let (p, t) = (space.degree(), space.knots());
        let orders = self.weights().iter().enumerate().take(p + 1).filter(|(_, weight)| **weight != 0.0);
        let rules: Vec<(usize, f64, Rule)> =
            orders.map(|(k, weight)| (k, *weight, Rule::new(nodes(k)))).collect();
        let mut bands = Bands::new(space)?;
        for k in space.spans() {
            let (start, length) = (t[k], t[k + 1] - t[k]);
            for (order, weight, rule) in &rules {
                for (node, share) in rule.nodes() {
                    let row: Functional<f64> = space.derivative_on(k, &(start + length * node), *order);
                    let scale = weight * length * share;
                    for (i, x) in row.weights().iter().enumerate() {
                        let entries = &mut bands.row(k - p + i)[p - i..];
                        entries.iter_mut().zip(row.weights()).for_each(|(entry, y)| *entry += scale * x * y);
                    }
                }
            }
        }
        bands.gathered()
    }
}
