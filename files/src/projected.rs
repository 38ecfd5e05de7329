//! Rational splines as most formats hold them: control points and weights apart.
//!
//! The library keeps `w P` and `w`. Over floats a point that gives `w P` bit by bit when it is multiplied by `w` need not exist;
//! where it comes from a file with points and weights it does, and is found here, so that files come back as they were.

use symspline::{Q, Scalar};
use symspline_dynamic::{Coords, Over};

/// Control points and weights.
#[derive(Clone, Debug, PartialEq)]
pub struct Projected {
    /// The coordinates of the points, one after the other.
    pub points: Coords,
    /// The weights.
    pub weights: Coords,
    /// Whether weight times point is, bit by bit, what was given; else it is within rounding.
    pub is_exact: bool,
}

impl Projected {
    /// The points and weights of homogeneous coordinates, for each point `dim` coordinates times the weight and then the
    /// weight; none if a weight is not positive, or a point not finite.
    pub fn of(weighted: &Coords, dim: usize) -> Option<Self> {
        match weighted {
            Over::Float(all) => floats(all, dim),
            Over::Exact(all) => fractions(all, dim),
        }
    }
}

fn floats(all: &[f64], dim: usize) -> Option<Projected> {
    let (mut points, mut weights, mut is_exact) = (Vec::new(), Vec::new(), true);
    for c in all.chunks_exact(dim + 1) {
        let weight = c[dim];
        if weight.is_nan() || weight <= 0.0 {
            return None;
        }
        for product in &c[..dim] {
            let nearest = product / weight;
            if !nearest.is_finite() {
                return None;
            }
            let gives = |x: &f64| (x * weight).to_bits() == product.to_bits();
            let found = [nearest, nearest.next_up(), nearest.next_down()].into_iter().find(gives);
            is_exact &= found.is_some();
            points.push(found.unwrap_or(nearest));
        }
        weights.push(weight);
    }
    Some(Projected { points: Over::Float(points), weights: Over::Float(weights), is_exact })
}

fn fractions(all: &[Q], dim: usize) -> Option<Projected> {
    let (mut points, mut weights) = (Vec::new(), Vec::new());
    for c in all.chunks_exact(dim + 1) {
        if c[dim] <= Q::int(0) {
            return None;
        }
        points.extend(c[..dim].iter().map(|product| product.clone() / &c[dim]));
        weights.push(c[dim].clone());
    }
    Some(Projected { points: Over::Exact(points), weights: Over::Exact(weights), is_exact: true })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// What was multiplied comes back, and a product that none gives is owned up to.
        #[test]
        fn points_give_their_products(x in -1e3..1e3, weight in 1e-3..1e3) {
            let back = Projected::of(&Over::Float(vec![x * weight, weight]), 1).unwrap();
            prop_assert!(back.is_exact);
            let Over::Float(points) = back.points else { panic!() };
            prop_assert_eq!(points[0] * weight, x * weight);
            let any = Projected::of(&Over::Float(vec![x, weight]), 1).unwrap();
            let Over::Float(points) = any.points else { panic!() };
            prop_assert_eq!(any.is_exact, points[0] * weight == x);
            prop_assert!((points[0] * weight - x).abs() <= x.abs() * f64::EPSILON);
        }
    }

    /// Just below a power of two floats are closer: there the nearest quotient may not give the product, but its neighbour does.
    #[test]
    fn products_at_powers_of_two_have_points() {
        for (x, weight) in
            [(0.6687017100452178, 1.4954350870919408), (0.9724339513936662, 1.0283474765220064)]
        {
            let product: f64 = x * weight;
            assert_ne!((product / weight) * weight, product);
            let back = Projected::of(&Over::Float(vec![product, weight]), 1).unwrap();
            assert_eq!((back.is_exact, back.points), (true, Over::Float(vec![x])));
        }
    }

    #[test]
    fn points_at_infinity_are_none() {
        for c in [[1.0, 0.0], [1.0, -1.0], [1e300, 1e-300], [0.0, f64::NAN]] {
            assert_eq!(Projected::of(&Over::Float(c.to_vec()), 1), None, "{c:?}");
        }
        assert_eq!(Projected::of(&Over::Exact([1, 0].map(Q::int).to_vec()), 1), None);
    }
}
