//! Fine tuning of curves and surfaces over either field.

use crate::any::Any;
use crate::each;
use crate::error::{Error, Result};
use crate::family::{AnySpline, AnySurface};
use crate::number::{Field, Number};
use crate::over::{AnySpace, Coords, Over};
use crate::value::Value;
use nalgebra::SVector;
use symspline::{
    Approximation, Curve, Edge, Edges, Held, HeldSurface, Hold, Path, Q, Relaxed, Scale, Springs, Surface,
};

/// One text for a curve or surface and a scale function over the same field.
#[macro_export]
macro_rules! scaled {
    ($shape:expr, $alpha:expr, $T:ident, $s:ident, $a:ident => $body:expr) => {
        match ($shape, $alpha) {
            ($crate::Any::F2($s), $crate::Any::F1($a)) => $crate::each!(@ f64, $T, $body),
            ($crate::Any::F3($s), $crate::Any::F1($a)) => $crate::each!(@ f64, $T, $body),
            ($crate::Any::Q2($s), $crate::Any::Q1($a)) => $crate::each!(@ ::symspline::Q, $T, $body),
            ($crate::Any::Q3($s), $crate::Any::Q1($a)) => $crate::each!(@ ::symspline::Q, $T, $body),
            (s, a) => Err($crate::tools::tune::no_scale(s, a).into()),
        }
    };
    // Without exact ones in space, where ends are held by square roots.
    (held $shape:expr, $alpha:expr, $T:ident, $s:ident, $a:ident => $body:expr) => {
        match ($shape, $alpha) {
            ($crate::Any::F2($s), $crate::Any::F1($a)) => $crate::each!(@ f64, $T, $body),
            ($crate::Any::F3($s), $crate::Any::F1($a)) => $crate::each!(@ f64, $T, $body),
            ($crate::Any::Q2($s), $crate::Any::Q1($a)) => $crate::each!(@ ::symspline::Q, $T, $body),
            (s, a) => Err($crate::tools::tune::no_scale(s, a).into()),
        }
    };
}

/// Why a shape is not scaled by what is given.
#[doc(hidden)]
pub fn no_scale<F: crate::Family>(shape: &Any<F>, alpha: &Any<F>) -> Error {
    if shape.is_exact() != alpha.is_exact() || alpha.dim() != 1 {
        shape.unlike_function(alpha)
    } else if shape.dim() == 1 {
        Error::Dimension { found: 1, least: 2 }
    } else {
        let left = format!("exact {} in space: it takes square roots, so convert it to floats", shape.kind());
        Error::NoSuch { operation: "holding", left, right: String::new() }
    }
}

/// A scale function, positive unless it is said to have any sign.
fn sign<F>(alpha: &F, signed: bool) -> Scale<'_, F> {
    if signed { Scale::Signed(alpha) } else { Scale::Positive(alpha) }
}

/// A curve with its ends put back; see [`Held`].
#[derive(Clone, Debug, PartialEq)]
pub struct HeldCurve {
    /// The curve.
    pub curve: AnySpline,
    /// The freely tuned curve under the same similarity.
    pub image: AnySpline,
    /// The square of the scale of the similarity.
    pub squared_scale: Number,
    /// From where to where the curve is its image.
    pub similar: Option<(Number, Number)>,
}

impl<T: Field, const N: usize> From<Held<T, N>> for HeldCurve
where
    AnySpline: From<Curve<T, N>>,
{
    fn from(held: Held<T, N>) -> Self {
        Self {
            curve: held.curve.into(),
            image: held.image.into(),
            squared_scale: held.squared_scale.number(),
            similar: held.similar.map(|(a, b)| (a.number(), b.number())),
        }
    }
}

