//! Deformable splines: shapes with the energy of an elastic body, moved by forces, after Vassilev.
//!
//! A [`Material`](material::Material) says what deformation costs, a [`Stiffness`](stiffness::Stiffness) is its matrix on the
//! coefficients of one space that may move, ready to be solved with, and an [`Elastic`](elastic::Elastic) is a curve's or a
//! surface's worth of them.

pub mod material;
mod factor;
pub mod breadth;
pub mod stiffness;
pub mod elastic;
pub mod pull;
pub mod forces;
pub mod anchors;
