//! Spaces, splines and parameters that love corner cases.
//!
//! Spaces on a common domain draw their knots from one grid, so that they share some, and each has its own. What a
//! knot counts is drawn as a word ([`Copies`]) and means something in every degree.

use nalgebra::SVector;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use symspline::{Coeff, Curve, Function, Q, Scalar, Spline, SplineSpace, Surface, TensorSpline};

/// The most coefficients of a generated space.
const MOST: usize = 48;

/// The settings of a law that runs `2 n` times.
pub fn cases(n: u32) -> ProptestConfig {
    let (max_shrink_iters, max_global_rejects) = (10_000, 100_000);
    ProptestConfig { cases: 2 * n, max_shrink_iters, max_global_rejects, ..ProptestConfig::default() }
}

/// How the ends of a space meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    Clamped,
    Unclamped,
    Periodic,
}
use Shape::{Clamped, Periodic, Unclamped};

/// Which spaces to draw.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    shapes: &'static [Shape],
    degrees: (usize, usize),
    /// How many derivatives exist as splines: 0 allows jumps, 1 kinks.
    smooth: usize,
    /// The most distinct knots inside.
    knots: usize,
}

/// Every space: of degree 0 to 10, with jumps, clamped or not, periodic.
pub const ANY: Kind =
    Kind { shapes: &[Clamped, Clamped, Unclamped, Periodic], degrees: (0, 10), smooth: 0, knots: 4 };
/// Spaces whose splines have a derivative.
pub const SMOOTH: Kind = Kind { smooth: 1, ..ANY };
/// Open spaces.
pub const OPEN: Kind = Kind { shapes: &[Clamped, Unclamped], ..ANY };
/// Spaces with clamped ends.
pub const CLAMPED: Kind = Kind { shapes: &[Clamped], ..ANY };
/// Periodic spaces.
pub const RING: Kind = Kind { shapes: &[Periodic], ..ANY };

impl Kind {
    /// The same with degrees from `low` to `high`.
    pub const fn of_degree(self, low: usize, high: usize) -> Self {
        Self { degrees: (low, high), ..self }
    }

    /// The same with `smooth` derivatives that are splines.
    pub const fn smooth(self, smooth: usize) -> Self {
        Self { smooth, ..self }
    }

    /// The same with at most `knots` distinct knots inside: surfaces have many coefficients.
    pub const fn few(self, knots: usize) -> Self {
        Self { knots, ..self }
    }
}

/// How often a knot counts.
#[derive(Clone, Copy, Debug)]
enum Copies {
    Absent,
    Simple,
    Double,
    Full,
    Jump,
}

impl Copies {
    fn count(self, degree: usize, smooth: usize) -> usize {
        let count = match self {
            Self::Absent => 0,
            Self::Simple => 1,
            Self::Double => 2,
            Self::Full => degree,
            Self::Jump => degree + 1,
        };
        count.min((degree + 1).saturating_sub(smooth))
    }
}

/// A space but for the grid it stands on.
#[derive(Clone, Debug)]
struct Recipe {
    kind: Kind,
    degree: usize,
    shape: Shape,
    copies: Vec<Copies>,
    outer: Vec<Q>,
}

