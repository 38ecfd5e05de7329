//! What is wrong with an expression, and which characters of it are meant.

use std::fmt;
use std::ops::Range;

/// What is wrong with a part of an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complaint {
    /// The bytes of the expression that are meant.
    pub span: Range<usize>,
    /// What is wrong.
    pub problem: String,
    /// Whether the expression is not understood; else it is, but a part of it has no value.
    pub is_grammar: bool,
    /// The expression, once it is known.
    pub text: String,
}

impl Complaint {
    /// That the expression is not understood here.
    pub fn grammar(span: Range<usize>, problem: impl Into<String>) -> Self {
        Self { span, problem: problem.into(), is_grammar: true, text: String::new() }
    }

    /// That this part has no value.
    pub fn value(span: Range<usize>, problem: impl Into<String>) -> Self {
        Self { is_grammar: false, ..Self::grammar(span, problem) }
    }

    /// The same about this text.
    pub fn about(self, text: &str) -> Self {
        Self { text: text.to_owned(), ..self }
    }

    /// Line and column of the first character that is meant, from 1.
    pub fn place(&self) -> (usize, usize) {
        let before = self.before();
        let line = before.matches('\n').count() + 1;
        (line, before.chars().rev().take_while(|c| *c != '\n').count() + 1)
    }

    fn before(&self) -> &str {
        self.text.get(..self.span.start).unwrap_or(&self.text)
    }

    /// The line that is meant, and below it marks under the characters.
    pub fn marked(&self) -> String {
        let (line, column) = self.place();
        let shown = self.text.lines().nth(line - 1).unwrap_or_default();
        let meant = self.text.get(self.span.clone()).unwrap_or_default();
        let width = meant.lines().next().unwrap_or_default().chars().count().max(1);
        // A tab is shown as one blank, so that the marks stand where they should.
        let shown: String = shown.chars().map(|c| if c == '\t' { ' ' } else { c }).collect();
        format!("  {shown}\n  {}{}", " ".repeat(column - 1), "^".repeat(width))
    }
}

/// One line: the place, and what is wrong.
impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (line, column) = self.place();
        write!(f, "expression:{line}:{column}: {}", self.problem)
    }
}

impl std::error::Error for Complaint {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_stand_under_characters_not_bytes() {
        let complaint = Complaint::grammar(5..7, "no").about("α +\nβγ");
        assert_eq!(complaint.place(), (2, 1));
        let complaint = Complaint::grammar(7..9, "no").about("α +\nβγ");
        assert_eq!(complaint.marked(), "  βγ\n   ^");
        assert_eq!(complaint.to_string(), "expression:2:2: no");
    }
}
