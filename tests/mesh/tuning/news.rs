//! Springs that never come to rest, constants that overflow, motions of what is held.

use crate::tuning::shapes::{any_surface, plain_cube};
use nalgebra::{Rotation3, SVector, vector};
use proptest::prelude::*;
use symspline::{Descend, DooSabin, Error, MeshSprings};

#[test]
fn without_tolerance_or_limit_they_end() {
    for descend in [Descend::ConjugateGradients, Descend::GaussNewton] {
        let springs =
            MeshSprings { descend, tolerance: 0.0, iterations: usize::MAX, ..MeshSprings::default() };
        let alpha: Vec<f64> = (0..12).map(|k| 1.0 + f64::from(k) / 24.0).collect();
        let found = plain_cube().fine_tuned(&alpha, &springs).unwrap();
        assert!(!found.converged && found.gradient < 1e-10, "{found:?}");
    }
}

#[test]
fn energies_that_overflow_are_refused() {
    let springs = MeshSprings { stretch: 1e308, ..MeshSprings::default() };
    let refused = plain_cube().fine_tuned(&[100.0; 12], &springs);
    assert!(matches!(refused, Err(Error::NotFinite { what: "energy", .. })), "{refused:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn motions_move_what_is_held_along((surface, alpha) in any_surface(), angles in [0.0_f64..6.0, 0.0..6.0, 0.0..6.0]) {
        let turn = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let place = |p: &SVector<f64, 3>| turn * p + vector![3.0, -1.0, 0.5];
        let gentle: Vec<f64> = alpha.iter().map(|a| 1.0 + 0.3 * (a - 1.0)).collect();
        let mesh = surface.mesh().with_points(surface.mesh().points().iter().map(place).collect()).unwrap();
        let moved = DooSabin::new(mesh, surface.boundary());
        let side = |surface: &DooSabin<f64, 3>| {
            let all = surface.mesh().points();
            let (low, high) = all.iter().fold((all[0], all[0]), |(low, high), p| (low.inf(p), high.sup(p)));
            (high - low).max()
        };
        let springs = MeshSprings { fixed: vec![0, 1, 2], tolerance: 1e-10, ..MeshSprings::default() };
        let there = surface.fine_tuned(&gentle, &springs).unwrap();
        let here = moved.fine_tuned(&gentle, &MeshSprings { stretch: (side(&moved) / side(&surface)).powi(2), ..springs }).unwrap();
        for (p, q) in there.surface.mesh().points().iter().zip(here.surface.mesh().points()) {
            prop_assert!((place(p) - q).norm() < 1e-6, "{}", (place(p) - q).norm());
        }
    }
}
