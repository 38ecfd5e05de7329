//! Bad values, bad springs, bad meshes.

use crate::tuning::shapes::plain_cube;
use nalgebra::vector;
use symspline::{
    Boundary, ControlMesh, Descend, DooSabin, Error, MeshSprings, RelaxedMesh, Result, TuneError,
};

fn tuned(alpha: &[f64], springs: MeshSprings) -> Result<RelaxedMesh> {
    plain_cube().fine_tuned(alpha, &springs)
}

fn springs() -> MeshSprings {
    MeshSprings::default()
}

#[test]
fn values_that_are_no_scales_are_named() {
    for bad in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut alpha = [1.0; 12];
        alpha[7] = bad;
        let refused = TuneError::EdgeScale { edge: 7, value: bad.to_string() };
        assert_eq!(tuned(&alpha, springs()), Err(refused.into()));
    }
    for count in [0, 11, 13] {
        let refused = Error::CoefficientCount { expected: 12, found: count };
        assert_eq!(tuned(&vec![1.0; count], springs()), Err(refused));
    }
}

#[test]
fn springs_that_are_none_are_named() {
    let alpha = [1.1; 12];
    for k in [0.0, -1.0, f64::NAN] {
        let refused = Err(TuneError::SpringConstant { constant: k.to_string() }.into());
        assert_eq!(tuned(&alpha, MeshSprings { shape: k, ..springs() }), refused);
    }
    let beyond = |index, length| Err(Error::IndexOutOfRange { index, length });
    assert_eq!(tuned(&alpha, MeshSprings { fixed: vec![8], ..springs() }), beyond(8, 8));
    assert_eq!(tuned(&alpha, MeshSprings { fixed_corners: vec![24], ..springs() }), beyond(24, 24));
    assert_eq!(
        tuned(&alpha, MeshSprings { moving: Some(vec![usize::MAX]), ..springs() }),
        beyond(usize::MAX, 8)
    );
    let refused = tuned(&alpha, MeshSprings { tolerance: f64::NAN, ..springs() });
    assert!(matches!(refused, Err(Error::BadTolerance { .. })));
}

#[test]
fn edges_without_length_are_named() {
    let points = plain_cube().mesh().points().to_vec();
    let topology = plain_cube().mesh().shared_topology().clone();
    let surface =
        |points| DooSabin::new(ControlMesh::over(topology.clone(), points).unwrap(), Boundary::Smooth);
    let same = surface(vec![points[3]; 8]);
    assert_eq!(same.fine_tuned(&[1.0; 12], &springs()), Err(Error::NoLength));
    // All corners of the first face in one point.
    let mut pinched = points.clone();
    topology.face(0).for_each(|v| pinched[v] = points[0]);
    let refused = Err(TuneError::ZeroEdge { edge: 0 }.into());
    assert_eq!(surface(pinched).fine_tuned(&[1.1; 12], &springs()), refused);
    // An edge that is to vanish beside others that are to be long.
    let mut alpha = [1e100; 12];
    alpha[5] = 1.0;
    let refused = plain_cube().fine_tuned(&alpha, &springs());
    assert!(matches!(refused, Err(Error::Tune(TuneError::ZeroEdge { .. }))), "{refused:?}");
}

#[test]
fn extreme_sizes_end_all_the_same() {
    for size in [1e-150, 1e150] {
        let mesh = plain_cube();
        let points = mesh.mesh().points().iter().map(|p| p * size).collect();
        let surface = DooSabin::new(mesh.mesh().with_points(points).unwrap(), Boundary::Smooth);
        let mut alpha = [1.0; 12];
        alpha[0] = 1.3;
        assert!(surface.fine_tuned(&alpha, &springs()).unwrap().converged);
    }
    let wide = ControlMesh::new(
        vec![
            vector![-1e308, 0.0, 0.0],
            vector![1e308, 0.0, 0.0],
            vector![0.0, 1e308, 0.0],
            vector![0.0, 0.0, 1e308],
        ],
        [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
    );
    let refused = DooSabin::new(wide.unwrap(), Boundary::Smooth).fine_tuned(&[1.0; 6], &springs());
    assert!(matches!(refused, Err(Error::NotFinite { .. })), "{refused:?}");
    for descend in [Descend::ConjugateGradients, Descend::GaussNewton] {
        for level in [1e-3, 1e3, 1e100] {
            let mut alpha = [1.0; 12];
            alpha[4] = level;
            let limited = MeshSprings { descend, iterations: 60, ..springs() };
            match tuned(&alpha, limited) {
                Ok(found) => assert!(found.energy <= found.energy_before && found.energy.is_finite()),
                Err(error) => assert!(matches!(error, Error::Tune(TuneError::ZeroEdge { .. })), "{error}"),
            }
        }
    }
}
