//! The stiffness of the coefficients of one space that may move.

use crate::coeff::{Coeff, check_shapes};
use crate::deform::breadth::Breadth;
use crate::deform::factor::{Factor, Squares};
use crate::deform::hats;
use crate::deform::loose::loose_motions;
use crate::deform::material::Material;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use std::sync::OnceLock;

/// The matrix `K_r` of a material on the coefficients of a space that may move, ready to be solved with [Vassilev, (17)].
///
/// `K_r` is the part of `K` with rows and columns of these coefficients; the others keep their places. Making it and solving
/// with it take time linear in their number, however many others there are.
///
/// # Examples
/// A rod that resists stretching, held at both ends and pulled in the middle:
/// ```
/// use symspline::{Breadth, Functional, Material, Q, Scalar, SplineSpace, Stiffness};
/// let space = SplineSpace::clamped(1, [0, 1, 2, 3, 4].map(Q::int))?;
/// let stiffness = Stiffness::new(&space, &Material::new(Q::int(1), Q::int(0))?, &Breadth::BetweenEnds(1))?;
/// let pulled = stiffness.response(&space.basis(&Q::int(2))?)?;
/// assert_eq!(pulled, [Q::int(0), Q::frac(1, 2), Q::int(1), Q::frac(1, 2), Q::int(0)]);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Stiffness<T> {
    space: SplineSpace<T>,
    material: Material<T>,
    /// Ascending.
    moving: Vec<usize>,
    /// The coefficients that may move in the order of the factor.
    order: Vec<usize>,
    factor: Factor<T>,
    /// From coefficients of `space` to the integrals `∫ f S_j` with the hat functions `S_j` of the breaks; made when it is asked
    /// for.
    hats: OnceLock<LinearMap<T>>,
}

