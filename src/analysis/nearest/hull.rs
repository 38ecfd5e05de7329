//! How far a hull of points is from the origin.
//!
//! For any direction `d` the hull is no nearer than `min d · q / |d|`. A direction is found as [the method of Frank and
//! Wolfe] does: from a point of the hull towards the one that stands out most against it, to the point of that segment
//! next to the origin. Few steps do; a bound is right after every one.
//!
//! [the method of Frank and Wolfe]: https://en.wikipedia.org/wiki/Frank%E2%80%93Wolfe_algorithm

use nalgebra::SVector;

/// How many directions are tried.
const STEPS: usize = 3;

/// Squared lengths below this are lost in the range of numbers.
const TINY: f64 = 1e-280;

/// A number that no point of the hull of `points` is nearer to the origin than, at most `enough` needed, starting at
/// the point `near` of the hull. Up to rounding of a few units of the largest point.
#[inline]
pub(super) fn distance<const N: usize>(
    points: &[SVector<f64, N>],
    near: SVector<f64, N>,
    enough: f64,
) -> f64 {
    let (mut near, mut bound) = (near, 0.0_f64);
    for _ in 0..STEPS {
        let square = near.norm_squared();
        if square < TINY {
            break;
        }
        let (mut least, mut out) = (f64::INFINITY, &points[0]);
        for q in points {
            let along = near.dot(q);
            if along < least {
                (least, out) = (along, q);
            }
        }
        bound = bound.max(least / square.sqrt());
        if bound >= enough {
            break;
        }
        let side = out - near;
        let length = side.norm_squared();
        if length < TINY {
            break;
        }
        near += side * (-near.dot(&side) / length).clamp(0.0, 1.0);
    }
    bound
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::vector;

    #[test]
    fn triangles_near_and_around() {
        let triangle = [vector![3.0, 1.0], vector![3.0, -2.0], vector![7.0, 0.0]];
        let bound = distance(&triangle, triangle[2], f64::INFINITY);
        assert!(bound <= 3.0 && bound > 2.9);
        let around = [vector![-1.0, -1.0], vector![2.0, -1.0], vector![0.0, 3.0]];
        assert!(distance(&around, around[0], f64::INFINITY) <= 0.0);
    }
}
