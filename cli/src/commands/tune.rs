//! `tune`: fine tuning of curves and surfaces.

use crate::commands::alpha::Alpha;
use crate::failure::{Failure, Result};
use crate::input::Input;
use crate::numbers::One;
use crate::output::{self, Output};
use clap::{Args, ValueEnum};
use nalgebra::SVector;
use std::fmt::Display;
use symspline::fine_tune::joint::Jointed;
use symspline::fine_tune::turn::Turnable;
use symspline::{
    Condition, Curve, Edge, Edges, Fit, Function, Hold, NearestScale, Norm, Path, Scale, Springs,
};
use symspline::{Surface, SurfaceCondition, TensorSpline};
use symspline_dynamic::{Any, AnySpline, AnySurface, Field, Value};

/// Fine-tune a curve or surface: its derivative times a scale function, so that its curvature is divided by it
#[derive(Args, Debug)]
#[command(after_help = "\
What was forced to hold the ends is told on standard error.

Examples:
  symspline tune --alpha-values 1,1,3/2,1 --hold points curve.json -o tuned.json
  symspline tune --alpha scale.json --hold nearest --order 1 --on 1/4,3/4 curve.json
  symspline tune --alpha-values '1,1,1;1,2,1;1,1,1' --alpha-degree 2 --path uv --hold points surface.json")]
pub struct Tune {
    #[command(flatten)]
    input: Input,
    #[command(flatten)]
    alpha: Alpha,
    /// What stays in place; of a part that is tuned its end points unless told
    #[arg(long, value_enum)]
    hold: Option<Held>,
    /// The order of derivatives that stay at the ends, with `--hold nearest`
    #[arg(long, default_value_t = 0)]
    order: usize,
    /// Keep the degree of a curve, within this distance
    #[arg(long, value_name = "TOLERANCE")]
    within: Option<One>,
    /// The path along which the derivatives of a surface are integrated
    #[arg(long, value_enum, default_value_t = Way::Both)]
    path: Way,
    /// Allow scale functions that are not positive
    #[arg(long)]
    signed: bool,
    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Held {
    /// The start alone
    None,
    /// End points, or edges
    Points,
    /// They and the first derivatives
    Tangents,
    /// They and the second derivatives
    Curvatures,
    /// The ends, by the nearest scale function: every tangent keeps its direction
    Nearest,
    /// A closed curve stays closed, by springs
    Closed,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Way {
    /// Along u, then along v
    Uv,
    /// Along v, then along u
    Vu,
    /// The mean of both
    Both,
}

/// Scale functions are positive unless any sign is allowed.
fn scale<F>(alpha: &F, signed: bool) -> Scale<'_, F> {
    if signed { Scale::Signed(alpha) } else { Scale::Positive(alpha) }
}

/// What a way of holding does not do.
fn unable(what: &str, instead: &str) -> Failure {
    Failure::refused(format!("{what}: {instead}"))
}

impl Tune {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        self.output.write(&self.input.changed(|value| self.tuned(value))?)
    }

    fn tuned(&self, value: &Value) -> Result<Value> {
        let (spaces, exact) = match value {
            Value::Spline(c) if c.dim() > 1 => (c.spaces(), c.is_exact()),
            Value::Surface(s) if s.dim() > 1 => (s.spaces(), s.is_exact()),
            Value::Rational(_) | Value::RationalSurface(_) => {
                let what =
                    "the integral of a scaled derivative of rational curves and surfaces is not rational";
                return Err(unable(what, "take 'polynomial' of 'symspline calc' first"));
            }
            other => {
                return Err(Failure::refused(format!(
                    "a curve or surface is expected, not a {}",
                    other.kind()
                )));
            }
        };
        let alpha = self.alpha.of(&spaces, exact, |value| Ok(self.input.field.convert(value)?))?;
        match (value, &alpha) {
            (Value::Spline(curve), Value::Spline(alpha)) => Ok(self.any_curve(curve, alpha)?.into()),
            (Value::Surface(surface), Value::Surface(alpha)) => Ok(self.any_surface(surface, alpha)?.into()),
            (value, alpha) => Err(Failure::refused(format!(
                "a {} is no scale function of a {}",
                alpha.kind(),
                value.kind()
            ))),
        }
    }

    fn hold(&self) -> Held {
        self.hold.unwrap_or(if self.alpha.on.is_some() { Held::Points } else { Held::None })
    }

