//! Piecewise powers: the pieces of a spline by their derivatives at the left ends.
//!
//! ```text
//! f(x) = Σ_r c_r (x - a)^r      on [a, b]
//! ```
//! Back to coefficients goes by Bernstein's, `Σ_r C(j, r) / C(p, r) (b - a)^r c_r`, and
//! [recomposition](crate::ops::recompose). Where pieces meet, the orders of derivatives that agree say how many knots a spline
//! needs there: `p + 1` less one for each order.

use crate::bernstein::binomials;
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::knots::KnotVector;
use crate::limits::{check_degree, check_dim};
use crate::parts::Parts;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

/// A piecewise polynomial: breaks, and on each interval between them the coefficients of the powers of `x` less its left
/// end.
///
/// # Examples
/// ```
/// use symspline::{PowerForm, Q, Scalar, SplineSpace};
/// let q = |numbers: [i64; 3]| numbers.map(Q::int).to_vec();
/// // x² up to 1, its tangent from there on.
/// let form = PowerForm::new([0, 1, 2].map(Q::int), vec![q([0, 0, 1]), q([1, 2, 0])])?;
/// let spline = form.to_smallest_spline()?;
/// assert_eq!(spline.space(), &SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?);
/// assert_eq!(spline.at(&Q::int(2))?, Q::int(3));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct PowerForm<T, C = T> {
    breaks: KnotVector<T>,
    pieces: Vec<Vec<C>>,
}

impl<T: Scalar, C: Coeff<T>> PowerForm<T, C> {
    /// The piecewise polynomial with these `breaks` and `pieces`, coefficients of lower powers first, all of one number.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::KnotsDecrease`], also for equal breaks; [`Error::TooFewKnots`] for fewer than two;
    /// [`Error::CoefficientCount`] unless there is a piece an interval; [`Error::Ragged`] for pieces or coefficients of
    /// different sizes; [`Error::DegreeTooHigh`].
    pub fn new(breaks: impl IntoIterator<Item = T>, pieces: Vec<Vec<C>>) -> Result<Self> {
        let breaks = KnotVector::new(breaks)?;
        if let Some(before) = breaks.windows(2).position(|ends| ends[0] == ends[1]) {
            return Err(Error::KnotsDecrease { index: before + 1 });
        }
        if breaks.len() < 2 {
            return Err(Error::TooFewKnots { expected: 2, found: breaks.len() });
        }
        if pieces.len() != breaks.len() - 1 {
            return Err(Error::CoefficientCount { expected: breaks.len() - 1, found: pieces.len() });
        }
        let Some(first) = pieces[0].first() else {
            return Err(Error::CoefficientCount { expected: 1, found: 0 });
        };
        check_degree(pieces[0].len() - 1)?;
        let same =
            |piece: &Vec<C>| piece.len() == pieces[0].len() && piece.iter().all(|c| c.same_shape(first));
        if let Some(index) = pieces.iter().position(|piece| !same(piece)) {
            return Err(Error::Ragged { index });
        }
        match pieces.iter().flatten().position(|c| !c.all_finite()) {
            Some(index) => Err(Error::NotFinite { what: "coefficient", index }),
            None => Ok(Self { breaks, pieces }),
        }
    }

    /// The ends of the intervals, ascending.
    pub fn breaks(&self) -> &[T] {
        &self.breaks
    }

    /// The coefficients of each piece, of lower powers first.
    pub fn pieces(&self) -> &[Vec<C>] {
        &self.pieces
    }

    /// The degree, one less than the number of coefficients of a piece.
    pub fn degree(&self) -> usize {
        self.pieces[0].len() - 1
    }