impl AnySpline {
    /// The curve that starts where this one does and has its derivative multiplied by `alpha`; see [`Curve::fine_tuned`].
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], and those of the library.
    pub fn fine_tuned(&self, alpha: &Self, signed: bool) -> Result<Self> {
        scaled!(self, alpha, T, c, a => { let _: Option<T>; Ok(c.fine_tuned(sign(a, signed))?.into()) })
    }

    /// The same with the ends held; see [`Curve::fine_tuned_holding`].
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned); [`Error::NoSuch`] for exact curves in space.
    pub fn fine_tuned_holding(&self, alpha: &Self, signed: bool, hold: Hold) -> Result<HeldCurve> {
        scaled!(held self, alpha, T, c, a => { let _: Option<T>; Ok(c.fine_tuned_holding(sign(a, signed), hold)?.into()) })
    }

    /// The curve fine-tuned with its degree kept, and how far that is off at most; see [`Curve::fine_tuned_within`].
    ///
    /// # Errors
    /// As [`fine_tuned_holding`](Self::fine_tuned_holding).
    pub fn fine_tuned_within(
        &self,
        alpha: &Self,
        signed: bool,
        hold: Hold,
        tolerance: &Number,
    ) -> Result<(Self, Number)> {
        scaled!(held self, alpha, T, c, a => {
            let Approximation { spline, bound } = c.fine_tuned_within(sign(a, signed), hold, &T::of(tolerance)?)?;
            Ok((spline.into(), bound.number()))
        })
    }

    /// What each coefficient of a scale function adds to the chord from `x` to `y`; see [`Curve::scale_moments`].
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], and those of the library.
    pub fn scale_moments(&self, scales: &AnySpace, x: &Number, y: &Number) -> Result<Coords> {
        match (self, scales) {
            (Any::F2(c), Over::Float(s)) => moments(c, s, x, y),
            (Any::F3(c), Over::Float(s)) => moments(c, s, x, y),
            (Any::Q2(c), Over::Exact(s)) => moments(c, s, x, y),
            (Any::Q3(c), Over::Exact(s)) => moments(c, s, x, y),
            (c, s) if c.is_exact() == s.is_exact() => Err(Error::Dimension { found: 1, least: 2 }),
            (c, s) => Err(Error::Fields { left: c.field(), right: s.field() }),
        }
    }

    /// A function that is its own with one value changed, by the least change of coefficients; see
    /// [`Spline::dragged`](symspline::Spline::dragged).
    ///
    /// # Errors
    /// [`Error::Dimensions`], and those of the library.
    pub fn dragged_value(&self, x: &Number, to: &Coords, norm: symspline::Norm) -> Result<Self> {
        each!(self, T, s => Ok(s.dragged(&T::of(x)?, crate::tools::shape::point(to)?, norm)?.into()))
    }
}

fn moments<T: Field, const N: usize>(
    curve: &Curve<T, N>,
    scales: &symspline::SplineSpace<T>,
    x: &Number,
    y: &Number,
) -> Result<Coords> {
    Ok(crate::number::flat(&curve.scale_moments(scales, &T::of(x)?, &T::of(y)?)?))
}

/// A closed curve relaxed by springs; see [`Curve::fine_tuned_closed`].
///
/// # Errors
/// [`Error::NoSuch`] for exact curves and functions, and those of the library.
pub fn closed(curve: &AnySpline, alpha: &AnySpline, signed: bool, springs: &Springs) -> Result<Closed> {
    fn of<const N: usize>(r: Relaxed<N>) -> Closed
    where
        AnySpline: From<Curve<f64, N>>,
    {
        Closed {
            curve: r.curve.into(),
            energies: [r.energy_before, r.energy],
            deviations: [r.length_deviation, r.angle_deviation],
            iterations: r.iterations,
            gradient: r.gradient,
            converged: r.converged,
        }
    }
    match (curve, alpha) {
        (Any::F2(c), Any::F1(a)) => Ok(of(c.fine_tuned_closed(sign(a, signed), springs)?)),
        (Any::F3(c), Any::F1(a)) => Ok(of(c.fine_tuned_closed(sign(a, signed), springs)?)),
        (c, _) => Err(Value::from(c.clone()).none_of("closing by springs, which takes square roots,")),
    }
}

/// A closed curve at rest; see [`Relaxed`].
#[derive(Clone, Debug, PartialEq)]
pub struct Closed {
    /// The curve.
    pub curve: AnySpline,
    /// The energy before and after.
    pub energies: [f64; 2],
    /// The largest deviation of a length, relative, and of an angle.
    pub deviations: [f64; 2],
    /// The steps it took.
    pub iterations: usize,
    /// What is left of the gradient.
    pub gradient: f64,
    /// Whether that is within the tolerance.
    pub converged: bool,
}

