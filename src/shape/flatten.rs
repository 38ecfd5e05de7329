//! Flattening: control points projected onto a line or plane, so that a part of a curve becomes straight, of a surface
//! plane [NURBS, section 11.4.2].
//!
//! Rules say which control points are projected, and others which projections are accepted. A span is flat when all control
//! points with influence there lie on the line or plane: `p + 1` consecutive ones of a curve, a grid of `(p + 1) × (q + 1)`
//! of a surface.

use crate::coeff::Coeff;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::flatten_region::{Part, in_polygon};
use crate::shape::onto::{Onto, Side};
use crate::shape::polygon::check_finite;
use crate::shape::region::Refinement;
use crate::shape::supports::Supports;
use crate::tensor::along::Direction;
use crate::vector::dot;
use nalgebra::SVector;

/// Which control points are projected by their influence.
#[derive(Clone, Debug, PartialEq)]
enum Reach<T> {
    All,
    /// Those without influence outside.
    Local(Part<T>),
    /// Those with influence inside.
    Whole(Part<T>),
}

impl<T> Reach<T> {
    fn part(&self) -> Option<&Part<T>> {
        match self {
            Self::All => None,
            Self::Local(part) | Self::Whole(part) => Some(part),
        }
    }
}

/// Which projections are accepted by their place.
#[derive(Clone, Debug, PartialEq)]
enum Accept<T, const N: usize> {
    Between(SVector<T, N>, SVector<T, N>),
    Polygon(Vec<SVector<T, N>>),
    Ball(SVector<T, N>, T),
}

/// Flattens curves and surfaces, polynomial and rational, onto a line or plane.
///
/// # Examples
/// Few control points are not enough for a cubic to become straight; more knots make it so.
/// ```
/// use nalgebra::vector;
/// use symspline::{Curve, Flatten, Onto, Q, Refinement, Scalar, ShapeError, SplineSpace};
/// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
/// let space = SplineSpace::clamped(3, [0, 1, 2, 3].map(Q::int))?;
/// let curve = Curve::new(space, vec![q(0, 0), q(1, 2), q(2, 3), q(4, 3), q(5, 2), q(6, 0)])?;
/// let cut = Flatten::new(Onto::line(q(0, 1), q(1, 0))?).local_to((Q::frac(1, 2), Q::frac(5, 2)));
/// assert!(cut.apply(&curve)?.flat.is_empty());
/// let done = cut.refined(Refinement::Count(8)).apply(&curve)?;
/// let (start, end) = done.flat[0][0].clone();
/// assert_eq!((start.clone(), end.clone()), (Q::frac(7, 8), Q::frac(7, 4)));
/// let straight = done.shape.restricted(&start, &end)?;
/// assert!(straight.coeffs().iter().all(|c| c[1] == Q::int(1)));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Flatten<T, const N: usize> {
    onto: Onto<T, N>,
    reach: Reach<T>,
    side: Option<Side>,
    /// Points and normals of planes; control points in front of all of them are projected.
    fronts: Vec<(SVector<T, N>, SVector<T, N>)>,
    accept: Vec<Accept<T, N>>,
    refinement: Option<Refinement<T>>,
    limit: Option<usize>,
}

/// What flattening made.
#[derive(Clone, Debug, PartialEq)]
pub struct Flattened<T, S> {
    /// The shape.
    pub shape: S,
    /// The control points that were replaced by their projections, as places in the list.
    pub projected: Vec<usize>,
    /// The parts that are flat, disjoint: of each from where to where, direction by direction. Over an exact field there are no
    /// others. They are cut at knots, and at the seam of a ring.
    pub flat: Vec<Vec<(T, T)>>,
    /// The least interval or rectangle outside of which nothing changed; none if nothing changed at all.
    pub changed: Option<Vec<(T, T)>>,
}

