//! Lengths within a part, and where a length is reached.

use super::ArcLength;
use super::gauss::RULES;
use super::jet::UNIT;

/// How many steps there are at most; when Newton's method does not get on, each halves the interval.
const STEPS: usize = 128;

impl<const N: usize> ArcLength<N> {
    /// The length up to `t` of part `index`, counted from 0 to 1.
    ///
    /// The rule of the part serves any smaller part from its start as well: the ellipse of that is within the ellipse
    /// of the part. And chords and polygons of smaller parts are nearer to each other.
    pub(super) fn within(&self, index: usize, t: f64) -> f64 {
        let part = &self.parts[index];
        self.starts[index] + (self.local(index, t) * part.unit).min(part.length)
    }

    /// The length up to `t` of part `index`, from the start of the part and in its unit.
    fn local(&self, index: usize, t: f64) -> f64 {
        let part = &self.parts[index];
        match part.rule {
            _ if t <= 0.0 => 0.0,
            Some(rule) => t * RULES[rule].mean(0.0, t, |s| part.piece.speed(&self.degree, s)),
            None => {
                let [before, _] = part.piece.split(t);
                let (chord, polygon) = before.enclosure();
                chord + (polygon - chord).max(0.0) / 2.0
            }
        }
    }

    /// The parameter where the curve has the length `s`.
    ///
    /// Newton's method, within an interval that shrinks about the solution.
    pub(super) fn inverse(&self, s: f64) -> f64 {
        let index = self.starts.partition_point(|start| *start <= s).saturating_sub(1);
        let part = &self.parts[index];
        if part.length == 0.0 {
            return part.global(0.0);
        }
        let whole = part.length / part.unit;
        let target = ((s - self.starts[index]) / part.unit).clamp(0.0, whole);
        if target == 0.0 || target == whole {
            return part.global(if target == 0.0 { 0.0 } else { 1.0 });
        }
        let (mut low, mut high, mut t) = (0.0_f64, 1.0_f64, target / whole);
        for _ in 0..STEPS {
            let off = self.local(index, t) - target;
            if off < 0.0 {
                low = t;
            } else {
                high = t;
            }
            if off.abs() <= 2.0 * UNIT * whole || high - low <= UNIT {
                break;
            }
            let step = t - off / part.piece.speed(&self.degree, t);
            let next = if step > low && step < high { step } else { low + (high - low) / 2.0 };
            if next == t {
                break;
            }
            t = next;
        }
        part.global(t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Result;
    use crate::rational::spline::NurbsCurve;
    use crate::space::SplineSpace;
    use crate::spline::Curve;
    use nalgebra::vector;

    /// The span has nine parameters, more than half of the length is before the second one, in many parts.
    #[test]
    fn spans_of_a_few_parameters() -> Result<()> {
        let (a, b) = (-1e6, -1e6 + 9.0 * 1e-10);
        let points: Vec<_> =
            (0..7).map(|i| vector![(1.3 * f64::from(i)).sin(), (2.1 * f64::from(i)).cos()]).collect();
        let weights = (0..7).map(|i| 1e-3_f64.powi(i)).rev().collect::<Vec<_>>();
        let curve = NurbsCurve::new(SplineSpace::bezier(6, a, b)?, points, weights)?;
        for curve in [curve.reversed()?, curve] {
            let length = curve.arc_length(&1e-10)?;
            assert_eq!((length.at(&a)?, length.at(&b)?), (0.0, length.total()));
            for s in length.evenly(20)? {
                assert!((a..=b).contains(&s));
            }
        }
        Ok(())
    }

    #[test]
    fn bounds_count_rounding() -> Result<()> {
        // Of the data, of the pieces and of the sum, for a line; of the origin, for one that is far away.
        let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 0.0], vector![3.0, 4.0]])?;
        assert!(line.arc_length(&1e-3)?.bound() >= 16.5 * UNIT * 5.0);
        let far =
            Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![1e9, 0.0], vector![1e9 + 1.0, 0.0]])?;
        assert!(NurbsCurve::from_polynomial(&far)?.arc_length(&1e-3)?.bound() >= UNIT * 1e9);
        Ok(())
    }
}
