//! Forces on a shape, acting together.

use crate::coeff::{Coeff, check_pair};
use crate::deform::elastic::{Elastic, Load};
use crate::deform::stiffness::Stiffness;
use crate::error::{Error, Result};
use crate::map::LinearMap;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::spline::Spline;
use crate::tensor::spline::TensorSpline;

/// Forces that act together on one shape.
///
/// Up to four single forces are answered one by one and added up; more, and such as are spread over the shape, by one solution for
/// all of them [Vassilev, sections 2.5, 3.5].
///
/// # Examples
/// ```
/// use symspline::{Breadth, Elastic, Forces, Function, Material, Q, Scalar, SplineSpace};
/// let mut rod = Function::constant(SplineSpace::uniform(3, 4, Q::int(0), Q::int(1))?, Q::int(0))?;
/// let elastic = Elastic::of(&rod, &Material::new(Q::int(1), Q::int(1))?, &[Breadth::BetweenEnds(1)])?;
/// let mut forces = Forces::new(&elastic, &rod)?;
/// forces.at(&Q::frac(1, 3), Q::int(5))?.at(&Q::frac(2, 3), Q::int(5))?;
/// forces.push(&mut rod)?;
/// assert_eq!(rod.at(&Q::frac(1, 4))?, rod.at(&Q::frac(3, 4))?);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Forces<'a, T: Scalar, S: Controlled<T>> {
    pub(crate) elastic: &'a Elastic<T>,
    single: Vec<(Load<T>, S::Point)>,
    /// Loads of all control points.
    spread: Option<Vec<S::Point>>,
    pub(crate) zero: S::Point,
}

/// How many single forces are answered one by one.
const FEW: usize = 4;

impl<'a, T: Scalar, S: Controlled<T>> Forces<'a, T, S> {
    /// No forces yet, on shapes like this one.
    ///
    /// # Errors
    /// [`DeformError::OtherSpace`](crate::DeformError::OtherSpace); [`Error::Weight`] if a rational shape has no first control point.
    pub fn new(elastic: &'a Elastic<T>, shape: &S) -> Result<Self> {
        elastic.check(shape)?;
        let zero = shape.control_point(0)?.zero_like();
        Ok(Self { elastic, single: Vec::new(), spread: None, zero })
    }

    /// A force at a place.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::NotFinite`]; [`Error::Ragged`] for a row of another length than the control points.
    pub fn at(&mut self, at: &S::Parameter, force: S::Point) -> Result<&mut Self> {
        self.check_force(0, &force)?;
        let load = self.elastic.load_at(|direction| S::coordinate(at, direction))?;
        self.single.push((load, force));
        Ok(self)
    }

