//! Skins: surfaces through curves.

use crate::error::{Failure, Result};
use crate::numbers::{Array, Num};
use crate::space::Space;
use crate::spline::Spline;
use crate::surface::Surface;
use nalgebra::SVector;
use pyo3::prelude::*;
use symspline::{Error, Skin};
use symspline_dynamic::{Any, AnySpline, AnySurface, Coords, Field, Meeting, Spaced};

/// A surface that the skin goes on from or into, alone or with the factor of the derivatives across.
#[derive(FromPyObject)]
enum Neighbour {
    Scaled(Surface, Num),
    Alone(Surface),
}

impl Neighbour {
    fn parts(self) -> (AnySurface, Num) {
        match self {
            Self::Scaled(surface, factor) => (surface.0, factor),
            Self::Alone(surface) => (surface.0, Num::int(1)),
        }
    }
}

fn met<M: Meeting>(of: &M, exact: bool) -> Result<M> {
    Ok(of.among(exact)?.into_owned())
}

fn unlike(left: usize, right: usize) -> Failure {
    symspline_dynamic::Error::Dimensions { left, right }.into()
}

fn lengths<const N: usize>(
    skin: Skin<f64, SVector<f64, N>>,
    spacing: &str,
) -> Result<Skin<f64, SVector<f64, N>>> {
    match spacing {
        "chord" => Ok(skin.by_chord_length()?),
        "centripetal" => Ok(skin.centripetal()?),
        other => {
            Err(Failure::new("Spacing", format!("'{other}' is no spacing: \"chord\" or \"centripetal\" is")))
        }
    }
}

fn none<S>(_: S, _: &str) -> Result<S> {
    Err(Failure::new("Spacing", "spacing by lengths is for curves over floats"))
}

#[pymethods]
impl Surface {
    /// The skin through curves, its sections at `parameters` of `v` (evenly spaced, or by "chord" length or "centripetal"), of a `degree`
    /// in `v` or in a `space` of `v`, which has as many coefficients as there are sections and tangents. With `closed` it comes back to
    /// the first; `start` and `end` are curves of tangents across the first and last section. `continuing` is a surface that ends, along
    /// its `v`, where the skin starts, and `continued_by` one that starts where it ends: the skin takes over the derivative across there,
    /// in a pair with a number that many times. The edges have to be the sections within `tolerance`, a distance.
    #[staticmethod]
    #[pyo3(signature = (sections, degree=None, parameters=None, *, space=None, spacing=None, closed=false, start=None, end=None,
        continuing=None, continued_by=None, tolerance=Num::int(0)))]
    #[allow(clippy::too_many_arguments, reason = "they are the keywords of Python")]
    fn skin(
        py: Python<'_>,
        sections: Vec<Spline>,
        degree: Option<usize>,
        parameters: Option<Array>,
        space: Option<Space>,
        spacing: Option<&str>,
        closed: bool,
        start: Option<Spline>,
        end: Option<Spline>,
        continuing: Option<Neighbour>,
        continued_by: Option<Neighbour>,
        tolerance: Num,
    ) -> Result<Self> {
        let parameters = parameters.map(Array::list).transpose()?;
        let neighbours = [continuing, continued_by].map(|one| one.map(Neighbour::parts));
        let mut exact =
            sections.iter().chain(&start).chain(&end).all(|s| s.0.is_exact()) && spacing.is_none();
        exact &= parameters.as_ref().is_none_or(Coords::is_exact);
        exact &= space.as_ref().is_none_or(|space| space.0.is_exact());
        exact &=
            neighbours.iter().flatten().all(|(surface, factor)| surface.is_exact() && factor.0.is_exact());
        let sections = sections.iter().map(|s| met(&s.0, exact)).collect::<Result<Vec<_>>>()?;
        let [start, end] = [start, end].map(|s| s.as_ref().map(|s| met(&s.0, exact)).transpose());
        let (start, end, space) = (start?, end?, space.map(|space| met(&space.0, exact)).transpose()?);
        let [before, after] = neighbours
            .map(|one| one.map(|(s, factor)| Ok::<_, Failure>((met(&s, exact)?, factor.0))).transpose());
        let (before, after) = (before?, after?);
        let Some(first) = sections.first() else {
            return Err(Error::from(symspline::SkinError::TooFewSections { expected: 2, found: 0 }).into());
        };
        // One text for each kind of curve; the spacing by lengths is for floats alone.
        macro_rules! skin {
            ($($kind:ident: $T:ty, $spaced:expr;)+) => {
                match first {
                    $(Any::$kind(_) => {
                        let inner = |s: &AnySpline| match s {
                            Any::$kind(s) => Ok(s.clone()),
                            other => Err(unlike(first.dim(), other.dim())),
                        };
                        let beside = |s: &AnySurface| match s {
                            Any::$kind(s) => Ok(s.clone()),
                            other => Err(unlike(first.dim(), other.dim())),
                        };
                        let curves = sections.iter().map(inner).collect::<Result<Vec<_>>>()?;
                        let mut skin = if closed { Skin::closed_through(&curves)? } else { Skin::through(&curves)? };
                        if let Some(parameters) = &parameters {
                            skin = skin.with_parameters(&<$T>::all_of(parameters)?)?;
                        }
                        if let Some(spacing) = spacing {
                            skin = $spaced(skin, spacing)?;
                        }
                        if let Some(start) = &start {
                            skin = skin.start_tangents(&inner(start)?)?;
                        }
                        if let Some(end) = &end {
                            skin = skin.end_tangents(&inner(end)?)?;
                        }
                        let tolerance = <$T>::of(&tolerance.0)?;
                        if let Some((before, factor)) = &before {
                            skin = skin.continuing(&beside(before)?, &<$T>::of(factor)?, &tolerance)?;
                        }
                        if let Some((after, factor)) = &after {
                            skin = skin.continued_by(&beside(after)?, &<$T>::of(factor)?, &tolerance)?;
                        }
                        Ok(Self(match (degree, &space) {
                            (Some(degree), None) => skin.surface(degree)?.into(),
                            (None, Some(space)) => skin.surface_in(<$T as Spaced>::space(space)?)?.into(),
                            _ => return Err(Failure::new("Word", "a skin has either a degree or a space across")),
                        }))
                    })+
                }
            };
        }
        if (start.is_some() && before.is_some()) || (end.is_some() && after.is_some()) {
            return Err(Failure::new(
                "Word",
                "tangents across an end are given, or taken from a surface, not both",
            ));
        }
        py.detach(|| {
            skin!(
                F1: f64, none;
                F2: f64, lengths;
                F3: f64, lengths;
                Q1: symspline::Q, none;
                Q2: symspline::Q, none;
                Q3: symspline::Q, none;
            )
        })
    }
}
