//! Evaluators of splines of one variable.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::limits::check_dim;
use crate::prepared::evaluate::Evaluate;
use crate::prepared::index::SpanIndex;
use crate::prepared::powers::{
    Centring, LEAST, Local, POWERS, check_finite, derivatives, single_derivatives, single_value, value,
};
use crate::scalar::Scalar;
use crate::spline::Spline;

/// How many parameters are tried together for one span.
const GROUP: usize = 32;

/// A spline prepared for values at many parameters, made by [`Spline::evaluator`].
///
/// # Examples
/// ```
/// use symspline::{Evaluate, Function, SplineSpace};
/// let space = SplineSpace::clamped(2, [0.0, 1.0, 2.0])?;
/// let evaluator = Function::new(space, vec![0.0, 2.0, 2.0, 0.0])?.evaluator()?;
/// assert_eq!(evaluator.eval(&[2.0, 0.5, 1.0])?, [0.0, 1.5, 2.0]);
/// assert_eq!(evaluator.derivatives_at::<2>(&0.0)?, [0.0, 4.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Evaluator<T, C> {
    spans: SpanIndex<T>,
    pieces: Pieces<T, C>,
}

/// The polynomials of the spans.
#[derive(Clone, Debug)]
enum Pieces<T, C> {
    /// In powers, `order` coefficients a span.
    Powers { order: usize, locals: Vec<Local<T>>, coeffs: Vec<C> },
    /// Of high degree: as they are, with the index of the knot at the start of every span.
    Plain { spline: Spline<T, C>, starts: Vec<usize> },
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The spline prepared for many values.
    ///
    /// Up to degree 8 every span becomes a polynomial in powers about its middle, `p + 1` coefficients a span. In `f64` a value
    /// is then off by at most `4 (p + 1) 2^p ε` times the largest coefficient under the span, where `ε = 2^-52`, and a derivative of
    /// order `d` by `(2 p / w)^d` times as much on a span of length `w`. Of higher degrees only the search for spans is prepared.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite) for coefficients so large that those of powers overflow or nearly do;
    /// [`TooLarge`](crate::Error::TooLarge).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Evaluate, Function, Q, Scalar};
    /// let cube = Function::monomial(3, Q::int(0), Q::int(2))?.evaluator()?;
    /// assert_eq!(cube.at(&Q::frac(1, 3))?, Q::frac(1, 27));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn evaluator(&self) -> Result<Evaluator<T, C>> {
        let p = self.degree();
        if p > POWERS {
            return self.plain_evaluator();
        }
        let spans = SpanIndex::new(self.space());
        let locals = Local::of_spans(spans.breaks());
        let order = LEAST.max(p + 1);
        check_dim(locals.len().saturating_mul(order))?;
        let pieces = self.bernstein(spans.breaks())?;
        let mut coeffs: Vec<C> = Vec::with_capacity(locals.len() * order);
        let mut centring = Centring::new(p);
        for piece in pieces.chunks(p + 1) {
            let first = coeffs.len();
            coeffs.extend_from_slice(piece);
            centring.centre(&mut coeffs, first, 1);
            coeffs.resize(first + order, piece[0].zero_like());
        }
        check_finite(&coeffs)?;
        Ok(Evaluator { spans, pieces: Pieces::Powers { order, locals, coeffs } })
    }

    /// The evaluator that keeps the spline as it is and prepares only the search for spans.
    pub(crate) fn plain_evaluator(&self) -> Result<Evaluator<T, C>> {
        let spans = SpanIndex::new(self.space());
        let starts = spans.breaks()[..spans.breaks().len() - 1].iter().map(|x| self.space().locate(x));
        let pieces = Pieces::Plain { spline: self.clone(), starts: starts.collect::<Result<_>>()? };
        Ok(Evaluator { spans, pieces })
    }
}

impl<T: Scalar, C: Coeff<T>> Evaluator<T, C> {
    #[inline(always)]
    fn on_span(&self, span: usize, x: &T) -> C {
        match &self.pieces {
            Pieces::Powers { order, locals, coeffs } => {
                let s = locals[span].parameter(x);
                single_value(&coeffs[span * order..][..*order], &s)
            }
            Pieces::Plain { spline, starts } => spline.on_span(starts[span], x),
        }
    }

