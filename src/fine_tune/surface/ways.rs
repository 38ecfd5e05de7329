//! The paths of one surface as tables, and the mean of what they lead to.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::fine_tune::scale::Scale;
use crate::functional::weigh;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::{Surface, TensorSpline, transposed};
use nalgebra::SVector;

use super::edges::Edges;
use super::path::Path;
use super::table::PathTable;

/// One path, or two.
#[derive(Clone, Debug)]
pub(super) struct Ways<T, const N: usize> {
    /// The spaces of the tuned surfaces.
    pub u: SplineSpace<T>,
    pub v: SplineSpace<T>,
    ways: Vec<Way<T, N>>,
}

/// One path.
#[derive(Clone, Debug)]
pub(super) struct Way<T, const N: usize> {
    pub table: PathTable<T, N>,
    /// The control points of the invariant surface, line after line as the table has them; none if no ends of
    /// lines are held.
    pub invariant: Vec<SVector<T, N>>,
    /// From the control points of this path to those of the mean, across and along the direction in which it ends, where these
    /// are others.
    finish: [Option<LinearMap<T>>; 2],
}

impl<T: Scalar, const N: usize> Ways<T, N> {
    /// The paths of `path` for surfaces tuned by scale functions over the spaces `scales`, lines along a direction starting where
    /// its edges stay if `edges` holds one.
    ///
    /// # Errors
    /// As [`fine_tuned`](Surface::fine_tuned) has them; [`TooLarge`](crate::Error::TooLarge).
    pub(super) fn new(
        surface: &Surface<T, N>,
        scales: (&SplineSpace<T>, &SplineSpace<T>),
        path: Path,
        edges: Edges,
    ) -> Result<Self> {
        let one = TensorSpline::constant(scales.0.clone(), scales.1.clone(), T::one())?;
        let is_held = |last: Direction| edges.orders(last) != [None, None];
        let shape = |last: Direction| {
            if is_held(last) {
                surface.swept(last, &one)
            } else {
                surface.fine_tuned(Scale::Signed(&one), Path::ending_in(last))
            }
        };
        let lasts = path.lasts();
        let shapes: Vec<Surface<T, N>> = lasts.iter().map(|last| shape(*last)).collect::<Result<_>>()?;
        let common = match shapes.as_slice() {
            [uv, vu] => uv.sum(vu)?,
            other => other[0].clone(),
        };
        let way = |(last, shape): (&Direction, &Surface<T, N>)| {
            let map = |direction: Direction| {
                let (from, to) = (shape.space(direction), common.space(direction));
                (from != to).then(|| from.embedding(to)).transpose()
            };
            let table =
                PathTable::new(surface, [scales.0, scales.1], *last, [shape.u(), shape.v()], is_held(*last))?;
            let lines = |s: Surface<T, N>| if *last == V { s } else { s.transposed() };
            let invariant = match is_held(*last) {
                true => lines(surface.invariant(shape)?).into_coeffs(),
                false => Vec::new(),
            };
            Ok(Way { table, invariant, finish: [map(last.other())?, map(*last)?] })
        };
        Ok(Self {
            ways: lasts.iter().zip(&shapes).map(way).collect::<Result<_>>()?,
            u: common.u().clone(),
            v: common.v().clone(),
        })
    }

    /// The control points of the surface tuned by `alpha`, its values row by row, the lines of each path as `hold` leaves them.
    ///
    /// # Errors
    /// Those of `hold`.
    pub(super) fn walk(
        &self,
        alpha: &[T],
        hold: impl Fn(&Way<T, N>, &mut [SVector<T, N>]) -> Result<()>,
    ) -> Result<Vec<SVector<T, N>>> {
        let mut mean: Option<Vec<SVector<T, N>>> = None;
        for way in &self.ways {
            let mut lines = way.table.lines(alpha);
            hold(way, &mut lines)?;
            let path = way.finished(lines);
            mean = Some(match mean {
                None => path,
                Some(mut other) => {
                    let half = T::frac(1, 2);
                    for (point, second) in other.iter_mut().zip(&path) {
                        *point += second;
                        point.scale(&half);
                    }
                    other
                }
            });
        }
        Ok(mean.unwrap_or_default())
    }
}

impl<T: Scalar, const N: usize> Way<T, N> {
    /// The control points of this path row by row, among those of the mean.
    fn finished(&self, mut lines: Vec<SVector<T, N>>) -> Vec<SVector<T, N>> {
        let [across, along] = &self.finish;
        let mut length = self.table.length;
        if let Some(map) = along {
            lines = mapped(&lines, length, map);
            length = map.target_dim();
        }
        match (across, self.table.last) {
            (None, V) => lines,
            (None, U) => transposed(&lines, length),
            (Some(map), last) => {
                let turned = transposed(&lines, length);
                let turned = mapped(&turned, turned.len() / length, map);
                if last == U { turned } else { transposed(&turned, map.target_dim()) }
            }
        }
    }
}

/// The image of each line of some length.
fn mapped<T: Scalar, const N: usize>(
    lines: &[SVector<T, N>],
    length: usize,
    map: &LinearMap<T>,
) -> Vec<SVector<T, N>> {
    let image = |line| map.rows().map(move |(first, weights)| weigh(first, weights, line));
    lines.chunks_exact(length).flat_map(image).collect()
}
