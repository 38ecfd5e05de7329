//! Laws of the points and normals of a surface at the vertices of its mesh.

use crate::catmull_clark::surfaces;
use crate::grids::grid;
use crate::meshes::{any_mesh, faces, mesh, pool, prism, torus};
use crate::strategies::cases;
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Boundary, CatmullClark, ControlMesh, DooSabin, Error, MeshError, Q, Scalar, Surface};

fn floats(mesh: &ControlMesh<Q, 3>) -> ControlMesh<f64, 3> {
    mesh.to_f64().expect("small numbers")
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn of_grids_they_are_points_of_the_b_spline(grid in grid()) {
        let (surface, n) = (grid.surface(), grid.sizes().1);
        let limits = grid.subdivided(Boundary::Open).limit_points()?;
        let (us, vs) = (grid.u.places(), grid.v.places());
        for (k, limit) in limits.iter().enumerate() {
            let inside = (1..us.len() - 1).contains(&(k / n)) && (1..n - 1).contains(&(k % n));
            let point = inside.then(|| surface.at(&us[k / n], &vs[k % n]));
            prop_assert_eq!(limit, &point.transpose()?, "vertex {}", k);
        }
    }

    #[test]
    fn corners_have_the_limits_of_the_mirrored_grid(grid in grid()) {
        let (m, n) = grid.sizes();
        let wide = grid.extended().subdivided(Boundary::Open).limit_points()?;
        for (k, limit) in grid.subdivided(Boundary::Corners).limit_points()?.iter().enumerate() {
            prop_assert_eq!(limit, &wide[(k / n + 2) * (n + 4) + k % n + 2], "vertex {} of {} by {}", k, m, n);
        }
    }

    #[test]
    fn refined_vertices_have_the_same_limit(surface in surfaces(), uniform in any::<bool>()) {
        let boundary = if surface.boundary() == Boundary::Open { Boundary::Corners } else { surface.boundary() };
        let mesh = surface.mesh().clone();
        let surface = match surface.intervals() {
            Some(d) if !uniform => CatmullClark::with_intervals(mesh, d.to_vec(), boundary)?,
            _ => CatmullClark::new(mesh, boundary),
        };
        match surface.limit_points() {
            Ok(limits) => {
                prop_assert!(limits.iter().all(Option::is_some));
                match surface.refined(1)?.limit_points() {
                    Ok(fine) => prop_assert_eq!(&fine[..limits.len()], &limits[..]),
                    // One of the new vertices.
                    Err(Error::Mesh(MeshError::Unsettled { vertex })) => prop_assert!(vertex >= limits.len()),
                    Err(error) => return Err(error.into()),
                }
            }
            Err(error) => {
                let unsettled = matches!(error, Error::Mesh(MeshError::Unsettled { .. }));
                prop_assert!(unsettled && surface.intervals().is_some(), "{}", error);
            }
        }
    }

    #[test]
    fn open_vertices_inside_have_the_same_limit(mesh in any_mesh()) {
        let surface = CatmullClark::new(mesh, Boundary::Open);
        let smooth = CatmullClark::new(surface.mesh().clone(), Boundary::Smooth).limit_points()?;
        let t = surface.mesh().topology();
        for (v, limit) in surface.limit_points()?.iter().enumerate() {
            prop_assert_eq!(limit.is_none(), t.is_boundary(v));
            // What is inside by two faces does not know of the boundary.
            let deep = t.leaving(v).flat_map(|h| t.face(t.face_of(h))).all(|w| !t.is_boundary(w));
            if deep {
                prop_assert_eq!(limit, &smooth[v]);
            }
        }
    }

    /// [Miura] (26), corrected: 223/1728.
    #[test]
    fn where_three_faces_of_a_doo_sabin_mesh_meet(pool in pool::<3>()) {
        let coarse = mesh(&prism(4), &pool);
        let converted = DooSabin::new(coarse.clone(), Boundary::Smooth).converted()?;
        let (old, t) = (coarse.topology(), converted.mesh().topology());
        let limits = converted.refined(1)?.limit_points()?;
        let p = coarse.points();
        // The triangles of the vertices come last.
        for (v, f) in (0..8).zip(t.face_count() - 8..) {
            let near = old.leaving(v).fold(SVector::zeros(), |sum, h| sum + &p[old.target(h)]);
            let far = old.leaving(v).fold(SVector::zeros(), |sum, h| sum + &p[old.target(old.next(h))]);
            let expected = &p[v] * Q::frac(629, 1152) + near * Q::frac(223, 1728) + far * Q::frac(77, 3456);
            prop_assert_eq!(&limits[t.vertex_count() + t.edge_count() + f], &Some(expected));
        }
    }

    #[test]
    fn vertices_tend_to_their_limits(mesh in any_mesh()) {
        let surface = CatmullClark::new(floats(&mesh), Boundary::Smooth);
        let size = mesh.points().iter().flat_map(|p| p.iter().map(Q::to_f64)).fold(0.0, |m: f64, x| m.max(x.abs()));
        let (limits, near) = (surface.limit_points()?, surface.refined(4)?);
        for (limit, point) in limits.iter().flatten().zip(near.mesh().points()) {
            prop_assert!((limit - point).norm() <= 0.1 * size);
        }
    }

    #[test]
    fn refined_vertices_have_the_same_normal(faces in faces(), pool in vec(vec(-9_i64..=9, 3), 19), corners in any::<bool>()) {
        // Of numbers of one size: what is flat but for rounding has no normal.
        let pool: Vec<_> = pool.iter().map(|p| SVector::<Q, 3>::from_fn(|i, _| Q::int(p[i]))).collect();
        let mesh = mesh(&faces, &pool);
        let boundary = if corners { Boundary::Corners } else { Boundary::Smooth };
        let surface = CatmullClark::new(floats(&mesh), boundary);
        let fine = surface.refined(2)?.limit_normals()?;
        let t = mesh.topology();
        for (v, (coarse, fine)) in surface.limit_normals()?.into_iter().zip(fine).enumerate() {
            let smooth_corner = boundary == Boundary::Smooth && t.is_boundary(v) && t.valence(v) == 2;
            if let (Some(n), Some(m), false) = (coarse, fine, smooth_corner) {
                prop_assert!((n - m).norm() < 1e-4, "vertex {}: {} {}", v, n, m);
            }
        }
    }

    #[test]
    fn of_grids_normals_are_those_of_the_b_spline(grid in grid(), heights in vec(-9_i64..=9, 36)) {
        let n = grid.sizes().1;
        let lift = |k: usize| vector![3 * (k / n) as i64, 3 * (k % n) as i64, heights[k]].map(Q::int);
        let points: Vec<_> = (0..grid.points.len()).map(lift).collect();
        let surface = Surface::new(grid.u.space(), grid.v.space(), points.clone())?.to_f64()?;
        let d = grid.intervals().iter().map(Q::to_f64).collect();
        let mesh = floats(&grid.mesh().with_points(points)?);
        let normals = CatmullClark::with_intervals(mesh, d, Boundary::Open)?.limit_normals()?;
        let (us, vs) = (grid.u.places(), grid.v.places());
        let simple = |at: &[Q], i: usize| at[i - 1] < at[i] && at[i] < at[i + 1];
        for i in (1..us.len() - 1).filter(|i| simple(&us, *i)) {
            for j in (1..n - 1).filter(|j| simple(&vs, *j)) {
                let expected = surface.unit_normal_at(&us[i].to_f64(), &vs[j].to_f64())?;
                let found = normals[i * n + j].unwrap();
                prop_assert!((found - expected).norm() < 1e-9, "{} {}", found, expected);
            }
        }
    }
}

