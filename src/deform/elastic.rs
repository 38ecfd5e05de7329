//! Curves and surfaces as elastic bodies.

use crate::coeff::Coeff;
use crate::deform::breadth::Breadth;
use crate::deform::hats::hat_space;
use crate::deform::material::Material;
use crate::deform::stiffness::Stiffness;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::space::SplineSpace;
use crate::tensor::along::Direction;
use crate::tensor::spline::transposed;

/// How a force at a point loads the control points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Spread {
    /// Shared linearly by the breaks on both sides, and from there by the hat functions of the breaks [Vassilev, (16) and (17)].
    #[default]
    Hat,
    /// By the basis functions at the point: the work of the force is force times movement, so the deformation is the one of
    /// least energy among those that move the point as far. Of rational shapes the polynomial basis functions are taken.
    Point,
}

/// A load that is a product of loads along the directions.
pub(crate) type Load<T> = Vec<Functional<T>>;

/// A curve or surface as an elastic body: a [`Stiffness`] along each direction.
///
/// ```text
/// K_u D = load        K_u D K_v = load
/// ```
/// for the displacements `D` of the control points of a curve and of a surface [Vassilev, (15) and (29)]; materials along `u` and
/// `v` may differ. The energy of a surface is that of the products of both materials' terms, with `w_k` along `u` and `w_l` along `v`:
///
/// ```text
/// E = Σ_kl w_k w_l ∫∫ |∂^k+l D / ∂u^k ∂v^l|² du dv                       [Vassilev, (25)]
/// ```
/// Rational shapes move by their control points; the energy is then that of the polynomial displacement `Σ N_i d_i`.
///
/// # Examples
/// A point of a curve is pulled to where it should be, by the force that this takes:
/// ```
/// use nalgebra::vector;
/// use symspline::{Breadth, Curve, Elastic, Material, Q, Scalar, SplineSpace};
/// let points = (0..8).map(|i| vector![Q::int(i), Q::int(0)]).collect();
/// let mut curve = Curve::new(SplineSpace::uniform(3, 5, Q::int(0), Q::int(1))?, points)?;
/// let material = Material::new(Q::int(1), Q::int(2))?;
/// let elastic = Elastic::of(&curve, &material, &[Breadth::BetweenEnds(1)])?;
/// let half = Q::frac(1, 2);
/// let target = vector![Q::frac(7, 2), Q::int(2)];
/// elastic.pull(&curve, &half)?.move_to(&mut curve, &target)?;
/// assert_eq!(curve.at(&half)?, target);
/// assert_eq!(curve.at(&Q::int(0))?, vector![Q::int(0), Q::int(0)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Elastic<T> {
    along: Vec<Stiffness<T>>,
    spread: Spread,
}

impl<T: Scalar> Elastic<T> {
    /// A curve.
    pub fn curve(stiffness: Stiffness<T>) -> Self {
        Self::along(vec![stiffness])
    }

    /// A surface with a stiffness along each direction.
    pub fn surface(u: Stiffness<T>, v: Stiffness<T>) -> Self {
        Self::along(vec![u, v])
    }

    /// A shape with a stiffness along each direction.
    pub(crate) fn along(along: Vec<Stiffness<T>>) -> Self {
        Self { along, spread: Spread::Hat }
    }

    /// The body of a shape, of one material; a breadth for each direction.
    ///
    /// # Errors
    /// Those of [`Stiffness::new`]; [`Error::CoefficientCount`] unless there is a breadth for each direction.
    pub fn of<S: Controlled<T>>(shape: &S, material: &Material<T>, breadths: &[Breadth<T>]) -> Result<Self> {
        Self::with_materials(shape, &vec![material.clone(); S::DIRECTIONS.len()], breadths)
    }

