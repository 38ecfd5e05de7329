//! Roots in floating point: the floats nearest to the roots of the polynomial with just the given coefficients.

use crate::exact::Q;
use crate::roots::isolate::{Isolation, isolation};
use crate::roots::polynomial::Polynomial;
use crate::roots::twofold::Twofold;
use crate::roots::{Root, RootValue, Roots, Solvable};
use crate::scalar::Scalar;
use std::cell::OnceCell;
use std::cmp::Ordering;

impl Solvable for f64 {
    fn roots(polynomial: &Polynomial<Self>) -> Roots<Self> {
        let known = |x: f64, multiplicity| Root { value: RootValue::Exact(x), multiplicity };
        let variations = polynomial.variations();
        let Some((start, end)) = polynomial.end_roots() else { return Roots::Everywhere };
        let (a, b) = polynomial.domain();
        if variations < 2 {
            // Signs are not rounded: no need to isolate.
            let inside = (variations == 1).then(|| (crossing(polynomial), 1));
            let roots = [Some((*a, start)), inside, Some((*b, end))].into_iter().flatten();
            return Roots::At(roots.filter(|(_, n)| *n > 0).map(|(x, n)| known(x, n)).collect());
        }
        let Some(Isolation { factor, roots }) = isolation(&exact(polynomial)) else {
            return Roots::Everywhere;
        };
        let root = |(low, high, multiplicity): (Q, Q, usize)| match low == high {
            true => known(low.to_f64(), multiplicity),
            false => {
                let near = guess(polynomial, low.to_f64(), high.to_f64());
                known(isolated(&factor, (&low, &high), near), multiplicity)
            }
        };
        Roots::At(roots.into_iter().map(root).collect())
    }

    fn root(polynomial: &Polynomial<Self>, start: Self, end: Self) -> RootValue<Self> {
        let near = guess(polynomial, start, end);
        RootValue::Exact(isolated(&exact(polynomial), (&image(start), &image(end)), near))
    }
}

/// The roots of an exact polynomial as floats: each between neighbours if it is none.
pub(crate) fn enclosed_roots(polynomial: &Polynomial<Q>) -> Roots<f64> {
    each_root(polynomial, |factor, guessed, low, high| {
        let (below, above) = float_neighbours(factor, guessed, (&low, &high));
        if below == above { RootValue::Exact(below) } else { RootValue::Enclosed(below, above) }
    })
}

/// The roots of an exact polynomial, each exactly or about as close as floats enclose it.
pub(crate) fn close_roots(polynomial: &Polynomial<Q>) -> Roots<Q> {
    each_root(polynomial, |factor, guessed, low, high| {
        if low == high {
            return RootValue::Exact(low);
        }
        let value = Q::root(factor, low.clone(), high.clone());
        if let RootValue::Exact(_) = value {
            return value;
        }
        let (below, above) = float_neighbours(factor, guessed, (&low, &high));
        RootValue::Enclosed(low.max(image(below)), high.min(image(above)))
    })
}

/// The roots of an exact polynomial, each made by `value` from a factor that has it as a simple one, that factor
/// rounded, and the ends of an isolating interval, which are equal where it is known.
fn each_root<T>(
    polynomial: &Polynomial<Q>,
    value: impl Fn(&Polynomial<Q>, Option<&Polynomial<f64>>, Q, Q) -> RootValue<T>,
) -> Roots<T> {
    let Some(Isolation { factor, roots }) = isolation(polynomial) else { return Roots::Everywhere };
    let guessed = if roots.iter().any(|(low, high, _)| low < high) { rounded(&factor) } else { None };
    let root = |(low, high, multiplicity): (Q, Q, usize)| Root {
        value: value(&factor, guessed.as_ref(), low, high),
        multiplicity,
    };
    Roots::At(roots.into_iter().map(root).collect())
}

/// The neighbouring floats around the root of `factor` between `low` and `high`, or the float that it is, twice.
fn float_neighbours(
    factor: &Polynomial<Q>,
    guessed: Option<&Polynomial<f64>>,
    (low, high): (&Q, &Q),
) -> (f64, f64) {
    let near = match guessed {
        Some(guessed) if low < high => guess(guessed, low.to_f64(), high.to_f64()),
        _ => low.to_f64(),
    };
    neighbours(near, |x, _| match low == high {
        true => image(x).cmp(low),
        false => beside(factor, (low, high), &image(x)),
    })
}

/// The polynomial with rounded coefficients, scaled.
fn rounded(polynomial: &Polynomial<Q>) -> Option<Polynomial<f64>> {
    let (a, b) = polynomial.domain();
    let size = polynomial.coeffs().iter().map(Q::abs).max()?;
    let c = polynomial.coeffs().iter().map(|c| (c.clone() / &size).to_f64()).collect();
    Polynomial::new(a.to_f64(), b.to_f64(), c).ok()
}