    /// Forces with the given values at the breaks of the shape, linear in between along each direction: `C F` for a curve,
    /// `C_u F C_vᵀ` for a surface, with `F` row by row [Vassilev, (12), (14) and (28)].
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one for each break, or each crossing of breaks; of a ring the end does not
    /// count. [`Error::Ragged`]; [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, Elastic, Forces, Function, Material, Q, Scalar, SplineSpace};
    /// let mut rod = Function::constant(SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?, Q::int(0))?;
    /// let elastic = Elastic::of(&rod, &Material::new(Q::int(1), Q::int(0))?, &[Breadth::BetweenEnds(1)])?;
    /// Forces::new(&elastic, &rod)?.at_breaks(&[0, 3, 0].map(Q::int))?.push(&mut rod)?;
    /// assert_eq!(rod.coeffs(), [0, 1, 0].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn at_breaks(&mut self, forces: &[S::Point]) -> Result<&mut Self> {
        let maps: Vec<LinearMap<T>> =
            self.elastic.stiffnesses().iter().map(|along| along.forcing().transpose()).collect();
        self.spread_by(&maps, forces)
    }

    /// The load of each control point that these forces are, all together: the right-hand side of the system.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn load(&self) -> Result<Vec<S::Point>> {
        let mut total = self.spread.clone().unwrap_or_else(|| self.no_load());
        for (load, force) in &self.single {
            self.each_of(load, |i, weight| total[i].add_scaled(weight, force));
        }
        check_loads(&total)?;
        Ok(total)
    }

    /// The displacements of the control points, with their places in the list.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn displacements(&self) -> Result<Vec<(usize, S::Point)>> {
        if self.spread.is_some() || self.single.len() > FEW {
            let moved = self.elastic.solved(&self.load()?)?;
            return Ok(moved.into_iter().enumerate().filter(|(_, d)| !d.vanishes()).collect());
        }
        let mut sum: Vec<(usize, S::Point)> = Vec::new();
        for (load, force) in &self.single {
            let response = self.elastic.response(load)?;
            if sum.is_empty() {
                sum.extend(response.iter().map(|(i, _)| (*i, self.zero.clone())));
            }
            sum.iter_mut().zip(&response).for_each(|((_, d), (_, v))| d.add_scaled(v, force));
        }
        match sum.iter().find(|(_, d)| !d.all_finite()) {
            Some((index, _)) => Err(Error::NotFinite { what: "displacement", index: *index }),
            None => Ok(sum),
        }
    }

    /// Adds these forces to those on `shape`. On an error it stays as it is.
    ///
    /// # Errors
    /// [`DeformError::OtherSpace`](crate::DeformError::OtherSpace), [`Error::NotFinite`] on overflow.
    pub fn push(&self, shape: &mut S) -> Result<()> {
        self.elastic.check(shape)?;
        shape.move_points(&self.displacements()?)
    }

    /// A load of zero for each control point.
    pub(crate) fn no_load(&self) -> Vec<S::Point> {
        let dims = self.elastic.stiffnesses().iter().map(|along| along.space().dim());
        vec![self.zero.clone(); dims.product()]
    }

    /// Adds loads of all control points unless one is not finite.
    pub(crate) fn add_load(&mut self, load: Vec<S::Point>) -> Result<&mut Self> {
        check_loads(&load)?;
        match &mut self.spread {
            Some(total) => total.iter_mut().zip(&load).for_each(|(sum, x)| sum.add_scaled(&T::one(), x)),
            None => self.spread = Some(load),
        }
        Ok(self)
    }

    /// Refuses forces that are not finite, or rows of another length than the control points.
    pub(crate) fn check_force(&self, index: usize, force: &S::Point) -> Result<()> {
        check_pair(&self.zero, force)?;
        if force.all_finite() { Ok(()) } else { Err(Error::NotFinite { what: "force", index }) }
    }

    /// Adds the loads that one map a direction makes of forces, row by row.
    fn spread_by(&mut self, maps: &[LinearMap<T>], forces: &[S::Point]) -> Result<&mut Self> {
        let expected = maps.iter().map(LinearMap::source_dim).product();
        if forces.len() != expected {
            return Err(Error::CoefficientCount { expected, found: forces.len() });
        }
        forces.iter().enumerate().try_for_each(|(index, force)| self.check_force(index, force))?;
        let load = match maps {
            [u, v] => {
                let rows: Vec<Row<S::Point>> = forces
                    .chunks_exact(v.source_dim())
                    .map(|row| Ok(Row(v.apply(row)?)))
                    .collect::<Result<_>>()?;
                u.apply(&rows)?.into_iter().flat_map(|row| row.0).collect()
            }
            _ => maps[0].apply(forces)?,
        };
        self.add_load(load)
    }

    /// The weights of one load, with the places of control points in the list.
    pub(crate) fn each_of(&self, load: &Load<T>, mut each: impl FnMut(usize, &T)) {
        let along = |direction: usize| {
            let space = self.elastic.stiffnesses()[direction].space();
            let row = &load[direction];
            row.weights().iter().enumerate().map(move |(k, w)| (space.slot(row.first() + k), w))
        };
        if load.len() == 1 {
            return along(0).for_each(|(i, w)| each(i, w));
        }
        let columns = self.elastic.stiffnesses()[1].space().dim();
        for (i, x) in along(0) {
            along(1).for_each(|(j, y)| each(i * columns + j, &(x.clone() * y)));
        }
    }
}

fn check_loads<T: Scalar, C: Coeff<T>>(loads: &[C]) -> Result<()> {
    match loads.iter().position(|load| !load.all_finite()) {
        Some(index) => Err(Error::NotFinite { what: "load", index }),
        None => Ok(()),
    }
}

impl<T: Scalar, C: Coeff<T>> Forces<'_, T, Spline<T, C>> {
    /// A force that varies along the curve, per unit of the parameter: any spline over its domain; its load `∫ N_i f` is exact over
    /// an exact field [Vassilev, (3)].
    ///
    /// # Errors
    /// [`Error::DomainMismatch`]; [`Error::Ragged`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, Elastic, Forces, Function, Material, Q, Scalar, SplineSpace};
    /// let mut rod = Function::constant(SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?, Q::int(0))?;
    /// let elastic = Elastic::of(&rod, &Material::new(Q::int(1), Q::int(0))?, &[Breadth::BetweenEnds(1)])?;
    /// let weight = Function::monomial(2, Q::int(0), Q::int(2))?;
    /// Forces::new(&elastic, &rod)?.density(&weight)?.push(&mut rod)?;
    /// assert_eq!(rod.coeffs(), [Q::int(0), Q::frac(7, 12), Q::int(0)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn density(&mut self, force: &Spline<T, C>) -> Result<&mut Self> {
        let gram = |along: &Stiffness<T>| along.space().gram(force.space(), 0, 0);
        self.spread_by(&[gram(&self.elastic.stiffnesses()[0])?], force.coeffs())
    }
}

impl<T: Scalar, C: Coeff<T>> Forces<'_, T, TensorSpline<T, C>> {
    /// A force that varies over the surface, per unit of the parameters: any spline over its domain; its load is exact over an exact
    /// field [Vassilev, (21)].
    ///
    /// # Errors
    /// [`Error::DomainMismatch`]; [`Error::Ragged`].
    pub fn density(&mut self, force: &TensorSpline<T, C>) -> Result<&mut Self> {
        let along = self.elastic.stiffnesses();
        let maps = [along[0].space().gram(force.u(), 0, 0)?, along[1].space().gram(force.v(), 0, 0)?];
        self.spread_by(&maps, force.coeffs())
    }
}
