//! Subdivision: face rules, Chaikin's rule, knot intervals, conversion, limits.

use crate::check::{Answer, Golden, check, for_each, row};
use crate::data::{Case, Field};
use nalgebra::SVector;
use symspline::{
    Boundary, CatmullClark, ControlMesh, ControlPolygon, CubicPolygon, DooSabin, EdgeLoops, Q, Result,
    Scalar, Topology,
};

fn rows<T: Scalar, const N: usize>(points: &[SVector<T, N>]) -> Vec<Vec<T>> {
    points.iter().cloned().map(row).collect()
}

struct FaceRules;

impl Golden for FaceRules {
    const CATEGORY: &'static str = "face_rules";
    const CASES: usize = 3;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let n = case.get("n").integer();
        // The face at one end of a prism, whose other vertices do not matter.
        let next = |i: usize| (i + 1) % n;
        let side = |i: usize| vec![next(i), i, n + i, n + next(i)];
        let faces: Vec<_> = std::iter::once((0..n).collect())
            .chain((0..n).map(side))
            .chain([(n..2 * n).rev().collect()])
            .collect();
        let face = |mut points: Vec<SVector<T, 3>>| {
            points.extend((0..n).map(|i| SVector::from([i, i * i, 7]).map(|x| T::int(x as i64))));
            ControlMesh::new(points, &faces).map(|prism| DooSabin::new(prism, Boundary::Smooth))
        };
        // The weights of corner 0 in all corners: the same as of all in corner 0.
        let unit = |k: usize| SVector::from([T::int(i64::from(k == 0)), T::zero(), T::zero()]);
        let unit = face((0..n).map(unit).collect())?;
        let first = |points: &[SVector<T, 3>]| points[..n].iter().map(|p| p[0].clone()).collect::<Vec<_>>();
        let face = face(case.get("polygon").points())?;
        let mut found =
            vec![first(unit.refined(1)?.mesh().points()), first(unit.converted()?.mesh().points())];
        found.extend(rows(&face.refined(1)?.mesh().points()[..n]));
        found.extend(rows(&face.converted()?.mesh().points()[..n]));
        found.extend(rows(&face.limit_points()?[..1]));
        Ok(Answer::rows(found))
    }

    fn expected(case: Case) -> Answer<Q> {
        let mut rows = ["doo_sabin_weights", "convert_weights"].map(|key| case.get(key).numbers()).to_vec();
        rows.extend(["doo_sabin", "convert"].map(|key| case.get(key).rows()).concat());
        rows.push(case.get("centroid").numbers());
        Answer::rows(rows)
    }
}

#[test]
fn face_rules() {
    check::<FaceRules>();
}

struct Chaikin;

impl Golden for Chaikin {
    const CATEGORY: &'static str = "chaikin_closed";
    const CASES: usize = 1;
    const FACTOR: f64 = 2.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        let polygon = ControlPolygon::<T, 2>::closed(case.get("polygon").points())?;
        Ok(Answer::rows(rows(polygon.chaikin(1)?.points())))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("out").rows())
    }
}

#[test]
fn chaikin_closed() {
    check::<Chaikin>();
}

struct Limit;

impl Golden for Limit {
    const CATEGORY: &'static str = "valence3_limit";
    const CASES: usize = 1;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        // The three faces around vertex 0, and three around a vertex 7 opposite, which does not matter.
        let faces = [[0, 1, 4, 2], [0, 2, 5, 3], [0, 3, 6, 1], [1, 6, 7, 4], [2, 4, 7, 5], [3, 5, 7, 6]];
        let mut points: Vec<SVector<T, 3>> = case.get("P").points();
        points.push(SVector::from([T::int(100), T::int(-50), T::int(30)]));
        let surface = DooSabin::new(ControlMesh::new(points, faces)?, Boundary::Smooth);
        // Six faces are there before, then one an edge, then those of the vertices.
        let triangle = 6 + 12;
        let doo_sabin = surface.refined(1)?.limit_points()?[triangle].clone();
        let converted = surface.converted()?;
        let topology = converted.mesh().topology();
        let centre = topology.vertex_count() + topology.edge_count() + triangle;
        let limits = converted.refined(1)?.limit_points()?;
        let catmull_clark = limits[centre].clone().expect("a closed surface");
        let difference = &doo_sabin - &catmull_clark;
        Ok(Answer::rows([doo_sabin, catmull_clark, difference].map(row).to_vec()))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(
            ["doo_sabin_limit", "nurccs_limit", "difference"].map(|k| case.get(k).numbers()).to_vec(),
        )
    }
}

#[test]
fn valence3_limit() {
    check::<Limit>();
}

struct Midpoint;

