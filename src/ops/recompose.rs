//! Coefficients of a spline from its pieces.
//!
//! Each coefficient is the polar value of **one** span of its support at the coefficient's knots. Every span gives the
//! same value, but not the same rounding: an argument `u` outside the span `[a, b]` extrapolates, and amplifies errors
//! by up to `1 + 2 dist(u, [a, b]) / (b - a)`. The span with the least product of these factors is taken
//! (`papers/recomposition.md`).

use crate::error::Result;
use crate::map::LinearMap;
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
        let pieces = self.pieces(p)?;
        let spans: Vec<usize> = pieces.spans().collect();
        let breaks: Vec<&T> = spans.iter().map(|&k| &pieces.knots()[k]).chain([pieces.domain().1]).collect();
        let mut map = LinearMap::empty(pieces.dim(), self.dim());
        let (mut args, mut free) = (Vec::with_capacity(p), Vec::with_capacity(p));
        // The spans under unrolled coefficient j; a wrapped coefficient also has those of its other end.
        let mut start = 0;
        let mut under = |j: usize| {
            while start + 1 < spans.len() && *breaks[start + 1] <= tau[j] {
                start += 1;
            }
            // A wrapped coefficient may lie past the last span altogether.
            let from = start + usize::from(*breaks[start + 1] <= tau[j]);
            let count = breaks[from..spans.len()].iter().take_while(|a| ***a < tau[j + p + 1]).count();
            (j, from, from + count)
        };
        let mut candidates: Vec<_> = (0..self.unrolled_dim()).map(&mut under).collect();
        let wrapped = candidates.split_off(self.dim());
        for (j, from, to) in candidates {
            let turns = wrapped.iter().skip(j).step_by(self.dim());
            let all = [(j, from, to)].into_iter().chain(turns.copied());
            let choices = all.flat_map(|(j, from, to)| (from..to).map(move |s| (j, s)));
            let cost =
                |&(j, s): &(usize, usize)| amplification(&tau[j + 1..=j + p], breaks[s], breaks[s + 1]);
            let least =
                choices.map(|choice| (cost(&choice), choice)).reduce(|x, y| if y.0 < x.0 { y } else { x });
            let (_, (j, s)) = least.expect("every coefficient has a span under it");
            args.clear();
            args.extend(&tau[j + 1..=j + p]);
            map.push_with(|weights| pieces.polar_into(spans[s], &args, &mut free, weights));
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
