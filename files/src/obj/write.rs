//! Writing OBJ.

use super::FORMAT;
use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use crate::nurbs::{Along, Nurbs, by_columns};
use symspline_dynamic::{Over, Value};

/// The OBJ text of curves in the plane and in space, of surfaces in space, and of one mesh.
///
/// # Errors
/// [`Problem::NoRoom`] for what it cannot hold: numbers, points, functions, degree 0, surfaces in the plane, a second mesh, weights that are not
/// positive, and names with `#`, with line breaks, or that are not words with single blanks between them.
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
        let told = Nurbs::of(&entry.value, FORMAT)?;
        let is_plane = match (&told.along[..], told.dim) {
            ([_], dim) => dim == 2,
            (_, 3) => false,
            (_, dim) => return Err(no_room(format!("{} in {dim} dimensions", entry.value.kind()))),
        };
        for (i, point) in told.points().enumerate() {
            let weight = told.weights.iter().map(|weights| &weights[i]);
            self.line(if is_plane { "vp" } else { "v" }, point.iter().chain(weight).map(number));
        }
        let count = told.points().len();
        let before = if is_plane { &mut self.plane_points } else { &mut self.vertices };
        let first = *before + 1;
        *before += count;
        self.line("cstype", [if told.weights.is_some() { "rat bspline" } else { "bspline" }.to_owned()]);
        self.line("deg", told.along.iter().map(|along| along.degree.to_string()));
        let ranges = told.along.iter().flat_map(Along::domain).map(|t| number(&t));
        let rows = told.along[0].count();
        let indices = by_columns(rows, count / rows).map(|i| (first + i).to_string());
        match told.along.len() {
            1 if is_plane => self.line("curv2", indices),
            1 => self.line("curv", ranges.chain(indices)),
            _ => self.line("surf", ranges.chain(indices)),
        }
        for (along, letter) in told.along.iter().zip(["u", "v"]) {
            self.line("parm", std::iter::once(letter.to_owned()).chain(along.knots.iter().map(number)));
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
