//! What is reported: where curves meet, and how sure that is.

use nalgebra::SVector;

/// What is known about a place where two things meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Certainty {
    /// There is exactly one solution in the ranges of parameters given, and it is simple. At an end of a curve this
    /// counts the pieces as going on beyond it by a few roundings.
    Proved,
    /// Not decided. They come as near to each other as the tolerance, or as rounding can tell, and may touch, cross
    /// several times, or just miss each other. Ranges that are wide say that they run along each other too closely to
    /// look at all of it.
    Contact,
}

/// How two curves pass each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Passage {
    /// Each goes from one side of the other to the other side.
    Crosses,
    /// Each stays on one side of the other, at a corner of one of them.
    Touches,
    /// One of them ends.
    Ends,
    /// Not known: they are tangent, or nearly.
    Unknown,
}

/// A place where two curves meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Meeting {
    /// The parameter on each curve.
    pub parameters: [f64; 2],
    /// From where to where the parameters of the exact solution lie, or those of the contact. At the seam of a closed
    /// curve the range starts before the domain.
    pub ranges: [(f64, f64); 2],
    /// The point, on the first curve.
    pub point: SVector<f64, 2>,
    /// How sure it is.
    pub certainty: Certainty,
    /// Whether they cross.
    pub passage: Passage,
}

/// A stretch along which two curves coincide.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlap {
    /// From where to where on the first curve, ascending.
    pub first: (f64, f64),
    /// The parameters of the second curve at the same points: descending if it runs the other way.
    pub second: (f64, f64),
}

/// All places where two curves meet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Intersections {
    /// Single places, in the order of the parameter on the first curve.
    pub meetings: Vec<Meeting>,
    /// Stretches, in the same order. Single places at their ends are not listed again.
    pub overlaps: Vec<Overlap>,
}

impl Intersections {
    /// Whether every meeting is proved and there is no overlap.
    pub fn is_proved(&self) -> bool {
        self.overlaps.is_empty() && self.meetings.iter().all(|m| m.certainty == Certainty::Proved)
    }
}

/// A place where a line meets a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct LineMeeting {
    /// The parameters of the surface.
    pub parameters: [f64; 2],
    /// From where to where the parameters of the exact solution lie, or those of the contact.
    pub ranges: [(f64, f64); 2],
    /// The parameter of the line: the point is `origin + along * direction`.
    pub along: f64,
    /// The point, on the surface.
    pub point: SVector<f64, 3>,
    /// How sure it is.
    pub certainty: Certainty,
}

/// A stretch along which a line lies in a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct LineOverlap {
    /// From where to where on the line, ascending.
    pub along: (f64, f64),
    /// The parameters of the surface where the stretch starts and ends.
    pub parameters: [[f64; 2]; 2],
}

/// All places where a line meets a surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LineMeetings {
    /// Single places, in the order of the line.
    pub meetings: Vec<LineMeeting>,
    /// Stretches, in the same order.
    pub overlaps: Vec<LineOverlap>,
}
