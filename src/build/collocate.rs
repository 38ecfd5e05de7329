//! Values and derivatives at parameters as rows of weights, and whether they determine a spline.
//!
//! Whether they do is decided before anything is solved: every coefficient needs a row of its own, in order, that it has a part
//! in (Schoenberg and Whitney; [deBoor, 2001]). For values these are the weights that do not vanish; for derivatives the knots say
//! it. Let `x` in the span `k` be a knot of multiplicity `m`, 0 if it is none. To the right of `x` the basis functions
//! `N_{k-m+1}, ..., N_k` begin there, and `N_{k-p+d}` does so with the order `d` of its first derivative that does not vanish. So the derivative of order `d` from the right has a part for
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

/// A derivative at a parameter, or a value, of order 0.
#[derive(Debug)]
pub(crate) struct Datum<T> {
    /// The row of weights, of a derivative of order `d` times the `d`-th power of the length of the span.
    pub row: Functional<T>,
    /// That power, which the value is to be multiplied with.
    unit: T,
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

    /// What the row is to be for the derivative to be `value`.
    pub(crate) fn scaled<C: Coeff<T>>(&self, value: &C) -> C {
        if self.unit.is_one() { value.clone() } else { value.scaled(&self.unit) }
    }

    fn weighs(&self, i: usize) -> bool {
        (self.columns.0..=self.columns.1).contains(&i)
    }
}

/// The values at the parameters, if they determine the spline.
pub(crate) fn values<T: Scalar>(space: &SplineSpace<T>, parameters: &[T]) -> Result<Vec<Functional<T>>> {
    let rows: Vec<Functional<T>> = parameters.iter().map(|x| space.basis(x)).collect::<Result<_>>()?;
    // Repeated parameters say nothing new.
    let fresh = |k: &usize| *k == 0 || parameters[*k - 1] != parameters[*k];
    let weighs = |row: &Functional<T>, i: usize| {
        i.checked_sub(row.first()).and_then(|k| row.weights().get(k)).is_some_and(|w| !w.is_zero())
    };
    check_determined(space, (0..rows.len()).filter(fresh), |k, i| weighs(&rows[k], i))?;
    Ok(rows)
}

/// The value at each parameter, and the next derivative wherever a parameter comes again, if they determine the spline.
pub(crate) fn jets<T: Scalar>(space: &SplineSpace<T>, parameters: &[T]) -> Result<Vec<Datum<T>>> {
    let mut data: Vec<Datum<T>> = Vec::with_capacity(parameters.len());
    let mut d = 0;
    for (place, x) in parameters.iter().enumerate() {
        d = if place > 0 && parameters[place - 1] == *x { d + 1 } else { 0 };
        if d > space.degree() {
            return Err(Error::DegreeTooLow { degree: space.degree(), needed: d });
        }
        data.push(Datum::of(space, x, d, place)?);
    }
    let mut order: Vec<usize> = (0..data.len()).collect();
    order.sort_by_key(|&k| data[k].rank);
    check_determined(space, order, |k, i| data[k].weighs(i))?;
    Ok(data)
}

/// That each coefficient of an open space has a datum of its own, in their `order`, that `weighs` it.
fn check_determined<T: Scalar>(
    space: &SplineSpace<T>,
    order: impl IntoIterator<Item = usize>,
    weighs: impl Fn(usize, usize) -> bool,
) -> Result<()> {
    if space.is_periodic() {
        return Ok(());
    }
    let mut remaining = order.into_iter();
    match (0..space.dim()).find(|&i| !remaining.any(|k| weighs(k, i))) {
        Some(index) => Err(Error::Undetermined { index }),
        None => Ok(()),
    }
}

/// The spline of `space` on whose coefficients the rows, as many as these, have the given values.
pub(crate) fn solved<'a, T: Scalar, C: Coeff<T>>(
    space: &SplineSpace<T>,
    rows: impl Iterator<Item = &'a Functional<T>>,
    values: impl Iterator<Item = C>,
) -> Result<Spline<T, C>> {
    let mut system = BandedSystem::new(space.dim(), border(space));
    for (row, value) in rows.zip(values) {
        system.push(row.first(), row.weights(), value);
    }
    Spline::new(space.clone(), system.solve()?)
}

/// How many columns of a collocation matrix go to the border.
pub(crate) fn border<T: Scalar>(space: &SplineSpace<T>) -> usize {
    if space.is_periodic() { space.degree().min(space.dim()) } else { 0 }
}
