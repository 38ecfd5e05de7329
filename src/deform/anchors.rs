//! Constraints that are met while the energy is least.

use crate::coeff::Coeff;
use crate::constrain::least::{Excess, dependencies, least_moves};
use crate::constrain::sparse::SparseRow;
use crate::deform::elastic::Elastic;
use crate::deform::forces::Forces;
use crate::deform::stiffness::Stiffness;
use crate::error::deform::DeformError;
use crate::error::shape::ShapeError;
use crate::error::{Error, Result};
use crate::limits::check_entries;
use crate::row::Row;
use crate::scalar::{Scalar, larger_size};
use crate::shape::constraints::{Constraints, Wanted};
use crate::shape::controlled::Controlled;
use crate::spline::Spline;
use crate::tensor::spline::transposed;

/// Constraints on an elastic shape, ready to be changed.
///
/// ```text
/// K D = load + Aᵀ λ,   A D = b            (A K⁻¹ Aᵀ) λ = b - A K⁻¹ load
/// ```
/// Of all displacements with `A D = b` this is the one of least energy. The multipliers `λ` are the forces that hold the shape:
/// they act on it as forces with [`Spread::Point`](crate::Spread::Point) do. Made once for `s` constraints by as many solutions with
/// `K`, a drag takes `s²` operations and one solution, over floats a few. The constrained values of a rational shape are those of
/// shapes with the same weights.
///
/// # Examples
/// A surface is lifted in the middle, while a corner keeps its point and its tangents:
/// ```
/// use nalgebra::vector;
/// use symspline::{Breadth, Constraints, Elastic, Material, Q, Scalar, SplineSpace, Surface};
/// let line = SplineSpace::uniform(3, 2, Q::int(0), Q::int(1))?;
/// let point = |k: i64| vector![Q::int(k / 5), Q::int(k % 5), Q::int(0)];
/// let mut sheet = Surface::new(line.clone(), line, (0..25).map(point).collect())?;
/// let material = Material::new(Q::int(1), Q::int(1))?.with_hardness(Q::int(1))?;
/// let elastic = Elastic::of(&sheet, &material, &[Breadth::Whole, Breadth::Whole])?;
/// let (middle, corner) = ((Q::frac(1, 2), Q::frac(1, 2)), (Q::int(0), Q::int(0)));
/// let held = Constraints::on(&sheet).point(&middle)?;
/// let held = held.point(&corner)?.derivative(&corner, (1, 0))?.derivative(&corner, (0, 1))?;
/// let flat = sheet.clone();
/// let [up, zero] = [1, 0].map(|z| vector![Q::int(0), Q::int(0), Q::int(z)]);
/// elastic.anchored(&held)?.drag(&mut sheet, &[up.clone(), zero.clone(), zero.clone(), zero])?;
/// assert_eq!(sheet.at(&middle.0, &middle.1)?, flat.at(&middle.0, &middle.1)? + up);
/// assert_eq!(sheet.derivative_at(&corner.0, &corner.1, 1, 0)?, flat.derivative_at(&corner.0, &corner.1, 1, 0)?);
/// # Ok::<(), symspline::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Anchored<T: Scalar, S: Controlled<T>> {
    elastic: Elastic<T>,
    wanted: Vec<Wanted<T, S>>,
    /// The rows on the control points that may move.
    free: Vec<SparseRow<T>>,
    compliance: Compliance<T>,
}

