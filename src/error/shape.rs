//! Why a shape tool refused.

/// Why a shape tool refused: what was picked cannot do what was asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum ShapeError {
    /// A control point, or several with their shares, have no influence at the picked parameter.
    #[error("what was picked has no influence at parameter {parameter}")]
    NoInfluence {
        /// The parameter.
        parameter: String,
    },
    /// A knot would be inserted where there is one already.
    #[error("the knot {knot} is there already: inserting it would make the shape less smooth")]
    KnotThere {
        /// The knot.
        knot: String,
    },
    /// A value should be a knot and is none.
    #[error("{value} is no knot")]
    NoKnot {
        /// The value.
        value: String,
    },
    /// No node is at or before a parameter.
    #[error("parameter {parameter} is before the first node")]
    NoNodeBefore {
        /// The parameter.
        parameter: String,
    },
    /// A point should be between the ends of a leg of the control polygon.
    #[error("the point is not between the ends of the leg, but at fraction {fraction} of it")]
    NotOnLeg {
        /// How far along the leg it is.
        fraction: String,
    },
    /// More conditions than control points that may move.
    #[error("{conditions} conditions on {free} control points: {clashing:?} cannot be met together")]
    Overdetermined {
        /// The number of conditions.
        conditions: usize,
        /// The number of control points that may move.
        free: usize,
        /// The first condition that depends on others, and those.
        clashing: Vec<usize>,
    },
    /// A condition depends on others, so that not every change can be asked for.
    #[error("condition {condition} depends on conditions {on:?}")]
    Dependent {
        /// The first condition that depends on those before it.
        condition: usize,
        /// Those it depends on; none if no control point that may move has influence.
        on: Vec<usize>,
    },
    /// A control point has a weight in the measure of movement that is not positive.
    #[error("the weight {weight} of the movement of control point {index} is not a positive number")]
    MovementWeight {
        /// Its place in the list.
        index: usize,
        /// The weight.
        weight: String,
    },
    /// Conditions given as rows, and fixed control points, do not say what they mean on a refined shape.
    #[error(
        "conditions given as rows, held control points and weights of movement have no meaning on a refined shape"
    )]
    NotCarried,
    /// A tangent would point the other way, or vanish.
    #[error("the least change that turns the tangent makes it vanish or point the other way")]
    TangentReversed,
    /// No control point has influence in a region alone.
    #[error("no control point has influence in the region alone: it takes more knots there")]
    NoFreePoints,
    /// Parameters were assigned to more or fewer control points than may move.
    #[error("there must be one share for each control point that may move, in each direction")]
    Shares,
    /// A vector that should point somewhere is zero.
    #[error("the {what} has no direction")]
    NoDirection {
        /// Which vector.
        what: &'static str,
    },
    /// A projection runs along the line or plane it should end on.
    #[error("the projection is parallel to what it should end on")]
    ParallelProjection,
    /// A line in space does not divide it, and holds no region.
    #[error("a line in space has no sides and holds no region")]
    NoSides,
    /// An interval was given for a surface, a region for a curve, or a direction that a curve does not have.
    #[error("the parameters are not those of this shape")]
    OtherParameters,
    /// Nothing became flat.
    #[error("no part is flat with {count} control points, and more than {limit} are not allowed")]
    NotFlat {
        /// How many control points the shape has now.
        count: usize,
        /// How many it may have.
        limit: usize,
    },
    /// No control point has its influence in an interval.
    #[error("no control point has all its influence between {start} and {end}: more knots are needed there")]
    NothingLocal {
        /// Start of the interval.
        start: String,
        /// End of the interval.
        end: String,
    },
    /// A control point is at the centre of the bend.
    #[error("control point {index} is at the centre of the bend")]
    AtCentre {
        /// The control point.
        index: usize,
    },
    /// The ray from the centre of a bend through a control point does not meet what is bent about.
    #[error("the ray from the centre through control point {index} does not meet what is bent about")]
    NoBendPoint {
        /// The control point.
        index: usize,
    },
    /// A bend sends a point to infinity, or through it to the other side.
    #[error(
        "the cross ratio {ratio} sends control point {index}, with OR : OP = {share}, to infinity or beyond"
    )]
    BeyondInfinity {
        /// The control point.
        index: usize,
        /// The cross ratio.
        ratio: String,
        /// The share `s` of the way from the centre to the point.
        share: String,
    },
    /// A length is not in the field.
    #[error("the square root of {square} is not in the field")]
    NoRoot {
        /// The square.
        square: String,
    },
    /// A closed shape has no ends that could be carried along.
    #[error("a closed shape has no ends to carry along")]
    NoEnds,
    /// A pull would reach what it pulls toward, or pass it.
    #[error("a pull by {fraction} of the way reaches or passes what it pulls toward: no weight does that")]
    PullTooFar {
        /// The fraction of the way asked for.
        fraction: String,
    },
    /// A push would need a weight of zero or less.
    #[error("a move by {fraction} of the way needs a weight of zero or less, it must stay above {limit}")]
    PushTooFar {
        /// The fraction of the way asked for, negative for a push.
        fraction: String,
        /// The fraction where the weight is zero.
        limit: String,
    },
    /// A weight would leave the range allowed.
    #[error("weight {index} would be {weight}, outside the range from {least} to {most}")]
    WeightOutOfRange {
        /// The control point, in the list of all.
        index: usize,
        /// The weight needed.
        weight: String,
        /// The least weight allowed.
        least: String,
        /// The largest weight allowed.
        most: String,
    },
    /// No weights are in a range: it must be `0 < least <= most`.
    #[error("no weights are allowed from {least} to {most}: a range is 0 < least <= most")]
    EmptyRange {
        /// The least weight.
        least: String,
        /// The largest weight.
        most: String,
    },
    /// A point is where it would be pulled to, so that no weight moves it.
    #[error("the point is already where it would be pulled to: the weight does not move it")]
    Fixed,
    /// Two picks should differ and are one.
    #[error("control point {index} was picked twice")]
    PickedTwice {
        /// The control point, in the list of all.
        index: usize,
    },
    /// Besides the control points picked nothing has influence, so that they span no triangle with what is left.
    #[error(
        "besides the two control points nothing has influence at parameter {parameter}: there is no triangle"
    )]
    NoBase {
        /// The parameter.
        parameter: String,
    },
    /// A triangle is flat.
    #[error("the corners of the triangle are on a line: only moves along it are possible")]
    FlatTriangle,
    /// A target is off the plane of the triangle that the point can reach.
    #[error(
        "the target is {distance} off the plane of the triangle, which is above the tolerance {tolerance}"
    )]
    OffPlane {
        /// The distance.
        distance: String,
        /// The tolerance given.
        tolerance: String,
    },
    /// A target is not inside the triangle that the point can reach.
    #[error("the target is not inside the triangle: its barycentric coordinate of {corner} is {coordinate}")]
    OutsideTriangle {
        /// "the base", "the first control point" or "the second control point".
        corner: &'static str,
        /// The coordinate, not positive.
        coordinate: String,
    },
    /// A point is not on the line of two others.
    #[error("point {point} is {distance} off the line, which is above the tolerance {tolerance}")]
    NotOnLine {
        /// Its place among the points given.
        point: usize,
        /// The distance.
        distance: String,
        /// The tolerance given.
        tolerance: String,
    },
    /// Two points that should differ coincide.
    #[error("points {first} and {second} coincide")]
    Coincide {
        /// The place of the one among the points given.
        first: usize,
        /// The place of the other.
        second: usize,
    },
    /// No knot inside the domain puts a parameter halfway between two nodes.
    #[error("no knot inside the domain puts parameter {parameter} halfway between two nodes")]
    NoHalfwayKnot {
        /// The parameter.
        parameter: String,
    },
}
