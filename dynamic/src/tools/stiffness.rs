//! Stiffness matrices, and what they make of lists of control points.

use crate::both;
use crate::error::{Error, Result};
use crate::number::{Field, flat};
use crate::over::{AnySpace, Coords};
use crate::tools::edit::Of;
use crate::tools::elastic::{AnyBreadth, AnyElastic, material};
use crate::tools::shape::all_points;

/// The stiffness matrix of a material on a space, row by row; see [`Material::matrix`](symspline::Material::matrix).
///
/// # Errors
/// Those of [`Material::matrix`](symspline::Material::matrix).
pub fn matrix(space: &AnySpace, weights: &Coords) -> Result<Coords> {
    both!(space, T, s => {
        let matrix = material::<T>(weights)?.matrix(s)?.to_matrix()?;
        Ok(T::coords(matrix.transpose().iter().cloned().collect()))
    })
}

/// The stiffness matrix over floats by Gauss rules, row by row, of so many nodes or of the least sufficient number; see
/// [`Material::matrix_by_rule`](symspline::Material::matrix_by_rule) and
/// [`Material::matrix_by_quadrature`](symspline::Material::matrix_by_quadrature).
///
/// # Errors
/// [`Error::Fields`] for an exact space, and those of the library.
pub fn matrix_by_rule(space: &AnySpace, weights: &Coords, nodes: Option<usize>) -> Result<Coords> {
    let (space, material) = (Of::<f64>::of(space)?, material::<f64>(weights)?);
    let matrix = match nodes {
        Some(nodes) => material.matrix_by_rule(space, nodes)?,
        None => material.matrix_by_quadrature(space)?,
    };
    Ok(Coords::Float(matrix.to_matrix()?.transpose().iter().copied().collect()))
}

/// The motions of coefficients that cost nothing, one after the other; see [`Material::null_space`](symspline::Material::null_space).
///
/// # Errors
/// Those of [`Material::null_space`](symspline::Material::null_space).
pub fn null_space(space: &AnySpace, weights: &Coords, breadth: &AnyBreadth) -> Result<Coords> {
    both!(space, T, s => {
        let motions = material::<T>(weights)?.null_space(s, &breadth.of()?)?;
        Ok(T::coords(motions.into_iter().flatten().collect()))
    })
}

/// One text for lists of points of each dimension, from numbers and back to numbers over the field `T`.
macro_rules! lists {
    ($numbers:expr, $dim:expr, $T:ident, $list:ident => $body:expr) => {
        match $dim {
            1 => lists!(@ $numbers, $T, $T, $list => $body),
            2 => lists!(@ $numbers, $T, nalgebra::SVector<$T, 2>, $list => $body),
            3 => lists!(@ $numbers, $T, nalgebra::SVector<$T, 3>, $list => $body),
            found => Err(Error::Dimension { found, least: 1 }),
        }
    };
    (@ $numbers:expr, $T:ident, $C:ty, $list:ident => $body:expr) => {{
        let $list: Vec<$C> = all_points($numbers)?;
        Ok(flat::<$T, $C>(&$body?))
    }};
}

pub(crate) use lists;

impl AnyElastic {
    /// For each direction the forcing matrix, row by row, a row for each break; see
    /// [`Stiffness::forcing`](symspline::Stiffness::forcing).
    ///
    /// # Errors
    /// [`symspline::Error::TooLarge`].
    pub fn forcing(&self) -> Result<Vec<Coords>> {
        both!(self, T, e => {
            let along = |s: &symspline::Stiffness<T>| {
                Ok(T::coords(s.forcing().to_matrix()?.transpose().iter().cloned().collect()))
            };
            e.stiffnesses().iter().map(along).collect()
        })
    }

    /// The displacements of control points under a load of each, `dim` coordinates each.
    ///
    /// # Errors
    /// [`Error::Dimension`], and those of [`Elastic::solved`](symspline::Elastic::solved).
    pub fn solved(&self, load: &Coords, dim: usize) -> Result<Coords> {
        both!(self, T, e => lists!(load, dim, T, load => e.solved(&load)))
    }

    /// Half of the gradient of the energy at control points, `dim` coordinates each: the load that keeps them where they are.
    ///
    /// # Errors
    /// [`Error::Dimension`], and those of [`Elastic::gradient`](symspline::Elastic::gradient).
    pub fn gradient(&self, points: &Coords, dim: usize) -> Result<Coords> {
        both!(self, T, e => lists!(points, dim, T, points => e.gradient(&points)))
    }
}
