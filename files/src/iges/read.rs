//! Reading IGES.

use crate::entry::Entry;
use crate::error::{FileError, Place, Problem, Result};
use crate::iges::kinds;
use crate::iges::parameters::{Delimiters, Parameters, wrong};
use crate::iges::records::{PARAMETERS, Record, Sections};
use crate::iges::splines::Told;
use crate::nurbs::Nurbs;
use nalgebra::{Matrix3, Vector3};
use std::collections::HashMap;

type Read<T> = std::result::Result<T, Problem>;

/// How many matrices may refer to each other.
const DEEPEST: usize = 16;

/// How many letters of names that are used again are read beyond those of the file.
const MOST_LETTERS: usize = 1 << 24;

/// The use flag of curves in the parameters of a surface.
const IN_PARAMETERS: &[u8] = b"05";

/// The curves and surfaces of an IGES file, in the order of its directory.
///
/// # Errors
/// [`Problem::Syntax`] with the line where records are wrong; [`Problem::Syntax`] and [`Problem::Value`] with the directory entry whose
/// parameters are.
pub fn from_bytes(bytes: &[u8]) -> Result<Vec<Entry>> {
    let sections = Sections::of(bytes)?;
    let by = Delimiters::of(&sections.global())
        .map_err(|problem| problem.at(Place::Entry("global section".into())))?;
    let directory = sections.directory().chunks(2).map(Item::of).collect::<Result<Vec<_>>>()?;
    let mut file =
        File { sections, by, directory, matrices: HashMap::new(), names: HashMap::new(), letters: 0 };
    let mut entries = Vec::new();
    for i in 0..file.directory.len() {
        if !file.directory[i].in_parameters {
            entries.extend(file.entry(i).map_err(|problem| file.directory[i].failed(i, problem))?);
        }
    }
    Ok(entries)
}

/// An entry of the directory.
struct Item {
    kind: i64,
    /// Where its parameters begin, counted from 1, and how many records they have.
    parameters: i64,
    records: i64,
    matrix: i64,
    form: i64,
    in_parameters: bool,
}

impl Item {
    fn of(records: &[Record<'_>]) -> Result<Self> {
        let [first, second] = records else {
            return Err(records[0].wrong("the directory entry has one record, not two"));
        };
        let field = |record: &Record<'_>, i: usize| record.whole(8 * i, 8 * i + 8);
        let kind = field(first, 0)?;
        if field(second, 0)? != kind {
            return Err(second.wrong("the records of the directory entry tell different kinds"));
        }
        Ok(Self {
            kind,
            parameters: field(first, 1)?,
            matrix: field(first, 6)?,
            in_parameters: first.data[68..70] == *IN_PARAMETERS,
            records: field(second, 3)?,
            form: field(second, 4)?,
        })
    }

    fn failed(&self, i: usize, problem: Problem) -> FileError {
        problem.at(Place::Entry(format!("directory entry {} (entity {})", 2 * i + 1, self.kind)))
    }
}

/// The linear part and the shift of a matrix.
type Motion = (Matrix3<f64>, Vector3<f64>);

struct File<'a> {
    sections: Sections<'a>,
    by: Delimiters,
    directory: Vec<Item>,
    /// What was read: many entities may refer to one matrix or name.
    matrices: HashMap<i64, Motion>,
    names: HashMap<usize, Option<String>>,
    /// How many letters the names have that were given so far.
    letters: usize,
}

