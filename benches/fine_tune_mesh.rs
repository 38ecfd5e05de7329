//! What does it cost to fine tune a subdivision surface? The pawn of 601 vertices, whose neck or a single vertex is stretched, whole or in
//! part, by both ways to rest; and how the time grows with grids on a torus.

use nalgebra::vector;
use numbers::Group;
use std::f64::consts::TAU;
use std::hint::black_box;
use symspline::io::obj;
use symspline::{Boundary, ControlMesh, Descend, DooSabin, MeshSprings, Result};

fn main() -> Result<()> {
    let mut criterion = numbers::criterion();
    ask(&mut criterion.benchmark_group("fine tune mesh"))?;
    criterion.final_summary();
    Ok(())
}

const WAYS: [(Descend, &str); 2] =
    [(Descend::ConjugateGradients, "conjugate gradients"), (Descend::GaussNewton, "Gauss-Newton")];

fn ask(group: &mut Group<'_>) -> Result<()> {
    let pawn = pawn()?;
    let mesh = pawn.mesh().topology();
    let height = |v: usize| pawn.mesh().points()[v][2];
    let neck = |[v, w]: [usize; 2]| if (0.35..0.65).contains(&(height(v) + height(w))) { 1.5 } else { 1.0 };
    let neck: Vec<f64> = mesh.edges().map(neck).collect();
    let mut vertex = vec![1.0; mesh.edge_count()];
    mesh.edges_at(300).for_each(|e| vertex[e] = 1.3);
    let bottom: Vec<usize> = (0..mesh.vertex_count()).filter(|v| height(*v) < 0.036).take(3).collect();
    let mut near = vec![300];
    // Four rings around the vertex.
    for _ in 0..4 {
        near = near.iter().flat_map(|v| mesh.edges_at(*v)).flat_map(|e| mesh.ends(e)).collect();
        near.sort_unstable();
        near.dedup();
    }
    for (descend, name) in WAYS {
        let springs = MeshSprings { descend, fixed: bottom.clone(), ..MeshSprings::default() };
        measure(group, &format!("pawn, neck, {name}"), &pawn, &neck, &springs)?;
        measure(group, &format!("pawn, a vertex, {name}"), &pawn, &vertex, &springs)?;
        let part = MeshSprings { descend, moving: Some(near.clone()), ..MeshSprings::default() };
        measure(group, &format!("pawn, a vertex in part, {name}"), &pawn, &vertex, &part)?;
        for size in [8, 16, 32] {
            let torus = torus(2 * size, size)?;
            let mut alpha = vec![1.0; torus.mesh().topology().edge_count()];
            torus.mesh().topology().edges_at(0).for_each(|e| alpha[e] = 1.3);
            let springs = MeshSprings { descend, fixed: vec![size], ..MeshSprings::default() };
            measure(
                group,
                &format!("torus of {} vertices, {name}", 2 * size * size),
                &torus,
                &alpha,
                &springs,
            )?;
        }
    }
    Ok(())
}

fn measure(
    group: &mut Group<'_>,
    name: &str,
    surface: &DooSabin<f64, 3>,
    alpha: &[f64],
    springs: &MeshSprings,
) -> Result<()> {
    assert!(surface.fine_tuned(alpha, springs)?.converged, "{name}");
    group.bench_function(format!("{name}/f64"), |b| {
        b.iter(|| black_box(surface).fine_tuned(alpha, springs));
    });
    Ok(())
}

fn pawn() -> Result<DooSabin<f64, 3>> {
    let mesh = obj::read(include_str!("../data/subd_pawn.obj").as_bytes())?;
    Ok(DooSabin::new(mesh, Boundary::Smooth))
}

/// A grid of `m` by `n` vertices on a torus.
fn torus(m: usize, n: usize) -> Result<DooSabin<f64, 3>> {
    let point = |k: usize| {
        let (u, v) = (TAU * (k % m) as f64 / m as f64, TAU * (k / m) as f64 / n as f64);
        vector![(3.0 + v.cos()) * u.cos(), (3.0 + v.cos()) * u.sin(), v.sin()]
    };
    let face = |k: usize| {
        let at = |i: usize, j: usize| i % m + m * (j % n);
        let (i, j) = (k % m, k / m);
        [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
    };
    let mesh = ControlMesh::new((0..m * n).map(point).collect(), (0..m * n).map(face))?;
    Ok(DooSabin::new(mesh, Boundary::Smooth))
}
