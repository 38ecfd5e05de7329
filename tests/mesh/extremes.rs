//! Meshes and knot intervals at the ends of what there is.

use crate::grids::{Grid, Knots};
use crate::meshes::{board, boundary, square_pillow};
use crate::strategies::cases;
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeSet;
use symspline::{
    Boundary, CatmullClark, ControlMesh, DooSabin, Q, Result, Scalar, SplineSpace, Surface, Topology,
};

type Point = SVector<f64, 3>;

/// A pyramid: a face with `n` sides, and a vertex in `n` faces.
fn pyramid(n: usize) -> ControlMesh<f64, 3> {
    let turn = |i: usize| (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
    let ring = (0..n).map(|i| vector![turn(i).1, turn(i).0, 0.1 * (i * i % 5) as f64]);
    let faces = (0..n).map(|i| vec![i, (i + 1) % n, n]).chain([(0..n).rev().collect()]);
    ControlMesh::new(ring.chain([vector![0.0, 0.0, 1.0]]).collect(), faces).expect("a manifold")
}

/// Points that agree but for rounding; normals are found to about seven digits.
fn assert_close(what: &str, found: Result<Vec<Point>>, expected: Result<Vec<Point>>) {
    let (found, expected) =
        (found.unwrap_or_else(|error| panic!("{what}: {error}")), expected.expect("points"));
    assert_eq!(found.len(), expected.len(), "{what}");
    let near = if what.ends_with("normals") { 1e-6 } else { 1e-12 };
    found.iter().zip(&expected).for_each(|(p, q)| assert!((p - q).norm() < near, "{what}: {p} {q}"));
}

/// In more than linear time this would take minutes.
#[test]
fn great_faces_and_valences_take_linear_time() {
    let mesh = pyramid(20_000);
    let count = mesh.topology().edge_count();
    let catmull_clark = [
        CatmullClark::new(mesh.clone(), Boundary::Smooth),
        CatmullClark::with_intervals(mesh.clone(), vec![2.0; count], Boundary::Smooth).unwrap(),
    ];
    for surface in catmull_clark {
        assert_eq!(surface.refined(1).unwrap().mesh().topology().face_count(), 2 * count);
        assert_eq!(surface.limit_points().unwrap().len(), 20_001);
        assert_eq!(surface.limit_normals().unwrap().len(), 20_001);
    }
    let uneven = (0..count).map(|e| [1.0 + (e % 3) as f64, 2.0]).collect();
    let doo_sabin = [
        DooSabin::new(mesh.clone(), Boundary::Smooth),
        DooSabin::with_intervals(mesh, uneven, Boundary::Smooth).unwrap(),
    ];
    for surface in doo_sabin {
        assert_eq!(surface.refined(1).unwrap().mesh().topology().vertex_count(), 2 * count);
        assert_eq!(surface.converted().unwrap().mesh().topology().vertex_count(), 2 * count);
        assert_eq!(surface.limit_points().unwrap().len(), 20_001);
        assert_eq!(surface.limit_normals().unwrap().len(), 20_001);
    }
}

/// Of any number of sides.
#[test]
fn limits_of_uneven_faces_stay_where_they_are() {
    for n in [3, 4, 5, 6, 7, 9, 10, 31, 100] {
        let mesh = pyramid(n);
        let uneven = (0..mesh.topology().edge_count())
            .map(|e| [1.0 + (e * e % 7) as f64, 1.0 + (e % 3) as f64])
            .collect();
        let surface = DooSabin::with_intervals(mesh, uneven, Boundary::Smooth).unwrap();
        let later = surface.refined(1).unwrap().limit_points().map(|points| points[..=n].to_vec());
        assert_close("later", surface.limit_points(), later);
    }
}

/// The rules have products and sums of intervals, whose scale does not matter.
#[test]
fn intervals_are_of_any_size() {
    let points: Vec<Point> =
        (0..25).map(|k| vector![(k / 5) as f64, (k % 5) as f64, (k * k % 7) as f64]).collect();
    let mesh = ControlMesh::new(points, board(5, 5)).unwrap();
    let t = mesh.topology();
    let of = |e: usize| 1.0 + (e % 3) as f64;
    let along = |e: usize| if t.ends(e)[0].abs_diff(t.ends(e)[1]) == 1 { 1.0 } else { 3.0 };
    for boundary in [Boundary::Open, Boundary::Smooth, Boundary::Corners] {
        let cubic = |size: f64| {
            let d = (0..t.edge_count()).map(|e| along(e) * size).collect();
            CatmullClark::with_intervals(mesh.clone(), d, boundary).unwrap()
        };
        let quadratic = |size: f64| {
            let d = (0..t.edge_count()).map(|e| [of(e) * size, of(2 * e) * size]).collect();
            DooSabin::with_intervals(mesh.clone(), d, boundary).unwrap()
        };
        for size in [1e-300, 1e-200, 1e200, 4e307] {
            let refined = |size| cubic(size).refined(2).map(|s| s.mesh().points().to_vec());
            assert_close("cubic", refined(size), refined(1.0));
            let limits = |size| cubic(size).limit_points().map(|p| p.into_iter().flatten().collect());
            assert_close("cubic limits", limits(size), limits(1.0));
            let normals = |size| cubic(size).limit_normals().map(|p| p.into_iter().flatten().collect());
            assert_close("cubic normals", normals(size), normals(1.0));
            let refined = |size| quadratic(size).refined(2).map(|s| s.mesh().points().to_vec());
            assert_close("quadratic", refined(size), refined(1.0));
            let converted = |size| quadratic(size).converted().map(|s| s.mesh().points().to_vec());
            assert_close("converted", converted(size), converted(1.0));
            assert_close("limits", quadratic(size).limit_points(), quadratic(1.0).limit_points());
        }
    }
}

/// A vertex in two faces becomes a face with two sides.
#[test]
fn faces_with_two_sides_are_rational() -> Result<()> {
    let points: Vec<SVector<Q, 3>> =
        [[0, 0, 0], [4, 0, 1], [4, 4, 0], [0, 4, 1]].map(|p| p.map(Q::int).into()).to_vec();
    let pillow = DooSabin::new(ControlMesh::new(points, square_pillow())?, Boundary::Smooth);
    let sides = |t: &Topology| t.faces().map(|face| face.len()).collect::<Vec<_>>();
    let fine = pillow.refined(1)?;
    assert_eq!(sides(fine.mesh().topology()), [4, 4, 4, 4, 4, 4, 2, 2, 2, 2]);
    let finer = fine.refined(1)?;
    assert_eq!(finer.limit_points()?[..10], fine.limit_points()?);
    // The weights 7/8 and 1/8.
    let face = fine.mesh().topology().face(9).map(|v| &fine.mesh().points()[v]).collect::<Vec<_>>();
    let new = finer.mesh().topology().face(9).map(|v| &finer.mesh().points()[v]).collect::<Vec<_>>();
    assert_eq!(new[0] * Q::int(8), face[0] * Q::int(7) + face[1]);
    fine.converted()?.refined(2)?;
    Ok(())
}

/// Intervals of which two in a row may vanish.
fn longer_knots() -> impl Strategy<Value = Knots> {
    vec(0_i64..=2, 6..=8).prop_map(|mut d| {
        let n = d.len();
        for i in 0..n {
            if d[i] == 0 && (i < 2 || i + 2 >= n || d[i - 1] == 0 && d[i - 2] == 0) {
                d[i] = 3;
            }
        }
        Knots(d.into_iter().map(Q::int).collect())
    })
}

/// The vertices of a quadratic net have these intervals: the knots, with one more at each end.
fn quadratic(d: &[Q]) -> Result<SplineSpace<Q>> {
    let mut knots = vec![Q::int(0); 2];
    d.iter().for_each(|d| knots.push(knots[knots.len() - 1].clone() + d));
    knots.push(knots[knots.len() - 1].clone());
    SplineSpace::new(2, knots)
}

proptest! {
    #![proptest_config(cases(4))]

    #[test]
    fn triple_knots_are_those_of_the_b_spline(u in longer_knots(), v in longer_knots(), pool in vec([-9_i64..9, -9_i64..9], 81)) {
        let count = (u.0.len() + 1) * (v.0.len() + 1);
        let grid = Grid { u, v, points: pool[..count].iter().map(|p| p.map(Q::int).into()).collect() };
        let surface = grid.subdivided(Boundary::Open);
        prop_assert_eq!(grid.by_place(&surface.refined(1)?, 1, 0), grid.inserted(1));
        let (spline, n) = (grid.surface(), grid.sizes().1);
        let (us, vs) = (grid.u.places(), grid.v.places());
        for (k, limit) in surface.limit_points()?.iter().enumerate() {
            let inside = (1..us.len() - 1).contains(&(k / n)) && (1..n - 1).contains(&(k % n));
            let point = inside.then(|| spline.at(&us[k / n], &vs[k % n]));
            prop_assert_eq!(limit, &point.transpose()?, "vertex {}", k);
        }
    }

    /// Clamped or not: converted surfaces are clamped.
    #[test]
    fn of_grids_converted_surfaces_are_the_same(size in [3_usize..6, 3_usize..6], pool in vec([-9_i64..9, -9_i64..9], 25), d in vec(1_i64..4, 10), boundary in boundary()) {
        let [m, n] = size;
        let points: Vec<SVector<Q, 2>> = pool[..m * n].iter().map(|p| p.map(Q::int).into()).collect();
        let mesh = ControlMesh::new(points.clone(), board(m, n))?;
        let spans = |d: &[i64]| {
            let last = d.len() - 1;
            let end = |k: usize| boundary != Boundary::Open && (k == 0 || k == last);
            d.iter().enumerate().map(|(k, d)| Q::int(if end(k) { 0 } else { *d })).collect::<Vec<_>>()
        };
        let (du, dv) = (spans(&d[..m]), spans(&d[5..5 + n]));
        let intervals = mesh.topology().edges().map(|ends| {
            let in_row = ends[0].abs_diff(ends[1]) == 1;
            ends.map(|v| if in_row { dv[v % n].clone() } else { du[v / n].clone() })
        }).collect();
        let converted = DooSabin::with_intervals(mesh, intervals, boundary)?.converted()?;
        let spline = Surface::new(quadratic(&du)?, quadratic(&dv)?, points)?;
        // After two steps there is a vertex at all quarters of all spans.
        let places = |d: &[Q]| {
            let mut at = vec![d[0].clone()];
            for quarter in d[1..d.len() - 1].iter().map(|d| d.clone() / Q::int(4)) {
                (0..4).for_each(|_| at.push(at[at.len() - 1].clone() + &quarter));
            }
            at
        };
        let values = spline.eval_grid(&places(&du), &places(&dv))?;
        let found = converted.refined(2)?.limit_points()?;
        let key = |p: &SVector<Q, 2>| (p[0].to_string(), p[1].to_string());
        prop_assert_eq!(found.iter().flatten().map(key).collect::<BTreeSet<_>>(), values.iter().map(key).collect());
    }
}
