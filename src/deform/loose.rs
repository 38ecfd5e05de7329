//! Motions that cost nothing, told by the knots alone.
//!
//! A material whose least derivative has the order one or two lets constants or linear functions pass, which break where the spline
//! is not smooth enough: at jumps, and linear ones at **hinges**, knots of multiplicity `p`. A line is known by its value at two
//! nodes, so what held coefficients leave free is counted along a part between two jumps, from hinge to hinge. No number is
//! rounded, however uneven the knots: floating-point factors then need not tell a motion that is free from one that costs little.

use crate::scalar::Scalar;
use crate::space::SplineSpace;

/// A coefficient along a part.
#[derive(Clone, Copy)]
struct Place {
    index: usize,
    moves: bool,
    hinge: bool,
}

/// How many motions of the coefficients that may move cost nothing, if the least derivative with a weight has this order, and one
/// of these coefficients. Nothing if the knots alone do not tell.
pub(crate) fn loose_motions<T: Scalar>(
    space: &SplineSpace<T>,
    order: usize,
    moving: &[usize],
) -> Option<(usize, usize)> {
    let (p, n) = (space.degree(), space.dim());
    let last = *moving.last()?;
    if order == 0 {
        return Some((0, last));
    }
    if p < order {
        return Some((moving.len(), last));
    }
    if order > 2 {
        return None;
    }
    let mut moves = vec![false; n];
    moving.iter().for_each(|i| moves[*i] = true);
    let (t, (a, b)) = (space.knots(), space.domain());
    // In a ring multiplicities repeat, so indices stay within the first round.
    let equal = |from: usize, to: usize| t[from % n.max(1)] == t[from % n.max(1) + to - from];
    let jump_before = |i: usize| equal(i, i + p);
    let hinge = |i: usize| {
        let value = |i: usize| equal(i + 1, i + p) && !jump_before(i) && !jump_before(i + 1);
        order == 2 && value(i) && (space.is_periodic() || (t[i + 1] > *a && t[i + 1] < *b))
    };
    let start = (0..n).find(|i| jump_before(*i));
    if space.is_periodic() && start.is_none() {
        return round(n, order, &moves, hinge, last);
    }
    let start = if space.is_periodic() { start.unwrap_or(0) } else { 0 };
    let places = (start..start + n).map(|i| Place { index: i % n, moves: moves[i % n], hinge: hinge(i % n) });
    let mut parts: Vec<Vec<Place>> = Vec::new();
    for place in places {
        if parts.is_empty() || jump_before(place.index) {
            parts.push(Vec::new());
        }
        parts.last_mut().expect("there is one").push(place);
    }
    Some(total(parts.iter().map(|part| (motions(part, order, false), part)), last))
}

/// All around a ring without jumps.
fn round(
    n: usize,
    order: usize,
    moves: &[bool],
    hinge: impl Fn(usize) -> bool,
    last: usize,
) -> Option<(usize, usize)> {
    let hinges: Vec<usize> = (0..n).filter(|i| hinge(*i)).collect();
    if moves.iter().all(|moves| *moves) {
        return Some((hinges.len().max(1), last));
    }
    if hinges.is_empty() {
        return Some((0, last));
    }
    // Cut open at a hinge whose value is known.
    let start = *hinges.iter().find(|i| !moves[**i])?;
    let place = |i: usize| Place { index: i % n, moves: moves[i % n], hinge: hinge(i % n) };
    let part: Vec<Place> = (start + 1..=start + n).map(place).collect();
    Some(total(std::iter::once((motions(&part, order, true), &part)), last))
}

fn total<'a>(parts: impl Iterator<Item = (usize, &'a Vec<Place>)>, last: usize) -> (usize, usize) {
    let free = |part: &[Place]| part.iter().rev().find(|place| place.moves).map(|place| place.index);
    parts
        .filter(|(motions, _)| *motions > 0)
        .fold((0, last), |(sum, at), (motions, part)| (sum + motions, free(part).unwrap_or(at)))
}

/// The motions of one part that cost nothing; `known` tells whether the value where it starts is held.
fn motions(part: &[Place], order: usize, mut known: bool) -> usize {
    if order == 1 {
        return usize::from(!known && part.iter().all(|place| place.moves));
    }
    let mut free = usize::from(!known);
    let mut nodes = 0;
    // From hinge to hinge: one more value, less what the held nodes between tell about the line.
    let close = |free: &mut usize, known: &mut bool, nodes: usize| {
        let own = 1 + usize::from(!*known);
        let told = nodes.min(own);
        *free = *free + 1 - told;
        *known = told == own;
    };
    for place in part {
        if !place.hinge {
            nodes += usize::from(!place.moves);
            continue;
        }
        close(&mut free, &mut known, nodes);
        nodes = 0;
        if !place.moves && !known {
            free -= 1;
            known = true;
        }
    }
    // A ring ends at the hinge where it was cut.
    if !part.last().is_some_and(|place| place.hinge) {
        close(&mut free, &mut known, nodes);
    }
    free
}
