//! Evaluators: splines prepared for many values.
//!
//! An [`Evaluator`](curve::Evaluator) holds every piece of a spline as a polynomial in powers and finds spans by a guide instead
//! of a search. Preparing costs a few values a span, and then values and derivatives at parameters in any order cost a fraction
//! of [`at`](crate::Spline::at). Evaluators share nothing with their spline and can be sent to other threads.

mod index;
mod powers;
pub mod evaluate;
pub mod curve;
pub mod surface;
pub mod rational;
