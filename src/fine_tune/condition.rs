//! Conditions on a fine-tuned curve, as conditions on the values of its scale function.
//!
//! For a fixed curve `D` is affine in the coefficients `a_j` of `α = Σ a_j φ_j`:
//!
//! ```text
//! D(y) - D(x) = Σ_j a_j m_j(x, y),     m_j(x, y) = ∫_x^y φ_j C'          (moments)
//! ```
//! so that where `D` passes, and whether it closes, are linear conditions on `a`. All are met without rotation and without
//! springs: every tangent keeps its direction, and `κ_D = κ / α` everywhere.

use crate::coeff::Coeff;
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Curve;
use nalgebra::SVector;

/// What a fine-tuned curve `D` of `C` over `[a, b]` must do; it starts at `C(a)`.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition<T, const N: usize> {
    /// The end stays: `D(b) = C(b)`. A closed curve stays closed.
    End,
    /// `D(x) = point`.
    Point {
        /// `x`.
        parameter: T,
        /// The point.
        point: SVector<T, N>,
    },
    /// `D(to) - D(from) = chord`.
    Chord {
        /// Where the chord starts.
        from: T,
        /// Where it ends.
        to: T,
        /// The vector.
        chord: SVector<T, N>,
    },
    /// The derivatives of order 1 to `count` at `parameter` stay: `D^(k) = C^(k)`.
    ///
    /// That is `α = 1` and `α^(k) = 0` for `0 < k < count`. One derivative keeps the curvature as well, since `κ_D = κ / α`:
    /// where the point stays too the curves meet with `G2`.
    Derivatives {
        /// Where.
        parameter: T,
        /// How many.
        count: usize,
    },
    /// `α(parameter) = value`: the derivative is that many times what it was, and the curvature is divided by it.
    Scale {
        /// Where.
        parameter: T,
        /// The value.
        value: T,
    },
    /// Coefficient `index` of `α` is `value`.
    Coefficient {
        /// The index.
        index: usize,
        /// The value.
        value: T,
    },
    /// The area between the curve and its chord stays, `½ ∫ (D - D(a)) × D'`; plane curves only. For a closed curve it is the
    /// area inside, counted with its sign.
    ///
    /// The one condition that is not linear. A few steps with its linear part lead to a scale function that is nearest up to
    /// second order; over an exact field a last step along a line then meets the area exactly, which takes other conditions
    /// that the curve itself meets, and may leave the floor of a scale function that would not be positive otherwise.
    Area,
}

impl<T: Scalar, const N: usize> Curve<T, N> {
    /// The moments `m_j = ∫_x^y φ_j C'`, `φ_j` the basis of `scales`: what each coefficient of a scale function adds to
    /// `D(y) - D(x)`.
    ///
    /// # Errors
    /// [`DomainMismatch`](Error::DomainMismatch), [`OutsideDomain`](Error::OutsideDomain),
    /// [`Discontinuous`](Error::Discontinuous) if the curve may jump.
    ///
    /// # Examples
    /// ```
    /// use nalgebra::vector;
    /// use symspline::{Q, Scalar, SplineSpace, segment};
    /// let line = segment(&vector![Q::int(0), Q::int(0)], &vector![Q::int(4), Q::int(2)])?;
    /// let moments = line.scale_moments(&SplineSpace::bezier(1, Q::int(0), Q::int(1))?, &Q::int(0), &Q::int(1))?;
    /// assert_eq!(moments, vec![vector![Q::int(2), Q::int(1)]; 2]);
    /// # Ok::<(), symspline::Error>(())
    /// ```
    pub fn scale_moments(&self, scales: &SplineSpace<T>, x: &T, y: &T) -> Result<Vec<SVector<T, N>>> {
        self.space().check_same_domain(scales)?;
        let speed = self.derivative()?;
        if x > y {
            let back = self.scale_moments(scales, y, x)?;
            return Ok(back.into_iter().map(|moment| -moment).collect());
        }
        if x == y {
            scales.locate(x)?;
            return Ok(vec![SVector::zeros(); scales.dim()]);
        }
        scales.gram_between(speed.space(), 0, 0, x, y)?.apply(speed.coeffs())
    }
}

/// Linear conditions on the coefficients of a scale function.
#[derive(Clone, Debug)]
pub(crate) struct Rows<T> {
    pub rows: Vec<Functional<T>>,
    pub targets: Vec<T>,
    /// The condition that each row is of.
    pub sources: Vec<usize>,
    /// The condition that the area stays, if there is one.
    pub area: Option<usize>,
}

impl<T: Scalar> Rows<T> {
    /// The rows that `conditions` are for scale functions in `scales`.
    pub(crate) fn of<const N: usize>(
        curve: &Curve<T, N>,
        scales: &SplineSpace<T>,
        conditions: &[Condition<T, N>],
    ) -> Result<Self> {
        let mut rows = Self { rows: Vec::new(), targets: Vec::new(), sources: Vec::new(), area: None };
        let (a, b) = curve.domain();
        curve.space().check_same_domain(scales)?;
        for (source, condition) in conditions.iter().enumerate() {
            match condition {
                Condition::End => {
                    let chord = curve.at_left(b)?.minus(&curve.at(a)?);
                    rows.push_chord(source, &curve.scale_moments(scales, a, b)?, &chord);
                }
                Condition::Point { parameter, point } => {
                    let chord = point.minus(&curve.at(a)?);
                    rows.push_chord(source, &curve.scale_moments(scales, a, parameter)?, &chord);
                }
                Condition::Chord { from, to, chord } => {
                    rows.push_chord(source, &curve.scale_moments(scales, from, to)?, chord);
                }
                Condition::Derivatives { parameter, count: 0 } => {
                    scales.locate(parameter)?;
                }
                Condition::Derivatives { parameter, count } => {
                    let jet = scales.basis_derivatives(parameter, count - 1)?;
                    for (order, row) in jet.into_iter().enumerate() {
                        rows.push(source, row, if order == 0 { T::one() } else { T::zero() });
                    }
                }
                Condition::Scale { parameter, value } => {
                    rows.push(source, scales.basis(parameter)?, value.clone());
                }
                Condition::Coefficient { index, .. } if *index >= scales.dim() => {
                    return Err(Error::IndexOutOfRange { index: *index, length: scales.dim() });
                }
                Condition::Coefficient { index, value } => {
                    rows.push(source, Functional::new(*index, [T::one()]), value.clone());
                }
                Condition::Area => rows.area = Some(source),
            }
        }
        match rows.targets.iter().position(|target| !target.is_finite()) {
            Some(row) => Err(Error::NotFinite { what: "condition", index: rows.sources[row] }),
            None => Ok(rows),
        }
    }

    fn push(&mut self, source: usize, row: Functional<T>, target: T) {
        self.rows.push(row);
        self.targets.push(target);
        self.sources.push(source);
    }

    /// `Σ a_j moments[j] = chord`, a row for each axis.
    fn push_chord<const N: usize>(
        &mut self,
        source: usize,
        moments: &[SVector<T, N>],
        chord: &SVector<T, N>,
    ) {
        for axis in 0..N {
            let weights: Vec<T> = moments.iter().map(|moment| moment[axis].clone()).collect();
            self.push(source, Functional::new(0, weights), chord[axis].clone());
        }
    }
}
