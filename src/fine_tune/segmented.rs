//! Fine tuning with the segmentation kept: the degree and the knots that the curve had.
//!
//! Sections of a skin are segmented alike. After fine tuning they are brought back to the degree they had, and with it to the same
//! segmentation [Miura, 3.1]. With `C` the curve in its space, of degree `p`, and `D` the tuned portion over `[a, b]`, the curve is
//!
//! ```text
//! C + Σ_i d_i N_i      with the least   ∫_a^b | D - C - Σ_i d_i N_i |²
//! ```
//! where `N_i` are the basis functions of the space that vanish outside `[a, b]`. At a knot `a` of multiplicity `m` these have
//! `p - m` derivatives that vanish, and the value. So the rest of the curve does not change, and meets the portion as smoothly as the
//! space is there. At an end of the domain those are left out that would change what is held.

use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::fine_tune::local::LocallyTuned;
use crate::fine_tune::place::{Inside, clamped_beside, copies};
use crate::ops::bound::Approximation;
use crate::scalar::Scalar;
use crate::spline::Curve;

/// How many times bounds halve the pieces of the difference.
const HALVINGS: usize = 3;

impl<T: Scalar, const N: usize> LocallyTuned<T, N> {
    /// The curve nearest to [`joined`](Self::joined) in exactly the space that the curve had, with a certified bound of the distance
    /// between the two.
    ///
    /// Nearest is meant in the sense of least squares, among the curves of the space that are the original one outside the portion and
    /// have its derivatives, as far as they are held, at the ends. Where the space is smoother at an end of the portion than what is
    /// held, it stays so. In `f64` control points with influence outside the portion are those of the curve to the bit, unless the
    /// portion reaches an unclamped end of the domain. With [`Hold::Start`](crate::Hold::Start) the end is that of the tuned curve.
    ///
    /// The tolerance is for the caller to choose: see [`Approximation::within`]. If the bound is too large the space has too few
    /// knots in the portion; [`reduced`](Self::reduced) adds them where they are needed.
    ///
    /// # Errors
    /// [`ShapeError::NothingLocal`] if no control point is free to move, so that the curve would come back as it was;
    /// [`Error::DegreeTooLow`] if the degree is below the order of the derivatives that are held; [`Error::Singular`] if in `f64`
    /// the spans differ too much; those of [`joined`](Self::joined).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Function, Hold, Q, Scalar, SplineSpace};
    /// let points = (0..10).map(|i| vector![Q::int(i), Q::int(i * i % 5)]).collect();
    /// let curve = Curve::new(SplineSpace::clamped(3, (0..=7).map(Q::int))?, points)?;
    /// let alpha = Function::new(SplineSpace::clamped(1, (0..=7).map(Q::int))?, [4, 4, 4, 5, 5, 4, 4, 4].map(Q::int).to_vec())?;
    /// let near = curve.fine_tuned_on(&alpha, Hold::Tangents)?.in_original_space()?;
    /// assert_eq!(near.spline.space(), curve.space());
    /// assert!(near.bound < Q::frac(1, 5));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "segmentation")]
    #[doc(alias = "degree reduction")]
    pub fn in_original_space(&self) -> Result<Approximation<Curve<T, N>, T>> {
        let (space, tuned) = (self.original().space(), &self.tuned().curve);
        let (p, (a, b), j) = (space.degree(), self.portion(), self.order());
        if j > p {
            return Err(Error::DegreeTooLow { degree: p, needed: j });
        }
        let (breaks, (start, end)) = (space.breaks(), space.domain());
        let [at_start, at_end] = [a == start, b == end].map(|at| at && !space.is_periodic());
        let fixed = |x: &T, at: bool| {
            if at { j + 1 } else { (j + 1).max((p + 1).saturating_sub(copies(&breaks, x))) }
        };
        let (first, last) = (fixed(a, at_start), fixed(b, at_end));

        let was = self.original().restricted(a, b)?;
        let (n, old) = (was.coeffs().len(), was.coeffs());
        let nothing = || ShapeError::NothingLocal { start: a.to_string(), end: b.to_string() };
        if first + last > n {
            return Err(nothing().into());
        }
        let (left, mut right) = (old[..first].to_vec(), old[n - last..].to_vec());
        if at_end {
            // Held it is the same, and otherwise it is where the curve ends now.
            right[last - 1].clone_from(&tuned.coeffs()[tuned.coeffs().len() - 1]);
        }
        if first + last == n && right == old[n - last..] {
            return Err(nothing().into());
        }
        let near = tuned.projection_between(was.space(), left, right)?;

        let beside = clamped_beside(space.clone(), (a, b))?;
        let mut points = self.original().embedded(&beside)?.into_coeffs();
        let free = if at_start { 0 } else { first }..n - if at_end { 0 } else { last };
        Inside::of(&beside, near.space()).among(&free).copy(near.coeffs(), &mut points);
        let spline = Curve::new(beside, points)?.embedded(space)?;
        let bound = spline.distance_bound_halved(&self.joined()?, HALVINGS)?;
        Ok(Approximation { spline, bound })
    }
}
