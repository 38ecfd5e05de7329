//! A tree of boxes over pieces.

use nalgebra::SVector;

/// A box around some pieces.
#[derive(Clone, Debug)]
pub(super) struct Node<const N: usize> {
    low: SVector<f64, N>,
    high: SVector<f64, N>,
    /// Of a leaf the piece, else the first of two neighbours.
    pub(super) next: u32,
    pub(super) is_leaf: bool,
}

impl<const N: usize> Node<N> {
    /// The squared distance of the box from a point.
    #[inline]
    pub(super) fn squared_distance(&self, point: &SVector<f64, N>) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            let out = (self.low[i] - point[i]).max(point[i] - self.high[i]).max(0.0);
            sum += out * out;
        }
        sum
    }
}

/// The tree; the first node is the root.
#[derive(Clone, Debug)]
pub(super) struct Tree<const N: usize> {
    pub(super) nodes: Vec<Node<N>>,
}

impl<const N: usize> Tree<N> {
    /// The tree over boxes `(low, high)`, one a piece, of which there is at least one.
    pub(super) fn new(boxes: &[(SVector<f64, N>, SVector<f64, N>)]) -> Self {
        let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
        let mut nodes = vec![hull_of(boxes, &order)];
        let mut open = vec![(0_usize, 0..order.len())];
        while let Some((node, range)) = open.pop() {
            let own = &mut order[range.clone()];
            if let [piece] = own {
                (nodes[node].next, nodes[node].is_leaf) = (*piece, true);
                continue;
            }
            let extent = nodes[node].high - nodes[node].low;
            let axis = if N == 0 { 0 } else { extent.imax() };
            let centre = |piece: &u32| {
                let (low, high) = &boxes[*piece as usize];
                low.iter().nth(axis).zip(high.iter().nth(axis)).map_or(0.0, |(a, b)| a + b)
            };
            let half = own.len() / 2;
            own.select_nth_unstable_by(half, |a, b| centre(a).total_cmp(&centre(b)));
            nodes[node].next = nodes.len() as u32;
            for part in [range.start..range.start + half, range.start + half..range.end] {
                open.push((nodes.len(), part.clone()));
                nodes.push(hull_of(boxes, &order[part]));
            }
        }
        Self { nodes }
    }
}

fn hull_of<const N: usize>(boxes: &[(SVector<f64, N>, SVector<f64, N>)], pieces: &[u32]) -> Node<N> {
    let own = pieces.iter().map(|piece| boxes[*piece as usize]);
    let both = |a: (SVector<f64, N>, SVector<f64, N>), b: (SVector<f64, N>, SVector<f64, N>)| {
        (a.0.inf(&b.0), a.1.sup(&b.1))
    };
    let (low, high) = own.reduce(both).expect("a node has a piece");
    Node { low, high, next: 0, is_leaf: false }
}
