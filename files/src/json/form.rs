//! Values as they are written in JSON.

use crate::error::Problem;
use crate::json::number::{Count, Text, Written};
use crate::projected::Projected;
use serde::{Deserialize, Deserializer, Serialize};
use symspline::{ControlMesh, Q, SplineSpace};
use symspline_dynamic::{
    AnyMesh, AnyRational, AnyRationalSurface, AnySpace, AnySpline, AnySurface, Coords, Value, both,
};

pub(super) const FORMAT: &str = "symspline";

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Document {
    pub format: String,
    pub version: Count,
    pub items: Vec<Item>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Item {
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    pub value: Form,
}

/// A value as it is written.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum Form {
    Number(Text),
    Point {
        field: FieldName,
        coordinates: Vec<Text>,
    },
    Spline {
        field: FieldName,
        space: Space,
        points: Vec<Vec<Text>>,
    },
    Rational {
        field: FieldName,
        space: Space,
        #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
        points: Option<Vec<Vec<Text>>>,
        #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
        weights: Option<Vec<Text>>,
        #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
        weighted: Option<Vec<Vec<Text>>>,
    },
    Surface {
        field: FieldName,
        u: Space,
        v: Space,
        points: Vec<Vec<Text>>,
    },
    RationalSurface {
        field: FieldName,
        u: Space,
        v: Space,
        #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
        points: Option<Vec<Vec<Text>>>,
        #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
        weights: Option<Vec<Text>>,
        #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
        weighted: Option<Vec<Vec<Text>>>,
    },
    Mesh {
        field: FieldName,
        points: Vec<Vec<Text>>,
        faces: Vec<Vec<Count>>,
    },
}

#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum FieldName {
    Exact,
    Float,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Space {
    degree: Count,
    knots: Vec<Text>,
    /// Where the seam of a periodic space comes again; missing for an open one.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    end: Option<Text>,
}

/// A part that may be missing, but not null.
fn present<'de, T: Deserialize<'de>, D: Deserializer<'de>>(deserializer: D) -> Result<Option<T>, D::Error> {
    T::deserialize(deserializer).map(Some)
}

type Read<T> = Result<T, Problem>;

fn read_all<T: Written>(texts: &[Text]) -> Read<Vec<T>> {
    texts.iter().map(T::read).collect()
}

