//! Integrals, compositions, products with weights, and forms of surfaces.

use crate::arguments::Along;
use crate::error::Result;
use crate::numbers::{Array, Num, Point};
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::spline::Spline;
use crate::surface::Surface;
use pyo3::prelude::*;
use symspline::QuadraticForm;
use symspline_dynamic::number::flat;
use symspline_dynamic::{
    Any, AnySurface, Error, Family, Field, Number, each, each_curve, together, with_function,
};

/// Three numbers or three functions: the factors of `du²`, of `2 du dv`, of `dv²`.
type Form<X> = (X, X, X);

fn numbers<T: Field>(form: QuadraticForm<T>) -> Form<Num> {
    (Num(form.uu.number()), Num(form.uv.number()), Num(form.vv.number()))
}

fn surfaces<T>(form: QuadraticForm<T>) -> Form<Surface>
where
    AnySurface: From<T>,
{
    (Surface(form.uu.into()), Surface(form.uv.into()), Surface(form.vv.into()))
}

/// That values in space are needed.
fn not_in_space<F: Family>(found: &Any<F>) -> Error {
    Error::Dimensions { left: 3, right: found.dim() }
}

/// One text for what has points in space, over either field.
macro_rules! in_space {
    ($any:expr, $T:ident, $s:ident => $body:expr) => {
        match $any {
            Any::F3($s) => each!(@ f64, $T, $body),
            Any::Q3($s) => each!(@ symspline::Q, $T, $body),
            other => Err(not_in_space(other).into()),
        }
    };
}

#[pymethods]
impl Spline {
    /// The function `x**power` on `[a, b]`.
    #[staticmethod]
    #[pyo3(signature = (power, a=Num::int(0), b=Num::int(1)))]
    fn monomial(power: usize, a: Num, b: Num) -> Result<Self> {
        let (a, b) = (&a.0, &b.0);
        together!(a, b);
        symspline_dynamic::both!(&*a, T, a => {
            Ok(Self(symspline::Function::<T>::monomial(power, a.clone(), T::of(&b)?)?.into()))
        })
    }

    /// The antiderivative that vanishes at the start of the domain. A periodic spline has one if its integral is exactly zero.
    fn antiderivative(&self, py: Python<'_>) -> Result<Self> {
        py.detach(|| Ok(Self(self.0.antiderivative()?)))
    }

    /// The integral from `a` to `b`, or over the domain: a number or a point. As a function: `antiderivative`.
    #[pyo3(signature = (a=None, b=None))]
    fn integral(&self, py: Python<'_>, a: Option<Num>, b: Option<Num>) -> Result<Point> {
        py.detach(|| {
            let (start, end) = self.0.domain();
            let (s, a, b) = (&self.0, &a.map_or(start, |a| a.0), &b.map_or(end, |b| b.0));
            together!(s, a, b);
            Ok(Point(s.integral_between(&a, &b)?))
        })
    }

    /// The integral of the values times a power of the parameter: a number or a point.
    fn moment(&self, py: Python<'_>, power: usize) -> Result<Point> {
        py.detach(|| each!(&self.0, T, s => Ok(Point(flat::<T, _>(&[s.moment(power)?])))))
    }

    /// The integral of the values times a function: a number or a point.
    fn weighted_integral(&self, py: Python<'_>, weight: &Self) -> Result<Point> {
        py.detach(|| {
            let (s, w) = (&self.0, &weight.0);
            together!(s, w);
            with_function!(&*s, &*w, s, w => Ok(Point(flat(&[s.weighted_integral(w)?]))))
        })
    }

    /// The inner product with another: the integral of the inner products of the values.
    fn inner(&self, py: Python<'_>, other: &Self) -> Result<Num> {
        let (s, t) = (&self.0, &other.0);
        together!(s, t);
        py.detach(|| Ok(Num(s.inner(&t)?)))
    }

    /// The composition with a function, `x` going to `self(inner(x))`; its values must lie in the domain.
    fn composed(&self, py: Python<'_>, inner: &Self) -> Result<Self> {
        let (s, t) = (&self.0, &inner.0);
        together!(s, t);
        py.detach(|| Ok(Self(s.composed(&t)?)))
    }

