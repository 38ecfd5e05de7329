//! [NURBS] sections 11.2 and 11.3.2: numbers printed with figures 11.1 to 11.6 and 11.15.

use crate::point;
use symspline::{Curve, Drag, Q, Scalar, SplineSpace};

/// Knots with the nodes that the figures name: `t_3 = 0.35`, `t_4 = 0.52`, and `(t_4 + t_5) / 2 = 0.608`.
fn space() -> SplineSpace<Q> {
    let inner = [200, 350, 500, 710, 878].map(|t| Q::frac(t, 1000));
    SplineSpace::clamped(3, [Q::int(0)].into_iter().chain(inner).chain([Q::int(1)])).expect("ascending knots")
}

#[test]
fn figures_of_section_11_2() {
    let space = space();
    let hundredths = |n: i64| Q::frac(n, 100);
    assert_eq!([3, 4].map(|i| space.node(i).expect("a node")), [35, 52].map(hundredths));
    // Figures 11.1 and 11.2: the control points that were chosen.
    assert_eq!(space.nearest_node(&Q::frac(3, 5)).expect("inside"), 4);
    assert_eq!(space.nearest_node(&hundredths(37)).expect("inside"), 3);
    // Figure 11.3: the mean of the nodes is 0.435, printed as 0.43, where the third is the nearer one.
    let x = hundredths(43);
    assert_eq!(space.nearest_node(&x).expect("inside"), 3);
    // Figure 11.4: the knot makes it node 4.
    let knot = space.node_placing_knot(&x).expect("a new knot").expect("no node yet");
    assert_eq!(space.refined(&[knot]).expect("inside").node(4).expect("a node"), x);
    // Figure 11.6: 0.47.
    let curve = Curve::constant(space, point([0, 0])).expect("a point");
    let drag = Drag::by_neighbours(&curve, &x, None).expect("influence");
    let [left, right] = &drag.rows().map(|row| row[0].clone()).collect::<Vec<Q>>()[..] else { panic!("two") };
    let gamma = right.clone() / (left.clone() + right);
    assert_eq!(gamma, Q::frac(8, 17));
    assert_eq!(format!("{:.2}", gamma.to_f64()), "0.47");
}

#[test]
fn the_parameter_of_a_leg() {
    let space = space();
    let middle = (space.node(4).expect("a node") + space.node(5).expect("a node")) / Q::int(2);
    assert_eq!(middle, Q::frac(608, 1000));
}
