//! Loops of edges: at each vertex on by the opposite edge.
//!
//! Of the four edges at an inner vertex two are opposite to two:
//!
//! ```text
//!            e_1
//!             |
//!     e_2 ─── v ─── e_0          e_0 and e_2, e_1 and e_3 go on in each other
//!             |
//!            e_3
//! ```
//! At the boundary the boundary goes on along itself, and edges from inside end. So each edge is in one loop and one alone [Miura,
//! 4.4].

use crate::error::Result;
use crate::error::mesh::MeshError;
use crate::mesh::topology::Topology;
use std::ops::Range;

/// The edges of a mesh in loops, closed or from boundary to boundary, each of which runs straight through its vertices.
///
/// # Examples
/// ```
/// use symspline::{EdgeLoops, Topology};
/// // Two squares side by side: the boundary, and the edge between them.
/// let loops = EdgeLoops::new(&Topology::new(6, [[0, 1, 4, 3], [1, 2, 5, 4]])?)?;
/// let lengths: Vec<usize> = (0..loops.count()).map(|i| loops.edges(i).len()).collect();
/// assert_eq!((lengths, loops.is_closed(0), loops.is_closed(1)), (vec![1, 6], false, true));
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeLoops {
    /// The edges, loop by loop.
    edges: Vec<usize>,
    /// Where the loop comes from into each of the edges.
    vertices: Vec<usize>,
    /// Where each loop begins among them, and where the last one ends.
    starts: Vec<usize>,
    closed: Vec<bool>,
    /// The loop of each edge.
    owners: Vec<usize>,
}

/// The edge is in no loop yet, or goes on in none.
const NONE: usize = usize::MAX;

impl EdgeLoops {
    /// The loops of a mesh: first those with ends, then the closed ones, each from its first edge on.
    ///
    /// # Errors
    /// [`MeshError::NoOppositeEdges`] for an inner vertex without four edges.
    pub fn new(topology: &Topology) -> Result<Self> {
        let four = |v: &usize| topology.is_boundary(*v) || topology.valence(*v) == 4;
        if let Some(vertex) = (0..topology.vertex_count()).find(|v| !four(v)) {
            return Err(MeshError::NoOppositeEdges { vertex, edges: topology.valence(vertex) }.into());
        }
        let count = topology.edge_count();
        let mut loops = Self {
            edges: Vec::with_capacity(count),
            vertices: Vec::with_capacity(count),
            starts: vec![0],
            closed: Vec::new(),
            owners: vec![NONE; count],
        };
        let onward = onward(topology);
        for e in 0..count {
            if let Some(end) = onward[e].iter().position(|next| *next == NONE) {
                loops.walk(topology, &onward, topology.ends(e)[end], e);
            }
        }
        for e in 0..count {
            loops.walk(topology, &onward, topology.ends(e)[0], e);
        }
        Ok(loops)
    }

    /// Adds the loop that goes from vertex `v` into edge `e`, unless it is there.
    fn walk(&mut self, topology: &Topology, onward: &[[usize; 2]], mut v: usize, mut e: usize) {
        if self.owners[e] != NONE {
            return;
        }
        let closed = loop {
            self.owners[e] = self.closed.len();
            self.edges.push(e);
            self.vertices.push(v);
            let ends = topology.ends(e);
            let end = usize::from(v == ends[0]);
            v = ends[end];
            match onward[e][end] {
                NONE => break false,
                next if self.owners[next] != NONE => break true,
                next => e = next,
            }
        };
        self.closed.push(closed);
        self.starts.push(self.edges.len());
    }

    /// How many loops there are.
    pub fn count(&self) -> usize {
        self.closed.len()
    }

    fn range(&self, i: usize) -> Range<usize> {
        self.starts[i]..self.starts[i + 1]
    }

    /// The edges of loop `i`, one after the other.
    ///
    /// # Panics
    /// If there is no loop `i`; so do the next two.
    pub fn edges(&self, i: usize) -> &[usize] {
        &self.edges[self.range(i)]
    }

    /// The vertices from which loop `i` goes into its edges.
    pub fn vertices(&self, i: usize) -> &[usize] {
        &self.vertices[self.range(i)]
    }

