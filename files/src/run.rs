//! Reading and writing by format.

use crate::entry::Entry;
use crate::error::{FileError, Problem, Result};
use crate::format::Format;
use crate::{dxf, geomdl, iges, json, obj, shaded, step, svg};
use std::fs::{self, File};
use std::io::Read as _;
use std::path::Path;

/// How many bytes of a file are read at most.
pub const MAX_BYTES: u64 = 1 << 30;

/// What a file holds, in the format that its name tells.
///
/// # Errors
/// With the name of the file and the place in it: [`Problem::Io`], [`Problem::TooLarge`] beyond [`MAX_BYTES`],
/// [`Problem::UnknownFormat`], and those of [`from_bytes`]. A file `.json` may hold the library's own form or that of geomdl.
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
        let read = from_bytes(&bytes, format);
        // Two formats end in `.json`: what is in the file tells them apart.
        match read {
            Err(_) if format == Format::Json && geomdl::is_meant(&bytes) => geomdl::from_bytes(&bytes),
            read => read,
        }
    };
    read().map_err(|error| error.named(&name))
}

/// What the bytes of a file hold.
///
/// # Errors
/// With the place: [`Problem::OneWay`] for formats that are only written, [`Problem::NoText`] for fonts, [`Problem::Syntax`], [`Problem::Value`].
pub fn from_bytes(bytes: &[u8], format: Format) -> Result<Vec<Entry>> {
    match format {
        Format::Json => json::from_bytes(bytes),
        Format::Geomdl => geomdl::from_bytes(bytes),
        Format::Svg => svg::from_bytes(bytes),
        Format::Font => Err(Problem::NoText.of_file()),
        Format::Obj => obj::from_bytes(bytes),
        Format::Ply | Format::Stl | Format::Gltf => Err(one_way(format, "read")),
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
        Format::Geomdl => geomdl::to_bytes(entries),
        Format::Svg => svg::to_bytes(entries),
        Format::Font => Err(one_way(format, "written")),
        Format::Obj => obj::to_bytes(entries),
        Format::Ply => shaded::ply(entries),
        Format::Stl => shaded::stl(entries),
        Format::Gltf => shaded::gltf(entries),
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

fn one_way(format: Format, verb: &'static str) -> FileError {
    Problem::OneWay { format: format.name(), verb }.of_file()
}
