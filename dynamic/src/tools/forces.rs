//! Forces on shapes: single ones, and such as are spread over shapes, along curves and over areas.

use crate::error::{Error, Result};
use crate::number::{Field, Flat};
use crate::over::Coords;
use crate::tools::area::{AnyArea, AnyCells, Bounded};
use crate::tools::shape::{Shape, all_points, place, point};
use crate::value::Value;
use nalgebra::SVector;
use std::borrow::Cow;
use symspline::{
    Controlled, Curve, Elastic, Forces, Interval, Q, Rational, Rectangle, Spline, SplineSpace, TensorSpline,
};

/// A force along a curve of the parameter plane; see [`Forces::along`].
#[derive(Clone, Debug, PartialEq)]
pub struct Along {
    /// The curve.
    pub path: Value,
    /// A number or vector, or a spline over the domain of the curve.
    pub force: Value,
    /// At how many places; the integral itself if there is no number, over floats.
    pub samples: Option<usize>,
}

/// A force, or a pressure, over an area of the parameter plane; see [`Forces::over`] and [`Forces::pressure`].
#[derive(Clone, Debug, PartialEq)]
pub struct Covering {
    /// The area.
    pub area: AnyArea,
    /// A number or vector, or a polynomial surface over the area.
    pub force: Value,
    /// How finely.
    pub cells: AnyCells,
}

/// Forces that act together; see [`Forces`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Load {
    /// Forces at places.
    pub single: Vec<(Coords, Coords)>,
    /// Forces at all breaks.
    pub at_breaks: Option<Coords>,
    /// A force that varies over the shape.
    pub density: Option<Value>,
    /// Forces along curves.
    pub along: Vec<Along>,
    /// Forces over areas.
    pub over: Vec<Covering>,
    /// Pressures over areas.
    pub pressure: Vec<Covering>,
}

impl Load {
    /// The same with its splines over the rationals, without loss.
    ///
    /// # Errors
    /// As [`Value::to_exact`].
    pub fn to_exact(&self) -> Result<Self> {
        self.with(&Value::to_exact)
    }

    /// The same with its splines over floats.
    ///
    /// # Errors
    /// As [`Value::to_float`].
    pub fn to_float(&self) -> Result<Self> {
        self.with(&Value::to_float)
    }

    fn with(&self, change: &impl Fn(&Value) -> Result<Value>) -> Result<Self> {
        let covering = |all: &[Covering]| {
            let one = |one: &Covering| {
                let (area, force) = (one.area.with(change)?, change(&one.force)?);
                Ok(Covering { area, force, cells: one.cells.clone() })
            };
            all.iter().map(one).collect::<Result<Vec<_>>>()
        };
        let along = |one: &Along| {
            let (path, force) = (change(&one.path)?, change(&one.force)?);
            Ok(Along { path, force, samples: one.samples })
        };
        Ok(Self {
            single: self.single.clone(),
            at_breaks: self.at_breaks.clone(),
            density: self.density.as_ref().map(change).transpose()?,
            along: self.along.iter().map(along).collect::<Result<_>>()?,
            over: covering(&self.over)?,
            pressure: covering(&self.pressure)?,
        })
    }

    /// These forces on a shape.
    pub(crate) fn of<'a, T: Field, S: Loaded<T>>(
        &self,
        elastic: &'a Elastic<T>,
        shape: &S,
    ) -> Result<Forces<'a, T, S>> {
        let mut forces = Forces::new(elastic, shape)?;
        for (at, force) in &self.single {
            forces.at(&place(at)?, point(force)?)?;
        }
        if let Some(all) = &self.at_breaks {
            forces.at_breaks(&all_points(all)?)?;
        }
        if let Some(density) = &self.density {
            S::add_density(&mut forces, density)?;
        }
        self.along.iter().try_for_each(|along| S::add_along(&mut forces, along))?;
        self.over.iter().try_for_each(|over| S::add_over(&mut forces, over))?;
        self.pressure.iter().try_for_each(|pressure| shape.add_pressure(&mut forces, pressure))?;
        Ok(forces)
    }
}

fn no(operation: &'static str, of: &str) -> Error {
    Error::NoSuch { operation, left: of.to_owned(), right: String::new() }
}

