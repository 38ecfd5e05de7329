//! Constraints that tie coordinates together.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::tools::shape::{Wish, alike, wishes};
use crate::tools::values::Name;
use crate::value::Thing;
use pyo3::prelude::*;
use std::collections::HashMap;
use symspline_dynamic::tools::coupled::{self, Tie, Tied};
use symspline_dynamic::{Coords, Meeting as _, Number};

/// A constraint that takes one number, as it comes from Python.
#[derive(FromPyObject)]
enum TieLike {
    /// A component of a derivative: the word, the place, the order, the vector.
    Along(String, Point, Name, Point),
    /// Coordinates and their weights.
    Components(HashMap<usize, Num>),
    /// A word alone.
    Word(String),
}

impl TieLike {
    /// The constraint; notes whether its numbers are exact.
    fn read(self, exact: &mut bool) -> Result<Tie> {
        match self {
            Self::Along(word, at, order, n) if word == "along" => {
                *exact &= at.0.is_exact() && n.0.is_exact();
                Ok(Tie::Along(at.0, order.0, n.0))
            }
            Self::Components(row) => {
                *exact &= row.values().all(|x| x.0.is_exact());
                let mut row: Vec<(usize, Number)> = row.into_iter().map(|(i, x)| (i, x.0)).collect();
                row.sort_by_key(|(i, _)| *i);
                Ok(Tie::Components(row))
            }
            Self::Word(word) if word == "area" => Ok(Tie::Area),
            Self::Along(word, ..) | Self::Word(word) => {
                let message = format!(
                    "a number is constrained by (\"along\", at, order, n), by a dict or by \"area\", not by \"{word}\""
                );
                Err(Failure::new("Word", message))
            }
        }
    }
}

/// Constraints on a shape with further ones that each take one number, prepared once and then dragged.
///
/// `constraints` and keywords are those of `Constraints`. Each of `numbers` is `("along", at, order, n)`, the component of the
/// derivative at a place along the vector `n`; a dict from places in `control_points(shape).ravel()` to weights, a linear functional of
/// coordinates; or "area", the area a polynomial plane curve sweeps around the origin, to first order in the change. So the end of a
/// curve slides along a line if its component across stays.
#[pyclass(frozen, module = "symspline.shape")]
#[derive(Debug)]
pub struct Coupled {
    held: Box<dyn Tied>,
    exact: bool,
}

#[pymethods]
impl Coupled {
    #[new]
    #[pyo3(signature = (shape, constraints, numbers, *, holding=None, freeing=None, weights=None, nearly=false))]
    #[allow(clippy::too_many_arguments, reason = "Python names them")]
    fn new(
        py: Python<'_>,
        shape: Thing,
        constraints: Vec<Wish>,
        numbers: Vec<TieLike>,
        holding: Option<Vec<Name>>,
        freeing: Option<Vec<Name>>,
        weights: Option<Vec<(Name, Num)>>,
        nearly: bool,
    ) -> Result<Self> {
        let (wishes, mut exact) = wishes(constraints, holding, freeing, weights, nearly);
        let ties = numbers.into_iter().map(|tie| tie.read(&mut exact)).collect::<Result<Vec<_>>>()?;
        let shape = shape.0.among(exact)?;
        let held = py.detach(|| coupled::coupled(&shape, &wishes, &ties))?;
        Ok(Self { held, exact: shape.is_exact() })
    }

    /// The shape with the constrained values changed: by a vector for each of `constraints`, by a number for each of `numbers`. They
    /// are taken into the field of the constraints.
    fn dragged(&self, py: Python<'_>, shape: Thing, vectors: Array, numbers: Array) -> Result<Thing> {
        let shape = alike(shape.0, self.exact)?;
        let numbers: Coords = numbers.list()?;
        Ok(Thing(py.detach(|| self.held.dragged(&shape, &vectors.numbers, &numbers))?))
    }
}

/// Adds the class to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Coupled>()
}
