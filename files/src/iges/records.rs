//! Records: lines of 80 columns, in five sections.

use crate::error::{FileError, Problem, Result};
use crate::nurbs::real::shown;

/// The letters of the sections, in their order.
const SECTIONS: [u8; 5] = *b"SGDPT";

/// The columns of a record that are data.
pub(super) const DATA: usize = 72;

/// The columns that are parameters; the others tell whose they are.
pub(super) const PARAMETERS: usize = 64;

/// The data columns of a record, and its line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record<'a> {
    pub data: &'a [u8],
    pub line: usize,
}

impl Record<'_> {
    /// The whole number in some columns; 0 if they are blank.
    pub(super) fn whole(&self, from: usize, to: usize) -> Result<i64> {
        let text = String::from_utf8_lossy(&self.data[from..to]);
        let text = text.trim();
        if text.is_empty() {
            return Ok(0);
        }
        text.parse().map_err(|_| self.wrong(format!("'{}' is not a whole number", shown(text))))
    }

    pub(super) fn wrong(&self, what: impl Into<String>) -> FileError {
        Problem::Syntax(what.into()).at_line(self.line)
    }
}

/// The sections of a file.
#[derive(Debug, Default)]
pub(super) struct Sections<'a> {
    sections: [Vec<Record<'a>>; 5],
}

impl<'a> Sections<'a> {
    /// Takes a file apart.
    ///
    /// # Errors
    /// [`Problem::Syntax`] with the line: for lines that are no records, for sections out of order, for records out of sequence, and
    /// unless the last one counts those of the others.
    pub(super) fn of(bytes: &'a [u8]) -> Result<Self> {
        let (mut all, mut current, mut line) = (Self::default(), 0, 0);
        for text in bytes.split(|b| *b == b'\n') {
            line += 1;
            let text = text.strip_suffix(b"\r").unwrap_or(text);
            if text.iter().all(|b| b.is_ascii_whitespace() || *b == 0x1a) {
                continue;
            }
            let wrong = |what: &str| Err(Problem::Syntax(what.to_owned()).at_line(line));
            let Some((data, rest)) = text.split_at_checked(DATA).filter(|(_, rest)| !rest.is_empty()) else {
                return wrong("the line has fewer than 80 columns");
            };
            let Some(section) = SECTIONS.iter().position(|letter| *letter == rest[0]) else {
                return wrong(match rest[0] {
                    b'C' => "compressed IGES files are not read",
                    b'B' => "binary IGES files are not read",
                    _ => "column 73 has none of the letters S, G, D, P and T",
                });
            };
            if section < current || current == SECTIONS.len() - 1 {
                return wrong("the sections are not in the order S, G, D, P, T");
            }
            current = section;
            let record = Record { data, line };
            let number = Record { data: rest, line }.whole(1, rest.len())?;
            all.sections[section].push(record);
            if usize::try_from(number) != Ok(all.sections[section].len()) {
                return wrong("the number of the record, in columns 74 to 80, is out of sequence");
            }
        }
        all.check_counts(line)?;
        Ok(all)
    }

    fn check_counts(&self, last: usize) -> Result<()> {
        let Some(end) = self.sections[4].first() else {
            return Err(Problem::Syntax("the file ends before its last section, T".to_owned()).at_line(last));
        };
        for (i, letter) in SECTIONS[..4].iter().enumerate() {
            let (claimed, found) = (end.whole(8 * i + 1, 8 * i + 8)?, self.sections[i].len());
            if end.data[8 * i] != *letter || usize::try_from(claimed) != Ok(found) {
                let letter = char::from(*letter);
                return Err(end.wrong(format!("{claimed} records {letter} are told, {found} are there")));
            }
        }
        Ok(())
    }

    /// The text of the global section.
    pub(super) fn global(&self) -> Vec<u8> {
        self.sections[1].iter().flat_map(|record| record.data).copied().collect()
    }

    pub(super) fn directory(&self) -> &[Record<'a>] {
        &self.sections[2]
    }

    pub(super) fn parameters(&self) -> &[Record<'a>] {
        &self.sections[3]
    }
}
