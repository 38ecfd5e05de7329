//! Where the faces of a Doo-Sabin surface shrink to, and how the surface lies there.
//!
//! A step maps the corners of a face linearly, by the same map `A` every time, to those of the face that it shrinks to. All rows of `A`
//! have the sum 1, so that the face shrinks to the point
//!
//! ```text
//! P∞ = Σ l_i P_i,   l A = l,   Σ l = 1
//! ```
//! With equal intervals `l_i = 1/n`. In a four-sided face whose opposite intervals agree, and in one at a clamped boundary, `l` are the
//! weights `c / Σ c` of the rule. The tangent plane is that of the first wave around the face, or, in a part of a biquadratic, of its
//! two derivatives.

use crate::dense::solve_dense;
use crate::error::Result;
use crate::error::mesh::MeshError;
use crate::mesh::boundary::Boundary;
use crate::mesh::control_mesh::ControlMesh;
use crate::mesh::corner_rule::CornerRule;
use crate::mesh::doo_sabin::DooSabin;
use crate::mesh::face_rule::{FaceRule, Waves};
use crate::scalar::{Real, Scalar};
use crate::vector::{cross3, unit};
use nalgebra::{DMatrix, SVector};

impl<T: Scalar, const N: usize> DooSabin<T, N> {
    /// The points on the surface that the faces shrink to, one a face.
    ///
    /// # Errors
    /// [`MeshError::NoLimit`] for a face that does not shrink to a point: one at a boundary in two places, or one without any knot
    /// interval that counts; [`MeshError::IrrationalWeights`] as in [`refined`](Self::refined), but only where intervals differ.
    /// The time is linear in the number of corners.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Boundary, ControlMesh, DooSabin};
    /// let points = vec![vector![0.0, 0.0], vector![3.0, 0.0], vector![0.0, 3.0]];
    /// let triangle = DooSabin::new(ControlMesh::new(points, [[0, 1, 2]])?, Boundary::Open);
    /// assert_eq!(triangle.limit_points()?, [vector![1.0, 1.0]]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn limit_points(&self) -> Result<Vec<SVector<T, N>>> {
        let mut rule = self.rule();
        let mut corners = Vec::new();
        (0..self.mesh().topology().face_count())
            .map(|f| {
                if rule.is_even(f) {
                    return Ok(self.mesh().centroid(f));
                }
                corners.clear();
                corners.extend(self.mesh().corners(f).cloned());
                limit(&mut rule, f, &corners)
            })
            .collect()
    }

    /// The mesh of the [limit points](Self::limit_points): a vertex where a face is, a face where an inner vertex is. It has all its
    /// vertices on the surface.
    ///
    /// At a boundary that is not open, vertices of the boundary in three or more faces are faces as well. The mesh must be the result of
    /// a step of subdivision, or like one: no two faces with two edges in common. Faces without an inner vertex are left out.
    ///
    /// # Errors
    /// Those of [`limit_points`](Self::limit_points); [`MeshError::NothingInside`] if all vertices are at the boundary; those of
    /// [`ControlMesh::new`].
    pub fn limit_mesh(&self) -> Result<ControlMesh<T, N>> {
        let topology = self.mesh().topology();
        let filled = |v: usize| self.boundary() != Boundary::Open && topology.leaving(v).nth(2).is_some();
        let within = (0..topology.vertex_count()).filter(|v| !topology.is_boundary(*v) || filled(*v));
        let limits = self.limit_points()?;
        let (mut corners, mut ends, mut points) = (Vec::new(), vec![0], Vec::new());
        let mut places = vec![None; topology.face_count()];
        for v in within {
            corners.extend(topology.leaving(v).map(|h| {
                let face = topology.face_of(h);
                *places[face].get_or_insert_with(|| {
                    points.push(limits[face].clone());
                    points.len() - 1
                })
            }));
            ends.push(corners.len());
        }
        if points.is_empty() {
            return Err(MeshError::NothingInside { what: "vertex" }.into());
        }
        let faces = ends.windows(2).map(|ends| &corners[ends[0]..ends[1]]);
        ControlMesh::new(points, faces)
    }
}

