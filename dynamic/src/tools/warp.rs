//! Warps: control points of a region moved.

use crate::Any;
use crate::error::{Error, Result};
use crate::number::{Field, Number};
use crate::over::Coords;
use crate::shape;
use crate::tools::aside::Aside;
use crate::tools::shape::{At, Shape, place, point};
use crate::value::Value;
use symspline::{Assigned, Direction, Refinement, Region, Reshaped, Warp};

/// How many knots an interval gets; see [`Refinement`].
#[derive(Clone, Debug, PartialEq)]
pub enum Refine {
    /// So many.
    Count(usize),
    /// As many as it takes that no span is longer.
    Spacing(Number),
}

impl Refine {
    pub(crate) fn of<T: Field>(&self) -> Result<Refinement<T>> {
        Ok(match self {
            Self::Count(count) => Refinement::Count(*count),
            Self::Spacing(h) => Refinement::Spacing(T::of(h)?),
        })
    }
}

/// A part of a shape to change; see [`Region`].
#[derive(Clone, Debug, PartialEq)]
pub struct AnyRegion {
    /// Where it begins.
    pub from: Coords,
    /// Where it ends.
    pub to: Coords,
    /// Knots to insert, along each direction.
    pub refine: [Option<Refine>; 2],
    /// Up to which distance knots are removed afterwards.
    pub thinned: Option<Number>,
}

impl AnyRegion {
    fn of<T: Field, P: At<T> + Clone>(&self) -> Result<Region<T, P>> {
        let mut region = Region::new(place::<T, P>(&self.from)?, place(&self.to)?);
        for (refine, direction) in self.refine.iter().zip([Direction::U, Direction::V]) {
            if let Some(refine) = refine {
                region = region.refined_along(direction, refine.of()?);
            }
        }
        if let Some(tolerance) = &self.thinned {
            region = region.thinned(T::of(tolerance)?);
        }
        Ok(region)
    }
}

/// A shape that was changed in a region; see [`Reshaped`].
#[derive(Clone, Debug, PartialEq)]
pub struct Changed {
    /// The shape.
    pub shape: Value,
    /// Knots that were inserted.
    pub inserted: Vec<(Direction, Number)>,
    /// How many control points were moved.
    pub moved: usize,
    /// Knots that were removed.
    pub removed: Vec<(Direction, Number)>,
    /// How far removal took the shape at most.
    pub bound: Number,
}

fn changed<T: Field, S: Shape<T>>(found: Reshaped<S, T>) -> Changed {
    let numbers = |knots: Vec<(Direction, T)>| {
        knots.into_iter().map(|(direction, x)| (direction, x.number())).collect()
    };
    Changed {
        shape: found.shape.value(),
        inserted: numbers(found.inserted),
        moved: found.moved,
        removed: numbers(found.removed),
        bound: found.bound.number(),
    }
}

/// How control points get the parameters they are moved by.
#[derive(Clone, Debug, PartialEq)]
pub enum Assignment {
    /// By their nodes.
    Nodes,
    /// By the lengths of chords, over floats.
    Chords,
    /// These ones, along each direction.
    Given(Vec<Coords>),
}

/// The movement of a control point, in the library's words.
type Movement<'a, P, C> = &'a dyn Fn(&Assigned<P>) -> symspline::Result<Option<C>>;

/// From share and parameter of a control point to its movement, if it moves.
pub type Displacement<'a> = dyn Fn(&Coords, &Coords) -> Result<Option<Coords>> + 'a;

/// A shape with control points of a region moved; see [`Warp`].
///
/// # Errors
/// Those of the displacement, [`Error::NoSuch`], [`Error::Dimensions`], and those of [`Warp::apply`].
pub fn warped(
    shape: &Value,
    region: &AnyRegion,
    assignment: &Assignment,
    displacement: &Displacement<'_>,
) -> Result<Changed> {
    fn of<T: Field, S: Shape<T>>(
        shape: &S,
        region: &AnyRegion,
        assignment: &Assignment,
        displacement: &Displacement<'_>,
        by_chords: impl FnOnce(
            &Warp<T, S::Parameter, Movement<'_, S::Parameter, S::Point>>,
        ) -> Option<symspline::Result<Reshaped<S, T>>>,
    ) -> Result<Changed> {
        let aside = Aside::default();
        let moved = |at: &Assigned<S::Parameter>| {
            let movement = displacement(&T::coords(at.share.numbers()), &T::coords(at.parameter.numbers()))
                .and_then(|by| by.map(|by| point(&by)).transpose());
            aside.told(movement)
        };
        let moved: Movement<'_, S::Parameter, S::Point> = &moved;
        let warp = Warp::new(region.of()?, moved);
        let found = match assignment {
            Assignment::Nodes => warp.apply(shape),
            Assignment::Given(shares) => {
                let shares = shares.iter().map(T::all_of).collect::<Result<Vec<_>>>()?;
                warp.apply_with(shape, |_, _| Ok(shares))
            }
            Assignment::Chords => match by_chords(&warp) {
                Some(found) => found,
                None => {
                    return Err(Error::NoSuch {
                        operation: "lengths of chords",
                        left: String::from("exact shapes and functions"),
                        right: String::new(),
                    });
                }
            },
        };
        aside.out(found).map(changed)
    }
    macro_rules! floats {
        ($kind:ident) => {
            match shape {
                Value::$kind(Any::F2(s)) => {
                    return of(s, region, assignment, displacement, |w| Some(w.apply_by_chords(s)))
                }
                Value::$kind(Any::F3(s)) => {
                    return of(s, region, assignment, displacement, |w| Some(w.apply_by_chords(s)))
                }
                _ => {}
            }
        };
    }
    if *assignment == Assignment::Chords {
        floats!(Spline);
        floats!(Surface);
        floats!(Rational);
        floats!(RationalSurface);
    }
    shape!(shape, "warp", T, s => of::<T, _>(s, region, assignment, displacement, |_| None))
}