impl Golden for Midpoint {
    const CATEGORY: &'static str = "nonuniform_cubic_midpoint";
    const CASES: usize = 1;
    const FACTOR: f64 = 4.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        // One more interval at each end, which does not matter here.
        let inner = case.get("intervals").numbers::<T>();
        let intervals = std::iter::once(T::one()).chain(inner).chain([T::one()]).collect();
        let polygon =
            CubicPolygon::<T, 2>::open(case.get("P").points(), Boundary::Open)?.with_intervals(intervals)?;
        let fine = polygon.refined(1)?;
        let _ = &fine;
        Ok(Answer::rows(rows(&[1, 2, 3].map(|i| fine.points()[2 * i].clone()))))
    }

    fn expected(case: Case) -> Answer<Q> {
        Answer::rows(case.get("edge_points").rows())
    }
}

#[test]
fn nonuniform_cubic_midpoint() {
    check::<Midpoint>();
}

struct Grid;

impl Golden for Grid {
    const CATEGORY: &'static str = "nurccs_grid";
    const CASES: usize = 3;
    const FACTOR: f64 = 8.0;

    fn found<T: Field>(case: Case) -> Result<Answer<T>> {
        const N: usize = 5;
        let points: Vec<SVector<T, 2>> = case.get("P").list().flat_map(Case::points).collect();
        let corner = |k: usize| {
            let v = k / (N - 1) * N + k % (N - 1);
            [v, v + N, v + N + 1, v + 1]
        };
        let mesh = ControlMesh::new(points, (0..(N - 1) * (N - 1)).map(corner))?;
        let (e, f) = (case.get("e").numbers::<T>(), case.get("f").numbers::<T>());
        let coarse = mesh.topology().clone();
        let interval = |[v, w]: [usize; 2]| match v / N == w / N {
            true => f[v.min(w) % N].clone(),
            false => e[v.min(w) / N].clone(),
        };
        let intervals = coarse.edges().map(interval).collect();
        let fine = CatmullClark::with_intervals(mesh, intervals, Boundary::Smooth)?.refined(1)?;
        // The old vertices come first, then the edges, then the faces.
        let (vertices, edges) = (coarse.vertex_count(), coarse.edge_count());
        let v = 2 * N + 2;
        let edge = |w: usize| vertices + coarse.edge_between(v, w).expect("an edge");
        let face = |i: usize, j: usize| vertices + edges + i * (N - 1) + j;
        let places = [
            v,
            edge(v - N),
            edge(v + N),
            edge(v - 1),
            edge(v + 1),
            face(1, 1),
            face(2, 1),
            face(2, 2),
            face(1, 2),
        ];
        Ok(Answer::rows(rows(&places.map(|place| fine.mesh().points()[place].clone()))))
    }

    fn expected(case: Case) -> Answer<Q> {
        let keys = ["vertex", "edge_u_minus", "edge_u_plus", "edge_v_minus", "edge_v_plus"];
        let mut rows = keys.map(|key| case.get(key).numbers()).to_vec();
        rows.extend(case.get("faces").rows());
        Answer::rows(rows)
    }
}

#[test]
fn nurccs_grid() {
    check::<Grid>();
}

/// The numbers of vertices, edges and faces, of knot intervals, of edges in loops, and of terms of the energy.
#[test]
fn conversion_topology() {
    for_each("conversion_topology", 2, |case| {
        let faces: Vec<Vec<usize>> =
            case.get("faces").list().map(|face| face.list().map(Case::integer).collect()).collect();
        let vertices = 1 + faces.iter().flatten().max().expect("faces");
        let points = vec![SVector::<Q, 1>::zeros(); vertices];
        let converted = DooSabin::new(ControlMesh::new(points, faces)?, Boundary::Smooth).converted()?;
        let topology: &Topology = converted.mesh().topology();
        let intervals = converted.intervals().expect("a surface with knot intervals");
        let count = |d: i64| intervals.iter().filter(|interval| **interval == Q::int(d)).count();
        let loops = EdgeLoops::new(topology)?;
        let mut lengths: Vec<usize> = (0..loops.count()).map(|i| loops.edges(i).len()).collect();
        lengths.sort_unstable();
        let pairs = |v: usize| topology.valence(v);
        let found = [
            ("V_out", topology.vertex_count()),
            ("E_out", topology.edge_count()),
            ("F_out", topology.face_count()),
            ("zero_interval_edges", count(0)),
            ("unit_interval_edges", count(1)),
            ("m1", lengths.iter().sum()),
            ("m2", (0..topology.vertex_count()).map(pairs).sum()),
        ];
        for (key, found) in found {
            assert_eq!(found, case.get(key).integer(), "{key} of {}", case.id());
        }
        let expected: Vec<usize> = case.get("loop_lengths").list().map(Case::integer).collect();
        assert_eq!(lengths, expected, "{}", case.id());
        Ok(())
    });
}
