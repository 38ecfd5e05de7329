//! Parameters for control points: where in a region a control point counts as being.

use crate::error::{Error, Result};
use crate::scalar::{Real, Scalar};
use crate::shape::controlled::Controlled;
use crate::shape::reshape::{Region, Window, flat};
use crate::tensor::along::Direction;
use crate::vector::length;
use nalgebra::SVector;

/// What is known of a control point that may move: the parameters assigned to it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Assigned<P> {
    /// The way through the region, from 0 to 1 in each direction: `t_i`, or `(s_i, t_j)`.
    pub share: P,
    /// The same in the domain of the shape: `from + share (to - from)`.
    pub parameter: P,
}

/// The nodes (11.4) as shares of the region along each direction: exact over any field. Nodes of an unclamped space beyond its ends
/// count as at them.
pub(crate) fn by_nodes<T: Scalar, P: Clone, S: Controlled<T, Parameter = P>>(
    shape: &S,
    region: &Region<T, P>,
    window: &Window,
) -> Vec<Vec<T>> {
    let along = |(direction, range): (&Direction, &std::ops::Range<usize>)| {
        let (start, end) = region.sides::<S>(*direction);
        let length = end.clone() - start;
        let share = |i| (shape.space_along(*direction).node_inside(i) - start) / &length;
        range.clone().map(share).collect()
    };
    S::DIRECTIONS.iter().zip(window.ranges()).map(along).collect()
}

/// Accumulated lengths of the legs of the control polygon, over the total length [NURBS, section 11.4.1]. Along each
/// direction of a net it is the mean over its lines in this direction [NURBS, A9.3], but for those of no length.
///
/// Lengths are counted from the control point before the window to the one after it, where there are such.
pub(crate) fn by_chords<T: Real, S: Controlled<T, Point = SVector<T, N>>, const N: usize>(
    shape: &S,
    window: &Window,
) -> Result<Vec<Vec<T>>> {
    // In each direction the indices with the neighbours, and how many are in front of the window.
    let widened = |(direction, range): (&Direction, &std::ops::Range<usize>)| {
        let space = shape.space_along(*direction);
        let (ring, dim) = (space.is_periodic(), space.dim());
        let front = usize::from(ring || range.start > 0);
        let back = usize::from(ring || range.end < dim);
        let first = if range.start >= front { range.start - front } else { range.start + dim - front };
        let count = front + range.len() + back;
        (front, (first..first + count).collect::<Vec<usize>>())
    };
    let wide: Vec<_> = S::DIRECTIONS.iter().zip(window.ranges()).map(widened).collect();
    let along = |axis: usize| {
        let (front, own) = &wide[axis];
        let others: Vec<usize> = wide.get(1 - axis).map_or(vec![0], |(_, other)| other.clone());
        let mut sums = vec![T::zero(); own.len()];
        let mut lines = 0;
        for other in others {
            let place = |i: &usize| {
                let pair = if axis == 0 { [*i, other] } else { [other, *i] };
                shape.control_point(flat(shape, &pair[..wide.len()]))
            };
            let points = own.iter().map(place).collect::<Result<Vec<_>>>()?;
            let Some(shares) = accumulated(&points)? else { continue };
            sums.iter_mut().zip(shares).for_each(|(sum, share)| *sum += share);
            lines += 1;
        }
        if lines == 0 {
            return Err(Error::NoLength);
        }
        sums.iter_mut().for_each(|sum| *sum /= T::int(lines));
        Ok(sums[*front..front + window.ranges()[axis].len()].to_vec())
    };
    (0..wide.len()).map(along).collect()
}

/// Accumulated lengths over the total one; none if that is zero.
fn accumulated<T: Real, const N: usize>(points: &[SVector<T, N>]) -> Result<Option<Vec<T>>> {
    let mut sums = vec![T::zero()];
    for pair in points.windows(2) {
        sums.push(sums[sums.len() - 1].clone() + length(&(&pair[1] - &pair[0])));
    }
    let total = sums[sums.len() - 1].clone();
    if !total.is_finite() {
        return Err(Error::NotFinite { what: "length", index: 0 });
    }
    Ok((!total.is_zero()).then(|| sums.into_iter().map(|sum| sum / &total).collect()))
}
