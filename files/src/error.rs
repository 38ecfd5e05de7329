//! What is wrong with a file, and where.

use std::fmt;

/// The result of reading or writing.
pub type Result<T> = std::result::Result<T, FileError>;

/// What is wrong with a file, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}{place}: {problem}", if file.is_empty() { "input" } else { file })]
pub struct FileError {
    /// The file, as it was named; empty if it was not.
    pub file: String,
    /// The place in it.
    pub place: Place,
    /// What is wrong.
    pub problem: Box<Problem>,
}

/// A place in a file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// The file as a whole.
    #[default]
    File,
    /// A line, counted from 1, and a column in letters from 1, or 0 if the line as a whole is meant.
    Line {
        /// The line.
        line: usize,
        /// The column.
        column: usize,
    },
    /// A byte, counted from 0.
    Byte(usize),
    /// An entry, counted from 0, or what stands for one: an entity `#12`, a glyph.
    Entry(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line { line, column: 0 } => write!(f, ":{line}"),
            Self::Line { line, column } => write!(f, ":{line}:{column}"),
            Self::Byte(at) => write!(f, ": byte {at}"),
            Self::Entry(name) => write!(f, ": {name}"),
        }
    }
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The operating system refused.
    #[error("{0}")]
    Io(String),
    /// More bytes than are read.
    #[error("more than {limit} bytes")]
    TooLarge {
        /// How many are read.
        limit: u64,
    },
    /// Nothing tells the format.
    #[error("no format is known by this name; these are: {known}")]
    UnknownFormat {
        /// The endings that are known.
        known: String,
    },
    /// The format is not read, or not written.
    #[error("{format} files are not {verb}")]
    OneWay {
        /// The format.
        format: &'static str,
        /// "read" or "written".
        verb: &'static str,
    },
    /// A font holds letters, not curves: a text must say which.
    #[error("a font holds letters, not curves: a text must tell which (`font::outlines`, `--text`)")]
    NoText,
    /// The text is not of the format: what was met or expected.
    #[error("{0}")]
    Syntax(String),
    /// The numbers do not make what they should.
    #[error(transparent)]
    Value(#[from] symspline_dynamic::Error),
    /// The format has no room for this value.
    #[error("{format} files hold no {value}")]
    NoRoom {
        /// The format.
        format: &'static str,
        /// The value, in words.
        value: String,
    },
}

impl Problem {
    /// This problem at a place, in a file that is not named yet.
    pub fn at(self, place: Place) -> FileError {
        FileError { file: String::new(), place, problem: Box::new(self) }
    }

    /// This problem in a line.
    pub fn at_line(self, line: usize) -> FileError {
        self.at(Place::Line { line, column: 0 })
    }

    /// This problem of the file as a whole.
    pub fn of_file(self) -> FileError {
        self.at(Place::File)
    }
}

impl From<symspline::Error> for Problem {
    fn from(error: symspline::Error) -> Self {
        Self::Value(error.into())
    }
}

impl FileError {
    /// The same error, of a file with this name.
    pub(crate) fn named(mut self, file: &str) -> Self {
        if self.file.is_empty() {
            self.file = file.to_owned();
        }
        self
    }
}
