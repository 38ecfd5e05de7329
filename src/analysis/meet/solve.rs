//! The search: boxes are excluded, proved to hold one solution, clipped or halved.

use crate::analysis::meet::certify::{Root, certify};
use crate::analysis::meet::frame::{Coefficients, Frame, Kind};
use crate::analysis::meet::system::{Pair, Problem, System};
use crate::analysis::meet::trace::{Trace, traces};
use crate::error::{Error, Result};

/// After so many boxes of one system, lines of solutions are looked for to the tolerance.
const MANY: usize = 192;

/// The work for one system, after which what is open is left over.
const MOST: usize = 1 << 21;

/// What a line of solutions costs, in boxes, and what is left over, in units of work.
const TRACED: usize = 32;
const KEPT: usize = 64;

/// A clip that leaves more than this of a side is none.
const STALLED: f64 = 0.7;

/// A clip is widened by this part of the side.
const WIDENED: f64 = 1e-3;

/// Clips leave at least this of the unit interval: in a sliver, derivatives across it are noise.
const SLENDER: f64 = 1e-8;

/// Boxes are not halved further than this.
const NARROW: f64 = 1e-14;

/// Along lines of solutions equations hold up to this many times the noise.
const ALONG: f64 = 16.0;

/// What the search found in the unit square.
#[derive(Clone, Debug, Default)]
pub(crate) struct Findings {
    pub roots: Vec<Root>,
    /// Boxes in which solutions can neither be excluded nor proved.
    pub left: Vec<[Pair; 2]>,
    /// Lines of solutions; no box covers a part of them.
    pub traces: Vec<Trace>,
}

/// How much work there may be in all: some units of a coefficient of a box each.
#[derive(Debug)]
pub(crate) struct Budget {
    spent: usize,
}

impl Budget {
    /// About a second.
    const LIMIT: usize = 1 << 26;

    pub(crate) fn new() -> Self {
        Self { spent: 0 }
    }

    /// # Errors
    /// [`Error::TooLarge`].
    pub(crate) fn spend(&mut self, units: usize) -> Result<()> {
        self.spent += units;
        if self.spent > Self::LIMIT {
            return Err(Error::TooLarge { count: self.spent, limit: Self::LIMIT });
        }
        Ok(())
    }
}

/// A part of the square.
struct Cell<S> {
    system: S,
    sides: [Pair; 2],
}

impl<S: System> Cell<S> {
    fn new(problem: &Problem<S>, sides: [Pair; 2]) -> Self {
        let [u, v] = sides;
        Self { system: problem.system.restricted(0, u[0], u[1]).restricted(1, v[0], v[1]), sides }
    }

    fn part(&self, axis: usize, from: f64, to: f64) -> Self {
        let mut sides = self.sides;
        let [a, b] = sides[axis];
        let place = |x: f64| if x == 1.0 { b } else { a + (b - a) * x };
        sides[axis] = [place(from), place(to)];
        Self { system: self.system.restricted(axis, from, to), sides }
    }

    fn width(&self, axis: usize) -> f64 {
        self.sides[axis][1] - self.sides[axis][0]
    }
}

/// The solutions in the unit square: boxes are left over only when their points are within `tolerance`, when an
/// equation is noise all over them, or when there are too many.
///
/// # Errors
/// [`Error::TooLarge`].
pub(crate) fn solve<S: System>(
    problem: &Problem<S>,
    tolerance: f64,
    budget: &mut Budget,
) -> Result<Findings> {
    let degrees = problem.system.degrees();
    let mut search = Search { problem, tolerance, found: Findings::default(), coeffs: Vec::new() };
    let whole = Cell::new(problem, [[0.0, 1.0]; 2]);
    let [p, q] = degrees.map(|degree| degree + 1);
    // Boxes of low degrees cost something, too; to cut them costs as much as the squares of the degrees.
    let units = p * q + p * p + q * q + 16;
    let most = (MOST / units).max(256 * (p * q + 1));
    let mut open = vec![whole];
    let mut boxes = 0;
    while let Some(cell) = open.pop() {
        budget.spend(units)?;
        boxes += 1;
        if boxes > most {
            search.found.left.push(cell.sides);
            continue;
        }
        if boxes == MANY && search.found.traces.is_empty() {
            search.look_for_traces(tolerance * problem.weight);
        }
        search.visit(cell, boxes == 1, &mut open);
        if boxes == 1 {
            budget.spend(TRACED * search.found.traces.len() * units)?;
        }
    }
    // Boxes next to proved solutions are left over only because they are small: they need not be.
    search.tolerance = 0.0;
    let (beside, left): (Vec<_>, Vec<_>) = search
        .found
        .left
        .iter()
        .partition(|sides| search.found.roots.iter().any(|root| is_beside(root, sides)));
    search.found.left = left;
    open.extend(beside.iter().map(|sides| Cell::new(problem, *sides)));
    for _ in 0..MANY * open.len() {
        let Some(cell) = open.pop() else { break };
        budget.spend(units)?;
        search.visit(cell, false, &mut open);
    }
    search.found.left.extend(open.iter().map(|cell| cell.sides));
    budget.spend(KEPT * search.found.left.len())?;
    Ok(search.found)
}

