//! The operators of splines over either field.

use crate::any::Any;
use crate::error::{Error, Result};
use crate::family::{AnyRational, AnyRationalSurface, AnySpline, AnySurface};
use crate::number::{Field, Flat, Number};
use crate::over::{AnySpace, Coords, Over};
use crate::{each, with_function};
use symspline::{Coeff, Direction};

/// A coefficient as coordinates of either field.
fn point<T: Field, C: Coeff<T>>(c: &C) -> Coords {
    T::coords(c.components().cloned().collect())
}

/// What polynomial and rational splines of one parameter have in common.
macro_rules! of_one_parameter {
    ($any:ty) => {
        impl $any {
            /// The space.
            pub fn space(&self) -> AnySpace {
                each!(self, s => s.space().clone().into())
            }

            /// The ends of the domain.
            pub fn domain(&self) -> (Number, Number) {
                each!(self, s => (s.domain().0.clone().number(), s.domain().1.clone().number()))
            }

            /// The value at a parameter.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn at(&self, x: &Number) -> Result<Coords> {
                each!(self, T, s => Ok(point(&s.at(&T::of(x)?)?)))
            }

            /// The values at many parameters, their coordinates one after the other.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn eval(&self, parameters: &Coords) -> Result<Coords> {
                each!(self, T, s => Ok(crate::number::flat(&s.eval(&T::all_of(parameters)?)?)))
            }

            /// The value and the derivatives up to an order, one point each.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn derivatives_at(&self, x: &Number, order: usize) -> Result<Vec<Coords>> {
                each!(self, T, s => Ok(s.derivatives_at(&T::of(x)?, order)?.iter().map(point).collect()))
            }

            /// The derivative.
            ///
            /// # Errors
            /// Those of the library: a jump has none.
            pub fn derivative(&self) -> Result<Self> {
                self.nth_derivative(1)
            }

            /// The derivative of an order.
            ///
            /// # Errors
            /// As [`derivative`](Self::derivative); [`symspline::Error::DegreeTooHigh`].
            pub fn nth_derivative(&self, order: usize) -> Result<Self> {
                each!(self, s => Ok(s.nth_derivative(order)?.into()))
            }

            /// The same with a higher degree.
            ///
            /// # Errors
            /// [`symspline::Error::DegreeTooHigh`].
            pub fn elevated(&self, raise: usize) -> Result<Self> {
                each!(self, s => Ok(s.elevated(raise)?.into()))
            }

            /// The same with more knots.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`], [`symspline::Error::Multiplicity`].
            pub fn inserted(&self, knots: &Coords) -> Result<Self> {
                each!(self, T, s => Ok(s.inserted(&T::all_of(knots)?)?.into()))
            }

            /// The part between two parameters.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`], [`symspline::Error::EmptyDomain`].
            pub fn restricted(&self, a: &Number, b: &Number) -> Result<Self> {
                each!(self, T, s => Ok(s.restricted(&T::of(a)?, &T::of(b)?)?.into()))
            }

            /// The parts before and after a parameter.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn split(&self, x: &Number) -> Result<(Self, Self)> {
                each!(self, T, s => {
                    let (before, after) = s.split(&T::of(x)?)?;
                    Ok((before.into(), after.into()))
                })
            }

            /// The same run through backwards.
            ///
            /// # Errors
            /// Those of the library.
            pub fn reversed(&self) -> Result<Self> {
                each!(self, s => Ok(s.reversed()?.into()))
            }

            /// The same over another interval.
            ///
            /// # Errors
            /// [`symspline::Error::EmptyDomain`].
            pub fn reparametrised(&self, start: &Number, end: &Number) -> Result<Self> {
                each!(self, T, s => Ok(s.reparametrised(&T::of(start)?, &T::of(end)?)?.into()))
            }

            /// The same with clamped ends.
            ///
            /// # Errors
            /// Those of the library.
            pub fn clamped_ends(&self) -> Result<Self> {
                each!(self, s => Ok(s.clamped_ends()?.into()))
            }
        }
    };
}

of_one_parameter!(AnySpline);
of_one_parameter!(AnyRational);

impl AnySpline {
    /// The antiderivative that vanishes at the start of the domain.
    ///
    /// # Errors
    /// Those of the library: a periodic one needs a mean of zero.
    pub fn antiderivative(&self) -> Result<Self> {
        each!(self, s => Ok(s.antiderivative()?.into()))
    }