    /// The composition with an increasing function that runs over the whole domain.
    fn reparametrised_by(&self, py: Python<'_>, change: &Self) -> Result<Self> {
        let (s, t) = (&self.0, &change.0);
        together!(s, t);
        py.detach(|| with_function!(&*s, &*t, s, t => Ok(Self(s.reparametrised_by(t)?.into()))))
    }
}

#[pymethods]
impl Rational {
    /// The same curve over `[start, end]`, its parameter changed by the Moebius map with a ratio: it starts `ratio` times as fast.
    fn moebius(&self, start: Num, end: Num, ratio: Num) -> Result<Self> {
        let (s, a, b, r) = (&self.0, &start.0, &end.0, &ratio.0);
        together!(s, a, b, r);
        each!(&*s, T, s => Ok(Self(s.moebius(&T::of(&a)?, &T::of(&b)?, &T::of(&r)?)?.into())))
    }

    /// The rational basis functions at a parameter and their derivatives up to an order: a list of pairs, the index of the first
    /// and the values, of shape `(degree + 1,)`.
    fn basis_derivatives(&self, x: Num, order: usize) -> Result<Vec<(usize, Array)>> {
        let (s, x) = (&self.0, &x.0);
        together!(s, x);
        each!(&*s, T, s => {
            let rows = s.basis_derivatives(&T::of(&x)?, order)?;
            Ok(rows.iter().map(|row| (row.first(), Array::row(row.weights().to_vec()))).collect())
        })
    }
}

#[pymethods]
impl Surface {
    /// The mixed derivative, `k` times in `u` and `l` times in `v`.
    fn partial(&self, py: Python<'_>, k: usize, l: usize) -> Result<Self> {
        py.detach(|| each!(&self.0, s => Ok(Self(s.partial(k, l)?.into()))))
    }

    /// The antiderivative in one direction that vanishes at the start.
    fn antiderivative(&self, py: Python<'_>, direction: Along) -> Result<Self> {
        py.detach(|| Ok(Self(self.0.antiderivative(direction.0)?)))
    }

    /// The integral over the rectangle from `start` to `end`, pairs of parameters, or over the domain: a number or a point.
    #[pyo3(signature = (start=None, end=None))]
    fn integral(&self, py: Python<'_>, start: Option<(Num, Num)>, end: Option<(Num, Num)>) -> Result<Point> {
        let corner =
            |pair: Option<(Num, Num)>, last: bool| -> (Number, Number) {
                pair.map_or_else(
                || each!(&self.0, s => {
                    let [u, v] = [s.u(), s.v()].map(|s| if last { s.domain().1 } else { s.domain().0 });
                    (u.clone().number(), v.clone().number())
                }),
                |(u, v)| (u.0, v.0),
            )
            };
        let ((a, c), (b, d)) = (corner(start, false), corner(end, true));
        py.detach(|| {
            let (s, a, b, c, d) = (&self.0, &a, &b, &c, &d);
            together!(s, a, b, c, d);
            each!(&*s, T, s => {
                let [a, b, c, d] = [T::of(&a)?, T::of(&b)?, T::of(&c)?, T::of(&d)?];
                Ok(Point(flat::<T, _>(&[s.integral_between((&a, &c), (&b, &d))?])))
            })
        })
    }

    /// The integral of the values times `u**k * v**l`: a number or a point.
    fn moment(&self, py: Python<'_>, k: usize, l: usize) -> Result<Point> {
        py.detach(|| each!(&self.0, T, s => Ok(Point(flat::<T, _>(&[s.moment(k, l)?])))))
    }

    /// The curve on the surface over a plane curve in its domain.
    fn composed(&self, py: Python<'_>, curve: &Spline) -> Result<Spline> {
        let (s, t) = (&self.0, &curve.0);
        together!(s, t);
        py.detach(|| Ok(Spline(s.composed(&t)?)))
    }

    /// The moment `∬ x**powers[0] * y**powers[1] dx dy` over the region that a surface in the plane covers.
    fn area_moment(&self, py: Python<'_>, powers: [usize; 2]) -> Result<Num> {
        py.detach(|| match &self.0 {
            Any::F2(s) => Ok(Num(s.area_moment(powers)?.number())),
            Any::Q2(s) => Ok(Num(s.area_moment(powers)?.number())),
            other => Err(Error::Dimensions { left: 2, right: other.dim() }.into()),
        })
    }

