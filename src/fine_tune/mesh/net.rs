//! A net of springs: edges that resist stretching, pairs of edges at a vertex that resist a change of their angle.
//!
//! Pairs are of two kinds: those that go on in each other in a [loop](super::loops), and neighbours around a vertex. Vertices that may move
//! come first; of a part the net has those edges and pairs that change if they move, and no more.

use super::loops::straight;
use crate::fine_tune::chain::direction;
use crate::fine_tune::joint::Jointed;
use crate::mesh::topology::Topology;
use nalgebra::SVector;

/// A vector of space.
pub(super) type Vector = SVector<f64, 3>;

/// An edge: its ends, the length it should have, and how stiff it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub ends: [usize; 2],
    pub length: f64,
    pub stretch: f64,
}

/// Two edges at a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Joint {
    /// The end of the one, the vertex, the end of the other.
    pub places: [usize; 3],
    pub legs: [usize; 2],
    /// Which way they are taken.
    pub signs: [f64; 2],
    /// The angle it should have.
    pub angle: f64,
    pub bend: f64,
}

impl Joint {
    /// The unit vectors and lengths of its legs, whose directions and lengths are given.
    pub(super) fn sides(&self, directions: &[(Vector, f64)]) -> [(Vector, f64); 2] {
        [0, 1].map(|k| {
            let (unit, length) = directions[self.legs[k]];
            (unit * self.signs[k], length)
        })
    }
}

/// The constants `k_l`, `k_a`, `k_b`, and whether all edges are of one material.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    pub stretch: f64,
    pub bend: f64,
    pub shape: f64,
    pub uniform: bool,
}

/// A net of springs.
#[derive(Clone, Debug)]
pub(super) struct Net {
    /// The vertex of the mesh at each place: first those that may move.
    pub vertices: Vec<usize>,
    /// How many may move.
    pub free: usize,
    pub points: Vec<Vector>,
    pub legs: Vec<Leg>,
    /// First those of loops.
    pub joints: Vec<Joint>,
    /// How many are of loops.
    pub straight: usize,
    /// The direction and length of each leg as the points lie.
    pub directions: Vec<(Vector, f64)>,
    /// By how much the energy rises with each leg.
    pub pulls: Vec<Vector>,
}

/// No place or leg.
const NONE: usize = usize::MAX;

impl Net {
    /// The net over a mesh whose edges should be `wanted` and are `found`, around those vertices that are free, or whole.
    pub(super) fn new(
        mesh: &Topology,
        points: &[Vector],
        [wanted, found]: [&[Vector]; 2],
        free: &[bool],
        whole: bool,
        constants: &Constants,
    ) -> Self {
        let mut vertices: Vec<usize> = (0..free.len()).filter(|v| free[*v]).collect();
        let count = vertices.len();
        let mean = wanted.iter().map(|leg| leg.norm() / wanted.len() as f64).sum::<f64>();
        let mut places = vec![NONE; free.len()];
        vertices.iter().enumerate().for_each(|(place, v)| places[*v] = place);
        // Angles at a vertex change if it moves or a neighbour.
        let mut centres = Vec::new();
        let mut seen = vec![false; free.len()];
        let mut add = |v: usize| {
            if !std::mem::replace(&mut seen[v], true) {
                centres.push(v);
            }
        };
        vertices.iter().for_each(|v| {
            add(*v);
            mesh.edges_at(*v).for_each(|e| mesh.ends(e).into_iter().for_each(&mut add));
        });
        if whole {
            (0..free.len()).for_each(add);
        }
        let mut net = Self {
            vertices: Vec::new(),
            free: count,
            points: Vec::new(),
            legs: Vec::new(),
            joints: Vec::new(),
            straight: 0,
            directions: Vec::new(),
            pulls: Vec::new(),
        };
        let mut ranks = vec![NONE; wanted.len()];
        let mut place = |v: usize| {
            if places[v] == NONE {
                places[v] = vertices.len();
                vertices.push(v);
            }
            places[v]
        };
        let mut neighbours = Vec::new();
        let turn = |u: &Vector, v: &Vector| direction(u).0.turn_to(&direction(v).0).angle;
        let (mut edges, mut leg_ranks) = (Vec::new(), Vec::new());
        for v in centres {
            edges.clear();
            leg_ranks.clear();
            edges.extend(mesh.edges_at(v));
            for &e in &edges {
                let ends = mesh.ends(e);
                if ranks[e] == NONE {
                    ranks[e] = net.legs.len();
                    let length = direction(&wanted[e]).1;
                    let stretch = if constants.uniform {
                        constants.stretch * (mean / length)
                    } else {
                        constants.stretch
                    };
                    let counts = whole || ends.iter().any(|end| free[*end]);
                    let stretch = if counts { stretch } else { 0.0 };
                    net.legs.push(Leg { ends: ends.map(&mut place), length, stretch });
                }
                leg_ranks.push(ranks[e]);
            }
            let boundary = mesh.is_boundary(v);
            let mut joint = |i: usize, j: usize, turned: f64, optimal: &[Vector], bend: f64| {
                let [a, b] = [edges[i], edges[j]];
                // Out of the vertex, but the first leg of two in a loop into it.
                let outward = |e: usize| if mesh.ends(e)[0] == v { 1.0 } else { -1.0 };
                let other = |e: usize| mesh.ends(e)[usize::from(mesh.ends(e)[0] == v)];
                let signs = [turned * outward(a), outward(b)];
                let counts = whole || [other(a), v, other(b)].iter().any(|end| free[*end]);
                counts.then(|| Joint {
                    places: [other(a), v, other(b)].map(&mut place),
                    legs: [leg_ranks[i], leg_ranks[j]],
                    signs,
                    angle: turn(&(optimal[a] * signs[0]), &(optimal[b] * signs[1])),
                    bend,
                })
            };
            for [i, j] in straight(edges.len(), boundary).into_iter().flatten() {
                net.joints.extend(joint(i, j, -1.0, wanted, constants.bend));
            }
            let around = edges.len() - usize::from(boundary);
            for i in 0..around {
                neighbours.extend(joint(i, (i + 1) % edges.len(), 1.0, found, constants.shape));
            }
        }
        net.straight = net.joints.len();
        net.joints.append(&mut neighbours);
        net.points = vertices.iter().map(|v| points[*v]).collect();
        net.vertices = vertices;
        net.directions = vec![(Vector::zeros(), 0.0); net.legs.len()];
        net.pulls = vec![Vector::zeros(); net.legs.len()];
        net
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::fine_tune::mesh::rest::{legs, scaled_legs};
    use crate::mesh::boundary::Boundary;
    use crate::mesh::control_mesh::ControlMesh;
    use crate::mesh::doo_sabin::DooSabin;
    use nalgebra::vector;

    pub(in crate::fine_tune::mesh) const EQUAL: Constants =
        Constants { stretch: 0.7, bend: 1.0, shape: 0.4, uniform: false };

    /// Numbers in `[-1, 1]` without a pattern.
    pub(in crate::fine_tune::mesh) fn noise(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        }
    }

