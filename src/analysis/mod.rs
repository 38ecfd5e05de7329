//! What a curve is like: zeros, curvature and its events, with proofs.

pub mod curvature;
mod ball;
mod pieces;
mod lifted;
pub mod certify;
pub mod zeros;
mod chain;
mod joint;
pub mod events;
pub mod measure;
pub mod profile;
pub mod analyse;
pub mod crossings;
pub mod nearest;
