//! What is learnt about a part of a piece: bounds, its nearest point, or a side that is enough.

use crate::analysis::nearest::hull;
use crate::analysis::nearest::polish::Patch;
use crate::analysis::nearest::search::{PATIENCE, Part, Search, Spot, Verdict};
use crate::analysis::nearest::split::{count, keep_side};
use crate::analysis::nearest::square::Gap;
use nalgebra::SVector;

/// How much work is done at most for one point, in products or so.
const WORK: usize = 1 << 25;

/// What looking at one part costs besides.
const OVERHEAD: usize = 256;

/// Parts with more coefficients are not squared: only the hull is asked.
const SQUARED: usize = 1 << 11;

/// Parts of a piece are not halved below this share of their local parameter.
const NARROW: f64 = 1e-14;

/// Squares of weights below this may be lost in the range of numbers.
const TINY: f64 = 1e-280;

/// How many places are collected at most.
const PLACES: usize = 1 << 9;

impl<const N: usize> Search<'_, N> {
    /// Learns what it can about a part.
    pub(super) fn examine(&mut self, part: &mut Part) -> Verdict {
        loop {
            let n = count(part.degrees);
            let products = if n > SQUARED { 0 } else { n * n / 2 };
            self.work += OVERHEAD + n * (part.degrees[0] + part.degrees[1] + 2) / 4 + products;
            let reach = self.meet(part);
            if self.work > self.patience {
                self.descend(part);
            }
            if self.work > WORK / 2 && self.sites.is_none() {
                // A finer one is a courtesy.
                self.accuracy = self.wanted;
                self.cut = self.best.distance - 0.5 * self.accuracy;
            }
            if n == 1 {
                self.settle(part, None);
                return Verdict::Done;
            }
            if self.dismisses(part.lower) {
                return Verdict::Done;
            }
            if self.is_a_point(part) {
                (0..2).for_each(|axis| self.keep(part, axis, None));
                continue;
            }
            if self.work > WORK || n > SQUARED {
                return self.without_squares(part, reach);
            }
            let noise = self.square(part, reach);
            if self.dismisses(part.lower) {
                return Verdict::Done;
            }
            if self.polish(part, noise, reach) {
                return Verdict::Done;
            }
            if self.is_within(part, reach) {
                self.settle(part, None);
                return Verdict::Done;
            }
            if let Some((axis, side)) = self.side(part, noise) {
                self.keep(part, axis, side);
                continue;
            }
            // Points without troughs are done before.
            let level = self.cut + part.slack;
            if self.work > PATIENCE && self.gap(part, level * level).least(2.0 * noise) >= 0.0 {
                self.dismisses(self.cut);
                return Verdict::Done;
            }
            return self.cut_or_end(part);
        }
    }

    /// Looks at corners and hull; returns how far the control points are at most.
    fn meet(&mut self, part: &mut Part) -> f64 {
        let room = &mut *self.room;
        let points = if room.weights.is_empty() {
            &room.points[part.first..]
        } else {
            room.quotients.clear();
            let weighted = room.points[part.first..].iter().zip(&room.weights[part.first..]);
            room.quotients.extend(weighted.map(|(c, weight)| c / *weight));
            &room.quotients
        };
        let [p, q] = part.degrees;
        let mut nearest = (f64::INFINITY, 0);
        for (corner, k) in [0, q, p * (q + 1), p * (q + 1) + q].into_iter().enumerate() {
            let square = points[k].norm_squared();
            if square < nearest.0 {
                nearest = (square, k);
                let distance = square.sqrt();
                if self.sites.is_none() && distance < self.best.distance {
                    let side = |axis: usize, upper: bool| {
                        if upper { part.sides[axis].1 } else { part.sides[axis].0 }
                    };
                    let at = [side(0, corner >= 2), side(1, corner % 2 == 1)];
                    self.best = Spot { root: part.root as usize, at, distance };
                    self.cut = distance - 0.5 * self.accuracy;
                }
            }
        }
        let reach = points.iter().map(SVector::norm_squared).fold(0.0, f64::max).sqrt();
        let hull = hull::distance(points, points[nearest.1], self.cut + part.slack + self.epsilon * reach);
        part.lower = part.lower.max(hull - self.epsilon * reach - part.slack);
        reach
    }

    /// Makes the squares, with the bound they give; returns what a coefficient of `G` may be off by.
    fn square(&mut self, part: &mut Part, reach: f64) -> f64 {
        let (room, squaring) = (&mut *self.room, &self.ground.squaring);
        squaring.square(
            &room.points[part.first..],
            part.degrees,
            &mut room.raised,
            &mut room.squares,
            |a, b| a.dot(b),
        );
        let noise = self.epsilon * reach * reach;
        let least = if room.weights.is_empty() {
            room.squares.iter().copied().fold(f64::INFINITY, f64::min)
        } else {
            let weights = &room.weights[part.first..];
            squaring.square(
                weights,
                part.degrees,
                &mut room.raised_weights,
                &mut room.weight_squares,
                |a, b| a * b,
            );
            let quotient = |(a, b): (&f64, &f64)| if *b > TINY { a / b } else { 0.0 };
            let quotients = room.squares.iter().zip(&room.weight_squares).map(quotient);
            quotients.fold(f64::INFINITY, f64::min)
        };
        let bound = (least - noise).max(0.0).sqrt() - part.slack;
        part.lower = part.lower.max(bound);
        noise
    }

    /// `G` for `r²`.
    fn gap(&self, part: &Part, square: f64) -> Gap<'_> {
        let weights = if self.room.weights.is_empty() { &[][..] } else { &self.room.weight_squares };
        Gap { points: &self.room.squares, weights, degrees: part.degrees.map(|p| 2 * p), square }
    }

    /// The distance below which points matter.
    fn level(&self) -> f64 {
        if self.sites.is_some() { self.cut } else { self.best.distance }
    }

    /// Finds the nearest point if `G` is convex, and whether that settles the part.
    fn polish(&mut self, part: &Part, noise: f64, reach: f64) -> bool {
        let level = self.level();
        let gap = self.gap(part, level * level);
        if gap.bend(noise) <= 0.0 {
            return false;
        }
        // Of a parabola the vertex.
        let start = [0, 1].map(|axis| match gap.end_slopes(axis) {
            Some((first, _)) if first >= 0.0 => 0.0,
            Some((_, last)) if last <= 0.0 => 1.0,
            Some((first, last)) => first / (first - last),
            None => 0.5,
        });
        let mut rooms = std::mem::take(&mut self.room.rooms);
        let patch = Patch {
            points: &self.room.points[part.first..],
            weights: self.room.weights.get(part.first..).unwrap_or(&[]),
            degrees: part.degrees,
        };
        let bend = |square: f64| self.gap(part, square).bend(noise);
        let found = patch.polished(start, bend, self.epsilon * reach, &mut rooms);
        self.room.rooms = rooms;
        match found {
            Some(found) if found.distance - found.lower <= 0.25 * self.accuracy => {
                self.settle(part, Some(found));
                true
            }
            _ => false,
        }
    }

    /// A side, if the nearest points are all there, or a direction along which the distance is the same.
    fn side(&self, part: &Part, noise: f64) -> Option<(usize, Option<bool>)> {
        let (lower, level) = (part.lower.max(0.0), self.level());
        // This much of `G` may be missed without lowering the distance by more than an eighth of the accuracy.
        let may_miss = (0.2 * lower * self.accuracy).max(self.accuracy * self.accuracy / 64.0);
        let lightest = self.lightest(part);
        let gaps = [self.gap(part, level * level), self.gap(part, lower * lower)];
        let gaps = if self.room.weights.is_empty() { &gaps[..1] } else { &gaps[..] };
        let by_gaps = |axis: usize| {
            let noise = 4.0 * part.degrees[axis] as f64 * noise;
            let range = gaps.iter().map(|gap| gap.slopes(axis));
            let range = range
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), (low, high)| (a.min(low), b.max(high)));
            (range.0 - noise, range.1 + noise, may_miss * lightest.powi(2))
        };
        let by_ratio = |axis: usize| {
            let slopes = self.ground.slopes.as_ref().filter(|_| !self.room.weights.is_empty())?;
            let squares = (&self.room.squares, &self.room.weight_squares);
            let (low, high) = slopes.range(squares.0, squares.1, part.degrees.map(|p| 2 * p), axis);
            let noise = 8.0 * part.degrees[axis] as f64 * noise;
            Some((low - noise, high + noise, may_miss * lightest.powi(4)))
        };
        let axes = || (0..2).filter(|&axis| part.degrees[axis] > 0);
        let told = |axis: usize, (least, greatest, may_miss): (f64, f64, f64)| match (
            least >= -may_miss,
            greatest <= may_miss,
        ) {
            (true, true) => Some((axis, None)),
            (true, false) => Some((axis, Some(false))),
            (false, true) => Some((axis, Some(true))),
            (false, false) => None,
        };
        let found = axes().find_map(|axis| told(axis, by_gaps(axis)));
        found.or_else(|| axes().find_map(|axis| told(axis, by_ratio(axis)?)))
    }

    fn lightest(&self, part: &Part) -> f64 {
        self.room.weights.get(part.first..).unwrap_or(&[]).iter().copied().fold(1.0, f64::min)
    }

    /// Whether all of a part is one point, but for a small part of the accuracy.
    fn is_a_point(&self, part: &Part) -> bool {
        let (points, weights) =
            (&self.room.points[part.first..], self.room.weights.get(part.first..).unwrap_or(&[]));
        let quotient = |k: usize| points[k] / weights.get(k).copied().unwrap_or(1.0);
        let first = quotient(0);
        (1..points.len()).rev().all(|k| (quotient(k) - first).amax() <= 0.01 * self.accuracy)
    }

    /// Goes on with a side alone: of a direction that does not matter with the lower one, for all of it.
    fn keep(&mut self, part: &mut Part, axis: usize, side: Option<bool>) {
        let (room, upper) = (&mut *self.room, side == Some(true));
        keep_side(&mut room.points, part.first, part.degrees, axis, upper);
        if !room.weights.is_empty() {
            keep_side(&mut room.weights, part.first, part.degrees, axis, upper);
        }
        part.degrees[axis] = 0;
        part.slack += 0.125 * self.accuracy;
        if side.is_some() {
            let (low, high) = part.sides[axis];
            part.sides[axis] = if upper { (high, high) } else { (low, low) };
        }
    }

    /// Whether all of a part is as near as is wanted.
    fn is_within(&self, part: &Part, reach: f64) -> bool {
        if self.sites.is_none() {
            return false;
        }
        let gap = self.gap(part, self.cut * self.cut);
        reach <= self.cut || (gap.weights.iter().all(|b| *b > TINY) && gap.is_nowhere_positive())
    }

    /// What can be said without squares.
    fn without_squares(&mut self, part: &Part, reach: f64) -> Verdict {
        if self.work > WORK || (self.sites.is_some() && reach <= self.cut) {
            self.settle(part, None);
            return Verdict::Done;
        }
        self.cut_or_end(part)
    }

    /// The longest direction, if it can be halved.
    fn cut_or_end(&mut self, part: &Part) -> Verdict {
        let [p, q] = part.degrees;
        let points = &self.room.points[part.first..];
        let extent = |axis: usize| {
            let (stride, lines) = if axis == 0 { (q + 1, q + 1) } else { (1, p + 1) };
            let line = |l: usize| if axis == 0 { l } else { l * (q + 1) };
            let steps = |l: usize| (0..part.degrees[axis]).map(move |i| line(l) + i * stride);
            let lengths = (0..lines).map(|l| steps(l).map(|k| (points[k + stride] - points[k]).norm()).sum());
            lengths.fold(0.0, f64::max)
        };
        let wide = |axis: usize| {
            let (low, high) = part.sides[axis];
            part.degrees[axis] > 0 && high - low > NARROW * high + f64::MIN_POSITIVE
        };
        let full = self.sites.as_ref().is_some_and(|sites| sites.len() >= PLACES);
        match [wide(0), wide(1)] {
            [true, _] if full => {}
            [true, true] => return Verdict::Halve(usize::from(extent(1) > extent(0))),
            [true, false] => return Verdict::Halve(0),
            [false, true] if !full => return Verdict::Halve(1),
            _ => {}
        }
        self.settle(part, None);
        Verdict::Done
    }
}
