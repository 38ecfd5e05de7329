//! A net of springs brought to rest: by conjugate gradients, or by Gauss and Newton's steps.
//!
//! The latter, with `g` the gradient and `H` the [stiffness](super::stiffness), whose diagonal `D` is raised where steps fail:
//!
//! ```text
//! x_{k+1} = x_k - t (H + λ D)⁻¹ g,   t = 1, 1/2, 1/4, ...          [Levenberg, Marquardt]
//! ```

use super::net::Net;
use super::springs::Descend;
use super::stiffness::Stiffness;
use crate::fine_tune::minimise::{Descent, Energy, Limits, dot, minimise};
use crate::fine_tune::records::{ROUNDING, Records};

/// The least damping that is not zero, and the most.
const DAMPING: [f64; 2] = [1e-6, 1e6];
/// The most times a step is halved.
const HALVINGS: usize = 6;

/// Who is told after so many steps the energy and the length of the gradient, and says whether to go on.
pub(super) type Watch<'a> = &'a mut dyn FnMut(usize, f64, f64) -> bool;

/// Moves the points that may move to where the energy is least nearby.
pub(super) fn relax(
    x: &mut [f64],
    limits: &Limits,
    descend: Descend,
    net: &mut Net,
    watch: Watch<'_>,
) -> Descent {
    let stiffness = Stiffness::of(net);
    let mut resting = Resting { net, stiffness, watch };
    match descend {
        Descend::ConjugateGradients => minimise(x, limits, &mut resting),
        Descend::GaussNewton => gauss_newton(x, limits, &mut resting),
    }
}

/// A net that is watched while it comes to rest.
struct Resting<'a> {
    net: &'a mut Net,
    stiffness: Stiffness,
    watch: Watch<'a>,
}

impl Energy for Resting<'_> {
    const RENEWAL: usize = 20;

    fn value(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        self.net.energy(x, gradient)
    }

    fn renew(&mut self, x: &[f64]) {
        self.net.lay(x);
        self.stiffness.renew(self.net, 0.0);
    }

    fn soften(&mut self, gradient: &mut [f64]) {
        self.stiffness.soften(gradient);
    }

    fn goes_on(&mut self, steps: usize, value: f64, gradient: f64) -> bool {
        (self.watch)(steps, value, gradient)
    }
}

/// See the text above.
fn gauss_newton(x: &mut [f64], limits: &Limits, resting: &mut Resting<'_>) -> Descent {
    let (mut gradient, mut softened, mut probe) = (vec![0.0; x.len()], vec![0.0; x.len()], x.to_vec());
    let before = resting.net.energy(x, &mut gradient);
    let (mut value, mut iterations, mut evaluations, mut damping) = (before, 0, 1, 0.0);
    let (mut size, mut records) = (f64::INFINITY, Records::new());
    loop {
        resting.net.lay(x);
        resting.stiffness.renew(resting.net, damping);
        softened.copy_from_slice(&gradient);
        resting.stiffness.soften(&mut softened);
        let slope = dot(&gradient, &softened);
        size = if slope >= 0.0 { slope.sqrt() } else { size };
        let spent = iterations >= limits.iterations || evaluations >= limits.evaluations;
        let done = slope.is_nan() || size <= limits.gradient || damping > DAMPING[1];
        let done = done || records.end(value, slope);
        if done || spent || !(resting.watch)(iterations, value, size) {
            break;
        }
        let ceiling = value + ROUNDING * value.abs();
        let mut t = 1.0;
        let mut found = None;
        for _ in 0..HALVINGS {
            for (to, (from, z)) in probe.iter_mut().zip(x.iter().zip(&softened)) {
                *to = from - t * z;
            }
            let next = resting.net.energy(&probe, &mut gradient);
            evaluations += 1;
            let flatter = next <= ceiling && dot(&gradient, &softened).abs() <= 0.9 * slope;
            if flatter || next < value - 1e-4 * t * slope.max(0.0) {
                found = Some(next);
                break;
            }
            t *= 0.5;
        }
        match found {
            Some(next) => {
                x.copy_from_slice(&probe);
                (value, iterations) = (next, iterations + 1);
                damping = match t {
                    1.0 if damping > DAMPING[0] => 0.1 * damping,
                    1.0 => 0.0,
                    _ => damping,
                };
            }
            None => {
                resting.net.energy(x, &mut gradient);
                damping = (10.0 * damping).max(DAMPING[0]);
            }
        }
    }
    if damping > 0.0 {
        // Damping makes what is left look small.
        resting.renew(x);
        softened.copy_from_slice(&gradient);
        resting.soften(&mut softened);
        let square = dot(&gradient, &softened);
        size = if square >= 0.0 { square.sqrt() } else { f64::INFINITY };
    }
    let converged = size <= limits.gradient && value.is_finite();
    Descent { before, value, gradient: size, iterations, converged }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fine_tune::mesh::net::Constants;
    use crate::fine_tune::mesh::net::tests::{mesh, net, noise};

    const LIMITS: Limits = Limits { gradient: 1e-8, iterations: 300, evaluations: 3000 };
    const EQUAL: Constants = Constants { stretch: 1.0, bend: 1.0, shape: 1.0, uniform: false };

    #[test]
    fn the_energy_never_rises_whatever_the_limit() {
        for descend in [Descend::ConjugateGradients, Descend::GaussNewton] {
            let mut last = f64::INFINITY;
            for iterations in 0..12 {
                let mut net = net(mesh(true, 0.1, 3), |e| 1.0 + e as f64 / 12.0, |v| v > 2, true, &EQUAL);
                let (mut x, mut told) = (net.coordinates(), Vec::new());
                let limits = Limits { iterations, ..LIMITS };
                let found = relax(&mut x, &limits, descend, &mut net, &mut |step, value, _| {
                    told.push((step, value));
                    true
                });
                assert!(found.iterations <= iterations && found.value <= last, "{descend:?} {iterations}");
                let energy = net.energy(&x, &mut vec![0.0; x.len()]);
                assert!((found.value - energy).abs() <= 1e-14 * energy);
                assert!(told.windows(2).all(|two| two[1].0 == two[0].0 + 1 || two[1] == two[0]));
                last = found.value;
            }
        }
    }

    #[test]
    fn both_come_to_rest_where_they_were_and_from_far_away() {
        for descend in [Descend::ConjugateGradients, Descend::GaussNewton] {
            // The net is at rest as it is; it is let go from a crumpled state.
            let mut net = net(mesh(true, 0.1, 9), |_| 1.0, |v| v > 5, true, &EQUAL);
            let (rest, mut next) = (net.coordinates(), noise(2));
            let mut x: Vec<f64> = rest.iter().map(|x| x + 0.1 * next()).collect();
            let found = relax(&mut x, &LIMITS, descend, &mut net, &mut |_, _, _| true);
            assert!(found.converged && found.value < 1e-14, "{descend:?} {found:?}");
            assert!(x.iter().zip(&rest).all(|(x, r)| (x - r).abs() < 1e-6));
        }
    }

    #[test]
    fn they_stop_when_told() {
        for descend in [Descend::ConjugateGradients, Descend::GaussNewton] {
            let mut net = net(mesh(true, 0.1, 3), |e| 1.0 + e as f64 / 12.0, |_| true, true, &EQUAL);
            let mut x = net.coordinates();
            let found = relax(&mut x, &LIMITS, descend, &mut net, &mut |step, _, _| step < 3);
            assert!(!found.converged && found.iterations == 3 && found.value < found.before);
        }
    }
}
