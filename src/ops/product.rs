//! Products: scalar with scalar, scalar with curve, dot, cross, or any bilinear pairing of coefficients.
//!
//! On each span both factors have Bernstein coefficients, and those of the product are convex combinations,
//!
//! ```text
//! c_k = Σ_{i+j=k} C(p, i) C(q, j) / C(p + q, k) a_i b_j
//! ```
//!
//! From them the [recomposition](SplineSpace::recomposition) makes the coefficients of the product space. No system is
//! solved, and the cost is linear in the number of spans. That a coefficient of the product is a mean of products of
//! polar values [Morken, 1991], [Ramshaw, 1989] is the definition with which the tests compare.

use crate::bernstein::Shares;
use crate::bilinear::{BilinearMap, Window};
use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Function, Spline};
use crate::vector::{cross2, cross3, dot};
use std::ops::Mul;

impl<T: Scalar> SplineSpace<T> {
    /// The product as a bilinear map from coefficients of this space and of `other` to coefficients of
    /// [`product_space`](Self::product_space).
    ///
    /// Fixing one side gives the table of products by a known factor, see [`BilinearMap::fix_left`].
    ///
    /// # Errors
    /// [`Error::DomainMismatch`], [`Error::DegreeTooHigh`], [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::SplineSpace;
    /// let lines = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let table = lines.multiplication(&lines)?.fix_left(&[1.0, 3.0])?;
    /// assert_eq!(table.apply(&[1.0, 3.0])?, [1.0, 3.0, 9.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn multiplication(&self, other: &Self) -> Result<BilinearMap<T>> {
        let target = self.product_space(other)?;
        let (p, q) = (self.degree(), other.degree());
        let left = self.embedding(&target.pieces(p)?)?;
        let right = other.embedding(&target.pieces(q)?)?;
        let shares = Shares::<T>::new(p, q);
        let rows = target.recomposition()?;
        let row = |(first, weights): (usize, &[T])| {
            let (piece, offset) = (first / (p + q + 1), first % (p + q + 1));
            let mut window = Window::default();
            for (k, weight) in (offset..).zip(weights) {
                for (i, j, share) in shares.meeting(k) {
                    let weight = weight.clone() * share;
                    window.add_outer(&weight, left.row(piece * (p + 1) + i), right.row(piece * (q + 1) + j));
                }
            }
            window.into_row(self.dim(), other.dim())
        };
        BilinearMap::from_rows(self.dim(), other.dim(), rows.rows().map(row).collect::<Result<Vec<_>>>()?)
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The product under any pairing of coefficients that is linear in both.
    ///
    /// The result lies in the [product space](SplineSpace::product_space): clamped, or periodic if both factors
    /// are. Nothing checks that `pair` is bilinear.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`], [`Error::DegreeTooHigh`], [`Error::TooLarge`]; [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// // The complex product of two lines.
    /// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![1.0, 0.0], vector![0.0, 1.0]])?;
    /// let square = line.product_by(&line, |c, d| vector![c[0] * d[0] - c[1] * d[1], c[0] * d[1] + c[1] * d[0]])?;
    /// assert_eq!(square.at(&1.0)?, vector![-1.0, 0.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn product_by<A, B>(&self, other: &Spline<T, A>, pair: impl Fn(&C, &A) -> B) -> Result<Spline<T, B>>
    where
        A: Coeff<T>,
        B: Coeff<T>,
    {
        let target = self.space().product_space(other.space())?;
        let (p, q) = (self.degree(), other.degree());
        let ends = target.ends();
        let (left, right) = (self.bernstein(&ends)?, other.bernstein(&ends)?);
        let (pieces, divisors) = Shares::new(p, q).multiply_cleared(&left, &right, &pair);
        let coeffs = target.recomposed(&ends, &pieces, &divisors);
        Spline::new(target, coeffs)
    }