/// A shape on which forces are spread, each kind where the library has it.
pub trait Loaded<T: Field>: Shape<T> {
    /// A curve through points like those of this shape.
    ///
    /// # Errors
    /// [`Error::NoSuch`].
    fn target(value: &Value) -> Result<&Spline<T, Self::Point>>;

    /// Adds a force that varies over the shape; see [`Forces::density`].
    ///
    /// # Errors
    /// [`Error::NoSuch`] for rational shapes, and those of the library.
    fn add_density(forces: &mut Forces<'_, T, Self>, density: &Value) -> Result<()> {
        let _ = (forces, density);
        Err(no("density", "a force on a rational shape"))
    }

    /// Adds a force along a curve of the parameter plane; see [`Forces::along`].
    ///
    /// # Errors
    /// [`Error::NoSuch`] for curves, and those of the library.
    fn add_along(forces: &mut Forces<'_, T, Self>, along: &Along) -> Result<()> {
        let _ = (forces, along);
        Err(no("path for a force", "a curve"))
    }

    /// Adds a force over an area of the parameter plane; see [`Forces::over`].
    ///
    /// # Errors
    /// [`Error::NoSuch`] for curves, and those of the library.
    fn add_over(forces: &mut Forces<'_, T, Self>, over: &Covering) -> Result<()> {
        let _ = (forces, over);
        Err(no("area for a force", "a curve"))
    }

    /// Adds a pressure on this shape over an area of the parameter plane; see [`Forces::pressure`].
    ///
    /// # Errors
    /// [`Error::NoSuch`] for what is no surface in space, and those of the library.
    fn add_pressure(&self, forces: &mut Forces<'_, T, Self>, pressure: &Covering) -> Result<()> {
        let _ = (forces, pressure);
        Err(no("pressure", "what is no surface in space"))
    }
}

/// What of forces on surfaces depends on the field.
pub(crate) trait Planar: Bounded {
    /// A curve in the plane.
    fn path(value: &Value) -> Result<&Curve<Self, 2>>;

    /// A function of two parameters.
    fn function(value: &Value) -> Result<&TensorSpline<Self, Self>>;

    /// Adds the integral of a force along a path.
    fn add_exactly<S: Controlled<Self, Parameter = (Self, Self)>>(
        forces: &mut Forces<'_, Self, S>,
        path: &Curve<Self, 2>,
        force: &Spline<Self, S::Point>,
    ) -> Result<()>;
}

impl Planar for f64 {
    fn path(value: &Value) -> Result<&Curve<Self, 2>> {
        Shape::inside(value).map_err(|_| value.none_of("path in the parameter plane"))
    }

    fn function(value: &Value) -> Result<&TensorSpline<Self, Self>> {
        Shape::inside(value).map_err(|_| value.none_of("pressure over an area"))
    }

    fn add_exactly<S: Controlled<Self, Parameter = (Self, Self)>>(
        forces: &mut Forces<'_, Self, S>,
        path: &Curve<Self, 2>,
        force: &Spline<Self, S::Point>,
    ) -> Result<()> {
        forces.along_exactly(path, force)?;
        Ok(())
    }
}

impl Planar for Q {
    fn path(value: &Value) -> Result<&Curve<Self, 2>> {
        Shape::inside(value).map_err(|_| value.none_of("path in the parameter plane"))
    }

    fn function(value: &Value) -> Result<&TensorSpline<Self, Self>> {
        Shape::inside(value).map_err(|_| value.none_of("pressure over an area"))
    }

    fn add_exactly<S: Controlled<Self, Parameter = (Self, Self)>>(
        _: &mut Forces<'_, Self, S>,
        _: &Curve<Self, 2>,
        _: &Spline<Self, S::Point>,
    ) -> Result<()> {
        Err(no("integral", "an exact force along a path, which takes a number of samples"))
    }
}

/// A number or a vector that a value is.
fn constant<T: Field, C: Flat<T>>(force: &Value) -> Result<Option<C>> {
    match force {
        Value::Number(x) => C::from_coords(&[T::of(x)?]).map(Some),
        Value::Point(p) => point(p).map(Some),
        _ => Ok(None),
    }
}

