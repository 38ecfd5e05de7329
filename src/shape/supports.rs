//! Where control points have influence, direction by direction: a curve counts as a surface of one column.

use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::flatten_region::{Extent, Part};
use crate::space::SplineSpace;
use crate::tensor::along::Direction;

/// Along one direction: the supports of the coefficients, and the spans with the coefficients that matter there.
struct Axis<T> {
    /// For each coefficient the intervals in the domain where it has influence: two or more across the seam of a ring.
    supports: Vec<Vec<(T, T)>>,
    spans: Vec<((T, T), Vec<usize>)>,
}

impl<T: Scalar> Axis<T> {
    fn of(space: &SplineSpace<T>) -> Self {
        let (p, t, (a, b)) = (space.degree(), space.knots(), space.domain());
        let mut supports = vec![Vec::new(); space.dim()];
        for i in 0..space.unrolled_dim() {
            let start = if t[i] < *a { a } else { &t[i] };
            let end = if t[i + p + 1] > *b { b } else { &t[i + p + 1] };
            if start < end {
                supports[space.slot(i)].push((start.clone(), end.clone()));
            }
        }
        let span = |k: usize| {
            let coeffs = (k - p..=k).map(|i| space.slot(i)).collect();
            ((t[k].clone(), t[k + 1].clone()), coeffs)
        };
        Self { supports, spans: space.spans().map(span).collect() }
    }

    /// The second direction of a curve.
    fn none() -> Self {
        let all = (T::zero(), T::one());
        Self { supports: vec![vec![all.clone()]], spans: vec![(all, vec![0])] }
    }
}

/// The supports of the control points of a shape.
pub(crate) struct Supports<T> {
    axes: [Axis<T>; 2],
    /// How many directions there are.
    directions: usize,
}

impl<T: Scalar> Supports<T> {
    pub(crate) fn of<S: Controlled<T>>(shape: &S) -> Self {
        let u = Axis::of(shape.space_along(Direction::U));
        let directions = S::DIRECTIONS.len();
        let v = if directions == 1 { Axis::none() } else { Axis::of(shape.space_along(Direction::V)) };
        Self { axes: [u, v], directions }
    }

    fn columns(&self) -> usize {
        self.axes[1].supports.len()
    }

    /// The rectangles in the domain where a control point has influence.
    fn extents(&self, flat: usize) -> impl Iterator<Item = Extent<T>> {
        let [u, v] =
            [(0, flat / self.columns()), (1, flat % self.columns())].map(|(k, i)| &self.axes[k].supports[i]);
        u.iter().flat_map(move |u| v.iter().map(move |v| [u.clone(), v.clone()]))
    }

    /// Whether a control point has influence in `part` alone.
    pub(crate) fn within(&self, flat: usize, part: &Part<T>) -> bool {
        self.extents(flat).all(|extent| part.holds(&extent))
    }

    /// Whether a control point has influence in `part`.
    pub(crate) fn meets(&self, flat: usize, part: &Part<T>) -> bool {
        self.extents(flat).any(|extent| part.meets(&extent))
    }

    /// Whether any of some control points has influence in a rectangle.
    pub(crate) fn reach_into(&self, flats: &[usize], extent: &Extent<T>) -> bool {
        let meets = |of: &Extent<T>| (0..2).all(|k| of[k].0 < extent[k].1 && extent[k].0 < of[k].1);
        flats.iter().any(|flat| self.extents(*flat).any(|of| meets(&of)))
    }

    /// The least rectangle that holds the influence of some control points, by direction.
    pub(crate) fn around(&self, flats: impl IntoIterator<Item = usize>) -> Option<Vec<(T, T)>> {
        let join = |a: Extent<T>, b: Extent<T>| {
            let least =
                |a: (T, T), b: (T, T)| (if b.0 < a.0 { b.0 } else { a.0 }, if b.1 > a.1 { b.1 } else { a.1 });
            let ([au, av], [bu, bv]) = (a, b);
            [least(au, bu), least(av, bv)]
        };
        let all = flats.into_iter().flat_map(|flat| self.extents(flat).collect::<Vec<_>>());
        all.reduce(join).map(|extent| extent.into_iter().take(self.directions).collect())
    }

    /// The spans in one direction that any of some control points has influence on; all spans if there are no such points.
    pub(crate) fn spans_of(&self, direction: usize, flats: &[usize]) -> Vec<(T, T)> {
        let mut marked = vec![flats.is_empty(); self.axes[direction].supports.len()];
        for flat in flats {
            marked[if direction == 0 { flat / self.columns() } else { flat % self.columns() }] = true;
        }
        let touched =
            self.axes[direction].spans.iter().filter(|(_, coeffs)| coeffs.iter().any(|i| marked[*i]));
        touched.map(|(span, _)| span.clone()).collect()
    }

    /// The parts of the domain all of whose control points are `on`, as disjoint rectangles, by direction.
    pub(crate) fn covered(&self, on: &[bool]) -> Vec<Vec<(T, T)>> {
        let mut done: Vec<Extent<T>> = Vec::new();
        // The rectangles that end with the row of spans before, as places in `done`.
        let mut open: Vec<usize> = Vec::new();
        for (u, rows) in &self.axes[0].spans {
            let mut next = Vec::new();
            for v in self.runs(rows, on) {
                let above = open.iter().copied().find(|k| done[*k][1] == v && done[*k][0].1 == u.0);
                let place = above.unwrap_or_else(|| {
                    done.push([u.clone(), v]);
                    done.len() - 1
                });
                done[place][0].1 = u.1.clone();
                next.push(place);
            }
            open = next;
        }
        done.into_iter().map(|extent| extent.into_iter().take(self.directions).collect()).collect()
    }

    /// Stretches along the second direction where all of these rows are `on`.
    fn runs(&self, rows: &[usize], on: &[bool]) -> Vec<(T, T)> {
        let columns = self.columns();
        let column: Vec<bool> = (0..columns).map(|j| rows.iter().all(|i| on[i * columns + j])).collect();
        let mut runs: Vec<(T, T)> = Vec::new();
        for ((start, end), coeffs) in &self.axes[1].spans {
            if !coeffs.iter().all(|j| column[*j]) {
                continue;
            }
            match runs.last_mut() {
                Some(last) if last.1 == *start => last.1 = end.clone(),
                _ => runs.push((start.clone(), end.clone())),
            }
        }
        runs
    }
}
