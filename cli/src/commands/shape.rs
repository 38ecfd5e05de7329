//! `shape`: control points, weights, warps, bends, flat parts, constraints.

use crate::commands::shapes::{Argued, Tool, apply, each_points, not_a_shape};
use crate::failure::{Failure, Result};
use crate::input::Input;
use crate::numbers::{Index, Interval, List, One, Place};
use crate::output::{self, Output};
use clap::{Args, Subcommand, ValueEnum};
use symspline::{Bend, Bump, Constraints, Direction, Drag, Flatten, Refinement, Region, Round, Side, Warp};
use symspline::{Weighed, WeightPull, confined};
use symspline_dynamic::{AnyRational, AnyRationalSurface, Field, Value};

/// Change the shape of a curve or surface
#[derive(Debug, Subcommand)]
pub enum Shape {
    /// Move a point of the shape by a vector, by moving one control point or a few
    #[command(after_help = "Example: symspline shape reposition --at 1/2 --by 0,1 curve.json")]
    Reposition(On<Reposition>),
    /// Take a point of the shape a fraction of the way to a control point, by its weight
    #[command(after_help = "Example: symspline shape weight --at 1/2 --index 2 --fraction 1/3 curve.json")]
    Weight(On<Weight>),
    /// Raise a bump: control points moved that have influence in a region alone
    #[command(after_help = "Example: symspline shape warp --on 1,3 --by 0,2 --insert 10 curve.json")]
    Warp(On<Warped>),
    /// Flatten: control points projected onto a line or plane
    #[command(
        after_help = "Example: symspline shape flatten --onto-point 0,2 --direction 1,0 --side positive curve.json"
    )]
    Flatten(On<Flattened>),
    /// Bend about a circle
    #[command(
        after_help = "Example: symspline shape bend --on 1,3 --centre 4.5,-6 --radius 6 --ratio 2 --insert 10 curve.json"
    )]
    Bend(On<Bent>),
    /// Change points and derivatives, by the least movement of control points
    #[command(after_help = "\
Each --change is of the derivative of the --order that stands at the same place, 0 if none is given, at its --at.

Example: symspline shape constrain --at 1/2 --order 0 --change 0,0 --at 1/2 --order 1 --change 0,1 curve.json")]
    Constrain(On<Constrained>),
}

/// A tool with what it works on.
#[derive(Args, Debug)]
pub struct On<A: Args> {
    #[command(flatten)]
    tool: A,
    #[command(flatten)]
    input: Input,
    #[command(flatten)]
    output: Output,
}

impl<A: Args> On<A> {
    fn run(&self, change: impl FnOnce(&A, &Value) -> Result<Value>) -> Result<()> {
        self.output.write(&self.input.changed(|value| change(&self.tool, value))?)
    }
}

impl Shape {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        match self {
            Self::Reposition(on) => on.run(apply),
            Self::Weight(on) => on.run(Weight::apply),
            Self::Warp(on) => on.run(apply),
            Self::Flatten(on) => on.run(apply),
            Self::Bend(on) => on.run(apply),
            Self::Constrain(on) => on.run(apply),
        }
    }
}

