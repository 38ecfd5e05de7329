//! Warps and flat parts.

use crate::arguments::word;
use crate::called::Called;
use crate::error::{Failure, Result};
use crate::numbers::{Array, Num, Point};
use crate::record::record;
use crate::value::Thing;
use pyo3::prelude::*;
use symspline::{Bump, Direction, Side};
use symspline_dynamic::tools::flat::{self, AnyFlatten, AnyOnto, AnyPart};
use symspline_dynamic::tools::warp::{self, AnyRegion, Assignment, Refine};
use symspline_dynamic::{Coords, Field, Meeting as _, Number, Over, Value};

/// Knots to insert: an `int` says how many, any other number how long spans may be.
#[derive(Debug)]
pub struct Finer(pub Refine);

impl<'py> FromPyObject<'_, 'py> for Finer {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match object.extract::<usize>() {
            Ok(count) => Ok(Self(Refine::Count(count))),
            Err(_) => Ok(Self(Refine::Spacing(object.extract::<Num>()?.0))),
        }
    }
}

/// Whether it is no float.
pub fn is_exact(refine: &Option<Refine>) -> bool {
    !matches!(refine, Some(Refine::Spacing(Over::Float(_))))
}

#[derive(Debug, FromPyObject)]
enum FinerBoth {
    Both(Option<Finer>, Option<Finer>),
    One(Finer),
}

fn finer(refine: Option<FinerBoth>, both: bool) -> [Option<Refine>; 2] {
    match refine {
        None => [None, None],
        Some(FinerBoth::Both(u, v)) => [u.map(|r| r.0), v.map(|r| r.0)],
        Some(FinerBoth::One(one)) => {
            let second = both.then(|| one.0.clone());
            [Some(one.0), second]
        }
    }
}

record! {
    "symspline.shape"
    /// A shape that was changed in a region.
    Reshaped {
        /// The shape.
        shape: Thing,
        /// Knots that were inserted: the direction, the knot.
        inserted: Vec<(String, Num)>,
        /// How many control points were moved.
        moved: usize,
        /// Knots that were removed again.
        removed: Vec<(String, Num)>,
        /// How far that took the shape at most.
        bound: Num,
    }
}

/// The shape with control points of a region moved by a displacement.
///
/// `displacement(share, parameter)` is any callable: from the way through the region, from 0 to 1 (of surfaces a pair), and the
/// parameter that is assigned to a control point, to the vector it moves by, or `None`. With `vector` it gives a number that
/// multiplies this vector, as a `Bump` does. Its exceptions come out as they are. `refine` inserts knots first, so many if it is an
/// `int`, else until spans are no longer; `thinned` removes knots afterwards up to a distance. Parameters are assigned by `shares`,
/// "nodes", "chords" (over floats) or a list of shares (of surfaces two).
#[pyfunction]
#[pyo3(signature = (shape, start, end, displacement, *, vector=None, refine=None, thinned=None, shares=None))]
#[allow(clippy::too_many_arguments, reason = "Python names them")]
fn warped(
    shape: Thing,
    start: Point,
    end: Point,
    displacement: Bound<'_, PyAny>,
    vector: Option<Point>,
    refine: Option<FinerBoth>,
    thinned: Option<Num>,
    shares: Option<Bound<'_, PyAny>>,
) -> PyResult<Reshaped> {
    let refine = finer(refine, start.0.len() > 1);
    let mut exact = start.0.is_exact() && end.0.is_exact() && refine.iter().all(is_exact);
    exact &=
        vector.as_ref().is_none_or(|v| v.0.is_exact()) && thinned.as_ref().is_none_or(|x| x.0.is_exact());
    let assignment = match shares {
        None => Assignment::Nodes,
        Some(shares) => match shares.extract::<String>() {
            Ok(name) => word("shares", &name, &[("nodes", false), ("chords", true)])
                .map(|chords| if chords { Assignment::Chords } else { Assignment::Nodes })?,
            Err(_) if start.0.len() == 1 => Assignment::Given(vec![shares.extract::<Array>()?.numbers]),
            Err(_) => {
                let all: Vec<Array> = shares.extract()?;
                Assignment::Given(all.into_iter().map(|one| one.numbers).collect())
            }
        },
    };
    exact &= assignment != Assignment::Chords;
    let shape = shape.0.among(exact).map_err(Failure::from)?;
    let region = AnyRegion { from: start.0, to: end.0, refine, thinned: thinned.map(|x| x.0) };
    let called = Called::default();
    let moved = |share: &Coords, parameter: &Coords| {
        called.call(|_| {
            let found = displacement.call1((Point(share.clone()), Point(parameter.clone())))?;
            if found.is_none() {
                return Ok(None);
            }
            match &vector {
                None => Ok(Some(found.extract::<Point>()?.0)),
                Some(vector) => {
                    let factor = found.extract::<Num>()?.0;
                    let scaled = Value::from(vector.0.clone()).scaled(&factor).map_err(Failure::from)?;
                    match scaled {
                        Value::Point(by) => Ok(Some(by)),
                        _ => Ok(None),
                    }
                }
            }
        })
    };
    let found = warp::warped(&shape, &region, &assignment, &moved);
    let found = called.out(found.map_err(Failure::from))?;
    let named = |knots: Vec<(Direction, Number)>| {
        knots
            .into_iter()
            .map(|(d, x)| (String::from(if d == Direction::U { "u" } else { "v" }), Num(x)))
            .collect()
    };
    Ok(Reshaped {
        shape: found.shape.into(),
        inserted: named(found.inserted),
        moved: found.moved,
        removed: named(found.removed),
        bound: Num(found.bound),
    })
}

