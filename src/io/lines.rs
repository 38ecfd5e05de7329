//! The lines of a text, those that are continued put together.

use std::io::{BufRead, Read as _};

use crate::error::mesh::MeshError;
use crate::error::obj::ObjError;
use crate::error::{Error, Result};
use crate::io::file::failed;

/// The longest line, in bytes, with all that continue it.
pub(super) const LONGEST: usize = 1 << 24;

/// The lines of a text, without comments, those that are continued put together.
pub(super) struct Lines<'a, R> {
    text: R,
    name: &'a str,
    /// How many lines were read.
    count: usize,
}

impl<'a, R: BufRead> Lines<'a, R> {
    /// The lines of what a reader of that name reads.
    pub(super) fn new(text: R, name: &'a str) -> Self {
        Self { text, name, count: 0 }
    }

    /// The next line and its number; none at the end.
    pub(super) fn next(&mut self) -> Result<Option<(usize, String)>> {
        let (first, mut whole) = (self.count + 1, String::new());
        let mut bytes = Vec::new();
        loop {
            bytes.clear();
            let room = LONGEST - whole.len();
            let mut part = (&mut self.text).take(room as u64 + 1);
            part.read_until(b'\n', &mut bytes).map_err(failed(self.name))?;
            if bytes.len() > room {
                return Err(refused(ObjError::LongLine { line: first, limit: LONGEST }));
            }
            if bytes.is_empty() {
                return match self.count + 1 == first {
                    true => Ok(None),
                    false => Err(refused(ObjError::Unfinished { line: first })),
                };
            }
            self.count += 1;
            // What is no text is in comments and names, or is refused as a word.
            let text = String::from_utf8_lossy(&bytes);
            let text = if self.count == 1 { text.trim_start_matches('\u{feff}') } else { &text };
            let text = text.split('#').next().unwrap_or_default().trim_end();
            match text.strip_suffix('\\') {
                // The end of a line parts words.
                Some(text) if whole.len() + text.len() < LONGEST => whole.extend([text, " "]),
                Some(_) => return Err(refused(ObjError::LongLine { line: first, limit: LONGEST })),
                None => {
                    whole.push_str(text);
                    return Ok(Some((first, whole)));
                }
            }
        }
    }
}

pub(super) fn refused(error: ObjError) -> Error {
    MeshError::Obj(error).into()
}
