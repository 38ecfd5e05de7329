//! Closed curves fine tuned and closed again by springs.
//!
//! For periodic `C` and `α` the integral of `α C'` does not close. The legs of its control polygon are periodic all the
//! same, and so are the angles between them: they are what a closed polygon should come near to, in the sense of the
//! energy (13) of a chain of springs [Miura, 4.2]. If it could be met, the curve would be `D` itself,
//! with curvature `κ / α`.

use crate::error::{Error, Result};
use crate::fine_tune::chain::Chain;
use crate::fine_tune::frame::{Frame, NOTHING};
use crate::fine_tune::joint::Jointed;
use crate::fine_tune::legs::{legs, scaled_speed};
use crate::fine_tune::minimise::{Limits, minimise};
use crate::fine_tune::scale::Scale;
use crate::fine_tune::springs::Springs;
use crate::fine_tune::turn::Turnable;
use crate::spline::{Curve, Function, Spline};
use crate::vector::{length, unit};
use nalgebra::SVector;

/// A closed curve whose control polygon is a chain of springs at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Relaxed<const N: usize> {
    /// The curve, periodic.
    pub curve: Curve<f64, N>,
    /// The energy (13) of the unscaled curve, where the springs were released.
    pub energy_before: f64,
    /// The energy (13) of the curve.
    pub energy: f64,
    /// The largest deviation of a leg's length, relative to what `α` asks for.
    pub length_deviation: f64,
    /// The largest deviation of an angle between legs from what `α` asks for, in radians. Where this and the other vanish the
    /// curve is, but for a motion, the integral of `α C'`, and has curvature `κ / α`.
    pub angle_deviation: f64,
    /// The steps it took.
    pub iterations: usize,
    /// What is left of the gradient, as [`Springs::tolerance`] measures it.
    pub gradient: f64,
    /// Whether the gradient is within the tolerance. If not, the iterations were too few, rounding allows no less, or a leg was
    /// pressed to nothing, which a length deviation of 1 or more hints at.
    pub converged: bool,
}

