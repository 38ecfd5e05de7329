//! What a curve is like: zeros, curvature and its events, with proofs.

mod ball;
mod pieces;
mod lifted;
pub mod certify;
pub mod zeros;
mod chain;
mod joint;
pub mod events;
pub mod profile;
pub mod analyse;
pub mod curvature;
