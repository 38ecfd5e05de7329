//! [Vassilev] (8)-(11): matrices of one segment of the uniform cubic B-spline.
//!
//! Over one span of length `h` the four cubics that do not vanish have the Gram matrices
//! `∫ N_i^(k) N_j^(k)` for `k = 0, 1, 2`, here with their denominators.

use nalgebra::vector;
use symspline::{
    Breadth, Curve, Elastic, Function, Material, Q, Result, Scalar, SplineSpace, Spread, Stiffness, Surface,
};

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

/// (5) to (7): the material's matrix is the weighted sum of these.
#[test]
fn stiffness_is_the_weighted_sum() -> Result<()> {
    let h = Q::frac(2, 3);
    let space = uniform(5, &h)?;
    let (alpha, beta, gamma) = (Q::int(3), Q::frac(5, 7), Q::frac(1, 11));
    let material = Material::new(alpha.clone(), beta.clone())?.with_hardness(gamma.clone())?;
    let found = material.matrix(&space)?.to_matrix()?;
    for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))) {
        let of_segment = |k: usize, s: usize| match (usize::checked_sub(i, s), usize::checked_sub(j, s)) {
            (Some(i @ 0..4), Some(j @ 0..4)) => entry(k, i, j, &h),
            _ => Q::int(0),
        };
        let of_order = |k: usize| (0..5).map(|s| of_segment(k, s)).sum::<Q>();
        assert_eq!(found[(i, j)], &gamma * of_order(0) + &alpha * of_order(1) + &beta * of_order(2));
    }
    Ok(())
}

/// (10) to (12): the forcing matrix of the uniform cubic, `h` times (11) for each segment.
#[test]
fn forcing_matrix_is_a_sum_of_segments() -> Result<()> {
    let h = Q::frac(5, 2);
    let space = uniform(4, &h)?;
    let hard = Material::new(Q::int(0), Q::int(0))?.with_hardness(Q::int(1))?;
    let forcing = Stiffness::new(&space, &hard, &Breadth::Whole)?.forcing().to_matrix()?;
    let segment = [[4, 1], [33, 22], [22, 33], [1, 4]];
    for (j, i) in (0..5).flat_map(|j| (0..7).map(move |i| (j, i))) {
        let share = |s: usize| match (usize::checked_sub(i, s), usize::checked_sub(j, s)) {
            (Some(i @ 0..4), Some(j @ 0..2)) => Q::frac(segment[i][j], 120) * &h,
            _ => Q::int(0),
        };
        assert_eq!(forcing[(j, i)], (0..4).map(share).sum::<Q>(), "break {j}, coefficient {i}");
    }
    Ok(())
}

/// Section 2.3: without forces the curve contracts to the origin; with the forces that hold it, it stays.
#[test]
fn without_forces_everything_contracts_to_the_origin() -> Result<()> {
    let points = (0..7).map(|i| vector![Q::int(i * i), Q::int(3 - i)]).collect();
    let curve = Curve::new(uniform(4, &Q::int(1))?, points)?;
    let material = Material::new(Q::int(1), Q::int(2))?.with_hardness(Q::frac(1, 10))?;
    let elastic = Elastic::of(&curve, &material, &[Breadth::Whole])?;
    // K V_0 are those forces: taken away, they move the control points to zero.
    assert_eq!(elastic.solved(&elastic.gradient(curve.coeffs())?)?, curve.coeffs());
    Ok(())
}

/// Section 2.3: in general no forces at breaks hold a given curve, there are fewer of them than control points.
#[test]
fn forces_at_breaks_do_not_hold_every_curve() -> Result<()> {
    let space = SplineSpace::uniform(3, 4, Q::int(0), Q::int(1))?;
    let hard = Material::new(Q::int(1), Q::int(1))?.with_hardness(Q::int(1))?;
    let forcing = Stiffness::new(&space, &hard, &Breadth::Whole)?.forcing().clone();
    assert_eq!((forcing.target_dim(), forcing.source_dim()), (5, 7));
    Ok(())
}

