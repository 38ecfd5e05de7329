//! `eval`: values and derivatives.

use crate::failure::{Failure, Result};
use crate::input::Input;
use crate::numbers::{One, Place, Places};
use crate::output;
use clap::Args;
use serde_json::{Value as Json, json};
use symspline::Q;
use symspline_dynamic::{AnySpace, Coords, Field, Number, Value, both};

/// How many values are made at most.
const MOST: usize = 10_000_000;

/// Evaluate a function, curve or surface at parameters
#[derive(Args, Debug)]
#[command(after_help = "\
Each line has the parameters, the orders of the derivative if there are derivatives, and the coordinates.

Examples:
  symspline eval --at 0.5,1/3 --derivatives 2 curve.json
  symspline eval --at 0.5:1/3 surface.json
  symspline eval --grid 101 --name C curves.json")]
pub struct Eval {
    #[command(flatten)]
    input: Input,
    /// Parameters: `u,u,...` or for surfaces `u:v,u:v,...`
    #[arg(
        long,
        value_name = "PLACES",
        allow_hyphen_values = true,
        required_unless_present = "grid",
        conflicts_with = "grid"
    )]
    at: Option<Places>,
    /// So many parameters from end to end; for surfaces along both directions
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..))]
    grid: Option<u32>,
    /// Derivatives up to this order too
    #[arg(long, value_name = "ORDER", default_value_t = 0)]
    derivatives: usize,
    /// Write JSON
    #[arg(long)]
    json: bool,
}

/// A value: where, of which derivative, and what.
struct Row {
    place: Vec<Number>,
    order: Vec<usize>,
    value: Coords,
}

impl Eval {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        let (place, entry) = self.input.entry()?;
        let rows = self.rows(&entry.value).map_err(|failure| failure.at(&place))?;
        if self.json {
            let row = |row: &Row| {
                let place: Json = row.place.iter().map(number).collect();
                let value: Json =
                    both!(&row.value, all => all.iter().map(|x| number(&x.clone().number())).collect());
                match self.derivatives {
                    0 => json!({"at": place, "value": value}),
                    _ => json!({"at": place, "order": row.order, "value": value}),
                }
            };
            return output::json(&rows.iter().map(row).collect());
        }
        let line = |row: &Row| {
            let mut cells: Vec<String> = row.place.iter().map(ToString::to_string).collect();
            if self.derivatives > 0 {
                cells.extend(row.order.iter().map(ToString::to_string));
            }
            both!(&row.value, all => cells.extend(all.iter().map(ToString::to_string)));
            format!("{}\n", cells.join("\t"))
        };
        output::text(&rows.iter().map(line).collect::<String>())
    }

    fn rows(&self, value: &Value) -> Result<Vec<Row>> {
        let spaces = match value {
            Value::Spline(s) => s.spaces(),
            Value::Rational(s) => s.spaces(),
            Value::Surface(s) => s.spaces(),
            Value::RationalSurface(s) => s.spaces(),
            other => return Err(Failure::refused(format!("a {} has no parameters", other.kind()))),
        };
        let places = self.places(&spaces)?;
        let mut rows = Vec::new();
        for place in places {
            self.add(value, place, &mut rows)?;
        }
        Ok(rows)
    }

    /// The places, in the field of the value.
    fn places(&self, spaces: &[AnySpace]) -> Result<Vec<Vec<Number>>> {
        let Some(count) = self.grid else {
            let places = self.at.as_ref().map_or(&[][..], |places| &places.0);
            return places.iter().map(|place| in_field(place, spaces)).collect();
        };
        let count = count as usize;
        let total = count.checked_pow(spaces.len() as u32).filter(|n| *n <= MOST);
        let total = total.ok_or_else(|| Failure::refused(format!("the grid has more than {MOST} places")))?;
        let axes: Vec<Vec<Number>> =
            spaces.iter().map(|space| both!(space, s => even(s.domain(), count))).collect();
        let place = |i: usize| match &axes[..] {
            [u, v] => vec![u[i / count].clone(), v[i % count].clone()],
            _ => vec![axes[0][i].clone()],
        };
        Ok((0..total).map(place).collect())
    }

    fn add(&self, value: &Value, place: Vec<Number>, rows: &mut Vec<Row>) -> Result<()> {
        let mut add =
            |order: Vec<usize>, value: Coords| rows.push(Row { place: place.clone(), order, value });
        let order = self.derivatives;
        match (value, &place[..]) {
            (Value::Spline(s), [x]) => {
                s.derivatives_at(x, order)?.into_iter().enumerate().for_each(|(k, d)| add(vec![k], d));
            }
            (Value::Rational(s), [x]) => {
                s.derivatives_at(x, order)?.into_iter().enumerate().for_each(|(k, d)| add(vec![k], d));
            }
            (Value::Surface(s), [u, v]) => add_mixed(s.derivatives_at(u, v, order)?, &mut add),
            (Value::RationalSurface(s), [u, v]) => add_mixed(s.derivatives_at(u, v, order)?, &mut add),
            (value, _) => return Err(Failure::refused(format!("a {} has no values", value.kind()))),
        }
        Ok(())
    }
}

fn add_mixed(all: Vec<Vec<Coords>>, add: &mut impl FnMut(Vec<usize>, Coords)) {
    for (k, row) in all.into_iter().enumerate() {
        row.into_iter().enumerate().for_each(|(l, d)| add(vec![k, l], d));
    }
}

/// A place as numbers of the field of its spaces, as many as there are parameters.
fn in_field(place: &Place, spaces: &[AnySpace]) -> Result<Vec<Number>> {
    if place.0.len() != spaces.len() {
        let form = if spaces.len() == 1 { "'u'" } else { "'u:v'" };
        return Err(Failure::Usage(format!("places are {form} here")));
    }
    let number = |(x, space): (&Q, &AnySpace)| {
        let x = One(x.clone()).number();
        Ok(if space.is_exact() { x } else { x.to_float()? })
    };
    place.0.iter().zip(spaces).map(number).collect()
}

/// Parameters from end to end.
fn even<T: Field>((start, end): (&T, &T), count: usize) -> Vec<Number> {
    let last = count as i64 - 1;
    let way = end.clone() - start;
    let inner = (1..last).map(|i| start.clone() + way.clone() * T::frac(i, last));
    std::iter::once(start.clone()).chain(inner).chain([end.clone()]).map(Field::number).collect()
}

/// A number: floats as numbers, fractions as text.
pub fn number(x: &Number) -> Json {
    match x {
        Number::Float(x) => json!(x),
        Number::Exact(x) => json!(x.to_string()),
    }
}
