//! What a command writes: values to a file or to standard output, tables and notes.

use crate::failure::{Failure, Result};
use crate::input::format;
use clap::Args;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use symspline_files::{Entry, Format};

/// Where values are written.
#[derive(Args, Clone, Debug)]
pub struct Output {
    /// Write to this file, in the format that its ending tells
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// The format, whatever the ending of the name; of standard output JSON unless told
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    pub to: Option<Format>,
}

impl Output {
    /// Writes values.
    pub fn write(&self, entries: &[Entry]) -> Result<()> {
        match &self.output {
            Some(file) => write(file, self.to, entries),
            None => {
                let bytes = symspline_files::to_bytes(entries, self.to.unwrap_or(Format::Json));
                bytes_out(&bytes.map_err(|error| of_values(error, "standard output"))?)
            }
        }
    }
}

/// Writes values to a file in a format, or in the one that its ending tells.
pub fn write(file: &Path, to: Option<Format>, entries: &[Entry]) -> Result<()> {
    let name = file.display().to_string();
    let format = match to {
        Some(format) => format,
        None => Format::of(file).map_err(|error| of_values(error, &name))?,
    };
    let bytes = symspline_files::to_bytes(entries, format).map_err(|error| of_values(error, &name))?;
    write_bytes(file, &bytes)
}

/// Writes bytes to a file.
pub fn write_bytes(file: &Path, bytes: &[u8]) -> Result<()> {
    std::fs::write(file, bytes).map_err(|error| {
        let mut problem = symspline_files::Problem::Io(error.to_string()).of_file();
        problem.file = file.display().to_string();
        problem.into()
    })
}

/// A value that cannot be written is refused; the file is not at fault.
fn of_values(mut error: symspline_files::FileError, name: &str) -> Failure {
    error.file = name.to_owned();
    match *error.problem {
        symspline_files::Problem::Value(_) => Failure::refused(error),
        _ => error.into(),
    }
}

/// Writes bytes to standard output; that nobody reads them is no error.
pub fn bytes_out(bytes: &[u8]) -> Result<()> {
    let mut out = std::io::stdout().lock();
    out.write_all(bytes).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => Failure::Closed,
        _ => Failure::Io { file: "standard output", error },
    })
}

/// Writes text to standard output.
pub fn text(text: &str) -> Result<()> {
    bytes_out(text.as_bytes())
}

/// Writes a JSON value to standard output, on one line.
pub fn json(value: &serde_json::Value) -> Result<()> {
    text(&format!("{value}\n"))
}

/// Tells something about the work on standard error; if nobody listens, so be it.
pub fn note(text: impl std::fmt::Display) {
    drop(writeln!(std::io::stderr().lock(), "{text}"));
}

/// Columns with as much room as their widest cells, numbers to the left, two blanks between.
pub fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |i: usize| rows.iter().filter_map(|row| row.get(i)).map(|c| c.chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|i| width(i).unwrap_or(0)).collect();
    let line = |row: &Vec<String>| {
        let cells: Vec<String> =
            row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        format!("{}\n", cells.join("  ").trim_end())
    };
    rows.iter().map(line).collect()
}
