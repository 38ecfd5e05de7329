//! An expression as a tree.

use std::ops::Range;
use symspline::Q;

/// A part of an expression, and the bytes it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The bytes.
    pub span: Range<usize>,
    /// What it is.
    pub kind: Kind,
}

/// What a part of an expression is.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A number.
    Number(Q),
    /// A name that stands for a value.
    Name(String),
    /// A point of numbers.
    Point(Vec<Node>),
    /// The negative.
    Negative(Box<Node>),
    /// Operators of one rank, from left to right. A list, not a tree of pairs: its depth is that of parentheses, however long it is.
    Chain(Box<Node>, Vec<(Operator, Node)>),
    /// A function of arguments.
    Call {
        /// The function.
        name: String,
        /// The arguments.
        arguments: Vec<Node>,
    },
}

/// An operator between two parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `+`
    Sum,
    /// `-`
    Difference,
    /// `*`
    Product,
    /// `/`
    Quotient,
    /// `@`
    Composition,
}
