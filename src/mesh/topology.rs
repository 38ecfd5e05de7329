//! Which faces of a mesh meet where: half-edges in flat tables.
//!
//! A half-edge is a side of a face, run through counter-clockwise: from its origin `v` to the origin of the next one. The half-edges of a
//! face follow each other, face by face, so that half-edge `h` is also a corner of its face:
//!
//! ```text
//!        v ──────── h ───────▶ w          face(h) is on the left
//!          ◀────  twin(h)  ────           twin(h) is in the face on the right, if there is one
//! ```
//! An edge is a half-edge and its twin, or a half-edge alone at the boundary. Everything is an index: vertices, half-edges, edges and
//! faces are counted from 0.
//!
//! All faces at a vertex make one fan: around it inside, from boundary to boundary at the boundary. Each step around a vertex or a face
//! takes constant time.

use std::collections::BTreeSet;
use std::ops::Range;

/// No half-edge.
pub(super) const NONE: u32 = u32::MAX;

/// How the faces of an oriented manifold, closed or with a boundary, hang together.
///
/// # Examples
/// ```
/// use symspline::Topology;
/// // Two triangles, and a square on the other side of one of them.
/// let faces: [&[usize]; 3] = [&[0, 1, 2], &[2, 1, 3], &[0, 2, 4, 5]];
/// let topology = Topology::new(6, faces)?;
/// assert_eq!((topology.edge_count(), topology.euler_characteristic()), (8, 1));
/// assert!(topology.is_boundary(0) && !topology.is_closed());
/// assert_eq!(topology.face(2).collect::<Vec<_>>(), [0, 2, 4, 5]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Topology {
    /// The origin of each half-edge.
    pub(super) origins: Vec<u32>,
    /// Where each face begins among the half-edges, and where the last one ends.
    pub(super) starts: Vec<u32>,
    /// The face of each half-edge.
    pub(super) faces: Vec<u32>,
    pub(super) twins: Vec<u32>,
    /// The edge of each half-edge.
    pub(super) edges: Vec<u32>,
    /// A half-edge of each edge.
    pub(super) sides: Vec<u32>,
    /// A half-edge out of each vertex: at the boundary the one without a twin.
    pub(super) leaving: Vec<u32>,
}

impl Topology {
    /// How many vertices there are.
    pub fn vertex_count(&self) -> usize {
        self.leaving.len()
    }

    /// How many edges there are.
    pub fn edge_count(&self) -> usize {
        self.sides.len()
    }

    /// How many faces there are.
    pub fn face_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// How many half-edges there are: as many as corners of faces.
    pub fn half_edge_count(&self) -> usize {
        self.origins.len()
    }

    /// Vertices less edges plus faces.
    pub fn euler_characteristic(&self) -> isize {
        self.vertex_count() as isize - self.edge_count() as isize + self.face_count() as isize
    }

    /// Whether there is no boundary.
    pub fn is_closed(&self) -> bool {
        self.twins.iter().all(|twin| *twin != NONE)
    }

    /// The half-edges of face `f`.
    ///
    /// # Panics
    /// If there is no face `f`.
    pub fn sides(&self, f: usize) -> Range<usize> {
        self.starts[f] as usize..self.starts[f + 1] as usize
    }

