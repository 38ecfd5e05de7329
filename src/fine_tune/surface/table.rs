//! Fine tuning of one surface along one path as a table: the differences of control points depend on few values of `α` each.
//!
//! ```text
//! T_{i,0} = edge,   T_{i,j+1} = T_{i,j} + Σ_kl α_kl w_ij,kl
//! ```
//! with `i` across the direction in which the path ends and `j` along it; `w_ij,kl` is control point `ij` of `φ_k ψ_l S_v` times
//! the mass of its basis function along the direction. So tuning takes a short sum for each control point, as for
//! [curves](crate::fine_tune::table).

use crate::bilinear::BilinearMap;
use crate::coeff::Coeff;
use crate::error::Result;
use crate::fine_tune::table::Table;
use crate::functional::{Functional, weigh};
use crate::limits::check_entries;
use crate::map::LinearMap;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::{Surface, transposed};
use nalgebra::SVector;

/// The table of a surface for one path. All is seen with the direction in which the path ends as the second one.
#[derive(Clone, Debug)]
pub(crate) struct PathTable<T, const N: usize> {
    /// The direction in which the path ends.
    pub last: Direction,
    /// How many values of `α` there are across and along.
    scales: [usize; 2],
    /// How many control points a line along the direction has.
    pub length: usize,
    edge: Edge<T, N>,
    legs: Vec<Leg>,
    weights: Vec<SVector<T, N>>,
}

/// Where lines of control points start.
#[derive(Clone, Debug)]
enum Edge<T, const N: usize> {
    /// Points that stay.
    Held(Vec<SVector<T, N>>),
    /// The edge tuned along itself: its own table, the values of `α` there, and its points among those of the surface.
    Tuned { table: Box<Table<T, N>>, scale: Functional<T>, points: LinearMap<T> },
}

/// The first value of `α` that a leg depends on, how many it does across and along, and where its weights are.
#[derive(Clone, Copy, Debug)]
struct Leg {
    first: [usize; 2],
    size: [usize; 2],
    weights: usize,
}