impl<T: Scalar> Stiffness<T> {
    /// The stiffness of `material` on the coefficients of `space` that `breadth` lets move.
    ///
    /// # Errors
    /// [`DeformError::NullSpace`] if some of their motions cost nothing; those of [`Breadth::coeffs`];
    /// [`Error::NotFinite`] if in floating point the material is beyond the range; [`Error::TooLarge`].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, DeformError, Error, Material, SplineSpace, Stiffness};
    /// let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    /// let bending = Material::new(0.0, 1.0)?;
    /// let loose = Stiffness::new(&space, &bending, &Breadth::Whole).unwrap_err();
    /// assert!(matches!(loose, Error::Deform(DeformError::NullSpace { order: Some(2), dimension: 2, .. })));
    /// assert!(Stiffness::new(&space, &bending, &Breadth::BetweenEnds(1)).is_ok());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn new(space: &SplineSpace<T>, material: &Material<T>, breadth: &Breadth<T>) -> Result<Self> {
        let moving = breadth.coeffs(space)?;
        let (order, width) = ordered(space, &moving);
        let lowest = material.lowest_order();
        let free = |dimension, coefficient| DeformError::NullSpace { order: lowest, dimension, coefficient };
        // Over floats the factors alone may take a motion that is free for one that costs little.
        let told =
            if T::EXACT { None } else { lowest.and_then(|order| loose_motions(space, order, &moving)) };
        if let Some((dimension, coefficient)) = told.filter(|(dimension, _)| *dimension > 0) {
            return Err(free(dimension, coefficient).into());
        }
        let (factor, loose) = squares(space, material, (&order, width))?.factored();
        if let Some(rank) = loose.last() {
            return Err(free(loose.len(), order[*rank]).into());
        }
        let hats = OnceLock::new();
        Ok(Self { space: space.clone(), material: material.clone(), moving, order, factor, hats })
    }

    /// The space.
    pub fn space(&self) -> &SplineSpace<T> {
        &self.space
    }

    /// Whether this is its space; if they share their knots none is looked at.
    pub(crate) fn is_over(&self, space: &SplineSpace<T>) -> bool {
        let shared = std::ptr::eq(space.knots().as_slice(), self.space.knots().as_slice());
        let kind = |space: &SplineSpace<T>| (space.degree(), space.dim(), space.is_periodic());
        (shared && kind(space) == kind(&self.space)) || *space == self.space
    }

    /// The material.
    pub fn material(&self) -> &Material<T> {
        &self.material
    }

    /// The coefficients that may move, in ascending order.
    pub fn moving(&self) -> &[usize] {
        &self.moving
    }

    /// The forcing matrix `C`, transposed: row `j` has the integrals `∫ N_i S_j` with the function `S_j` that is one at break
    /// `j`, zero at the others, and linear in between [Vassilev, (8) to (12)].
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, Material, Q, Scalar, SplineSpace, Stiffness};
    /// let segment = SplineSpace::new(3, (0..8).map(Q::int))?;
    /// let material = Material::new(Q::int(1), Q::int(1))?.with_hardness(Q::int(1))?;
    /// let forcing = Stiffness::new(&segment, &material, &Breadth::Whole)?.forcing().clone();
    /// assert_eq!(forcing.row(0), (0, &[4, 33, 22, 1].map(|k| Q::frac(k, 120))[..]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn forcing(&self) -> &LinearMap<T> {
        self.hats.get_or_init(|| hats::forcing(&self.space))
    }

    /// The load of a unit force at `x`: shared by the breaks on both sides of it [Vassilev, (16) and (17)].
    ///
    /// # Errors
    /// [`Error::OutsideDomain`].
    pub fn hat_load(&self, x: &T) -> Result<Functional<T>> {
        hats::hat_load(&self.space, x)
    }

    /// How the coefficients answer a load: `V_c` with `K_r V_c = load`, zero where they are held [Vassilev, (17) and (18)].
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn response(&self, load: &Functional<T>) -> Result<Vec<T>> {
        let mut response = vec![T::zero(); self.space.dim()];
        self.moving.iter().zip(self.answer(load)?).for_each(|(i, x)| response[*i] = x);
        Ok(response)
    }

    /// How the coefficients that may move answer a load, in ascending order.
    pub(crate) fn answer(&self, load: &Functional<T>) -> Result<Vec<T>> {
        let place = |i: &usize| self.moving.binary_search(i).ok();
        let mut loads = vec![T::zero(); self.moving.len()];
        for (k, weight) in load.weights().iter().enumerate() {
            if let Some(place) = place(&((load.first() + k) % self.space.dim())) {
                loads[place] += weight;
            }
        }
        if self.order == self.moving {
            self.solve(&mut loads, 1)?;
            return Ok(loads);
        }
        let places: Vec<usize> = self.order.iter().filter_map(place).collect();
        let mut values: Vec<T> = places.iter().map(|place| loads[*place].clone()).collect();
        self.solve(&mut values, 1)?;
        places.iter().zip(values).for_each(|(place, x)| loads[*place] = x);
        Ok(loads)
    }

    /// Solves in place, the values being in the order of the factor.
    fn solve<C: Coeff<T>>(&self, values: &mut [C], columns: usize) -> Result<()> {
        self.factor.solve(values, columns);
        match values.iter().position(|value| !value.all_finite()) {
            Some(index) => Err(Error::NotFinite { what: "displacement", index }),
            None => Ok(()),
        }
    }

    /// The displacements `D` with `K_r D = load`, zero where coefficients are held [Vassilev, (15)].
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is a load for each coefficient; [`Error::Ragged`]; [`Error::NotFinite`] on
    /// overflow.
    pub fn solved<C: Coeff<T>>(&self, load: &[C]) -> Result<Vec<C>> {
        self.solved_by_columns(load, 1)
    }

    /// As [`solved`](Self::solved) for several columns, load `i` of column `j` at `i * columns + j`.
    pub(crate) fn solved_by_columns<C: Coeff<T>>(&self, load: &[C], columns: usize) -> Result<Vec<C>> {
        let expected = self.space.dim() * columns;
        if load.len() != expected {
            return Err(Error::CoefficientCount { expected, found: load.len() });
        }
        check_shapes(load)?;
        let row = |i: &usize| &load[i * columns..(i + 1) * columns];
        let mut values: Vec<C> = self.order.iter().flat_map(row).cloned().collect();
        self.solve(&mut values, columns)?;
        let mut solved: Vec<C> = load.iter().map(C::zero_like).collect();
        for (i, row) in self.order.iter().zip(values.chunks_exact(columns)) {
            solved[i * columns..(i + 1) * columns].clone_from_slice(row);
        }
        Ok(solved)
    }
}

