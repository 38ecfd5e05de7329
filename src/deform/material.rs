//! What a deformation costs.

use crate::coeff::{Coeff, check_shapes};
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::gather::Gather;
use crate::limits::{check_degree, check_entries};
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;

/// An elastic material: what the derivatives of a deformation cost.
///
/// ```text
/// E(f) = Σ_k w_k ∫ |f^(k)|²        w_0 = γ,  w_1 = α,  w_2 = β
/// ```
/// `α` resists stretching and `β` bending [Vassilev, (1) and (2)]; `γ` makes the material hard, so that deformations become
/// narrow [Vassilev, (25)]. Integrals are sums over the spans: where the spline is only continuous a material that resists
/// nothing but bending is a hinge.
///
/// # Examples
/// ```
/// use symspline::{Function, Material, Q, Scalar};
/// let material = Material::new(Q::int(3), Q::int(1))?;
/// // 3 ∫ (2x)² + ∫ 2² on [0, 1].
/// assert_eq!(material.energy(&Function::monomial(2, Q::int(0), Q::int(1))?)?, Q::int(8));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Material<T> {
    /// By the order of the derivative; the last is not zero.
    weights: Vec<T>,
}

impl<T: Scalar> Material<T> {
    /// The material with resistance `α` to stretching and `β` to bending.
    ///
    /// # Errors
    /// [`DeformError::Material`] for a weight that is negative or not finite.
    pub fn new(stretching: T, bending: T) -> Result<Self> {
        Self::of_orders([T::zero(), stretching, bending])
    }

