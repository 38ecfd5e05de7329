//! Products: scalar with scalar, scalar with curve, dot, cross, or any bilinear pairing of coefficients.
//!
//! On each span both factors have Bernstein coefficients, and those of the product are convex combinations,
//!
//! ```text
//! c_k = Σ_{i+j=k} C(p, i) C(q, j) / C(p + q, k) a_i b_j
//! ```
//!
//! From them each coefficient of the product space is the polar value of **one** span of its support at the
//! coefficient's knots. Every span gives the same value, but not the same rounding: an argument `u` outside the span
//! `[a, b]` extrapolates, and amplifies errors by up to `1 + 2 dist(u, [a, b]) / (b - a)`. The span with the least
//! product of these factors is taken. No system is solved, and the cost is linear in the number of spans; the
//! statement that a product's coefficient is a mean of products of polar values is the definition the tests use
//! ([Morken], [Ramshaw]).

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::map::{BilinearMap, BilinearRow, LinearMap};
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Function, Spline};
use crate::vector::{cross2, cross3};
use std::ops::Mul;

impl<T: Scalar> SplineSpace<T> {
    /// The product as a bilinear map from coefficients of this space and of `other` to coefficients of
    /// [`product_space`](Self::product_space).
    ///
    /// Fixing one side gives the table of products by a known factor, see [`BilinearMap::fix_left`].
    ///
    /// # Errors
    /// [`Error::DomainMismatch`], [`Error::DegreeTooHigh`].
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
        let shares = bernstein_shares::<T>(p, q);
        let rows = target.recomposition()?;
        let row = |(first, weights): (usize, &[T])| {
            let (piece, offset) = (first / (p + q + 1), first % (p + q + 1));
            let mut window = Window::default();
            for (k, weight) in (offset..).zip(weights) {
                for i in k.saturating_sub(q)..=p.min(k) {
                    let weight = weight.clone() * &shares[i][k - i];
                    window.add_outer(
                        &weight,
                        left.row(piece * (p + 1) + i),
                        right.row(piece * (q + 1) + k - i),
                    );
                }
            }
            window.into_row(self.dim(), other.dim())
        };
        BilinearMap::from_rows(self.dim(), other.dim(), rows.rows().map(row))
    }

    /// The map from Bernstein coefficients on the spans, those of [`pieces`](Self::pieces) of the same degree, to
    /// coefficients of this space, for piecewise polynomials that lie in it. Each row uses a single piece.
    ///
    /// # Errors
    /// None for a valid space.
    pub fn recomposition(&self) -> Result<LinearMap<T>> {
        let (p, tau) = (self.degree(), self.knots());
        let pieces = self.pieces(p)?;
        let spans: Vec<usize> = pieces.spans().collect();
        let breaks: Vec<&T> = spans.iter().map(|&k| &pieces.knots()[k]).chain([pieces.domain().1]).collect();
        let mut map = LinearMap::empty(pieces.dim(), self.dim());
        let (mut args, mut free) = (Vec::with_capacity(p), Vec::with_capacity(p));
        // The spans under unrolled coefficient j; a wrapped coefficient also has those of its other end.
        let mut start = 0;
        let mut under = |j: usize| {
            while start + 1 < spans.len() && *breaks[start + 1] <= tau[j] {
                start += 1;
            }
            // A wrapped coefficient may lie past the last span altogether.
            let from = start + usize::from(*breaks[start + 1] <= tau[j]);
            let count = breaks[from..spans.len()].iter().take_while(|a| ***a < tau[j + p + 1]).count();
            (j, from, from + count)
        };
        let mut candidates: Vec<_> = (0..self.unrolled_dim()).map(&mut under).collect();
        let wrapped = candidates.split_off(self.dim());
        for (j, from, to) in candidates {
            let turns = wrapped.iter().skip(j).step_by(self.dim());
            let all = [(j, from, to)].into_iter().chain(turns.copied());
            let choices = all.flat_map(|(j, from, to)| (from..to).map(move |s| (j, s)));
            let cost =
                |&(j, s): &(usize, usize)| amplification(&tau[j + 1..=j + p], breaks[s], breaks[s + 1]);
            let least =
                choices.map(|choice| (cost(&choice), choice)).reduce(|x, y| if y.0 < x.0 { y } else { x });
            let (_, (j, s)) = least.expect("every coefficient has a span under it");
            args.clear();
            args.extend(&tau[j + 1..=j + p]);
            map.push_with(|weights| pieces.polar_into(spans[s], &args, &mut free, weights));
        }
        Ok(map)
    }
}

/// How much polar arguments may amplify errors of Bernstein coefficients on `[a, b]`. Exact fields have no errors:
/// there it counts the arguments that cost anything.
fn amplification<T: Scalar>(args: &[T], a: &T, b: &T) -> T {
    if T::EXACT {
        return T::int(args.iter().filter(|u| *u != a && *u != b).count() as i64);
    }
    let width = b.clone() - a;
    let outside = |u: &T| if u < a { a.clone() - u } else { u.clone() - b };
    let growth = |u: &T| T::one() + T::int(2) * outside(u) / &width;
    args.iter().filter(|u| *u < a || *u > b).fold(T::one(), |product, u| product * growth(u))
}