impl File<'_> {
    /// What an entry of the directory is, if it is a curve or surface.
    fn entry(&mut self, i: usize) -> Read<Option<Entry>> {
        let item = &self.directory[i];
        let matrix = item.matrix;
        let told: fn(&Parameters) -> Read<Told> = match item.kind {
            kinds::ARC => Parameters::arc,
            kinds::LINE => Parameters::line,
            kinds::CURVE => Parameters::curve,
            kinds::SURFACE => Parameters::surface,
            _ => return Ok(None),
        };
        let parameters = self.parameters(i)?;
        let Told { mut nurbs, ends, length } = told(&parameters)?;
        if matrix != 0 {
            let (turn, shift) = self.matrix(matrix, 0)?;
            nurbs.move_by(&turn, &shift);
        }
        let value = nurbs.into_part(&ends)?;
        Ok(Some(Entry { name: self.name(&parameters, length)?, value }))
    }

    /// The parameters of an entry; the first is its kind.
    fn parameters(&self, i: usize) -> Read<Parameters> {
        let (item, all) = (&self.directory[i], self.sections.parameters());
        let range = usize::try_from(item.parameters - 1).ok().zip(usize::try_from(item.records).ok());
        let records = range.and_then(|(start, count)| all.get(start..start.checked_add(count)?));
        let Some(records) = records.filter(|records| !records.is_empty()) else {
            let (start, count) = (item.parameters, item.records);
            return wrong(format!(
                "{count} parameter records from {start} on are told, {} are there",
                all.len()
            ));
        };
        let mut text = Vec::with_capacity(records.len() * PARAMETERS);
        for record in records {
            let owner = record.whole(PARAMETERS, record.data.len()).map_err(|error| *error.problem)?;
            if usize::try_from(owner) != Ok(2 * i + 1) {
                return wrong(format!(
                    "the parameters in line {} belong to directory entry {owner}",
                    record.line
                ));
            }
            text.extend(&record.data[..PARAMETERS]);
        }
        let parameters = Parameters::of(&text, self.by)?;
        match parameters.whole(0)? {
            kind if kind == item.kind => Ok(parameters),
            kind => wrong(format!("the parameters are those of an entity {kind}")),
        }
    }

    /// The index of the entry that a pointer refers to.
    fn pointed(&self, pointer: i64, kind: i64) -> Read<usize> {
        let index = usize::try_from(pointer).ok().filter(|at| at % 2 == 1).map(|at| at / 2);
        match index.filter(|index| self.directory.get(*index).is_some_and(|item| item.kind == kind)) {
            Some(index) => Ok(index),
            None => wrong(format!("pointer {pointer} does not refer to an entity {kind}")),
        }
    }

    /// The motion of a matrix, and of those that it refers to.
    fn matrix(&mut self, pointer: i64, depth: usize) -> Read<Motion> {
        if let Some(found) = self.matrices.get(&pointer) {
            return Ok(*found);
        }
        if depth == DEEPEST {
            return wrong(format!("more than {DEEPEST} matrices refer to each other, or in a circle"));
        }
        let index = self.pointed(pointer, kinds::MATRIX)?;
        let rows = self.parameters(index)?.reals(1, 12)?;
        let turn = Matrix3::from_fn(|i, j| rows[4 * i + j]);
        let shift = Vector3::from_fn(|i, _| rows[4 * i + 3]);
        let found = match self.directory[index].matrix {
            0 => (turn, shift),
            next => {
                let (outer, far) = self.matrix(next, depth + 1)?;
                (outer * turn, outer * shift + far)
            }
        };
        self.matrices.insert(pointer, found);
        Ok(found)
    }

    /// The name among the properties: after those of the entity there are pointers to associations, and then to properties.
    fn name(&mut self, parameters: &Parameters, length: usize) -> Read<Option<String>> {
        let Ok(associations) = usize::try_from(parameters.whole(length)?) else { return Ok(None) };
        let at = length.saturating_add(associations).saturating_add(1);
        let count = if at < parameters.len() { parameters.whole(at)? } else { 0 };
        for i in (at + 1..parameters.len()).take(usize::try_from(count).unwrap_or(0)) {
            let pointer = parameters.whole(i)?;
            let Ok(index) = self.pointed(pointer, kinds::PROPERTY) else { continue };
            if self.directory[index].form == kinds::NAME {
                return self.named(index);
            }
        }
        Ok(None)
    }
}

impl File<'_> {
    /// The name that a property tells.
    fn named(&mut self, index: usize) -> Read<Option<String>> {
        if !self.names.contains_key(&index) {
            let name = self.parameters(index)?.text(2);
            self.names.insert(index, name);
        }
        let name = self.names[&index].clone();
        self.letters += name.as_ref().map_or(0, String::len);
        match self.letters > MOST_LETTERS + self.sections.parameters().len() * PARAMETERS {
            true => wrong("the names of the file are too long for so many entities"),
            false => Ok(name),
        }
    }
}

impl Nurbs {
    /// Moves the control points; then they are in space.
    fn move_by(&mut self, turn: &Matrix3<f64>, shift: &Vector3<f64>) {
        let moved = |point: &[f64]| turn * Vector3::from(Self::in_space(point)) + shift;
        self.coords = self.points().flat_map(|point| moved(point).data.0[0]).collect();
        self.dim = 3;
    }
}
