//! Arithmetic of values: what `+`, `-`, `*`, `/`, dots and crosses mean for each pair of kinds.

use crate::any::{Any, Family};
use crate::error::{Error, Result};
use crate::family::{AnyRational, AnyRationalSurface, AnySpline, AnySurface};
use crate::number::{Field, Number};
use crate::over::{Coords, Over};
use crate::value::Value;
use symspline::{Q, Scalar};

/// Two numbers over one field: over floats if either is one.
fn meet(
    x: &Number,
    y: &Number,
    float: impl Fn(f64, f64) -> f64,
    exact: impl Fn(Q, Q) -> Q,
) -> Result<Number> {
    match (x, y) {
        (Over::Exact(x), Over::Exact(y)) => Ok(Over::Exact(exact(x.clone(), y.clone()))),
        (x, y) => Ok(Over::Float(float(f64::of(x)?, f64::of(y)?))),
    }
}

/// Two points over one field, coordinate by coordinate.
fn meet_points(
    p: &Coords,
    q: &Coords,
    float: impl Fn(f64, f64) -> f64,
    exact: impl Fn(Q, Q) -> Q,
) -> Result<Coords> {
    if p.len() != q.len() {
        return Err(Error::Dimensions { left: p.len(), right: q.len() });
    }
    Ok(match (p, q) {
        (Over::Exact(p), Over::Exact(q)) => {
            Over::Exact(p.iter().zip(q).map(|(x, y)| exact(x.clone(), y.clone())).collect())
        }
        (p, q) => {
            let (p, q) = (f64::all_of(p)?, f64::all_of(q)?);
            Over::Float(p.into_iter().zip(q).map(|(x, y)| float(x, y)).collect())
        }
    })
}

/// Both as rational ones if either is.
fn promoted(left: &Value, right: &Value) -> Result<(Value, Value)> {
    use Value::{Rational, RationalSurface, Spline, Surface};
    Ok(match (left, right) {
        (Spline(s), Rational(t)) => (AnyRational::from_polynomial(s)?.into(), t.clone().into()),
        (Rational(s), Spline(t)) => (s.clone().into(), AnyRational::from_polynomial(t)?.into()),
        (Surface(s), RationalSurface(t)) => {
            (AnyRationalSurface::from_polynomial(s)?.into(), t.clone().into())
        }
        (RationalSurface(s), Surface(t)) => {
            (s.clone().into(), AnyRationalSurface::from_polynomial(t)?.into())
        }
        (left, right) => (left.clone(), right.clone()),
    })
}

/// The number as a vector, for what has numbers as values.
fn vector(number: &Number) -> Coords {
    match number {
        Over::Float(x) => Over::Float(vec![*x]),
        Over::Exact(x) => Over::Exact(vec![x.clone()]),
    }
}

/// A product with the function on either side.
fn either_times<F: Family>(
    s: &Any<F>,
    t: &Any<F>,
    times: impl Fn(&Any<F>, &Any<F>) -> Result<Any<F>>,
) -> Result<Any<F>> {
    if t.dim() == 1 { times(s, t) } else { times(t, s) }
}

impl Value {
    /// The sum: of numbers, of points, of splines of one kind, and of a spline and a point, which moves it.
    ///
    /// # Errors
    /// [`Error::NoSuch`], [`Error::Fields`], [`Error::Dimensions`], and those of the library.
    pub fn sum(&self, other: &Self) -> Result<Self> {
        use Value::{Number, Point, Rational, RationalSurface, Spline, Surface};
        Ok(match promoted(self, other)? {
            (Number(x), Number(y)) => meet(&x, &y, |x, y| x + y, |x, y| x + y)?.into(),
            (Point(p), Point(q)) => meet_points(&p, &q, |x, y| x + y, |x, y| x + y)?.into(),
            (Spline(s), Spline(t)) => s.sum(&t)?.into(),
            (Surface(s), Surface(t)) => s.sum(&t)?.into(),
            (Rational(s), Rational(t)) => s.sum(&t)?.into(),
            (RationalSurface(s), RationalSurface(t)) => s.sum(&t)?.into(),
            (Point(p), s) | (s, Point(p)) => s.moved(&p, self, other)?,
            (Number(x), s) | (s, Number(x)) => s.moved(&vector(&x), self, other)?,
            _ => return Err(self.none_with("sum", other)),
        })
    }