/// By symmetry: the ends of a prism over a polygon with `n` corners, joined to a vertex on the axis.
#[test]
fn normals_on_an_axis_run_along_it() {
    for n in 3..9 {
        let turn = |i: usize| (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
        let ring = |z: f64| (0..n).map(move |i| vector![turn(i).1, turn(i).0, z]);
        let points = ring(-1.0).chain(ring(1.0)).chain([vector![0.0, 0.0, 1.5]]).collect::<Vec<_>>();
        let mut faces = prism(n);
        faces.pop();
        faces.extend((0..n).map(|i| vec![n + i, n + (i + 1) % n, 2 * n]));
        let surface = CatmullClark::new(ControlMesh::new(points, faces).unwrap(), Boundary::Smooth);
        let normal = surface.limit_normals().unwrap()[2 * n].unwrap();
        assert!((normal - vector![0.0, 0.0, 1.0]).norm() < 1e-12, "{n}: {normal}");
    }
}

/// Floats settle where exact numbers cannot, and find the point to which refinement tends.
#[test]
fn unequal_intervals_around_a_cube() {
    let points: Vec<SVector<Q, 3>> =
        (0..8).map(|i| SVector::from([i % 4 / 2, i / 4, (i % 4 + 1) % 4 / 2].map(Q::int))).collect();
    let cube = ControlMesh::new(points, prism(4)).unwrap();
    let d: Vec<Q> = (0..12).map(|e| Q::int(1 + e % 3)).collect();
    let exact = CatmullClark::with_intervals(cube.clone(), d.clone(), Boundary::Smooth).unwrap();
    assert!(matches!(exact.limit_points(), Err(Error::Mesh(MeshError::Unsettled { .. }))));
    let d = d.iter().map(Q::to_f64).collect();
    let surface = CatmullClark::with_intervals(floats(&cube), d, Boundary::Smooth).unwrap();
    let limits = surface.limit_points().unwrap();
    let near = surface.refined(7).unwrap();
    for (limit, point) in limits.iter().flatten().zip(near.mesh().points()) {
        assert!((limit - point).norm() < 1e-3);
    }
    assert!(surface.limit_normals().unwrap().iter().all(Option::is_some));
}

#[test]
fn the_limit_mesh_of_a_torus_is_closed() {
    let points: Vec<SVector<Q, 3>> =
        (0..12).map(|i| SVector::from([i, i * i % 7, i % 5].map(Q::int))).collect();
    let surface = CatmullClark::new(mesh(&torus(3, 4), &points), Boundary::Open);
    let limits = surface.limit_mesh().unwrap();
    assert!(limits.topology().is_closed());
    assert_eq!(limits.points()[5], surface.limit_points().unwrap()[5].clone().unwrap());
}
