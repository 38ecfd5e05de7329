//! What is around a vertex of a Catmull-Clark surface, and whether its limit is known.
//!
//! The limit of a vertex is a mean of the points of the faces around it, with weights that are known if these faces have
//! four sides and the knot intervals around repeat from step to step: there are none, all are equal, or those of parallel
//! edges are. Each step sets such a vertex further apart from all that is irregular, so what is not settled may be after
//! some steps. Only the surroundings are refined: the points of a step in the faces of three rings around a vertex depend
//! on the faces of three rings alone.

use crate::error::Result;
use crate::error::mesh::MeshError;
use crate::mesh::boundary::Boundary;
use crate::mesh::catmull_clark::CatmullClark;
use crate::mesh::interval_rules::{reach, reaches, scaled};
use crate::mesh::topology::Topology;
use crate::scalar::Scalar;
use nalgebra::SVector;
use std::borrow::Cow;

/// How many steps are made over exact numbers before a vertex counts as unsettled.
const EXACT_STEPS: usize = 6;

/// The knot intervals along a line: the last but one and the last before a point, the first and the second after it.
pub(super) type Line<T> = [T; 4];

/// A surface with the reaches of its edges.
pub(super) struct Near<'a, T: Scalar, const N: usize> {
    pub(super) surface: &'a CatmullClark<T, N>,
    /// The knot intervals, if they are not all equal, in a scale in which sums do not overflow.
    intervals: Option<Cow<'a, [T]>>,
    reaches: Vec<[T; 2]>,
}

impl<'a, T: Scalar, const N: usize> Near<'a, T, N> {
    fn new(surface: &'a CatmullClark<T, N>) -> Self {
        let topology = surface.mesh().topology();
        let intervals = surface.intervals().map(scaled);
        let reaches = intervals.as_ref().map(|d| reaches(topology, d)).unwrap_or_default();
        Self { surface, intervals, reaches }
    }

    pub(super) fn topology(&self) -> &'a Topology {
        self.surface.mesh().topology()
    }

    pub(super) fn point(&self, v: usize) -> &'a SVector<T, N> {
        &self.surface.mesh().points()[v]
    }

    /// The knot interval of half-edge `h`; 1 if all are equal.
    fn interval(&self, h: usize) -> T {
        self.intervals.as_ref().map_or_else(T::one, |d| d[self.topology().edge_of(h)].clone())
    }

    /// The half-edges out of vertex `v`, if all faces there have four sides.
    pub(super) fn ring(&self, v: usize) -> Option<Vec<usize>> {
        let topology = self.topology();
        let ring: Vec<usize> = topology.leaving(v).collect();
        let square = |h: &usize| topology.sides(topology.face_of(*h)).len() == 4;
        ring.iter().all(square).then_some(ring)
    }

    /// The vertex across the face of half-edge `h` out of a vertex.
    pub(super) fn across(&self, h: usize) -> usize {
        self.topology().target(self.topology().next(h))
    }

    /// Whether all intervals around vertex `v` inside are equal, and go on so.
    pub(super) fn is_uniform(&self, ring: &[usize]) -> bool {
        if self.intervals.is_none() {
            return true;
        }
        let (topology, d) = (self.topology(), self.interval(ring[0]));
        let straight = T::int(3) * &d;
        let even = |h: usize| {
            self.interval(h) == d
                && [false, true].iter().all(|far| *reach(topology, &self.reaches, h, *far) == straight)
        };
        let face = |h: usize| [h, topology.next(h), topology.next(topology.next(h))].into_iter().all(even);
        !d.is_zero() && ring.iter().all(|h| face(*h))
    }

    /// The same of vertex `v` of the boundary.
    pub(super) fn is_uniform_rim(&self, v: usize, ring: &[usize]) -> bool {
        if self.intervals.is_none() {
            return true;
        }
        let (topology, d) = (self.topology(), self.interval(ring[0]));
        let back = topology.rim(v)[1];
        let straight = T::int(3) * &d;
        let even = [false, true].iter().all(|far| *reach(topology, &self.reaches, back, *far) == straight);
        let corners = self.surface.boundary() == Boundary::Corners;
        even && self.is_uniform(ring) && self.rim_line(v, corners).iter().all(|along| *along == d)
    }

    /// Whether the intervals at a vertex inside vanish: then it never moves.
    pub(super) fn is_still(&self, ring: &[usize]) -> bool {
        ring.iter().all(|h| self.interval(*h).is_zero())
    }

    /// The knot intervals along both lines through a vertex inside of valence 4, the first from half-edge `ring[2]` to
    /// `ring[0]`, if the surface is a B-spline surface around it.
    pub(super) fn lines(&self, ring: &[usize]) -> Option<[Line<T>; 2]> {
        let &[east, north, west, south] = ring else { return None };
        if self.intervals.is_none() {
            return Some([(); 2].map(|()| [(); 4].map(|()| T::one())));
        }
        let topology = self.topology();
        let reach = |h: usize, far: bool| reach(topology, &self.reaches, h, far);
        // The edge `h` against the next ones on both sides.
        let parallel = |i: usize| {
            let (h, before) = (ring[i], ring[(i + 3) % 4]);
            let left = topology.next(topology.next(h));
            let right = topology.next(before);
            let (d, near, far) = (self.interval(h), reach(h, false), reach(h, true));
            self.interval(left) == d
                && self.interval(right) == d
                && [reach(left, true), reach(right, false)] == [near; 2]
                && [reach(left, false), reach(right, true)] == [far; 2]
        };
        if !(0..4).all(parallel) {
            return None;
        }
        let on = |h: usize| (reach(h, true).clone() - self.interval(h)) * T::frac(1, 2);
        let line = |from: usize, to: usize| [on(from), self.interval(from), self.interval(to), on(to)];
        Some([line(west, east), line(south, north)])
    }

    /// The knot intervals along the boundary through vertex `v`, which is mirrored at `corners`.
    pub(super) fn rim_line(&self, v: usize, corners: bool) -> Line<T> {
        let topology = self.topology();
        let [out, back] = topology.rim(v);
        let is_corner = |[out, back]: [usize; 2]| corners && topology.prev(out) == back;
        let on = |h: usize, end: usize, which: usize| {
            let rim = topology.rim(end);
            self.interval(if is_corner(rim) { h } else { rim[which] })
        };
        let (before, after) = (on(back, topology.origin(back), 1), on(out, topology.target(out), 0));
        [before, self.interval(back), self.interval(out), after]
    }
}

