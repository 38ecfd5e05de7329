//! What does a step of subdivision cost? A cube, subdivided until there are up to 100 000 faces, with equal knot intervals and with
//! others: one more step of both schemes; and five steps at once of the pawn in the data. Throughput is in new faces. All should be
//! linear in them.

use criterion::Throughput;
use nalgebra::SVector;
use numbers::{Group, Numbers, Question};
use std::hint::black_box;
use symspline::{Boundary, CatmullClark, ControlMesh, DooSabin, Result, Scalar};

fn main() -> Result<()> {
    numbers::run::<Subdividing>()
}

struct Subdividing;

impl Question for Subdividing {
    const NAME: &'static str = "subdivide";
    /// Steps.
    type Size = usize;
    const FLOATS: &'static [usize] = &[1, 3, 5, 7];
    const FRACTIONS: &'static [usize] = &[1, 3];
    const IMAGES: &'static [usize] = &[3];

    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, depth: usize) -> Result<()> {
        let cube = cube(numbers)?;
        let doo_sabin = DooSabin::new(cube.clone(), Boundary::Smooth).refined(depth - 1)?;
        let catmull_clark = CatmullClark::new(cube, Boundary::Smooth).refined(depth - 1)?;
        let interval = |k: usize| (numbers.knot)(k % 5 + 1) - (numbers.knot)(k % 5);
        let edges = doo_sabin.mesh().topology().edge_count();
        let pairs = (0..edges).map(|e| [interval(e), interval(e + 2)]).collect();
        let uneven_doo_sabin = DooSabin::with_intervals(doo_sabin.mesh().clone(), pairs, Boundary::Smooth)?;
        let edges = catmull_clark.mesh().topology().edge_count();
        let single = (0..edges).map(interval).collect();
        let uneven = CatmullClark::with_intervals(catmull_clark.mesh().clone(), single, Boundary::Smooth)?;

        let (name, faces) = (numbers.name, catmull_clark.refined(1)?.mesh().topology().face_count());
        group.throughput(Throughput::Elements(faces as u64));
        group.bench_function(format!("catmull_clark {name}, {faces} faces"), |b| {
            b.iter(|| black_box(&catmull_clark).refined(1));
        });
        group.bench_function(format!("catmull_clark uneven {name}, {faces} faces"), |b| {
            b.iter(|| black_box(&uneven).refined(1));
        });
        let faces = doo_sabin.refined(1)?.mesh().topology().face_count();
        group.throughput(Throughput::Elements(faces as u64));
        group.bench_function(format!("doo_sabin {name}, {faces} faces"), |b| {
            b.iter(|| black_box(&doo_sabin).refined(1));
        });
        group.bench_function(format!("doo_sabin uneven {name}, {faces} faces"), |b| {
            b.iter(|| black_box(&uneven_doo_sabin).refined(1));
        });
        Ok(())
    }
}

/// A cube, a little out of shape.
fn cube<T: Scalar>(numbers: &Numbers<T>) -> Result<ControlMesh<T, 3>> {
    let corner = |k: usize| {
        let at = [k & 1, k >> 1 & 1, k >> 2];
        SVector::from_fn(|axis, _| (numbers.knot)(at[axis]) + (numbers.value)(3 * k + axis) * T::frac(1, 8))
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    ControlMesh::new((0..8).map(corner).collect(), faces)
}
