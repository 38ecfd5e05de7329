//! The statements of an OBJ text, each with its line.

use crate::error::{Problem, Result};
use std::str::FromStr;

/// How much of a word errors repeat, in letters.
const REPEATED: usize = 24;

/// A statement: a keyword and its arguments.
#[derive(Clone, Debug)]
pub(super) struct Statement<'a> {
    /// Its line, counted from 1: the first one, if it goes on.
    pub line: usize,
    /// How many lines it takes.
    pub length: usize,
    words: Vec<&'a str>,
}

impl<'a> Statement<'a> {
    /// The keyword.
    pub fn keyword(&self) -> &'a str {
        self.words[0]
    }

    /// What follows the keyword.
    pub fn arguments(&self) -> &[&'a str] {
        &self.words[1..]
    }

    /// That something is wrong with it.
    pub fn refused<T>(&self, what: impl Into<String>) -> Result<T> {
        Err(Problem::Syntax(what.into()).at_line(self.line))
    }

    /// An argument as a number.
    pub fn number<T: FromStr>(&self, word: &str) -> Result<T> {
        match word.parse() {
            Ok(number) => Ok(number),
            Err(_) => self.refused(format!("'{}' is no such number", start(word))),
        }
    }

    /// An argument as a finite float.
    pub fn float(&self, word: &str) -> Result<f64> {
        let x: f64 = self.number(word)?;
        if x.is_finite() { Ok(x) } else { self.refused(format!("'{}' is not finite", start(word))) }
    }

    /// All arguments from one on as finite floats.
    pub fn floats(&self, from: usize) -> Result<Vec<f64>> {
        self.arguments().iter().skip(from).map(|word| self.float(word)).collect()
    }
}

/// A word, or how it begins.
pub(super) fn start(word: &str) -> String {
    word.chars().take(REPEATED).collect()
}

/// The statements of a text, without comments, those that go on put together.
pub(super) fn statements(text: &str) -> impl Iterator<Item = Result<Statement<'_>>> {
    let mut lines = text.trim_start_matches('\u{feff}').split('\n').enumerate();
    std::iter::from_fn(move || {
        while let Some((index, first)) = lines.next() {
            let mut statement = Statement { line: index + 1, length: 1, words: Vec::new() };
            let mut line = first;
            loop {
                let plain = line.split('#').next().unwrap_or_default().trim_end();
                let goes_on = plain.strip_suffix('\\');
                statement.words.extend(goes_on.unwrap_or(plain).split_whitespace());
                if goes_on.is_none() {
                    break;
                }
                match lines.next() {
                    Some((_, next)) => line = next,
                    None => return Some(statement.refused("the text ends where a line goes on")),
                }
                statement.length += 1;
            }
            if !statement.words.is_empty() {
                return Some(Ok(statement));
            }
        }
        None
    })
}
