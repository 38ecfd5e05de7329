//! Anything that has a name in a file or in an expression.

use crate::error::{Error, Result};
use crate::family::{AnyRational, AnyRationalSurface, AnySpline, AnySurface};
use crate::number::Number;
use crate::over::{AnyMesh, Coords};
use crate::{both, each};
use std::fmt;
use symspline::SplineSpace;

/// A number, a point, or a spline of any kind, over either field.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Value {
    /// A number.
    Number(Number),
    /// A point, or a vector.
    Point(Coords),
    /// A function or curve.
    Spline(AnySpline),
    /// A function of two parameters, or a surface.
    Surface(AnySurface),
    /// A rational function or curve.
    Rational(AnyRational),
    /// A rational function of two parameters, or a rational surface.
    RationalSurface(AnyRationalSurface),
    /// A mesh.
    Mesh(AnyMesh),
}

/// One text for all kinds: `value!(value, x => ...)`.
macro_rules! value {
    ($value:expr, $x:ident => $body:expr) => {
        match $value {
            Value::Number($x) => $body,
            Value::Point($x) => $body,
            Value::Spline($x) => $body,
            Value::Surface($x) => $body,
            Value::Rational($x) => $body,
            Value::RationalSurface($x) => $body,
            Value::Mesh($x) => $body,
        }
    };
}

impl Value {
    /// Whether it is over the rationals.
    pub fn is_exact(&self) -> bool {
        value!(self, x => x.is_exact())
    }

    /// "exact" or "float".
    pub fn field(&self) -> &'static str {
        value!(self, x => x.field())
    }

    /// What it is called: "number", "point", "curve", ...
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Number(_) => "number",
            Self::Point(_) => "point",
            Self::Spline(s) => s.kind(),
            Self::Surface(s) => s.kind(),
            Self::Rational(s) => s.kind(),
            Self::RationalSurface(s) => s.kind(),
            Self::Mesh(_) => "mesh",
        }
    }

    /// The same over the rationals, without loss.
    ///
    /// # Errors
    /// Those of the library: a number that is not finite.
    pub fn to_exact(&self) -> Result<Self> {
        Ok(value!(self, x => x.to_exact()?.into()))
    }

    /// The same rounded to floats.
    ///
    /// # Errors
    /// Those of the library: knots may fall together.
    pub fn to_float(&self) -> Result<Self> {
        Ok(value!(self, x => x.to_float()?.into()))
    }

    /// That there is no such operation of this value and another.
    pub(crate) fn none_with(&self, operation: &'static str, other: &Self) -> Error {
        Error::NoSuch { operation, left: self.name(), right: other.name() }
    }

    /// That there is no such operation of this value alone.
    pub(crate) fn none(&self, operation: &'static str) -> Error {
        Error::NoSuch { operation, left: self.name(), right: String::new() }
    }

    fn name(&self) -> String {
        format!("{} {}", self.field(), self.kind())
    }
}

macro_rules! from {
    ($($kind:ident: $inner:ty),+) => {
        $(impl From<$inner> for Value {
            fn from(inner: $inner) -> Self {
                Self::$kind(inner)
            }
        })+
    };
}

from!(Number: Number, Point: Coords, Spline: AnySpline, Surface: AnySurface, Rational: AnyRational);
from!(RationalSurface: AnyRationalSurface, Mesh: AnyMesh);

/// One line: the field, the kind, and what there is to count.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.field(), self.kind())?;
        match self {
            Self::Number(x) => write!(f, " {x}"),
            Self::Point(p) => both!(p, p => {
                let all: Vec<String> = p.iter().map(ToString::to_string).collect();
                write!(f, " ({})", all.join(", "))
            }),
            Self::Mesh(mesh) => both!(mesh, mesh => {
                let t = mesh.topology();
                write!(f, ", {} vertices, {} edges, {} faces", t.vertex_count(), t.edge_count(), t.face_count())
            }),
            Self::Spline(s) => each!(s, s => spaces(f, self.dim(), &[s.space()])),
            Self::Surface(s) => each!(s, s => spaces(f, self.dim(), &[s.u(), s.v()])),
            Self::Rational(s) => each!(s, s => spaces(f, self.dim(), &[s.space()])),
            Self::RationalSurface(s) => each!(s, s => spaces(f, self.dim(), &[s.u(), s.v()])),
        }
    }
}

impl Value {
    /// How many coordinates its values have.
    pub fn dim(&self) -> usize {
        match self {
            Self::Number(_) => 1,
            Self::Point(p) => p.len(),
            Self::Spline(s) => s.dim(),
            Self::Surface(s) => s.dim(),
            Self::Rational(s) => s.dim(),
            Self::RationalSurface(s) => s.dim(),
            Self::Mesh(_) => 3,
        }
    }
}

fn spaces<T: symspline::Scalar>(
    f: &mut fmt::Formatter<'_>,
    dim: usize,
    spaces: &[&SplineSpace<T>],
) -> fmt::Result {
    if dim > 1 {
        write!(f, " in {dim} dimensions")?;
    }
    let each = |write: &dyn Fn(&SplineSpace<T>) -> String| {
        spaces.iter().map(|s| write(s)).collect::<Vec<_>>().join(" x ")
    };
    let domain = |s: &SplineSpace<T>| {
        let (a, b) = s.domain();
        format!("[{a}, {b}]{}", if s.is_periodic() { " periodic" } else { "" })
    };
    let degrees = each(&|s| s.degree().to_string());
    write!(f, ", degree {degrees}, {} coefficients on {}", each(&|s| s.dim().to_string()), each(&domain))
}
