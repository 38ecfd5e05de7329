//! Grids of control points with knot intervals along rows and columns, and the B-spline surfaces that they control.

use crate::meshes::{board, interval};
use crate::strategies::point;
use nalgebra::{SVector, vector};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeMap;
use symspline::{Boundary, CatmullClark, ControlMesh, Q, Scalar, SplineSpace, Surface};

/// The intervals between the control points of a cubic, the points being one more.
#[derive(Clone, Debug)]
pub struct Knots(pub Vec<Q>);

impl Knots {
    /// The knot in the middle of the support of each control point, the mirrored ones before and behind, and two beyond.
    fn centres(&self, depth: usize) -> Vec<Q> {
        let d = &self.0;
        let mut at = vec![Q::int(0)];
        for d in d {
            at.push(at[at.len() - 1].clone() + d);
        }
        for _ in 0..depth {
            let halves = at.windows(2).flat_map(|t| [t[0].clone(), (t[0].clone() + &t[1]) / Q::int(2)]);
            let all: Vec<Q> = halves.chain([at[at.len() - 1].clone()]).collect();
            at = all[1..all.len() - 1].to_vec();
        }
        let n = at.len();
        let before = at[0].clone() * Q::int(2) - &at[1];
        let after = at[n - 1].clone() * Q::int(2) - &at[n - 2];
        let outer = (before.clone() - Q::int(1), after.clone() + Q::int(1));
        [outer.0, before].into_iter().chain(at).chain([after, outer.1]).collect()
    }

    /// The space of the cubics over these knots.
    pub fn space(&self) -> SplineSpace<Q> {
        SplineSpace::new(3, self.centres(0)).expect("ascending knots, at most three equal inside")
    }

    /// The knot of each control point.
    pub fn places(&self) -> Vec<Q> {
        let all = self.centres(0);
        all[2..all.len() - 2].to_vec()
    }

    /// How the control points after `depth` steps come of the old ones: rows of weights, by the polar form.
    fn rows(&self, depth: usize) -> Vec<Vec<Q>> {
        let (space, centres) = (self.space(), self.centres(depth));
        let (t, n) = (space.knots(), space.dim());
        let row = |j: usize| {
            // A span of the support, or one that touches it if that is a point.
            let (low, high) = (&centres[j - 2], &centres[j + 2]);
            let spans = || (3..n).filter(|k| t[*k] < t[k + 1]);
            let inside =
                spans().find(|k| t[*k].clone().max(low.clone()) < t[k + 1].clone().min(high.clone()));
            let k = inside.or_else(|| spans().find(|k| t[*k] <= centres[j] && centres[j] <= t[k + 1]));
            let functional = space.polar(k.expect("a span of the domain"), &centres[j - 1..=j + 1]);
            functional.expect("three arguments").to_dense(n)
        };
        (2..centres.len() - 2).map(row).collect()
    }
}

/// A grid of control points, row by row.
#[derive(Clone, Debug)]
pub struct Grid {
    pub u: Knots,
    pub v: Knots,
    pub points: Vec<SVector<Q, 2>>,
}

impl Grid {
    pub fn sizes(&self) -> (usize, usize) {
        (self.u.0.len() + 1, self.v.0.len() + 1)
    }

    /// The B-spline surface.
    pub fn surface(&self) -> Surface<Q, 2> {
        Surface::new(self.u.space(), self.v.space(), self.points.clone()).expect("a point a pair")
    }

    pub fn mesh(&self) -> ControlMesh<Q, 2> {
        let (m, n) = self.sizes();
        ControlMesh::new(self.points.clone(), board(m, n)).expect("a board")
    }

    /// An interval an edge of the mesh.
    pub fn intervals(&self) -> Vec<Q> {
        let n = self.sizes().1;
        let of = |[a, b]: [usize; 2]| {
            let (low, high) = (a.min(b), a.max(b));
            if high - low == 1 { self.v.0[low % n].clone() } else { self.u.0[low / n].clone() }
        };
        self.mesh().topology().edges().map(of).collect()
    }

