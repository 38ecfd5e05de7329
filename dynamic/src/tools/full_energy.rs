//! The energy of a surface with a weight for each derivative.

use crate::error::{Error, Result};
use crate::number::{Field, Number, flat};
use crate::over::{AnySpace, Coords};
use crate::tools::constraints::{Rows, rows};
use crate::tools::edit::Of;
use crate::tools::elastic::{AnyBreadth, material};
use crate::tools::shape::all_points;
use crate::tools::stiffness::lists;
use crate::value::Value;
use crate::{both, each};
use symspline::{FullEnergy, SplineSpace};

/// Weights of the derivatives of a surface; see [`FullEnergy`].
///
/// Two are equal if they are of one field and have the same weights.
#[derive(Clone, Debug, PartialEq)]
pub struct AnyFullEnergy {
    /// Row by row, the last row and the last column not all zero.
    weights: Coords,
    columns: usize,
}

/// The weights of an energy, which has none from these orders on.
fn read<T: Field>(energy: &FullEnergy<T>, (rows, columns): (usize, usize)) -> AnyFullEnergy {
    let weighs = |k: usize, l: usize| !energy.weight(k, l).is_zero();
    let last =
        |count: usize, some: &dyn Fn(usize) -> bool| (0..count).rev().find(|i| some(*i)).map_or(0, |i| i + 1);
    let m = last(rows, &|k| (0..columns).any(|l| weighs(k, l)));
    let n = last(columns, &|l| (0..rows).any(|k| weighs(k, l)));
    let weights: Vec<T> = (0..m).flat_map(|k| (0..n).map(move |l| energy.weight(k, l))).collect();
    // No weights have no field.
    let weights = if n == 0 { Coords::Exact(Vec::new()) } else { T::coords(weights) };
    AnyFullEnergy { weights, columns: n }
}

impl AnyFullEnergy {
    /// The energy with these weights, row by row; numbers are of one field.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`FullEnergy::new`].
    pub fn new(weights: &[Coords]) -> Result<Self> {
        let Some(first) = weights.first() else {
            return Ok(Self { weights: Coords::Exact(Vec::new()), columns: 0 });
        };
        let columns = weights.iter().map(Coords::len).max().unwrap_or(0);
        both!(first, T, _first => {
            let rows = weights.iter().map(|row| Ok(Of::<T>::of(row)?.clone())).collect::<Result<Vec<_>>>()?;
            Ok(read(&FullEnergy::new(rows)?, (weights.len(), columns)))
        })
    }

    /// The energy with the eight weights of the paper; see [`FullEnergy::of_eight`].
    ///
    /// # Errors
    /// [`Error::Dimensions`] unless there are eight, and those of [`FullEnergy::of_eight`].
    pub fn of_eight(weights: &Coords) -> Result<Self> {
        let right = weights.len();
        both!(weights, all => {
            let all = all.clone().try_into().map_err(|_| Error::Dimensions { left: 8, right })?;
            Ok(read(&FullEnergy::of_eight(all)?, (3, 3)))
        })
    }

    /// The energy of a membrane and a thin plate, over the field of the first number; see [`FullEnergy::thin_plate`].
    ///
    /// # Errors
    /// Those of [`FullEnergy::thin_plate`].
    pub fn thin_plate(stretching: &Number, bending: &Number) -> Result<Self> {
        both!(stretching, T, _a => Ok(read(&FullEnergy::<T>::thin_plate(T::of(stretching)?, T::of(bending)?)?, (3, 3))))
    }

