//! Interpolation and least squares: banded solves, linear in the number of points.
//!
//! Whether the data determine the spline is decided before anything is solved: every coefficient needs a parameter of
//! its own, in order, at which its basis function does not vanish (Schoenberg and Whitney; [deBoor, 2001]). Least
//! squares solve the normal equations `Σ_k N_i(x_k) (f(x_k) - d_k) = 0`, which over `Q` is exact.

use crate::build::collocate::{border, check_data, solved, values};
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::linalg::BandedSystem;
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::spline::Spline;

/// What least squares do with the first and last point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ends {
    /// They count like the others.
    Free,
    /// The spline starts at the first and ends at the last point exactly.
    Held,
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The spline of `space` with the values `data` at `parameters`, of which there are as many as coefficients.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`]; [`Error::NotFinite`]; [`Error::OutsideDomain`];
    /// [`Error::ParametersDecrease`] unless parameters are in order; [`Error::Undetermined`] if a coefficient has no
    /// parameter of its own; [`Error::Singular`] for a periodic space in which the data leave a freedom all the same, in
    /// `f64` up to rounding.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, interpolation_space};
    /// let parameters = [0.0, 1.0, 2.0, 4.0];
    /// let f = Function::interpolating(&interpolation_space(3, &parameters)?, &parameters, &[0.0, 1.0, 8.0, 64.0])?;
    /// assert!((f.at(&3.0)? - 27.0).abs() < 1e-13);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn interpolating(space: &SplineSpace<T>, parameters: &[T], data: &[C]) -> Result<Self> {
        check_data(space, parameters, data)?;
        if parameters.len() != space.dim() {
            return Err(Error::CoefficientCount { expected: space.dim(), found: parameters.len() });
        }
        solved(space, values(space, parameters)?.iter(), data.iter().cloned())
    }

    /// The spline of `space` with the least sum of squared distances to `data` at `parameters`.
    ///
    /// In `f64` the normal equations square the condition of the problem: on very uneven knots, or with hardly more data
    /// than coefficients, half of the digits may be lost where [`interpolating`](Self::interpolating) keeps all.
    ///
    /// # Errors
    /// As [`interpolating`](Self::interpolating), but there may be more data than coefficients.
    /// To hold ends the space must be clamped ([`Error::NotClamped`]) and have two coefficients, and the parameters must
    /// start and end where the domain does ([`Error::DomainMismatch`]).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Ends, Function, SplineSpace};
    /// let line = SplineSpace::bezier(1, 0.0, 2.0)?;
    /// let fit = Function::least_squares(&line, &[0.0, 1.0, 2.0], &[0.0, 3.0, 0.0], Ends::Free)?;
    /// assert!(fit.coeffs().iter().all(|c| (c - 1.0).abs() < 1e-14));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn least_squares(space: &SplineSpace<T>, parameters: &[T], data: &[C], ends: Ends) -> Result<Self> {
        check_data(space, parameters, data)?;
        if ends == Ends::Held {
            check_ends(space, parameters)?;
        }
        let (p, dim) = (space.degree(), space.dim());
        let rows = values(space, parameters)?;
        // Normal equation i has weights on the unrolled coefficients i - p ..= i + p, stored from i - p.
        let mut normal = vec![vec![T::zero(); 2 * p + 1]; dim];
        let mut right: Vec<C> = vec![data[0].zero_like(); dim];
        for (row, value) in rows.iter().zip(data) {
            for (k, w) in row.weights().iter().enumerate() {
                let i = space.slot(row.first() + k);
                right[i].add_scaled(w, value);
                for (l, v) in row.weights().iter().enumerate() {
                    normal[i][p + l - k] += w.clone() * v;
                }
            }
        }
        let mut system = BandedSystem::new(dim, border(space));
        for (i, (weights, value)) in normal.iter().zip(right).enumerate() {
            match (ends, i) {
                (Ends::Held, 0) => system.push(0, &[T::one()], data[0].clone()),
                (Ends::Held, i) if i + 1 == dim => system.push(i, &[T::one()], data[data.len() - 1].clone()),
                // An open space has no coefficients before the first or after the last: those weights are zero.
                _ if !space.is_periodic() => {
                    let (skip, take) = (p.saturating_sub(i), (dim + p - i).min(2 * p + 1));
                    system.push(i + skip - p, &weights[skip..take], value);
                }
                _ => system.push(i + p.div_ceil(dim) * dim - p, weights, value),
            }
        }
        Spline::new(space.clone(), system.solve()?)
    }

    /// The largest squared distance of the spline from `data` at `parameters`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::CoefficientCount`] if the counts differ; [`Error::NotFinite`] for data that are
    /// not, or if a square overflows.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Ends, Function, SplineSpace};
    /// let (parameters, data) = ([0.0, 1.0, 2.0], [0.0, 3.0, 0.0]);
    /// let fit = Function::least_squares(&SplineSpace::bezier(0, 0.0, 2.0)?, &parameters, &data, Ends::Free)?;
    /// assert_eq!(fit.largest_squared_residual(&parameters, &data)?, 4.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn largest_squared_residual(&self, parameters: &[T], data: &[C]) -> Result<T> {
        if parameters.len() != data.len() {
            return Err(Error::CoefficientCount { expected: parameters.len(), found: data.len() });
        }
        let values = self.eval(parameters)?;
        let squared = |(value, datum): (&C, &C)| value.minus(datum).squared_size();
        let squares: Vec<T> = values.iter().zip(data).map(squared).collect();
        match squares.iter().position(|square| !square.is_finite()) {
            Some(index) => Err(Error::NotFinite { what: "residual", index }),
            None => Ok(squares.into_iter().fold(T::zero(), larger)),
        }
    }
}

