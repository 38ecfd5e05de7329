//! Fine tuning of one surface by many scale functions, while a value of `α` is dragged: the map `α ↦ T` prepared.

use crate::constrain::norm::{CoeffSpace, Norm, SpacePair};
use crate::error::{Error, Result};
use crate::fine_tune::nearest_scale::NearestScale;
use crate::fine_tune::scale_space::check_values;
use crate::fine_tune::surface::condition::SurfaceCondition;
use crate::fine_tune::turn::Turnable;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::spline::Surface;
use nalgebra::SVector;

use super::edges::Edges;
use super::held::{hold_lines, in_line, restore_edges};
use super::path::Path;
use super::ways::Ways;

/// A surface prepared for fine tuning by scale functions over one pair of spaces.
///
/// # Examples
/// ```
/// use nalgebra::{SVector, vector};
/// use symspline::{Path, SplineSpace, Surface, SurfaceTuner, TensorSpline};
/// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
/// let corners = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0]];
/// let saddle = Surface::new(line.clone(), line.clone(), corners.map(|p| SVector::from(p)).to_vec())?;
/// let tuner = SurfaceTuner::free(&saddle, (&line, &line), Path::Both)?;
/// let mut points = vec![SVector::zeros(); tuner.u().dim() * tuner.v().dim()];
/// for last in [1.0, 1.5, 2.0] {
///     tuner.tune_into(&[1.0, 1.0, 1.0, last], &mut points)?;
/// }
/// let alpha = TensorSpline::new(line.clone(), line, vec![1.0, 1.0, 1.0, 2.0])?;
/// assert_eq!(points, saddle.fine_tuned(&alpha, Path::Both)?.coeffs());
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceTuner<T: Scalar, const N: usize> {
    ways: Ways<T, N>,
    scales: SpacePair<T>,
    held: Option<HeldEdges<T, N>>,
    nearest: Option<NearestScale<T, SpacePair<T>>>,
    /// Whether scale functions may have any sign.
    signed: bool,
}

/// What it takes to put edges back.
#[derive(Clone, Debug)]
struct HeldEdges<T, const N: usize> {
    edges: Edges,
    invariant: Vec<SVector<T, N>>,
    /// [`hold_lines`], known where the vectors are known to turn.
    hold: HoldLines<T, N>,
}

type HoldLines<T, const N: usize> = fn(
    &mut [SVector<T, N>],
    &[SVector<T, N>],
    usize,
    [Option<usize>; 2],
) -> std::result::Result<(), (usize, Error)>;

impl<T: Scalar, const N: usize> SurfaceTuner<T, N> {
    /// The map from scale functions over the spaces `scales` to [fine-tuned](Surface::fine_tuned) surfaces.
    ///
    /// # Errors
    /// As [`fine_tuned`](Surface::fine_tuned) has them; [`TooLarge`](Error::TooLarge).
    pub fn free(
        surface: &Surface<T, N>,
        scales: (&SplineSpace<T>, &SplineSpace<T>),
        path: Path,
    ) -> Result<Self> {
        Ok(Self {
            ways: Ways::new(surface, scales, path, Edges::default())?,
            scales: (scales.0.clone(), scales.1.clone()),
            held: None,
            nearest: None,
            signed: false,
        })
    }

