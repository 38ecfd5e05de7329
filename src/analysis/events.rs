//! What may happen to the curvature along a curve.

use crate::analysis::zeros::Place;

/// What happens to the curvature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum EventKind {
    /// In the plane the curvature changes its sign; in space it vanishes.
    Inflection,
    /// The curvature has a maximum (in the plane with its sign).
    Maximum,
    /// The curvature has a minimum (in the plane with its sign), other than a zero in space.
    Minimum,
    /// The curvature jumps at a knot.
    Jump,
    /// The curve stands still and goes on in its direction.
    Stationary,
    /// The curve stands still and turns back.
    Cusp,
    /// The direction jumps at a knot.
    Corner,
    /// The position jumps at a knot.
    Gap,
}

/// Bounds of a number, rounded outwards; infinite where there are none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The number is not below this.
    pub low: f64,
    /// The number is not above this.
    pub high: f64,
}

impl Bounds {
    /// A float between the bounds, about their mean; a bound that is infinite counts as the other one.
    ///
    /// # Examples
    /// ```
    /// use symspline::Bounds;
    /// assert_eq!(Bounds { low: 1.0, high: 3.0 }.middle(), 2.0);
    /// ```
    pub fn middle(&self) -> f64 {
        match (self.low.is_finite(), self.high.is_finite()) {
            (true, true) => self.low * 0.5 + self.high * 0.5,
            (true, false) => self.low,
            (false, true) => self.high,
            (false, false) => 0.0,
        }
    }
}

/// Something that happens to the curvature, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Event<T> {
    /// What happens.
    pub kind: EventKind,
    /// Where. On a closed curve an interval over the seam ends before it starts.
    pub place: Place<T>,
    /// The curvature just before the place and just after it; of an interval, at its start and at its end, from inside.
    pub curvature: [Bounds; 2],
    /// By which angle the direction turns here, of [`Corner`](EventKind::Corner) and [`Cusp`](EventKind::Cusp), from 0
    /// to π.
    pub turn: f64,
}
