//! Evaluators of surfaces.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::limits::check_dim;
use crate::prepared::evaluate::Evaluate;
use crate::prepared::index::SpanIndex;
use crate::prepared::powers::{Centring, Local, check_finite, derivatives, taylor, value};
use crate::scalar::Scalar;
use crate::tensor::spline::TensorSpline;

/// The highest sum of degrees for which powers are used: what rounding grows by is at most `2^10`.
const POWERS: usize = 10;

/// A surface prepared for values at many parameters, made by [`TensorSpline::evaluator`].
///
/// # Examples
/// ```
/// use symspline::{Evaluate, SplineSpace, TensorSpline};
/// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
/// let evaluator = TensorSpline::new(line.clone(), line, vec![0.0, 1.0, 2.0, 5.0])?.evaluator()?;
/// assert_eq!(evaluator.eval(&[(1.0, 0.5), (0.0, 0.0)])?, [3.5, 0.0]);
/// assert_eq!(evaluator.derivatives_at::<2>(&(0.0, 0.5))?, [[0.5, 1.0], [3.0, 2.0]]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceEvaluator<T, C>(Pieces<T, C>);

/// The polynomials of the patches.
#[derive(Clone, Debug)]
enum Pieces<T, C> {
    Powers(Patches<T, C>),
    /// Of high degree: as they are.
    Plain(TensorSpline<T, C>),
}

/// Patches in powers, row by row of them: `orders.0` rows of `orders.1` coefficients each, the powers along `v` next to each other.
#[derive(Clone, Debug)]
struct Patches<T, C> {
    orders: (usize, usize),
    u: SpanIndex<T>,
    v: SpanIndex<T>,
    us: Vec<Local<T>>,
    vs: Vec<Local<T>>,
    coeffs: Vec<C>,
}

impl<T: Scalar, C: Coeff<T>> TensorSpline<T, C> {
    /// The surface prepared for many values.
    ///
    /// Up to a sum `p + q = 10` of degrees every patch becomes a polynomial in powers about its middle, which takes
    /// `(p + 1) (q + 1)` coefficients a patch. In `f64` a value is then off by at most `4 (p + q + 2) 2^(p+q) ε` times the
    /// largest coefficient under the patch, where `ε = 2^-52`. Surfaces of higher degree are kept as they are. The
    /// table is large: beyond some ten thousand patches it leaves the caches, and [`eval`](Self::eval) may be faster.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Error::NotFinite) for coefficients so large that those of powers overflow or nearly do;
    /// [`TooLarge`](crate::Error::TooLarge).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Evaluate, Q, Scalar, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let product = TensorSpline::new(line.clone(), line, [0, 0, 0, 1].map(Q::int).to_vec())?.evaluator()?;
    /// assert_eq!(product.at(&(Q::frac(1, 3), Q::frac(1, 2)))?, Q::frac(1, 6));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn evaluator(&self) -> Result<SurfaceEvaluator<T, C>> {
        let (p, q) = (self.u().degree(), self.v().degree());
        if p + q > POWERS {
            return Ok(self.plain_evaluator());
        }
        let (u, v) = (SpanIndex::new(self.u()), SpanIndex::new(self.v()));
        let (us, vs) = (Local::of_spans(u.breaks()), Local::of_spans(v.breaks()));
        let size = (p + 1) * (q + 1);
        check_dim(us.len().saturating_mul(vs.len()).saturating_mul(size))?;
        let pieces = self.embedded(&self.u().pieces(p)?, &self.v().pieces(q)?)?;
        let width = pieces.v().dim();
        let mut coeffs = Vec::with_capacity(pieces.coeffs().len());
        let (mut along_u, mut along_v) = (Centring::new(p), Centring::new(q));
        for strip in pieces.coeffs().chunks((p + 1) * width) {
            for j in (0..width).step_by(q + 1) {
                let start = coeffs.len();
                coeffs.extend(strip.chunks(width).flat_map(|row| &row[j..=j + q]).cloned());
                let patch = &mut coeffs[start..];
                (0..=p).for_each(|i| along_v.centre(patch, i * (q + 1), 1));
                (0..=q).for_each(|j| along_u.centre(patch, j, q + 1));
            }
        }
        check_finite(&coeffs)?;
        Ok(SurfaceEvaluator(Pieces::Powers(Patches { orders: (p + 1, q + 1), u, v, us, vs, coeffs })))
    }

    /// The evaluator that keeps the surface as it is.
    pub(crate) fn plain_evaluator(&self) -> SurfaceEvaluator<T, C> {
        SurfaceEvaluator(Pieces::Plain(self.clone()))
    }
}

