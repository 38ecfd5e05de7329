//! Curvatures measured: enclosed at events, and sampled to be drawn.

use crate::analysis::ball::Ball;
use crate::analysis::certify::Certified;
use crate::analysis::events::Bounds;
use crate::analysis::lifted::{Lifted, Motion};
use crate::analysis::zeros::Place;
use crate::roots::RootValue;

/// How many samples a span has.
const SAMPLES: usize = 24;

/// A curvature to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The parameter.
    pub parameter: f64,
    /// The curvature.
    pub curvature: f64,
    /// The derivative of the curvature by arc length; not a number where a curve in space is straight.
    pub slope: f64,
}

/// Curvatures with bounds.
pub(crate) struct Measure<'a, T, const N: usize> {
    motion: Option<Motion<Ball, N>>,
    ends: &'a [T],
}

impl<'a, T: Certified, const N: usize> Measure<'a, T, N> {
    pub(crate) fn new(curve: &Lifted<T, N>, ends: &'a [T]) -> Self {
        let motion = curve.over(|x| Ok(x.ball())).and_then(|curve| curve.motion(3)).ok();
        Self { motion, ends }
    }

    /// The curvature before and after a place, or inside an interval at its start and end.
    pub(crate) fn around(&self, place: &Place<T>, closed: bool) -> [Bounds; 2] {
        let count = self.ends.len() - 1;
        let (low, high) = place.bounds();
        // The span right of a parameter, and the one left of it.
        let right = |x: &T| (self.ends.partition_point(|t| t <= x) - 1).min(count - 1);
        let left = |x: &T| match self.ends.partition_point(|t| t < x) {
            0 if closed => count - 1,
            i => i.saturating_sub(1),
        };
        match place {
            Place::Along(..) => [self.on(right(low), low, low), self.on(left(high), high, high)],
            Place::At(RootValue::Exact(x)) => {
                let before = left(x);
                let x_before = if closed && *x == self.ends[0] { &self.ends[count] } else { x };
                [self.on(before, x_before, x_before), self.on(right(x), x, x)]
            }
            Place::At(RootValue::Enclosed(..)) => [self.on(right(low), low, high); 2],
        }
    }

    /// The curvature of the curve of span `i` between two parameters.
    fn on(&self, i: usize, low: &T, high: &T) -> Bounds {
        let x = Ball::between(low.ball().bounds().0, high.ball().bounds().1);
        let (low, high) =
            self.motion.as_ref().map_or(Ball::UNKNOWN, |motion| motion.curvature(i, &x)[0]).bounds();
        Bounds { low, high }
    }

    /// Samples of every span, where the curvature is finite.
    pub(crate) fn samples(&self) -> Vec<Sample> {
        let Some(motion) = &self.motion else { return Vec::new() };
        let mut samples = Vec::new();
        for (i, ends) in self.ends.windows(2).enumerate() {
            let [a, b] = [&ends[0], &ends[1]].map(|x| x.ball().middle());
            samples.extend((0..=SAMPLES).filter_map(|j| {
                let x = if j == SAMPLES { b } else { a + (b - a) * (j as f64 / SAMPLES as f64) };
                let [curvature, slope] = motion.curvature(i, &Ball::exact(x)).map(|ball| ball.middle());
                curvature.is_finite().then_some(Sample { parameter: x, curvature, slope })
            }));
        }
        samples
    }
}
