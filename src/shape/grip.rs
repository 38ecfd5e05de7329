//! Points moved by one control point, or by several that share the way.
//!
//! With shares `s_i` the control points move by `s_i α d` and the point by `α Σ s_i R_i d`: it moves by `d` for
//! `α = 1 / Σ s_i R_i` [NURBS, (11.1) to (11.14)]. One control point is the case of one share; two with `1 - γ` and `γ`, four
//! with the products of two such pairs.

use crate::constrain::sparse::SparseRow;
use crate::error::Result;
use crate::error::shape::ShapeError;
use crate::scalar::Scalar;
use crate::shape::controlled::Controlled;
use crate::shape::drag::Drag;
use crate::space::SplineSpace;

impl<T: Scalar> Drag<T> {
    /// The point at `at` moved by one control point [NURBS, (11.2) and (11.3), of surfaces (11.10) and (11.11)].
    ///
    /// The edit takes one vector, by which the point moves exactly; made once, it serves any number of pulls.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`](crate::Error::OutsideDomain), [`Error::IndexOutOfRange`](crate::Error::IndexOutOfRange);
    /// [`ShapeError::NoInfluence`] where the control point has none, as at the ends of its support.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Curve, Drag, Q, Scalar, SplineSpace};
    /// let points = [[0, 0], [1, 2], [3, 2], [4, 0]].map(|[x, y]| vector![Q::int(x), Q::int(y)]);
    /// let curve = Curve::new(SplineSpace::clamped(2, [0, 1, 2].map(Q::int))?, points.to_vec())?;
    /// let (x, up) = (Q::frac(1, 2), vector![Q::int(0), Q::int(1)]);
    /// let pulled = Drag::by_one(&curve, &x, 1)?.applied(&curve, &[up.clone()])?;
    /// assert_eq!(pulled.at(&x)?, curve.at(&x)? + up);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    #[doc(alias = "control point repositioning")]
    pub fn by_one<S: Controlled<T>>(shape: &S, at: &S::Parameter, index: S::Index) -> Result<Self> {
        Self::by_shares(shape, at, &[(index, T::one())])
    }

