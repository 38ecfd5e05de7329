//! Gravity fields of polylines and curves in the parameter plane: what is within a distance is pulled
//! [NURBS, (11.52)-(11.55)].

use crate::analysis::nearest::projector::Projector;
use crate::error::{Error, Result};
use crate::scalar::{Scalar, larger};
use crate::shape::polygon::check_finite;
use crate::spline::Curve;
use nalgebra::vector;

/// What pulls at a point: the foot of the perpendicular on the nearest line.
#[derive(Clone, Debug, PartialEq)]
pub struct GravityPull<T> {
    /// The squared distance `d²` to the line.
    pub squared_distance: T,
    /// Which of the lines.
    pub line: usize,
    /// The place `λ` of the foot on it: of a polyline the index of the leg and the share of it, of a curve its parameter.
    pub place: T,
    /// The foot, in the parameter plane.
    pub foot: (T, T),
}

/// The field of some polylines.
///
/// # Examples
/// ```
/// use symspline::{Gravity, Q, Scalar};
/// let corner = [(0, 0), (4, 0), (4, 4)].map(|(u, v)| (Q::int(u), Q::int(v)));
/// let field = Gravity::new([corner], Q::int(1))?;
/// let pull = field.pull(&(Q::int(1), Q::frac(-1, 2))).expect("it is near");
/// assert_eq!((pull.squared_distance, pull.place), (Q::frac(1, 4), Q::frac(1, 4)));
/// assert!(field.pull(&(Q::int(1), Q::int(2))).is_none());
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Gravity<T> {
    polylines: Vec<Vec<(T, T)>>,
    squared_radius: T,
}

/// The field of some curves in the parameter plane.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{CurveGravity, Curve, SplineSpace};
/// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, 0.0]];
/// let field = CurveGravity::new(&[Curve::new(SplineSpace::bezier(2, 0.0, 1.0)?, points)?], 0.5)?;
/// let pull = field.pull(&(1.0, 1.25))?.expect("it is near");
/// assert!((pull.squared_distance - 0.0625).abs() < 1e-9 && (pull.place - 0.5).abs() < 1e-4);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurveGravity {
    curves: Vec<Projector<f64, 2>>,
    radius: f64,
}

impl<T: Scalar> Gravity<T> {
    /// The field of radius `radius` around polylines. One of a single point is a disc.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`] for a polyline without points; [`Error::NotFinite`] for a corner, or a leg; [`Error::BadTolerance`]
    /// unless the radius is finite with its square, and not negative, and its square vanishes with it alone.
    pub fn new<I: IntoIterator<Item = (T, T)>>(
        polylines: impl IntoIterator<Item = I>,
        radius: T,
    ) -> Result<Self> {
        let polylines: Vec<Vec<_>> = polylines.into_iter().map(|line| line.into_iter().collect()).collect();
        for line in &polylines {
            check_finite(line)?;
            if line.is_empty() {
                return Err(Error::TooFewPoints { expected: 1, found: 0 });
            }
            let is_long = |pair: &[(T, T)]| {
                let (x, y) = (pair[1].0.clone() - &pair[0].0, pair[1].1.clone() - &pair[0].1);
                !(x.is_finite() && y.is_finite())
            };
            if let Some(index) = line.windows(2).position(is_long) {
                return Err(Error::NotFinite { what: "leg", index });
            }
        }
        let squared_radius = radius.clone() * &radius;
        let vanishes = squared_radius.is_zero() && !radius.is_zero();
        if radius < T::zero() || !squared_radius.is_finite() || vanishes {
            return Err(Error::BadTolerance { tolerance: radius.to_string() });
        }
        Ok(Self { polylines, squared_radius })
    }

    /// The squared radius.
    pub fn squared_radius(&self) -> &T {
        &self.squared_radius
    }

    /// What pulls at a point: the nearest place of the polylines, if it is not farther away than the radius. Of several
    /// the first.
    pub fn pull(&self, point: &(T, T)) -> Option<GravityPull<T>> {
        let mut nearest: Option<GravityPull<T>> = None;
        for (line, corners) in self.polylines.iter().enumerate() {
            for leg in 0..corners.len().saturating_sub(1).max(1) {
                let pull = self.pull_of(point, line, leg);
                let near = pull.squared_distance <= self.squared_radius;
                if near && nearest.as_ref().is_none_or(|best| pull.squared_distance < best.squared_distance) {
                    nearest = Some(pull);
                }
            }
        }
        nearest
    }

    /// The foot on one leg.
    fn pull_of(&self, (u, v): &(T, T), line: usize, leg: usize) -> GravityPull<T> {
        let corners = &self.polylines[line];
        let (a, b) = (&corners[leg], &corners[(leg + 1).min(corners.len() - 1)]);
        let (x, y) = (b.0.clone() - &a.0, b.1.clone() - &a.1);
        let (du, dv) = (u.clone() - &a.0, v.clone() - &a.1);
        // In units of the leg, so that no square overflows or vanishes.
        let unit = larger(x.magnitude(), y.magnitude());
        let (mut share, mut across) = (T::zero(), None);
        if !unit.is_zero() {
            let (x, y) = (x.clone() / &unit, y.clone() / &unit);
            let square = x.clone() * &x + y.clone() * &y;
            share = (du.clone() / &unit * &x + dv.clone() / &unit * &y) / &square;
            let cross = x * &dv - y * &du;
            across = Some(cross.clone() * cross / square);
        }
        let is_inside = share > T::zero() && share < T::one();
        share = if is_inside || share <= T::zero() { larger(share, T::zero()) } else { T::one() };
        let foot = (a.0.clone() + x * &share, a.1.clone() + y * &share);
        let from_foot = || {
            let (du, dv) = (u.clone() - &foot.0, v.clone() - &foot.1);
            du.clone() * &du + dv.clone() * &dv
        };
        // The height over the leg, which is more exact than the distance from the foot.
        let squared_distance = across.filter(|_| is_inside).unwrap_or_else(from_foot);
        GravityPull { squared_distance, line, place: T::int(leg as i64) + share, foot }
    }
}

impl CurveGravity {
    /// The field of radius `radius` around curves.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] unless the radius is finite and not negative; those of [`Curve::projector`].
    pub fn new(curves: &[Curve<f64, 2>], radius: f64) -> Result<Self> {
        if !(radius.is_finite() && radius >= 0.0) {
            return Err(Error::BadTolerance { tolerance: radius.to_string() });
        }
        Ok(Self { curves: curves.iter().map(Curve::projector).collect::<Result<_>>()?, radius })
    }

    /// What pulls at a point: the nearest place of the curves, if it is not farther away than the radius. Of several the
    /// first.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a point that is not finite.
    pub fn pull(&self, (u, v): &(f64, f64)) -> Result<Option<GravityPull<f64>>> {
        let mut nearest = None;
        let mut most = self.radius;
        for (line, curve) in self.curves.iter().enumerate() {
            let foot = curve.foot(&vector![*u, *v])?;
            if foot.distance < most || (nearest.is_none() && foot.distance <= most) {
                most = foot.distance;
                nearest = Some(GravityPull {
                    squared_distance: foot.distance * foot.distance,
                    line,
                    place: foot.parameter,
                    foot: (foot.point[0], foot.point[1]),
                });
            }
        }
        Ok(nearest)
    }
}