impl<T: Scalar> Elastic<T> {
    /// These constraints, to be met with the least energy.
    ///
    /// Which control points may move is a matter of the breadth of this body.
    ///
    /// # Errors
    /// [`ShapeError::Dependent`] and [`ShapeError::Overdetermined`] if a constraint follows from others, in floating point up to
    /// rounding, or has no control points to move;
    /// [`DeformError::Meaningless`] if the constraints hold or weigh control points or allow least squares;
    /// [`DeformError::OtherSpace`]; [`Error::NotFinite`] on overflow; [`Error::TooLarge`].
    pub fn anchored<S: Controlled<T>>(&self, constraints: &Constraints<'_, T, S>) -> Result<Anchored<T, S>> {
        self.check(constraints.shape)?;
        let meaningless = [
            (!constraints.held.is_empty() || constraints.free.is_some(), "held and free control points"),
            (!constraints.weights.is_empty(), "weights of movement"),
            (constraints.excess != Excess::Refused, "least squares"),
        ];
        if let Some((_, what)) = meaningless.into_iter().find(|(asked, _)| *asked) {
            return Err(DeformError::Meaningless { what }.into());
        }
        let moves = self.mask();
        let wanted = constraints.wanted.clone();
        let free: Vec<SparseRow<T>> = wanted.iter().map(|wanted| wanted.row.without(|i| !moves[i])).collect();
        check_entries(free.len(), free.len())?;
        if !T::EXACT && !free.is_empty() {
            // The rows themselves tell dependence better than their compliance, which is a soft body's.
            least_moves(&free, |_| T::one(), Excess::Refused)?;
        }
        let mut compliance = vec![Vec::new(); free.len()];
        let zero = vec![T::zero(); moves.len()];
        for (i, row) in free.iter().enumerate() {
            let mut load = zero.clone();
            row.terms().iter().for_each(|(k, w)| load[*k] = w.clone());
            let answer = self.solved(&load)?;
            compliance[i] = free[..=i].iter().map(|row| row.apply(&answer).unwrap_or_else(T::zero)).collect();
        }
        Ok(Anchored { elastic: self.clone(), wanted, free, compliance: Compliance::new(compliance)? })
    }

    /// Which control points may move.
    fn mask(&self) -> Vec<bool> {
        let along = |stiffness: &Stiffness<T>| {
            let mut moves = vec![false; stiffness.space().dim()];
            stiffness.moving().iter().for_each(|i| moves[*i] = true);
            moves
        };
        let masks: Vec<Vec<bool>> = self.stiffnesses().iter().map(along).collect();
        let both = |all: Vec<bool>, next: &Vec<bool>| {
            all.iter().flat_map(|a| next.iter().map(move |b| *a && *b)).collect()
        };
        masks.iter().fold(vec![true], both)
    }

    /// The gradient of the energy, but for the factor 2: `K V` or `K_u V K_v`, for all control points [Vassilev, (25)].
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is one for each control point; [`Error::Ragged`];
    /// [`Error::NotFinite`] on overflow.
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, Elastic, Function, Material, Q, Scalar, SplineSpace};
    /// let f = Function::new(SplineSpace::clamped(1, [0, 1, 2].map(Q::int))?, [0, 3, 0].map(Q::int).to_vec())?;
    /// let elastic = Elastic::of(&f, &Material::new(Q::int(1), Q::int(0))?, &[Breadth::BetweenEnds(1)])?;
    /// assert_eq!(elastic.gradient(f.coeffs())?, [-3, 6, -3].map(Q::int));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn gradient<C: Coeff<T>>(&self, coeffs: &[C]) -> Result<Vec<C>> {
        let [u, v] = self.stiffnesses() else {
            let along = &self.stiffnesses()[0];
            return along.material().gradient(along.space(), coeffs);
        };
        let (m, n) = (u.space().dim(), v.space().dim());
        if coeffs.len() != m * n {
            return Err(Error::CoefficientCount { expected: m * n, found: coeffs.len() });
        }
        let along = |along: &Stiffness<T>, grid: &[C], columns: usize| -> Result<Vec<C>> {
            let rows: Vec<Row<C>> = grid.chunks_exact(columns).map(|row| Row(row.to_vec())).collect();
            let loads = along.material().gradient(along.space(), &rows)?;
            Ok(loads.into_iter().flat_map(|row| row.0).collect())
        };
        let across = along(u, coeffs, n)?;
        Ok(transposed(&along(v, &transposed(&across, n), m)?, m))
    }
}

