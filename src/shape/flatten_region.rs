//! Parts of the parameters of a shape: intervals, rectangles, polygons and discs, with the questions whether such a part
//! holds or meets the support of a control point. Exact over any field, without roots.

use crate::scalar::Scalar;
use crate::shape::polygon::is_inside;

/// From where to where along both parameters.
pub(crate) type Extent<T> = [(T, T); 2];

/// A part of the parameters of a curve (an interval) or of a surface (the others).
///
/// # Examples
/// ```
/// use symspline::Part;
/// let triangle = Part::Polygon(vec![[0, 0], [4, 0], [0, 4]].into_iter().map(|p| p.map(f64::from)).collect());
/// assert!(triangle.contains(&[1.0, 3.0]) && !triangle.contains(&[1.5, 3.0]));
/// let disc = Part::Disc { centre: [0.0, 0.0], radius: 5.0 };
/// assert!(disc.contains(&[3.0, 4.0]) && !disc.contains(&[4.0, 4.0]));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Part<T> {
    /// An interval of a curve.
    Interval(T, T),
    /// The intervals of a surface along `u` and `v`.
    Rectangle((T, T), (T, T)),
    /// What is inside a closed polygon by the even-odd rule, with its edges.
    Polygon(Vec<[T; 2]>),
    /// A disc with its edge.
    Disc {
        /// Its centre.
        centre: [T; 2],
        /// Its radius.
        radius: T,
    },
}

impl<T> From<(T, T)> for Part<T> {
    fn from((start, end): (T, T)) -> Self {
        Self::Interval(start, end)
    }
}

impl<T> From<[(T, T); 2]> for Part<T> {
    fn from([u, v]: [(T, T); 2]) -> Self {
        Self::Rectangle(u, v)
    }
}

impl<T: Scalar> Part<T> {
    /// Whether a place is inside; of an interval the first parameter alone counts.
    pub fn contains(&self, x: &[T; 2]) -> bool {
        let between = |x: &T, (start, end): (&T, &T)| start <= x && x <= end;
        match self {
            Self::Interval(start, end) => between(&x[0], (start, end)),
            Self::Rectangle(u, v) => between(&x[0], (&u.0, &u.1)) && between(&x[1], (&v.0, &v.1)),
            Self::Polygon(corners) => in_polygon(corners, x),
            Self::Disc { centre, radius } => squared_distance(x, centre) <= radius.clone() * radius,
        }
    }

    /// The least rectangle around it; of an interval the first entry is the interval.
    pub(crate) fn bounds(&self) -> Option<Extent<T>> {
        let around = |centre: &T, radius: &T| (centre.clone() - radius, centre.clone() + radius);
        Some(match self {
            Self::Interval(start, end) => [(start.clone(), end.clone()), (T::zero(), T::one())],
            Self::Rectangle(u, v) => [u.clone(), v.clone()],
            Self::Polygon(corners) => {
                let first = corners.first()?;
                let mut bounds = [0, 1].map(|k| (first[k].clone(), first[k].clone()));
                for corner in corners {
                    for (bound, x) in bounds.iter_mut().zip(corner) {
                        if *x < bound.0 {
                            bound.0 = x.clone();
                        }
                        if *x > bound.1 {
                            bound.1 = x.clone();
                        }
                    }
                }
                bounds
            }
            Self::Disc { centre, radius } => [0, 1].map(|k| around(&centre[k], radius)),
        })
    }

    /// Whether all of a rectangle is inside. A polygon whose edges cross the rectangle does not count as holding it.
    pub(crate) fn holds(&self, extent: &Extent<T>) -> bool {
        match self {
            Self::Polygon(corners) => {
                !edges(corners).any(|edge| meets_inside(edge, extent)) && self.contains(&middle(extent))
            }
            _ => corners(extent).iter().all(|corner| self.contains(corner)),
        }
    }

    /// Whether the inside of a rectangle has a place in common with the inside of the part.
    pub(crate) fn meets(&self, extent: &Extent<T>) -> bool {
        let overlap = |k: usize, (start, end): (&T, &T)| extent[k].0 < *end && *start < extent[k].1;
        match self {
            Self::Interval(start, end) => overlap(0, (start, end)),
            Self::Rectangle(u, v) => overlap(0, (&u.0, &u.1)) && overlap(1, (&v.0, &v.1)),
            Self::Polygon(corners) => {
                edges(corners).any(|edge| meets_inside(edge, extent)) || self.contains(&middle(extent))
            }
            Self::Disc { centre, radius } => {
                let nearest = [0, 1].map(|k| clamped(&centre[k], &extent[k]));
                squared_distance(&nearest, centre) < radius.clone() * radius
            }
        }
    }
}

