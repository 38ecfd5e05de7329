//! Coefficients of a spline from its pieces.
//!
//! Each coefficient is the polar value of **one** span of its support at the coefficient's knots. Every span gives the
//! same value, but not the same rounding: an argument `u` outside the span `[a, b]` extrapolates, and amplifies errors
//! by up to `1 + 2 dist(u, [a, b]) / (b - a)`. The span with the least product of these factors is taken
//! (`papers/recomposition.md`).
//!
//! Where all knots of a coefficient are `a` or `b` it is a Bernstein coefficient: of a product most are.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::functional::weigh;
use crate::map::LinearMap;
use crate::polar::bernstein_blossom;
use crate::scalar::Scalar;
use crate::space::SplineSpace;

impl<T: Scalar> SplineSpace<T> {
    /// The map from Bernstein coefficients on the spans, those of [`pieces`](Self::pieces) of the same degree, to
    /// coefficients of this space, for piecewise polynomials that lie in it. Each row uses a single piece.
    ///
    /// # Errors
    /// None for a valid space.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 2.0])?;
    /// let f = Function::new(space.clone(), vec![0.0, 1.0, 3.0, 0.0])?;
    /// let pieces = f.embedded(&space.pieces(2)?)?;
    /// assert_eq!(space.recomposition()?.apply(pieces.coeffs())?, f.coeffs());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn recomposition(&self) -> Result<LinearMap<T>> {
        let ends = self.ends();
        let mut map = LinearMap::empty((self.degree() + 1) * (ends.len() - 1), self.dim());
        let mut choice = SpanChoice::new(self, &ends);
        for slot in 0..self.dim() {
            let place = choice.least(slot);
            map.push_with(|weights| choice.row(place, weights));
        }
        Ok(map)
    }

    /// The [recomposition](Self::recomposition) of `pieces`, the Bernstein coefficients between the distinct knots `ends`,
    /// without a table. What comes from piece `s` is divided by `divisors[s]`, if there are any.
    pub(crate) fn recomposed<C: Coeff<T>>(&self, ends: &[T], pieces: &[C], divisors: &[T]) -> Vec<C> {
        let (p, tau) = (self.degree(), self.knots());
        let mut choice = SpanChoice::new(self, ends);
        let mut coeffs: Vec<C> = Vec::with_capacity(self.dim());
        let mut weights = Vec::with_capacity(p + 1);
        let divide = |c: &mut C, s: usize| {
            if let Some(divisor) = divisors.get(s).filter(|divisor| !divisor.is_one()) {
                c.divide(divisor);
            }
        };
        let mut by_choice = |slot: usize| {
            weights.clear();
            let place = choice.least(slot);
            let first = choice.row(place, &mut weights);
            let mut c = weigh(first, &weights, pieces);
            divide(&mut c, place.0);
            c
        };
        // The last copy of the start of a span, and up to p copies there.
        let mut k = p;
        let mut at_start = tau[1..=k].iter().filter(|t| **t == ends[0]).count();
        for (s, (b, piece)) in ends[1..].iter().zip(pieces.chunks_exact(p + 1)).enumerate() {
            let at_end = tau[k + 1..].iter().take(p).take_while(|t| *t == b).count();
            // Coefficient k + i - p has i knots at the end of the span, and the others at its start if there are as many.
            let first = (p - at_start).max((p + coeffs.len()).saturating_sub(k));
            if first <= at_end {
                (coeffs.len()..(k + first - p).min(self.dim())).for_each(|slot| coeffs.push(by_choice(slot)));
                let copied = coeffs.len();
                coeffs.extend_from_slice(&piece[first..=at_end]);
                coeffs[copied..].iter_mut().for_each(|c| divide(c, s));
            }
            k += at_end;
            while tau.get(k + 1) == Some(b) {
                k += 1;
            }
            at_start = at_end;
        }
        (coeffs.len()..self.dim()).for_each(|slot| coeffs.push(by_choice(slot)));
        coeffs.truncate(self.dim());
        coeffs
    }
}

/// A span and the knots of a coefficient for arguments.
type Place<'a, T> = (usize, &'a [T]);

/// Chooses the spans that amplify least, for one coefficient after the other.
struct SpanChoice<'a, T> {
    space: &'a SplineSpace<T>,
    ends: &'a [T],
    /// For each turn of a ring the first span under the unrolled coefficient.
    starts: Vec<usize>,
}

impl<'a, T: Scalar> SpanChoice<'a, T> {
    fn new(space: &'a SplineSpace<T>, ends: &'a [T]) -> Self {
        Self { space, ends, starts: vec![0; space.unrolled_dim().div_ceil(space.dim())] }
    }

    /// The best place for coefficient `slot`; `slot` must not decrease from call to call.
    fn least(&mut self, slot: usize) -> Place<'a, T> {
        let (p, tau, ends) = (self.space.degree(), self.space.knots(), self.ends);
        let mut least: Option<(T, Place<'a, T>)> = None;
        let mut j = slot;
        for start in &mut self.starts {
            if j >= self.space.unrolled_dim() {
                break;
            }
            // A wrapped one may lie past the last span altogether.
            while *start + 1 < ends.len() && ends[*start + 1] <= tau[j] {
                *start += 1;
            }
            let (args, end) = (&tau[j + 1..=j + p], &tau[j + p + 1]);
            let under = ends[*start..].windows(2).take_while(|ends| ends[0] < *end);
            for (s, ends) in (*start..).zip(under) {
                let cost = amplification(args, &ends[0], &ends[1]);
                if least.as_ref().is_none_or(|(lowest, _)| cost < *lowest) {
                    least = Some((cost, (s, args)));
                }
            }
            j += self.space.dim();
        }
        least.expect("every coefficient has a span under it").1
    }

    /// Appends the weights there on the coefficients of the pieces; returns the index of the first.
    fn row(&self, (s, args): Place<'_, T>, weights: &mut Vec<T>) -> usize {
        s * (args.len() + 1) + bernstein_blossom(&self.ends[s], &self.ends[s + 1], args, weights)
    }
}

/// How much polar arguments, in ascending order, may amplify errors of Bernstein coefficients on `[a, b]`. Exact fields
/// have no errors: there it counts the arguments that cost anything.
fn amplification<T: Scalar>(args: &[T], a: &T, b: &T) -> T {
    if T::EXACT {
        return T::int(args.iter().filter(|u| *u != a && *u != b).count() as i64);
    }
    let double = T::int(2) / (b.clone() - a);
    let left = args.iter().take_while(|u| *u < a).map(|u| a.clone() - u);
    let right = args.iter().rev().take_while(|u| *u > b).map(|u| u.clone() - b);
    left.chain(right).fold(T::one(), |product, distance| product * (T::one() + distance * &double))
}
