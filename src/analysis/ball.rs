//! Numbers known up to an error: a float, and a bound of how far from it the number is.
//!
//! Every operation bounds its own rounding, so that a text written over [`Scalar`] proves what it computes when it runs
//! over balls. Balls compare by their middles, which is right for knots, whose radius is zero; signs are told by
//! [`sign`](Ball::sign) only where the whole ball has them.

use crate::exact::Q;
use crate::scalar::Scalar;
use num_traits::{One, Zero};
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Half a unit in the last place of one: the relative error of one rounding.
const HALF_ULP: f64 = f64::EPSILON / 2.0;

/// Makes up for the roundings of radii themselves, a few each time.
const SLACK: f64 = 1.0 + 16.0 * f64::EPSILON;

/// Makes up for underflow.
const LEAST: f64 = 4.0 * f64::from_bits(1);

/// All numbers `x` with `|x - middle| <= radius`; a middle or radius that is not finite tells nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    middle: f64,
    radius: f64,
}

impl Ball {
    /// All numbers.
    pub(crate) const UNKNOWN: Self = Self { middle: f64::NAN, radius: f64::INFINITY };

    /// The number `x`.
    pub(crate) fn exact(x: f64) -> Self {
        Self { middle: x, radius: 0.0 }
    }

    /// A ball around `q`.
    pub(crate) fn around(q: &Q) -> Self {
        let middle = q.to_f64();
        if Q::try_from(middle).is_ok_and(|x| x == *q) { Self::exact(middle) } else { Self::rounded(middle) }
    }

    /// The ball that holds `low` and `high`.
    pub(crate) fn between(low: f64, high: f64) -> Self {
        if low == high {
            return Self::exact(low);
        }
        let middle = low * 0.5 + high * 0.5;
        Self { middle, radius: larger((high - middle).next_up(), (middle - low).next_up()) }
    }

    /// The ball around a number that rounds to `middle`.
    fn rounded(middle: f64) -> Self {
        Self { middle, radius: middle.abs() * f64::EPSILON + LEAST }
    }

    /// Lower and upper bound of all its numbers.
    pub(crate) fn bounds(&self) -> (f64, f64) {
        if self.radius == 0.0 {
            return (self.middle, self.middle);
        }
        match self.is_finite() {
            true => ((self.middle - self.radius).next_down(), (self.middle + self.radius).next_up()),
            false => (f64::NEG_INFINITY, f64::INFINITY),
        }
    }

    /// The sign all its numbers have.
    pub(crate) fn sign(&self) -> Option<Ordering> {
        match self {
            Self { middle, radius } if middle > radius => Some(Ordering::Greater),
            Self { middle, radius } if -middle > *radius => Some(Ordering::Less),
            Self { middle: 0.0, radius: 0.0 } => Some(Ordering::Equal),
            _ => None,
        }
    }

    /// The middle.
    pub(crate) fn middle(&self) -> f64 {
        self.middle
    }

    /// How far from the middle its numbers are at most.
    pub(crate) fn radius(&self) -> f64 {
        self.radius
    }

    /// The square roots of its numbers that are not negative.
    pub(crate) fn root(&self) -> Self {
        let (low, high) = self.bounds();
        match low > 0.0 {
            true => Self::between(low.sqrt().next_down(), high.sqrt().next_up()),
            false => Self::between(0.0, high.sqrt().next_up()),
        }
    }

    fn plus(self, other: Self) -> Self {
        // The rounding of a sum is a float, found without error.
        let middle = self.middle + other.middle;
        let part = middle - self.middle;
        let lost = (self.middle - (middle - part)) + (other.middle - part);
        let radius = self.radius + other.radius + lost.abs();
        Self { middle, radius: if radius == 0.0 { 0.0 } else { radius * SLACK } }
    }

    fn times(self, other: Self) -> Self {
        let middle = self.middle * other.middle;
        if self.is_zero() || other.is_zero() {
            return Self::exact(if middle.is_nan() { middle } else { 0.0 });
        }
        let spread = self.middle.abs() * other.radius + self.radius * (other.middle.abs() + other.radius);
        Self { middle, radius: (spread + middle.abs() * HALF_ULP) * SLACK + LEAST }
    }

    fn over(self, other: Self) -> Self {
        let room = (other.middle.abs() - other.radius).next_down();
        if room.is_nan() || room <= 0.0 {
            return Self::UNKNOWN;
        }
        let middle = self.middle / other.middle;
        if self.is_zero() {
            return Self::exact(0.0);
        }
        let spread = (self.radius + middle.abs() * SLACK * other.radius + LEAST) / room;
        Self { middle, radius: (spread + middle.abs() * HALF_ULP) * SLACK + LEAST }
    }
}

fn larger(x: f64, y: f64) -> f64 {
    if x < y { y } else { x }
}

impl Scalar for Ball {
    const EXACT: bool = false;

    fn int(n: i64) -> Self {
        let middle = n as f64;
        if n.unsigned_abs() <= 1 << 53 { Self::exact(middle) } else { Self::rounded(middle) }
    }

    fn frac(p: i64, q: i64) -> Self {
        let quotient = Self::int(p) / Self::int(q);
        // Halves and the like lose nothing.
        if q.unsigned_abs().is_power_of_two() && p.unsigned_abs() < 1 << 53 {
            Self::exact(quotient.middle)
        } else {
            quotient
        }
    }

