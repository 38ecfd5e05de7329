//! Reading STEP.

use crate::entry::Entry;
use crate::error::{Problem, Result};
use crate::nurbs::{Along, Nurbs};
use crate::step::exchange::{Exchange, place};
use crate::step::parameter::{Parameter, Part, wrong};
use crate::step::text;
use std::collections::{HashMap, HashSet};
use symspline::limits::MAX_DEGREE;

type Read<T> = std::result::Result<T, Problem>;

/// What holds the curves in the parameters of surfaces.
const IN_PARAMETERS: &str = "DEFINITIONAL_REPRESENTATION";

/// The curves and surfaces of a STEP file, in the order of the file.
///
/// # Errors
/// [`Problem::Syntax`] with line and column where the structure is wrong; [`Problem::Syntax`] and [`Problem::Value`] with the instance,
/// `#12`, whose parameters are wrong.
pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>> {
    let exchange = Exchange::of(bytes, |word| word == IN_PARAMETERS || kind(word).is_some())?;
    let mut passed = HashSet::new();
    for id in &exchange.found {
        let parts = exchange.instance(*id).map_err(|problem| problem.at(place(*id)))?;
        for (_, parameters) in parts.iter().filter(|(name, _)| *name == IN_PARAMETERS) {
            let items = parameters.iter().flat_map(|parameter| parameter.list().unwrap_or_default());
            passed.extend(items.filter_map(|item| item.reference().ok()));
            passed.insert(*id);
        }
    }
    let mut reader = Reader { exchange: &exchange, points: HashMap::new() };
    let splines = exchange.found.iter().filter(|id| !passed.contains(id));
    splines.map(|id| reader.entry(*id).map_err(|problem| problem.at(place(*id)))).collect()
}

/// How a type of curves or surfaces tells its knots, and whether it is of surfaces.
fn kind(word: &str) -> Option<(&str, bool)> {
    let (kind, surface) = match (word.strip_suffix("_WITH_KNOTS"), word) {
        (Some("B_SPLINE_CURVE"), _) => ("WITH_KNOTS", false),
        (Some("B_SPLINE_SURFACE"), _) => ("WITH_KNOTS", true),
        _ => match (word.strip_suffix("_CURVE"), word.strip_suffix("_SURFACE")) {
            (Some(kind), _) => (kind, false),
            (_, Some(kind)) => (kind, true),
            _ => return None,
        },
    };
    let known = ["WITH_KNOTS", "B_SPLINE", "RATIONAL_B_SPLINE", "BEZIER", "UNIFORM", "QUASI_UNIFORM"];
    known.contains(&kind).then_some((kind, surface))
}

struct Reader<'a> {
    exchange: &'a Exchange<'a>,
    /// Those that were read: many control points may be one instance.
    points: HashMap<u64, Vec<f64>>,
}