    /// The vertices of face `f`, counter-clockwise.
    ///
    /// # Panics
    /// If there is no face `f`.
    pub fn face(&self, f: usize) -> impl ExactSizeIterator<Item = usize> + Clone + '_ {
        self.origins[self.sides(f)].iter().map(|v| *v as usize)
    }

    /// The vertices of all faces.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = Vec<usize>> + '_ {
        (0..self.face_count()).map(|f| self.face(f).collect())
    }

    /// Where half-edge `h` begins.
    ///
    /// # Panics
    /// If there is no half-edge `h`; so do all that follow.
    pub fn origin(&self, h: usize) -> usize {
        self.origins[h] as usize
    }

    /// Where half-edge `h` ends.
    pub fn target(&self, h: usize) -> usize {
        self.origin(self.next(h))
    }

    /// The face on the left of half-edge `h`.
    pub fn face_of(&self, h: usize) -> usize {
        self.faces[h] as usize
    }

    /// The next half-edge around the face of `h`, counter-clockwise.
    #[inline]
    pub fn next(&self, h: usize) -> usize {
        let f = self.face_of(h);
        if h + 1 == self.starts[f + 1] as usize { self.starts[f] as usize } else { h + 1 }
    }

    /// The half-edge before `h` around its face.
    #[inline]
    pub fn prev(&self, h: usize) -> usize {
        let f = self.face_of(h);
        if h == self.starts[f] as usize { self.starts[f + 1] as usize - 1 } else { h - 1 }
    }

    /// The half-edge of the same edge in the other face; none at the boundary.
    #[inline]
    pub fn twin(&self, h: usize) -> Option<usize> {
        match self.twins[h] {
            NONE => None,
            twin => Some(twin as usize),
        }
    }

    /// The edge of half-edge `h`.
    #[inline]
    pub fn edge_of(&self, h: usize) -> usize {
        self.edges[h] as usize
    }

    /// A half-edge of edge `e`: of its two the lower.
    pub fn side(&self, e: usize) -> usize {
        self.sides[e] as usize
    }

    /// The two ends of edge `e`.
    pub fn ends(&self, e: usize) -> [usize; 2] {
        let h = self.side(e);
        [self.origin(h), self.target(h)]
    }

    /// The ends of all edges.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = [usize; 2]> + '_ {
        (0..self.edge_count()).map(|e| self.ends(e))
    }

    /// Whether edge `e` is in one face alone.
    pub fn is_boundary_edge(&self, e: usize) -> bool {
        self.twins[self.side(e)] == NONE
    }

    /// Whether vertex `v` is at the boundary.
    pub fn is_boundary(&self, v: usize) -> bool {
        self.twins[self.leaving[v] as usize] == NONE
    }

    /// The half-edges out of vertex `v`, one a face, counter-clockwise: at the boundary from the first face to the last.
    pub fn leaving(&self, v: usize) -> impl Iterator<Item = usize> + Clone + '_ {
        let first = self.leaving[v] as usize;
        let turn = move |h: &usize| self.twin(self.prev(*h)).filter(|next| *next != first);
        std::iter::successors(Some(first), turn)
    }

    /// The edges at vertex `v`, counter-clockwise: at the boundary one more than there are faces.
    pub fn edges_at(&self, v: usize) -> impl Iterator<Item = usize> + Clone + '_ {
        let last = self.leaving(v).last().map(|h| self.prev(h)).filter(|_| self.is_boundary(v));
        self.leaving(v).chain(last).map(|h| self.edge_of(h))
    }

    /// How many edges there are at vertex `v`.
    pub fn valence(&self, v: usize) -> usize {
        self.leaving(v).count() + usize::from(self.is_boundary(v))
    }

    /// The edge between two vertices, if there is one.
    pub fn edge_between(&self, v: usize, w: usize) -> Option<usize> {
        self.edges_at(v).find(|e| v != w && self.ends(*e).contains(&w))
    }

    /// The boundaries: each a chain of half-edges, one after the other, with the surface on the left.
    pub fn boundaries(&self) -> Vec<Vec<usize>> {
        let mut left: BTreeSet<usize> =
            (0..self.half_edge_count()).filter(|h| self.twin(*h).is_none()).collect();
        let mut loops = Vec::new();
        while let Some(&first) = left.first() {
            let onward = |h: &usize| {
                let next = self.leaving[self.target(*h)] as usize;
                (next != first).then_some(next)
            };
            let chain: Vec<usize> = std::iter::successors(Some(first), onward).collect();
            chain.iter().for_each(|h| {
                left.remove(h);
            });
            loops.push(chain);
        }
        loops
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three squares around a vertex, and a triangle.
    fn corner() -> Topology {
        let faces: [&[usize]; 4] = [&[0, 1, 4, 2], &[0, 2, 5, 3], &[0, 3, 6, 1], &[4, 1, 7]];
        Topology::new(8, faces).unwrap()
    }

    #[test]
    fn walks_around_vertices_are_counter_clockwise() {
        let t = corner();
        let around = |v: usize| t.leaving(v).map(|h| t.target(h)).collect::<Vec<_>>();
        let mut inside = around(0);
        let first = inside.iter().position(|v| *v == 1).unwrap();
        inside.rotate_left(first);
        assert_eq!(inside, [1, 2, 3]);
        // At the boundary from the edge that leaves along it.
        assert_eq!(around(1), [7, 4, 0]);
        assert_eq!(t.edges_at(1).map(|e| t.ends(e)).collect::<Vec<_>>(), [[1, 7], [1, 4], [0, 1], [6, 1]]);
        assert_eq!((t.valence(0), t.valence(1), t.valence(7)), (3, 4, 2));
        assert!(t.is_boundary(1) && !t.is_boundary(0));
    }

    #[test]
    fn boundaries_run_with_the_surface_on_their_left() {
        let t = corner();
        let chains = t.boundaries();
        assert_eq!(chains.len(), 1);
        let vertices: Vec<usize> = chains[0].iter().map(|h| t.origin(*h)).collect();
        assert_eq!(vertices, [4, 2, 5, 3, 6, 1, 7]);
        assert_eq!(t.euler_characteristic(), 1);
    }

    #[test]
    fn half_edges_fit_together() {
        let t = corner();
        for h in 0..t.half_edge_count() {
            assert_eq!((t.next(t.prev(h)), t.prev(t.next(h))), (h, h));
            assert!(t.sides(t.face_of(h)).contains(&h));
            if let Some(twin) = t.twin(h) {
                assert_eq!(
                    (t.twin(twin), t.origin(twin), t.edge_of(twin)),
                    (Some(h), t.target(h), t.edge_of(h))
                );
            }
        }
        assert_eq!(t.edge_between(0, 2), t.edge_between(2, 0));
        assert_eq!((t.edge_between(0, 7), t.edge_between(0, 0)), (None, None));
    }
}
