//! Shapes whose control points can be put back as they were.

use crate::coeff::Coeff;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::rational::domain::Domain;
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::space::SplineSpace;
use crate::spline::Spline;
use crate::tensor::spline::TensorSpline;
use crate::weighted::Weighted;

/// A [`Controlled`] shape whose control points can be kept and put back bit by bit, which adding a movement and taking it away
/// does not do in floating point.
pub trait Restorable<T: Scalar>: Controlled<T> {
    /// A control point as it is stored: of a rational shape the weighted one.
    type Stored: Coeff<T>;

    /// All of them.
    fn stored(&self) -> &[Self::Stored];

    /// One that was moved by a vector of the same shape.
    fn moved(stored: &Self::Stored, by: &Self::Point) -> Self::Stored;

    /// Puts control points, with weights as they are, in the place of others. On an error nothing has changed.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`], [`Error::NotFinite`], [`Error::Ragged`]; [`DeformError::OtherWeight`].
    fn put(&mut self, stored: Vec<(usize, Self::Stored)>) -> Result<()>;

    /// The shape over `spaces`, one for each direction, with these control points.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`], also unless there is a space for each direction; those of the constructors.
    fn rebuilt(spaces: &[SplineSpace<T>], stored: Vec<Self::Stored>) -> Result<Self>;
}

impl<T: Scalar, C: Coeff<T>> Restorable<T> for Spline<T, C> {
    type Stored = C;

    fn stored(&self) -> &[C] {
        self.coeffs()
    }

    fn moved(stored: &C, by: &C) -> C {
        stored.plus_scaled(&T::one(), by)
    }

    fn put(&mut self, stored: Vec<(usize, C)>) -> Result<()> {
        self.replace_coeffs(stored)
    }

    fn rebuilt(spaces: &[SplineSpace<T>], stored: Vec<C>) -> Result<Self> {
        let [space] = spaces else {
            return Err(Error::CoefficientCount { expected: 1, found: spaces.len() });
        };
        Self::new(space.clone(), stored)
    }
}

impl<T: Scalar, C: Coeff<T>> Restorable<T> for TensorSpline<T, C> {
    type Stored = C;

    fn stored(&self) -> &[C] {
        self.coeffs()
    }

    fn moved(stored: &C, by: &C) -> C {
        stored.plus_scaled(&T::one(), by)
    }

    fn put(&mut self, stored: Vec<(usize, C)>) -> Result<()> {
        self.replace_coeffs(stored)
    }

    fn rebuilt(spaces: &[SplineSpace<T>], stored: Vec<C>) -> Result<Self> {
        let [u, v] = spaces else { return Err(Error::CoefficientCount { expected: 2, found: spaces.len() }) };
        Self::new(u.clone(), v.clone(), stored)
    }
}

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Restorable<T> for Rational<D, T, C>
where
    D::Spline<Weighted<T, C>>: Restorable<T, Point = Weighted<T, C>, Stored = Weighted<T, C>>,
{
    type Stored = Weighted<T, C>;

    fn stored(&self) -> &[Weighted<T, C>] {
        D::coeffs(self.lifted())
    }

    fn moved(Weighted { point, weight }: &Weighted<T, C>, by: &C) -> Weighted<T, C> {
        Weighted { point: point.plus_scaled(weight, by), weight: weight.clone() }
    }

    fn put(&mut self, stored: Vec<(usize, Weighted<T, C>)>) -> Result<()> {
        let own = self.stored();
        let is_other =
            |(i, new): &&(usize, Weighted<T, C>)| own.get(*i).is_some_and(|c| c.weight != new.weight);
        if let Some((index, Weighted { weight, .. })) = stored.iter().find(is_other) {
            return Err(DeformError::OtherWeight { point: *index, weight: weight.to_string() }.into());
        }
        self.replace_points(stored)
    }

    fn rebuilt(spaces: &[SplineSpace<T>], stored: Vec<Weighted<T, C>>) -> Result<Self> {
        Self::from_lifted(D::Spline::<Weighted<T, C>>::rebuilt(spaces, stored)?)
    }
}