    #[inline(always)]
    fn derivatives_on_span<const COUNT: usize>(&self, span: usize, x: &T) -> [C; COUNT] {
        match &self.pieces {
            Pieces::Powers { order, locals, coeffs } => {
                let (s, slope) = (locals[span].parameter(x), locals[span].slope());
                single_derivatives(&coeffs[span * order..][..*order], &s, slope)
            }
            Pieces::Plain { spline, starts } => {
                let mut all = spline.derivatives_on(starts[span], x, COUNT.saturating_sub(1)).into_iter();
                std::array::from_fn(|_| all.next().expect("one derivative an order"))
            }
        }
    }

    /// Calls `take` with the values of polynomials of `ORDER` coefficients.
    fn for_each_of<const ORDER: usize>(
        &self,
        (locals, coeffs): (&[Local<T>], &[C]),
        parameters: &[T],
        take: impl FnMut(C),
    ) -> Result<()> {
        let (pieces, _) = coeffs.as_chunks::<ORDER>();
        let piece = |span: usize| (&pieces[span], &locals[span]);
        self.walk(parameters, piece, |(piece, local), x| value(*piece, &local.parameter(x)), take)
    }

    /// Calls `take` with what `value` makes of each parameter and the `piece` of its span.
    #[inline(always)]
    fn walk<P, V>(
        &self,
        parameters: &[T],
        piece: impl Fn(usize) -> P,
        value: impl Fn(&P, &T) -> V,
        mut take: impl FnMut(V),
    ) -> Result<()> {
        for group in parameters.chunks(GROUP) {
            let span = self.spans.locate(&group[0])?;
            // A last one outside the domain is met in its turn.
            let end = self.spans.locate(&group[group.len() - 1]).unwrap_or(span);
            if span.abs_diff(end) > GROUP / 8 {
                // In no order: whether a span holds the next parameter too is not worth a question.
                for x in group {
                    take(value(&piece(self.spans.locate(x)?), x));
                }
                continue;
            }
            let (mut ends, mut here) = (self.spans.ends(span), piece(span));
            for x in group {
                if !(ends.0 <= x && x < ends.1) {
                    let span = self.spans.locate(x)?;
                    (ends, here) = (self.spans.ends(span), piece(span));
                }
                take(value(&here, x));
            }
        }
        Ok(())
    }
}

impl<T: Scalar, C: Coeff<T>> Evaluate for Evaluator<T, C> {
    type Parameter = T;
    type Value = C;
    type Derivatives<const COUNT: usize> = [C; COUNT];

    #[inline(always)]
    fn at(&self, x: &T) -> Result<C> {
        Ok(self.on_span(self.spans.locate(x)?, x))
    }

    #[inline(always)]
    fn derivatives_at<const COUNT: usize>(&self, x: &T) -> Result<[C; COUNT]> {
        Ok(self.derivatives_on_span(self.spans.locate(x)?, x))
    }

    fn for_each(&self, parameters: &[T], take: impl FnMut(C)) -> Result<()> {
        let Pieces::Powers { order, locals, coeffs } = &self.pieces else {
            return self.walk(parameters, |span| span, |span, x| self.on_span(*span, x), take);
        };
        let table = (locals.as_slice(), coeffs.as_slice());
        match order {
            4 => self.for_each_of::<4>(table, parameters, take),
            5 => self.for_each_of::<5>(table, parameters, take),
            6 => self.for_each_of::<6>(table, parameters, take),
            _ => self.walk(parameters, |span| span, |span, x| self.on_span(*span, x), take),
        }
    }

    fn for_each_derivatives<const COUNT: usize>(
        &self,
        parameters: &[T],
        take: impl FnMut([C; COUNT]),
    ) -> Result<()> {
        match &self.pieces {
            Pieces::Powers { order: 4, locals, coeffs } => {
                let (pieces, _) = coeffs.as_chunks::<4>();
                let piece = |span: usize| (&pieces[span], &locals[span]);
                let all = |(piece, local): &(&[C; 4], &Local<T>), x: &T| {
                    derivatives(piece.iter(), &local.parameter(x), local.slope())
                };
                self.walk(parameters, piece, all, take)
            }
            _ => self.walk(parameters, |span| span, |span, x| self.derivatives_on_span(*span, x), take),
        }
    }
}