impl<T: Scalar, S: Controlled<T>> Anchored<T, S> {
    /// The rows of `A`, in the order of the constraints.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &SparseRow<T>> {
        self.wanted.iter().map(|wanted| &wanted.row)
    }

    /// Changes the constrained values by `changes`, one vector each, and returns the forces `λ` that this took. On an error
    /// the shape stays as it is.
    ///
    /// # Errors
    /// [`Error::CoefficientCount`] unless there is a change for each constraint; [`Error::Ragged`];
    /// [`DeformError::OtherSpace`], [`Error::NotFinite`] on overflow; [`DeformError::Unmet`] if in floating point many constraints
    /// lie so close together on a long chain that rounding is all that tells them apart.
    pub fn drag(&self, shape: &mut S, changes: &[S::Point]) -> Result<Vec<S::Point>> {
        self.elastic.check(shape)?;
        self.check_count(changes.len())?;
        let Some(zero) = changes.first().map(S::Point::zero_like) else { return Ok(Vec::new()) };
        self.displace(shape, vec![zero; shape.control_count()], changes)
    }

    /// Gives the constrained values the values `targets`, and returns the forces that this took. On an error the shape stays as it is.
    ///
    /// # Errors
    /// As [`drag`](Self::drag); [`Error::Weight`] if a row weighs a control point at infinity.
    pub fn meet(&self, shape: &mut S, targets: &[S::Point]) -> Result<Vec<S::Point>> {
        self.elastic.check(shape)?;
        self.check_count(targets.len())?;
        let gap = |(wanted, target): (&Wanted<T, S>, &S::Point)| wanted.gap(shape, target);
        let changes = self.wanted.iter().zip(targets).map(gap).collect::<Result<Vec<_>>>()?;
        self.drag(shape, &changes)
    }

    /// Adds forces to those on the shape, while the constrained values stay as they are, and returns the forces that hold them. On an
    /// error the shape stays as it is.
    ///
    /// # Errors
    /// As [`drag`](Self::drag).
    ///
    /// # Examples
    /// ```
    /// use symspline::{Breadth, Constraints, Elastic, Forces, Function, Material, Q, Scalar, SplineSpace};
    /// let mut rod = Function::constant(SplineSpace::clamped(1, [0, 1, 2, 3].map(Q::int))?, Q::int(0))?;
    /// let elastic = Elastic::of(&rod, &Material::new(Q::int(1), Q::int(0))?, &[Breadth::BetweenEnds(1)])?;
    /// let held = elastic.anchored(&Constraints::on(&rod).point(&Q::int(2))?)?;
    /// let mut forces = Forces::new(&elastic, &rod)?;
    /// forces.at_breaks(&[0, 6, 0, 0].map(Q::int))?;
    /// let reaction = held.push(&mut rod, &forces)?;
    /// assert_eq!((rod.coeffs(), reaction), (&[0, 2, 0, 0].map(Q::int)[..], vec![Q::int(-3)]));
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn push(&self, shape: &mut S, forces: &Forces<'_, T, S>) -> Result<Vec<S::Point>> {
        self.elastic.check(shape)?;
        let load = forces.load()?;
        let zero = load[0].zero_like();
        self.displace(shape, load, &vec![zero; self.wanted.len()])
    }

    /// Gives the constrained values the points of a curve at [even parameters](crate::SplineSpace::even_parameters), and returns the forces
    /// that this took: a curve on a surface, constrained by [`Constraints::along`], is moved onto another in space [Vassilev, section
    /// 3.6]. On an error the shape stays as it is.
    ///
    /// # Errors
    /// As [`meet`](Self::meet); those of [`SplineSpace::even_parameters`](crate::SplineSpace::even_parameters).
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Breadth, Constraints, Curve, Elastic, Function, Material, SplineSpace, TensorSpline};
    /// let space = SplineSpace::uniform(3, 4, 0.0, 1.0)?;
    /// let mut plane = TensorSpline::constant(space.clone(), space, 0.0)?;
    /// let line = SplineSpace::bezier(1, 0.0, 1.0)?;
    /// let diagonal = Curve::new(line, vec![vector![0.25, 0.25], vector![0.75, 0.75]])?;
    /// let hill = Function::new(SplineSpace::bezier(2, 0.0, 1.0)?, vec![0.0, 1.0, 0.0])?;
    /// let material = Material::new(1.0, 1.0)?.with_hardness(1.0)?;
    /// let elastic = Elastic::of(&plane, &material, &[Breadth::Whole, Breadth::Whole])?;
    /// let held = elastic.anchored(&Constraints::on(&plane).along(&diagonal, 5)?)?;
    /// held.meet_curve(&mut plane, &hill)?;
    /// assert!((plane.at(&0.5, &0.5)? - 0.5).abs() < 1e-12);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn meet_curve(&self, shape: &mut S, target: &Spline<T, S::Point>) -> Result<Vec<S::Point>> {
        let parameters = target.space().even_parameters(self.wanted.len())?;
        let targets = parameters.iter().map(|t| target.at(t)).collect::<Result<Vec<_>>>()?;
        self.meet(shape, &targets)
    }

    /// Takes all other forces from the shape: of all shapes with these constrained values, and with the control points that may not
    /// move, the one of least energy. On an error the shape stays as it is.
    ///
    /// # Errors
    /// As [`drag`](Self::drag); [`Error::Weight`] if a control point is at infinity.
    ///
    /// # Examples
    /// The curve that bends least between its ends, through a point and with a tangent:
    /// ```
    /// use symspline::{Breadth, Constraints, Elastic, Function, Material, Q, Scalar, SplineSpace};
    /// let coeffs = [0, 5, -2, 7, 0].map(Q::int).to_vec();
    /// let mut f = Function::new(SplineSpace::clamped(3, [0, 1, 2].map(Q::int))?, coeffs)?;
    /// let bending = Material::new(Q::int(0), Q::int(1))?;
    /// let elastic = Elastic::of(&f, &bending, &[Breadth::BetweenEnds(1)])?;
    /// let one = Q::int(1);
    /// let held = elastic.anchored(&Constraints::on(&f).point(&one)?)?;
    /// let (before, middle) = (bending.energy(&f)?, f.at(&one)?);
    /// held.relax(&mut f)?;
    /// // A natural cubic spline through three points.
    /// assert_eq!((f.at(&one)?, f.derivative_at(&Q::int(0), 2)?), (middle, Q::int(0)));
    /// assert!(bending.energy(&f)? < before);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn relax(&self, shape: &mut S) -> Result<Vec<S::Point>> {
        self.elastic.check(shape)?;
        let mut relaxed = shape.clone();
        let mut forces: Vec<S::Point> = Vec::new();
        // Over floats a second time, for what rounding of a large load left behind.
        for _ in 0..if T::EXACT { 1 } else { 2 } {
            let mut load = self.elastic.gradient(&relaxed.control_points()?)?;
            load.iter_mut().for_each(|c| c.scale(&-T::one()));
            let zero = load[0].zero_like();
            forces = self.displace(&mut relaxed, load, &vec![zero; self.wanted.len()])?;
        }
        *shape = relaxed;
        Ok(forces)
    }

    fn check_count(&self, found: usize) -> Result<()> {
        let expected = self.wanted.len();
        if found == expected { Ok(()) } else { Err(Error::CoefficientCount { expected, found }) }
    }

    /// Moves control points under a load so that constrained values change in this way.
    fn displace(
        &self,
        shape: &mut S,
        mut load: Vec<S::Point>,
        changes: &[S::Point],
    ) -> Result<Vec<S::Point>> {
        if let Some(index) = changes.iter().position(|change| !change.same_shape(&load[0])) {
            return Err(Error::Ragged { index });
        }
        let mut moved =
            if load.iter().all(S::Point::vanishes) { load.clone() } else { self.elastic.solved(&load)? };
        let mut forces: Vec<S::Point> = changes.iter().map(S::Point::zero_like).collect();
        let size = |points: &[S::Point]| {
            points.iter().flat_map(S::Point::components).map(T::magnitude).fold(T::zero(), larger_size)
        };
        let (mut first, mut last) = (None, None);
        // Over floats again, as long as that halves what rounding left open.
        loop {
            let open = |(row, change): (&SparseRow<T>, &S::Point)| match row.apply(&moved) {
                Some(value) => change.minus(&value),
                None => change.clone(),
            };
            let mut more: Vec<S::Point> = self.free.iter().zip(changes).map(open).collect();
            let gap = size(&more);
            if !gap.is_finite() {
                return Err(Error::NotFinite { what: "constrained value", index: 0 });
            }
            if gap.is_zero() {
                break;
            }
            let allowed = first.get_or_insert_with(|| gap.clone()).clone() * T::frac(1, 1 << 20);
            if last.is_some_and(|last| T::EXACT || gap.clone() + &gap > last) {
                if gap > allowed + size(&moved) * T::frac(1, 1 << 40) {
                    return Err(DeformError::Unmet { open: gap.to_string() }.into());
                }
                break;
            }
            last = Some(gap);
            self.compliance.solve(&mut more);
            load.iter_mut().for_each(|c| *c = c.zero_like());
            for ((row, by), force) in self.free.iter().zip(&more).zip(&mut forces) {
                force.add_scaled(&T::one(), by);
                row.terms().iter().for_each(|(i, w)| load[*i].add_scaled(w, by));
            }
            let further = self.elastic.solved(&load)?;
            moved.iter_mut().zip(&further).for_each(|(d, e)| d.add_scaled(&T::one(), e));
        }
        let moves: Vec<(usize, S::Point)> =
            moved.into_iter().enumerate().filter(|(_, d)| !d.vanishes()).collect();
        shape.move_points(&moves)?;
        Ok(forces)
    }
}

