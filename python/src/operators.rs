//! The operators that polynomial and rational splines share.

use crate::arguments::Along;
use crate::error::Result;
use crate::numbers::{Array, Num};
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::space::Space;
use crate::spline::Spline;
use crate::surface::Surface;
use pyo3::prelude::*;
use symspline_dynamic::{Spaced, each, together};

macro_rules! of_one_parameter {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The derivative of an order.
            #[pyo3(signature = (order=1))]
            fn derivative(&self, py: Python<'_>, order: usize) -> Result<Self> {
                py.detach(|| Ok(Self(self.0.nth_derivative(order)?)))
            }

            /// The same with a higher degree.
            #[pyo3(signature = (by=1))]
            fn elevate(&self, py: Python<'_>, by: usize) -> Result<Self> {
                py.detach(|| Ok(Self(self.0.elevated(by)?)))
            }

            /// The same with more knots, of shape `(n,)`.
            fn inserted(&self, py: Python<'_>, knots: Array) -> Result<Self> {
                let (s, knots) = (&self.0, &knots.list()?);
                together!(s, knots);
                py.detach(|| Ok(Self(s.inserted(&knots)?)))
            }

            /// The same in a space that holds its own.
            fn embedded(&self, py: Python<'_>, target: &Space) -> Result<Self> {
                let (s, t) = (&self.0, &target.0);
                together!(s, t);
                py.detach(|| each!(&*s, T, s => Ok(Self(s.embedded(<T as Spaced>::space(&t)?)?.into()))))
            }

            /// The part between two parameters.
            fn restricted(&self, py: Python<'_>, a: Num, b: Num) -> Result<Self> {
                let (s, a, b) = (&self.0, &a.0, &b.0);
                together!(s, a, b);
                py.detach(|| Ok(Self(s.restricted(&a, &b)?)))
            }

            /// The parts before and after a parameter.
            fn split(&self, py: Python<'_>, x: Num) -> Result<(Self, Self)> {
                let (s, x) = (&self.0, &x.0);
                together!(s, x);
                py.detach(|| {
                    let (before, after) = s.split(&x)?;
                    Ok((Self(before), Self(after)))
                })
            }

            /// The same run through backwards.
            fn reversed(&self) -> Result<Self> {
                Ok(Self(self.0.reversed()?))
            }

            /// The same over another interval.
            fn reparametrised(&self, start: Num, end: Num) -> Result<Self> {
                let (s, start, end) = (&self.0, &start.0, &end.0);
                together!(s, start, end);
                Ok(Self(s.reparametrised(&start, &end)?))
            }

            /// The same with clamped ends.
            fn clamped_ends(&self) -> Result<Self> {
                Ok(Self(self.0.clamped_ends()?))
            }
        }
    };
}

of_one_parameter!(Spline);
of_one_parameter!(Rational);

macro_rules! of_two_parameters {
    ($class:ident, $curve:ident) => {
        #[pymethods]
        impl $class {
            /// The curve at one parameter: in direction "u" the parameter is a `u`, and the curve runs along `v`.
            fn isocurve(&self, direction: Along, x: Num) -> Result<$curve> {
                let (s, x) = (&self.0, &x.0);
                together!(s, x);
                Ok($curve(s.isocurve(direction.0, &x)?))
            }

            /// The derivative of an order in one direction.
            #[pyo3(signature = (direction, order=1))]
            fn derivative(&self, py: Python<'_>, direction: Along, order: usize) -> Result<Self> {
                py.detach(|| Ok(Self(self.0.nth_derivative(direction.0, order)?)))
            }

            /// The same with a higher degree in one direction.
            #[pyo3(signature = (direction, by=1))]
            fn elevate(&self, py: Python<'_>, direction: Along, by: usize) -> Result<Self> {
                py.detach(|| Ok(Self(self.0.elevated(direction.0, by)?)))
            }

            /// The same with more knots in one direction, of shape `(n,)`.
            fn inserted(&self, py: Python<'_>, direction: Along, knots: Array) -> Result<Self> {
                let (s, knots) = (&self.0, &knots.list()?);
                together!(s, knots);
                py.detach(|| Ok(Self(s.inserted(direction.0, &knots)?)))
            }

            /// The same in spaces that hold its own.
            fn embedded(&self, py: Python<'_>, u: &Space, v: &Space) -> Result<Self> {
                let (s, u, v) = (&self.0, &u.0, &v.0);
                together!(s, u, v);
                py.detach(|| {
                    each!(&*s, T, s => Ok(Self(s.embedded(<T as Spaced>::space(&u)?, <T as Spaced>::space(&v)?)?.into())))
                })
            }

            /// The part between two parameters of one direction.
            fn restricted(&self, py: Python<'_>, direction: Along, a: Num, b: Num) -> Result<Self> {
                let (s, a, b) = (&self.0, &a.0, &b.0);
                together!(s, a, b);
                py.detach(|| Ok(Self(s.restricted(direction.0, &a, &b)?)))
            }

            /// The parts before and after a parameter of one direction.
            fn split(&self, py: Python<'_>, direction: Along, x: Num) -> Result<(Self, Self)> {
                let (s, x) = (&self.0, &x.0);
                together!(s, x);
                py.detach(|| {
                    let (before, after) = s.split(direction.0, &x)?;
                    Ok((Self(before), Self(after)))
                })
            }

            /// The same run through backwards in one direction.
            fn reversed(&self, direction: Along) -> Result<Self> {
                Ok(Self(self.0.reversed(direction.0)?))
            }

            /// The same with clamped ends.
            fn clamped_ends(&self) -> Result<Self> {
                Ok(Self(self.0.clamped_ends()?))
            }
        }
    };
}

of_two_parameters!(Surface, Spline);
of_two_parameters!(RationalSurface, Rational);

#[pymethods]
impl Surface {
    /// The same with the parameters exchanged.
    fn transposed(&self) -> Self {
        Self(self.0.transposed())
    }
}

#[pymethods]
impl RationalSurface {
    /// The same with the parameters exchanged.
    fn transposed(&self) -> Result<Self> {
        Ok(Self(self.0.transposed()?))
    }
}
