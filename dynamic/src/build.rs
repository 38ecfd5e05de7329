//! Splines from numbers: their spaces, the dimension of their values, and the coordinates.

use crate::any::Any;
use crate::each;
use crate::error::{Error, Result};
use crate::family::{AnyRational, AnyRationalSurface, AnySpline, AnySurface};
use crate::number::{Field, Flat, flat, points};
use crate::over::{AnySpace, Coords, Over};
use nalgebra::SVector;
use symspline::{Interval, Q, Rational, Rectangle, Spline, TensorSpline, Weighted};

/// Homogeneous coordinates put together to weighted points: `w x, w y, ...` and `w`.
fn weighted<T: Field, C: Flat<T>>(coords: &[T]) -> Result<Vec<Weighted<T, C>>> {
    let size = C::DIM + 1;
    if !coords.len().is_multiple_of(size) {
        return Err(Error::Torn { count: coords.len(), dim: size });
    }
    let one = |c: &[T]| Ok(Weighted { point: C::from_coords(&c[..C::DIM])?, weight: c[C::DIM].clone() });
    coords.chunks_exact(size).map(one).collect()
}

/// One text for each dimension: `C` is the type of coefficients over the field.
macro_rules! of_dim {
    ($dim:expr, $T:ty, $C:ident => $body:expr) => {
        match $dim {
            1 => {
                type $C = $T;
                Ok(Any::from($body?))
            }
            2 => {
                type $C = SVector<$T, 2>;
                Ok(Any::from($body?))
            }
            3 => {
                type $C = SVector<$T, 3>;
                Ok(Any::from($body?))
            }
            found => Err(Error::Dimension { found, least: 1 }),
        }
    };
}

impl AnySpline {
    /// The spline with these coefficients, `dim` coordinates each.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], [`Error::Torn`], and those of [`Spline::new`].
    pub fn new(space: AnySpace, dim: usize, coords: Coords) -> Result<Self> {
        match (space, coords) {
            (Over::Float(s), Over::Float(c)) => of_dim!(dim, f64, C => Spline::<f64, C>::new(s, points(&c)?)),
            (Over::Exact(s), Over::Exact(c)) => of_dim!(dim, Q, C => Spline::<Q, C>::new(s, points(&c)?)),
            (space, coords) => Err(space.unlike(&coords)),
        }
    }
}

impl AnySurface {
    /// The surface with these coefficients, `dim` coordinates each, row by row, each row of one `u`.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], [`Error::Torn`], and those of [`TensorSpline::new`].
    pub fn new(u: AnySpace, v: AnySpace, dim: usize, coords: Coords) -> Result<Self> {
        match (u, v, coords) {
            (Over::Float(u), Over::Float(v), Over::Float(c)) => {
                of_dim!(dim, f64, C => TensorSpline::<f64, C>::new(u, v, points(&c)?))
            }
            (Over::Exact(u), Over::Exact(v), Over::Exact(c)) => {
                of_dim!(dim, Q, C => TensorSpline::<Q, C>::new(u, v, points(&c)?))
            }
            (u, v, coords) => {
                Err(if u.is_exact() == v.is_exact() { u.unlike(&coords) } else { u.unlike(&v) })
            }
        }
    }
}

impl AnyRational {
    /// The rational spline with these control points, `dim` coordinates each, and weights.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], [`Error::Torn`], and those of [`symspline::NurbsCurve::new`].
    pub fn new(space: AnySpace, dim: usize, coords: Coords, weights: Coords) -> Result<Self> {
        match (space, coords, weights) {
            (Over::Float(s), Over::Float(c), Over::Float(w)) => {
                of_dim!(dim, f64, C => Rational::<Interval, f64, C>::new(s, points(&c)?, w))
            }
            (Over::Exact(s), Over::Exact(c), Over::Exact(w)) => {
                of_dim!(dim, Q, C => Rational::<Interval, Q, C>::new(s, points(&c)?, w))
            }
            (s, c, w) => Err(if s.is_exact() == c.is_exact() { s.unlike(&w) } else { s.unlike(&c) }),
        }
    }

    /// The rational spline with these homogeneous coordinates, for each control point `w x, w y, ...` and then `w`.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], [`Error::Torn`], and those of [`Rational::from_lifted`].
    pub fn from_weighted(space: AnySpace, dim: usize, coords: Coords) -> Result<Self> {
        match (space, coords) {
            (Over::Float(s), Over::Float(c)) => {
                of_dim!(dim, f64, C => Rational::<Interval, f64, C>::from_lifted(Spline::new(s, weighted(&c)?)?))
            }
            (Over::Exact(s), Over::Exact(c)) => {
                of_dim!(dim, Q, C => Rational::<Interval, Q, C>::from_lifted(Spline::new(s, weighted(&c)?)?))
            }
            (space, coords) => Err(space.unlike(&coords)),
        }
    }

    /// Its homogeneous coordinates, for each control point `w x, w y, ...` and then `w`.
    pub fn weighted(&self) -> Coords {
        each!(self, s => flat(s.lifted().coeffs()))
    }
}

impl AnyRationalSurface {
    /// The rational surface with these control points, `dim` coordinates each, and weights, row by row, each row of one `u`.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], [`Error::Torn`], and those of [`symspline::NurbsSurface::new`].
    pub fn new(u: AnySpace, v: AnySpace, dim: usize, coords: Coords, weights: Coords) -> Result<Self> {
        match (u, v, coords, weights) {
            (Over::Float(u), Over::Float(v), Over::Float(c), Over::Float(w)) => {
                of_dim!(dim, f64, C => Rational::<Rectangle, f64, C>::new(u, v, points(&c)?, w))
            }
            (Over::Exact(u), Over::Exact(v), Over::Exact(c), Over::Exact(w)) => {
                of_dim!(dim, Q, C => Rational::<Rectangle, Q, C>::new(u, v, points(&c)?, w))
            }
            (u, v, c, w) => Err(match u.is_exact() {
                exact if exact != v.is_exact() => u.unlike(&v),
                exact if exact != c.is_exact() => u.unlike(&c),
                _ => u.unlike(&w),
            }),
        }
    }

    /// The rational surface with these homogeneous coordinates, for each control point `w x, w y, ...` and then `w`, row by
    /// row, each row of one `u`.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], [`Error::Torn`], and those of [`Rational::from_lifted`].
    pub fn from_weighted(u: AnySpace, v: AnySpace, dim: usize, coords: Coords) -> Result<Self> {
        match (u, v, coords) {
            (Over::Float(u), Over::Float(v), Over::Float(c)) => {
                of_dim!(dim, f64, C => Rational::<Rectangle, f64, C>::from_lifted(TensorSpline::new(u, v, weighted(&c)?)?))
            }
            (Over::Exact(u), Over::Exact(v), Over::Exact(c)) => {
                of_dim!(dim, Q, C => Rational::<Rectangle, Q, C>::from_lifted(TensorSpline::new(u, v, weighted(&c)?)?))
            }
            (u, v, c) => Err(if u.is_exact() == v.is_exact() { u.unlike(&c) } else { u.unlike(&v) }),
        }
    }

    /// Its homogeneous coordinates, for each control point `w x, w y, ...` and then `w`.
    pub fn weighted(&self) -> Coords {
        each!(self, s => flat(s.lifted().coeffs()))
    }
}
