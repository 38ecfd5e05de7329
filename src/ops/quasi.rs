//! Quasi-interpolation: a spline near a function, from samples and without a system to solve.
//!
//! On each span the polynomial through `p + 1` samples is taken, and each coefficient is the polar value of the
//! polynomial of one span of its support, see [`recompose`](crate::ops::recompose). So it is local and linear in the number
//! of spans, and a projection: splines of the space, polynomials of degree `p` among them, come back as they are.
//!
//! The samples lie inside the span, denser towards its ends, `a + (b - a) (3 τ² - 2 τ³)` at `τ = (2 l + 1) / (2 p + 2)`: near
//! Chebyshev's points, which keep errors from growing, and rational.

use crate::bernstein::binomials;
use crate::coeff::Coeff;
use crate::error::Result;
use crate::functional::weigh;
use crate::linalg::BandedSystem;
use crate::ops::bound::Approximation;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

impl<T: Scalar> SplineSpace<T> {
    /// The quasi-interpolant of the function that `sample` gives, from `p + 1` samples inside each span.
    ///
    /// A smooth function is met up to a constant times `h^{p+1}`, `h` the length of the longest span.
    ///
    /// That constant grows fast with the degree, since a coefficient looks at one span of its support only, and rounding
    /// grows with it: on many spans `f64` keeps about 11 digits in degree 7, 4 in degree 12 and none in degree 20.
    ///
    /// # Errors
    /// The first error of `sample`; [`NotFinite`](crate::Error::NotFinite) if it gives what is not a number.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let sine: Function<f64> = SplineSpace::uniform(3, 10, 0.0, 1.0)?.quasi_interpolant(|x| Ok(x.sin()))?;
    /// assert!((sine.at(&0.42)? - 0.42_f64.sin()).abs() < 1e-6);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn quasi_interpolant<C: Coeff<T>>(
        &self,
        mut sample: impl FnMut(&T) -> Result<C>,
    ) -> Result<Spline<T, C>> {
        let samples = self.quasi_places().iter().map(&mut sample).collect::<Result<Vec<C>>>()?;
        Spline::new(self.clone(), self.quasi_coeffs(&samples)?)
    }

    /// The parameters of the samples, `p + 1` a span.
    pub(crate) fn quasi_places(&self) -> Vec<T> {
        let p = self.degree();
        let nodes: Vec<T> = (0..=p).map(|l| node(l, p)).collect();
        let place = |a: &T, b: &T, node: &T| a.clone() + (b.clone() - a) * node;
        let ends = self.ends();
        ends.windows(2).flat_map(|ends| nodes.iter().map(|node| place(&ends[0], &ends[1], node))).collect()
    }

    /// The coefficients of the quasi-interpolant with these samples.
    pub(crate) fn quasi_coeffs<C: Coeff<T>>(&self, samples: &[C]) -> Result<Vec<C>> {
        let p = self.degree();
        let interpolation = local_interpolation::<T>(p)?;
        let piece = |samples| interpolation.iter().map(move |weights| weigh(0, weights, samples));
        let pieces: Vec<C> = samples.chunks(p + 1).flat_map(piece).collect();
        Ok(self.recomposed(&self.ends(), &pieces, &[]))
    }

    /// The parameters of the samples, and of a clamped space both ends.
    pub(crate) fn places_with_ends(&self) -> Vec<T> {
        let (a, b) = self.domain();
        let end = |x: &T| self.is_clamped().then(|| x.clone());
        end(a).into_iter().chain(self.quasi_places()).chain(end(b)).collect()
    }

    /// What `operator` makes of samples inside spans, but the samples at the ends of a clamped space, which are its end values.
    pub(crate) fn with_ends<C: Coeff<T>>(
        &self,
        samples: &[C],
        operator: impl FnOnce(&[C]) -> Result<Vec<C>>,
    ) -> Result<Vec<C>> {
        let [start, inside @ .., end] = samples else { return operator(samples) };
        if !self.is_clamped() {
            return operator(samples);
        }
        let mut coeffs = operator(inside)?;
        let last = coeffs.len() - 1;
        coeffs[0] = start.clone();
        coeffs[last] = end.clone();
        Ok(coeffs)
    }

    /// For each coefficient the mean, over a span in the middle of its support, of the polynomial with these samples.
    pub(crate) fn middle_means<C: Coeff<T>>(&self, samples: &[C]) -> Result<Vec<C>> {
        let (p, t, ends) = (self.degree(), self.knots(), self.ends());
        let rows = local_interpolation::<T>(p)?;
        let share = T::frac(1, p as i64 + 1);
        let weight = |l: usize| rows.iter().fold(T::zero(), |sum, row| sum + &row[l]) * &share;
        let weights: Vec<T> = (0..=p).map(weight).collect();
        let means: Vec<C> = samples.chunks(p + 1).map(|samples| weigh(0, &weights, samples)).collect();
        let (start, end) = self.domain();
        let inside = |k: &usize| t[*k] < t[k + 1] && t[*k] >= *start && t[*k] < *end;
        let middle = |j: usize| (j..=j + p).filter(inside).min_by_key(|k| (2 * k).abs_diff(2 * j + p));
        // In a ring a coefficient may have its support before the start.
        let found = |j: usize| {
            let k =
                middle(j).or_else(|| middle(j + self.dim())).expect("every coefficient has a span under it");
            means[ends.partition_point(|a| *a <= t[k]) - 1].clone()
        };
        Ok((0..self.dim()).map(found).collect())
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// A spline of `target` near this one, by [quasi-interpolation](SplineSpace::quasi_interpolant), with a certified bound:
    /// the same function if `target` contains it.
    ///
    /// # Errors
    /// [`DomainMismatch`](crate::Error::DomainMismatch); [`NotFinite`](crate::Error::NotFinite) on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, Q, Scalar, SplineSpace};
    /// let square = Function::monomial(2, Q::int(0), Q::int(2))?;
    /// let target = SplineSpace::clamped(3, [0, 1, 2].map(Q::int))?;
    /// let near = square.quasi_interpolated(&target)?;
    /// assert_eq!((near.spline, near.bound), (square.embedded(&target)?, Q::int(0)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn quasi_interpolated(&self, target: &SplineSpace<T>) -> Result<Approximation<Self, T>> {
        self.space().check_same_domain(target)?;
        let mut span = self.degree();
        let spline = target.quasi_interpolant(|x| self.at_near(x, &mut span))?;
        let bound = self.distance_bound(&spline)?;
        Ok(Approximation { spline, bound })
    }
}

