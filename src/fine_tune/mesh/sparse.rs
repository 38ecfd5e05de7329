//! A symmetric positive matrix of blocks, three unknowns a node, and how to solve with it.
//!
//! ```text
//! A = L Lᵀ,   A_rc = 0 = L_rc   unless nodes r and c are coupled, or both to a node eliminated before
//! ```
//! after a [dissection](super::dissect) of the nodes. Which blocks of `L` there are is found once; a matrix is built in their places and
//! factored there, column by column, each from those to the left that reach it.

use super::dissect::{Graph, dissected};

/// Three columns of three.
type Block = [[f64; 3]; 3];

/// No node.
const NONE: usize = usize::MAX;

/// Such a matrix, or its factor.
#[derive(Clone, Debug)]
pub(super) struct SparseMatrix {
    /// Where each node stands in the order.
    ranks: Vec<usize>,
    /// Where each column begins among the blocks below the diagonal, and where the last one ends.
    starts: Vec<usize>,
    /// The row of each, in each column from the top.
    rows: Vec<usize>,
    blocks: Vec<Block>,
    diagonal: Vec<Block>,
}

impl SparseMatrix {
    /// The zero matrix of nodes coupled as in a graph.
    pub(super) fn zero(graph: &Graph) -> Self {
        let (count, order) = (graph.count(), dissected(graph));
        let mut ranks = vec![0; count];
        order.iter().enumerate().for_each(|(rank, node)| ranks[*node] = rank);
        let (mut starts, mut rows) = (vec![0], Vec::<usize>::new());
        // The columns whose first row is this one, in a list.
        let (mut child, mut sibling) = (vec![NONE; count], vec![NONE; count]);
        let mut marks = vec![NONE; count];
        for (c, node) in order.iter().enumerate() {
            marks[c] = c;
            let first = rows.len();
            let own = graph.at(*node).iter().map(|other| ranks[*other]).filter(|r| *r > c);
            for r in own {
                marks[r] = c;
                rows.push(r);
            }
            let mut left = child[c];
            while left != NONE {
                for k in starts[left]..starts[left + 1] {
                    let r = rows[k];
                    if std::mem::replace(&mut marks[r], c) != c {
                        rows.push(r);
                    }
                }
                left = sibling[left];
            }
            rows[first..].sort_unstable();
            starts.push(rows.len());
            if let Some(&parent) = rows.get(first) {
                sibling[c] = std::mem::replace(&mut child[parent], c);
            }
        }
        let blocks = vec![Block::default(); rows.len()];
        Self { ranks, starts, rows, blocks, diagonal: vec![Block::default(); count] }
    }

    /// Sets all entries to zero, but those on the diagonal to `diagonal`.
    pub(super) fn reset(&mut self, diagonal: f64) {
        self.blocks.fill(Block::default());
        self.diagonal.fill([[diagonal, 0.0, 0.0], [0.0, diagonal, 0.0], [0.0, 0.0, diagonal]]);
    }

    /// Multiplies the diagonal.
    pub(super) fn raise(&mut self, factor: f64) {
        self.diagonal.iter_mut().for_each(|block| (0..3).for_each(|a| block[a][a] *= factor));
    }

    /// The place of the block of two nodes, the lower one in the order first; of one node with itself that on the diagonal.
    fn block(&mut self, r: usize, c: usize) -> &mut Block {
        if r == c {
            return &mut self.diagonal[c];
        }
        let range = self.starts[c]..self.starts[c + 1];
        let place = self.rows[range.clone()].partition_point(|row| *row < r);
        &mut self.blocks[range.start + place]
    }

