//! Answers from the definitions, written without the library's kernels.

use symspline::{Coeff, Function, Q, Scalar, Spline, SplineSpace, TensorSpline};

/// From which side a limit is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Left,
    Right,
}

fn zero() -> Q {
    Q::int(0)
}

/// All unrolled basis functions at `x` by the recurrence of Cox and de Boor, with `0 / 0 = 0`.
pub fn basis(space: &SplineSpace<Q>, x: &Q, side: Side) -> Vec<Q> {
    let t = space.knots();
    let (a, b) = space.domain();
    let side = if x == b {
        Side::Left
    } else if x == a {
        Side::Right
    } else {
        side
    };
    let holds = |k: usize| match side {
        Side::Right => t[k] <= *x && *x < t[k + 1],
        Side::Left => t[k] < *x && *x <= t[k + 1],
    };
    let mut row: Vec<Q> = (0..t.len() - 1).map(|k| Q::int(i64::from(holds(k)))).collect();
    for p in 1..=space.degree() {
        let part = |num: Q, den: Q, n: &Q| if *n == zero() { zero() } else { num / den * n };
        row = (0..row.len() - 1)
            .map(|i| {
                part(x.clone() - &t[i], t[i + p].clone() - &t[i], &row[i])
                    + part(t[i + p + 1].clone() - x, t[i + p + 1].clone() - &t[i + 1], &row[i + 1])
            })
            .collect();
    }
    row
}

/// The value or the left limit of a spline; at the seam of a ring the left limit comes from the far end.
pub fn value<C: Coeff<Q>>(f: &Spline<Q, C>, x: &Q, side: Side) -> C {
    let space = f.space();
    let (a, b) = space.domain();
    let x = if space.is_periodic() && side == Side::Left && x == a { b } else { x };
    let mut sum = f.coeffs()[0].zero_like();
    for (i, n) in basis(space, x, side).iter().enumerate() {
        sum.add_scaled(n, &f.coeffs()[i % space.dim()]);
    }
    sum
}

/// The value of a surface: the sum over all pairs of basis functions.
pub fn surface_value<C: Coeff<Q>>(s: &TensorSpline<Q, C>, u: &Q, v: &Q) -> C {
    let mut sum = s.coeffs()[0].zero_like();
    let along_v = basis(s.v(), v, Side::Right);
    for (i, n) in basis(s.u(), u, Side::Right).iter().enumerate() {
        for (j, m) in along_v.iter().enumerate() {
            let slot = i % s.u().dim() * s.v().dim() + j % s.v().dim();
            sum.add_scaled(&(n.clone() * m), &s.coeffs()[slot]);
        }
    }
    sum
}

/// The polar value of span `k` at `args`, by the algorithm of de Boor with one argument a step.
pub fn polar<C: Coeff<Q>>(f: &Spline<Q, C>, k: usize, args: &[Q]) -> C {
    let (p, t) = (f.degree(), f.space().knots());
    let mut d: Vec<C> = (k - p..=k).map(|i| f.coeffs()[i % f.space().dim()].clone()).collect();
    for (r, u) in args.iter().enumerate() {
        for i in 0..p - r {
            let (low, high) = (&t[k - p + r + i + 1], &t[k + i + 1]);
            let share = (u.clone() - low) / (high.clone() - low);
            d[i].scale(&(Q::int(1) - &share));
            let next = d[i + 1].clone();
            d[i].add_scaled(&share, &next);
        }
    }
    d.swap_remove(0)
}

/// The span that holds the inside of `[a, b]`, an interval without knots inside.
pub fn span_of(space: &SplineSpace<Q>, a: &Q, b: &Q) -> usize {
    let t = space.knots();
    (space.degree()..t.len() - 1).find(|&k| t[k] <= *a && *b <= t[k + 1] && t[k] < t[k + 1]).expect("a span")
}

