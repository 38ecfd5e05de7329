//! Values and derivatives at parameters as rows of weights, and whether they determine a spline.
//!
//! Whether they do is decided before anything is solved: every coefficient needs a row of its own, in order, that it has a part
//! in (Schoenberg and Whitney; [deBoor, 2001]). Which coefficients those are the knots say. Let `x` in the span `k` be a knot of
//! multiplicity `m`, 0 if it is none. To the right of `x` the basis functions `N_{k-m+1}, ..., N_k` begin there, and `N_{k-p+d}`
//! does so with the order `d` of its first derivative that does not vanish. So the derivative of order `d` from the right has a part for
//!
//! ```text
//! k - p  <=  i  <=  max(k - m, k - p + d)
//! ```
//! once the lower ones are given. At the end of the domain all is mirrored, and the highest derivative comes first.

use crate::coeff::{Coeff, check_shapes};
use crate::error::{Error, Result};
use crate::functional::Functional;
use crate::linalg::BandedSystem;
use crate::scalar::Scalar;
use crate::space::SplineSpace;
use crate::spline::Spline;
use std::cmp::Ordering;

/// Counts, finite values, parameters in order.
pub(crate) fn check_data<T: Scalar, C: Coeff<T>>(
    space: &SplineSpace<T>,
    parameters: &[T],
    data: &[C],
) -> Result<()> {
    if parameters.len() != data.len() {
        return Err(Error::CoefficientCount { expected: parameters.len(), found: data.len() });
    }
    if data.is_empty() || parameters.len() < space.dim() {
        return Err(Error::TooFewPoints { expected: space.dim(), found: data.len() });
    }
    check_shapes(data)?;
    if let Some(index) = data.iter().position(|value| !value.all_finite()) {
        return Err(Error::NotFinite { what: "point", index });
    }
    match parameters.windows(2).position(|pair| pair[0].partial_cmp(&pair[1]).is_none_or(Ordering::is_gt)) {
        Some(before) => Err(Error::ParametersDecrease { index: before + 1 }),
        None => Ok(()),
    }
}

/// A value or derivative at a parameter.
#[derive(Debug)]
pub(crate) struct Datum<T> {
    /// The row of weights, of a derivative of order `d` times the `d`-th power of the length of the span.
    pub row: Functional<T>,
    /// That power.
    pub unit: T,
    /// The first and last of the unrolled coefficients that have a part in it.
    columns: (usize, usize),
    /// Where it stands among the data in the order of the coefficients they fix.
    rank: (bool, usize),
}

impl<T: Scalar> Datum<T> {
    /// The derivative of order `d` at `x`, number `place` of the data.
    fn of(space: &SplineSpace<T>, x: &T, d: usize, place: usize) -> Result<Self> {
        let (k, p, t) = (space.locate(x)?, space.degree(), space.knots());
        let at_end = x == space.domain().1;
        let columns = if at_end {
            let copies = t[k + 1..].iter().take_while(|s| *s == x).count();
            ((k + copies).saturating_sub(p).min(k.saturating_sub(d)), k)
        } else {
            let copies = t[..=k].iter().rev().take_while(|s| *s == x).count();
            (k - p, k.saturating_sub(copies).max(k - p + d))
        };
        let width = t[k + 1].clone() - &t[k];
        let unit = (0..d).fold(T::one(), |power, _| power * &width);
        let row = if d == 0 {
            space.basis_on(k, x)
        } else {
            let row = space.basis_derivative(x, d)?;
            Functional::new(row.first(), row.weights().iter().map(|w| w.clone() * &unit).collect::<Vec<_>>())
        };
        // At the end of the domain the last datum fixes the coefficient before those that came earlier.
        let rank = if at_end { (true, usize::MAX - place) } else { (false, place) };
        Ok(Self { row, unit, columns, rank })
    }

    fn weighs(&self, i: usize) -> bool {
        (self.columns.0..=self.columns.1).contains(&i)
    }
}

/// The values at the parameters, if they determine the spline.
pub(crate) fn values<T: Scalar>(space: &SplineSpace<T>, parameters: &[T]) -> Result<Vec<Datum<T>>> {
    let datum = |(place, x)| Datum::of(space, x, 0, place);
    let data: Vec<Datum<T>> = parameters.iter().enumerate().map(datum).collect::<Result<_>>()?;
    // Repeated parameters say nothing new.
    let fresh = |i: &usize| *i == 0 || parameters[*i - 1] != parameters[*i];
    check_determined(space, (0..data.len()).filter(fresh).map(|i| &data[i]).collect())?;
    Ok(data)
}

/// The value at each parameter, and the next derivative wherever a parameter comes again, if they determine the spline.
pub(crate) fn jets<T: Scalar>(space: &SplineSpace<T>, parameters: &[T]) -> Result<Vec<Datum<T>>> {
    let mut data: Vec<Datum<T>> = Vec::with_capacity(parameters.len());
    let mut order = 0;
    for (place, x) in parameters.iter().enumerate() {
        order = if place > 0 && parameters[place - 1] == *x { order + 1 } else { 0 };
        if order > space.degree() {
            return Err(Error::DegreeTooLow { degree: space.degree(), needed: order });
        }
        data.push(Datum::of(space, x, order, place)?);
    }
    check_determined(space, data.iter().collect())?;
    Ok(data)
}

/// That each coefficient of an open space has a datum of its own.
fn check_determined<T: Scalar>(space: &SplineSpace<T>, mut data: Vec<&Datum<T>>) -> Result<()> {
    if space.is_periodic() {
        return Ok(());
    }
    data.sort_by_key(|datum| datum.rank);
    let mut remaining = data.into_iter();
    match (0..space.dim()).find(|&i| !remaining.any(|datum| datum.weighs(i))) {
        Some(index) => Err(Error::Undetermined { index }),
        None => Ok(()),
    }
}

/// The spline of `space` with these data, as many as coefficients.
pub(crate) fn solved<T: Scalar, C: Coeff<T>>(
    space: &SplineSpace<T>,
    rows: &[Datum<T>],
    data: &[C],
) -> Result<Spline<T, C>> {
    let mut system = BandedSystem::new(space.dim(), border(space));
    for (datum, value) in rows.iter().zip(data) {
        let mut value = value.clone();
        if !datum.unit.is_one() {
            value.scale(&datum.unit);
        }
        system.push(datum.row.first(), datum.row.weights(), value);
    }
    Spline::new(space.clone(), system.solve()?)
}

/// How many columns of a collocation matrix go to the border.
pub(crate) fn border<T: Scalar>(space: &SplineSpace<T>) -> usize {
    if space.is_periodic() { space.degree().min(space.dim()) } else { 0 }
}
