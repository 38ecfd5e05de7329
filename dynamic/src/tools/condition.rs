//! Conditions on fine-tuned curves and surfaces, and the nearest scale functions that meet them.

use crate::any::Any;
use crate::error::{Error, Result};
use crate::family::{AnySpline, AnySurface};
use crate::number::{Field, Number};
use crate::over::{AnySpace, Coords, Over};
use crate::tools::tune::vector;
use symspline::{
    Condition, Curve, Direction, Edge, NearestScale, Norm, Path, Q, SpacePair, SplineSpace, Surface,
    SurfaceCondition,
};

/// What a fine-tuned curve must do; see [`Condition`].
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "as in Condition")]
pub enum AnyCondition {
    End,
    Point { parameter: Number, point: Coords },
    Chord { from: Number, to: Number, chord: Coords },
    Derivatives { parameter: Number, count: usize },
    Scale { parameter: Number, value: Number },
    Coefficient { index: usize, value: Number },
    Area,
}

impl AnyCondition {
    pub(crate) fn of<T: Field, const N: usize>(&self) -> Result<Condition<T, N>> {
        Ok(match self {
            Self::End => Condition::End,
            Self::Area => Condition::Area,
            Self::Point { parameter, point } => {
                Condition::Point { parameter: T::of(parameter)?, point: vector(point)? }
            }
            Self::Chord { from, to, chord } => {
                Condition::Chord { from: T::of(from)?, to: T::of(to)?, chord: vector(chord)? }
            }
            Self::Derivatives { parameter, count } => {
                Condition::Derivatives { parameter: T::of(parameter)?, count: *count }
            }
            Self::Scale { parameter, value } => {
                Condition::Scale { parameter: T::of(parameter)?, value: T::of(value)? }
            }
            Self::Coefficient { index, value } => {
                Condition::Coefficient { index: *index, value: T::of(value)? }
            }
        })
    }
}

/// What a fine-tuned surface must do; see [`SurfaceCondition`].
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "as in SurfaceCondition")]
pub enum AnySurfaceCondition {
    Edge { edge: Edge, order: usize },
    Closed { direction: Direction },
    Derivative { at: (Number, Number), order: (usize, usize), value: Coords },
    Scale { at: (Number, Number), value: Number },
    Coefficient { index: (usize, usize), value: Number },
}

fn pair<T: Field>(at: &(Number, Number)) -> Result<(T, T)> {
    Ok((T::of(&at.0)?, T::of(&at.1)?))
}

impl AnySurfaceCondition {
    pub(crate) fn of<T: Field, const N: usize>(&self) -> Result<SurfaceCondition<T, N>> {
        Ok(match self {
            Self::Edge { edge, order } => SurfaceCondition::Edge { edge: *edge, order: *order },
            Self::Closed { direction } => SurfaceCondition::Closed { direction: *direction },
            Self::Derivative { at, order, value } => {
                SurfaceCondition::Derivative { at: pair(at)?, order: *order, value: vector(value)? }
            }
            Self::Scale { at, value } => SurfaceCondition::Scale { at: pair(at)?, value: T::of(value)? },
            Self::Coefficient { index, value } => {
                SurfaceCondition::Coefficient { index: *index, value: T::of(value)? }
            }
        })
    }
}

/// Conditions prepared for scale functions of one parameter; see [`NearestScale`].
pub type AnyNearest = Over<NearestScale<f64>, NearestScale<Q>>;

/// Conditions prepared for scale functions of two parameters.
pub type AnySurfaceNearest = Over<NearestScale<f64, SpacePair<f64>>, NearestScale<Q, SpacePair<Q>>>;

pub(crate) fn mismatch<F: crate::Family, A, B>(shape: &Any<F>, scale: &Over<A, B>) -> Error {
    match shape.is_exact() == scale.is_exact() {
        true => Error::Dimension { found: 1, least: 2 },
        false => Error::Fields { left: shape.field(), right: scale.field() },
    }
}

