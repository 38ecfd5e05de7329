//! The topology of Catmull and Clark's subdivision: every face is cut into one four-sided face a corner.
//!
//! Vertices of the result are the old ones, then a point an edge, then a point a face. Half-edge `h` of the old mesh, from `v`
//! in face `f`, becomes the face `h`, with the half-edges
//!
//! ```text
//! 4h:  v → edge(h)    4h+1:  edge(h) → f    4h+2:  f → edge(prev h)    4h+3:  edge(prev h) → v
//! ```
//! so that all twins are known at once: those of `4h` and `4h+1` are `4 next(twin h) + 3` and `4 next(h) + 2`.
//! Edges of the result are the halves of the old edges, `2e` and `2e + 1`, the first at the origin of the edge's side, and then one a
//! half-edge, from its middle into the face.

use crate::error::Result;
use crate::mesh::build::check_size;
use crate::mesh::topology::{NONE, Topology};

impl Topology {
    /// The topology after a step of Catmull and Clark's subdivision.
    pub(crate) fn quartered(&self) -> Result<Self> {
        let (vertices, edges, half_edges) = (self.vertex_count(), self.edge_count(), self.half_edge_count());
        check_size(half_edges.saturating_mul(4))?;
        let mut fine = Self {
            origins: Vec::with_capacity(4 * half_edges),
            starts: (0..=half_edges as u32).map(|f| 4 * f).collect(),
            faces: (0..4 * half_edges as u32).map(|h| h / 4).collect(),
            twins: Vec::with_capacity(4 * half_edges),
            edges: Vec::with_capacity(4 * half_edges),
            sides: vec![NONE; 2 * edges + half_edges],
            leaving: vec![NONE; vertices + edges + self.face_count()],
        };
        let half = |h: usize, far: bool| {
            let e = self.edge_of(h);
            2 * e as u32 + u32::from((self.side(e) == h) == far)
        };
        for f in 0..self.face_count() {
            let centre = (vertices + edges + f) as u32;
            let sides = self.sides(f);
            for h in sides.clone() {
                let next = if h + 1 == sides.end { sides.start } else { h + 1 };
                let prev = if h == sides.start { sides.end - 1 } else { h - 1 };
                let middle = |h: usize| vertices as u32 + self.edges[h];
                fine.origins.extend([self.origins[h], middle(h), centre, middle(prev)]);
                let ahead = self.twin(h).map_or(NONE, |twin| 4 * self.next(twin) as u32 + 3);
                let behind = self.twin(prev).map_or(NONE, |twin| 4 * twin as u32);
                fine.twins.extend([ahead, 4 * next as u32 + 2, 4 * prev as u32 + 1, behind]);
                let into = |h: usize| (2 * edges + h) as u32;
                fine.edges.extend([half(h, false), into(h), into(prev), half(prev, true)]);
            }
        }
        fine.lead();
        Ok(fine)
    }

    /// Fills in the sides of edges, and the half-edges that lead at each vertex.
    pub(super) fn lead(&mut self) {
        for h in (0..self.origins.len()).rev() {
            self.sides[self.edges[h] as usize] = h as u32;
            let leading = &mut self.leaving[self.origins[h] as usize];
            if *leading == NONE || self.twins[*leading as usize] != NONE {
                *leading = h as u32;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::topology::Topology;

    /// Refined by the rule, and anew from its faces.
    #[test]
    fn tables_are_those_of_the_faces() {
        let faces: [&[usize]; 4] = [&[0, 1, 4, 2], &[0, 2, 5, 3], &[0, 3, 6, 1], &[4, 1, 7]];
        let coarse = Topology::new(8, faces).unwrap();
        let fine = coarse.quartered().unwrap();
        let anew = Topology::new(fine.vertex_count(), fine.faces()).unwrap();
        assert_eq!((&fine.twins, &fine.starts, &fine.faces), (&anew.twins, &anew.starts, &anew.faces));
        for v in 0..fine.vertex_count() {
            let ring = |t: &Topology| {
                let mut ends: Vec<_> = t.edges_at(v).map(|e| t.ends(e)).collect();
                if !t.is_boundary(v) {
                    let least = (0..ends.len()).min_by_key(|k| ends[*k]).unwrap();
                    ends.rotate_left(least);
                }
                ends
            };
            assert_eq!(ring(&fine), ring(&anew));
        }
        assert_eq!(fine.euler_characteristic(), coarse.euler_characteristic());
        for e in 0..coarse.edge_count() {
            let middle = coarse.vertex_count() + e;
            let [v, w] = coarse.ends(e);
            assert_eq!([fine.ends(2 * e), fine.ends(2 * e + 1)].map(|ends| ends.contains(&v)), [true, false]);
            assert!(fine.ends(2 * e + 1).contains(&w) && fine.ends(2 * e).contains(&middle));
        }
    }
}
