//! The knot that puts a parameter halfway between two nodes, so that two weights pull evenly there.
//!
//! A knot `û` changes the nodes around it. With `t_k` the node nearest to `x`, the new nodes `k` and `k + 1` have the mean `x` for
//! [NURBS, section 11.3.2; the formula after (11.33) is the central one]
//!
//! ```text
//! central    û = p x - (u_{k+1} + u_{k+p}) / 2 - Σ_{j=2}^{p-1} u_{k+j}         in [u_{k+1}, u_{k+p}]
//! right gap  û = 2 p x - Σ_{j=1}^{p} u_{k+j} - Σ_{j=2}^{p} u_{k+j}             in [u_{k+p}, u_{k+p+1}]
//! left gap   û = 2 p x - Σ_{j=1}^{p} u_{k+j} - Σ_{j=1}^{p-1} u_{k+j}           in [u_k, u_{k+1}]
//! ```
//!
//! The central one serves as long as `|x - t_k| <= (u_{k+p} - u_{k+1}) / (2 p)`; else the side of `x` says which of the others does.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;

/// Where the knot lies that puts a parameter halfway between two nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Regime {
    /// No knot is needed.
    There,
    /// Between the knots of the nearest node.
    Central,
    /// Before them.
    LeftGap,
    /// After them.
    RightGap,
}

/// A parameter halfway between two nodes, after a knot is inserted.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Halfway<T> {
    /// The knot to insert, none if the parameter is halfway already.
    pub knot: Option<T>,
    /// Where the knot lies.
    pub regime: Regime,
    /// The first of the two nodes, in the space with the knot; the other is the next. In a ring it is an unrolled index.
    pub leg: usize,
}

