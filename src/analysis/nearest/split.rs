//! Halving of Bernstein coefficients in one or two directions, on a stack.

use crate::coeff::Coeff;

/// How many coefficients there are with these degrees.
#[inline]
pub(super) fn count(degrees: [usize; 2]) -> usize {
    (degrees[0] + 1) * (degrees[1] + 1)
}

/// Halves the polynomial at the end of `coeffs`, which begins at `first`, in direction `axis`. One half replaces it,
/// the other is put behind it: the upper half if `upper_last`, else the lower.
pub(super) fn halve<C: Coeff<f64>>(
    coeffs: &mut Vec<C>,
    first: usize,
    degrees: [usize; 2],
    axis: usize,
    upper_last: bool,
) {
    coeffs.extend_from_within(first..);
    let (front, back) = coeffs[first..].split_at_mut(count(degrees));
    let (lower, upper) = if upper_last { (front, back) } else { (back, front) };
    let (p, stride) = (degrees[axis], if axis == 0 { degrees[1] + 1 } else { 1 });
    let lines = if axis == 0 { 0..degrees[1] + 1 } else { 0..degrees[0] + 1 };
    for line in lines {
        let start = if axis == 0 { line } else { line * (degrees[1] + 1) };
        let c = |i: usize| start + i * stride;
        for r in 1..=p {
            for i in (r..=p).rev() {
                let (before, here) = lower.split_at_mut(c(i));
                here[0].scale(&0.5);
                here[0].add_scaled(&0.5, &before[c(i - 1)]);
            }
            upper[c(p - r)] = lower[c(p)].clone();
        }
    }
}

/// Replaces the polynomial at the end of `coeffs` by its values on the lower or the upper side in direction `axis`.
pub(super) fn keep_side<C: Coeff<f64>>(
    coeffs: &mut Vec<C>,
    first: usize,
    degrees: [usize; 2],
    axis: usize,
    upper: bool,
) {
    let [p, q] = degrees;
    if axis == 0 {
        if upper {
            (0..=q).for_each(|j| coeffs[first + j] = coeffs[first + p * (q + 1) + j].clone());
        }
        coeffs.truncate(first + q + 1);
    } else {
        let column = if upper { q } else { 0 };
        (0..=p).for_each(|i| coeffs[first + i] = coeffs[first + i * (q + 1) + column].clone());
        coeffs.truncate(first + p + 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_and_sides_of_a_product() {
        // x y on [0, 2] × [0, 4].
        let whole = vec![9.0, 0.0, 0.0, 0.0, 8.0];
        for upper_last in [false, true] {
            let mut coeffs = whole.clone();
            halve(&mut coeffs, 1, [1, 1], 0, upper_last);
            let (lower, upper) = ([0.0, 0.0, 0.0, 4.0], [0.0, 4.0, 0.0, 8.0]);
            let expected = if upper_last { [lower, upper] } else { [upper, lower] };
            assert_eq!(coeffs[1..], expected.concat());
        }
        let mut coeffs = whole.clone();
        halve(&mut coeffs, 1, [1, 1], 1, true);
        assert_eq!(coeffs[1..], [0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 4.0, 8.0]);
        for (axis, upper, side) in [(0, true, [0.0, 8.0]), (1, true, [0.0, 8.0]), (0, false, [0.0, 0.0])] {
            let mut coeffs = whole.clone();
            keep_side(&mut coeffs, 1, [1, 1], axis, upper);
            assert_eq!(coeffs[1..], side);
        }
    }
}
