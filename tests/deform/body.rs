//! Bodies to test on: a shape, a material and a breadth for each direction.

use crate::strategies::number;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use symspline::{
    Breadth, Controlled, Curve, DeformError, Elastic, Error, Material, NurbsCurve, NurbsSurface, Q, Result,
    Scalar, SplineSpace, Surface,
};

use crate::strategies::probes;

/// What to make of a shape.
#[derive(Clone, Debug)]
pub struct Wish {
    weights: [[i64; 3]; 2],
    breadth: [(u8, Index, Index); 2],
    pub places: Vec<(Index, Index)>,
    pub numbers: Vec<Q>,
}

pub fn wish() -> impl Strategy<Value = Wish> {
    let index = any::<Index>;
    let weights = || {
        prop_oneof![
            2 => Just([1, 2, 3]), 2 => Just([0, 1, 2]), 1 => Just([0, 0, 1]), 1 => Just([0, 1, 0]), 1 => Just([1, 0, 0]),
            1 => [0..3_i64, 0..3_i64, 0..3_i64],
        ]
    };
    let breadth = || (0..6_u8, index(), index());
    (weights(), weights(), breadth(), breadth(), vec((index(), index()), 4), vec(number(), 64))
        .prop_map(|(u, v, s, t, places, numbers)| Wish { weights: [u, v], breadth: [s, t], places, numbers })
}

fn breadth(space: &SplineSpace<Q>, (kind, i, j): &(u8, Index, Index)) -> Breadth<Q> {
    let n = space.dim();
    match kind {
        0 => Breadth::Whole,
        1 if !space.is_periodic() => Breadth::BetweenEnds(1),
        2 => Breadth::Around(i.get(&probes(space)).clone(), 1 + j.index(n)),
        3 if space.is_periodic() => Breadth::Range(i.index(n)..i.index(n) + 1 + j.index(n)),
        4 => Breadth::Listed((0..n).filter(|k| (k + i.index(7)) % (2 + j.index(3)) != 0).collect()),
        _ => Breadth::Range(i.index(n)..n),
    }
}

/// A material of one direction.
pub fn material(weights: &[i64; 3]) -> Result<Material<Q>> {
    Material::of_orders(weights.map(Q::int))
}

impl Wish {
    pub fn first_material(&self) -> Result<Material<Q>> {
        material(&self.weights[0])
    }

    pub fn first_breadth(&self, space: &SplineSpace<Q>) -> Breadth<Q> {
        breadth(space, &self.breadth[0])
    }
}

/// A shape that can be wished for.
pub trait Body: Controlled<Q> {
    fn place(&self, at: &(Index, Index)) -> Self::Parameter;
    fn order(of: usize) -> Self::Order;
    fn vector(numbers: &[Q]) -> Self::Point;

    /// The body, unless nothing moves, something moves freely, or a control point is at infinity or beyond.
    fn body(&self, wish: &Wish) -> Result<Option<Elastic<Q>>> {
        if matches!(self.control_points(), Err(Error::Weight { .. })) {
            return Ok(None);
        }
        let materials =
            wish.weights.iter().take(Self::DIRECTIONS.len()).map(material).collect::<Result<Vec<_>>>()?;
        let spaces = Self::DIRECTIONS.iter().map(|direction| self.space_along(*direction));
        let breadths: Vec<Breadth<Q>> =
            spaces.zip(&wish.breadth).map(|(space, wish)| breadth(space, wish)).collect();
        match Elastic::with_materials(self, &materials, &breadths) {
            Err(Error::Deform(DeformError::NullSpace { .. } | DeformError::NothingMoves)) => Ok(None),
            other => other.map(Some),
        }
    }

    /// The control points as they are now, less those of another.
    fn moved_from(&self, other: &Self) -> Result<Vec<Self::Point>> {
        use symspline::Coeff;
        let both = self.control_points()?.into_iter().zip(other.control_points()?);
        Ok(both.map(|(now, before)| now.minus(&before)).collect())
    }
}

/// Which control points may move.
pub fn moving(elastic: &Elastic<Q>) -> Vec<bool> {
    let along = |i: usize| {
        let stiffness = &elastic.stiffnesses()[i];
        (0..stiffness.space().dim()).map(|k| stiffness.moving().contains(&k)).collect::<Vec<bool>>()
    };
    if elastic.stiffnesses().len() == 1 {
        return along(0);
    }
    let (u, v) = (along(0), along(1));
    u.iter().flat_map(|a| v.iter().map(move |b| *a && *b)).collect()
}

macro_rules! body {
    ($kind:ty, curve) => {
        impl Body for $kind {
            fn place(&self, at: &(Index, Index)) -> Q {
                at.0.get(&probes(self.space_along(symspline::Direction::U))).clone()
            }
            fn order(of: usize) -> usize {
                of
            }
            fn vector(numbers: &[Q]) -> Self::Point {
                Self::Point::from_fn(|i, _| numbers[i].clone())
            }
        }
    };
    ($kind:ty, surface) => {
        impl Body for $kind {
            fn place(&self, at: &(Index, Index)) -> (Q, Q) {
                let coordinate = |i: &Index, direction| i.get(&probes(self.space_along(direction))).clone();
                (coordinate(&at.0, symspline::Direction::U), coordinate(&at.1, symspline::Direction::V))
            }
            fn order(of: usize) -> (usize, usize) {
                [(0, 0), (1, 0), (0, 1), (1, 1)][of]
            }
            fn vector(numbers: &[Q]) -> Self::Point {
                Self::Point::from_fn(|i, _| numbers[i].clone())
            }
        }
    };
}
body!(Curve<Q, 2>, curve);
body!(NurbsCurve<Q, 2>, curve);
body!(Surface<Q, 2>, surface);
body!(NurbsSurface<Q, 2>, surface);