fn clamped<T: Scalar>(x: &T, (start, end): &(T, T)) -> T {
    if x < start {
        start.clone()
    } else if x > end {
        end.clone()
    } else {
        x.clone()
    }
}

fn squared_distance<T: Scalar>(x: &[T; 2], y: &[T; 2]) -> T {
    let [d, e] = [0, 1].map(|k| x[k].clone() - &y[k]);
    d.clone() * &d + e.clone() * &e
}

fn middle<T: Scalar>(extent: &Extent<T>) -> [T; 2] {
    [0, 1].map(|k| extent[k].0.clone() + (extent[k].1.clone() - &extent[k].0) / T::int(2))
}

fn corners<T: Scalar>([u, v]: &Extent<T>) -> [[T; 2]; 4] {
    [(&u.0, &v.0), (&u.0, &v.1), (&u.1, &v.0), (&u.1, &v.1)].map(|(x, y)| [x.clone(), y.clone()])
}

/// The edges of a closed polygon.
fn edges<T>(corners: &[[T; 2]]) -> impl Iterator<Item = [&[T; 2]; 2]> {
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| [a, b])
}

/// Whether `x` is in a closed polygon, edges included.
pub(crate) fn in_polygon<T: Scalar>(corners: &[[T; 2]], x: &[T; 2]) -> bool {
    is_inside(edges(corners).map(|ends| ends.map(|end| (&end[0], &end[1]))), (&x[0], &x[1]))
}

/// Whether a segment has a point strictly inside a rectangle.
fn meets_inside<T: Scalar>([a, b]: [&[T; 2]; 2], extent: &Extent<T>) -> bool {
    // From where to where on the segment, both ends left out.
    let (mut enter, mut leave): (Option<T>, Option<T>) = (None, None);
    for (k, (start, end)) in extent.iter().enumerate() {
        let step = b[k].clone() - &a[k];
        if step.is_zero() {
            if a[k] <= *start || a[k] >= *end {
                return false;
            }
            continue;
        }
        let [x, y] = [start, end].map(|bound| (bound.clone() - &a[k]) / &step);
        let (x, y) = if x < y { (x, y) } else { (y, x) };
        enter = Some(enter.filter(|e| *e > x).unwrap_or(x));
        leave = Some(leave.filter(|l| *l < y).unwrap_or(y));
    }
    match (enter, leave) {
        (Some(enter), Some(leave)) => enter < leave && enter < T::one() && leave > T::zero(),
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[[i32; 2]]) -> Part<f64> {
        Part::Polygon(corners.iter().map(|c| c.map(f64::from)).collect())
    }

    #[test]
    fn even_odd() {
        // A pentagram-like ring: the square in the square is out.
        let ring = polygon(&[[0, 0], [6, 0], [6, 6], [0, 6], [0, 0], [2, 2], [4, 2], [4, 4], [2, 4], [2, 2]]);
        for (x, inside) in [([1.0, 1.5], true), ([3.0, 3.0], false), ([2.0, 3.0], true), ([7.0, 3.0], false)]
        {
            assert_eq!(ring.contains(&x), inside, "{x:?}");
        }
        assert!(!polygon(&[]).contains(&[0.0, 0.0]));
    }

    #[test]
    fn rectangles_in_polygons() {
        let l = polygon(&[[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]]);
        let extent = |u: (f64, f64), v: (f64, f64)| [u, v];
        assert!(l.holds(&extent((0.0, 2.0), (0.0, 4.0))) && l.holds(&extent((0.0, 4.0), (0.0, 2.0))));
        // All corners but the inner one.
        assert!(!l.holds(&extent((0.0, 3.0), (0.0, 3.0))));
        assert!(l.meets(&extent((1.0, 9.0), (1.0, 9.0))) && !l.meets(&extent((2.0, 4.0), (2.0, 4.0))));
        assert!(l.meets(&extent((-9.0, 9.0), (-9.0, 9.0))) && !l.holds(&extent((-9.0, 9.0), (-9.0, 9.0))));
        // A notch that no corner of the rectangle sees.
        let notched = polygon(&[[0, 0], [8, 0], [8, 8], [5, 8], [4, 1], [3, 8], [0, 8]]);
        assert!(!notched.holds(&extent((1.0, 7.0), (2.0, 4.0))));
    }

    #[test]
    fn discs() {
        let disc = Part::Disc { centre: [0.0, 0.0], radius: 5.0 };
        assert!(disc.holds(&[(-3.0, 3.0), (-4.0, 4.0)]) && !disc.holds(&[(-4.0, 3.0), (-4.0, 4.0)]));
        assert!(disc.meets(&[(4.0, 9.0), (-1.0, 9.0)]) && !disc.meets(&[(3.0, 9.0), (4.0, 9.0)]));
    }
}
