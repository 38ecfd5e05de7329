//! The energy of a surface with a weight for each derivative.
//!
//! ```text
//! E(S) = Σ_kl c_kl ∫∫ |∂^k+l S / ∂u^k ∂v^l|² du dv        ½ ∇E = Σ_kl c_kl K_k V K_l        [Vassilev, (21) and (23)]
//! ```
//! Row `k` of the weights is a [`Material`] along `v`, of what the derivatives of order `k` along `u` are made, so that the sum is
//! `Σ_k K_k V M_k` with the stiffness matrices `M_k` of these materials.
//!
//! An [`Elastic`](crate::Elastic) surface has weights `c_kl = x_k y_l` [Vassilev, (25)], and its system falls apart into one
//! along each direction. This one does not: it is solved as a band matrix over the grid.

use crate::coeff::{Coeff, check_shapes};
use crate::constrain::sparse::SparseRow;
use crate::deform::breadth::Breadth;
use crate::deform::factor::Factor;
use crate::deform::material::{Material, square};
use crate::deform::stiffness::ordered;
use crate::error::deform::DeformError;
use crate::error::{Error, Result};
use crate::limits::{check_degree, check_entries};
use crate::map::LinearMap;
use crate::row::Row;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::spline::TensorSpline;

/// The energy of a surface with free weights `c_kl` of its derivatives [Vassilev, (21)].
///
/// # Examples
/// How far is an elastic surface [Vassilev, (25)] from one of the eight weights that it names? The same load on both, and the
/// energy of the difference as a share:
/// ```
/// use symspline::{Breadth, Elastic, FullEnergy, Function, Material, Result, SplineSpace, TensorSpline};
/// let space = SplineSpace::uniform(3, 5, 0.0, 1.0)?;
/// let sheet = TensorSpline::constant(space.clone(), space.clone(), 0.0)?;
/// let held = [Breadth::BetweenEnds(1), Breadth::BetweenEnds(1)];
/// let load: Vec<f64> = (0..64).map(|i| if i == 27 { 1.0 } else { 0.0 }).collect();
/// let share = |hardness: f64| -> Result<f64> {
///     let material = Material::of_orders([hardness, 1.0, 2.0])?;
///     let eight = FullEnergy::of_materials(&material, &material)?.with_weight((0, 0), 0.0)?;
///     let full = eight.solved((&space, &space), &load, [&held[0], &held[1]])?;
///     let elastic = Elastic::of(&sheet, &material, &held)?.solved(&load)?;
///     let surface = |points| TensorSpline::new(space.clone(), space.clone(), points);
///     let difference = surface(full.iter().zip(&elastic).map(|(x, y)| x - y).collect())?;
///     Ok((eight.energy(&difference)? / eight.energy(&surface(full)?)?).sqrt())
/// };
/// assert!(share(0.1)? < 1e-4 && share(1000.0)? > 0.1);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct FullEnergy<T> {
    /// For each order along `u` the weights of the orders along `v`; the last has some.
    along_v: Vec<Material<T>>,
}

impl<T: Scalar> FullEnergy<T> {
    /// The energy with the weights `c_kl` row by row: row `k` has those of the derivatives of order `k` along `u`.
    ///
    /// # Errors
    /// [`DeformError::SurfaceWeight`] for a weight that is negative or not finite; [`Error::DegreeTooHigh`].
    ///
    /// # Examples
    /// ```
    /// use symspline::FullEnergy;
    /// let energy = FullEnergy::new([vec![0.0, 1.0], vec![2.0]])?;
    /// assert_eq!((energy.weight(0, 1), energy.weight(1, 0), energy.weight(7, 7)), (1.0, 2.0, 0.0));
    /// assert!(FullEnergy::new([[-1.0]]).is_err());
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn new<R: IntoIterator<Item = T>>(weights: impl IntoIterator<Item = R>) -> Result<Self> {
        let mut along_v = Vec::new();
        for (k, row) in weights.into_iter().enumerate() {
            check_degree(k)?;
            along_v.push(Material::of_orders(row).map_err(|error| in_row(k, error))?);
        }
        Ok(Self::of_rows(along_v))
    }

    fn of_rows(mut along_v: Vec<Material<T>>) -> Self {
        while along_v.last().is_some_and(|row| row.weights().is_empty()) {
            along_v.pop();
        }
        Self { along_v }
    }