    fn is_finite(&self) -> bool {
        self.middle.is_finite() && self.radius.is_finite()
    }

    fn magnitude(&self) -> Self {
        Self { middle: self.middle.abs(), radius: self.radius }
    }
}

impl PartialOrd for Ball {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.middle.partial_cmp(&other.middle)
    }
}

impl fmt::Display for Ball {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ± {}", self.middle, self.radius)
    }
}

impl Zero for Ball {
    fn zero() -> Self {
        Self::exact(0.0)
    }

    fn is_zero(&self) -> bool {
        self.middle == 0.0 && self.radius == 0.0
    }
}

impl One for Ball {
    fn one() -> Self {
        Self::exact(1.0)
    }
}

impl Neg for Ball {
    type Output = Self;

    fn neg(self) -> Self {
        Self { middle: -self.middle, radius: self.radius }
    }
}

/// The sign for values and references, and with assignment, from one function.
macro_rules! sign {
    ($sign:ident $operator:ident, $assign:ident $assigned:ident, |$x:ident, $y:ident| $value:expr) => {
        impl $sign for Ball {
            type Output = Self;

            #[inline]
            fn $operator(self, other: Self) -> Self {
                let ($x, $y) = (self, other);
                $value
            }
        }

        impl $sign<&Ball> for Ball {
            type Output = Self;

            #[inline]
            fn $operator(self, other: &Self) -> Self {
                self.$operator(*other)
            }
        }

        impl $assign for Ball {
            #[inline]
            fn $assigned(&mut self, other: Self) {
                *self = self.$operator(other);
            }
        }

        impl $assign<&Ball> for Ball {
            #[inline]
            fn $assigned(&mut self, other: &Self) {
                *self = self.$operator(*other);
            }
        }
    };
}

sign!(Add add, AddAssign add_assign, |x, y| x.plus(y));
sign!(Sub sub, SubAssign sub_assign, |x, y| x.plus(-y));
sign!(Mul mul, MulAssign mul_assign, |x, y| x.times(y));
sign!(Div div, DivAssign div_assign, |x, y| x.over(y));

#[cfg(test)]
mod tests {
    use super::*;

    /// A sequence of numbers of all sizes that is always the same.
    fn numbers() -> impl Iterator<Item = f64> {
        let mut state = 1_u64;
        std::iter::repeat_with(move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let share = (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
            share * 2.0_f64.powi((state % 61) as i32 - 30)
        })
    }

    #[test]
    fn balls_hold_what_they_stand_for() {
        let exact = |x: f64| Q::try_from(x).unwrap();
        let mut numbers = numbers();
        for _ in 0..300 {
            let (mut ball, mut q) = (Ball::exact(1.0), Q::int(1));
            for step in 0..12 {
                let x = numbers.next().unwrap();
                let other = (Ball::exact(x) / Ball::int(3), exact(x) / Q::int(3));
                (ball, q) = match step % 4 {
                    0 => (ball + other.0, q + other.1),
                    1 => (ball * other.0, q * other.1),
                    2 => (ball - other.0, q - other.1),
                    _ => (ball / other.0, q / other.1),
                };
                let (low, high) = ball.bounds();
                assert!(exact(low) <= q && q <= exact(high));
                assert!(
                    high - low <= 1e-13 * q.to_f64().abs().max(low.abs())
                        || ball.sign().is_none()
                        || step > 1
                );
            }
        }
    }

    #[test]
    fn every_rounding_is_counted() {
        // Of exact numbers each result is off by its own rounding alone.
        let exact = |x: f64| Q::try_from(x).unwrap();
        let mut numbers = numbers();
        for _ in 0..300 {
            let (x, y) = (numbers.next().unwrap(), numbers.next().unwrap());
            let (one, other) = (Ball::exact(x), Ball::exact(y));
            let results = [one + other, one - other, one * other, one / other];
            let truths = [exact(x) + exact(y), exact(x) - exact(y), exact(x) * exact(y), exact(x) / exact(y)];
            for (ball, truth) in results.iter().zip(&truths) {
                let radius = exact(ball.radius);
                assert!((exact(ball.middle) - truth).abs() <= radius, "{x} {y}");
                assert!(ball.radius <= 1.2e-16 * ball.middle.abs() + 1e-300);
            }
        }
    }

    #[test]
    fn signs_are_certain() {
        let third = Ball::int(1) / Ball::int(3);
        assert_eq!((third - third).sign(), None);
        assert_eq!((third - Ball::frac(1, 4)).sign(), Some(Ordering::Greater));
        assert_eq!((Ball::exact(0.1) - Ball::exact(0.1)).sign(), Some(Ordering::Equal));
        assert_eq!((Ball::exact(0.1) / Ball::zero()).sign(), None);
        assert_eq!((third / (third - third)).sign(), None);
        assert_eq!((Ball::exact(1e-200) * Ball::exact(1e-200)).sign(), None);
        assert_eq!((Ball::exact(1e200) * Ball::exact(1e200)).sign(), None);
    }

    #[test]
    fn roots_are_held() {
        let (low, high) = Ball::int(2).root().bounds();
        assert!(low * low < 2.0 && 2.0 < high * high && high - low < 1e-14);
        let (low, high) = Ball::between(-1.0, 4.0).root().bounds();
        assert!(low <= 0.0 && (2.0..2.000_001).contains(&high));
    }
}
