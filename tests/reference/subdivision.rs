//! [Miura] (9)-(12), (19)-(22): Chaikin's rule, and closed quadratics as cubics over double knots.
//!
//! The non-uniform form of (22) follows from the polar form: with `h_i` the length of the segment of vertex `i` of the
//! polygon, the two cubic controls on leg `i` divide it in the ratios given in `conversion`.

use crate::point;
use symspline::{Curve, Q, Result, Scalar, SplineSpace};

/// A closed quadratic with vertices in general position over segments of lengths `h_1, ..., h_{m-1}, h_0`, which
/// begins with the segment of vertex 1: coefficient 0 of a periodic space has its segment before the seam.
fn closed_quadratic(lengths: &[Q]) -> Result<Curve<Q, 2>> {
    let m = lengths.len();
    let knots = (1..m).scan(Q::int(0), |t, i| {
        *t += &lengths[i];
        Some(t.clone())
    });
    let knots: Vec<Q> = std::iter::once(Q::int(0)).chain(knots).collect();
    let space = SplineSpace::periodic(2, knots, lengths.iter().sum())?;
    let vertex = |i: usize| point([(i as i64 * 7 + 3) % 11, (i as i64 * i as i64 * 5 + 1) % 13]);
    Curve::new(space, (0..m).map(vertex).collect())
}

/// Vertex `i`, wrapped, times `w` plus the next one times `v`.
fn on_leg(curve: &Curve<Q, 2>, i: usize, w: &Q, v: &Q) -> nalgebra::SVector<Q, 2> {
    let p = curve.coeffs();
    p[i].map(|x| x * w) + p[(i + 1) % p.len()].map(|x| x * v)
}

#[test]
fn chaikin_is_bisection_of_the_uniform_quadratic() -> Result<()> {
    for m in [3, 4, 7] {
        let curve = closed_quadratic(&vec![Q::int(1); m])?;
        let fine = curve.embedded(&curve.space().bisected()?)?;
        assert_eq!(fine.coeffs().len(), 2 * m);
        let (near, far) = (Q::frac(3, 4), Q::frac(1, 4));
        for i in 0..m {
            assert_eq!(fine.coeffs()[2 * i], on_leg(&curve, i, &near, &far), "(9), leg {i} of {m}");
            assert_eq!(fine.coeffs()[2 * i + 1], on_leg(&curve, i, &far, &near), "(10), leg {i} of {m}");
        }
    }
    Ok(())
}

#[test]
fn uniform_quadratic_to_cubic() -> Result<()> {
    for m in [3, 4, 7] {
        let curve = closed_quadratic(&vec![Q::int(1); m])?;
        let cubic = curve.elevated(1)?;
        assert_eq!(cubic.coeffs().len(), 2 * m);
        let (near, far) = (Q::frac(5, 6), Q::frac(1, 6));
        for i in 0..m {
            assert_eq!(cubic.coeffs()[2 * i], on_leg(&curve, i, &near, &far), "(11), leg {i} of {m}");
            assert_eq!(cubic.coeffs()[2 * i + 1], on_leg(&curve, i, &far, &near), "(12), leg {i} of {m}");
        }
    }
    Ok(())
}

/// The knots of (20) and (21): one period from the seam gives the wrapped vectors of the paper; the library keeps one
/// more at the end of the second.
#[test]
fn knots_of_the_triangle() -> Result<()> {
    let thirds = |numerators: &[i64]| -> Vec<Q> { numerators.iter().map(|&n| Q::frac(n, 3)).collect() };
    let quadratic = SplineSpace::periodic(2, thirds(&[0, 1, 2]), Q::int(1))?;
    assert_eq!(quadratic.knots()[..], thirds(&[-2, -1, 0, 1, 2, 3, 4, 5]));
    let cubic = quadratic.elevated(1)?;
    assert_eq!(cubic.knots()[..12], thirds(&[-1, -1, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4]));
    assert_eq!((cubic.dim(), cubic.knots().len()), (6, 13));
    // Over the twelve knots alone: eight controls, and the same domain.
    let open = SplineSpace::new(3, thirds(&[-1, -1, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4]))?;
    assert_eq!((open.dim(), open.domain()), (8, (&Q::int(0), &Q::int(1))));
    Ok(())
}

/// Weights of the vertices `i`, `i + 1` in the controls `2 i`, `2 i + 1`, for segments of lengths `h`, `k`.
fn conversion(h: &Q, k: &Q) -> [[Q; 2]; 2] {
    let whole = Q::int(3) * (h.clone() + k);
    let (two, three) = (Q::int(2), Q::int(3));
    [
        [(two.clone() * h + three.clone() * k) / &whole, h.clone() / &whole],
        [k.clone() / &whole, (three * h + two * k) / &whole],
    ]
}

#[test]
fn non_uniform_quadratic_to_cubic() -> Result<()> {
    for lengths in [vec![1, 2, 3], vec![5, 1, 1, 2], vec![1, 7, 2, 9, 4, 3]] {
        let h: Vec<Q> = lengths.into_iter().map(|n| Q::frac(n, 2)).collect();
        let (curve, m) = (closed_quadratic(&h)?, h.len());
        let cubic = curve.elevated(1)?;
        for i in 0..m {
            for (offset, [w, v]) in conversion(&h[i], &h[(i + 1) % m]).iter().enumerate() {
                assert_eq!(
                    cubic.coeffs()[2 * i + offset],
                    on_leg(&curve, i, w, v),
                    "leg {i} of {m}, {offset}"
                );
            }
        }
    }
    Ok(())
}

/// (19) holds for degree 2 alone; in any degree `p` the elevated closed curve over `m` simple knots has `2 m`
/// coefficients, and every knot twice.
#[test]
fn double_knots_in_any_degree() -> Result<()> {
    for p in 1..=5 {
        let space = SplineSpace::periodic(p, (0..4).map(Q::int), Q::int(4))?;
        let raised = space.elevated(1)?;
        assert_eq!((raised.degree(), raised.dim()), (p + 1, 8), "degree {p}");
        assert!(raised.breaks().iter().all(|(_, copies)| *copies == 2), "degree {p}");
    }
    Ok(())
}