/// Control points repositioned.
#[derive(Args, Debug)]
pub struct Reposition {
    /// The point: `u`, or `u:v` of a surface
    #[arg(long, allow_hyphen_values = true)]
    at: Place,
    /// The vector by which it moves
    #[arg(long, value_name = "VECTOR", allow_hyphen_values = true)]
    by: List,
    /// Which control points move
    #[arg(long, value_enum, default_value_t = With::Nearest)]
    with: With,
    /// The control point that moves, with `--with one`
    #[arg(long, required_if_eq("with", "one"))]
    index: Option<Index>,
    /// Insert knots so that nothing moves outside this interval
    #[arg(long, value_name = "A,B", conflicts_with_all = ["with", "index"], allow_hyphen_values = true)]
    between: Option<Interval>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum With {
    /// The one of `--index`
    One,
    /// The one that is nearest to the point
    Nearest,
    /// The two around the point, of a surface the four
    Neighbours,
}

impl Tool for Reposition {
    fn applied<T: Field, const N: usize, S: Argued<T, N>>(&self, shape: &S) -> Result<S> {
        let (at, by) = (S::parameter(&self.at)?, [S::vector(&self.by)?]);
        if let Some(Interval { from, to }) = &self.between {
            let (from, to) = (S::parameter(from)?, S::parameter(to)?);
            let (mut finer, mut index) = (shape.clone(), Vec::new());
            for direction in S::DIRECTIONS {
                let [start, x, end] = [&from, &at, &to].map(|place| S::coordinate(place, *direction));
                let (inserted, k) = confined(&finer, *direction, x, (start, end))?;
                finer = inserted;
                index.push(k);
            }
            return Ok(Drag::by_one(&finer, &at, S::index(&Index(index))?)?.applied(&finer, &by)?);
        }
        let drag = match (self.with, &self.index) {
            (With::One, Some(index)) => Drag::by_one(shape, &at, S::index(index)?)?,
            (With::Neighbours, _) => Drag::by_neighbours(shape, &at, None)?,
            _ => Drag::by_nearest(shape, &at)?,
        };
        Ok(drag.applied(shape, &by)?)
    }
}

/// A weight that takes a point to its control point.
#[derive(Args, Debug)]
pub struct Weight {
    /// The point: `u`, or `u:v` of a surface
    #[arg(long, allow_hyphen_values = true)]
    at: Place,
    /// The control point: `i`, or `i:j` of a surface
    #[arg(long)]
    index: Index,
    /// The fraction of the way; less than 0 pushes away
    #[arg(long, allow_hyphen_values = true)]
    fraction: One,
}

impl Weight {
    /// What it makes of a rational shape; a polynomial one has weights 1.
    fn apply(&self, value: &Value) -> Result<Value> {
        let refused = || Err(not_a_shape(value));
        match value {
            Value::Spline(s) => self.apply(&AnyRational::from_polynomial(s)?.into()),
            Value::Surface(s) => self.apply(&AnyRationalSurface::from_polynomial(s)?.into()),
            Value::Rational(any) => {
                each_points!(any, s => Ok(Value::Rational(self.pulled(s)?.into())), refused())
            }
            Value::RationalSurface(any) => {
                each_points!(any, s => Ok(Value::RationalSurface(self.pulled(s)?.into())), refused())
            }
            _ => refused(),
        }
    }

    fn pulled<T: Field, const N: usize, S: Argued<T, N> + Weighed<T>>(&self, shape: &S) -> Result<S> {
        let pull = WeightPull::new(shape, &S::parameter(&self.at)?, S::index(&self.index)?)?;
        Ok(pull.applied(shape, &self.fraction.of()?)?)
    }
}

/// A bump.
#[derive(Args, Debug)]
pub struct Warped {
    /// The region: `a,b`, or `u0:v0,u1:v1` of a surface
    #[arg(long, value_name = "A,B", allow_hyphen_values = true)]
    on: Interval,
    /// The vector by which the top moves
    #[arg(long, value_name = "VECTOR", allow_hyphen_values = true)]
    by: List,
    /// How broad the top is: 1 for a cubic bump, more for a broader one
    #[arg(long, value_name = "WEIGHT", default_value = "1")]
    bump: One,
    /// Insert so many knots in the region first
    #[arg(long, value_name = "N", default_value_t = 0)]
    insert: usize,
}

impl Tool for Warped {
    fn applied<T: Field, const N: usize, S: Argued<T, N>>(&self, shape: &S) -> Result<S> {
        let bump = Bump::new(self.bump.of()?)?;
        let region = Region::new(S::parameter(&self.on.from)?, S::parameter(&self.on.to)?)
            .refined(Refinement::Count(self.insert));
        let warp = Warp::along(region, |at| S::height(&bump, &at.share), S::vector(&self.by)?);
        let warped = warp.apply(shape)?;
        output::note(format_args!(
            "{} control points moved, {} knots inserted",
            warped.moved,
            warped.inserted.len()
        ));
        Ok(warped.shape)
    }
}

/// Flat parts.
#[derive(Args, Debug)]
pub struct Flattened {
    /// A point of the line or plane
    #[arg(long, value_name = "POINT", allow_hyphen_values = true)]
    onto_point: List,
    /// The direction of the line
    #[arg(
        long,
        value_name = "VECTOR",
        allow_hyphen_values = true,
        required_unless_present = "normal",
        conflicts_with = "normal"
    )]
    direction: Option<List>,
    /// The normal of the line or plane
    #[arg(long, value_name = "VECTOR", allow_hyphen_values = true)]
    normal: Option<List>,
    /// Only control points on this side: the one its normal points to, of a line in the plane the left one, or the other
    #[arg(long, value_enum)]
    side: Option<Half>,
    /// Only control points with influence in this part alone: `a,b`, or `u0:v0,u1:v1` of a surface
    #[arg(long, value_name = "A,B", allow_hyphen_values = true)]
    on: Option<Interval>,
    /// Insert so many knots first
    #[arg(long, value_name = "N")]
    insert: Option<usize>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Half {
    Positive,
    Negative,
}