    /// As [`free`](Self::free), by the [nearest](NearestScale) scale functions with which the surface meets `conditions`.
    ///
    /// # Errors
    /// Those of [`free`](Self::free) and [`NearestScale::on_surface`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Edge, Norm, Path, Q, Scalar, SplineSpace, Surface, SurfaceCondition, SurfaceTuner};
    /// let parabola = SplineSpace::bezier(2, Q::int(0), Q::int(1))?;
    /// let points = (0..9).map(|i| vector![Q::int(i / 3), Q::int(i % 3), Q::int(i % 4)]).collect();
    /// let surface = Surface::new(parabola.clone(), parabola, points)?;
    /// let scales = SplineSpace::uniform(2, 4, Q::int(0), Q::int(1))?;
    /// let edges = Edge::ALL.map(|edge| SurfaceCondition::Edge { edge, order: 0 });
    /// let pair = (&scales, &scales);
    /// let tuner = SurfaceTuner::constrained(&surface, pair, Path::Both, &edges, Norm::Coefficients)?;
    /// let mut wanted = vec![Q::int(1); 36];
    /// wanted[14] = Q::int(2);
    /// let (tuned, third) = (tuner.tuned(&wanted)?, Q::frac(1, 3));
    /// assert_eq!(tuned.at(&third, &Q::int(1))?, surface.at(&third, &Q::int(1))?);
    /// assert_ne!(tuned.at(&third, &third)?, surface.at(&third, &third)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn constrained(
        surface: &Surface<T, N>,
        scales: (&SplineSpace<T>, &SplineSpace<T>),
        path: Path,
        conditions: &[SurfaceCondition<T, N>],
        norm: Norm,
    ) -> Result<Self> {
        let free = Self::free(surface, scales, path)?;
        let nearest = NearestScale::on_ways(surface, &free.ways, scales, conditions, norm)?;
        Ok(Self { nearest: Some(nearest), ..free })
    }

    /// As [`free`](Self::free), with the edges put back as [`fine_tuned_holding`](Surface::fine_tuned_holding) does.
    ///
    /// # Errors
    /// Those of [`free`](Self::free); [`TuneError`](crate::TuneError) and [`CoefficientCount`](Error::CoefficientCount) as
    /// [`fine_tuned_holding`](Surface::fine_tuned_holding) has them, as far as they do not depend on the scale.
    pub fn prepare(
        surface: &Surface<T, N>,
        scales: (&SplineSpace<T>, &SplineSpace<T>),
        path: Path,
        edges: Edges,
    ) -> Result<Self>
    where
        SVector<T, N>: Turnable<T>,
    {
        edges.check(surface)?;
        if edges == Edges::default() {
            return Self::free(surface, scales, path);
        }
        let ways = Ways::new(surface, scales, path, edges)?;
        let shape = Surface::constant(ways.u.clone(), ways.v.clone(), SVector::zeros())?;
        let invariant = surface.invariant(&shape)?.into_coeffs();
        let held = Some(HeldEdges { edges, invariant, hold: hold_lines });
        let scales = (scales.0.clone(), scales.1.clone());
        let tuner = Self { ways, scales, held, nearest: None, signed: false };
        // The scale one says what no scale can hold.
        tuner.walk(&vec![T::one(); tuner.scales.dim()], &mut shape.into_coeffs())?;
        Ok(tuner)
    }

    /// The same without asking for positive scale functions, as [`Scale::Signed`](crate::Scale::Signed).
    pub fn signed(self) -> Self {
        Self { signed: true, ..self }
    }

    /// The space in `u` of the tuned surfaces.
    pub fn u(&self) -> &SplineSpace<T> {
        &self.ways.u
    }

    /// The space in `v` of the tuned surfaces.
    pub fn v(&self) -> &SplineSpace<T> {
        &self.ways.v
    }

    /// The spaces of the scale functions.
    pub fn scales(&self) -> (&SplineSpace<T>, &SplineSpace<T>) {
        (&self.scales.0, &self.scales.1)
    }

    /// The surface tuned by the scale function with these coefficients, row by row.
    ///
    /// # Errors
    /// Those of [`tune_into`](Self::tune_into); [`NotFinite`](Error::NotFinite) on overflow.
    pub fn tuned(&self, alpha: &[T]) -> Result<Surface<T, N>> {
        let mut points = vec![SVector::zeros(); self.u().dim() * self.v().dim()];
        self.tune_into(alpha, &mut points)?;
        Surface::new(self.u().clone(), self.v().clone(), points)
    }

    /// Writes the control points of the [tuned](Self::tuned) surface to `points`, row by row. While the values of `alpha` are
    /// positive nothing is searched; other scale functions are first proved to be positive. Under conditions `alpha` is what
    /// is wanted, and a nearest scale function that is not positive takes a quadratic program.
    ///
    /// # Errors
    /// [`CoefficientCount`](Error::CoefficientCount) unless `alpha` and `points` are as many as their spaces say;
    /// [`NotFinite`](Error::NotFinite) if a value of `alpha` is not finite (overflow on the way to `points` is not looked for,
    /// but by [`tuned`](Self::tuned)); [`NotPositive`](Error::NotPositive), [`Undecided`](Error::Undecided); under conditions
    /// those of [`NearestScale::to`]; with held edges [`TuneError::NoChord`](crate::TuneError::NoChord). Then `points` is as it
    /// was.
    pub fn tune_into(&self, alpha: &[T], points: &mut [SVector<T, N>]) -> Result<()> {
        let places = self.u().dim() * self.v().dim();
        if points.len() != places {
            return Err(Error::CoefficientCount { expected: places, found: points.len() });
        }
        match &self.nearest {
            Some(nearest) => {
                check_values(&self.scales, alpha, true)?;
                self.walk(&nearest.near(alpha.to_vec(), self.signed)?, points)
            }
            None => {
                check_values(&self.scales, alpha, self.signed)?;
                self.walk(alpha, points)
            }
        }
    }

    /// The control points, after each path the ends of its lines held, then the edges.
    fn walk(&self, alpha: &[T], points: &mut [SVector<T, N>]) -> Result<()> {
        let Some(held) = &self.held else {
            points.clone_from_slice(&self.ways.walk(alpha, |_, _| Ok(()))?);
            return Ok(());
        };
        let mut mean = self.ways.walk(alpha, |way, lines| {
            let (last, length) = (way.table.last, way.table.length);
            (held.hold)(lines, &way.invariant, length, held.edges.orders(last))
                .map_err(|(line, error)| in_line(error, last, line))
        })?;
        restore_edges(&mut mean, &held.invariant, [self.u().dim(), self.v().dim()], held.edges)?;
        points.clone_from_slice(&mean);
        Ok(())
    }
}
