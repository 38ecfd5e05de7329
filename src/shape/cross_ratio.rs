//! The cross ratio of four points of a line, which no perspective changes.

use crate::coeff::Coeff;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::scalar::{Scalar, larger_size};

/// The cross ratio `(A, B; C, D)` of four points of a line, with signed lengths along it:
///
/// ```text
/// (A, B; C, D) = (AC / BC) / (AD / BD)
/// ```
///
/// A weight is one: `w_k = (P_k, R; M, P)`, where `R`, `M` and `P` are the points of the curve at weight 0, at weight 1 and at
/// `w_k` [NURBS, (11.24) and (11.38)]; see [`WeightPull::point_at_weight`](crate::WeightPull::point_at_weight). `C` and `D` may coincide.
///
/// `tolerance` is how far from the line through `A` and `B` the others may be: zero over an exact field.
///
/// # Errors
/// [`ShapeError::NotOnLine`]; [`ShapeError::Coincide`] if `A` and `B`, `B` and `C` or `A` and `D` are one point;
/// [`Error::BadTolerance`]; [`Error::NotFinite`].
///
/// # Examples
/// ```
/// use symspline::{Q, Scalar, cross_ratio};
/// let [a, b, c, d] = [0, 6, 2, 3].map(Q::int);
/// assert_eq!(cross_ratio([&a, &b, &c, &d], &Q::int(0))?, Q::frac(1, 2));
/// # Ok::<(), symspline::Error>(())
/// ```
pub fn cross_ratio<T: Scalar, C: Coeff<T>>(points: [&C; 4], tolerance: &T) -> Result<T> {
    if !(*tolerance >= T::zero() && tolerance.is_finite()) {
        return Err(Error::BadTolerance { tolerance: tolerance.to_string() });
    }
    let mut from_a = points.map(|p| p.minus(points[0]));
    let size = from_a.iter().flat_map(C::components).map(T::magnitude).fold(T::zero(), larger_size);
    if !size.is_finite() {
        return Err(Error::NotFinite { what: "distance of points", index: 0 });
    }
    // In proportion to the largest, so that no square overflows.
    if !size.is_zero() {
        from_a.iter_mut().for_each(|way| way.divide(&size));
    }
    if from_a[1].squared_size().is_zero() {
        return Err(ShapeError::Coincide { first: 0, second: 1 }.into());
    }
    let [_, line, c, d] = &from_a;
    let share = |point: usize, way: &C| -> Result<T> {
        let share = T::dot(way.components().zip(line.components())) / line.squared_size();
        let off = way.plus_scaled(&-share.clone(), line).squared_size();
        let allowed = tolerance.clone() / &size;
        if off > allowed.clone() * allowed {
            let (distance, tolerance) = (off.root_above() * &size, tolerance.clone());
            let [distance, tolerance] = [distance, tolerance].map(|x| x.to_string());
            return Err(ShapeError::NotOnLine { point, distance, tolerance }.into());
        }
        Ok(share)
    };
    let [c, d] = [share(2, c)?, share(3, d)?];
    let one = T::one();
    match (c == one, d.is_zero()) {
        (true, _) => Err(ShapeError::Coincide { first: 1, second: 2 }.into()),
        (_, true) => Err(ShapeError::Coincide { first: 0, second: 3 }.into()),
        _ => Ok(c.clone() / (c - &one) * ((d.clone() - one) / d)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Q;
    use nalgebra::vector;

    #[test]
    fn refusals_say_why() {
        let [o, x, y, z] = [[0, 0], [1, 0], [0, 1], [2, 0]].map(|p| vector![Q::int(p[0]), Q::int(p[1])]);
        let ratio = |points: [&_; 4]| cross_ratio(points, &Q::int(0)).unwrap_err();
        let coincide = |first, second| Error::from(ShapeError::Coincide { first, second });
        assert_eq!(ratio([&o, &o, &x, &z]), coincide(0, 1));
        assert_eq!(ratio([&o, &x, &x, &z]), coincide(1, 2));
        assert_eq!(ratio([&o, &x, &z, &o]), coincide(0, 3));
        for (point, points) in [(2, [&o, &x, &y, &z]), (3, [&o, &x, &z, &y])] {
            assert!(
                matches!(ratio(points), Error::Shape(ShapeError::NotOnLine { point: found, .. }) if found == point)
            );
        }
        let bad = cross_ratio([&o, &x, &z, &z], &Q::int(-1));
        assert_eq!(bad, Err(Error::BadTolerance { tolerance: "-1".into() }));
    }

    #[test]
    fn sizes_do_not_matter() {
        for size in [1e-320, 1e-300, 1.0, 1e300] {
            let [a, b, c, d] = [0.0, 3.0, 1.0, 2.0].map(|s: f64| vector![s * size, -s * size]);
            let ratio = cross_ratio([&a, &b, &c, &d], &0.0).unwrap();
            assert!((ratio - 0.25).abs() < if size < 1e-310 { 1e-2 } else { 1e-14 }, "{ratio} at {size}");
            let off = vector![0.5 * size, 0.0];
            assert!(cross_ratio([&a, &b, &off, &d], &(0.1 * size)).is_err());
            assert!(cross_ratio([&a, &b, &off, &d], &size).is_ok());
        }
        let far = [-1e308, 1e308, 0.0, 1.0];
        assert!(matches!(cross_ratio(far.each_ref(), &0.0), Err(Error::NotFinite { .. })));
        // So much shorter than the rest that its square vanishes.
        let near = [0.0, 1e-200, 1.0, 2.0];
        assert!(cross_ratio(near.each_ref(), &0.0).is_err());
    }
}
