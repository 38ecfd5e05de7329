//! The value of a tree.

use crate::calc::arguments::{Arguments, Refusal, gathered};
use crate::calc::complaint::Complaint;
use crate::calc::construct::quotient;
use crate::calc::functions::{FUNCTIONS, Function, composed};
use crate::calc::parser::parse;
use crate::calc::size;
use crate::calc::tree::{Kind, Node, Operator};
use std::collections::BTreeMap;
use symspline_dynamic::{Number, Value};

/// What names stand for.
pub type Names = BTreeMap<String, Value>;

/// The value of an expression, and remarks on it.
///
/// # Errors
/// A [`Complaint`] about the smallest part that is not understood or has no value.
pub fn evaluate(text: &str, names: &Names) -> Result<(Value, Vec<String>), Complaint> {
    let tree = parse(text)?;
    let mut evaluator = Evaluator { names, notes: Vec::new() };
    let value = evaluator.value(&tree).map_err(|complaint| complaint.about(text))?;
    Ok((value, evaluator.notes))
}

struct Evaluator<'a> {
    names: &'a Names,
    notes: Vec<String>,
}

impl Evaluator<'_> {
    fn value(&mut self, node: &Node) -> Result<Value, Complaint> {
        let here = |problem: String| Complaint::value(node.span.clone(), problem);
        match &node.kind {
            Kind::Number(x) => Ok(Number::Exact(x.clone()).into()),
            Kind::Name(name) => match self.names.get(name) {
                Some(value) => Ok(value.clone()),
                None => Err(here(unknown("name", name, self.names.keys().map(String::as_str)))),
            },
            Kind::Point(nodes) => {
                let values = nodes.iter().map(|node| match self.value(node)? {
                    Value::Number(x) => Ok(x),
                    other => {
                        let problem = format!("coordinates are numbers, this is a {}", other.kind());
                        Err(Complaint::value(node.span.clone(), problem))
                    }
                });
                let numbers = values.collect::<Result<Vec<Number>, _>>()?;
                let coords = gathered(&numbers.iter().collect::<Vec<_>>());
                Ok(coords.map_err(|error| here(error.to_string()))?.into())
            }
            Kind::Negative(inner) => self.value(inner)?.negated().map_err(|error| here(error.to_string())),
            Kind::Chain(first, others) => {
                let mut left = self.value(first)?;
                for (operator, node) in others {
                    let right = self.value(node)?;
                    left = applied(*operator, &left, &right)
                        .map_err(|refusal| refusal.problem)
                        .and_then(not_too_large)
                        .map_err(|problem| Complaint::value(first.span.start..node.span.end, problem))?;
                }
                Ok(left)
            }
            Kind::Call { name, arguments } => self.call(node, name, arguments),
        }
    }

    fn call(&mut self, node: &Node, name: &str, nodes: &[Node]) -> Result<Value, Complaint> {
        let here = |problem: String| Complaint::value(node.span.clone(), problem);
        let Some(function) = FUNCTIONS.iter().find(|function| function.name == name) else {
            let span = node.span.start..node.span.start + name.len();
            return Err(Complaint::value(span, unknown("function", name, FUNCTIONS.iter().map(|f| f.name))));
        };
        let (least, most) = function.counts;
        if !(least..=most).contains(&nodes.len()) {
            let Function { name, usage, .. } = function;
            return Err(here(format!("{name}({usage}) is expected, not {} arguments", nodes.len())));
        }
        let values = nodes.iter().map(|node| self.value(node)).collect::<Result<Vec<_>, _>>()?;
        let mut arguments = Arguments::new(&values);
        let given = (function.apply)(&mut arguments);
        self.notes.append(&mut arguments.notes);
        let value = given.map_err(|Refusal { argument, problem }| {
            let span = argument.and_then(|i| nodes.get(i)).unwrap_or(node).span.clone();
            Complaint::value(span, problem)
        })?;
        not_too_large(value).map_err(here)
    }
}

/// The value, if it is small enough to go on with.
fn not_too_large(value: Value) -> Result<Value, String> {
    size::check(&value)?;
    Ok(value)
}

