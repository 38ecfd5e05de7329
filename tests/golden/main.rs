//! Golden values: exact numbers made by another program (piecewise polynomials over rationals), in `cases.json`.
//!
//! Each category is one test. Over `Q` knots and coefficients must be equal; over `f64` inputs are rounded to
//! nearest, knots must still be equal, and numbers may be off by `FACTOR * EPSILON * size`, where `size` is the
//! largest number of the answer, or for a derivative of order `k` the coefficients' size times `(2 p / h)^k` with
//! `h` the shortest span.

mod data;
mod check;
mod values;
mod operators;
mod removal;
mod tuning;
mod closed;
mod nearest;
mod spring;
mod curvature;
mod surface;
mod rational;
mod shape_reposition;
mod shape_constraints;
mod shape_weights;
mod shape_warps;
mod shape_bends;
mod deform;
mod subdivision;

/// The categories tested here, with their numbers of cases.
const TESTED: [(&str, usize); 64] = [
    ("basis", 22),
    ("curve_ders", 3),
    ("hodograph", 3),
    ("knot_insertion", 8),
    ("degree_elevation", 6),
    ("degree_reduction", 7),
    ("knot_removal", 3),
    ("knot_removal_forced", 5),
    ("product", 7),
    ("antiderivative", 5),
    ("definite_integral", 10),
    ("gram", 9),
    ("fine_tune", 10),
    ("fine_tune_end", 14),
    ("closed_quadratic_to_cubic", 2),
    ("closed_fine_tune_open", 2),
    ("closed_spring", 2),
    ("local_fine_tune", 2),
    ("alpha_preserve_ends", 6),
    ("closed_alpha_preserve", 2),
    ("curvature2d", 3),
    ("curvature3d", 3),
    ("surface_T", 4),
    ("surface_T_boundary", 2),
    ("surface_alpha_border", 3),
    ("nurbs_ders", 6),
    ("nurbs_basis_ders", 5),
    ("nurbs_surface_ders", 2),
    ("knot_insertion_rational", 1),
    ("node_placing", 5),
    ("move_one_control", 4),
    ("move_two_controls", 8),
    ("inverse_knot_insertion", 2),
    ("constraint_curve", 10),
    ("constraint_surface", 3),
    ("fowler", 6),
    ("weight_one", 6),
    ("weight_two", 3),
    ("weight_one_distance", 2),
    ("weight_surface", 1),
    ("weight_derivatives", 2),
    ("halfway_knot", 6),
    ("local_range", 5),
    ("warp_f", 8),
    ("warp_f2", 8),
    ("warp_curve", 1),
    ("flatten_line", 4),
    ("flatten_plane", 2),
    ("bend_point", 12),
    ("bend_circle", 3),
    ("bend_rest", 2),
    ("bend_rest3", 1),
    ("bend_cylinder", 3),
    ("vassilev_matrices", 4),
    ("vassilev_segment", 1),
    ("vassilev_move", 3),
    ("vassilev_forces", 1),
    ("vassilev_surface_move", 2),
    ("face_rules", 3),
    ("chaikin_closed", 1),
    ("valence3_limit", 1),
    ("nonuniform_cubic_midpoint", 1),
    ("nurccs_grid", 3),
    ("conversion_topology", 2),
];

/// The file holds what its header promises, and nothing that is not tested.
#[test]
fn every_case_is_counted() {
    let mut tested = TESTED.to_vec();
    let mut promised = data::categories();
    tested.sort_unstable();
    promised.sort_unstable();
    assert_eq!(promised, tested);
    let mut ids: Vec<&str> =
        tested.iter().flat_map(|(name, _)| data::cases(name)).map(data::Case::id).collect();
    assert_eq!(ids.len(), tested.iter().map(|(_, count)| count).sum::<usize>());
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), 286, "distinct cases");
}
