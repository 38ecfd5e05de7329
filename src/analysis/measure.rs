//! Curvatures measured: enclosed at events, and sampled to be drawn.

use crate::analysis::ball::Ball;
use crate::analysis::certify::Certified;
use crate::analysis::events::Bounds;
use crate::analysis::lifted::{Lifted, Motion, wedge};
use crate::analysis::pieces::Pieces;
use crate::analysis::zeros::Place;
use crate::coeff::Coeff;
use crate::roots::RootValue;
use crate::scalar::Scalar;
use crate::vector::dot;
use nalgebra::SVector;
use num_traits::{One, Zero};

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

/// Points and weights, each with its first three derivatives, with bounds.
struct Moving<const N: usize> {
    points: [Pieces<Ball, SVector<Ball, N>>; 4],
    weights: Option<[Pieces<Ball>; 4]>,
}

/// A function and its first three derivatives.
fn derivatives<C: Coeff<Ball>>(value: &Pieces<Ball, C>) -> [Pieces<Ball, C>; 4] {
    let first = value.derivative();
    let second = first.derivative();
    let third = second.derivative();
    [value.clone(), first, second, third]
}

impl<const N: usize> Moving<N> {
    fn new(motion: &Motion<Ball, N>) -> Self {
        Self { points: derivatives(motion.points()), weights: motion.weights().map(derivatives) }
    }

    /// The curvature at `x` of the curve of piece `i`, in the plane with its sign, and its derivative by arc length.
    fn curvature(&self, i: usize, x: &Ball) -> [Ball; 2] {
        let [p, first, second, third] = [0, 1, 2, 3].map(|k| self.points[k].at(i, x));
        let one = [Ball::one(), Ball::zero(), Ball::zero(), Ball::zero()];
        let [w, w1, w2, w3] =
            self.weights.as_ref().map_or(one, |weights| [0, 1, 2, 3].map(|k| weights[k].at(i, x)));
        let (direction, turned) = (first * w - p * w1, second * w - p * w2);
        let bend_with = |change: &SVector<Ball, N>, w2| {
            wedge(&first, change) * w - wedge(&p, change) * w1 + wedge(&p, &first) * w2
        };
        let (bend, bend_slope) = (bend_with(&second, w2), bend_with(&third, w3));
        let (speed, three) = (dot(&direction, &direction), Ball::int(3));
        let rise = bend * (w1 * three) + bend_slope * w;
        let slope = rise * speed - bend * (w * three * dot(&direction, &turned));
        let (bend, slope) = match N < 3 {
            true => (bend[2], slope[2]),
            false => {
                let size = dot(&bend, &bend).root();
                (size, dot(&bend, &slope) / size)
            }
        };
        [w * w * w * bend / (speed * speed.root()), w * w * w * w * slope / (speed * speed * speed)]
    }
}

/// Curvatures with bounds.
pub(crate) struct Measure<'a, T, const N: usize> {
    moving: Option<Moving<N>>,
    ends: &'a [T],
}

impl<'a, T: Certified, const N: usize> Measure<'a, T, N> {
    pub(crate) fn new(curve: &Lifted<T, N>, ends: &'a [T]) -> Self {
        let moving =
            curve.over(|x| Ok(x.ball())).and_then(|curve| curve.motion(0)).ok().as_ref().map(Moving::new);
        Self { moving, ends }
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
            self.moving.as_ref().map_or(Ball::UNKNOWN, |moving| moving.curvature(i, &x)[0]).bounds();
        Bounds { low, high }
    }

    /// Samples of every span, where the curvature is finite.
    pub(crate) fn samples(&self) -> Vec<Sample> {
        let Some(moving) = &self.moving else { return Vec::new() };
        let mut samples = Vec::new();
        for (i, ends) in self.ends.windows(2).enumerate() {
            let [a, b] = [&ends[0], &ends[1]].map(|x| x.ball().middle());
            samples.extend((0..=SAMPLES).filter_map(|j| {
                let x = if j == SAMPLES { b } else { a + (b - a) * (j as f64 / SAMPLES as f64) };
                let [curvature, slope] = moving.curvature(i, &Ball::exact(x)).map(|ball| ball.middle());
                curvature.is_finite().then_some(Sample { parameter: x, curvature, slope })
            }));
        }
        samples
    }
}
