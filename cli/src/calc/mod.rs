//! Expressions over splines: `P0 + integral(alpha * diff(C))`.
//!
//! ```text
//! sum      := product (("+" | "-") product)*
//! product  := negative (("*" | "/") negative)*
//! negative := "-"* chain
//! chain    := atom ("@" atom)*                        composition, (f @ g)(x) = f(g(x))
//! atom     := number | name | name "(" [sum ("," sum)*] ")" | "(" sum ("," sum)* ")"
//! ```
//! Two sums or more in parentheses are a point. Numbers are fractions until they meet floats.

// From the ground up: a module uses only what stands above it.
pub mod complaint;
pub mod tokens;
pub mod tree;
pub mod parser;
pub mod arguments;
pub mod construct;
pub mod size;
pub mod functions;
pub mod evaluate;
#[cfg(test)]
mod laws;
#[cfg(test)]
mod attacked;