/// The matrix `A K⁻¹ Aᵀ = L D Lᵀ`: how far one constrained value gives under the force of another.
#[derive(Clone, Debug)]
struct Compliance<T> {
    /// Row `i` of `L` before the diagonal.
    lower: Vec<Vec<T>>,
    pivots: Vec<T>,
}

impl<T: Scalar> Compliance<T> {
    /// The factors of a matrix of which the lower half is given, row by row.
    fn new(matrix: Vec<Vec<T>>) -> Result<Self> {
        let (mut lower, mut pivots): (Vec<Vec<T>>, Vec<T>) = (Vec::new(), Vec::new());
        for (condition, mut row) in matrix.into_iter().enumerate() {
            let own = row.pop().unwrap_or_else(T::zero);
            if !own.is_finite() || !row.iter().all(T::is_finite) {
                return Err(Error::NotFinite { what: "compliance of constraint", index: condition });
            }
            // Entry j becomes L_ij D_j.
            for (j, other) in lower.iter().enumerate() {
                let known = T::dot(row[..j].iter().zip(other));
                row[j] -= known;
            }
            let shares: Vec<T> = row.iter().zip(&pivots).map(|(x, pivot)| x.clone() / pivot).collect();
            let pivot = own.clone() - T::dot(row.iter().zip(&shares));
            let independent = pivot > T::zero();
            if !independent {
                return Err(ShapeError::Dependent { condition, on: dependencies(&shares, &lower) }.into());
            }
            lower.push(shares);
            pivots.push(pivot);
        }
        Ok(Self { lower, pivots })
    }

    fn solve<C: Coeff<T>>(&self, values: &mut [C]) {
        for (i, row) in self.lower.iter().enumerate() {
            let (known, rest) = values.split_at_mut(i);
            row.iter().zip(known).for_each(|(x, y)| rest[0].add_scaled(&-x.clone(), y));
        }
        values.iter_mut().zip(&self.pivots).for_each(|(value, pivot)| value.divide(pivot));
        for (i, row) in self.lower.iter().enumerate().rev() {
            let (above, rest) = values.split_at_mut(i);
            row.iter().zip(above).for_each(|(x, y)| y.add_scaled(&-x.clone(), &rest[0]));
        }
    }
}
