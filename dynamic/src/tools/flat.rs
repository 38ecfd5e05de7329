//! Parts of shapes made straight or flat.

use crate::error::{Error, Result};
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::shape;
use crate::tools::shape::{Shape, all_points, place, point};
use crate::tools::warp::Refine;
use crate::value::Value;
use nalgebra::SVector;
use symspline::{Controlled, Flatten, Onto, Part, Side};

/// What control points are projected onto; see [`Onto`].
#[derive(Clone, Debug, PartialEq)]
pub struct AnyOnto {
    /// A point of it.
    pub origin: Coords,
    /// The direction of a line.
    pub line: Option<Coords>,
    /// The normal of a plane; of a line in space the normal of the planes in which points go.
    pub normal: Option<Coords>,
    /// The direction in which points go; at a right angle otherwise.
    pub along: Option<Coords>,
}

/// Points with something to be projected onto.
trait Projected<T: Field, const N: usize> {
    fn onto(onto: &AnyOnto) -> Result<Onto<T, N>>;
}

fn no_onto() -> Error {
    Error::NoSuch {
        operation: "projection",
        left: String::from("a line in the plane, a plane or a line in space"),
        right: String::from("what was given"),
    }
}

impl<T: Field> Projected<T, 2> for SVector<T, 2> {
    fn onto(onto: &AnyOnto) -> Result<Onto<T, 2>> {
        let origin = point(&onto.origin)?;
        match (&onto.line, &onto.normal, &onto.along) {
            (Some(line), None, None) => Ok(Onto::<T, 2>::line(origin, point(line)?)?),
            (Some(line), None, Some(along)) => {
                Ok(Onto::<T, 2>::line_along(origin, point(line)?, point(along)?)?)
            }
            _ => Err(no_onto()),
        }
    }
}

impl<T: Field> Projected<T, 3> for SVector<T, 3> {
    fn onto(onto: &AnyOnto) -> Result<Onto<T, 3>> {
        let origin = point(&onto.origin)?;
        match (&onto.line, &onto.normal, &onto.along) {
            (None, Some(normal), None) => Ok(Onto::<T, 3>::plane(origin, point(normal)?)?),
            (None, Some(normal), Some(along)) => {
                Ok(Onto::<T, 3>::plane_along(origin, point(normal)?, point(along)?)?)
            }
            (Some(line), None, None) => Ok(Onto::<T, 3>::space_line(origin, point(line)?)?),
            (Some(line), Some(normal), None) => {
                Ok(Onto::<T, 3>::space_line_within(origin, point(line)?, point(normal)?)?)
            }
            _ => Err(no_onto()),
        }
    }
}

/// A part of the parameters; see [`Part`].
#[derive(Clone, Debug, PartialEq)]
pub enum AnyPart {
    /// An interval: start and end. Of a surface a rectangle: corner and corner.
    Between(Coords, Coords),
    /// A closed polygon, corner by corner.
    Polygon(Coords),
    /// A disc.
    Disc(Coords, Number),
}

impl AnyPart {
    fn of<T: Field>(&self) -> Result<Part<T>> {
        Ok(match self {
            Self::Between(from, to) if from.len() == 1 => Part::Interval(place(from)?, place(to)?),
            Self::Between(from, to) => {
                let ((u, v), (s, t)): ((T, T), (T, T)) = (place(from)?, place(to)?);
                Part::Rectangle((u, s), (v, t))
            }
            Self::Polygon(corners) => {
                let corners: Vec<SVector<T, 2>> = all_points(corners)?;
                Part::Polygon(corners.into_iter().map(|c| [c[0].clone(), c[1].clone()]).collect())
            }
            Self::Disc(centre, radius) => {
                let (u, v): (T, T) = place(centre)?;
                Part::Disc { centre: [u, v], radius: T::of(radius)? }
            }
        })
    }
}

/// How a shape is flattened; see [`Flatten`].
#[derive(Clone, Debug, PartialEq)]
pub struct AnyFlatten {
    /// Onto what.
    pub onto: AnyOnto,
    /// Control points without influence outside this part.
    pub local: Option<AnyPart>,
    /// Control points with influence inside this part.
    pub whole: Option<AnyPart>,
    /// On one side alone.
    pub side: Option<Side>,
    /// In front of planes alone: points and normals.
    pub in_front_of: Vec<(Coords, Coords)>,
    /// Accepted between the ends of segments.
    pub segments: Vec<(Coords, Coords)>,
    /// Accepted inside polygons.
    pub polygons: Vec<Coords>,
    /// Accepted within balls.
    pub balls: Vec<(Coords, Number)>,
    /// Knots to insert first.
    pub refine: Option<Refine>,
    /// With more knots until it is flat, at most so many control points.
    pub until_flat: Option<usize>,
}

/// What flattening made; see [`Flattened`](symspline::Flattened).
#[derive(Clone, Debug, PartialEq)]
pub struct FlatShape {
    /// The shape.
    pub shape: Value,
    /// The control points that were projected.
    pub projected: Vec<usize>,
    /// The flat parts, direction by direction from where to where.
    pub flat: Vec<Vec<(Number, Number)>>,
    /// Outside of this nothing changed.
    pub changed: Option<Vec<(Number, Number)>>,
}

/// A flattened shape.
///
/// # Errors
/// [`Error::NoSuch`] for functions, and those of [`Flatten::apply`].
pub fn flattened(shape: &Value, how: &AnyFlatten) -> Result<FlatShape> {
    fn of<T: Field, S, const N: usize>(shape: &S, how: &AnyFlatten) -> Result<FlatShape>
    where
        SVector<T, N>: Projected<T, N>,
        S: Shape<T> + Controlled<T, Point = SVector<T, N>>,
    {
        let mut flatten = Flatten::new(<SVector<T, N>>::onto(&how.onto)?);
        if let Some(part) = &how.local {
            flatten = flatten.local_to(part.of::<T>()?);
        }
        if let Some(part) = &how.whole {
            flatten = flatten.whole(part.of::<T>()?);
        }
        if let Some(side) = how.side {
            flatten = flatten.on_side(side);
        }
        for (origin, normal) in &how.in_front_of {
            flatten = flatten.in_front_of(point(origin)?, point(normal)?);
        }
        for (a, b) in &how.segments {
            flatten = flatten.within_segment(point(a)?, point(b)?);
        }
        for corners in &how.polygons {
            flatten = flatten.within_polygon(all_points(corners)?);
        }
        for (centre, radius) in &how.balls {
            flatten = flatten.within_ball(point(centre)?, T::of(radius)?);
        }
        if let Some(refine) = &how.refine {
            flatten = flatten.refined(refine.of()?);
        }
        if let Some(most) = how.until_flat {
            flatten = flatten.until_flat(most);
        }
        let found = flatten.apply(shape)?;
        let numbers = |part: Vec<(T, T)>| part.into_iter().map(|(a, b)| (a.number(), b.number())).collect();
        Ok(FlatShape {
            shape: found.shape.value(),
            projected: found.projected,
            flat: found.flat.into_iter().map(numbers).collect(),
            changed: found.changed.map(numbers),
        })
    }
    shape!(in space shape, "flattening", T, s => { let _: Option<T>; of(s, how) })
}
