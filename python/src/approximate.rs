//! Approximations with a certified bound: lower degrees, fewer knots, other spaces.
//!
//! A tolerance is a number of the field of the spline, whatever it was given as: it makes no floats of fractions.

use crate::arguments::{Along, SIDES, Smooth, Touch, word};
use crate::error::Result;
use crate::numbers::Num;
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::space::Space;
use crate::spline::Spline;
use crate::surface::Surface;
use pyo3::prelude::*;
use symspline::Approximation;
use symspline_dynamic::{Any, Family, Field, Spaced, alike, each, together};

/// A spline, and at least the largest distance from what it approximates.
fn near<F: Family, S: Into<Any<F>>, T: Field>(approximation: Approximation<S, T>) -> (Any<F>, Num) {
    (approximation.spline.into(), Num(approximation.bound.number()))
}

/// One text for an approximation of a spline: the class around it, and the bound.
macro_rules! near {
    ($py:ident, $class:ident, $any:expr, $T:ident, $s:ident => $body:expr) => {
        $py.detach(|| {
            let (spline, bound) = each!($any, $T, $s => Result::Ok(near($body?)))?;
            Ok(($class(spline), bound))
        })
    };
}

#[pymethods]
impl Spline {
    /// The same with a lower degree, if it is of that degree.
    #[pyo3(signature = (by=1))]
    fn degree_reduced_exactly(&self, py: Python<'_>, by: usize) -> Result<Self> {
        py.detach(|| each!(&self.0, s => Ok(Self(s.degree_reduced_exactly(by)?.into()))))
    }

    /// A spline of a lower degree near this one, found knot by knot, and a bound of the distance.
    #[pyo3(signature = (by=1))]
    fn degree_lowered(&self, py: Python<'_>, by: usize) -> Result<(Self, Num)> {
        near!(py, Self, &self.0, T, s => { let _: Option<T>; s.degree_lowered(by) })
    }

    /// The best spline of a lower degree in the mean square, and a bound of the distance. `continuity` as in `Space.reduced`;
    /// `contact` is how many derivatives are kept at the ends, the value counting as the first, or a pair of such numbers.
    #[pyo3(signature = (by=1, continuity=Smooth::default(), contact=Touch::default()))]
    fn degree_reduced(
        &self,
        py: Python<'_>,
        by: usize,
        continuity: Smooth,
        contact: Touch,
    ) -> Result<(Self, Num)> {
        near!(py, Self, &self.0, T, s => { let _: Option<T>; s.degree_reduced(by, continuity.0, contact.0) })
    }

    /// A spline of a lower degree within a tolerance, with as many more knots as that takes, and a bound of the distance.
    #[pyo3(signature = (by, tolerance, contact=Touch::default()))]
    fn degree_reduced_within(
        &self,
        py: Python<'_>,
        by: usize,
        tolerance: Num,
        contact: Touch,
    ) -> Result<(Self, Num)> {
        near!(py, Self, &self.0, T, s => s.degree_reduced_within(by, &T::of(&tolerance.0)?, contact.0))
    }

    /// The spline without up to `times` copies of a knot, as far as it stays within a tolerance, and a bound of the distance.
    #[pyo3(signature = (knot, times=1, tolerance=Num::int(0)))]
    fn removed(&self, py: Python<'_>, knot: Num, times: usize, tolerance: Num) -> Result<(Self, Num)> {
        let (s, knot) = (&self.0, &knot.0);
        together!(s, knot);
        near!(py, Self, &*s, T, s => s.removed(&T::of(&knot)?, times, &T::of(&tolerance.0)?))
    }

    /// The spline with as few knots as a tolerance allows, and a bound of the distance.
    fn without_spare_knots(&self, py: Python<'_>, tolerance: Num) -> Result<(Self, Num)> {
        near!(py, Self, &self.0, T, s => s.without_spare_knots(&T::of(&tolerance.0)?))
    }