fn read_space<T: Written>(space: &Space) -> Read<SplineSpace<T>> {
    let knots = read_all::<T>(&space.knots)?;
    Ok(match &space.end {
        Some(end) => SplineSpace::periodic_up_to(space.degree.0, knots, T::read(end)?)?,
        None => SplineSpace::new(space.degree.0, knots)?,
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

/// Control points of rational splines as they are written.
enum Control {
    /// Points, and weights.
    Apart(Coords, Coords),
    /// Homogeneous coordinates.
    Weighted(Coords),
}

/// The dimension of the points, and what is written of them: points and weights, or homogeneous coordinates.
fn read_control<T: Written>(
    points: Option<&Vec<Vec<Text>>>,
    weights: Option<&Vec<Text>>,
    weighted: Option<&Vec<Vec<Text>>>,
) -> Read<(usize, Control)> {
    match (points, weights, weighted) {
        (Some(points), Some(weights), None) => {
            let (dim, coords) = read_points::<T>(points)?;
            Ok((dim, Control::Apart(coords, T::coords(read_all(weights)?))))
        }
        (None, None, Some(rows)) => {
            let (size, coords) = read_points::<T>(rows)?;
            Ok((size.saturating_sub(1), Control::Weighted(coords)))
        }
        _ => {
            let either = "either \"points\" and \"weights\" or \"weighted\" make a rational spline";
            Err(Problem::Syntax(either.into()))
        }
    }
}

/// Points and weights, if these come back bit by bit; else homogeneous coordinates.
#[expect(clippy::type_complexity, reason = "these are three parts of a form")]
fn control(
    weighted: &Coords,
    dim: usize,
) -> (Option<Vec<Vec<Text>>>, Option<Vec<Text>>, Option<Vec<Vec<Text>>>) {
    match Projected::of(weighted, dim).filter(|found| found.is_exact) {
        Some(found) => (Some(rows(&found.points, dim)), Some(texts(&found.weights)), None),
        None => (None, None, Some(rows(weighted, dim + 1))),
    }
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

    /// The value that is written.
    pub(super) fn value(&self) -> Read<Value> {
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
            Self::Rational { space: s, points, weights, weighted, .. } => {
                match read_control::<T>(points.as_ref(), weights.as_ref(), weighted.as_ref())? {
                    (dim, Control::Apart(points, weights)) => {
                        AnyRational::new(space(s)?, dim, points, weights)?
                    }
                    (dim, Control::Weighted(coords)) => {
                        AnyRational::from_homogeneous(space(s)?, dim, coords)?
                    }
                }
                .into()
            }
            Self::Surface { u, v, points, .. } => {
                let (dim, coords) = read_points::<T>(points)?;
                AnySurface::new(space(u)?, space(v)?, dim, coords)?.into()
            }
            Self::RationalSurface { u, v, points, weights, weighted, .. } => {
                let (u, v) = (space(u)?, space(v)?);
                match read_control::<T>(points.as_ref(), weights.as_ref(), weighted.as_ref())? {
                    (dim, Control::Apart(points, weights)) => {
                        AnyRationalSurface::new(u, v, dim, points, weights)?
                    }
                    (dim, Control::Weighted(coords)) => {
                        AnyRationalSurface::from_homogeneous(u, v, dim, coords)?
                    }
                }
                .into()
            }
            Self::Mesh { points, faces, .. } => {
                let points = points.iter().map(|point| {
                    Ok(symspline_dynamic::operators::coefficient::<T, _>(&T::coords(read_all(point)?))?)
                });
                let faces = faces.iter().map(|face| face.iter().map(|corner| corner.0).collect::<Vec<_>>());
                AnyMesh::from(ControlMesh::new(points.collect::<Read<_>>()?, faces)?).into()
            }
        })
    }

    /// A value as it is written.
    pub(super) fn of(value: &Value) -> Read<Self> {
        let field = if value.is_exact() { FieldName::Exact } else { FieldName::Float };
        Ok(match value {
            Value::Number(x) => Self::Number(both!(x, x => x.text())),
            Value::Point(p) => Self::Point { field, coordinates: texts(p) },
            Value::Spline(s) => {
                Self::Spline { field, space: form(&s.space()), points: rows(&s.coords()?, s.dim()) }
            }
            Value::Rational(s) => {
                let (points, weights, weighted) = control(&s.homogeneous(), s.dim());
                Self::Rational { field, space: form(&s.space()), points, weights, weighted }
            }
            Value::Surface(s) => {
                let spaces = s.spaces();
                let points = rows(&s.coords()?, s.dim());
                Self::Surface { field, u: form(&spaces[0]), v: form(&spaces[1]), points }
            }
            Value::RationalSurface(s) => {
                let (spaces, (points, weights, weighted)) = (s.spaces(), control(&s.homogeneous(), s.dim()));
                let [u, v] = [&spaces[0], &spaces[1]].map(form);
                Self::RationalSurface { field, u, v, points, weights, weighted }
            }
            Value::Mesh(mesh) => both!(mesh, mesh => Self::Mesh {
                field,
                points: mesh.points().iter().map(|p| p.iter().map(Written::text).collect()).collect(),
                faces: mesh.topology().faces().map(|face| face.into_iter().map(Count).collect()).collect(),
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
        degree: Count(space.degree()),
        knots: space.knots_round().unwrap_or(space.knots().as_slice()).iter().map(Written::text).collect(),
        end: space.is_periodic().then(|| space.domain().1.text()),
    })
}
