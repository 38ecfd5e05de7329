//! Pieces of a curve as arc length sees them: polynomial by the hodograph, rational by weighted points from the start
//! of the piece.
//!
//! With `s` from 0 to 1 on the piece the speed is `|D| / W`:
//!
//! ```text
//! polynomial   D = dC/ds              W = 1
//! rational     D = P' w - P w'        W = w²           C = P / w
//! ```
//!
//! `|D|² = D·D` is a polynomial, so the speed is analytic where that has no zero and neither has `w`.

use super::gauss::PerEllipse;
use super::jet::{Centring, UNIT, size};
use crate::bernstein::binomials;
use crate::coeff::Coeff;
use crate::vector::dot;
use crate::weighted::Weighted;
use nalgebra::SVector;

/// A piece, by Bernstein coefficients, in a unit of its own.
#[derive(Clone, Debug)]
pub(super) enum Piece<const N: usize> {
    /// The hodograph `dC/ds`.
    Polynomial(Vec<SVector<f64, N>>),
    /// The weighted points; the first one is at the origin, if its weight is positive.
    Rational(Vec<Weighted<f64, SVector<f64, N>>>),
}

/// What depends on the degree of the pieces alone.
#[derive(Clone, Debug)]
pub(super) struct Degree {
    /// The binomial coefficients of the degree less one.
    choose: Vec<f64>,
    full: Centring,
    less: Centring,
}

impl Degree {
    /// For pieces of degree `p` of curves.
    pub(super) fn new(p: usize) -> Self {
        let less = p.saturating_sub(1);
        Self { choose: binomials(less), full: Centring::new(p), less: Centring::new(less) }
    }
}

impl<const N: usize> Piece<N> {
    /// The polynomial piece with Bernstein coefficients `points`.
    pub(super) fn polynomial(points: &[SVector<f64, N>]) -> Self {
        let p = (points.len() - 1) as f64;
        let leg = |ends: &[SVector<f64, N>]| (ends[1] - ends[0]) * p;
        let legs: Vec<_> = points.windows(2).map(leg).collect();
        Self::Polynomial(if legs.is_empty() { vec![SVector::zeros()] } else { legs })
    }

    /// The rational piece with Bernstein coefficients `points`.
    pub(super) fn rational(mut points: Vec<Weighted<f64, SVector<f64, N>>>) -> Self {
        let heaviest = points.iter().map(|c| c.weight.abs()).fold(0.0, f64::max);
        let unit = 1.0 / power_of_two(heaviest);
        points.iter_mut().filter(|_| unit != 1.0).for_each(|c| c.scale(&unit));
        if points[0].weight > 0.0 {
            let start = points[0].project();
            points.iter_mut().for_each(|c| c.point -= start * c.weight);
            points[0].point = SVector::zeros();
        }
        Self::Rational(points)
    }

    /// The parts before and after `s`.
    pub(super) fn split(&self, s: f64) -> [Self; 2] {
        match self {
            Self::Polynomial(legs) => {
                let [mut before, mut after] = split(legs, s);
                before.iter_mut().for_each(|leg| *leg *= s);
                after.iter_mut().for_each(|leg| *leg *= 1.0 - s);
                [Self::Polynomial(before), Self::Polynomial(after)]
            }
            Self::Rational(points) => split(points, s).map(Self::rational),
        }
    }

    /// The lengths of chord and control polygon, between which that of the piece lies. Without positive weights nothing
    /// is known from above.
    pub(super) fn enclosure(&self) -> (f64, f64) {
        match self {
            Self::Polynomial(legs) => {
                let count = legs.len() as f64;
                let sum = legs.iter().fold(SVector::zeros(), |sum: SVector<f64, N>, leg| sum + leg);
                (size(&sum) / count, legs.iter().map(size).sum::<f64>() / count)
            }
            Self::Rational(points) => {
                let (first, last) = (&points[0], &points[points.len() - 1]);
                if first.weight <= 0.0 || last.weight <= 0.0 {
                    return (0.0, f64::INFINITY);
                }
                let chord = size(&(last.project() - first.project()));
                if points.iter().any(|c| c.weight <= 0.0) {
                    return (chord, f64::INFINITY);
                }
                let leg = |ends: &[Weighted<f64, _>]| size(&(ends[1].project() - ends[0].project()));
                (chord, points.windows(2).map(leg).sum())
            }
        }
    }

    /// The speed at `s`.
    #[inline]
    pub(super) fn speed(&self, degree: &Degree, s: f64) -> f64 {
        match self {
            Self::Polynomial(legs) => size(&value(&degree.choose, legs, s)),
            Self::Rational(points) if points.len() == 1 => 0.0,
            Self::Rational(points) => {
                let before = value(&degree.choose, &points[..points.len() - 1], s);
                let after = value(&degree.choose, &points[1..], s);
                let p = (points.len() - 1) as f64;
                let slope = after.minus(&before);
                let point = before.plus_scaled(&s, &slope).project();
                let weight = before.weight + s * slope.weight;
                p * size(&(slope.point - point * slope.weight)) / weight
            }
        }
    }

