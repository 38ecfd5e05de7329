//! The JSON form: every value without loss, exact numbers as text `"p/q"`.
//!
//! ```text
//! {"format": "symspline", "version": 1, "items": [
//!   {"name": "C", "value": {"spline": {"field": "exact", "space": {"degree": 1, "knots": ["0", "0", "1/3", "1/3"]},
//!                                      "points": [["0", "0"], ["1", "2"]]}}}]}
//! ```
//! The schema is `files/symspline.schema.json`. A field is `"exact"`, with numbers as text `p`, `p/q` or a decimal, or as whole
//! numbers; or `"float"`, with numbers. The knots of a periodic space run once round, the seam at the start only, and `end` is where
//! it comes again. Points of functions have one coordinate. Points of surfaces stand row by row, each row of one `u`.

use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use serde::de::{self, Deserializer, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::fmt;
use symspline::{ControlMesh, Q, Scalar, SplineSpace};
use symspline_dynamic::{
    AnyMesh, AnyRational, AnyRationalSurface, AnySpace, AnySpline, AnySurface, Coords, Field, Value, both,
};

/// The version that is written; older ones are read.
pub const VERSION: u32 = 1;

const FORMAT: &str = "symspline";

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    format: String,
    version: u32,
    items: Vec<Item>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Item {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    value: Form,
}

/// A value as it is written.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Form {
    Number(Text),
    Point { field: FieldName, coordinates: Vec<Text> },
    Spline { field: FieldName, space: Space, points: Vec<Vec<Text>> },
    Rational { field: FieldName, space: Space, points: Vec<Vec<Text>>, weights: Vec<Text> },
    Surface { field: FieldName, u: Space, v: Space, points: Vec<Vec<Text>> },
    RationalSurface { field: FieldName, u: Space, v: Space, points: Vec<Vec<Text>>, weights: Vec<Text> },
    Mesh { field: FieldName, points: Vec<Vec<Text>>, faces: Vec<Vec<usize>> },
}

#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum FieldName {
    Exact,
    Float,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Space {
    degree: usize,
    knots: Vec<Text>,
    /// Where the seam of a periodic space comes again; missing for an open one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    end: Option<Text>,
}

/// A number as it stands in a file.
#[derive(Clone)]
enum Text {
    Float(f64),
    Whole(i64),
    Exact(Q),
}

impl Serialize for Text {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        match self {
            Self::Float(x) if !x.is_finite() => {
                Err(serde::ser::Error::custom(format!("{x} is not a number")))
            }
            Self::Float(x) => serializer.serialize_f64(*x),
            Self::Whole(n) => serializer.serialize_i64(*n),
            Self::Exact(x) => serializer.collect_str(x),
        }
    }
}

impl<'de> Deserialize<'de> for Text {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        struct Numbers;

        impl Visitor<'_> for Numbers {
            type Value = Text;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or a text \"p/q\"")
            }

            fn visit_f64<E: de::Error>(self, x: f64) -> std::result::Result<Text, E> {
                if x.is_finite() {
                    Ok(Text::Float(x))
                } else {
                    Err(E::custom("a number is too large for a float"))
                }
            }

            fn visit_i64<E: de::Error>(self, n: i64) -> std::result::Result<Text, E> {
                Ok(Text::Whole(n))
            }

            fn visit_u64<E: de::Error>(self, n: u64) -> std::result::Result<Text, E> {
                Ok(i64::try_from(n).map_or(Text::Float(n as f64), Text::Whole))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> std::result::Result<Text, E> {
                text.parse().map(Text::Exact).map_err(E::custom)
            }
        }
        deserializer.deserialize_any(Numbers)
    }
}

/// A field as it is read and written.
trait Written: Field {
    fn read(text: &Text) -> std::result::Result<Self, Problem>;

    fn text(&self) -> Text;
}

impl Written for f64 {
    fn read(text: &Text) -> std::result::Result<Self, Problem> {
        match text {
            Text::Float(x) => Ok(*x),
            // A whole number of a float has at most 53 bits; others were written by somebody else and are rounded.
            Text::Whole(n) => Ok(*n as f64),
            Text::Exact(x) => {
                Err(Problem::Syntax(format!("\"{x}\" is a text: numbers of the field \"float\" are not")))
            }
        }
    }

