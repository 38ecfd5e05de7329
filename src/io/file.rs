//! Files as a whole.

use std::fs;
use std::path::Path;

use crate::error::{Error, Result};

/// Writes a file and creates its folder if need be.
///
/// # Errors
/// [`Error::Io`].
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(failed(path.display()))?;
    }
    fs::write(path, bytes).map_err(failed(path.display()))
}

/// What the operating system said about a file.
pub(crate) fn failed(path: impl ToString) -> impl Fn(std::io::Error) -> Error {
    move |error| Error::Io { path: path.to_string(), message: error.to_string() }
}
