//! Elastic bodies that were made lately, to be used again.

use crate::deform::breadth::Breadth;
use crate::deform::elastic::{Elastic, Spread};
use crate::deform::material::Material;
use crate::deform::stiffness::Stiffness;
use crate::error::Result;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use std::collections::VecDeque;

/// How many bodies are kept.
const KEPT: usize = 8;

/// Bodies of a shape, the last one used first.
///
/// A [`Stiffness`] depends on the space, the material and the coefficients that may move, and is not made again while these stay.
#[derive(Clone, Debug)]
pub(crate) struct Bodies<T> {
    kept: VecDeque<Elastic<T>>,
}

impl<T: Scalar> Bodies<T> {
    /// None yet.
    pub(crate) fn new() -> Self {
        Self { kept: VecDeque::new() }
    }

    /// The body of a shape with a material and a breadth for each direction.
    pub(crate) fn of<S: Controlled<T>>(
        &mut self,
        shape: &S,
        materials: &[Material<T>],
        breadths: &[Breadth<T>],
        spread: Spread,
    ) -> Result<&Elastic<T>> {
        let each = || S::DIRECTIONS.iter().map(|direction| shape.space_along(*direction)).zip(materials);
        let moving = each().zip(breadths).map(|((space, _), breadth)| breadth.coeffs(space));
        let moving: Vec<Vec<usize>> = moving.collect::<Result<_>>()?;
        let is_of = |direction: usize, stiffness: &Stiffness<T>| {
            let (material, own) = (&materials[direction], shape.space_along(S::DIRECTIONS[direction]));
            stiffness.moving() == moving[direction]
                && stiffness.material() == material
                && stiffness.is_over(own)
        };
        let is_all = |body: &Elastic<T>| body.stiffnesses().iter().enumerate().all(|(d, s)| is_of(d, s));
        let body = match self.kept.iter().position(is_all).and_then(|place| self.kept.remove(place)) {
            Some(body) => body,
            None => {
                let one = |(direction, (space, material))| {
                    let mut known = self.kept.iter().map(|body| &body.stiffnesses()[direction]);
                    match known.find(|stiffness| is_of(direction, stiffness)) {
                        Some(stiffness) => Ok(stiffness.clone()),
                        None => Stiffness::new(space, material, &Breadth::Listed(moving[direction].clone())),
                    }
                };
                Elastic::along(each().enumerate().map(one).collect::<Result<_>>()?)
            }
        };
        self.kept.truncate(KEPT - 1);
        self.kept.push_front(body.with_spread(spread));
        Ok(&self.kept[0])
    }
}