    /// Adds `w wᵀ` where `w` has the given values at some nodes, each coupled with each; nodes beyond the last are left out.
    pub(super) fn add_square<const K: usize>(&mut self, nodes: [usize; K], values: &[[f64; 3]; K]) {
        let count = self.ranks.len();
        for (node, value) in nodes.iter().zip(values).filter(|(node, _)| **node < count) {
            for (other, factor) in nodes.iter().zip(values).filter(|(node, _)| **node < count) {
                let (r, c) = (self.ranks[*node], self.ranks[*other]);
                if r >= c {
                    let block = self.block(r, c);
                    for (column, y) in block.iter_mut().zip(factor) {
                        column.iter_mut().zip(value).for_each(|(entry, x)| *entry += x * y);
                    }
                }
            }
        }
    }

    /// Replaces the matrix by its factor `L`. A pivot that rounding made negative is replaced by its magnitude, one that it made too
    /// small by a small one.
    pub(super) fn factor(&mut self) {
        let count = self.ranks.len();
        // The columns that reach row `c` next, in a list, and where in them that row is.
        let (mut reaching, mut link, mut next) = (vec![NONE; count], vec![NONE; count], vec![0; count]);
        let mut places = vec![NONE; count];
        for c in 0..count {
            let own = self.starts[c]..self.starts[c + 1];
            self.rows[own.clone()].iter().zip(own.clone()).for_each(|(r, place)| places[*r] = place);
            let mut left = reaching[c];
            while left != NONE {
                let after = link[left];
                let (at, end) = (next[left], self.starts[left + 1]);
                let factor = self.blocks[at];
                subtract(&mut self.diagonal[c], &factor, &factor);
                for k in at + 1..end {
                    let block = self.blocks[k];
                    subtract(&mut self.blocks[places[self.rows[k]]], &block, &factor);
                }
                if at + 1 < end {
                    next[left] = at + 1;
                    link[left] = std::mem::replace(&mut reaching[self.rows[at + 1]], left);
                }
                left = after;
            }
            factor_block(&mut self.diagonal[c]);
            let pivot = self.diagonal[c];
            self.blocks[own.clone()].iter_mut().for_each(|block| divide(block, &pivot));
            if !own.is_empty() {
                next[c] = own.start;
                link[c] = std::mem::replace(&mut reaching[self.rows[own.start]], c);
            }
        }
    }

    /// Solves `L Lᵀ z = g` for `g`, given node by node, and puts `z` there. `room`, as long, is overwritten.
    pub(super) fn solve(&self, g: &mut [f64], room: &mut [[f64; 3]]) {
        for (values, rank) in g.chunks_exact(3).zip(&self.ranks) {
            room[*rank].copy_from_slice(values);
        }
        for c in 0..self.ranks.len() {
            let l = &self.diagonal[c];
            let x = room[c][0] / l[0][0];
            let y = (room[c][1] - l[0][1] * x) / l[1][1];
            let z = (room[c][2] - l[0][2] * x - l[1][2] * y) / l[2][2];
            room[c] = [x, y, z];
            for k in self.starts[c]..self.starts[c + 1] {
                let (block, target) = (&self.blocks[k], &mut room[self.rows[k]]);
                (0..3).for_each(|a| target[a] -= block[0][a] * x + block[1][a] * y + block[2][a] * z);
            }
        }
        for c in (0..self.ranks.len()).rev() {
            let mut sum = room[c];
            for k in self.starts[c]..self.starts[c + 1] {
                let (block, from) = (&self.blocks[k], &room[self.rows[k]]);
                (0..3).for_each(|a| {
                    sum[a] -= block[a][0] * from[0] + block[a][1] * from[1] + block[a][2] * from[2];
                });
            }
            let l = &self.diagonal[c];
            let z = sum[2] / l[2][2];
            let y = (sum[1] - l[1][2] * z) / l[1][1];
            let x = (sum[0] - l[0][1] * y - l[0][2] * z) / l[0][0];
            room[c] = [x, y, z];
        }
        for (values, rank) in g.chunks_exact_mut(3).zip(&self.ranks) {
            values.copy_from_slice(&room[*rank]);
        }
    }
}

