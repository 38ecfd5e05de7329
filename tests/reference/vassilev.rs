//! [Vassilev] (8)-(11): matrices of one segment of the uniform cubic B-spline.
//!
//! Over one span of length `h` the four cubics that do not vanish have the Gram matrices
//! `∫ N_i^(k) N_j^(k)` for `k = 0, 1, 2`, here with their denominators.

use symspline::{Q, Result, Scalar, SplineSpace};

/// `K0`, `K1`, `K2` times their denominators.
const SEGMENT: [(i64, [[i64; 4]; 4]); 3] = [
    (5040, [[20, 129, 60, 1], [129, 1188, 933, 60], [60, 933, 1188, 129], [1, 60, 129, 20]]),
    (120, [[6, 7, -12, -1], [7, 34, -29, -12], [-12, -29, 34, 7], [-1, -12, 7, 6]]),
    (6, [[2, -3, 0, 1], [-3, 6, -3, 0], [0, -3, 6, -3], [1, 0, -3, 2]]),
];

/// Entry `i, j` of the matrix for derivatives of order `k`: `K_k` scales with `h^(1 - 2 k)`.
fn entry(k: usize, i: usize, j: usize, h: &Q) -> Q {
    let (denominator, rows) = SEGMENT[k];
    let power = (0..2 * k).fold(h.clone(), |power, _| power / h);
    Q::frac(rows[i][j], denominator) * power
}

/// The uniform unclamped cubic of `spans` spans of length `h`, its domain from `3 h` on.
fn uniform(spans: i64, h: &Q) -> Result<SplineSpace<Q>> {
    SplineSpace::new(3, (0..spans + 7).map(|i| Q::from(i) * h))
}

#[test]
fn segment_matrices_of_the_uniform_cubic() -> Result<()> {
    for h in [Q::int(1), Q::frac(2, 3), Q::int(5)] {
        let space = uniform(3, &h)?;
        let (a, b) = (Q::int(4) * &h, Q::int(5) * &h);
        for k in 0..=2 {
            let gram = space.gram_between(&space, k, k, &a, &b)?.to_matrix()?;
            for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
                // The middle one of three spans carries the functions 1 to 4.
                let inside = (1..=4).contains(&i) && (1..=4).contains(&j);
                let expected = if inside { entry(k, i - 1, j - 1, &h) } else { Q::int(0) };
                assert_eq!(gram[(i, j)], expected, "order {k}, entry {i}, {j}, h = {h}");
            }
        }
    }
    Ok(())
}

/// The global matrix is the sum of those of the segments, shifted by one each.
#[test]
fn global_matrices_are_sums_of_segment_matrices() -> Result<()> {
    let h = Q::frac(3, 2);
    let space = uniform(5, &h)?;
    for k in 0..=2 {
        let gram = space.gram(&space, k, k)?.to_matrix()?;
        for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))) {
            let of_segment = |s: usize| match (usize::checked_sub(i, s), usize::checked_sub(j, s)) {
                (Some(i @ 0..4), Some(j @ 0..4)) => entry(k, i, j, &h),
                _ => Q::int(0),
            };
            let sum: Q = (0..5).map(of_segment).sum();
            assert_eq!(gram[(i, j)], sum, "order {k}, entry {i}, {j}");
        }
    }
    Ok(())
}

/// Null spaces: `K1` has the constants, `K2` the linear functions too, whose coefficients are the nodes.
#[test]
fn null_spaces_of_the_stiffness_matrices() -> Result<()> {
    let space = uniform(4, &Q::int(1))?;
    let (ones, nodes) = (vec![Q::int(1); space.dim()], space.greville());
    for (k, coeffs, vanishes) in
        [(1, &ones, true), (2, &ones, true), (2, &nodes, true), (0, &ones, false), (1, &nodes, false)]
    {
        let image = space.gram(&space, k, k)?.apply(coeffs)?;
        assert_eq!(image.iter().all(|x| *x == Q::int(0)), vanishes, "order {k} on {coeffs:?}");
    }
    Ok(())
}
