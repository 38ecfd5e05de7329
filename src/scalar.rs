//! The numbers that knots, weights and coefficients are made of.
//!
//! Every operator of the library is written once over a [`Scalar`], an ordered field. The two fields that come
//! with it are `f64` and the exact rationals [`Q`](crate::exact::Q); a dual number or a field of fractions serves as
//! well. What needs square roots asks for a [`Real`].

use crate::error::Result;
use nalgebra::DMatrix;
use num_traits::{One, Zero};
use std::fmt::Display;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// An ordered field.
///
/// Arithmetic takes its right operand by value or by reference, so that generic text reads
/// `a.clone() + &b` and never copies a big number twice.
///
/// # Examples
/// ```
/// use symspline::{Q, Scalar};
/// fn mean<T: Scalar>(a: &T, b: &T) -> T {
///     (a.clone() + b) / T::int(2)
/// }
/// assert_eq!(mean(&1.0, &2.0), 1.5);
/// assert_eq!(mean(&Q::frac(1, 3), &Q::int(1)), Q::frac(2, 3));
/// ```
pub trait Scalar:
    nalgebra::Scalar
    + PartialOrd
    + Display
    + Send
    + Sync
    + Zero
    + One
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + for<'a> Div<&'a Self, Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + for<'a> AddAssign<&'a Self>
    + for<'a> SubAssign<&'a Self>
    + for<'a> MulAssign<&'a Self>
    + for<'a> DivAssign<&'a Self>
{
    /// Whether arithmetic is exact. Kernels use it to choose between the stable and the cheap of two equal ways.
    const EXACT: bool;

    /// The integer `n`, rounded to nearest where the field cannot hold it.
    fn int(n: i64) -> Self;

    /// The fraction `p / q`.
    ///
    /// # Panics
    /// If `q` is zero and the field has no infinities.
    fn frac(p: i64, q: i64) -> Self {
        Self::int(p) / Self::int(q)
    }

    /// Whether this is a number at all: false for the infinities and NaN of floating point.
    fn is_finite(&self) -> bool {
        true
    }

    /// The absolute value.
    fn magnitude(&self) -> Self {
        if *self < Self::zero() { -self.clone() } else { self.clone() }
    }

    /// A number not below the square root of `self`, for certified bounds: where sizes are squared, errors are not.
    ///
    /// Of zero it is zero. Nothing else is promised about how close it is, except over `f64` and [`Q`](crate::exact::Q): a few parts in `10^15`.
    fn root_above(&self) -> Self {
        if self.is_zero() {
            return self.clone();
        }
        // Newton's method from above stays above, in any ordered field.
        let half = Self::frac(1, 2);
        let step = |x: Self, _| if x.is_zero() { x } else { (self.clone() / &x + &x) * &half };
        (0..6).fold((self.clone() + Self::one()) * &half, step)
    }

    /// A number that never decreases with `self`, from `start` on, about `(self - start) * per_unit`: where to begin looking for
    /// `self` among sorted numbers. Always the same number, which tells nothing, is right too.
    fn bucket(&self, start: &Self, per_unit: &Self) -> usize {
        let _ = (start, per_unit);
        0
    }

    /// The sum of products `Σ a b`, the hook by which an exact field may reduce a whole row once.
    fn dot<'a>(pairs: impl Iterator<Item = (&'a Self, &'a Self)>) -> Self {
        pairs.fold(Self::zero(), |sum, (a, b)| sum + a.clone() * b)
    }

    /// Divides all `values` by one `divisor`, the hook by which an exact field may look for common factors once.
    ///
    /// # Panics
    /// If `divisor` is zero and the field has no infinities.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Q, Scalar};
    /// let mut values = [2, 3].map(Q::int);
    /// Q::divide(&mut values, &Q::int(6));
    /// assert_eq!(values, [Q::frac(1, 3), Q::frac(1, 2)]);
    /// ```
    #[inline]
    fn divide(values: &mut [Self], divisor: &Self) {
        values.iter_mut().for_each(|x| *x /= divisor);
    }

    /// A number that is not zero and whose multiples of `values` are cheaper to multiply and add: a common denominator.
    /// `None` where that is not worth a division in the end.
    #[inline]
    fn clear<'a>(values: impl Iterator<Item = &'a Self>) -> Option<Self> {
        let _ = values;
        None
    }

    /// The number, not zero, whose multiples of `values` are whole numbers without a common factor, if there are such
    /// numbers and some value is not zero: eliminations then need no fractions. `None` for all other fields.
    #[inline]
    fn primitive<'a>(values: impl Iterator<Item = &'a Self>) -> Option<Self> {
        let _ = values;
        None
    }

    /// The solution of `matrix x = right`, the hook by which a field may solve in another way than by elimination; see
    /// [`solve_dense`](crate::dense::solve_dense), which has checked the shapes.
    #[inline]
    fn solve(matrix: &DMatrix<Self>, right: &DMatrix<Self>) -> Option<Result<DMatrix<Self>>> {
        let _ = (matrix, right);
        None
    }

    /// The weights of a polar value as whole numbers over one denominator, which is returned: the hook by which an exact
    /// field may do without any reduction before the value. `None` where the weights should be made by dividing.
    ///
    /// The polar value has the arguments `arg(0), ..., arg(q - 1)` beside the run of knots `t_{lo+1}, ..., t_{hi}`, and its
    /// `q + 1 = weights.len()` weights come by one step an argument. With `w_0 = 1`, step `r = 1, ..., q` takes
    ///
    /// ```text
    /// w_j <- w_j (t_{hi+1+j} - x) / d_j + w_{j-1} (x - t_{lo-r+j}) / d_{j-1},   d_j = t_{hi+1+j} - t_{lo+1-r+j},
    /// ```
    ///
    /// `x = arg(r - 1)`, where no `d_j` vanishes. On `None` the weights are left alone.
    #[inline]
    fn whole_blossom<'a>(
        t: &'a [Self],
        lo: usize,
        hi: usize,
        arg: &impl Fn(usize) -> &'a Self,
        weights: &mut [Self],
    ) -> Option<Self> {
        let _ = (t, lo, hi, arg, weights);
        None
    }
}

