//! An order of elimination that keeps factors sparse: nested dissection [George].
//!
//! A few nodes whose removal parts a graph in two come last, before them the two parts, each in such an order. The parting nodes
//! are a level of a walk in breadth from a node at the rim: on a mesh of `n` nodes about `√n` of them.

/// Parts of this size are left as they are.
const LEAF: usize = 12;

/// The neighbours of each node.
#[derive(Clone, Debug)]
pub(super) struct Graph {
    starts: Vec<usize>,
    neighbours: Vec<usize>,
}

impl Graph {
    /// The graph of these pairs, in which a pair may stand several times, either way round.
    pub(super) fn of(count: usize, pairs: impl Iterator<Item = [usize; 2]>) -> Self {
        let mut ways: Vec<[usize; 2]> =
            pairs.flat_map(|[a, b]| [[a, b], [b, a]]).filter(|[a, b]| a != b).collect();
        ways.sort_unstable();
        ways.dedup();
        let mut starts = vec![0; count + 1];
        ways.iter().for_each(|[a, _]| starts[a + 1] += 1);
        (0..count).for_each(|i| starts[i + 1] += starts[i]);
        Self { starts, neighbours: ways.into_iter().map(|[_, b]| b).collect() }
    }

    pub(super) fn count(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn at(&self, node: usize) -> &[usize] {
        &self.neighbours[self.starts[node]..self.starts[node + 1]]
    }
}

/// A walk in breadth through a part of the graph.
struct Walk {
    nodes: Vec<usize>,
    /// Where each level begins, and where the last one ends.
    levels: Vec<usize>,
}

/// The parts so far: nodes of one part have one mark.
struct Parts<'a> {
    graph: &'a Graph,
    marks: Vec<usize>,
    last: usize,
}

impl Parts<'_> {
    /// Walks from a node through its part, all of whose nodes that it comes to get a new mark.
    fn walk(&mut self, from: usize) -> Walk {
        let old = self.marks[from];
        self.last += 1;
        let (mut nodes, mut levels) = (vec![from], vec![0]);
        self.marks[from] = self.last;
        while levels.last() != Some(&nodes.len()) {
            let start = levels[levels.len() - 1];
            levels.push(nodes.len());
            for k in start..levels[levels.len() - 1] {
                for &next in self.graph.at(nodes[k]) {
                    if self.marks[next] == old {
                        self.marks[next] = self.last;
                        nodes.push(next);
                    }
                }
            }
        }
        Walk { nodes, levels }
    }
}

/// The nodes in an order in which to eliminate them.
pub(super) fn dissected(graph: &Graph) -> Vec<usize> {
    let mut order = vec![0; graph.count()];
    let mut parts = Parts { graph, marks: vec![0; graph.count()], last: 0 };
    // Parts, and where in the order each ends.
    let mut stack = vec![((0..graph.count()).collect::<Vec<_>>(), graph.count())];
    while let Some((nodes, end)) = stack.pop() {
        if nodes.len() <= LEAF {
            order[end - nodes.len()..end].copy_from_slice(&nodes);
            continue;
        }
        let old = parts.marks[nodes[0]];
        // From the far end of a walk the levels are many and small.
        let rim = parts.walk(nodes[0]);
        let walk = parts.walk(rim.nodes[rim.nodes.len() - 1]);
        if walk.nodes.len() < nodes.len() {
            // In pieces: all of them at once, each with a mark of its own.
            let mut seam = end - walk.nodes.len();
            stack.push((walk.nodes, end));
            for node in nodes {
                if parts.marks[node] == old {
                    let piece = parts.walk(node).nodes;
                    let start = seam - piece.len();
                    stack.push((piece, seam));
                    seam = start;
                }
            }
            continue;
        }
        let depth = walk.levels.len() - 1;
        if depth < 3 {
            order[end - nodes.len()..end].copy_from_slice(&nodes);
            continue;
        }
        let middle = walk.levels.partition_point(|start| 2 * start <= nodes.len()).clamp(2, depth - 1) - 1;
        let (low, high) = (walk.levels[middle], walk.levels[middle + 1]);
        let above = walk.nodes[high..].to_vec();
        parts.last += 1;
        above.iter().for_each(|node| parts.marks[*node] = parts.last);
        let beside = |node: &usize| graph.at(*node).iter().any(|next| parts.marks[*next] == parts.last);
        let (between, inner): (Vec<usize>, Vec<usize>) =
            walk.nodes[low..high].iter().copied().partition(beside);
        let below: Vec<usize> = walk.nodes[..low].iter().copied().chain(inner).collect();
        let seam = end - between.len();
        order[seam..end].copy_from_slice(&between);
        between.iter().for_each(|node| parts.marks[*node] = usize::MAX);
        let start = seam - above.len();
        stack.extend([(above, seam), (below, start)]);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(m: usize, n: usize) -> Graph {
        let along = (0..m * n).filter(move |k| (k + 1) % m != 0).map(|k| [k, k + 1]);
        Graph::of(m * n, along.chain((m..m * n).map(move |k| [k - m, k])))
    }

    /// How many entries elimination in an order has below the diagonal.
    fn entries(graph: &Graph, order: &[usize]) -> usize {
        let n = graph.count();
        let mut rank = vec![0; n];
        order.iter().enumerate().for_each(|(k, node)| rank[*node] = k);
        let mut rows = vec![std::collections::BTreeSet::new(); n];
        for node in 0..n {
            rows[rank[node]].extend(graph.at(node).iter().map(|b| rank[*b]).filter(|b| *b > rank[node]));
        }
        for k in 0..n {
            let row = rows[k].clone();
            if let Some(first) = row.first() {
                rows[*first].extend(row.iter().copied().filter(|b| b != first));
            }
        }
        rows.iter().map(std::collections::BTreeSet::len).sum()
    }

    #[test]
    fn each_node_comes_once_and_factors_of_grids_are_sparse() {
        let square = grid(40, 40);
        let order = dissected(&square);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..1600));
        // In natural order each row has forty entries.
        let [natural, dissected] =
            [(0..1600).collect(), order].map(|order: Vec<usize>| entries(&square, &order));
        assert!(natural > 60_000 && 2 * dissected < natural, "{natural} {dissected}");
    }

    /// One after the other, each looking through all that is left, they would take minutes.
    #[test]
    fn many_pieces_take_linear_time() {
        let count = 400_000;
        let mut order = dissected(&Graph::of(count, (0..count).step_by(2).map(|k| [k, k + 1])));
        order.sort_unstable();
        assert!(order.into_iter().eq(0..count));
    }

    #[test]
    fn graphs_in_pieces_and_stars_are_ordered_too() {
        let pieces = Graph::of(100, (0..98).filter(|k| k % 33 != 0).map(|k| [k, k + 1]));
        let star = Graph::of(100, (1..100).map(|k| [0, k]));
        for graph in [pieces, star, Graph::of(0, std::iter::empty()), Graph::of(40, std::iter::empty())] {
            let mut order = dissected(&graph);
            order.sort_unstable();
            assert!(order.into_iter().eq(0..graph.count()));
        }
    }
}
