//! Conditions on a fine-tuned surface, as conditions on the values of its scale function.
//!
//! For a fixed surface and path `T` is affine in the coefficients `a_j` of `α = Σ a_j φ_j`:
//!
//! ```text
//! T = S(a, c) + Σ_j a_j G_j,     G_j what φ_j makes of S from the origin
//! ```
//! so that where `T` passes, whether its edges stay, and whether it closes, are linear conditions on `a`. Nothing is rotated or
//! scaled, so that `∂T/∂v = α S_v` holds along the path.
//!
//! A scale that keeps the edges of every surface of some spaces, whatever its control points are, is `1` on the border, and its
//! difference from `1` is orthogonal to the derivatives of those surfaces, line by line; for a given surface less is needed, and
//! that is what is asked for here.

use crate::coeff::Coeff;
use crate::constrain::norm::{CoeffSpace, Norm, SpacePair};
use crate::error::tune::TuneError;
use crate::error::{Error, Result};
use crate::fine_tune::ends::check_count;
use crate::fine_tune::nearest_scale::NearestScale;
use crate::functional::Functional;
use crate::limits::check_entries;
use crate::ops::bound::epsilon;
use crate::scalar::{Scalar, larger};
use crate::space::SplineSpace;
use crate::tensor::along::Direction::{self, U, V};
use crate::tensor::spline::Surface;
use nalgebra::SVector;

use super::edges::{Edge, Edges};
use super::path::Path;
use super::ways::Ways;

/// What a fine-tuned surface `T` of `S` must do; both start at one corner.
#[derive(Clone, Debug, PartialEq)]
pub enum SurfaceCondition<T, const N: usize> {
    /// An edge stays, and the derivatives across it up to `order`.
    Edge {
        /// Which.
        edge: Edge,
        /// The order.
        order: usize,
    },
    /// The surface closes: both edges of `direction` are the same curve. Of a surface and a scale that are periodic there the
    /// derivatives across the seam then agree as well, as far as those of the scale do; so
    /// [`projected`](crate::Spline::projected) along the direction to the periodic product space gives the same surface over
    /// that.
    Closed {
        /// The direction that goes around.
        direction: Direction,
    },
    /// A derivative at a point has a value: `∂_u^k ∂_v^l T(u, v) = value`, the point itself with `(0, 0)`.
    Derivative {
        /// `(u, v)`.
        at: (T, T),
        /// `(k, l)`.
        order: (usize, usize),
        /// The value.
        value: SVector<T, N>,
    },
    /// `α(u, v) = value`.
    Scale {
        /// `(u, v)`.
        at: (T, T),
        /// The value.
        value: T,
    },
    /// Coefficient `(i, j)` of `α` is `value`.
    Coefficient {
        /// `(i, j)`.
        index: (usize, usize),
        /// The value.
        value: T,
    },
}