    fn any_curve(&self, curve: &AnySpline, alpha: &AnySpline) -> Result<AnySpline> {
        Ok(match (curve, alpha, self.hold()) {
            (Any::F2(c), Any::F1(a), Held::Closed) => self.closed(c, a)?.into(),
            (Any::F3(c), Any::F1(a), Held::Closed) => self.closed(c, a)?.into(),
            (_, _, Held::Closed) => {
                return Err(unable("springs need square roots", "use --float, or --hold nearest"));
            }
            (Any::F2(c), Any::F1(a), Held::Nearest) => self.nearest(c, a)?.into(),
            (Any::F3(c), Any::F1(a), Held::Nearest) => self.nearest(c, a)?.into(),
            (Any::Q2(c), Any::Q1(a), Held::Nearest) => self.nearest(c, a)?.into(),
            (Any::Q3(c), Any::Q1(a), Held::Nearest) => self.nearest(c, a)?.into(),
            (Any::F2(c), Any::F1(a), hold) => self.held(c, a, hold)?.into(),
            (Any::F3(c), Any::F1(a), hold) => self.held(c, a, hold)?.into(),
            (Any::Q2(c), Any::Q1(a), hold) => self.held(c, a, hold)?.into(),
            (Any::Q3(c), Any::Q1(a), Held::None) if self.within.is_none() => {
                c.fine_tuned(scale(a, self.signed))?.into()
            }
            (Any::Q3(_), Any::Q1(_), _) => return Err(unable(TURNS, "use --float, or --hold nearest")),
            (curve, alpha, _) => return Err(unlike(curve, alpha)),
        })
    }

    /// The ends held by a rotation and scaling.
    fn held<T: Field, const N: usize>(
        &self,
        c: &Curve<T, N>,
        alpha: &Function<T>,
        hold: Held,
    ) -> Result<Curve<T, N>>
    where
        SVector<T, N>: Turnable<T>,
    {
        let hold = match hold {
            Held::Points => Hold::Points,
            Held::Tangents => Hold::Tangents,
            Held::Curvatures => Hold::Curvatures,
            _ => Hold::Start,
        };
        let alpha = scale(alpha, self.signed);
        if let Some(tolerance) = &self.within {
            let near = c.fine_tuned_within(alpha, hold, &tolerance.of()?)?;
            output::note(format_args!("within {} of what tuning makes", near.bound));
            return Ok(near.spline);
        }
        let whole = alpha_domain(&alpha) == c.domain();
        let (held, curve) = match whole {
            true => {
                let held = c.fine_tuned_holding(alpha, hold)?;
                let curve = held.curve.clone();
                (held, curve)
            }
            false => {
                let local = c.fine_tuned_on(alpha, hold)?;
                (local.tuned().clone(), local.joined()?)
            }
        };
        if hold != Hold::Start {
            note_held(&held.squared_scale, &held.deviation()?);
        }
        Ok(curve)
    }

    /// The ends held by the choice of the scale function.
    fn nearest<T: Field, const N: usize>(&self, c: &Curve<T, N>, alpha: &Function<T>) -> Result<Curve<T, N>> {
        let (start, end) = c.domain();
        let local = alpha.domain() != c.domain();
        if local || self.within.is_some() {
            if self.signed {
                return Err(Failure::Usage("--signed does not go with a part or --within here".to_owned()));
            }
            let local = c.fine_tuned_on_by_nearest(alpha, self.order, Norm::L2)?;
            let Some(tolerance) = &self.within else { return Ok(local.joined()?) };
            let near = local.reduced(&tolerance.of()?)?;
            output::note(format_args!("within {} of what tuning makes", near.bound));
            return Ok(near.spline);
        }
        let mut conditions = vec![Condition::End];
        if self.order > 0 {
            let kept = |x: &T| Condition::Derivatives { parameter: x.clone(), count: self.order };
            conditions.extend([kept(start), kept(end)]);
        }
        let nearest = NearestScale::prepare(c, alpha.space(), &conditions, Norm::L2)?;
        let taken = if self.signed { nearest.to_signed(alpha)? } else { nearest.to(alpha)? };
        output::note(format_args!("the scale function is off by at most {}", taken.distance_bound(alpha)?));
        Ok(c.fine_tuned(scale(&taken, self.signed))?)
    }

    fn closed<const N: usize>(&self, c: &Curve<f64, N>, alpha: &Function<f64>) -> Result<Curve<f64, N>>
    where
        SVector<f64, N>: Jointed,
    {
        if self.within.is_some() || self.alpha.on.is_some() {
            return Err(Failure::Usage("--hold closed is of the whole curve, without --within".to_owned()));
        }
        let relaxed = c.fine_tuned_closed(scale(alpha, self.signed), &Springs::default())?;
        output::note(format_args!(
            "lengths off by at most {:.3e}, angles by {:.3e}, after {} steps{}",
            relaxed.length_deviation,
            relaxed.angle_deviation,
            relaxed.iterations,
            if relaxed.converged { "" } else { ", not at rest yet" }
        ));
        Ok(relaxed.curve)
    }

