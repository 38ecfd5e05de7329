//! Writing OBJ.

use super::FORMAT;
use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use crate::projected::Projected;
use crate::rounded::{Rounded, rounded};
use symspline::SplineSpace;
use symspline_dynamic::{Over, Value};

/// The OBJ text of curves in the plane and in space, of surfaces in space, and of one mesh.
///
/// # Errors
/// [`Problem::NoRoom`] for what it cannot hold: numbers, points, functions, surfaces in the plane, a second mesh, rational splines with points at
/// infinity, and names with `#`, with line breaks, or that are not words with single blanks between them.
pub fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>> {
    let mut text = Text::default();
    for (i, entry) in entries.iter().enumerate() {
        text.put(entry).map_err(|problem| problem.at(Place::Entry(format!("item {i}"))))?;
    }
    Ok(text.text.into_bytes())
}

/// What was written so far.
#[derive(Default)]
struct Text {
    text: String,
    vertices: usize,
    plane_points: usize,
    has_mesh: bool,
    is_named: bool,
}

fn no_room(value: impl Into<String>) -> Problem {
    Problem::NoRoom { format: FORMAT, value: value.into() }
}

impl Text {
    fn line(&mut self, keyword: &str, words: impl IntoIterator<Item = String>) {
        self.text.push_str(keyword);
        words.into_iter().for_each(|word| self.text.extend([" ", &word]));
        self.text.push('\n');
    }

    fn put(&mut self, entry: &Entry) -> std::result::Result<(), Problem> {
        self.name(entry.name.as_deref())?;
        if let Value::Mesh(mesh) = &entry.value {
            return self.mesh(mesh);
        }
        let Rounded { spaces, dim, coords, is_rational } = rounded(&entry.value, FORMAT)?;
        let is_plane = match (&spaces[..], dim) {
            ([_], 2) => true,
            ([_], 3) | ([_, _], 3) => false,
            _ => return Err(no_room(format!("{} in {dim} dimensions", entry.value.kind()))),
        };
        let (points, weights) = match is_rational {
            true => Projected::floats(&coords, dim)
                .ok_or_else(|| no_room(format!("{} with points at infinity", entry.value.kind())))?,
            false => (coords, Vec::new()),
        };
        for (i, point) in points.chunks(dim).enumerate() {
            let numbers = point.iter().chain(weights.get(i)).map(number);
            self.line(if is_plane { "vp" } else { "v" }, numbers);
        }
        let count = points.len() / dim;
        let before = if is_plane { &mut self.plane_points } else { &mut self.vertices };
        let first = *before + 1;
        *before += count;
        self.line("cstype", [if is_rational { "rat bspline" } else { "bspline" }.to_owned()]);
        self.line("deg", spaces.iter().map(|s| s.degree().to_string()));
        let ends = |s: &SplineSpace<f64>| [s.domain().0, s.domain().1].map(number);
        let ranges: Vec<String> = spaces.iter().flat_map(ends).collect();
        match &spaces[..] {
            [_] if is_plane => self.line("curv2", (first..first + count).map(|i| i.to_string())),
            [_] => self.line("curv", ranges.into_iter().chain((first..first + count).map(|i| i.to_string()))),
            [u, v] => {
                // In the file the index of u runs first, here that of v.
                let columns = v.dim();
                let order = (0..columns).flat_map(|j| (0..u.dim()).map(move |i| first + i * columns + j));
                self.line("surf", ranges.into_iter().chain(order.map(|i| i.to_string())));
            }
            _ => unreachable!("a spline has one parameter or two"),
        }
        for (space, letter) in spaces.iter().zip(["u", "v"]) {
            let knots = space.knots().iter().map(number);
            self.line("parm", std::iter::once(letter.to_owned()).chain(knots));
        }
        self.line("end", []);
        Ok(())
    }

    fn name(&mut self, name: Option<&str>) -> std::result::Result<(), Problem> {
        match name {
            None if self.is_named => self.line("o", []),
            None => {}
            Some(name) => {
                let words: Vec<&str> = name.split_whitespace().collect();
                let holds = |bad: char| name.contains(bad);
                if name.is_empty() || words.join(" ") != name || holds('#') || name.ends_with('\\') {
                    return Err(no_room(format!("name {name:?}")));
                }
                self.line("o", [name.to_owned()]);
            }
        }
        self.is_named = name.is_some();
        Ok(())
    }

    fn mesh(&mut self, mesh: &symspline_dynamic::AnyMesh) -> std::result::Result<(), Problem> {
        if std::mem::replace(&mut self.has_mesh, true) {
            return Err(no_room("second mesh"));
        }
        let Over::Float(mesh) = mesh.to_float()? else { unreachable!("it was rounded to floats") };
        mesh.points().iter().for_each(|point| self.line("v", point.iter().map(number)));
        for face in mesh.topology().faces() {
            let first = self.vertices + 1;
            self.line("f", face.into_iter().map(|corner| (corner + first).to_string()));
        }
        self.vertices += mesh.points().len();
        Ok(())
    }
}

/// The shortest number that is read back bit by bit; with an exponent where `{}` would write hundreds of zeros.
fn number(x: &f64) -> String {
    format!("{x:?}")
}