    /// The energy with the eight weights of the paper: of `S_u`, `S_v`, `S_uu`, `S_uv`, `S_vv`, `S_uuv`, `S_uvv`, `S_uuvv`
    /// [Vassilev, (21)].
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// # Examples
    /// ```
    /// use symspline::FullEnergy;
    /// let energy = FullEnergy::of_eight([1, 2, 3, 4, 5, 6, 7, 8].map(f64::from))?;
    /// assert_eq!(energy, FullEnergy::new([[0.0, 2.0, 5.0], [1.0, 4.0, 7.0], [3.0, 6.0, 8.0]])?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn of_eight(weights: [T; 8]) -> Result<Self> {
        let [u, v, uu, uv, vv, uuv, uvv, uuvv] = weights;
        Self::new([[T::zero(), v, vv], [u, uv, uvv], [uu, uuv, uuvv]])
    }

    /// The energy of a membrane and a thin plate: `α (|S_u|² + |S_v|²) + β (|S_uu|² + 2 |S_uv|² + |S_vv|²)`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// # Examples
    /// ```
    /// use symspline::{FullEnergy, SplineSpace, TensorSpline};
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let saddle = TensorSpline::new(line.clone(), line, vec![0.0, 0.0, 0.0, 1.0])?;
    /// // Of u v: ∫∫ v² + u², and twice one.
    /// assert!((FullEnergy::thin_plate(3.0, 5.0)?.energy(&saddle)? - 12.0).abs() < 1e-14);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn thin_plate(stretching: T, bending: T) -> Result<Self> {
        let (a, b) = (|| stretching.clone(), || bending.clone());
        Self::new([vec![T::zero(), a(), b()], vec![a(), b() + b()], vec![b()]])
    }

    /// The energy of an elastic surface: `c_kl = x_k y_l` with the weights `x` of one material along `u` and `y` of one along
    /// `v` [Vassilev, (25)].
    ///
    /// # Errors
    /// [`DeformError::SurfaceWeight`] if a product is beyond the range.
    pub fn of_materials(u: &Material<T>, v: &Material<T>) -> Result<Self> {
        Self::new(u.weights().iter().map(|x| v.weights().iter().map(move |y| x.clone() * y)))
    }

    /// The same energy with another weight of the derivative `(k, l)`.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_weight(&self, (k, l): (usize, usize), weight: T) -> Result<Self> {
        check_degree(k)?;
        check_degree(l)?;
        let none = Material::of_orders([])?;
        let mut along_v = self.along_v.clone();
        along_v.resize(along_v.len().max(k + 1), none);
        let mut row = along_v[k].weights().to_vec();
        row.resize(row.len().max(l + 1), T::zero());
        row[l] = weight;
        along_v[k] = Material::of_orders(row).map_err(|error| in_row(k, error))?;
        Ok(Self::of_rows(along_v))
    }

    /// The weight `c_kl`.
    pub fn weight(&self, k: usize, l: usize) -> T {
        self.along_v.get(k).and_then(|row| row.weights().get(l)).cloned().unwrap_or_else(T::zero)
    }

    /// The energy `E(S)`: a sum of squares, never negative. It takes time linear in the number of coefficients.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn energy<C: Coeff<T>>(&self, s: &TensorSpline<T, C>) -> Result<T> {
        let mut energy = T::zero();
        for (k, material) in self.rows_up_to(s.u().degree()) {
            // The squares along `v` are the same for every line.
            let mut along = Vec::new();
            material
                .each_square(s.v(), |first, row, weight| along.push((first, row.to_vec(), weight.clone())));
            single(k)?.each_square(s.u(), |first, row, weight| {
                let mut sum: Vec<C> = s.row(first).iter().map(C::zero_like).collect();
                for (i, x) in row.iter().enumerate() {
                    sum.iter_mut().zip(s.row(first + i)).for_each(|(sum, c)| sum.add_scaled(x, c));
                }
                let squares =
                    along.iter().map(|(first, row, weight)| square(s.v(), (*first, row), &sum) * weight);
                energy += squares.fold(T::zero(), |sum, x| sum + x) * weight;
            });
        }
        if energy.is_finite() { Ok(energy) } else { Err(Error::NotFinite { what: "energy", index: 0 }) }
    }

    /// The load that keeps the surface as it is, half of the gradient of the energy: `Σ_kl c_kl K_k V K_l` for the coefficients
    /// `V` [Vassilev, (23)]. It takes time linear in their number.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub fn gradient<C: Coeff<T>>(&self, s: &TensorSpline<T, C>) -> Result<Vec<C>> {
        let mut sum: Vec<C> = s.coeffs().iter().map(C::zero_like).collect();
        let one = T::one();
        for (across, along) in self.matrices(s.u(), s.v())? {
            let rows: Vec<Row<C>> = s.rows().map(|row| Ok(Row(along.apply(row)?))).collect::<Result<_>>()?;
            let image = across.apply(&rows)?;
            let entries = image.iter().flat_map(|row| row.iter());
            sum.iter_mut().zip(entries).for_each(|(x, y)| x.add_scaled(&one, y));
        }
        match sum.iter().position(|x| !x.all_finite()) {
            Some(index) => Err(Error::NotFinite { what: "gradient", index }),
            None => Ok(sum),
        }
    }

    /// The stiffness matrix `Σ_kl c_kl K_k ⊗ K_l` on the coefficients row by row, one row for each: `E = Vᵀ K V`.
    ///
    /// # Errors
    /// [`Error::TooLarge`]; [`Error::NotFinite`] if in floating point an entry is beyond the range.
    ///
    /// # Examples
    /// ```
    /// use symspline::{FullEnergy, Q, Scalar, SplineSpace};
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let matrix = FullEnergy::new([vec![], vec![Q::int(0), Q::int(1)]])?.matrix(&line, &line)?;
    /// assert_eq!(matrix[0].terms(), [(0, 1), (1, -1), (2, -1), (3, 1)].map(|(i, x)| (i, Q::int(x))));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn matrix(&self, u: &SplineSpace<T>, v: &SplineSpace<T>) -> Result<Vec<SparseRow<T>>> {
        let (m, n) = (u.dim(), v.dim());
        let most = |space: &SplineSpace<T>| (2 * space.degree() + 1).min(space.dim());
        check_entries(m.saturating_mul(n), most(u).saturating_mul(most(v)))?;
        let maps = self.matrices(u, v)?;
        let mut rows = Vec::with_capacity(m * n);
        for i in 0..m {
            for j in 0..n {
                let terms = maps.iter().flat_map(|maps| products(maps, (i, j), (m, n)));
                rows.push(SparseRow::new(terms.map(|((k, l), x)| (k * n + l, x))));
            }
        }
        match rows.iter().position(|row| row.terms().iter().any(|(_, x)| !x.is_finite())) {
            Some(index) => Err(Error::NotFinite { what: "row of the stiffness matrix", index }),
            None => Ok(rows),
        }
    }

    /// The displacements of the control points under a load of each, row by row, such as [`Forces::load`](crate::Forces::load),
    /// zero where they are held. A breadth for each direction says which may move.
    ///
    /// With `m` and `n` control points that may move, `m <= n`, this takes time `m n (p m)²` and memory `m n p m`: a band as wide as
    /// the shorter side, where an [`Elastic`](crate::Elastic) surface takes linear time.
    ///
    /// # Errors
    /// [`DeformError::LooseSurface`] if some motions cost nothing; those of [`Breadth::coeffs`]; [`Error::CoefficientCount`] unless
    /// there is a load for each control point; [`Error::Ragged`]; [`Error::TooLarge`]; [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, FullEnergy, Q, Scalar, SplineSpace};
    /// let roof = SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?;
    /// let (membrane, inner) = (FullEnergy::thin_plate(Q::int(1), Q::int(0))?, Breadth::BetweenEnds(1));
    /// let mut load = vec![Q::int(0); 9];
    /// load[4] = Q::int(8);
    /// assert_eq!(membrane.solved((&roof, &roof), &load, [&inner, &inner])?[4], Q::int(3));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn solved<C: Coeff<T>>(
        &self,
        (u, v): (&SplineSpace<T>, &SplineSpace<T>),
        load: &[C],
        [along_u, along_v]: [&Breadth<T>; 2],
    ) -> Result<Vec<C>> {
        let expected = u.dim().saturating_mul(v.dim());
        if load.len() != expected {
            return Err(Error::CoefficientCount { expected, found: load.len() });
        }
        check_shapes(load)?;
        let free = [Free::new(u, along_u)?, Free::new(v, along_v)?];
        let place = Places::new(&free);
        let band = self.band((u, v), &free, &place)?;
        let grid = |rank: usize| {
            let (i, j) = place.pair(rank);
            free[0].order[i] * v.dim() + free[1].order[j]
        };
        let factor = Factor::of_band(place.width, band).map_err(|loose| DeformError::LooseSurface {
            dimension: loose.len(),
            point: loose.last().map_or(0, |rank| grid(*rank)),
        })?;
        let mut values: Vec<C> = (0..place.count).map(|rank| load[grid(rank)].clone()).collect();
        factor.solve(&mut values, 1);
        if let Some(index) = values.iter().position(|value| !value.all_finite()) {
            return Err(Error::NotFinite { what: "displacement", index });
        }
        let mut solved: Vec<C> = load.iter().map(C::zero_like).collect();
        values.into_iter().enumerate().for_each(|(rank, value)| solved[grid(rank)] = value);
        Ok(solved)
    }

    /// The upper band of the matrix of the control points that may move.
    fn band(
        &self,
        (u, v): (&SplineSpace<T>, &SplineSpace<T>),
        free: &[Free; 2],
        place: &Places,
    ) -> Result<Vec<T>> {
        check_entries(place.count, place.width)?;
        let maps = self.matrices(u, v)?;
        let size = (u.dim(), v.dim());
        let mut band = vec![T::zero(); place.count * place.width];
        for rank in 0..place.count {
            let (i, j) = place.pair(rank);
            let row = &mut band[rank * place.width..][..place.width];
            for maps in &maps {
                for ((k, l), x) in products(maps, (free[0].order[i], free[1].order[j]), size) {
                    let (Some(k), Some(l)) = (free[0].rank[k], free[1].rank[l]) else { continue };
                    if let Some(offset) = place.rank(k, l).checked_sub(rank) {
                        row[offset] += x;
                    }
                }
            }
            if !row.iter().all(T::is_finite) {
                return Err(Error::NotFinite { what: "row of the stiffness matrix", index: rank });
            }
        }
        Ok(band)
    }

    /// The orders along `u` up to a degree that have weights, with these.
    fn rows_up_to(&self, degree: usize) -> impl Iterator<Item = (usize, &Material<T>)> {
        let rows = self.along_v.iter().enumerate().take(degree + 1);
        rows.filter(|(_, material)| !material.weights().is_empty())
    }

    /// `K_k` and `M_k` for each order along `u` that has weights.
    fn matrices(&self, u: &SplineSpace<T>, v: &SplineSpace<T>) -> Result<Vec<(LinearMap<T>, LinearMap<T>)>> {
        let rows = self.rows_up_to(u.degree());
        rows.map(|(k, material)| Ok((single(k)?.matrix(u)?, material.matrix(v)?))).collect()
    }
}

