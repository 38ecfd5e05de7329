//! [Miura] (23) to (27): the conversion of Doo-Sabin surfaces, and how far it is off at a vertex in `n` faces with four sides.
//!
//! From the rules: with `q`, `a`, `c` the means of the new corners at the vertex, at its neighbours and across, the centre of the new
//! `n`-gon comes to rest at `((n + 185/64) q + 63/32 a + 9/64 c) / (n + 5)` once Catmull and Clark's rules have been applied twice.

use nalgebra::SVector;
use symspline::{Boundary, ControlMesh, DooSabin, Q, Result, Scalar};

/// The vertex 0 with `n` neighbours `1 ..= n`, the corners across from it behind them, and one vertex that all of these meet in.
fn star(n: usize) -> Vec<[usize; 4]> {
    let (near, far) = (|i: usize| 1 + i % n, |i: usize| 1 + n + i % n);
    let front = |i: usize| [0, near(i), far(i), near(i + 1)];
    let back = |i: usize| [near(i), far(i + n - 1), 1 + 2 * n, far(i)];
    (0..n).map(front).chain((0..n).map(back)).collect()
}

/// The weights of vertex 0, of each neighbour, and of each corner across, in the limits of the two surfaces at the vertex.
fn weights(n: usize) -> Result<[[Q; 3]; 2]> {
    let kind = |v: usize| (v > 0) as usize + (v > n) as usize;
    let unit = |v: usize| SVector::<Q, 3>::from_fn(|k, _| Q::int(i64::from(v <= 2 * n && k == kind(v))));
    let mesh = ControlMesh::new((0..2 * n + 2).map(unit).collect(), star(n))?;
    let surface = DooSabin::new(mesh, Boundary::Smooth);
    // Before the faces of vertices come those of 2 n faces and 4 n edges.
    let face = 6 * n;
    let doo_sabin = surface.refined(1)?.limit_points()?[face].clone();
    let converted = surface.converted()?;
    let topology = converted.mesh().topology();
    let centre = topology.vertex_count() + topology.edge_count() + face;
    let limits = converted.refined(1)?.limit_points()?;
    let catmull_clark = limits[centre].clone().expect("a closed surface");
    // All neighbours together have the weight of one component.
    let share = |sum: &SVector<Q, 3>| {
        let all = Q::int(n as i64);
        [sum[0].clone(), sum[1].clone() / &all, sum[2].clone() / &all]
    };
    Ok([share(&doo_sabin), share(&catmull_clark)])
}

#[test]
fn the_error_at_three_faces_is_that_of_the_paper() -> Result<()> {
    let [doo_sabin, catmull_clark] = weights(3)?;
    assert_eq!(doo_sabin, [Q::frac(9, 16), Q::frac(1, 8), Q::frac(1, 48)], "(25)");
    assert_eq!(catmull_clark, [Q::frac(629, 1152), Q::frac(223, 1728), Q::frac(77, 3456)], "(26)");
    let off = [0, 1, 2].map(|k| doo_sabin[k].clone() - &catmull_clark[k]);
    assert_eq!(off, [Q::frac(19, 1152), Q::frac(-7, 1728), Q::frac(-5, 3456)], "(27)");
    Ok(())
}

#[test]
fn the_error_at_any_number_of_faces_has_a_closed_form() -> Result<()> {
    for n in 3..10 {
        let (m, whole) = (n as i64, 144 * (n as i64 + 5));
        let [doo_sabin, catmull_clark] = weights(n)?;
        let expected = [Q::frac(9, 16), Q::frac(3, 8 * m), Q::frac(1, 16 * m)];
        assert_eq!(doo_sabin, expected, "{n} faces");
        let expected =
            [Q::frac(100 * m + 329, whole), Q::frac(40 * m + 326, whole * m), Q::frac(4 * m + 65, whole * m)];
        assert_eq!(catmull_clark, expected, "{n} faces");
        let off = [0, 1, 2].map(|k| doo_sabin[k].clone() - &catmull_clark[k]);
        let expected = [
            Q::frac(19 * (4 - m), whole),
            Q::frac(-14 * (4 - m), whole * m),
            Q::frac(-5 * (4 - m), whole * m),
        ];
        assert_eq!(off, expected, "{n} faces");
    }
    Ok(())
}