impl Recipe {
    fn on(&self, grid: &[Q]) -> SplineSpace<Q> {
        let (p, smooth) = (self.degree, self.kind.smooth);
        // High degrees make big numbers: few spans keep them fast.
        let inner_knots = match p {
            0..=3 => 4,
            4 | 5 => 2,
            _ => 1,
        };
        let inner_knots = self.kind.knots.min(inner_knots);
        let counted = grid[1..grid.len() - 1].iter().zip(&self.copies[1..]);
        let counted = counted.map(|(t, copies)| (t, copies.count(p, smooth))).filter(|(_, count)| *count > 0);
        let inner = counted.take(inner_knots).flat_map(|(t, count)| std::iter::repeat_n(t.clone(), count));
        let (a, b) = (&grid[0], &grid[grid.len() - 1]);
        let built = match self.shape {
            Periodic if p >= smooth => {
                let seam = self.copies[0].count(p, smooth).max(1);
                SplineSpace::periodic(p, std::iter::repeat_n(a.clone(), seam).chain(inner), b.clone() - a)
            }
            Unclamped => {
                let walk = |from: &Q, gaps: &[Q], sign: i64| -> Vec<Q> {
                    let step = |at: &mut Q, gap: &Q| {
                        *at += Q::int(sign) * gap;
                        Some(at.clone())
                    };
                    gaps.iter().scan(from.clone(), step).collect()
                };
                let before = walk(a, &self.outer[..p], -1);
                let after = walk(b, &self.outer[p..2 * p], 1);
                let ends = (before.into_iter().rev(), after.into_iter());
                SplineSpace::new(p, ends.0.chain([a.clone()]).chain(inner).chain([b.clone()]).chain(ends.1))
            }
            _ => SplineSpace::clamped(p, [a.clone()].into_iter().chain(inner).chain([b.clone()])),
        };
        built.expect("a recipe makes a valid space")
    }
}

fn recipe(kind: Kind) -> impl Strategy<Value = Recipe> {
    let (low, high) = kind.degrees;
    let degree = prop_oneof![
        6 => low..=high.min(low.max(3)),
        3 => low..=high.min(low.max(5)),
        1 => low..=high,
    ];
    let copies = prop_oneof![
        2 => Just(Copies::Absent),
        5 => Just(Copies::Simple),
        2 => Just(Copies::Double),
        2 => Just(Copies::Full),
        2 => Just(Copies::Jump),
    ];
    let outer = prop_oneof![2 => Just(Q::int(0)), 5 => gap()];
    (degree, select(kind.shapes), vec(copies, 6), vec(outer, 20))
        .prop_map(move |(degree, shape, copies, outer)| Recipe { kind, degree, shape, copies, outer })
}

/// A distance of knots: even, uneven, with denominators of all sorts, tiny, huge.
fn gap() -> impl Strategy<Value = Q> {
    prop_oneof![
        5 => Just(Q::int(1)),
        3 => (1_i64..=5, 1_i64..=7).prop_map(|(n, d)| Q::frac(n, d)),
        1 => Just(Q::frac(1, 1_000_000)),
        1 => Just(Q::int(1_000_000)),
    ]
}

/// Ascending distinct knots, at least two.
fn grid() -> impl Strategy<Value = Vec<Q>> {
    let start = select(vec![Q::int(0), Q::int(0), Q::int(-1), Q::frac(1, 3), Q::frac(-7, 2), Q::int(100)]);
    (start, vec(gap(), 1..=5)).prop_map(|(start, gaps)| {
        let mut knots = vec![start];
        for gap in gaps {
            knots.push(knots[knots.len() - 1].clone() + gap);
        }
        knots
    })
}

/// A number such as coefficients are: small, zero, a fraction, large, tiny.
pub fn number() -> impl Strategy<Value = Q> {
    prop_oneof![
        6 => (-9_i64..=9).prop_map(Q::int),
        2 => Just(Q::int(0)),
        3 => (-9_i64..=9, 1_i64..=9).prop_map(|(n, d)| Q::frac(n, d)),
        1 => (-9_i64..=9).prop_map(|n| Q::int(n * 1_000_000_007)),
        1 => (1_i64..=9).prop_map(|n| Q::frac(n, 1_000_003)),
    ]
}

/// A point such as control points are.
pub fn point<const N: usize>() -> impl Strategy<Value = SVector<Q, N>> {
    vec(number(), N).prop_map(|x| SVector::from_fn(|i, _| x[i].clone()))
}

/// Coefficients for any space, now and then all equal.
pub fn coeffs<C: Coeff<Q>>(one: impl Strategy<Value = C> + Clone) -> impl Strategy<Value = Vec<C>> {
    prop_oneof![12 => vec(one.clone(), MOST), 1 => one.prop_map(|c| vec![c; MOST])]
}

