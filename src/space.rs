//! Spline spaces: a degree, knots, and how the ends meet.
//!
//! ```text
//! open      t_0 <= ... <= t_{n+p+1}, coefficients c_0 ... c_n, domain [t_p, t_{n+1}]
//! periodic  the same with t_{i+m} = t_i + period and c_{i+m} = c_i: m coefficients
//! ```
//!
//! A periodic space stores its knots unrolled, as an open one with the last `p` coefficients wrapped. So one text
//! walks the spans of both, and only [`SplineSpace::slot`] knows which coefficients coincide.

use crate::error::{Error, Result};
use crate::knots::KnotVector;
use crate::limits::{check_degree, check_dim};
use crate::scalar::Scalar;

/// The splines of one degree over one knot vector.
///
/// A value: spaces are compared, elevated, united and multiplied without any spline at hand. Cloning shares the
/// knots.
///
/// - The domain is `[t_p, t_{n+1}]`, clamped or not.
/// - A knot inside may have up to `p + 1` copies; `p + 1` is a jump. A knot at an end has at most `p + 1`.
/// - Every coefficient matters: `t_p < t_{p+1}` and `t_n < t_{n+1}`.
///
/// # Examples
/// ```
/// use symspline::SplineSpace;
/// let cubic = SplineSpace::clamped(3, [0.0, 1.0, 2.0, 4.0])?;
/// assert_eq!((cubic.degree(), cubic.dim()), (3, 6));
/// assert_eq!(cubic.domain(), (&0.0, &4.0));
/// let ring = SplineSpace::periodic(2, [0.0, 1.0, 2.0], 4.0)?;
/// assert_eq!(ring.dim(), 3);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct SplineSpace<T> {
    degree: usize,
    knots: KnotVector<T>,
    dim: usize,
    periodic: bool,
}

