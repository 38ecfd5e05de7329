//! What curves and surfaces are like: zeros, curvature and its events, lengths, frames, nearest points,
//! meetings, most of it with proofs.

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
pub mod turning;
pub mod length;
pub mod frames;
pub mod surface_curvature;
pub mod nearest;
pub mod meet;
