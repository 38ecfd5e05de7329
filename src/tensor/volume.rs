//! Areas, volumes and their moments, exact because they are integrals of polynomials.
//!
//! With `x = S(u, v)` and `n = S_u × S_v`, the divergence theorem for `x^a y^b z^c (x, y, z)` gives
//!
//! ```text
//! ∭ x^a y^b z^c dV = 1 / (a + b + c + 3) ∬ x^a y^b z^c S·n du dv
//! ```
//! over the solid inside a closed surface whose normals point outwards. If the surface is open, it is that of the cone
//! over the surface with its tip at the origin.

use crate::error::Result;
use crate::limits::check_degree;
use crate::scalar::Scalar;
use crate::tensor::along::Direction::{U, V};
use crate::tensor::spline::{Surface, TensorSpline};
use nalgebra::SVector;

impl<T: Scalar, const N: usize> Surface<T, N> {
    /// `base` times the coordinates to the given powers.
    fn weighted_by(&self, base: TensorSpline<T>, powers: [usize; N]) -> Result<TensorSpline<T>> {
        powers.iter().try_for_each(|&power| check_degree(power))?;
        let factors = powers.iter().enumerate().flat_map(|(axis, &power)| std::iter::repeat_n(axis, power));
        factors.into_iter().try_fold(base, |product, axis| product.times(&self.coordinate(axis)?))
    }
}

impl<T: Scalar> Surface<T, 2> {
    /// The moment `∬ x^a y^b dx dy` over the plane region that the surface covers, counted with the sign of
    /// `S_u × S_v` and as often as it is covered; `[0, 0]` gives its area.
    ///
    /// # Errors
    /// As [`derivative`](TensorSpline::derivative) and [`product_by`](TensorSpline::product_by).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [[0, 0], [0, 2], [3, 0], [3, 2]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let rectangle = Surface::new(line.clone(), line, corners.to_vec())?;
    /// assert_eq!(rectangle.area_moment([0, 0])?, Q::int(6));
    /// assert_eq!(rectangle.area_moment([1, 0])?, Q::int(9));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn area_moment(&self, powers: [usize; 2]) -> Result<T> {
        let element = self.derivative(U)?.cross(&self.derivative(V)?)?;
        self.weighted_by(element, powers)?.integral()
    }
}

impl<T: Scalar> Surface<T, 3> {
    /// The vector area `∬ S_u × S_v du dv`, zero for a closed surface.
    ///
    /// # Errors
    /// As [`normal`](Self::normal).
    pub fn vector_area(&self) -> Result<SVector<T, 3>> {
        self.normal()?.integral()
    }

    /// The moment `∭ x^a y^b z^c dV` of the cone from the origin over the surface; over a closed surface with outward
    /// normals, of the solid inside. `[0, 0, 0]` gives its volume. A solid with several faces has the sum of theirs.
    ///
    /// # Errors
    /// As [`normal`](Self::normal).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, SplineSpace, Surface};
    /// // The face z = 1 of the unit cube: a third of the cube is the pyramid under it.
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[x, y]| vector![Q::int(x), Q::int(y), Q::int(1)]);
    /// let face = Surface::new(line.clone(), line, corners.to_vec())?;
    /// assert_eq!(face.volume_moment([0, 0, 0])?, Q::frac(1, 3));
    /// assert_eq!(face.volume_moment([0, 0, 1])?, Q::frac(1, 4));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn volume_moment(&self, powers: [usize; 3]) -> Result<T> {
        powers.iter().try_for_each(|&power| check_degree(power))?;
        let total: usize = powers.iter().sum();
        let element = self.dot(&self.normal()?)?;
        Ok(self.weighted_by(element, powers)?.integral()? / T::int(total as i64 + 3))
    }
}
