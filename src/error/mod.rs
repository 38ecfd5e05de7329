//! What can go wrong, as one enum with data.

pub mod deform;
pub mod obj;
pub mod mesh;
pub mod shape;
pub mod skin;
pub mod tune;

use deform::DeformError;
use mesh::MeshError;
use shape::ShapeError;
use skin::SkinError;
use tune::TuneError;

/// The result of an operation that can fail.
pub type Result<T> = std::result::Result<T, Error>;

/// Why an operation refused. Values of a field stand as text, so that one enum serves every field.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Error {
    /// A value is NaN or infinite.
    #[error("{what} {index} is not a finite number")]
    NotFinite {
        /// What kind of value: "knot", "coefficient", "parameter", ...
        what: &'static str,
        /// Its place in the input.
        index: usize,
    },
    /// A knot is smaller than the one before it.
    #[error("knot {index} is smaller than the knot before it")]
    KnotsDecrease {
        /// The index of the smaller knot.
        index: usize,
    },
    /// Not enough knots for the degree.
    #[error("{expected} knots are needed, {found} are given")]
    TooFewKnots {
        /// How many it takes.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// The domain has no length, or a knot lies beyond it.
    #[error("the domain from {start} to {end} is empty or does not hold all knots")]
    EmptyDomain {
        /// Start of the domain.
        start: String,
        /// End of the domain.
        end: String,
    },
    /// The length of a span, or of the whole knot vector, has no finite inverse in floating point.
    #[error(
        "the span after knot {index}, or the whole knot vector, is too short or too long for floating point"
    )]
    SpanOutOfRange {
        /// The index of the knot before the span.
        index: usize,
    },
    /// A knot has more copies than degree + 1.
    #[error("knot {knot} has {multiplicity} copies, at most {limit} make sense")]
    Multiplicity {
        /// The knot.
        knot: String,
        /// How many copies it has.
        multiplicity: usize,
        /// How many it may have.
        limit: usize,
    },
    /// A coefficient has no influence on the domain.
    #[error("coefficient {index} has no influence on the domain")]
    UnusedCoefficient {
        /// Its index.
        index: usize,
    },
    /// A degree (or order) beyond what is sane.
    #[error("degree {degree} is above the limit {limit}")]
    DegreeTooHigh {
        /// The degree asked for.
        degree: usize,
        /// The highest allowed.
        limit: usize,
    },
    /// The degree of a space is too low for what it should hold.
    #[error("degree {degree} is too low, {needed} is needed")]
    DegreeTooLow {
        /// The degree given.
        degree: usize,
        /// The degree needed.
        needed: usize,
    },
    /// A size beyond what is sane.
    #[error("{count} values are more than the limit {limit}")]
    TooLarge {
        /// The number asked for.
        count: usize,
        /// The largest allowed.
        limit: usize,
    },
    /// A parameter is outside the domain, or not a number.
    #[error("parameter {parameter} is outside the domain [{start}, {end}]")]
    OutsideDomain {
        /// The parameter.
        parameter: String,
        /// Start of the domain.
        start: String,
        /// End of the domain.
        end: String,
    },
    /// Two splines that should have the same domain do not.
    #[error("the domains {left} and {right} differ")]
    DomainMismatch {
        /// The one domain.
        left: String,
        /// The other.
        right: String,
    },
    /// An index is not that of a non-empty span of the domain.
    #[error("{span} is not the index of a non-empty span of the domain")]
    EmptySpan {
        /// The index given.
        span: usize,
    },
    /// The number of coefficients, points or arguments is wrong.
    #[error("{expected} values are needed, {found} are given")]
    CoefficientCount {
        /// How many it takes.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// Rows that should have the same length do not.
    #[error("row {index} has another length than the first")]
    Ragged {
        /// The first row that differs.
        index: usize,
    },
    /// A weight is not positive.
    #[error("weight {index} is {weight}, not positive")]
    Weight {
        /// Its index.
        index: usize,
        /// The weight.
        weight: String,
    },
    /// A denominator vanishes somewhere.
    #[error("the denominator has a zero")]
    Pole,
    /// Bisection did not tell whether a function, as a denominator or a scale, vanishes.
    #[error("whether the function has a zero could not be decided")]
    Undecided,
    /// A function that should be positive is not.
    #[error("the function is {value} at parameter {parameter}, not positive")]
    NotPositive {
        /// A parameter where it is not.
        parameter: String,
        /// The value there.
        value: String,
    },
    /// A ratio is not positive.
    #[error("the ratio {ratio} is not a positive number")]
    Ratio {
        /// The ratio given.
        ratio: String,
    },
    /// The ends of an arc do not lie on one circle around the centre.
    #[error("the ends of the arc are not at one distance from the centre")]
    NotOnCircle,
    /// An index is out of range.
    #[error("index {index} is out of range for {length} values")]
    IndexOutOfRange {
        /// The index.
        index: usize,
        /// The number of values.
        length: usize,
    },
    /// A space is too smooth at a knot to hold another.
    #[error("the target has {multiplicity} copies of knot {knot}, {needed} are needed")]
    TooSmooth {
        /// The knot.
        knot: String,
        /// How many copies the target has.
        multiplicity: usize,
        /// How many it takes.
        needed: usize,
    },
    /// A periodic space cannot hold an open one.
    #[error("a spline with open ends does not fit a periodic space")]
    NotPeriodic,
    /// A spline jumps where it should be continuous.
    #[error("the spline may jump at knot {knot}")]
    Discontinuous {
        /// The knot of multiplicity degree + 1.
        knot: String,
    },
    /// A periodic antiderivative needs the integral over the period to vanish.
    #[error("the integral over the period is {integral}, not zero: no periodic antiderivative")]
    NonZeroMean {
        /// The integral over one period.
        integral: String,
    },
    /// A tolerance is negative, NaN or infinite.
    #[error("{tolerance} is no tolerance")]
    BadTolerance {
        /// The tolerance given.
        tolerance: String,
    },
    /// No approximation within the tolerance was found.
    #[error("the error is bounded by {bound} only, which is above the tolerance {tolerance}")]
    OutOfTolerance {
        /// The certified bound that was reached.
        bound: String,
        /// The tolerance given.
        tolerance: String,
    },
    /// A point is not on a curve or surface within the tolerance.
    #[error("the point is {distance} away, which is above the tolerance {tolerance}")]
    TooFar {
        /// The distance.
        distance: String,
        /// The tolerance given.
        tolerance: String,
    },
    /// A spline is not one of the lower degree asked for.
    #[error("the spline is not one of degree {degree}")]
    NotReducible {
        /// The degree asked for.
        degree: usize,
    },
    /// A value is not a knot inside the domain that could be removed.
    #[error("{knot} is no knot that can be removed")]
    NotRemovable {
        /// The value.
        knot: String,
    },
    /// Not enough points.
    #[error("{expected} points are needed, {found} are given")]
    TooFewPoints {
        /// How many it takes.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A parameter is smaller than the one before it, or not a number.
    #[error("parameter {index} is not at or after the one before it")]
    ParametersDecrease {
        /// The index of the parameter.
        index: usize,
    },
    /// The ends of a space must be clamped for what was asked.
    #[error("the ends are not clamped")]
    NotClamped,
    /// Two ends that should meet do not.
    #[error("the ends do not meet: {left} and {right}")]
    EndsDoNotMeet {
        /// Where the one ends.
        left: String,
        /// Where the other starts.
        right: String,
    },
    /// The data do not determine a coefficient (the Schoenberg-Whitney condition fails there).
    #[error("the data do not determine coefficient {index}")]
    Undetermined {
        /// The first coefficient without a parameter of its own inside its support.
        index: usize,
    },
    /// A linear system has no unique solution.
    #[error("the system is singular at row {row}")]
    Singular {
        /// The row where elimination found no pivot.
        row: usize,
    },
    /// A condition follows from those before it, but its value does not.
    #[error("condition {condition} contradicts those before it")]
    Clash {
        /// Its index.
        condition: usize,
    },
    /// An area is that of a plane curve.
    #[error("an area needs a plane curve, not one in {dimension} dimensions")]
    NotPlane {
        /// The dimension of the curve.
        dimension: usize,
    },
    /// A curve stands still, so that it has no direction or curvature there.
    #[error("the derivative vanishes at parameter {parameter}")]
    Stationary {
        /// The parameter.
        parameter: String,
    },
    /// The curvature of a curve vanishes, so that it has no Frenet normal there.
    #[error("the curvature vanishes at parameter {parameter}: there is no Frenet normal")]
    Straight {
        /// The parameter.
        parameter: String,
    },
    /// A vector that should give a normal is along the tangent, or zero.
    #[error("the vector for the first normal is zero or along the tangent")]
    AlongTangent,
    /// The first derivatives of a surface are parallel, so that it has no normal there.
    #[error("the surface has no normal at ({u}, {v})")]
    NoNormal {
        /// The first parameter.
        u: String,
        /// The second parameter.
        v: String,
    },
    /// The inner function of a composition takes a value outside the domain of the outer one.
    #[error(
        "the value {value} at parameter {parameter} is outside the domain [{start}, {end}] of the outer spline"
    )]
    LeavesDomain {
        /// A parameter where it does.
        parameter: String,
        /// The value there.
        value: String,
        /// Start of the domain of the outer spline.
        start: String,
        /// End of that domain.
        end: String,
    },
    /// A composition needs a knot at a parameter that is not in the field, or not known to be.
    #[error(
        "the value {knot}, a knot, is taken between parameters {start} and {end} where the field has no number for it"
    )]
    IrrationalPreimage {
        /// The knot of the outer spline.
        knot: String,
        /// A parameter below the one needed.
        start: String,
        /// A parameter above it, no other preimage of the knot in between.
        end: String,
    },
    /// A change of parameter does not increase.
    #[error("the change of parameter does not increase at {parameter}")]
    NotIncreasing {
        /// A parameter where it does not.
        parameter: String,
    },
    /// All points coincide, so that nothing has a length.
    #[error("all points coincide, the polygon has no length")]
    NoLength,
    /// No similarity reaches held ends: a chord has no length. See [`Condition::End`](crate::Condition::End).
    #[error(
        "the points to be held coincide at both ends, before or after scaling: no rotation and scaling holds them; closed curves stay closed by springs, or exactly by a nearest scale that holds the end"
    )]
    NoChord,
    /// A leg of a control polygon has no length, so that it makes no angle with the next.
    #[error("leg {index} of the control polygon has no length, its angles are undefined")]
    ZeroLeg {
        /// The index of the leg.
        index: usize,
    },
    /// Fine tuning refused.
    #[error(transparent)]
    Tune(#[from] TuneError),
    /// A shape tool refused.
    #[error(transparent)]
    Shape(#[from] ShapeError),
    /// A spline was not deformed.
    #[error(transparent)]
    Deform(#[from] DeformError),
    /// See [`MeshError`].
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// No skin was laid over sections.
    #[error(transparent)]
    Skin(#[from] SkinError),
    /// A text is not a number.
    #[error("'{text}' is not a fraction p/q: {reason}")]
    NotANumber {
        /// The text as given.
        text: String,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// Reading or writing a file failed.
    #[error("{path}: {message}")]
    Io {
        /// The file.
        path: String,
        /// What the operating system said.
        message: String,
    },
    /// A picture could not be drawn.
    #[error("cannot draw: {message}")]
    Drawing {
        /// Why.
        message: String,
    },
}

impl Error {
    /// [`Error::NoNormal`] at `(u, v)`.
    pub(crate) fn no_normal(u: &impl ToString, v: &impl ToString) -> Self {
        Self::NoNormal { u: u.to_string(), v: v.to_string() }
    }
}