    /// The value at `x`: of the piece on its right, at the end of the last.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let form = Function::monomial(2, 1.0, 3.0)?.to_power_form();
    /// assert_eq!((form.pieces()[0].as_slice(), form.at(&2.0)?), (&[1.0, 2.0, 1.0][..], 4.0));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn at(&self, x: &T) -> Result<C> {
        let (a, b) = self.ends();
        if !(x >= a && x <= b) {
            let [parameter, start, end] = [x, a, b].map(T::to_string);
            return Err(Error::OutsideDomain { parameter, start, end });
        }
        Ok(self.shifted(self.piece_right_of(x), x).swap_remove(0))
    }

    /// The same function as a spline of `target`, to `tolerance`: the largest distance of values, zero over an exact
    /// field.
    ///
    /// # Errors
    /// [`Error::TooSmooth`] at a break where the pieces join less smoothly than the target; [`Error::DomainMismatch`];
    /// [`Error::DegreeTooLow`]; [`Error::BadTolerance`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Error, PowerForm, Q, Scalar, SplineSpace};
    /// let q = |numbers: [i64; 2]| numbers.map(Q::int).to_vec();
    /// let roof = PowerForm::new([0, 1, 2].map(Q::int), vec![q([0, 1]), q([1, -1])])?;
    /// let spline = roof.to_spline(&SplineSpace::clamped(2, [0, 1, 1, 2].map(Q::int))?, &Q::int(0))?;
    /// assert_eq!(spline.at(&Q::int(1))?, Q::int(1));
    /// let smooth = roof.to_spline(&SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?, &Q::int(0));
    /// assert_eq!(smooth.unwrap_err(), Error::TooSmooth { knot: "1".into(), multiplicity: 1, needed: 2 });
    /// # Ok::<(), Error>(())
    /// ```
    pub fn to_spline(&self, target: &SplineSpace<T>, tolerance: &T) -> Result<Spline<T, C>> {
        if !tolerance.is_finite() || *tolerance < T::zero() {
            return Err(Error::BadTolerance { tolerance: tolerance.to_string() });
        }
        let q = target.degree();
        if self.ends() != target.domain() {
            let text = |(a, b): (&T, &T)| format!("[{a}, {b}]");
            return Err(Error::DomainMismatch { left: text(self.ends()), right: text(target.domain()) });
        }
        if q < self.degree() {
            return Err(Error::DegreeTooLow { degree: q, needed: self.degree() });
        }
        let rough = self.too_rough(target);
        if let (Some(error), true) = (&rough, tolerance.is_zero()) {
            return Err(error.clone());
        }
        let knots: Vec<T> = target.breaks().into_iter().map(|(t, _)| t).collect();
        let spline = Spline::new(target.clone(), target.recomposition()?.apply(&self.bernstein(&knots, q))?)?;
        let far =
            |error: &Error| (!self.near(&spline, tolerance)?).then(|| error.clone()).map_or(Ok(()), Err);
        rough.as_ref().map_or(Ok(()), far)?;
        Ok(spline)
    }

    /// The same function in the smallest clamped space that holds it: of the lowest degree, with as few knots as the
    /// joints allow.
    ///
    /// Derivatives are compared with `==`, so in `f64` rounding makes most knots full.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let square = Function::monomial(2, Q::int(0), Q::int(2))?;
    /// let hidden = square.elevated(2)?.inserted(&[Q::int(1), Q::int(1)])?;
    /// assert_eq!(hidden.to_power_form().to_smallest_spline()?, square);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn to_smallest_spline(&self) -> Result<Spline<T, C>> {
        let used = |piece: &Vec<C>| piece.iter().rposition(|c| !c.vanishes()).unwrap_or(0);
        let degree = self.pieces.iter().map(used).max().unwrap_or(0);
        let inner: Vec<(T, usize)> = (1..self.pieces.len())
            .map(|s| (self.breaks[s].clone(), degree + 1 - self.agreement(s - 1, s).min(degree + 1)))
            .filter(|(_, copies)| *copies > 0)
            .collect();
        let end = |t: &T| vec![t.clone(); degree + 1];
        let (a, b) = self.ends();
        let space = SplineSpace::from_parts(degree, Parts { left: end(a), inner, right: end(b) })?;
        let lowered: Vec<Vec<C>> = self.pieces.iter().map(|piece| piece[..=degree].to_vec()).collect();
        Self { breaks: self.breaks.clone(), pieces: lowered }.to_spline(&space, &T::zero())
    }

    fn ends(&self) -> (&T, &T) {
        (&self.breaks[0], &self.breaks[self.pieces.len()])
    }

    /// The piece that holds what is right of `x`.
    fn piece_right_of(&self, x: &T) -> usize {
        self.breaks[1..self.pieces.len()].partition_point(|t| t <= x)
    }

    /// The coefficients of the powers of `x - from` of piece `s`.
    fn shifted(&self, s: usize, from: &T) -> Vec<C> {
        let mut coeffs = self.pieces[s].clone();
        let by = from.clone() - &self.breaks[s];
        if by.is_zero() {
            return coeffs;
        }
        // Horner's scheme, once for each power.
        for lowest in 0..coeffs.len() {
            for r in (lowest + 1..coeffs.len()).rev() {
                let higher = coeffs[r].scaled(&by);
                coeffs[r - 1].add_scaled(&T::one(), &higher);
            }
        }
        coeffs
    }

    /// How many derivatives, the value among them, piece `left` at its end and piece `right` at its start have in common
    /// from the lowest on: more than the degree if they are the same polynomial.
    fn agreement(&self, left: usize, right: usize) -> usize {
        let end = self.shifted(left, &self.breaks[left + 1]);
        end.iter().zip(&self.pieces[right]).take_while(|(c, d)| c == d).count()
    }

    /// The first break where the pieces join less smoothly than the splines of `target`, as the error that says so.
    fn too_rough(&self, target: &SplineSpace<T>) -> Option<Error> {
        let mut theirs = target.breaks().into_iter().peekable();
        let first = usize::from(!target.is_periodic());
        (first..self.pieces.len()).find_map(|s| {
            let knot = &self.breaks[s];
            let left = s.checked_sub(1).unwrap_or(self.pieces.len() - 1);
            let needed = match self.agreement(left, s) {
                all if all > self.degree() => 0,
                some => target.degree() + 1 - some,
            };
            while theirs.next_if(|(t, _)| t < knot).is_some() {}
            let multiplicity = theirs.next_if(|(t, _)| t == knot).map_or(0, |(_, copies)| copies);
            let knot = knot.to_string();
            (multiplicity < needed).then_some(Error::TooSmooth { knot, multiplicity, needed })
        })
    }

    /// The Bernstein coefficients of degree `q` on the intervals of `knots`, of the polynomial at the start of each.
    fn bernstein(&self, knots: &[T], q: usize) -> Vec<C> {
        let rows: Vec<Vec<T>> = (0..=q).map(binomials).collect();
        let mut coeffs = Vec::with_capacity((knots.len() - 1) * (q + 1));
        for ends in knots.windows(2) {
            let width = ends[1].clone() - &ends[0];
            let mut powers = self.shifted(self.piece_right_of(&ends[0]), &ends[0]);
            let mut scale = T::one();
            for (r, c) in powers.iter_mut().enumerate() {
                c.scale(&(scale.clone() / &rows[q][r]));
                scale *= &width;
            }
            coeffs.extend((0..=q).map(|j| {
                let terms = rows[j].iter().zip(&powers);
                C::combine(terms).expect("a piece has a coefficient")
            }));
        }
        coeffs
    }

    /// Whether `spline` is at most `tolerance` away everywhere.
    fn near(&self, spline: &Spline<T, C>, tolerance: &T) -> Result<bool> {
        let q = spline.degree();
        check_dim(self.breaks.len().saturating_mul(q + 1))?;
        let joints = self.breaks.iter().map(|t| (t.clone(), q + 1));
        let (a, b) = self.ends();
        let inner = joints.filter(|(t, _)| a < t && t < b).collect();
        let end = |t: &T| vec![t.clone(); q + 1];
        let own = SplineSpace::from_parts(q, Parts { left: end(a), inner, right: end(b) })?;
        let fine = own.union(&spline.space().pieces(q)?)?;
        let knots: Vec<T> = fine.breaks().into_iter().map(|(t, _)| t).collect();
        let (mine, theirs) = (self.bernstein(&knots, q), spline.embedded(&fine)?);
        let square = tolerance.clone() * tolerance;
        Ok(mine.iter().zip(theirs.coeffs()).all(|(c, d)| c.minus(d).squared_size() <= square))
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The pieces by their derivatives at the left ends: coefficient `r` of a piece is `f^(r) / r!` there.
    ///
    /// Over `f64` these overflow for high degrees on short spans: coefficients that are not finite are not refused here.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let f = Function::new(SplineSpace::clamped(1, [0.0, 1.0, 3.0])?, vec![0.0, 2.0, 0.0])?;
    /// let form = f.to_power_form();
    /// assert_eq!(form.breaks(), [0.0, 1.0, 3.0]);
    /// assert_eq!(form.pieces(), [[0.0, 2.0], [2.0, -1.0]]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn to_power_form(&self) -> PowerForm<T, C> {
        let (p, t) = (self.degree(), self.space().knots());
        let piece = |k: usize| {
            let mut coeffs = self.derivatives_on(k, &t[k], p);
            let mut factorial = T::one();
            for (r, c) in coeffs.iter_mut().enumerate().skip(1) {
                factorial *= T::int(r as i64);
                c.scale(&(T::one() / &factorial));
            }
            coeffs
        };
        let breaks = self.space().breaks().into_iter().map(|(t, _)| t);
        PowerForm {
            breaks: KnotVector::new(breaks).expect("breaks ascend"),
            pieces: self.space().spans().map(piece).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spline::Function;

    #[test]
    fn forms_that_are_none_are_refused() {
        let form = |breaks: &[f64], pieces: &[&[f64]]| {
            PowerForm::new(breaks.to_vec(), pieces.iter().map(|piece| piece.to_vec()).collect())
        };
        assert_eq!(form(&[0.0], &[]), Err(Error::TooFewKnots { expected: 2, found: 1 }));
        assert_eq!(form(&[0.0, 0.0], &[&[1.0]]), Err(Error::KnotsDecrease { index: 1 }));
        assert_eq!(form(&[0.0, 1.0], &[]), Err(Error::CoefficientCount { expected: 1, found: 0 }));
        assert_eq!(form(&[0.0, 1.0], &[&[]]), Err(Error::CoefficientCount { expected: 1, found: 0 }));
        assert_eq!(form(&[0.0, 1.0, 2.0], &[&[1.0], &[1.0, 2.0]]), Err(Error::Ragged { index: 1 }));
        assert!(matches!(form(&[0.0, 1.0], &[&[f64::NAN]]), Err(Error::NotFinite { .. })));
        assert!(matches!(
            form(&[0.0, 1.0], &[&[1.0]]).unwrap().at(&f64::NAN),
            Err(Error::OutsideDomain { .. })
        ));
    }

    #[test]
    fn floats_go_there_and_back_to_a_tolerance() {
        let space = SplineSpace::uniform_periodic(3, 7, 0.0, 1.0).unwrap();
        let f = Function::new(space.clone(), (0..7).map(|i| (i as f64).sin()).collect()).unwrap();
        let form = f.to_power_form();
        let back = form.to_spline(&space, &1e-12).unwrap();
        assert!(back.coeffs().iter().zip(f.coeffs()).all(|(c, d)| (c - d).abs() < 1e-12));
        let smoother = SplineSpace::uniform_periodic(4, 7, 0.0, 1.0).unwrap();
        assert!(matches!(form.to_spline(&smoother, &1e-6), Err(Error::TooSmooth { .. })));
        assert!(matches!(form.to_spline(&space, &f64::NAN), Err(Error::BadTolerance { .. })));
    }
}