/// `C(p, i) C(q, j) / C(p + q, i + j)` for all `i`, `j`.
pub(crate) fn bernstein_shares<T: Scalar>(p: usize, q: usize) -> Vec<Vec<T>> {
    let [rows_p, rows_q, rows] = [p, q, p + q].map(binomials::<T>);
    let share = |i: usize, j: usize| rows_p[i].clone() * &rows_q[j] / &rows[i + j];
    (0..=p).map(|i| (0..=q).map(|j| share(i, j)).collect()).collect()
}

/// `C(n, 0), ..., C(n, n)`.
pub(crate) fn binomials<T: Scalar>(n: usize) -> Vec<T> {
    let mut row = vec![T::one(); n + 1];
    for k in 1..n {
        row[k] = row[k - 1].clone() * T::int((n + 1 - k) as i64) / T::int(k as i64);
    }
    row
}

/// A growing window of weights on index pairs.
struct Window<T> {
    weights: Vec<(usize, usize, T)>,
}

impl<T> Default for Window<T> {
    fn default() -> Self {
        Self { weights: Vec::new() }
    }
}

impl<T: Scalar> Window<T> {
    /// Adds `weight` times the product of two rows.
    fn add_outer(&mut self, weight: &T, left: (usize, &[T]), right: (usize, &[T])) {
        for (i, l) in (left.0..).zip(left.1) {
            let scaled = weight.clone() * l;
            self.weights.extend((right.0..).zip(right.1).map(|(j, r)| (i, j, scaled.clone() * r)));
        }
    }

    /// The window as a row.
    fn into_row(self, left_dim: usize, right_dim: usize) -> BilinearRow<T> {
        let lows =
            self.weights.iter().fold((usize::MAX, usize::MAX), |low, w| (low.0.min(w.0), low.1.min(w.1)));
        let highs = self.weights.iter().fold((0, 0), |high, w| (high.0.max(w.0), high.1.max(w.1)));
        let mut weights = vec![vec![T::zero(); highs.1 - lows.1 + 1]; highs.0 - lows.0 + 1];
        for (i, j, weight) in self.weights {
            weights[i - lows.0][j - lows.1] += weight;
        }
        BilinearRow { first: (lows.0 % left_dim, lows.1 % right_dim), weights }
    }
}

impl<T: Scalar, C: Coeff<T>> Spline<T, C> {
    /// The product under any pairing of coefficients that is linear in both.
    ///
    /// The result lies in the [product space](SplineSpace::product_space): clamped, or periodic if both factors
    /// are. Nothing checks that `pair` is bilinear.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`], [`Error::DegreeTooHigh`]; [`Error::NotFinite`] on overflow.
    pub fn product_by<A, B>(&self, other: &Spline<T, A>, pair: impl Fn(&C, &A) -> B) -> Result<Spline<T, B>>
    where
        A: Coeff<T>,
        B: Coeff<T>,
    {
        let target = self.space().product_space(other.space())?;
        let (p, q) = (self.degree(), other.degree());
        let left = self.embedded(&target.pieces(p)?)?;
        let right = other.embedded(&target.pieces(q)?)?;
        let shares = bernstein_shares::<T>(p, q);
        let mut pieces = Vec::with_capacity(left.coeffs().len() / (p + 1) * (p + q + 1));
        for (a, b) in left.coeffs().chunks(p + 1).zip(right.coeffs().chunks(q + 1)) {
            for k in 0..=p + q {
                let from = k.saturating_sub(q);
                let mut sum = pair(&a[from], &b[k - from]);
                sum.scale(&shares[from][k - from]);
                (from + 1..=p.min(k))
                    .for_each(|i| sum.add_scaled(&shares[i][k - i], &pair(&a[i], &b[k - i])));
                pieces.push(sum);
            }
        }
        let coeffs = target.recomposition()?.apply(&pieces)?;
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
        self.product_by(other, |c, d| T::dot(c.iter().zip(d.iter())))
    }

    /// Coordinate `axis` of the curve as a scalar spline.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`].
    pub fn coordinate(&self, axis: usize) -> Result<Function<T>> {
        if axis >= N {
            return Err(Error::IndexOutOfRange { index: axis, length: N });
        }
        Spline::new(self.space().clone(), self.coeffs().iter().map(|c| c[axis].clone()).collect())
    }
}

impl<T: Scalar> Curve<T, 2> {
    /// The cross product `x_1 y_2 - y_1 x_2` of two plane curves, a scalar spline.
    ///
    /// # Errors
    /// As [`product_by`](Spline::product_by).
    pub fn cross(&self, other: &Self) -> Result<Function<T>> {
        self.product_by(other, cross2)
    }
}

impl<T: Scalar> Curve<T, 3> {
    /// The cross product of two space curves.
    ///
    /// # Errors
    /// As [`product_by`](Spline::product_by).
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
