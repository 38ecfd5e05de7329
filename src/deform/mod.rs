//! Deformable splines: shapes with the energy of an elastic body, moved by forces, after Vassilev.
//!
//! A [`Material`](material::Material) says what deformation costs, a [`Stiffness`](stiffness::Stiffness) is its matrix on the
//! coefficients of one space that may move, ready to be solved with, and an [`Elastic`](elastic::Elastic) is a curve's or a
//! surface's worth of them.
//! A [`Sculptor`](sculptor::Sculptor) has a shape in hand: forces come and go, and what was done can be undone.

pub mod material;
mod factor;
pub mod breadth;
mod hats;
mod loose;
pub mod stiffness;
mod null_space;
mod quadrature;
pub mod elastic;
pub mod pull;
pub mod forces;
pub mod forces_along;
pub mod area;
pub mod forces_over;
pub mod anchors;
pub mod relax;
pub mod full_energy;
pub mod reach;
pub mod restorable;
mod bodies;
mod history;
pub mod sculptor;
