//! Curvature profiles: where the curvature rises and falls, with all its events, proved.
//!
//! Three functions of the curve say it all: the squared speed (zero where the curve stands still), one with the sign of
//! the curvature, and one with the sign of its slope. Their zeros are found with a proof; at knots, where the curve is
//! less smooth than its derivatives ask for, both sides are compared exactly.

use crate::analysis::certify::condition::{Condition, What};
use crate::analysis::certify::{Certified, Course};
use crate::analysis::chain::{Mark, Marked, changes, marks};
use crate::analysis::events::{Event, EventKind};
use crate::analysis::joint::{Joint, joint};
use crate::analysis::lifted::Lifted;
use crate::analysis::measure::{Measure, Sample};
use crate::analysis::zeros::{Place, joined};
use crate::error::{Error, Result};
use crate::roots::RootValue;
use std::cmp::Ordering;
use std::f64::consts::PI;

/// A stretch on which the curvature rises, falls or stays as it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run<T> {
    /// Where it starts.
    pub start: RootValue<T>,
    /// Where it ends.
    pub end: RootValue<T>,
    /// `Greater` where the curvature rises, `Less` where it falls, `Equal` where it is constant.
    pub trend: Ordering,
}

/// The curvature of a curve along its parameter: signed in the plane, not negative in space.
///
/// Events and runs are proved: there are no others, and none of them is due to rounding or sampling. Over `f64` that is
/// said of the curve with just these numbers. Where they have been rounded, tiny jumps and corners are events too,
/// unless [`profile_within`](crate::Analyse::profile_within) is told to pass over them. Events nearer to each other
/// than rounding may change places.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Analyse, Curve, EventKind, SplineSpace};
/// let points = vec![vector![0.0, 0.0], vector![1.0, 2.0], vector![2.0, -2.0], vector![3.0, 0.0]];
/// let wave = Curve::new(SplineSpace::bezier(3, 0.0, 1.0)?, points)?.profile()?;
/// let kinds: Vec<EventKind> = wave.events().iter().map(|event| event.kind).collect();
/// assert_eq!(kinds, [EventKind::Minimum, EventKind::Inflection, EventKind::Maximum]);
/// let (low, high) = wave.events()[1].place.bounds();
/// assert!(*low <= 0.5 && 0.5 <= *high && high - low < 1e-12);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurvatureProfile<T> {
    domain: (T, T),
    events: Vec<Event<T>>,
    marks: Vec<Marked<T>>,
    samples: Vec<Sample>,
}

impl<T: Certified> CurvatureProfile<T> {
    /// Start and end of the domain.
    pub fn domain(&self) -> (&T, &T) {
        (&self.domain.0, &self.domain.1)
    }

    /// All events in the order of their places.
    pub fn events(&self) -> &[Event<T>] {
        &self.events
    }

    /// How many events of a kind there are.
    pub fn count(&self, kind: EventKind) -> usize {
        self.events.iter().filter(|event| event.kind == kind).count()
    }

    /// Curvatures to draw, ascending, as many for each span; at a knot there is one from each side. Nothing is proved
    /// of them. Where the curvature is not finite there is none.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// The scale of a comb nine of ten of whose teeth are no longer than `length`; zero for a straight curve.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, circle};
    /// let profile = circle(&vector![0.0, 0.0], &2.0)?.profile()?;
    /// assert!((profile.comb_scale(1.0) - 2.0).abs() < 1e-12);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn comb_scale(&self, length: f64) -> f64 {
        let mut sizes: Vec<f64> = self.samples.iter().map(|sample| sample.curvature.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let size = sizes.get(sizes.len() * 9 / 10).copied().unwrap_or(0.0);
        if size > 0.0 { length / size } else { 0.0 }
    }

