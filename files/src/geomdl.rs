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
use crate::projected::Projected;
use crate::rounded::{Rounded, points_of, rounded};
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use symspline::SplineSpace;
use symspline_dynamic::{AnyRational, AnyRationalSurface, AnySpace, AnySpline, AnySurface, Coords, Value};

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
/// [`Problem::NoRoom`] for functions, numbers, points and meshes, for curves and surfaces in one file, and for rational ones with
/// points at infinity.
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

fn space(degree: &Option<Count>, knots: &Option<Vec<f64>>, suffix: &str) -> Read<SplineSpace<f64>> {
    let degree = needed(degree, &format!("degree{suffix}"))?;
    let knots = needed(knots, &format!("knotvector{suffix}"))?;
    Ok(SplineSpace::new(degree.0, knots.iter().copied())?)
}

impl Data {
    /// The dimension of the points, their coordinates, and the weights.
    fn control(&self) -> Read<(usize, Coords, Option<Coords>)> {
        if let Some(kind) = self.kind.as_ref().filter(|kind| *kind != "spline") {
            return Err(Problem::Syntax(format!("shapes of type \"{kind}\" are not read")));
        }
        let Points { points, weights } = needed(&self.control_points, "control_points")?;
        let (dim, coords) = points_of(points)?;
        if let Some(found) = self.dimension.filter(|found| found.0 != dim) {
            return Err(Problem::Syntax(format!("\"dimension\" is {}, but points have {dim}", found.0)));
        }
        let ones = || vec![1.0; points.len()];
        let weights = weights.clone().or_else(|| (self.rational == Some(true)).then(ones));
        Ok((dim, Coords::Float(coords), weights.map(Coords::Float)))
    }

    fn curve(&self) -> Read<Value> {
        let space = space(&self.degree, &self.knotvector, "")?.into();
        Ok(match self.control()? {
            (dim, points, Some(weights)) => AnyRational::new(space, dim, points, weights)?.into(),
            (dim, points, None) => AnySpline::new(space, dim, points)?.into(),
        })
    }

    fn surface(&self) -> Read<Value> {
        if self.trims.as_ref().is_some_and(|trims| !trims.data.is_empty()) {
            return Err(Problem::Syntax("trimmed surfaces are not read".into()));
        }
        let u = space(&self.degree_u, &self.knotvector_u, "_u")?;
        let v = space(&self.degree_v, &self.knotvector_v, "_v")?;
        for (name, size, found) in [("u", self.size_u, u.dim()), ("v", self.size_v, v.dim())] {
            if let Some(size) = size.filter(|size| size.0 != found) {
                let text = format!("\"size_{name}\" is {}, but the knots are for {found}", size.0);
                return Err(Problem::Syntax(text));
            }
        }
        let (u, v) = (AnySpace::from(u), AnySpace::from(v));
        Ok(match self.control()? {
            (dim, points, Some(weights)) => AnyRationalSurface::new(u, v, dim, points, weights)?.into(),
            (dim, points, None) => AnySurface::new(u, v, dim, points)?.into(),
        })
    }

    /// The type of the shape and what is written of it.
    fn of(entry: &Entry) -> Read<(&'static str, Self)> {
        let Rounded { spaces, dim, coords, is_rational } = rounded(&entry.value, FORMAT)?;
        if dim < 2 {
            return Err(Problem::NoRoom { format: FORMAT, value: entry.value.kind().into() });
        }
        let (points, weights) = match is_rational {
            false => (coords, None),
            true => {
                let at_infinity = || Problem::NoRoom {
                    format: FORMAT,
                    value: format!("{} with points at infinity", entry.value.kind()),
                };
                let (points, weights) = Projected::floats(&coords, dim).ok_or_else(at_infinity)?;
                (points, Some(weights))
            }
        };
        let points = points.chunks(dim).map(<[f64]>::to_vec).collect();
        let data = Self {
            kind: Some("spline".into()),
            name: entry.name.clone(),
            rational: Some(is_rational),
            dimension: Some(Count(dim)),
            control_points: Some(Points { points, weights }),
            ..Self::default()
        };
        let knots = |space: &SplineSpace<f64>| Some(space.knots().to_vec());
        let degree = |space: &SplineSpace<f64>| Some(Count(space.degree()));
        let size = |space: &SplineSpace<f64>| Some(Count(space.dim()));
        Ok(match &spaces[..] {
            [s] => ("curve", Self { degree: degree(s), knotvector: knots(s), ..data }),
            [u, v] => {
                let (degree_u, degree_v) = (degree(u), degree(v));
                let (knotvector_u, knotvector_v) = (knots(u), knots(v));
                let (size_u, size_v) = (size(u), size(v));
                ("surface", Self { degree_u, degree_v, knotvector_u, knotvector_v, size_u, size_v, ..data })
            }
            _ => unreachable!("a spline has one parameter or two"),
        })
    }
}
