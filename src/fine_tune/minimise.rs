//! The least value of a smooth function of many numbers, by nonlinear conjugate gradients.
//!
//! ```text
//! d_0 = -z_0,   x_{k+1} = x_k + t d_k,   d_{k+1} = -z_{k+1} + β d_k,   β = max(0, z_{k+1}·(g_{k+1} - g_k) / z_k·g_k)
//! ```
//! with `g` the gradient and `z = M g`, where `M` is near to the inverse of the second derivatives or, for want of anything
//! better, the identity: the method of Polak and Ribière. It starts anew by itself where `β` would be negative, and here also
//! where `d` does not go down or no step is found. `M` may change on the way, as long as it changes little at a time.
//!
//! The step `t` is found from slopes along `d`, by secants within a bracket, until the slope is a tenth of what it was;
//! values only say whether a step is too long. So the search works down to gradients whose effect on the value is lost in
//! rounding.
//!
//! Each step takes a few values and a number of operations linear in the number of unknowns, and allocates nothing.

use crate::fine_tune::records::{ROUNDING, Records};

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// The length `√(g·z)` of the gradient that is small enough.
    pub gradient: f64,
    /// The most steps.
    pub iterations: usize,
    /// The most values taken, but for the few that end a step.
    pub evaluations: usize,
}

/// What a descent came to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Descent {
    /// The value at the start.
    pub before: f64,
    /// The value reached, above the first by no more than rounding.
    pub value: f64,
    /// The length `√(g·z)` of the gradient there: the value could fall by about half of its square.
    pub gradient: f64,
    /// The steps taken.
    pub iterations: usize,
    /// Whether the gradient is as small as asked for.
    pub converged: bool,
}

/// How much smaller than at its start the slope along a line must be at its end.
const FLATTER: f64 = 0.1;
/// The most values along a line.
const TRIALS: usize = 40;
/// The least slope of a direction, relative to that of the steepest one.
const STEEP: f64 = 1e-6;

/// A function to be minimised.
pub(crate) trait Energy {
    /// After so many steps `M` is renewed.
    const RENEWAL: usize = usize::MAX;

    /// The value at `x`, which may be infinite or no number, and its gradient.
    fn value(&mut self, x: &[f64], gradient: &mut [f64]) -> f64;

    /// Makes `M` for places near `x`.
    fn renew(&mut self, _: &[f64]) {}

    /// Multiplies a gradient by `M`, which is symmetric and positive.
    fn soften(&mut self, _: &mut [f64]) {}

    /// Told after so many steps the value and the length of the gradient; whether to go on.
    fn goes_on(&mut self, _steps: usize, _value: f64, _gradient: f64) -> bool {
        true
    }
}

impl<F: FnMut(&[f64], &mut [f64]) -> f64> Energy for F {
    fn value(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        self(x, gradient)
    }
}

/// Moves `x` down to where `energy` is least nearby.
pub(crate) fn minimise<F: Energy>(x: &mut [f64], limits: &Limits, energy: &mut F) -> Descent {
    let n = x.len();
    let mut probe = Probe { energy, x: x.to_vec(), gradient: vec![0.0; n], evaluations: 0 };
    let (mut old, mut soft, mut direction) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    let mut here = Spot { t: 0.0, value: probe.evaluate(), slope: 0.0 };
    let before = here.value;
    let (mut iterations, mut age) = (0, 0);
    let (mut square, mut fall, mut anew) = (0.0, 0.0, true);
    let mut records = Records::new();
    loop {
        if age >= F::RENEWAL || anew {
            probe.energy.renew(x);
            age = 0;
        }
        let last = std::mem::replace(&mut square, probe.soften(&mut soft));
        let beta = if anew { 0.0 } else { ((square - dot(&soft, &old)) / last).max(0.0) };
        old.copy_from_slice(&probe.gradient);
        turn(&mut direction, &soft, beta);
        let mut slope = dot(&old, &direction);
        if slope > -STEEP * square {
            turn(&mut direction, &soft, 0.0);
            slope = -square;
        }
        let spent = iterations >= limits.iterations || probe.evaluations >= limits.evaluations;
        let done = square.is_nan() || square.sqrt() <= limits.gradient || records.end(here.value, square);
        if done || spent || !probe.energy.goes_on(iterations, here.value, square.sqrt()) {
            break;
        }
        // The natural first step is 1; then the value is to fall by as much as in the last one.
        let step = if anew { 1.0 } else { here.t * fall / slope };
        fall = slope;
        match probe.search(x, &direction, Spot { t: 0.0, value: here.value, slope }, step) {
            Some(there) => {
                x.copy_from_slice(&probe.x);
                here = there;
                (iterations, age, anew) = (iterations + 1, age + 1, false);
            }
            None if anew => break,
            None => {
                probe.gradient.copy_from_slice(&old);
                anew = true;
            }
        }
    }
    let gradient = if square.is_nan() { f64::INFINITY } else { square.sqrt() };
    let converged = gradient <= limits.gradient && here.value.is_finite();
    Descent { before, value: here.value, gradient, iterations, converged }
}

