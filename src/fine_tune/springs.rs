//! How stiff the springs are that hold a closed curve together.

use crate::error::tune::TuneError;
use crate::error::{Error, Result};

/// How stiff the springs are that [`fine_tuned_closed`](crate::Curve::fine_tuned_closed) relaxes, and how far it goes.
///
/// # Examples
/// ```
/// use symspline::Springs;
/// let stiff = Springs { bend: 20.0, fixed: vec![0, 3], ..Springs::default() };
/// assert_eq!((stiff.stretch, Springs::default().bend), (1.0, 2.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Springs {
    /// The constant `k_l` of the legs, for lengths in units of the longest side of the curve's bounding box. It is 1.
    pub stretch: f64,
    /// The constant `k_a` of the joints, for angles in radians. It is 2: the larger, the better curvature keeps its
    /// shape.
    pub bend: f64,
    /// Whether all legs are of one material: then the constant of a leg is `k_l` times the mean length over its own, both at
    /// rest. They are not in (13), where long legs can press short ones to nothing.
    pub uniform: bool,
    /// The indices of control points of the result that stay where those of the unscaled curve are. There are none.
    pub fixed: Vec<usize>,
    /// The most steps. They are 2000.
    pub iterations: usize,
    /// The springs are at rest where the energy could fall by about half the square of this times `max(k_l, k_a)`. It is
    /// `1e-9`.
    pub tolerance: f64,
}

impl Default for Springs {
    fn default() -> Self {
        Self { stretch: 1.0, bend: 2.0, uniform: false, fixed: Vec::new(), iterations: 2000, tolerance: 1e-9 }
    }
}

impl Springs {
    /// Refuses springs without strength, points that are not among `count`, and tolerances that are none.
    pub(crate) fn check(&self, count: usize) -> Result<()> {
        for constant in [self.stretch, self.bend] {
            if !(constant > 0.0 && constant.is_finite()) {
                return Err(TuneError::SpringConstant { constant: constant.to_string() }.into());
            }
        }
        if !(self.tolerance >= 0.0 && self.tolerance.is_finite()) {
            return Err(Error::BadTolerance { tolerance: self.tolerance.to_string() });
        }
        match self.fixed.iter().find(|&&index| index >= count) {
            Some(&index) => Err(Error::IndexOutOfRange { index, length: count }),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_springs_are_refused() {
        let check = |springs: Springs| springs.check(3);
        for k in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let refused = Err(TuneError::SpringConstant { constant: k.to_string() }.into());
            assert_eq!(check(Springs { stretch: k, ..Springs::default() }), refused);
            assert_eq!(check(Springs { bend: k, ..Springs::default() }), refused);
        }
        for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(check(Springs { tolerance, ..Springs::default() }).is_err());
        }
        let refused = Err(Error::IndexOutOfRange { index: 3, length: 3 });
        assert_eq!(check(Springs { fixed: vec![2, 3], ..Springs::default() }), refused);
        assert_eq!(check(Springs { fixed: vec![2, 0, 2], ..Springs::default() }), Ok(()));
    }
}
