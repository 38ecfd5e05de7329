//! The same thing over one field or the other.

use crate::error::{Error, Result};
use crate::number::Field;
use symspline::{ControlMesh, Q, SplineSpace};

/// Something over `f64`, or its like over `Q`.
#[derive(Clone, Debug, PartialEq)]
pub enum Over<A, B> {
    /// Over `f64`.
    Float(A),
    /// Over the rationals.
    Exact(B),
}

/// A spline space over either field.
pub type AnySpace = Over<SplineSpace<f64>, SplineSpace<Q>>;

/// A control mesh in space over either field.
pub type AnyMesh = Over<ControlMesh<f64, 3>, ControlMesh<Q, 3>>;

/// Numbers of one field: a point, weights, or the coordinates of many points one after the other.
pub type Coords = Over<Vec<f64>, Vec<Q>>;

/// One text for both: `both!(over, T, x => ...)` has `x` what is inside and `T` its field.
#[macro_export]
macro_rules! both {
    ($over:expr, $x:ident => $body:expr) => {
        match $over {
            $crate::Over::Float($x) => $body,
            $crate::Over::Exact($x) => $body,
        }
    };
    ($over:expr, $T:ident, $x:ident => $body:expr) => {
        match $over {
            $crate::Over::Float($x) => {
                type $T = f64;
                $body
            }
            $crate::Over::Exact($x) => {
                type $T = ::symspline::Q;
                $body
            }
        }
    };
}

impl<A, B> Over<A, B> {
    /// Whether it is over the rationals.
    pub fn is_exact(&self) -> bool {
        matches!(self, Self::Exact(_))
    }

    /// "exact" or "float".
    pub fn field(&self) -> &'static str {
        if self.is_exact() { Q::NAME } else { f64::NAME }
    }

    /// That two things over different fields met.
    pub(crate) fn unlike<C, D>(&self, other: &Over<C, D>) -> Error {
        Error::Fields { left: self.field(), right: other.field() }
    }
}

impl Coords {
    /// How many numbers.
    pub fn len(&self) -> usize {
        both!(self, all => all.len())
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The numbers over the rationals, without loss.
    ///
    /// # Errors
    /// [`symspline::Error::NotFinite`].
    pub fn to_exact(&self) -> Result<Self> {
        Ok(Self::Exact(Q::all_of(self)?))
    }

    /// The nearest floats.
    ///
    /// # Errors
    /// None; it is a result for symmetry.
    pub fn to_float(&self) -> Result<Self> {
        Ok(Self::Float(f64::all_of(self)?))
    }
}

impl AnySpace {
    /// The space over the rationals, without loss.
    ///
    /// # Errors
    /// As [`SplineSpace::map_scalars`].
    pub fn to_exact(&self) -> Result<Self> {
        Ok(Self::Exact(match self {
            Self::Float(space) => space.map_scalars(|t| Q::try_from(*t))?,
            Self::Exact(space) => space.clone(),
        }))
    }

    /// The space with knots rounded to nearest.
    ///
    /// # Errors
    /// As [`SplineSpace::map_scalars`], such as knots that fall together.
    pub fn to_float(&self) -> Result<Self> {
        Ok(Self::Float(match self {
            Self::Float(space) => space.clone(),
            Self::Exact(space) => space.map_scalars(|t| Ok(t.to_f64()))?,
        }))
    }
}

impl AnyMesh {
    /// The mesh over the rationals, without loss.
    ///
    /// # Errors
    /// As [`ControlMesh::to_exact`].
    pub fn to_exact(&self) -> Result<Self> {
        Ok(Self::Exact(match self {
            Self::Float(mesh) => mesh.to_exact()?,
            Self::Exact(mesh) => mesh.clone(),
        }))
    }

    /// The mesh with coordinates rounded to nearest.
    ///
    /// # Errors
    /// As [`ControlMesh::to_f64`].
    pub fn to_float(&self) -> Result<Self> {
        Ok(Self::Float(match self {
            Self::Float(mesh) => mesh.clone(),
            Self::Exact(mesh) => mesh.to_f64()?,
        }))
    }
}

impl From<ControlMesh<f64, 3>> for AnyMesh {
    fn from(mesh: ControlMesh<f64, 3>) -> Self {
        Self::Float(mesh)
    }
}

impl From<ControlMesh<Q, 3>> for AnyMesh {
    fn from(mesh: ControlMesh<Q, 3>) -> Self {
        Self::Exact(mesh)
    }
}

impl From<SplineSpace<f64>> for AnySpace {
    fn from(space: SplineSpace<f64>) -> Self {
        Self::Float(space)
    }
}

impl From<SplineSpace<Q>> for AnySpace {
    fn from(space: SplineSpace<Q>) -> Self {
        Self::Exact(space)
    }
}
