//! Forces at many places at once, and along curves of a surface.
//!
//! A force `f(t)` along a curve `c(t) = (u(t), v(t))` of a surface loads the control points by
//!
//! ```text
//! ∫ load(c(t)) f(t) dt  ≈  Δt Σ_k load(c(t_k)) f(t_k)        t_k = a + (k + 1/2) Δt,  Δt = (b - a) / n
//! ```
//! with single forces at equal distances of the parameter [Vassilev, section 3.6], by the midpoint rule: the total force is that
//! of the integral, no end counts half and no seam twice. All samples go into one grid of loads, answered by one solution.

use crate::analysis::length::gauss::Rule;
use crate::coeff::Coeff;
use crate::deform::forces::Forces;
use crate::deform::stiffness::Stiffness;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::limits::check_samples;
use crate::ops::cuts::cuts;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::spline::{Curve, Spline};

impl<T: Scalar, S: Controlled<T>> Forces<'_, T, S> {
    /// Forces at many places, added up as they come: they take no room each, and one solution answers them all.
    ///
    /// On an error none of them counts.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::Ragged`]; [`Error::NotFinite`]; [`Error::TooLarge`] for more than
    /// [`MAX_SAMPLES`](crate::limits::MAX_SAMPLES).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, Elastic, Forces, Function, Material, Q, Scalar, SplineSpace};
    /// let mut rod = Function::constant(SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?, Q::int(0))?;
    /// let elastic = Elastic::of(&rod, &Material::new(Q::int(1), Q::int(0))?, &[Breadth::BetweenEnds(1)])?;
    /// let forces = (1..4).map(|i| (Q::frac(i, 2), Q::int(1)));
    /// Forces::new(&elastic, &rod)?.at_all(forces)?.push(&mut rod)?;
    /// assert_eq!(rod.coeffs(), [Q::int(0), Q::frac(3, 4), Q::int(0)]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn at_all(
        &mut self,
        forces: impl IntoIterator<Item = (S::Parameter, S::Point)>,
    ) -> Result<&mut Self> {
        self.at_each(forces.into_iter().map(Ok))
    }

    /// As [`at_all`](Self::at_all), of places and forces that may be none.
    fn at_each(
        &mut self,
        forces: impl IntoIterator<Item = Result<(S::Parameter, S::Point)>>,
    ) -> Result<&mut Self> {
        let mut total = self.no_load();
        for (index, place) in forces.into_iter().enumerate() {
            check_samples(index + 1)?;
            let (at, force) = place?;
            self.check_force(index, &force)?;
            let load = self.elastic.load_at(|direction| S::coordinate(&at, direction))?;
            self.each_of(&load, |i, weight| total[i].add_scaled(weight, &force));
        }
        self.add_load(total)
    }
}

impl<T: Scalar, S: Controlled<T, Parameter = (T, T)>> Forces<'_, T, S> {
    /// A force that varies along a curve `(u(t), v(t))` of the surface, per unit of its parameter: `force` at the middles of
    /// `samples` equal parts of the domain [Vassilev, section 3.6].
    ///
    /// On an error nothing is added.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`] unless path and force have the same domain; those of [`along_by`](Self::along_by).
    ///
    /// # Examples
    /// A ridge that rises from nothing:
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Breadth, Elastic, Forces, Function, Material, Q, Scalar, SplineSpace, TensorSpline, segment};
    /// let space = SplineSpace::uniform(3, 5, Q::int(0), Q::int(1))?;
    /// let mut plane = TensorSpline::constant(space.clone(), space, Q::int(0))?;
    /// let material = Material::new(Q::int(1), Q::int(1))?;
    /// let elastic = Elastic::of(&plane, &material, &[Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)])?;
    /// let (half, low, high) = (Q::frac(1, 2), Q::frac(1, 5), Q::frac(4, 5));
    /// let path = segment(&vector![low, half.clone()], &vector![high.clone(), half.clone()])?;
    /// let rising = Function::monomial(1, Q::int(0), Q::int(1))?;
    /// Forces::new(&elastic, &plane)?.along(&path, &rising, 20)?.push(&mut plane)?;
    /// assert!(plane.at(&high, &half)? > plane.at(&Q::frac(1, 5), &half)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn along(
        &mut self,
        path: &Curve<T, 2>,
        force: &Spline<T, S::Point>,
        samples: usize,
    ) -> Result<&mut Self> {
        path.space().check_same_domain(force.space())?;
        let mut span = 0;
        self.along_by(path, samples, |t, _| force.at_near(t, &mut span))
    }

    /// As [`along`](Self::along), with any function of the parameter `t` and of the place `(u, v)` for the force.
    ///
    /// # Errors
    /// [`DeformError::NoSamples`] for none; [`Error::TooLarge`] for more than
    /// [`MAX_SAMPLES`](crate::limits::MAX_SAMPLES); [`Error::LeavesDomain`] with the parameter `t` where the path is not on the
    /// surface; [`Error::Ragged`]; [`Error::NotFinite`]; those of `force`.
    pub fn along_by(
        &mut self,
        path: &Curve<T, 2>,
        samples: usize,
        mut force: impl FnMut(&T, &(T, T)) -> Result<S::Point>,
    ) -> Result<&mut Self> {
        check_samples(samples)?;
        if samples == 0 {
            return Err(DeformError::NoSamples.into());
        }
        let (a, b) = path.domain();
        let step = (b.clone() - a) / T::int(samples as i64);
        let on_surface = |(direction, along): (usize, &Stiffness<T>)| {
            let (start, end) = along.space().domain();
            let inside = path.coeffs().iter().all(|c| *start <= c[direction] && c[direction] <= *end);
            (start.clone(), end.clone(), inside)
        };
        let sides: Vec<(T, T, bool)> =
            self.elastic.stiffnesses().iter().enumerate().map(on_surface).collect();
        let mut span = 0;
        let sample = |t: T| {
            let mut at: [T; 2] = path.at_near(&t, &mut span)?.into();
            for (x, (start, end, inside)) in at.iter_mut().zip(&sides) {
                if *start <= *x && *x <= *end {
                    continue;
                }
                if !*inside {
                    let [value, parameter, start, end] = [&*x, &t, start, end].map(T::to_string);
                    return Err(Error::LeavesDomain { value, parameter, start, end });
                }
                // A mean of control points is not outside: it was rounded.
                *x = if *x < *start { start.clone() } else { end.clone() };
            }
            let at = at.into();
            let mut force = force(&t, &at)?;
            force.scale(&step);
            Ok((at, force))
        };
        self.at_each(middles(a, b, samples).map(sample))
    }
}

