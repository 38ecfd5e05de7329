//! Groups: a code and a value, a line each.

use crate::error::{Problem, Result};
use crate::nurbs::real;
use std::borrow::Cow;

/// A code, its value, and the line where the value stands.
#[derive(Clone, Debug)]
pub(super) struct Group<'a> {
    pub code: i32,
    pub value: Cow<'a, str>,
    pub line: usize,
}

impl Group<'_> {
    /// The value as a finite number.
    pub(super) fn real(&self) -> Result<f64> {
        let text = self.value.trim();
        real::read(text).ok_or_else(|| {
            let text = real::shown(text);
            Problem::Syntax(format!("group {}: '{text}' is not a finite number", self.code))
                .at_line(self.line)
        })
    }

    /// The value as a whole number.
    pub(super) fn whole(&self) -> Result<i64> {
        let text = self.value.trim();
        text.parse().map_err(|_| {
            let text = real::shown(text);
            Problem::Syntax(format!("group {}: '{text}' is not a whole number", self.code)).at_line(self.line)
        })
    }
}

/// The groups of a text.
pub(super) struct Groups<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> Groups<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Result<Self> {
        if bytes.starts_with(b"AutoCAD Binary DXF") {
            return Err(Problem::Syntax("binary DXF files are not read".to_owned()).at_line(1));
        }
        Ok(Self { rest: bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes), line: 0 })
    }

    /// The lines that were read.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    fn next_line(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        self.line += 1;
        let (line, rest) = match self.rest.iter().position(|b| *b == b'\n') {
            Some(end) => (&self.rest[..end], &self.rest[end + 1..]),
            None => (self.rest, &self.rest[self.rest.len()..]),
        };
        self.rest = rest;
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }

    /// The next group; `None` at the end of the text.
    pub(super) fn next(&mut self) -> Result<Option<Group<'a>>> {
        let Some(code) = self.next_line() else { return Ok(None) };
        let text = String::from_utf8_lossy(code);
        // Codes have 16 bits.
        let Ok(code) = text.trim().parse::<i16>().map(i32::from) else {
            let text = real::shown(text.trim());
            return Err(Problem::Syntax(format!("'{text}' is not a group code")).at_line(self.line));
        };
        let Some(value) = self.next_line() else {
            return Err(
                Problem::Syntax(format!("the file ends after the group code {code}")).at_line(self.line)
            );
        };
        // Before 2007 texts were in code pages; only names are concerned.
        let value = match std::str::from_utf8(value) {
            Ok(text) => Cow::Borrowed(text),
            Err(_) => Cow::Owned(value.iter().copied().map(char::from).collect()),
        };
        Ok(Some(Group { code, value, line: self.line }))
    }
}

/// A text with its letters `\U+XXXX`.
pub(super) fn unescaped(text: &str) -> String {
    let mut units: Vec<u16> = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("\\U+") {
        units.extend(rest[..at].encode_utf16());
        let digits = rest.get(at + 3..at + 7).filter(|digits| digits.bytes().all(|b| b.is_ascii_hexdigit()));
        match digits.and_then(|digits| u16::from_str_radix(digits, 16).ok()) {
            Some(unit) => {
                units.push(unit);
                rest = &rest[at + 7..];
            }
            None => {
                units.extend("\\U+".encode_utf16());
                rest = &rest[at + 3..];
            }
        }
    }
    units.extend(rest.encode_utf16());
    String::from_utf16_lossy(&units)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_by_number_are_read() {
        assert_eq!(unescaped("a\\U+00E9\\U+d83d\\U+DE00\\U+12\\"), "aé😀\\U+12\\");
        assert_eq!(unescaped("\\U+00é0"), "\\U+00é0");
    }

    #[test]
    fn lines_are_counted_and_marks_and_returns_taken_off() {
        let mut groups = Groups::new(b"\xef\xbb\xbf  0\r\nSECTION\r\n 10\n 1.5 \nx\n").unwrap();
        let first = groups.next().unwrap().unwrap();
        assert_eq!((first.code, &*first.value, first.line), (0, "SECTION", 2));
        assert_eq!(groups.next().unwrap().unwrap().real().unwrap(), 1.5);
        assert_eq!(groups.next().unwrap_err().to_string(), "input:5: 'x' is not a group code");
    }
}
