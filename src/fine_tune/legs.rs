//! A closed fine-tuned curve by the legs of its control polygon.
//!
//! For periodic `C` and `α` the derivative `E = α C'` is periodic, and so are the legs of the control polygon of
//! `D(t) = C(a) + ∫_a^t E`, though `D` is not:
//!
//! ```text
//! leg_i = Q_{i+1} - Q_i = E_i (t_{i+m+1} - t_i) / (m + 1),    Σ leg_i = D(b) - D(a)
//! ```
//! over one period, with `m` and `t` degree and knots of `E`. In the [space of antiderivatives] coefficient `i + 1` starts at
//! the knot where coefficient `i` of `E` does, so that leg `i` goes from `Q_i` to `Q_{i+1}` there, the last one back to `Q_0`.
//!
//! [space of antiderivatives]: crate::SplineSpace::antiderivative_space

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::spline::{Curve, Function};
use nalgebra::SVector;

/// The product `α C'` of a periodic curve and a periodic scale function.
///
/// # Errors
/// [`Error::NotPeriodic`], [`Error::DomainMismatch`], [`Error::Discontinuous`], [`Error::NotFinite`].
pub(crate) fn scaled_speed<T: Scalar, const N: usize>(
    curve: &Curve<T, N>,
    alpha: &Function<T>,
) -> Result<Curve<T, N>> {
    if !curve.space().is_periodic() || !alpha.space().is_periodic() {
        return Err(Error::NotPeriodic);
    }
    curve.derivative()?.times(alpha)
}

/// The legs of the control polygons whose curves have the periodic derivative `speed`.
pub(crate) fn legs<T: Scalar, const N: usize>(speed: &Curve<T, N>) -> Vec<SVector<T, N>> {
    let coeffs = speed.coeffs().iter().enumerate();
    coeffs.map(|(i, c)| c.scaled(&speed.space().mass(i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use crate::fine_tune::scale::Scale;
    use crate::space::SplineSpace;
    use nalgebra::vector;

    fn q(n: usize) -> Q {
        // Numbers without a pattern.
        Q::frac((n * n * 7 + n * 3) as i64 % 23 - 11, 1 + (n * 5) as i64 % 4)
    }

    /// Rings over one domain: simple and multiple knots, at the seam too.
    fn ring(degree: usize, kind: usize) -> SplineSpace<Q> {
        let knots = match kind {
            0 => vec![0, 1, 2, 3, 4],
            1 => vec![0, 2, 3],
            2 => vec![0, 0, 1, 4, 4],
            3 => vec![0],
            _ => vec![0, 3, 3, 3],
        };
        let mut knots: Vec<i64> = knots;
        // A curve of degree p may have p copies of a knot.
        let runs: Vec<Vec<i64>> = knots.chunk_by(i64::eq).map(<[i64]>::to_vec).collect();
        knots = runs.into_iter().flat_map(|run| run.into_iter().take(degree.max(1))).collect();
        SplineSpace::periodic(degree, knots.into_iter().map(Q::int), Q::int(6)).unwrap()
    }

    fn cases() -> impl Iterator<Item = (Curve<Q, 2>, Function<Q>)> {
        (0..250).map(|seed| {
            let (n, kind) = (1 + seed % 4, seed / 4 % 5);
            let space = ring(n, kind);
            let points = (0..space.dim()).map(|i| vector![q(seed + i), q(3 * seed + 7 * i)]).collect();
            let scale = ring(seed % 3, seed / 20 % 5);
            let levels = (0..scale.dim()).map(|i| q(5 * seed + i)).collect();
            (Curve::new(space, points).unwrap(), Function::new(scale, levels).unwrap())
        })
    }

    #[test]
    fn legs_add_up_to_the_drift() {
        for (curve, alpha) in cases() {
            let legs = legs(&scaled_speed(&curve, &alpha).unwrap());
            let open = curve.fine_tuned(Scale::Signed(&alpha)).unwrap();
            let points = open.coeffs();
            let drift = points[points.len() - 1].minus(&points[0]);
            let sum = legs
                .iter()
                .fold(SVector::zeros(), |sum: SVector<Q, 2>, leg| sum.plus_scaled(&Q::int(1), leg));
            assert_eq!(sum, drift);
        }
    }

    #[test]
    fn open_splines_are_refused() {
        let (curve, alpha) = cases().next().unwrap();
        let open = curve.embedded(&curve.space().clamped_ends().unwrap()).unwrap();
        assert_eq!(scaled_speed(&open, &alpha).unwrap_err(), Error::NotPeriodic);
        let open = Function::monomial(1, Q::int(0), Q::int(6)).unwrap();
        assert_eq!(scaled_speed(&curve, &open).unwrap_err(), Error::NotPeriodic);
    }
}