impl Reader<'_> {
    fn entry(&mut self, id: u64) -> Read<Entry> {
        let parts = complex(self.exchange.instance(id)?)?;
        let surface = parts.iter().any(|(name, _)| *name == "B_SPLINE_SURFACE");
        let told = if surface { self.surface(&parts)? } else { self.curve(&parts)? };
        let name = match part(&parts, "REPRESENTATION_ITEM")? {
            [Parameter::Text(name)] if !name.is_empty() => Some(text::read(name)),
            _ => None,
        };
        Ok(Entry { name, value: told.into_value()? })
    }

    fn curve(&mut self, parts: &[Part<'_>]) -> Read<Nurbs> {
        let [degree, points, _, closed, _] = part(parts, "B_SPLINE_CURVE")? else {
            return wrong("B_SPLINE_CURVE has five parameters");
        };
        let points = points.list()?;
        let along = Along::new(parts, degree, points.len(), closed, 0)?;
        let weights = weights(parts, "RATIONAL_B_SPLINE_CURVE")?;
        let weights = weights.map(|weights| weights.reals()).transpose()?;
        check_count(weights.as_deref(), points.len())?;
        let (dim, coords) = self.coords(points.iter())?;
        Ok(Nurbs { along: vec![along], dim, coords, weights })
    }

    fn surface(&mut self, parts: &[Part<'_>]) -> Read<Nurbs> {
        let [u_degree, v_degree, points, _, u_closed, v_closed, _] = part(parts, "B_SPLINE_SURFACE")? else {
            return wrong("B_SPLINE_SURFACE has seven parameters");
        };
        let rows = points.list()?.iter().map(Parameter::list).collect::<Read<Vec<_>>>()?;
        let columns = rows.first().map_or(0, |row| row.len());
        if let Some(i) = rows.iter().position(|row| row.len() != columns) {
            return wrong(format!(
                "row {i} of the control points has {} points, not {columns}",
                rows[i].len()
            ));
        }
        let u = Along::new(parts, u_degree, rows.len(), u_closed, 0)?;
        let v = Along::new(parts, v_degree, columns, v_closed, 1)?;
        let weights = match weights(parts, "RATIONAL_B_SPLINE_SURFACE")? {
            Some(weights) => {
                let weights = weights.list()?.iter().map(Parameter::reals).collect::<Read<Vec<_>>>()?;
                let even = weights.len() == rows.len() && weights.iter().all(|row| row.len() == columns);
                if !even {
                    return wrong("the rows of weights are not those of the control points");
                }
                Some(weights.concat())
            }
            None => None,
        };
        let (dim, coords) = self.coords(rows.into_iter().flatten())?;
        Ok(Nurbs { along: vec![u, v], dim, coords, weights })
    }

    /// The dimension and the coordinates of points that are referred to.
    fn coords<'p>(&mut self, points: impl Iterator<Item = &'p Parameter<'p>>) -> Read<(usize, Vec<f64>)> {
        let (mut dim, mut coords) = (None, Vec::new());
        for point in points {
            let id = point.reference()?;
            let point = self.point(id)?;
            if *dim.get_or_insert(point.len()) != point.len() {
                return wrong(format!("#{id} has another number of coordinates than those before"));
            }
            coords.extend(point);
        }
        Ok((dim.unwrap_or(3), coords))
    }

    fn point(&mut self, id: u64) -> Read<&[f64]> {
        if !self.points.contains_key(&id) {
            let place = |problem: Problem| Problem::Syntax(format!("#{id}: {problem}"));
            let parts = match self.exchange.instance(id) {
                Err(problem) if self.exchange.defines(id) => return Err(place(problem)),
                parts => parts?,
            };
            let found = match parts.as_slice() {
                [("CARTESIAN_POINT", parameters)] => parameters.last(),
                _ => match parts.iter().find(|(name, _)| *name == "CARTESIAN_POINT") {
                    Some((_, parameters)) => parameters.last(),
                    None => return wrong(format!("#{id} is not a CARTESIAN_POINT")),
                },
            };
            let Some(found) = found else {
                return wrong(format!("#{id}: a CARTESIAN_POINT has coordinates"));
            };
            let coords = found.reals().map_err(place)?;
            if !(2..=3).contains(&coords.len()) {
                return wrong(format!("#{id}: {} coordinates; there may be two or three", coords.len()));
            }
            self.points.insert(id, coords);
        }
        Ok(&self.points[&id])
    }
}