/// A [`Scalar`] with square roots and angles.
pub trait Real: Scalar {
    /// The non-negative square root.
    fn sqrt(&self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(&self) -> (Self, Self);
    /// The nearest `f64`, for pictures and reports.
    fn to_f64(&self) -> f64;
}

/// The larger of two.
pub(crate) fn larger<X: PartialOrd>(x: X, y: X) -> X {
    if x < y { y } else { x }
}

/// The larger of two sizes, where what is not finite counts as the largest.
pub(crate) fn larger_size<T: Scalar>(x: T, y: T) -> T {
    if (y <= x) | !x.is_finite() { x } else { y }
}

impl Scalar for f64 {
    const EXACT: bool = false;

    #[inline]
    fn int(n: i64) -> Self {
        n as f64
    }

    #[inline]
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }

    #[inline]
    fn magnitude(&self) -> Self {
        self.abs()
    }

    #[inline]
    fn bucket(&self, start: &Self, per_unit: &Self) -> usize {
        // Beyond 2^52 the last bits of a number are its integer part, rounded: a cast takes several times as long.
        const UNIT: f64 = (1_u64 << 52) as f64;
        const MOST: f64 = u32::MAX as f64;
        let count = (self - start) * per_unit;
        // Not a number, which is zero times infinity, counts as the most too.
        let count = if count < MOST { count } else { MOST };
        (count + UNIT).to_bits() as u32 as usize
    }

    #[inline]
    fn root_above(&self) -> Self {
        // Both roundings together are less than this.
        self.sqrt() * (1.0 + 2.0 * Self::EPSILON)
    }
}

impl Real for f64 {
    #[inline]
    fn sqrt(&self) -> Self {
        f64::sqrt(*self)
    }

    #[inline]
    fn sin_cos(&self) -> (Self, Self) {
        f64::sin_cos(*self)
    }

    #[inline]
    fn to_f64(&self) -> f64 {
        *self
    }
}
