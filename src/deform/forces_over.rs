//! Forces over an area of a surface.
//!
//! ```text
//! ∫∫ load(u, v) f(u, v) du dv  ≈  Δu Δv Σ load(u_i, v_j) f(u_i, v_j)
//! ```
//! with single forces in the middles of equal cells, those of the middles that lie in the area [Vassilev, section 3.7]. Loads are
//! products of loads along the directions: each row of cells is added up along `u` first, and then loads the control points once.

use crate::coeff::Coeff;
use crate::deform::area::Area;
use crate::deform::forces::Forces;
use crate::deform::forces_along::middles;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::limits::{MAX_SAMPLES, check_samples};
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::vector::Crossed;
use nalgebra::SVector;

/// Into how many equal cells the box around an area is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cells<T> {
    /// So many along `u` and along `v`.
    Counts(usize, usize),
    /// Along each direction as few as it takes that none is longer: `Δu` and `Δv` are about the same.
    Spacing(T),
}

impl<T: Scalar> Cells<T> {
    /// How many cells along `u` and along `v` a box has.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] for a spacing that is not positive; [`DeformError::NoSamples`] for no cells; [`Error::TooLarge`] for
    /// more than [`MAX_SAMPLES`].
    ///
    /// # Examples
    /// ```
    /// use symspline::Cells;
    /// assert_eq!(Cells::Spacing(0.25).counts(&[(0.0, 0.0), (1.0, 0.4)])?, (4, 2));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn counts(&self, [low, high]: &[(T, T); 2]) -> Result<(usize, usize)> {
        let (u, v) = match self {
            Self::Counts(u, v) => (*u, *v),
            Self::Spacing(spacing) if *spacing > T::zero() && spacing.is_finite() => {
                let fit = |from: &T, to: &T| {
                    let length = to.clone() - from;
                    // The greatest number of cells that leaves some of the length, bit by bit.
                    let below = (0..=MAX_SAMPLES.ilog2()).rev().fold(0, |sum, bit| {
                        let more = sum + (1 << bit);
                        if spacing.clone() * T::int(more as i64) < length { more } else { sum }
                    });
                    below + 1
                };
                (fit(&low.0, &high.0), fit(&low.1, &high.1))
            }
            Self::Spacing(spacing) => return Err(Error::BadTolerance { tolerance: spacing.to_string() }),
        };
        match u.saturating_mul(v) {
            0 => Err(DeformError::NoSamples.into()),
            count => check_samples(count).map(|()| (u, v)),
        }
    }
}