impl<T: Scalar, C: Coeff<T>> Patches<T, C> {
    /// The patch that holds `x`, and its spans.
    #[inline]
    fn find(&self, (u, v): &(T, T)) -> Result<(&[C], &Local<T>, &Local<T>)> {
        let (k, l) = (self.u.locate(u)?, self.v.locate(v)?);
        let size = self.orders.0 * self.orders.1;
        Ok((&self.coeffs[(k * self.vs.len() + l) * size..][..size], &self.us[k], &self.vs[l]))
    }
}

/// What `f` makes of a patch and the length of its rows, both known to the compiler for equal low degrees.
#[inline(always)]
fn unrolled<C, R>(orders: (usize, usize), patch: &[C], f: impl Fn(&[C], usize) -> R) -> R {
    match orders {
        (2, 2) => f(&patch[..4], 2),
        (3, 3) => f(&patch[..9], 3),
        (4, 4) => f(&patch[..16], 4),
        (_, order) => f(patch, order),
    }
}

impl<T: Scalar, C: Coeff<T>> Evaluate for SurfaceEvaluator<T, C> {
    type Parameter = (T, T);
    type Value = C;
    type Derivatives<const COUNT: usize> = [[C; COUNT]; COUNT];

    #[inline]
    fn at(&self, x: &(T, T)) -> Result<C> {
        let patches = match &self.0 {
            Pieces::Powers(patches) => patches,
            Pieces::Plain(surface) => return surface.at(&x.0, &x.1),
        };
        let (patch, along_u, along_v) = patches.find(x)?;
        let (s, t) = (along_u.parameter(&x.0), along_v.parameter(&x.1));
        Ok(unrolled(patches.orders, patch, |patch, order| {
            let [value] = taylor(patch.chunks_exact(order).map(|row| value(row, &t)), &s);
            value
        }))
    }

    #[inline]
    fn derivatives_at<const COUNT: usize>(&self, x: &(T, T)) -> Result<[[C; COUNT]; COUNT]> {
        let patches = match &self.0 {
            Pieces::Powers(patches) => patches,
            Pieces::Plain(surface) => {
                let all = surface.derivatives_at(&x.0, &x.1, COUNT.saturating_sub(1))?;
                return Ok(std::array::from_fn(|k| std::array::from_fn(|l| all[k][l].clone())));
            }
        };
        let (patch, along_u, along_v) = patches.find(x)?;
        let (s, t) = (along_u.parameter(&x.0), along_v.parameter(&x.1));
        Ok(unrolled(patches.orders, patch, |patch, order| {
            let row = |row: &[C]| -> [C; COUNT] { derivatives(row.iter(), &t, along_v.slope()) };
            derivatives(patch.chunks_exact(order).map(row), &s, along_u.slope())
        }))
    }

    fn for_each(&self, parameters: &[(T, T)], mut take: impl FnMut(C)) -> Result<()> {
        parameters.iter().try_for_each(|x| self.at(x).map(&mut take))
    }

    fn for_each_derivatives<const COUNT: usize>(
        &self,
        parameters: &[(T, T)],
        mut take: impl FnMut([[C; COUNT]; COUNT]),
    ) -> Result<()> {
        parameters.iter().try_for_each(|x| self.derivatives_at(x).map(&mut take))
    }
}
