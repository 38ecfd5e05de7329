//! Coefficients of a spline from its pieces.
//!
//! Each coefficient is the polar value of **one** span of its support at the coefficient's knots. Every span gives the
//! same value, but not the same rounding: an argument `u` outside the span `[a, b]` extrapolates, and amplifies errors
//! by up to `1 + 2 dist(u, [a, b]) / (b - a)`. The span with the least product of these factors is taken
//! (`papers/recomposition.md`).

use crate::error::Result;
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
        let (p, tau) = (self.degree(), self.knots());
        let breaks = self.breaks();
        let mut map = LinearMap::empty((p + 1) * (breaks.len() - 1), self.dim());
        // The first span under each unrolled coefficient; a wrapped one may lie past the last span altogether.
        let mut start = 0;
        let mut first_under = |j: usize| {
            while start + 1 < breaks.len() && breaks[start + 1].0 <= tau[j] {
                start += 1;
            }
            start
        };
        let starts: Vec<usize> = (0..self.unrolled_dim()).map(&mut first_under).collect();
        for slot in 0..self.dim() {
            let mut least: Option<(T, usize, &[T])> = None;
            for j in (slot..self.unrolled_dim()).step_by(self.dim()) {
                let args = &tau[j + 1..=j + p];
                for (s, ends) in breaks.windows(2).enumerate().skip(starts[j]) {
                    if ends[0].0 >= tau[j + p + 1] {
                        break;
                    }
                    let cost = amplification(args, &ends[0].0, &ends[1].0);
                    if least.as_ref().is_none_or(|(lowest, ..)| cost < *lowest) {
                        least = Some((cost, s, args));
                    }
                }
            }
            let (_, s, args) = least.expect("every coefficient has a span under it");
            let (a, b) = (&breaks[s].0, &breaks[s + 1].0);
            map.push_with(|weights| s * (p + 1) + bernstein_blossom(a, b, args, weights));
        }
        Ok(map)
    }
}

/// How much polar arguments may amplify errors of Bernstein coefficients on `[a, b]`. Exact fields have no errors:
/// there it counts the arguments that cost anything.
fn amplification<T: Scalar>(args: &[T], a: &T, b: &T) -> T {
    if T::EXACT {
        return T::int(args.iter().filter(|u| *u != a && *u != b).count() as i64);
    }
    let width = b.clone() - a;
    let outside = |u: &T| if u < a { a.clone() - u } else { u.clone() - b };
    let growth = |u: &T| T::one() + T::int(2) * outside(u) / &width;
    args.iter().filter(|u| *u < a || *u > b).fold(T::one(), |product, u| product * growth(u))
}
