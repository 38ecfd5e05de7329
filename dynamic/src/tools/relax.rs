//! Relaxation: curves on their way to where their energy is least.

use crate::both;
use crate::error::Result;
use crate::number::{Field, Number};
use crate::over::{AnySpace, Coords, Over};
use crate::shape;
use crate::tools::edit::Of;
use crate::tools::elastic::{AnyBreadth, AnyElastic, material};
use crate::tools::shape::{Shape, all_points};
use crate::value::Value;
use symspline::{Q, Relaxation};

/// Steps of curves over one space; see [`Relaxation`].
pub type AnyRelaxation = Over<Relaxation<f64>, Relaxation<Q>>;

impl From<Relaxation<f64>> for AnyRelaxation {
    fn from(relaxation: Relaxation<f64>) -> Self {
        Self::Float(relaxation)
    }
}

impl From<Relaxation<Q>> for AnyRelaxation {
    fn from(relaxation: Relaxation<Q>) -> Self {
        Self::Exact(relaxation)
    }
}

impl AnyRelaxation {
    /// Steps of one length of curves over a space, of a material; numbers are taken into the field of the space.
    ///
    /// # Errors
    /// Those of [`Relaxation::new`].
    pub fn new(space: &AnySpace, weights: &Coords, breadth: &AnyBreadth, step: &Number) -> Result<Self> {
        both!(space, T, s => Ok(Relaxation::new(s, &material::<T>(weights)?, &breadth.of()?, T::of(step)?)?.into()))
    }

    /// The length of a step.
    pub fn length(&self) -> Number {
        fn of<T: Field>(relaxation: &Relaxation<T>) -> Number {
            relaxation.length().clone().number()
        }
        both!(self, r => of(r))
    }

    /// The body whose stiffness is that of one step, for loads.
    pub fn body(&self) -> AnyElastic {
        both!(self, r => r.body().clone().into())
    }

    /// A curve after one step, under a load of each control point if there is one.
    ///
    /// # Errors
    /// [`Error::NoSuch`](crate::Error::NoSuch), [`Error::Fields`](crate::Error::Fields), and those of [`Relaxation::step`] and
    /// [`Relaxation::step_under`].
    pub fn stepped(&self, curve: &Value, load: Option<&Coords>) -> Result<Value> {
        fn of<T: Field, S: Shape<T>>(
            relaxation: &Relaxation<T>,
            curve: &S,
            load: Option<&Coords>,
        ) -> Result<Value> {
            let mut moved = curve.clone();
            match load {
                Some(load) => relaxation.step_under(&mut moved, &all_points::<T, _>(load)?)?,
                None => relaxation.step(&mut moved)?,
            }
            Ok(moved.value())
        }
        shape!(curve curve, "relaxation", T, s => of(Of::<T>::of(self)?, s, load))
    }
}
