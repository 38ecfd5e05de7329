//! How large results may grow.
//!
//! A short expression can ask for what no memory holds: `abs2(abs2(abs2(7)))` has twice the digits with each word. Degrees are bounded by the
//! library, numbers of fractions here, so that each step takes seconds at most.

use symspline_dynamic::{Any, AnySpace, Coords, Family, Over, Value, both};

/// How many bits the fractions of a result have at most.
const MAX_BITS: u64 = 1 << 17;

/// How many they have at most times the coefficients that a step multiplies with each other, those of one span.
const MAX_WORK: u64 = 1 << 20;

/// How many products of exact numbers a composition takes at most: about `p³ q`, if `p` and `q` are the degrees.
const MAX_PRODUCTS: usize = 1 << 21;

/// Refuses exact compositions that take too long.
///
/// # Errors
/// The degrees, in words.
pub fn check_composition(outer: &[AnySpace], inner: &[AnySpace]) -> Result<(), String> {
    let degree =
        |spaces: &[AnySpace]| spaces.iter().map(|space| both!(space, s => s.degree())).sum::<usize>();
    let (p, q) = (degree(outer), degree(inner));
    let is_exact = outer.iter().all(AnySpace::is_exact);
    if is_exact && p.saturating_pow(3).saturating_mul(q) > MAX_PRODUCTS {
        return Err(format!("an exact composition of degrees {p} and {q} takes too long: use floats"));
    }
    Ok(())
}

/// Refuses results that are too large to go on with, and floats that are not finite.
///
/// # Errors
/// What is too large, in words.
pub fn check(value: &Value) -> Result<(), String> {
    let (bits, coefficients) = match value {
        Value::Number(Over::Float(x)) => return finite(&[*x]),
        Value::Point(Over::Float(p)) => return finite(p),
        _ if !value.is_exact() => return Ok(()),
        Value::Number(Over::Exact(x)) => (x.bits(), 1),
        Value::Point(p) => (most(p), 1),
        Value::Spline(s) => of_spline(s),
        Value::Surface(s) => of_spline(s),
        Value::Rational(s) => of_spline(s),
        Value::RationalSurface(s) => of_spline(s),
        _ => return Ok(()),
    };
    if bits > MAX_BITS || bits.saturating_mul(coefficients) > MAX_WORK {
        return Err(format!("the result has fractions of {bits} bits: too large to go on with exactly"));
    }
    Ok(())
}

/// Refuses numbers of which one is not finite; splines are checked by the library.
fn finite(all: &[f64]) -> Result<(), String> {
    match all.iter().find(|x| !x.is_finite()) {
        Some(x) => Err(format!("the result is {x}, not a finite number")),
        None => Ok(()),
    }
}

/// The bits of the largest fraction, and the coefficients of one span.
fn of_spline<F: Family>(s: &Any<F>) -> (u64, u64) {
    let points = s.coords().map_or(0, |all| most(&all));
    let weights = s.weights().map_or(0, |all| most(&all));
    let orders = s.spaces().into_iter().map(|space| both!(space, s => s.degree() as u64 + 1));
    (points.max(weights), orders.product())
}

/// The bits of the largest fraction.
fn most(all: &Coords) -> u64 {
    match all {
        Over::Float(_) => 0,
        Over::Exact(all) => all.iter().map(symspline::Q::bits).max().unwrap_or(0),
    }
}

#[cfg(test)]
mod tests {
    use crate::calc::evaluate::{Names, evaluate};

    fn problem(text: &str) -> Option<String> {
        evaluate(text, &Names::new()).err().map(|complaint| complaint.to_string())
    }

    #[test]
    fn numbers_that_double_are_stopped() {
        let nested = |text: &str, n: usize| format!("{}{text}{}", "abs2(".repeat(n), ")".repeat(n));
        // 7^(2^16) has 183983 bits, and its denominator one.
        assert_eq!(problem(&nested("7", 10)), None);
        assert!(problem(&nested("7", 60)).unwrap().contains("the result has fractions of 183984 bits"));
        // The complaint is about the call that is too much, the sixteenth from inside.
        assert!(problem(&nested("7", 60)).unwrap().starts_with(&format!("expression:1:{}: ", 44 * 5 + 1)));
        assert!(problem(&vec!["1e400"; 200].join(" * ")).unwrap().contains("too large"));
    }

    #[test]
    fn floats_are_finite() {
        assert_eq!(problem("float(1e308) * 1"), None);
        assert!(
            problem("1 + float(1e308) * 10")
                .unwrap()
                .ends_with("1:5: the result is inf, not a finite number")
        );
        assert!(problem("float(1e400)").is_some());
        assert!(problem("float((1, 1e400))").is_some());
    }

    #[test]
    fn compositions_are_stopped_before_they_start() {
        let chain = |f: &str, n: usize| vec![f; n].join(" @ ");
        let square = "bezier(0, 0, 1)";
        assert_eq!(problem(&chain(square, 6)), None);
        let stopped = problem(&chain(square, 9)).unwrap();
        assert!(stopped.contains("an exact composition of degrees 128 and 2 takes too long"), "{stopped}");
        assert_eq!(problem(&chain("float(bezier(0, 0, 1))", 8)), None);
    }

    #[test]
    fn splines_are_stopped_by_all_of_their_coefficients() {
        let ramp = "bezier(1/123456789, 2/987654321)";
        assert_eq!(problem(&vec![ramp; 40].join(" * ")), None);
        assert!(problem(&vec![ramp; 500].join(" * ")).unwrap().contains("too large"));
        let float = vec!["float(bezier(1/3, 2/7))"; 500].join(" * ");
        assert_eq!(problem(&float), None);
    }
}
