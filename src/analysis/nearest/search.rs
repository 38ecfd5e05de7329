//! Branch and bound over the pieces: the least distance, or all pieces of the curve or surface that come as near as a
//! given distance.

use crate::analysis::nearest::pieces::{Pieces, Sides};
use crate::analysis::nearest::polish::{Found, Rooms};
use crate::analysis::nearest::ratio::Slopes;
use crate::analysis::nearest::split::{count, halve};
use crate::analysis::nearest::square::Squaring;
use crate::analysis::nearest::tree::Tree;
use nalgebra::SVector;

/// How deep the tree may be, and more.
const DEPTH: usize = 96;

/// After how much work the first descent is made, the next after twice as much; troughs are looked for from then on.
pub(super) const PATIENCE: usize = 1 << 15;

/// A part of a piece.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) root: u32,
    /// The degrees: a direction that no longer matters has 0.
    pub(super) degrees: [usize; 2],
    /// Where it is in the piece: without extent in directions of which only a side matters.
    pub(super) sides: Sides,
    /// Where the part was of which it is a side.
    pub(super) basin: Sides,
    /// Its coefficients begin here.
    pub(super) first: usize,
    /// No point is nearer.
    pub(super) lower: f64,
    /// How far the distance may be below that of the side.
    pub(super) slack: f64,
}

/// A point of a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) root: usize,
    /// Local parameters.
    pub(super) at: [f64; 2],
    pub(super) distance: f64,
}

/// A part of a piece that comes as near as was asked.
#[derive(Clone, Debug)]
pub(super) struct Site {
    /// Its nearest point.
    pub(super) spot: Spot,
    /// From all of this the distance descends to `spot` or to `sides`.
    pub(super) basin: Sides,
    /// All of this may come as near; one point only if there is one nearest point.
    pub(super) sides: Sides,
}

/// What is kept from one search to the next.
#[derive(Clone, Debug)]
pub(super) struct Room<const N: usize> {
    pub(super) parts: Vec<Part>,
    pub(super) points: Vec<SVector<f64, N>>,
    pub(super) weights: Vec<f64>,
    pub(super) quotients: Vec<SVector<f64, N>>,
    pub(super) raised: Vec<SVector<f64, N>>,
    pub(super) raised_weights: Vec<f64>,
    pub(super) squares: Vec<f64>,
    pub(super) weight_squares: Vec<f64>,
    pub(super) rooms: Rooms<N>,
}

impl<const N: usize> Default for Room<N> {
    fn default() -> Self {
        Self {
            parts: Vec::new(),
            points: Vec::new(),
            weights: Vec::new(),
            quotients: Vec::new(),
            raised: Vec::new(),
            raised_weights: Vec::new(),
            squares: Vec::new(),
            weight_squares: Vec::new(),
            rooms: Rooms::default(),
        }
    }
}

/// What is searched.
#[derive(Clone, Debug)]
pub(super) struct Ground<const N: usize> {
    pub(super) pieces: Pieces<N>,
    pub(super) tree: Tree<N>,
    pub(super) squaring: Squaring,
    /// Of rational splines of low degree.
    pub(super) slopes: Option<Slopes>,
}

/// A search for one point.
pub(super) struct Search<'a, const N: usize> {
    pub(super) ground: &'a Ground<N>,
    pub(super) room: &'a mut Room<N>,
    pub(super) point: SVector<f64, N>,
    /// What coordinates may be off by, in units of the largest about a part.
    pub(super) epsilon: f64,
    pub(super) accuracy: f64,
    /// The accuracy that will do after much work.
    pub(super) wanted: f64,
    /// Parts that come no nearer do not matter.
    pub(super) cut: f64,
    pub(super) best: Spot,
    /// No point is nearer than this, among those seen.
    pub(super) bound: f64,
    /// If all parts as near as this are wanted: those found.
    pub(super) sites: Option<Vec<Site>>,
    pub(super) work: usize,
    /// At how much work the best point is brought down next.
    pub(super) patience: usize,
}

/// What is to be done with a part.
pub(super) enum Verdict {
    Done,
    Halve(usize),
}

/// The least distance of `point`: a point met, and a bound that is lower by less than `accuracy`, after much work by
/// less than `wanted`, if the work suffices.
pub(super) fn least<const N: usize>(
    ground: &Ground<N>,
    room: &mut Room<N>,
    point: SVector<f64, N>,
    (accuracy, wanted): (f64, f64),
) -> (Spot, f64) {
    let mut search = Search::new(ground, room, point, accuracy, f64::INFINITY, None);
    search.wanted = wanted;
    search.run();
    let (best, bound) = (search.best, search.bound);
    (best, bound.min(best.distance))
}

/// All parts that come as near as `level`.
pub(super) fn within<const N: usize>(
    ground: &Ground<N>,
    room: &mut Room<N>,
    point: SVector<f64, N>,
    accuracy: f64,
    level: f64,
) -> Vec<Site> {
    let mut search = Search::new(ground, room, point, accuracy, level, Some(Vec::new()));
    search.run();
    search.sites.unwrap_or_default()
}

/// The unit of rounding for these degrees in `N` dimensions.
pub(super) fn epsilon<const N: usize>(degrees: [usize; 2]) -> f64 {
    (2 * (degrees[0] + degrees[1]) + N + 4) as f64 * f64::EPSILON
}

