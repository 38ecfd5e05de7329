//! What a curve is like: so far its curvature.

pub mod curvature;
