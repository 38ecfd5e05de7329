//! Identities proved: not checked at samples, but coefficient by coefficient over the rationals.
//!
//! `cargo run --release --example exact_algebra`

#![allow(clippy::print_stdout, reason = "printing is what this program does")]

use nalgebra::vector;
use symspline::Direction::{U, V};
use symspline::{
    Function, NurbsCurve, Q, RationalFunction, Result, Scalar, SplineSpace, TensorSpline, circle,
};

fn main() -> Result<()> {
    leibniz()?;
    circle_at_any_degree()?;
    integral_by_two_routes()
}

/// `∂(f S)/∂u = ∂f/∂u S + f ∂S/∂u` for a scalar surface `f` and a surface `S` with other knots and degrees.
fn leibniz() -> Result<()> {
    let f = grid(2, [0, 1, 3], 1, [0, 2, 3], |i| Q::frac(i * i % 7 - 3, 2))?;
    let heights = grid(1, [0, 2, 3], 2, [0, 1, 3], |i| Q::frac(5 * i % 11, 3))?;
    let s = heights.product_by(&heights, |x, y| vector![Q::int(1), x + y, x * y])?;
    let sides = [(&f * &s).derivative(U)?, &(&f.derivative(U)? * &s) + &(&f * &s.derivative(U)?)];
    println!("Leibniz for surfaces: ∂(f S)/∂u = ∂f/∂u S + f ∂S/∂u");
    println!("  f   {}", about(&f));
    println!("  S   {}", about(&s));
    sides.iter().zip(["left", "right"]).for_each(|(side, name)| println!("  {name:<5} {}", about(side)));
    println!("  the same function: {}\n", sides[0].same_function(&sides[1])?);
    Ok(())
}

/// A circle is a circle in any degree, and its points at rational parameters are rational.
fn circle_at_any_degree() -> Result<()> {
    let quadratic = circle(&vector![Q::int(0), Q::int(0)], &Q::int(1))?;
    let quintic = quadratic.through(|lifted| lifted.elevated(3))?;
    println!("An exact circle: degree {} raised to {}", quadratic.degree(), quintic.degree());
    for x in [Q::frac(1, 12), Q::frac(1, 3), Q::frac(7, 10)] {
        let point = quintic.at(&x)?;
        println!("  C({x}) = ({}, {})", point[0], point[1]);
    }
    println!("  x² + y² = 1 on the whole curve: {}\n", has_unit_length(&quintic)?);
    Ok(())
}

fn has_unit_length(curve: &NurbsCurve<Q, 2>) -> Result<bool> {
    let square = curve.dot(curve)?;
    let one = Function::constant(square.space().clone(), Q::int(1))?;
    square.same_function(&RationalFunction::from_polynomial(&one)?)
}

/// `∬ f g` as the integral of the product spline, and from the Gram matrices of the spaces.
fn integral_by_two_routes() -> Result<()> {
    let f = grid(3, [0, 1, 3], 2, [0, 2, 3], |i| Q::frac(i % 5 - 2, 3))?;
    let g = grid(1, [0, 2, 3], 2, [0, 1, 3], |i| Q::frac(3 * i % 7, 5))?;
    let by_product = f.times(&g)?.integral()?;
    let (gram_u, gram_v) = (f.u().gram(g.u(), 0, 0)?, f.v().gram(g.v(), 0, 0)?);
    let columns = gram_u.apply(g.spline_of_rows().coeffs())?;
    let duals: Vec<Vec<Q>> = columns.iter().map(|row| gram_v.apply(row)).collect::<Result<_>>()?;
    let by_gram = Q::dot(f.coeffs().iter().zip(duals.iter().flatten()));
    println!("An integral by two routes");
    println!("  ∬ f g = {by_product}, the integral of the product");
    println!("  ∬ f g = {by_gram}, by Gram matrices");
    let by_corners = f.times(&g)?.antiderivative(U)?.antiderivative(V)?.at(&Q::int(3), &Q::int(3))?;
    println!("  ∬ f g = {by_corners}, the antiderivative at the far corner");
    Ok(())
}

/// A scalar surface over clamped spaces with the given breaks.
fn grid(p: usize, us: [i64; 3], q: usize, vs: [i64; 3], value: impl Fn(i64) -> Q) -> Result<TensorSpline<Q>> {
    let (u, v) = (SplineSpace::clamped(p, us.map(Q::int))?, SplineSpace::clamped(q, vs.map(Q::int))?);
    let count = u.dim() * v.dim();
    TensorSpline::new(u, v, (0..count as i64).map(value).collect())
}

/// Degrees and size in words.
fn about<C: symspline::Coeff<Q>>(s: &TensorSpline<Q, C>) -> String {
    let (u, v) = (s.u(), s.v());
    format!("degrees ({}, {}), {} × {} coefficients", u.degree(), v.degree(), u.dim(), v.dim())
}
