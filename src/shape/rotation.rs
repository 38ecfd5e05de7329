//! Rotations by the least angle, over any field that holds the ratio of two lengths.
//!
//! The rotation that takes the direction of `v` to that of `w` is two reflections, `x -> x - 2 (x·n) / (n·n) n`:
//!
//! ```text
//! n_1 = ρ v + w,  n_2 = w                        for v·w >= 0, with ρ = |w| / |v|
//! n_1 = ρ v - w,  n_2 = v - (v·w) / (w·w) w      otherwise
//! ```
//! The first takes `ρ v` to `-w`, and the second turns that about; or the first takes `ρ v` to `w`, and the second leaves that
//! where it is. What is across both vectors stays. So `ρ` alone has to be in the field, in the plane and in space, and no
//! `n_1` cancels. Half a turn has no least axis in space: then `n_2` is the part across `w` of the coordinate axis that `w` leans
//! to least. Over inexact fields so it is where `n_2` is no more than rounding.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::ops::bound::epsilon;
use crate::scalar::{Scalar, larger};
use crate::shape::root::{divided, root, size};
use crate::vector::dot;
use nalgebra::SVector;

/// The rotation by the least angle from one direction to another.
///
/// # Examples
/// ```
/// use nalgebra::vector;
/// use symspline::{Q, Rotation, Scalar};
/// let q = |x: i64, y: i64| vector![Q::int(x), Q::int(y)];
/// let turn = Rotation::between(&q(3, 4), &q(8, 6))?;
/// assert_eq!(turn.of(&q(3, 4)), q(4, 3));
/// // No direction, no rotation.
/// assert_eq!(Rotation::between(&q(0, 0), &q(8, 6))?.of(&q(3, 4)), q(3, 4));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Rotation<T, const N: usize> {
    /// Normals of the two mirrors; none if nothing turns.
    mirrors: Option<[SVector<T, N>; 2]>,
}

impl<T: Scalar, const N: usize> Rotation<T, N> {
    /// The rotation that turns nothing.
    pub fn none() -> Self {
        Self { mirrors: None }
    }

    /// The rotation that takes the direction of `from` to that of `to`; none if one of them has no direction.
    ///
    /// # Errors
    /// [`ShapeError::NoRoot`](crate::ShapeError::NoRoot) if the ratio of their lengths is not in the field.
    pub fn between(from: &SVector<T, N>, to: &SVector<T, N>) -> Result<Self> {
        if from.vanishes() || to.vanishes() {
            return Ok(Self::none());
        }
        let [from, to] = [from, to].map(|v| divided(v, &size(v)));
        let ratio = root(&(to.squared_size() / from.squared_size()))?;
        if dot(&from, &to) >= T::zero() {
            let middle = to.plus_scaled(&ratio, &from);
            return Ok(Self { mirrors: Some([divided(&middle, &size(&middle)), to]) });
        }
        let difference = to.plus_scaled(&-ratio, &from);
        // Where a line is all there is nothing is across it.
        let mirrors = sideways(&from, &to).map(|across| [divided(&difference, &size(&difference)), across]);
        Ok(Self { mirrors })
    }

    /// A vector after the rotation.
    pub fn of(&self, v: &SVector<T, N>) -> SVector<T, N> {
        match &self.mirrors {
            Some([first, second]) => reflected(&reflected(v, first), second),
            None => v.clone(),
        }
    }

    /// A point after the rotation about `pivot` and the translation of that to `place`: `place + R (point - pivot)`.
    pub fn carried(
        &self,
        point: &SVector<T, N>,
        pivot: &SVector<T, N>,
        place: &SVector<T, N>,
    ) -> SVector<T, N> {
        place.plus_scaled(&T::one(), &self.of(&point.minus(pivot)))
    }
}

/// The mirror image of `v` in the plane through the origin across `normal`.
fn reflected<T: Scalar, const N: usize>(v: &SVector<T, N>, normal: &SVector<T, N>) -> SVector<T, N> {
    v.plus_scaled(&(T::int(-2) * dot(v, normal) / normal.squared_size()), normal)
}

/// The part of `v` that is across `w`.
fn across<T: Scalar, const N: usize>(v: &SVector<T, N>, w: &SVector<T, N>) -> SVector<T, N> {
    v.plus_scaled(&(-(dot(v, w) / w.squared_size())), w)
}

