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
//! Polynomial curves have no weights: `D = P'`, `B = P' × P''`, `E = B' |P'|² - 3 B (P'·P'')`. In the plane `B` and `E`
//! are numbers; here they are vectors across the plane, so that both are one text.

use crate::analysis::ball::Ball;
use crate::analysis::pieces::Pieces;
use crate::coeff::Coeff;
use crate::error::Result;
use crate::rational::spline::NurbsCurve;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::{Curve, Function, Spline};
use crate::vector::dot;
use nalgebra::SVector;
use num_traits::{One, Zero};
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

    /// Points and weights between the knots, of degree `order` at least: the order of the highest derivative that is
    /// used.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge).
    pub(crate) fn motion(&self, order: usize) -> Result<Motion<T, N>> {
        let ends: Arc<[T]> = self.space().ends().into();
        let weights = self.weights.as_ref().map(|weights| derivatives(weights, &ends, order)).transpose()?;
        Ok(Motion { points: derivatives(&self.points, &ends, order)?, weights })
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

/// The pieces of a spline and of its first three derivatives, of degree `order` at least.
fn derivatives<T: Scalar, C: Coeff<T>>(
    spline: &Spline<T, C>,
    ends: &Arc<[T]>,
    order: usize,
) -> Result<[Pieces<T, C>; 4]> {
    let mut value = Pieces::of(spline, ends)?;
    while value.degree() < order {
        value = value.elevated();
    }
    let first = value.derivative();
    let second = first.derivative();
    let third = second.derivative();
    Ok([value, first, second, third])
}

/// Points and weights, each with its first three derivatives, between knots.
#[derive(Debug)]
pub(crate) struct Motion<T, const N: usize> {
    points: [Pieces<T, SVector<T, N>>; 4],
    weights: Option<[Pieces<T>; 4]>,
}

/// A vector across the plane, or of space.
pub(crate) type Across<T> = SVector<T, 3>;

impl<T: Scalar, const N: usize> Motion<T, N> {
    /// The weighted points.
    pub(crate) fn points(&self) -> &Pieces<T, SVector<T, N>> {
        &self.points[0]
    }

    /// The weights, if there are any.
    pub(crate) fn weights(&self) -> Option<&Pieces<T>> {
        self.weights.as_ref().map(|weights| &weights[0])
    }

    /// `P - w q`: from a point to the curve, times the weight.
    pub(crate) fn away_from(&self, point: &SVector<T, N>) -> Pieces<T, SVector<T, N>> {
        match self.weights() {
            Some(weights) => self.points().plus(-1, &weights.map(|weight| point.map(|x| x * weight))),
            None => self.points().map(|c| c - point),
        }
    }

    /// `D`.
    pub(crate) fn direction(&self) -> Result<Pieces<T, SVector<T, N>>> {
        self.turned(1)
    }

    /// `P^(k) w - P w^(k)`: of order 1 it is `D`, of order 2 its derivative.
    fn turned(&self, k: usize) -> Result<Pieces<T, SVector<T, N>>> {
        let Some(weights) = &self.weights else { return Ok(self.points[k].clone()) };
        Ok(weights[0].product(&self.points[k])?.plus(-1, &weights[k].product(&self.points[0])?))
    }

    /// `|D|²`.
    pub(crate) fn speed(&self) -> Result<Pieces<T>> {
        let direction = self.direction()?;
        direction.times(&direction, dot)
    }

    /// `B`.
    pub(crate) fn bend(&self) -> Result<Pieces<T, Across<T>>> {
        self.bend_with(2)
    }

    /// `w P'×P^(k) - w' P×P^(k) + w^(k) P×P'`: with `k = 2` it is `B`, with `k = 3` its derivative.
    fn bend_with(&self, k: usize) -> Result<Pieces<T, Across<T>>> {
        let [point, first, ..] = &self.points;
        let bend = first.times(&self.points[k], wedge)?;
        let Some([weight, slope, ..]) = &self.weights else { return Ok(bend) };
        let weights = self.weights.as_ref().map(|weights| &weights[k]).expect("there are weights");
        let turned = slope.product(&point.times(&self.points[k], wedge)?)?;
        Ok(weight.product(&bend)?.plus(-1, &turned).plus(1, &weights.product(&point.times(first, wedge)?)?))
    }

    /// `E`, to which the slope of the curvature is proportional.
    pub(crate) fn slope(&self) -> Result<Pieces<T, Across<T>>> {
        let (bend, bend_slope) = (self.bend()?, self.bend_with(3)?);
        let (direction, turned) = (self.direction()?, self.turned(2)?);
        let (speed, speed_slope) = (direction.times(&direction, dot)?, direction.times(&turned, dot)?);
        let Some([weight, weight_slope, ..]) = &self.weights else {
            return Ok(speed.product(&bend_slope)?.plus(-3, &speed_slope.product(&bend)?));
        };
        let weighted = weight.product(&bend)?;
        let rise = weight.product(&bend_slope)?.plus(3, &weight_slope.product(&bend)?);
        Ok(speed.product(&rise)?.plus(-3, &speed_slope.product(&weighted)?))
    }

    /// `B · D''`, which is `w⁵ (C' × C'') · C'''`.
    pub(crate) fn twist(&self) -> Result<Pieces<T>> {
        let mut third = self.turned(3)?;
        if let Some([_, slope, second, _]) = &self.weights {
            third =
                third.plus(1, &slope.product(&self.points[2])?).plus(-1, &second.product(&self.points[1])?);
        }
        self.bend()?.times(&third, |across, c| dot(across, &padded(c)))
    }
}

impl<const N: usize> Motion<Ball, N> {
    /// The curvature at `x` of the curve of piece `i`, in the plane with its sign, and its derivative by arc length.
    pub(crate) fn curvature(&self, i: usize, x: &Ball) -> [Ball; 2] {
        let [p, first, second, third] = [0, 1, 2, 3].map(|k| self.points[k].at(i, x));
        let one = [Ball::one(), Ball::zero(), Ball::zero(), Ball::zero()];
        let [w, w1, w2, w3] =
            self.weights.as_ref().map_or(one, |weights| [0, 1, 2, 3].map(|k| weights[k].at(i, x)));
        let (direction, turned) = (first * w - p * w1, second * w - p * w2);
        let bend_with = |change: &SVector<Ball, N>, w2| {
            wedge(&first, change) * w - wedge(&p, change) * w1 + wedge(&p, &first) * w2
        };
        let (bend, bend_slope) = (bend_with(&second, w2), bend_with(&third, w3));
        let (speed, three) = (dot(&direction, &direction), Ball::int(3));
        let rise = bend * (w1 * three) + bend_slope * w;
        let slope = rise * speed - bend * (w * three * dot(&direction, &turned));
        let (bend, slope) = match N < 3 {
            true => (bend[2], slope[2]),
            false => {
                let size = dot(&bend, &bend).root();
                (size, dot(&bend, &slope) / size)
            }
        };
        [w * w * w * bend / (speed * speed.root()), w * w * w * w * slope / (speed * speed * speed)]
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
