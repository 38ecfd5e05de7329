//! Laws of Catmull and Clark's subdivision.

use crate::grids::{Grid, Knots, grid};
use crate::meshes::{any_mesh, boundary, closed, interval, intervals, mesh, pool, prism};
use crate::strategies::{cases, number, point};
use nalgebra::{SMatrix, SVector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Boundary, CatmullClark, Curve, Error, MeshError, Q, Scalar, SplineSpace};

type Surface = CatmullClark<Q, 3>;

/// The surface with intervals, or without.
fn surface(mesh: symspline::ControlMesh<Q, 3>, pool: &Option<Vec<Q>>, boundary: Boundary) -> Surface {
    match pool {
        Some(pool) => {
            let d = intervals(&mesh, pool);
            CatmullClark::with_intervals(mesh, d, boundary).expect("an interval an edge")
        }
        None => CatmullClark::new(mesh, boundary),
    }
}

/// A surface of any sort, with a vertex inside.
pub fn surfaces() -> impl Strategy<Value = Surface> {
    (any_mesh(), proptest::option::of(vec(interval(), 11)), boundary()).prop_map(|(mesh, pool, boundary)| {
        let t = mesh.topology();
        let empty = (0..t.vertex_count()).all(|v| t.is_boundary(v));
        surface(mesh, &pool, if empty { Boundary::Smooth } else { boundary })
    })
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn of_grids_it_is_knot_insertion(grid in grid(), depth in 1_usize..=2) {
        let refined = grid.subdivided(Boundary::Open).refined(depth)?;
        prop_assert_eq!(grid.by_place(&refined, depth, 0), grid.inserted(depth));
    }

    #[test]
    fn corners_are_those_of_the_grid_mirrored_at_the_boundary(grid in grid(), depth in 1_usize..=2) {
        let wider = grid.extended();
        let refined = wider.subdivided(Boundary::Open).refined(depth)?;
        let wide = wider.by_place(&refined, depth, -2);
        let refined = grid.subdivided(Boundary::Corners).refined(depth)?;
        for (place, point) in grid.by_place(&refined, depth, 0) {
            prop_assert_eq!(&wide[&place], &point, "at {:?}", place);
        }
    }

    #[test]
    fn corners_and_smooth_boundaries_differ_there_alone(mesh in any_mesh(), pool in proptest::option::of(vec(interval(), 11))) {
        let [smooth, corners] = [Boundary::Smooth, Boundary::Corners].map(|b| surface(mesh.clone(), &pool, b).refined(1));
        let (smooth, corners) = (smooth?, corners?);
        let t = smooth.mesh().topology();
        for v in (0..t.vertex_count()).filter(|v| !t.is_boundary(*v)) {
            prop_assert_eq!(&smooth.mesh().points()[v], &corners.mesh().points()[v]);
        }
        let t = mesh.topology();
        for v in (0..t.vertex_count()).filter(|v| t.valence(*v) == 2 && t.is_boundary(*v)) {
            prop_assert_eq!(&corners.mesh().points()[v], &mesh.points()[v]);
        }
    }

    #[test]
    fn equal_intervals_are_the_uniform_scheme(mesh in any_mesh(), boundary in boundary(), d in (1_i64..=5, 1_i64..=3), depth in 1_usize..=2) {
        let all = vec![Q::frac(d.0, d.1); mesh.topology().edge_count()];
        let with = CatmullClark::with_intervals(mesh.clone(), all, boundary)?.refined(depth);
        match CatmullClark::new(mesh, boundary).refined(depth) {
            Ok(uniform) => {
                let with = with?;
                prop_assert_eq!(with.mesh(), uniform.mesh());
                let halved = Q::frac(d.0, d.1 << depth);
                prop_assert!(with.intervals().into_iter().flatten().all(|d| *d == halved));
            }
            Err(error) => {
                prop_assert_eq!(&error, &Error::from(MeshError::NothingInside { what: "vertex" }));
                prop_assert_eq!(with, Err(error));
            }
        }
    }

    #[test]
    fn subdivision_commutes_with_affine_maps(surface in surfaces(), a in vec(number(), 9), b in point::<3>()) {
        let a = SMatrix::<Q, 3, 3>::from_fn(|i, j| a[3 * i + j].clone());
        let map = |surface: &Surface| {
            let points = surface.mesh().points().iter().map(|p| &a * p + &b).collect();
            let mesh = surface.mesh().with_points(points).unwrap();
            match surface.intervals() {
                Some(d) => CatmullClark::with_intervals(mesh, d.to_vec(), surface.boundary()).unwrap(),
                None => CatmullClark::new(mesh, surface.boundary()),
            }
        };
        prop_assert_eq!(map(&surface).refined(1)?, map(&surface.refined(1)?));
    }

    #[test]
    fn steps_follow_each_other(surface in surfaces()) {
        prop_assert_eq!(&surface.refined(0)?, &surface);
        prop_assert_eq!(surface.refined(1)?.refined(1)?, surface.refined(2)?);
    }

    #[test]
    fn intervals_scale(mesh in any_mesh(), pool in vec(interval(), 11), boundary in boundary(), scale in (1_i64..=5, 1_i64..=3)) {
        let scale = Q::frac(scale.0, scale.1);
        let scaled = pool.iter().map(|d| d.clone() * &scale).collect();
        let refined = surface(mesh.clone(), &Some(pool), boundary).refined(2);
        let other = surface(mesh, &Some(scaled), boundary).refined(2);
        prop_assert_eq!(refined.map(|s| s.mesh().clone()), other.map(|s| s.mesh().clone()));
    }

    #[test]
    fn closed_meshes_stay_closed(faces in closed(), pool in pool::<3>(), depth in 1_usize..=3) {
        let coarse = CatmullClark::new(mesh(&faces, &pool), Boundary::Smooth);
        let fine = coarse.refined(depth)?;
        let (old, new) = (coarse.mesh().topology(), fine.mesh().topology());
        prop_assert!(new.is_closed());
        prop_assert_eq!(new.euler_characteristic(), old.euler_characteristic());
        prop_assert_eq!(new.face_count(), old.half_edge_count() << (2 * (depth - 1)));
    }

    #[test]
    fn smooth_boundaries_are_closed_cubics(mesh in any_mesh(), pool in vec(interval(), 11)) {
        let pool: Vec<Q> = pool.into_iter().map(|d| if d == Q::int(0) { Q::frac(2, 3) } else { d }).collect();
        let surface = surface(mesh, &Some(pool), Boundary::Smooth);
        let fine = surface.refined(1)?;
        let (t, d) = (surface.mesh().topology(), surface.intervals().unwrap());
        for chain in t.boundaries() {
            // A control point has its knot in the middle: coefficient 1 of a periodic cubic has the seam there.
            let n = chain.len();
            let of = |h: usize| d[t.edge_of(chain[h % n])].clone();
            let mut knots = vec![Q::int(0)];
            for i in 1..n {
                knots.push(knots[i - 1].clone() + of(i - 1));
            }
            let period = knots[n - 1].clone() + of(n - 1);
            let space = SplineSpace::periodic(3, knots, period)?;
            let points: Vec<_> = chain.iter().map(|h| surface.mesh().points()[t.origin(*h)].clone()).collect();
            let turned = |of: &[SVector<Q, 3>]| (0..of.len()).map(|i| of[(i + of.len() - 1) % of.len()].clone()).collect::<Vec<_>>();
            let curve = Curve::new(space.clone(), turned(&points))?;
            let fine_curve = curve.embedded(&space.bisected()?)?;
            let halves = chain.iter().flat_map(|h| [t.origin(*h), t.vertex_count() + t.edge_of(*h)]);
            let halves: Vec<_> = halves.map(|v| fine.mesh().points()[v].clone()).collect();
            prop_assert_eq!(fine_curve.coeffs(), &turned(&halves)[..]);
        }
    }
}

