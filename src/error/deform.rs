//! Why a spline was not deformed.

/// Why a spline was not deformed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum DeformError {
    /// A material has a weight that is negative or not finite.
    #[error("the weight {weight} of derivative {order} is not a finite number from zero on")]
    Material {
        /// The order of the derivative that it weighs.
        order: usize,
        /// The weight.
        weight: String,
    },
    /// Some motions cost no energy: the material has a null space on the coefficients that may move.
    #[error("the null space has the dimension {dimension}: {}", null_space(*order))]
    NullSpace {
        /// The least order of a derivative that the material weighs; none if it weighs none.
        order: Option<usize>,
        /// The dimension of the null space on the coefficients that may move.
        dimension: usize,
        /// One of these coefficients that nothing holds.
        coefficient: usize,
    },
    /// The energy of a surface has a weight that is negative or not finite.
    #[error("the weight {weight} of derivative ({k}, {l}) is not a finite number from zero on")]
    SurfaceWeight {
        /// How many derivatives along `u`.
        k: usize,
        /// How many along `v`.
        l: usize,
        /// The weight.
        weight: String,
    },
    /// Some motions of a surface cost no energy.
    #[error(
        "{dimension} independent motions of the surface cost no energy: hold more control points, or weigh the value itself"
    )]
    LooseSurface {
        /// The dimension of the null space on the control points that may move.
        dimension: usize,
        /// One of these control points that nothing holds, as its place in the list.
        point: usize,
    },
    /// A step in time is not positive.
    #[error("the time step {step} is not a positive finite number")]
    Step {
        /// The step.
        step: String,
    },
    /// No coefficient may move.
    #[error("no control point may move")]
    NothingMoves,
    /// The ends of a ring cannot be held.
    #[error("a periodic space has no ends to hold")]
    NoEnds,
    /// A force does not move the point it should move.
    #[error(
        "the force at {place} does not move the shape there: the control points that may move have no hold on it"
    )]
    NoHold {
        /// Where the force acts.
        place: String,
    },
    /// Constraints ask for what an elastic body does not know.
    #[error("{what} have no meaning for an elastic body: its breadth says what may move, its energy how")]
    Meaningless {
        /// What they ask for.
        what: &'static str,
    },
    /// Constraints are not met but for rounding.
    #[error(
        "constraints are missed by {open}: in floating point they are too close together to be told apart"
    )]
    Unmet {
        /// By how much the constrained values are off.
        open: String,
    },
    /// Nothing is held that could be dragged.
    #[error("nothing is held: grab the shape first")]
    NothingHeld,
    /// The shape is not over the spaces of the material.
    #[error("the shape is over another space along {direction}")]
    OtherSpace {
        /// Along which parameter.
        direction: String,
    },
    /// Control points of a rational shape are put back with another weight than they have.
    #[error("control point {point} has another weight than {weight}")]
    OtherWeight {
        /// The control point, as its place in the list.
        point: usize,
        /// The weight that was given.
        weight: String,
    },
    /// Forces are spread over a curve or an area without a single sample on it.
    #[error("no sample lies on the curve or in the area")]
    NoSamples,
    /// A curve around an area does not end where it begins, or jumps.
    #[error("the curve around the area is open at {parameter}")]
    OpenBoundary {
        /// Where it is open; at its end if it does not meet its start.
        parameter: String,
    },
}

fn null_space(order: Option<usize>) -> String {
    match order {
        None => "the material resists nothing".into(),
        Some(0) => "beside the other weights the hardness is rounding; hold control points, or give more of it".into(),
        Some(1) => "the material lets constant functions pass, that is translations; hold a control point of each part, or give hardness".into(),
        Some(2) => "the material lets linear functions pass, on a ring constants, with breaks where the spline is only continuous; hold two control points of each part, or give hardness".into(),
        Some(order) => format!(
            "the material lets polynomials below degree {order} pass on each smooth part; hold as many control points, or give hardness"
        ),
    }
}