impl<T: Scalar, const N: usize> PathTable<T, N> {
    /// The table of the path that ends in `last`, for control points over `spaces`, those of the surfaces of this path, along
    /// an edge that stays or is tuned.
    ///
    /// # Errors
    /// As [`fine_tuned`](Surface::fine_tuned) has them.
    pub(crate) fn new(
        surface: &Surface<T, N>,
        scales: [&SplineSpace<T>; 2],
        last: Direction,
        spaces: [&SplineSpace<T>; 2],
        held: bool,
    ) -> Result<Self> {
        if last == U {
            let turned = |[u, v]: [&'_ SplineSpace<T>; 2]| [v.clone(), u.clone()];
            let (scales, spaces) = (turned(scales), turned(spaces));
            let table = Self::ending_in_v(&surface.transposed(), scales.each_ref(), spaces.each_ref(), held)?;
            return Ok(Self { last, ..table });
        }
        Self::ending_in_v(surface, scales, spaces, held)
    }

    fn ending_in_v(
        surface: &Surface<T, N>,
        scales: [&SplineSpace<T>; 2],
        spaces: [&SplineSpace<T>; 2],
        held: bool,
    ) -> Result<Self> {
        let start = surface.v().domain().0;
        let curve = surface.isocurve(V, start)?;
        let edge = if held {
            let curve = if spaces[0].is_periodic() { curve } else { curve.clamped_ends()? };
            Edge::Held(curve.embedded(spaces[0])?.into_coeffs())
        } else {
            let table = Box::new(Table::open(&curve, scales[0])?);
            let points = table.space.embedding(spaces[0])?;
            Edge::Tuned { table, scale: scales[1].basis(start)?, points }
        };
        let speed = surface.derivative(V)?.along(V, |rows| rows.clamped_ends())?;
        let across =
            onto(surface.u().multiplication(scales[0])?, &surface.u().product_space(scales[0])?, spaces[0])?;
        let opened = scales[1].clamped_ends()?;
        let along = speed.v().multiplication(&opened)?;
        let target = speed.v().product_space(&opened)?;
        let table = Self {
            last: V,
            scales: scales.map(SplineSpace::dim),
            length: spaces[1].dim(),
            edge,
            legs: Vec::new(),
            weights: Vec::new(),
        };
        table.with_legs(&speed, &across, &along, &scales[1].embedding(&opened)?, &target)
    }

    /// The same with its legs, from the products across and along.
    fn with_legs(
        mut self,
        speed: &Surface<T, N>,
        across: &BilinearMap<T>,
        along: &BilinearMap<T>,
        opening: &LinearMap<T>,
        target: &SplineSpace<T>,
    ) -> Result<Self> {
        // Each row of the derivative times functions of v.
        let mut rows = Vec::with_capacity(speed.u().dim());
        for row in speed.rows() {
            let axis = |axis: usize| {
                let coeffs: Vec<T> = row.iter().map(|c| c[axis].clone()).collect();
                along.fix_left(&coeffs)?.after(opening)
            };
            rows.push((0..N).map(axis).collect::<Result<Vec<LinearMap<T>>>>()?);
        }
        check_entries(across.target_dim(), target.dim().saturating_mul(N))?;
        for outer in across.rows() {
            let height = outer.weights.first().map_or(0, Vec::len);
            for j in 0..target.dim() {
                let mass = target.mass(j);
                let wide =
                    |i: usize| rows[(outer.first.0 + i) % rows.len()].iter().map(move |map| map.row(j));
                // The window that all axes of all rows lie in; rows of one product start at one place.
                let windows = (0..outer.weights.len()).flat_map(wide);
                let (low, high) = windows.fold((usize::MAX, 0), |(low, high), (first, weights)| {
                    (low.min(first), high.max(first + weights.len()))
                });
                let width = high.saturating_sub(low);
                let low = if width == 0 { 0 } else { low };
                let leg =
                    Leg { first: [outer.first.1, low], size: [height, width], weights: self.weights.len() };
                check_entries(self.weights.len() + height * width, N)?;
                self.weights.resize(leg.weights + height * width, SVector::zeros());
                let window = &mut self.weights[leg.weights..];
                for (i, shares) in outer.weights.iter().enumerate() {
                    for (axis, (first, weights)) in wide(i).enumerate() {
                        let places = (first - low..).zip(weights);
                        for (l, weight) in places {
                            let weight = weight.clone() * &mass;
                            for (k, share) in shares.iter().enumerate() {
                                window[k * width + l][axis] += weight.clone() * share;
                            }
                        }
                    }
                }
                self.legs.push(leg);
            }
        }
        Ok(self)
    }

    /// The control points of the surface tuned by `alpha`, its values over `(u, v)`, line after line along the direction in
    /// which the path ends.
    pub(crate) fn lines(&self, alpha: &[T]) -> Vec<SVector<T, N>> {
        let turned: Vec<T>;
        let alpha = match self.last {
            V => alpha,
            U => {
                turned = transposed(alpha, self.scales[0]);
                &turned
            }
        };
        let columns = self.scales[1];
        let edge = match &self.edge {
            Edge::Held(points) => points.clone(),
            Edge::Tuned { table, scale, points } => {
                let along: Vec<T> = alpha.chunks_exact(columns).map(|row| scale.apply(row)).collect();
                let mut own = vec![SVector::zeros(); table.space.dim()];
                table.tune_into(&along, &mut own);
                points.rows().map(|(first, weights)| weigh(first, weights, &own)).collect()
            }
        };
        let mut points = Vec::with_capacity(edge.len() * self.length);
        for (mut place, legs) in edge.into_iter().zip(self.legs.chunks_exact(self.length - 1)) {
            for leg in legs {
                points.push(place.clone());
                self.advance(&mut place, leg, alpha);
            }
            points.push(place);
        }
        points
    }

    /// Adds a leg to a place.
    #[inline]
    fn advance(&self, place: &mut SVector<T, N>, leg: &Leg, alpha: &[T]) {
        let [rows, columns] = self.scales;
        let ([k, l], [height, width]) = (leg.first, leg.size);
        let mut weights = self.weights[leg.weights..].iter();
        for k in k..k + height {
            let row = &alpha[k % rows * columns..][..columns];
            if l + width <= columns {
                row[l..l + width].iter().zip(&mut weights).for_each(|(a, w)| place.add_scaled(a, w));
            } else {
                (l..l + width).zip(&mut weights).for_each(|(l, w)| place.add_scaled(&row[l % columns], w));
            }
        }
    }
}

/// The products of two spaces as members of a larger one.
fn onto<T: Scalar>(
    product: BilinearMap<T>,
    from: &SplineSpace<T>,
    to: &SplineSpace<T>,
) -> Result<BilinearMap<T>> {
    if from == to { Ok(product) } else { product.then(&from.embedding(to)?) }
}
