//! A part of a mesh: some of its faces, with the vertices and edges that they have.
//!
//! Vertices and edges keep their order. Where faces that stay hang together in a vertex alone, the vertex is split: each
//! fan of them gets its own, so that the part is a manifold again.

use crate::mesh::topology::{NONE, Topology};

/// A part of a mesh, and where it comes from.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) topology: Topology,
    /// The old number of each vertex, ascending: twice if it was split.
    pub(super) vertices: Vec<u32>,
    /// The old number of each edge, ascending.
    pub(super) edges: Vec<u32>,
}

impl Topology {
    /// The faces that `keep` keeps; nothing if that is none.
    pub(super) fn part(&self, keep: impl Fn(usize) -> bool) -> Option<Part> {
        let mut part = Self {
            origins: Vec::new(),
            starts: vec![0],
            faces: Vec::new(),
            twins: Vec::new(),
            edges: Vec::new(),
            sides: Vec::new(),
            leaving: Vec::new(),
        };
        // The new number of each half-edge that stays.
        let mut places = vec![NONE; self.half_edge_count()];
        for f in (0..self.face_count()).filter(|f| keep(*f)) {
            for h in self.sides(f) {
                places[h] = part.faces.len() as u32;
                part.faces.push(part.starts.len() as u32 - 1);
            }
            part.starts.push(part.faces.len() as u32);
        }
        let count = part.faces.len();
        if count == 0 {
            return None;
        }
        part.origins = vec![NONE; count];
        part.twins = vec![NONE; count];
        part.edges = vec![NONE; count];
        let place = |h: Option<usize>| h.map_or(NONE, |h| places[h]);
        let (mut vertices, mut edges) = (Vec::new(), Vec::new());
        for e in 0..self.edge_count() {
            let side = self.side(e);
            let pair = [place(Some(side)), place(self.twin(side))];
            for (new, twin) in [(pair[0], pair[1]), (pair[1], pair[0])] {
                if new != NONE {
                    part.edges[new as usize] = edges.len() as u32;
                    part.twins[new as usize] = twin;
                }
            }
            if pair != [NONE; 2] {
                edges.push(e as u32);
            }
        }
        for v in 0..self.vertex_count() {
            for h in self.leaving(v) {
                let free = |h: &usize| places[*h] != NONE && part.origins[places[*h] as usize] == NONE;
                if !free(&h) {
                    continue;
                }
                // The fan of `h`, clockwise and counter-clockwise; a closed one comes around to itself.
                let back =
                    |g: &usize| self.twin(*g).map(|twin| self.next(twin)).filter(|g| free(g) && *g != h);
                let first = std::iter::successors(Some(h), back).last().unwrap_or(h);
                let new = vertices.len() as u32;
                vertices.push(v as u32);
                let mut at = Some(first);
                while let Some(g) = at {
                    part.origins[places[g] as usize] = new;
                    let free = |h: &usize| places[*h] != NONE && part.origins[places[*h] as usize] == NONE;
                    at = self.twin(self.prev(g)).filter(free);
                }
            }
        }
        part.sides = vec![NONE; edges.len()];
        part.leaving = vec![NONE; vertices.len()];
        part.lead();
        Some(Part { topology: part, vertices, edges })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A board of three by three squares.
    fn board() -> Topology {
        let corners = |f: usize| {
            let v = 4 * (f / 3) + f % 3;
            [v, v + 1, v + 5, v + 4]
        };
        Topology::new(16, (0..9).map(corners)).unwrap()
    }

    #[test]
    fn tables_are_those_of_the_faces_that_stay() {
        for kept in
            [vec![0, 1, 2, 3, 4, 5, 6, 7, 8], vec![1, 4], vec![0, 1, 2, 3, 5, 6, 7, 8], vec![3, 4, 6, 7, 2]]
        {
            let board = board();
            let part = board.part(|f| kept.contains(&f)).unwrap();
            let (t, faces) = (&part.topology, || (0..9).filter(|f| kept.contains(f)));
            let old: Vec<Vec<usize>> =
                t.faces().map(|face| face.iter().map(|v| part.vertices[*v] as usize).collect()).collect();
            assert_eq!(old, faces().map(|f| board.face(f).collect::<Vec<_>>()).collect::<Vec<_>>());
            let anew = Topology::new(t.vertex_count(), t.faces()).unwrap();
            assert_eq!((&t.twins, &t.starts, &t.faces), (&anew.twins, &anew.starts, &anew.faces));
            for e in 0..t.edge_count() {
                let ends = t.ends(e).map(|v| part.vertices[v] as usize);
                assert!(board.ends(part.edges[e] as usize).iter().all(|v| ends.contains(v)));
            }
            for v in 0..t.vertex_count() {
                assert_eq!((t.valence(v), t.is_boundary(v)), (anew.valence(v), anew.is_boundary(v)));
            }
        }
        assert!(board().part(|_| false).is_none());
    }

    #[test]
    fn where_faces_meet_in_a_vertex_alone_it_is_split() {
        let part = board().part(|f| f == 0 || f == 4).unwrap();
        assert_eq!(part.vertices, [0, 1, 4, 5, 5, 6, 9, 10]);
        assert_eq!(part.topology.edge_count(), 8);
        assert_eq!(part.topology.boundaries().len(), 2);
    }
}