fn fill<C: Coeff<Q>>(space: SplineSpace<Q>, coeffs: &[C]) -> Spline<Q, C> {
    let coeffs = coeffs[..space.dim()].to_vec();
    Spline::new(space, coeffs).expect("as many coefficients as the space has")
}

/// A space.
pub fn space(kind: Kind) -> impl Strategy<Value = SplineSpace<Q>> {
    (grid(), recipe(kind)).prop_map(|(grid, recipe)| recipe.on(&grid))
}

/// Two spaces on one domain.
pub fn spaces(one: Kind, two: Kind) -> impl Strategy<Value = [SplineSpace<Q>; 2]> {
    (grid(), recipe(one), recipe(two)).prop_map(|(grid, r, s)| [r.on(&grid), s.on(&grid)])
}

/// Three spaces on one domain.
pub fn three_spaces(kind: Kind) -> impl Strategy<Value = [SplineSpace<Q>; 3]> {
    (grid(), recipe(kind), recipe(kind), recipe(kind))
        .prop_map(|(grid, r, s, t)| [r.on(&grid), s.on(&grid), t.on(&grid)])
}

/// A scalar spline.
pub fn function(kind: Kind) -> impl Strategy<Value = Function<Q>> {
    (space(kind), coeffs(number().boxed())).prop_map(|(space, c)| fill(space, &c))
}

/// Two scalar splines on one domain.
pub fn functions(one: Kind, two: Kind) -> impl Strategy<Value = [Function<Q>; 2]> {
    let numbers = || coeffs(number().boxed());
    (spaces(one, two), numbers(), numbers()).prop_map(|([r, s], c, d)| [fill(r, &c), fill(s, &d)])
}

/// Three scalar splines on one domain.
pub fn three_functions(kind: Kind) -> impl Strategy<Value = [Function<Q>; 3]> {
    let numbers = || coeffs(number().boxed());
    (three_spaces(kind), numbers(), numbers(), numbers())
        .prop_map(|([r, s, t], c, d, e)| [fill(r, &c), fill(s, &d), fill(t, &e)])
}

/// A curve.
pub fn curve<const N: usize>(kind: Kind) -> impl Strategy<Value = Curve<Q, N>> {
    (space(kind), coeffs(point::<N>().boxed())).prop_map(|(space, c)| fill(space, &c))
}

/// Two curves on one domain.
pub fn curves<const N: usize>(one: Kind, two: Kind) -> impl Strategy<Value = [Curve<Q, N>; 2]> {
    let points = || coeffs(point::<N>().boxed());
    (spaces(one, two), points(), points()).prop_map(|([r, s], c, d)| [fill(r, &c), fill(s, &d)])
}

/// A curve and a scalar spline on one domain.
pub fn curve_and_function<const N: usize>(
    one: Kind,
    two: Kind,
) -> impl Strategy<Value = (Curve<Q, N>, Function<Q>)> {
    (spaces(one, two), coeffs(point::<N>().boxed()), coeffs(number().boxed()))
        .prop_map(|([r, s], c, d)| (fill(r, &c), fill(s, &d)))
}

/// The surface over two spaces whose coefficients are dealt out from a pool, without a pattern.
fn grid_of<C: Coeff<Q>>([u, v]: [SplineSpace<Q>; 2], pool: &[C]) -> TensorSpline<Q, C> {
    let deal = |i: usize, j: usize| pool[(7 * i + 11 * j + i * j) % pool.len()].clone();
    let coeffs = (0..u.dim()).flat_map(|i| (0..v.dim()).map(move |j| deal(i, j))).collect();
    TensorSpline::new(u, v, coeffs).expect("as many coefficients as the spaces have")
}

/// Coefficients to deal out to a surface.
fn pool<C: Coeff<Q>>(one: impl Strategy<Value = C>) -> impl Strategy<Value = Vec<C>> {
    vec(one, 23)
}

/// A scalar surface, of the one kind along `u` and of the other along `v`.
pub fn field(u: Kind, v: Kind) -> impl Strategy<Value = TensorSpline<Q>> {
    (space(u), space(v), pool(number())).prop_map(|(u, v, pool)| grid_of([u, v], &pool))
}

