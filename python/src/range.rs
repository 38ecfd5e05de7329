//! Enclosures of extreme values, and boxes.

use crate::error::Result;
use crate::numbers::{Array, Num, Point};
use crate::rational::Rational;
use crate::rational_surface::RationalSurface;
use crate::record::record;
use crate::spline::Spline;
use crate::surface::Surface;
use pyo3::prelude::*;
use symspline::Enclosure;
use symspline_dynamic::{Any, Error, Field, each_curve};

record! {
    "symspline"
    /// An extreme value between a bound and a value met.
    Extremum {
        /// The function nowhere goes beyond this.
        bound: Num,
        /// The function goes that far: its value at `parameter`.
        value: Num,
        /// Where `value` is met: a parameter, or two in an array.
        parameter: Point,
    }
}

/// The place of an extreme value.
trait Place {
    fn point(self) -> Point;
}

macro_rules! place {
    ($($field:ty),+) => {
        $(impl Place for $field {
            fn point(self) -> Point {
                Point(Field::coords(vec![self]))
            }
        }

        impl Place for ($field, $field) {
            fn point(self) -> Point {
                Point(Field::coords(vec![self.0, self.1]))
            }
        })+
    };
}

place!(f64, symspline::Q);

fn ends<T: Field, X: Place>(enclosure: Enclosure<T, X>) -> (Extremum, Extremum) {
    let end = |e: symspline::Extremum<T, X>| Extremum {
        bound: Num(e.bound.number()),
        value: Num(e.value.number()),
        parameter: e.parameter.point(),
    };
    (end(enclosure.least), end(enclosure.greatest))
}

macro_rules! range {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The least and the greatest value of a function, each enclosed to an accuracy.
            fn range(&self, py: Python<'_>, accuracy: Num) -> Result<(Extremum, Extremum)> {
                py.detach(|| match &self.0 {
                    Any::F1(s) => Ok(ends(s.range(&Field::of(&accuracy.0)?)?)),
                    Any::Q1(s) => Ok(ends(s.range(&Field::of(&accuracy.0)?)?)),
                    other => Err(Error::Dimensions { left: 1, right: other.dim() }.into()),
                })
            }

            /// The least and the greatest value of each coordinate, enclosed to an accuracy: a list of pairs.
            fn bounding_box(&self, py: Python<'_>, accuracy: Num) -> Result<Vec<(Extremum, Extremum)>> {
                py.detach(|| each_curve!(&self.0, T, s => {
                    Ok(s.bounding_box(&T::of(&accuracy.0)?)?.into_iter().map(ends).collect())
                }, match &self.0 {
                    Any::F1(s) => Ok(vec![ends(s.range(&Field::of(&accuracy.0)?)?)]),
                    Any::Q1(s) => Ok(vec![ends(s.range(&Field::of(&accuracy.0)?)?)]),
                    other => Err(Error::Dimensions { left: 1, right: other.dim() }.into()),
                }))
            }
        }
    };
}

range!(Spline);
range!(Surface);
range!(Rational);
range!(RationalSurface);

macro_rules! control_box {
    ($class:ident, $corners:expr) => {
        #[pymethods]
        impl $class {
            /// The lowest and the highest corner of the box of the control points, of shape `(d,)`.
            fn control_box(&self) -> Result<(Array, Array)> {
                each_curve!(&self.0, T, s => {
                    let (low, high) = $corners(s.control_box())?;
                    let [low, high] = [low, high].map(|p| Array::row::<T>(p.iter().cloned().collect()));
                    Ok((low, high))
                }, Err(Error::Dimension { found: 1, least: 2 }.into()))
            }
        }
    };
}

control_box!(Spline, Result::Ok);
control_box!(Surface, Result::Ok);
control_box!(Rational, std::convert::identity);
control_box!(RationalSurface, std::convert::identity);

macro_rules! coefficients {
    ($class:ident) => {
        #[pymethods]
        impl $class {
            /// The least and the greatest coefficient of a function, between which all values lie.
            fn coefficient_range(&self) -> Result<(Num, Num)> {
                fn pair<T: Field>((a, b): (T, T)) -> (Num, Num) {
                    (Num(a.number()), Num(b.number()))
                }
                match &self.0 {
                    Any::F1(s) => Ok(pair(s.coefficient_range())),
                    Any::Q1(s) => Ok(pair(s.coefficient_range())),
                    other => Err(Error::Dimensions { left: 1, right: other.dim() }.into()),
                }
            }

            /// A positive number below all values of a positive function.
            fn positive_bound(&self, py: Python<'_>) -> Result<Num> {
                py.detach(|| match &self.0 {
                    Any::F1(s) => Ok(Num(s.positive_bound()?.number())),
                    Any::Q1(s) => Ok(Num(s.positive_bound()?.number())),
                    other => Err(Error::Dimensions { left: 1, right: other.dim() }.into()),
                })
            }
        }
    };
}

coefficients!(Spline);
coefficients!(Surface);
