//! Lines of solutions as stretches of parameters: split where they turn back, joined where pieces meet.

use crate::analysis::meet::merge::{Axis, Place};
use crate::analysis::meet::system::Pair;
use crate::analysis::meet::trace::Trace;

/// Ends of stretches are compared to this part of a domain.
const SLACK: f64 = 1e-9;

/// From where to where a line of solutions runs, ascending in the first parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    pub from: Pair,
    pub to: Pair,
}

impl Stretch {
    /// Whether a place lies at an end and is not longer than the stretch.
    pub(crate) fn ends_at(&self, place: &Place, axes: &[Axis; 2]) -> bool {
        let near = |end: &Pair| {
            (0..2).all(|k| {
                let Axis { domain: [a, b], closed } = axes[k];
                let (slack, [from, to]) = (SLACK * (b - a), place[k]);
                let within = |x: f64| x >= from - slack && x <= to + slack;
                within(end[k]) || closed && (within(end[k] - (b - a)) || within(end[k] + (b - a)))
            })
        };
        let share = |length: &dyn Fn(usize) -> f64| {
            let part = |k: usize| length(k) / (axes[k].domain[1] - axes[k].domain[0]);
            part(0).max(part(1))
        };
        let own = share(&|k| (self.to[k] - self.from[k]).abs());
        share(&|k| place[k][1] - place[k][0]) <= own && (near(&self.from) || near(&self.to))
    }
}

/// The stretches of a line of solutions, each monotone in both unknowns, in parameters.
pub(crate) fn stretches(trace: &Trace, axes: &[Axis; 2], parameters: impl Fn(Pair) -> Pair) -> Vec<Stretch> {
    let points: Vec<Pair> = trace.points.iter().map(|x| parameters(*x)).collect();
    let mut cuts = vec![0, points.len() - 1];
    for k in 0..2 {
        let values: Vec<f64> = points.iter().map(|x| x[k]).collect();
        cuts.extend(turns(&values, slack(axes)[k]));
    }
    cuts.sort_unstable();
    cuts.dedup();
    let stretch = |pair: &[usize]| Stretch { from: points[pair[0]], to: points[pair[1]] }.oriented(axes);
    cuts.windows(2).map(stretch).collect()
}

fn slack(axes: &[Axis; 2]) -> Pair {
    axes.map(|axis| SLACK * (axis.domain[1] - axis.domain[0]))
}

/// Where values turn back by more than `slack`.
fn turns(values: &[f64], slack: f64) -> Vec<usize> {
    let (mut turns, mut sign, mut extreme) = (Vec::new(), 0.0, 0);
    for (i, x) in values.iter().enumerate() {
        let moved = x - values[extreme];
        if sign * moved >= 0.0 && (sign != 0.0 || moved.abs() > slack) {
            (sign, extreme) = (if sign == 0.0 { moved.signum() } else { sign }, i);
        } else if moved.abs() > slack {
            turns.push(extreme);
            (sign, extreme) = (-sign, i);
        }
    }
    turns
}

impl Stretch {
    /// The same, ascending in the first parameter, or in the second if the first stays.
    fn oriented(self, axes: &[Axis; 2]) -> Self {
        let slack = slack(axes);
        let moved = [0, 1].map(|k| self.to[k] - self.from[k]);
        let falls = if moved[0].abs() > slack[0] { moved[0] < 0.0 } else { moved[1] < 0.0 };
        if falls { Self { from: self.to, to: self.from } } else { self }
    }

    /// Whether the first parameter moves, and how the second does.
    fn kind(&self, slack: Pair) -> (bool, i8) {
        let moved = [0, 1].map(|k| self.to[k] - self.from[k]);
        let sign = i8::from(moved[1] > slack[1]) - i8::from(moved[1] < -slack[1]);
        (moved[0].abs() > slack[0], sign)
    }
}

