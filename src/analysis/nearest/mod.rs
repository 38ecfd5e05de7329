//! The nearest points of curves and surfaces to a point, all of them, with a bound that is proved.
//!
//! A spline is taken as its Bernstein pieces, lifted if it is rational. With `A(x) = w(x) (S(x) - P)` the piece is
//! nearer to `P` than `r` exactly where the polynomial
//!
//! ```text
//! G(x) = |A(x)|² - r² w(x)²
//! ```
//!
//! is negative. Its Bernstein coefficients tell more than bounds: where `G` increases, the nearest point of a piece is
//! at an end (of a surface on an edge); where `G` is convex, it is unique, Newton's method finds it, and the slope that
//! is left there bounds what may be missed. A piece about which they tell nothing is halved (`search`). Whole pieces
//! are passed over by the boxes of a tree (`tree`) and by the hulls of their control points (`hull`).
//!
//! A curve is a surface here whose second direction has degree 0 and no extent.

mod scale;
pub mod foot;
mod split;
mod hull;
mod square;
mod bowl;
mod ratio;
mod jet;
mod pieces;
mod tree;
mod polish;
mod search;
mod descend;
mod examine;
mod islands;
pub mod projector;
pub mod entry;
