//! Which of the parts found belong together: neighbours may share a foot at their border, and a place where the
//! distance stays the same is found in many parts.
//!
//! Two parts belong together if the foot of one lies in the other, since from there the distance descends to the foot
//! of the other; or if both stay near as a whole and touch. Not so across a knot where the curve jumps, unless the feet
//! are the same point.

use crate::analysis::nearest::pieces::{Axis, Sides};
use nalgebra::SVector;

/// Feet at the same distance and closer than this, in lengths of their pieces, are not told apart.
const CLOSE: f64 = 1.0 / (1 << 24) as f64;

/// A part that was found, by the parameters of the domain.
#[derive(Clone, Debug)]
pub(super) struct Isle<const N: usize> {
    pub(super) at: [f64; 2],
    pub(super) point: SVector<f64, N>,
    pub(super) distance: f64,
    /// From all of this the distance descends to what is in `sides`.
    pub(super) basin: Sides,
    pub(super) sides: Sides,
    /// The lengths of the piece.
    pub(super) widths: [f64; 2],
}

impl<const N: usize> Isle<N> {
    /// Whether all of `sides` stays near, not a single point of it.
    fn is_long(&self) -> bool {
        self.sides.iter().any(|(low, high)| low < high)
    }
}

/// What belongs together.
pub(super) struct Groups {
    /// The index of the nearest isle of every group.
    pub(super) feet: Vec<usize>,
    /// Boxes around isles that stay near as a whole, and those that belong to them.
    pub(super) along: Vec<Sides>,
}

/// Groups isles. Points closer than `noise` are the same.
pub(super) fn groups<const N: usize>(isles: &[Isle<N>], axes: &[Axis; 2], noise: f64) -> Groups {
    let mut union: Vec<usize> = (0..isles.len()).collect();
    let mut order: Vec<usize> = (0..isles.len()).collect();
    order.sort_by(|i, j| isles[*i].basin[0].0.total_cmp(&isles[*j].basin[0].0));
    for (place, &i) in order.iter().enumerate() {
        let end = isles[i].basin[0].1 + CLOSE * isles[i].widths[0];
        for &j in order[place + 1..].iter().take_while(|j| isles[**j].basin[0].0 <= end) {
            if meet(&isles[i], &isles[j], axes, [0.0; 2], noise) {
                unite(&mut union, i, j);
            }
        }
    }
    let mut along: Vec<(usize, Sides)> = Vec::new();
    for (i, isle) in isles.iter().enumerate().filter(|(_, isle)| isle.is_long()) {
        let group = find(&union, i);
        if along.iter().all(|(known, _)| *known != group) {
            along.push((group, isle.sides));
        }
    }
    for (group, sides) in &mut along {
        for (_, isle) in isles.iter().enumerate().filter(|(i, _)| find(&union, *i) == *group) {
            for (side, own) in sides.iter_mut().zip(&isle.sides) {
                *side = (side.0.min(own.0), side.1.max(own.1));
            }
        }
    }
    // Round a seam feet are the same, but boxes are not joined.
    let turns = axes.each_ref().map(|axis| if axis.periodic { axis.domain.1 - axis.domain.0 } else { 0.0 });
    if turns != [0.0; 2] {
        let shifts = |turn: f64| if turn > 0.0 { vec![-turn, 0.0, turn] } else { vec![0.0] };
        let at_seam = |isle: &Isle<N>| {
            let near = |i: usize, knot: f64| {
                let (low, high) = isle.basin[i];
                low - CLOSE * isle.widths[i] <= knot && knot <= high + CLOSE * isle.widths[i]
            };
            (0..2).any(|i| axes[i].periodic && (near(i, axes[i].domain.0) || near(i, axes[i].domain.1)))
        };
        let seam: Vec<usize> = (0..isles.len()).filter(|i| at_seam(&isles[*i])).collect();
        for (place, &i) in seam.iter().enumerate() {
            for &j in &seam[..place] {
                let both = shifts(turns[0])
                    .into_iter()
                    .flat_map(|u| shifts(turns[1]).into_iter().map(move |v| [u, v]));
                let meets =
                    |shift: [f64; 2]| shift != [0.0; 2] && meet(&isles[i], &isles[j], axes, shift, noise);
                if both.into_iter().any(meets) {
                    unite(&mut union, i, j);
                }
            }
        }
    }
    let mut feet: Vec<usize> = Vec::new();
    for i in 0..isles.len() {
        match feet.iter_mut().find(|foot| find(&union, **foot) == find(&union, i)) {
            Some(foot) if isles[i].distance < isles[*foot].distance => *foot = i,
            Some(_) => {}
            None => feet.push(i),
        }
    }
    along.sort_by(|a, b| a.1[0].0.total_cmp(&b.1[0].0).then(a.1[1].0.total_cmp(&b.1[1].0)));
    Groups { feet, along: along.into_iter().map(|(_, sides)| sides).collect() }
}

/// Whether two isles, the first of them moved, belong together.
fn meet<const N: usize>(
    one: &Isle<N>,
    other: &Isle<N>,
    axes: &[Axis; 2],
    shift: [f64; 2],
    noise: f64,
) -> bool {
    let moved = |sides: &Sides, i: usize| (sides[i].0 + shift[i], sides[i].1 + shift[i]);
    let basins = [0, 1].map(|i| (moved(&one.basin, i), other.basin[i]));
    let between = |i: usize, knot: f64| {
        let (a, b) = basins[i];
        (a.1 <= knot && knot <= b.0) || (b.1 <= knot && knot <= a.0)
    };
    let torn = (0..2).any(|i| axes[i].torn.iter().any(|knot| between(i, *knot)));
    if torn && (one.point - other.point).amax() > noise {
        return false;
    }
    let holds = |side: (f64, f64), x: f64| side.0 <= x && x <= side.1;
    let place = |i: usize| one.at[i] + shift[i];
    // Rounding may take a foot at a border to either side, and then twice.
    let close = |i: usize| (place(i) - other.at[i]).abs() <= CLOSE * one.widths[i].max(other.widths[i]);
    let twins = (one.distance - other.distance).abs() <= noise;
    let overlap = |i: usize| {
        let (a, b) = (moved(&one.sides, i), other.sides[i]);
        let margin = if twins { CLOSE * one.widths[i].max(other.widths[i]) } else { 0.0 };
        a.0 <= b.1 + margin && b.0 <= a.1 + margin
    };
    (0..2).all(|i| holds(basins[i].1, place(i)))
        || (0..2).all(|i| holds(basins[i].0, other.at[i]))
        || (twins && (0..2).all(close))
        || (one.is_long() && other.is_long() && (0..2).all(overlap))
}

/// The first of the group of `i`.
fn find(union: &[usize], mut i: usize) -> usize {
    while union[i] != i {
        i = union[i];
    }
    i
}

fn unite(union: &mut [usize], i: usize, j: usize) {
    let (a, b) = (find(union, i), find(union, j));
    union[a.max(b)] = a.min(b);
}