    /// As `without_spare_knots`, for a spline that may change between two parameters alone.
    fn without_spare_knots_on(
        &self,
        py: Python<'_>,
        start: Num,
        end: Num,
        tolerance: Num,
    ) -> Result<(Self, Num)> {
        let (s, start, end) = (&self.0, &start.0, &end.0);
        together!(s, start, end);
        near!(py, Self, &*s, T, s => s.without_spare_knots_on(&T::of(&start)?, &T::of(&end)?, &T::of(&tolerance.0)?))
    }

    /// The spline without one copy of the knot at an index, whatever that changes: `keep` ("left", "right") is the side that keeps
    /// its coefficients. With a bound of the distance, and the ends of the interval outside which nothing changes.
    fn without_knot(&self, py: Python<'_>, index: usize, keep: &str) -> Result<(Self, Num, (Num, Num))> {
        let keep = word("keep", keep, &SIDES)?;
        py.detach(|| {
            each!(&self.0, s => {
                let dropped = s.without_knot(index, keep)?;
                let (start, end) = dropped.changed;
                let changed = (Num(start.number()), Num(end.number()));
                Ok((Self(dropped.spline.into()), Num(dropped.bound.number()), changed))
            })
        })
    }

    /// The best spline of a space in the mean square, and a bound of the distance. `contact` as in `degree_reduced`.
    #[pyo3(signature = (target, contact=Touch::default()))]
    fn projected(&self, py: Python<'_>, target: &Space, contact: Touch) -> Result<(Self, Num)> {
        let (s, t) = (&self.0, &target.0);
        together!(s, t);
        near!(py, Self, &*s, T, s => s.projected(<T as Spaced>::space(&t)?, contact.0))
    }

    /// A spline within a tolerance in a space or in finer ones, and a bound of the distance.
    #[pyo3(signature = (start, tolerance, contact=Touch::default()))]
    fn approximated_within(
        &self,
        py: Python<'_>,
        start: &Space,
        tolerance: Num,
        contact: Touch,
    ) -> Result<(Self, Num)> {
        let (s, t) = (&self.0, &start.0);
        together!(s, t);
        near!(py, Self, &*s, T, s => {
            s.approximated_within(<T as Spaced>::space(&t)?, &T::of(&tolerance.0)?, contact.0)
        })
    }

    /// The quasi-interpolant in a space, and a bound of the distance.
    fn quasi_interpolated(&self, py: Python<'_>, target: &Space) -> Result<(Self, Num)> {
        let (s, t) = (&self.0, &target.0);
        together!(s, t);
        near!(py, Self, &*s, T, s => s.quasi_interpolated(<T as Spaced>::space(&t)?))
    }

    /// At least the size of every value.
    fn size_bound(&self) -> Result<Num> {
        each!(&self.0, s => Ok(Num(s.size_bound()?.number())))
    }

    /// At least the distance from another everywhere; halving sharpens it.
    #[pyo3(signature = (other, halvings=0))]
    fn distance_bound(&self, py: Python<'_>, other: &Self, halvings: usize) -> Result<Num> {
        let (s, t) = (&self.0, &other.0);
        together!(s, t);
        py.detach(|| {
            alike!(&*s, &*t, s, t => Ok(Num(match halvings {
                0 => s.distance_bound(t)?.number(),
                _ => s.distance_bound_halved(t, halvings)?.number(),
            })))
        })
    }
}

macro_rules! simplified {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The same with the lowest degree and the fewest knots that hold it exactly.
            fn simplified(&self, py: Python<'_>) -> Result<Self> {
                py.detach(|| each!(&self.0, s => Ok(Self(s.simplified()?.into()))))
            }

            /// One with a low degree and few knots within a tolerance, and a bound of the distance.
            fn simplified_within(&self, py: Python<'_>, tolerance: Num) -> Result<(Self, Num)> {
                near!(py, Self, &self.0, T, s => s.simplified_within(&T::of(&tolerance.0)?))
            }
        }
    };
}

simplified!(Spline);
simplified!(Surface);