    fn moved(&self, by: &Coords, left: &Self, right: &Self) -> Result<Self> {
        Ok(match self {
            Self::Spline(s) => s.translated(by)?.into(),
            Self::Surface(s) => s.translated(by)?.into(),
            Self::Rational(s) => s.translated(by)?.into(),
            Self::RationalSurface(s) => s.translated(by)?.into(),
            _ => return Err(left.none_with("sum", right)),
        })
    }

    /// The difference, as the [sum](Self::sum).
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    pub fn difference(&self, other: &Self) -> Result<Self> {
        self.sum(&other.negated()?)
    }

    /// The negative.
    ///
    /// # Errors
    /// [`Error::NoSuch`] for a mesh.
    pub fn negated(&self) -> Result<Self> {
        self.scaled(&Over::Exact(Q::int(-1)))
    }

    /// The multiple.
    ///
    /// # Errors
    /// [`Error::NoSuch`] for a mesh; those of the library.
    pub fn scaled(&self, factor: &Number) -> Result<Self> {
        Ok(match self {
            Self::Number(x) => meet(x, factor, |x, y| x * y, |x, y| x * y)?.into(),
            Self::Point(p) => {
                let factors = match factor {
                    Over::Float(x) => Over::Float(vec![*x; p.len()]),
                    Over::Exact(x) => Over::Exact(vec![x.clone(); p.len()]),
                };
                meet_points(p, &factors, |x, y| x * y, |x, y| x * y)?.into()
            }
            Self::Spline(s) => s.scaled(factor)?.into(),
            Self::Surface(s) => s.scaled(factor)?.into(),
            Self::Rational(s) => s.scaled(factor)?.into(),
            Self::RationalSurface(s) => s.scaled(factor)?.into(),
            Self::Mesh(_) => return Err(self.none("multiple")),
        })
    }

    /// The product: of numbers, of a number and anything, of a function and a spline or a vector. For two curves see
    /// [`dot`](Self::dot).
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    pub fn product(&self, other: &Self) -> Result<Self> {
        use Value::{Number, Rational, RationalSurface, Spline, Surface};
        Ok(match promoted(self, other)? {
            (Number(x), y) | (y, Number(x)) => y.scaled(&x)?,
            (Spline(s), Spline(t)) if s.dim().min(t.dim()) == 1 => {
                either_times(&s, &t, AnySpline::times)?.into()
            }
            (Surface(s), Surface(t)) if s.dim().min(t.dim()) == 1 => {
                either_times(&s, &t, AnySurface::times)?.into()
            }
            (Rational(s), Rational(t)) if s.dim().min(t.dim()) == 1 => {
                either_times(&s, &t, AnyRational::times)?.into()
            }
            (RationalSurface(s), RationalSurface(t)) if s.dim().min(t.dim()) == 1 => {
                either_times(&s, &t, AnyRationalSurface::times)?.into()
            }
            // A function times a vector: the matrix of one column.
            (s, Value::Point(p)) | (Value::Point(p), s) if s.dim() == 1 => {
                s.under(&p)?.ok_or_else(|| self.none_with("product", other))?
            }
            _ => return Err(self.none_with("product", other)),
        })
    }

    /// The quotient by a number or a function; quotients of polynomial splines by functions are rational splines.
    ///
    /// # Errors
    /// As [`sum`](Self::sum); [`symspline::Error::Pole`] where the divisor vanishes.
    pub fn quotient(&self, other: &Self) -> Result<Self> {
        use Value::{Number, Rational, RationalSurface, Spline, Surface};
        Ok(match promoted(self, other)? {
            (x, Number(y)) => x.scaled(&reciprocal(&y)?)?,
            (Spline(s), Spline(t)) => AnyRational::quotient(&s, &t)?.into(),
            (Surface(s), Surface(t)) => AnyRationalSurface::quotient(&s, &t)?.into(),
            (Rational(s), Rational(t)) => s.divided(&t)?.into(),
            (RationalSurface(s), RationalSurface(t)) => s.divided(&t)?.into(),
            (x @ (Number(_) | Value::Point(_)), s) if s.dim() == 1 => s.one()?.product(&x)?.quotient(&s)?,
            _ => return Err(self.none_with("quotient", other)),
        })
    }

