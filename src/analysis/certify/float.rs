//! Courses of functions over `f64`, by balls where these decide.

use crate::analysis::ball::Ball;
use crate::analysis::certify::condition::Condition;
use crate::analysis::certify::{Course, course, sealed};
use crate::error::Result;
use crate::exact::Q;
use crate::roots::float::enclosed_roots;
use crate::roots::{Polynomial, RootValue};
use std::cmp::Ordering;

/// How often a piece is halved before exact numbers take over.
const DEPTH: usize = 12;

impl sealed::Engine for f64 {
    fn exact(&self) -> Result<Q> {
        Q::try_from(*self)
    }

    fn ball(&self) -> Ball {
        Ball::exact(*self)
    }

    fn courses<const N: usize>(condition: &Condition<Self, N>) -> Result<Vec<Course<Self>>> {
        // What overflows is left to exact numbers as well.
        let function =
            condition.over(|x| Ok(Ball::exact(*x))).and_then(|condition| condition.function()).ok();
        let by_balls = |i: usize| isolated(&function.as_ref()?.polynomial(i).ok()?);
        let piece = |(i, k): (usize, usize)| match by_balls(i) {
            Some(course) => Ok(course),
            None => exactly(condition, k),
        };
        condition.curve.space().spans().enumerate().map(piece).collect()
    }
}

/// The course of a function on the span `k`, by exact numbers.
fn exactly<const N: usize>(condition: &Condition<f64, N>, k: usize) -> Result<Course<f64>> {
    let function = condition.window(k, |x| Q::try_from(*x))?.function()?;
    Ok(course(&function.polynomial(0)?, enclosed_roots))
}

/// The course of a polynomial if its coefficients are known well enough.
fn isolated(polynomial: &Polynomial<Ball>) -> Option<Course<f64>> {
    let c = polynomial.coeffs();
    let signs = [c[0].sign()?, c[c.len() - 1].sign()?];
    if signs.contains(&Ordering::Equal) {
        return None;
    }
    let mut inside = Vec::new();
    let mut open = vec![(polynomial.clone(), DEPTH)];
    while let Some((part, depth)) = open.pop() {
        match variations(&part) {
            Some(0) => {}
            Some(1) => inside.push((narrowed(&part), 1)),
            _ => {
                let (left, right) = halves(&part, depth)?;
                open.extend([(right, depth - 1), (left, depth - 1)]);
            }
        }
    }
    Some(Course { signs, at_ends: [0, 0], inside })
}

/// The parts on both sides of a float near the middle that is certainly no zero.
fn halves(part: &Polynomial<Ball>, depth: usize) -> Option<(Polynomial<Ball>, Polynomial<Ball>)> {
    let (a, b) = (part.domain().0.middle(), part.domain().1.middle());
    let cuts = [0.5, 0.4375, 0.5625].into_iter().filter(|_| depth > 0).map(|share| a + (b - a) * share);
    cuts.filter(|x| a < *x && *x < b).find_map(|x| {
        let (left, right) = part.split_inside(&Ball::exact(x));
        certain(&right.coeffs()[0]).map(|_| (left, right))
    })
}

/// The sign of a ball without zero.
fn certain(c: &Ball) -> Option<Ordering> {
    c.sign().filter(|sign| *sign != Ordering::Equal)
}

/// The sign variations of the coefficients, if they are certain. The signs at the ends are.
fn variations(part: &Polynomial<Ball>) -> Option<usize> {
    let (mut count, mut last, mut unknown) = (0, None, 0);
    for c in part.coeffs() {
        match c.sign() {
            Some(Ordering::Equal) => {}
            None => unknown += 1,
            Some(sign) => {
                let changes = last.is_some_and(|last| last != sign);
                // One unknown sign between two that differ makes no more changes.
                if unknown > usize::from(changes) {
                    return None;
                }
                count += usize::from(changes);
                (last, unknown) = (Some(sign), 0);
            }
        }
    }
    Some(count)
}

/// The one zero of a polynomial whose signs at the ends are certain and differ, between floats with certain signs.
fn narrowed(part: &Polynomial<Ball>) -> RootValue<f64> {
    let (a, b) = (part.domain().0.middle(), part.domain().1.middle());
    let first = part.coeffs()[0].sign();
    let sign = |x: f64| {
        // The cheap value first; where that does not decide, the one by means alone.
        let x = Ball::exact(x);
        certain(&part.at(&x)).or_else(|| certain(&part.split_inside(&x).1.coeffs()[0]))
    };
    let near = near(part, a, b);
    let ulp = (near.abs() * f64::EPSILON).max((b - a) * 1e-16).max(f64::MIN_POSITIVE);
    let side = |is_low: bool| {
        let mut step = ulp;
        loop {
            let x = if is_low { near - step } else { near + step };
            match (is_low, x) {
                (true, x) if x <= a => return a,
                (false, x) if x >= b => return b,
                _ if sign(x).is_some_and(|sign| (Some(sign) == first) == is_low) => return x,
                _ => step *= 4.0,
            }
        }
    };
    RootValue::Enclosed(side(true), side(false))
}

/// A float near the zero, by the middles of the coefficients.
fn near(part: &Polynomial<Ball>, a: f64, b: f64) -> f64 {
    let c: Vec<f64> = part.coeffs().iter().map(Ball::middle).collect();
    let Ok(rounded) = Polynomial::new(a, b, c) else { return a + (b - a) * 0.5 };
    let (mut low, mut high) = (a, b);
    let (mut below, mut above) = (rounded.coeffs()[0], rounded.coeffs()[rounded.coeffs().len() - 1]);
    // Regula falsi, its weaker end halved (Illinois), with a bisection now and then.
    for step in 0..60 {
        let secant = low + (high - low) * (below / (below - above));
        let x =
            if step % 4 == 3 || !(low < secant && secant < high) { low * 0.5 + high * 0.5 } else { secant };
        if !(low < x && x < high) {
            break;
        }
        let value = rounded.at(&x);
        if value == 0.0 {
            return x;
        }
        if (value > 0.0) == (below > 0.0) {
            (low, below, above) = (x, value, above * 0.5);
        } else {
            (high, above, below) = (x, value, below * 0.5);
        }
        if high - low <= f64::EPSILON * x.abs() {
            break;
        }
    }
    low * 0.5 + high * 0.5
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;

    #[test]
    fn signs_that_are_not_certain_count_only_where_they_do_not_matter() {
        // A third less a third may be anything near zero.
        let unknown = Ball::frac(1, 3) - Ball::frac(1, 3);
        let count = |c: &[Option<i64>]| {
            let c = c.iter().map(|c| c.map_or(unknown, Ball::int)).collect();
            variations(&Polynomial::new(Ball::int(0), Ball::int(1), c).unwrap())
        };
        assert_eq!(count(&[Some(1), Some(-1), Some(0), Some(2)]), Some(2));
        assert_eq!(count(&[Some(1), None, Some(-1)]), Some(1));
        assert_eq!(count(&[Some(1), None, Some(1)]), None);
        assert_eq!(count(&[Some(1), None, None, Some(-1)]), None);
        assert_eq!(count(&[Some(1), None, Some(-1), None, Some(1)]), Some(2));
    }
}