fn along<T: Planar, S>(forces: &mut Forces<'_, T, S>, along: &Along) -> Result<()>
where
    S: Loaded<T> + Controlled<T, Parameter = (T, T)>,
{
    let path = T::path(&along.path)?;
    let force = match constant::<T, S::Point>(&along.force)? {
        Some(force) => {
            let (a, b) = path.domain();
            Cow::Owned(Spline::constant(SplineSpace::bezier(0, a.clone(), b.clone())?, force)?)
        }
        None => Cow::Borrowed(S::target(&along.force)?),
    };
    match along.samples {
        Some(samples) => {
            forces.along(path, &force, samples)?;
            Ok(())
        }
        None => T::add_exactly(forces, path, &force),
    }
}

fn over<T: Planar, S>(forces: &mut Forces<'_, T, S>, over: &Covering) -> Result<()>
where
    S: Shape<T> + Controlled<T, Parameter = (T, T)>,
    TensorSpline<T, S::Point>: Shape<T>,
{
    let (area, cells) = (over.area.of::<T>()?, over.cells.of()?);
    match constant::<T, S::Point>(&over.force)? {
        Some(force) => forces.over(&area, &cells, |_| Ok(force.clone()))?,
        None => {
            let force = TensorSpline::<T, S::Point>::inside(&over.force);
            let force = force.map_err(|_| over.force.none_of("surface of vectors as the shape has,"))?;
            forces.over(&area, &cells, |(u, v)| force.at(u, v))?
        }
    };
    Ok(())
}

fn pressure<T: Planar, S>(surface: &S, forces: &mut Forces<'_, T, S>, over: &Covering) -> Result<()>
where
    S: Controlled<T, Parameter = (T, T), Order = (usize, usize), Point = SVector<T, 3>>,
{
    let (area, cells) = (over.area.of::<T>()?, over.cells.of()?);
    match constant::<T, T>(&over.force)? {
        Some(pressure) => forces.pressure(surface, &area, &cells, |_| Ok(pressure.clone()))?,
        None => {
            let pressure = T::function(&over.force)?;
            forces.pressure(surface, &area, &cells, |(u, v)| pressure.at(u, v))?
        }
    };
    Ok(())
}

macro_rules! loaded {
    (@density $T:ty) => {
        fn add_density(forces: &mut Forces<'_, $T, Self>, density: &Value) -> Result<()> {
            forces.density(Self::inside(density)?)?;
            Ok(())
        }
    };
    (@surface $T:ty, $($pressure:ident)?) => {
        fn add_along(forces: &mut Forces<'_, $T, Self>, all: &Along) -> Result<()> {
            along(forces, all)
        }

        fn add_over(forces: &mut Forces<'_, $T, Self>, all: &Covering) -> Result<()> {
            over(forces, all)
        }

        $(fn add_pressure(&self, forces: &mut Forces<'_, $T, Self>, all: &Covering) -> Result<()> {
            $pressure(self, forces, all)
        })?
    };
    (@target $T:ty) => {
        fn target(value: &Value) -> Result<&Spline<$T, Self::Point>> {
            Shape::inside(value).map_err(|_| value.none_of("curve of vectors as the shape has,"))
        }
    };
    ($($T:ty, $C:ty $(: $pressure:ident)?;)+) => {$(
        impl Loaded<$T> for Spline<$T, $C> {
            loaded!(@target $T);
            loaded!(@density $T);
        }

        impl Loaded<$T> for Rational<Interval, $T, $C> {
            loaded!(@target $T);
        }

        impl Loaded<$T> for TensorSpline<$T, $C> {
            loaded!(@target $T);
            loaded!(@density $T);
            loaded!(@surface $T, $($pressure)?);
        }

        impl Loaded<$T> for Rational<Rectangle, $T, $C> {
            loaded!(@target $T);
            loaded!(@surface $T, $($pressure)?);
        }
    )+};
}

loaded! { f64, f64; f64, SVector<f64, 2>; f64, SVector<f64, 3>: pressure; Q, Q; Q, SVector<Q, 2>; Q, SVector<Q, 3>: pressure; }
