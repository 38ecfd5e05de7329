//! The functions of expressions: a table of names, uses and what they do.

use crate::calc::arguments::{Arguments, Given, Refusal};
use crate::calc::construct::{constant, curve, ramp, uniform};
use crate::calc::size;
use symspline::{Direction, Q, Scalar};
use symspline_dynamic::{AnyRational, AnySpace, AnySpline, Coords, Field, Number, Over, Value, each};

/// A function.
pub struct Function {
    /// Its name.
    pub name: &'static str,
    /// Its arguments, in words.
    pub usage: &'static str,
    /// What it is, in words.
    pub meaning: &'static str,
    /// The least and the greatest number of arguments.
    pub counts: (usize, usize),
    /// What it does.
    pub apply: fn(&mut Arguments<'_>) -> Given<Value>,
}

const MANY: usize = usize::MAX;

/// All functions.
pub const FUNCTIONS: [Function; 37] = [
    function("diff", "f[, k]", "the derivative, or that of order k", (1, 2), diff),
    function("du", "S", "the derivative of a surface in u", (1, 1), |a| partial(a, Direction::U)),
    function("dv", "S", "the derivative of a surface in v", (1, 1), |a| partial(a, Direction::V)),
    function(
        "integral",
        "f[, a, b]",
        "the antiderivative from 0 at the start, or from a to b",
        (1, 3),
        integral,
    ),
    function("at", "f, x | S, u, v", "the value at a parameter", (2, 3), at),
    function("dot", "f, g", "the inner product of values", (2, 2), |a| dot(a.value(0), a.value(1))),
    function("cross", "f, g", "the cross product of values", (2, 2), cross),
    function("inner", "f, g", "the integral of the inner product", (2, 2), |a| {
        Ok(a.spline(0)?.inner(a.spline(1)?)?.into())
    }),
    function("compose", "f, g", "x to f(g(x)), as f @ g", (2, 2), |a| composed(a.value(0), a.value(1))),
    function("elevate", "f, k", "the degree raised by k", (2, 2), elevate),
    function("reduce", "f, k", "the degree lowered by k, near f", (2, 2), reduce),
    function("insert", "f, t, ...", "with more knots", (2, MANY), insert),
    function("restrict", "f, a, b", "the part from a to b", (3, 3), restrict),
    function("reverse", "f", "run through backwards", (1, 1), reverse),
    function("reparam", "f, a, b", "over the interval from a to b", (3, 3), reparam),
    function("clamp", "f", "with clamped ends", (1, 1), clamp),
    function("simplify", "f", "the lowest degree and fewest knots that hold f", (1, 1), simplify),
    function("join", "f, g", "f, then g, which starts where f ends", (2, 2), join),
    function("coord", "f, i", "the coordinate i, from 0", (2, 2), |a| coordinate(a.value(0), a.count_of(1)?)),
    function("x", "f", "the first coordinate", (1, 1), |a| coordinate(a.value(0), 0)),
    function("y", "f", "the second coordinate", (1, 1), |a| coordinate(a.value(0), 1)),
    function("z", "f", "the third coordinate", (1, 1), |a| coordinate(a.value(0), 2)),
    function("iso_u", "S, u", "the curve of a surface where u is this", (2, 2), |a| {
        isocurve(a, Direction::U)
    }),
    function("iso_v", "S, v", "the curve of a surface where v is this", (2, 2), |a| {
        isocurve(a, Direction::V)
    }),
    function("transpose", "S", "u and v exchanged", (1, 1), transpose),
    function("same", "f, g", "1 if both are the same function, else 0", (2, 2), same),
    function("length", "C", "the length, a float", (1, 1), length),
    function("exact", "f", "over fractions, without loss", (1, 1), |a| Ok(a.value(0).to_exact()?)),
    function("float", "f", "rounded to floats", (1, 1), |a| Ok(a.value(0).to_float()?)),
    function("rational", "f[, w]", "as a rational one, with weights w or 1", (1, 2), rational),
    function("polynomial", "f, tolerance", "a polynomial near a rational one", (2, 2), polynomial),
    function("bezier", "P, ...", "the Bezier curve of points or numbers over [0, 1]", (1, MANY), |a| {
        uniform(a, a.count() - 1, 0)
    }),
    function("uniform", "p, P, ...", "the clamped uniform spline of degree p over [0, 1]", (2, MANY), |a| {
        uniform(a, a.count_of(0)?, 1)
    }),
    function("const", "c, a, b", "the constant c over the interval from a to b", (3, 3), |a| ramp(a, false)),
    function("param", "a, b", "the function x over the interval from a to b", (2, 2), |a| ramp(a, true)),
    function("curve", "x, y[, z]", "the curve whose coordinates are these functions", (2, 3), curve),
    function("abs2", "f", "the squared length of values", (1, 1), |a| dot(a.value(0), a.value(0))),
];

const fn function(
    name: &'static str,
    usage: &'static str,
    meaning: &'static str,
    counts: (usize, usize),
    apply: fn(&mut Arguments<'_>) -> Given<Value>,
) -> Function {
    Function { name, usage, meaning, counts, apply }
}

/// One text for splines of one parameter, polynomial and rational.
macro_rules! of_one_parameter {
    ($arguments:expr, $s:ident => $body:expr) => {
        match $arguments.value(0) {
            Value::Spline($s) => Ok($body.into()),
            Value::Rational($s) => Ok($body.into()),
            _ => $arguments.wrong(0, "a function or curve"),
        }
    };
}

/// One text for splines of two parameters, polynomial and rational.
macro_rules! of_two_parameters {
    ($arguments:expr, $s:ident => $body:expr) => {
        match $arguments.value(0) {
            Value::Surface($s) => Ok($body.into()),
            Value::RationalSurface($s) => Ok($body.into()),
            _ => $arguments.wrong(0, "a surface"),
        }
    };
}

fn diff(a: &mut Arguments<'_>) -> Given<Value> {
    let order = if a.count() == 2 { a.count_of(1)? } else { 1 };
    of_one_parameter!(a, s => s.nth_derivative(order)?)
}

/// The inner product of values; of numbers their product, as of functions.
fn dot(f: &Value, g: &Value) -> Given<Value> {
    Ok(if matches!((f, g), (Value::Number(_), Value::Number(_))) { f.product(g)? } else { f.dot(g)? })
}

/// The cross product of values; of points that of constants.
fn cross(a: &mut Arguments<'_>) -> Given<Value> {
    let (Value::Point(p), Value::Point(q)) = (a.value(0), a.value(1)) else {
        return Ok(a.value(0).cross(a.value(1))?);
    };
    let (start, end) = (Number::Exact(Q::int(0)), Number::Exact(Q::int(1)));
    let constant = |point: &Coords| constant(point.clone(), (&start, &end), p.is_exact() && q.is_exact());
    Ok(point(constant(p)?.cross(&constant(q)?)?.at(&start)?))
}

fn partial(a: &mut Arguments<'_>, direction: Direction) -> Given<Value> {
    of_two_parameters!(a, s => s.derivative(direction)?)
}

/// A number if there is one coordinate, else a point.
fn point(coords: Coords) -> Value {
    match coords {
        Over::Float(all) if all.len() == 1 => Number::Float(all[0]).into(),
        Over::Exact(all) if all.len() == 1 => Number::Exact(all[0].clone()).into(),
        coords => coords.into(),
    }
}

fn integral(a: &mut Arguments<'_>) -> Given<Value> {
    match a.count() {
        1 => Ok(a.spline(0)?.antiderivative()?.into()),
        2 => Err(Refusal {
            argument: None,
            problem: "integral takes a function alone, or also both ends".into(),
        }),
        _ => Ok(point(a.spline(0)?.integral_between(a.number(1)?, a.number(2)?)?)),
    }
}

fn at(a: &mut Arguments<'_>) -> Given<Value> {
    match (a.value(0), a.count()) {
        (Value::Spline(s), 2) => Ok(point(s.at(a.number(1)?)?)),
        (Value::Rational(s), 2) => Ok(point(s.at(a.number(1)?)?)),
        (Value::Surface(s), 3) => Ok(point(s.at(a.number(1)?, a.number(2)?)?)),
        (Value::RationalSurface(s), 3) => Ok(point(s.at(a.number(1)?, a.number(2)?)?)),
        (_, 2) => a.wrong(0, "a function or curve"),
        _ => a.wrong(0, "a surface"),
    }
}

/// `x` to `f(g(x))`; for a surface `f` the curve on it over a plane curve `g`.
pub fn composed(f: &Value, g: &Value) -> Given<Value> {
    let short = |outer: Vec<AnySpace>, inner: &AnySpline| {
        let checked = size::check_composition(&outer, &inner.spaces());
        checked.map_err(|problem| Refusal { argument: None, problem })
    };
    match (f, g) {
        (Value::Spline(f), Value::Spline(g)) => {
            short(f.spaces(), g)?;
            Ok(f.composed(g)?.into())
        }
        (Value::Surface(f), Value::Spline(g)) => {
            short(f.spaces(), g)?;
            Ok(f.composed(g)?.into())
        }
        _ => Err(Refusal {
            argument: None,
            problem: format!(
                "there is no composition of {} and {}: both must be polynomial, the second of one parameter",
                f.kind(),
                g.kind()
            ),
        }),
    }
}

fn elevate(a: &mut Arguments<'_>) -> Given<Value> {
    let raise = a.count_of(1)?;
    match a.value(0) {
        Value::Surface(s) => Ok(s.elevated(Direction::U, raise)?.elevated(Direction::V, raise)?.into()),
        Value::RationalSurface(s) => {
            Ok(s.elevated(Direction::U, raise)?.elevated(Direction::V, raise)?.into())
        }
        _ => of_one_parameter!(a, s => s.elevated(raise)?),
    }
}

fn reduce(a: &mut Arguments<'_>) -> Given<Value> {
    let by = a.count_of(1)?;
    let (value, bound) = each!(a.spline(0)?, s => {
        let near = s.degree_lowered(by)?;
        (AnySpline::from(near.spline), near.bound.to_string())
    });
    a.notes.push(format!("reduce: within {bound}"));
    Ok(value.into())
}

fn insert(a: &mut Arguments<'_>) -> Given<Value> {
    let knots = a.numbers_from(1)?;
    of_one_parameter!(a, s => s.inserted(&knots)?)
}

fn restrict(a: &mut Arguments<'_>) -> Given<Value> {
    let (start, end) = (a.number(1)?, a.number(2)?);
    of_one_parameter!(a, s => s.restricted(start, end)?)
}

fn reverse(a: &mut Arguments<'_>) -> Given<Value> {
    of_one_parameter!(a, s => s.reversed()?)
}

fn reparam(a: &mut Arguments<'_>) -> Given<Value> {
    let (start, end) = (a.number(1)?, a.number(2)?);
    of_one_parameter!(a, s => s.reparametrised(start, end)?)
}

fn clamp(a: &mut Arguments<'_>) -> Given<Value> {
    match a.value(0) {
        Value::Surface(s) => Ok(s.clamped_ends()?.into()),
        Value::RationalSurface(s) => Ok(s.clamped_ends()?.into()),
        _ => of_one_parameter!(a, s => s.clamped_ends()?),
    }
}

fn simplify(a: &mut Arguments<'_>) -> Given<Value> {
    match a.value(0) {
        Value::Surface(s) => Ok(each!(s, s => Value::Surface(s.simplified()?.into()))),
        _ => Ok(a.spline(0)?.simplified()?.into()),
    }
}

fn join(a: &mut Arguments<'_>) -> Given<Value> {
    let (f, g) = (a.spline(0)?, a.spline(1)?);
    let join = || -> symspline_dynamic::Result<AnySpline> {
        symspline_dynamic::alike!(f, g, s, t => Ok(s.join_continuous(t)?.into()))
    };
    Ok(join()?.into())
}

fn coordinate(value: &Value, axis: usize) -> Given<Value> {
    match value {
        Value::Spline(s) => Ok(s.coordinate(axis)?.into()),
        Value::Surface(s) => Ok(s.coordinate(axis)?.into()),
        Value::Rational(s) => Ok(s.coordinate(axis)?.into()),
        Value::RationalSurface(s) => Ok(s.coordinate(axis)?.into()),
        Value::Point(p) if axis < p.len() => Ok(match p {
            Over::Float(p) => Number::Float(p[axis]).into(),
            Over::Exact(p) => Number::Exact(p[axis].clone()).into(),
        }),
        other => Err(Refusal {
            argument: Some(0),
            problem: format!("there is no coordinate {axis} of this {}", other.kind()),
        }),
    }
}

fn isocurve(a: &mut Arguments<'_>, direction: Direction) -> Given<Value> {
    let x = a.number(1)?;
    of_two_parameters!(a, s => s.isocurve(direction, x)?)
}

fn transpose(a: &mut Arguments<'_>) -> Given<Value> {
    match a.value(0) {
        Value::Surface(s) => Ok(s.transposed().into()),
        Value::RationalSurface(s) => Ok(s.transposed()?.into()),
        _ => a.wrong(0, "a surface"),
    }
}

fn same(a: &mut Arguments<'_>) -> Given<Value> {
    let same = match (a.value(0), a.value(1)) {
        (Value::Spline(f), Value::Spline(g)) => f.same_function(g)?,
        (Value::Surface(f), Value::Surface(g)) => f.same_function(g)?,
        (Value::Rational(f), Value::Rational(g)) => f.same_function(g)?,
        (Value::RationalSurface(f), Value::RationalSurface(g)) => f.same_function(g)?,
        (Value::Spline(f), Value::Rational(g)) => AnyRational::from_polynomial(f)?.same_function(g)?,
        (Value::Rational(f), Value::Spline(g)) => f.same_function(&AnyRational::from_polynomial(g)?)?,
        (f @ (Value::Number(_) | Value::Point(_)), g) if f.kind() == g.kind() => f == g,
        (f, g) => {
            let problem = format!("{} and {} are not compared", f.kind(), g.kind());
            return Err(Refusal { argument: None, problem });
        }
    };
    Ok(Number::Exact(Q::int(i64::from(same))).into())
}

fn length(a: &mut Arguments<'_>) -> Given<Value> {
    match crate::measure::length(a.value(0)) {
        Some(length) => Ok(Number::Float(length?.total).into()),
        None => a.wrong(0, "a curve"),
    }
}

fn rational(a: &mut Arguments<'_>) -> Given<Value> {
    let f = a.spline(0)?;
    match a.count() {
        1 => Ok(AnyRational::from_polynomial(f)?.into()),
        _ => Ok(AnyRational::quotient(&f.times(a.spline(1)?)?, a.spline(1)?)?.into()),
    }
}

fn polynomial(a: &mut Arguments<'_>) -> Given<Value> {
    let Value::Rational(f) = a.value(0) else { return a.wrong(0, "a rational function or curve") };
    let tolerance = a.number(1)?;
    let (value, bound) = each!(f, T, s => {
        let near = s.polynomial_within(&<T as Field>::of(tolerance)?)?;
        (AnySpline::from(near.spline), near.bound.to_string())
    });
    a.notes.push(format!("polynomial: within {bound}"));
    Ok(value.into())
}