    /// The material with weights for the derivatives of order 0, 1, 2 and so on.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use symspline::Material;
    /// assert_eq!(Material::of_orders([0.0, 1.0, 2.0])?, Material::new(1.0, 2.0)?);
    /// assert!(Material::new(1.0, -2.0).is_err());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn of_orders(weights: impl IntoIterator<Item = T>) -> Result<Self> {
        let mut kept = Vec::new();
        for (order, weight) in weights.into_iter().enumerate() {
            check_degree(order)?;
            if !(weight >= T::zero() && weight.is_finite()) {
                return Err(DeformError::Material { order, weight: weight.to_string() }.into());
            }
            kept.push(weight);
        }
        while kept.last().is_some_and(T::is_zero) {
            kept.pop();
        }
        Ok(Self { weights: kept })
    }

    /// The same material with the hardness `γ`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// # Examples
    /// ```
    /// use symspline::Material;
    /// assert_eq!(Material::new(1.0, 2.0)?.with_hardness(0.5)?.weights(), [0.5, 1.0, 2.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn with_hardness(&self, hardness: T) -> Result<Self> {
        Self::of_orders(std::iter::once(hardness).chain(self.weights.iter().skip(1).cloned()))
    }

    /// The weights of the derivatives of order 0, 1, 2 and so on, down to the last that is not zero.
    pub fn weights(&self) -> &[T] {
        &self.weights
    }

    /// The least order of a derivative that has a weight.
    pub(crate) fn lowest_order(&self) -> Option<usize> {
        self.weights.iter().position(|w| !w.is_zero())
    }

    /// The stiffness matrix `K = Σ_k w_k K_k` with `K_k = ∫ N^(k) N^(k)ᵀ`, for which `E(f) = cᵀ K c` [Vassilev, (4) to (7)
    /// and (24)].
    ///
    /// It is what [`SplineSpace::gram`] of derivatives gives, and exists where these jump too.
    ///
    /// # Errors
    /// [`Error::TooLarge`]; [`Error::NotFinite`] if in floating point an entry is beyond the range.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Material, Q, Scalar, SplineSpace};
    /// let space = SplineSpace::clamped(3, [0, 1, 3, 4].map(Q::int))?;
    /// let bending = Material::of_orders([0, 0, 1].map(Q::int))?.matrix(&space)?;
    /// assert_eq!(bending, space.gram(&space, 2, 2)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn matrix(&self, space: &SplineSpace<T>) -> Result<LinearMap<T>> {
        let p = space.degree();
        let mut bands = Bands::new(space)?;
        self.each_square(space, |first, row, weight| {
            for (i, x) in row.iter().enumerate() {
                let scaled = weight.clone() * x;
                let entries = &mut bands.row(first + i)[p - i..];
                entries.iter_mut().zip(row).for_each(|(entry, y)| *entry += scaled.clone() * y);
            }
        });
        bands.gathered()
    }

    /// The energy `E(f)`: a sum of squares, never negative.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn energy<C: Coeff<T>>(&self, f: &Spline<T, C>) -> Result<T> {
        let (space, coeffs) = (f.space(), f.coeffs());
        let mut energy = T::zero();
        self.each_square(space, |first, row, weight| energy += square(space, (first, row), coeffs) * weight);
        if energy.is_finite() { Ok(energy) } else { Err(Error::NotFinite { what: "energy", index: 0 }) }
    }

    /// Half of the gradient of the energy, `K c = Σ w a (a · c)`, without `K`: in floating point a small energy comes of
    /// small products `a · c`, whose rounding `K` would multiply by its condition.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`], [`Error::Ragged`]; [`Error::NotFinite`] on overflow.
    pub(crate) fn gradient<C: Coeff<T>>(&self, space: &SplineSpace<T>, coeffs: &[C]) -> Result<Vec<C>> {
        if coeffs.len() != space.dim() {
            return Err(Error::CoefficientCount { expected: space.dim(), found: coeffs.len() });
        }
        check_shapes(coeffs)?;
        let mut gradient: Vec<C> = coeffs.iter().map(C::zero_like).collect();
        self.each_square(space, |first, row, weight| {
            let terms = row.iter().enumerate().map(|(i, x)| (x, &coeffs[space.slot(first + i)]));
            let mut value = C::combine(terms).expect("a span has coefficients");
            value.scale(weight);
            row.iter().enumerate().for_each(|(i, x)| gradient[space.slot(first + i)].add_scaled(x, &value));
        });
        match gradient.iter().position(|x| !x.all_finite()) {
            Some(index) => Err(Error::NotFinite { what: "gradient", index }),
            None => Ok(gradient),
        }
    }

    /// The energy as a sum of squares `Σ w (Σ_i a_i c[first + i])²` with `p + 1` weights `a` each and unrolled indices, span
    /// by span: `f^(k)` on a span in polynomials that are orthogonal there.
    pub(crate) fn each_square(&self, space: &SplineSpace<T>, square: impl FnMut(usize, &[T], &T)) {
        self.each_square_on(space, space.spans(), square);
    }

    /// The squares of the energy on these spans, which are not empty.
    pub(crate) fn each_square_on(
        &self,
        space: &SplineSpace<T>,
        spans: impl Iterator<Item = usize>,
        mut square: impl FnMut(usize, &[T], &T),
    ) {
        let (p, t) = (space.degree(), space.knots());
        let orders = || self.weights.iter().enumerate().take(p + 1).filter(|(_, w)| !w.is_zero());
        let bases: Vec<Orthogonal<T>> = orders().map(|(k, _)| Orthogonal::new(p - k)).collect();
        for k in spans {
            let length = t[k + 1].clone() - &t[k];
            // Row j has the weights of Bernstein coefficient j.
            let mut rows = Vec::with_capacity(p + 1);
            space.each_bernstein(k, |first, weights| {
                let mut row = vec![T::zero(); p + 1];
                row[first..first + weights.len()].clone_from_slice(weights);
                rows.push(row);
            });
            let mut order = 0;
            for ((next, weight), basis) in orders().zip(&bases) {
                while order < next {
                    let factor = T::int((p - order) as i64) / &length;
                    differentiate(&mut rows, &factor);
                    order += 1;
                }
                basis.each(&rows, |row, share| square(k - p, row, &(weight.clone() * &length * share)));
            }
        }
    }
}

/// The square `|Σ_i a_i c[first + i]|²`, indices unrolled.
pub(crate) fn square<T: Scalar, C: Coeff<T>>(
    space: &SplineSpace<T>,
    (first, row): (usize, &[T]),
    coeffs: &[C],
) -> T {
    let terms = row.iter().enumerate().map(|(i, x)| (x, &coeffs[space.slot(first + i)]));
    let value = C::combine(terms).expect("a span has coefficients");
    T::dot(value.components().map(|x| (x, x)))
}