    fn any_surface(&self, surface: &AnySurface, alpha: &AnySurface) -> Result<AnySurface> {
        if self.within.is_some() {
            return Err(Failure::Usage("--within is of curves".to_owned()));
        }
        let path = match self.path {
            Way::Uv => Path::UThenV,
            Way::Vu => Path::VThenU,
            Way::Both => Path::Both,
        };
        let fit = match self.hold() {
            Held::None => Fit::Free,
            Held::Points => Fit::Position,
            Held::Tangents => Fit::Tangent,
            Held::Curvatures => Fit::Curvature,
            Held::Nearest => {
                return Ok(match (surface, alpha) {
                    (Any::F2(s), Any::F1(a)) => self.nearest_surface(s, a, path)?.into(),
                    (Any::F3(s), Any::F1(a)) => self.nearest_surface(s, a, path)?.into(),
                    (Any::Q2(s), Any::Q1(a)) => self.nearest_surface(s, a, path)?.into(),
                    (Any::Q3(s), Any::Q1(a)) => self.nearest_surface(s, a, path)?.into(),
                    (surface, alpha) => return Err(unlike(surface, alpha)),
                });
            }
            Held::Closed => return Err(unable("springs close curves", "use --hold nearest")),
        };
        Ok(match (surface, alpha) {
            (Any::F2(s), Any::F1(a)) => self.held_surface(s, a, path, fit)?.into(),
            (Any::F3(s), Any::F1(a)) => self.held_surface(s, a, path, fit)?.into(),
            (Any::Q2(s), Any::Q1(a)) => self.held_surface(s, a, path, fit)?.into(),
            (Any::Q3(s), Any::Q1(a)) if fit == Fit::Free => s.fine_tuned(scale(a, self.signed), path)?.into(),
            (Any::Q3(_), Any::Q1(_)) => return Err(unable(TURNS, "use --float, or --hold nearest")),
            (surface, alpha) => return Err(unlike(surface, alpha)),
        })
    }

    fn held_surface<T: Field, const N: usize>(
        &self,
        s: &Surface<T, N>,
        alpha: &TensorSpline<T>,
        path: Path,
        fit: Fit,
    ) -> Result<Surface<T, N>>
    where
        SVector<T, N>: Turnable<T>,
    {
        let whole = (alpha.u().domain(), alpha.v().domain()) == (s.u().domain(), s.v().domain());
        let (alpha, edges) = (scale(alpha, self.signed), Edges::all(fit));
        let (surface, forced) = match whole {
            true => {
                let held = s.fine_tuned_holding(alpha, path, edges)?;
                (held.surface, held.forced)
            }
            false => {
                let local = s.fine_tuned_on(alpha, path, edges)?;
                (local.joined()?, local.tuned().forced.clone())
            }
        };
        if fit != Fit::Free {
            output::note(format_args!("control points at edges were forced by at most {forced}"));
        }
        Ok(surface)
    }

    /// The edges across the path held by the choice of the scale function.
    fn nearest_surface<T: Field, const N: usize>(
        &self,
        s: &Surface<T, N>,
        alpha: &TensorSpline<T>,
        path: Path,
    ) -> Result<Surface<T, N>> {
        let edges: &[Edge] = match path {
            Path::UThenV => &[Edge::VStart, Edge::VEnd],
            Path::VThenU => &[Edge::UStart, Edge::UEnd],
            Path::Both => &Edge::ALL,
        };
        let condition = |edge: &Edge| SurfaceCondition::Edge { edge: *edge, order: self.order };
        let conditions: Vec<_> = edges.iter().map(condition).collect();
        let nearest = NearestScale::on_surface(s, (alpha.u(), alpha.v()), path, &conditions, Norm::L2)?;
        let taken = if self.signed { nearest.to_signed(alpha)? } else { nearest.to(alpha)? };
        Ok(s.fine_tuned(scale(&taken, self.signed), path)?)
    }
}

/// Why exact curves and surfaces in space are not turned.
const TURNS: &str = "turning an exact curve or surface in space, to hold its ends, needs square roots";

/// The domain of a scale function.
fn alpha_domain<'a, T: Field>(alpha: &Scale<'a, Function<T>>) -> (&'a T, &'a T) {
    match alpha {
        Scale::Positive(alpha) | Scale::Signed(alpha) => alpha.domain(),
    }
}

fn note_held(squared_scale: &impl Display, deviation: &impl Display) {
    output::note(format_args!(
        "held by a similarity whose scale squared is {squared_scale}; control points at the ends were put elsewhere by at most {deviation}"
    ));
}

/// That fields or kinds do not go together.
fn unlike<F: symspline_dynamic::Family>(shape: &Any<F>, alpha: &Any<F>) -> Failure {
    match shape.is_exact() == alpha.is_exact() {
        true => Failure::refused(format!(
            "a scale function has numbers as values, this {} has points",
            alpha.kind()
        )),
        false => Failure::refused(format!(
            "the {} is {} and the scale function {}: use --exact or --float",
            shape.kind(),
            shape.field(),
            alpha.field()
        )),
    }
}