impl<T: Scalar, S: Controlled<T, Parameter = (T, T)>> Forces<'_, T, S> {
    /// A force over an area of the parameter plane, per unit of it: any function of the place `(u, v)`.
    ///
    /// The cells fill the box around the area, so a rectangle is filled exactly; at other boundaries the force is off by parts of
    /// cells. On an error nothing is added. A row of cells asks the area once, so with a curve around it many short rows take longer
    /// than few long ones.
    ///
    /// # Errors
    /// [`DeformError::NoSamples`] if no middle of a cell is in the area; [`Error::OutsideDomain`] if one is that is not on the
    /// surface; [`Error::NotFinite`]; [`Error::Ragged`]; those of [`Cells::counts`], of the area, and of `force`.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, Cells, DeformError, Elastic, Error, Forces, Material, Polygons, Q, Scalar, SplineSpace};
    /// use symspline::TensorSpline;
    /// let space = SplineSpace::uniform(3, 5, Q::int(0), Q::int(1))?;
    /// let mut plane = TensorSpline::constant(space.clone(), space, Q::int(0))?;
    /// let material = Material::new(Q::int(1), Q::int(1))?;
    /// let elastic = Elastic::of(&plane, &material, &[Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)])?;
    /// let x = |n| Q::frac(n, 5);
    /// let triangle = Polygons::new([[(x(1), x(1)), (x(4), x(1)), (x(1), x(4))]])?;
    /// let mut forces = Forces::new(&elastic, &plane)?;
    /// forces.over(&triangle, &Cells::Counts(9, 9), |_| Ok(Q::int(1)))?.push(&mut plane)?;
    /// assert_eq!(plane.at(&x(1), &x(2))?, plane.at(&x(2), &x(1))?);
    /// // The middle of the only cell is not in the area.
    /// let corner = Polygons::new([[(x(1), x(1)), (x(2), x(1)), (x(1), x(4))], [(x(3), x(4)), (x(4), x(4)), (x(4), x(1))]])?;
    /// let missed = forces.over(&corner, &Cells::Counts(1, 1), |_| Ok(Q::int(1))).map(|_| ());
    /// assert_eq!(missed, Err(Error::Deform(DeformError::NoSamples)));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn over(
        &mut self,
        area: &(impl Area<T> + ?Sized),
        cells: &Cells<T>,
        mut force: impl FnMut(&(T, T)) -> Result<S::Point>,
    ) -> Result<&mut Self> {
        let [low, high] = area.bounds()?;
        let (m, n) = cells.counts(&[low.clone(), high.clone()])?;
        let [along_u, along_v] = self.elastic.stiffnesses() else {
            return Err(Error::CoefficientCount { expected: 2, found: 1 });
        };
        let us: Vec<T> = middles(&low.0, &high.0, m).collect();
        let columns: Vec<_> = us.iter().map(|u| self.elastic.load_along(along_u, u)).collect();
        let step = |a: &T, b: &T, count: usize| (b.clone() - a) / T::int(count as i64);
        let cell = step(&low.0, &high.0, m) * step(&low.1, &high.1, n);
        let (u_space, v_space) = (along_u.space(), along_v.space());
        let mut total = self.no_load();
        let mut samples = 0;
        for v in middles(&low.1, &high.1, n) {
            let inside = area.inside(&us, &v)?;
            if !inside.contains(&true) {
                continue;
            }
            let load_v = self.elastic.load_along(along_v, &v)?;
            let mut row = vec![self.zero.clone(); u_space.dim()];
            for (i, u) in us.iter().enumerate().filter(|(i, _)| inside.get(*i) == Some(&true)) {
                let load_u = columns[i].as_ref().map_err(Error::clone)?;
                let force = force(&(u.clone(), v.clone()))?;
                self.check_force(samples, &force)?;
                samples += 1;
                for (k, weight) in load_u.weights().iter().enumerate() {
                    row[u_space.slot(load_u.first() + k)].add_scaled(weight, &force);
                }
            }
            for (k, weight) in load_v.weights().iter().enumerate() {
                let (j, weight) = (v_space.slot(load_v.first() + k), weight.clone() * &cell);
                let column = total.iter_mut().skip(j).step_by(v_space.dim());
                column.zip(&row).for_each(|(sum, x)| sum.add_scaled(&weight, x));
            }
        }
        match samples {
            0 => Err(DeformError::NoSamples.into()),
            _ => self.add_load(total),
        }
    }
}

impl<T, S> Forces<'_, T, S>
where
    T: Scalar,
    S: Controlled<T, Parameter = (T, T), Order = (usize, usize), Point = SVector<T, 3>>,
{
    /// A pressure over an area: a force along the normals, for each unit of area of `surface` itself.
    ///
    /// ```text
    /// ∫∫ load p n |S_u × S_v| du dv = ∫∫ load p (S_u × S_v) du dv        n = (S_u × S_v) / |S_u × S_v|
    /// ```
    /// so that it takes no square roots. Where the normal vanishes so does the force.
    ///
    /// # Errors
    /// As [`over`](Self::over); [`DeformError::OtherSpace`] for a surface of another kind.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Breadth, Cells, Elastic, Forces, Material, Polygons, SplineSpace, Surface};
    /// let space = SplineSpace::uniform(3, 5, 0.0, 1.0)?;
    /// let points = space.greville().iter().flat_map(|x| space.greville().into_iter().map(|y| vector![*x, y, 0.0])).collect();
    /// let mut sheet = Surface::new(space.clone(), space, points)?;
    /// let ends = [Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)];
    /// let elastic = Elastic::of(&sheet, &Material::new(1.0, 1.0)?, &ends)?;
    /// let square = Polygons::new([[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]])?;
    /// Forces::new(&elastic, &sheet)?.pressure(&sheet, &square, &Cells::Counts(20, 20), |_| Ok(1.0))?.push(&mut sheet)?;
    /// assert!(sheet.at(&0.5, &0.5)?[2] > 0.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn pressure(
        &mut self,
        surface: &S,
        area: &(impl Area<T> + ?Sized),
        cells: &Cells<T>,
        mut pressure: impl FnMut(&(T, T)) -> Result<T>,
    ) -> Result<&mut Self> {
        self.elastic.check(surface)?;
        self.over(area, cells, |at| {
            let tangents = [surface.derivative_of(at, (1, 0))?, surface.derivative_of(at, (0, 1))?];
            Ok(tangents[0].crossed(&tangents[1]).scaled(&pressure(at)?))
        })
    }
}
