//! What a command reads: a file or standard input, and the entry that is meant.

use crate::failure::{Failure, Result};
use clap::Args;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use symspline_dynamic::Value;
use symspline_files::{Entry, Format, MAX_BYTES, Place, Problem};

/// Whether numbers are fractions or floats.
#[derive(Args, Clone, Copy, Debug)]
pub struct FieldChoice {
    /// Convert what is read to fractions first, without loss
    #[arg(long, conflicts_with = "float")]
    pub exact: bool,
    /// Round what is read to floats first
    #[arg(long)]
    pub float: bool,
}

impl FieldChoice {
    /// The value in the field that was chosen.
    pub fn convert(self, value: Value) -> symspline_dynamic::Result<Value> {
        match (self.exact, self.float) {
            (true, _) => value.to_exact(),
            (_, true) => value.to_float(),
            _ => Ok(value),
        }
    }
}

/// A file to read, and which of its entries.
#[derive(Args, Clone, Debug)]
pub struct Input {
    /// The file; `-` is standard input
    #[arg(default_value = "-")]
    pub file: PathBuf,
    /// The format, if the ending of the name does not tell it; of standard input JSON unless told
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    pub from: Option<Format>,
    /// The entry with this name
    #[arg(long, conflicts_with = "item")]
    pub name: Option<String>,
    /// The entry with this number, from 0
    #[arg(long, value_name = "N")]
    pub item: Option<usize>,
    #[command(flatten)]
    pub field: FieldChoice,
}

/// A format by the ending of names of its files.
pub fn format(ending: &str) -> std::result::Result<Format, String> {
    Format::by_name(&ending.to_lowercase()).map_err(|error| error.problem.to_string())
}

/// The entries of a file, or of standard input if it is called `-`.
pub fn read(file: &Path, from: Option<Format>) -> Result<Vec<Entry>> {
    if file != Path::new("-") && from.is_none() {
        return Ok(symspline_files::read(file)?);
    }
    let name = file_name(file);
    let bytes = bytes(file)?;
    symspline_files::from_bytes(&bytes, from.unwrap_or(Format::Json)).map_err(|mut error| {
        error.file = name;
        error.into()
    })
}

/// The bytes of a file, or of standard input if it is called `-`.
pub fn bytes(file: &Path) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let read = match file == Path::new("-") {
        true => std::io::stdin().lock().take(MAX_BYTES + 1).read_to_end(&mut bytes),
        false => File::open(file).and_then(|open| open.take(MAX_BYTES + 1).read_to_end(&mut bytes)),
    };
    let problem = match read {
        Err(error) => Problem::Io(error.to_string()),
        Ok(_) if bytes.len() as u64 > MAX_BYTES => Problem::TooLarge { limit: MAX_BYTES },
        Ok(_) => return Ok(bytes),
    };
    let mut error = problem.at(Place::File);
    error.file = file_name(file);
    Err(error.into())
}

/// What messages call a file.
pub fn file_name(file: &Path) -> String {
    if file == Path::new("-") { "standard input".to_owned() } else { file.display().to_string() }
}

/// What messages call an entry of a file that holds several.
pub fn entry_name(index: usize, entry: &Entry) -> String {
    match &entry.name {
        Some(name) => format!("item {index} ({})", visible(name)),
        None => format!("item {index}"),
    }
}

/// A text from a file for people: what would steer a terminal is written out.
pub fn visible(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_control() { c.escape_unicode().to_string() } else { c.to_string() })
        .collect()
}

impl Input {
    /// What messages call the file.
    pub fn label(&self) -> String {
        file_name(&self.file)
    }

    /// What messages call the one entry that is meant: the file, and the entry if it was chosen.
    fn place(&self, index: usize, entry: &Entry) -> String {
        match self.name.is_some() || self.item.is_some() {
            true => format!("{}: {}", self.label(), entry_name(index, entry)),
            false => self.label(),
        }
    }

    /// The entries that are meant: one if it was named, else all.
    pub fn entries(&self) -> Result<Vec<(usize, Entry)>> {
        let all = read(&self.file, self.from)?;
        let listed: Vec<String> = all.iter().enumerate().map(|(i, entry)| entry_name(i, entry)).collect();
        let chosen = |(i, entry): &(usize, Entry)| match (&self.name, self.item) {
            (Some(name), _) => entry.name.as_ref() == Some(name),
            (_, Some(item)) => *i == item,
            _ => true,
        };
        let mut chosen: Vec<(usize, Entry)> = all.into_iter().enumerate().filter(chosen).collect();
        if chosen.is_empty() && (self.name.is_some() || self.item.is_some()) {
            let there = if listed.is_empty() { "nothing".to_owned() } else { listed.join(", ") };
            return Err(
                Failure::refused(format!("there is no such entry; there is {there}")).at(&self.label())
            );
        }
        for (i, entry) in &mut chosen {
            let place = || format!("{}: {}", self.label(), entry_name(*i, entry));
            let value = self.field.convert(entry.value.clone());
            entry.value = value.map_err(|error| Failure::from(error).at(&place()))?;
        }
        Ok(chosen)
    }

    /// The one entry that is meant, and what messages call it; if the file holds several, one must be named.
    pub fn entry(&self) -> Result<(String, Entry)> {
        let mut all = self.entries()?;
        match all.len() {
            1 => {
                let (i, entry) = all.remove(0);
                Ok((self.place(i, &entry), entry))
            }
            0 => Err(Failure::refused("the file holds nothing").at(&self.label())),
            _ => {
                let listed: Vec<String> = all.iter().map(|(i, entry)| entry_name(*i, entry)).collect();
                let problem =
                    format!("choose an entry with --name or --item: there is {}", listed.join(", "));
                Err(Failure::refused(problem).at(&self.label()))
            }
        }
    }

    /// The one entry that is meant, changed; what `change` refuses is told with its place.
    pub fn changed(&self, change: impl FnOnce(&Value) -> Result<Value>) -> Result<Vec<Entry>> {
        let (place, entry) = self.entry()?;
        let value = change(&entry.value).map_err(|failure| failure.at(&place))?;
        Ok(vec![Entry { value, ..entry }])
    }
}
