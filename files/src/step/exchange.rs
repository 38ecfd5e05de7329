//! The exchange structure: which instances there are, and where.

use crate::error::{Place, Problem, Result};
use crate::nurbs::real::shown;
use crate::step::parameter::{DEEPEST, Part, parts};
use crate::step::scan::{Scanner, Token};
use std::collections::HashMap;

/// The instances of a file by their numbers. Only those that are asked for are taken apart.
pub(super) struct Exchange<'a> {
    bytes: &'a [u8],
    /// Where each is defined, after its sign `=`.
    places: HashMap<u64, usize>,
    /// Those that have one of the types that were looked for, in the order of the file.
    pub found: Vec<u64>,
}

impl<'a> Exchange<'a> {
    /// Reads the structure of a file, and notes the instances of types that are `wanted`.
    ///
    /// # Errors
    /// [`Problem::Syntax`] with line and column.
    pub(super) fn of(bytes: &'a [u8], wanted: impl Fn(&str) -> bool) -> Result<Self> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut scanner = Scanner::new(bytes, 0);
        if !matches!(scanner.next(), Ok(Token::Word("ISO-10303-21"))) {
            return Err(scanner.wrong("the file does not begin with 'ISO-10303-21;'"));
        }
        scanner.expect(b';')?;
        let mut exchange = Self { bytes, places: HashMap::new(), found: Vec::new() };
        loop {
            match scanner.next()? {
                Token::Word("END-ISO-10303-21") => break,
                Token::Word("DATA") => exchange.data(&mut scanner, &wanted)?,
                Token::Word(_) => skip_section(&mut scanner)?,
                other => return Err(scanner.wrong(format!("a section was expected, not {}", other.shown()))),
            }
        }
        scanner.expect(b';')?;
        Ok(exchange)
    }

    fn data(&mut self, scanner: &mut Scanner<'a>, wanted: &impl Fn(&str) -> bool) -> Result<()> {
        // The section may have parameters.
        skip_to_semicolon(scanner, |_| {})?;
        loop {
            let id = match scanner.next()? {
                Token::Reference(id) => id,
                Token::Word("ENDSEC") => return scanner.expect(b';'),
                other => {
                    return Err(scanner.wrong(format!("an instance was expected, not {}", other.shown())));
                }
            };
            scanner.expect(b'=')?;
            if self.places.insert(id, scanner.at()).is_some() {
                return Err(scanner.wrong(format!("#{id} is defined twice")));
            }
            let mut found = false;
            skip_to_semicolon(scanner, |word| found |= wanted(word))?;
            if found {
                self.found.push(id);
            }
        }
    }

    /// Whether there is such an instance.
    pub(super) fn defines(&self, id: u64) -> bool {
        self.places.contains_key(&id)
    }

    /// The parts of an instance.
    ///
    /// # Errors
    /// [`Problem::Syntax`] at the instance.
    pub(super) fn instance(&self, id: u64) -> std::result::Result<Vec<Part<'a>>, Problem> {
        let Some(at) = self.places.get(&id) else {
            return Err(Problem::Syntax(format!("#{id} is referred to and not there")));
        };
        parts(&mut Scanner::new(self.bytes, *at))
    }
}

/// The place of an instance.
pub(super) fn place(id: u64) -> Place {
    Place::Entry(format!("#{id}"))
}

/// Passes over all up to a semicolon; shows the words.
fn skip_to_semicolon<'a>(scanner: &mut Scanner<'a>, mut show: impl FnMut(&'a str)) -> Result<()> {
    let mut depth = 0_usize;
    loop {
        match scanner.next()? {
            Token::Word("ENDSEC" | "DATA") => return Err(scanner.wrong("an instance has no end")),
            Token::Word(word) => show(word),
            Token::Sign(b'=') => return Err(scanner.wrong("an instance has no end")),
            Token::Sign(b'(') if depth == DEEPEST => {
                return Err(scanner.wrong(format!("more than {DEEPEST} brackets stand in each other")));
            }
            Token::Sign(b'(') => depth += 1,
            Token::Sign(b')') if depth == 0 => {
                return Err(scanner.wrong("a bracket closes that was not opened"));
            }
            Token::Sign(b')') => depth -= 1,
            Token::Sign(b';') if depth > 0 => return Err(scanner.wrong("a bracket is not closed")),
            Token::Sign(b';') => return Ok(()),
            _ => {}
        }
    }
}

/// Passes over a section of no interest.
fn skip_section(scanner: &mut Scanner<'_>) -> Result<()> {
    loop {
        match scanner.next()? {
            Token::Word("ENDSEC") => return scanner.expect(b';'),
            Token::Word(word @ ("DATA" | "END-ISO-10303-21")) => {
                return Err(scanner.wrong(format!("'{}' stands in a section that has no end", shown(word))));
            }
            _ => {}
        }
    }
}
