//! Writing IGES.

use crate::entry::Entry;
use crate::error::{Place, Problem, Result};
use crate::iges::kinds;
use crate::iges::records::{DATA, PARAMETERS};
use crate::nurbs::real::written;
use crate::nurbs::{Along, Nurbs, by_columns};

/// The most records of a section: their numbers have seven digits.
const MOST: usize = 9_999_999;

/// The IGES file with these curves and surfaces.
///
/// # Errors
/// [`Problem::NoRoom`] for what is no curve or surface, for functions and plane surfaces, for weights that are not positive, for names
/// with other letters than those of ASCII, and for more than 9999999 records; [`Problem::Value`].
pub fn to_bytes(entries: &[Entry]) -> Result<Vec<u8>> {
    let mut file = Draft::default();
    for (i, entry) in entries.iter().enumerate() {
        let told = Nurbs::of(&entry.value, "IGES");
        let put = told.and_then(|told| file.spline(&told, entry.name.as_deref(), entry.value.kind()));
        put.map_err(|problem| problem.at(Place::Entry(format!("item {i}"))))?;
    }
    file.finished()
}

#[derive(Default)]
struct Draft {
    directory: Vec<String>,
    parameters: Vec<String>,
}

impl Draft {
    /// Puts an entity; returns its pointer.
    fn put(&mut self, kind: i64, form: i64, status: &str, items: &[String]) -> usize {
        let pointer = self.directory.len() + 1;
        let first = self.parameters.len() + 1;
        let lines = wrapped(items, PARAMETERS);
        let count = lines.len();
        self.parameters.extend(lines.into_iter().map(|line| format!("{line:<64}{pointer:>8}")));
        self.directory
            .push(format!("{kind:>8}{first:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{status}", 0, 0, 0, 0, 0, 0));
        self.directory.push(format!("{kind:>8}{:>8}{:>8}{count:>8}{form:>8}{:>24}{:>8}", 0, 0, "", 0));
        pointer
    }

    fn spline(&mut self, told: &Nurbs, name: Option<&str>, kind: &str) -> std::result::Result<(), Problem> {
        let no_room = |value: String| Err(Problem::NoRoom { format: "IGES", value });
        let surface = told.along.len() == 2;
        if surface && told.dim == 2 {
            return no_room(format!("{kind} in the plane"));
        }
        if let Some(name) =
            name.filter(|name| !name.chars().all(|letter| letter == ' ' || letter.is_ascii_graphic()))
        {
            return no_room(format!("name {name:?}"));
        }
        let flag = |set: bool| u8::from(set).to_string();
        let all = |item: &dyn Fn(&Along) -> Vec<String>| told.along.iter().flat_map(item).collect::<Vec<_>>();
        let entity = if surface { kinds::SURFACE } else { kinds::CURVE };
        let mut items = vec![entity.to_string()];
        items.extend(all(&|along| vec![(along.count() - 1).to_string()]));
        items.extend(all(&|along| vec![along.degree.to_string()]));
        items.extend((!surface).then(|| flag(told.dim == 2)));
        items.extend((0..told.along.len()).map(|i| flag(told.along[i].periodic || told.closes(i))));
        items.push(flag(told.weights.is_none()));
        items.extend(all(&|along| vec![flag(along.periodic)]));
        items.extend(all(&|along| along.knots.iter().copied().map(real).collect()));
        let (rows, columns) = (told.along[0].count(), told.along.get(1).map_or(1, Along::count));
        let order = || by_columns(rows, columns);
        items.extend(order().map(|i| real(told.weights.as_ref().map_or(1.0, |weights| weights[i]))));
        let points: Vec<&[f64]> = told.points().collect();
        items.extend(order().flat_map(|i| Nurbs::in_space(points[i])).map(real));
        items.extend(all(&|along| along.domain().map(real).to_vec()));
        if !surface {
            items.extend([0.0, 0.0, if told.dim == 2 { 1.0 } else { 0.0 }].map(real));
        }
        if let Some(name) = name {
            // No association, one property: the entity comes after this one.
            items.extend(["0".to_owned(), "1".to_owned(), (self.directory.len() + 3).to_string()]);
            self.put(entity, 0, "00000000", &items);
            let name = vec![kinds::PROPERTY.to_string(), "1".to_owned(), hollerith(name)];
            self.put(kinds::PROPERTY, kinds::NAME, "00010300", &name);
        } else {
            self.put(entity, 0, "00000000", &items);
        }
        Ok(())
    }

    fn finished(self) -> Result<Vec<u8>> {
        if self.directory.len().max(self.parameters.len()) > MOST {
            let value = format!("more than {MOST} records");
            return Err(Problem::NoRoom { format: "IGES", value }.of_file());
        }
        // Millimetres, 64-bit numbers, version 5.3.
        let global = "1H,|1H;|9Hsymspline|0H|9Hsymspline|9Hsymspline|32|308|15|308|15|0H|1.0|2|2HMM|1|0.0|15H20000101.000000|1.0E-7|0.0|0H|0H|11|0|15H20000101.000000";
        let global: Vec<String> = global.split('|').map(str::to_owned).collect();
        let sections = [
            ('S', vec!["splines".to_owned()]),
            ('G', wrapped(&global, DATA)),
            ('D', self.directory),
            ('P', self.parameters),
        ];
        let mut text = String::new();
        for (letter, records) in &sections {
            for (i, record) in records.iter().enumerate() {
                text.push_str(&format!("{record:<72}{letter}{:>7}\n", i + 1));
            }
        }
        let counts: String =
            sections.iter().map(|(letter, records)| format!("{letter}{:>7}", records.len())).collect();
        text.push_str(&format!("{counts:<72}T{:>7}\n", 1));
        Ok(text.into_bytes())
    }
}

/// A number of double length.
fn real(x: f64) -> String {
    written(x).replace('E', "D")
}

fn hollerith(text: &str) -> String {
    format!("{}H{text}", text.len())
}

/// Items and their delimiters in lines: they break after delimiters, and inside of texts that are longer than a line.
fn wrapped(items: &[String], width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for (i, item) in items.iter().enumerate() {
        let delimiter = if i + 1 == items.len() { ';' } else { ',' };
        let mut rest = format!("{item}{delimiter}");
        let last = lines.last_mut().expect("there is a line from the start");
        if last.len() + rest.len() <= width {
            last.push_str(&rest);
            continue;
        }
        while rest.len() > width {
            let after = rest.split_off(width);
            lines.push(std::mem::replace(&mut rest, after));
        }
        lines.push(rest);
    }
    lines.retain(|line| !line.is_empty());
    lines
}