/// A scale function that multiplies the curvature by about `ratio`, and how far off the ratio may be; see
/// [`SplineSpace::scale_for_curvature_ratio`](symspline::SplineSpace::scale_for_curvature_ratio).
///
/// # Errors
/// [`Error::Fields`], and those of the library.
pub fn scale_for_curvature_ratio(scales: &AnySpace, ratio: &AnySpline) -> Result<(AnySpline, Number)> {
    fn found<T: Field>(f: Approximation<symspline::Function<T>, T>) -> (AnySpline, Number)
    where
        AnySpline: From<symspline::Function<T>>,
    {
        (f.spline.into(), f.bound.number())
    }
    match (scales, ratio) {
        (Over::Float(s), Any::F1(r)) => Ok(found::<f64>(s.scale_for_curvature_ratio(r)?)),
        (Over::Exact(s), Any::Q1(r)) => Ok(found::<Q>(s.scale_for_curvature_ratio(r)?)),
        (s, r) if s.is_exact() == r.is_exact() => Err(Error::Dimensions { left: 1, right: r.dim() }),
        (s, r) => Err(Error::Fields { left: s.field(), right: r.field() }),
    }
}

/// A surface with its edges put back, and how far control points were forced; see [`HeldSurface`].
pub type HeldAnySurface = (AnySurface, Number);

fn held_surface<T: Field, const N: usize>(held: HeldSurface<T, N>) -> HeldAnySurface
where
    AnySurface: From<Surface<T, N>>,
{
    (held.surface.into(), held.forced.number())
}

impl AnySurface {
    /// The surface with its derivatives multiplied by `alpha` along a path; see [`Surface::fine_tuned`].
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimension`], and those of the library.
    pub fn fine_tuned(&self, alpha: &Self, signed: bool, path: Path) -> Result<Self> {
        scaled!(self, alpha, T, s, a => { let _: Option<T>; Ok(s.fine_tuned(sign(a, signed), path)?.into()) })
    }

    /// The surface tuned away from an edge; see [`Surface::fine_tuned_from`].
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned).
    pub fn fine_tuned_from(&self, alpha: &Self, signed: bool, edge: Edge) -> Result<Self> {
        scaled!(self, alpha, T, s, a => { let _: Option<T>; Ok(s.fine_tuned_from(sign(a, signed), edge)?.into()) })
    }

    /// The surface tuned with its edges held; see [`Surface::fine_tuned_holding`].
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned); [`Error::NoSuch`] for exact surfaces in space.
    pub fn fine_tuned_holding(
        &self,
        alpha: &Self,
        signed: bool,
        path: Path,
        edges: Edges,
    ) -> Result<HeldAnySurface> {
        scaled!(held self, alpha, T, s, a => {
            let _: Option<T>;
            Ok(held_surface(s.fine_tuned_holding(sign(a, signed), path, edges)?))
        })
    }

    /// The surface with a rectangle tuned: the rectangle, how far it was forced, and both as one surface; see
    /// [`Surface::fine_tuned_on`].
    ///
    /// # Errors
    /// As [`fine_tuned_holding`](Self::fine_tuned_holding).
    pub fn fine_tuned_on(
        &self,
        alpha: &Self,
        signed: bool,
        path: Path,
        edges: Edges,
    ) -> Result<(HeldAnySurface, Self)> {
        scaled!(held self, alpha, T, s, a => {
            let _: Option<T>;
            let local = s.fine_tuned_on(sign(a, signed), path, edges)?;
            let joined = local.joined()?.into();
            Ok((held_surface(local.tuned().clone()), joined))
        })
    }

    /// The difference of both paths, and a bound of it; see [`Surface::path_gap`].
    ///
    /// # Errors
    /// As [`fine_tuned`](Self::fine_tuned).
    pub fn path_gap(&self, alpha: &Self) -> Result<(Self, Number)> {
        scaled!(self, alpha, T, s, a => {
            let _: Option<T>;
            let gap = s.path_gap(a)?;
            Ok((gap.difference.into(), gap.bound.number()))
        })
    }
}

/// The vector with as many coordinates as there are numbers.
pub(crate) fn vector<T: Field, const N: usize>(numbers: &Coords) -> Result<SVector<T, N>> {
    crate::tools::shape::point(numbers)
}
