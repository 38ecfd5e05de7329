//! The Python package `symspline`: classes around the values of `symspline_dynamic`, methods around the library's.
//!
//! Numbers: whole numbers and `fractions.Fraction` are exact, and so is what is made of them. A float anywhere makes floats of the
//! whole, as with Python's own numbers; arrays of floats are `numpy` arrays of `float64`, of fractions arrays of objects. Methods
//! that may take long release the interpreter's lock.

// From the ground up: a module uses only what stands above it.
mod error;
mod called;
#[macro_use]
mod numbers;
mod arguments;
mod record;
mod space;
mod spline;
mod maps;
mod surface;
mod rational;
mod rational_surface;
mod mesh;
mod value;
mod arithmetic;
mod evaluate;
mod operators;
mod calculus;
mod pieces;
mod approximate;
mod range;
mod data;
mod skin;
mod scipy;
mod tools;

use pyo3::prelude::*;

#[pymodule]
fn _symspline(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    error::register(module)?;
    module.add_class::<space::Space>()?;
    module.add_class::<spline::Spline>()?;
    module.add_class::<range::Extremum>()?;
    module.add_class::<surface::Surface>()?;
    module.add_class::<rational::Rational>()?;
    module.add_class::<rational_surface::RationalSurface>()?;
    module.add_class::<mesh::Mesh>()?;
    tools::register(module)
}