    pub fn subdivided(&self, boundary: Boundary) -> CatmullClark<Q, 2> {
        CatmullClark::with_intervals(self.mesh(), self.intervals(), boundary).expect("an interval an edge")
    }

    /// The control points after `depth` steps by knot insertion, by their places in the grid.
    pub fn inserted(&self, depth: usize) -> BTreeMap<[Q; 2], SVector<Q, 2>> {
        let (rows, columns) = (self.u.rows(depth), self.v.rows(depth));
        let n = self.sizes().1;
        let mut inserted = BTreeMap::new();
        for (i, row) in rows.iter().enumerate() {
            for (j, column) in columns.iter().enumerate() {
                let mut sum = SVector::zeros();
                for (k, p) in self.points.iter().enumerate() {
                    sum += p * (row[k / n].clone() * &column[k % n]);
                }
                inserted.insert([place(i, depth), place(j, depth)], sum);
            }
        }
        inserted
    }

    /// Refined points by their places in the grid, with its first vertex at `first` in both directions.
    pub fn by_place(
        &self,
        refined: &CatmullClark<Q, 2>,
        depth: usize,
        first: i64,
    ) -> BTreeMap<[Q; 2], SVector<Q, 2>> {
        // Equal intervals keep what is linear.
        let (m, n) = self.sizes();
        let at = |k: usize| vector![Q::int((k / n) as i64 + first), Q::int((k % n) as i64 + first)];
        let flat = self.mesh().with_points((0..m * n).map(at).collect()).expect("a point a vertex");
        let boundary = if refined.boundary() == Boundary::Open { Boundary::Open } else { Boundary::Corners };
        let places = CatmullClark::new(flat, boundary).refined(depth).expect("as before");
        assert_eq!(places.mesh().topology(), refined.mesh().topology());
        let key = |p: &SVector<Q, 2>| [p[0].clone(), p[1].clone()];
        places.mesh().points().iter().map(key).zip(refined.mesh().points().iter().cloned()).collect()
    }

    /// The grid with two rows of points all around, mirrored through the points of the boundary.
    pub fn extended(&self) -> Self {
        let longer = |d: &Knots| {
            let (d, n) = (&d.0, d.0.len());
            let before = [d[1].clone(), d[0].clone()];
            let after = [d[n - 1].clone(), d[n - 2].clone()];
            Knots(before.into_iter().chain(d.iter().cloned()).chain(after).collect())
        };
        let (m, n) = self.sizes();
        // Before the first and behind the last: twice that less its mirror image.
        let pick = |i: usize, m: usize| match i {
            0 | 1 => [(0, 2), (2 - i, -1)],
            i if i >= m + 2 => [(m - 1, 2), (2 * m - i, -1)],
            i => [(i - 2, 1), (i - 2, 0)],
        };
        let point = |i: usize, j: usize| {
            let mut sum = SVector::zeros();
            for (k, w) in pick(i, m) {
                pick(j, n).into_iter().for_each(|(l, x)| sum += &self.points[k * n + l] * Q::int(w * x));
            }
            sum
        };
        let points =
            (0..m + 4).flat_map(|i| (0..n + 4).map(move |j| (i, j))).map(|(i, j)| point(i, j)).collect();
        Self { u: longer(&self.u), v: longer(&self.v), points }
    }
}

/// Where vertex `i` of a row is after `depth` steps with an open boundary, the old ones being 0, 1, ...
fn place(i: usize, depth: usize) -> Q {
    Q::int(1) + Q::frac(i as i64 - 1, 1 << depth)
}

/// Intervals, at most two in a row that vanish, none at the ends.
pub fn knots() -> impl Strategy<Value = Knots> {
    vec(interval(), 3..=5).prop_map(|mut d| {
        let n = d.len();
        for i in [0, 1, n - 2, n - 1] {
            if d[i] == Q::int(0) {
                d[i] = Q::frac(3, 2);
            }
        }
        Knots(d)
    })
}

pub fn grid() -> impl Strategy<Value = Grid> {
    (knots(), knots(), vec(point::<2>(), 36)).prop_map(|(u, v, mut points)| {
        points.truncate((u.0.len() + 1) * (v.0.len() + 1));
        Grid { u, v, points }
    })
}
