//! Reading OBJ.

use super::draft::{Draft, Element};
use super::knots::Kind;
use super::lines::{Statement, start, statements};
use crate::entry::Entry;
use crate::error::{Problem, Result};
use std::fmt::Write as _;
use symspline::io::obj;
use symspline_dynamic::AnyMesh;

/// What is passed over, as it changes no curve, surface or face.
const PASSED: [&str; 18] = [
    "vt",
    "vn",
    "s",
    "mg",
    "l",
    "p",
    "mtllib",
    "usemtl",
    "maplib",
    "usemap",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
];

/// The free-form curves and surfaces of an OBJ file and the mesh of its faces, in their order.
///
/// # Errors
/// [`Problem::Syntax`] and [`Problem::Value`] with the line; for the mesh what [`symspline::io::obj::read`] refuses.
pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>> {
    // What is no text is in comments and names, or is refused as a word.
    let text = String::from_utf8_lossy(bytes);
    let mut reading = Reading::default();
    for statement in statements(&text) {
        reading.take(statement?)?;
    }
    if let Some(draft) = &reading.open {
        return draft.start.refused("'end' is missing");
    }
    let (mut entries, first) = (std::mem::take(&mut reading.entries), reading.first_face.take());
    if let Some((place, name)) = first {
        // Files with faces alone are read as they are.
        let mesh = match entries.is_empty() && reading.kind.is_none() {
            true => obj::read(bytes),
            false => obj::read(reading.faces(&text)?.as_bytes()),
        };
        let mesh = mesh.map_err(|error| Problem::from(error).of_file())?;
        entries.insert(place, Entry { name, value: AnyMesh::from(mesh).into() });
    }
    Ok(entries)
}

/// What was read so far.
#[derive(Default)]
struct Reading<'a> {
    entries: Vec<Entry>,
    /// Vertices: coordinates and weight, and the statement.
    points: Vec<([f64; 3], f64)>,
    vertices: Vec<Statement<'a>>,
    plane: Vec<([f64; 3], f64)>,
    /// The corners of each face as indices from 0, and the statement.
    corners: Vec<(Vec<usize>, Statement<'a>)>,
    /// Where the mesh belongs among the entries, and its name.
    first_face: Option<(usize, Option<String>)>,
    kind: Option<(Kind, bool)>,
    degrees: Vec<usize>,
    open: Option<Draft<'a>>,
    object: Option<String>,
    group: Option<String>,
}

impl<'a> Reading<'a> {
    fn take(&mut self, statement: Statement<'a>) -> Result<()> {
        match statement.keyword() {
            "v" => {
                let point = vertex(&statement)?;
                self.points.push(point);
                self.vertices.push(statement);
            }
            "vp" => {
                let point = match statement.floats(0)?[..] {
                    [u] => ([u, 0.0, 0.0], 1.0),
                    [u, v] => ([u, v, 0.0], 1.0),
                    [u, v, w] => ([u, v, 0.0], w),
                    _ => return statement.refused("a point of the plane has one to three numbers"),
                };
                self.plane.push(point);
            }
            "f" => self.face(statement)?,
            "o" => self.object = name(&statement),
            "g" => self.group = name(&statement),
            "cstype" => self.kind = Some(kind(&statement)?),
            "deg" => {
                let degrees = statement.arguments().iter().map(|word| statement.number(word));
                self.degrees = degrees.collect::<Result<_>>()?;
                if !matches!(self.degrees[..], [_] | [_, _]) {
                    return statement.refused("one degree or two are expected");
                }
            }
            "curv" => self.begin(Element::Curve, 2, statement)?,
            "curv2" => self.begin(Element::PlaneCurve, 0, statement)?,
            "surf" => self.begin(Element::Surface, 4, statement)?,
            "parm" => self.knots(&statement)?,
            "end" => match self.open.take() {
                None => return statement.refused("nothing is open that could end here"),
                Some(draft) => {
                    let name = self.object.clone().or_else(|| self.group.clone());
                    self.entries.push(Entry { name, value: draft.finished()? });
                }
            },
            word if PASSED.contains(&word) => {}
            word => return statement.refused(format!("'{}' is not read", start(word))),
        }
        Ok(())
    }

