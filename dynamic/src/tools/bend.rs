//! Bends about lines, circles and the like.

use crate::Any;
use crate::error::{Error, Result};
use crate::family::{AnySpline, AnySurface};
use crate::number::{Field, Number, flat};
use crate::over::Coords;
use crate::shape;
use crate::tools::aside::Aside;
use crate::tools::shape::{Shape, all_points, coords, point};
use crate::tools::warp::Refine;
use crate::value::Value;
use nalgebra::SVector;
use std::fmt;
use symspline::{
    Axis, Bend, BendCentre, Bendable, ByShare, Coeff, Controlled, CrossRatio, Direction, Flat, NurbsSurface,
    OffsetAxis, Q, Rotation, Round, Sphere, Surface,
};

/// From a centre and a point to the share of the way, if there is one; see [`ByShare`].
pub type Share<'a> = dyn Fn(&Coords, &Coords) -> Result<Option<Number>> + Sync + 'a;

/// What a shape is bent about; see [`Bendable`].
pub enum About<'a> {
    /// A circle, sphere or cylinder about the centre.
    Round(Number),
    /// A circle or sphere elsewhere.
    Sphere(Coords, Number),
    /// A line in the plane or a plane in space: a point and the normal.
    Flat(Coords, Coords),
    /// A plane curve, or a surface over floats.
    Shape(Value),
    /// Any function.
    Share(&'a Share<'a>),
}

impl fmt::Debug for About<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Round(radius) => f.debug_tuple("Round").field(radius).finish(),
            Self::Sphere(centre, radius) => f.debug_tuple("Sphere").field(centre).field(radius).finish(),
            Self::Flat(origin, normal) => f.debug_tuple("Flat").field(origin).field(normal).finish(),
            Self::Shape(shape) => f.debug_tuple("Shape").field(shape).finish(),
            Self::Share(_) => f.write_str("Share"),
        }
    }
}

/// The centre of a bend: a point, a straight axis, or one at a distance from an isocurve.
#[derive(Clone, Debug)]
pub enum Centre {
    /// A point.
    Point(Coords),
    /// A point of an axis and its direction.
    Axis(Coords, Coords),
    /// The offset of an isocurve, over floats.
    Offset(AnyOffsetAxis),
}

/// The axis at a distance from an isocurve, over floats; see [`OffsetAxis`].
#[derive(Clone, Debug)]
pub enum AnyOffsetAxis {
    /// Of a polynomial surface.
    Surface(OffsetAxis<Surface<f64, 3>>),
    /// Of a rational one.
    Rational(OffsetAxis<NurbsSurface<f64, 3>>),
}

/// One text for both.
macro_rules! axis {
    ($axis:expr, $a:ident => $body:expr) => {
        match $axis {
            AnyOffsetAxis::Surface($a) => $body,
            AnyOffsetAxis::Rational($a) => $body,
        }
    };
}

impl AnyOffsetAxis {
    /// The axis of a surface in space over floats.
    ///
    /// # Errors
    /// [`Error::NoSuch`] for other shapes, and those of [`OffsetAxis::new`].
    pub fn new(surface: &Value, direction: Direction, at: f64, offset: f64) -> Result<Self> {
        match surface {
            Value::Surface(Any::F3(s)) => Ok(Self::Surface(OffsetAxis::new(s, direction, at, offset)?)),
            Value::RationalSurface(Any::F3(s)) => {
                Ok(Self::Rational(OffsetAxis::new(s, direction, at, offset)?))
            }
            other => Err(other.none_of("axis at a distance, in space over floats,")),
        }
    }

    /// A point of the axis.
    ///
    /// # Errors
    /// Those of [`OffsetAxis::point`].
    pub fn point(&self, w: f64) -> Result<Coords> {
        Ok(coords::<f64, _>(&axis!(self, a => a.point(w))?))
    }

    /// The point of the axis that is nearest to a point.
    ///
    /// # Errors
    /// [`Error::Dimensions`], and those of [`BendCentre::centre_of`].
    pub fn centre_of(&self, of: &Coords) -> Result<Coords> {
        Ok(coords::<f64, _>(&axis!(self, a => a.centre_of(&point(of)?))?))
    }
}

/// Something to bend about, whatever it is.
struct BentAbout<'a, T, const N: usize>(Box<dyn Bendable<T, N> + 'a>);