/// The bump of a weight at `t`: it rises smoothly from 0 at 0 to 1 at 1/2 and falls to 0 at 1; the greater the weight, the steeper.
/// With a pair for `t` it is the bump over the unit square.
#[pyfunction]
fn bump(weight: Num, t: Point) -> Result<Num> {
    fn of<T: Field>(weight: &Number, t: &Coords) -> Result<Num> {
        let bump = Bump::new(T::of(weight)?)?;
        match &T::all_of(t)?[..] {
            [t] => Ok(Num(bump.at(t).number())),
            [s, t] => Ok(Num(bump.at_pair(&(s.clone(), t.clone())).number())),
            _ => Err(Failure::new("Shape", "a bump is over one parameter or two")),
        }
    }
    match weight.0.is_exact() && t.0.is_exact() {
        true => of::<symspline::Q>(&weight.0, &t.0),
        false => of::<f64>(&weight.0, &t.0),
    }
}

/// A part of the parameters: `(start, end)` with numbers or pairs, `("polygon", corners)` or `("disc", centre, radius)`.
fn part(object: &Bound<'_, PyAny>, exact: &mut bool) -> PyResult<AnyPart> {
    if let Ok((word, corners)) = object.extract::<(String, Array)>() {
        *exact &= corners.numbers.is_exact();
        if word == "polygon" {
            return Ok(AnyPart::Polygon(corners.numbers));
        }
    } else if let Ok((word, centre, radius)) = object.extract::<(String, Point, Num)>() {
        *exact &= centre.0.is_exact() && radius.0.is_exact();
        if word == "disc" {
            return Ok(AnyPart::Disc(centre.0, radius.0));
        }
    } else if let Ok((from, to)) = object.extract::<(Point, Point)>() {
        *exact &= from.0.is_exact() && to.0.is_exact();
        return Ok(AnyPart::Between(from.0, to.0));
    }
    Err(Failure::new("Word", "a part is (start, end), (\"polygon\", corners) or (\"disc\", centre, radius)")
        .into())
}

record! {
    "symspline.shape"
    /// What flattening made.
    Flattened {
        /// The shape.
        shape: Thing,
        /// The control points that were projected, as places in the list.
        projected: Vec<usize>,
        /// The flat parts: of each from where to where along each direction.
        flat: Vec<Vec<(Num, Num)>>,
        /// Outside of this nothing changed; none if nothing changed at all.
        changed: Option<Vec<(Num, Num)>>,
    }
}