/// A place on a line, with value and slope there.
#[derive(Clone, Copy, Debug)]
struct Spot {
    t: f64,
    value: f64,
    slope: f64,
}

/// The function, and the last place where its value was taken.
struct Probe<'a, F> {
    energy: &'a mut F,
    x: Vec<f64>,
    gradient: Vec<f64>,
    evaluations: usize,
}

impl<F: Energy> Probe<'_, F> {
    fn evaluate(&mut self) -> f64 {
        self.evaluations += 1;
        self.energy.value(&self.x, &mut self.gradient)
    }

    /// The softened gradient, and its product with the gradient.
    fn soften(&mut self, soft: &mut [f64]) -> f64 {
        soft.copy_from_slice(&self.gradient);
        self.energy.soften(soft);
        dot(soft, &self.gradient)
    }

    /// The place `x + t direction`.
    fn spot(&mut self, x: &[f64], direction: &[f64], t: f64) -> Spot {
        for (to, (from, d)) in self.x.iter_mut().zip(x.iter().zip(direction)) {
            *to = from + t * d;
        }
        let value = self.evaluate();
        Spot { t, value, slope: dot(&self.gradient, direction) }
    }

    /// A place on the line where it is much flatter than at its start and not higher, which is where the value was taken
    /// last. The first trial is at `first`.
    fn search(&mut self, x: &[f64], direction: &[f64], start: Spot, first: f64) -> Option<Spot> {
        let ceiling = start.value + ROUNDING * start.value.abs();
        // `low` goes down and is not above the start; beyond `high` nobody looks.
        let (mut low, mut high) = (start, None::<Spot>);
        let mut t = first;
        for trial in 0..TRIALS {
            let usable = t.is_finite() && t > low.t && high.is_none_or(|high| t < high.t);
            if !usable {
                break;
            }
            let spot = self.spot(x, direction, t);
            let fits = spot.value <= ceiling && spot.slope.is_finite();
            if fits && spot.slope.abs() <= FLATTER * start.slope.abs() {
                return Some(spot);
            }
            let before = low;
            if fits && spot.slope < 0.0 {
                low = spot;
            } else {
                high = Some(spot);
            }
            t = match high {
                Some(high) => between(low, high, trial),
                None => beyond(before, low),
            };
        }
        // No place flat enough was found, but perhaps a lower one.
        (low.value < start.value).then(|| self.spot(x, direction, low.t))
    }
}

/// Where the line may be flat between a place that goes down and one that does not, or is too high.
fn between(low: Spot, high: Spot, trial: usize) -> f64 {
    let width = high.t - low.t;
    let secant = -low.slope / (high.slope - low.slope);
    // Now and then by half: secants may come from one side only.
    if high.slope > 0.0 && trial % 3 != 2 {
        low.t + width * secant.clamp(0.05, 0.95)
    } else if high.value.is_finite() {
        low.t + 0.5 * width
    } else {
        low.t + 0.1 * width
    }
}

/// Where the line may be flat beyond two places that go down.
fn beyond(before: Spot, last: Spot) -> f64 {
    let secant = last.slope / (before.slope - last.slope) * (last.t - before.t);
    let secant = if before.slope < last.slope { secant } else { f64::INFINITY };
    last.t + secant.clamp(last.t, 9.0 * last.t)
}

/// The direction `-gradient + beta direction`.
fn turn(direction: &mut [f64], gradient: &[f64], beta: f64) {
    for (d, g) in direction.iter_mut().zip(gradient) {
        *d = if beta == 0.0 { -g } else { beta * *d - g };
    }
}