    /// A cube, or a plane grid of 3 by 4 squares, moved by noise of a size.
    pub(in crate::fine_tune::mesh) fn mesh(cube: bool, size: f64, seed: u64) -> ControlMesh<f64, 3> {
        let mut next = noise(seed);
        let mut moved = |p: Vector| p + Vector::from_fn(|_, _| size * next());
        if cube {
            let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
            let corner = |k: i32| vector![f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)];
            return ControlMesh::new((0..8).map(|k| moved(corner(k))).collect(), faces).unwrap();
        }
        let points = (0..20).map(|k| moved(vector![f64::from(k % 4), f64::from(k / 4), 0.0])).collect();
        let faces = (0..12).map(|k| k / 3 * 4 + k % 3).map(|k| [k, k + 1, k + 5, k + 4]);
        ControlMesh::new(points, faces).unwrap()
    }

    /// The net of a mesh with these values, those vertices free of whose number something holds.
    pub(in crate::fine_tune::mesh) fn net(
        mesh: ControlMesh<f64, 3>,
        alpha: impl Fn(usize) -> f64,
        free: impl Fn(usize) -> bool,
        whole: bool,
        constants: &Constants,
    ) -> Net {
        let coarse = mesh.shared_topology().clone();
        let old = DooSabin::new(mesh, Boundary::Smooth);
        let surface = old.converted().unwrap();
        let (fine, points) = (surface.mesh().topology(), surface.mesh().points());
        let alpha: Vec<f64> = (0..coarse.edge_count()).map(alpha).collect();
        let wanted = scaled_legs(&old, fine, points, &alpha);
        let free: Vec<bool> = (0..fine.vertex_count()).map(free).collect();
        Net::new(fine, points, [&wanted, &legs(fine, points)], &free, whole, constants)
    }

    #[test]
    fn a_closed_mesh_has_as_many_terms_as_the_paper_says() {
        let net = net(mesh(true, 0.1, 1), |_| 1.0, |_| true, true, &EQUAL);
        assert_eq!([net.legs.len(), net.straight, net.joints.len() - net.straight], [48, 48, 96]);
    }

    #[test]
    fn a_part_has_the_terms_that_change() {
        let values = |e: usize| 1.0 + e as f64 / 50.0;
        let mut whole = net(mesh(false, 0.1, 2), values, |v| v < 4, true, &EQUAL);
        let mut part = net(mesh(false, 0.1, 2), values, |v| v < 4, false, &EQUAL);
        assert!(part.legs.len() < whole.legs.len() / 2 && part.joints.len() < whole.joints.len() / 2);
        let (x, mut next) = (whole.coordinates(), noise(1));
        let (mut g, mut h) = (vec![0.0; 12], vec![0.0; 12]);
        let rest = whole.energy(&x, &mut g) - part.energy(&x, &mut h);
        let moved: Vec<f64> = x.iter().map(|x| x + 0.1 * next()).collect();
        let changed = whole.energy(&moved, &mut g) - part.energy(&moved, &mut h);
        assert!(rest > 0.0 && (rest - changed).abs() < 1e-13);
        assert!(g.iter().zip(&h).all(|(g, h)| (g - h).abs() < 1e-13));
        let (sums, _) = part.parts();
        assert!((sums.iter().sum::<f64>() - part.energy(&moved, &mut h)).abs() < 1e-13);
    }
}
