//! Writing SVG.

use super::FORMAT;
use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use crate::outline::Point;
use std::collections::HashSet;
use std::fmt::Write as _;
use symspline::{Contact, Curve, NurbsCurve, SplineSpace};
use symspline_dynamic::{Any, Value};

/// How far what is approximated may be off, in the size of the curve: the longer side of the box of its control points.
pub const TOLERANCE: f64 = 1e-6;

/// The SVG text of curves in the plane.
///
/// # Errors
/// [`Problem::NoRoom`] for what is no curve in the plane, for curves with jumps or of degree 0, and for names with letters that XML has not; those of
/// [`polynomial_within`](symspline::Rational::polynomial_within) and
/// [`degree_reduced_within`](symspline::Spline::degree_reduced_within) for rational curves and those of degree 4 and more.
pub fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>> {
    let mut paths = String::new();
    let (mut ids, mut bounds) = (HashSet::new(), None);
    for (i, entry) in entries.iter().enumerate() {
        let at = |problem: Problem| problem.at(Place::Entry(format!("item {i}")));
        let curve = plane(&entry.value).and_then(|curve| pieces(&curve)).map_err(at)?;
        for point in curve.coeffs() {
            let (low, high) = bounds.get_or_insert((*point, *point));
            *low = low.inf(point);
            *high = high.sup(point);
        }
        paths.push_str("  <path");
        if let Some(name) = &entry.name {
            let is_id = !name.is_empty() && !name.contains(char::is_whitespace) && ids.insert(name);
            let key = if is_id { "id" } else { "data-name" };
            let _ = write!(paths, " {key}=\"{}\"", escaped(name).map_err(at)?);
        }
        let _ = writeln!(paths, " d=\"{}\"/>", data(&curve));
    }
    let (low, high) = bounds.unwrap_or_default();
    Ok(document(low, high, &paths).into_bytes())
}

fn document(low: Point, high: Point, paths: &str) -> String {
    let size = (high - low).max().clamp(f64::MIN_POSITIVE, 1e300);
    let margin = size / 20.0;
    let [x, y] = [low[0], low[1]].map(|x| x.max(-1e300) - margin);
    let [width, height] = [0, 1].map(|k| (high[k] - low[k]).min(1e300) + 2.0 * margin);
    let numbers = [x, y, width, height].map(number).join(" ");
    let stroke = number(size / 200.0);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{numbers}\" fill=\"none\" stroke=\"black\" \
         stroke-width=\"{stroke}\">\n{paths}</svg>\n"
    )
}

/// A plane curve over floats of degree 3 at most, clamped.
fn plane(value: &Value) -> std::result::Result<Curve<f64, 2>, Problem> {
    let no_room = || Problem::NoRoom {
        format: FORMAT,
        value: format!("{} in {} dimensions", value.kind(), value.dim()),
    };
    let (curve, tolerance) = match value {
        Value::Spline(any) => match any.to_float()? {
            Any::F2(curve) => {
                let tolerance = tolerance(curve.coeffs().iter().copied());
                (curve, tolerance)
            }
            _ => return Err(no_room()),
        },
        Value::Rational(any) => match any.to_float()? {
            Any::F2(curve) => {
                let tolerance = tolerance(curve.lifted().coeffs().iter().map(symspline::Weighted::project));
                (polynomial(&curve, tolerance / 2.0)?, tolerance / 2.0)
            }
            _ => return Err(no_room()),
        },
        _ => return Err(no_room()),
    };
    let curve = curve.clamped_ends()?;
    match curve.degree() {
        0 => Err(Problem::NoRoom { format: FORMAT, value: "curve of degree 0".into() }),
        1..=3 => Ok(curve),
        degree => Ok(curve.degree_reduced_within(degree - 3, &tolerance, Contact::both(1))?.spline),
    }
}

fn polynomial(curve: &NurbsCurve<f64, 2>, tolerance: f64) -> std::result::Result<Curve<f64, 2>, Problem> {
    Ok(curve.polynomial_within(&tolerance)?.spline)
}

/// How far a curve with these control points may be off. Points at infinity do not count.
fn tolerance(points: impl Iterator<Item = Point>) -> f64 {
    let finite = points.filter(|point| point.iter().all(|x| x.is_finite()));
    let ends = finite.map(|point| (point, point)).reduce(|(low, high), (p, q)| (low.inf(&p), high.sup(&q)));
    let size = ends.map_or(1.0, |(low, high)| (high - low).max());
    let size = if size > 0.0 { size.min(f64::MAX) } else { 1.0 };
    size * TOLERANCE
}

/// The same curve in Bezier pieces that share their ends.
fn pieces(curve: &Curve<f64, 2>) -> std::result::Result<Curve<f64, 2>, Problem> {
    let (space, degree) = (curve.space(), curve.degree());
    let breaks = space.breaks();
    let inner = &breaks[1..breaks.len() - 1];
    if inner.iter().any(|(_, copies)| *copies > degree) {
        return Err(Problem::NoRoom { format: FORMAT, value: "curve with jumps".into() });
    }
    let copies = inner.iter().flat_map(|(knot, _)| std::iter::repeat_n(*knot, degree));
    let (a, b) = space.domain();
    let target = SplineSpace::clamped(degree, std::iter::once(*a).chain(copies).chain([*b]))?;
    if target == *space { Ok(curve.clone()) } else { Ok(curve.embedded(&target)?) }
}

/// The data of a path.
fn data(curve: &Curve<f64, 2>) -> String {
    let pair = |p: &Point| format!("{} {}", number(p[0]), number(p[1]));
    let (coeffs, degree) = (curve.coeffs(), curve.degree());
    let letter = ["", "L", "Q", "C"][degree];
    let mut data = format!("M{}", pair(&coeffs[0]));
    for piece in coeffs[1..].chunks(degree) {
        let points: Vec<String> = piece.iter().map(pair).collect();
        data.extend([" ", letter, &points.join(" ")]);
    }
    if coeffs[0] == coeffs[coeffs.len() - 1] {
        data.push_str(" Z");
    }
    data
}

/// The shortest decimal that is read back bit by bit.
fn number(x: f64) -> String {
    let text = format!("{x:?}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

/// A name as the value of an attribute.
fn escaped(name: &str) -> std::result::Result<String, Problem> {
    let mut text = String::with_capacity(name.len());
    for letter in name.chars() {
        match letter {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '"' => text.push_str("&quot;"),
            '\t' | '\n' | '\r' => {
                let _ = write!(text, "&#{};", u32::from(letter));
            }
            '\0'..'\u{20}' | '\u{fffe}' | '\u{ffff}' => {
                return Err(Problem::NoRoom { format: FORMAT, value: format!("name {name:?}") });
            }
            _ => text.push(letter),
        }
    }
    Ok(text)
}