    /// The logarithmic curvature graph: `log10 ρ` against `log10 |ρ ds/dρ|` with the radius `ρ = 1 / |κ|`, for every
    /// sample where both are finite and the curve is not straight.
    ///
    /// Of curves that please it is nearly straight; its slope is 1 for logarithmic spirals, 2 for involutes of circles
    /// and -1 for clothoids.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, Curve, SplineSpace};
    /// let points = vec![vector![1.0, 1.0], vector![1.5, 2.0], vector![2.0, 4.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, 1.0, 2.0)?, points)?.profile()?; // y = x²
    /// // ρ = (1 + 4x²)^(3/2) / 2 and ρ ds/dρ = (1 + 4x²)^(3/2) / (12 x).
    /// let [x, y] = parabola.log_log()[0];
    /// assert!((x - (5.0_f64.powf(1.5) / 2.0).log10()).abs() < 1e-12);
    /// assert!((y - (5.0_f64.powf(1.5) / 12.0).log10()).abs() < 1e-12);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn log_log(&self) -> Vec<[f64; 2]> {
        // Nothing is told from curvatures that are rounding beside the others.
        let largest = self.samples.iter().fold(0.0_f64, |most, sample| most.max(sample.curvature.abs()));
        let bent = self.samples.iter().filter(|sample| sample.curvature.abs() > 1e-9 * largest);
        // ds/dρ = -κ² ds/dκ.
        let point = |sample: &Sample| {
            [-sample.curvature.abs().log10(), (sample.curvature / sample.slope).abs().log10()]
        };
        bent.map(point).filter(|point| point.iter().all(|x| x.is_finite())).collect()
    }

    /// The stretches between events on which the curvature rises, falls or stays, in order, parted by jumps and by
    /// places where it is not defined.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use std::cmp::Ordering;
    /// use symspline::{Analyse, Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?.profile()?;
    /// let trends: Vec<Ordering> = parabola.runs().iter().map(|run| run.trend).collect();
    /// assert_eq!(trends, [Ordering::Greater, Ordering::Less]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn runs(&self) -> Vec<Run<T>> {
        let mut runs: Vec<Run<T>> = Vec::new();
        let last = RootValue::Exact(self.domain.1.clone());
        for (i, marked) in self.marks.iter().enumerate() {
            let Some(trend) = marked.after else { break };
            let end = self.marks.get(i + 1).map_or(&last, |next| &next.value).clone();
            match runs.last_mut() {
                Some(run) if run.trend == trend && marked.mark == Mark::Turn => run.end = end,
                _ => runs.push(Run { start: marked.value.clone(), end, trend }),
            }
        }
        runs
    }

    /// The trend of the curvature all over `[a, b]`: `Greater` if it is proved never to fall there and `Less` if never
    /// to rise, jumps included, `Equal` if it is constant; `None` if it has an extremum inside or is not defined
    /// somewhere.
    ///
    /// The proof is by the signs of the slope. Where an end is inside the enclosure of an extremum, there is none.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::EmptyDomain`] unless `a < b`.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use std::cmp::Ordering;
    /// use symspline::{Analyse, Curve, SplineSpace};
    /// let points = vec![vector![-1.0, 1.0], vector![0.0, -1.0], vector![1.0, 1.0]];
    /// let parabola = Curve::new(SplineSpace::bezier(2, -1.0, 1.0)?, points)?.profile()?;
    /// assert_eq!(parabola.trend_on(&-1.0, &-0.001)?, Some(Ordering::Greater));
    /// assert_eq!(parabola.trend_on(&-1.0, &0.5)?, None);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn trend_on(&self, a: &T, b: &T) -> Result<Option<Ordering>> {
        let (start, end) = self.domain();
        if let Some(x) = [a, b].into_iter().find(|x| !(*x >= start && *x <= end)) {
            let [parameter, start, end] = [x, start, end].map(T::to_string);
            return Err(Error::OutsideDomain { parameter, start, end });
        }
        if a >= b {
            return Err(Error::EmptyDomain { start: a.to_string(), end: b.to_string() });
        }
        let inside = |value: &RootValue<T>| value.bounds().1 > a && value.bounds().0 < b;
        let steps = self.marks.iter().filter(|marked| inside(&marked.value));
        let mut trends = Vec::new();
        for marked in steps {
            match marked.mark {
                Mark::Turn => {}
                Mark::Step(sign) => trends.push(sign),
                Mark::Cut => return Ok(None),
            }
        }
        let meets = |run: &Run<T>| run.end.bounds().1 > a && run.start.bounds().0 < b;
        trends.extend(self.runs().iter().filter(|run| meets(run)).map(|run| run.trend));
        trends.retain(|trend| *trend != Ordering::Equal);
        let first = trends.first().copied();
        Ok(match first {
            None => Some(Ordering::Equal),
            Some(first) => trends.iter().all(|trend| *trend == first).then_some(first),
        })
    }

    /// Where the sequences of events of two profiles first differ in kind, as an index of either; `None` if they are
    /// the same.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Analyse, circle, ellipse};
    /// let centre = vector![0.0, 0.0];
    /// let [long, short] = [3.0, 2.0].map(|x| ellipse(&centre, &vector![x, 0.0], &vector![0.0, 1.0]));
    /// assert_eq!(long?.profile()?.differs_at(&short?.profile()?), None);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn differs_at<U>(&self, other: &CurvatureProfile<U>) -> Option<usize> {
        let differs = |i: &usize| {
            self.events.get(*i).map(|event| event.kind) != other.events.get(*i).map(|event| event.kind)
        };
        (0..self.events.len().max(other.events.len())).find(differs)
    }
}