/// The coefficient of a product at the polar arguments `args` on `[a, b]`: the mean over all ways to deal the
/// arguments to the factors.
pub fn product_coefficient(f: &Function<Q>, g: &Function<Q>, args: &[Q], (a, b): (&Q, &Q)) -> Q {
    let (p, k, l) = (f.degree(), span_of(f.space(), a, b), span_of(g.space(), a, b));
    let (mut sum, mut count) = (zero(), 0);
    for hands in (0_u32..1 << args.len()).filter(|hands| hands.count_ones() as usize == p) {
        let deal = |mine: bool| -> Vec<Q> {
            let taken = |i: &usize| (hands >> i & 1 == 1) == mine;
            (0..args.len()).filter(taken).map(|i| args[i].clone()).collect()
        };
        sum += polar(f, k, &deal(true)) * polar(g, l, &deal(false));
        count += 1;
    }
    sum / Q::int(count)
}

/// A polynomial on an interval in powers of `x`, lowest first.
pub struct Powers {
    pub a: Q,
    pub b: Q,
    pub coeffs: Vec<Q>,
}

impl Powers {
    /// `∫ x^power f` over the part of the interval in `[from, to]`.
    pub fn moment(&self, power: usize, from: &Q, to: &Q) -> Q {
        let (low, high) = (self.a.clone().max(from.clone()), self.b.clone().min(to.clone()));
        if low >= high {
            return zero();
        }
        let primitive = |x: &Q| {
            let term =
                |(i, c): (usize, &Q)| c.clone() * raised(x, i + power + 1) / Q::int((i + power + 1) as i64);
            self.coeffs.iter().enumerate().map(term).sum::<Q>()
        };
        primitive(&high) - primitive(&low)
    }
}

/// `x^n`.
pub fn raised(x: &Q, n: usize) -> Q {
    std::iter::repeat_n(x.clone(), n).product()
}

/// The pieces of a spline in powers of `x`: Newton's interpolation of values from the recurrence.
pub fn powers(f: &Function<Q>) -> Vec<Powers> {
    let breaks = f.space().breaks();
    let piece = |(a, b): (&Q, &Q)| {
        let p = f.degree();
        let node = |i: usize| a.clone() + (b.clone() - a) * Q::frac(i as i64 + 1, p as i64 + 2);
        let nodes: Vec<Q> = (0..=p).map(node).collect();
        let mut divided: Vec<Q> = nodes.iter().map(|x| value(f, x, Side::Right)).collect();
        for r in 1..=p {
            for i in (r..=p).rev() {
                divided[i] = (divided[i].clone() - &divided[i - 1]) / (nodes[i].clone() - &nodes[i - r]);
            }
        }
        let mut coeffs: Vec<Q> = Vec::new();
        for i in (0..=p).rev() {
            // coeffs * (x - node) + divided
            coeffs.insert(0, zero());
            for j in 0..coeffs.len() - 1 {
                let lower = coeffs[j + 1].clone() * &nodes[i];
                coeffs[j] -= lower;
            }
            coeffs[0] += &divided[i];
        }
        Powers { a: a.clone(), b: b.clone(), coeffs }
    };
    breaks.windows(2).map(|ends| piece((&ends[0].0, &ends[1].0))).collect()
}

/// The rank of a matrix of rows.
pub fn rank(mut rows: Vec<Vec<Q>>) -> usize {
    let (mut rank, width) = (0, rows.first().map_or(0, Vec::len));
    for column in 0..width {
        let Some(pivot) = (rank..rows.len()).find(|&i| rows[i][column] != zero()) else { continue };
        rows.swap(rank, pivot);
        let (done, rest) = rows.split_at_mut(rank + 1);
        let pivot = &done[rank];
        for row in rest {
            let factor = row[column].clone() / &pivot[column];
            for j in column..width {
                row[j] -= factor.clone() * &pivot[j];
            }
        }
        rank += 1;
    }
    rank
}

/// The spline of `space` with coefficient `i` one and all others zero.
pub fn unit(space: &SplineSpace<Q>, i: usize) -> Function<Q> {
    let coeffs = (0..space.dim()).map(|j| Q::int(i64::from(i == j))).collect();
    Function::new(space.clone(), coeffs).expect("as many coefficients as the space has")
}
