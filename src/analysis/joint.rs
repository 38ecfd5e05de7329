//! How a curve goes on at a knot: position, direction and curvature from both sides, compared exactly.
//!
//! Near an end of a span the derivative has the direction of its outermost Bernstein coefficient that is not zero, so a
//! curve that stands still at a knot has a direction there too.

use crate::analysis::certify::sealed::Engine;
use crate::analysis::lifted::{Across, Lifted, wedge};
use crate::error::Result;
use crate::exact::Q;
use crate::vector::dot;
use nalgebra::SVector;
use num_traits::{One, Zero};
use std::cmp::Ordering;

/// How two spans meet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Joint {
    /// With one position, direction and value of the curvature.
    Smooth,
    /// The curvature jumps, up or down.
    Jump(Ordering),
    /// The curve stands still on one side at least, but goes on in its direction.
    Still,
    /// The direction turns back.
    Back,
    /// The direction turns by this angle.
    Corner(f64),
    /// The position jumps.
    Gap,
}

/// What a curve is like at one end of a span.
struct End<const N: usize> {
    point: SVector<Q, N>,
    weight: Q,
    /// `D`, and the direction, which is that of `D` unless `D` vanishes there; none of a point.
    velocity: SVector<Q, N>,
    direction: Option<SVector<Q, N>>,
    bend: Across<Q>,
}

/// How the spans `left` and `right` of a curve meet. An angle of the directions, or a jump of the curvature in
/// proportion to its size, that is not above `tolerance` counts for nothing.
///
/// # Errors
/// [`Error::TooLarge`](crate::Error::TooLarge).
pub(crate) fn joint<T: Engine, const N: usize>(
    curve: &Lifted<T, N>,
    [left, right]: [usize; 2],
    tolerance: f64,
) -> Result<Joint> {
    let [before, after] = [end(curve, left, true)?, end(curve, right, false)?];
    // Points are weighted.
    if before.point.map(|x| x * &after.weight) != after.point.map(|x| x * &before.weight) {
        return Ok(Joint::Gap);
    }
    let (Some(from), Some(to)) = (&before.direction, &after.direction) else { return Ok(Joint::Still) };
    let (across, along) = (wedge(from, to), dot(from, to));
    let turn = if across.iter().all(Q::is_zero) { 0.0 } else { angle(&across, &along) };
    if turn > tolerance {
        return Ok(Joint::Corner(turn));
    }
    if along.is_negative() {
        return Ok(Joint::Back);
    }
    if [&before, &after].iter().any(|end| end.velocity.iter().all(Q::is_zero)) {
        return Ok(Joint::Still);
    }
    let squares = [signed_square(&before), signed_square(&after)];
    let order = squares[1].cmp(&squares[0]);
    let [one, other] = squares.map(|square| square.to_f64().signum() * square.to_f64().abs().sqrt());
    let tiny = (one - other).abs() <= tolerance * one.abs().max(other.abs());
    Ok(if order == Ordering::Equal || tolerance > 0.0 && tiny { Joint::Smooth } else { Joint::Jump(order) })
}

/// The angle between two directions that are not parallel, from their products: above 0, however small it is.
fn angle(across: &Across<Q>, along: &Q) -> f64 {
    let size = across.iter().map(Q::abs).fold(along.abs(), |size, x| if x > size { x } else { size });
    let part = |x: &Q| (x / &size).to_f64();
    let sine = across.iter().map(part).fold(0.0, f64::hypot);
    sine.atan2(part(along)).max(f64::MIN_POSITIVE)
}

fn end<T: Engine, const N: usize>(curve: &Lifted<T, N>, span: usize, is_last: bool) -> Result<End<N>> {
    let motion = curve.window(span, T::exact)?.motion(2)?;
    fn outermost<C: Clone>(coeffs: &[C], is_last: bool) -> C {
        coeffs[if is_last { coeffs.len() - 1 } else { 0 }].clone()
    }
    let moves = motion.direction()?;
    let mut inwards = moves.piece(0).to_vec();
    if is_last {
        inwards.reverse();
    }
    Ok(End {
        point: outermost(motion.points().piece(0), is_last),
        weight: motion.weights().map_or_else(Q::one, |weights| outermost(weights.piece(0), is_last)),
        velocity: inwards[0].clone(),
        direction: inwards.into_iter().find(|c| !c.iter().all(Q::is_zero)),
        bend: outermost(motion.bend()?.piece(0), is_last),
    })
}

/// The squared curvature, in the plane with the sign of the curvature.
fn signed_square<const N: usize>(end: &End<N>) -> Q {
    let weight = end.weight.clone() * &end.weight * &end.weight;
    let speed = dot(&end.velocity, &end.velocity);
    let square = dot(&end.bend, &end.bend) * &weight * &weight / (speed.clone() * &speed * &speed);
    if N < 3 && end.bend[2].is_negative() { -square } else { square }
}
