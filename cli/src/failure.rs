//! Why a command fails, and the exit code that says so.

use crate::calc::complaint::Complaint;
use symspline_files::{FileError, Problem};

/// The result of a step of a command.
pub type Result<T> = std::result::Result<T, Failure>;

/// Why a command fails.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// A file that was not read or not written.
    #[error(transparent)]
    File(FileError),
    /// The library refused; the place is the file, and the entry if it holds several, or nothing.
    #[error("{place}{}{problem}", if place.is_empty() { "" } else { ": " })]
    Refused {
        /// The place.
        place: String,
        /// What is wrong.
        problem: String,
    },
    /// Arguments that do not go together.
    #[error("{0}")]
    Usage(String),
    /// An expression that is not understood, or a part of it that has no value.
    #[error(transparent)]
    Expression(Complaint),
    /// Standard input or output failed.
    #[error("{file}: {error}")]
    Io {
        /// What failed.
        file: &'static str,
        /// How.
        error: std::io::Error,
    },
    /// Nobody reads what is written: not worth a word.
    #[error("nobody reads the output")]
    Closed,
}

impl Failure {
    /// A refusal in the words of the command.
    pub fn refused(problem: impl ToString) -> Self {
        Self::Refused { place: String::new(), problem: problem.to_string() }
    }

    /// The same failure, of what is at this place, unless it has one.
    pub fn at(self, name: &str) -> Self {
        match self {
            Self::Refused { place, problem } if place.is_empty() => {
                Self::Refused { place: name.to_owned(), problem }
            }
            other => other,
        }
    }

    /// The exit code: 1 the library refused, 2 usage, 3 input or output, 4 contents of files or grammar.
    pub fn code(&self) -> u8 {
        match self {
            Self::Refused { .. } => 1,
            Self::File(error) => match *error.problem {
                Problem::Syntax(_) | Problem::Value(_) => 4,
                Problem::NoRoom { .. } => 1,
                Problem::NoText => 2,
                _ => 3,
            },
            Self::Usage(_) => 2,
            Self::Expression(complaint) if complaint.is_grammar => 4,
            Self::Expression(_) => 1,
            Self::Io { .. } => 3,
            Self::Closed => 0,
        }
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        Self::File(error)
    }
}

impl From<symspline_dynamic::Error> for Failure {
    fn from(error: symspline_dynamic::Error) -> Self {
        Self::refused(error)
    }
}

impl From<symspline::Error> for Failure {
    fn from(error: symspline::Error) -> Self {
        Self::refused(error)
    }
}
