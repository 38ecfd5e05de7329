//! Polynomials on neighbouring intervals, each by its Bernstein coefficients; how they meet does not matter.
//!
//! So sums, products and derivatives of any order are taken interval by interval, also where a spline would need more
//! knots than it may have.

use crate::bernstein::Shares;
use crate::coeff::Coeff;
use crate::error::Result;
use crate::limits::{check_degree, check_dim};
use crate::roots::Polynomial;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use std::sync::Arc;

/// One polynomial of `degree` between each two neighbours of `ends`.
#[derive(Clone, Debug)]
pub(crate) struct Pieces<T, C = T> {
    ends: Arc<[T]>,
    degree: usize,
    coeffs: Vec<C>,
}

impl<T: Scalar, C: Coeff<T>> Pieces<T, C> {
    /// The pieces of a spline between `ends`, which leave out no knot between them.
    pub(crate) fn of(spline: &Spline<T, C>, ends: &Arc<[T]>) -> Result<Self> {
        Ok(Self { ends: ends.clone(), degree: spline.degree(), coeffs: spline.bernstein(ends)? })
    }

    /// The degree of all of them.
    pub(crate) fn degree(&self) -> usize {
        self.degree
    }

    /// How many polynomials there are.
    pub(crate) fn count(&self) -> usize {
        self.ends.len() - 1
    }

    /// The Bernstein coefficients of one of them.
    pub(crate) fn piece(&self, i: usize) -> &[C] {
        &self.coeffs[i * (self.degree + 1)..(i + 1) * (self.degree + 1)]
    }

    /// From where to where one of them goes.
    pub(crate) fn interval(&self, i: usize) -> [&T; 2] {
        [&self.ends[i], &self.ends[i + 1]]
    }

    /// The value of one of them at `x`, by the algorithm of de Casteljau.
    pub(crate) fn at(&self, i: usize, x: &T) -> C {
        let [a, b] = self.interval(i);
        let width = b.clone() - a;
        let (u, v) = ((x.clone() - a) / &width, (b.clone() - x) / &width);
        let mut c = self.piece(i).to_vec();
        for last in (0..self.degree).rev() {
            (0..=last).for_each(|j| c[j] = c[j].scaled(&v).plus_scaled(&u, &c[j + 1]));
        }
        c.swap_remove(0)
    }

    /// The derivatives; of constants zero.
    pub(crate) fn derivative(&self) -> Self {
        if self.degree == 0 {
            return self.map(C::zero_like);
        }
        let (p, degree) = (self.degree, T::int(self.degree as i64));
        let mut coeffs = Vec::with_capacity(self.count() * p);
        for i in 0..self.count() {
            let [a, b] = self.interval(i);
            let slope = degree.clone() / (b.clone() - a);
            let legs = self.piece(i).windows(2).map(|leg| leg[1].minus(&leg[0]).scaled(&slope));
            coeffs.extend(legs);
        }
        Self { ends: self.ends.clone(), degree: p - 1, coeffs }
    }

    /// The polynomials of degree `p - steps` with the coefficients from the `j`-th on, `j <= steps`: those that the
    /// algorithm of de Casteljau blends in its last steps.
    pub(crate) fn inner(&self, steps: usize, j: usize) -> Self {
        let degree = self.degree - steps;
        let coeffs = (0..self.count()).flat_map(|i| self.piece(i)[j..=j + degree].iter().cloned()).collect();
        Self { ends: self.ends.clone(), degree, coeffs }
    }

    /// The multiples by `factor / h^power`, where `h` is the length of the interval.
    pub(crate) fn per_length(mut self, factor: i64, power: usize) -> Self {
        let ends = self.ends.clone();
        for (piece, ends) in self.coeffs.chunks_mut(self.degree + 1).zip(ends.windows(2)) {
            let width = ends[1].clone() - &ends[0];
            let share = (0..power).fold(T::int(factor), |share, _| share / &width);
            piece.iter_mut().for_each(|c| c.scale(&share));
        }
        self
    }

    /// The products under a bilinear pairing.
    pub(crate) fn times<A: Coeff<T>, B: Coeff<T>>(
        &self,
        other: &Pieces<T, A>,
        pair: impl Fn(&C, &A) -> B,
    ) -> Result<Pieces<T, B>> {
        let degree = self.degree + other.degree;
        check_degree(degree)?;
        check_dim(self.count().saturating_mul(degree + 1))?;
        let coeffs = Shares::new(self.degree, other.degree).multiply(&self.coeffs, &other.coeffs, &pair);
        Ok(Pieces { ends: self.ends.clone(), degree, coeffs })
    }

    /// The sums `self + factor * other` with polynomials of the same degree.
    pub(crate) fn plus(&self, factor: i64, other: &Self) -> Self {
        debug_assert_eq!(self.degree, other.degree, "polynomials of one degree");
        let factor = T::int(factor);
        let sums = self.coeffs.iter().zip(&other.coeffs).map(|(c, d)| c.plus_scaled(&factor, d));
        Self { ends: self.ends.clone(), degree: self.degree, coeffs: sums.collect() }
    }

    /// The same polynomials, written with one degree more.
    pub(crate) fn elevated(&self) -> Self {
        let degree = self.degree + 1;
        let mut coeffs = Vec::with_capacity(self.count() * (degree + 1));
        for c in (0..self.count()).map(|i| self.piece(i)) {
            let share = |i: usize| T::frac(i as i64, degree as i64);
            coeffs.push(c[0].clone());
            coeffs.extend(
                (1..degree).map(|i| c[i].scaled(&share(degree - i)).plus_scaled(&share(i), &c[i - 1])),
            );
            coeffs.push(c[degree - 1].clone());
        }
        Self { ends: self.ends.clone(), degree, coeffs }
    }

    /// Every coefficient replaced.
    pub(crate) fn map<A: Coeff<T>>(&self, f: impl Fn(&C) -> A) -> Pieces<T, A> {
        Pieces { ends: self.ends.clone(), degree: self.degree, coeffs: self.coeffs.iter().map(f).collect() }
    }

    /// The spline of these pieces, every knot as often as it may be.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub(crate) fn into_spline(self) -> Result<Spline<T, C>> {
        let copies = self.ends.iter().flat_map(|t| std::iter::repeat_n(t.clone(), self.degree + 1));
        Spline::new(SplineSpace::new(self.degree, copies)?, self.coeffs)
    }
}

impl<T: Scalar> Pieces<T> {
    /// One of the polynomials.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub(crate) fn polynomial(&self, i: usize) -> Result<Polynomial<T>> {
        let [a, b] = self.interval(i);
        Polynomial::new(a.clone(), b.clone(), self.piece(i).to_vec())
    }

    /// The product with a function of as many pieces.
    pub(crate) fn product<C: Coeff<T>>(&self, other: &Pieces<T, C>) -> Result<Pieces<T, C>> {
        self.times(other, |factor, c| c.scaled(factor))
    }
}
