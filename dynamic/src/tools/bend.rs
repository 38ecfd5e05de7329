//! Bends about lines, circles and the like.

use crate::Any;
use crate::error::{Error, Result};
use crate::family::{AnySpline, AnySurface};
use crate::number::{Field, Number, flat};
use crate::over::Coords;
use crate::shape;
use crate::tools::shape::{Shape, all_points, point};
use crate::tools::warp::Refine;
use crate::value::Value;
use nalgebra::SVector;
use symspline::{
    Axis, Bend, BendCentre, Bendable, Coeff, Controlled, CrossRatio, Direction, Flat, Q, Rotation, Round,
    Sphere,
};

/// What a shape is bent about; see [`Bendable`].
#[derive(Clone, Debug, PartialEq)]
pub enum About {
    /// A circle, sphere or cylinder about the centre.
    Round(Number),
    /// A circle or sphere elsewhere.
    Sphere(Coords, Number),
    /// A line in the plane or a plane in space: a point and the normal.
    Flat(Coords, Coords),
}

/// The centre of a bend: a point, or a straight axis through it.
#[derive(Clone, Debug, PartialEq)]
pub struct Centre {
    /// The point.
    pub point: Coords,
    /// The direction of the axis.
    pub axis: Option<Coords>,
}

enum BentAbout<T, const N: usize> {
    Round(Round<T>),
    Sphere(Sphere<T, N>),
    Flat(Flat<T, N>),
}

impl<T: Field, const N: usize> Bendable<T, N> for BentAbout<T, N> {
    fn share(&self, centre: &SVector<T, N>, point: &SVector<T, N>) -> symspline::Result<Option<T>> {
        match self {
            Self::Round(about) => about.share(centre, point),
            Self::Sphere(about) => about.share(centre, point),
            Self::Flat(about) => about.share(centre, point),
        }
    }
}

enum AnyCentre<T, const N: usize> {
    Point(SVector<T, N>),
    Axis(Axis<T, N>),
}

impl<T: Field, const N: usize> BendCentre<T, N> for AnyCentre<T, N> {
    fn centre_of(&self, point: &SVector<T, N>) -> symspline::Result<SVector<T, N>> {
        match self {
            Self::Point(centre) => centre.centre_of(point),
            Self::Axis(axis) => axis.centre_of(point),
        }
    }
}

/// The cross ratio of a bend; see [`CrossRatio`].
#[derive(Clone, Debug, PartialEq)]
pub enum Ratio {
    /// The same everywhere.
    Constant(Number),
    /// A function of the parameter.
    Along(AnySpline),
    /// A function of both parameters.
    Over(AnySurface),
}

/// What of a ratio is over the field.
trait InField: Field {
    fn ratio(ratio: &Ratio) -> Result<CrossRatio<Self>>;
}

macro_rules! in_field {
    ($field:ty, $variant:ident) => {
        impl InField for $field {
            fn ratio(ratio: &Ratio) -> Result<CrossRatio<Self>> {
                match ratio {
                    Ratio::Constant(x) => Ok(CrossRatio::Constant(Self::of(x)?)),
                    Ratio::Along(Any::$variant(f)) => Ok(CrossRatio::Along(f.clone())),
                    Ratio::Over(Any::$variant(f)) => Ok(CrossRatio::Over(f.clone())),
                    Ratio::Along(f) => Err(Value::from(f.clone()).none_of("bend by the ratio")),
                    Ratio::Over(f) => Err(Value::from(f.clone()).none_of("bend by the ratio")),
                }
            }
        }
    };
}

in_field!(f64, F1);
in_field!(Q, Q1);

/// How a shape is bent; see [`Bend`].
#[derive(Clone, Debug, PartialEq)]
pub struct AnyBend {
    /// Towards what.
    pub centre: Centre,
    /// About what.
    pub about: About,
    /// How far.
    pub ratio: Ratio,
    /// Along which direction of a surface.
    pub direction: Direction,
    /// Between which knots.
    pub interval: Option<(Number, Number)>,
    /// Knots to insert first.
    pub refine: Option<Refine>,
    /// Whether what is outside the interval is carried along.
    pub tails: bool,
}

/// A bent shape.
///
/// # Errors
/// [`Error::NoSuch`] for functions, and those of [`Bend::apply`].
pub fn bent(shape: &Value, how: &AnyBend) -> Result<Value> {
    fn of<T: InField, S, const N: usize>(shape: &S, how: &AnyBend) -> Result<Value>
    where
        SVector<T, N>: crate::number::Flat<T>,
        S: Shape<T> + Controlled<T, Point = SVector<T, N>>,
    {
        let centre = match &how.centre.axis {
            None => AnyCentre::Point(point(&how.centre.point)?),
            Some(axis) => AnyCentre::Axis(Axis::new(point(&how.centre.point)?, point(axis)?)?),
        };
        let about = match &how.about {
            About::Round(radius) => BentAbout::Round(Round(T::of(radius)?)),
            About::Sphere(centre, radius) => {
                BentAbout::Sphere(Sphere { centre: point(centre)?, radius: T::of(radius)? })
            }
            About::Flat(origin, normal) => {
                BentAbout::Flat(Flat { origin: point(origin)?, normal: point(normal)? })
            }
        };
        let mut bend = Bend::new(centre, about, T::ratio(&how.ratio)?).along(how.direction);
        if let Some((a, b)) = &how.interval {
            bend = bend.on(T::of(a)?, T::of(b)?);
        }
        if let Some(refine) = &how.refine {
            bend = bend.refined(refine.of()?);
        }
        if !how.tails {
            bend = bend.without_tails();
        }
        Ok(bend.apply(shape)?.value())
    }
    shape!(in space shape, "bend", T, s => { let _: Option<T>; of(s, how) })
}

/// Points carried along by the rotation that takes the direction from `before` to `pivot` into that from `after` to `place`, about the
/// pivot, and the move from the pivot to the place; see [`Rotation::carried`].
///
/// # Errors
/// [`Error::Dimension`], [`Error::Torn`], and those of [`Rotation::between`].
pub fn carried(points: &Coords, [before, pivot, after, place]: [&Coords; 4]) -> Result<Coords> {
    fn of<T: Field, const N: usize>(points: &Coords, way: [&Coords; 4]) -> Result<Coords>
    where
        SVector<T, N>: crate::number::Flat<T>,
    {
        let all = way.map(point::<T, SVector<T, N>>);
        let [before, pivot, after, place] = all;
        let (before, pivot, after, place) = (before?, pivot?, after?, place?);
        let turn = Rotation::between(&pivot.minus(&before), &place.minus(&after))?;
        let points: Vec<SVector<T, N>> = all_points(points)?;
        Ok(flat::<T, _>(&points.iter().map(|p| turn.carried(p, &pivot, &place)).collect::<Vec<_>>()))
    }
    let way = [before, pivot, after, place];
    match (place.len(), points.is_exact() && way.iter().all(|p| p.is_exact())) {
        (2, true) => of::<Q, 2>(points, way),
        (2, false) => of::<f64, 2>(points, way),
        (3, true) => of::<Q, 3>(points, way),
        (3, false) => of::<f64, 3>(points, way),
        (found, _) => Err(Error::Dimension { found, least: 2 }),
    }
}