impl<T: Scalar, const N: usize> Flatten<T, N> {
    /// Projects every control point.
    pub fn new(onto: Onto<T, N>) -> Self {
        Self {
            onto,
            reach: Reach::All,
            side: None,
            fronts: Vec::new(),
            accept: Vec::new(),
            refinement: None,
            limit: None,
        }
    }

    /// Projects control points without influence outside `part`: nothing changes there.
    pub fn local_to(self, part: impl Into<Part<T>>) -> Self {
        Self { reach: Reach::Local(part.into()), ..self }
    }

    /// Projects control points with influence inside `part`, so that all of it becomes flat if no other rule forbids it. The
    /// shape changes up to `p` spans farther; [`Flattened::changed`] says how far.
    pub fn whole(self, part: impl Into<Part<T>>) -> Self {
        Self { reach: Reach::Whole(part.into()), ..self }
    }

    /// Projects control points strictly on this side of the line or plane only.
    pub fn on_side(self, side: Side) -> Self {
        Self { side: Some(side), ..self }
    }

    /// Projects control points in front of the plane (in the plane: line) through `origin` across `normal` only; may be
    /// called for several planes.
    pub fn in_front_of(mut self, origin: SVector<T, N>, normal: SVector<T, N>) -> Self {
        self.fronts.push((origin, normal));
        self
    }

    /// Accepts projections between the planes through `a` and `b` across `b - a`: on a line those within the segment from `a`
    /// to `b`.
    pub fn within_segment(mut self, a: SVector<T, N>, b: SVector<T, N>) -> Self {
        self.accept.push(Accept::Between(a, b));
        self
    }

    /// Accepts projections inside a polygon of the plane by the even-odd rule, edges included.
    pub fn within_polygon(mut self, corners: Vec<SVector<T, N>>) -> Self {
        self.accept.push(Accept::Polygon(corners));
        self
    }

    /// Accepts projections no farther from `centre` than `radius`: within a disc of the plane.
    pub fn within_ball(mut self, centre: SVector<T, N>, radius: T) -> Self {
        self.accept.push(Accept::Ball(centre, radius));
        self
    }

    /// Inserts knots first: in the part if one is given, everywhere else.
    pub fn refined(self, refinement: Refinement<T>) -> Self {
        Self { refinement: Some(refinement), ..self }
    }

    /// Refuses a result that is flat nowhere in the part, if one is given, and where control points were projected, after halving
    /// spans near those as long as there are no more than `most` control points.
    pub fn until_flat(self, most: usize) -> Self {
        Self { limit: Some(most), ..self }
    }

    /// The flattened shape.
    ///
    /// # Errors
    /// [`ShapeError::OtherParameters`] for a part of the wrong kind; [`ShapeError::NoSides`] if a rule needs a plane and there
    /// is a line in space; [`ShapeError::NoDirection`]; [`ShapeError::NotFlat`]; [`Error::OutsideDomain`] or
    /// [`Error::EmptyDomain`] for a part that is not in the domain; [`Error::Weight`]; [`Error::NotFinite`] on overflow; those
    /// of [`Refinement`]; [`Error::TooFewPoints`] for a polygon of fewer than three corners; [`Error::BadTolerance`] for the radius of
    /// a ball that is negative or not finite.
    pub fn apply<S: Controlled<T, Point = SVector<T, N>>>(&self, shape: &S) -> Result<Flattened<T, S>> {
        let bounds = self.bounds(shape)?;
        self.check()?;
        let mut current = shape.clone();
        if let Some(refinement) = &self.refinement {
            for (direction, (start, end)) in S::DIRECTIONS.iter().zip(&bounds) {
                current = refinement.of(&current, *direction, start, end)?;
            }
        }
        loop {
            let attempt = self.attempt(&current)?;
            let supports = Supports::of(&current);
            let Some(limit) = self.limit.filter(|_| !self.is_done(&attempt, &supports)) else {
                return Ok(attempt);
            };
            let mut finer = current.clone();
            for (k, direction) in S::DIRECTIONS.iter().enumerate() {
                let knots = middles(&supports.spans_of(k, &attempt.projected), &bounds[k]);
                finer = finer.inserted_along(*direction, &knots)?;
            }
            let count = current.control_count();
            if finer.control_count() > limit || finer.control_count() == count {
                return Err(ShapeError::NotFlat { count, limit }.into());
            }
            current = finer;
        }
    }

