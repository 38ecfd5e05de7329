//! The polynomial pieces of a spline, as Bernstein coefficients.
//!
//! On `[a, b]` within the span `[t_k, t_{k+1}]` coefficient `i` is the polar value `F(a, ..., a, b, ..., b)` with `i`
//! times `b`. The coefficients `F(t_{k-p+i+1}, ..., t_{k+i})` become `F(a, ..., a, t_{k+1}, ..., t_{k+i})` by `p` steps that
//! each put in one `a`, and then those by `p` steps that each put in one `b`. All steps are convex combinations, and they need
//! no table.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::limits::check_dim;
use crate::ops::elevate::SpanWalk;
use crate::polar::{polar_value, take_run};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The polynomial pieces, one a span, each on its own interval with Bernstein coefficients.
    ///
    /// Computes what [NURBS, A5.6] does, with the original parameters kept.
    ///
    /// # Errors
    /// [`TooLarge`](crate::Error::TooLarge).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let f = Function::new(SplineSpace::clamped(2, [0.0, 1.0, 2.0])?, vec![0.0, 1.0, 3.0, 0.0])?;
    /// let pieces = f.bezier_pieces()?;
    /// assert_eq!(pieces[1].domain(), (&1.0, &2.0));
    /// assert_eq!(pieces[1].coeffs(), [2.0, 3.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn bezier_pieces(&self) -> Result<Vec<Self>> {
        let (p, ends) = (self.degree(), self.space().ends());
        let all = self.bernstein(&ends)?;
        let piece = |(ends, coeffs): (&[T], &[C])| {
            Spline::new(SplineSpace::bezier(p, ends[0].clone(), ends[1].clone())?, coeffs.to_vec())
        };
        ends.windows(2).zip(all.chunks(p + 1)).map(piece).collect()
    }

    /// The Bernstein coefficients between neighbours of `ends`, `p + 1` each. These ascend from end to end of the domain
    /// and leave out no knot: the coefficients in the [pieces](SplineSpace::pieces) of a space with these breaks.
    ///
    /// # Errors
    /// [`TooLarge`](crate::Error::TooLarge).
    pub(crate) fn bernstein(&self, ends: &[T]) -> Result<Vec<C>> {
        check_dim((ends.len() - 1).saturating_mul(self.degree() + 1))?;
        Ok(match self.degree() {
            // One reduction a coefficient.
            _ if T::EXACT => self.bernstein_by_values(ends),
            0 => self.bernstein_of_order::<1>(ends),
            1 => self.bernstein_of_order::<2>(ends),
            2 => self.bernstein_of_order::<3>(ends),
            3 => self.bernstein_of_order::<4>(ends),
            4 => self.bernstein_of_order::<5>(ends),
            5 => self.bernstein_of_order::<6>(ends),
            _ => self.bernstein_by_values(ends),
        })
    }

    /// [`bernstein`](Self::bernstein) as the definition has it: each coefficient a polar value.
    fn bernstein_by_values(&self, ends: &[T]) -> Vec<C> {
        let (p, t) = (self.degree(), self.space().knots());
        let (mut args, mut free, mut weights) = (Vec::new(), Vec::new(), vec![T::zero(); p + 1]);
        let mut walk = SpanWalk::new(self.space());
        let mut pieces: Vec<C> = Vec::with_capacity((p + 1) * (ends.len() - 1));
        for ends in ends.windows(2) {
            let k = walk.span_right_of(&ends[0]);
            // Without a jump the first coefficient is the last one before.
            let joined = pieces.last().filter(|_| t[k - p] < ends[0]).cloned();
            let first = usize::from(joined.is_some());
            pieces.extend(joined);
            for i in first..=p {
                args.clear();
                args.extend(std::iter::repeat_n(&ends[0], p - i).chain(std::iter::repeat_n(&ends[1], i)));
                let (lo, hi) = take_run(t, k, &args, &mut free);
                let arg = |r: usize| free[r];
                let value =
                    polar_value(t, (lo, hi), arg, &mut weights[..=free.len()], (hi - p, self.coeffs()));
                pieces.push(value);
            }
        }
        pieces
    }

    /// [`bernstein`](Self::bernstein) for `ORDER = p + 1` known to the compiler.
    fn bernstein_of_order<const ORDER: usize>(&self, ends: &[T]) -> Vec<C> {
        let (p, t) = (ORDER - 1, self.space().knots());
        let mut walk = SpanWalk::new(self.space());
        let mut pieces: Vec<C> = Vec::with_capacity(ORDER * (ends.len() - 1));
        for ends in ends.windows(2) {
            let (a, b) = (&ends[0], &ends[1]);
            let k = walk.span_right_of(a);
            let (below, above) = (&t[k + 1 - p..=k], &t[k + 1..=k + p]);
            let mut c: [C; ORDER] =
                std::array::from_fn(|i| self.coeffs()[self.space().slot(k - p + i)].clone());
            // Without a jump the first coefficient is the last one before.
            let joined = pieces.last().filter(|_| t[k - p] < *a);
            for r in 1..ORDER {
                for i in 0..ORDER - r {
                    let (low, high) = (&below[i + r - 1], &above[i]);
                    let given = i + r == p && a == low;
                    if !given && (i > 0 || joined.is_none()) {
                        let (front, back) = c.split_at_mut(i + 1);
                        let [left, right] = parts(low, a, high);
                        blend(&mut front[i], &left, &right, &back[0]);
                    }
                }
            }
            if let Some(joined) = joined {
                c[0] = joined.clone();
            }
            let shares: [[T; 2]; ORDER] =
                std::array::from_fn(|l| parts(a, b, if l < p { &above[l] } else { b }));
            for r in 1..ORDER {
                for i in (r..ORDER).rev() {
                    if i > r || *b != above[0] {
                        let (front, back) = c.split_at_mut(i);
                        let [left, right] = &shares[i - r];
                        blend(&mut back[0], right, left, &front[i - 1]);
                    }
                }
            }
            pieces.extend(c);
        }
        pieces
    }
}

/// The weights of `low` and `high` in `x` between them.
#[inline(always)]
fn parts<T: Scalar>(low: &T, x: &T, high: &T) -> [T; 2] {
    let inverse = T::one() / (high.clone() - low);
    [(high.clone() - x) * &inverse, (x.clone() - low) * inverse]
}

#[inline(always)]
fn blend<T: Scalar, C: Coeff<T>>(value: &mut C, own: &T, weight: &T, other: &C) {
    value.scale(own);
    value.add_scaled(weight, other);
}
