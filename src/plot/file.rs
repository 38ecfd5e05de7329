//! Files.

use std::fs;
use std::path::Path;

use crate::error::{Error, Result};

/// Writes a file and creates its folder if need be.
///
/// # Errors
/// [`Error::Io`].
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    let fail =
        |error: std::io::Error| Error::Io { path: path.display().to_string(), message: error.to_string() };
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(fail)?;
    }
    fs::write(path, bytes).map_err(fail)
}
