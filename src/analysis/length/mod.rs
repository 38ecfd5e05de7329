//! Arc length with a proof, and its inverse.
//!
//! ```text
//! L(x) = ∫ |C'|        from the start of the domain to x
//! ```
//!
//! The length has no closed form, but each piece of a curve has a speed that is analytic away from the places where the
//! curve stands still. So Gauss rules converge geometrically, and a bound of the speed in the complex plane bounds
//! their error. A curve is cut into parts on which such a bound is small enough; where there is none, next to a place
//! where it stands still, chord and control polygon enclose what is left.
//!
//! Where a curve jumps, the jump counts nothing: the length is that of the pieces.

pub(crate) mod gauss;
mod jet;
mod piece;
mod source;
mod measure;
mod inverse;

use crate::error::{Error, Result};
use crate::limits::check_dim;
use crate::rational::spline::NurbsCurve;
use crate::spline::Curve;
use jet::UNIT;
use measure::{Part, Parts, measure};
use piece::Degree;
use source::{Span, polynomial_spans, rational_spans};

/// The arc length of a curve, prepared: the total with a certified bound, the length up to a parameter, and the
/// parameter at a length.
///
/// # Examples
/// ```
/// use symspline::{NurbsCurve, circle};
/// use nalgebra::vector;
/// let circle: NurbsCurve<f64, 2> = circle(&vector![5.0, 0.0], &2.0)?;
/// let length = circle.arc_length(&1e-12)?;
/// let turn = std::f64::consts::TAU;
/// assert!((length.total() - 2.0 * turn).abs() <= length.bound() && length.bound() < 1e-11);
/// // Four points at equal distances along the curve, the last one equal to the first.
/// let x = length.evenly(4)?;
/// assert!((circle.at(&x[1])? - vector![5.0, 2.0]).norm() < 1e-12);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct ArcLength<const N: usize> {
    domain: (f64, f64),
    degree: Degree,
    parts: Vec<Part<N>>,
    /// The length up to each part.
    starts: Vec<f64>,
    total: f64,
    bound: f64,
}

impl<const N: usize> Curve<f64, N> {
    /// The arc length, to a relative `accuracy`.
    ///
    /// [`bound`](ArcLength::bound) is what is certified. It is at most `accuracy` times the length, unless rounding
    /// does not allow that (below some `1e-14`, times the degree), or the curve stands still in a great many places.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] unless `accuracy` is positive and finite; [`Error::NotFinite`] if the length overflows;
    /// [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?; // y = x²
    /// let exact = 5_f64.sqrt() + 2_f64.asinh() / 2.0;
    /// let length = parabola.arc_length(&1e-12)?;
    /// assert!((length.total() - exact).abs() <= length.bound() && length.bound() <= 1e-12 * exact);
    /// assert!((length.at(&0.0)? - exact / 2.0).abs() < 1e-14);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn arc_length(&self, accuracy: &f64) -> Result<ArcLength<N>> {
        ArcLength::new(polynomial_spans(self)?, self.degree(), *accuracy)
    }

    /// The length, to a relative `accuracy`: the total of [`arc_length`](Self::arc_length).
    ///
    /// # Errors
    /// As [`arc_length`](Self::arc_length).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 0.0], vector![3.0, 4.0]])?;
    /// assert_eq!(line.length(&1e-6)?, 5.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn length(&self, accuracy: &f64) -> Result<f64> {
        Ok(self.arc_length(accuracy)?.total())
    }
}

impl<const N: usize> NurbsCurve<f64, N> {
    /// The arc length, as that of a [polynomial curve](Curve::arc_length).
    ///
    /// # Errors
    /// As [`Curve::arc_length`]; [`Error::Undecided`] if the denominator is too close to zero somewhere.
    pub fn arc_length(&self, accuracy: &f64) -> Result<ArcLength<N>> {
        ArcLength::new(rational_spans(self.lifted())?, self.degree(), *accuracy)
    }

    /// The length, to a relative `accuracy`: the total of [`arc_length`](Self::arc_length).
    ///
    /// # Errors
    /// As [`arc_length`](Self::arc_length).
    pub fn length(&self, accuracy: &f64) -> Result<f64> {
        Ok(self.arc_length(accuracy)?.total())
    }
}