/// The material that weighs the derivative of one order alone.
fn single<T: Scalar>(order: usize) -> Result<Material<T>> {
    Material::of_orders(std::iter::repeat_n(T::zero(), order).chain([T::one()]))
}

/// Says in which row a weight is wrong.
fn in_row(k: usize, error: Error) -> Error {
    match error {
        Error::Deform(DeformError::Material { order, weight }) => {
            DeformError::SurfaceWeight { k, l: order, weight }.into()
        }
        other => other,
    }
}

/// The entries of row `(i, j)` of `K ⊗ M`, for a grid of some size.
fn products<'a, T: Scalar>(
    (across, along): &'a (LinearMap<T>, LinearMap<T>),
    (i, j): (usize, usize),
    (m, n): (usize, usize),
) -> impl Iterator<Item = ((usize, usize), T)> + use<'a, T> {
    let ((first, row), (start, other)) = (across.row(i), along.row(j));
    row.iter().enumerate().flat_map(move |(k, x)| {
        let at = move |l: usize| ((first + k) % m, (start + l) % n);
        other.iter().enumerate().map(move |(l, y)| (at(l), x.clone() * y))
    })
}

/// The coefficients along one direction that may move.
struct Free {
    order: Vec<usize>,
    /// For each coefficient its place in that order.
    rank: Vec<Option<usize>>,
    width: usize,
}