/// The float nearest to the one root of `polynomial` between `low` and `high`, which are no roots.
fn isolated(polynomial: &Polynomial<Q>, ends: (&Q, &Q), near: f64) -> f64 {
    nearest(near, |x, y| beside(polynomial, ends, &((image(x) + image(y)) * Q::frac(1, 2))))
}

/// How `x` compares with the one root between `low` and `high`.
fn beside(polynomial: &Polynomial<Q>, (low, high): (&Q, &Q), x: &Q) -> Ordering {
    if x <= low || x >= high {
        return if x <= low { Ordering::Less } else { Ordering::Greater };
    }
    side(polynomial.sign_at(x), polynomial.sign_at(low))
}

/// Near to where a polynomial changes its sign between `low` and `high`, by bisection with rounding.
fn guess(polynomial: &Polynomial<f64>, mut low: f64, mut high: f64) -> f64 {
    // At an end that is a root the sign is that of the nearest coefficient.
    let at_start = polynomial.coeffs().iter().find(|c| **c != 0.0).unwrap_or(&0.0);
    let first = if low <= *polynomial.domain().0 { *at_start } else { polynomial.at(&low) }.signum();
    loop {
        let middle = low * 0.5 + high * 0.5;
        if !(low < middle && middle < high) {
            return low;
        }
        if polynomial.at(&middle) * first > 0.0 { low = middle } else { high = middle }
    }
}

/// The float nearest to the one root inside the interval.
fn crossing(polynomial: &Polynomial<f64>) -> f64 {
    let (a, b) = polynomial.domain();
    let falls = polynomial.coeffs().iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0);
    let before = if falls { Ordering::Greater } else { Ordering::Less };
    let (twofold, image_of_all) = (Twofold::new(polynomial), OnceCell::new());
    nearest(guess(polynomial, *a, *b), |x, y| {
        if y <= *a || x >= *b {
            return if y <= *a { Ordering::Less } else { Ordering::Greater };
        }
        let exactly = || {
            let polynomial = image_of_all.get_or_init(|| exact(polynomial));
            polynomial.sign_at(&((image(x) + image(y)) * Q::frac(1, 2)))
        };
        let sign = twofold.as_ref().and_then(|p| p.sign(x, y));
        side(sign.unwrap_or_else(exactly), before)
    })
}

/// How a parameter with this sign compares with the root, if the sign is `before` up to there.
fn side(sign: Ordering, before: Ordering) -> Ordering {
    match sign {
        Ordering::Equal => Ordering::Equal,
        sign if sign == before => Ordering::Less,
        _ => Ordering::Greater,
    }
}

fn image(x: f64) -> Q {
    Q::try_from(x).expect("parameters and coefficients of a polynomial are finite")
}

/// The polynomial with the exact numbers that the floats are.
fn exact(polynomial: &Polynomial<f64>) -> Polynomial<Q> {
    let (a, b) = polynomial.domain();
    let c = polynomial.coeffs().iter().copied().map(image).collect();
    Polynomial::new(image(*a), image(*b), c).expect("a valid polynomial has a valid image")
}

/// The float nearest to a root, found from `guess`; `side(x, y)` is how the mean of `x` and `y` compares with the root.
fn nearest(guess: f64, side: impl Fn(f64, f64) -> Ordering) -> f64 {
    let (x, y) = neighbours(guess, &side);
    if x < y && side(x, y) == Ordering::Less { y } else { x }
}

/// The neighbouring floats between which a root is, or the root twice if it is a float.
fn neighbours(guess: f64, side: impl Fn(f64, f64) -> Ordering) -> (f64, f64) {
    let most = rank(f64::MAX);
    // First away from the guess in growing steps, then by bisection.
    let (mut below, mut above) = (-most, most);
    let (mut at, mut stride) = (rank(guess), 1);
    while below + 1 < above {
        match side(float(at), float(at)) {
            Ordering::Equal => return (float(at), float(at)),
            Ordering::Less => below = at,
            Ordering::Greater => above = at,
        }
        at = match (below == -most, above == most) {
            (false, true) => below.saturating_add(stride),
            (true, false) => above.saturating_sub(stride),
            _ => i64::midpoint(below, above),
        };
        if at <= below || above <= at {
            at = i64::midpoint(below, above);
        }
        stride = stride.saturating_mul(2);
    }
    (float(below), float(above))
}

/// The place of a finite float in the order of all of them, zero at 0.
fn rank(x: f64) -> i64 {
    let bits = x.to_bits() as i64;
    if bits < 0 { i64::MIN.wrapping_sub(bits) } else { bits }
}

/// The float of a rank.
fn float(rank: i64) -> f64 {
    f64::from_bits(if rank < 0 { i64::MIN.wrapping_sub(rank) } else { rank } as u64)
}