/// Section 3.1: the larger `γ`, the narrower the deformation; the larger `β`, the broader.
#[test]
fn hardness_makes_deformations_narrow() -> Result<()> {
    let space = SplineSpace::uniform(3, 20, 0.0, 20.0)?;
    let width = |alpha: f64, beta: f64, gamma: f64| -> Result<f64> {
        let mut f = Function::constant(space.clone(), 0.0)?;
        let material = Material::new(alpha, beta)?.with_hardness(gamma)?;
        let elastic = Elastic::of(&f, &material, &[Breadth::BetweenEnds(1)])?;
        elastic.pull(&f, &10.0)?.move_to(&mut f, &1.0)?;
        Ok(f.coeffs().iter().map(|c| c.abs()).sum())
    };
    // The three materials of Fig. 5.
    let (a, b, c) = (width(1.0, 2.0, 0.1)?, width(1.0, 20.0, 0.1)?, width(1.0, 20.0, 0.5)?);
    assert!(b > 1.3 * a && c < b / 1.3, "{a} {b} {c}");
    Ok(())
}

/// (20) with the load of (17) and with the one that costs least: both move the point there, by different shapes.
#[test]
fn both_loads_move_the_point() -> Result<()> {
    let space = SplineSpace::uniform(3, 6, Q::int(0), Q::int(1))?;
    let curve = Curve::new(space, (0..9).map(|i| vector![Q::int(i), Q::int(0)]).collect())?;
    let elastic = Elastic::of(&curve, &Material::new(Q::int(1), Q::int(1))?, &[Breadth::BetweenEnds(1)])?;
    let (at, target) = (Q::frac(5, 11), vector![Q::int(4), Q::int(2)]);
    let material = elastic.stiffnesses()[0].material().clone();
    let moved = |spread: Spread| -> Result<Curve<Q, 2>> {
        let mut moved = curve.clone();
        elastic.clone().with_spread(spread).pull(&curve, &at)?.move_to(&mut moved, &target)?;
        assert_eq!(moved.at(&at)?, target);
        Ok(moved)
    };
    let (hat, point) = (moved(Spread::Hat)?, moved(Spread::Point)?);
    assert_ne!(hat, point);
    let cost = |moved: &Curve<Q, 2>| material.energy(&moved.difference(&curve)?);
    assert!(cost(&point)? < cost(&hat)?);
    Ok(())
}

/// (31): the displacements of a surface under one force are a product of those of curves; materials may differ.
#[test]
fn surfaces_answer_one_force_by_a_product() -> Result<()> {
    let u = SplineSpace::uniform(3, 4, Q::int(0), Q::int(1))?;
    let v = SplineSpace::uniform(2, 3, Q::int(0), Q::int(1))?;
    let [soft, stiff] = [(1, 2), (5, 0)].map(|(alpha, beta)| Material::new(Q::int(alpha), Q::int(beta)));
    let along_u = Stiffness::new(&u, &soft?, &Breadth::BetweenEnds(1))?;
    let along_v = Stiffness::new(&v, &stiff?, &Breadth::BetweenEnds(1))?;
    let (x, y) = (Q::frac(1, 3), Q::frac(2, 5));
    let (v_u, v_v) = (along_u.response(&along_u.hat_load(&x)?)?, along_v.response(&along_v.hat_load(&y)?)?);
    let flat = Surface::constant(u, v, vector![Q::int(0), Q::int(0), Q::int(0)])?;
    let elastic = Elastic::surface(along_u, along_v);
    let mut pushed = flat.clone();
    elastic.pull(&flat, &(x, y))?.push(&mut pushed, &vector![Q::int(0), Q::int(0), Q::int(7)])?;
    for (i, row) in pushed.rows().enumerate() {
        for (j, point) in row.iter().enumerate() {
            assert_eq!(point[2], &v_u[i] * &v_v[j] * Q::int(7), "{i}, {j}");
        }
    }
    Ok(())
}