/// A matrix on the coefficients of a space that joins those of common spans: entry `j - i + p` of row `i` stands for `j`.
pub(crate) struct Bands<'a, T> {
    space: &'a SplineSpace<T>,
    entries: Vec<T>,
}

impl<'a, T: Scalar> Bands<'a, T> {
    /// All zero.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    pub(crate) fn new(space: &'a SplineSpace<T>) -> Result<Self> {
        let (n, width) = (space.dim(), 2 * space.degree() + 1);
        check_entries(n, width)?;
        Ok(Self { space, entries: vec![T::zero(); n * width] })
    }

    /// The row of a coefficient, by its unrolled index.
    pub(crate) fn row(&mut self, i: usize) -> &mut [T] {
        let width = 2 * self.space.degree() + 1;
        &mut self.entries[self.space.slot(i) * width..][..width]
    }

    /// The rows with indices wrapped.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub(crate) fn gathered(self) -> Result<LinearMap<T>> {
        let (p, n) = (self.space.degree(), self.space.dim());
        let mut gather = Gather::new(n);
        let mut map = LinearMap::empty(n, n);
        for (i, row) in self.entries.chunks_exact(2 * p + 1).enumerate() {
            if !row.iter().all(T::is_finite) {
                return Err(Error::NotFinite { what: "row of the stiffness matrix", index: i });
            }
            let at = |k: usize| (i + k + p * n - p) % n;
            row.iter()
                .enumerate()
                .filter(|(_, x)| !x.is_zero())
                .for_each(|(k, x)| gather.add(at(k), x.clone()));
            map.push_with(|weights| gather.drain_into(weights));
        }
        Ok(map)
    }
}

/// Replaces rows by the differences of neighbours times `factor`.
fn differentiate<T: Scalar>(rows: &mut Vec<Vec<T>>, factor: &T) {
    for j in 1..rows.len() {
        let (before, after) = rows.split_at_mut(j);
        for (x, y) in before[j - 1].iter_mut().zip(&after[0]) {
            *x = (y.clone() - &*x) * factor;
        }
    }
    rows.pop();
}

/// The mean of a squared polynomial over a span by its Bernstein coefficients, as a sum of squares: `G = L D Lᵀ` with the Gram
/// matrix `G` of Bernstein polynomials of degree `q` on `[0, 1]`.
///
/// ```text
/// L_ij = C(q, i) C(i, j) i! (2q - i - j)! / (C(q, j) j! (2q - 2j)!)        D_j = (C(q, j) / C(2q + 1 - j, j))² / (2q - 2j + 1)
/// ```
/// `q_j = (L⁻¹ B)_j` is `(1 - t)^(q - j)` times a Jacobi polynomial. No entry is negative, and none is a difference.
struct Orthogonal<T> {
    /// Below the diagonal of `L`, column by column.
    lower: Vec<Vec<T>>,
    diagonal: Vec<T>,
}

impl<T: Scalar> Orthogonal<T> {
    fn new(q: usize) -> Self {
        let fraction = |a: usize, b: usize| T::frac(a as i64, b as i64);
        let column = |j: usize| {
            let ratio = |i: usize| fraction((q - i) * (i + 1), (i + 1 - j) * (2 * q - i - j));
            let next = |entry: &mut T, i: usize| {
                *entry *= ratio(i);
                Some(entry.clone())
            };
            (j..q).scan(T::one(), next).collect()
        };
        let pivot = |j: usize| {
            let ratio = (0..j).fold(T::one(), |r, l| r * fraction(q - l, 2 * q + 1 - j - l));
            ratio.clone() * ratio * fraction(1, 2 * (q - j) + 1)
        };
        Self { lower: (0..=q).map(column).collect(), diagonal: (0..=q).map(pivot).collect() }
    }

    /// Hands out the squares for Bernstein coefficients that are given as rows.
    fn each(&self, rows: &[Vec<T>], mut square: impl FnMut(&[T], &T)) {
        for (k, (column, pivot)) in self.lower.iter().zip(&self.diagonal).enumerate() {
            let mut row = rows[k].clone();
            for (factor, other) in column.iter().zip(&rows[k + 1..]) {
                row.iter_mut().zip(other).for_each(|(x, y)| *x += factor.clone() * y);
            }
            square(&row, pivot);
        }
    }
}