/// Sample `l` of `0 ..= p` in the unit interval.
fn node<T: Scalar>(l: usize, p: usize) -> T {
    let place = T::frac(2 * l as i64 + 1, 2 * p as i64 + 2);
    place.clone() * &place * (T::int(3) - T::int(2) * place)
}

/// For each Bernstein coefficient of the polynomial of degree `p` through the samples their weights.
fn local_interpolation<T: Scalar>(p: usize) -> Result<Vec<Row<T>>> {
    let choose = binomials::<T>(p);
    let mut system = BandedSystem::new(p + 1, 0);
    for l in 0..=p {
        let u = node::<T>(l, p);
        let v = T::one() - &u;
        let power = |x: &T, n: usize| (0..n).fold(T::one(), |product, _| product * x);
        let basis: Vec<T> = (0..=p).map(|j| choose[j].clone() * power(&u, j) * power(&v, p - j)).collect();
        let unit = Row((0..=p).map(|i| if i == l { T::one() } else { T::zero() }).collect());
        system.push(0, &basis, unit);
    }
    system.solve()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;
    use crate::spline::Function;

    #[test]
    fn domains_must_agree() {
        let long = Function::monomial(1, 0.0, 2.0).unwrap();
        let target = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
        assert!(matches!(long.quasi_interpolated(&target), Err(Error::DomainMismatch { .. })));
    }

    #[test]
    fn what_is_no_number_is_refused() {
        let space = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
        let nowhere = space.quasi_interpolant(|_| Ok(f64::NAN));
        assert_eq!(nowhere.unwrap_err(), Error::NotFinite { what: "coefficient", index: 0 });
        let refused = space.quasi_interpolant::<f64>(|_| Err(Error::NotPeriodic));
        assert_eq!(refused.unwrap_err(), Error::NotPeriodic);
    }

    #[test]
    fn four_times_the_spans_take_a_cubic_error_down_by_four_to_the_fourth() {
        let error = |spans: usize| {
            let space = SplineSpace::uniform(3, spans, 0.0, 1.0).unwrap();
            let f = space.quasi_interpolant(|x: &f64| Ok((5.0 * x).sin())).unwrap();
            let off = |i: i32| (f.at(&(f64::from(i) / 1000.0)).unwrap() - (f64::from(i) / 200.0).sin()).abs();
            (0..=1000).map(off).fold(0.0, f64::max)
        };
        assert!(error(40) < 1e-6 && error(10) / error(40) > 200.0);
    }
}