    /// Whether something is flat where it should be, and by the projections if there are any.
    fn is_done<S>(&self, attempt: &Flattened<T, S>, supports: &Supports<T>) -> bool {
        attempt.flat.iter().any(|flat| {
            let other = || (T::zero(), T::one());
            let extent = [flat[0].clone(), flat.get(1).cloned().unwrap_or_else(other)];
            let wanted = self.reach.part().is_none_or(|part| part.meets(&extent));
            wanted && (attempt.projected.is_empty() || supports.reach_into(&attempt.projected, &extent))
        })
    }

    /// From where to where knots may be inserted, direction by direction.
    fn bounds<S: Controlled<T>>(&self, shape: &S) -> Result<Vec<(T, T)>> {
        let domain = |d: &Direction| {
            let (a, b) = shape.space_along(*d).domain();
            (a.clone(), b.clone())
        };
        let Some(part) = self.reach.part() else { return Ok(S::DIRECTIONS.iter().map(domain).collect()) };
        if matches!(part, Part::Interval(..)) != (S::DIRECTIONS.len() == 1) {
            return Err(ShapeError::OtherParameters.into());
        }
        if let Part::Polygon(corners) = part
            && !corners.is_empty()
        {
            enough(corners.len())?;
            check_finite(&corners.iter().cloned().map(<(T, T)>::from).collect::<Vec<_>>())?;
        }
        let named = matches!(part, Part::Interval(..) | Part::Rectangle(..));
        let extent = part.bounds().ok_or(ShapeError::OtherParameters)?;
        let clipped = |(direction, (start, end)): (&Direction, (T, T))| {
            let space = shape.space_along(*direction);
            if named {
                space.locate(&start)?;
                space.locate(&end)?;
            }
            let (a, b) = space.domain();
            let start = if start < *a { a.clone() } else { start };
            let end = if end > *b { b.clone() } else { end };
            if start < end {
                Ok((start, end))
            } else {
                Err(Error::EmptyDomain { start: start.to_string(), end: end.to_string() })
            }
        };
        S::DIRECTIONS.iter().zip(extent).map(clipped).collect()
    }

    /// Refuses rules that make no sense.
    fn check(&self) -> Result<()> {
        let needs_plane =
            self.side.is_some() || self.accept.iter().any(|rule| matches!(rule, Accept::Polygon(_)));
        if needs_plane {
            self.onto.normal()?;
        }
        for rule in &self.accept {
            match rule {
                Accept::Between(a, b) if a == b => {
                    return Err(ShapeError::NoDirection { what: "segment" }.into());
                }
                Accept::Between(a, b) => all_finite("segment", [a, b])?,
                Accept::Polygon(corners) => {
                    enough(corners.len())?;
                    all_finite("corner", corners)?;
                }
                Accept::Ball(centre, radius) => {
                    all_finite("centre", [centre])?;
                    if !radius.is_finite() || *radius < T::zero() {
                        return Err(Error::BadTolerance { tolerance: radius.to_string() });
                    }
                }
            }
        }
        if self.fronts.iter().any(|(_, normal)| normal.vanishes()) {
            return Err(ShapeError::NoDirection { what: "normal" }.into());
        }
        all_finite("plane", self.fronts.iter().flat_map(|(origin, normal)| [origin, normal]))
    }