/// A surface, of the one kind along `u` and of the other along `v`.
pub fn surface<const N: usize>(u: Kind, v: Kind) -> impl Strategy<Value = Surface<Q, N>> {
    (space(u), space(v), pool(point::<N>())).prop_map(|(u, v, pool)| grid_of([u, v], &pool))
}

/// Two scalar surfaces on one domain, the first of the kinds `one` along `u` and `v`, the second of the kinds `two`.
pub fn fields(one: [Kind; 2], two: [Kind; 2]) -> impl Strategy<Value = [TensorSpline<Q>; 2]> {
    let [us, vs] = [0, 1].map(|i| spaces(one[i], two[i]));
    (us, vs, pool(number()), pool(number()))
        .prop_map(|([u, x], [v, y], c, d)| [grid_of([u, v], &c), grid_of([x, y], &d)])
}

/// Two surfaces on one domain, the first of the kinds `one` along `u` and `v`, the second of the kinds `two`.
pub fn surfaces<const N: usize>(one: [Kind; 2], two: [Kind; 2]) -> impl Strategy<Value = [Surface<Q, N>; 2]> {
    let [us, vs] = [0, 1].map(|i| spaces(one[i], two[i]));
    (us, vs, pool(point::<N>()), pool(point::<N>()))
        .prop_map(|([u, x], [v, y], c, d)| [grid_of([u, v], &c), grid_of([x, y], &d)])
}

/// A surface of the kinds `one` and a scalar surface of the kinds `two` on one domain.
pub fn surface_and_field<const N: usize>(
    one: [Kind; 2],
    two: [Kind; 2],
) -> impl Strategy<Value = (Surface<Q, N>, TensorSpline<Q>)> {
    let [us, vs] = [0, 1].map(|i| spaces(one[i], two[i]));
    (us, vs, pool(point::<N>()), pool(number()))
        .prop_map(|([u, x], [v, y], c, d)| (grid_of([u, v], &c), grid_of([x, y], &d)))
}

/// Places in a list yet to be seen.
pub fn indices(most: usize) -> impl Strategy<Value = Vec<Index>> {
    vec(any::<Index>(), 0..=most)
}

/// The parameters where things happen: knots, ends, middles, and a point close behind each knot. Ascending.
pub fn probes(space: &SplineSpace<Q>) -> Vec<Q> {
    let breaks = space.breaks();
    let within = |a: &Q, b: &Q, n: i64, d: i64| a.clone() + (b.clone() - a) * Q::frac(n, d);
    let inside = breaks.windows(2).flat_map(|ends| {
        let (a, b) = (&ends[0].0, &ends[1].0);
        [a.clone(), within(a, b, 1, 9), within(a, b, 1, 2)]
    });
    inside.chain([breaks[breaks.len() - 1].0.clone()]).collect()
}

/// About twenty pairs of such parameters all over the domain of a surface, its last corner among them.
pub fn probe_pairs<C: Coeff<Q>>(s: &TensorSpline<Q, C>) -> Vec<(Q, Q)> {
    let (us, vs) = (probes(s.u()), probes(s.v()));
    let skip = (us.len() * vs.len()).div_ceil(20);
    let chosen = |i: usize, j: usize| (i * vs.len() + j + 1).is_multiple_of(skip);
    let last = (us[us.len() - 1].clone(), vs[vs.len() - 1].clone());
    let row = |i: usize| (0..vs.len()).filter(move |&j| chosen(i, j)).map(move |j| (i, j));
    let pairs = (0..us.len()).flat_map(row).map(|(i, j)| (us[i].clone(), vs[j].clone()));
    pairs.chain([last]).collect()
}

/// As many of the proposed knots as the space has room for, strictly inside; in a ring the seam counts as inside.
pub fn insertable(space: &SplineSpace<Q>, places: &[Index]) -> Vec<Q> {
    let probes = probes(space);
    let mut knots = Vec::new();
    for place in places {
        knots.push(place.get(&probes).clone());
        if space.refined(&knots).is_err() {
            knots.pop();
        }
    }
    knots
}