    /// The product with a scalar spline.
    ///
    /// # Errors
    /// As [`product_by`](Self::product_by).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Function, SplineSpace};
    /// let x = Function::monomial(1, 0.0, 1.0)?;
    /// let hat = Function::new(SplineSpace::clamped(1, [0.0, 0.5, 1.0])?, vec![0.0, 1.0, 0.0])?;
    /// let product = hat.times(&x)?;
    /// assert_eq!((product.degree(), product.at(&0.25)?), (2, 0.125));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn times(&self, factor: &Function<T>) -> Result<Self> {
        self.product_by(factor, |c, w| c.scaled(w))
    }
}

impl<T: Scalar, const N: usize> Curve<T, N> {
    /// The dot product of two curves, a scalar spline.
    ///
    /// # Errors
    /// As [`product_by`](Spline::product_by).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![0.0, 0.0], vector![3.0, 4.0]])?;
    /// assert_eq!(line.dot(&line)?.coeffs(), [0.0, 0.0, 25.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn dot(&self, other: &Self) -> Result<Function<T>> {
        self.product_by(other, dot)
    }

    /// Coordinate `axis` of the curve as a scalar spline.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let line = Curve::new(SplineSpace::bezier(1, 0.0, 1.0)?, vec![vector![1.0, 2.0], vector![3.0, 4.0]])?;
    /// assert_eq!(line.coordinate(1)?.coeffs(), [2.0, 4.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn coordinate(&self, axis: usize) -> Result<Function<T>> {
        if axis >= N {
            return Err(Error::IndexOutOfRange { index: axis, length: N });
        }
        self.map_coeffs(|c| c[axis].clone())
    }
}

impl<T: Scalar> Curve<T, 2> {
    /// The cross product `x_1 y_2 - y_1 x_2` of two plane curves, a scalar spline.
    ///
    /// # Errors
    /// As [`product_by`](Spline::product_by).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let points = vec![vector![0.0, 0.0], vector![1.0, 0.0], vector![1.0, 1.0]];
    /// let curve = Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?;
    /// // Twice the area swept from the origin.
    /// assert!((curve.cross(&curve.derivative()?)?.integral()? - 2.0 / 3.0).abs() < 1e-15);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn cross(&self, other: &Self) -> Result<Function<T>> {
        self.product_by(other, cross2)
    }
}

impl<T: Scalar> Curve<T, 3> {
    /// The cross product of two space curves.
    ///
    /// # Errors
    /// As [`product_by`](Spline::product_by).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace};
    /// let space = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let [f, g] = [vector![1.0, 0.0, 0.0], vector![0.0, 1.0, 0.0]].map(|c| Curve::constant(space.clone(), c));
    /// assert_eq!(f?.cross(&g?)?.at(&0.5)?, vector![0.0, 0.0, 1.0]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn cross(&self, other: &Self) -> Result<Self> {
        self.product_by(other, cross3)
    }
}

impl<T: Scalar, C: Coeff<T>> Mul<&Spline<T, C>> for &Function<T> {
    type Output = Spline<T, C>;

    /// The [product](Spline::times) of a scalar spline and any spline.
    ///
    /// # Panics
    /// With the text of its error.
    fn mul(self, other: &Spline<T, C>) -> Spline<T, C> {
        other.times(self).unwrap_or_else(|error| panic!("{error}"))
    }
}

impl<T: Scalar, C: Coeff<T>> Mul<Spline<T, C>> for Function<T> {
    type Output = Spline<T, C>;

    fn mul(self, other: Spline<T, C>) -> Spline<T, C> {
        &self * &other
    }
}

impl<T: Scalar, const N: usize> Mul<&Function<T>> for &Curve<T, N> {
    type Output = Curve<T, N>;

    /// The [product](Spline::times) of a curve and a scalar spline.
    ///
    /// # Panics
    /// With the text of its error.
    fn mul(self, factor: &Function<T>) -> Curve<T, N> {
        factor * self
    }
}
