//! From words to a tree, by recursive descent with a bounded depth.

use crate::calc::complaint::Complaint;
use crate::calc::tokens::{Token, tokens};
use crate::calc::tree::{Kind, Node, Operator};
use std::ops::Range;

/// How deep parentheses nest at most.
pub const MAX_DEPTH: usize = 64;

/// The ranks of operators, from the loosest.
const RANKS: [&[(char, Operator)]; 3] = [
    &[('+', Operator::Sum), ('-', Operator::Difference)],
    &[('*', Operator::Product), ('/', Operator::Quotient)],
    &[('@', Operator::Composition)],
];

type Parsed<T> = Result<T, Complaint>;

/// The tree of an expression.
///
/// # Errors
/// A [`Complaint`] at the first word that is not expected.
pub fn parse(text: &str) -> Parsed<Node> {
    let parse = || {
        let mut parser = Parser { tokens: tokens(text)?, next: 0, depth: 0 };
        let tree = parser.ranked(0)?;
        match parser.peek() {
            Token::End => Ok(tree),
            _ => Err(parser.unexpected("an operator or the end")),
        }
    };
    parse().map_err(|complaint| complaint.about(text))
}

struct Parser {
    tokens: Vec<(Token, Range<usize>)>,
    next: usize,
    depth: usize,
}

impl Parser {
    fn peek(&self) -> &Token {
        &self.tokens[self.next].0
    }

    fn span(&self) -> Range<usize> {
        self.tokens[self.next].1.clone()
    }

    /// The next word; the end stays.
    fn take(&mut self) -> (Token, Range<usize>) {
        let taken = self.tokens[self.next].clone();
        self.next = (self.next + 1).min(self.tokens.len() - 1);
        taken
    }

    fn takes(&mut self, symbol: char) -> bool {
        let met = *self.peek() == Token::Symbol(symbol);
        if met {
            self.take();
        }
        met
    }

    fn unexpected(&self, wanted: &str) -> Complaint {
        Complaint::grammar(self.span(), format!("{wanted} is expected, not {}", self.peek().describe()))
    }

    /// Operators of a rank and above.
    fn ranked(&mut self, rank: usize) -> Parsed<Node> {
        let Some(operators) = RANKS.get(rank) else { return self.atom() };
        let operand = |parser: &mut Self| if rank == 1 { parser.negative() } else { parser.ranked(rank + 1) };
        let first = operand(self)?;
        let mut others = Vec::new();
        while let Token::Symbol(symbol) = *self.peek()
            && let Some((_, operator)) = operators.iter().find(|(sign, _)| *sign == symbol)
        {
            self.take();
            others.push((*operator, operand(self)?));
        }
        let Some((_, last)) = others.last() else { return Ok(first) };
        let span = first.span.start..last.span.end;
        Ok(Node { span, kind: Kind::Chain(Box::new(first), others) })
    }

    /// Signs, then compositions. Signs cancel in pairs, so a row of them is not deep.
    fn negative(&mut self) -> Parsed<Node> {
        let start = self.span().start;
        let mut signs = 0;
        while self.takes('-') {
            signs += 1;
        }
        let inner = self.ranked(2)?;
        if signs % 2 == 0 {
            return Ok(inner);
        }
        Ok(Node { span: start..inner.span.end, kind: Kind::Negative(Box::new(inner)) })
    }

    fn atom(&mut self) -> Parsed<Node> {
        let wanted = "a number, a name or '('";
        match self.peek().clone() {
            Token::Number(x) => Ok(Node { span: self.take().1, kind: Kind::Number(x) }),
            Token::Name(name) => {
                let span = self.take().1;
                if *self.peek() != Token::Symbol('(') {
                    return Ok(Node { span, kind: Kind::Name(name) });
                }
                let (arguments, end) = self.parenthesised(true)?;
                Ok(Node { span: span.start..end, kind: Kind::Call { name, arguments } })
            }
            Token::Symbol('(') => {
                let start = self.span().start;
                let (mut inner, end) = self.parenthesised(false)?;
                match inner.len() {
                    1 => Ok(inner.remove(0)),
                    _ => Ok(Node { span: start..end, kind: Kind::Point(inner) }),
                }
            }
            _ => Err(self.unexpected(wanted)),
        }
    }

