//! Which pieces of two lists may meet: their boxes overlap. Both lists are halved in turn, so curves that meet seldom
//! cost a little more than their lengths.

use crate::analysis::meet::solve::Budget;
use crate::analysis::meet::system::Pair;
use crate::error::Result;

/// The lowest and the highest corner of a box.
pub(crate) type Corners = [Pair; 2];

/// A binary tree of boxes over a list, each node after its children.
struct Tree {
    nodes: Vec<Node>,
}

struct Node {
    corners: Corners,
    /// Two nodes, or the index in the list.
    inside: std::result::Result<[usize; 2], usize>,
}

impl Tree {
    fn new(leaves: &[Corners]) -> Self {
        let mut tree = Self { nodes: Vec::with_capacity(2 * leaves.len()) };
        tree.add(leaves, 0);
        tree
    }

    /// Adds the tree over `leaves`, the first of which is number `first`; its root is the last node.
    fn add(&mut self, leaves: &[Corners], first: usize) -> usize {
        let node = match leaves {
            [corners] => Node { corners: *corners, inside: Err(first) },
            _ => {
                let (left, right) = leaves.split_at(leaves.len() / 2);
                let inside = [self.add(left, first), self.add(right, first + left.len())];
                let [a, b] = inside.map(|i| self.nodes[i].corners);
                let corners = [0, 1].map(|k| [0, 1].map(|x| join(k, a[k][x], b[k][x])));
                Node { corners, inside: Ok(inside) }
            }
        };
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn extent(&self, node: usize) -> f64 {
        let [low, high] = self.nodes[node].corners;
        (high[0] - low[0]).max(high[1] - low[1])
    }
}

fn join(end: usize, a: f64, b: f64) -> f64 {
    if end == 0 { a.min(b) } else { a.max(b) }
}

/// The pairs of indices of boxes that are not farther than `slack` from each other. No list is empty.
///
/// # Errors
/// [`TooLarge`](crate::Error::TooLarge).
pub(crate) fn pairs(
    first: &[Corners],
    second: &[Corners],
    slack: f64,
    budget: &mut Budget,
) -> Result<Vec<[usize; 2]>> {
    let (one, other) = (Tree::new(first), Tree::new(second));
    let mut open = vec![[one.nodes.len() - 1, other.nodes.len() - 1]];
    let mut found = Vec::new();
    while let Some([i, j]) = open.pop() {
        budget.spend(1)?;
        let ([a, b], [c, d]) = (one.nodes[i].corners, other.nodes[j].corners);
        if (0..2).any(|k| a[k] - d[k] > slack || c[k] - b[k] > slack) {
            continue;
        }
        match (&one.nodes[i].inside, &other.nodes[j].inside) {
            (Err(i), Err(j)) => found.push([*i, *j]),
            (Ok(halves), Err(_)) => open.extend(halves.map(|i| [i, j])),
            (Err(_), Ok(halves)) => open.extend(halves.map(|j| [i, j])),
            (Ok(halves), Ok(_)) if one.extent(i) >= other.extent(j) => open.extend(halves.map(|i| [i, j])),
            (Ok(_), Ok(halves)) => open.extend(halves.map(|j| [i, j])),
        }
    }
    found.sort_unstable();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_found() {
        let boxes = |count: usize, shift: f64| -> Vec<Corners> {
            (0..count).map(|i| [[i as f64, shift], [i as f64 + 1.0, shift + 1.0]]).collect()
        };
        let found = |shift: f64| pairs(&boxes(7, 0.0), &boxes(4, shift), 0.25, &mut Budget::new()).unwrap();
        let near = |i: &usize, j: &usize| i.abs_diff(*j) <= 1;
        let expected: Vec<_> =
            (0..7).flat_map(|i| (0..4).map(move |j| [i, j])).filter(|[i, j]| near(i, j)).collect();
        assert_eq!(found(1.2), expected);
        assert_eq!(found(1.3), Vec::<[usize; 2]>::new());
    }
}