#[pymethods]
impl Surface {
    /// The best surface of two spaces in the mean square, and a bound of the distance.
    fn projected(&self, py: Python<'_>, u: &Space, v: &Space) -> Result<(Self, Num)> {
        let (s, u, v) = (&self.0, &u.0, &v.0);
        together!(s, u, v);
        near!(py, Self, &*s, T, s => s.projected(<T as Spaced>::space(&u)?, <T as Spaced>::space(&v)?))
    }

    /// The surface of a lower degree in one direction near this one, and a bound of the distance.
    #[pyo3(signature = (direction, by=1))]
    fn degree_lowered(&self, py: Python<'_>, direction: Along, by: usize) -> Result<(Self, Num)> {
        near!(py, Self, &self.0, T, s => {
            let _: Option<T>;
            s.approximated_along(direction.0, |rows| rows.degree_lowered(by))
        })
    }

    /// The surface without up to `times` copies of a knot of one direction, as far as it stays within a tolerance, and a bound of
    /// the distance.
    #[pyo3(signature = (direction, knot, times=1, tolerance=Num::int(0)))]
    fn removed(
        &self,
        py: Python<'_>,
        direction: Along,
        knot: Num,
        times: usize,
        tolerance: Num,
    ) -> Result<(Self, Num)> {
        let (s, knot) = (&self.0, &knot.0);
        together!(s, knot);
        near!(py, Self, &*s, T, s => {
            let (knot, tolerance) = (T::of(&knot)?, T::of(&tolerance.0)?);
            s.approximated_along(direction.0, |rows| rows.removed(&knot, times, &tolerance))
        })
    }

    /// The surface with few knots in the rectangle from `start` to `end`, pairs of parameters, outside which it does not change, and
    /// a bound of the distance.
    fn without_spare_knots_on(
        &self,
        py: Python<'_>,
        start: (Num, Num),
        end: (Num, Num),
        tolerance: Num,
    ) -> Result<(Self, Num)> {
        let (s, a, b, c, d) = (&self.0, &start.0.0, &start.1.0, &end.0.0, &end.1.0);
        together!(s, a, b, c, d);
        near!(py, Self, &*s, T, s => {
            let (from, to) = ((T::of(&a)?, T::of(&b)?), (T::of(&c)?, T::of(&d)?));
            s.without_spare_knots_on(&from, &to, &T::of(&tolerance.0)?)
        })
    }
}

#[pymethods]
impl Rational {
    /// The curve with as few knots as a tolerance allows, and a bound of the distance.
    fn without_spare_knots(&self, py: Python<'_>, tolerance: Num) -> Result<(Self, Num)> {
        near!(py, Self, &self.0, T, s => {
            s.approximated(&T::of(&tolerance.0)?, |lifted, tolerance| lifted.without_spare_knots(tolerance))
        })
    }

    /// One with a low degree and few knots within a tolerance, and a bound of the distance.
    fn simplified_within(&self, py: Python<'_>, tolerance: Num) -> Result<(Self, Num)> {
        near!(py, Self, &self.0, T, s => {
            s.approximated(&T::of(&tolerance.0)?, |lifted, tolerance| lifted.simplified_within(tolerance))
        })
    }
}

macro_rules! polynomial {
    ($class:ident, $polynomial:ident) => {
        #[pymethods]
        impl $class {
            /// A polynomial spline within a tolerance, of a degree (at least that of this one; 3 if none is given), and a bound of the
            /// distance.
            #[pyo3(signature = (tolerance, degree=None))]
            fn polynomial_within(
                &self,
                py: Python<'_>,
                tolerance: Num,
                degree: Option<usize>,
            ) -> Result<($polynomial, Num)> {
                near!(py, $polynomial, &self.0, T, s => match degree {
                    None => s.polynomial_within(&T::of(&tolerance.0)?),
                    Some(degree) => s.polynomial_of_degree_within(degree, &T::of(&tolerance.0)?),
                })
            }
        }
    };
}

polynomial!(Rational, Spline);
polynomial!(RationalSurface, Surface);