impl<const N: usize> ArcLength<N> {
    fn new(spans: Vec<Span<N>>, p: usize, accuracy: f64) -> Result<Self> {
        if !accuracy.is_finite() || accuracy <= 0.0 {
            return Err(Error::BadTolerance { tolerance: accuracy.to_string() });
        }
        let domain = (spans[0].ends.0, spans[spans.len() - 1].ends.1);
        let degree = Degree::new(p);
        let Parts { parts, bound } = measure(spans, &degree, p, accuracy)?;
        // Compensated: what each sum loses is kept.
        let (mut sum, mut lost, mut starts) = (0.0, 0.0, Vec::with_capacity(parts.len()));
        for part in &parts {
            starts.push(sum + lost);
            let next: f64 = sum + part.length;
            lost += if sum >= part.length { sum - next + part.length } else { part.length - next + sum };
            sum = next;
        }
        let total = sum + lost;
        if !total.is_finite() {
            return Err(Error::NotFinite { what: "length", index: 0 });
        }
        Ok(Self { domain, degree, parts, starts, total, bound: bound + 4.0 * UNIT * total })
    }

    /// The length of the whole curve.
    pub fn total(&self) -> f64 {
        self.total
    }

    /// How far [`total`](Self::total) is off at most, rounding included.
    ///
    /// That of [`at`](Self::at) and [`parameter_at`](Self::parameter_at) is no larger, but for the rounding of the
    /// parameter itself, which moves along the curve by the speed there.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// Start and end of the domain of the curve.
    pub fn domain(&self) -> (f64, f64) {
        self.domain
    }

    /// The length from the start of the domain to `x`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 3.0])?;
    /// let corner = Curve::new(space, vec![vector![0.0, 0.0], vector![1.0, 0.0], vector![1.0, 4.0]])?;
    /// let length = corner.arc_length(&1e-9)?;
    /// assert_eq!((length.at(&1.0)?, length.at(&2.0)?, length.total()), (1.0, 3.0, 5.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn at(&self, x: &f64) -> Result<f64> {
        let (a, b) = self.domain;
        if !(*x >= a && *x <= b) {
            return Err(outside(*x, self.domain));
        }
        if *x == b {
            return Ok(self.total);
        }
        let part = self.parts.partition_point(|part| part.local(*x) >= 0.0) - 1;
        Ok(self.within(part, self.parts[part].local(*x)))
    }

    /// The parameter up to which the curve has the length `s`.
    ///
    /// Where the curve stands still for a while, which of the parameters is not said; but length zero is the start of
    /// the domain, and the total, if it is not zero, its end.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`] unless `s` is between zero and the total.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![0.0, 0.0], vector![9.0, 0.0]];
    /// let start = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?; // 9 x²
    /// assert!((start.arc_length(&1e-12)?.parameter_at(&1.0)? - 1.0 / 3.0).abs() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn parameter_at(&self, s: &f64) -> Result<f64> {
        if !(*s >= 0.0 && *s <= self.total) {
            return Err(outside(*s, (0.0, self.total)));
        }
        Ok(match *s {
            0.0 => self.domain.0,
            s if s == self.total => self.domain.1,
            s => self.inverse(s),
        })
    }

    /// The parameters of `count + 1` points that divide the curve into `count` parts of equal length, both ends
    /// included.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`] if `count` is zero; [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let space = SplineSpace::clamped(1, [0.0, 1.0, 3.0])?;
    /// let corner = Curve::new(space, vec![vector![0.0, 0.0], vector![1.0, 0.0], vector![1.0, 4.0]])?;
    /// assert_eq!(corner.arc_length(&1e-9)?.evenly(5)?, [0.0, 1.0, 1.5, 2.0, 2.5, 3.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn evenly(&self, count: usize) -> Result<Vec<f64>> {
        if count == 0 {
            return Err(Error::TooFewPoints { expected: 2, found: 1 });
        }
        check_dim(count.saturating_add(1))?;
        let inner = (1..count).map(|i| self.inverse(self.total * (i as f64 / count as f64)));
        // By rounding two parameters might be in the wrong order.
        let ascending = inner.scan(self.domain.0, |last, x| {
            *last = last.max(x);
            Some(*last)
        });
        Ok([self.domain.0].into_iter().chain(ascending).chain([self.domain.1]).collect())
    }
}

fn outside(x: f64, (start, end): (f64, f64)) -> Error {
    Error::OutsideDomain { parameter: x.to_string(), start: start.to_string(), end: end.to_string() }
}
