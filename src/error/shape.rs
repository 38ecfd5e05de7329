//! Why a shape tool refused.

/// Why a shape tool refused: what was picked cannot do what was asked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
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
}
