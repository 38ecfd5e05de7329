//! Evaluation from a table: the power form of each span, and a guide to the spans.
//!
//! The guide cuts the domain into buckets narrower than the narrowest span: a bucket holds one break at most, so that
//! a span is found by one product, one look-up and one comparison without a branch.

use crate::bounds::pieces::{bezier, powers};
use crate::bounds::{Lanes, lanes};

#[derive(Debug)]
pub struct Guide {
    scale: f64,
    first: Vec<u32>,
    /// The breaks; beyond the last span there is nothing.
    breaks: Vec<f64>,
}

impl Guide {
    pub fn new(mut breaks: Vec<f64>) -> Self {
        let narrowest = breaks.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        let (start, end) = (breaks[0], breaks[breaks.len() - 1]);
        let buckets = ((end - start) / narrowest * 1.01).ceil();
        let scale = buckets / (end - start);
        let last = breaks.len() - 2;
        let mut k = 0;
        let first = (0..=buckets as usize).map(|i| {
            while k < last && breaks[k + 1] <= start + i as f64 / scale {
                k += 1;
            }
            k as u32
        });
        let first = first.collect();
        breaks[last + 1] = f64::INFINITY;
        Self { scale, first, breaks }
    }

    /// The span and its start.
    #[inline(always)]
    pub fn span(&self, x: f64) -> (usize, f64) {
        let k = self.first[((x - self.breaks[0]) * self.scale) as usize] as usize;
        let k = k + usize::from(x >= self.breaks[k + 1]);
        (k, self.breaks[k])
    }

    /// Where the span ends; infinity for the last one.
    pub fn end(&self, k: usize) -> f64 {
        self.breaks[k + 1]
    }
}

/// A cubic curve.
#[derive(Debug)]
pub struct Table {
    guide: Guide,
    pieces: Vec<[Lanes; 4]>,
}

impl Table {
    pub fn new(t: &[f64], c: &[Lanes]) -> Self {
        let breaks = &t[3..t.len() - 3];
        let widths = breaks.windows(2).map(|pair| pair[1] - pair[0]);
        let pieces = bezier(t, c).into_iter().zip(widths).map(|(piece, h)| powers(piece, h)).collect();
        Self { guide: Guide::new(breaks.to_vec()), pieces }
    }

    #[inline(always)]
    pub fn at(&self, x: f64) -> Lanes {
        let (k, start) = self.guide.span(x);
        horner(&self.pieces[k], x - start)
    }

    /// The value and two derivatives.
    #[inline(always)]
    pub fn derivatives(&self, x: f64) -> [Lanes; 3] {
        let (k, start) = self.guide.span(x);
        let ([_, c1, c2, c3], s) = (&self.pieces[k], x - start);
        let value = horner(&self.pieces[k], s);
        let first = lanes(|l| c1[l] + s * (2.0 * c2[l] + s * (3.0 * c3[l])));
        let second = lanes(|l| 2.0 * c2[l] + s * (6.0 * c3[l]));
        [value, first, second]
    }

    /// Many values. Runs of parameters in one span share the look-up and the coefficients.
    #[inline(always)]
    pub fn fill(&self, xs: &[f64], out: &mut [[f64; 3]], finish: impl Fn(Lanes) -> [f64; 3]) {
        let mut i = 0;
        while i < xs.len() {
            let (k, start) = self.guide.span(xs[i]);
            out[i] = finish(horner(&self.pieces[k], xs[i] - start));
            i += 1;
            let end = self.guide.end(k);
            // Which side it leaves on is a coin toss: one branch for both.
            let stays = |x: &f64| (*x - start) * (end - *x) > 0.0;
            if xs.get(i).is_some_and(stays) {
                let piece = self.pieces[k];
                let run = xs[i..].iter().take_while(|x| stays(x)).count();
                for (x, place) in xs[i..i + run].iter().zip(&mut out[i..i + run]) {
                    *place = finish(horner(&piece, x - start));
                }
                i += run;
            }
        }
    }
}

#[inline(always)]
pub fn horner([c0, c1, c2, c3]: &[Lanes; 4], s: f64) -> Lanes {
    lanes(|l| c0[l] + s * (c1[l] + s * (c2[l] + s * c3[l])))
}
