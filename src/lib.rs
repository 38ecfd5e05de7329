//! Symbolic spline algebra.

// The modules from the ground up: a module uses only what stands above it (tests/floors.rs).
pub mod error;
pub mod scalar;
pub mod exact;
pub mod coeff;
mod vector;
mod linalg;
pub mod functional;
pub mod map;
pub mod knots;
mod polar;
pub mod space;
mod derived;
mod basis;
pub mod spline;
pub mod ops;
pub mod build;
pub mod analysis;
pub mod fine_tune;
#[cfg(feature = "plot")]
pub mod plot;

pub use analysis::curvature::Curved;
pub use build::fit::Ends;
pub use build::parameters::{approximation_space, chord_length, interpolation_space};
pub use coeff::Coeff;
pub use error::{Error, Result};
pub use exact::Q;
pub use fine_tune::hold::{Hold, Turnable};
pub use functional::Functional;
pub use knots::KnotVector;
pub use map::{BilinearMap, BilinearRow, LinearMap};
pub use scalar::{Real, Scalar};
pub use space::SplineSpace;
pub use spline::{Curve, Function, Spline};