impl<T: Field, const N: usize> Bendable<T, N> for BentAbout<'_, T, N> {
    fn share(&self, centre: &SVector<T, N>, point: &SVector<T, N>) -> symspline::Result<Option<T>> {
        self.0.share(centre, point)
    }
}

/// A centre, whatever it is.
struct AnyCentre<T, const N: usize>(Box<dyn BendCentre<T, N>>);

impl<T: Field, const N: usize> BendCentre<T, N> for AnyCentre<T, N> {
    fn centre_of(&self, point: &SVector<T, N>) -> symspline::Result<SVector<T, N>> {
        self.0.centre_of(point)
    }
}

/// Points that can be bent about some shapes, and towards some axes.
trait Bent<T: Field, const N: usize> {
    /// The shape as something to bend about.
    fn about(shape: &Value) -> Result<Box<dyn Bendable<T, N>>> {
        Err(shape.none_of("bend about"))
    }

    /// The axis as a centre.
    fn offset(axis: &AnyOffsetAxis) -> Result<Box<dyn BendCentre<T, N>>> {
        let _ = axis;
        Err(Error::NoSuch {
            operation: "bend towards the axis of a surface over floats",
            left: format!("{} shapes of {N} dimensions", T::NAME),
            right: String::new(),
        })
    }
}

macro_rules! about {
    ($T:ty, $n:literal, $curve:ident $rational:ident, $variant:ident; $($offset:tt)*) => {
        impl Bent<$T, $n> for SVector<$T, $n> {
            fn about(shape: &Value) -> Result<Box<dyn Bendable<$T, $n>>> {
                match shape {
                    Value::$curve(Any::$variant(s)) => Ok(Box::new(s.clone())),
                    Value::$rational(Any::$variant(s)) => Ok(Box::new(s.clone())),
                    other => Err(other.none_of("bend about")),
                }
            }

            $($offset)*
        }
    };
}

about!(f64, 2, Spline Rational, F2;);
about!(Q, 2, Spline Rational, Q2;);
about! { f64, 3, Surface RationalSurface, F3;
fn offset(axis: &AnyOffsetAxis) -> Result<Box<dyn BendCentre<f64, 3>>> {
    Ok(axis!(axis, a => Box::new(a.clone())))
} }
impl Bent<Q, 3> for SVector<Q, 3> {}

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
#[derive(Debug)]
pub struct AnyBend<'a> {
    /// Towards what.
    pub centre: Centre,
    /// About what.
    pub about: About<'a>,
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
/// Those of a function given to bend about; [`Error::NoSuch`] for functions, and for what this kind of shape cannot be bent about;
/// those of [`Bend::apply`].
pub fn bent(shape: &Value, how: &AnyBend<'_>) -> Result<Value> {
    fn of<T: InField, S, const N: usize>(shape: &S, how: &AnyBend<'_>) -> Result<Value>
    where
        SVector<T, N>: crate::number::Flat<T> + Bent<T, N>,
        S: Shape<T> + Controlled<T, Point = SVector<T, N>>,
    {
        let centre: Box<dyn BendCentre<T, N>> = match &how.centre {
            Centre::Point(centre) => Box::new(point::<T, SVector<T, N>>(centre)?),
            Centre::Axis(origin, axis) => Box::new(Axis::<T, N>::new(point(origin)?, point(axis)?)?),
            Centre::Offset(axis) => SVector::<T, N>::offset(axis)?,
        };
        let aside = Aside::default();
        let about: Box<dyn Bendable<T, N> + '_> = match &how.about {
            About::Round(radius) => Box::new(Round(T::of(radius)?)),
            About::Sphere(centre, radius) => {
                Box::new(Sphere { centre: point::<T, SVector<T, N>>(centre)?, radius: T::of(radius)? })
            }
            About::Flat(origin, normal) => {
                Box::new(Flat { origin: point::<T, SVector<T, N>>(origin)?, normal: point(normal)? })
            }
            About::Shape(shape) => SVector::<T, N>::about(shape)?,
            About::Share(share) => Box::new(ByShare(|centre: &SVector<T, N>, point: &SVector<T, N>| {
                let found = share(&coords::<T, _>(centre), &coords::<T, _>(point));
                aside.told(found.and_then(|s| s.map(|s| T::of(&s)).transpose()))
            })),
        };
        let (centre, about) = (AnyCentre(centre), BentAbout(about));
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
        aside.out(bend.apply(shape)).map(Shape::value)
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