    /// What is in parentheses, with commas between, and where they end.
    fn parenthesised(&mut self, may_be_empty: bool) -> Parsed<(Vec<Node>, usize)> {
        let open = self.take().1;
        if self.depth == MAX_DEPTH {
            return Err(Complaint::grammar(open, format!("parentheses nest deeper than {MAX_DEPTH}")));
        }
        self.depth += 1;
        let mut inner = Vec::new();
        if !(may_be_empty && *self.peek() == Token::Symbol(')')) {
            inner.push(self.ranked(0)?);
            while self.takes(',') {
                inner.push(self.ranked(0)?);
            }
        }
        self.depth -= 1;
        let end = self.span().end;
        if self.takes(')') { Ok((inner, end)) } else { Err(self.unexpected("',' or ')'")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The tree with all parentheses written.
    fn written(node: &Node) -> String {
        let list = |nodes: &[Node]| nodes.iter().map(written).collect::<Vec<_>>().join(", ");
        match &node.kind {
            Kind::Number(x) => x.to_string(),
            Kind::Name(name) => name.clone(),
            Kind::Point(nodes) => format!("({})", list(nodes)),
            Kind::Negative(inner) => format!("(-{})", written(inner)),
            Kind::Chain(first, others) => others.iter().fold(written(first), |left, (operator, right)| {
                let sign = RANKS.concat().iter().find(|(_, o)| o == operator).unwrap().0;
                format!("({left}{sign}{})", written(right))
            }),
            Kind::Call { name, arguments } => format!("{name}({})", list(arguments)),
        }
    }

    #[test]
    fn ranks_and_order() {
        let shape = |text: &str| written(&parse(text).unwrap());
        assert_eq!(shape("a - b - c * d / e"), "((a-b)-((c*d)/e))");
        assert_eq!(shape("-f @ g @ h * --x"), "((-((f@g)@h))*x)");
        assert_eq!(shape("a - -b"), "(a-(-b))");
        assert_eq!(shape("(1, 2/3, f(x, (y)))"), "(1, (2/3), f(x, y))");
        assert_eq!(shape("f()"), "f()");
    }

    #[test]
    fn complaints_point_at_the_word() {
        let at = |text: &str| {
            let complaint = parse(text).unwrap_err();
            assert!(complaint.is_grammar);
            (complaint.span, complaint.problem)
        };
        assert_eq!(at("1 + ").0, 4..4);
        assert_eq!(at("f(a b)").0, 4..5);
        assert_eq!(at("a b").0, 2..3);
        assert_eq!(at("(1, )").0, 4..5);
        assert_eq!(at("()").0, 1..2);
        assert_eq!(at("f(x").1, "',' or ')' is expected, not the end");
        assert_eq!(at("2 @ -x").0, 4..5);
    }

    #[test]
    fn depth_is_bounded_and_length_is_not_depth() {
        let nested = |n: usize| format!("{}1{}", "(".repeat(n), ")".repeat(n));
        assert!(parse(&nested(MAX_DEPTH)).is_ok());
        assert_eq!(parse(&nested(MAX_DEPTH + 1)).unwrap_err().span, MAX_DEPTH..MAX_DEPTH + 1);
        assert!(parse(&"f(".repeat(100_000)).is_err());
        assert!(parse(&format!("{}1", "-".repeat(100_001))).is_ok());
        assert!(parse(&format!("1{}", "+1".repeat(100_000))).is_ok());
    }

    proptest! {
        #[test]
        fn nothing_panics_and_places_are_inside(text in "[-+*/@(),.0-9a-cα \n]{0,40}") {
            if let Err(complaint) = parse(&text) {
                prop_assert!(complaint.span.end <= text.len());
                complaint.marked();
            }
        }

        #[test]
        fn what_is_written_out_is_read_the_same(text in "[-+*/@(),0-9a-c]{0,12}") {
            if let Ok(tree) = parse(&text) {
                let full = written(&tree);
                prop_assert_eq!(written(&parse(&full).unwrap()), full);
            }
        }
    }
}