#[test]
fn depths_out_of_reach_are_refused_at_once() {
    let points =
        (0..8_i64).map(|i| SVector::from([i & 1, (i >> 1) & 1, i >> 2].map(Q::int))).collect::<Vec<_>>();
    let cube = CatmullClark::new(mesh(&prism(4), &points), Boundary::Smooth);
    for depth in [13, 31, 32, 64, 1 << 40, usize::MAX] {
        assert!(matches!(cube.refined(depth), Err(Error::TooLarge { .. })), "{depth}");
    }
}

/// The case `nurccs_grid-pub-01` of the golden file.
#[test]
fn a_vertex_of_a_grid_with_intervals() {
    let points = [
        [[3, -2], [-9, -1], [-7, 6], [1, 7], [3, 6]],
        [[7, -6], [-4, 4], [-5, 0], [7, -8], [-4, 4]],
        [[7, 8], [6, 6], [0, 3], [-7, 4], [-7, 1]],
        [[-3, 0], [0, 9], [6, -1], [-1, -4], [-6, 4]],
        [[-2, 3], [8, 3], [2, -1], [-5, -4], [-3, -1]],
    ];
    let [u, v] = [[1, 2, 3, 1], [2, 1, 1, 3]].map(|d| Knots(d.map(Q::int).to_vec()));
    let grid =
        Grid { u, v, points: points.concat().into_iter().map(|p| SVector::from(p.map(Q::int))).collect() };
    let fine = grid.subdivided(Boundary::Smooth).refined(1).unwrap();
    let t = grid.mesh();
    let edge = |w: usize| &fine.mesh().points()[25 + t.topology().edge_between(12, w).unwrap()];
    assert_eq!(fine.mesh().points()[12].as_slice(), [Q::frac(-81, 400), Q::frac(21263, 9600)]);
    assert_eq!(edge(7).as_slice(), [Q::frac(-319, 120), Q::frac(31, 32)]);
    assert_eq!(edge(13).as_slice(), [Q::frac(-63, 50), Q::frac(233, 150)]);
}