impl<T: Scalar> NearestScale<T, SpacePair<T>> {
    /// The conditions on fine-tuned versions of `surface` along `path` by scale functions over the pair `scales`, nearness
    /// measured by `norm`.
    ///
    /// To keep whole edges takes a scale with more coefficients than the surface has in each direction: some
    /// `n + 2` where that has `n`.
    ///
    /// # Errors
    /// [`Error::DomainMismatch`]; [`Error::OutsideDomain`] for the parameters of a condition; [`Error::IndexOutOfRange`];
    /// [`TuneError::NoEdge`] if an edge is that of a direction in which the surface is periodic;
    /// [`Error::CoefficientCount`] if there are too few lines of control points for the order at an edge; [`Error::NotFinite`];
    /// [`Error::Discontinuous`] if the surface may jump; [`Error::TooLarge`].
    ///
    /// # Examples
    /// A tube tuned around that stays closed, exactly:
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Direction, NearestScale, Norm, Path, Q, Scalar, SplineSpace, Surface, SurfaceCondition, TensorSpline};
    /// let ring = SplineSpace::uniform_periodic(2, 4, Q::int(0), Q::int(1))?;
    /// let line = SplineSpace::bezier(1, Q::int(0), Q::int(1))?;
    /// let corners = [(0, 0), (4, 0), (5, 3), (1, 4)];
    /// let points = corners.iter().flat_map(|(x, y)| [0, 2].map(|z| vector![Q::int(*x), Q::int(*y), Q::int(z)]));
    /// let tube = Surface::new(ring.clone(), line.clone(), points.collect())?;
    /// let scales = (ring.derivative_space()?, line);
    /// let closed = [SurfaceCondition::Closed { direction: Direction::U }];
    /// let nearest = NearestScale::on_surface(&tube, (&scales.0, &scales.1), Path::VThenU, &closed, Norm::L2)?;
    /// let wanted = TensorSpline::new(scales.0, scales.1, [2, 4, 3, 2, 2, 2, 2, 3].map(|a| Q::frac(a, 2)).to_vec())?;
    /// let tuned = tube.fine_tuned(&nearest.to(&wanted)?, Path::VThenU)?;
    /// let edge = |u: i64| tuned.isocurve(Direction::U, &Q::int(u));
    /// assert_eq!(edge(0)?, edge(1)?);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn on_surface<const N: usize>(
        surface: &Surface<T, N>,
        scales: (&SplineSpace<T>, &SplineSpace<T>),
        path: Path,
        conditions: &[SurfaceCondition<T, N>],
        norm: Norm,
    ) -> Result<Self> {
        Self::on_ways(surface, &Ways::new(surface, scales, path, Edges::default())?, scales, conditions, norm)
    }

    /// As [`on_surface`](Self::on_surface), the paths prepared.
    pub(super) fn on_ways<const N: usize>(
        surface: &Surface<T, N>,
        ways: &Ways<T, N>,
        scales: (&SplineSpace<T>, &SplineSpace<T>),
        conditions: &[SurfaceCondition<T, N>],
        norm: Norm,
    ) -> Result<Self> {
        let pair = (scales.0.clone(), scales.1.clone());
        let mut rows = Rows {
            ways,
            scales,
            images: Vec::new(),
            extents: [T::zero(), T::zero()],
            rows: Vec::new(),
            targets: Vec::new(),
            sources: Vec::new(),
        };
        for (source, condition) in conditions.iter().enumerate() {
            let before = rows.rows.len();
            rows.add(surface, condition)?;
            if !matches!(condition, SurfaceCondition::Scale { .. } | SurfaceCondition::Coefficient { .. }) {
                rows.settle(surface, before, condition);
            }
            rows.sources.resize(rows.rows.len(), source);
        }
        let Rows { rows, targets, sources, .. } = rows;
        if let Some(row) = targets.iter().position(|target| !target.is_finite()) {
            return Err(Error::NotFinite { what: "condition", index: sources[row] });
        }
        Self::of_independent_rows(&pair, &rows, &targets, &sources, norm)
    }
}

/// Linear conditions on the coefficients of a scale function.
struct Rows<'a, T: Scalar, const N: usize> {
    ways: &'a Ways<T, N>,
    scales: (&'a SplineSpace<T>, &'a SplineSpace<T>),
    /// The origin of the tuned surfaces and the `G_j`, made when first needed.
    images: Vec<Surface<T, N>>,
    /// The largest coordinates of the first and of the others.
    extents: [T; 2],
    rows: Vec<Functional<T>>,
    targets: Vec<T>,
    sources: Vec<usize>,
}