    /// The energy of an elastic surface of one material along each direction; see [`FullEnergy::of_materials`].
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`FullEnergy::of_materials`].
    pub fn of_materials(u: &Coords, v: &Coords) -> Result<Self> {
        if u.is_exact() != v.is_exact() {
            return Err(u.unlike(v));
        }
        both!(u, T, _u => Ok(read(&FullEnergy::of_materials(&material::<T>(u)?, &material(v)?)?, (u.len(), v.len()))))
    }

    /// The same energy with another weight of one derivative, over the field of this weight; see [`FullEnergy::with_weight`].
    ///
    /// # Errors
    /// Those of [`FullEnergy::with_weight`].
    pub fn with_weight(&self, (k, l): (usize, usize), weight: &Number) -> Result<Self> {
        let (rows, columns) = self.orders();
        both!(weight, T, _x => {
            let energy = self.energy_over::<T>()?.with_weight((k, l), T::of(weight)?)?;
            Ok(read(&energy, (rows.max(k + 1), columns.max(l + 1))))
        })
    }

    /// The weight of one derivative.
    ///
    /// # Errors
    /// None; it is a result for symmetry.
    pub fn weight(&self, k: usize, l: usize) -> Result<Number> {
        both!(&self.weights, T, _all => Ok(self.energy_over::<T>()?.weight(k, l).number()))
    }

    /// The weights row by row, the last row and the last column not all zero.
    pub fn weights(&self) -> &Coords {
        &self.weights
    }

    /// From which orders on along `u` and `v` there are no weights.
    pub fn orders(&self) -> (usize, usize) {
        (self.weights.len().checked_div(self.columns).unwrap_or(0), self.columns)
    }

    fn energy_over<T: Field>(&self) -> Result<FullEnergy<T>> {
        let all = T::all_of(&self.weights)?;
        Ok(FullEnergy::new(all.chunks(self.columns.max(1)).map(<[T]>::to_vec))?)
    }

    /// What a surface costs. Weights are taken into its field.
    ///
    /// # Errors
    /// [`Error::NoSuch`] for what is no polynomial surface, and those of [`FullEnergy::energy`].
    pub fn energy(&self, surface: &Value) -> Result<Number> {
        match surface {
            Value::Surface(any) => each!(any, T, s => Ok(self.energy_over::<T>()?.energy(s)?.number())),
            other => Err(other.none_of("full energy")),
        }
    }

    /// The load that keeps a surface as it is. Weights are taken into its field.
    ///
    /// # Errors
    /// [`Error::NoSuch`] for what is no polynomial surface, and those of [`FullEnergy::gradient`].
    pub fn gradient(&self, surface: &Value) -> Result<Coords> {
        match surface {
            Value::Surface(any) => {
                each!(any, T, s => Ok(flat::<T, _>(&self.energy_over::<T>()?.gradient(s)?)))
            }
            other => Err(other.none_of("gradient of the full energy")),
        }
    }

    /// The stiffness matrix on the coefficients row by row. Weights are taken into the field of the spaces.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`FullEnergy::matrix`].
    pub fn matrix(&self, u: &AnySpace, v: &AnySpace) -> Result<Rows> {
        both!(u, T, u => Ok(rows(self.energy_over::<T>()?.matrix(u, Of::<T>::of(v)?)?.iter())))
    }

    /// The displacements of control points, row by row with `dim` coordinates each, under a load of each; a breadth for each
    /// direction. Numbers are taken into the field of the spaces.
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], [`Error::Dimensions`] unless there are two breadths, and those of
    /// [`FullEnergy::solved`].
    pub fn solved(
        &self,
        (u, v): (&AnySpace, &AnySpace),
        (load, dim): (&Coords, usize),
        breadths: &[AnyBreadth],
    ) -> Result<Coords> {
        let [along_u, along_v] = breadths else {
            return Err(Error::Dimensions { left: 2, right: breadths.len() });
        };
        both!(u, T, u => {
            let v: &SplineSpace<T> = Of::<T>::of(v)?;
            let (energy, held) = (self.energy_over::<T>()?, [along_u.of()?, along_v.of()?]);
            lists!(load, dim, T, load => energy.solved((u, v), &load, [&held[0], &held[1]]))
        })
    }
}