impl Along {
    fn new(
        parts: &[Part<'_>],
        degree: &Parameter<'_>,
        count: usize,
        closed: &Parameter<'_>,
        direction: usize,
    ) -> Read<Self> {
        let degree = degree.size()?;
        if degree == 0 || degree > MAX_DEGREE {
            return wrong(format!("a degree of {degree} is not possible"));
        }
        let periodic = closed.is_true();
        for (name, parameters) in parts {
            let (told, surface) = match kind(name) {
                Some((told, surface)) if !told.contains("B_SPLINE") => (told, surface),
                _ => continue,
            };
            let knots = match told {
                "WITH_KNOTS" => {
                    // Multiplicities and knots, for a surface first the one and then the other of both directions.
                    let step = if surface { 2 } else { 1 };
                    if parameters.len() != 2 * step + 1 {
                        return wrong(format!("{name} has {} parameters of its own", 2 * step + 1));
                    }
                    let (copies, knots) =
                        (parameters[direction].sizes()?, parameters[direction + step].reals()?);
                    expanded(&knots, &copies, count + degree + 1)?
                }
                told => default_knots(told, degree, count)?,
            };
            return Ok(Self { degree, knots, periodic });
        }
        wrong("no part tells the knots")
    }
}

/// The parts of an instance as if it were written with all of its types.
fn complex(parts: Vec<Part<'_>>) -> Read<Vec<Part<'_>>> {
    let [(name, parameters)] = parts.as_slice() else { return Ok(parts) };
    let Some((_, surface)) = kind(name) else { return wrong(format!("{name} is no curve or surface")) };
    let (general, own) = if surface { ("B_SPLINE_SURFACE", 7) } else { ("B_SPLINE_CURVE", 5) };
    if parameters.len() < own + 1 {
        return wrong(format!("{name} has {} parameters or more, not {}", own + 1, parameters.len()));
    }
    let item = ("REPRESENTATION_ITEM", parameters[..1].to_vec());
    let rest = (*name, parameters[own + 1..].to_vec());
    let mut all = vec![item, (general, parameters[1..=own].to_vec())];
    if *name != general {
        all.push(rest);
    }
    Ok(all)
}

fn part<'p, 'a>(parts: &'p [Part<'a>], name: &str) -> Read<&'p [Parameter<'a>]> {
    match parts.iter().find(|part| part.0 == name) {
        Some((_, parameters)) => Ok(parameters),
        None => wrong(format!("{name} is missing")),
    }
}

fn weights<'p, 'a>(parts: &'p [Part<'a>], name: &str) -> Read<Option<&'p Parameter<'a>>> {
    match parts.iter().find(|part| part.0 == name) {
        None => Ok(None),
        Some((_, parameters)) => match parameters.as_slice() {
            [weights] => Ok(Some(weights)),
            _ => wrong(format!("{name} has one parameter of its own")),
        },
    }
}

fn check_count(weights: Option<&[f64]>, points: usize) -> Read<()> {
    match weights {
        Some(weights) if weights.len() != points => {
            wrong(format!("{points} control points have {} weights", weights.len()))
        }
        _ => Ok(()),
    }
}

/// Each knot as often as it has copies, `expected` of them in all.
fn expanded(knots: &[f64], copies: &[usize], expected: usize) -> Read<Vec<f64>> {
    if knots.len() != copies.len() {
        return wrong(format!("{} knots have {} multiplicities", knots.len(), copies.len()));
    }
    let found = copies.iter().fold(0_usize, |sum, count| sum.saturating_add(*count));
    if found != expected || copies.contains(&0) {
        return wrong(format!(
            "the multiplicities make {found} knots, not {expected}, or one of them is zero"
        ));
    }
    if let Some(i) = (1..knots.len()).find(|&i| knots[i] <= knots[i - 1]) {
        return wrong(format!("knot {i} is not greater than the one before"));
    }
    Ok(knots.iter().zip(copies).flat_map(|(knot, count)| std::iter::repeat_n(*knot, *count)).collect())
}

/// The knots that the standard gives to curves without any: whole numbers.
fn default_knots(told: &str, degree: usize, count: usize) -> Read<Vec<f64>> {
    if count <= degree {
        return wrong(format!("{count} control points do not make degree {degree}"));
    }
    // From -degree in steps of one, every knot once.
    if told == "UNIFORM" {
        return Ok((0..count + degree + 1).map(|i| i as f64 - degree as f64).collect());
    }
    // Full copies at the ends from 0, inside one, or in Bézier pieces as many as the degree.
    let (step, spans) = match told {
        "BEZIER" if !(count - 1).is_multiple_of(degree) => {
            return wrong(format!("{count} control points do not make pieces of degree {degree}"));
        }
        "BEZIER" => (degree, (count - 1) / degree),
        _ => (1, count - degree),
    };
    let inner = (1..spans).flat_map(|i| std::iter::repeat_n(i as f64, step));
    let end = |t: f64| std::iter::repeat_n(t, degree + 1);
    Ok(end(0.0).chain(inner).chain(end(spans as f64)).collect())
}