impl<T: Real> DooSabin<T, 3> {
    /// The unit normals of the surface at the [limit points](Self::limit_points), to the side from which faces run
    /// counter-clockwise; none where the tangent plane is not determined.
    ///
    /// Where intervals differ, or at a boundary, around a face that does not have four sides, the plane is found by 40 steps.
    ///
    /// # Errors
    /// Those of [`limit_points`](Self::limit_points).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Boundary, ControlMesh, DooSabin};
    /// let points = vec![vector![0.0, 0.0, 0.0], vector![3.0, 0.0, 0.0], vector![0.0, 3.0, 0.0]];
    /// let triangle = DooSabin::new(ControlMesh::new(points, [[0, 1, 2]])?, Boundary::Open);
    /// assert_eq!(triangle.limit_normals()?, [Some(vector![0.0, 0.0, 1.0])]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn limit_normals(&self) -> Result<Vec<Option<SVector<T, 3>>>> {
        let mut rule = self.rule();
        let mut waves = Waves::default();
        let mut corners = Vec::new();
        let mut normal = |f: usize| {
            corners.clear();
            corners.extend(self.mesh().corners(f).cloned());
            let across = if rule.is_even(f) {
                waves.run(&corners)?;
                // Two places about a quarter of the turn apart.
                cross3(&waves.first[0], &waves.first[(corners.len() + 2) / 4])
            } else if let ([p, q, r, s], Some([a, b, c, d])) = (&corners[..], rule.weights(f)) {
                let along = |from: [&SVector<T, 3>; 2], to: [&SVector<T, 3>; 2], w: T, v: T| {
                    (to[0] - from[0]) * w + (to[1] - from[1]) * v
                };
                let u = along([p, s], [q, r], a.clone() + b, c.clone() + d);
                let v = along([p, q], [s, r], a.clone() + d, b.clone() + c);
                cross3(&u, &v)
            } else {
                let centre = limit(&mut rule, f, &corners)?;
                area_after(&mut rule, f, corners.iter().map(|corner| corner - &centre).collect())?
            };
            Ok(unit(&across).map(|(normal, _)| normal))
        };
        (0..self.mesh().topology().face_count()).map(&mut normal).collect()
    }
}

/// The point that face `f`, which has uneven intervals or is at a boundary, shrinks to.
fn limit<T: Scalar, const N: usize>(
    rule: &mut CornerRule<'_, T, N>,
    f: usize,
    corners: &[SVector<T, N>],
) -> Result<SVector<T, N>> {
    let nowhere = MeshError::NoLimit { what: "face", index: f };
    let weights = rule.weights(f).ok_or(nowhere.clone())?.to_vec();
    let sum = |weights: &[T]| {
        corners.iter().zip(weights).fold(SVector::zeros(), |sum, (corner, w)| sum + corner * w.clone())
    };
    // What is at the boundary stays there: corners, and boundary edges between vertices that are none.
    let held = rule.held(f);
    match held[..] {
        [] => {}
        [i] => return Ok(rule.along_boundary(f, i, corners).expect("held corners are at the boundary")),
        _ => return Err(nowhere.into()),
    }
    let agree =
        |a: T, b: T| a == b || !T::EXACT && (a.clone() - &b).magnitude() <= (a + b) * T::frac(1, 1 << 40);
    if let [a, b, c, d] = &weights[..]
        && agree(a.clone() * c, b.clone() * d)
    {
        return Ok(sum(&weights));
    }
    Ok(sum(&left(&weights)?.ok_or(nowhere)?))
}

