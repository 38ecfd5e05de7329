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
            return part.start;
        }
        let whole = part.length / part.unit;
        let target = ((s - self.starts[index]) / part.unit).clamp(0.0, whole);
        if target == 0.0 || target == whole {
            return if target == 0.0 { part.start } else { part.end };
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
        (part.start + (part.end - part.start) * t).clamp(part.start, part.end)
    }
}
