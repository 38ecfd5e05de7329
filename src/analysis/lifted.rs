//! Curves, polynomial or rational, as their points and weights; what their bending is made of, interval by interval.
//!
//! With points `P` (times weights) and weights `w`, `C = P / w`, primes for derivatives:
//!
//! ```text
//! D = P' w - P w'                         C' = D / w²
//! B = w P'×P'' - w' P×P'' + w'' P×P'      C' × C'' = B / w³         κ = w³ |B| / |D|³
//! B' = w P'×P''' - w' P×P''' + w''' P×P'
//! E = (3 w' B + w B') |D|² - 3 w B (D·D')           κ' |D|⁵ = w² E,   in space κ κ' |D|⁸ = w⁵ B·E
//! ```
//!
//! In Bernstein form these are made with the degrees they have, not with those that the factors would give.
//!
//! Polynomial curves have no weights: `D = P'`, `B = P' × P''`, `E = B' |P'|² - 3 B (P'·P'')`. In the plane `B` and `E`
//! are numbers; here they are vectors across the plane, so that both are one text.

use crate::analysis::pieces::Pieces;
use crate::coeff::Coeff;
use crate::error::Result;
use crate::rational::spline::NurbsCurve;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Function, Spline};
use crate::vector::dot;
use nalgebra::SVector;
use std::sync::Arc;

/// Points and weights of a curve, which are splines of one space.
#[derive(Clone, Debug)]
pub struct Lifted<T, const N: usize> {
    points: Curve<T, N>,
    weights: Option<Function<T>>,
}

impl<T: Scalar, const N: usize> Lifted<T, N> {
    pub(crate) fn polynomial(curve: &Curve<T, N>) -> Self {
        Self { points: curve.clone(), weights: None }
    }

    /// # Errors
    /// None for a valid curve.
    pub(crate) fn rational(curve: &NurbsCurve<T, N>) -> Result<Self> {
        Ok(Self { points: curve.numerator()?, weights: Some(curve.denominator()?) })
    }

    pub(crate) fn space(&self) -> &SplineSpace<T> {
        self.points.space()
    }

    /// The same curve over another field.
    ///
    /// # Errors
    /// The first one of `convert`; [`Error::NotFinite`](crate::Error::NotFinite).
    pub(crate) fn over<U: Scalar>(&self, mut convert: impl FnMut(&T) -> Result<U>) -> Result<Lifted<U, N>> {
        let weights = self.weights.as_ref().map(|weights| weights.map_scalars(&mut convert)).transpose()?;
        Ok(Lifted { points: self.points.map_scalars(convert)?, weights })
    }

    /// What is on the span `k` alone, over another field.
    ///
    /// # Errors
    /// As [`over`](Self::over).
    pub(crate) fn window<U: Scalar>(
        &self,
        k: usize,
        mut convert: impl FnMut(&T) -> Result<U>,
    ) -> Result<Lifted<U, N>> {
        let weights = self.weights.as_ref().map(|weights| window(weights, k, &mut convert)).transpose()?;
        Ok(Lifted { points: window(&self.points, k, convert)?, weights })
    }

    /// Points and weights between the knots; where there are weights of degree `order` at least, the order of the highest
    /// derivative that is used.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge).
    pub(crate) fn motion(&self, order: usize) -> Result<Motion<T, N>> {
        let ends: Arc<[T]> = self.space().ends().into();
        let mut points = Pieces::of(&self.points, &ends)?;
        let Some(weights) = &self.weights else { return Ok(Motion { points, weights: None }) };
        let mut weights = Pieces::of(weights, &ends)?;
        while points.degree() < order.min(2) {
            (points, weights) = (points.elevated(), weights.elevated());
        }
        Ok(Motion { points, weights: Some(weights) })
    }
}

/// The spline on its span `k` alone, with the knots and coefficients that count there, over another field.
fn window<T: Scalar, U: Scalar, C: Coeff<T>>(
    spline: &Spline<T, C>,
    k: usize,
    mut convert: impl FnMut(&T) -> Result<U>,
) -> Result<Spline<U, C::Over<U>>> {
    let (p, space) = (spline.degree(), spline.space());
    let (a, b) = space.domain();
    let period = convert(b)? - convert(a)?;
    // The knots of a ring beyond one period are made of those within, which are not rounded.
    let round = space.round_knots();
    let first = space.last_span() + 1 - round.len();
    let mut knot = |i: usize| -> Result<U> {
        if !space.is_periodic() {
            return convert(&space.knots()[i]);
        }
        let steps = i as i64 - first as i64;
        let (turns, i) = (steps.div_euclid(round.len() as i64), steps.rem_euclid(round.len() as i64));
        Ok(convert(&round[i as usize])? + U::int(turns) * &period)
    };
    let knots = (k - p..=k + p + 1).map(&mut knot).collect::<Result<Vec<U>>>()?;
    let coeffs = (k - p..=k).map(|i| spline.coeff(i).try_map(&mut convert)).collect::<Result<_>>()?;
    Spline::new(SplineSpace::new(p, knots)?, coeffs)
}

