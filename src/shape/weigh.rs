//! Weights that change in place, while control points stay.
//!
//! A weight is a positive number: at zero the control point would be lost. The denominator of a rational spline is proved
//! positive when it is made, mostly by its coefficients. A weight that grows keeps the proof. One that shrinks keeps it if all
//! weights around it are positive, which a few comparisons tell; only where a denominator is positive although some of its
//! coefficients are not is it proved again. So a change costs the same whatever the number of control points.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::limits::check_degree;
use crate::ops::sign::Sign;
use crate::rational::domain::Domain;
use crate::rational::spline::Rational;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::space::SplineSpace;
use crate::weighted::Weighted;

/// A shape whose control points have weights: a rational curve or surface.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{NurbsCurve, SplineSpace, Weighed};
/// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, 0.0]];
/// let mut arc = NurbsCurve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points, vec![1.0; 3])?;
/// arc.set_weights(&[(1, 3.0)])?;
/// assert_eq!(arc.at(&0.5)?, vector![1.0, 1.5]);
/// # Ok::<(), symspline::Error>(())
/// ```
pub trait Weighed<T: Scalar>: Controlled<T> {
    /// A control point times its weight, and the weight.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    fn weighted(&self, flat: usize) -> Result<&Weighted<T, Self::Point>>;

    /// Puts control points with weights in the place of others. On an error nothing has changed.
    ///
    /// # Errors
    /// [`Error::Weight`] for a weight that is not positive; [`Error::IndexOutOfRange`]; [`Error::NotFinite`], also on overflow
    /// of weight times point; [`Error::Pole`] and [`Error::Undecided`] where other weights are not positive and the
    /// denominator would vanish, or may.
    fn place_weighted(&mut self, new: &[(usize, Self::Point, T)]) -> Result<()>;