impl<T: Scalar> SplineSpace<T> {
    /// The parameter halfway between nodes `k` and `k + 1`, where the weights of leg `k` pull evenly [NURBS, section 11.3.2].
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`]; [`Error::OutsideDomain`] in an unclamped or periodic space.
    ///
    /// # Examples
    /// ```
    /// let space = symspline::SplineSpace::clamped(2, [0.0, 1.0, 2.0, 4.0])?;
    /// assert_eq!(space.between_nodes(1)?, 1.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn between_nodes(&self, k: usize) -> Result<T> {
        let (left, right) = (self.node(k)?, self.node(k.saturating_add(1))?);
        let x = left.clone() + (right - left) / T::int(2);
        self.locate(&x).map(|_| x)
    }

    /// The knot that puts `x` halfway between two nodes [NURBS, section 11.3.2], unless there is a knot already.
    ///
    /// # Errors
    /// [`ShapeError::KnotThere`]: inserting it makes splines less smooth, so that they may get a corner; those who want that
    /// take [`halfway_knot_or_copy`](Self::halfway_knot_or_copy). [`ShapeError::NoHalfwayKnot`], also in rings of fewer than `p`
    /// coefficients, where a knot counts several times for each node and the formulas need not hold;
    /// [`Error::DegreeTooLow`] below degree 2; [`Error::OutsideDomain`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Halfway, Regime, SplineSpace};
    /// let space = SplineSpace::clamped(2, [0.0, 1.0, 2.0, 4.0])?;
    /// let found = space.halfway_knot(&1.375)?;
    /// assert_eq!(found, Halfway { knot: Some(1.25), regime: Regime::Central, leg: 2 });
    /// let nodes = space.refined(&[1.25])?.greville();
    /// assert_eq!((nodes[2] + nodes[3]) / 2.0, 1.375);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn halfway_knot(&self, x: &T) -> Result<Halfway<T>> {
        let found = self.halfway_knot_or_copy(x)?;
        match &found.knot {
            Some(knot) if self.knots().contains(knot) => {
                Err(ShapeError::KnotThere { knot: knot.to_string() }.into())
            }
            _ => Ok(found),
        }
    }

    /// As [`halfway_knot`](Self::halfway_knot), even if there is such a knot already: another copy of it. Over floating point
    /// that is also one which differs by rounding.
    ///
    /// # Errors
    /// As [`halfway_knot`](Self::halfway_knot), but [`ShapeError::KnotThere`] only where no further copy is possible.
    pub fn halfway_knot_or_copy(&self, x: &T) -> Result<Halfway<T>> {
        let p = self.degree();
        if p < 2 {
            return Err(Error::DegreeTooLow { degree: p, needed: 2 });
        }
        let k = self.nearest_node(x)?;
        if let Some(leg) = self.leg_around(x, k) {
            return Ok(Halfway { knot: None, regime: Regime::There, leg });
        }
        let none = || ShapeError::NoHalfwayKnot { parameter: x.to_string() };
        let (regime, knot) = self.halving(x, k);
        let knot = self.inside(self.snapped(knot, k)).ok_or_else(none)?;
        let there = |_| ShapeError::KnotThere { knot: knot.to_string() };
        let finer = self.refined(std::slice::from_ref(&knot)).map_err(there)?;
        // In a ring the knots before the domain are counted from the seam, and in a short one the knot counts several times.
        let leg = finer.leg_around(x, k).ok_or_else(none)?;
        Ok(Halfway { knot: Some(knot), regime, leg })
    }

    /// The knot by the formula of its regime.
    fn halving(&self, x: &T, k: usize) -> (Regime, T) {
        let p = self.degree();
        let u = &self.knots()[k..=k + p + 1];
        // From `x`, so that no sum is large.
        let rises = |knots: &[T]| knots.iter().fold(T::zero(), |sum, t| sum + (x.clone() - t));
        let from_node = rises(&u[1..=p]);
        let ends = u[p].clone() - &u[1];
        let two = T::int(2);
        if from_node.magnitude() * &two <= ends {
            let knot = x.clone() + (from_node + rises(&u[2..p])) / two;
            (Regime::Central, knot)
        } else if from_node > T::zero() {
            (Regime::RightGap, x.clone() + from_node + rises(&u[2..=p]))
        } else {
            (Regime::LeftGap, x.clone() + from_node + rises(&u[1..p]))
        }
    }

    /// A knot of coefficient `k` in the place of one that differs from it by rounding.
    fn snapped(&self, knot: T, k: usize) -> T {
        let support = &self.knots()[k..=k + self.degree() + 1];
        let same = support.iter().find(|t| self.same(t, &knot, k)).cloned();
        same.unwrap_or(knot)
    }

    /// Whether two parameters are the same, over floating point up to rounding.
    fn same(&self, x: &T, y: &T, k: usize) -> bool {
        if T::EXACT {
            return x == y;
        }
        let t = self.knots();
        let noise = (t[k + self.degree() + 1].clone() - &t[k]) * T::frac(1, 1 << 40);
        (x.clone() - y).magnitude() <= noise
    }

    /// The parameter inside the domain where `knot` can be inserted, in a ring a period away if need be.
    fn inside(&self, knot: T) -> Option<T> {
        let (a, b) = self.domain();
        let period = self.length();
        let knot = match self.is_periodic() {
            true if knot < *a => knot + period,
            true if knot >= *b => knot - period,
            _ => knot,
        };
        let inner = *a < knot && knot < *b || self.is_periodic() && knot == *a;
        inner.then_some(knot)
    }

    /// The leg near `k` whose nodes have the mean `x`.
    fn leg_around(&self, x: &T, k: usize) -> Option<usize> {
        let last = self.unrolled_dim() - 1;
        let halves = |i: &usize| {
            let (left, right) = (self.mean_of_knots(*i), self.mean_of_knots(i + 1));
            let middle = left.clone() + (right - left) / T::int(2);
            self.same(&middle, x, (*i).min(last))
        };
        let near = k.saturating_sub(2)..(k + 3).min(last);
        near.filter(|i| self.degree() > 0 && *i < last).find(halves)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn low_degrees_are_refused() {
        for degree in [0, 1] {
            let space = SplineSpace::clamped(degree, [0.0, 1.0, 2.0]).unwrap();
            assert_eq!(space.halfway_knot(&0.5), Err(Error::DegreeTooLow { degree, needed: 2 }));
        }
        let cubic = SplineSpace::bezier(3, 0.0, 1.0).unwrap();
        assert!(matches!(cubic.halfway_knot(&1.5), Err(Error::OutsideDomain { .. })));
        assert!(matches!(cubic.between_nodes(3), Err(Error::IndexOutOfRange { index: 4, length: 4 })));
        assert!(cubic.between_nodes(usize::MAX).is_err());
    }

    #[test]
    fn a_knot_that_is_there_is_told() {
        // Node 2 is at 1, and with another copy of the knot two nodes are around it.
        let space = SplineSpace::clamped(2, [0.0, 0.5, 1.5, 2.0]).unwrap();
        let (knot, x) = (0.5, 0.75);
        assert_eq!(space.halfway_knot(&x), Err(ShapeError::KnotThere { knot: "0.5".into() }.into()));
        let found = space.halfway_knot_or_copy(&x).unwrap();
        assert_eq!(found.knot, Some(knot));
        let nodes = space.refined(&[knot]).unwrap().greville();
        assert_eq!((nodes[found.leg] + nodes[found.leg + 1]) / 2.0, x);
    }

    #[test]
    fn halfway_up_to_rounding_is_halfway() {
        let space = SplineSpace::clamped(3, (0..8).map(|i| f64::from(i) / 7.0)).unwrap();
        for k in 0..space.dim() - 1 {
            let x = space.between_nodes(k).unwrap();
            for x in [x, x * (1.0 + f64::EPSILON), x * (1.0 - f64::EPSILON)] {
                let found = space.halfway_knot(&x).unwrap();
                assert_eq!(found, Halfway { knot: None, regime: Regime::There, leg: k });
            }
        }
    }

    #[test]
    fn no_knot_beyond_the_ends() {
        let space = SplineSpace::bezier(3, 0.0, 1.0).unwrap();
        for x in [0.0, 1.0] {
            let none = ShapeError::NoHalfwayKnot { parameter: x.to_string() };
            assert_eq!(space.halfway_knot_or_copy(&x), Err(none.into()));
        }
    }
}