    /// The moment `∭ x**a * y**b * z**c dV`, `powers = (a, b, c)`, of the cone from the origin over a surface in space; over a closed
    /// surface, of the solid inside.
    fn volume_moment(&self, py: Python<'_>, powers: [usize; 3]) -> Result<Num> {
        py.detach(|| in_space!(&self.0, _T, s => Ok(Num(s.volume_moment(powers)?.number()))))
    }

    /// The integral of the normals of a surface in space, of shape `(3,)`.
    fn vector_area(&self, py: Python<'_>) -> Result<Array> {
        py.detach(
            || in_space!(&self.0, T, s => Ok(Array::row::<T>(s.vector_area()?.iter().cloned().collect()))),
        )
    }

    /// The normals `S_u × S_v` of a surface in space, not of unit length, as a surface.
    fn normal(&self, py: Python<'_>) -> Result<Self> {
        py.detach(|| in_space!(&self.0, _T, s => Ok(Self(s.normal()?.into()))))
    }

    /// The first fundamental form as three functions: the factors of `du²`, of `2 du dv`, of `dv²`.
    fn first_form(&self, py: Python<'_>) -> Result<Form<Self>> {
        py.detach(|| {
            each_curve!(&self.0, T, s => { let _: Option<T>; Ok(surfaces(s.first_form()?)) },
                Err(Error::Dimension { found: 1, least: 2 }.into()))
        })
    }

    /// The second fundamental form times the length of `normal()`, as three functions.
    fn scaled_second_form(&self, py: Python<'_>) -> Result<Form<Self>> {
        py.detach(|| in_space!(&self.0, _T, s => Ok(surfaces(s.scaled_second_form()?))))
    }
}

macro_rules! forms {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The first fundamental form at a pair of parameters: the factors of `du²`, of `2 du dv`, of `dv²`.
            fn first_form_at(&self, u: Num, v: Num) -> Result<Form<Num>> {
                let (s, u, v) = (&self.0, &u.0, &v.0);
                together!(s, u, v);
                each_curve!(&*s, T, s => Ok(numbers(s.first_form_at(&T::of(&u)?, &T::of(&v)?)?)),
                    Err(Error::Dimension { found: 1, least: 2 }.into()))
            }

            /// The normal `S_u × S_v` at a pair of parameters, of shape `(3,)`, not of unit length.
            fn normal_at(&self, u: Num, v: Num) -> Result<Array> {
                let (s, u, v) = (&self.0, &u.0, &v.0);
                together!(s, u, v);
                in_space!(&*s, T, s => {
                    Ok(Array::row::<T>(s.normal_at(&T::of(&u)?, &T::of(&v)?)?.iter().cloned().collect()))
                })
            }

            /// The unit normal at a pair of parameters, of shape `(3,)`, in floats.
            fn unit_normal_at(&self, u: Num, v: Num) -> Result<Array> {
                match &self.0.to_float()? {
                    Any::F3(s) => {
                        let normal = s.unit_normal_at(&f64::of(&u.0)?, &f64::of(&v.0)?)?;
                        Ok(Array::row(normal.iter().copied().collect()))
                    }
                    other => Err(not_in_space(other).into()),
                }
            }

            /// The second fundamental form at a pair of parameters, in floats: the factors of `du²`, of `2 du dv`, of `dv²`.
            fn second_form_at(&self, u: Num, v: Num) -> Result<Form<Num>> {
                match &self.0.to_float()? {
                    Any::F3(s) => Ok(numbers(s.second_form_at(&f64::of(&u.0)?, &f64::of(&v.0)?)?)),
                    other => Err(not_in_space(other).into()),
                }
            }
        }
    };
}

forms!(Surface);
forms!(RationalSurface);

#[pymethods]
impl RationalSurface {
    /// The same surface with its parameter in one direction changed by a Moebius map.
    fn moebius(&self, direction: Along, start: Num, end: Num, ratio: Num) -> Result<Self> {
        let (s, a, b, r) = (&self.0, &start.0, &end.0, &ratio.0);
        together!(s, a, b, r);
        each!(&*s, T, s => {
            Ok(Self(s.moebius(direction.0, &T::of(&a)?, &T::of(&b)?, &T::of(&r)?)?.into()))
        })
    }
}
