//! The weights of polar values as whole numbers over one denominator.
//!
//! The recurrence of [the polar form](crate::scalar::Scalar::whole_blossom) sees differences of knots and arguments only, and
//! their common scale cancels. So they are put over one denominator and taken as integers; each step multiplies by the
//! least common multiple of its divisors where the generic text divides:
//!
//! ```text
//! n_j <- (L / d_j) n_j (right_j - x) + (L / d_{j-1}) n_{j-1} (x - left_{j-1}),   L = lcm(d_j),  d_j = right_j - left_j
//! ```
//!
//! No gcd of long numbers is taken on the way. The value is reduced once, when all is added up.

use super::Q;
use super::Repr::{Big, Small};
use super::gcd::{power_of_two, word_gcd};
use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// The most steps, which are arguments, that are kept on the stack.
const STEPS: usize = 8;

/// Fills `weights` with whole numbers and returns their denominator, if differences of knots fit in words of 128 bits.
pub(super) fn blossom<'a>(
    t: &'a [Q],
    lo: usize,
    hi: usize,
    arg: &impl Fn(usize) -> &'a Q,
    weights: &mut [Q],
) -> Option<Q> {
    let steps = weights.len() - 1;
    if steps > STEPS {
        return None;
    }
    let (below, above) = (&t[lo + 1 - steps..=lo], &t[hi + 1..hi + 1 + steps]);
    let mut scale = Scale::default();
    below.iter().chain(above).try_for_each(|x| scale.add(x))?;
    (0..steps).try_for_each(|r| scale.add(arg(r)))?;
    let mut places = [[0; STEPS]; 3];
    for j in 0..steps {
        places[0][j] = scale.of(&below[steps - 1 - j])?;
        places[1][j] = scale.of(&above[j])?;
        places[2][j] = scale.of(arg(j))?;
    }
    center(&mut places, steps);
    let [left, right, args] = places;
    // Knot j of step r, counted from the left, is the (r - 1 - j)-th from the span outwards.
    let divisor = |r: usize, j: usize| right[j] - left[r - 1 - j];
    let shares = |r: usize, j: usize| (right[j] - args[r - 1], args[r - 1] - left[r - 1 - j]);
    let (numerators, denominator) = if let Some(words) = run::<i128>(steps, divisor, shares) {
        words
    } else {
        let (numerators, denominator) = run::<BigInt>(steps, divisor, shares)?;
        weights.iter_mut().zip(numerators).for_each(|(w, n)| *w = n.into());
        return Some(denominator.into());
    };
    weights.iter_mut().zip(numerators).for_each(|(w, n)| *w = Q::coprime(n, 1));
    Some(Q::coprime(denominator, 1))
}

/// The least common denominator, `odd · 2^twos`.
struct Scale {
    odd: i64,
    twos: u32,
}

impl Default for Scale {
    fn default() -> Self {
        Self { odd: 1, twos: 0 }
    }
}

impl Scale {
    fn add(&mut self, x: &Q) -> Option<()> {
        let (odd, twos) = match &x.0 {
            &Small { den, .. } => (den >> den.trailing_zeros(), den.trailing_zeros()),
            Big(f) => (1, power_of_two(&f.den)?.to_u32()?),
        };
        self.twos = self.twos.max(twos);
        if self.odd % odd != 0 {
            self.odd = self.odd.checked_mul(odd / word_gcd(self.odd, odd))?;
        }
        Some(())
    }

    /// The multiple of `x`, if that stays clear of the ends of 128 bits.
    fn of(&self, x: &Q) -> Option<i128> {
        let (num, odd, twos) = match &x.0 {
            &Small { num, den } => (num.into(), den >> den.trailing_zeros(), den.trailing_zeros()),
            Big(f) => (f.num.to_i128()?, 1, f.den.trailing_zeros()? as u32),
        };
        let factor = if odd == self.odd { 1 } else { self.odd / odd };
        let shift = self.twos - twos;
        let room = num.unsigned_abs().leading_zeros() + factor.leading_zeros();
        (room > 67 + shift).then(|| (num * i128::from(factor)) << shift)
    }
}

