//! Skins that go on from one surface, or into another, with a common tangent plane.
//!
//! Where two surfaces share an edge and their derivatives across it are positive multiples of each other, so are their tangent
//! planes the same: they meet with `G1`, and with `C1` if the factor is one.

use crate::build::skin::{Skin, onto};
use crate::coeff::Coeff;
use crate::error::skin::SkinError;
use crate::error::{Error, Result};
use crate::ops::bound::check_tolerance;
use crate::scalar::Scalar;
use crate::spline::Spline;
use crate::tensor::along::Direction;
use crate::tensor::spline::TensorSpline;

impl<T: Scalar, C: Coeff<T>> Skin<T, C> {
    /// The same with the start tangents that continue `before` with `G1`: `∂S/∂v` at the first section is `factor` times that of
    /// `before` at the end of its `v`.
    ///
    /// The edge of `before` there must be the first section within `tolerance`, a distance between points; over an exact field it may
    /// be zero. [`transposed`](TensorSpline::transposed) and [`reversed`](TensorSpline::reversed) surfaces turn any edge to where it
    /// is looked for. Domains along the edge need not agree.
    ///
    /// # Errors
    /// [`SkinError::EdgeElsewhere`]; [`Error::Ratio`] unless the factor is positive; [`Error::BadTolerance`]; those of
    /// [`start_tangents`](Self::start_tangents).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, Skin, Function, Direction};
    /// let section = |power: usize| Function::monomial(power, Q::int(0), Q::int(1));
    /// let before = Skin::through(&[section(1)?, section(2)?])?.surface(1)?;
    /// let skin = Skin::through(&[section(2)?, section(3)?])?.continuing(&before, &Q::int(2), &Q::int(0))?.surface(2)?;
    /// let slope = |s: &symspline::TensorSpline<Q>, v| s.derivative_at(&Q::frac(1, 2), &v, 0, 1);
    /// assert_eq!(slope(&skin, Q::int(0))?, slope(&before, Q::int(1))? * Q::int(2));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "G1")]
    pub fn continuing(self, before: &TensorSpline<T, C>, factor: &T, tolerance: &T) -> Result<Self> {
        let tangents = across(before, before.v().domain().1, &self.sections[0], factor, tolerance)?;
        self.start_tangents(&tangents)
    }

    /// The same with the end tangents that go over into `after` with `G1`: `∂S/∂v` at the last section is `factor` times that of
    /// `after` at the start of its `v`.
    ///
    /// # Errors
    /// As [`continuing`](Self::continuing).
    pub fn continued_by(self, after: &TensorSpline<T, C>, factor: &T, tolerance: &T) -> Result<Self> {
        let last = &self.sections[self.sections.len() - 1];
        let tangents = across(after, after.v().domain().0, last, factor, tolerance)?;
        self.end_tangents(&tangents)
    }
}

/// `factor` times the derivative across the edge at `v`, which is the `section`.
fn across<T: Scalar, C: Coeff<T>>(
    surface: &TensorSpline<T, C>,
    v: &T,
    section: &Spline<T, C>,
    factor: &T,
    tolerance: &T,
) -> Result<Spline<T, C>> {
    check_tolerance(tolerance)?;
    if !(factor.is_finite() && *factor > T::zero()) {
        return Err(Error::Ratio { ratio: factor.to_string() });
    }
    let edge = onto(section.space(), &surface.isocurve(Direction::V, v)?)?;
    let distance = edge.distance_bound(section)?;
    if distance > *tolerance {
        let (distance, tolerance) = (distance.to_string(), tolerance.to_string());
        return Err(SkinError::EdgeElsewhere { distance, tolerance }.into());
    }
    surface.contracted(Direction::V, |rows| rows.derivative_at(v, 1))?.scaled(factor)
}
