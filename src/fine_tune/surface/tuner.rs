//! Fine tuning of one surface by many scale functions, while a value of `α` is dragged: the map `α ↦ T` prepared.

use crate::coeff::Coeff;
use crate::constrain::norm::Norm;
use crate::error::{Error, Result};
use crate::fine_tune::nearest_scale::NearestScale;
use crate::fine_tune::scale::Scale;
use crate::fine_tune::scale_space::check_values;
use crate::fine_tune::surface::condition::SurfaceCondition;
use crate::fine_tune::turn::Turnable;
use crate::functional::weigh;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::{Surface, TensorSpline};
use nalgebra::SVector;

use super::edges::Edges;
use super::held::{hold_lines, in_line, restore_edges};
use super::path::Path;
use super::table::{PathTable, transposed};

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
    u: SplineSpace<T>,
    v: SplineSpace<T>,
    scales: (SplineSpace<T>, SplineSpace<T>),
    /// One, or two of which the mean is taken.
    ways: Vec<Way<T, N>>,
    held: Option<HeldEdges<T, N>>,
    nearest: Option<NearestScale<T, (SplineSpace<T>, SplineSpace<T>)>>,
    /// Whether scale functions may have any sign.
    signed: bool,
}

/// One path.
#[derive(Clone, Debug)]
struct Way<T, const N: usize> {
    table: PathTable<T, N>,
    /// The control points of the invariant surface, line after line as the table has them; none if no ends of
    /// lines are held.
    invariant: Vec<SVector<T, N>>,
    /// From the control points of this path to those of the mean, across and along the direction in which it ends, where these
    /// are others.
    finish: [Option<LinearMap<T>>; 2],
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
        Self::with_edges(surface, scales, path, Edges::default())
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
        let nearest = NearestScale::on_surface(surface, scales, path, conditions, norm)?;
        Ok(Self { nearest: Some(nearest), ..Self::free(surface, scales, path)? })
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
        let mut tuner = Self::with_edges(surface, scales, path, edges)?;
        if edges == Edges::default() {
            return Ok(tuner);
        }
        let shape = Surface::constant(tuner.u.clone(), tuner.v.clone(), SVector::zeros())?;
        let invariant = surface.invariant(&shape)?.into_coeffs();
        tuner.held = Some(HeldEdges { edges, invariant, hold: hold_lines });
        // The scale one says what no scale can hold.
        let mut points = shape.into_coeffs();
        tuner.walk(&vec![T::one(); scales.0.dim() * scales.1.dim()], &mut points)?;
        Ok(tuner)
    }

    fn with_edges(
        surface: &Surface<T, N>,
        scales: (&SplineSpace<T>, &SplineSpace<T>),
        path: Path,
        edges: Edges,
    ) -> Result<Self> {
        let one = TensorSpline::constant(scales.0.clone(), scales.1.clone(), T::one())?;
        let is_held = |last: Direction| edges.orders(last) != [None, None];
        let shape = |last: Direction| {
            if is_held(last) {
                surface.swept(last, &one)
            } else {
                surface.fine_tuned(Scale::Signed(&one), Path::ending_in(last))
            }
        };
        let lasts: &[Direction] = match path {
            Path::UThenV => &[V],
            Path::VThenU => &[U],
            Path::Both => &[V, U],
        };
        let shapes: Vec<Surface<T, N>> = lasts.iter().map(|last| shape(*last)).collect::<Result<_>>()?;
        let common = match shapes.as_slice() {
            [uv, vu] => uv.sum(vu)?,
            other => other[0].clone(),
        };
        let way = |(last, shape): (&Direction, &Surface<T, N>)| {
            let map = |direction: Direction| {
                let (from, to) = (shape.space(direction), common.space(direction));
                (from != to).then(|| from.embedding(to)).transpose()
            };
            let table =
                PathTable::new(surface, [scales.0, scales.1], *last, [shape.u(), shape.v()], is_held(*last))?;
            let lines = |s: Surface<T, N>| if *last == V { s } else { s.transposed() };
            let invariant = match is_held(*last) {
                true => lines(surface.invariant(shape)?).into_coeffs(),
                false => Vec::new(),
            };
            Ok(Way { table, invariant, finish: [map(last.other())?, map(*last)?] })
        };
        Ok(Self {
            ways: lasts.iter().zip(&shapes).map(way).collect::<Result<_>>()?,
            u: common.u().clone(),
            v: common.v().clone(),
            scales: (scales.0.clone(), scales.1.clone()),
            held: None,
            nearest: None,
            signed: false,
        })
    }

    /// The same without asking for positive scale functions, as [`Scale::Signed`](crate::Scale::Signed).
    pub fn signed(self) -> Self {
        Self { signed: true, ..self }
    }

    /// The space in `u` of the tuned surfaces.
    pub fn u(&self) -> &SplineSpace<T> {
        &self.u
    }

    /// The space in `v` of the tuned surfaces.
    pub fn v(&self) -> &SplineSpace<T> {
        &self.v
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
        let mut points = vec![SVector::zeros(); self.u.dim() * self.v.dim()];
        self.tune_into(alpha, &mut points)?;
        Surface::new(self.u.clone(), self.v.clone(), points)
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
        let places = self.u.dim() * self.v.dim();
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
        let mut paths = Vec::with_capacity(self.ways.len());
        for way in &self.ways {
            let (mut lines, last) = (way.table.lines(alpha), way.table.last);
            if let Some(held) = &self.held {
                (held.hold)(&mut lines, &way.invariant, way.table.length, held.edges.orders(last))
                    .map_err(|(line, error)| in_line(error, last, line))?;
            }
            paths.push(way.finished(lines));
        }
        let mut paths = paths.into_iter();
        let mut mean = paths.next().unwrap_or_default();
        if let Some(other) = paths.next() {
            let half = T::frac(1, 2);
            for (point, other) in mean.iter_mut().zip(&other) {
                *point += other;
                point.scale(&half);
            }
        }
        if let Some(held) = &self.held {
            restore_edges(&mut mean, &held.invariant, [self.u.dim(), self.v.dim()], held.edges)?;
        }
        points.clone_from_slice(&mean);
        Ok(())
    }
}

impl<T: Scalar, const N: usize> Way<T, N> {
    /// The control points of this path row by row, among those of the mean.
    fn finished(&self, mut lines: Vec<SVector<T, N>>) -> Vec<SVector<T, N>> {
        let [across, along] = &self.finish;
        let mut length = self.table.length;
        if let Some(map) = along {
            lines = mapped(&lines, length, map);
            length = map.target_dim();
        }
        match (across, self.table.last) {
            (None, V) => lines,
            (None, U) => transposed(&lines, length),
            (Some(map), last) => {
                let turned = transposed(&lines, length);
                let turned = mapped(&turned, turned.len() / length, map);
                if last == U { turned } else { transposed(&turned, map.target_dim()) }
            }
        }
    }
}

/// The image of each line of some length.
fn mapped<T: Scalar, const N: usize>(
    lines: &[SVector<T, N>],
    length: usize,
    map: &LinearMap<T>,
) -> Vec<SVector<T, N>> {
    let image = |line| map.rows().map(move |(first, weights)| weigh(first, weights, line));
    lines.chunks_exact(length).flat_map(image).collect()
}