/// The profile of a curve, whose joints are looked at as [`joint`] says.
///
/// # Errors
/// [`Error::TooLarge`], [`Error::DegreeTooHigh`].
pub(crate) fn profile<T: Certified, const N: usize>(
    curve: Lifted<T, N>,
    tolerance: f64,
) -> Result<CurvatureProfile<T>> {
    let (space, domain) = (curve.space().clone(), curve.space().domain());
    let (ends, domain) = (space.ends(), (domain.0.clone(), domain.1.clone()));
    let condition = |what| Condition { curve: curve.clone(), what };
    let [speed, bend, slope] =
        [What::Speed, What::Bend, What::Slope].map(|what| T::courses(&condition(what)));
    let (speed, bend) = (speed?, bend?);
    let slope = parted(slope?, &speed);
    let joints = joints(&curve, &speed, tolerance)?;
    // A curve that ends where it starts is closed, whatever its space.
    let closed = !matches!(joints[0], Some(Joint::Gap));
    let stands = |i: usize, value: &RootValue<T>| {
        speed[i].inside.iter().any(|(still, _)| overlap(still.bounds(), value.bounds()))
    };
    let cut =
        |i: usize| joints[i].as_ref().is_some_and(|joint| !matches!(joint, Joint::Smooth | Joint::Jump(_)));
    let marks_of =
        |courses: &[Course<T>], mark: &dyn Fn(usize) -> Mark| marks(&ends, courses, closed, mark, stands);
    let rises = marks_of(&slope, &|i| match &joints[i] {
        _ if cut(i) => Mark::Cut,
        Some(Joint::Jump(up)) => Mark::Step(*up),
        _ => Mark::Turn,
    });
    let balls = Measure::new(&curve, &ends);
    let event = |kind, place: Place<T>| {
        let curvature = balls.around(&place, closed);
        Event { kind, place, curvature, turn: if kind == EventKind::Cusp { PI } else { 0.0 } }
    };
    let still = joined(&ends, &speed, closed);
    let mut events = Vec::new();
    let bends: Vec<Place<T>> = if N < 3 {
        let signs = marks_of(&parted(bend, &speed), &|i| if cut(i) { Mark::Cut } else { Mark::Turn });
        changes(&signs, closed).into_iter().map(|change| change.place).collect()
    } else {
        let vanishes = joined(&ends, &bend, closed).into_iter().map(|zero| zero.place);
        vanishes
            .filter(|place| !still.iter().any(|zero| overlap(zero.place.bounds(), place.bounds())))
            .collect()
    };
    for change in changes(&rises, closed) {
        let kind = if change.to == Ordering::Less { EventKind::Maximum } else { EventKind::Minimum };
        let hidden = N >= 3 && bends.iter().any(|place| overlap(place.bounds(), change.place.bounds()));
        events.extend((!hidden).then(|| event(kind, change.place)));
    }
    events.extend(bends.into_iter().map(|place| event(EventKind::Inflection, place)));
    for zero in still {
        // At knots the joints say more.
        let says = |joint: &Option<Joint>| joint.as_ref().is_some_and(|joint| *joint != Joint::Gap);
        let is_joint = |(t, joint): (&T, &Option<Joint>)| says(joint) && zero.place.bounds() == (t, t);
        if ends.iter().zip(&joints).any(is_joint) {
            continue;
        }
        let turns_back = zero.multiplicity % 4 == 2 && zero.before.is_some() && zero.after.is_some();
        let kind = if turns_back { EventKind::Cusp } else { EventKind::Stationary };
        events.push(event(kind, zero.place));
    }
    let stays = |i: usize| {
        let left = i.checked_sub(1).unwrap_or(speed.len() - 1);
        speed[left].signs[1] == Ordering::Equal && speed[i].signs[0] == Ordering::Equal
    };
    for (i, (t, joint)) in ends.iter().zip(&joints).enumerate() {
        let (kind, turn) = match joint {
            None | Some(Joint::Smooth) => continue,
            Some(Joint::Jump(_)) => (EventKind::Jump, 0.0),
            // Said of the whole stretch already.
            Some(Joint::Still) if stays(i) => continue,
            Some(Joint::Still) => (EventKind::Stationary, 0.0),
            Some(Joint::Back) => (EventKind::Cusp, PI),
            Some(Joint::Corner(turn)) => (EventKind::Corner, *turn),
            Some(Joint::Gap) if i == 0 && !space.is_periodic() => continue,
            Some(Joint::Gap) => (EventKind::Gap, 0.0),
        };
        events.push(Event { turn, ..event(kind, Place::At(RootValue::Exact(t.clone()))) });
    }
    events.sort_by(|one, other| {
        one.place.bounds().partial_cmp(&other.place.bounds()).expect("parameters are ordered")
    });
    Ok(CurvatureProfile { domain, events, marks: rises, samples: balls.samples() })
}

