//! The normals of a Catmull-Clark surface at the vertices of its control mesh.
//!
//! Over equal knot intervals a vertex of valence `n` inside, in four-sided faces, has the tangents
//!
//! ```text
//! t_1 = Σ A cos(2πi/n) e_i + (cos(2πi/n) + cos(2π(i+1)/n)) f_i,    t_2 the same with sines,
//! A = 1 + cos(2π/n) + cos(π/n) √(2 (9 + cos(2π/n)))
//! ```
//! which belong to the largest eigenvalue of a step below 1, with waves around the vertex. At a vertex of the boundary in
//! `k ≥ 2` faces one tangent is that of the boundary, `e_0 - e_k`, the other belongs to half waves, with `φ = π/k`:
//!
//! ```text
//! Σ sin(iφ) e_i + b Σ sin((i + ½)φ) f_i + w (e_0 + e_k) + w' V,   b = cos(φ/2) / (8λ - 2),
//! λ = (5 + cos φ + √((1 + cos φ)(9 + cos φ))) / 16
//! (λ - ½) w - w'/8 = sin φ / 16 + b sin(φ/2) / 4
//! (λ - ¾) w' - w = ⅜ Σ sin(iφ) + b/4 Σ sin((i + ½)φ)
//! ```
//! where the right-hand sides are what a step brings from inside to the boundary. In one face, the edges of that face
//! span the plane: they are tangents of a corner, and span the plane in which the curve of a smooth boundary bends, into
//! which the face is drawn.

use crate::coeff::Coeff;
use crate::error::Result;
use crate::mesh::boundary::Boundary;
use crate::mesh::catmull_clark::CatmullClark;
use crate::mesh::face_rule::turn;
use crate::mesh::limit::{product, weights};
use crate::mesh::near::{Line, Near, settle};
use crate::scalar::{Real, Scalar, larger};
use crate::vector::{cross3, extent};
use nalgebra::SVector;

/// How many steps floats are refined around a vertex that does not settle: what is left is as far from flat as the
/// rounding is.
const STEPS: usize = 24;

impl<T: Real> CatmullClark<T, 3> {
    /// The unit normals of the surface at the vertices, on the side from which faces run counter-clockwise.
    ///
    /// There is none where the tangents vanish or are parallel, at a vertex of valence 2 inside, at triple knots, which
    /// make a crease, and at the boundary of a mesh whose boundary is open, where the surface does not reach. In four or
    /// more faces at the boundary the surface has no tangent plane in general: then this is the normal to the boundary
    /// and to the direction in which the faces shrink most slowly.
    ///
    /// Vertices in other than four-sided faces, or among irregular knot intervals, are refined with their surroundings
    /// until the formula holds, or else 24 times, after which the formula for equal intervals is right to about seven
    /// digits.
    ///
    /// # Errors
    /// [`MeshError::Unsettled`](crate::MeshError::Unsettled) over exact numbers; those of [`CatmullClark::refined`].
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Boundary, CatmullClark, ControlMesh};
    /// let points = vec![vector![0.0, 0.0, 0.0], vector![1.0, 0.0, 0.0], vector![1.0, 1.0, 0.0], vector![0.0, 1.0, 0.0]];
    /// let square = CatmullClark::new(ControlMesh::new(points, [[0, 1, 2, 3]])?, Boundary::Corners);
    /// assert_eq!(square.limit_normals()?, vec![Some(vector![0.0, 0.0, 1.0]); 4]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn limit_normals(&self) -> Result<Vec<Option<SVector<T, 3>>>> {
        let open = self.boundary() == Boundary::Open;
        settle(self, STEPS, |near, v, last| {
            let boundary = near.topology().is_boundary(v);
            if boundary && open {
                return Some(None);
            }
            let (ring, last) = (near.ring(v)?, last && !T::EXACT);
            let tangents = match boundary {
                true if ring.len() == 1 || last || near.is_uniform_rim(v, &ring) => {
                    Some(at_rim(near, v, &ring))
                }
                true => None,
                false => inside(near, v, &ring, last),
            };
            let size = || {
                let around = ring.iter().flat_map(|h| [near.topology().target(*h), near.across(*h)]);
                extent(around.chain([v]).map(|w| near.point(w)))
            };
            tangents.map(|tangents| unit_normal(&tangents, size()))
        })
    }
}

type Tangents<T> = [SVector<T, 3>; 2];

