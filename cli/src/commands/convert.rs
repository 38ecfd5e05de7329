//! `convert`: from one format to another.

use crate::failure::{Failure, Result};
use crate::input::{self, FieldChoice, format};
use crate::{output, progress};
use clap::Args;
use std::path::{Path, PathBuf};
use symspline::{Q, Scalar};
use symspline_dynamic::{Coords, Value};
use symspline_files::{Entry, Format};

/// Convert a file to another format
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  symspline convert curves.json curves.svg
  symspline convert --exact mesh.obj mesh.json
  symspline convert --text 'so' --turn-over font.ttf so.svg
  symspline convert --from json --to json - -")]
pub struct Convert {
    /// The file to read; `-` is standard input
    input: PathBuf,
    /// The file to write; `-` is standard output
    output: PathBuf,
    /// The format that is read, if the ending of the name does not tell it
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    from: Option<Format>,
    /// The format that is written, if the ending of the name does not tell it
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    to: Option<Format>,
    /// The outlines of this text; the file is then a font
    #[arg(long, conflicts_with = "from")]
    text: Option<String>,
    /// Turn curves and surfaces over, y to -y: in fonts and CAD the y axis points up, in SVG down
    #[arg(long)]
    turn_over: bool,
    #[command(flatten)]
    field: FieldChoice,
}

impl Convert {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        let mut entries = match &self.text {
            Some(text) => outlines(&self.input, text)?,
            None => input::read(&self.input, self.from)?,
        };
        let bar = progress::bar(entries.len(), "converting");
        for (i, entry) in entries.iter_mut().enumerate() {
            let place = format!("{}: {}", input::file_name(&self.input), input::entry_name(i, entry));
            let value = self.field.convert(entry.value.clone());
            entry.value = value.map_err(|error| Failure::from(error).at(&place))?;
            if self.turn_over {
                entry.value = turned_over(&entry.value).map_err(|failure| failure.at(&place))?;
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        let output = Some(&self.output).filter(|file| file.as_path() != Path::new("-")).cloned();
        output::Output { output, to: self.to }.write(&entries)
    }
}

/// The mirror image with y the other way round.
fn turned_over(value: &Value) -> Result<Value> {
    let dim = value.dim();
    let entry = |i: usize| match (i / dim, i % dim) {
        (1, 1) => Q::int(-1),
        (row, column) => Q::int(i64::from(row == column)),
    };
    let mirror = Coords::Exact((0..dim * dim).map(entry).collect());
    let mirror = if value.is_exact() { mirror } else { mirror.to_float()? };
    Ok(match value {
        Value::Spline(s) if dim > 1 => s.transformed(&mirror)?.into(),
        Value::Surface(s) if dim > 1 => s.transformed(&mirror)?.into(),
        Value::Rational(s) if dim > 1 => s.transformed(&mirror)?.into(),
        Value::RationalSurface(s) if dim > 1 => s.transformed(&mirror)?.into(),
        other => return Err(Failure::refused(format!("a {} is not turned over", other.kind()))),
    })
}

/// The outlines of a text in a font.
fn outlines(font: &Path, text: &str) -> Result<Vec<Entry>> {
    symspline_files::font::outlines(&input::bytes(font)?, text).map_err(|mut error| {
        error.file = input::file_name(font);
        error.into()
    })
}