/// The courses of a function with marks where the curve stands still inside spans on which the function vanishes, too.
fn parted<T: Clone>(mut courses: Vec<Course<T>>, speed: &[Course<T>]) -> Vec<Course<T>> {
    for (course, speed) in courses.iter_mut().zip(speed) {
        if course.signs[0] == Ordering::Equal {
            course.inside = speed.inside.clone();
        }
    }
    courses
}

/// How the curve goes on at each end of a span, where it may be less than smooth; at the start from the end of the
/// domain.
fn joints<T: Certified, const N: usize>(
    curve: &Lifted<T, N>,
    speed: &[Course<T>],
    tolerance: f64,
) -> Result<Vec<Option<Joint>>> {
    let space = curve.space();
    let (spans, breaks): (Vec<usize>, _) = (space.spans().collect(), space.breaks());
    let count = spans.len();
    let at = |i: usize| -> Result<Option<Joint>> {
        let left = i.checked_sub(1).unwrap_or(count - 1);
        if i == count {
            return Ok(None);
        }
        let stands = speed[left].at_ends[1] > 0 || speed[i].at_ends[0] > 0;
        let is_ring = i > 0 || space.is_periodic();
        if is_ring && space.degree() >= breaks[i].1 + 2 && !stands {
            return Ok(None);
        }
        joint(curve, [spans[left], spans[i]], tolerance).map(Some)
    };
    (0..=count).map(at).collect()
}

/// Whether two intervals have a parameter in common.
fn overlap<T: PartialOrd>((a, b): (&T, &T), (c, d): (&T, &T)) -> bool {
    a <= d && c <= b
}
