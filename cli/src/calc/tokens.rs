//! The words of an expression.

use crate::calc::complaint::Complaint;
use crate::numbers;
use std::ops::Range;
use symspline::Q;

/// A word.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    /// A number, exactly as written.
    Number(Q),
    /// A name: letters, digits and `_`, not a digit first.
    Name(String),
    /// One of `+ - * / @ ( ) ,`.
    Symbol(char),
    /// The end of the text.
    End,
}

impl Token {
    /// What messages call it.
    pub fn describe(&self) -> String {
        match self {
            Self::Number(_) => "a number".to_owned(),
            Self::Name(name) => format!("'{name}'"),
            Self::Symbol(symbol) => format!("'{symbol}'"),
            Self::End => "the end".to_owned(),
        }
    }
}

/// The words of a text with the bytes they take; the last is [`Token::End`].
pub fn tokens(text: &str) -> Result<Vec<(Token, Range<usize>)>, Complaint> {
    let mut found = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_start();
        let start = text.len() - rest.len();
        let Some(first) = rest.chars().next() else {
            found.push((Token::End, start..start));
            return Ok(found);
        };
        let length = match first {
            c if c.is_ascii_digit() || c == '.' => number_length(rest),
            c if c.is_alphabetic() || c == '_' => {
                rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len())
            }
            c => c.len_utf8(),
        };
        let (word, after) = rest.split_at(length);
        let span = start..start + length;
        let token = match first {
            c if c.is_ascii_digit() || c == '.' => {
                Token::Number(numbers::number(word).map_err(|why| Complaint::grammar(span.clone(), why))?)
            }
            c if c.is_alphabetic() || c == '_' => Token::Name(word.to_owned()),
            c if "+-*/@(),".contains(c) => Token::Symbol(c),
            c => return Err(Complaint::grammar(span, format!("'{c}' means nothing here"))),
        };
        found.push((token, span));
        rest = after;
    }
}

/// How many bytes at the start are a number: digits and points, and a power of ten.
fn number_length(text: &str) -> usize {
    let digits = |text: &str| text.find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(text.len());
    let plain = digits(text);
    let Some(power) = text[plain..].strip_prefix(['e', 'E']) else { return plain };
    let signs = usize::from(power.starts_with(['+', '-']));
    match digits(&power[signs..]) {
        0 => plain,
        length => plain + 1 + signs + length,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use symspline::Scalar;

    #[test]
    fn words_and_their_places() {
        let found = tokens(" P0+1.5e-1*α(x_1)").unwrap();
        let words: Vec<String> = found.iter().map(|(token, _)| token.describe()).collect();
        assert_eq!(words, ["'P0'", "'+'", "a number", "'*'", "'α'", "'('", "'x_1'", "')'", "the end"]);
        assert_eq!(found[2], (Token::Number(Q::frac(3, 20)), 4..10));
        assert_eq!(tokens("2E+3").unwrap()[0], (Token::Number(Q::int(2000)), 0..4));
    }

    #[test]
    fn what_means_nothing_is_refused_where_it_stands() {
        assert_eq!(tokens("1 + $").unwrap_err().span, 4..5);
        assert_eq!(tokens("1.2.3").unwrap_err().span, 0..5);
        assert_eq!(tokens("2 * .").unwrap_err().span, 4..5);
    }
}