/// The product `Σ a b`.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits = Limits { gradient: 1e-10, iterations: 1000, evaluations: 5000 };

    #[test]
    fn quadratics_take_as_many_steps_as_unknowns() {
        // Σ i (x_i - 1)² / 2: a condition of 12.
        let mut x = vec![0.0; 12];
        let found = minimise(&mut x, &LIMITS, &mut |x: &[f64], g: &mut [f64]| {
            let terms = x.iter().zip(g).enumerate().map(|(i, (x, g))| {
                *g = (i + 1) as f64 * (x - 1.0);
                0.5 * *g * (x - 1.0)
            });
            terms.sum()
        });
        assert!(found.converged && found.iterations <= 24, "{found:?}");
        assert!(x.iter().all(|x| (x - 1.0).abs() < 1e-9), "{x:?}");
        assert!(found.before == 39.0 && found.value < 1e-19, "{found:?}");
    }

    /// A valley bent twice [Rosenbrock].
    fn valley(x: &[f64], g: &mut [f64]) -> f64 {
        let (a, b) = (1.0 - x[0], x[1] - x[0] * x[0]);
        g[0] = -2.0 * a - 400.0 * x[0] * b;
        g[1] = 200.0 * b;
        a * a + 100.0 * b * b
    }

    #[test]
    fn curved_valleys_are_followed() {
        let mut x = [-1.2, 1.0];
        let found = minimise(&mut x, &LIMITS, &mut valley);
        assert!(found.converged && found.iterations < 100, "{found:?}");
        assert!((x[0] - 1.0).abs() < 1e-9 && (x[1] - 1.0).abs() < 1e-9);
    }

    #[test]
    fn the_value_never_rises_whatever_the_limit() {
        let mut last = f64::INFINITY;
        for iterations in 0..40 {
            let mut x = [-1.2, 1.0];
            let found = minimise(&mut x, &Limits { iterations, ..LIMITS }, &mut valley);
            assert!(found.iterations <= iterations && found.value <= last);
            assert_eq!(found.value, valley(&x, &mut [0.0; 2]));
            last = found.value;
        }
        let mut taken = 0;
        let mut counted = |x: &[f64], g: &mut [f64]| {
            taken += 1;
            valley(x, g)
        };
        let limits = Limits { evaluations: 10, ..LIMITS };
        assert!(!minimise(&mut [-1.2, 1.0], &limits, &mut counted).converged);
        assert!(taken <= 10 + TRIALS);
    }

    #[test]
    fn large_constants_do_not_hide_the_minimum() {
        // Near the minimum the value does not change any more, the slope does.
        let mut x = [3.0, 4.0];
        let found = minimise(&mut x, &LIMITS, &mut |x: &[f64], g: &mut [f64]| {
            (g[0], g[1]) = (2.0 * x[0], 20.0 * (x[1] - 1.0));
            1e6 + x[0] * x[0] + 10.0 * (x[1] - 1.0).powi(2)
        });
        assert!(found.converged, "{found:?}");
        assert!(x[0].abs() < 1e-9 && (x[1] - 1.0).abs() < 1e-9);
    }

    #[test]
    fn no_minimum_and_no_numbers_end_all_the_same() {
        let downhill = minimise(&mut [1.0], &LIMITS, &mut |x: &[f64], g: &mut [f64]| {
            g[0] = -1.0;
            -x[0]
        });
        assert!(!downhill.converged);
        for bad in [f64::NAN, f64::INFINITY] {
            let mut x = [1.0, 2.0];
            let found = minimise(&mut x, &LIMITS, &mut |_: &[f64], g: &mut [f64]| {
                g.fill(bad);
                bad
            });
            assert!(!found.converged && x == [1.0, 2.0]);
        }
        // A wall: beyond x = 2 nothing is defined.
        let mut x = [0.0];
        let found = minimise(&mut x, &LIMITS, &mut |x: &[f64], g: &mut [f64]| {
            g[0] = -1.0 / (x[0] - 2.0) - 3.0;
            if x[0] < 2.0 { -(2.0 - x[0]).ln() - 3.0 * x[0] } else { f64::NAN }
        });
        assert!(found.converged && (x[0] - 5.0 / 3.0).abs() < 1e-9, "{found:?} {x:?}");
        assert!(minimise(&mut [], &LIMITS, &mut |_: &[f64], _: &mut [f64]| 0.0).converged);
    }

    /// `Σ 10^i x_i² / 2` and half of a quartic, softened by the squares alone.
    struct Stiff {
        renewed: usize,
    }

    impl Energy for Stiff {
        const RENEWAL: usize = 3;

        fn value(&mut self, x: &[f64], g: &mut [f64]) -> f64 {
            let terms = x.iter().zip(g).enumerate().map(|(i, (x, g))| {
                let k = 10_f64.powi(i as i32);
                *g = k * x + 2.0 * x.powi(3);
                0.5 * (k * x * x + x.powi(4))
            });
            terms.sum()
        }

        fn renew(&mut self, _: &[f64]) {
            self.renewed += 1;
        }

        fn soften(&mut self, g: &mut [f64]) {
            g.iter_mut().enumerate().for_each(|(i, g)| *g *= 0.1_f64.powi(i as i32));
        }
    }

    #[test]
    fn softened_gradients_make_short_work_of_stiff_functions() {
        let (mut x, mut stiff) = (vec![1.0; 9], Stiff { renewed: 0 });
        let found = minimise(&mut x, &LIMITS, &mut stiff);
        assert!(found.converged && found.iterations < 12, "{found:?}");
        assert_eq!(stiff.renewed, 1 + found.iterations / 3);
        // Without it takes ten times as long.
        let mut x = vec![1.0; 9];
        let plain = minimise(&mut x, &LIMITS, &mut |x: &[f64], g: &mut [f64]| stiff.value(x, g));
        assert!(plain.iterations > 10 * found.iterations, "{plain:?}");
    }

    #[test]
    fn a_failed_search_starts_anew_from_where_it_was() {
        let mut taken = 0;
        let mut x = [-1.2, 1.0];
        let found = minimise(&mut x, &LIMITS, &mut |x: &[f64], g: &mut [f64]| {
            taken += 1;
            let value = valley(x, g);
            // No number along a whole line.
            if (10..10 + TRIALS).contains(&taken) {
                g.fill(f64::NAN);
                return f64::NAN;
            }
            value
        });
        assert!(found.converged && taken > 10 + TRIALS, "{found:?}");
        assert!((x[0] - 1.0).abs() < 1e-9);
    }
}
