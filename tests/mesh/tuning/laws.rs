//! What holds for all fine-tuned meshes.

use crate::tuning::oracle::Oracle;
use crate::tuning::shapes::{any_surface, closed_surface, plain_cube, plain_torus};
use nalgebra::{Rotation3, SVector, vector};
use proptest::prelude::*;
use std::ops::ControlFlow;
use symspline::{Boundary, ControlMesh, Descend, DooSabin, MeshSprings, RelaxedMesh};

fn points(tuned: &RelaxedMesh) -> &[SVector<f64, 3>] {
    tuned.surface.mesh().points()
}

fn tuned(surface: &DooSabin<f64, 3>, alpha: &[f64], springs: &MeshSprings) -> RelaxedMesh {
    surface.fine_tuned(alpha, springs).expect("a mesh without degenerate edges")
}

/// The surface with its points moved.
fn with(surface: &DooSabin<f64, 3>, place: impl Fn(&SVector<f64, 3>) -> SVector<f64, 3>) -> DooSabin<f64, 3> {
    let moved = surface.mesh().points().iter().map(place).collect();
    DooSabin::new(surface.mesh().with_points(moved).expect("as many points"), surface.boundary())
}

fn largest_distance(a: &[SVector<f64, 3>], b: &[SVector<f64, 3>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn springs_come_to_rest_at_less_energy((surface, alpha) in any_surface(), newton in any::<bool>(), uniform in any::<bool>()) {
        let descend = if newton { Descend::GaussNewton } else { Descend::ConjugateGradients };
        let found = tuned(&surface, &alpha, &MeshSprings { descend, uniform, ..MeshSprings::default() });
        prop_assert!(found.energy < found.energy_before, "{} {}", found.energy, found.energy_before);
        prop_assert!(found.converged, "{} steps, {}", found.iterations, found.gradient);
        let sum: f64 = found.terms.iter().sum();
        prop_assert!((sum - found.energy).abs() < 1e-12 * found.energy_before);
        prop_assert_eq!(found.surface.mesh().topology(), found.invariant.mesh().topology());
        prop_assert_eq!(found.surface.intervals(), found.invariant.intervals());
        prop_assert_eq!(found.invariant, surface.converted().unwrap());
    }

    #[test]
    fn values_of_one_change_nothing((surface, alpha) in any_surface(), newton in any::<bool>()) {
        let descend = if newton { Descend::GaussNewton } else { Descend::ConjugateGradients };
        let ones = vec![1.0; alpha.len()];
        let found = tuned(&surface, &ones, &MeshSprings { descend, tolerance: 0.0, ..MeshSprings::default() });
        prop_assert_eq!((found.iterations, found.energy_before, found.energy), (0, 0.0, 0.0));
        prop_assert!(found.converged && found.length_deviation == 0.0 && found.angle_deviation == 0.0);
        prop_assert_eq!(found.surface, found.invariant);
    }

    #[test]
    fn what_is_fixed_stays((surface, alpha) in any_surface(), a in any::<prop::sample::Index>(), b in any::<prop::sample::Index>()) {
        let mesh = surface.mesh().topology();
        let (v, corner) = (a.index(mesh.vertex_count()), b.index(mesh.half_edge_count()));
        let springs = MeshSprings { fixed: vec![v], fixed_corners: vec![corner], ..MeshSprings::default() };
        let found = tuned(&surface, &alpha, &springs);
        for kept in mesh.leaving(v).chain([corner]) {
            prop_assert_eq!(points(&found)[kept], found.invariant.mesh().points()[kept]);
        }
        prop_assert!(found.energy < found.energy_before);
    }

    #[test]
    fn outside_of_the_moving_part_nothing_moves((surface, alpha) in any_surface(), a in any::<prop::sample::Index>()) {
        let mesh = surface.mesh().topology();
        let v = a.index(mesh.vertex_count());
        let springs = MeshSprings { moving: Some(vec![v]), ..MeshSprings::default() };
        let found = tuned(&surface, &alpha, &springs);
        let moving: Vec<usize> = mesh.leaving(v).collect();
        for k in (0..mesh.half_edge_count()).filter(|k| !moving.contains(k)) {
            prop_assert_eq!(points(&found)[k], found.invariant.mesh().points()[k]);
        }
        prop_assert!(found.converged && found.energy < found.energy_before);
        // With all the others fixed it is the same, but for terms that do not change.
        let others = (0..mesh.vertex_count()).filter(|w| *w != v).collect();
        let whole = tuned(&surface, &alpha, &MeshSprings { fixed: others, tolerance: 1e-9, ..MeshSprings::default() });
        prop_assert!(largest_distance(points(&whole), points(&found)) < 1e-5);
        let falls = [&whole, &found].map(|tuned| tuned.energy_before - tuned.energy);
        prop_assert!((falls[0] - falls[1]).abs() < 1e-9, "{falls:?}");
    }

    #[test]
    fn enlargements_are_tuned_to_enlargements((surface, alpha) in closed_surface()) {
        let small = tuned(&surface, &alpha, &MeshSprings::default());
        let large = tuned(&with(&surface, |p| p * 4.0), &alpha, &MeshSprings::default());
        prop_assert_eq!((small.energy, small.iterations), (large.energy, large.iterations));
        for (s, l) in points(&small).iter().zip(points(&large)) {
            prop_assert_eq!(s * 4.0, *l);
        }
    }

    #[test]
    fn motions_move_the_result_along((surface, alpha) in closed_surface(), angles in [0.0_f64..6.0, 0.0..6.0, 0.0..6.0]) {
        // The box to which all is scaled turns too: the constant of lengths makes up for its side.
        let turn = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let shift = vector![3.0, -1.0, 0.5];
        let moved = with(&surface, |p| turn * p + shift);
        let side = |surface: &DooSabin<f64, 3>| {
            let all = surface.mesh().points();
            let (low, high) = all.iter().fold((all[0], all[0]), |(low, high), p| (low.inf(p), high.sup(p)));
            (high - low).max()
        };
        let stretch = (side(&moved) / side(&surface)).powi(2);
        let springs = MeshSprings { iterations: 4, ..MeshSprings::default() };
        let there = tuned(&surface, &alpha, &springs);
        let here = tuned(&moved, &alpha, &MeshSprings { stretch, ..springs });
        prop_assert!((there.energy_before - here.energy_before).abs() < 1e-9 * here.energy_before);
        // A few steps, before valleys are flat.
        let expected: Vec<_> = points(&there).iter().map(|p| turn * p + shift).collect();
        prop_assert!(largest_distance(&expected, points(&here)) < 1e-3);
    }

    /// For values near 1: for others there may be more minima than one, and either way finds its own.
    #[test]
    fn both_ways_down_reach_the_same_energy((surface, alpha) in any_surface()) {
        let gentle: Vec<f64> = alpha.iter().map(|a| 1.0 + 0.05 * (a - 1.0)).collect();
        let reached = [Descend::ConjugateGradients, Descend::GaussNewton].map(|descend| {
            tuned(&surface, &gentle, &MeshSprings { descend, tolerance: 1e-9, ..MeshSprings::default() }).energy
        });
        prop_assert!((reached[0] - reached[1]).abs() <= 1e-9 * reached[0], "{reached:?}");
    }

    #[test]
    fn energies_are_those_of_the_formula((surface, alpha) in closed_surface()) {
        let springs = MeshSprings { stretch: 0.7, bend: 1.0, shape: 0.4, tolerance: 1e-9, ..MeshSprings::default() };
        let found = tuned(&surface, &alpha, &springs);
        let oracle = Oracle::of(&surface, &alpha, [0.7, 1.0, 0.4]);
        let before = oracle.energy(found.invariant.mesh().points());
        prop_assert!((before - found.energy_before).abs() < 1e-10 * before);
        let mut points = points(&found).to_vec();
        let rest = oracle.energy(&points);
        prop_assert!((rest - found.energy).abs() < 1e-10 * before, "{rest} {}", found.energy);
        // No vertex that is moved a little makes it less.
        let h = 1e-4 * oracle.side;
        for k in [0, points.len() / 2] {
            for a in 0..3 {
                let mut at = |t: f64| {
                    points[k][a] += t;
                    let energy = oracle.energy(&points);
                    points[k][a] -= t;
                    energy
                };
                let slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) * oracle.side / (12.0 * h);
                prop_assert!(slope.abs() < 1e-5, "{slope}");
            }
        }
    }

    #[test]
    fn who_watches_may_stop((surface, alpha) in any_surface(), steps in 0_usize..4) {
        let mut told = Vec::new();
        let watch = |progress: &symspline::Progress| {
            told.push(*progress);
            if progress.iteration < steps { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let found = surface.fine_tuned_watched(&alpha, &MeshSprings::default(), watch).unwrap();
        prop_assert_eq!((found.iterations, found.converged), (steps, false));
        prop_assert_eq!(told.len(), steps + 1);
        prop_assert_eq!(told[0].energy, found.energy_before);
        prop_assert_eq!((told[steps].energy, told[steps].gradient), (found.energy, found.gradient));
        prop_assert!(told.windows(2).all(|two| two[1].energy <= two[0].energy));
    }

    #[test]
    fn constants_count_by_their_ratio((surface, alpha) in any_surface()) {
        let [one, four] = [1.0, 4.0].map(|k| {
            tuned(&surface, &alpha, &MeshSprings { stretch: k, bend: 0.5 * k, shape: 0.25 * k, ..MeshSprings::default() })
        });
        prop_assert_eq!(points(&one), points(&four));
        prop_assert_eq!((4.0 * one.energy, 4.0 * one.energy_before), (four.energy, four.energy_before));
        prop_assert_eq!(one.terms.map(|term| 4.0 * term), four.terms);
    }
}

#[test]
fn equal_values_on_a_cube_enlarge_it() {
    // Loops around a cube close after any scale: lengths and angles as asked for, but for those angles that only move with it.
    let found =
        tuned(&plain_cube(), &[1.25; 12], &MeshSprings { tolerance: 1e-10, ..MeshSprings::default() });
    assert!(found.converged && found.energy < 1e-18, "{found:?}");
    let centre = vector![0.5, 0.5, 0.5];
    for (moved, before) in points(&found).iter().zip(found.invariant.mesh().points()) {
        assert!((moved - (centre + (before - centre) * 1.25)).norm() < 1e-8);
    }
}

#[test]
fn longer_edges_get_longer() {
    let surface = plain_torus(8, 6);
    let mesh = surface.mesh().topology();
    let mut alpha = vec![1.0; mesh.edge_count()];
    mesh.edges_at(0).for_each(|e| alpha[e] = 1.3);
    let found = tuned(&surface, &alpha, &MeshSprings::default());
    let length = |points: &[SVector<f64, 3>], h: usize| (points[mesh.next(h)] - points[h]).norm();
    for e in mesh.edges_at(0) {
        let h = mesh.side(e);
        assert!(length(points(&found), h) > 1.05 * length(found.invariant.mesh().points(), h));
    }
}

#[test]
fn without_a_free_vertex_nothing_happens() {
    let surface = plain_cube();
    let alpha = [1.5; 12];
    for springs in [
        MeshSprings { fixed: (0..8).collect(), ..MeshSprings::default() },
        MeshSprings { moving: Some(vec![]), ..MeshSprings::default() },
    ] {
        for descend in [Descend::ConjugateGradients, Descend::GaussNewton] {
            let found = tuned(&surface, &alpha, &MeshSprings { descend, ..springs.clone() });
            assert_eq!((found.iterations, found.converged), (0, true));
            assert_eq!(found.energy, found.energy_before);
            assert_eq!(found.surface, found.invariant);
        }
    }
}

#[test]
fn open_boundaries_are_tuned_too() {
    let squares = (0..12).map(|k| k / 3 * 4 + k % 3).map(|k| [k, k + 1, k + 5, k + 4]);
    let place = |k: i32| vector![f64::from(k % 4), f64::from(k / 4), f64::from(k * k % 7) / 10.0];
    let mesh = ControlMesh::new((0..20).map(place).collect(), squares).unwrap();
    for boundary in [Boundary::Open, Boundary::Smooth, Boundary::Corners] {
        let surface = DooSabin::new(mesh.clone(), boundary);
        let mut alpha = vec![1.0; mesh.topology().edge_count()];
        alpha[3] = 1.4;
        let found = tuned(&surface, &alpha, &MeshSprings::default());
        assert!(found.converged && found.energy < found.energy_before);
        assert_eq!(found.surface.boundary(), found.invariant.boundary());
    }
}
