//! The words of an exchange structure.

use crate::error::{FileError, Place, Problem, Result};
use crate::nurbs::real::shown;

/// A word. Texts and the like are as they stand in the file, without their marks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Token<'a> {
    /// `CARTESIAN_POINT`, `ISO-10303-21`.
    Word(&'a str),
    /// `#12`.
    Reference(u64),
    /// `-1.5E-3`.
    Number(&'a str),
    /// `'it''s'`, both marks in the middle still there.
    Text(&'a [u8]),
    /// `.T.`.
    Enumeration(&'a str),
    /// `"0F"`.
    Binary,
    /// A bracket, comma, semicolon and the like.
    Sign(u8),
}

impl Token<'_> {
    /// As messages show it.
    pub(super) fn shown(self) -> String {
        match self {
            Self::Word(word) | Self::Number(word) => format!("'{}'", shown(word)),
            Self::Reference(id) => format!("#{id}"),
            Self::Text(_) => "a text".to_owned(),
            Self::Enumeration(word) => format!(".{}.", shown(word)),
            Self::Binary => "a binary".to_owned(),
            Self::Sign(sign) => format!("'{}'", char::from(sign)),
        }
    }
}

/// Where the words are read.
#[derive(Clone)]
pub(super) struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Scanner<'a> {
    pub(super) fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at }
    }

    /// How many bytes were read.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    /// An error here.
    pub(super) fn wrong(&self, what: impl Into<String>) -> FileError {
        let before = &self.bytes[..self.at.min(self.bytes.len())];
        let line = before.iter().filter(|b| **b == b'\n').count() + 1;
        let column = before.iter().rev().take_while(|b| **b != b'\n').count().max(1);
        Problem::Syntax(what.into()).at(Place::Line { line, column })
    }

    /// The next word.
    ///
    /// # Errors
    /// At the end of the file, for a text or comment without end, and for what begins no word.
    pub(super) fn next(&mut self) -> Result<Token<'a>> {
        self.skip_blanks()?;
        let Some(&first) = self.bytes.get(self.at) else { return Err(self.wrong("the file ends too early")) };
        Ok(match first {
            b'\'' => Token::Text(self.quoted(b'\'')?),
            b'"' => {
                self.quoted(b'"')?;
                Token::Binary
            }
            b'#' => {
                self.at += 1;
                let digits = self.run(|b| b.is_ascii_digit());
                match digits.parse() {
                    Ok(id) => Token::Reference(id),
                    Err(_) => {
                        return Err(self.wrong(format!("'#{}' is not a name of an instance", shown(digits))));
                    }
                }
            }
            b'.' => {
                self.at += 1;
                let word = self.run(|b| b.is_ascii_alphanumeric() || b == b'_');
                if self.bytes.get(self.at) != Some(&b'.') {
                    return Err(self.wrong(format!("the enumeration .{} has no end", shown(word))));
                }
                self.at += 1;
                Token::Enumeration(word)
            }
            b'+' | b'-' | b'0'..=b'9' => {
                Token::Number(self.run(|b| b.is_ascii_digit() || b"+-.eE".contains(&b)))
            }
            b'!' | b'_' => {
                self.at += 1;
                Token::Word(self.run(in_word))
            }
            first if first.is_ascii_alphabetic() => Token::Word(self.run(in_word)),
            first if first.is_ascii_graphic() => {
                self.at += 1;
                Token::Sign(first)
            }
            first => return Err(self.wrong(format!("byte {first} begins nothing"))),
        })
    }

    /// Passes one sign.
    ///
    /// # Errors
    /// If it does not come next.
    pub(super) fn expect(&mut self, sign: u8) -> Result<()> {
        match self.next()? {
            Token::Sign(found) if found == sign => Ok(()),
            other => Err(self.wrong(format!("'{}' was expected, not {}", char::from(sign), other.shown()))),
        }
    }

    fn skip_blanks(&mut self) -> Result<()> {
        loop {
            while self.bytes.get(self.at).is_some_and(|b| b.is_ascii_whitespace() || *b == 0x0b) {
                self.at += 1;
            }
            if !self.bytes[self.at..].starts_with(b"/*") {
                return Ok(());
            }
            let inside = &self.bytes[self.at + 2..];
            match inside.windows(2).position(|pair| pair == b"*/") {
                Some(length) => self.at += length + 4,
                None => return Err(self.wrong("the comment has no end")),
            }
        }
    }

    /// What stands between two marks; a doubled mark is part of it.
    fn quoted(&mut self, mark: u8) -> Result<&'a [u8]> {
        let start = self.at + 1;
        let mut end = start;
        loop {
            match self.bytes[end..].iter().position(|b| *b == mark) {
                None => return Err(self.wrong("the text has no end")),
                Some(length) if self.bytes.get(end + length + 1) == Some(&mark) => end += length + 2,
                Some(length) => {
                    end += length;
                    break;
                }
            }
        }
        self.at = end + 1;
        Ok(&self.bytes[start..end])
    }

    fn run(&mut self, belongs: impl Fn(u8) -> bool) -> &'a str {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|b| !belongs(*b)).unwrap_or(rest.len());
        self.at += length;
        std::str::from_utf8(&rest[..length]).expect("only ASCII letters, digits and signs belong")
    }
}

fn in_word(b: u8) -> bool {
    b.is_ascii_alphanumeric() || b == b'_' || b == b'-'
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &str) -> std::result::Result<Vec<Token<'_>>, String> {
        let mut scanner = Scanner::new(text.as_bytes(), 0);
        let mut tokens = Vec::new();
        while scanner.at() < text.trim_end().len() {
            tokens.push(scanner.next().map_err(|error| error.to_string())?);
        }
        Ok(tokens)
    }

    #[test]
    fn words_signs_and_comments_are_told_apart() {
        use Token::{Binary, Enumeration, Number, Reference, Sign, Text, Word};
        let text = "#1=/* 'no' * / */A_B('it''s',.T.,-1.E-05,\"0F\",$,*,!X);ISO-10303-21";
        let [open, close, comma] = *b"(),";
        let tokens = [
            Reference(1),
            Sign(b'='),
            Word("A_B"),
            Sign(open),
            Text(b"it''s"),
            Sign(comma),
            Enumeration("T"),
            Sign(comma),
            Number("-1.E-05"),
            Sign(comma),
            Binary,
            Sign(comma),
            Sign(b'$'),
            Sign(comma),
            Sign(b'*'),
            Sign(comma),
            Word("X"),
            Sign(close),
            Sign(b';'),
            Word("ISO-10303-21"),
        ];
        assert_eq!(all(text).unwrap(), tokens);
    }

    #[test]
    fn what_has_no_end_is_told_with_line_and_column() {
        for (text, wrong) in [
            ("A\n 'it''s", "input:2:1: the text has no end"),
            ("\n\n/* /", "input:3:1: the comment has no end"),
            ("A #x", "input:1:3: '#' is not a name of an instance"),
            ("#99999999999999999999", "input:1:21: '#99999999999999999999' is not a name of an instance"),
            (".T", "input:1:2: the enumeration .T has no end"),
            ("A\n\u{1}B", "input:2:1: byte 1 begins nothing"),
        ] {
            assert_eq!(all(text).unwrap_err(), wrong);
        }
    }
}
