//! Control points put back near the ends of a line of them: those of a curve, or of one row or column of a surface.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::fine_tune::turn::Turnable;
use crate::ops::bound::epsilon;
use crate::scalar::{Scalar, larger_size};
use nalgebra::SVector;

/// The control points near the ends of the invariant curve, to which those of a tuned curve are put back.
#[derive(Clone, Debug)]
pub(crate) struct Ends<T, const N: usize> {
    /// `I_0 ... I_s`.
    start: Vec<SVector<T, N>>,
    /// `I_{N-e} ... I_N`.
    end: Vec<SVector<T, N>>,
    /// `N - e`.
    far: usize,
}

impl<T: Scalar, const N: usize> Ends<T, N> {
    /// The ends of the control points `i`, `s + 1` and `e + 1` of them.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] if these are not all different ones.
    pub(crate) fn of(i: &[SVector<T, N>], [s, e]: [usize; 2]) -> Result<Self> {
        check_count(i.len(), s + e + 2)?;
        let far = i.len() - 1 - e;
        Ok(Self { start: i[..=s].to_vec(), end: i[far..].to_vec(), far })
    }

    /// `I_s`.
    pub(crate) fn foot(&self) -> &SVector<T, N> {
        &self.start[self.start.len() - 1]
    }

    /// `I_{N-e} - I_s`.
    pub(crate) fn chord(&self) -> SVector<T, N> {
        self.end[0].minus(self.foot())
    }

    /// Control point `k` if it is one of those that are matched, which come without rounding.
    pub(crate) fn held(&self, k: usize) -> Option<&SVector<T, N>> {
        self.start.get(k).or_else(|| self.end.get(k.checked_sub(self.far)?))
    }

    /// The similarity that takes the chord of the tuned curve to this one.
    ///
    /// # Errors
    /// [`Error::NoChord`] if one of them has no length.
    pub(crate) fn turn(
        &self,
        tuned: &SVector<T, N>,
    ) -> Result<impl Fn(&SVector<T, N>) -> SVector<T, N> + use<T, N>>
    where
        SVector<T, N>: Turnable<T>,
    {
        let chord = self.chord();
        SVector::turn(tuned, &chord).filter(|_| !chord.vanishes()).ok_or(Error::NoChord)
    }
}

/// Puts the control points `q` back to those of the invariant line `i` at the ends that are held, `j + 1` of them each: at one
/// end by a translation, at both by a similarity.
///
/// # Errors
/// [`Error::CoefficientCount`] if there are too few; [`Error::NoChord`] if one of the chords has no length and they differ.
pub(crate) fn hold_line<T: Scalar, const N: usize>(
    q: &mut [SVector<T, N>],
    i: &[SVector<T, N>],
    depths: [Option<usize>; 2],
) -> Result<()>
where
    SVector<T, N>: Turnable<T>,
{
    if let [Some(s), Some(e)] = depths {
        let ends = Ends::of(i, [s, e])?;
        let foot = q[s].clone();
        let chord = q[ends.far].minus(&foot);
        if extent([&chord.minus(&ends.chord())]) <= noise(q, i) {
            // Also where the whole line is one point.
            translate(q, &ends.foot().minus(&foot));
        } else {
            let turn = ends.turn(&chord)?;
            q.iter_mut()
                .for_each(|point| *point = turn(&point.minus(&foot)).plus_scaled(&T::one(), ends.foot()));
        }
    } else if let Some(j) = depths[0] {
        check_count(q.len(), j + 1)?;
        translate(q, &i[j].minus(&q[j]));
    } else if let Some(j) = depths[1] {
        check_count(q.len(), j + 1)?;
        let k = q.len() - 1 - j;
        translate(q, &i[k].minus(&q[k]));
    }
    restore(q, i, depths);
    Ok(())
}

/// Up to what a difference of two points of these lines is rounding.
fn noise<T: Scalar, const N: usize>(q: &[SVector<T, N>], i: &[SVector<T, N>]) -> T {
    if T::EXACT {
        return T::zero();
    }
    extent(q.iter().chain(i)) * epsilon::<T>() * T::int(8 * q.len() as i64)
}

/// The largest coordinate.
fn extent<'a, T: Scalar, const N: usize>(points: impl IntoIterator<Item = &'a SVector<T, N>>) -> T {
    points.into_iter().flat_map(|point| point.iter()).map(T::magnitude).fold(T::zero(), larger_size)
}

/// Copies the control points of the invariant line that are held; there are enough of them.
pub(crate) fn restore<C: Clone>(q: &mut [C], i: &[C], depths: [Option<usize>; 2]) {
    let [start, end] = depths.map(|depth| depth.map_or(0, |j| j + 1));
    let far = q.len() - end;
    q[..start].clone_from_slice(&i[..start]);
    q[far..].clone_from_slice(&i[far..]);
}

fn translate<T: Scalar, const N: usize>(points: &mut [SVector<T, N>], by: &SVector<T, N>) {
    if !by.vanishes() {
        points.iter_mut().for_each(|point| *point += by);
    }
}

/// Refuses fewer control points than `needed`.
pub(crate) fn check_count(found: usize, needed: usize) -> Result<()> {
    if found < needed { Err(Error::CoefficientCount { expected: needed, found }) } else { Ok(()) }
}