/// What `limit` finds at each vertex, refined around it until `limit` finds something, `steps` times at most, and less
/// over exact numbers. It is told when that was the last step.
pub(super) fn settle<T: Scalar, R, const N: usize>(
    surface: &CatmullClark<T, N>,
    steps: usize,
    limit: impl Fn(&Near<'_, T, N>, usize, bool) -> Option<R>,
) -> Result<Vec<R>> {
    let count = surface.mesh().topology().vertex_count();
    let mut found: Vec<Option<R>> = (0..count).map(|_| None).collect();
    // The vertices that are left, by their numbers in the part at hand and in the whole.
    let mut left: Vec<(usize, usize)> = (0..count).map(|v| (v, v)).collect();
    let mut part = None;
    let steps = if T::EXACT { EXACT_STEPS } else { steps };
    for step in 0..=steps {
        let near = Near::new(part.as_ref().unwrap_or(surface));
        left.retain(|(v, whole)| {
            found[*whole] = limit(&near, *v, step == steps);
            found[*whole].is_none()
        });
        if left.is_empty() || step == steps {
            break;
        }
        let topology = near.topology();
        let mut kept = vec![false; topology.face_count()];
        // A vertex in many faces comes once: its fan is walked every time.
        let mut reached = vec![false; topology.vertex_count()];
        let mut vertices: Vec<usize> = left.iter().map(|(v, _)| *v).collect();
        for _ in 0..3 {
            let mut next = Vec::new();
            for f in vertices.iter().flat_map(|v| topology.leaving(*v)).map(|h| topology.face_of(h)) {
                if !std::mem::replace(&mut kept[f], true) {
                    next.extend(topology.face(f).filter(|v| !std::mem::replace(&mut reached[*v], true)));
                }
            }
            vertices = next;
        }
        let (around, names) = near.surface.part(|f| kept[f]).expect("vertices have faces");
        let (finer, moved) = around.step()?;
        let place = |names: &[u32], v: usize| names.partition_point(|name| (*name as usize) < v);
        for (v, _) in &mut left {
            *v = place(&names, *v);
            *v = moved.as_ref().map_or(*v, |moved| place(moved, *v));
        }
        part = Some(finer);
    }
    match left.first() {
        Some((_, vertex)) => Err(MeshError::Unsettled { vertex: *vertex }.into()),
        None => Ok(found.into_iter().flatten().collect()),
    }
}
