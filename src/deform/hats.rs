//! Loads that are shared by the breaks: forces that are linear on each span.
//!
//! On a span of length `h` a force that goes from `f` to `g` loads the Bernstein polynomials of degree `p` by
//!
//! ```text
//! ∫ B_j (f (1 - t) + g t) h dt = h ((p + 1 - j) f + (j + 1) g) / ((p + 1) (p + 2))
//! ```
//! and a basis function by the sum over its Bernstein coefficients there.

use crate::error::Result;
use crate::functional::Functional;
use crate::gather::Gather;
use crate::knots::KnotVector;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;

/// The load of a unit force at `x`, shared by the breaks on both sides of it [Vassilev, (16) and (17)].
///
/// It looks at three spans, whatever the length of the space.
pub(crate) fn hat_load<T: Scalar>(space: &SplineSpace<T>, x: &T) -> Result<Functional<T>> {
    let k = space.locate(x)?;
    let (start, end) = (&space.knots()[k], &space.knots()[k + 1]);
    let right = (x.clone() - start) / (end.clone() - start);
    Ok(load(space, k, T::one() - &right, right))
}

/// The integrals `∫ N_i S_j` with the hat function `S_j` of each break, row by row [Vassilev, (8) to (12)].
pub(crate) fn forcing<T: Scalar>(space: &SplineSpace<T>) -> LinearMap<T> {
    let n = space.dim();
    let (mut gather, mut map) = (Gather::new(n), LinearMap::empty(n, n));
    let mut push = |row: Functional<T>| {
        let first = row.first();
        let weights = row.into_weights().into_iter().enumerate();
        weights.for_each(|(i, weight)| gather.add((first + i) % n, weight));
        map.push_with(|weights| gather.drain_into(weights));
    };
    space.spans().for_each(|k| push(load(space, k, T::one(), T::zero())));
    if !space.is_periodic() {
        push(load(space, space.last_span(), T::zero(), T::one()));
    }
    map
}

/// The space of the hat functions: continuous, linear between breaks.
pub(crate) fn hat_space<T: Scalar>(space: &SplineSpace<T>) -> Result<SplineSpace<T>> {
    let mut breaks: Vec<T> = space.breaks().into_iter().map(|(knot, _)| knot).collect();
    if !space.is_periodic() {
        return SplineSpace::clamped(1, breaks);
    }
    breaks.pop();
    SplineSpace::joined(1, &KnotVector::new(breaks)?, space.domain().1.clone())
}

/// The load of the multiples `left` and `right` of the hat functions at the ends of span `k`.
fn load<T: Scalar>(space: &SplineSpace<T>, k: usize, left: T, right: T) -> Functional<T> {
    let (p, n) = (space.degree(), space.dim() as i64);
    let (before, after) = (span_before(space, k), span_after(space, k));
    let before = before.filter(|_| !left.is_zero()).map(|k| (k, T::zero(), left.clone()));
    let after = after.filter(|_| !right.is_zero()).map(|k| (k, right.clone(), T::zero()));
    let pieces = [before, Some((k as i64, left, right)), after];
    let pieces: Vec<_> = pieces.into_iter().flatten().collect();
    let (first, last) = (pieces[0].0, pieces[pieces.len() - 1].0);
    let mut weights = vec![T::zero(); (last - first) as usize + p + 1];
    for (unrolled, from, to) in &pieces {
        // Among the spans of the space.
        let k = if space.is_periodic() { (unrolled - p as i64).rem_euclid(n) + p as i64 } else { *unrolled };
        add_span(space, k as usize, [from, to], &mut weights[(unrolled - first) as usize..]);
    }
    Functional::new((first - p as i64).rem_euclid(n) as usize, weights)
}

/// The non-empty span before; of the first one in a ring the last, a round before.
fn span_before<T: Scalar>(space: &SplineSpace<T>, k: usize) -> Option<i64> {
    let t = space.knots();
    match (space.degree()..k).rev().find(|k| t[*k] < t[k + 1]) {
        Some(before) => Some(before as i64),
        None => space.is_periodic().then(|| space.last_span() as i64 - space.dim() as i64),
    }
}

/// The non-empty span after; of the last one in a ring the first, a round later.
fn span_after<T: Scalar>(space: &SplineSpace<T>, k: usize) -> Option<i64> {
    let t = space.knots();
    match (k + 1..space.unrolled_dim()).find(|k| t[*k] < t[k + 1]) {
        Some(after) => Some(after as i64),
        None => space.is_periodic().then(|| (space.degree() + space.dim()) as i64),
    }
}

/// Adds the load of the basis functions of span `k`, the first at `weights[0]`.
fn add_span<T: Scalar>(space: &SplineSpace<T>, k: usize, [from, to]: [&T; 2], weights: &mut [T]) {
    let (p, t) = (space.degree(), space.knots());
    let (start, end) = (&t[k], &t[k + 1]);
    let share = (end.clone() - start) / T::int(((p + 1) * (p + 2)) as i64);
    let mut j = 0;
    space.each_bernstein(k, |first, row| {
        let of_j = from.clone() * T::int((p + 1 - j) as i64) + to.clone() * T::int((j + 1) as i64);
        let of_j = of_j * &share;
        weights[first..].iter_mut().zip(row).for_each(|(sum, c)| *sum += c.clone() * &of_j);
        j += 1;
    });
}