    /// The integral over the domain.
    ///
    /// # Errors
    /// Those of the library.
    pub fn integral(&self) -> Result<Coords> {
        each!(self, s => Ok(point(&s.integral()?)))
    }

    /// The integral from one parameter to another.
    ///
    /// # Errors
    /// [`symspline::Error::OutsideDomain`].
    pub fn integral_between(&self, a: &Number, b: &Number) -> Result<Coords> {
        each!(self, T, s => Ok(point(&s.integral_between(&T::of(a)?, &T::of(b)?)?)))
    }

    /// The inner product `∫ f · g`.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimensions`], and those of the library.
    pub fn inner(&self, other: &Self) -> Result<Number> {
        crate::alike!(self, other, s, t => Ok(s.inner(t)?.number()))
    }

    /// The composition with a function, `x` going to `self(inner(x))`.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimensions`], and those of the library: values of `inner` must lie in the domain.
    pub fn composed(&self, inner: &Self) -> Result<Self> {
        with_function!(self, inner, s, f => Ok(s.composed(f)?.into()))
    }

    /// The same with the lowest degree and the fewest knots that hold it exactly.
    ///
    /// # Errors
    /// Those of the library.
    pub fn simplified(&self) -> Result<Self> {
        each!(self, s => Ok(s.simplified()?.into()))
    }

    /// The same in a space that holds its own.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`symspline::Spline::embedded`] if the space does not hold this one.
    pub fn embedded(&self, target: &AnySpace) -> Result<Self> {
        match (self, target) {
            (Any::F1(s), Over::Float(t)) => Ok(s.embedded(t)?.into()),
            (Any::F2(s), Over::Float(t)) => Ok(s.embedded(t)?.into()),
            (Any::F3(s), Over::Float(t)) => Ok(s.embedded(t)?.into()),
            (Any::Q1(s), Over::Exact(t)) => Ok(s.embedded(t)?.into()),
            (Any::Q2(s), Over::Exact(t)) => Ok(s.embedded(t)?.into()),
            (Any::Q3(s), Over::Exact(t)) => Ok(s.embedded(t)?.into()),
            (s, t) => Err(Error::Fields { left: s.field(), right: t.field() }),
        }
    }
}