/// The weights `l` of a face with the weights `c` whose sum is 1, in time linear in their number.
///
/// With `s = 1/2` and `g_i = (c_{i+2} + c_{i-2}) / 8`, the equation `l A = l` is
///
/// ```text
/// (s + n g_j) l_j = s c_j + z_j,   z_j = Σ_i (1 + 2 cos(2π (i - j) / n)) g_i l_i
/// ```
/// where `z` is a constant plus a first wave around the face: three unknowns. A wave is put together of those that are highest at corner
/// 0 and about a quarter of the turn further, so that no sines are needed. Their sum is 1 then.
fn left<T: Scalar>(c: &[T]) -> Result<Option<Vec<T>>> {
    let (n, s) = (c.len(), FaceRule::DooSabin.share::<T>());
    let quarter = (n + 2) / 4;
    let pulls: Vec<T> =
        (0..n).map(|i| (c[(i + 2) % n].clone() + &c[(i + n - 2) % n]) * T::frac(1, 8)).collect();
    let whole = |j: usize| pulls[j].clone() * T::int(n as i64) + &s;
    let mut waves = Waves::<T, 1>::default();
    let unit = |i: usize| SVector::<T, 1>::new(if i == 0 { T::one() } else { T::zero() });
    waves.run(&(0..n).map(unit).collect::<Vec<_>>())?;
    let cosines: Vec<T> = waves.first.iter().map(|cos| cos[0].clone()).collect();
    let base = |b: usize, j: usize| match b {
        0 => T::one(),
        1 => cosines[j].clone(),
        _ => cosines[(j + n - quarter) % n].clone(),
    };
    let between = cosines[quarter].clone();
    let apart = T::one() - between.clone() * &between;
    // What of `z` comes of such `(s + n g) l`, by its three parts.
    let mut parts = |of: &dyn Fn(usize) -> T| -> Result<[T; 3]> {
        let pulled = |j: usize| SVector::<T, 1>::new(of(j) * &pulls[j] / whole(j));
        let sum = waves.run(&(0..n).map(pulled).collect::<Vec<_>>())?;
        let [first, further] = [0, quarter].map(|j| waves.first[j][0].clone() * T::int(2));
        // Of two corners one wave is the other, turned over.
        let further = if apart.is_zero() { T::zero() } else { (further - first.clone() * &between) / &apart };
        Ok([sum[0].clone(), first - further.clone() * &between, further])
    };
    let right = parts(&|j| s.clone() * &c[j])?;
    let images = [parts(&|j| base(0, j))?, parts(&|j| base(1, j))?, parts(&|j| base(2, j))?];
    let entry = |i: usize, b: usize| if i == b { T::one() } else { T::zero() } - &images[b][i];
    let system = DMatrix::from_fn(3, 3, entry);
    let Ok(z) = solve_dense(&system, &DMatrix::from_fn(3, 1, |i, _| right[i].clone())) else {
        return Ok(None);
    };
    let weight = |j: usize| {
        let terms = (0..3).fold(s.clone() * &c[j], |sum, b| sum + z[(b, 0)].clone() * base(b, j));
        terms / whole(j)
    };
    Ok(Some((0..n).map(weight).collect()))
}

/// The direction of the area of a face after many steps, for corners given from the point that it shrinks to.
fn area_after<T: Real>(
    rule: &mut CornerRule<'_, T, 3>,
    f: usize,
    mut corners: Vec<SVector<T, 3>>,
) -> Result<SVector<T, 3>> {
    const STEPS: usize = 40;
    let mut waves = Waves::default();
    let mut moved = Vec::new();
    for _ in 0..STEPS {
        moved.clear();
        rule.apply(FaceRule::DooSabin.share(), f, &corners, &mut waves, &mut moved)?;
        // Larger again by as much as the first wave shrinks.
        corners.clear();
        corners.extend(moved.iter().map(|corner| corner * T::int(2)));
    }
    let ahead = corners.iter().skip(1).chain(&corners);
    Ok(corners.iter().zip(ahead).fold(SVector::zeros(), |sum, (p, q)| sum + cross3(p, q)))
}