/// Whether a box touches where the root is the only solution.
fn is_beside(root: &Root, sides: &[Pair; 2]) -> bool {
    (0..2).all(|k| sides[k][0] <= root.x[k] + root.reach[k] && sides[k][1] >= root.x[k] - root.reach[k])
}

/// Whether a box lies where the root is the only solution.
fn reaches(root: &Root, sides: &[Pair; 2]) -> bool {
    (0..2).all(|k| {
        let within = |x: f64| (x - root.x[k]).abs() <= root.reach[k];
        within(sides[k][0]) && within(sides[k][1])
    })
}

/// Whether the root may lie in a box.
fn touches(root: &Root, sides: &[Pair; 2]) -> bool {
    (0..2).all(|k| root.x[k] + root.radius[k] >= sides[k][0] && root.x[k] - root.radius[k] <= sides[k][1])
}

/// Whether two proofs are of one solution.
fn same(one: &Root, other: &Root) -> bool {
    (0..2).all(|k| (one.x[k] - other.x[k]).abs() <= one.radius[k] + other.radius[k])
}

struct Search<'a, S> {
    problem: &'a Problem<S>,
    tolerance: f64,
    found: Findings,
    coeffs: Vec<Pair>,
}

impl<S: System> Search<'_, S> {
    fn look_for_traces(&mut self, accuracy: f64) {
        self.problem.system.fill(&mut self.coeffs);
        let least = ALONG * self.problem.noise;
        self.found.traces = traces(self.problem, &self.coeffs, accuracy.max(least), self.tolerance);
    }

    /// Decides a cell or puts its parts on the list.
    fn visit(&mut self, cell: Cell<S>, whole: bool, open: &mut Vec<Cell<S>>) {
        if self.found.roots.iter().any(|root| reaches(root, &cell.sides)) {
            return;
        }
        cell.system.fill(&mut self.coeffs);
        let degrees = cell.system.degrees();
        let all = Coefficients { degrees, coeffs: &self.coeffs, noise: self.problem.noise };
        if all.misses() {
            return;
        }
        let frame = all.frame();
        if frame.misses() {
            return;
        }
        let steps = all.steps();
        let one_at_most = frame.kind == Kind::Regular && frame.is_dominated();
        if whole && !one_at_most {
            self.look_for_traces(0.0);
        }
        if self.found.traces.iter().any(|trace| trace.covers(self.problem, &cell.sides)) {
            return;
        }
        let root = if one_at_most { self.root_near(&frame, &cell) } else { None };
        if let Some(root) = root.filter(|root| touches(root, &cell.sides)) {
            if !self.found.roots.iter().any(|other| same(other, &root)) {
                self.found.roots.push(root);
            }
            return;
        }
        let small = (0..2).all(|k| self.problem.speeds[k] * cell.width(k) <= self.tolerance);
        // Next to a root that is proved the next clip will leave nothing.
        if small && root.is_none() {
            self.found.left.push(cell.sides);
            return;
        }
        if let Some((axis, x)) = self.found.traces.iter().find_map(|trace| trace.cut(&cell.sides)) {
            let at = (x - cell.sides[axis][0]) / cell.width(axis);
            open.extend([cell.part(axis, at, 1.0), cell.part(axis, 0.0, at)]);
            return;
        }
        let clip = |axis: usize| match frame.kind {
            Kind::Regular => frame.clip(axis, axis),
            Kind::Turned => frame.clip(0, axis),
        };
        let (Some(u), Some(v)) = (clip(0), clip(1)) else { return };
        let wide = |[from, to]: Pair, k: usize| {
            let more = WIDENED.max(0.5 * SLENDER / cell.width(k));
            [(from - more).max(0.0), (to + more).min(1.0)]
        };
        let parts = [wide(u, 0), wide(v, 1)];
        let helps = [0, 1].map(|k| parts[k][1] - parts[k][0] < STALLED);
        if helps != [false; 2] {
            let clip = |cell: Cell<S>, k: usize| cell.part(k, parts[k][0], parts[k][1]);
            open.push((0..2).filter(|&k| helps[k]).fold(cell, clip));
            return;
        }
        // Noise in one equation and one branch of solutions of the other: that is all there is to know.
        if frame.is_flat(1) && frame.is_monotone(0) || frame.is_flat(0) {
            self.found.left.push(cell.sides);
            return;
        }
        // Halves, across the side along which more happens.
        let usable = |k: &usize| steps[*k] > 0.0 && cell.width(*k) > NARROW;
        match (0..2).filter(usable).max_by(|j, k| steps[*j].total_cmp(&steps[*k])) {
            Some(axis) => open.extend([cell.part(axis, 0.5, 1.0), cell.part(axis, 0.0, 0.5)]),
            None => self.found.left.push(cell.sides),
        }
    }

    /// The solution that Newton's method finds from a cell with one at most, if it is proved; it may be near the cell
    /// only.
    fn root_near(&self, frame: &Frame, cell: &Cell<S>) -> Option<Root> {
        // The combined equations are about x - a and y - b: so their means are those from the middle.
        let mean = |k: usize| frame.coeffs.iter().map(|c| c[k]).sum::<f64>() / frame.coeffs.len() as f64;
        let guess = [0, 1].map(|k| 0.5 - mean(k));
        let near = guess.iter().all(|x| (-0.5..=1.5).contains(x));
        let place = [0, 1].map(|k| cell.sides[k][0] + cell.width(k) * guess[k]);
        near.then(|| certify(self.problem, place)).flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::meet::system::{Grid, rounding};

    /// The system of two products of polynomials in one unknown each: solutions are pairs of roots.
    fn product(us: &[f64], vs: &[f64]) -> Problem<Grid> {
        let degrees = [us.len() - 1, vs.len() - 1];
        let coeffs = us.iter().flat_map(|u| vs.iter().map(move |v| [*u, *v])).collect();
        Problem {
            system: Grid { degrees, coeffs },
            noise: rounding(degrees, 1.0),
            speeds: [1.0; 2],
            weight: 1.0,
        }
    }

    fn found(problem: &Problem<Grid>) -> Findings {
        solve(problem, 1e-9, &mut Budget::new()).unwrap()
    }

    #[test]
    fn pairs_of_roots_are_found() {
        // Three roots each: those of the Chebyshev polynomial of degree 3, moved to [0, 1].
        let chebyshev = [-1.0, 5.0, -5.0, 1.0];
        let found = found(&product(&chebyshev, &chebyshev));
        assert_eq!((found.roots.len(), found.left.len(), found.traces.len()), (9, 0, 0), "{found:?}");
        for root in found.roots {
            let nearest = |x: f64| {
                let roots = [1.0, 3.0, 5.0].map(|k: f64| 0.5 + 0.5 * (k * std::f64::consts::PI / 6.0).cos());
                roots.iter().map(|r| (r - x).abs()).fold(1.0, f64::min)
            };
            assert!((0..2).all(|k| nearest(root.x[k]) <= root.radius[k]));
        }
    }

    #[test]
    fn double_roots_are_left_over() {
        // (2 x - 1)² = 0, y = 1/2.
        let found = found(&product(&[1.0, -1.0, 1.0], &[-1.0, 1.0]));
        assert!(found.roots.is_empty() && !found.left.is_empty() && found.left.len() < 16);
        for sides in found.left {
            assert!((0..2).all(|k| sides[k][0] <= 0.5 + 1e-7 && sides[k][1] >= 0.5 - 1e-7));
        }
    }

    #[test]
    fn roots_at_corners_and_cuts_are_found_once() {
        let found = found(&product(&[0.0, 1.0], &[-1.0, 0.0]));
        assert_eq!((found.roots.len(), found.left.len()), (1, 0));
        let found = self::found(&product(&[-1.0, 1.0], &[-1.0, -1.0, 1.0, 1.0]));
        assert_eq!((found.roots.len(), found.left.len()), (1, 0));
    }

    #[test]
    fn lines_of_solutions_are_traced() {
        // (x - y) (1, 2).
        let coeffs = vec![[0.0, 0.0], [-1.0, -2.0], [1.0, 2.0], [0.0, 0.0]];
        let problem = Problem {
            system: Grid { degrees: [1, 1], coeffs },
            noise: rounding([1, 1], 2.0),
            speeds: [1.0; 2],
            weight: 1.0,
        };
        let found = found(&problem);
        assert_eq!((found.roots.len(), found.left.len(), found.traces.len()), (0, 0, 1));
        assert_eq!(found.traces[0].ends(), [[0.0, 0.0], [1.0, 1.0]]);
    }
}
