//! Solutions that fill a line, where curves coincide or a line lies in a surface.
//!
//! Two polynomials of degrees `(p, q)` with more than `2 p q` common zeros have a common factor (Bézout, on a product
//! of two lines). The zeros of the factor leave the square through its border: so the border is searched for zeros
//! first, and from each the line of zeros is followed inwards, in more than `2 p q` steps, each checked to be a zero up
//! to an accuracy, until it leaves again.

use crate::analysis::meet::casteljau::{Line, restrict, value_and_slope};
use crate::analysis::meet::frame::{Coefficients, Kind, norm, turn};
use crate::analysis::meet::system::{Pair, Problem, System};

/// Steps along a line at most for the proof, and at least.
const STEPS: std::ops::RangeInclusive<usize> = 12..=128;

/// Boxes of one side of the square at most.
const SIDE_BOXES: usize = 512;

/// Zeros on a side are sought to this width.
const WIDTH: f64 = 1e-9;

/// A line of solutions, from border to border.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    pub points: Vec<Pair>,
}

impl Trace {
    pub(crate) fn ends(&self) -> [Pair; 2] {
        [self.points[0], self.points[self.points.len() - 1]]
    }

    /// Whether all solutions in a box are on this line: the line runs through the whole of one side, and for each value
    /// of that unknown there is one value of the other at most that solves the leading equation.
    pub(crate) fn covers<S: System>(&self, problem: &Problem<S>, sides: &[Pair; 2]) -> bool {
        (0..2).any(|axis| self.covers_along(problem, sides, axis))
    }

    fn covers_along<S: System>(&self, problem: &Problem<S>, sides: &[Pair; 2], axis: usize) -> bool {
        let [from, to] = sides[axis];
        let slack = 1e-11;
        let mut reached = [f64::INFINITY, f64::NEG_INFINITY];
        let mut across = sides[1 - axis];
        let mut extend = |x: f64, y: f64, bend: f64| {
            reached = [reached[0].min(x), reached[1].max(x)];
            across = [across[0].min(y - bend), across[1].max(y + bend)];
        };
        for (i, pair) in self.points.windows(2).enumerate() {
            let ([x, y], [z, w]) = ([pair[0][axis], pair[0][1 - axis]], [pair[1][axis], pair[1][1 - axis]]);
            if x.max(z) < from - slack || x.min(z) > to + slack {
                continue;
            }
            // How far the line may leave the chord.
            let second = |j: usize| {
                let c = |j: usize| self.points[j][1 - axis];
                if j > 0 && j + 1 < self.points.len() {
                    (c(j - 1) - 2.0 * c(j) + c(j + 1)).abs()
                } else {
                    0.0
                }
            };
            let bend = second(i).max(second(i + 1)) + slack;
            let at = |x0: f64| if z == x { w } else { y + (w - y) * ((x0 - x) / (z - x)).clamp(0.0, 1.0) };
            let [near, far] = [x.min(z).max(from), x.max(z).min(to)];
            extend(near, at(near), bend);
            extend(far, at(far), bend);
        }
        if reached[0] > from + slack || reached[1] < to - slack {
            return false;
        }
        let across = across.map(|y| y.clamp(0.0, 1.0));
        let part = problem.system.restricted(axis, from, to).restricted(1 - axis, across[0], across[1]);
        let mut coeffs = Vec::new();
        part.fill(&mut coeffs);
        let all = Coefficients { degrees: part.degrees(), coeffs: &coeffs, noise: problem.noise };
        let [a, b] = all.slopes();
        let [low, high] = all.combined(Kind::Turned, turn(a, b)).slope_range(0, 1 - axis);
        low > 0.0 || high < 0.0
    }

    /// Where an end of the line cuts a box, if it does.
    pub(crate) fn cut(&self, sides: &[Pair; 2]) -> Option<(usize, f64)> {
        let cuts = self.ends().into_iter().flat_map(|end| [(0, end[0]), (1, end[1])]);
        cuts.into_iter().find(|&(axis, x)| x > sides[axis][0] + 1e-10 && x < sides[axis][1] - 1e-10)
    }
}

/// The lines of solutions, where the equations hold up to `accuracy`; those shorter than `shortest` do not count.
pub(crate) fn traces<S: System>(
    problem: &Problem<S>,
    coeffs: &[Pair],
    accuracy: f64,
    shortest: f64,
) -> Vec<Trace> {
    let mut starts = border(problem.system.degrees(), coeffs, accuracy);
    let mut traces = Vec::new();
    while starts.len() > 1 {
        let start = starts.remove(0);
        let Some(trace) = follow(problem, start, accuracy) else { continue };
        let length = |pair: &[Pair]| {
            (0..2).map(|k| (pair[1][k] - pair[0][k]).abs() * problem.speeds[k]).fold(0.0, f64::max)
        };
        if trace.points.windows(2).map(length).sum::<f64>() > shortest {
            let end = trace.ends()[1];
            starts.retain(|other| distance(*other, end) > 1e-6);
            traces.push(trace);
        }
    }
    traces
}

