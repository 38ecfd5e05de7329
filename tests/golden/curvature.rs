//! Curvature as quotients of piecewise polynomials: `κ² = N² / S³` with `N = C' × C''` and `S = |C'|²`.

use crate::check::{check_row, derivative_size, for_each, largest, shortest_span};
use crate::data::Case;
use symspline::{Analyse, Curve, Function, Q, Result};

/// The bound over `f64`: relative to the size of the numbers of which `N` and `S` are sums, in epsilons.
const FACTOR: f64 = 1.0;

/// `N` and `S` of a plane curve.
fn turning_and_speed(curve: &Curve<Q, 2>) -> Result<[Function<Q>; 2]> {
    let first = curve.derivative()?;
    Ok([first.cross(&first.derivative()?)?, first.dot(&first)?])
}

/// `2 N' S - 3 N S'` on one polynomial piece: zero where the curvature is extremal.
fn extrema(piece: &Curve<Q, 2>) -> Result<Function<Q>> {
    let [turning, speed] = turning_and_speed(piece)?;
    let left = turning.derivative()?.times(&speed)?.scaled(&Q::from(2))?;
    left.difference(&turning.times(&speed.derivative()?)?.scaled(&Q::from(3))?)
}

/// The power basis polynomial at `x`, lowest coefficient first.
fn horner(coeffs: &[Q], x: &Q) -> Q {
    coeffs.iter().rev().fold(Q::from(0), |sum, c| sum * x + c)
}

/// Checks that `found` is the polynomial on `[a, b]`: at more inner points than either has degree.
fn check_polynomial(place: &str, found: &Function<Q>, coeffs: &[Q], [a, b]: [&Q; 2]) -> Result<()> {
    let count = found.degree().max(coeffs.len()) as i64 + 1;
    for i in 1..=count {
        let x = a.clone() + (b.clone() - a) * Q::from(i) / Q::from(count + 1);
        assert_eq!(found.at(&x)?, horner(coeffs, &x), "{place} at {x} (found on the left)");
    }
    Ok(())
}

/// `N`, `S`, `κ²` at a parameter, and all pieces as polynomials.
fn in_the_plane(case: Case) -> Result<()> {
    let (id, curve, t) = (case.id(), case.curve::<Q, 2>("p")?, case.get("t").number::<Q>());
    let [turning, speed] = turning_and_speed(&curve)?;
    let (n, s) = (turning.at(&t)?, speed.at(&t)?);
    assert_eq!(n, case.get("N").number(), "{id} N");
    assert_eq!(s, case.get("S").number(), "{id} S");
    let squared = n.clone() * &n / (s.clone() * &s * &s);
    assert_eq!(squared, case.get("kappa2").number(), "{id} kappa2");

    let breaks: Vec<Q> = case.get("breaks").numbers();
    let pieces = curve.bezier_pieces()?;
    assert_eq!(pieces.len() + 1, breaks.len(), "{id} breaks");
    for (i, piece) in pieces.iter().enumerate() {
        let ends = [&breaks[i], &breaks[i + 1]];
        assert_eq!(piece.domain(), (ends[0], ends[1]), "{id} breaks");
        let poly = |key: &str| case.get(key).list().nth(i).expect("one polynomial a piece").numbers();
        let [n, s, e] = ["N_poly", "S_poly", "extrema_poly"].map(poly);
        check_polynomial(&format!("{id} N, piece {i}"), &turning, &n, ends)?;
        check_polynomial(&format!("{id} S, piece {i}"), &speed, &s, ends)?;
        check_polynomial(&format!("{id} extrema, piece {i}"), &extrema(piece)?, &e, ends)?;
        let degree = e.iter().rposition(|c| *c != Q::from(0)).unwrap_or(0);
        assert!(degree <= case.get("extrema_degree_bound").integer(), "{id} degree {degree}");
    }

    let kappa = case.curve::<f64, 2>("p")?.curvature_at(&t.to_f64())?;
    assert_eq!(kappa.is_sign_negative(), n.is_negative(), "{id}: the sign of κ is that of N");
    check_squared(case, kappa, &squared, &s);
    Ok(())
}

/// `κ²` at a parameter.
fn in_space(case: Case) -> Result<()> {
    let (id, curve, t) = (case.id(), case.curve::<Q, 3>("p")?, case.get("t").number::<Q>());
    let first = curve.derivative()?;
    let binormal = first.cross(&first.derivative()?)?;
    let (area, speed) = (binormal.dot(&binormal)?.at(&t)?, first.dot(&first)?.at(&t)?);
    let squared = area / (speed.clone() * &speed * &speed);
    assert_eq!(squared, case.get("kappa2").number(), "{id} kappa2");
    let kappa = case.curve::<f64, 3>("p")?.curvature_at(&t.to_f64())?;
    assert!(kappa >= 0.0, "{id}");
    check_squared(case, kappa, &squared, &speed);
    Ok(())
}

/// Checks `κ` over `f64` against the exact `κ²`: `C'` and `C''` are rounded like derivatives of orders 1 and 2.
fn check_squared(case: Case, kappa: f64, squared: &Q, speed: &Q) {
    let (p, h) = (case.get("p").integer(), shortest_span(&case.get("U").numbers::<Q>()));
    let points = largest(case.get("P").rows::<Q>().iter().flatten());
    let [first, second] = [1, 2].map(|k| derivative_size(points, p, h, k));
    let (k, length) = (squared.to_f64().sqrt(), speed.to_f64().sqrt());
    // dκ <= |dC''| / |C'|² + 3 κ |dC'| / |C'| and then d(κ²) = 2 κ dκ.
    let size = 2.0 * k * (second / length.powi(2) + 3.0 * k * first / length);
    check_row(
        &format!("{} kappa2", case.id()),
        &[kappa * kappa],
        std::slice::from_ref(squared),
        size,
        FACTOR,
    );
}

#[test]
fn curvature2d() {
    for_each("curvature2d", 3, in_the_plane);
}

#[test]
fn curvature3d() {
    for_each("curvature3d", 3, in_space);
}
