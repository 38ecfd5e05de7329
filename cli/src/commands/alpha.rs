//! The scale function of fine tuning, from a file or a list.

use crate::commands::calc::{Binding, bound_entry};
use crate::failure::{Failure, Result};
use crate::numbers::{Index, Interval, List};
use clap::Args;
use std::str::FromStr;
use symspline::{Direction, SplineSpace};
use symspline_dynamic::{AnySpace, AnySpline, AnySurface, Coords, Field, Number, Over, Value, both};

/// The scale function.
#[derive(Args, Clone, Debug)]
pub struct Alpha {
    /// The scale function: a file with one entry, or `FILE:ENTRY`
    #[arg(
        long,
        value_name = "FILE[:ENTRY]",
        required_unless_present = "alpha_values",
        conflicts_with = "alpha_values"
    )]
    alpha: Option<String>,
    /// Its control values, over uniform knots; for surfaces rows of one `u`, with `;` between
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    alpha_values: Option<Rows>,
    /// Its degree, for surfaces `p` or `p:q`
    #[arg(long, value_name = "DEGREE", default_value = "3")]
    alpha_degree: Index,
    /// Only this part is tuned: `a,b`, or `u0:v0,u1:v1` of a surface
    #[arg(long, value_name = "A,B", allow_hyphen_values = true)]
    pub on: Option<Interval>,
}

/// Rows of numbers, all as long.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows(Vec<List>);

impl FromStr for Rows {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let rows = text.split(';').map(str::parse).collect::<std::result::Result<Vec<List>, _>>()?;
        match rows.iter().position(|row| row.0.len() != rows[0].0.len()) {
            Some(i) => Err(format!("row {i} has {} numbers, the first {}", rows[i].0.len(), rows[0].0.len())),
            None => Ok(Self(rows)),
        }
    }
}

impl Alpha {
    /// The scale function of a curve or surface with these spaces: over the part that is tuned, or all of the domain.
    pub fn of(
        &self,
        spaces: &[AnySpace],
        exact: bool,
        convert: impl Fn(Value) -> Result<Value>,
    ) -> Result<Value> {
        let domain = self.domain(spaces)?;
        if let Some(rows) = &self.alpha_values {
            return self.listed(rows, &domain, exact);
        }
        let file = self.alpha.as_deref().unwrap_or_default();
        let value =
            convert(bound_entry(&Binding::of_file(file), None)?.value).map_err(|failure| failure.at(file))?;
        let restrict = || -> symspline_dynamic::Result<Value> {
            Ok(match (value, &domain[..], &self.on) {
                (Value::Spline(f), [(a, b)], Some(_)) => f.restricted(a, b)?.into(),
                (Value::Surface(f), [u, v], Some(_)) => {
                    f.restricted(Direction::U, &u.0, &u.1)?.restricted(Direction::V, &v.0, &v.1)?.into()
                }
                (value, ..) => value,
            })
        };
        restrict().map_err(|error| Failure::from(error).at(file))
    }

    /// Where the scale function is given: from where to where along each direction.
    fn domain(&self, spaces: &[AnySpace]) -> Result<Vec<(Number, Number)>> {
        let whole = |space: &AnySpace| both!(space, s => (s.domain().0.clone().number(), s.domain().1.clone().number()));
        let Some(Interval { from, to }) = &self.on else { return Ok(spaces.iter().map(whole).collect()) };
        if from.0.len() != spaces.len() || to.0.len() != spaces.len() {
            let form = if spaces.len() == 1 { "'a,b'" } else { "'u0:v0,u1:v1'" };
            return Err(Failure::Usage(format!("the part is {form} here")));
        }
        Ok(from.0.iter().zip(&to.0).map(|(a, b)| (Over::Exact(a.clone()), Over::Exact(b.clone()))).collect())
    }

    fn listed(&self, rows: &Rows, domain: &[(Number, Number)], exact: bool) -> Result<Value> {
        let counts = [rows.0.len(), rows.0[0].0.len()];
        let counts = if domain.len() == 1 { &counts[1..] } else { &counts[..] };
        if domain.len() == 1 && rows.0.len() != 1 {
            return Err(Failure::Usage("--alpha-values has one row for a curve".to_owned()));
        }
        let degree =
            |i: usize| self.alpha_degree.0.get(i).or(self.alpha_degree.0.first()).copied().unwrap_or(3);
        let space = |i: usize| -> Result<AnySpace> {
            let (degree, count) = (degree(i), counts[i]);
            let spans = count.checked_sub(degree).filter(|spans| *spans > 0).ok_or_else(|| {
                Failure::Usage(format!(
                    "--alpha-values has {count} numbers, degree {degree} takes {} or more",
                    degree + 1
                ))
            })?;
            let (a, b) = &domain[i];
            Ok(match exact {
                true => {
                    SplineSpace::uniform(degree, spans, symspline::Q::of(a)?, symspline::Q::of(b)?)?.into()
                }
                false => SplineSpace::uniform(degree, spans, f64::of(a)?, f64::of(b)?)?.into(),
            })
        };
        let coords = Coords::Exact(rows.0.iter().flat_map(|row| row.0.clone()).collect());
        let coords = if exact { coords } else { coords.to_float()? };
        Ok(match domain.len() {
            1 => AnySpline::new(space(0)?, 1, coords)?.into(),
            _ => AnySurface::new(space(0)?, space(1)?, 1, coords)?.into(),
        })
    }
}