/// The energy of the coefficients in `order`, the others being zero; a basis function of a span reaches `width` places far.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::TooLarge`].
pub(crate) fn squares<T: Scalar>(
    space: &SplineSpace<T>,
    material: &Material<T>,
    (order, width): (&[usize], usize),
) -> Result<Squares<T>> {
    // One more than the place in the order; zero for those that are held.
    let mut rank = vec![0_usize; space.dim()];
    order.iter().enumerate().for_each(|(place, index)| rank[*index] = place + 1);
    let place = |i: usize| rank[space.slot(i)].checked_sub(1);
    let mut spans = spans_under(space, order);
    // Ascending along a chain; on a ring by the first place that they reach.
    let p = space.degree();
    let first = |k: &usize| (k - p..=*k).filter_map(place).min();
    if !spans.is_sorted_by_key(first) {
        spans.sort_by_cached_key(first);
    }
    let mut squares = Squares::new(order.len(), width)?;
    let mut finite = true;
    material.each_square_on(space, spans.into_iter(), |first, row, weight| {
        finite &= T::EXACT || (T::dot(row.iter().zip(row)) * weight).is_finite();
        let terms = row.iter().enumerate().filter(|(_, x)| !x.is_zero());
        squares.push(terms.filter_map(|(i, x)| Some((place(first + i)?, x.clone()))), weight);
    });
    if finite { Ok(squares) } else { Err(Error::NotFinite { what: "stiffness", index: 0 }) }
}

/// The coefficients that may move in an order in which neighbours are near, and how far a basis function of a span reaches.
///
/// Along a chain that is the order of indices. On a ring that nothing cuts open places are taken from both sides, `0, m - 1, 1,
/// m - 2, ...`, so that the band has no corners.
pub(crate) fn ordered<T: Scalar>(space: &SplineSpace<T>, moving: &[usize]) -> (Vec<usize>, usize) {
    let (p, n, m) = (space.degree(), space.dim(), moving.len());
    if !space.is_periodic() {
        return (moving.to_vec(), p + 1);
    }
    // A chain starts after `p` held ones in a row.
    let gap = |k: usize| (moving[k] + n - moving[(k + m - 1) % m] - 1) % n;
    let start = if m == 1 { Some(0) } else { (0..m).find(|k| gap(*k) >= p.max(1)) };
    match start {
        Some(start) => ((0..m).map(|k| moving[(start + k) % m]).collect(), p + 1),
        None => ((0..m).map(|k| moving[if k % 2 == 0 { k / 2 } else { m - 1 - k / 2 }]).collect(), 2 * p + 1),
    }
}

/// The non-empty spans on which some of these coefficients have influence, in ascending order.
fn spans_under<T: Scalar>(space: &SplineSpace<T>, moving: &[usize]) -> Vec<usize> {
    let (p, n, t) = (space.degree(), space.dim(), space.knots());
    let spans = p..space.unrolled_dim();
    // In a ring `n` spans, beginning with `p`, where unrolled indices turn to those of spans.
    let among = |k: usize| if space.is_periodic() { p + (k + p * n - p) % n } else { k };
    let mut moving = moving.to_vec();
    moving.sort_unstable();
    let mut reached: Vec<usize> = Vec::with_capacity(moving.len() + p);
    for i in moving {
        let start = reached.last().map_or(i, |last| i.max(last + 1));
        reached.extend(start..=i + p);
    }
    let each = reached.into_iter().map(among);
    let mut under: Vec<usize> = each.filter(|k| spans.contains(k) && t[*k] < t[k + 1]).collect();
    under.sort_unstable();
    under.dedup();
    under
}