/// Subtracts `b lᵀ`.
#[inline]
fn subtract(from: &mut Block, b: &Block, l: &Block) {
    for c in 0..3 {
        for r in 0..3 {
            from[c][r] -= b[0][r] * l[0][c] + b[1][r] * l[1][c] + b[2][r] * l[2][c];
        }
    }
}

/// Replaces the lower half of a block by its factor; what is above the diagonal is left.
fn factor_block(block: &mut Block) {
    const LEAST: f64 = 64.0 * f64::EPSILON;
    for c in 0..3 {
        let whole = block[c][c].abs();
        let left = whole - (0..c).map(|k| block[k][c] * block[k][c]).sum::<f64>();
        let pivot = left.abs().max(LEAST * whole).max(f64::MIN_POSITIVE).sqrt();
        block[c][c] = pivot;
        for r in c + 1..3 {
            let sum: f64 = (0..c).map(|k| block[k][r] * block[k][c]).sum();
            block[c][r] = (block[c][r] - sum) / pivot;
        }
    }
}

/// Divides a block by the transpose of a factor from the right.
fn divide(block: &mut Block, l: &Block) {
    let [first, second, third] = block;
    for ((x, y), z) in first.iter_mut().zip(second).zip(third) {
        *x /= l[0][0];
        *y = (*y - *x * l[0][1]) / l[1][1];
        *z = (*z - *x * l[0][2] - *y * l[1][2]) / l[2][2];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    fn noise(k: usize) -> f64 {
        (k * k * 37 + k * 11) as f64 % 101.0 / 50.0 - 1.0
    }

    #[test]
    fn it_solves_as_a_full_matrix_does() {
        for (m, n) in [(1, 1), (2, 1), (7, 9), (12, 5)] {
            let count = m * n;
            let fans: Vec<[usize; 3]> =
                (0..count).filter(|k| (k + 1) % m != 0 && k + m < count).map(|k| [k + 1, k, k + m]).collect();
            let pairs = fans.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
            let mut sparse = SparseMatrix::zero(&Graph::of(count, pairs));
            sparse.reset(0.5);
            let mut full = DMatrix::<f64>::identity(3 * count, 3 * count) * 0.5;
            for (i, fan) in fans.iter().enumerate() {
                let values = [0, 1, 2].map(|k| [0, 1, 2].map(|a| noise(9 * i + 3 * k + a)));
                // A node beyond the last does not count.
                sparse.add_square(
                    [fan[0], fan[1], fan[2], count],
                    &[values[0], values[1], values[2], [9.0; 3]],
                );
                let mut w = DVector::zeros(3 * count);
                fan.iter().zip(&values).for_each(|(k, v)| (0..3).for_each(|a| w[3 * k + a] = v[a]));
                full += &w * w.transpose();
            }
            sparse.raise(1.25);
            (0..3 * count).for_each(|k| full[(k, k)] *= 1.25);
            let g: Vec<f64> = (0..3 * count).map(noise).collect();
            let mut z = g.clone();
            sparse.factor();
            sparse.solve(&mut z, &mut vec![[0.0; 3]; count]);
            let left = full * DVector::from_vec(z) - DVector::from_vec(g);
            assert!(left.amax() < 1e-12, "{m} x {n}: {left}");
        }
    }

    #[test]
    fn singular_matrices_solve_to_finite_numbers() {
        let mut sparse = SparseMatrix::zero(&Graph::of(2, std::iter::once([0, 1])));
        sparse.reset(0.0);
        sparse.add_square([0, 1], &[[1.0, 2.0, 3.0], [-1.0, -2.0, -3.0]]);
        sparse.factor();
        let mut z = [1.0, 2.0, 3.0, -1.0, -2.0, -3.0];
        sparse.solve(&mut z, &mut [[0.0; 3]; 2]);
        assert!(z.iter().all(|x| x.is_finite()), "{z:?}");
    }
}
