//! The same spline with its degree raised.
//!
//! Coefficient `j` one degree higher is the mean of the `p + 1` polar values that leave out one of the knots
//! `τ_{j+1}, ..., τ_{j+p+1}` of the raised space [Ramshaw, 1989]:
//!
//! ```text
//! d_j = 1 / (p + 1) Σ_i F(τ_{j+1}, ..., τ_{j+1+p} without τ_{j+1+i})
//! ```
//!
//! Copies of a knot count together. Most of the other arguments are knots around the span, which cost nothing, and the
//! rest lie between them, so that every step is a convex combination. Several degrees are raised one by one.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::map::LinearMap;
use crate::ops::run::Run;
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar> SplineSpace<T> {
    /// The rows into `raised`, this space elevated by one: means of polar values that leave out one knot.
    pub(crate) fn elevation_rows(&self, raised: &Self) -> LinearMap<T> {
        self.first_elevation_rows(raised, raised.dim())
    }

    /// The first `count` of the [rows](Self::elevation_rows).
    fn first_elevation_rows(&self, raised: &Self, count: usize) -> LinearMap<T> {
        let (p, tau) = (self.degree(), raised.knots());
        let mut map = LinearMap::empty(self.dim(), count);
        let (mut args, mut free) = (Vec::with_capacity(p), Vec::with_capacity(p));
        let (mut row, mut part) = (vec![T::zero(); p + 1], Vec::with_capacity(p + 1));
        let mut walk = SpanWalk::new(self);
        for j in 0..count {
            let k = walk.span_right_of(larger(&tau[j], raised.domain().0));
            let knots = &tau[j + 1..=j + p + 1];
            let (mut low, mut high) = (p, 0);
            args.clear();
            args.extend(&knots[1..]);
            let mut skip = 0;
            for copies in knots.chunk_by(T::eq) {
                part.clear();
                let first = self.polar_into(k, &args, &mut free, &mut part) + p - k;
                let count = T::int(copies.len() as i64);
                part.iter().enumerate().for_each(|(l, w)| row[first + l] += count.clone() * w);
                (low, high) = (low.min(first), high.max(first + part.len()));
                // The next to leave out comes after these copies.
                let passed = skip..(skip + copies.len()).min(p);
                args[passed.clone()].iter_mut().zip(&knots[passed]).for_each(|(arg, t)| *arg = t);
                skip += copies.len();
            }
            map.push(k - p + low, |weights| {
                let mean = |sum: &mut T| std::mem::replace(sum, T::zero()) / T::int(p as i64 + 1);
                weights.extend(row[low..high].iter_mut().map(mean));
            });
        }
        map
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The same function with its degree raised by `raise`; see [`SplineSpace::elevated`] for the knots.
    ///
    /// # Errors
    /// As [`SplineSpace::elevated`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let line = Function::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![1.0, 4.0])?;
    /// assert_eq!(line.elevated(1)?.coeffs(), [1.0, 2.5, 4.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "degree elevation")]
    pub fn elevated(&self, raise: usize) -> Result<Self> {
        self.space().check_elevation(raise)?;
        (0..raise).try_fold(self.clone(), |f, _| {
            let space = f.space().elevated(1)?;
            let coeffs = f.space().elevated_coeffs(&space, f.coeffs())?;
            Spline::new(space, coeffs)
        })
    }
}

impl<T: Scalar> SplineSpace<T> {
    /// The coefficients in `raised`, this space elevated by one, of the spline with `coeffs` here: those of
    /// [`elevation_rows`](Self::elevation_rows), in low degrees without a table.
    fn elevated_coeffs<C: Coeff<T>>(&self, raised: &Self, coeffs: &[C]) -> Result<Vec<C>> {
        // Coefficients on the heap are better summed up once than value by value.
        match self.degree() {
            _ if std::mem::needs_drop::<C>() => self.elevation_rows(raised).apply(coeffs),
            1 => self.elevated_of_order::<2, C>(raised, coeffs),
            2 => self.elevated_of_order::<3, C>(raised, coeffs),
            3 => self.elevated_of_order::<4, C>(raised, coeffs),
            4 => self.elevated_of_order::<5, C>(raised, coeffs),
            5 => self.elevated_of_order::<6, C>(raised, coeffs),
            _ => self.elevation_rows(raised).apply(coeffs),
        }
    }

    /// [`elevated_coeffs`](Self::elevated_coeffs) for `ORDER = p + 1` known to the compiler.
    ///
    /// From the domain's start on, the knots of a coefficient are a run of knots of this space, and one free copy more of each
    /// but perhaps the first and the last. To leave out a knot is to leave out its free copy or one end of the run. The
    /// polar value without the first knot is the next coefficient's without the last.
    fn elevated_of_order<const ORDER: usize, C: Coeff<T>>(
        &self,
        raised: &Self,
        coeffs: &[C],
    ) -> Result<Vec<C>> {
        let (t, tau, start) = (self.knots(), raised.knots(), raised.domain().0);
        let before = tau[..ORDER].iter().take_while(|x| *x < start).count().min(raised.dim());
        let mut elevated = self.first_elevation_rows(raised, before).apply(coeffs)?;
        elevated.reserve_exact(raised.dim() - before);
        let shares: [T; ORDER] = std::array::from_fn(|i| T::frac(i as i64 + 1, ORDER as i64));
        let mut run = Run::<T, ORDER>::new(t, ORDER - 1, &tau[before + 1..=before + ORDER]);
        let mut shared: Option<C> = None;
        for j in before..raised.dim() {
            let knots: &[T; ORDER] = tau[j + 1..].first_chunk().expect("every coefficient has its knots");
            let copies = |i: usize| knots[i..].iter().take_while(|x| **x == knots[i]).count();
            let mut passed = 0;
            let mut without = |skip: usize| {
                if run.is_free(passed, &knots[skip]) {
                    passed += 1;
                    return run.polar_without_free(passed - 1, coeffs);
                }
                let at_left_end = skip == 0 && knots[0] != knots[ORDER - 1];
                if at_left_end { run.polar_without_first(coeffs) } else { run.polar_without_last(coeffs) }
            };
            let mut skip = copies(0);
            let head = without(0);
            let mut sum = head.scaled(&shares[skip - 1]);
            while skip < ORDER {
                let count = copies(skip);
                let tail = if skip + count == ORDER { shared.take() } else { None };
                sum.add_scaled(&shares[count - 1], &tail.unwrap_or_else(|| without(skip)));
                skip += count;
            }
            // If the next row starts at another knot, its arguments hold all copies of that knot, so that both sides agree.
            shared = Some(head);
            elevated.push(sum);
            if let Some(next) = tau.get(j + ORDER + 1) {
                run.advance(&knots[0], next);
            }
        }
        Ok(elevated)
    }
}

/// Walks the spans of a space from left to right beside another ascending sequence.
pub(crate) struct SpanWalk<'a, T> {
    knots: &'a [T],
    span: usize,
    last: usize,
}

impl<'a, T: Scalar> SpanWalk<'a, T> {
    pub(crate) fn new(space: &'a SplineSpace<T>) -> Self {
        Self { knots: space.knots(), span: space.degree(), last: space.last_span() }
    }

    /// The span that holds what is right of `x`; `x` must not decrease from call to call.
    pub(crate) fn span_right_of(&mut self, x: &T) -> usize {
        while self.span < self.last && self.knots[self.span + 1] <= *x {
            self.span += 1;
        }
        self.span
    }
}
