//! Instances: their parts and parameters.

use crate::error::Problem;
use crate::nurbs::real::{self, shown};
use crate::step::scan::{Scanner, Token};

/// How deep brackets may stand in brackets.
pub(super) const DEEPEST: usize = 64;

type Read<T> = Result<T, Problem>;

/// A parameter of an instance.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Parameter<'a> {
    Whole(i64),
    Real(f64),
    Text(&'a [u8]),
    Enumeration(&'a str),
    Reference(u64),
    List(Vec<Self>),
    /// What is of no use here: a binary, `$`, `*`, or a value with its type.
    Other,
}

/// One part of an instance: the name of a type, and the parameters.
pub(super) type Part<'a> = (&'a str, Vec<Parameter<'a>>);

pub(super) fn wrong<T>(what: impl Into<String>) -> Read<T> {
    Err(Problem::Syntax(what.into()))
}

/// The parts of the instance after its sign `=`: one, or those between brackets.
pub(super) fn parts<'a>(scanner: &mut Scanner<'a>) -> Read<Vec<Part<'a>>> {
    let mut all = Vec::new();
    match word(scanner)? {
        Token::Word(name) => all.push((name, list_after(scanner)?)),
        Token::Sign(b'(') => loop {
            match word(scanner)? {
                Token::Word(name) => all.push((name, list_after(scanner)?)),
                Token::Sign(b')') => break,
                other => return wrong(format!("the name of a type was expected, not {}", other.shown())),
            }
        },
        other => return wrong(format!("the name of a type was expected, not {}", other.shown())),
    }
    Ok(all)
}

fn word<'a>(scanner: &mut Scanner<'a>) -> Read<Token<'a>> {
    scanner.next().map_err(|error| *error.problem)
}

fn list_after<'a>(scanner: &mut Scanner<'a>) -> Read<Vec<Parameter<'a>>> {
    match word(scanner)? {
        Token::Sign(b'(') => list(scanner, 1),
        other => wrong(format!("'(' was expected, not {}", other.shown())),
    }
}

/// The parameters up to the bracket that closes.
fn list<'a>(scanner: &mut Scanner<'a>, depth: usize) -> Read<Vec<Parameter<'a>>> {
    if depth > DEEPEST {
        return wrong(format!("more than {DEEPEST} brackets stand in each other"));
    }
    let mut all = Vec::new();
    loop {
        let token = word(scanner)?;
        if token == Token::Sign(b')') && all.is_empty() {
            return Ok(all);
        }
        all.push(parameter(token, scanner, depth)?);
        match word(scanner)? {
            Token::Sign(b',') => {}
            Token::Sign(b')') => return Ok(all),
            other => return wrong(format!("',' or ')' was expected, not {}", other.shown())),
        }
    }
}

fn parameter<'a>(token: Token<'a>, scanner: &mut Scanner<'a>, depth: usize) -> Read<Parameter<'a>> {
    Ok(match token {
        Token::Reference(id) => Parameter::Reference(id),
        Token::Text(text) => Parameter::Text(text),
        Token::Enumeration(word) => Parameter::Enumeration(word),
        Token::Number(text) => match text.parse() {
            Ok(whole) => Parameter::Whole(whole),
            Err(_) => match real::read(text) {
                Some(x) => Parameter::Real(x),
                None => return wrong(format!("'{}' is not a finite number", shown(text))),
            },
        },
        Token::Sign(b'(') => Parameter::List(list(scanner, depth + 1)?),
        Token::Binary | Token::Sign(b'$' | b'*') => Parameter::Other,
        Token::Word(_) => match word(scanner)? {
            Token::Sign(b'(') => {
                list(scanner, depth + 1)?;
                Parameter::Other
            }
            other => return wrong(format!("'(' was expected, not {}", other.shown())),
        },
        Token::Sign(sign) => return wrong(format!("'{}' is not a parameter", char::from(sign))),
    })
}

impl<'a> Parameter<'a> {
    pub(super) fn real(&self) -> Read<f64> {
        match self {
            Self::Real(x) => Ok(*x),
            Self::Whole(n) => Ok(*n as f64),
            _ => wrong("a number was expected"),
        }
    }

    pub(super) fn size(&self) -> Read<usize> {
        match self {
            Self::Whole(n) => {
                usize::try_from(*n).or_else(|_| wrong(format!("{n} was not expected: it is negative")))
            }
            _ => wrong("a whole number was expected"),
        }
    }

    pub(super) fn list(&self) -> Read<&[Self]> {
        match self {
            Self::List(all) => Ok(all),
            _ => wrong("a list was expected"),
        }
    }

    pub(super) fn reals(&self) -> Read<Vec<f64>> {
        self.list()?.iter().map(Self::real).collect()
    }

    pub(super) fn sizes(&self) -> Read<Vec<usize>> {
        self.list()?.iter().map(Self::size).collect()
    }

    pub(super) fn reference(&self) -> Read<u64> {
        match self {
            Self::Reference(id) => Ok(*id),
            _ => wrong("a reference was expected"),
        }
    }

    pub(super) fn is_true(&self) -> bool {
        matches!(self, Self::Enumeration("T"))
    }
}
