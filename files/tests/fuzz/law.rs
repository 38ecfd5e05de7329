//! What every reader promises of any bytes: an answer, and what it accepts can be written and read again.

use symspline_dynamic::Value;
use symspline_files::{Entry, Format, Problem, font, from_bytes, to_bytes};

/// The text whose letters are asked of fonts.
const TEXT: &str = "aé8 |";

/// What the bytes hold; of a font some letters.
pub fn read(bytes: &[u8], format: Format) -> symspline_files::Result<Vec<Entry>> {
    match format {
        Format::Font => font::outlines(bytes, TEXT),
        format => from_bytes(bytes, format),
    }
}

/// Checks the law; tells whether the bytes were accepted.
///
/// Values come back bit by bit. From the second time on only do those that a format changes once: rational ones where it holds points
/// apart from weights, since their product is rounded, or has no rational curves and an approximation comes back; curves of the plane, which STEP
/// puts in space.
pub fn holds(bytes: &[u8], format: Format) -> bool {
    let Ok(entries) = read(bytes, format) else { return false };
    if !format.is_written() {
        return true;
    }
    let Some(again) = once_more(&entries, format) else { return true };
    let is_changed = |entry: &Entry| match entry.value {
        Value::Rational(_) | Value::RationalSurface(_) => format != Format::Json,
        _ => format == Format::Step && entry.value.dim() == 2,
    };
    if !entries.iter().any(is_changed) {
        assert_eq!(format!("{again:?}"), format!("{entries:?}"), "what was written is not what was read");
    }
    let Some(third) = once_more(&again, format) else { panic!("what was written once is refused") };
    assert_eq!(format!("{third:?}"), format!("{again:?}"), "what was written is not what was read");
    true
}

/// Written and read; none where the format has no room for it, or an approximation is out of reach.
fn once_more(entries: &[Entry], format: Format) -> Option<Vec<Entry>> {
    match to_bytes(entries, format) {
        Ok(bytes) => Some(read(&bytes, format).unwrap_or_else(|error| {
            panic!("{error}: what was written is refused:\n{}", String::from_utf8_lossy(&bytes))
        })),
        Err(error) if matches!(*error.problem, Problem::NoRoom { .. } | Problem::Value(_)) => None,
        Err(error) => panic!("{error}: what was read is not written"),
    }
}
