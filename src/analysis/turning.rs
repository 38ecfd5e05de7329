//! How much a curve bends in all: the angle its direction runs through.
//!
//! On a piece the direction is that of `D`, a polynomial. By the formula of Crofton its path on the sphere of
//! directions is as long as the mean number of its crossings with great circles, and a great circle is crossed by the
//! directions of the Bernstein coefficients of `D` at least as often. So
//!
//! ```text
//! angle(D(a), D(b))  <=  ∫ |κ| ds  <=  Σ angle(d_i, d_(i+1))
//! ```
//!
//! and halving brings both together. In the plane they are equal as soon as the `d_i` turn one way by less than half a
//! turn.

use crate::analysis::analyse::sealed;
use crate::analysis::ball::Ball;
use crate::analysis::certify::Certified;
use crate::analysis::events::Bounds;
use crate::analysis::lifted::{Lifted, wedge};
use crate::error::{Error, Result};
use crate::exact::Q;
use crate::scalar::Scalar;
use crate::vector::{Crossed, dot};
use nalgebra::SVector;
use num_traits::{One, Zero};
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

/// How often pieces are halved at most, in all.
const HALVINGS: usize = 1 << 14;

/// How often a piece is halved at most: beyond, its bounds stay as they are.
const DEPTH: usize = 48;

impl<T: Certified, const N: usize, L: sealed::Liftable<T, N>> Turning<T, N> for L where
    SVector<T, N>: Crossed<T>
{
}

/// Total curvature and turning angle, enclosed, for [`Curve`](crate::Curve) and [`NurbsCurve`](crate::NurbsCurve)
/// alike.
pub trait Turning<T: Certified, const N: usize>: sealed::Liftable<T, N>
where
    SVector<T, N>: Crossed<T>,
{
    /// The total curvature `∫ |κ| ds` in radians, between bounds that are no further apart than `accuracy`.
    ///
    /// Corners and jumps at knots count nothing ([`profile`](crate::Analyse::profile) has them); a cusp inside a span
    /// counts `π`. The bounds are further apart where rounding or the limit of 16 384 halvings does not let them come
    /// closer.
    ///
    /// # Errors
    /// [`Error::BadTolerance`] unless `accuracy` is positive and finite; [`Error::TooLarge`], [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use std::f64::consts::TAU;
    /// use symspline::{Q, Scalar, Turning, circle};
    /// let circle = circle(&vector![Q::int(1), Q::int(2)], &Q::int(3))?;
    /// let total = circle.total_curvature(1e-9)?;
    /// assert!(total.low <= TAU && TAU <= total.high && total.high - total.low < 1e-9);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn total_curvature(&self, accuracy: f64) -> Result<Bounds> {
        if !accuracy.is_finite() || accuracy <= 0.0 {
            return Err(Error::BadTolerance { tolerance: accuracy.to_string() });
        }
        let mut open: BinaryHeap<Arc<N>> =
            directions(&self.to_lifted()?)?.into_iter().map(|(_, arc)| Arc::new(arc, 0)).collect();
        let (mut low, mut high) = (0.0, 0.0);
        let gap = |open: &BinaryHeap<Arc<N>>| open.iter().map(Arc::gap).sum::<f64>();
        let (mut left, mut until) = (gap(&open), 1);
        for halvings in 0..=HALVINGS {
            // The sum of gaps is kept by differences, and made anew now and then against rounding.
            if halvings == until {
                (left, until) = (gap(&open), until * 2);
            }
            if left <= accuracy || halvings == HALVINGS {
                break;
            }
            let Some(arc) = open.pop().filter(|arc| arc.gap() > 0.0) else { break };
            left -= arc.gap();
            if arc.depth == DEPTH {
                (low, high) = (low + arc.low, high + arc.high);
                continue;
            }
            for half in halves(&arc.directions) {
                let half = Arc::new(half, arc.depth + 1);
                left += half.gap();
                open.push(half);
            }
        }
        let count = open.len() as f64;
        let (low, high) = open.iter().fold((low, high), |(low, high), arc| (low + arc.low, high + arc.high));
        let rounding = 1.0 + (count + 2.0) * f64::EPSILON;
        Ok(Bounds { low: low / rounding, high: high * rounding })
    }

    /// The angle by which the direction of a plane curve turns from start to end, positive to the left, in radians.
    ///
    /// Corners and jumps at knots count nothing. Of a closed smooth curve it is a multiple of `2π`.
    ///
    /// # Errors
    /// [`Error::Stationary`] where the curve stands still inside a span, so that its direction may jump;
    /// [`Error::TooLarge`], [`Error::NotFinite`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, SplineSpace, Turning};
    /// // A quarter to the left, another to the right.
    /// let points = vec![vector![0.0, 0.0], vector![2.0, 0.0], vector![2.0, 2.0], vector![2.0, 4.0], vector![4.0, 4.0]];
    /// let bend = Curve::new(SplineSpace::clamped(2, [0.0, 1.0, 1.0, 2.0])?, points)?;
    /// let angle = bend.turning_angle()?;
    /// assert!(angle.low <= 0.0 && 0.0 <= angle.high && angle.high - angle.low < 1e-13);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    fn turning_angle(&self) -> Result<Bounds>
    where
        SVector<T, N>: Crossed<T, Product = T>,
    {
        let lifted = self.to_lifted()?;
        let ends = lifted.space().ends();
        let (mut low, mut high) = (0.0, 0.0);
        for (i, arc) in directions(&lifted)? {
            let mut open = vec![(arc, 0)];
            while let Some((arc, depth)) = open.pop() {
                if let Some([from, to]) = in_half_plane(&arc) {
                    let (angle, error) = angle(from, to);
                    let angle = if wedge(from, to)[2].middle() < 0.0 { -angle } else { angle };
                    (low, high) = (low + angle - error, high + angle + error);
                } else if depth == DEPTH {
                    return Err(Error::Stationary {
                        parameter: format!("between {} and {}", ends[i], ends[i + 1]),
                    });
                } else {
                    open.extend(halves(&arc).map(|half| (half, depth + 1)));
                }
            }
        }
        Ok(Bounds { low: low.next_down(), high: high.next_up() })
    }
}