impl Tool for Flattened {
    fn applied<T: Field, const N: usize, S: Argued<T, N>>(&self, shape: &S) -> Result<S> {
        let onto = S::onto(&self.onto_point, self.direction.as_ref(), self.normal.as_ref())?;
        let mut flatten = Flatten::new(onto);
        if let Some(side) = self.side {
            flatten = flatten.on_side(match side {
                Half::Positive => Side::Positive,
                Half::Negative => Side::Negative,
            });
        }
        if let Some(Interval { from, to }) = &self.on {
            flatten = flatten.local_to(S::part(S::parameter(from)?, S::parameter(to)?));
        }
        if let Some(count) = self.insert {
            flatten = flatten.refined(Refinement::Count(count));
        }
        let flattened = flatten.apply(shape)?;
        let (projected, flat) = (flattened.projected.len(), flattened.flat.len());
        output::note(format_args!("{projected} control points projected, {flat} parts are flat"));
        Ok(flattened.shape)
    }
}

/// A bend about a circle, or a sphere.
#[derive(Args, Debug)]
pub struct Bent {
    /// The interval that is bent; the whole shape if none is given
    #[arg(long, value_name = "A,B", allow_hyphen_values = true)]
    on: Option<Interval>,
    /// The centre
    #[arg(long, value_name = "POINT", allow_hyphen_values = true)]
    centre: List,
    /// The radius
    #[arg(long)]
    radius: One,
    /// The cross ratio: 1 brings control points to the circle
    #[arg(long, default_value = "1", allow_hyphen_values = true)]
    ratio: One,
    /// The direction along which a surface is bent
    #[arg(long, value_enum, default_value_t = Along::U)]
    along: Along,
    /// Insert so many knots first
    #[arg(long, value_name = "N")]
    insert: Option<usize>,
    /// Leave what is outside the interval where it is
    #[arg(long)]
    without_tails: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Along {
    U,
    V,
}

impl Tool for Bent {
    fn applied<T: Field, const N: usize, S: Argued<T, N>>(&self, shape: &S) -> Result<S> {
        let direction = match self.along {
            Along::U => Direction::U,
            Along::V => Direction::V,
        };
        let centre = S::vector(&self.centre)?;
        let mut bend =
            Bend::new(centre, Round(self.radius.of::<T>()?), self.ratio.of::<T>()?).along(direction);
        if let Some(Interval { from, to }) = &self.on {
            bend = bend.on(single(from)?.of()?, single(to)?.of()?);
        }
        if let Some(count) = self.insert {
            bend = bend.refined(Refinement::Count(count));
        }
        if self.without_tails {
            bend = bend.without_tails();
        }
        Ok(bend.apply(shape)?)
    }
}

/// A place along one direction.
fn single(place: &Place) -> Result<One> {
    match &place.0[..] {
        [x] => Ok(One(x.clone())),
        _ => Err(Failure::Usage("the interval is 'a,b' here: it is along one direction".to_owned())),
    }
}

/// Constraints.
#[derive(Args, Debug)]
pub struct Constrained {
    /// Where: `u`, or `u:v` of a surface
    #[arg(long, required = true, allow_hyphen_values = true)]
    at: Vec<Place>,
    /// Which derivative: `k`, or `k:l` of a surface
    #[arg(long)]
    order: Vec<Index>,
    /// By which vector it changes
    #[arg(long, value_name = "VECTOR", required = true, allow_hyphen_values = true)]
    change: Vec<List>,
    /// A control point that stays: `i`, or `i:j` of a surface
    #[arg(long, value_name = "INDEX")]
    hold: Vec<Index>,
}

impl Tool for Constrained {
    fn applied<T: Field, const N: usize, S: Argued<T, N>>(&self, shape: &S) -> Result<S> {
        let count = self.at.len();
        if self.change.len() != count || !(self.order.is_empty() || self.order.len() == count) {
            return Err(Failure::Usage(
                "there must be as many --change as --at, and as many --order or none".into(),
            ));
        }
        let held = self.hold.iter().map(S::index).collect::<Result<Vec<_>>>()?;
        let mut constraints = Constraints::on(shape).holding(&held)?;
        for (i, at) in self.at.iter().enumerate() {
            let order = self.order.get(i).map_or(Ok(S::VALUE), S::order)?;
            constraints = constraints.derivative(&S::parameter(at)?, order)?;
        }
        let changes = self.change.iter().map(S::vector).collect::<Result<Vec<_>>>()?;
        Ok(constraints.prepare()?.dragged(shape, &changes)?)
    }
}