/// The direction in which `v` is across `w`, both not far from one in size; where it is not, that of the coordinate axis that
/// `w` leans to least. None on a line.
fn sideways<T: Scalar, const N: usize>(v: &SVector<T, N>, w: &SVector<T, N>) -> Option<SVector<T, N>> {
    let largest = |v: &SVector<T, N>| v.iter().map(T::magnitude).fold(T::zero(), larger);
    let noise = if T::EXACT { T::zero() } else { T::int(16) * epsilon::<T>() * largest(v) };
    let side = across(v, w);
    if largest(&side) > noise {
        // Once more, for what rounding left along `w`.
        return Some(across(&divided(&side, &size(&side)), w));
    }
    let least = (1..N).fold(0, |k, i| if w[i].magnitude() < w[k].magnitude() { i } else { k });
    let axis: SVector<T, N> = SVector::from_fn(|i, _| if i == least { T::one() } else { T::zero() });
    (N > 1).then(|| across(&axis, w))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use nalgebra::vector;

    #[test]
    fn half_turns_are_rotations() {
        let from = vector![Q::int(1), Q::int(-2), Q::int(2)];
        let turn = Rotation::between(&from, &from.scaled(&Q::int(-3))).unwrap();
        assert_eq!(turn.of(&from), from.scaled(&Q::int(-1)));
        // Twice is none, and lengths stay.
        let v = vector![Q::int(5), Q::int(7), Q::int(-1)];
        assert_eq!(turn.of(&turn.of(&v)), v);
        assert_eq!(turn.of(&v).squared_size(), v.squared_size());
        let flat = vector![Q::int(3), Q::int(1)];
        let turn = Rotation::between(&flat, &flat.scaled(&Q::int(-1))).unwrap();
        assert_eq!(turn.of(&vector![Q::int(2), Q::int(9)]), vector![Q::int(-2), Q::int(-9)]);
    }

    #[test]
    fn rotations_near_half_a_turn_keep_lengths() {
        let from = vector![1.0, 0.0, 0.0];
        for e in [0.0, 1e-300, 1e-12, 1e-8, 1e-6, 1e-3, 1.0] {
            let turn = Rotation::between(&from, &vector![-2.0, 2.0 * e, 0.0]).unwrap();
            let images = [0, 1, 2].map(|k| turn.of(&SVector::from_fn(|i, _| f64::from(u8::from(i == k)))));
            for (i, u) in images.iter().enumerate() {
                for (j, v) in images.iter().enumerate() {
                    assert!((u.dot(v) - f64::from(u8::from(i == j))).abs() < 1e-14, "{e}");
                }
            }
        }
    }

    #[test]
    fn rotations_near_half_a_turn_arrive() {
        for i in 1..200 {
            let s = f64::from(i);
            let from = vector![s.sin(), (1.7 * s).cos(), (0.3 * s).sin()];
            for e in [0.0, 1e-16, 1e-14, 1e-10, 1e-6, 1e-2] {
                let to = from * -s.cos().abs() + vector![0.3, -0.2, 0.1] * e;
                let image = Rotation::between(&from, &to).unwrap().of(&from);
                assert!((image.normalize() - to.normalize()).norm() < 1e-14, "{i} {e}");
            }
            let from = from.xy();
            let turn = Rotation::between(&from, &(from * -s.cos().abs())).unwrap();
            assert!((turn.of(&vector![3.0, 4.0]) + vector![3.0, 4.0]).norm() < 1e-13, "{i}");
        }
    }

    #[test]
    fn sizes_do_not_matter() {
        for size in [1e-300, 1e300] {
            let turn = Rotation::between(&vector![3.0 * size, 4.0 * size], &vector![-4.0, 3.0]).unwrap();
            assert!((turn.of(&vector![1.0, 0.0]) - vector![0.0, 1.0]).norm() < 1e-15);
        }
        assert!(Rotation::between(&vector![Q::int(1), Q::int(1)], &vector![Q::int(1), Q::int(0)]).is_err());
        let line = Rotation::between(&vector![1.0], &vector![-1.0]).unwrap();
        assert_eq!(line.of(&vector![2.0]), vector![2.0]);
    }
}