/// Stretches that follow each other as one, in order. Seams are not crossed.
pub(crate) fn joined(mut parts: Vec<Stretch>, axes: &[Axis; 2]) -> Vec<Stretch> {
    let slack = slack(axes);
    // A line on a seam is told from the start.
    for part in &mut parts {
        for k in (0..2).filter(|&k| axes[k].closed) {
            let [start, end] = axes[k].domain;
            if part.from[k] >= end - slack[k] && part.to[k] >= end - slack[k] {
                (part.from[k], part.to[k]) = (start, start);
            }
        }
    }
    // A line on the edge of two patches is found by both.
    parts.sort_by(|a, b| a.from[0].total_cmp(&b.from[0]));
    let mut single: Vec<Stretch> = Vec::with_capacity(parts.len());
    for part in parts {
        let level = |other: &&Stretch| other.from[0] >= part.from[0] - slack[0];
        let same = |other: &Stretch| near(other.from, part.from, slack) && near(other.to, part.to, slack);
        if !single.iter().rev().take_while(level).any(same) {
            single.push(part);
        }
    }
    let mut parts = single;
    loop {
        let count = parts.len();
        parts = joined_once(parts, slack);
        if parts.len() == count {
            return parts;
        }
    }
}

fn near(a: Pair, b: Pair, slack: Pair) -> bool {
    (0..2).all(|k| (a[k] - b[k]).abs() <= slack[k])
}

/// One pass along the first parameter; where that stays, the order is any.
fn joined_once(mut parts: Vec<Stretch>, slack: Pair) -> Vec<Stretch> {
    let ascending =
        |a: &Stretch, b: &Stretch| a.from[0].total_cmp(&b.from[0]).then(a.from[1].total_cmp(&b.from[1]));
    parts.sort_by(ascending);
    let near = |a: Pair, b: Pair| near(a, b, slack);
    let mut done: Vec<Stretch> = Vec::new();
    let mut open: Vec<Stretch> = Vec::new();
    for part in parts {
        let (over, still): (Vec<_>, Vec<_>) =
            open.into_iter().partition(|chain| chain.to[0] < part.from[0] - slack[0]);
        done.extend(over);
        open = still;
        let kind = part.kind(slack);
        let mut same = open.iter_mut().filter(|chain| chain.kind(slack) == kind);
        let meets = |chain: &&mut Stretch| near(chain.to, part.from) || near(part.to, chain.from);
        match same.find(meets) {
            Some(chain) if near(chain.to, part.from) => chain.to = part.to,
            Some(chain) => chain.from = part.from,
            None => open.push(part),
        }
    }
    done.extend(open);
    done.sort_by(ascending);
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_turn_at_extremes() {
        assert_eq!(turns(&[0.0, 1.0, 2.0], 0.1), [0; 0]);
        assert_eq!(turns(&[0.0, 2.0, 1.0, 3.0], 0.1), [1, 2]);
        assert_eq!(turns(&[0.0, 0.05, 0.02, 0.06], 0.1), [0; 0]);
        assert_eq!(turns(&[1.0, 0.5, 0.45, 0.5, 0.7], 0.1), [2]);
    }

    #[test]
    fn chains_are_joined_in_any_order() {
        let axes = [Axis { domain: [0.0, 4.0], closed: false }; 2];
        let part = |from: Pair, to: Pair| Stretch { from, to };
        let up = joined(
            vec![
                part([1.0, 2.0], [1.0, 3.0]),
                part([1.0 + 1e-15, 0.0], [1.0, 2.0]),
                part([1.0, 0.0], [1.0, 2.0]),
            ],
            &axes,
        );
        assert_eq!(up.len(), 1);
        assert_eq!((up[0].from[1], up[0].to[1]), (0.0, 3.0));
        let falling = joined(vec![part([1.0, 2.0], [2.0, 1.0]), part([0.0, 3.0], [1.0, 2.0])], &axes);
        assert_eq!((falling.len(), falling[0].from, falling[0].to), (1, [0.0, 3.0], [2.0, 1.0]));
        let corner = joined(vec![part([0.0, 0.0], [1.0, 1.0]), part([1.0, 1.0], [2.0, 0.0])], &axes);
        assert_eq!(corner.len(), 2);
    }
}