    fn text(&self) -> Text {
        Text::Float(*self)
    }
}

impl Written for Q {
    fn read(text: &Text) -> std::result::Result<Self, Problem> {
        match text {
            Text::Exact(x) => Ok(x.clone()),
            Text::Whole(n) => Ok(Q::int(*n)),
            Text::Float(x) => Err(Problem::Syntax(format!("{x} is not exact: write a text \"p/q\""))),
        }
    }

    fn text(&self) -> Text {
        Text::Exact(self.clone())
    }
}

type Read<T> = std::result::Result<T, Problem>;

fn read_all<T: Written>(texts: &[Text]) -> Read<Vec<T>> {
    texts.iter().map(T::read).collect()
}

fn read_space<T: Written>(space: &Space) -> Read<SplineSpace<T>> {
    let knots = read_all::<T>(&space.knots)?;
    Ok(match &space.end {
        Some(end) => SplineSpace::periodic_up_to(space.degree, knots, T::read(end)?)?,
        None => SplineSpace::new(space.degree, knots)?,
    })
}

/// The dimension of points, and their coordinates one after the other.
fn read_points<T: Written>(points: &[Vec<Text>]) -> Read<(usize, Coords)> {
    let dim = points.first().map_or(1, Vec::len);
    if let Some(index) = points.iter().position(|point| point.len() != dim) {
        return Err(symspline::Error::Ragged { index }.into());
    }
    let coords = points.iter().flatten().map(T::read).collect::<Read<_>>()?;
    Ok((dim, T::coords(coords)))
}

impl Form {
    fn field(&self) -> FieldName {
        match self {
            Self::Number(Text::Exact(_)) => FieldName::Exact,
            Self::Number(_) => FieldName::Float,
            Self::Point { field, .. }
            | Self::Spline { field, .. }
            | Self::Rational { field, .. }
            | Self::Surface { field, .. }
            | Self::RationalSurface { field, .. }
            | Self::Mesh { field, .. } => *field,
        }
    }

    fn value(&self) -> Read<Value> {
        match self.field() {
            FieldName::Exact => self.read::<Q>(),
            FieldName::Float => self.read::<f64>(),
        }
    }

    fn read<T: Written>(&self) -> Read<Value>
    where
        AnySpace: From<SplineSpace<T>>,
        AnyMesh: From<ControlMesh<T, 3>>,
    {
        let space = |space: &Space| read_space::<T>(space).map(AnySpace::from);
        Ok(match self {
            Self::Number(text) => T::read(text)?.number().into(),
            Self::Point { coordinates, .. } => T::coords(read_all(coordinates)?).into(),
            Self::Spline { space: s, points, .. } => {
                let (dim, coords) = read_points::<T>(points)?;
                AnySpline::new(space(s)?, dim, coords)?.into()
            }
            Self::Rational { space: s, points, weights, .. } => {
                let (dim, coords) = read_points::<T>(points)?;
                AnyRational::new(space(s)?, dim, coords, T::coords(read_all(weights)?))?.into()
            }
            Self::Surface { u, v, points, .. } => {
                let (dim, coords) = read_points::<T>(points)?;
                AnySurface::new(space(u)?, space(v)?, dim, coords)?.into()
            }
            Self::RationalSurface { u, v, points, weights, .. } => {
                let (dim, coords) = read_points::<T>(points)?;
                let weights = T::coords(read_all(weights)?);
                AnyRationalSurface::new(space(u)?, space(v)?, dim, coords, weights)?.into()
            }
            Self::Mesh { points, faces, .. } => {
                let points = points.iter().map(|point| {
                    Ok(symspline_dynamic::operators::coefficient::<T, _>(&T::coords(read_all(point)?))?)
                });
                AnyMesh::from(ControlMesh::new(points.collect::<Read<_>>()?, faces)?).into()
            }
        })
    }