/// What polynomial and rational splines of two parameters have in common.
macro_rules! of_two_parameters {
    ($any:ty, $along:ty) => {
        impl $any {
            /// The space of one parameter.
            pub fn space(&self, direction: Direction) -> AnySpace {
                each!(self, s => match direction {
                    Direction::U => s.u().clone().into(),
                    Direction::V => s.v().clone().into(),
                })
            }

            /// The value at a pair of parameters.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn at(&self, u: &Number, v: &Number) -> Result<Coords> {
                each!(self, T, s => Ok(point(&s.at(&T::of(u)?, &T::of(v)?)?)))
            }

            /// The values on a grid, row by row, each row of one `u`, their coordinates one after the other.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn eval_grid(&self, us: &Coords, vs: &Coords) -> Result<Coords> {
                each!(self, T, s => Ok(crate::number::flat(&s.eval_grid(&T::all_of(us)?, &T::all_of(vs)?)?)))
            }

            /// All mixed derivatives up to an order, `[k][l]` of `k` in `u` and `l` in `v`.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn derivatives_at(&self, u: &Number, v: &Number, order: usize) -> Result<Vec<Vec<Coords>>> {
                each!(self, T, s => {
                    let all = s.derivatives_at(&T::of(u)?, &T::of(v)?, order)?;
                    Ok(all.iter().map(|row| row.iter().map(point).collect()).collect())
                })
            }

            /// The curve at one parameter.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn isocurve(&self, direction: Direction, x: &Number) -> Result<$along> {
                each!(self, T, s => Ok(s.isocurve(direction, &T::of(x)?)?.into()))
            }

            /// The derivative in one direction.
            ///
            /// # Errors
            /// Those of the library: a jump has none.
            pub fn derivative(&self, direction: Direction) -> Result<Self> {
                self.nth_derivative(direction, 1)
            }

            /// The derivative of an order in one direction.
            ///
            /// # Errors
            /// As [`derivative`](Self::derivative); [`symspline::Error::DegreeTooHigh`].
            pub fn nth_derivative(&self, direction: Direction, order: usize) -> Result<Self> {
                let (k, l) = match direction {
                    Direction::U => (order, 0),
                    Direction::V => (0, order),
                };
                each!(self, s => Ok(s.partial(k, l)?.into()))
            }

            /// The same with a higher degree.
            ///
            /// # Errors
            /// [`symspline::Error::DegreeTooHigh`].
            pub fn elevated(&self, direction: Direction, raise: usize) -> Result<Self> {
                each!(self, s => Ok(s.elevated(direction, raise)?.into()))
            }

            /// The same with more knots.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`], [`symspline::Error::Multiplicity`].
            pub fn inserted(&self, direction: Direction, knots: &Coords) -> Result<Self> {
                each!(self, T, s => Ok(s.inserted(direction, &T::all_of(knots)?)?.into()))
            }

            /// The part between two parameters.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`], [`symspline::Error::EmptyDomain`].
            pub fn restricted(&self, direction: Direction, a: &Number, b: &Number) -> Result<Self> {
                each!(self, T, s => Ok(s.restricted(direction, &T::of(a)?, &T::of(b)?)?.into()))
            }

            /// The parts before and after a parameter.
            ///
            /// # Errors
            /// [`symspline::Error::OutsideDomain`].
            pub fn split(&self, direction: Direction, x: &Number) -> Result<(Self, Self)> {
                each!(self, T, s => {
                    let (before, after) = s.split(direction, &T::of(x)?)?;
                    Ok((before.into(), after.into()))
                })
            }

            /// The same run through backwards in one direction.
            ///
            /// # Errors
            /// Those of the library.
            pub fn reversed(&self, direction: Direction) -> Result<Self> {
                each!(self, s => Ok(s.reversed(direction)?.into()))
            }

            /// The same with clamped ends.
            ///
            /// # Errors
            /// Those of the library.
            pub fn clamped_ends(&self) -> Result<Self> {
                each!(self, s => Ok(s.clamped_ends()?.into()))
            }
        }
    };
}

of_two_parameters!(AnySurface, AnySpline);
of_two_parameters!(AnyRationalSurface, AnyRational);

impl AnySurface {
    /// The antiderivative in one direction.
    ///
    /// # Errors
    /// Those of the library.
    pub fn antiderivative(&self, direction: Direction) -> Result<Self> {
        each!(self, s => Ok(s.antiderivative(direction)?.into()))
    }

    /// The integral over the domain.
    ///
    /// # Errors
    /// Those of the library.
    pub fn integral(&self) -> Result<Coords> {
        each!(self, s => Ok(point(&s.integral()?)))
    }

    /// The same with the parameters exchanged.
    pub fn transposed(&self) -> Self {
        each!(self, s => s.transposed().into())
    }

    /// The curve on the surface over a plane curve in its domain.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], and those of the library.
    pub fn composed(&self, curve: &AnySpline) -> Result<AnySpline> {
        match (self, curve) {
            (Self::F1(s), Any::F2(c)) => Ok(s.composed(c)?.into()),
            (Self::F2(s), Any::F2(c)) => Ok(s.composed(c)?.into()),
            (Self::F3(s), Any::F2(c)) => Ok(s.composed(c)?.into()),
            (Self::Q1(s), Any::Q2(c)) => Ok(s.composed(c)?.into()),
            (Self::Q2(s), Any::Q2(c)) => Ok(s.composed(c)?.into()),
            (Self::Q3(s), Any::Q2(c)) => Ok(s.composed(c)?.into()),
            (s, c) if s.is_exact() != c.is_exact() => {
                Err(Error::Fields { left: s.field(), right: c.field() })
            }
            (_, c) => Err(Error::Dimensions { left: 2, right: c.dim() }),
        }
    }
}

impl AnyRationalSurface {
    /// The same with the parameters exchanged.
    ///
    /// # Errors
    /// Those of the library.
    pub fn transposed(&self) -> Result<Self> {
        each!(self, s => Ok(s.transposed()?.into()))
    }
}

/// A point from coordinates of either field.
///
/// # Errors
/// [`Error::Dimensions`], [`symspline::Error::NotFinite`].
pub fn coefficient<T: Field, C: Flat<T>>(coords: &Coords) -> Result<C> {
    C::from_coords(&T::all_of(coords)?)
}