impl Free {
    fn new<T: Scalar>(space: &SplineSpace<T>, breadth: &Breadth<T>) -> Result<Self> {
        let (order, width) = ordered(space, &breadth.coeffs(space)?);
        let mut rank = vec![None; space.dim()];
        order.iter().enumerate().for_each(|(place, index)| rank[*index] = Some(place));
        let width = width.min(order.len());
        Ok(Self { order, rank, width })
    }
}

/// The control points of a grid that may move in one list, with the narrower band of the two directions.
struct Places {
    count: usize,
    /// How far a row of the matrix reaches, its diagonal included.
    width: usize,
    /// The number of those along the inner direction.
    columns: usize,
    /// Whether the inner direction is `u`.
    turned: bool,
}

impl Places {
    fn new([u, v]: &[Free; 2]) -> Self {
        let (m, n) = (u.order.len(), v.order.len());
        let wide = |outer: &Free, inner: &Free| (outer.width - 1) * inner.order.len() + inner.width;
        let turned = wide(v, u) < wide(u, v);
        let (width, columns) = if turned { (wide(v, u), m) } else { (wide(u, v), n) };
        Self { count: m * n, width, columns, turned }
    }

    fn rank(&self, i: usize, j: usize) -> usize {
        if self.turned { j * self.columns + i } else { i * self.columns + j }
    }

    fn pair(&self, rank: usize) -> (usize, usize) {
        let (outer, inner) = (rank / self.columns, rank % self.columns);
        if self.turned { (inner, outer) } else { (outer, inner) }
    }
}