/// Bernstein coefficients of directions.
type Directions<const N: usize> = Vec<SVector<Ball, N>>;

/// Directions known less well than to this part of their lengths are made again by exact numbers.
const LOOSE: f64 = 1e-10;

/// The Bernstein coefficients of the direction on every span where the curve moves, with the number of the span.
fn directions<T: Certified, const N: usize>(lifted: &Lifted<T, N>) -> Result<Vec<(usize, Directions<N>)>> {
    let moves = lifted.over(|x| Ok(x.ball())).and_then(|lifted| lifted.motion(1)?.direction()).ok();
    let mut all = Vec::new();
    for (i, k) in lifted.space().spans().enumerate() {
        let arc = match moves.as_ref().and_then(|moves| of_unit_size(moves.piece(i))) {
            Some(arc) => arc,
            None => exactly(lifted, k)?,
        };
        if !arc.iter().all(vanishes) {
            all.push((i, arc));
        }
    }
    Ok(all)
}

/// Directions in a unit near the size of the speed, so that its square stays in the range of floats; if all are known
/// well.
fn of_unit_size<const N: usize>(moves: &[SVector<Ball, N>]) -> Option<Directions<N>> {
    let size = moves.iter().flatten().fold(0.0_f64, |size, x| size.max(x.middle().abs()));
    let well = |c: &SVector<Ball, N>| vanishes(c) || spread(c) <= LOOSE;
    if size == 0.0 {
        return moves.iter().all(vanishes).then(|| moves.to_vec());
    }
    let unit = Ball::exact(size.log2().round().exp2());
    let moves: Directions<N> = moves.iter().map(|c| c.map(|x| x / unit)).collect();
    moves.iter().all(well).then_some(moves)
}

/// The directions on the span `k`, from exact numbers.
fn exactly<T: Certified, const N: usize>(lifted: &Lifted<T, N>, k: usize) -> Result<Directions<N>> {
    let moves = lifted.window(k, T::exact)?.motion(1)?.direction()?;
    let sizes = moves.piece(0).iter().flatten().map(Q::abs);
    let size = sizes.max().filter(|size| !size.is_zero()).unwrap_or_else(Q::one);
    Ok(moves.piece(0).iter().map(|c| c.map(|x| Ball::around(&(x / &size)))).collect())
}

