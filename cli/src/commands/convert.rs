//! `convert`: from one format to another.

use crate::failure::{Failure, Result};
use crate::input::{self, FieldChoice, format};
use crate::{output, progress};
use clap::Args;
use std::path::{Path, PathBuf};
use symspline_files::{Entry, Format};

/// Convert a file to another format
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  symspline convert curves.json curves.svg
  symspline convert --exact mesh.obj mesh.json
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
    /// The outlines of this text, of a font
    #[arg(long)]
    text: Option<String>,
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
            bar.inc(1);
        }
        bar.finish_and_clear();
        let output = Some(&self.output).filter(|file| file.as_path() != Path::new("-")).cloned();
        output::Output { output, to: self.to }.write(&entries)
    }
}

/// The outlines of a text in a font.
fn outlines(font: &Path, text: &str) -> Result<Vec<Entry>> {
    symspline_files::font::outlines(&input::bytes(font)?, text).map_err(|mut error| {
        error.file = input::file_name(font);
        error.into()
    })
}