fn distance(a: Pair, b: Pair) -> f64 {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs())
}

/// Zeros on the sides of the square.
fn border([p, q]: [usize; 2], coeffs: &[Pair], accuracy: f64) -> Vec<Pair> {
    let mut found: Vec<Pair> = Vec::new();
    for (axis, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let side: Vec<Pair> = match axis {
            0 => coeffs[end * p * (q + 1)..][..=q].to_vec(),
            _ => coeffs[end * q..].iter().step_by(q + 1).copied().collect(),
        };
        for x in side_zeros(&side, accuracy) {
            let mut place = [end as f64; 2];
            place[1 - axis] = x;
            if found.iter().all(|other| distance(*other, place) > 1e-9) {
                found.push(place);
            }
        }
    }
    found
}

/// Where a polynomial with values in the plane vanishes up to `accuracy`: one place for each stretch.
fn side_zeros(side: &[Pair], accuracy: f64) -> Vec<f64> {
    let mut open = vec![([0.0, 1.0], side.to_vec())];
    let mut kept: Vec<Pair> = Vec::new();
    let mut boxes = 0;
    while let Some(([from, to], c)) = open.pop() {
        boxes += 1;
        if boxes > SIDE_BOXES {
            break;
        }
        let chord = [c[c.len() - 1][0] - c[0][0], c[c.len() - 1][1] - c[0][1]];
        let size = norm(chord);
        let normal = if size > 0.0 { [-chord[1] / size, chord[0] / size] } else { [1.0, 0.0] };
        let misses = [[1.0, 0.0], [0.0, 1.0], normal].iter().any(|n| {
            let value = |c: &Pair| n[0] * c[0] + n[1] * c[1];
            c.iter().all(|c| value(c) > accuracy) || c.iter().all(|c| value(c) < -accuracy)
        });
        if misses {
            continue;
        }
        if to - from <= WIDTH || c.iter().all(|c| norm(*c) <= accuracy) {
            kept.push([from, to]);
            continue;
        }
        let middle = 0.5 * (from + to);
        for (half, a, b) in [([from, middle], 0.0, 0.5), ([middle, to], 0.5, 1.0)] {
            let mut part = c.clone();
            restrict(&mut part, Line::whole(side.len()), a, b);
            open.push((half, part));
        }
    }
    kept.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut stretches: Vec<Pair> = Vec::new();
    for [from, to] in kept {
        match stretches.last_mut() {
            Some(last) if from <= last[1] + 2.0 * WIDTH => last[1] = to,
            _ => stretches.push([from, to]),
        }
    }
    let ends = |[from, to]: Pair| if to - from > 0.5 { vec![from, to] } else { vec![0.5 * (from + to)] };
    let sharp = |x: f64| nearest(|x| value_and_slope(&mut side.to_vec(), x), x, accuracy);
    let vanishes = |x: &f64| norm(value_and_slope(&mut side.to_vec(), *x)[0]) <= accuracy;
    stretches.into_iter().flat_map(ends).map(sharp).filter(vanishes).collect()
}

/// The parameter in `[0, 1]` near `x` where a polynomial with values in the plane is nearest to zero, by Gauss-Newton.
///
/// Slopes that are no larger than the accuracy do not tell.
fn nearest(local: impl Fn(f64) -> [Pair; 2], mut x: f64, accuracy: f64) -> f64 {
    for _ in 0..6 {
        let [value, slope] = local(x);
        let size = norm(slope);
        if size <= accuracy {
            return x;
        }
        let step = (value[0] * (slope[0] / size) + value[1] * (slope[1] / size)) / size;
        // Roundings do not count: an end stays an end.
        let next = (x - step).clamp(0.0, 1.0);
        x = if next < 1e-14 {
            0.0
        } else if next > 1.0 - 1e-14 {
            1.0
        } else {
            next
        };
    }
    x
}

/// The line of solutions from a point of the border inwards.
fn follow<S: System>(problem: &Problem<S>, start: Pair, accuracy: f64) -> Option<Trace> {
    let [p, q] = problem.system.degrees();
    let steps = (2 * p * q + 1).clamp(*STEPS.start(), *STEPS.end());
    let leading = leading(problem, start)?;
    let inward =
        |d: &Pair| (0..2).all(|k| !(start[k] == 0.0 && d[k] < -1e-9 || start[k] == 1.0 && d[k] > 1e-9));
    let along = [[-leading.1[1], leading.1[0]], [leading.1[1], -leading.1[0]]];
    along.into_iter().filter(inward).find_map(|direction| {
        let walk = Walk { problem, accuracy };
        let rough = walk.points(start, direction, 1.0 / steps as f64, 8 * steps)?;
        if rough.len() > steps {
            return Some(Trace { points: rough });
        }
        let length: f64 = rough.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
        let fine = walk.points(start, direction, length / (steps + 2) as f64, 8 * steps)?;
        (fine.len() > steps).then_some(Trace { points: fine })
    })
}

