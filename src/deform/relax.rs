//! Relaxation: a curve on its way to where its energy is least.

use crate::coeff::{Coeff, check_pair};
use crate::deform::breadth::Breadth;
use crate::deform::elastic::Elastic;
use crate::deform::material::Material;
use crate::deform::stiffness::Stiffness;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::space::SplineSpace;

/// Time steps of a curve that follows the forces of its energy `cᵀ K c - 2 load · c` through a viscous medium, whose resistance is
/// measured by `∫ |f|²`: implicit steps of length `τ`,
///
/// ```text
/// (K_0 + τ K) (c' - c) = τ (load - K c)        for the coefficients that may move; the others stay
/// ```
/// with the matrix of the material of the weights `τ w_k`, and one more for the value. Each step lowers the energy, however long
/// it is: `E(c) - E(c') = dᵀ K d + (2 / τ) dᵀ K_0 d` with `d = c' - c`. What does not move any more has the least energy, and one
/// step leaves at most `∫ |f - g|² / (4 τ)` of the energy of the difference `f - g` to it. Motions that cost nothing stay as they are.
///
/// # Examples
/// ```
/// use symspline::{Breadth, Function, Material, Q, Relaxation, Scalar, SplineSpace};
/// let space = SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?;
/// let mut rod = Function::new(space.clone(), [0, 3, 0].map(Q::int).to_vec())?;
/// let stretching = Material::new(Q::int(1), Q::int(0))?;
/// let relaxation = Relaxation::new(&space, &stretching, &Breadth::BetweenEnds(1), Q::frac(1, 6))?;
/// // (2/3 + 2/6) d = -2 · 3 / 6.
/// relaxation.step(&mut rod)?;
/// assert_eq!(rod.coeffs(), [0, 2, 0].map(Q::int));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Relaxation<T> {
    body: Elastic<T>,
    /// `K`.
    matrix: LinearMap<T>,
    step: T,
}

impl<T: Scalar> Relaxation<T> {
    /// Steps of length `step` of curves over `space`, of a material; `breadth` lets coefficients move.
    ///
    /// # Errors
    /// [`DeformError::Step`] unless the step is positive and finite; those of [`Stiffness::new`] but for its null space, and in
    /// floating point that too, where the step is so long that `K_0` is rounding beside `τ K`.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, DeformError, Error, Material, Relaxation, SplineSpace};
    /// let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    /// let refused = Relaxation::new(&space, &Material::new(0.0, 1.0)?, &Breadth::Whole, -1.0).unwrap_err();
    /// assert!(matches!(refused, Error::Deform(DeformError::Step { .. })));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn new(
        space: &SplineSpace<T>,
        material: &Material<T>,
        breadth: &Breadth<T>,
        step: T,
    ) -> Result<Self> {
        if !(step > T::zero() && step.is_finite()) {
            return Err(DeformError::Step { step: step.to_string() }.into());
        }
        let resisting = material.weights().iter().map(|weight| weight.clone() * &step);
        let hardness = T::one() + resisting.clone().next().unwrap_or_else(T::zero);
        let resisting = Material::of_orders(std::iter::once(hardness).chain(resisting.skip(1)))?;
        let body = Elastic::curve(Stiffness::new(space, &resisting, breadth)?);
        Ok(Self { body, matrix: material.matrix(space)?, step })
    }

    /// The length of a step.
    pub fn length(&self) -> &T {
        &self.step
    }

    /// The body whose stiffness is that of one step; for [`Forces`](crate::Forces), whose load does not depend on it.
    pub fn body(&self) -> &Elastic<T> {
        &self.body
    }

    /// One step without forces. On an error the curve stays as it is.
    ///
    /// # Errors
    /// [`DeformError::OtherSpace`] for curves over other spaces; [`Error::Weight`]; [`Error::NotFinite`] on overflow.
    pub fn step<S: Controlled<T>>(&self, curve: &mut S) -> Result<()> {
        self.move_by(curve, None)
    }

    /// One step under a load of each control point, such as [`Forces::load`](crate::Forces::load). On an error the curve stays as
    /// it is.
    ///
    /// # Errors
    /// As [`step`](Self::step); [`Error::CoefficientCount`] unless there is a load for each control point; [`Error::Ragged`].
    ///
    /// # Examples
    /// What does not move any more is in balance:
    /// ```
    /// use symspline::{Breadth, Forces, Function, Material, Q, Relaxation, Scalar, SplineSpace};
    /// let space = SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?;
    /// let mut rod = Function::constant(space.clone(), Q::int(0))?;
    /// let stretching = Material::new(Q::int(1), Q::int(0))?;
    /// let relaxation = Relaxation::new(&space, &stretching, &Breadth::BetweenEnds(1), Q::int(1))?;
    /// let mut forces = Forces::new(relaxation.body(), &rod)?;
    /// let load = forces.at_breaks(&[0, 3, 0].map(Q::int))?.load()?;
    /// relaxation.step_under(&mut rod, &load)?;
    /// assert_eq!(rod.coeffs()[1], Q::frac(3, 4));
    /// rod.replace_coeffs(vec![(1, Q::int(1))])?;
    /// relaxation.step_under(&mut rod, &load)?;
    /// assert_eq!(rod.coeffs()[1], Q::int(1));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn step_under<S: Controlled<T>>(&self, curve: &mut S, load: &[S::Point]) -> Result<()> {
        self.move_by(curve, Some(load))
    }

    fn move_by<S: Controlled<T>>(&self, curve: &mut S, load: Option<&[S::Point]>) -> Result<()> {
        self.body.check(curve)?;
        let mut push = self.matrix.apply(&curve.control_points()?)?;
        let minus = -T::one();
        push.iter_mut().for_each(|x| x.scale(&minus));
        if let Some(load) = load {
            if load.len() != push.len() {
                return Err(Error::CoefficientCount { expected: push.len(), found: load.len() });
            }
            load.iter().try_for_each(|x| check_pair(&push[0], x))?;
            push.iter_mut().zip(load).for_each(|(x, y)| x.add_scaled(&T::one(), y));
        }
        push.iter_mut().for_each(|x| x.scale(&self.step));
        let moves = self.body.solved(&push)?;
        let moving = self.body.stiffnesses()[0].moving();
        curve.move_points(&moving.iter().map(|i| (*i, moves[*i].clone())).collect::<Vec<_>>())
    }
}