    fn begin(&mut self, element: Element, range: usize, statement: Statement<'a>) -> Result<()> {
        if let Some(draft) = &self.open {
            return statement.refused(format!("the element of line {} has no 'end'", draft.start.line));
        }
        let Some((kind, is_rational)) = self.kind else {
            return statement.refused("'cstype' is missing");
        };
        if statement.arguments().len() < range {
            return statement.refused(format!("the {range} ends of the range are missing"));
        }
        let points = if element == Element::PlaneCurve { &self.plane } else { &self.points };
        let point = |word: &&str| Ok(points[index(&statement, word, points.len())?]);
        let points = statement.arguments()[range..].iter().map(point).collect::<Result<_>>()?;
        let ends = statement.arguments()[..range].iter().map(|word| statement.float(word));
        let (range, degrees) = (ends.collect::<Result<_>>()?, self.degrees.clone());
        let knots = [None, None];
        self.open =
            Some(Draft { element, kind, is_rational, degrees, start: statement, range, points, knots });
        Ok(())
    }

    fn knots(&mut self, statement: &Statement<'a>) -> Result<()> {
        let Some(draft) = &mut self.open else {
            return statement.refused("'parm' stands outside of a curve or surface");
        };
        let parameter = match statement.arguments().first() {
            Some(&"u") => 0,
            Some(&"v") if draft.element == Element::Surface => 1,
            _ => return statement.refused("'parm' needs 'u', or for surfaces 'v'"),
        };
        match draft.knots[parameter].replace(statement.floats(1)?) {
            None => Ok(()),
            Some(_) => statement.refused("the knots were told before"),
        }
    }

    fn face(&mut self, statement: Statement<'a>) -> Result<()> {
        if self.first_face.is_none() {
            let name = self.object.clone().or_else(|| self.group.clone());
            self.first_face = Some((self.entries.len(), name));
        }
        // Vertices may come after faces; who counts back counts those before.
        let count = self.points.len();
        let corner = |word: &&str| {
            let number: i64 = statement.number(word.split('/').next().unwrap_or_default())?;
            match number {
                1.. => Ok(number as usize - 1),
                _ => index(&statement, word, count),
            }
        };
        let corners = statement.arguments().iter().map(corner).collect::<Result<_>>()?;
        self.corners.push((corners, statement));
        Ok(())
    }

    /// The text of the faces and of their vertices alone, each in its line.
    fn faces(&self, text: &str) -> Result<String> {
        let mut number = vec![None; self.points.len()];
        for (corners, statement) in &self.corners {
            for corner in corners {
                match number.get_mut(*corner) {
                    Some(number) => *number = Some(0),
                    None => return statement.refused(format!("there is no vertex {}", corner + 1)),
                }
            }
        }
        let mut lines = vec![String::new(); text.split('\n').count() + 1];
        let mut count = 0;
        for (vertex, number) in self.vertices.iter().zip(&mut number) {
            if number.is_some() {
                count += 1;
                *number = Some(count);
                lines[vertex.line] = format!("v {}", vertex.arguments().join(" "));
            }
        }
        for (corners, statement) in &self.corners {
            let line = &mut lines[statement.line];
            line.push('f');
            for corner in corners {
                let _ = write!(line, " {}", number[*corner].expect("it was given a number"));
            }
        }
        Ok(lines[1..].join("\n"))
    }
}

fn vertex(statement: &Statement<'_>) -> Result<([f64; 3], f64)> {
    // The mesh reader says what is wrong with a vertex of faces in its own words: here any numbers will do.
    match statement.floats(0)?[..] {
        [x, y, z] | [x, y, z, _, _, _] => Ok(([x, y, z], 1.0)),
        [x, y, z, w] => Ok(([x, y, z], w)),
        _ => statement.refused("a vertex has three coordinates, and a weight or a colour"),
    }
}

/// The index that a word tells, from 0.
fn index(statement: &Statement<'_>, word: &str, count: usize) -> Result<usize> {
    let text = word.split('/').next().unwrap_or_default();
    let number: i64 = statement.number(text)?;
    let found = match number {
        1.. => usize::try_from(number - 1).ok().filter(|index| *index < count),
        _ => usize::try_from(number.unsigned_abs())
            .ok()
            .filter(|back| *back > 0)
            .and_then(|back| count.checked_sub(back)),
    };
    match found {
        Some(index) => Ok(index),
        None => statement.refused(format!("there is no point {number}: {count} stand before this line")),
    }
}

fn name(statement: &Statement<'_>) -> Option<String> {
    Some(statement.arguments().join(" ")).filter(|name| !name.is_empty())
}

fn kind(statement: &Statement<'_>) -> Result<(Kind, bool)> {
    let (is_rational, word) = match statement.arguments() {
        ["rat", word] => (true, *word),
        [word] => (false, *word),
        _ => return statement.refused("'cstype' needs the type of curves"),
    };
    match word {
        "bspline" => Ok((Kind::Bspline, is_rational)),
        "bezier" => Ok((Kind::Bezier, is_rational)),
        _ => statement.refused(format!("curves of type '{}' are not read", start(word))),
    }
}
