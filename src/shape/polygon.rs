//! Regions of the parameter plane bounded by polygons: the die of a punch [NURBS, (11.51)].

use crate::error::{Error, Result};
use crate::scalar::Scalar;

/// A closed region bounded by one or several polygons, by the even-odd rule: a ray from a point inside crosses the edges an
/// odd number of times. Polygons may cross themselves and each other; one within another is a hole.
///
/// Edges and corners belong to the region, all of them.
///
/// # Examples
/// The inside of a pentagram is outside.
/// ```
/// use symspline::Polygons;
/// let star = [(0.0, 3.0), (-2.0, -3.0), (3.0, 1.0), (-3.0, 1.0), (2.0, -3.0)];
/// let region = Polygons::new([star])?;
/// assert!(region.contains(&(0.0, 2.0)) && region.contains(&(0.0, 1.0)) && !region.contains(&(0.0, 0.0)));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Polygons<T> {
    /// The edges of all.
    edges: Vec<[(T, T); 2]>,
}

impl<T: Scalar> Polygons<T> {
    /// The region bounded by polygons, each closed from its last corner to its first.
    ///
    /// # Errors
    /// [`Error::TooFewPoints`] for a polygon of fewer than three corners; [`Error::NotFinite`].
    pub fn new<I: IntoIterator<Item = (T, T)>>(polygons: impl IntoIterator<Item = I>) -> Result<Self> {
        let mut edges = Vec::new();
        for polygon in polygons {
            let corners: Vec<(T, T)> = polygon.into_iter().collect();
            check_finite(&corners)?;
            let found = corners.len();
            if found < 3 {
                return Err(Error::TooFewPoints { expected: 3, found });
            }
            edges.extend((0..found).map(|i| [corners[i].clone(), corners[(i + 1) % found].clone()]));
        }
        Ok(Self { edges })
    }

    /// Whether a point is in the region, exactly over an exact field.
    pub fn contains(&self, point: &(T, T)) -> bool {
        let edges = self.edges.iter().map(|[(a, c), (b, d)]| [(a, c), (b, d)]);
        is_inside(edges, (&point.0, &point.1))
    }

    /// The edges of all polygons.
    pub(crate) fn edges(&self) -> &[[(T, T); 2]] {
        &self.edges
    }
}

/// Whether a point is on an edge, or a ray from it crosses an odd number of edges.
pub(crate) fn is_inside<'a, T: Scalar>(
    edges: impl Iterator<Item = [(&'a T, &'a T); 2]>,
    (u, v): (&T, &T),
) -> bool {
    let mut inside = false;
    for [(a, c), (b, d)] in edges {
        let between = |x: &T, p: &T, q: &T| (p <= x && x <= q) || (q <= x && x <= p);
        if (u, v) == (a, c) || (c == d && v == c && between(u, a, b)) {
            return true;
        }
        if c == d || !between(v, c, d) {
            continue;
        }
        let met = a.clone() + (b.clone() - a) * ((v.clone() - c) / (d.clone() - c));
        if *u == met {
            return true;
        }
        // Of an edge the upper end does not count, so that a corner counts once for two edges.
        inside ^= (v < c) != (v < d) && *u < met;
    }
    inside
}

/// Refuses points that are not finite.
pub(crate) fn check_finite<T: Scalar>(points: &[(T, T)]) -> Result<()> {
    match points.iter().position(|(u, v)| !u.is_finite() || !v.is_finite()) {
        Some(index) => Err(Error::NotFinite { what: "point", index }),
        None => Ok(()),
    }
}