impl<T: Scalar> SplineSpace<T> {
    /// The open space over a full knot vector, `n + p + 2` knots for `n + 1` coefficients.
    ///
    /// # Errors
    /// [`Error::DegreeTooHigh`], [`Error::NotFinite`], [`Error::KnotsDecrease`], [`Error::TooFewKnots`],
    /// [`Error::EmptyDomain`], [`Error::Multiplicity`]; [`Error::UnusedCoefficient`] if the first or last coefficient
    /// would have no influence on the domain; [`Error::SpanOutOfRange`] if in `f64` the length of a span or of the whole
    /// has no finite inverse.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, SplineSpace};
    /// let unclamped = SplineSpace::new(2, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0])?;
    /// assert_eq!(unclamped.domain(), (&2.0, &3.0));
    /// let torn = SplineSpace::new(1, [0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0]);
    /// assert!(matches!(torn, Err(Error::Multiplicity { multiplicity: 3, limit: 2, .. })));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn new(degree: usize, knots: impl IntoIterator<Item = T>) -> Result<Self> {
        check_degree(degree)?;
        Self::over(degree, KnotVector::new(knots)?)
    }

    /// The open space over a knot vector at hand.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// # Examples
    /// ```
    /// use symspline::{KnotVector, SplineSpace};
    /// let knots = KnotVector::new([0.0, 0.0, 1.0, 1.0])?;
    /// assert_eq!(SplineSpace::over(1, knots)?, SplineSpace::bezier(1, 0.0, 1.0)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn over(degree: usize, knots: KnotVector<T>) -> Result<Self> {
        check_degree(degree)?;
        if knots.len() < 2 * degree + 2 {
            return Err(Error::TooFewKnots { expected: 2 * degree + 2, found: knots.len() });
        }
        let dim = knots.len() - degree - 1;
        check_dim(dim)?;
        let space = Self { degree, knots, dim, periodic: false };
        space.check_knots()?;
        let t = space.knots();
        if t[degree] == t[degree + 1] {
            return Err(Error::UnusedCoefficient { index: 0 });
        }
        if t[dim - 1] == t[dim] {
            return Err(Error::UnusedCoefficient { index: dim - 1 });
        }
        Ok(space)
    }

    /// The open space with clamped ends over `breaks`: the two ends once, the knots inside as often as they count.
    ///
    /// # Errors
    /// As [`new`](Self::new), and [`Error::TooFewKnots`] for fewer than two breaks.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 1.0, 2.0])?;
    /// assert_eq!(space.knots().as_slice(), [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn clamped(degree: usize, breaks: impl IntoIterator<Item = T>) -> Result<Self> {
        check_degree(degree)?;
        let breaks = KnotVector::new(breaks)?;
        let (Some(a), Some(b), true) = (breaks.first(), breaks.last(), breaks.len() > 1) else {
            return Err(Error::TooFewKnots { expected: 2, found: breaks.len() });
        };
        let end = |t: &T| std::iter::repeat_n(t.clone(), degree);
        Self::new(degree, end(a).chain(breaks.iter().cloned()).chain(end(b)))
    }

    /// The polynomials of `degree` on `[a, b]`: one span, clamped.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// assert_eq!(SplineSpace::bezier(3, 0.0, 1.0)?.dim(), 4);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn bezier(degree: usize, a: T, b: T) -> Result<Self> {
        check_degree(degree)?;
        let end = |t: T| std::iter::repeat_n(t, degree + 1);
        Self::new(degree, end(a).chain(end(b)))
    }

    /// The clamped space with `spans` equal spans on `[a, b]`.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::TooLarge`] for more than [`MAX_DIM`](crate::limits::MAX_DIM) spans.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, SplineSpace};
    /// let space = SplineSpace::uniform(1, 3, Q::int(0), Q::int(1))?;
    /// assert_eq!(space, SplineSpace::clamped(1, [Q::int(0), Q::frac(1, 3), Q::frac(2, 3), Q::int(1)])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn uniform(degree: usize, spans: usize, a: T, b: T) -> Result<Self> {
        check_dim(spans)?;
        Self::clamped(degree, (0..=spans).map(|i| even(&a, &b, i, spans)))
    }

    /// The periodic space with `spans` equal spans on `[a, b]`.
    ///
    /// # Errors
    /// As [`periodic`](Self::periodic); [`Error::TooLarge`] for more than [`MAX_DIM`](crate::limits::MAX_DIM) spans.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// assert_eq!(SplineSpace::uniform_periodic(3, 8, 0.0, 1.0)?.dim(), 8);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn uniform_periodic(degree: usize, spans: usize, a: T, b: T) -> Result<Self> {
        check_dim(spans)?;
        if spans == 0 {
            return Err(Error::TooFewKnots { expected: 1, found: 0 });
        }
        let knots = (0..spans).map(|i| even(&a, &b, i, spans));
        Self::joined(degree, &KnotVector::new(knots)?, b.clone())
    }

    /// The periodic space whose `knots` run once round from the seam, the seam itself at the start only:
    /// `knots[0] <= ... <= knots[m - 1] < knots[0] + period`. It has `m` coefficients.
    ///
    /// The domain is `[knots[0], knots[0] + period]`; coefficient `i` is the one with support from knot `t_i` of
    /// [`knots`](Self::knots), where `t_p` is the last copy of the seam.
    ///
    /// In `f64` the knots beyond the domain are rounded sums, `knot + k * period`: with spans shorter than the rounding of
    /// the period, relative to them, the space is not quite periodic.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::EmptyDomain`] if a knot lies a period or more after the first;
    /// [`Error::SpanOutOfRange`] if knots beyond the domain fall together by rounding.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let ring = SplineSpace::periodic(2, [0.0, 1.0, 3.0], 4.0)?;
    /// assert_eq!((ring.dim(), ring.domain()), (3, (&0.0, &4.0)));
    /// assert_eq!(ring.knots().as_slice(), [-3.0, -1.0, 0.0, 1.0, 3.0, 4.0, 5.0, 7.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn periodic(degree: usize, knots: impl IntoIterator<Item = T>, period: T) -> Result<Self> {
        let round = KnotVector::new(knots)?;
        match round.first() {
            Some(a) => Self::joined(degree, &round, a.clone() + period),
            None => Err(Error::TooFewKnots { expected: 1, found: 0 }),
        }
    }

    /// The periodic space whose knots run once round from the seam, which comes again at `end`.
    pub(crate) fn joined(degree: usize, round: &KnotVector<T>, end: T) -> Result<Self> {
        check_degree(degree)?;
        check_dim(round.len())?;
        let (m, a) = (round.len(), &round[0]);
        if !end.is_finite() || round[m - 1] >= end {
            return Err(Error::EmptyDomain { start: a.to_string(), end: end.to_string() });
        }
        let seam = round.iter().take_while(|t| *t == a).count();
        if seam > degree + 1 {
            return Err(Error::Multiplicity { knot: a.to_string(), multiplicity: seam, limit: degree + 1 });
        }
        // Unrolled index j stands `shift` knots before the seam's first copy.
        let shift = (degree + 1 - seam) as i64;
        let period = end.clone() - a;
        let unrolled = (0..(m + 2 * degree + 1) as i64).map(|j| {
            let (turns, i) = ((j - shift).div_euclid(m as i64), (j - shift).rem_euclid(m as i64) as usize);
            match turns {
                0 => round[i].clone(),
                // The end of the domain is what was given, not a rounded sum.
                1 if i < seam => end.clone(),
                _ => round[i].clone() + period.clone() * T::int(turns),
            }
        });
        let space = Self { degree, knots: KnotVector::new(unrolled)?, dim: m, periodic: true };
        // Rounding may not make knots fall together a period away that are distinct here.
        let same = |j: usize| space.knots[j] == space.knots[j + 1];
        if let Some(index) = (0..2 * degree).find(|&j| same(j) != same(j + m)) {
            return Err(Error::SpanOutOfRange { index });
        }
        space.check_knots()?;
        Ok(space)
    }

    fn check_knots(&self) -> Result<()> {
        let (t, (a, b)) = (self.knots(), self.domain());
        if a >= b {
            return Err(Error::EmptyDomain { start: a.to_string(), end: b.to_string() });
        }
        let reach = t[t.len() - 1].clone() - &t[0];
        let narrow = if T::EXACT { None } else { t.narrow_span() };
        if let Some(index) = narrow.or((!reach.is_finite()).then_some(0)) {
            return Err(Error::SpanOutOfRange { index });
        }
        let limit = self.degree + 1;
        let crowded = t.iter().zip(&t[limit..]).fold(false, |any, (first, beyond)| any | (first == beyond));
        match crowded.then(|| t.chunk_by(T::eq).find(|copies| copies.len() > limit)).flatten() {
            Some(copies) => {
                Err(Error::Multiplicity { knot: copies[0].to_string(), multiplicity: copies.len(), limit })
            }
            None => Ok(()),
        }
    }

    /// The degree.
    #[inline]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The full knot vector; of a periodic space unrolled, `m + 2p + 1` knots for `m` coefficients.
    #[inline]
    pub fn knots(&self) -> &KnotVector<T> {
        &self.knots
    }

    /// The number of coefficients.
    #[inline]
    pub fn dim(&self) -> usize {
        self.dim
    }

    /// The number of coefficients before any coincide; greater than [`dim`](Self::dim) only in periodic spaces.
    #[inline]
    pub(crate) fn unrolled_dim(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// Where coefficient `i` of the unrolled space is stored.
    #[inline]
    pub fn slot(&self, i: usize) -> usize {
        if i < self.dim { i } else { i % self.dim }
    }

    /// Whether the ends are joined.
    #[inline]
    pub fn is_periodic(&self) -> bool {
        self.periodic
    }

    /// Whether both ends carry `p + 1` knots, so that the first and last coefficient are the end values.
    pub fn is_clamped(&self) -> bool {
        let (t, last) = (self.knots(), self.unrolled_dim());
        !self.is_periodic() && t[0] == t[self.degree] && t[last] == t[last + self.degree]
    }

    /// Start and end of the domain.
    #[inline]
    pub fn domain(&self) -> (&T, &T) {
        (&self.knots[self.degree], &self.knots[self.unrolled_dim()])
    }

    /// The length of the domain.
    pub(crate) fn length(&self) -> T {
        let (a, b) = self.domain();
        b.clone() - a
    }

    /// The indices `k` of the non-empty spans `[t_k, t_{k+1}]` of the domain, in order.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 1.0, 2.0])?;
    /// assert_eq!(space.spans().collect::<Vec<_>>(), [1, 3]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn spans(&self) -> impl Iterator<Item = usize> + '_ {
        (self.degree..self.unrolled_dim()).filter(|&k| self.knots[k] < self.knots[k + 1])
    }

    /// The distinct knots of the domain with their multiplicities, both ends included.
    ///
    /// At the ends all copies count, outside the domain too; in a periodic space both ends show the seam's.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 1.0, 2.0])?;
    /// assert_eq!(space.breaks(), [(0.0, 3), (1.0, 2), (2.0, 3)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn breaks(&self) -> Vec<(T, usize)> {
        let (a, b) = self.domain();
        let inside = |copies: &&[T]| *a <= copies[0] && copies[0] <= *b;
        let chunks = self.knots.chunk_by(T::eq).filter(inside);
        chunks.map(|copies| (copies[0].clone(), copies.len())).collect()
    }

    /// The Greville abscissae `(t_{i+1} + ... + t_{i+p}) / p`: the coefficients of the function `x` (of degree 0:
    /// the middles of the spans).
    ///
    /// In a periodic space they are those of the unrolled coefficients `0 .. m`, and may lie left of the domain.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// assert_eq!(SplineSpace::clamped(2, [0.0, 1.0, 3.0])?.greville(), [0.0, 0.5, 2.0, 3.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn greville(&self) -> Vec<T> {
        (0..self.dim).map(|i| self.mean_of_knots(i)).collect()
    }

    /// The Greville abscissa of the unrolled coefficient `i`.
    pub(crate) fn mean_of_knots(&self, i: usize) -> T {
        let t = self.knots();
        match self.degree {
            0 => t[i].clone() + (t[i + 1].clone() - &t[i]) / T::int(2),
            // From the first of them, so that no sum overflows.
            p => {
                let rises = t[i + 1..=i + p].iter().fold(T::zero(), |sum, x| sum + (x.clone() - &t[i + 1]));
                t[i + 1].clone() + rises / T::int(p as i64)
            }
        }
    }

    /// The last non-empty span.
    #[inline]
    pub(crate) fn last_span(&self) -> usize {
        let (t, end) = (self.knots(), self.unrolled_dim());
        let mut k = end - 1;
        while t[k] == t[end] {
            k -= 1;
        }
        k
    }

    /// The knots of one period, from the first copy of the seam.
    pub(crate) fn round_knots(&self) -> &[T] {
        let first = self.last_span() + 1 - self.dim;
        &self.knots[first..first + self.dim]
    }

    /// Checks that a spline of this space and one of `other` have the same domain.
    pub(crate) fn check_same_domain(&self, other: &Self) -> Result<()> {
        if self.domain() == other.domain() {
            return Ok(());
        }
        let text = |(a, b): (&T, &T)| format!("[{a}, {b}]");
        Err(Error::DomainMismatch { left: text(self.domain()), right: text(other.domain()) })
    }
}

/// Step `i` of `steps` equal ones from `a` to `b`, both ends without rounding.
pub(crate) fn even<T: Scalar>(a: &T, b: &T, i: usize, steps: usize) -> T {
    if i == steps { b.clone() } else { a.clone() + (b.clone() - a) * T::frac(i as i64, steps.max(1) as i64) }
}
