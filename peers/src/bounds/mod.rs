//! Lower bounds: what plain safe Rust takes at least, written by hand for one degree, simple knots inside, clamped
//! ends and `f64`. Nothing is checked and nothing is general: a library can come near, rarely below.
//!
//! Points have four lanes `[x, y, z, w]`, so that polynomial and rational tables are one text.

pub mod direct;
pub mod elevate;
pub mod interpolate;
pub mod pieces;
pub mod plain;
pub mod product;
pub mod reduce;
pub mod refine;
pub mod remove;
pub mod surface;
pub mod table;

pub type Lanes = [f64; 4];

#[inline(always)]
pub fn lanes(term: impl FnMut(usize) -> f64) -> Lanes {
    std::array::from_fn(term)
}

/// `(wx, wy, wz, w)` for each point.
pub fn lifted(points: &[[f64; 3]], weights: &[f64]) -> Vec<Lanes> {
    points.iter().zip(weights).map(|([x, y, z], w)| [w * x, w * y, w * z, *w]).collect()
}

/// The points with weight 1.
pub fn flat(points: &[[f64; 3]]) -> Vec<Lanes> {
    points.iter().map(|[x, y, z]| [*x, *y, *z, 1.0]).collect()
}

#[inline(always)]
pub fn point([x, y, z, _]: Lanes) -> [f64; 3] {
    [x, y, z]
}

#[inline(always)]
pub fn project([x, y, z, w]: Lanes) -> [f64; 3] {
    let inverse = 1.0 / w;
    [x * inverse, y * inverse, z * inverse]
}
