//! Evaluation of bicubic surfaces from a table: the power form of each patch, 16 coefficients.

use crate::bounds::pieces::{bezier, powers};
use crate::bounds::table::{Guide, horner};
use crate::bounds::{Lanes, lanes};

/// `patch[i][j]` goes with `u^i v^j`.
type Patch = [[Lanes; 4]; 4];

#[derive(Debug)]
pub struct Patches {
    guide: Guide,
    spans: usize,
    patches: Vec<Patch>,
}

impl Patches {
    /// The same knots in both directions, `side` points in a row.
    pub fn new(t: &[f64], side: usize, c: &[Lanes]) -> Self {
        let breaks = &t[3..t.len() - 3];
        let (spans, width) = (breaks.len() - 1, |k: usize| breaks[k + 1] - breaks[k]);
        // Along v each row of the net, then along u each column of what came out.
        let cut = |row: &[Lanes]| -> Vec<[Lanes; 4]> {
            bezier(t, row).into_iter().enumerate().map(|(k, piece)| powers(piece, width(k))).collect()
        };
        let rows: Vec<Vec<[Lanes; 4]>> = c.chunks(side).map(cut).collect();
        let mut patches = vec![[[[0.0; 4]; 4]; 4]; spans * spans];
        for (l, power) in (0..spans).flat_map(|l| (0..4).map(move |power| (l, power))) {
            let column: Vec<Lanes> = rows.iter().map(|row| row[l][power]).collect();
            for (k, piece) in cut(&column).into_iter().enumerate() {
                (0..4).for_each(|i| patches[k * spans + l][i][power] = piece[i]);
            }
        }
        Self { guide: Guide::new(breaks.to_vec()), spans, patches }
    }

    #[inline(always)]
    fn find(&self, u: f64, v: f64) -> (&Patch, f64, f64) {
        let ((k, a), (l, b)) = (self.guide.span(u), self.guide.span(v));
        (&self.patches[k * self.spans + l], u - a, v - b)
    }

    #[inline(always)]
    pub fn at(&self, u: f64, v: f64) -> Lanes {
        let (patch, s, r) = self.find(u, v);
        horner(&[0, 1, 2, 3].map(|i| horner(&patch[i], r)), s)
    }

    /// The value and the first derivatives.
    #[inline(always)]
    pub fn tangents(&self, u: f64, v: f64) -> [Lanes; 3] {
        let (patch, s, r) = self.find(u, v);
        let rows = [0, 1, 2, 3].map(|i| horner(&patch[i], r));
        let slopes = [0, 1, 2, 3].map(|i| slope(&patch[i], r));
        [horner(&rows, s), slope(&rows, s), horner(&slopes, s)]
    }

    /// The values at all pairs, where `us` are in order and `vs` the fewer: each patch is a cubic in `u` for each `v`.
    pub fn grid(&self, us: &[f64], vs: &[f64], out: &mut Vec<[f64; 3]>) {
        out.clear();
        let spans: Vec<(usize, f64)> = vs.iter().map(|v| self.guide.span(*v)).collect();
        let mut cubics = Vec::with_capacity(vs.len());
        let mut last = usize::MAX;
        for u in us {
            let (k, a) = self.guide.span(*u);
            if k != last {
                last = k;
                cubics.clear();
                cubics.extend(spans.iter().zip(vs).map(|((l, b), v)| {
                    let patch = &self.patches[k * self.spans + l];
                    [0, 1, 2, 3].map(|i| horner(&patch[i], v - b))
                }));
            }
            out.extend(cubics.iter().map(|cubic| crate::bounds::point(horner(cubic, u - a))));
        }
    }
}

#[inline(always)]
fn slope([_, c1, c2, c3]: &[Lanes; 4], s: f64) -> Lanes {
    lanes(|l| c1[l] + s * (2.0 * c2[l] + s * (3.0 * c3[l])))
}
