//! The JSON form: every value without loss, exact numbers as text `"p/q"`.
//!
//! ```text
//! {"format": "symspline", "version": 1, "items": [
//!   {"name": "C", "value": {"spline": {"field": "exact", "space": {"degree": 1, "knots": ["0", "0", "1/3", "1/3"]},
//!                                      "points": [["0", "0"], ["1", "2"]]}}}]}
//! ```
//! An item is a value, by its kind, and its name, if it has one:
//!
//! ```text
//! {"number": 0.5}                                                  or a fraction: {"number": "1/3"}
//! {"point": {"field": F, "coordinates": [x, ...]}}
//! {"spline": {"field": F, "space": S, "points": [P, ...]}}         the coefficients, one of each dimension of the space
//! {"rational": {"field": F, "space": S, "points": [P, ...], "weights": [w, ...]}}
//! {"surface": {"field": F, "u": S, "v": S, "points": [P, ...]}}    and "rational_surface", with weights
//! {"mesh": {"field": F, "points": [P, ...], "faces": [[i, j, k, ...], ...]}}      corners counted from 0
//! ```
//! Here `F` is `"exact"` or `"float"`, `P` is `[x]`, `[x, y]` or `[x, y, z]`, and `S` is `{"degree": p, "knots": [t, ...]}` with all
//! knots, or for a periodic space `{"degree": p, "knots": [t, ...], "end": t}`. Instead of points and weights a rational spline may have
//! `"weighted": [[w x, w y, w], ...]`: so it is written if a weight is zero or negative, or if no points give these products to the last bit.
//! What is not told here is refused.
//!
//! The schema is `files/symspline.schema.json`. A field is `"exact"`, with numbers as text `p`, `p/q` or a decimal, or as whole
//! numbers; or `"float"`, with numbers. The knots of a periodic space run once round, the seam at the start only, and `end` is where
//! it comes again. Points of functions have one coordinate. Points of surfaces stand row by row, each row of one `u`.

mod number;
mod form;

pub(crate) use number::Count;

use crate::entry::Entry;
use crate::error::{FileError, Place, Problem, Result};
use form::{Document, FORMAT, Form, Item};

/// The version that is written; older ones are read.
pub const VERSION: usize = 1;

/// What a JSON text holds.
///
/// # Errors
/// [`Problem::Syntax`] with line and column; [`Problem::Value`] with the number of the item, from 0.
pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>> {
    let document: Document = serde_json::from_slice(bytes).map_err(syntax)?;
    if document.format != FORMAT {
        let found = format!("\"format\" is \"{}\", not \"{FORMAT}\"", document.format);
        return Err(Problem::Syntax(found).of_file());
    }
    let version = document.version.0;
    if version == 0 || version > VERSION {
        let found = format!("version {version} is not known; up to {VERSION} are");
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

/// What is wrong with a JSON text, and where.
#[expect(clippy::needless_pass_by_value, reason = "it is made for map_err")]
pub(crate) fn syntax(error: serde_json::Error) -> FileError {
    let (line, column) = (error.line(), error.column());
    let text = error.to_string();
    let text = text.rsplit_once(" at line ").map_or(text.as_str(), |(text, _)| text).to_owned();
    Problem::Syntax(text).at(Place::Line { line, column })
}

/// The JSON text of values.
///
/// # Errors
/// [`Problem::Syntax`] for a number that is not finite.
pub fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>> {
    let item = |(i, entry): (usize, &Entry)| {
        let value =
            Form::of(&entry.value).map_err(|problem| problem.at(Place::Entry(format!("item {i}"))))?;
        Ok(Item { name: entry.name.clone(), value })
    };
    let items = entries.iter().enumerate().map(item).collect::<Result<_>>()?;
    let document = Document { format: FORMAT.to_owned(), version: Count(VERSION), items };
    let mut bytes =
        serde_json::to_vec(&document).map_err(|error| Problem::Syntax(error.to_string()).of_file())?;
    bytes.push(b'\n');
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use symspline::{Q, Scalar, SplineSpace};
    use symspline_dynamic::{AnySpline, Number, Over};

    #[test]
    fn a_periodic_curve_comes_back() {
        let space = SplineSpace::periodic(2, [0.1, 0.7, 1.3], 2.4).unwrap();
        let curve =
            AnySpline::new(space.into(), 2, Over::Float(vec![0.1, 0.2, 1e-300, -0.0, 5e100, 3.0])).unwrap();
        let entries = [Entry::named("ring", curve), Number::Exact(Q::frac(1, 3)).into()];
        assert_eq!(from_bytes(&to_bytes(&entries).unwrap()).unwrap(), entries);
    }
}
