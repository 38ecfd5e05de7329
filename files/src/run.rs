//! Reading and writing by format.

use crate::entry::Entry;
use crate::error::{Problem, Result};
use crate::format::Format;
use crate::{dxf, iges, json, step};
use std::fs::{self, File};
use std::io::Read as _;
use std::path::Path;

/// How many bytes of a file are read at most.
pub const MAX_BYTES: u64 = 1 << 30;

/// What a file holds, in the format that its name tells.
///
/// # Errors
/// With the name of the file and the place in it: [`Problem::Io`], [`Problem::TooLarge`] beyond [`MAX_BYTES`],
/// [`Problem::UnknownFormat`], and those of [`from_bytes`].
pub fn read(path: &Path) -> Result<Vec<Entry>> {
    let name = path.display().to_string();
    let read = || {
        let format = Format::of(path)?;
        let mut bytes = Vec::new();
        let file = File::open(path).map_err(|error| Problem::Io(error.to_string()).of_file())?;
        file.take(MAX_BYTES + 1)
            .read_to_end(&mut bytes)
            .map_err(|error| Problem::Io(error.to_string()).of_file())?;
        if bytes.len() as u64 > MAX_BYTES {
            return Err(Problem::TooLarge { limit: MAX_BYTES }.of_file());
        }
        from_bytes(&bytes, format)
    };
    read().map_err(|error| error.named(&name))
}

/// What the bytes of a file hold.
///
/// # Errors
/// With the place: [`Problem::OneWay`] for formats that are only written, [`Problem::Syntax`], [`Problem::Value`].
pub fn from_bytes(bytes: &[u8], format: Format) -> Result<Vec<Entry>> {
    match format {
        Format::Json => json::from_bytes(bytes),
        Format::Dxf => dxf::from_bytes(bytes),
        Format::Step => step::from_bytes(bytes),
        Format::Iges => iges::from_bytes(bytes),
    }
}

/// The file of a format that holds these values.
///
/// # Errors
/// [`Problem::OneWay`] for formats that are only read, [`Problem::NoRoom`] for values that the format cannot hold.
pub fn to_bytes(entries: &[Entry], format: Format) -> Result<Vec<u8>> {
    match format {
        Format::Json => json::to_bytes(entries),
        Format::Dxf => dxf::to_bytes(entries),
        Format::Step => step::to_bytes(entries),
        Format::Iges => iges::to_bytes(entries),
    }
}

/// Writes a file in the format that its name tells. Nothing is written if that fails.
///
/// # Errors
/// As [`to_bytes`], and [`Problem::Io`].
pub fn write(path: &Path, entries: &[Entry]) -> Result<()> {
    let name = path.display().to_string();
    let write = || {
        let bytes = to_bytes(entries, Format::of(path)?)?;
        fs::write(path, bytes).map_err(|error| Problem::Io(error.to_string()).of_file())
    };
    write().map_err(|error| error.named(&name))
}
