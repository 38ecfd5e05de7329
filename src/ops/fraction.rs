//! How large a quotient of splines is, patch by patch.
//!
//! On a patch the quotient `r / w` with positive weights is a mean of what its coefficients stand for,
//!
//! ```text
//! |r / w| <= max |r_i| / w_i
//! ```
//! Halving the patch closes in on the truth, and makes weights positive where only the values of the denominator are.
//!
//! If each `r_i` is known but for an error of `m` and each `w_i` but for one of `k`, then
//!
//! ```text
//! |r / w| <= (max |r_i| / w_i + m / w_min) / (1 - k / w_min)
//! ```

use crate::coeff::Coeff;
use crate::ops::bound::{epsilon, largest, size};
use crate::ops::patch::Patch;
use crate::scalar::{Scalar, larger, larger_size};
use crate::weighted::Weighted;

/// How often a patch is halved in each direction before its bound counts.
pub(crate) const HALVINGS: usize = 2;

/// What is certain of a quotient on one patch.
#[derive(Clone, Debug, PartialEq)]
pub struct FractionBound<T> {
    /// The quotient is nowhere larger; nothing is known where halving left weights that may not be positive.
    pub bound: Option<T>,
    /// What rounding makes of the bound at least, however small the patch.
    pub floor: T,
    /// How much the numerator changes from one coefficient to the next along each direction, squared.
    pub rises: Vec<T>,
}

/// The quotient of `patch`, whose coefficients may be off by those of `noise`. Where the bound is at most `enough` no patch is
/// halved further.
pub(crate) fn fraction_bound<T: Scalar, C: Coeff<T>, const D: usize>(
    patch: Patch<T, D, Weighted<T, C>>,
    noise: Option<&Patch<T, D, Weighted<T>>>,
    enough: &T,
) -> FractionBound<T> {
    let most = |numbers: fn(&Weighted<T>) -> &T| -> T {
        let numbers = noise.iter().flat_map(|noise| noise.coeffs.iter().map(numbers));
        numbers.fold(T::zero(), |most, x| larger_size(most, x.clone()))
    };
    let errors = [most(|c| &c.point), most(|c| &c.weight)];
    let shares = noise.iter().flat_map(|noise| noise.coeffs.iter().zip(&patch.coeffs));
    let shares =
        shares.filter(|(_, c)| c.weight > T::zero()).map(|(noise, c)| noise.point.clone() / &c.weight);
    let floor = shares.reduce(|low, x| if x < low { x } else { low }).unwrap_or_else(T::zero);
    let rises = (0..D).map(|axis| rise(&patch, axis)).collect();
    let bound = halved(patch, &errors, enough, 0);
    FractionBound { bound, floor, rises }
}

/// The bound after halvings, or that without them if they do not help.
fn halved<T: Scalar, C: Coeff<T>, const D: usize>(
    patch: Patch<T, D, Weighted<T, C>>,
    errors: &[T; 2],
    enough: &T,
    turn: usize,
) -> Option<T> {
    let whole = whole(&patch, errors);
    let beyond = |c: &Weighted<T, C>| size(&c.point) > enough.clone() * &c.weight;
    let decided = whole.as_ref().is_some_and(|bound| bound <= enough);
    let is_constant = patch.coeffs.len() == 1;
    if decided || is_constant || turn == HALVINGS * D || patch.corners().any(beyond) {
        return whole;
    }
    let mut most = T::zero();
    for half in patch.halves(turn) {
        match halved(half, errors, enough, turn + 1).filter(|bound| bound <= enough) {
            Some(bound) => most = larger(most, bound),
            None => return whole,
        }
    }
    Some(most)
}

/// The bound from the coefficients as they are.
fn whole<T: Scalar, C: Coeff<T>, const D: usize>(
    patch: &Patch<T, D, Weighted<T, C>>,
    [off, weight_off]: &[T; 2],
) -> Option<T> {
    if T::EXACT && patch.coeffs.iter().all(|c| c.point.vanishes()) {
        return Some(T::zero());
    }
    let lower = |low: &T, c: &Weighted<T, C>| if c.weight < *low { Some(c.weight.clone()) } else { None };
    let first = patch.coeffs[0].weight.clone();
    let least = patch.coeffs.iter().fold(first, |low, c| lower(&low, c).unwrap_or(low));
    if least <= weight_off.clone() * T::int(2) {
        return None;
    }
    let quotients: Vec<C> = patch.coeffs.iter().map(Weighted::project).collect();
    let top = largest(&quotients);
    if T::EXACT {
        return Some(top);
    }
    // Room for the roundings of this line and of the quotients.
    let slack = T::one() + T::int(16) * epsilon::<T>();
    let bound = (top + off.clone() / &least) / (T::one() - weight_off.clone() / &least) * slack;
    bound.is_finite().then_some(bound)
}

/// The largest squared difference of neighbours along `axis`.
fn rise<T: Scalar, C: Coeff<T>, const D: usize>(patch: &Patch<T, D, Weighted<T, C>>, axis: usize) -> T {
    let stride: usize = patch.degrees[axis + 1..].iter().map(|q| q + 1).product();
    let inside = |i: &usize| i / stride % (patch.degrees[axis] + 1) < patch.degrees[axis];
    let starts = (0..patch.coeffs.len()).filter(inside);
    let steps = starts.map(|i| patch.coeffs[i + stride].point.minus(&patch.coeffs[i].point).squared_size());
    steps.fold(T::zero(), larger_size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halving_finds_positive_weights_and_sharper_bounds() {
        // x (1 - x) / (1 - 3 x + 3 x²): the middle weight is negative, the greatest value is 1 at 1/2.
        let c = [(0.0, 1.0), (0.5, -0.5), (0.0, 1.0)].map(|(point, weight)| Weighted { point, weight });
        let patch = Patch { degrees: [2], sides: [(0.0, 1.0)], coeffs: c.to_vec() };
        let noise = [0.0; 3].map(|point| Weighted { point, weight: 0.0 });
        let noise = Patch { degrees: [2], sides: [(0.0, 1.0)], coeffs: noise.to_vec() };
        assert_eq!(fraction_bound(patch.clone(), None, &0.5).bound, None);
        let bound = fraction_bound(patch.clone(), Some(&noise), &4.0).bound.unwrap();
        assert!((1.0..=4.0).contains(&bound), "{bound}");
        let noise = Patch { coeffs: vec![Weighted { point: 0.25, weight: 0.0 }; 3], ..noise };
        let off = fraction_bound(patch, Some(&noise), &8.0);
        assert!(off.bound.unwrap() > bound && off.floor == 0.25 && off.rises == [0.25]);
    }

    #[test]
    fn constants_are_not_halved() {
        let one = |point, weight| Patch {
            degrees: [0, 0],
            sides: [(0.0, 1.0), (0.0, 1.0)],
            coeffs: vec![Weighted { point, weight }],
        };
        let bound = fraction_bound(one(1.0, 2.0), Some(&one(1.0, 0.0)), &0.75).bound.unwrap();
        assert!((1.0..1.001).contains(&bound), "{bound}");
    }
}
