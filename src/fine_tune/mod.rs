//! Fine tuning: a curve is deformed by scaling its derivative [Miura].

pub mod scale;
pub mod hold;
