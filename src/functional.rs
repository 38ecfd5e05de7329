//! Linear functionals on the coefficients of a spline.

use crate::coeff::Coeff;
use crate::scalar::Scalar;

/// A linear functional with few neighbouring weights: `c -> Σ_k w_k c[first + k]`.
///
/// Indices run on past the last coefficient and wrap to the first, which is what periodic spaces need; in an open
/// space a functional never reaches that far. A functional acts on any coefficients: on numbers, on points.
///
/// # Examples
/// ```
/// use symspline::Functional;
/// let mean = Functional::new(3, [0.5, 0.5]);
/// assert_eq!(mean.apply(&[2.0, 0.0, 0.0, 4.0]), 3.0);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Functional<T> {
    first: usize,
    weights: Vec<T>,
}

impl<T: Scalar> Functional<T> {
    /// The functional with `weights` on the coefficients from `first`.
    pub fn new(first: usize, weights: impl Into<Vec<T>>) -> Self {
        Self { first, weights: weights.into() }
    }

    /// The index of the first weighted coefficient.
    pub fn first(&self) -> usize {
        self.first
    }

    /// The weights.
    pub fn weights(&self) -> &[T] {
        &self.weights
    }

    /// The weights, moved out.
    pub(crate) fn into_weights(self) -> Vec<T> {
        self.weights
    }

    /// The value on `coeffs`.
    ///
    /// # Panics
    /// If `coeffs` is empty.
    pub fn apply<C: Coeff<T>>(&self, coeffs: &[C]) -> C {
        weigh(self.first, &self.weights, coeffs)
    }

    /// The weights spread over `dim` coefficients, wrapped ones added up.
    ///
    /// # Panics
    /// If `dim` is zero.
    ///
    /// # Examples
    /// ```
    /// use symspline::Functional;
    /// assert_eq!(Functional::new(2, [1.0, 5.0]).to_dense(3), [5.0, 0.0, 1.0]);
    /// ```
    pub fn to_dense(&self, dim: usize) -> Vec<T> {
        let mut dense = vec![T::zero(); dim];
        for (k, w) in self.weights.iter().enumerate() {
            dense[(self.first + k) % dim] += w;
        }
        dense
    }
}

/// `Σ_k weights[k] coeffs[first + k]`, indices wrapped.
#[inline(always)]
pub(crate) fn weigh<T: Scalar, C: Coeff<T>>(first: usize, weights: &[T], coeffs: &[C]) -> C {
    let window = first.checked_add(weights.len()).and_then(|end| coeffs.get(first..end));
    match window.and_then(|window| C::combine(weights.iter().zip(window))) {
        Some(sum) => sum,
        None => weigh_wrapped(first, weights, coeffs),
    }
}

/// [`weigh`] where indices wrap, or there are no weights.
#[cold]
#[inline(never)]
fn weigh_wrapped<T: Scalar, C: Coeff<T>>(first: usize, weights: &[T], coeffs: &[C]) -> C {
    let sum = C::combine(weights.iter().zip(coeffs.iter().cycle().skip(first % coeffs.len())));
    sum.unwrap_or_else(|| coeffs[0].zero_like())
}