impl AnyNearest {
    /// The conditions on fine-tuned versions of a curve.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`NearestScale::prepare`].
    pub fn prepare(
        curve: &AnySpline,
        scales: &AnySpace,
        conditions: &[AnyCondition],
        norm: Norm,
    ) -> Result<Self> {
        fn of<T: Field, const N: usize>(
            curve: &Curve<T, N>,
            scales: &SplineSpace<T>,
            conditions: &[AnyCondition],
            norm: Norm,
        ) -> Result<NearestScale<T>> {
            let conditions = conditions.iter().map(AnyCondition::of).collect::<Result<Vec<_>>>()?;
            Ok(NearestScale::prepare(curve, scales, &conditions, norm)?)
        }
        match (curve, scales) {
            (Any::F2(c), Over::Float(s)) => Ok(Self::Float(of(c, s, conditions, norm)?)),
            (Any::F3(c), Over::Float(s)) => Ok(Self::Float(of(c, s, conditions, norm)?)),
            (Any::Q2(c), Over::Exact(s)) => Ok(Self::Exact(of(c, s, conditions, norm)?)),
            (Any::Q3(c), Over::Exact(s)) => Ok(Self::Exact(of(c, s, conditions, norm)?)),
            (c, s) => Err(mismatch(c, s)),
        }
    }

    /// The nearest scale function that meets the conditions; see [`NearestScale::to`].
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimensions`], and those of the library.
    pub fn to(&self, wanted: &AnySpline, signed: bool) -> Result<AnySpline> {
        match (self, wanted) {
            (Self::Float(n), Any::F1(a)) => Ok(if signed { n.to_signed(a)? } else { n.to(a)? }.into()),
            (Self::Exact(n), Any::Q1(a)) => Ok(if signed { n.to_signed(a)? } else { n.to(a)? }.into()),
            (n, a) if n.is_exact() == a.is_exact() => Err(Error::Dimensions { left: 1, right: a.dim() }),
            (n, a) => Err(Error::Fields { left: n.field(), right: a.field() }),
        }
    }
}

impl AnySurfaceNearest {
    /// The conditions on fine-tuned versions of a surface.
    ///
    /// # Errors
    /// [`Error::Fields`], and those of [`NearestScale::on_surface`].
    pub fn prepare(
        surface: &AnySurface,
        scales: &[AnySpace; 2],
        path: Path,
        conditions: &[AnySurfaceCondition],
        norm: Norm,
    ) -> Result<Self> {
        fn of<T: Field, const N: usize>(
            surface: &Surface<T, N>,
            (u, v): &SpacePair<T>,
            path: Path,
            conditions: &[AnySurfaceCondition],
            norm: Norm,
        ) -> Result<NearestScale<T, SpacePair<T>>> {
            let conditions = conditions.iter().map(AnySurfaceCondition::of).collect::<Result<Vec<_>>>()?;
            Ok(NearestScale::on_surface(surface, (u, v), path, &conditions, norm)?)
        }
        match (surface, &paired(scales)?) {
            (Any::F2(s), Over::Float(p)) => Ok(Self::Float(of(s, p, path, conditions, norm)?)),
            (Any::F3(s), Over::Float(p)) => Ok(Self::Float(of(s, p, path, conditions, norm)?)),
            (Any::Q2(s), Over::Exact(p)) => Ok(Self::Exact(of(s, p, path, conditions, norm)?)),
            (Any::Q3(s), Over::Exact(p)) => Ok(Self::Exact(of(s, p, path, conditions, norm)?)),
            (s, p) => Err(mismatch(s, p)),
        }
    }

    /// The nearest scale function that meets the conditions; see [`NearestScale::to`].
    ///
    /// # Errors
    /// [`Error::Fields`], [`Error::Dimensions`], and those of the library.
    pub fn to(&self, wanted: &AnySurface, signed: bool) -> Result<AnySurface> {
        match (self, wanted) {
            (Self::Float(n), Any::F1(a)) => Ok(if signed { n.to_signed(a)? } else { n.to(a)? }.into()),
            (Self::Exact(n), Any::Q1(a)) => Ok(if signed { n.to_signed(a)? } else { n.to(a)? }.into()),
            (n, a) if n.is_exact() == a.is_exact() => Err(Error::Dimensions { left: 1, right: a.dim() }),
            (n, a) => Err(Error::Fields { left: n.field(), right: a.field() }),
        }
    }
}

/// Two spaces over one field.
pub(crate) fn paired([u, v]: &[AnySpace; 2]) -> Result<Over<SpacePair<f64>, SpacePair<Q>>> {
    match (u, v) {
        (Over::Float(u), Over::Float(v)) => Ok(Over::Float((u.clone(), v.clone()))),
        (Over::Exact(u), Over::Exact(v)) => Ok(Over::Exact((u.clone(), v.clone()))),
        (u, v) => Err(Error::Fields { left: u.field(), right: v.field() }),
    }
}
