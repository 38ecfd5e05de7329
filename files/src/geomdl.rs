//! The JSON of geomdl (NURBS-Python): what its `exchange.export_json` writes and `import_json` reads.
//!
//! ```text
//! {"shape": {"type": "curve", "count": 1, "data": [
//!   {"type": "spline", "rational": true, "dimension": 2, "degree": 2, "knotvector": [0, 0, 0, 1, 1, 1],
//!    "control_points": {"points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]}, "name": "arc"}]}}
//! ```
//! A file holds curves or surfaces, not both. Points are not multiplied by weights; those of surfaces stand row by row, each row of one
//! `u`. What geomdl adds about drawing (`delta`, `id`, `reversed`) is passed over; trimmed surfaces, volumes and freeform shapes are
//! refused. Numbers are floats: exact ones are rounded to nearest when written. There is no periodic spline in this format: it is
//! written open, with its knots unrolled. geomdl moves knots to `[0, 1]` as it reads, unless it is told not to.

use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use crate::json::{Count, syntax};
use crate::nurbs::{Along, Nurbs};
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use symspline_dynamic::Value;

const FORMAT: &str = "geomdl";

#[derive(Serialize, Deserialize)]
struct Document {
    shape: Shape,
}

#[derive(Serialize, Deserialize)]
struct Shape {
    #[serde(rename = "type")]
    kind: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    count: Option<Count>,
    data: Vec<Data>,
}

#[derive(Default, Serialize, Deserialize)]
struct Data {
    #[serde(rename = "type", default, skip_serializing_if = "Option::is_none")]
    kind: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    rational: Option<bool>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    dimension: Option<Count>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    degree: Option<Count>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    knotvector: Option<Vec<f64>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    degree_u: Option<Count>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    degree_v: Option<Count>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    knotvector_u: Option<Vec<f64>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    knotvector_v: Option<Vec<f64>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    size_u: Option<Count>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    size_v: Option<Count>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    control_points: Option<Points>,
    #[serde(default, skip_serializing)]
    trims: Option<Trims>,
}

#[derive(Serialize, Deserialize)]
struct Points {
    points: Vec<Vec<f64>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    weights: Option<Vec<f64>>,
}

#[derive(Deserialize)]
struct Trims {
    #[serde(default)]
    data: Vec<IgnoredAny>,
}

type Read<T> = std::result::Result<T, Problem>;

/// Whether a JSON text is of this format and not of the library's own.
pub(crate) fn is_meant(bytes: &[u8]) -> bool {
    #[derive(Deserialize)]
    struct Peek {
        format: Option<IgnoredAny>,
        shape: Option<IgnoredAny>,
    }
    serde_json::from_slice(bytes).is_ok_and(|peek: Peek| peek.format.is_none() && peek.shape.is_some())
}

/// The curves or surfaces of a geomdl JSON text.
///
/// # Errors
/// [`Problem::Syntax`] with line and column, or with the number of the shape, from 0; [`Problem::Value`] with that number.
pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>> {
    let Document { shape } = serde_json::from_slice(bytes).map_err(syntax)?;
    let read = match shape.kind.as_str() {
        "curve" => Data::curve,
        "surface" => Data::surface,
        other => {
            return Err(Problem::Syntax(format!("shapes of type \"{other}\" are not read")).of_file());
        }
    };
    if let Some(count) = shape.count.filter(|count| count.0 != shape.data.len()) {
        let found = format!("\"count\" is {}, but there are {} shapes", count.0, shape.data.len());
        return Err(Problem::Syntax(found).of_file());
    }
    let entry = |(i, data): (usize, &Data)| match read(data) {
        Ok(value) => Ok(Entry { name: data.name.clone(), value }),
        Err(problem) => Err(problem.at(Place::Entry(format!("shape {i}")))),
    };
    shape.data.iter().enumerate().map(entry).collect()
}

