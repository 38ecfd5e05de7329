//! Weights at scattered indices, gathered into one row.

use crate::scalar::Scalar;

/// A sum of weights at scattered indices, gathered into one row.
pub(crate) struct Gather<T> {
    dense: Vec<T>,
    seen: Vec<bool>,
    /// The slots seen, each once.
    touched: Vec<usize>,
}

impl<T: Scalar> Gather<T> {
    pub(crate) fn new(dim: usize) -> Self {
        Self { dense: vec![T::zero(); dim], seen: vec![false; dim], touched: Vec::new() }
    }

    pub(crate) fn add(&mut self, index: usize, weight: T) {
        let slot = wrap(index, self.dense.len());
        self.dense[slot] += weight;
        if !std::mem::replace(&mut self.seen[slot], true) {
            self.touched.push(slot);
        }
    }

    /// Appends the shortest row, cyclically, that holds all touched weights; returns its first index.
    pub(crate) fn drain_into(&mut self, weights: &mut Vec<T>) -> usize {
        let dim = self.dense.len();
        self.touched.sort_unstable();
        let Some((&lowest, &highest)) = self.touched.first().zip(self.touched.last()) else { return 0 };
        // The row starts after the widest gap between touched slots; the gap at the seam wins ties.
        let seam_gap = lowest + dim - highest;
        let inner = self.touched.windows(2).map(|pair| (pair[1] - pair[0], pair[1]));
        let widest = inner.max_by_key(|gap| gap.0).filter(|gap| gap.0 > seam_gap);
        let (gap, first) = widest.unwrap_or((seam_gap, lowest));
        let take = |i: usize| std::mem::replace(&mut self.dense[wrap(first + i, dim)], T::zero());
        weights.extend((0..=dim - gap).map(take));
        self.touched.drain(..).for_each(|slot| self.seen[slot] = false);
        first
    }
}

/// `index` modulo `dim`, without a division where it need not wrap.
#[inline]
pub(crate) fn wrap(index: usize, dim: usize) -> usize {
    if index < dim { index } else { index % dim }
}
