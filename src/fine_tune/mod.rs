//! Fine tuning: a curve is deformed by scaling its derivative, after Miura, Cheng and Wang.

pub mod scale;
pub mod approximate;
pub mod turn;
mod ends;
mod place;
pub mod hold;
pub mod condition;
mod table;
mod area;
pub mod scale_space;
pub mod nearest_scale;
pub mod tuner;
pub mod local;
pub mod repeated;
pub mod segmented;
mod records;
mod minimise;
mod ring;
mod legs;
pub mod joint;
pub mod springs;
mod chain;
mod frame;
pub mod closed;
pub mod surface;
pub mod mesh;