    /// The point at `at` moved by some control points, which move by shares of one vector.
    ///
    /// # Errors
    /// As [`by_one`](Self::by_one); [`ShapeError::NoInfluence`] if the shares of the influences add up to nothing.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Drag, SplineSpace, Surface};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let flat = Surface::new(line.clone(), line, vec![vector![0.0, 0.0, 0.0]; 4])?;
    /// // One corner up, its neighbour half as much.
    /// let drag = Drag::by_shares(&flat, &(0.0, 0.5), &[((0, 0), 1.0), ((0, 1), 0.5)])?;
    /// let moved = drag.applied(&flat, &[vector![0.0, 0.0, 3.0]])?;
    /// assert_eq!(moved.coeffs()[0][2], 4.0);
    /// assert_eq!(moved.at(&0.0, &0.5)?[2], 3.0);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn by_shares<S: Controlled<T>>(
        shape: &S,
        at: &S::Parameter,
        shares: &[(S::Index, T)],
    ) -> Result<Self> {
        let named = shares.iter().map(|(index, share)| Ok((shape.flat(*index)?, share.clone())));
        share_out(shape, at, named.collect::<Result<_>>()?)
    }

    /// The point at `at` moved by the control point whose node is nearest [NURBS, (11.5)], of surfaces the nearest in
    /// each direction [NURBS, (11.12)].
    ///
    /// # Errors
    /// [`Error::OutsideDomain`](crate::Error::OutsideDomain); [`ShapeError::NoInfluence`] where that control point has none,
    /// as an end point of an unclamped curve may.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Drag, Function, SplineSpace};
    /// let zero = Function::constant(SplineSpace::clamped(3, [0.0, 1.0, 2.0, 3.0, 4.0])?, 0.0)?;
    /// assert_eq!(Drag::by_nearest(&zero, &2.1)?.indices(), [3]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn by_nearest<S: Controlled<T>>(shape: &S, at: &S::Parameter) -> Result<Self> {
        let nearest = |space: &SplineSpace<T>, x: &T, _: Option<&T>| {
            Ok(vec![(space.slot(space.nearest_node(x)?), T::one())])
        };
        share_out(shape, at, along_each(shape, at, None, nearest)?)
    }

    /// The point at `at` moved by the two control points whose nodes are around it, of surfaces by the four: with shares
    /// `1 - γ` and `γ` in each direction, by default so that a control point at its node moves alone,
    /// `γ = (x - t_k) / (t_{k+1} - t_k)` [NURBS, (11.7) to (11.9), of surfaces (11.13) and (11.14)].
    ///
    /// # Errors
    /// As [`by_one`](Self::by_one); [`ShapeError::NoNodeBefore`] in an unclamped space before its first node.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Drag, Function, Q, Scalar, SplineSpace};
    /// let zero = Function::constant(SplineSpace::clamped(3, [0, 1, 2, 3, 4].map(Q::int))?, Q::int(0))?;
    /// let drag = Drag::by_neighbours(&zero, &Q::frac(3, 2), None)?;
    /// assert_eq!(drag.indices(), [2, 3]);
    /// let even = Drag::by_neighbours(&zero, &Q::frac(3, 2), Some(&Q::frac(1, 2)))?;
    /// assert_eq!(even.applied(&zero, &[Q::int(1)])?.at(&Q::frac(3, 2))?, Q::int(1));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn by_neighbours<S: Controlled<T>>(
        shape: &S,
        at: &S::Parameter,
        gamma: Option<&S::Parameter>,
    ) -> Result<Self> {
        let around = |space: &SplineSpace<T>, x: &T, gamma: Option<&T>| {
            let k = space.node_before(x)?;
            let start = space.node(k)?;
            // After the last node there is no other, and at a node the default needs none.
            let share = match (gamma, space.node(k + 1)) {
                (Some(gamma), Ok(_)) => gamma.clone(),
                (None, Ok(end)) if start != *x => (x.clone() - &start) / (end - &start),
                _ => return Ok(vec![(space.slot(k), T::one())]),
            };
            Ok(vec![(space.slot(k), T::one() - &share), (space.slot(k + 1), share)])
        };
        share_out(shape, at, along_each(shape, at, gamma, around)?)
    }
}

/// The products of shares in each direction, with places in the list.
fn along_each<T: Scalar, S: Controlled<T>>(
    shape: &S,
    at: &S::Parameter,
    gamma: Option<&S::Parameter>,
    shares: impl Fn(&SplineSpace<T>, &T, Option<&T>) -> Result<Vec<(usize, T)>>,
) -> Result<Vec<(usize, T)>> {
    let mut products = vec![(0, T::one())];
    for direction in S::DIRECTIONS {
        let space = shape.space_along(*direction);
        let gamma = gamma.map(|gamma| S::coordinate(gamma, *direction));
        let along = shares(space, S::coordinate(at, *direction), gamma)?;
        let longer = |(flat, product): &(usize, T)| {
            let (flat, product) = (*flat * space.dim(), product.clone());
            along.iter().map(move |(slot, share)| (flat + slot, product.clone() * share)).collect::<Vec<_>>()
        };
        products = products.iter().flat_map(longer).collect();
    }
    Ok(products)
}

/// The edit that moves the control points by their shares so that the point moves by a vector given.
fn share_out<T: Scalar, S: Controlled<T>>(
    shape: &S,
    at: &S::Parameter,
    shares: Vec<(usize, T)>,
) -> Result<Drag<T>> {
    let shares = SparseRow::new(shares);
    let influence = shape.influence(at, S::VALUE)?;
    let part = |(i, share): &(usize, T)| influence.weight(*i).map(|r| share.clone() * r);
    let sum = shares.terms().iter().filter_map(part).fold(T::zero(), |sum, part| sum + part);
    let (indices, mut matrix): (Vec<usize>, Vec<T>) = shares.terms().iter().cloned().unzip();
    let refused = ShapeError::NoInfluence { parameter: format!("{at:?}") };
    if sum.is_zero() {
        return Err(refused.into());
    }
    T::divide(&mut matrix, &sum);
    if !matrix.iter().all(T::is_finite) {
        return Err(refused.into());
    }
    Ok(Drag::new(shape.control_count(), indices, matrix, 1))
}
