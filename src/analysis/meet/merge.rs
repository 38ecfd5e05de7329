//! What neighbouring pieces found, each once: places that touch are one.

use crate::analysis::meet::system::Pair;

/// The interval of a parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    pub domain: Pair,
    /// Whether the start follows the end.
    pub closed: bool,
}

impl Axis {
    /// Parameters nearer than this are not told apart.
    pub(crate) fn slack(&self) -> f64 {
        4.0 * f64::EPSILON * self.domain[0].abs().max(self.domain[1].abs())
    }

    fn period(&self) -> f64 {
        self.domain[1] - self.domain[0]
    }

    /// The parameter in the domain; a closed one begins anew at the end.
    pub(crate) fn inside(&self, x: f64) -> f64 {
        let [a, b] = self.domain;
        let x = if self.closed && x < a { x + self.period() } else { x };
        if self.closed && x >= b - self.slack() { a } else { x.clamp(a, b) }
    }
}

/// A place in the plane of two parameters, from where to where in each.
pub(crate) type Place = [Pair; 2];

/// The places that belong together, as indices, by a chain of places that overlap or touch.
pub(crate) fn groups(places: &[Place], axes: &[Axis; 2]) -> Vec<Vec<usize>> {
    // At the end of a closed domain places count a period before, too.
    let mut shown: Vec<(Place, usize)> = places.iter().copied().zip(0..).collect();
    for (k, axis) in axes.iter().enumerate().filter(|(_, axis)| axis.closed) {
        let at_end = |(place, _): &&(Place, usize)| place[k][1] >= axis.domain[1] - axis.slack();
        let before = |(place, i): &(Place, usize)| {
            let mut place = *place;
            place[k] = place[k].map(|x| x - axis.period());
            (place, *i)
        };
        let ghosts: Vec<_> = shown.iter().filter(at_end).map(before).collect();
        shown.extend(ghosts);
    }
    shown.sort_by(|(a, _), (b, _)| a[0][0].total_cmp(&b[0][0]));
    let mut parents: Vec<usize> = (0..places.len()).collect();
    let mut active: Vec<(Place, usize)> = Vec::new();
    for (place, i) in shown {
        active.retain(|(other, _)| other[0][1] + axes[0].slack() >= place[0][0]);
        for (other, j) in &active {
            let slack = axes[1].slack();
            if other[1][0] <= place[1][1] + slack && place[1][0] <= other[1][1] + slack {
                let (a, b) = (root(&mut parents, i), root(&mut parents, *j));
                parents[a.max(b)] = a.min(b);
            }
        }
        active.push((place, i));
    }
    let mut groups: Vec<Vec<usize>> = vec![Vec::new(); places.len()];
    for i in 0..places.len() {
        let root = root(&mut parents, i);
        groups[root].push(i);
    }
    groups.retain(|group| !group.is_empty());
    groups
}

fn root(parents: &mut [usize], mut i: usize) -> usize {
    while parents[i] != i {
        parents[i] = parents[parents[i]];
        i = parents[i];
    }
    i
}

/// From where to where places of one group reach; over the seam of a closed parameter it starts before the domain.
pub(crate) fn hull(places: &[Place], axes: &[Axis; 2]) -> Place {
    std::array::from_fn(|k| {
        let axis = &axes[k];
        let parts = || places.iter().map(|place| place[k]);
        let far = |[from, to]: &Pair| axis.closed && 0.5 * (from + to) > axis.domain[0] + 0.5 * axis.period();
        let both = parts().any(|part| far(&part)) && parts().any(|part| !far(&part));
        let apart = both && parts().all(|[from, to]| to - from < 0.25 * axis.period());
        let at_seam = apart
            && parts().any(|part| part[1] >= axis.domain[1] - axis.slack())
            && parts().any(|part| part[0] <= axis.domain[0] + axis.slack());
        let shift = |part: Pair| if at_seam && far(&part) { part.map(|x| x - axis.period()) } else { part };
        let join = |[a, b]: Pair, [c, d]: Pair| [a.min(c), b.max(d)];
        parts().map(shift).reduce(join).expect("a group has a place")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const OPEN: Axis = Axis { domain: [0.0, 4.0], closed: false };
    const RING: Axis = Axis { domain: [0.0, 4.0], closed: true };

    #[test]
    fn places_that_touch_are_one() {
        let places = [
            [[0.0, 1.0], [0.0, 1.0]],
            [[1.0, 2.0], [1.0, 2.0]],
            [[0.0, 0.5], [2.0, 3.0]],
            [[2.0, 2.0], [2.0, 2.5]],
        ];
        assert_eq!(groups(&places, &[OPEN; 2]), [vec![0, 1, 3], vec![2]]);
        assert_eq!(hull(&[places[0], places[1], places[3]], &[OPEN; 2]), [[0.0, 2.0], [0.0, 2.5]]);
    }

    #[test]
    fn seams_are_crossed() {
        let places = [[[0.0, 0.0], [1.0, 1.0]], [[3.9, 4.0], [1.0, 1.0]]];
        assert_eq!(groups(&places, &[OPEN; 2]).len(), 2);
        assert_eq!(groups(&places, &[RING, OPEN]), [vec![0, 1]]);
        let hull = hull(&places, &[RING, OPEN]);
        assert!((hull[0][0] + 0.1).abs() < 1e-15 && hull[0][1] == 0.0 && hull[1] == [1.0, 1.0]);
        // Both seams at once.
        let corners = [[[0.0, 0.0], [0.0, 0.0]], [[4.0, 4.0], [4.0, 4.0]], [[4.0, 4.0], [0.0, 0.0]]];
        assert_eq!(groups(&corners, &[RING; 2]), [vec![0, 1, 2]]);
        assert_eq!(RING.inside(4.0), 0.0);
        assert_eq!(OPEN.inside(4.0), 4.0);
    }
}
