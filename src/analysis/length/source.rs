//! From curves to pieces.
//!
//! Each span is taken from a control point of its own and in a unit of its own before anything is rounded: then errors
//! are in proportion to what the span spans, however far it is from the origin.

use super::jet::{UNIT, size};
use super::piece::{Piece, power_of_two};
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::polar::{polar_value, take_run};
use crate::space::SplineSpace;
use crate::spline::{Curve, Spline};
use crate::weighted::Weighted;
use nalgebra::SVector;

/// A span of a curve.
#[derive(Clone, Debug)]
pub(super) struct Span<const N: usize> {
    /// Where it starts and ends.
    pub ends: (f64, f64),
    pub piece: Piece<N>,
    /// The unit of lengths of the piece.
    pub unit: f64,
    /// By how much rounding on the way to the piece may change its length, in that unit.
    pub rounding: f64,
}

/// The spans of a polynomial curve.
pub(super) fn polynomial_spans<const N: usize>(curve: &Curve<f64, N>) -> Result<Vec<Span<N>>> {
    let span = |k: usize| {
        let mut window = window(curve, k);
        let far = unit_of(&window, |c| c.amax());
        window.iter_mut().for_each(|c| *c /= far);
        let origin = window[0];
        window.iter_mut().for_each(|c| *c -= origin);
        let near = unit_of(&window, |c| c.amax());
        window.iter_mut().for_each(|c| *c /= near);
        let widest = window.iter().map(size).fold(0.0, f64::max);
        let p = curve.degree() as f64;
        let piece = Piece::polynomial(&bernstein(curve.space(), k, &window));
        Ok(Span {
            ends: ends(curve.space(), k),
            piece,
            unit: far * near,
            rounding: 8.0 * p * p * UNIT * widest,
        })
    };
    curve.space().spans().map(span).collect()
}

/// The spans of a rational curve.
pub(super) fn rational_spans<const N: usize>(
    lifted: &Spline<f64, Weighted<f64, SVector<f64, N>>>,
) -> Result<Vec<Span<N>>> {
    let span = |k: usize| {
        let mut window = window(lifted, k);
        let heavy = unit_of(&window, |c| c.weight.abs());
        let far = unit_of(&window, |c| c.point.amax());
        window.iter_mut().for_each(|c| {
            c.weight /= heavy;
            c.point /= far;
        });
        let heaviest = window.iter().max_by(|c, d| c.weight.total_cmp(&d.weight));
        let origin = heaviest.expect("a window has a coefficient").project();
        window.iter_mut().for_each(|c| c.point -= origin * c.weight);
        let near = unit_of(&window, |c| c.point.amax());
        window.iter_mut().for_each(|c| c.point /= near);
        let p = lifted.degree() as f64;
        let piece = Piece::rational(bernstein(lifted.space(), k, &window));
        let unit = far / heavy * near;
        if !unit.is_finite() {
            return Err(Error::NotFinite { what: "length", index: 0 });
        }
        // Taking the origin away is rounded twice in proportion to that, the rest in proportion to what is left.
        let share = 2.0 * (p + 1.0) * (p + 4.0) * UNIT;
        let rounding = share * ((5.0 * p + 4.0) * piece.extent() + 2.0 * size(&origin) / near);
        let rounding = if p > 0.0 { rounding } else { 0.0 };
        Ok(Span { ends: ends(lifted.space(), k), piece, unit, rounding })
    };
    lifted.space().spans().map(span).collect()
}

fn window<C: Coeff<f64>>(spline: &Spline<f64, C>, k: usize) -> Vec<C> {
    (k - spline.degree()..=k).map(|i| spline.coeff(i).clone()).collect()
}

fn ends(space: &SplineSpace<f64>, k: usize) -> (f64, f64) {
    (space.knots()[k], space.knots()[k + 1])
}

/// The power of two for the unit of the sizes of coefficients.
fn unit_of<C>(window: &[C], size: impl Fn(&C) -> f64) -> f64 {
    power_of_two(window.iter().map(size).fold(0.0, f64::max))
}

/// The Bernstein coefficients on span `k`, where only the coefficients of that span are given.
fn bernstein<C: Coeff<f64>>(space: &SplineSpace<f64>, k: usize, window: &[C]) -> Vec<C> {
    let (p, t) = (space.degree(), space.knots());
    let (mut free, mut weights) = (Vec::new(), vec![0.0; p + 1]);
    let ends: Vec<&f64> = std::iter::repeat_n(&t[k], p).chain(std::iter::repeat_n(&t[k + 1], p)).collect();
    let coefficient = |i: usize| {
        let (lo, hi) = take_run(t, k, &ends[i..i + p], &mut free);
        let weights = &mut weights[..=free.len()];
        polar_value(t, (lo, hi), |r| free[r], weights, (hi - k, window))
    };
    (0..=p).map(coefficient).collect()
}