/// The geomdl JSON text of curves, or of surfaces.
///
/// # Errors
/// [`Problem::NoRoom`] for functions, numbers, points and meshes, for degree 0, for curves and surfaces in one file, and for weights
/// that are zero, negative or too small.
pub fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>> {
    let at = |i: usize, problem: Problem| problem.at(Place::Entry(format!("item {i}")));
    let mut kind = None;
    let mut data = Vec::with_capacity(entries.len());
    for (i, entry) in entries.iter().enumerate() {
        let (found, one) = Data::of(entry).map_err(|problem| at(i, problem))?;
        if *kind.get_or_insert(found) != found {
            let value = "curves and surfaces in one file".into();
            return Err(at(i, Problem::NoRoom { format: FORMAT, value }));
        }
        data.push(one);
    }
    let kind = kind.unwrap_or("curve").to_owned();
    let document = Document { shape: Shape { kind, count: Some(Count(data.len())), data } };
    let mut bytes =
        serde_json::to_vec(&document).map_err(|error| Problem::Syntax(error.to_string()).of_file())?;
    bytes.push(b'\n');
    Ok(bytes)
}

/// A part of a shape that it must have.
fn needed<'a, T>(part: &'a Option<T>, name: &str) -> Read<&'a T> {
    part.as_ref().ok_or_else(|| Problem::Syntax(format!("\"{name}\" is missing")))
}

fn along(degree: &Option<Count>, knots: &Option<Vec<f64>>, suffix: &str) -> Read<Along> {
    let degree = needed(degree, &format!("degree{suffix}"))?.0;
    let knots = needed(knots, &format!("knotvector{suffix}"))?.clone();
    Ok(Along { degree, knots, periodic: false })
}

impl Data {
    /// The value of the control points over these parameters.
    fn value(&self, along: Vec<Along>) -> Read<Value> {
        if let Some(kind) = self.kind.as_ref().filter(|kind| *kind != "spline") {
            return Err(Problem::Syntax(format!("shapes of type \"{kind}\" are not read")));
        }
        let Points { points, weights } = needed(&self.control_points, "control_points")?;
        let dim = points.first().map_or(1, Vec::len);
        if let Some(index) = points.iter().position(|point| point.len() != dim) {
            return Err(symspline::Error::Ragged { index }.into());
        }
        if let Some(found) = self.dimension.filter(|found| found.0 != dim) {
            return Err(Problem::Syntax(format!("\"dimension\" is {}, but points have {dim}", found.0)));
        }
        let ones = || vec![1.0; points.len()];
        let weights = weights.clone().or_else(|| (self.rational == Some(true)).then(ones));
        Nurbs { along, dim, coords: points.concat(), weights }.into_value()
    }

    fn curve(&self) -> Read<Value> {
        self.value(vec![along(&self.degree, &self.knotvector, "")?])
    }

    fn surface(&self) -> Read<Value> {
        if self.trims.as_ref().is_some_and(|trims| !trims.data.is_empty()) {
            return Err(Problem::Syntax("trimmed surfaces are not read".into()));
        }
        let u = along(&self.degree_u, &self.knotvector_u, "_u")?;
        let v = along(&self.degree_v, &self.knotvector_v, "_v")?;
        for (name, size, found) in [("u", self.size_u, u.count()), ("v", self.size_v, v.count())] {
            if let Some(size) = size.filter(|size| size.0 != found) {
                let text = format!("\"size_{name}\" is {}, but the knots are for {found}", size.0);
                return Err(Problem::Syntax(text));
            }
        }
        self.value(vec![u, v])
    }

    /// The type of the shape and what is written of it.
    fn of(entry: &Entry) -> Read<(&'static str, Self)> {
        let Nurbs { along, dim, coords, weights } = Nurbs::of(&entry.value, FORMAT)?;
        let data = Self {
            kind: Some("spline".into()),
            name: entry.name.clone(),
            rational: Some(weights.is_some()),
            dimension: Some(Count(dim)),
            control_points: Some(Points {
                points: coords.chunks(dim).map(<[f64]>::to_vec).collect(),
                weights,
            }),
            ..Self::default()
        };
        let mut told = along
            .into_iter()
            .map(|along| (Some(Count(along.degree)), Some(Count(along.count())), Some(along.knots)));
        Ok(match (told.next(), told.next()) {
            (Some((degree_u, size_u, knotvector_u)), Some((degree_v, size_v, knotvector_v))) => {
                ("surface", Self { degree_u, degree_v, knotvector_u, knotvector_v, size_u, size_v, ..data })
            }
            (Some((degree, _, knotvector)), None) => ("curve", Self { degree, knotvector, ..data }),
            (None, _) => unreachable!("a spline has a parameter"),
        })
    }
}