    /// Whether loop `i` comes back to its first edge.
    pub fn is_closed(&self, i: usize) -> bool {
        self.closed[i]
    }

    /// The loop of edge `e`.
    ///
    /// # Panics
    /// If there is no edge `e`.
    pub fn loop_of(&self, e: usize) -> usize {
        self.owners[e]
    }
}

/// The edges in which each edge goes on at its two ends.
fn onward(topology: &Topology) -> Vec<[usize; 2]> {
    let mut onward = vec![[NONE; 2]; topology.edge_count()];
    let mut edges = Vec::new();
    for v in 0..topology.vertex_count() {
        edges.clear();
        edges.extend(topology.edges_at(v));
        for pair in straight(edges.len(), topology.is_boundary(v)).into_iter().flatten() {
            let [a, b] = pair.map(|rank| edges[rank]);
            for (e, next) in [(a, b), (b, a)] {
                onward[e][usize::from(topology.ends(e)[0] != v)] = next;
            }
        }
    }
    onward
}

/// Which of the edges counted around a vertex go on in which.
pub(crate) fn straight(edges: usize, boundary: bool) -> [Option<[usize; 2]>; 2] {
    if boundary { [Some([0, edges - 1]), None] } else { [Some([0, 2]), Some([1, 3])] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;

    #[test]
    fn each_edge_is_in_one_loop_that_goes_on_where_it_ends() {
        let l = Topology::new(8, [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6]]).unwrap();
        let tetrahedron = Topology::new(4, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]).unwrap();
        for topology in [l.shrunk(true).unwrap(), l.shrunk(false).unwrap(), tetrahedron.shrunk(true).unwrap()]
        {
            let loops = EdgeLoops::new(&topology).unwrap();
            let onward = onward(&topology);
            let ends_at = |v: usize, e: usize| {
                onward[e][topology.ends(e).iter().position(|end| *end == v).unwrap()] == NONE
            };
            let mut seen: Vec<usize> = (0..loops.count()).flat_map(|i| loops.edges(i)).copied().collect();
            seen.sort_unstable();
            assert!(seen.into_iter().eq(0..topology.edge_count()));
            for i in 0..loops.count() {
                let (edges, vertices) = (loops.edges(i), loops.vertices(i));
                for k in 0..edges.len() {
                    assert!(topology.ends(edges[k]).contains(&vertices[k]) && loops.loop_of(edges[k]) == i);
                    let after = vertices.get(k + 1).or(loops.is_closed(i).then_some(&vertices[0]));
                    assert!(after.is_none_or(|v| topology.ends(edges[k]).contains(v) && *v != vertices[k]));
                }
                if !loops.is_closed(i) {
                    let last = *edges.last().unwrap();
                    assert!(topology.ends(last).into_iter().any(|v| ends_at(v, last)));
                    assert!(ends_at(vertices[0], edges[0]));
                }
            }
        }
    }

    #[test]
    fn the_boundary_is_a_loop() {
        let l = Topology::new(8, [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6]]).unwrap();
        for filled in [true, false] {
            let fine = l.shrunk(filled).unwrap();
            let loops = EdgeLoops::new(&fine).unwrap();
            let boundary: Vec<usize> = fine.boundaries()[0].iter().map(|h| fine.edge_of(*h)).collect();
            let i = loops.loop_of(boundary[0]);
            assert!(loops.is_closed(i) && loops.edges(i).len() == boundary.len());
            assert!(boundary.iter().all(|e| loops.loop_of(*e) == i));
        }
    }

    /// Looked for around the vertex edge by edge, the loops would take minutes.
    #[test]
    fn large_fans_take_linear_time() {
        let k = 100_000;
        let fan = Topology::new(k + 2, (1..=k).map(|i| [0, i, i + 1])).unwrap();
        assert_eq!(EdgeLoops::new(&fan).unwrap().count(), k);
    }

    #[test]
    fn other_vertices_have_no_opposite_edges() {
        let tetrahedron = Topology::new(4, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]).unwrap();
        let refused = Error::from(MeshError::NoOppositeEdges { vertex: 0, edges: 3 });
        assert_eq!(EdgeLoops::new(&tetrahedron), Err(refused));
    }
}
