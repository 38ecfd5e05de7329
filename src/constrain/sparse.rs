//! Linear functionals on few coefficients, anywhere in a list.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::scalar::Scalar;

/// A linear functional with weights on some coefficients: `c -> Σ w_i c_i`.
///
/// Indices ascend, no weight is zero. A [`Functional`] has neighbouring weights; control points of a surface that have
/// influence at one place are not neighbours in its list, so this one names each.
///
/// # Examples
/// ```
/// use symspline::SparseRow;
/// let row = SparseRow::new([(7, 0.5), (2, 1.0), (7, 1.5), (3, 0.0)]);
/// assert_eq!(row.terms(), [(2, 1.0), (7, 2.0)]);
/// assert_eq!(row.weight(7), Some(&2.0));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct SparseRow<T> {
    terms: Vec<(usize, T)>,
}

impl<T: Scalar> SparseRow<T> {
    /// The functional with the given weights; those of one index are added up, zeros left out.
    pub fn new(terms: impl IntoIterator<Item = (usize, T)>) -> Self {
        let mut terms: Vec<(usize, T)> = terms.into_iter().collect();
        if !terms.is_sorted_by(|(i, _), (j, _)| i < j) {
            terms.sort_by_key(|(i, _)| *i);
            terms.dedup_by(|(i, w), (j, sum)| {
                let same = i == j;
                if same {
                    *sum += &*w;
                }
                same
            });
        }
        terms.retain(|(_, w)| !w.is_zero());
        Self { terms }
    }

    /// A functional on the coefficients of a list of `dim`, indices wrapped.
    ///
    /// # Panics
    /// If `dim` is zero.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Functional, SparseRow};
    /// let row = SparseRow::from_functional(&Functional::new(2, [1.0, 5.0]), 3);
    /// assert_eq!(row.terms(), [(0, 5.0), (2, 1.0)]);
    /// ```
    pub fn from_functional(functional: &Functional<T>, dim: usize) -> Self {
        let at = |k: usize| (functional.first() + k) % dim;
        Self::new(functional.weights().iter().enumerate().map(|(k, w)| (at(k), w.clone())))
    }

    /// The indices and weights, indices ascending.
    pub fn terms(&self) -> &[(usize, T)] {
        &self.terms
    }

    /// The weight at `index`, unless it is zero.
    pub fn weight(&self, index: usize) -> Option<&T> {
        let found = self.terms.binary_search_by_key(&index, |(i, _)| *i).ok()?;
        Some(&self.terms[found].1)
    }

    /// Refuses weights beyond a list of `length`, and those that are not finite.
    pub(crate) fn check(&self, length: usize) -> Result<()> {
        if let Some((index, _)) = self.terms.last().filter(|(i, _)| *i >= length) {
            return Err(Error::IndexOutOfRange { index: *index, length });
        }
        match self.terms.iter().position(|(_, w)| !w.is_finite()) {
            Some(index) => Err(Error::NotFinite { what: "weight", index }),
            None => Ok(()),
        }
    }

    /// The functional without the weights at some indices.
    #[must_use]
    pub fn without(&self, left_out: impl Fn(usize) -> bool) -> Self {
        Self { terms: self.terms.iter().filter(|(i, _)| !left_out(*i)).cloned().collect() }
    }

    /// The value on `coeffs`; none for a functional without weights.
    ///
    /// # Panics
    /// If a weight stands beyond the last coefficient.
    ///
    /// # Examples
    /// ```
    /// use symspline::SparseRow;
    /// assert_eq!(SparseRow::new([(1, 2.0), (3, 1.0)]).apply(&[9.0, 1.0, 9.0, 5.0]), Some(7.0));
    /// ```
    pub fn apply<C: Coeff<T>>(&self, coeffs: &[C]) -> Option<C> {
        C::combine(self.terms.iter().map(|(i, w)| (w, &coeffs[*i])))
    }
}