    fn of(value: &Value) -> Read<Self> {
        let field = if value.is_exact() { FieldName::Exact } else { FieldName::Float };
        Ok(match value {
            Value::Number(x) => Self::Number(both!(x, x => x.text())),
            Value::Point(p) => Self::Point { field, coordinates: texts(p) },
            Value::Spline(s) => {
                Self::Spline { field, space: form(&s.space()), points: rows(&s.coords()?, s.dim()) }
            }
            Value::Rational(s) => Self::Rational {
                field,
                space: form(&s.space()),
                points: rows(&s.coords()?, s.dim()),
                weights: s.weights().iter().flat_map(texts).collect(),
            },
            Value::Surface(s) => {
                let spaces = s.spaces();
                let points = rows(&s.coords()?, s.dim());
                Self::Surface { field, u: form(&spaces[0]), v: form(&spaces[1]), points }
            }
            Value::RationalSurface(s) => {
                let spaces = s.spaces();
                let points = rows(&s.coords()?, s.dim());
                let weights = s.weights().iter().flat_map(texts).collect();
                Self::RationalSurface { field, u: form(&spaces[0]), v: form(&spaces[1]), points, weights }
            }
            Value::Mesh(mesh) => both!(mesh, mesh => Self::Mesh {
                field,
                points: mesh.points().iter().map(|p| p.iter().map(Written::text).collect()).collect(),
                faces: mesh.topology().faces().collect(),
            }),
            other => return Err(Problem::NoRoom { format: "JSON", value: other.to_string() }),
        })
    }
}

fn texts(coords: &Coords) -> Vec<Text> {
    both!(coords, all => all.iter().map(Written::text).collect())
}

fn rows(coords: &Coords, dim: usize) -> Vec<Vec<Text>> {
    texts(coords).chunks(dim).map(<[Text]>::to_vec).collect()
}

fn form(space: &AnySpace) -> Space {
    both!(space, space => Space {
        degree: space.degree(),
        knots: space.knots_round().unwrap_or(space.knots().as_slice()).iter().map(Written::text).collect(),
        end: space.is_periodic().then(|| space.domain().1.text()),
    })
}

/// What a JSON text holds.
///
/// # Errors
/// [`Problem::Syntax`] with line and column; [`Problem::Value`] with the number of the item, from 0.
pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>> {
    let document: Document = serde_json::from_slice(bytes).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        let text = error.to_string();
        let text = text.rsplit_once(" at line ").map_or(text.as_str(), |(text, _)| text).to_owned();
        Problem::Syntax(text).at(Place::Line { line, column })
    })?;
    if document.format != FORMAT {
        let found = format!("\"format\" is \"{}\", not \"{FORMAT}\"", document.format);
        return Err(Problem::Syntax(found).of_file());
    }
    if document.version == 0 || document.version > VERSION {
        let found = format!("version {} is not known; up to {VERSION} are", document.version);
        return Err(Problem::Syntax(found).of_file());
    }
    let entry = |(i, item): (usize, Item)| match item.value.value() {
        Ok(value) => Ok(Entry { name: item.name, value }),
        Err(problem) => {
            let name = item.name.map(|name| format!(" ({name})")).unwrap_or_default();
            Err(problem.at(Place::Entry(format!("item {i}{name}"))))
        }
    };
    document.items.into_iter().enumerate().map(entry).collect()
}

/// The JSON text of values.
///
/// # Errors
/// [`Problem::Value`]: a rational spline may have a weight of zero, which has no point.
pub fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>> {
    let item = |(i, entry): (usize, &Entry)| {
        let value =
            Form::of(&entry.value).map_err(|problem| problem.at(Place::Entry(format!("item {i}"))))?;
        Ok(Item { name: entry.name.clone(), value })
    };
    let items = entries.iter().enumerate().map(item).collect::<Result<_>>()?;
    let document = Document { format: FORMAT.to_owned(), version: VERSION, items };
    let mut bytes =
        serde_json::to_vec(&document).map_err(|error| Problem::Syntax(error.to_string()).of_file())?;
    bytes.push(b'\n');
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use symspline_dynamic::{Number, Over};

    #[test]
    fn a_periodic_curve_comes_back() {
        let space = SplineSpace::periodic(2, [0.1, 0.7, 1.3], 2.4).unwrap();
        let curve =
            AnySpline::new(space.into(), 2, Over::Float(vec![0.1, 0.2, 1e-300, -0.0, 5e100, 3.0])).unwrap();
        let entries = [Entry::named("ring", curve), Number::Exact(Q::frac(1, 3)).into()];
        assert_eq!(from_bytes(&to_bytes(&entries).unwrap()).unwrap(), entries);
    }
}
