//! The topology of Doo and Sabin's subdivision: every face shrinks away from its neighbours, and edges and vertices become faces.
//!
//! Vertex `h` of the result is the corner of half-edge `h` of the old mesh. Its faces are
//!
//! - the old faces, with the old half-edges: half-edge `h` runs from vertex `h` to vertex `next(h)`;
//! - a four-sided face an inner edge, with the half-edges
//!   `next(h) → h`, `h → next(t)`, `next(t) → t`, `t → next(h)`, where `h` is the side of the edge and `t` its twin;
//! - a face an inner vertex, with the corners at that vertex, counter-clockwise.
//!
//! So the twins are known at once. A boundary vertex has a face where it has three or more faces around it and the boundary is to
//! be filled: its corners then border on the new boundary by one edge, as those of a vertex in two faces do.
//!
//! The edges of the result come in this order: those of the old faces (`h` for half-edge `h`), then two for each inner
//! edge: at the origin of its side, at the other end; then those that fill the boundary.

use crate::error::Result;
use crate::mesh::build::check_size;
use crate::mesh::topology::{NONE, Topology};

impl Topology {
    /// The topology after a step of Doo and Sabin's subdivision. Boundary vertices in three or more faces become faces if `filled`.
    pub(crate) fn shrunk(&self, filled: bool) -> Result<Self> {
        let half_edges = self.half_edge_count();
        let inner: Vec<usize> =
            (0..self.edge_count()).map(|e| self.side(e)).filter(|h| self.twins[*h] != NONE).collect();
        check_size(half_edges.saturating_mul(2).saturating_add(6 * inner.len()))?;
        // Where the face of an edge has its half-edges.
        let mut ranks = vec![NONE; self.edge_count()];
        let base = |rank: usize| half_edges + 4 * rank;
        inner.iter().enumerate().for_each(|(rank, h)| ranks[self.edge_of(*h)] = rank as u32);
        // The edge and the half-edge `h → next(twin h)`.
        let across = |h: usize| {
            let e = self.edge_of(h);
            let far = usize::from(self.side(e) != h);
            let rank = ranks[e] as usize;
            (half_edges + 2 * rank + far, base(rank) + 2 * far + 1)
        };

        let mut fine = Self {
            origins: (0..half_edges as u32).collect(),
            starts: self.starts.clone(),
            faces: self.faces.clone(),
            twins: vec![NONE; half_edges],
            edges: (0..half_edges as u32).collect(),
            sides: Vec::new(),
            leaving: vec![NONE; half_edges],
        };
        let reserve = 8 * inner.len();
        fine.origins.reserve(reserve);
        fine.twins.reserve(reserve);
        fine.edges.reserve(reserve);
        fine.faces.reserve(reserve);
        for (rank, &h) in inner.iter().enumerate() {
            let t = self.twins[h] as usize;
            let corners = [self.next(h), h, self.next(t), t].map(|corner| corner as u32);
            fine.twins[h] = base(rank) as u32;
            fine.twins[t] = base(rank) as u32 + 2;
            let along = [half_edges + 2 * rank, half_edges + 2 * rank + 1].map(|e| e as u32);
            fine.push(&corners, &[h as u32, NONE, t as u32, NONE], &[h as u32, along[0], t as u32, along[1]]);
        }
        let mut edge_count = half_edges + 2 * inner.len();
        let (mut corners, mut twins, mut edges) = (Vec::new(), Vec::new(), Vec::new());
        for v in 0..self.vertex_count() {
            let boundary = self.is_boundary(v);
            if boundary && !(filled && self.leaving(v).nth(2).is_some()) {
                continue;
            }
            corners.clear();
            corners.extend(self.leaving(v).map(|h| h as u32));
            twins.clear();
            edges.clear();
            let first = fine.origins.len();
            // From each corner on, counter-clockwise: the edge there is that of the next corner's half-edge.
            for (k, _) in corners.iter().enumerate() {
                let ahead = corners[(k + 1) % corners.len()] as usize;
                if self.twins[ahead] == NONE {
                    twins.push(NONE);
                    edges.push(edge_count as u32);
                    edge_count += 1;
                } else {
                    let (edge, twin) = across(ahead);
                    twins.push(twin as u32);
                    edges.push(edge as u32);
                    fine.twins[twin] = (first + k) as u32;
                }
            }
            fine.push(&corners, &twins, &edges);
        }
        fine.sides = vec![NONE; edge_count];
        fine.lead();
        Ok(fine)
    }

    /// Adds a face.
    fn push(&mut self, corners: &[u32], twins: &[u32], edges: &[u32]) {
        let face = self.face_count() as u32;
        self.origins.extend_from_slice(corners);
        self.twins.extend_from_slice(twins);
        self.edges.extend_from_slice(edges);
        self.faces.extend(corners.iter().map(|_| face));
        self.starts.push(self.origins.len() as u32);
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::topology::Topology;

    #[test]
    fn tables_are_those_of_the_faces() {
        let faces: [&[usize]; 4] = [&[0, 1, 4, 2], &[0, 2, 5, 3], &[0, 3, 6, 1], &[4, 1, 7]];
        let open = Topology::new(8, faces).unwrap();
        let tetrahedron = Topology::new(4, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]).unwrap();
        for coarse in [open, tetrahedron] {
            for filled in [false, true] {
                let fine = coarse.shrunk(filled).unwrap();
                let anew = Topology::new(fine.vertex_count(), fine.faces()).unwrap();
                assert_eq!(
                    (&fine.twins, &fine.starts, &fine.faces),
                    (&anew.twins, &anew.starts, &anew.faces)
                );
                assert_eq!(fine.edge_count(), anew.edge_count());
                for h in 0..fine.half_edge_count() {
                    assert_eq!(fine.side(fine.edge_of(h)), h.min(fine.twin(h).unwrap_or(h)));
                }
                (0..fine.vertex_count()).for_each(|v| assert_eq!(fine.is_boundary(v), anew.is_boundary(v)));
                assert_eq!(fine.euler_characteristic(), coarse.euler_characteristic());
            }
        }
    }

    #[test]
    fn boundary_vertices_in_three_faces_are_filled_if_asked_for() {
        // An L of three squares, with vertex 4 at its inner corner.
        let faces = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6]];
        let coarse = Topology::new(8, faces).unwrap();
        let counts =
            |filled| coarse.shrunk(filled).map(|fine| (fine.face_count(), fine.boundaries()[0].len()));
        // Eight sides, and the edges of the faces between them: one at two vertices, and two or one at vertex 4.
        assert_eq!(counts(false), Ok((5, 12)));
        assert_eq!(counts(true), Ok((6, 11)));
    }
}