/// Points and weights between knots.
#[derive(Debug)]
pub(crate) struct Motion<T, const N: usize> {
    points: Pieces<T, SVector<T, N>>,
    weights: Option<Pieces<T>>,
}

/// A vector across the plane, or of space.
pub(crate) type Across<T> = SVector<T, 3>;

impl<T: Scalar, const N: usize> Motion<T, N> {
    /// The weighted points.
    pub(crate) fn points(&self) -> &Pieces<T, SVector<T, N>> {
        &self.points
    }

    /// The weights, if there are any.
    pub(crate) fn weights(&self) -> Option<&Pieces<T>> {
        self.weights.as_ref()
    }

    /// `P - w q`: from a point to the curve, times the weight.
    pub(crate) fn away_from(&self, point: &SVector<T, N>) -> Pieces<T, SVector<T, N>> {
        match &self.weights {
            Some(weights) => self.points.plus(-1, &weights.map(|weight| point.map(|x| x * weight))),
            None => self.points.map(|c| c - point),
        }
    }

    /// `D`, of degree `2p - 2`: with the two polynomials of degree `p - 1` that the algorithm of de Casteljau blends last,
    /// `D = p (P_1 w_0 - P_0 w_1)` for the local parameter.
    pub(crate) fn direction(&self) -> Result<Pieces<T, SVector<T, N>>> {
        let Some(weights) = &self.weights else { return Ok(self.points.derivative()) };
        if self.points.degree() == 0 {
            return Ok(self.points.derivative());
        }
        let [a, b] = [0, 1].map(|j| self.points.inner(1, j));
        let [u, v] = [0, 1].map(|j| weights.inner(1, j));
        Ok(u.product(&b)?.plus(-1, &v.product(&a)?).per_length(self.points.degree() as i64, 1))
    }

    /// `|D|²`.
    pub(crate) fn speed(&self) -> Result<Pieces<T>> {
        let direction = self.direction()?;
        direction.times(&direction, dot)
    }

    /// `B`, of degree `3p - 6`: with the three polynomials of degree `p - 2` that the algorithm of de Casteljau blends in its
    /// last two steps, `B = p² (p - 1) (w_0 P_1×P_2 - w_1 P_0×P_2 + w_2 P_0×P_1)` for the local parameter.
    pub(crate) fn bend(&self) -> Result<Pieces<T, Across<T>>> {
        let Some(weights) = &self.weights else {
            let first = self.points.derivative();
            return first.times(&first.derivative(), wedge);
        };
        let p = self.points.degree() as i64;
        let [a, b, c] = [0, 1, 2].map(|j| self.points.inner(2, j));
        let [u, v, w] = [0, 1, 2].map(|j| weights.inner(2, j));
        let (first, second) = (u.product(&b.times(&c, wedge)?)?, v.product(&a.times(&c, wedge)?)?);
        let minors = first.plus(-1, &second).plus(1, &w.product(&a.times(&b, wedge)?)?);
        Ok(minors.per_length(p * p * (p - 1), 3))
    }

    /// `E`, to which the slope of the curvature is proportional.
    pub(crate) fn slope(&self) -> Result<Pieces<T, Across<T>>> {
        let (bend, direction) = (self.bend()?, self.direction()?);
        let (speed, bend_slope) = (direction.times(&direction, dot)?, bend.derivative());
        let speed_slope = direction.times(&direction.derivative(), dot)?;
        let Some(weight) = &self.weights else {
            return Ok(speed.product(&bend_slope)?.plus(-3, &speed_slope.product(&bend)?));
        };
        let turned = weight.derivative().product(&bend)?.per_length(3, 0);
        // A constant has a slope of zero, which has no degree to add.
        let rise = if bend.degree() == 0 { turned } else { turned.plus(1, &weight.product(&bend_slope)?) };
        Ok(speed.product(&rise)?.plus(-3, &speed_slope.product(&weight.product(&bend)?)?))
    }

    /// `B · D''`, which is `w⁵` times the determinant of the first three derivatives.
    pub(crate) fn twist(&self) -> Result<Pieces<T>> {
        let third = self.direction()?.derivative().derivative();
        self.bend()?.times(&third, |across, c| dot(across, &padded(c)))
    }
}

/// A vector of the plane or of space, as one of space.
fn padded<T: Scalar, const N: usize>(c: &SVector<T, N>) -> Across<T> {
    Across::from(std::array::from_fn(|axis| c.get(axis).cloned().unwrap_or_else(T::zero)))
}

/// The cross product of vectors of the plane or of space.
pub(crate) fn wedge<T: Scalar, const N: usize>(c: &SVector<T, N>, d: &SVector<T, N>) -> Across<T> {
    let minor = |i: usize, j: usize| match i.max(j) < N {
        true => c[i].clone() * &d[j] - c[j].clone() * &d[i],
        false => T::zero(),
    };
    Across::from([minor(1, 2), minor(2, 0), minor(0, 1)])
}