    /// The body of a shape with a material and a breadth for each direction.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn with_materials<S: Controlled<T>>(
        shape: &S,
        materials: &[Material<T>],
        breadths: &[Breadth<T>],
    ) -> Result<Self> {
        let expected = S::DIRECTIONS.len();
        if let Some(found) = [materials.len(), breadths.len()].into_iter().find(|found| *found != expected) {
            return Err(Error::CoefficientCount { expected, found });
        }
        let each = S::DIRECTIONS.iter().zip(materials.iter().zip(breadths));
        let stiffness = |(direction, (material, breadth)): (&Direction, (&Material<T>, &Breadth<T>))| {
            Stiffness::new(shape.space_along(*direction), material, breadth)
        };
        Ok(Self::along(each.map(stiffness).collect::<Result<_>>()?))
    }

    /// The same body, where forces at points are spread in this way.
    #[must_use]
    pub fn with_spread(self, spread: Spread) -> Self {
        Self { spread, ..self }
    }

    /// The stiffness along each direction.
    pub fn stiffnesses(&self) -> &[Stiffness<T>] {
        &self.along
    }

    /// The load of a unit force at a place with these coordinates.
    pub(crate) fn load_at<'a>(&self, coordinate: impl Fn(Direction) -> &'a T) -> Result<Load<T>> {
        let each = self.along.iter().zip([Direction::U, Direction::V]);
        each.map(|(stiffness, direction)| self.load_along(stiffness, coordinate(direction))).collect()
    }

    /// What one direction contributes to the load of a unit force.
    pub(crate) fn load_along(&self, along: &Stiffness<T>, x: &T) -> Result<Functional<T>> {
        match self.spread {
            Spread::Hat => along.hat_load(x),
            Spread::Point => along.space().basis(x),
        }
    }

    /// The space whose basis functions share a force at a point along one direction.
    pub(crate) fn load_space(&self, along: &Stiffness<T>) -> Result<SplineSpace<T>> {
        match self.spread {
            Spread::Hat => hat_space(along.space()),
            Spread::Point => Ok(along.space().clone()),
        }
    }

    /// How the control points that may move answer a load, with their places in the list, in ascending order [Vassilev, (18) and
    /// (31)].
    pub(crate) fn response(&self, load: &[Functional<T>]) -> Result<Vec<(usize, T)>> {
        let along = |(stiffness, load): (&Stiffness<T>, &Functional<T>)| stiffness.answer(load);
        let answers = self.along.iter().zip(load).map(along).collect::<Result<Vec<_>>>()?;
        let moving =
            |direction: usize| self.along[direction].moving().iter().copied().zip(&answers[direction]);
        let [_, v] = &self.along[..] else { return Ok(moving(0).map(|(i, x)| (i, x.clone())).collect()) };
        let columns = v.space().dim();
        let mut response = Vec::with_capacity(moving(0).len() * moving(1).len());
        for (i, x) in moving(0) {
            response.extend(moving(1).map(|(j, y)| (i * columns + j, x.clone() * y)));
        }
        Ok(response)
    }

    /// The displacements under a load of each control point, zero where they are held [Vassilev, (15) and (29)].
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is a load for each control point; [`Error::Ragged`]; [`Error::NotFinite`] on
    /// overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, Elastic, Function, Material, Q, Scalar, SplineSpace};
    /// let rod = Function::constant(SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?, Q::int(0))?;
    /// let elastic = Elastic::of(&rod, &Material::new(Q::int(1), Q::int(0))?, &[Breadth::BetweenEnds(1)])?;
    /// assert_eq!(elastic.solved(&[0, 4, 0].map(Q::int))?, [0, 2, 0].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn solved<C: Coeff<T>>(&self, load: &[C]) -> Result<Vec<C>> {
        let [u, v] = &self.along[..] else { return self.along[0].solved(load) };
        let (m, n) = (u.space().dim(), v.space().dim());
        let across = u.solved_by_columns(load, n)?;
        Ok(transposed(&v.solved_by_columns(&transposed(&across, n), m)?, m))
    }

    /// Refuses shapes over other spaces.
    pub(crate) fn check<S: Controlled<T>>(&self, shape: &S) -> Result<()> {
        if S::DIRECTIONS.len() != self.along.len() {
            return Err(Error::CoefficientCount { expected: self.along.len(), found: S::DIRECTIONS.len() });
        }
        let other = |(direction, stiffness): &(&Direction, &Stiffness<T>)| {
            !stiffness.is_over(shape.space_along(**direction))
        };
        match S::DIRECTIONS.iter().zip(&self.along).find(other) {
            Some((direction, _)) => Err(DeformError::OtherSpace { direction: direction.to_string() }.into()),
            None => Ok(()),
        }
    }
}
