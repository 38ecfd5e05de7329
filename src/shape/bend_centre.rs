//! What shapes are bent towards: a point, or the nearest point of an axis, which is a straight line or the offset of an isocurve.

use crate::coeff::Coeff;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::root::{divided, size};
use crate::tensor::along::Direction;
use crate::vector::{cross3, dot, unit};
use nalgebra::SVector;

/// Something that gives each control point its centre `O`.
pub trait BendCentre<T: Scalar, const N: usize> {
    /// The centre of a control point.
    ///
    /// # Errors
    /// Those of the search for it.
    fn centre_of(&self, point: &SVector<T, N>) -> Result<SVector<T, N>>;
}

/// One centre for all.
impl<T: Scalar, const N: usize> BendCentre<T, N> for SVector<T, N> {
    fn centre_of(&self, _: &SVector<T, N>) -> Result<SVector<T, N>> {
        Ok(self.clone())
    }
}

/// The straight axis `Q + w V`.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Axis, BendCentre};
/// let axis = Axis::new(vector![0.0, 0.0, 1.0], vector![0.0, 2.0, 0.0])?;
/// assert_eq!(axis.centre_of(&vector![3.0, 4.0, 5.0])?, vector![0.0, 4.0, 1.0]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Axis<T, const N: usize> {
    origin: SVector<T, N>,
    direction: SVector<T, N>,
}

impl<T: Scalar, const N: usize> Axis<T, N> {
    /// The axis through `origin` in `direction`.
    ///
    /// # Errors
    /// [`ShapeError::NoDirection`].
    pub fn new(origin: SVector<T, N>, direction: SVector<T, N>) -> Result<Self> {
        if direction.vanishes() || !direction.all_finite() {
            return Err(ShapeError::NoDirection { what: "axis" }.into());
        }
        Ok(Self { origin, direction })
    }
}

impl<T: Scalar, const N: usize> BendCentre<T, N> for Axis<T, N> {
    /// `Q + w V` with `w = V·(P - Q) / V·V` [NURBS, (11.63)].
    fn centre_of(&self, point: &SVector<T, N>) -> Result<SVector<T, N>> {
        let along = divided(&self.direction, &size(&self.direction));
        let w = dot(&along, &point.minus(&self.origin)) / along.squared_size();
        Ok(self.origin.plus_scaled(&w, &along))
    }
}

/// How many places of each span are looked at first.
const SAMPLES: usize = 8;

/// The most steps of the search between two of them.
const STEPS: usize = 100;

/// The axis `O(w) = S(u_c, w) + d N(u_c, w)` at a distance from an isocurve, with `N` the unit normal [NURBS, (11.62)].
///
/// The nearest point of the axis is looked for between the samples around the nearest one, at an end of the axis at the other end
/// too, where a closed one goes on: eight a span, which takes the axis to be well-behaved, not proved.
#[derive(Clone, Debug)]
pub struct OffsetAxis<S> {
    surface: S,
    /// Along what the surface is bent: the isocurve runs across.
    direction: Direction,
    at: f64,
    offset: f64,
    /// Parameters of the isocurve with the points of the axis there.
    samples: Vec<(f64, SVector<f64, 3>)>,
}

