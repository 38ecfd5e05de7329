//! Cutting pieces into parts whose lengths are known well enough.
//!
//! A part is done if its chord is nearly as long as its control polygon, or if a Gauss rule has a small enough bound.
//! Else it is halved. Next to a place where the curve stands still no rule has a bound. There lengths go down with the
//! squares of widths, or faster, so that after some halvings the polygon is short enough to be of no account.

use super::gauss::RULES;
use super::jet::UNIT;
use super::piece::{Degree, Piece};
use super::source::Span;
use crate::error::{Error, Result};

/// How often a span is halved in one place at most.
const DEPTH: u32 = 50;

/// How many parts beyond some for each span there are at most in low degrees.
const PARTS: usize = 1 << 14;

/// A part of a span.
#[derive(Clone, Debug)]
pub(super) struct Part<const N: usize> {
    /// Start and end of its span.
    pub ends: (f64, f64),
    /// Where in the span it starts, which goes from 0 to 1.
    pub from: f64,
    /// What share of the span it is.
    pub width: f64,
    pub piece: Piece<N>,
    /// The unit of lengths of the piece.
    pub unit: f64,
    /// The rule that integrates its speed; none if chord and polygon enclose its length.
    pub rule: Option<usize>,
    /// The length, in units of the curve.
    pub length: f64,
}

impl<const N: usize> Part<N> {
    /// The parameter at `t` from 0 to 1. In a short span many parts may have the same.
    pub(super) fn global(&self, t: f64) -> f64 {
        let ((a, b), s) = (self.ends, self.from + self.width * t);
        if s == 1.0 { b } else { (a + (b - a) * s).clamp(a, b) }
    }

    /// Where `x` is, from 0 to 1 if it is in the part.
    pub(super) fn local(&self, x: f64) -> f64 {
        let (a, b) = self.ends;
        ((x - a) / (b - a) - self.from) / self.width
    }
}

/// The parts of a curve, in order.
#[derive(Debug)]
pub(super) struct Parts<const N: usize> {
    pub parts: Vec<Part<N>>,
    /// How far the sum of the lengths is off at most.
    pub bound: f64,
}

/// A part in the making: a piece, and which part of the span it is.
struct Candidate<const N: usize> {
    piece: Piece<N>,
    from: f64,
    width: f64,
    depth: u32,
}

/// The parts of the curve with these spans, whose lengths add up to its own with the relative `accuracy`, if rounding
/// and the limits on halving allow.
pub(super) fn measure<const N: usize>(
    spans: Vec<Span<N>>,
    degree: &Degree,
    p: usize,
    accuracy: f64,
) -> Result<Parts<N>> {
    let guess = |span: &Span<N>| span.unit * RULES[0].mean(0.0, 1.0, |s| span.piece.speed(degree, s));
    let guesses: Vec<f64> = spans.iter().map(guess).collect();
    let mean = guesses.iter().map(|length| length / spans.len() as f64).sum::<f64>();
    let mut left = 32 * spans.len() + PARTS / (1 + (p / 128).pow(2));
    let (mut parts, mut bound) = (Vec::with_capacity(2 * spans.len()), 0.0);
    for (span, guess) in spans.into_iter().zip(guesses) {
        // What is of no account: near a place where the curve stands still there may be some fifty such parts.
        let floor = accuracy * (guess / 128.0 + mean / 128.0) / span.unit;
        let ends = span.ends;
        let mut off = span.rounding;
        let mut open = vec![Candidate { piece: span.piece, from: 0.0, width: 1.0, depth: 0 }];
        while let Some(Candidate { piece, from, width, depth }) = open.pop() {
            off += piece.rounding();
            let last = depth == DEPTH || left == 0;
            let Some((length, error, rule)) = length(&piece, degree, accuracy, floor, last)? else {
                left -= 1;
                let (half, depth) = (width / 2.0, depth + 1);
                let [before, after] = piece.split(0.5);
                open.push(Candidate { piece: after, from: from + half, width: half, depth });
                open.push(Candidate { piece: before, from, width: half, depth });
                continue;
            };
            off += error;
            parts.push(Part { ends, from, width, piece, unit: span.unit, rule, length: length * span.unit });
        }
        bound += off * span.unit;
    }
    if bound.is_finite() {
        Ok(Parts { parts, bound })
    } else {
        Err(Error::NotFinite { what: "length", index: 0 })
    }
}

/// The length of a piece, how far it is off at most, and the rule that gives it, if the piece need not be halved.
fn length<const N: usize>(
    piece: &Piece<N>,
    degree: &Degree,
    accuracy: f64,
    floor: f64,
    last: bool,
) -> Result<Option<(f64, f64, Option<usize>)>> {
    let (chord, polygon) = piece.enclosure();
    let slack = (polygon - chord).max(0.0) / 2.0;
    if slack <= (accuracy / 4.0 * chord).max(floor).max(4.0 * UNIT * polygon) && polygon.is_finite() {
        return Ok(Some((chord + slack, slack, None)));
    }
    let (most, speed) = piece.most(degree);
    let enough = (accuracy / 4.0 * speed).max(floor);
    for (index, rule) in RULES.iter().enumerate() {
        let error = rule.error(&most);
        if error <= enough {
            let length = rule.mean(0.0, 1.0, |s| piece.speed(degree, s));
            return Ok(Some((length, error + (rule.count() + 8) as f64 * UNIT * length, Some(index))));
        }
    }
    match last {
        true if polygon.is_finite() => Ok(Some((chord + slack, slack, None))),
        true => Err(Error::Undecided),
        false => Ok(None),
    }
}
