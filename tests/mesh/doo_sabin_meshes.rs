//! Doo-Sabin surfaces over meshes of any sort.

use crate::meshes::{any_mesh, boundary, interval};
use crate::nets::sorted;
use crate::strategies::cases;
use nalgebra::{SMatrix, SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeSet;
use symspline::{Boundary, ControlMesh, DooSabin, Error, MeshError, Q, Result, Scalar};

/// Whether the weights of a face are rational.
fn rational(sides: usize) -> bool {
    matches!(sides, 3 | 4 | 6)
}

/// A surface with knot intervals or without, whose first step is rational.
fn surface() -> impl Strategy<Value = DooSabin<Q, 3>> {
    let exact = |mesh: &ControlMesh<Q, 3>| mesh.topology().faces().all(|face| rational(face.len()));
    let meshes = any_mesh().prop_filter("irrational weights", exact);
    (meshes, boundary(), any::<bool>(), vec(interval(), 23)).prop_map(|(mesh, boundary, even, pool)| {
        let deal = |e: usize| [e * e + 5 * e, 3 * e + 1].map(|k| pool[k % pool.len()].clone());
        let intervals = (0..mesh.topology().edge_count()).map(deal).collect();
        match even {
            true => DooSabin::new(mesh, boundary),
            false => DooSabin::with_intervals(mesh, intervals, boundary).expect("two intervals an edge"),
        }
    })
}

fn with_points(surface: &DooSabin<Q, 3>, points: Vec<SVector<Q, 3>>) -> Result<DooSabin<Q, 3>> {
    let mesh = surface.mesh().with_points(points)?;
    match surface.intervals() {
        None => Ok(DooSabin::new(mesh, surface.boundary())),
        Some(d) => DooSabin::with_intervals(mesh, d.to_vec(), surface.boundary()),
    }
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn affine_maps_go_before_or_after(surface in surface(), entries in vec(-3_i64..4, 12)) {
        let entries: Vec<Q> = entries.into_iter().map(Q::int).collect();
        let linear = SMatrix::<Q, 3, 3>::from_column_slice(&entries[..9]);
        let shift = SVector::<Q, 3>::from_column_slice(&entries[9..]);
        let map = |points: &[SVector<Q, 3>]| points.iter().map(|p| &linear * p + &shift).collect::<Vec<_>>();
        let mapped = with_points(&surface, map(surface.mesh().points()))?;
        let (before, after) = (mapped.refined(1)?, surface.refined(1)?);
        prop_assert_eq!(before.mesh().points(), &map(after.mesh().points())[..]);
        let (before, after) = (mapped.converted()?, surface.converted()?);
        prop_assert_eq!(before.mesh().points(), &map(after.mesh().points())[..]);
        if let Ok(limits) = surface.limit_points() {
            prop_assert_eq!(mapped.limit_points()?, map(&limits));
        }
    }

    #[test]
    fn the_shape_of_the_mesh_is_kept(surface in surface()) {
        let (coarse, fine) = (surface.mesh().topology().clone(), surface.refined(1)?);
        let fine = fine.mesh().topology();
        prop_assert_eq!(coarse.euler_characteristic(), fine.euler_characteristic());
        prop_assert_eq!(coarse.boundaries().len(), fine.boundaries().len());
        // Four edges meet everywhere, at the boundary two to four.
        for v in 0..fine.vertex_count() {
            let valence = fine.valence(v);
            let fits = if fine.is_boundary(v) { (2..=4).contains(&valence) } else { valence == 4 };
            prop_assert!(fits, "{} edges at vertex {}", valence, v);
        }
    }

    /// The rules know no left and right.
    #[test]
    fn surfaces_turned_over_are_the_same(surface in surface()) {
        let (mesh, topology) = (surface.mesh(), surface.mesh().topology());
        let over = topology.faces().map(|mut face| {
            face.reverse();
            face
        });
        let over = ControlMesh::new(mesh.points().to_vec(), over)?;
        let over = match surface.intervals() {
            None => DooSabin::new(over, surface.boundary()),
            Some(d) => {
                let pair = |[v, w]: [usize; 2]| {
                    let e = topology.edges_at(v).find(|e| topology.ends(*e).contains(&w)).expect("the same edges");
                    let mut pair = d[e].clone();
                    if topology.ends(e) != [v, w] {
                        pair.reverse();
                    }
                    pair
                };
                let intervals = over.topology().edges().map(pair).collect();
                DooSabin::with_intervals(over, intervals, surface.boundary())?
            }
        };
        prop_assert_eq!(sorted(over.refined(1)?.mesh().points()), sorted(surface.refined(1)?.mesh().points()));
        prop_assert_eq!(sorted(over.converted()?.mesh().points()), sorted(surface.converted()?.mesh().points()));
        prop_assert_eq!(over.limit_points().ok(), surface.limit_points().ok());
    }

    #[test]
    fn limits_stay_where_they_are(surface in surface()) {
        let fine = surface.refined(1)?;
        match surface.limit_points() {
            Ok(limits) => {
                // Of the new faces the old ones come first.
                match fine.limit_points() {
                    Ok(later) => prop_assert_eq!(&later[..limits.len()], &limits[..]),
                    Err(Error::Mesh(MeshError::IrrationalWeights { .. } | MeshError::NoLimit { .. })) => {}
                    Err(error) => return Err(error.into()),
                }
            }
            Err(Error::Mesh(MeshError::NoLimit { what: "face", index })) => {
                let topology = surface.mesh().topology();
                let touches = topology.face(index).filter(|v| topology.is_boundary(*v)).count() > 1;
                let flat = surface.intervals().is_some_and(|d| d.iter().flatten().any(|d| *d == Q::int(0)));
                prop_assert!(touches && surface.boundary() != Boundary::Open || flat);
            }
            Err(error) => return Err(error.into()),
        }
    }

    #[test]
    fn boundaries_are_cut_as_polygons_are(surface in surface()) {
        let (coarse, fine) = (surface.mesh(), surface.refined(1)?);
        let even = surface.intervals().is_none() && surface.boundary() != Boundary::Open;
        let alone = |v: usize| coarse.topology().valence(v) == 2;
        let rounds = coarse.topology().boundaries();
        let smooth = rounds.iter().flatten().all(|h| !alone(coarse.topology().origin(*h)));
        let key = |p: &SVector<Q, 3>| p.iter().map(Q::to_string).collect::<Vec<_>>();
        let mut cut = BTreeSet::new();
        for h in rounds.iter().flatten() {
            let [p, q] = [coarse.topology().origin(*h), coarse.topology().target(*h)].map(|v| &coarse.points()[v]);
            let third = |p: &SVector<Q, 3>, q: &SVector<Q, 3>| (p * Q::int(3) + q) / Q::int(4);
            cut.extend([key(&third(p, q)), key(&third(q, p))]);
        }
        let topology = fine.mesh().topology();
        let found: BTreeSet<_> = topology.boundaries().iter().flatten()
            .map(|h| key(&fine.mesh().points()[topology.origin(*h)])).collect();
        if even && smooth {
            prop_assert_eq!(found, cut);
        }
    }
}

/// Faces with any number of sides, over floats.
#[test]
fn normals_are_those_of_small_faces() -> Result<()> {
    let around = |n: usize, z: f64| {
        (0..n).map(move |k| {
            let angle = std::f64::consts::TAU * k as f64 / n as f64;
            vector![angle.cos(), angle.sin(), z + 0.1 * (k * k % 5) as f64]
        })
    };
    for n in [3, 4, 5, 7, 9] {
        // A prism, closed or with its upper end open, with knot intervals or without.
        let points: Vec<_> = around(n, 0.0).chain(around(n, 1.0)).collect();
        let side = |i: usize| vec![i, (i + 1) % n, (i + 1) % n + n, i + n];
        let ends = [(0..n).rev().collect::<Vec<_>>(), (n..2 * n).collect()];
        for faces in [
            (0..n).map(side).chain(ends.clone()).collect::<Vec<_>>(),
            (0..n).map(side).chain([ends[0].clone()]).collect(),
        ] {
            let mesh = ControlMesh::new(points.clone(), faces)?;
            let deal = |e: usize| [1.0 + (e % 3) as f64, 1.0 + (e * e % 2) as f64];
            let intervals: Vec<_> = (0..mesh.topology().edge_count()).map(deal).collect();
            let even = DooSabin::new(mesh.clone(), Boundary::Smooth);
            for surface in [even, DooSabin::with_intervals(mesh, intervals, Boundary::Smooth)?] {
                let normals = surface.limit_normals()?;
                let limits = surface.limit_points()?;
                let fine = surface.refined(5)?;
                for f in 0..surface.mesh().topology().face_count() {
                    let face: Vec<_> =
                        fine.mesh().topology().face(f).map(|v| fine.mesh().points()[v]).collect();
                    let ahead = face.iter().skip(1).chain(&face);
                    let area: SVector<f64, 3> =
                        face.iter().zip(ahead).map(|(p, q)| (p - limits[f]).cross(&(q - limits[f]))).sum();
                    let normal = normals[f].expect("a tangent plane");
                    assert!((normal - area.normalize()).norm() < 0.05, "face {f} of {n}: {normal} {area}");
                    let size = face.iter().map(|p| (p - limits[f]).norm()).fold(0.0, f64::max);
                    assert!(size < 0.2, "face {f} shrinks");
                }
            }
        }
    }
    Ok(())
}