impl<S> OffsetAxis<S>
where
    S: Controlled<f64, Point = SVector<f64, 3>, Parameter = (f64, f64), Order = (usize, usize)>,
{
    /// The axis at the signed distance `offset`, to the side of `S_u × S_v`, from the isocurve where the parameter in `direction`
    /// is `at`.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::NotFinite`] for the offset; [`Error::NoNormal`] if the surface has none somewhere on the
    /// isocurve.
    pub fn new(surface: &S, direction: Direction, at: f64, offset: f64) -> Result<Self> {
        if !offset.is_finite() {
            return Err(Error::NotFinite { what: "offset", index: 0 });
        }
        let across = match direction {
            Direction::U => Direction::V,
            Direction::V => Direction::U,
        };
        let breaks: Vec<f64> = surface.space_along(across).breaks().into_iter().map(|(t, _)| t).collect();
        let mut axis = Self { surface: surface.clone(), direction, at, offset, samples: Vec::new() };
        let inside = breaks.windows(2).flat_map(|ends| {
            let step = (ends[1] - ends[0]) / SAMPLES as f64;
            (0..SAMPLES).map(move |k| ends[0] + k as f64 * step)
        });
        let last = breaks.last().copied();
        let sample = |w: f64| Ok((w, axis.point(w)?));
        axis.samples = inside.chain(last).map(sample).collect::<Result<_>>()?;
        Ok(axis)
    }

    /// The parameters of the surface at a parameter of the isocurve.
    fn place(&self, w: f64) -> (f64, f64) {
        match self.direction {
            Direction::U => (self.at, w),
            Direction::V => (w, self.at),
        }
    }

    /// A point of the axis.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`]; [`Error::NoNormal`].
    pub fn point(&self, w: f64) -> Result<SVector<f64, 3>> {
        let [point, _] = self.jet(w, 0)?;
        Ok(point)
    }

    /// A point of the axis, with the derivative there for order 1: `N' = (n' - N (N·n')) / |n|` with `n = S_u × S_v`.
    fn jet(&self, w: f64, order: usize) -> Result<[SVector<f64, 3>; 2]> {
        let place = self.place(w);
        let d = |k: usize, l: usize| self.surface.derivative_of(&place, (k, l));
        let (along_u, along_v) = (d(1, 0)?, d(0, 1)?);
        let normal = cross3(&along_u, &along_v);
        let (unit, length) = unit(&normal).ok_or_else(|| Error::no_normal(&place.0, &place.1))?;
        let point = d(0, 0)? + unit * self.offset;
        if order == 0 {
            return Ok([point, SVector::zeros()]);
        }
        let (speed, turned) = match self.direction {
            Direction::U => (along_v, cross3(&d(1, 1)?, &along_v) + cross3(&along_u, &d(0, 2)?)),
            Direction::V => (along_u, cross3(&d(2, 0)?, &along_v) + cross3(&along_u, &d(1, 1)?)),
        };
        let rate = (turned - unit * unit.dot(&turned)) / length;
        Ok([point, speed + rate * self.offset])
    }
}

impl<S> BendCentre<f64, 3> for OffsetAxis<S>
where
    S: Controlled<f64, Point = SVector<f64, 3>, Parameter = (f64, f64), Order = (usize, usize)>,
{
    fn centre_of(&self, point: &SVector<f64, 3>) -> Result<SVector<f64, 3>> {
        let off = |k: &usize| (self.samples[*k].1 - point).norm();
        let count = self.samples.len();
        let best = (0..count).min_by(|j, k| off(j).total_cmp(&off(k))).ok_or(Error::NoLength)?;
        let mut nearest = self.samples[best].1;
        // A domain has a span, and so two samples.
        let around = if best == 0 || best + 1 == count { [0, count - 2] } else { [best - 1, best] };
        for (low, high) in around.map(|low| (low, low + 1)) {
            if let Some(found) = self.foot_between(point, self.samples[low].0, self.samples[high].0)?
                && (found - point).norm() < (nearest - point).norm()
            {
                nearest = found;
            }
        }
        Ok(nearest)
    }
}

impl<S> OffsetAxis<S>
where
    S: Controlled<f64, Point = SVector<f64, 3>, Parameter = (f64, f64), Order = (usize, usize)>,
{
    /// The point between two parameters where the distance from `point` stops falling, if it falls at the first and rises at the
    /// second: by secants that keep it between, halving where they are slow.
    fn foot_between(&self, point: &SVector<f64, 3>, low: f64, high: f64) -> Result<Option<SVector<f64, 3>>> {
        let slope = |w: f64| -> Result<(SVector<f64, 3>, f64)> {
            let [place, speed] = self.jet(w, 1)?;
            Ok((place, (place - point).dot(&speed)))
        };
        let (mut low, mut high) = ((low, slope(low)?.1), (high, slope(high)?.1));
        if low.1 >= 0.0 || high.1 <= 0.0 {
            return Ok(None);
        }
        let mut found = None;
        for step in 0..STEPS {
            let secant = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
            let middle = 0.5 * (low.0 + high.0);
            let w = if step % 3 < 2 && low.0 < secant && secant < high.0 { secant } else { middle };
            if w <= low.0 || w >= high.0 {
                break;
            }
            let (place, rate) = slope(w)?;
            found = Some(place);
            if rate == 0.0 {
                break;
            }
            if rate < 0.0 { low = (w, rate) } else { high = (w, rate) }
        }
        Ok(found)
    }
}
