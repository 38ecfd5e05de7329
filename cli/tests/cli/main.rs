//! The program, run as others run it.
#![allow(clippy::unwrap_used, reason = "these are tests, also outside of functions marked so")]

mod program;
mod calc;
mod formats;
mod looking;
mod meshes;
mod readme;
mod shaping;
mod streams;
mod tuning;
