//! Meshes of all sorts: closed and bounded, with faces and vertices of many valences.

use crate::strategies::point;
use nalgebra::SVector;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::collections::BTreeMap;
use symspline::{Boundary, ControlMesh, Q, Scalar, Topology};

/// The corners of all faces.
pub type Faces = Vec<Vec<usize>>;

pub fn tetrahedron() -> Faces {
    vec![vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![2, 0, 3]]
}

pub fn octahedron() -> Faces {
    stellated(&square_pillow(), 0, 1)
}

/// Two squares, back to back: a vertex in two faces has the valence 2.
pub fn square_pillow() -> Faces {
    vec![vec![0, 1, 2, 3], vec![3, 2, 1, 0]]
}

/// A prism over a polygon with `n` corners: a cube for 4.
pub fn prism(n: usize) -> Faces {
    let side = |i: usize| vec![i, (i + 1) % n, (i + 1) % n + n, i + n];
    let ends = [(0..n).rev().collect(), (n..2 * n).collect()];
    (0..n).map(side).chain(ends).collect()
}

/// A torus of `m` by `n` squares.
pub fn torus(m: usize, n: usize) -> Faces {
    let vertex = |i: usize, j: usize| (i % m) * n + j % n;
    let face =
        |i: usize, j: usize| vec![vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
    (0..m).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| face(i, j)).collect()
}

/// A board of `m` by `n` vertices, vertex `(i, j)` at `i n + j`.
pub fn board(m: usize, n: usize) -> Faces {
    let face = |i: usize, j: usize| vec![i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1];
    (0..m - 1).flat_map(|i| (0..n - 1).map(move |j| (i, j))).map(|(i, j)| face(i, j)).collect()
}

/// With a new vertex in the faces `f` and `g`, joined to their corners.
fn stellated(faces: &Faces, f: usize, g: usize) -> Faces {
    let count = faces.iter().flatten().max().map_or(0, |v| v + 1);
    let mut new = Vec::new();
    for (k, face) in faces.iter().enumerate() {
        match [f, g].iter().position(|x| *x == k) {
            Some(i) => {
                let n = face.len();
                let apex = count + if f == g { 0 } else { i };
                new.extend((0..n).map(|k| vec![face[k], face[(k + 1) % n], apex]));
            }
            None => new.push(face.clone()),
        }
    }
    new
}

/// With a face cut along a diagonal, unless there is such an edge already.
fn split(faces: &Faces, f: usize, at: usize) -> Faces {
    let face = &faces[f];
    let n = face.len();
    let corner = |k: usize| face[(at + k) % n];
    let joined = |v: usize, w: usize| {
        faces.iter().any(|face| (0..face.len()).any(|k| [face[k], face[(k + 1) % face.len()]] == [v, w]))
    };
    if n < 4 || joined(corner(0), corner(2)) || joined(corner(2), corner(0)) {
        return faces.clone();
    }
    let parts = [vec![corner(0), corner(1), corner(2)], std::iter::once(0).chain(2..n).map(corner).collect()];
    faces.iter().take(f).cloned().chain(parts).chain(faces.iter().skip(f + 1).cloned()).collect()
}

/// Without some faces, and without the vertices that are then in no face.
fn without(faces: &Faces, gone: &[usize]) -> Faces {
    let mut names = BTreeMap::new();
    let left = faces.iter().enumerate().filter(|(f, _)| !gone.contains(f));
    let mut name = |v: &usize| {
        let next = names.len();
        *names.entry(*v).or_insert(next)
    };
    left.map(|(_, face)| face.iter().map(&mut name).collect()).collect()
}

fn varied(base: Faces, changes: &[(Index, Index, bool)]) -> Faces {
    let change = |faces: Faces, (f, at, cut): &(Index, Index, bool)| {
        let f = f.index(faces.len());
        if *cut { split(&faces, f, at.index(faces[f].len())) } else { stellated(&faces, f, f) }
    };
    changes.iter().fold(base, change)
}

fn changes(most: usize) -> impl Strategy<Value = Vec<(Index, Index, bool)>> {
    vec((any::<Index>(), any::<Index>(), any::<bool>()), 0..=most)
}

/// Closed meshes: polyhedra, a torus, and what comes of cutting faces and of raising pyramids on them.
pub fn closed() -> impl Strategy<Value = Faces> {
    let bases = vec![
        tetrahedron(),
        octahedron(),
        prism(3),
        prism(4),
        prism(5),
        prism(6),
        prism(7),
        torus(3, 4),
        torus(5, 3),
        square_pillow(),
    ];
    (select(bases), changes(4)).prop_map(|(base, changes)| varied(base, &changes))
}

/// Meshes with boundaries: boards with holes, changed as closed meshes are, and closed meshes with a hole.
pub fn bounded() -> impl Strategy<Value = Faces> {
    let bases = vec![
        board(2, 2),
        board(3, 3),
        board(4, 4),
        board(3, 5),
        board(5, 5),
        prism(4),
        prism(6),
        torus(4, 4),
    ];
    let holes = vec(any::<Index>(), 1..=3);
    (select(bases), holes, changes(3)).prop_filter_map(
        "what is left is no manifold",
        |(base, holes, changes)| {
            let whole = base.len() == 1 || holes.len() == 1 && base.len() > 6;
            let gone: Vec<usize> = holes.iter().map(|hole| hole.index(base.len())).collect();
            let left = if whole { without(&base, &gone[..0]) } else { without(&base, &gone) };
            let open = varied(left, &changes);
            let count = open.iter().flatten().max().map_or(0, |v| v + 1);
            Topology::new(count, &open).is_ok_and(|t| !t.is_closed()).then_some(open)
        },
    )
}

/// Meshes of all sorts.
pub fn faces() -> impl Strategy<Value = Faces> {
    prop_oneof![closed(), bounded()]
}

/// What becomes of boundaries.
pub fn boundary() -> impl Strategy<Value = Boundary> {
    select(vec![Boundary::Open, Boundary::Smooth, Boundary::Corners])
}

/// A mesh with points dealt out from a pool.
pub fn mesh<const N: usize>(faces: &Faces, pool: &[SVector<Q, N>]) -> ControlMesh<Q, N> {
    let count = faces.iter().flatten().max().map_or(0, |v| v + 1);
    let deal = |v: usize| &pool[(v * v + 3 * v) % pool.len()] * Q::int(1 + v as i64 % 3);
    ControlMesh::new((0..count).map(deal).collect(), faces).expect("a manifold, each vertex in a face")
}

/// Points to deal out.
pub fn pool<const N: usize>() -> impl Strategy<Value = Vec<SVector<Q, N>>> {
    vec(point::<N>(), 19)
}

/// A mesh of any sort.
pub fn any_mesh() -> impl Strategy<Value = ControlMesh<Q, 3>> {
    (faces(), pool()).prop_map(|(faces, pool)| mesh(&faces, &pool))
}

/// Knot intervals to deal out: a few that vanish among others.
pub fn interval() -> impl Strategy<Value = Q> {
    prop_oneof![
        2 => Just(Q::int(0)),
        5 => Just(Q::int(1)),
        5 => (1_i64..=5, 1_i64..=4).prop_map(|(n, d)| Q::frac(n, d)),
    ]
}

/// An interval an edge, dealt out from a pool.
pub fn intervals<const N: usize>(mesh: &ControlMesh<Q, N>, pool: &[Q]) -> Vec<Q> {
    (0..mesh.topology().edge_count()).map(|e| pool[(e * e + 5 * e) % pool.len()].clone()).collect()
}
