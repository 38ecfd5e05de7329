//! Meshes to try things on: closed and bounded, moved by noise.

use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use symspline::{Boundary, ControlMesh, DooSabin};

type Points = Vec<SVector<f64, 3>>;
type Faces = Vec<Vec<usize>>;

fn faces<const K: usize>(faces: &[[usize; K]]) -> Faces {
    faces.iter().map(|face| face.to_vec()).collect()
}

fn cube() -> (Points, Faces) {
    let corner = |k: i32| vector![f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)];
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    ((0..8).map(corner).collect(), faces(&sides))
}

fn octahedron() -> (Points, Faces) {
    let points =
        (0..6).map(|k| SVector::from_fn(|a, _| if a == k / 2 { 1.0 - (k % 2) as f64 * 2.0 } else { 0.0 }));
    let sides = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    (points.collect(), faces(&sides))
}

fn tetrahedron() -> (Points, Faces) {
    let points = vec![
        vector![1.0, 1.0, 1.0],
        vector![1.0, -1.0, -1.0],
        vector![-1.0, 1.0, -1.0],
        vector![-1.0, -1.0, 1.0],
    ];
    (points, faces(&[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]))
}

/// Over a regular polygon.
fn prism(sides: usize) -> (Points, Faces) {
    let point = |k: usize| {
        let angle = (k % sides) as f64 * std::f64::consts::TAU / sides as f64;
        vector![2.0 * angle.cos(), 2.0 * angle.sin(), 1.5 * (k / sides) as f64]
    };
    let wall = |k: usize| vec![k, (k + 1) % sides, sides + (k + 1) % sides, sides + k];
    let ends = [(0..sides).rev().collect(), (sides..2 * sides).collect()];
    ((0..2 * sides).map(point).collect(), (0..sides).map(wall).chain(ends).collect())
}

/// A grid on a torus.
fn torus(m: usize, n: usize) -> (Points, Faces) {
    let tau = std::f64::consts::TAU;
    let point = |k: usize| {
        let (u, v) = (tau * (k % m) as f64 / m as f64, tau * (k / m) as f64 / n as f64);
        vector![(3.0 + v.cos()) * u.cos(), (3.0 + v.cos()) * u.sin(), v.sin()]
    };
    let face = |k: usize| {
        let at = |i: usize, j: usize| i % m + m * (j % n);
        let (i, j) = (k % m, k / m);
        vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
    };
    ((0..m * n).map(point).collect(), (0..m * n).map(face).collect())
}

fn grid(m: usize, n: usize) -> (Points, Faces) {
    let points = (0..m * n).map(|k| vector![(k % m) as f64, (k / m) as f64, 0.0]).collect();
    let squares = (0..m * (n - 1)).filter(|k| (k + 1) % m != 0).map(|k| vec![k, k + 1, k + m + 1, k + m]);
    (points, squares.collect())
}

/// Three squares, with a corner that is filled.
fn bracket() -> (Points, Faces) {
    let points = [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2]];
    let points = points.map(|[x, y]| vector![f64::from(x), f64::from(y), f64::from(x * y) / 3.0]);
    (points.to_vec(), faces(&[[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6]]))
}

fn lidless() -> (Points, Faces) {
    let (points, mut sides) = cube();
    sides.remove(1);
    (points, sides)
}

fn moved((points, faces): (Points, Faces), noise: &[[f64; 3]], size: f64) -> DooSabin<f64, 3> {
    let points = points.iter().zip(noise).map(|(p, d)| p + SVector::from(*d) * size).collect();
    DooSabin::new(ControlMesh::new(points, faces).expect("a mesh"), Boundary::Smooth)
}

fn shape(which: usize) -> (Points, Faces) {
    match which {
        0 => cube(),
        1 => octahedron(),
        2 => tetrahedron(),
        3 => prism(5),
        4 => torus(5, 4),
        5 => grid(4, 5),
        6 => bracket(),
        _ => lidless(),
    }
}

/// A surface with a value for each edge: closed ones, and then bounded ones.
fn among(which: std::ops::Range<usize>) -> impl Strategy<Value = (DooSabin<f64, 3>, Vec<f64>)> {
    let noise = vec([-0.15_f64..0.15, -0.15..0.15, -0.15..0.15], 20);
    (which, noise, vec(0.75_f64..1.4, 40)).prop_map(|(which, noise, alpha)| {
        let surface = moved(shape(which), &noise, 1.0);
        let count = surface.mesh().topology().edge_count();
        (surface, alpha[..count].to_vec())
    })
}

pub fn any_surface() -> impl Strategy<Value = (DooSabin<f64, 3>, Vec<f64>)> {
    among(0..8)
}

pub fn closed_surface() -> impl Strategy<Value = (DooSabin<f64, 3>, Vec<f64>)> {
    among(0..5)
}

pub fn plain_cube() -> DooSabin<f64, 3> {
    moved(cube(), &[[0.0; 3]; 8], 0.0)
}

pub fn plain_torus(m: usize, n: usize) -> DooSabin<f64, 3> {
    moved(torus(m, n), &vec![[0.0; 3]; m * n], 0.0)
}