/// That the first and last coefficient are the values at the first and last parameter.
fn check_ends<T: Scalar>(space: &SplineSpace<T>, parameters: &[T]) -> Result<()> {
    if !space.is_clamped() {
        return Err(Error::NotClamped);
    }
    if space.dim() < 2 {
        return Err(Error::CoefficientCount { expected: 2, found: space.dim() });
    }
    let ((a, b), (first, last)) = (space.domain(), (&parameters[0], &parameters[parameters.len() - 1]));
    if (a, b) == (first, last) {
        return Ok(());
    }
    Err(Error::DomainMismatch { left: format!("[{a}, {b}]"), right: format!("[{first}, {last}]") })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spline::Function;

    #[test]
    fn repeated_parameters_say_nothing_new() {
        let space = SplineSpace::bezier(7, 0.0, 1.0).unwrap();
        let parameters = [0.0, 0.1, 0.2, 0.2, 0.5, 0.6, 0.8, 0.8, 1.0];
        let fit = Function::least_squares(&space, &parameters, &[1.0; 9], Ends::Free);
        // At 1 only the last basis function is not zero: the one before it is left without a parameter.
        assert_eq!(fit, Err(Error::Undetermined { index: 6 }));
    }

    #[test]
    fn rings_that_cannot_interpolate_are_refused() {
        // Quadratics at the knots of an even number of equal spans: alternating data have no answer.
        for spans in [2, 4, 6, 8, 10, 50, 100] {
            let space = SplineSpace::uniform_periodic(2, spans, 0.0, 1.0).unwrap();
            let parameters: Vec<f64> = (0..spans).map(|i| i as f64 / spans as f64).collect();
            let data: Vec<f64> = (0..spans).map(|i| (i * i % 7) as f64).collect();
            let fit = Function::interpolating(&space, &parameters, &data);
            assert!(matches!(fit, Err(Error::Singular { .. })), "{spans}: {fit:?}");
        }
    }

    #[test]
    fn rings_with_an_odd_number_of_spans_interpolate() {
        for spans in [1, 3, 5, 51] {
            let space = SplineSpace::uniform_periodic(2, spans, 0.0, 1.0).unwrap();
            let parameters: Vec<f64> = (0..spans).map(|i| i as f64 / spans as f64).collect();
            let data: Vec<f64> = (0..spans).map(|i| (i * i % 7) as f64).collect();
            let fit = Function::interpolating(&space, &parameters, &data).unwrap();
            assert!(fit.largest_squared_residual(&parameters, &data).unwrap() < 1e-24);
        }
    }
}
