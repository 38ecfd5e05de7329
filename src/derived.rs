//! Spaces made from spaces: finer ones, and the smallest ones that hold a sum or a product.

use crate::error::{Error, Result};
use crate::limits::{check_degree, check_dim};
use crate::parts::Parts;
use crate::scalar::Scalar;
use crate::space::SplineSpace;

impl<T: Scalar> SplineSpace<T> {
    /// The space with more knots inside, each of `knots` adding one to the multiplicity there.
    ///
    /// In a periodic space the seam, that is the start of the domain, counts as inside.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::OutsideDomain`] for a knot not strictly inside, [`Error::Multiplicity`],
    /// [`Error::TooLarge`]; [`Error::SpanOutOfRange`] if knots come too near for floating point.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 2.0])?;
    /// assert_eq!(space.refined(&[0.5, 1.0])?, SplineSpace::clamped(2, [0.0, 0.5, 1.0, 1.0, 2.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn refined(&self, knots: &[T]) -> Result<Self> {
        check_dim(self.dim().saturating_add(knots.len()))?;
        if let Some(index) = knots.iter().position(|t| !t.is_finite()) {
            return Err(Error::NotFinite { what: "knot", index });
        }
        let (a, b) = self.domain();
        let inside = |t: &T| if self.is_periodic() { a <= t && t < b } else { a < t && t < b };
        if let Some(t) = knots.iter().find(|t| !inside(t)) {
            return Err(Error::OutsideDomain {
                parameter: t.to_string(),
                start: a.to_string(),
                end: b.to_string(),
            });
        }
        let mut added = knots.to_vec();
        added.sort_by(|s, t| s.partial_cmp(t).expect("finite knots are ordered"));
        if self.is_periodic() {
            let added = added.chunk_by(T::eq).map(|copies| (copies[0].clone(), copies.len())).collect();
            let round = merge(self.round(), added, |present, added| present + added);
            return Self::from_round(self.degree(), &round, self.domain().1);
        }
        let (mut all, mut rest) = (Vec::with_capacity(self.knots().len() + added.len()), &self.knots()[..]);
        for t in added {
            let passed = rest.iter().take_while(|knot| **knot <= t).count();
            all.extend_from_slice(&rest[..passed]);
            all.push(t);
            rest = &rest[passed..];
        }
        all.extend_from_slice(rest);
        Self::new(self.degree(), all)
    }

    /// The space with the middle of every span as a further knot.
    ///
    /// # Errors
    /// [`Error::SpanOutOfRange`] if a span is too short to have a middle in the field.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, SplineSpace};
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 3.0])?;
    /// assert_eq!(space.bisected()?, SplineSpace::clamped(2, [0.0, 0.5, 1.0, 2.0, 3.0])?);
    /// let narrow = SplineSpace::bezier(2, 1.0, 1.0 + f64::EPSILON)?;
    /// assert_eq!(narrow.bisected(), Err(Error::SpanOutOfRange { index: 2 }));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn bisected(&self) -> Result<Self> {
        let t = self.knots();
        let middle = |k: usize| {
            let middle = t[k].clone() + (t[k + 1].clone() - &t[k]) / T::int(2);
            let inside = t[k] < middle && middle < t[k + 1];
            if inside { Ok(middle) } else { Err(Error::SpanOutOfRange { index: k }) }
        };
        self.refined(&self.spans().map(middle).collect::<Result<Vec<T>>>()?)
    }

    /// The space of degree `p + raise` that holds this one: every distinct knot gets `raise` more copies, so that
    /// no smoothness is lost and none is gained.
    ///
    /// # Errors
    /// [`Error::DegreeTooHigh`], [`Error::TooLarge`]; [`Error::SpanOutOfRange`] if more knots beyond a periodic domain are
    /// needed and fall together by rounding.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let lines = SplineSpace::clamped(1, [0.0, 1.0, 3.0])?;
    /// assert_eq!(lines.elevated(1)?, SplineSpace::clamped(2, [0.0, 1.0, 1.0, 3.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn elevated(&self, raise: usize) -> Result<Self> {
        if raise == 0 {
            return Ok(self.clone());
        }
        self.check_elevation(raise)?;
        let degree = self.degree() + raise;
        let raised =
            |knots: Vec<(T, usize)>| knots.into_iter().map(|(t, m)| (t, m + raise)).collect::<Vec<_>>();
        if self.is_periodic() {
            return Self::from_round(degree, &raised(self.round()), self.domain().1);
        }
        let Parts { left, inner, right } = self.parts();
        let copies = |knots: &[T]| -> Vec<T> {
            let chunks = knots.chunk_by(T::eq);
            chunks.flat_map(|c| std::iter::repeat_n(c[0].clone(), c.len() + raise)).collect()
        };
        let mut left = copies(&left);
        left.drain(..left.len() - degree - 1);
        let mut right = copies(&right);
        right.truncate(degree + 1);
        Self::from_parts(degree, Parts { left, inner: raised(inner), right })
    }

    /// Refuses to raise the degree beyond sane sizes.
    pub(crate) fn check_elevation(&self, raise: usize) -> Result<()> {
        check_degree(self.degree().saturating_add(raise))?;
        check_dim(self.dim().saturating_add(self.dim().saturating_mul(raise)))
    }

    /// The open space with `p + 1` knots at either end of the same domain.
    ///
    /// # Errors
    /// None beyond those of a valid space.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let ring = SplineSpace::periodic(2, [0.0, 1.0, 3.0], 4.0)?;
    /// assert_eq!(ring.clamped_ends()?, SplineSpace::clamped(2, [0.0, 1.0, 3.0, 4.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn clamped_ends(&self) -> Result<Self> {
        if self.is_clamped() {
            return Ok(self.clone());
        }
        let (a, b) = self.domain();
        let end = |t: &T| vec![t.clone(); self.degree() + 1];
        Self::from_parts(self.degree(), Parts { left: end(a), inner: self.parts().inner, right: end(b) })
    }

    /// The open space whose outer knots repeat the spacing of the domain periodically.
    ///
    /// A periodic space gives the open space over its own unrolled knots, without those past the end that no coefficient
    /// needs.
    ///
    /// # Errors
    /// [`Error::SpanOutOfRange`] if rounding makes outer knots coincide; [`Error::NotFinite`] if they overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let clamped = SplineSpace::clamped(2, [0.0, 1.0, 3.0])?;
    /// assert_eq!(clamped.unclamped_ends()?.knots().as_slice(), [-3.0, -2.0, 0.0, 1.0, 3.0, 4.0, 6.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn unclamped_ends(&self) -> Result<Self> {
        if self.is_periodic() {
            return Self::from_parts(self.degree(), self.parts());
        }
        let mut round = vec![(self.domain().0.clone(), 1)];
        round.extend(self.parts().inner);
        Self::from_round(self.degree(), &round, self.domain().1)?.unclamped_ends()
    }

    /// The same space over other knots outside the domain: `before` are the `p` knots before its start, `after` the
    /// `p` knots after its end, both in ascending order.
    ///
    /// # Errors
    /// [`Error::TooFewKnots`] if either does not have `p` knots, and those of [`new`](Self::new).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let clamped = SplineSpace::clamped(1, [0.0, 1.0, 3.0])?;
    /// assert_eq!(clamped.with_outer_knots(&[-1.0], &[4.0])?, SplineSpace::new(1, [-1.0, 0.0, 1.0, 3.0, 4.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn with_outer_knots(&self, before: &[T], after: &[T]) -> Result<Self> {
        let p = self.degree();
        for outer in [before, after] {
            if outer.len() != p {
                return Err(Error::TooFewKnots { expected: p, found: outer.len() });
            }
        }
        let (a, b) = self.domain();
        let left = before.iter().chain([a]).cloned().collect();
        let right = [b].into_iter().chain(after).cloned().collect();
        Self::from_parts(p, Parts { left, inner: self.parts().inner, right })
    }

    /// The smallest space that contains the sums of a spline here and a spline of `other`.
    ///
    /// Both are elevated to the higher degree; then a knot has the higher of its two multiplicities. An end keeps
    /// its outer knots if they agree and is clamped otherwise. The union of periodic spaces is periodic.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let (lines, cubics) = (SplineSpace::clamped(1, [0.0, 1.0, 2.0])?, SplineSpace::clamped(3, [0.0, 2.0])?);
    /// assert_eq!(lines.union(&cubics)?, SplineSpace::clamped(3, [0.0, 1.0, 1.0, 1.0, 2.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn union(&self, other: &Self) -> Result<Self> {
        self.check_same_domain(other)?;
        if self == other {
            return Ok(self.clone());
        }
        let degree = self.degree().max(other.degree());
        let (f, g) = (self.elevated(degree - self.degree())?, other.elevated(degree - other.degree())?);
        if f.is_periodic() && g.is_periodic() {
            return Self::from_round(degree, &merge(f.round(), g.round(), usize::max), f.domain().1);
        }
        let (a, b) = self.domain();
        let (f, g, open) = (f.parts(), g.parts(), !f.is_periodic() && !g.is_periodic());
        let end = |mine: Vec<T>, theirs: Vec<T>, t: &T| {
            if open && mine == theirs { mine } else { vec![t.clone(); degree + 1] }
        };
        let parts = Parts {
            left: end(f.left, g.left, a),
            inner: merge(f.inner, g.inner, usize::max),
            right: end(f.right, g.right, b),
        };
        Self::from_parts(degree, parts)
    }

    /// The smallest space with clamped ends that contains the products of a spline here and a spline of `other`;
    /// periodic if both are.
    ///
    /// Degrees add, `p + q`. A knot with `m` copies here and `n` there gets
    /// `max(m + q if m > 0, n + p if n > 0)`.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`], [`Error::DegreeTooHigh`], [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, SplineSpace};
    /// let lines = SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?;
    /// assert_eq!(lines.product_space(&lines)?.dim(), 5);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn product_space(&self, other: &Self) -> Result<Self> {
        self.check_same_domain(other)?;
        let (p, q) = (self.degree(), other.degree());
        check_degree(p + q)?;
        let raised =
            |knots: Vec<(T, usize)>, by: usize| knots.into_iter().map(|(t, m)| (t, m + by)).collect();
        if self.is_periodic() && other.is_periodic() {
            let round = merge(raised(self.round(), q), raised(other.round(), p), usize::max);
            return Self::from_round(p + q, &round, self.domain().1);
        }
        let inner = merge(raised(self.parts().inner, q), raised(other.parts().inner, p), usize::max);
        let (a, b) = self.domain();
        let end = |t: &T| vec![t.clone(); p + q + 1];
        Self::from_parts(p + q, Parts { left: end(a), inner, right: end(b) })
    }

    /// The space of independent polynomials of `degree` on the spans of this one: every knot has `degree + 1`
    /// copies, so coefficients are the Bernstein coefficients of the pieces, `degree + 1` a span.
    ///
    /// # Errors
    /// [`Error::DegreeTooHigh`], [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let space = SplineSpace::clamped(3, [0.0, 1.0, 3.0])?;
    /// assert_eq!(space.pieces(1)?, SplineSpace::clamped(1, [0.0, 1.0, 1.0, 3.0])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn pieces(&self, degree: usize) -> Result<Self> {
        check_degree(degree)?;
        check_dim(self.dim().saturating_mul(degree + 1))?;
        let (a, b) = self.domain();
        let end = |t: &T| vec![t.clone(); degree + 1];
        let inner = self.parts().inner.into_iter().map(|(t, _)| (t, degree + 1)).collect();
        Self::from_parts(degree, Parts { left: end(a), inner, right: end(b) })
    }

    /// Whether every spline of `other` is one of this space: same domain, no higher degree, no rougher knot.
    ///
    /// An open space may contain a periodic one, never the other way round. Knots outside the domain do not
    /// matter: over the domain they change the basis, not the space.
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let coarse = SplineSpace::clamped(2, [0.0, 1.0, 2.0])?;
    /// assert!(coarse.refined(&[0.5])?.contains(&coarse));
    /// assert!(!coarse.contains(&coarse.refined(&[0.5])?));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn contains(&self, other: &Self) -> bool {
        other.check_within(self).is_ok()
    }

    /// Why a spline of this space is not one of `target`, if so.
    pub(crate) fn check_within(&self, target: &Self) -> Result<()> {
        self.check_same_domain(target)?;
        let Some(raise) = target.degree().checked_sub(self.degree()) else {
            return Err(Error::DegreeTooLow { degree: target.degree(), needed: self.degree() });
        };
        let (mine, theirs) = match (self.is_periodic(), target.is_periodic()) {
            (false, true) => return Err(Error::NotPeriodic),
            (true, true) => (self.round(), target.round()),
            _ => (self.parts().inner, target.parts().inner),
        };
        let mut theirs = theirs.into_iter().peekable();
        for (t, m) in mine {
            while theirs.next_if(|(s, _)| *s < t).is_some() {}
            let present = theirs.next_if(|(s, _)| *s == t).map_or(0, |(_, n)| n);
            if present < m + raise {
                return Err(Error::TooSmooth {
                    knot: t.to_string(),
                    multiplicity: present,
                    needed: m + raise,
                });
            }
        }
        Ok(())
    }
}

/// Unites two ascending lists of knots with counts; `both` combines the counts of a knot that is in both lists.
fn merge<T: Scalar>(
    left: Vec<(T, usize)>,
    right: Vec<(T, usize)>,
    both: impl Fn(usize, usize) -> usize,
) -> Vec<(T, usize)> {
    let mut merged = Vec::with_capacity(left.len() + right.len());
    let mut right = right.into_iter().peekable();
    for (t, m) in left {
        while let Some(earlier) = right.next_if(|(s, _)| *s < t) {
            merged.push(earlier);
        }
        let count = right.next_if(|(s, _)| *s == t).map_or(m, |(_, n)| both(m, n));
        merged.push((t, count));
    }
    merged.extend(right);
    merged
}
