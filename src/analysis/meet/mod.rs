//! Where curves meet in the plane, and where a line meets a surface: two equations in two unknowns.
//!
//! Both are one problem. On a pair of pieces, or on a patch, `F(x, y) = 0` with `F` from the unit square to the plane,
//! given by Bernstein coefficients:
//!
//! ```text
//! curves    F(s, t) = P(s) w(t) - Q(t) v(s)       with pieces P / v and Q / w
//! line      F(u, v) = n_i · (P(u, v) - A w(u, v)), i = 1, 2, with normals n_i of the line through A
//! ```
//!
//! The solver (`solve`) halves and clips boxes until each holds no solution, or one that is proved, or is as small as
//! the tolerance or rounding allows. Solutions along a line, where curves coincide, are traced first (`trace`).
//!
//! - `arc`, `patch`: the pieces of curves and surfaces, brought to unit size;
//! - `casteljau`, `system`: Bernstein coefficients of the equations, their boxes and values;
//! - `frame`: preconditioning, exclusion and clipping by convex hulls;
//! - `certify`: Newton's method with a proof;
//! - `trace`, `solve`: solutions that fill a line, and the search for the others;
//! - `merge`: what neighbouring pieces found, each once;
//! - `pairs`: which pieces may meet;
//! - [`curves`], [`mod@line`]: the two questions.

mod casteljau;
mod system;
mod frame;
mod certify;
mod trace;
mod solve;
mod merge;
mod stretch;
mod pairs;
pub(crate) mod arc;
mod patch;
pub mod report;
pub mod curves;
pub mod line;