/// The tangents at a vertex inside, if it is settled or need not be.
fn inside<T: Real>(near: &Near<'_, T, 3>, v: usize, ring: &[usize], last: bool) -> Option<Tangents<T>> {
    if let Some([u, w]) = near.lines(ring) {
        let (du, dw) = (slopes(&u), slopes(&w));
        return Some([product(near, v, ring, &du, &weights(&w)), product(near, v, ring, &weights(&u), &dw)]);
    }
    if near.is_still(ring) {
        return Some([SVector::zeros(), SVector::zeros()]);
    }
    if !last && !near.is_uniform(ring) {
        return None;
    }
    let n = ring.len();
    let ([cos, _], [half, _]) = (turn::<T>(1, n), turn::<T>(1, 2 * n));
    let edge = T::one() + &cos + half * (T::int(2) * (T::int(9) + &cos)).sqrt();
    let turns: Vec<[T; 2]> = (0..n).map(|i| turn(i, n)).collect();
    let tangent = |part: usize| {
        let mut sum = SVector::zeros();
        for (i, &h) in ring.iter().enumerate() {
            let [this, next] = [&turns[i][part], &turns[(i + 1) % n][part]];
            let target = near.point(near.topology().target(h)) - near.point(v);
            Coeff::add_scaled(&mut sum, &(this.clone() * &edge), &target);
            Coeff::add_scaled(
                &mut sum,
                &(this.clone() + next),
                &(near.point(near.across(h)) - near.point(v)),
            );
        }
        sum
    };
    // Around a vertex of valence 2 there are no waves: the sines are rounding.
    Some(if n == 2 { [SVector::zeros(), SVector::zeros()] } else { [tangent(0), tangent(1)] })
}

/// The tangents at a vertex of the boundary: from the last edge to the first, and inwards.
fn at_rim<T: Real>(near: &Near<'_, T, 3>, v: usize, ring: &[usize]) -> Tangents<T> {
    let (topology, k) = (near.topology(), ring.len());
    let from = |w: usize| near.point(w) - near.point(v);
    let [first, last] = [topology.target(ring[0]), topology.origin(topology.prev(ring[k - 1]))].map(from);
    if k == 1 {
        return [first, last];
    }
    let ([cos, _], [half, _]) = (turn::<T>(1, 2 * k), turn::<T>(1, 4 * k));
    let root = ((T::one() + &cos) * (T::int(9) + &cos)).sqrt();
    let lambda = (T::int(5) + &cos + root) / T::int(16);
    let b = half / (T::int(8) * &lambda - T::int(2));
    let edge = |i: usize| turn::<T>(i, 2 * k)[1].clone();
    let face = |i: usize| turn::<T>(2 * i + 1, 4 * k)[1].clone() * &b;
    let edges = (1..k).fold(T::zero(), |sum, i| sum + edge(i));
    let faces = (0..k).fold(T::zero(), |sum, i| sum + face(i));
    let to_vertex = edges * T::frac(3, 8) + faces * T::frac(1, 4);
    let to_edge = edge(1) * T::frac(1, 16) + face(0) * T::frac(1, 4);
    // Cramer's rule; the vertex itself, w', is where all is measured from.
    let whole = (lambda.clone() - T::one()) * (lambda.clone() - T::frac(1, 4));
    let w = ((lambda - T::frac(3, 4)) * to_edge + to_vertex * T::frac(1, 8)) / whole;
    let mut inwards = (&first + &last) * w;
    for (i, &h) in ring.iter().enumerate() {
        if i > 0 {
            Coeff::add_scaled(&mut inwards, &edge(i), &from(topology.target(h)));
        }
        Coeff::add_scaled(&mut inwards, &face(i), &from(near.across(h)));
    }
    [first - last, inwards]
}

/// The weights of the direction of a cubic at a knot: none of all three at a kink.
fn slopes<T: Scalar>([before, a, b, after]: &Line<T>) -> [T; 3] {
    let whole = a.clone() + b;
    if whole.is_zero() {
        return [(); 3].map(|()| T::zero());
    }
    let first = -(b.clone() / (whole.clone() + before));
    let last = a.clone() / (whole + after);
    let own = -(first.clone() + &last);
    [first, own, last]
}

/// The unit vector perpendicular to two tangents; none where they are parallel but for the rounding of themselves, or of points of the
/// given size, whose differences they are.
fn unit_normal<T: Real>(tangents: &Tangents<T>, points: T) -> Option<SVector<T, 3>> {
    let [mut s, mut t] = tangents.clone();
    let mut rounding = T::frac(1, 1 << 40);
    for tangent in [&mut s, &mut t] {
        let size = extent([&*tangent]);
        if size.is_zero() {
            return None;
        }
        rounding = larger(rounding, points.clone() / &size * T::frac(1, 1 << 46));
        Coeff::divide(tangent, &size);
    }
    let mut normal = cross3(&s, &t);
    let square = Coeff::squared_size(&normal);
    if square <= rounding.clone() * rounding {
        return None;
    }
    Coeff::divide(&mut normal, &square.sqrt());
    Some(normal)
}
