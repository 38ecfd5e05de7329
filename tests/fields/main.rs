//! Any ordered field will do: the library over numbers it has never heard of.
//!
//! - [`dual`]: numbers `a + b ε` with `ε² = 0`. What is computed with `t + ε` in place of a knot or a coefficient `t` carries
//!   its derivative by `t` along.
//! - [`fraction`]: quotients of polynomials in a symbol `x`. Knots and coefficients may contain it, and so does what is
//!   computed from them; a number may be put in its place before or after.
//! - [`bare`]: exact numbers that go without the hooks of the library, which must not change a result.
//!
//! ```text
//! let x = Fraction::symbol();
//! let alpha = Function::new(SplineSpace::clamped(1, [zero, one + &x, two])?, vec![...])?;
//! let tuned = curve.fine_tuned(&alpha)?;                      // its control points are fractions in x
//! let quarter = tuned.map_scalars(|c| c.at(&Q::frac(1, 4)))?;   // the curve for the knot 1 + 1/4
//! ```

mod signs;
mod dual;
mod fraction;
mod derivatives;
mod symbols;
mod bare;