    /// Bounds of the speed on the ellipses, infinite where it is not shown to be analytic; and about the speed in the
    /// middle.
    pub(super) fn most(&self, degree: &Degree) -> (PerEllipse, f64) {
        match self {
            Self::Polynomial(legs) => {
                let hodograph = degree.less.jet(legs);
                let square = hodograph.times(&hodograph, dot);
                let (middle, spread) = (*square.middle(), square.spread());
                let most =
                    |spread: f64| if spread < middle { (middle + spread).sqrt() } else { f64::INFINITY };
                (spread.map(most), middle.sqrt())
            }
            Self::Rational(points) => {
                let p = (points.len() - 1) as f64;
                let slopes: Vec<_> =
                    points.windows(2).map(|ends| ends[1].minus(&ends[0]).scaled(&p)).collect();
                let slopes = if slopes.is_empty() { vec![points[0].zero_like()] } else { slopes };
                let part = |c: &[Weighted<f64, SVector<f64, N>>], by: &Centring| {
                    let points: Vec<_> = c.iter().map(|c| c.point).collect();
                    let weights: Vec<_> = c.iter().map(|c| c.weight).collect();
                    (by.jet(&points), by.jet(&weights))
                };
                let ((point, weight), (slope, weight_slope)) =
                    (part(points, &degree.full), part(&slopes, &degree.less));
                let scaled = |v: &SVector<f64, N>, w: &f64| v * *w;
                let hodograph = slope.times(&weight, scaled).minus(&point.times(&weight_slope, scaled));
                let square = hodograph.times(&hodograph, dot);
                let (over, under) = (square.spread(), weight.spread());
                let (middle, weight) = (*square.middle(), *weight.middle());
                let most = |e: usize| {
                    let shown = over[e] < middle && under[e] < weight;
                    if shown {
                        (middle + over[e]).sqrt() / (weight - under[e]).powi(2)
                    } else {
                        f64::INFINITY
                    }
                };
                (super::gauss::per_ellipse(most), middle.sqrt() / (weight * weight))
            }
        }
    }

    /// By how much the length may be wrong since coefficients are rounded in some `p` operations.
    ///
    /// With positive weights a relative error `e` of them, and one of `e |C|` in the points `C`, moves the length by `2
    /// (p + 1) (p + 4) e |C|` at most, however large their ratios: a rational basis function goes up once and down
    /// once.
    pub(super) fn rounding(&self) -> f64 {
        match self {
            Self::Polynomial(legs) => {
                (legs.len() + 4) as f64 * UNIT * legs.iter().map(size).fold(0.0, f64::max)
            }
            Self::Rational(points) => {
                let p = (points.len() - 1) as f64;
                ((p + 1.0) * (p + 4.0) + 8.0 * p) * (p + 2.0) * 2.0 * UNIT * self.extent()
            }
        }
    }

    /// The greatest distance of a control point of a rational piece from its start.
    pub(super) fn extent(&self) -> f64 {
        let Self::Rational(points) = self else { return 0.0 };
        // Parts of a piece without positive weights have them, and are looked at again.
        let weight = |c: &Weighted<f64, _>| if c.weight > 0.0 { c.weight } else { 1.0 };
        points.iter().map(|c| size(&c.point) / weight(c)).fold(0.0, f64::max)
    }
}

/// The power of two not above `size`, which neither has itself nor in its inverse left the range of numbers; one for
/// zero.
pub(super) fn power_of_two(size: f64) -> f64 {
    if size > 0.0 { size.log2().floor().clamp(-1000.0, 1000.0).exp2() } else { 1.0 }
}

/// The Bernstein coefficients of the parts before and after `s`.
fn split<C: Coeff<f64>>(coeffs: &[C], s: f64) -> [Vec<C>; 2] {
    let (mut before, mut after) = (Vec::with_capacity(coeffs.len()), coeffs.to_vec());
    for r in (0..coeffs.len()).rev() {
        before.push(after[0].clone());
        for i in 0..r {
            let next = after[i + 1].clone();
            after[i].scale(&(1.0 - s));
            after[i].add_scaled(&s, &next);
        }
    }
    [before, after]
}

/// The value at `s` of the polynomial with Bernstein coefficients `coeffs`, whose binomial coefficients are `choose`.
///
/// A sum of terms with positive weights, nested in `1 - s`.
#[inline]
fn value<C: Coeff<f64>>(choose: &[f64], coeffs: &[C], s: f64) -> C {
    let (mut sum, mut power) = (coeffs[0].clone(), 1.0);
    for (coeff, choose) in coeffs.iter().zip(choose).skip(1) {
        power *= s;
        sum.scale(&(1.0 - s));
        sum.add_scaled(&(choose * power), coeff);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::super::gauss::RADII;
    use super::*;
    use nalgebra::vector;

    /// `|D|² = 1 + z² / 4` has the zeros `±2i`.
    #[test]
    fn zeros_of_the_speed_are_seen() {
        let piece = Piece::Polynomial(vec![vector![1.0, -0.5], vector![1.0, 0.5]]);
        let (most, speed) = piece.most(&Degree::new(2));
        assert!((speed - 1.0).abs() < 1e-15);
        for (most, r) in most.into_iter().zip(RADII.iter()) {
            assert_eq!(most.is_finite(), *r < 2.0, "{r}");
        }
    }

    #[test]
    fn the_speed_stays_below_its_bound_beyond_the_ends() {
        for light in [0.6, 1.0, 1.5] {
            let lift = |x: f64, y: f64, weight: f64| Weighted { point: vector![x, y] * weight, weight };
            let piece =
                Piece::rational(vec![lift(0.0, 0.0, 1.0), lift(1.0, 0.1, light), lift(2.0, 0.0, 1.0)]);
            let degree = Degree::new(2);
            for (most, r) in piece.most(&degree).0.into_iter().zip(RADII.iter()) {
                assert!(
                    piece.speed(&degree, (1.0 + r) / 2.0) <= most
                        && piece.speed(&degree, (1.0 - r) / 2.0) <= most
                );
            }
        }
    }
}
