//! Rational splines, NURBS: quotients of splines, kept as splines of [weighted](crate::Weighted) points.
//!
//! Every linear operator acts on the lifted spline as it stands ([`Rational::through`](spline::Rational::through)). The
//! products of the lifted splines under pairings of weighted points give the arithmetic ([`arithmetic`]).

pub mod domain;
pub mod spline;
pub mod curve;
pub mod surface;
pub(crate) mod quotient;
pub mod eval;
pub mod arithmetic;
pub mod derivative;
pub mod operators;
pub mod moebius;
pub mod range;
pub mod approximate;
pub mod polynomial;