impl<T: Scalar, const N: usize> Rows<'_, T, N> {
    fn add(&mut self, surface: &Surface<T, N>, condition: &SurfaceCondition<T, N>) -> Result<()> {
        match condition {
            SurfaceCondition::Edge { edge, order } => {
                let direction = edge.direction();
                if surface.space(direction).is_periodic() {
                    return Err(TuneError::NoEdge { direction: direction.to_string() }.into());
                }
                self.make_images()?;
                let [count, width] = [direction, direction.other()].map(|d| self.images[0].space(d).dim());
                check_count(count, order.saturating_add(1))?;
                for depth in 0..=*order {
                    let line = if edge.is_end() { count - 1 - depth } else { depth };
                    for across in 0..width {
                        self.push(|s| control(s, direction, line, across).clone(), None);
                    }
                }
            }
            SurfaceCondition::Closed { direction } => {
                self.make_images()?;
                let [count, width] = [*direction, direction.other()].map(|d| self.images[0].space(d).dim());
                for across in 0..width {
                    let gap = |s: &Surface<T, N>| {
                        control(s, *direction, count - 1, across).minus(control(s, *direction, 0, across))
                    };
                    self.push(gap, Some(&SVector::zeros()));
                }
            }
            SurfaceCondition::Derivative { at, order, value } => {
                self.make_images()?;
                surface.derivative_at(&at.0, &at.1, order.0, order.1)?;
                let derivative = |s: &Surface<T, N>| {
                    s.derivative_at(&at.0, &at.1, order.0, order.1).expect("the same domain as before")
                };
                self.push(derivative, Some(value));
            }
            SurfaceCondition::Scale { at, value } => {
                let (u, v) = self.scales;
                let [across, along] = [(u, &at.0), (v, &at.1)].map(|(space, x)| space.basis(x));
                let (across, along) = (across?.to_dense(u.dim()), along?.to_dense(v.dim()));
                let weights: Vec<T> =
                    across.iter().flat_map(|a| along.iter().map(move |b| a.clone() * b)).collect();
                self.rows.push(Functional::new(0, weights));
                self.targets.push(value.clone());
            }
            SurfaceCondition::Coefficient { index, value } => {
                let (u, v) = self.scales;
                for (index, length) in [(index.0, u.dim()), (index.1, v.dim())] {
                    if index >= length {
                        return Err(Error::IndexOutOfRange { index, length });
                    }
                }
                self.rows.push(Functional::new(index.0 * v.dim() + index.1, [T::one()]));
                self.targets.push(value.clone());
            }
        }
        Ok(())
    }

    /// Tunes the surface by zero and by each basis function.
    fn make_images(&mut self) -> Result<()> {
        if !self.images.is_empty() {
            return Ok(());
        }
        let (u, v) = self.scales;
        let count = (u.clone(), v.clone()).dim();
        check_entries(count + 1, self.ways.u.dim().saturating_mul(self.ways.v.dim()).saturating_mul(N))?;
        let mut alpha = vec![T::zero(); count];
        let tuned = |alpha: &[T]| {
            let points = self.ways.walk(alpha, |_, _| Ok(()))?;
            Surface::new(self.ways.u.clone(), self.ways.v.clone(), points)
        };
        let origin = tuned(&alpha)?;
        let mut images = Vec::with_capacity(count + 1);
        for j in 0..count {
            alpha[j] = T::one();
            images.push(tuned(&alpha)?.difference(&origin)?);
            alpha[j] = T::zero();
        }
        let extent = |s: &Surface<T, N>| {
            s.coeffs().iter().flat_map(|c| c.iter()).map(T::magnitude).fold(T::zero(), larger)
        };
        self.extents = [extent(&origin), images.iter().map(extent).fold(T::zero(), larger)];
        images.insert(0, origin);
        self.images = images;
        Ok(())
    }

    /// `Σ_j a_j f(G_j) = value - f(S(a, c))` for each axis, without a value what it is for `α = 1`.
    fn push(&mut self, functional: impl Fn(&Surface<T, N>) -> SVector<T, N>, value: Option<&SVector<T, N>>) {
        let found: Vec<SVector<T, N>> = self.images.iter().map(functional).collect();
        for axis in 0..N {
            let weights: Vec<T> = found[1..].iter().map(|v| v[axis].clone()).collect();
            self.targets.push(match value {
                Some(value) => value[axis].clone() - &found[0][axis],
                None => weights.iter().fold(T::zero(), |sum, w| sum + w),
            });
            self.rows.push(Functional::new(0, weights));
        }
    }

    /// In floating point brings the rows of one condition on the shape, those from index `from` on, to the size of the images, with
    /// weights of at most one, and drops weights that are rounding; where a scale of one keeps an edge, it still does.
    fn settle(&mut self, surface: &Surface<T, N>, from: usize, condition: &SurfaceCondition<T, N>) {
        if T::EXACT {
            return;
        }
        // What a derivative of a surface of size one over this domain may be.
        let mut unit = T::one();
        if let SurfaceCondition::Derivative { order, .. } = condition {
            for (direction, order) in [(U, order.0), (V, order.1)] {
                let (a, b) = surface.space(direction).domain();
                (0..order).for_each(|_| unit /= b.clone() - a);
            }
        }
        let [origin, image] = self.extents.each_ref().map(|extent| extent.clone() * &unit);
        let all = larger(origin, image.clone());
        // Rounding of what the images are made of does not make a row.
        let noise = all.clone() * epsilon::<T>() * T::int(64);
        let rows = &mut self.rows[from..];
        let weights = rows.iter().flat_map(|row| row.weights());
        let mut size = weights.map(T::magnitude).fold(image, larger);
        if size <= noise {
            size = if all.is_zero() { T::one() } else { all };
        }
        for (row, target) in rows.iter_mut().zip(&mut self.targets[from..]) {
            let kept = |w: &T| if w.magnitude() <= noise { T::zero() } else { w.clone() / &size };
            *row = Functional::new(row.first(), row.weights().iter().map(kept).collect::<Vec<_>>());
            *target = match condition {
                SurfaceCondition::Edge { .. } => row.weights().iter().fold(T::zero(), |sum, w| sum + w),
                _ => target.clone() / &size,
            };
        }
    }
}

/// The control point on a line across a direction.
fn control<T: Scalar, const N: usize>(
    surface: &Surface<T, N>,
    direction: Direction,
    line: usize,
    across: usize,
) -> &SVector<T, N> {
    let width = surface.v().dim();
    match direction {
        U => &surface.coeffs()[line * width + across],
        V => &surface.coeffs()[across * width + line],
    }
}