/// The shape with control points projected onto a line or plane, so that a part becomes straight or flat.
///
/// In the plane onto the line through `origin` in the direction `line`; in space onto the plane across `normal`, or the line `line`
/// (within planes across `normal`). Points go at a right angle, or `along` a vector. Those projected are all, those without
/// influence outside the part `local`, or those with influence in the part `whole`; on one `side` ("positive", "negative"), in
/// front of planes, whose projections lie within `segments`, `polygons` or `balls`. `refine` inserts knots first, `until_flat` more
/// and more up to so many control points.
#[pyfunction]
#[pyo3(signature = (shape, origin, *, line=None, normal=None, along=None, local=None, whole=None, side=None, in_front_of=Vec::new(),
    segments=Vec::new(), polygons=Vec::new(), balls=Vec::new(), refine=None, until_flat=None))]
#[allow(clippy::too_many_arguments, reason = "Python names them")]
fn flattened(
    py: Python<'_>,
    shape: Thing,
    origin: Point,
    line: Option<Point>,
    normal: Option<Point>,
    along: Option<Point>,
    local: Option<Bound<'_, PyAny>>,
    whole: Option<Bound<'_, PyAny>>,
    side: Option<&str>,
    in_front_of: Vec<(Point, Point)>,
    segments: Vec<(Point, Point)>,
    polygons: Vec<Array>,
    balls: Vec<(Point, Num)>,
    refine: Option<Finer>,
    until_flat: Option<usize>,
) -> PyResult<Flattened> {
    let mut exact = origin.0.is_exact();
    for vector in [&line, &normal, &along].into_iter().flatten() {
        exact &= vector.0.is_exact();
    }
    for (a, b) in in_front_of.iter().chain(&segments) {
        exact &= a.0.is_exact() && b.0.is_exact();
    }
    exact &= polygons.iter().all(|p| p.numbers.is_exact());
    exact &= balls.iter().all(|(c, r)| c.0.is_exact() && r.0.is_exact());
    let refine = refine.map(|r| r.0);
    exact &= is_exact(&refine);
    let [local, whole] = [local, whole].map(|p| p.map(|p| part(&p, &mut exact)).transpose());
    let sides = [("positive", Side::Positive), ("negative", Side::Negative)];
    let pairs = |all: Vec<(Point, Point)>| all.into_iter().map(|(a, b)| (a.0, b.0)).collect();
    let how = AnyFlatten {
        onto: AnyOnto {
            origin: origin.0,
            line: line.map(|v| v.0),
            normal: normal.map(|v| v.0),
            along: along.map(|v| v.0),
        },
        local: local?,
        whole: whole?,
        side: side.map(|name| word("side", name, &sides)).transpose()?,
        in_front_of: pairs(in_front_of),
        segments: pairs(segments),
        polygons: polygons.into_iter().map(|p| p.numbers).collect(),
        balls: balls.into_iter().map(|(c, r)| (c.0, r.0)).collect(),
        refine,
        until_flat,
    };
    let shape = shape.0.among(exact).map_err(Failure::from)?;
    let found = py.detach(|| flat::flattened(&shape, &how)).map_err(Failure::from)?;
    let ends = |part: Vec<(Number, Number)>| part.into_iter().map(|(a, b)| (Num(a), Num(b))).collect();
    Ok(Flattened {
        shape: found.shape.into(),
        projected: found.projected,
        flat: found.flat.into_iter().map(ends).collect(),
        changed: found.changed.map(ends),
    })
}

/// Adds the functions and classes to the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Reshaped>()?;
    module.add_class::<Flattened>()?;
    module.add_function(wrap_pyfunction!(warped, module)?)?;
    module.add_function(wrap_pyfunction!(bump, module)?)?;
    module.add_function(wrap_pyfunction!(flattened, module)?)
}