    /// The power: of a number or a function.
    ///
    /// # Errors
    /// [`Error::NoSuch`]; those of the library: the degree may get too high.
    pub fn power(&self, exponent: usize) -> Result<Self> {
        if exponent == 0 {
            return self.one();
        }
        // The binary digits after the first.
        let digits = (0..exponent.ilog2()).rev().map(|k| exponent >> k & 1);
        digits.into_iter().try_fold(self.clone(), |power, digit| {
            let square = power.product(&power)?;
            if digit == 1 { square.product(self) } else { Ok(square) }
        })
    }

    /// The one in the space of this function.
    fn one(&self) -> Result<Self> {
        match self.dim() {
            1 => self.scaled(&Over::Exact(Q::int(0)))?.sum(&Value::Number(Over::Exact(Q::int(1)))),
            _ => Err(self.none("power")),
        }
    }

    /// The inner product of the values: of points a number, of curves, or of a curve and a vector, a function.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    pub fn dot(&self, other: &Self) -> Result<Self> {
        use Value::{Point, Rational, RationalSurface, Spline, Surface};
        Ok(match promoted(self, other)? {
            (Point(p), Point(q)) => match meet_points(&p, &q, |x, y| x * y, |x, y| x * y)? {
                Over::Float(all) => Value::Number(Over::Float(all.into_iter().sum())),
                Over::Exact(all) => Value::Number(Over::Exact(all.into_iter().sum())),
            },
            (Spline(s), Spline(t)) => s.dot(&t)?.into(),
            (Surface(s), Surface(t)) => s.dot(&t)?.into(),
            (Rational(s), Rational(t)) => s.dot(&t)?.into(),
            (RationalSurface(s), RationalSurface(t)) => s.dot(&t)?.into(),
            // With a vector: the matrix of one row.
            (s, Point(p)) | (Point(p), s) if s.dim() == p.len() => {
                s.under(&p)?.ok_or_else(|| self.none_with("dot product", other))?
            }
            _ => return Err(self.none_with("dot product", other)),
        })
    }

    /// The image under a matrix of this one's field, if it is a spline.
    fn under(&self, matrix: &Coords) -> Result<Option<Self>> {
        let matrix = if self.is_exact() { matrix.to_exact()? } else { matrix.to_float()? };
        Ok(Some(match self {
            Self::Spline(s) => s.transformed(&matrix)?.into(),
            Self::Surface(s) => s.transformed(&matrix)?.into(),
            Self::Rational(s) => s.transformed(&matrix)?.into(),
            Self::RationalSurface(s) => s.transformed(&matrix)?.into(),
            _ => return Ok(None),
        }))
    }

    /// The cross product of the values: of plane curves a function, in space vectors.
    ///
    /// # Errors
    /// As [`sum`](Self::sum).
    pub fn cross(&self, other: &Self) -> Result<Self> {
        use Value::{Rational, RationalSurface, Spline, Surface};
        Ok(match promoted(self, other)? {
            (Spline(s), Spline(t)) => s.cross(&t)?.into(),
            (Surface(s), Surface(t)) => s.cross(&t)?.into(),
            (Rational(s), Rational(t)) => s.cross(&t)?.into(),
            (RationalSurface(s), RationalSurface(t)) => s.cross(&t)?.into(),
            _ => return Err(self.none_with("cross product", other)),
        })
    }
}

/// One over a number.
fn reciprocal(y: &Number) -> Result<Number> {
    match y {
        Over::Exact(y) if *y == Q::int(0) => Err(Error::DivisionByZero),
        Over::Exact(y) => Ok(Over::Exact(Q::int(1) / y)),
        Over::Float(y) => Ok(Over::Float(1.0 / y)),
    }
}