impl<S: Controlled<f64, Parameter = (f64, f64)>> Forces<'_, f64, S> {
    /// As [`along`](Self::along), but for rounding with the integral itself.
    ///
    /// Between the parameters where the path crosses knots of the surface the load is a polynomial, for which a Gauss rule of enough
    /// nodes is exact.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`] unless path and force have the same domain; [`Error::LeavesDomain`] with a parameter where the path
    /// is not on the surface; [`Error::DegreeTooHigh`]; [`Error::TooLarge`]; [`Error::Ragged`]; [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Breadth, Elastic, Forces, Function, Material, SplineSpace, TensorSpline, segment};
    /// let space = SplineSpace::uniform(3, 5, 0.0, 1.0)?;
    /// let plane = TensorSpline::constant(space.clone(), space, 0.0)?;
    /// let material = Material::new(1.0, 1.0)?;
    /// let elastic = Elastic::of(&plane, &material, &[Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)])?;
    /// let path = segment(&vector![0.1, 0.2], &vector![0.9, 0.7])?;
    /// let rising = Function::monomial(1, 0.0, 1.0)?;
    /// let (mut exactly, mut nearly) = (Forces::new(&elastic, &plane)?, Forces::new(&elastic, &plane)?);
    /// exactly.along_exactly(&path, &rising)?;
    /// nearly.along(&path, &rising, 10_000)?;
    /// let both = [exactly.load()?, nearly.load()?];
    /// assert!(both[0].iter().zip(&both[1]).all(|(x, y)| (x - y).abs() < 1e-9));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn along_exactly(
        &mut self,
        path: &Curve<f64, 2>,
        force: &Spline<f64, S::Point>,
    ) -> Result<&mut Self> {
        path.space().check_same_domain(force.space())?;
        let [along_u, along_v] = self.elastic.stiffnesses() else {
            return Err(Error::CoefficientCount { expected: 2, found: 1 });
        };
        let spaces = (self.elastic.load_space(along_u)?, self.elastic.load_space(along_v)?);
        let (u, v) = (path.coordinate(0)?, path.coordinate(1)?);
        let cut = cuts([(&spaces.0, &u), (&spaces.1, &v)])?.space;
        let rule = Rule::new((cut.degree() + force.degree()) / 2 + 1);
        let breaks = cut.breaks().into_iter().chain(force.space().breaks());
        let mut ends: Vec<f64> = breaks.map(|(t, _)| t).collect();
        ends.sort_by(f64::total_cmp);
        let inside = |x: f64, (a, b): (&f64, &f64)| x.clamp(*a, *b);
        let sample = |ends: &[f64], (node, weight): &(f64, f64)| {
            let length = ends[1] - ends[0];
            let t = ends[0] + length * node;
            let at = path.at(&t)?;
            // The path is proved to be on the surface; its points are rounded.
            let at = (inside(at[0], along_u.space().domain()), inside(at[1], along_v.space().domain()));
            Ok((at, force.at(&t)?.scaled(&(weight * length))))
        };
        let pieces = ends.windows(2).filter(|ends| ends[0] < ends[1]);
        self.at_each(pieces.flat_map(|ends| rule.nodes().iter().map(move |node| sample(ends, node))))
    }
}

/// The middles of `count` equal parts of `[a, b]`.
pub(crate) fn middles<T: Scalar>(a: &T, b: &T, count: usize) -> impl Iterator<Item = T> {
    let (a, length) = (a.clone(), b.clone() - a);
    (0..count as i64).map(move |k| a.clone() + T::frac(2 * k + 1, 2 * count as i64) * &length)
}