fn vanishes<const N: usize>(c: &SVector<Ball, N>) -> bool {
    c.iter().all(Ball::is_zero)
}

/// The error of a vector as a part of its length.
fn spread<const N: usize>(c: &SVector<Ball, N>) -> f64 {
    let (size, radius) = c.iter().fold((0.0, 0.0), |(size, radius), x| {
        let middle = x.middle();
        (size + middle * middle, radius + x.radius())
    });
    radius / f64::sqrt(size)
}

/// The angle between two vectors, from 0 to π, and a bound of its error, also of the angle with the sign of its turn.
fn angle<const N: usize>(from: &SVector<Ball, N>, to: &SVector<Ball, N>) -> (f64, f64) {
    // A vector that is off by a part of its length turns by an angle with that sine.
    let spread = spread(from) + spread(to);
    if spread.is_nan() || spread >= 0.5 {
        return (0.0, PI);
    }
    let middles = |c: &SVector<Ball, N>| c.map(|x| x.middle()).normalize();
    let (from, to) = (middles(from), middles(to));
    (2.0 * (from - to).norm().atan2((from + to).norm()), 1.1 * spread + 8.0 * f64::EPSILON)
}

/// The directions at both ends, if all directions are in one open half-plane.
fn in_half_plane<const N: usize>(arc: &[SVector<Ball, N>]) -> Option<[&SVector<Ball, N>; 2]> {
    let mut moving = arc.iter().filter(|c| !vanishes(c));
    let first = moving.next()?;
    let last = moving.next_back().unwrap_or(first);
    let towards = arc.iter().fold(SVector::from_element(Ball::zero()), |sum: SVector<Ball, N>, c| sum + c);
    let towards = towards.map(|x| Ball::exact(x.middle()));
    let certain = |c: &&SVector<Ball, N>| dot(c, &towards).sign() == Some(Ordering::Greater);
    arc.iter().filter(|c| !vanishes(c)).all(|c| certain(&c)).then_some([first, last])
}

/// The Bernstein coefficients on both halves.
fn halves<const N: usize>(arc: &[SVector<Ball, N>]) -> [Vec<SVector<Ball, N>>; 2] {
    let (mut left, mut right, half) = (Vec::with_capacity(arc.len()), arc.to_vec(), Ball::frac(1, 2));
    for last in (0..arc.len()).rev() {
        left.push(right[0]);
        (0..last).for_each(|i| right[i] = (right[i] + right[i + 1]) * half);
    }
    [left, right]
}

/// A part of a path of directions, and between which bounds its length is.
struct Arc<const N: usize> {
    directions: Vec<SVector<Ball, N>>,
    depth: usize,
    low: f64,
    high: f64,
}

impl<const N: usize> Arc<N> {
    fn new(directions: Vec<SVector<Ball, N>>, depth: usize) -> Self {
        let moving: Vec<&SVector<Ball, N>> = directions.iter().filter(|c| !vanishes(c)).collect();
        let [mut low, mut high] = [0.0; 2];
        if let [first, .., last] = moving[..] {
            let (chord, error) = angle(first, last);
            low = (chord - error).max(0.0);
            let legs = moving.windows(2).map(|leg| angle(leg[0], leg[1]));
            high = legs.fold(0.0, |sum, (angle, error)| sum + (angle + error).min(PI));
        }
        Self { directions, depth, low, high }
    }

    /// How far apart the bounds are, but for what rounding makes of it.
    fn gap(&self) -> f64 {
        let gap = self.high - self.low;
        if gap > 64.0 * f64::EPSILON * self.directions.len() as f64 { gap } else { 0.0 }
    }
}

impl<const N: usize> Ord for Arc<N> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.gap().total_cmp(&other.gap())
    }
}

impl<const N: usize> PartialOrd for Arc<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const N: usize> PartialEq for Arc<N> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<const N: usize> Eq for Arc<N> {}