impl<const N: usize> Curve<f64, N>
where
    SVector<f64, N>: Jointed,
{
    /// The closed curve with its derivative multiplied by `alpha` as nearly as it stays closed.
    ///
    /// The result lies in the space of `∫ α C'`, periodic. Its control points `Q_i` have the least energy
    ///
    /// ```text
    /// E = Σ_i k_l (l_i^opt - l_i)² + k_a (θ_i^opt - θ_i)²          [Miura, (13)]
    /// ```
    /// near those of the curve itself, where `l_i` is the length of the leg from `Q_i` to `Q_{i+1}`, `θ_i` the angle between legs
    /// `i - 1` and `i`, both cyclic, and `l_i^opt`, `θ_i^opt` are what they would be without closing. Angles have signs in the
    /// plane and none in space. Lengths are in units of the longest side of the bounding box of the curve's control
    /// points, so that a curve and its enlargements come out alike.
    ///
    /// [`Springs::fixed`] points do not move. If there are none, point 0 and the direction of leg 0 stay, which is no
    /// restriction; if there is one, it and the direction of the leg from it.
    ///
    /// Curvature is `κ / α` only as nearly as the deviations in [`Relaxed`] tell. All legs give way by about the same length,
    /// so that closing may press short ones to nothing; [`Springs::uniform`] ones give way by the same share. In space more
    /// curves than one may be at rest, since angles without sign do not fix how the curve twists; a plane curve stays in its plane.
    ///
    /// # Errors
    /// [`Error::NotPeriodic`] unless both are periodic; [`Error::DomainMismatch`]; [`Error::Discontinuous`];
    /// [`Error::NotPositive`], [`Error::Undecided`] unless `alpha` is proved to be positive; [`Error::NoLength`] if all control points coincide;
    /// [`Error::ZeroLeg`] if a control point of `C'` or of `α C'` vanishes in the space of their product, but for rounding
    /// beside the largest;
    /// [`TuneError::SpringConstant`](crate::TuneError::SpringConstant), [`Error::BadTolerance`], [`Error::IndexOutOfRange`] for unusable springs;
    /// [`Error::NotFinite`] on overflow; [`Error::DegreeTooHigh`], [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Function, Springs};
    /// let triangle = Curve::closed(2, vec![vector![0.0, 0.0], vector![4.0, 1.0], vector![1.0, 5.0]])?;
    /// // The value 3/2 in the middle of leg 1.
    /// let alpha = Function::closed(1, vec![1.0, 1.5, 1.0])?;
    /// let tuned = triangle.fine_tuned_closed(&alpha, &Springs::default())?;
    /// assert!(tuned.converged && tuned.curve.space().is_periodic());
    /// assert!((tuned.energy_before - 1.1725).abs() < 1e-4 && (tuned.energy - 0.0209).abs() < 1e-4);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn fine_tuned_closed<'a>(
        &self,
        alpha: impl Into<Scale<'a, Function<f64>>>,
        springs: &Springs,
    ) -> Result<Relaxed<N>> {
        let alpha = alpha.into().function()?;
        let frame = Frame::of(self.coeffs())?;
        let small = self.map_coeffs(|point| frame.inward(point))?;
        let speed = scaled_speed(&small, alpha)?;
        springs.check(speed.coeffs().len())?;
        let space = speed.space().antiderivative_space()?;
        let start = small.embedded(&space)?;
        check_legs(&start.derivative()?)?;
        check_legs(&speed)?;
        let largest = springs.stretch.max(springs.bend);

        let mut fixed = springs.fixed.clone();
        fixed.sort_unstable();
        fixed.dedup();
        // A single point is no restriction: it is put in place at the end.
        let held: &[usize] = if fixed.len() > 1 { &fixed } else { &[] };
        let constants = [springs.stretch / largest, springs.bend / largest];
        let mut chain = Chain::at_rest(&legs(&speed), constants, springs.uniform, held)?;
        let mut points: Vec<f64> = start.coeffs().iter().flatten().copied().collect();
        let limits = Limits {
            gradient: springs.tolerance,
            iterations: springs.iterations,
            evaluations: springs.iterations.saturating_mul(4),
        };
        let descent = minimise(&mut points, &limits, &mut chain);
        if !descent.before.is_finite() {
            return Err(Error::NotFinite { what: "energy", index: 0 });
        }

        let [length_deviation, angle_deviation] = chain.deviation(&points);
        let moved = points.chunks_exact(N).map(SVector::from_column_slice).collect();
        let points = in_place(moved, start.coeffs(), held, fixed.first().copied().unwrap_or(0));
        Ok(Relaxed {
            curve: Spline::new(space, points.iter().map(|point| frame.outward(point)).collect())?,
            energy_before: largest * descent.before,
            energy: largest * descent.value,
            length_deviation,
            angle_deviation,
            iterations: descent.iterations,
            gradient: descent.gradient,
            converged: descent.converged,
        })
    }
}

/// Refuses derivatives with a control point that is zero but for rounding: the leg it belongs to has no direction.
fn check_legs<const N: usize>(speed: &Curve<f64, N>) -> Result<()> {
    let sizes = speed.coeffs().iter().map(length);
    let largest = sizes.clone().fold(0.0, f64::max);
    match sizes.zip(0..).find(|(size, _)| *size <= NOTHING * largest) {
        Some((_, index)) => Err(Error::ZeroLeg { index }),
        None => Ok(()),
    }
}

/// The points moved so that point `anchor` and the direction of the leg from it are as at the start. With
/// `held` points, which did not move, all are in place.
fn in_place<const N: usize>(
    mut points: Vec<SVector<f64, N>>,
    start: &[SVector<f64, N>],
    held: &[usize],
    anchor: usize,
) -> Vec<SVector<f64, N>>
where
    SVector<f64, N>: Jointed,
{
    if !held.is_empty() {
        return points;
    }
    let leg = |points: &[SVector<f64, N>]| points[(anchor + 1) % points.len()] - points[anchor];
    let directions = unit(&leg(&points)).zip(unit(&leg(start)));
    let origin = points[anchor];
    let turn = directions.and_then(|((from, _), (to, _))| Turnable::turn(&from, &to));
    for point in &mut points {
        let arm = *point - origin;
        *point = start[anchor] + turn.as_ref().map_or(arm, |turn| turn(&arm));
    }
    points
}
