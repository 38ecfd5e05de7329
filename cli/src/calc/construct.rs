//! Splines from numbers and points.

use crate::calc::arguments::{Arguments, Given, Refusal, gathered};
use symspline::{Q, Scalar, SplineSpace};
use symspline_dynamic::{AnySpace, AnySpline, Coords, Number, Over, Value, both};

/// The clamped uniform spline over [0, 1] with the coefficients that stand from an argument on.
pub fn uniform(a: &mut Arguments<'_>, degree: usize, first: usize) -> Given<Value> {
    let count = a.count() - first;
    if count <= degree {
        let problem = format!("degree {degree} takes {} coefficients or more, not {count}", degree + 1);
        return Err(Refusal { argument: None, problem });
    }
    let mut dim = None;
    let mut coords: Vec<Number> = Vec::new();
    for i in first..a.count() {
        let numbers: Vec<Number> = match a.value(i) {
            Value::Number(x) => vec![x.clone()],
            Value::Point(Over::Float(p)) => p.iter().map(|x| Number::Float(*x)).collect(),
            Value::Point(Over::Exact(p)) => p.iter().cloned().map(Number::Exact).collect(),
            _ => return a.wrong(i, "a number or a point"),
        };
        if *dim.get_or_insert(numbers.len()) != numbers.len() {
            let problem = "this has other coordinates than the first".to_owned();
            return Err(Refusal { argument: Some(i), problem });
        }
        coords.extend(numbers);
    }
    let coords = gathered(&coords.iter().collect::<Vec<_>>())?;
    let space = SplineSpace::uniform(degree, count - degree, Q::int(0), Q::int(1))?;
    let space = of_field(AnySpace::Exact(space), coords.is_exact())?;
    Ok(AnySpline::new(space, dim.unwrap_or(1), coords)?.into())
}

fn of_field(space: AnySpace, exact: bool) -> symspline_dynamic::Result<AnySpace> {
    if exact { Ok(space) } else { space.to_float() }
}

/// A constant, or the parameter itself, over an interval.
pub fn ramp(a: &mut Arguments<'_>, rises: bool) -> Given<Value> {
    let ends = a.numbers_from(usize::from(!rises))?;
    if rises {
        let line: AnySpline = both!(ends, ends => {
            let space = SplineSpace::bezier(1, ends[0].clone(), ends[1].clone())?;
            symspline::Function::new(space, ends)?.into()
        });
        return Ok(line.into());
    }
    let value = match a.value(0) {
        Value::Number(x) => gathered(&[x])?,
        Value::Point(p) => p.clone(),
        _ => return a.wrong(0, "a number or a point"),
    };
    let exact = value.is_exact() && ends.is_exact();
    Ok(constant(value, (a.number(1)?, a.number(2)?), exact)?.into())
}

/// A constant over an interval.
pub fn constant(
    value: Coords,
    (start, end): (&Number, &Number),
    exact: bool,
) -> symspline_dynamic::Result<AnySpline> {
    let ends = gathered(&[start, end])?;
    let space: AnySpace =
        both!(ends, ends => SplineSpace::bezier(0, ends[0].clone(), ends[1].clone())?.into());
    let value = if exact { value } else { value.to_float()? };
    AnySpline::new(of_field(space, exact)?, value.len(), value)
}

/// The quotient; of a number or a point by a function that of the constant.
pub fn quotient(f: &Value, g: &Value) -> Given<Value> {
    let value = match f {
        Value::Number(x) => gathered(&[x])?,
        Value::Point(p) => p.clone(),
        _ => return Ok(f.quotient(g)?),
    };
    let (domain, exact) = match g {
        Value::Spline(g) => (g.domain(), g.is_exact()),
        Value::Rational(g) => (g.domain(), g.is_exact()),
        _ => return Ok(f.quotient(g)?),
    };
    let value = if exact { value.to_exact()? } else { value };
    Ok(Value::Spline(constant(value, (&domain.0, &domain.1), exact)?).quotient(g)?)
}

/// The curve whose coordinates are these functions.
pub fn curve(a: &mut Arguments<'_>) -> Given<Value> {
    let dim = a.count();
    let axes = (0..dim).map(|axis| {
        let f = a.spline(axis)?;
        if f.dim() != 1 {
            return a.wrong(axis, "a function");
        }
        let unit = Coords::Exact((0..dim).map(|i| Q::int(i64::from(i == axis))).collect());
        let (start, end) = f.domain();
        Ok(constant(unit, (&start, &end), f.is_exact())?.times(f)?)
    });
    let mut sum: Option<AnySpline> = None;
    for axis in axes {
        let axis = axis?;
        sum = Some(match sum {
            Some(sum) => sum.sum(&axis)?,
            None => axis,
        });
    }
    Ok(sum.expect("a curve takes two functions or more").into())
}