    /// Whether a control point is one to project, by its place.
    fn picks(&self, point: &SVector<T, N>) -> Result<bool> {
        let on_side = match self.side {
            None => true,
            Some(Side::Positive) => self.onto.height(point)? > T::zero(),
            Some(Side::Negative) => self.onto.height(point)? < T::zero(),
        };
        let in_front =
            |(origin, normal): &(SVector<T, N>, SVector<T, N>)| dot(&point.minus(origin), normal) > T::zero();
        Ok(on_side && self.fronts.iter().all(in_front))
    }

    /// Whether a projection is accepted.
    fn accepts(&self, point: &SVector<T, N>) -> Result<bool> {
        for rule in &self.accept {
            let accepted = match rule {
                Accept::Between(a, b) => {
                    let (way, done) = (b.minus(a), point.minus(a));
                    let share = dot(&done, &way);
                    T::zero() <= share && share <= way.squared_size()
                }
                Accept::Ball(centre, radius) => point.minus(centre).squared_size() <= radius.clone() * radius,
                Accept::Polygon(corners) => {
                    let axes = plane_axes(self.onto.normal()?);
                    let seen = |c: &SVector<T, N>| axes.map(|k| c[k].clone());
                    in_polygon(&corners.iter().map(seen).collect::<Vec<_>>(), &seen(point))
                }
            };
            if !accepted {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The shape with the control points projected that the rules name.
    fn attempt<S: Controlled<T, Point = SVector<T, N>>>(&self, shape: &S) -> Result<Flattened<T, S>> {
        let supports = Supports::of(shape);
        let in_reach = |i: usize| match &self.reach {
            Reach::All => true,
            Reach::Local(part) => supports.within(i, part),
            Reach::Whole(part) => supports.meets(i, part),
        };
        let (mut projected, mut moves, mut on) = (Vec::new(), Vec::new(), Vec::new());
        for i in 0..shape.control_count() {
            let point = shape.control_point(i)?;
            let image = self.onto.projected(&point);
            let chosen = in_reach(i) && self.picks(&point)? && self.accepts(&image)?;
            on.push(chosen || self.onto.holds(&point));
            if chosen {
                projected.push(i);
                if image != point {
                    moves.push((i, image.minus(&point)));
                }
            }
        }
        let changed = supports.around(moves.iter().map(|(i, _)| *i));
        let mut shape = shape.clone();
        shape.move_points(&moves)?;
        Ok(Flattened { shape, projected, flat: supports.covered(&on), changed })
    }
}

/// Refuses polygons of fewer than three corners.
fn enough(found: usize) -> Result<()> {
    if found < 3 { Err(Error::TooFewPoints { expected: 3, found }) } else { Ok(()) }
}

/// Refuses vectors that are not finite.
fn all_finite<'a, T: Scalar, const N: usize>(
    what: &'static str,
    vectors: impl IntoIterator<Item = &'a SVector<T, N>>,
) -> Result<()> {
    match vectors.into_iter().position(|v| !v.all_finite()) {
        Some(index) => Err(Error::NotFinite { what, index }),
        None => Ok(()),
    }
}

/// The two axes along which a plane is seen best, across the largest part of its normal.
fn plane_axes<T: Scalar, const N: usize>(normal: &SVector<T, N>) -> [usize; 2] {
    let steepest = (0..N).fold(0, |k, i| if normal[i].magnitude() > normal[k].magnitude() { i } else { k });
    match (N, steepest) {
        (3, 0) => [1, 2],
        (3, 1) => [0, 2],
        _ => [0, 1],
    }
}

/// The middles of what some spans have within bounds, none of which is a knot.
fn middles<T: Scalar>(spans: &[(T, T)], (start, end): &(T, T)) -> Vec<T> {
    let middle = |(a, b): &(T, T)| {
        let (a, b) = (if a < start { start } else { a }, if b > end { end } else { b });
        let middle = a.clone() + (b.clone() - a) / T::int(2);
        (*a < middle && middle < *b).then_some(middle)
    };
    spans.iter().filter_map(middle).collect()
}
