//! [Miura] table 1, sections 2 and A: sizes of fine tuned curves, and of curves of raised degree.
//!
//! For `C` of degree `n` and `α` of degree `q` the result has degree `n + q`; a knot inside has
//! `max(q + m_C, n - 1 + m_α)` copies (only terms of knots that are there), an end `n + q + 1`. The table gives degree
//! and number of control points of `C` and of `α`; all its knots are simple.

use crate::point;
use symspline::{Curve, Function, Q, Result, Scalar, SplineSpace};

/// A clamped space with simple knots inside and so many coefficients.
fn space(degree: usize, coefficients: usize) -> Result<SplineSpace<Q>> {
    SplineSpace::uniform(degree, coefficients - degree, Q::int(0), Q::int(1))
}

/// A plane curve that turns this way and that.
fn curve(space: SplineSpace<Q>) -> Result<Curve<Q, 2>> {
    let points = (0..space.dim() as i64).map(|i| point([3 * i, (i * i) % 7])).collect();
    Curve::new(space, points)
}

/// Degree and number of control points of a fine tuned curve.
fn tuned_size((n, controls): (usize, usize), (q, values): (usize, usize)) -> Result<(usize, usize)> {
    let alpha = space(q, values)?;
    let values = (0..alpha.dim() as i64).map(|i| Q::frac(i % 3 + 2, 2)).collect();
    let tuned = curve(space(n, controls)?)?.fine_tuned(&Function::new(alpha, values)?)?;
    Ok((tuned.degree(), tuned.coeffs().len()))
}

/// The rule, for knots in common positions `common`: copies inside plus one end.
fn ruled_size((n, controls): (usize, usize), (q, values): (usize, usize), common: usize) -> (usize, usize) {
    let (of_curve, of_alpha) = (controls - n - 1, values - q - 1);
    let both = (q + 1).max(n);
    let inside = (of_curve - common) * (q + 1) + (of_alpha - common) * n + common * both;
    (n + q, inside + n + q + 1)
}

#[test]
fn sizes_of_the_curves_of_table_1() -> Result<()> {
    // Face: 178 knots inside, doubled.
    assert_eq!(tuned_size((2, 181), (1, 2))?, (3, 360));
    // Car: 68 knots inside and 3 of the scale function at the quarters, none in common, all tripled.
    assert_eq!(tuned_size((3, 72), (2, 6))?, (5, 219));
    // Double loop: 155 knots inside, tripled.
    assert_eq!(tuned_size((3, 159), (2, 3))?, (5, 471));
    Ok(())
}

#[test]
fn sizes_follow_the_rule_of_knots() -> Result<()> {
    for (c, alpha, common) in [
        ((2, 181), (1, 2), 0),
        ((3, 72), (2, 6), 0),
        ((3, 159), (2, 3), 0),
        ((3, 11), (2, 6), 3),
        ((4, 8), (1, 3), 1),
    ] {
        assert_eq!(tuned_size(c, alpha)?, ruled_size(c, alpha, common), "{c:?} {alpha:?}");
    }
    Ok(())
}

/// Degree `n - 1` with simple knots keeps `D` as smooth as `C`, of class `n - 1`, at all three kinds of knots.
#[test]
fn recommended_degree_keeps_smoothness() -> Result<()> {
    for n in 2..=4 {
        let c = curve(SplineSpace::clamped(n, [0, 1, 2, 4, 6].map(Q::int))?)?;
        let alpha_space = SplineSpace::clamped(n - 1, [0, 2, 3, 6].map(Q::int))?;
        let values = (0..alpha_space.dim() as i64).map(|i| Q::int(i % 3 + 1)).collect();
        let tuned = c.fine_tuned(&Function::new(alpha_space, values)?)?;
        // Degree 2 n - 1 and n copies: class n - 1.
        let inside: Vec<(Q, usize)> = [1, 2, 3, 4].map(|t| (Q::int(t), n)).to_vec();
        assert_eq!(tuned.degree(), 2 * n - 1);
        assert_eq!(tuned.space().breaks()[1..5], inside, "degree {n}");
    }
    Ok(())
}

/// With `α = 1` the result is the curve itself, written in the space of the result.
#[test]
fn identity_scale_function_keeps_the_curve() -> Result<()> {
    let c = curve(space(3, 9)?)?;
    let one = Function::constant(space(2, 5)?, Q::int(1))?;
    let tuned = c.fine_tuned(&one)?;
    assert_eq!(tuned, c.embedded(tuned.space())?);
    Ok(())
}

/// (15)-(17): raising the degree of a curve with `n + 1` controls and `s` distinct knots inside gives `n + s + 2`
/// controls, and the knot vector grows by `s + 2`.
#[test]
fn sizes_of_raised_degree() -> Result<()> {
    for inside in [vec![], vec![1], vec![1, 2, 2], vec![1, 1, 1, 3, 4]] {
        let mut distinct = inside.clone();
        distinct.dedup();
        let breaks = [0].into_iter().chain(inside.iter().copied()).chain([5]).map(Q::int);
        let c = curve(SplineSpace::clamped(3, breaks)?)?;
        let raised = c.elevated(1)?;
        let s = distinct.len();
        assert_eq!(raised.coeffs().len(), c.coeffs().len() + s + 1, "knots inside {inside:?}");
        assert_eq!(raised.space().knots().len(), c.space().knots().len() + s + 2, "knots inside {inside:?}");
    }
    Ok(())
}