/// Moves the first knot on the right to zero and divides by the powers of two that all numbers have in common.
fn center(places: &mut [[i128; STEPS]; 3], steps: usize) {
    let origin = places[1][0];
    let mut bits = 0;
    for row in places.iter_mut() {
        row[..steps].iter_mut().for_each(|x| {
            *x -= origin;
            bits |= *x;
        });
    }
    let twos = if bits == 0 { 0 } else { bits.trailing_zeros() };
    places.iter_mut().for_each(|row| row.iter_mut().for_each(|x| *x >>= twos));
}

/// Integers of some size, whose operations may leave it.
trait Whole: Sized + Clone {
    fn from_word(n: i128) -> Self;
    fn times(self, factor: i128) -> Option<Self>;
    fn plus(self, other: &Self) -> Option<Self>;
}

impl Whole for i128 {
    #[inline]
    fn from_word(n: i128) -> Self {
        n
    }

    #[inline]
    fn times(self, factor: i128) -> Option<Self> {
        let room = self.unsigned_abs().leading_zeros() + factor.unsigned_abs().leading_zeros();
        (room > 128).then(|| self * factor)
    }

    #[inline]
    fn plus(self, other: &Self) -> Option<Self> {
        self.checked_add(*other)
    }
}

impl Whole for BigInt {
    fn from_word(n: i128) -> Self {
        n.into()
    }

    fn times(mut self, factor: i128) -> Option<Self> {
        match i64::try_from(factor) {
            Ok(1) => {}
            Ok(word) => self *= word,
            Err(_) => self *= factor,
        }
        Some(self)
    }

    fn plus(self, other: &Self) -> Option<Self> {
        Some(self + other)
    }
}

/// Numerators and denominator, unless they leave the integers.
fn run<I: Whole>(
    steps: usize,
    divisor: impl Fn(usize, usize) -> i128,
    shares: impl Fn(usize, usize) -> (i128, i128),
) -> Option<([I; STEPS + 1], I)> {
    let mut numerators: [I; STEPS + 1] = std::array::from_fn(|_| I::from_word(1));
    let mut denominator = I::from_word(1);
    for r in 1..=steps {
        let divisors = Divisors::new(r, &divisor);
        let mut saved: Option<I> = None;
        for (j, numerator) in numerators[..r].iter_mut().enumerate() {
            let place = std::mem::replace(numerator, I::from_word(0));
            let share = divisors.cofactors(j).try_fold(place, I::times)?;
            let (here, next) = shares(r, j);
            let kept = share.clone().times(here)?;
            *numerator = match &saved {
                Some(saved) => kept.plus(saved)?,
                None => kept,
            };
            saved = Some(share.times(next)?);
        }
        numerators[r] = saved.expect("a step has a divisor");
        denominator = divisors.factors().try_fold(denominator, I::times)?;
    }
    Some((numerators, denominator))
}

/// The divisors of a step, and their least common multiple as far as it comes cheap: of short ones as one number, of long
/// ones as the product of the different ones.
struct Divisors {
    count: usize,
    values: [i128; STEPS],
    short: Option<i64>,
    different: [bool; STEPS],
}

impl Divisors {
    fn new(count: usize, divisor: &impl Fn(usize, usize) -> i128) -> Self {
        let values: [i128; STEPS] = std::array::from_fn(|j| if j < count { divisor(count, j) } else { 1 });
        let multiple = |l: i64, d: &i128| {
            let d = i64::from(i32::try_from(*d).ok()?);
            if l % d == 0 { Some(l) } else { l.checked_mul(d / word_gcd(l, d)) }
        };
        let short = values[..count].iter().try_fold(1, multiple);
        let different = std::array::from_fn(|j| j < count && !values[..j].contains(&values[j]));
        Self { count, values, short, different }
    }

    /// Numbers whose product is the multiple divided by divisor `j`.
    fn cofactors(&self, j: usize) -> impl Iterator<Item = i128> {
        let short = self.short.map(|l| i128::from(l / self.values[j] as i64));
        let others = (0..self.count).filter(move |i| short.is_none() && self.different[*i]);
        let others = others.map(|i| self.values[i]).filter(move |d| *d != self.values[j]);
        short.into_iter().chain(others)
    }

    /// Numbers whose product is the multiple.
    fn factors(&self) -> impl Iterator<Item = i128> {
        let others = (0..self.count).filter(|i| self.short.is_none() && self.different[*i]);
        self.short.map(i128::from).into_iter().chain(others.map(|i| self.values[i]))
    }
}