    /// The weight of a control point.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    fn weight(&self, flat: usize) -> Result<&T> {
        Ok(&self.weighted(flat)?.weight)
    }

    /// Changes weights; control points stay. On an error nothing has changed.
    ///
    /// # Errors
    /// As [`place_weighted`](Self::place_weighted); [`Error::Weight`] also if the old weight is not positive, so that there is
    /// no control point.
    ///
    /// # Examples
    /// A weight of zero would lose its control point:
    /// ```
    /// use symspline::{Error, RationalFunction, SplineSpace, Weighed};
    /// let mut f = RationalFunction::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![3.0, 5.0], vec![1.0; 2])?;
    /// assert_eq!(f.set_weights(&[(1, 0.0)]), Err(Error::Weight { index: 1, weight: "0".into() }));
    /// # Ok::<(), Error>(())
    /// ```
    fn set_weights(&mut self, new: &[(usize, T)]) -> Result<()> {
        let kept = new.iter().map(|(i, weight)| Ok((*i, self.control_point(*i)?, weight.clone())));
        let kept = kept.collect::<Result<Vec<_>>>()?;
        self.place_weighted(&kept)
    }

    /// The derivatives of the point at `at` by the weight of a control point, of orders `0 ..= order` [NURBS, (11.18) to
    /// (11.20)]:
    ///
    /// ```text
    /// ∂^n S / ∂w_k^n = (-1)^(n-1) n! (N_k / W)^n (P_k - S),   W = Σ w_i N_i
    /// ```
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DegreeTooHigh`], [`Error::IndexOutOfRange`]; [`Error::Weight`] unless the weight is
    /// positive; [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, RationalFunction, Scalar, SplineSpace, Weighed};
    /// // In the middle the value is w / (1 + w).
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let f = RationalFunction::new(line, [0, 1].map(Q::int).to_vec(), vec![Q::int(1); 2])?;
    /// let derivatives = f.weight_derivatives(&Q::frac(1, 2), 1, 3)?;
    /// assert_eq!(derivatives, [(1, 2), (1, 4), (-1, 4), (3, 8)].map(|(p, q)| Q::frac(p, q)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn weight_derivatives(
        &self,
        at: &Self::Parameter,
        flat: usize,
        order: usize,
    ) -> Result<Vec<Self::Point>> {
        check_degree(order)?;
        let control = self.control_point(flat)?;
        let value = self.derivative_of(at, Self::VALUE)?;
        let way = control.minus(&value);
        let row = self.influence(at, Self::VALUE)?;
        let rate = match row.weight(flat) {
            Some(share) => share.clone() / self.weight(flat)?,
            None => T::zero(),
        };
        let mut derivatives = vec![value];
        let mut factor = rate.clone();
        for n in 1..=order {
            derivatives.push(way.scaled(&factor));
            factor = -(factor * &rate * T::int(n as i64 + 1));
        }
        match derivatives.iter().position(|d| !d.all_finite()) {
            Some(index) => Err(Error::NotFinite { what: "derivative", index }),
            None => Ok(derivatives),
        }
    }
}

impl<D: Domain<T>, T: Scalar, C: Coeff<T>> Weighed<T> for Rational<D, T, C>
where
    Self: Controlled<T, Point = C>,
{
    fn weighted(&self, flat: usize) -> Result<&Weighted<T, C>> {
        let all = D::coeffs(self.lifted());
        all.get(flat).ok_or(Error::IndexOutOfRange { index: flat, length: all.len() })
    }

    fn place_weighted(&mut self, new: &[(usize, C, T)]) -> Result<()> {
        let mut old = Vec::with_capacity(new.len());
        let mut placed = Vec::with_capacity(new.len());
        let mut shrinks = false;
        for (i, point, weight) in new {
            let before = self.weighted(*i)?;
            if weight.is_zero() || weight.is_finite() && *weight < T::zero() {
                return Err(Error::Weight { index: *i, weight: weight.to_string() });
            }
            shrinks |= *weight < before.weight;
            old.push((*i, before.clone()));
            placed.push((*i, Weighted::new(point, weight.clone())));
        }
        self.replace_points(placed)?;
        if !shrinks || new.iter().all(|(i, ..)| is_among_positive(self, *i)) {
            return Ok(());
        }
        let refused = match self.denominator().and_then(|bottom| D::sign(&bottom)) {
            Ok(Sign::Positive) => return Ok(()),
            Ok(Sign::Negative) => Error::Pole,
            Err(error) => error,
        };
        old.reverse();
        self.replace_points(old)?;
        Err(refused)
    }
}

/// Whether all weights around a control point are positive.
pub(super) fn is_among_positive<T: Scalar, S: Weighed<T>>(shape: &S, flat: usize) -> bool {
    around(shape, flat).all(|i| shape.weight(i).is_ok_and(|weight| *weight > T::zero()))
}

/// The control points with influence where one has it, in the list of all; some more than once in a short ring.
fn around<T: Scalar, S: Controlled<T>>(shape: &S, flat: usize) -> impl Iterator<Item = usize> {
    let [across, along] = match S::DIRECTIONS {
        [u, v] => [Some(shape.space_along(*u)), Some(shape.space_along(*v))],
        [u, ..] => [None, Some(shape.space_along(*u))],
        [] => [None, None],
    };
    let width = along.map_or(1, SplineSpace::dim);
    let columns = near(along, flat % width);
    near(across, flat / width).flat_map(move |i| columns.clone().map(move |j| i * width + j))
}

/// The coefficients of a space whose supports meet that of coefficient `i`.
fn near<T: Scalar>(space: Option<&SplineSpace<T>>, i: usize) -> impl Iterator<Item = usize> + Clone + use<T> {
    let (p, m, ring) = space.map_or((0, 1, false), |s| (s.degree(), s.dim(), s.is_periodic()));
    let (first, past) = match ring {
        true if 2 * p < m => (i + m - p, i + m + p + 1),
        true => (0, m),
        false => (i.saturating_sub(p), m.min(i + p + 1)),
    };
    (first..past).map(move |j| j % m)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use crate::rational::spline::RationalFunction;
    use crate::spline::Spline;

    fn lifted(weights: &[i64]) -> RationalFunction<Q> {
        let coeffs = weights.iter().map(|w| Weighted { point: Q::int(1), weight: Q::int(*w) });
        let space = SplineSpace::clamped(2, (0..weights.len() as i64 - 1).map(Q::int)).unwrap();
        Rational::from_lifted(Spline::new(space, coeffs.collect()).unwrap()).unwrap()
    }

    #[test]
    fn nothing_changes_on_an_error() {
        let mut f = RationalFunction::new(
            SplineSpace::bezier(2, 0.0, 1.0).unwrap(),
            vec![1.0, 1e10, 3.0],
            vec![1.0, 2.0, 3.0],
        )
        .unwrap();
        let before = f.clone();
        let bad = |index, weight: &str| Err(Error::Weight { index, weight: weight.into() });
        assert_eq!(f.set_weights(&[(0, 5.0), (2, 0.0)]), bad(2, "0"));
        assert_eq!(f.set_weights(&[(0, 5.0), (2, -1.0)]), bad(2, "-1"));
        let out = Error::IndexOutOfRange { index: 3, length: 3 };
        assert_eq!(f.set_weights(&[(0, 5.0), (3, 1.0)]), Err(out));
        for weight in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
            let overflow = Error::NotFinite { what: "coefficient", index: 1 };
            assert_eq!(f.set_weights(&[(0, 5.0), (1, weight)]), Err(overflow), "{weight}");
        }
        assert_eq!(f, before);
        f.set_weights(&[]).unwrap();
        assert_eq!(f, before);
    }

    #[test]
    fn a_weight_that_shrinks_beside_a_negative_one_is_looked_at() {
        // The first piece is 6 x² - 8 x + 3.
        let mut f = lifted(&[3, -1, 3, 3, 3, 3, 3]);
        let before = f.clone();
        assert_eq!(f.set_weights(&[(2, Q::frac(1, 100)), (0, Q::frac(1, 100))]), Err(Error::Pole));
        assert_eq!(f, before);
        f.set_weights(&[(0, Q::frac(19, 10))]).unwrap();
        assert_eq!(f.set_weights(&[(1, Q::int(1))]), Err(Error::Weight { index: 1, weight: "-1".into() }));
        // Out of its reach there is nothing to prove.
        f.set_weights(&[(5, Q::frac(1, 100))]).unwrap();
        f.place_weighted(&[(1, Q::int(7), Q::int(1))]).unwrap();
        f.set_weights(&[(2, Q::frac(1, 100)), (0, Q::frac(1, 100))]).unwrap();
    }

    #[test]
    fn neighbours_share_a_span() {
        let spaces = [
            SplineSpace::clamped(2, (0..6).map(f64::from)).unwrap(),
            SplineSpace::uniform_periodic(2, 7, 0.0, 1.0).unwrap(),
            SplineSpace::uniform_periodic(3, 4, 0.0, 1.0).unwrap(),
            SplineSpace::clamped(0, (0..4).map(f64::from)).unwrap(),
        ];
        for space in spaces {
            let (m, p) = (space.dim(), space.degree());
            for i in 0..m {
                let mut found: Vec<usize> = near(Some(&space), i).collect();
                found.sort_unstable();
                found.dedup();
                let on_a_span = |j: &usize| {
                    let has = |k: usize, j: usize| (k - p..=k).any(|c| space.slot(c) == j);
                    space.spans().any(|k| has(k, i) && has(k, *j))
                };
                let together: Vec<usize> = (0..m).filter(on_a_span).collect();
                assert_eq!(found, together, "coefficient {i} of {m}");
            }
        }
    }
}
