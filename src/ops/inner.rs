//! Inner products, Gram matrices and moments.
//!
//! ```text
//! <f, g> = ∫ f g        G_ij = ∫ N_i^(k) M_j^(l)
//! ```
//! On a span `[a, b]` Bernstein polynomials have the integrals
//! `∫ B_i^p B_j^q = (b - a) / (p + q + 1) · C(p, i) C(q, j) / C(p + q, i + j)`, so that
//! `G = Eᵀ D F` with the maps `E`, `F` from the spaces to the pieces of their derivatives and `D` block diagonal.

use crate::bernstein::Shares;
use crate::coeff::Coeff;
use crate::error::Result;
use crate::functional::Functional;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Function, Spline};

impl<T: Scalar> SplineSpace<T> {
    /// The Gram matrix `∫ N_i^(k) M_j^(l)` of derivatives of this space (order `k`) and of `other` (order `l`) over
    /// their common domain, as a banded map from coefficients of `other`; row `i` belongs to `N_i`.
    ///
    /// # Errors
    /// [`DomainMismatch`](crate::Error::DomainMismatch), [`Discontinuous`](crate::Error::Discontinuous) if a
    /// derivative does not exist.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, SplineSpace};
    /// let lines = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let gram = lines.gram(&lines, 0, 0)?;
    /// assert_eq!(gram.row(0), (0, &[Q::frac(1, 3), Q::frac(1, 6)][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn gram(&self, other: &Self, k: usize, l: usize) -> Result<LinearMap<T>> {
        let (a, b) = self.domain();
        self.check_same_domain(other)?;
        self.gram_between(other, k, l, a, b)
    }

    /// As [`gram`](Self::gram), integrated from `a` to `b` only.
    ///
    /// # Errors
    /// As [`gram`](Self::gram), and [`OutsideDomain`](crate::Error::OutsideDomain),
    /// [`EmptyDomain`](crate::Error::EmptyDomain).
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let line = SplineSpace::bezier(1, 0.0, 2.0)?;
    /// let slopes = line.gram_between(&line, 1, 1, &0.0, &1.0)?;
    /// assert_eq!(slopes.row(0), (0, &[0.25, -0.25][..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn gram_between(&self, other: &Self, k: usize, l: usize, a: &T, b: &T) -> Result<LinearMap<T>> {
        let factors = self.gram_factors(other, k, l, a, b)?;
        factors.left.after(&factors.blocks.after(&factors.right)?)
    }

    /// The factors of [`gram_between`](Self::gram_between).
    pub(crate) fn gram_factors(
        &self,
        other: &Self,
        k: usize,
        l: usize,
        a: &T,
        b: &T,
    ) -> Result<GramFactors<T>> {
        self.check_same_domain(other)?;
        let (left, left_space) = self.nth_differentiation(k)?;
        let (right, right_space) = other.nth_differentiation(l)?;
        let (f, g) = (left_space.restricted_space(a, b)?, right_space.restricted_space(a, b)?);
        let (p, q) = (f.degree(), g.degree());
        let common = f.pieces(p)?.product_space(&g.pieces(q)?)?;
        let (f_pieces, g_pieces) = (common.pieces(p)?, common.pieces(q)?);
        // Into the pieces, after the derivatives if there are any.
        let cut = |space: &Self, pieces: &Self, derivative: Option<LinearMap<T>>| match derivative {
            None => Ok(space.insertion_rows(pieces)),
            Some(derivative) => space.insertion_rows(pieces).after(&derivative),
        };
        let left = cut(&left_space, &f_pieces, left)?;
        let right = cut(&right_space, &g_pieces, right)?;
        let shares = Shares::<T>::new(p, q);
        let mut blocks = LinearMap::empty(g_pieces.dim(), f_pieces.dim());
        for (piece, ends) in common.breaks().windows(2).enumerate() {
            let scale = (ends[1].0.clone() - &ends[0].0) / T::int((p + q + 1) as i64);
            for row in shares.rows() {
                blocks.push(piece * (q + 1), |weights| {
                    weights.extend(row.iter().map(|share| scale.clone() * share));
                });
            }
        }
        Ok(GramFactors { left: left.transpose(), blocks, right })
    }

    /// The moment `f -> ∫ x^power f(x) dx` over the domain, as a functional.
    ///
    /// # Errors
    /// [`DegreeTooHigh`](crate::Error::DegreeTooHigh); [`NotFinite`](crate::Error::NotFinite) if a power of an end of the
    /// domain overflows.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar, SplineSpace};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// assert_eq!(line.moment(1)?.weights(), [Q::frac(1, 6), Q::frac(1, 3)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn moment(&self, power: usize) -> Result<Functional<T>> {
        let (a, b) = self.domain();
        let monomial = Function::monomial(power, a.clone(), b.clone())?;
        Ok(Functional::new(0, self.gram(monomial.space(), 0, 0)?.apply(monomial.coeffs())?))
    }

    /// The derivative of order `order` as a map, none for the order zero, with its space.
    fn nth_differentiation(&self, order: usize) -> Result<(Option<LinearMap<T>>, Self)> {
        crate::limits::check_degree(order)?;
        (0..order).try_fold((None, self.clone()), |(map, space), _| {
            let (next, step) = (space.derivative_space()?, space.differentiation()?);
            let map = map.map_or_else(|| Ok(step.clone()), |map| step.after(&map))?;
            Ok((Some(map), next))
        })
    }
}

/// `G = left ∘ blocks ∘ right`: to the pieces, their integrals, and back.
pub(crate) struct GramFactors<T> {
    pub left: LinearMap<T>,
    pub blocks: LinearMap<T>,
    pub right: LinearMap<T>,
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The moment `∫ x^power f(x) dx` over the domain.
    ///
    /// # Errors
    /// As [`SplineSpace::moment`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let one = Function::constant(SplineSpace::bezier(0, 0.0, 2.0)?, 1.0)?;
    /// assert_eq!(one.moment(1)?, 2.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn moment(&self, power: usize) -> Result<C> {
        Ok(self.space().moment(power)?.apply(self.coeffs()))
    }

    /// The integral of the product with a scalar spline, `∫ f w`.
    ///
    /// # Errors
    /// As [`times`](Self::times).
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let x = Function::monomial(1, 0.0, 1.0)?;
    /// assert!((Function::monomial(2, 0.0, 1.0)?.weighted_integral(&x)? - 0.25).abs() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn weighted_integral(&self, weight: &Function<T>) -> Result<C> {
        self.times(weight)?.integral()
    }
}

impl<T: Scalar> Function<T> {
    /// The inner product `∫ f g` over the domain.
    ///
    /// # Errors
    /// As [`times`](Spline::times).
    ///
    /// # Examples
    /// ```
    /// use symspline::Function;
    /// let x = Function::monomial(1, 0.0, 3.0)?;
    /// assert!((x.inner(&x)? - 9.0).abs() < 1e-14);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn inner(&self, other: &Self) -> Result<T> {
        self.times(other)?.integral()
    }
}

impl<T: Scalar, const N: usize> Curve<T, N> {
    /// The inner product `∫ f · g` of two curves.
    ///
    /// # Errors
    /// As [`dot`](Curve::dot).
    pub fn inner(&self, other: &Self) -> Result<T> {
        self.dot(other)?.integral()
    }
}