/// The value of the leading equation at `x` and its unit gradient with the length, if the Jacobian is not zero.
fn leading<S: System>(problem: &Problem<S>, x: Pair) -> Option<(f64, Pair, f64)> {
    let local = problem.system.at(x);
    let [a, b] = local.slopes;
    let row = turn(a, b)[0];
    let dot = |c: Pair| row[0] * c[0] + row[1] * c[1];
    let gradient = [dot(a), dot(b)];
    let size = norm(gradient);
    (size > problem.noise).then(|| (dot(local.value), gradient.map(|g| g / size), size))
}

struct Walk<'a, S> {
    problem: &'a Problem<S>,
    accuracy: f64,
}

impl<S: System> Walk<'_, S> {
    fn vanishes(&self, x: Pair) -> bool {
        norm(self.problem.system.at(x).value) <= self.accuracy
    }

    /// The points from `start` to the border.
    fn points(&self, start: Pair, direction: Pair, step: f64, most: usize) -> Option<Vec<Pair>> {
        let (mut points, mut direction) = (vec![start], direction);
        while points.len() <= most {
            let here = points[points.len() - 1];
            let guess = [here[0] + step * direction[0], here[1] + step * direction[1]];
            let next = self.corrected(guess);
            if next.iter().any(|x| !(-1e-12..=1.0 + 1e-12).contains(x)) {
                points.push(self.exit(here, next)?);
                return Some(points);
            }
            let moved = [next[0] - here[0], next[1] - here[1]];
            let size = norm(moved);
            if !self.vanishes(next) || size < 0.25 * step || size > 4.0 * step {
                return None;
            }
            let ahead = self.direction(next, moved.map(|x| x / size));
            if let Some(k) = (0..2).find(|&k| direction[k] * ahead[k] < 0.0) {
                points.push(self.turning(here, next, k, direction));
            }
            direction = ahead;
            points.push(next);
        }
        None
    }

    /// The direction of the line at `x`, the one nearer to `last`.
    fn direction(&self, x: Pair, last: Pair) -> Pair {
        let Some((_, gradient, _)) = leading(self.problem, x) else { return last };
        let along = [-gradient[1], gradient[0]];
        let same = along[0] * last[0] + along[1] * last[1] >= 0.0;
        if same { along } else { along.map(|x| -x) }
    }

    /// The point between two of the line where unknown `k` turns back, by bisection.
    fn turning(&self, from: Pair, to: Pair, k: usize, direction: Pair) -> Pair {
        let place = |part: f64| {
            self.corrected([from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])])
        };
        let (mut before, mut after) = (0.0, 1.0);
        for _ in 0..50 {
            let middle = 0.5 * (before + after);
            if self.direction(place(middle), direction)[k] * direction[k] > 0.0 {
                before = middle;
            } else {
                after = middle;
            }
        }
        place(before)
    }

    /// The point where the leading equation holds, near `x`.
    fn corrected(&self, mut x: Pair) -> Pair {
        for _ in 0..6 {
            let Some((value, gradient, size)) = leading(self.problem, x) else { return x };
            let step = value / size;
            if step.abs() > 0.25 || step.is_nan() {
                return x;
            }
            x = [x[0] - step * gradient[0], x[1] - step * gradient[1]];
            if step.abs() < 1e-15 {
                return x;
            }
        }
        x
    }

    /// Where the line from a point inside to one outside leaves the square.
    fn exit(&self, inside: Pair, outside: Pair) -> Option<Pair> {
        let places = (0..2).filter_map(|k| {
            let end = if outside[k] < 0.0 {
                0.0
            } else if outside[k] > 1.0 {
                1.0
            } else {
                return None;
            };
            let part = (end - inside[k]) / (outside[k] - inside[k]);
            let guess = inside[1 - k] + part * (outside[1 - k] - inside[1 - k]);
            let place = |y: f64| if k == 0 { [end, y] } else { [y, end] };
            let local = |y: f64| {
                let local = self.problem.system.at(place(y));
                [local.value, local.slopes[1 - k]]
            };
            let place = place(nearest(local, guess.clamp(0.0, 1.0), self.accuracy));
            self.vanishes(place).then_some(place)
        });
        places.min_by(|a, b| distance(*a, inside).total_cmp(&distance(*b, inside)))
    }
}