fn applied(operator: Operator, left: &Value, right: &Value) -> Result<Value, Refusal> {
    Ok(match operator {
        Operator::Sum => left.sum(right)?,
        Operator::Difference => left.difference(right)?,
        Operator::Product => left.product(right)?,
        Operator::Quotient => return quotient(left, right),
        Operator::Composition => return composed(left, right),
    })
}

/// That there is no such name, and which there are.
fn unknown<'a>(what: &str, name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    match known.is_empty() {
        true => format!("there is no {what} '{name}': bind one with --let {name}=FILE"),
        false => format!("there is no {what} '{name}'; there is {}", known.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> String {
        match evaluate(text, &Names::new()) {
            Ok((value, _)) => value.to_string(),
            Err(complaint) => format!("{:?} {complaint}", complaint.span),
        }
    }

    #[test]
    fn numbers_and_points() {
        assert_eq!(shown("1/3 + 1/6 - -0.5"), "exact number 1");
        assert_eq!(shown("2 * (1, 2/3) - (0, 1)"), "exact point (2, 1/3)");
        assert_eq!(shown("y((4, 5, 6))"), "exact number 5");
        assert_eq!(shown("float(1/4) + 1/4"), "float number 0.5");
        assert_eq!(shown("dot((1, 2), (3, 4))"), "exact number 11");
        assert_eq!(shown("dot(3, 1/6)"), "exact number 1/2");
        assert_eq!(shown("abs2(float(3))"), "float number 9");
        assert_eq!(shown("cross((1, 2), (3, 4))"), "exact number -2");
        assert_eq!(shown("cross((1, 0, 0), float(1) * (0, 1, 0))"), "float point (0, 0, 1)");
    }

    #[test]
    fn values_from_closed_forms() {
        // x² on [0, 1] is the Bezier function 0, 0, 1.
        assert_eq!(shown("at(bezier(0, 0, 1), 2/3)"), "exact number 4/9");
        assert_eq!(shown("integral(bezier(0, 0, 1), 0, 1)"), "exact number 1/3");
        assert_eq!(shown("same(bezier(0, 0, 1), param(0, 1) * param(0, 1))"), "exact number 1");
        assert_eq!(shown("at(param(0, 4) @ (2 * param(0, 1) + 1), 1/2)"), "exact number 2");
        assert_eq!(shown("at(curve(param(0, 1), 3 * param(0, 1)), 1/3)"), "exact point (1/3, 1)");
        assert_eq!(shown("length(bezier((0, 0), (3, 4)))"), "float number 5");
        assert_eq!(shown("at(diff(param(0, 1) * param(0, 1) * param(0, 1), 2), 1/2)"), "exact number 3");
        assert_eq!(shown("at(const((1, 2), 0, 3), 1)"), "exact point (1, 2)");
        assert_eq!(shown("at(1 / (1 + param(0, 1)), 1/2)"), "exact number 2/3");
        // The unit circle in the first quadrant: at t = 1/3 of ((1 - t²)/(1 + t²), 2t/(1 + t²)) it is (4/5, 3/5).
        let t = "param(0, 1)";
        let quarter = format!("curve(1 - {t} * {t}, 2 * {t}) / (1 + {t} * {t})");
        assert_eq!(shown(&format!("at({quarter}, 1/3)")), "exact point (4/5, 3/5)");
        assert_eq!(shown(&format!("same(abs2({quarter}), const(1, 0, 1))")), "exact number 1");
    }

    #[test]
    fn complaints_point_at_the_smallest_part() {
        assert!(shown("1 + intgral(2)").starts_with("4..11 expression:1:5: there is no function 'intgral'"));
        assert!(shown("1 + alpha").starts_with("4..9 "));
        assert!(shown("2 * (1 / 0)").starts_with("5..10 expression:1:6: division by zero"));
        assert!(shown("at(param(0, 1), 1 + 1)").starts_with("0..22 "));
        assert!(shown("diff(param(0, 1), 1/2)").starts_with("18..21 "));
        assert!(shown("1 + diff(7)").starts_with("9..10 "));
        assert!(
            shown("at(1)")
                .starts_with("0..5 expression:1:1: at(f, x | S, u, v) is expected, not 1 arguments")
        );
        assert!(shown("(1, (2, 3))").starts_with("4..10 "));
        assert!(
            shown("const(1, 0, 1) + const(float(1), 0, 1)").contains("exact and float values do not mix")
        );
    }
}