impl<'a, const N: usize> Search<'a, N> {
    fn new(
        ground: &'a Ground<N>,
        room: &'a mut Room<N>,
        point: SVector<f64, N>,
        accuracy: f64,
        cut: f64,
        sites: Option<Vec<Site>>,
    ) -> Self {
        let best = Spot { root: 0, at: [0.0; 2], distance: f64::INFINITY };
        let (bound, work, epsilon) = (f64::INFINITY, 0, epsilon::<N>(ground.pieces.degrees));
        let (wanted, patience) = (accuracy, PATIENCE);
        Self { ground, room, point, epsilon, accuracy, wanted, cut, best, bound, sites, work, patience }
    }

    fn run(&mut self) {
        let nodes = &self.ground.tree.nodes;
        let mut open = [(0.0, 0_u32); DEPTH];
        open[0] = (nodes[0].squared_distance(&self.point), 0);
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (square, node) = open[count];
            if self.dismisses(square.sqrt()) {
                continue;
            }
            let node = &nodes[node as usize];
            if node.is_leaf {
                self.search_piece(node.next, square.sqrt());
                continue;
            }
            let next = [0, 1]
                .map(|i| (nodes[node.next as usize + i].squared_distance(&self.point), node.next + i as u32));
            let [near, far] = if next[0].0 <= next[1].0 { next } else { [next[1], next[0]] };
            (open[count], open[count + 1]) = (far, near);
            count += 2;
        }
    }

    /// Whether what is no nearer than `lower` does not matter.
    #[inline]
    pub(super) fn dismisses(&mut self, lower: f64) -> bool {
        let dismissed = lower >= self.cut;
        if dismissed {
            self.bound = self.bound.min(lower);
        }
        dismissed
    }

    fn search_piece(&mut self, root: u32, lower: f64) {
        let pieces = &self.ground.pieces;
        let n = count(pieces.degrees);
        let own = root as usize * n..(root as usize + 1) * n;
        let room = &mut *self.room;
        room.points.clear();
        room.weights.clear();
        if pieces.weights.is_empty() {
            room.points.extend(pieces.points[own].iter().map(|c| c - self.point));
        } else {
            room.weights.extend_from_slice(&pieces.weights[own.clone()]);
            let weighted = pieces.points[own].iter().zip(&room.weights);
            room.points.extend(weighted.map(|(c, weight)| c - self.point * *weight));
        }
        let (degrees, sides) = (pieces.degrees, [(0.0, 1.0); 2]);
        room.parts.push(Part { root, degrees, sides, basin: sides, first: 0, lower, slack: 0.0 });
        while let Some(mut part) = self.room.parts.pop() {
            let verdict = if self.dismisses(part.lower) { Verdict::Done } else { self.examine(&mut part) };
            match verdict {
                Verdict::Halve(axis) => self.halve(part, axis),
                Verdict::Done => {
                    self.room.points.truncate(part.first);
                    if !pieces.weights.is_empty() {
                        self.room.weights.truncate(part.first);
                    }
                }
            }
        }
    }

    /// Puts both halves on the stack, the nearer one above.
    fn halve(&mut self, part: Part, axis: usize) {
        let (room, n) = (&mut *self.room, count(part.degrees));
        let corner = |k: usize| room.points[part.first + k].norm_squared();
        let [low, high] = if axis == 0 {
            let width = part.degrees[1];
            [corner(0) + corner(width), corner(n - 1 - width) + corner(n - 1)]
        } else {
            let width = part.degrees[1];
            [corner(0) + corner(n - 1 - width), corner(width) + corner(n - 1)]
        };
        let upper_last = high < low;
        halve(&mut room.points, part.first, part.degrees, axis, upper_last);
        if !room.weights.is_empty() {
            halve(&mut room.weights, part.first, part.degrees, axis, upper_last);
        }
        let middle = 0.5 * (part.sides[axis].0 + part.sides[axis].1);
        let (mut lower, mut upper) = (part.clone(), part);
        (lower.sides[axis].1, upper.sides[axis].0) = (middle, middle);
        (lower.basin[axis], upper.basin[axis]) = (lower.sides[axis], upper.sides[axis]);
        let [below, mut above] = if upper_last { [lower, upper] } else { [upper, lower] };
        above.first += n;
        room.parts.extend([below, above]);
    }

    /// Is done with a part: with its nearest point, or without having found it.
    pub(super) fn settle(&mut self, part: &Part, found: Option<Found>) {
        let place = |axis: usize, t: f64| {
            let (low, high) = part.sides[axis];
            if t == 1.0 { high } else { low + t * (high - low) }
        };
        let root = part.root as usize;
        let end = count(part.degrees) == 1;
        let spot = match found {
            Some(Found { at, distance, .. }) => {
                Spot { root, at: [place(0, at[0]), place(1, at[1])], distance }
            }
            None => {
                let k = part.first;
                let weight = self.room.weights.get(k).copied().unwrap_or(1.0);
                let distance = self.room.points[k].norm() / weight;
                Spot { root, at: [part.sides[0].0, part.sides[1].0], distance }
            }
        };
        let Some(sites) = &mut self.sites else {
            let lower = match found {
                Some(found) => found.lower - part.slack,
                None if end => spot.distance - part.slack,
                None => part.lower,
            };
            self.bound = self.bound.min(lower);
            if spot.distance < self.best.distance {
                self.best = spot;
                self.cut = spot.distance - 0.5 * self.accuracy;
            }
            return;
        };
        if (found.is_some() || end) && spot.distance > self.cut {
            return;
        }
        let sides = [0, 1].map(|axis| {
            let flat = found.is_some() && part.degrees[axis] > 0;
            if flat { (spot.at[axis], spot.at[axis]) } else { part.sides[axis] }
        });
        sites.push(Site { spot, basin: part.basin, sides });
    }
}
