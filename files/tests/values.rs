//! The JSON form brings every value back bit by bit.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod drawn;

use drawn::{bits, entries};
use proptest::prelude::*;
use symspline::{Q, Scalar, SplineSpace};
use symspline_dynamic::{AnyRational, Over, Value};
use symspline_files::{Entry, Format, Place, Problem, from_bytes, to_bytes};

proptest! {
    #[test]
    fn json_brings_every_value_back(entries in entries()) {
        let text = to_bytes(&entries, Format::Json).unwrap();
        let back = from_bytes(&text, Format::Json).unwrap();
        prop_assert_eq!(bits(&back), bits(&entries));
        prop_assert_eq!(to_bytes(&back, Format::Json).unwrap(), text);
    }

    #[test]
    fn json_cut_short_is_refused(entries in entries(), share in 0.0..1.0) {
        let text = to_bytes(&entries, Format::Json).unwrap();
        let kept = ((text.len() - 2) as f64 * share) as usize;
        let refused = from_bytes(&text[..kept], Format::Json).unwrap_err();
        prop_assert!(matches!(*refused.problem, Problem::Syntax(_)), "{}", refused);
    }
}

/// Homogeneous coordinates are written where points and weights would not do: weights of zero, and products that none gives.
#[test]
fn weights_of_zero_are_kept() {
    let space = SplineSpace::bezier(2, Q::int(0), Q::int(1)).unwrap();
    let half = [[1, 0, 1], [0, 1, 0], [-1, 0, 1]].concat().into_iter().map(Q::int).collect();
    let half = AnyRational::from_homogeneous(space.into(), 2, Over::Exact(half)).unwrap();
    let entry = Entry::named("half circle", half);
    let text = to_bytes(std::slice::from_ref(&entry), Format::Json).unwrap();
    assert!(String::from_utf8_lossy(&text).contains("\"weighted\":[[\"1\",\"0\",\"1\"],[\"0\",\"1\",\"0\"]"));
    assert_eq!(from_bytes(&text, Format::Json).unwrap(), [entry]);
}

#[test]
fn points_and_weights_are_written_where_they_do() {
    let space = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let (points, weights) = (Over::Float(vec![0.1, 0.7]), Over::Float(vec![0.3, 1.1]));
    let curve = AnyRational::new(space.into(), 1, points, weights).unwrap();
    let text = to_bytes(&[curve.into()], Format::Json).unwrap();
    assert!(String::from_utf8_lossy(&text).contains("\"points\":[[0.1],[0.7]],\"weights\":[0.3,1.1]"));
}

/// What is wrong with the form is a problem of syntax, with its line and column; with the numbers, one of its item.
#[test]
fn wrong_texts_say_where() {
    let wrong = |text: &str| from_bytes(text.as_bytes(), Format::Json).unwrap_err().to_string();
    let items = |items: &str| format!("{{\"format\":\"symspline\",\"version\":1,\n\"items\":[{items}]}}");
    assert_eq!(wrong("{\"format\":\n1e400}"), "input:2:5: number out of range");
    assert_eq!(wrong(&items("").replace('1', "2")), "input: version 2 is not known; up to 1 are");
    assert!(wrong(&items("{\"value\":{\"number\":\"1/0\"}}")).starts_with("input:2:"));
    let space = "\"space\":{\"degree\":1,\"knots\":[0,0,1,1]}";
    let torn = format!(
        "{{\"name\":\"a\",\"value\":{{\"spline\":{{\"field\":\"float\",{space},\"points\":[[1]]}}}}}}"
    );
    assert_eq!(wrong(&items(&torn)), "input: item 0 (a): 2 values are needed, 1 are given");
    let float = torn.replace("float", "exact").replace("[1]", "[0.5]");
    assert_eq!(wrong(&items(&float)), "input: item 0 (a): 0.5 is not exact: write a text \"p/q\"");
    let both = format!(
        "{{\"value\":{{\"rational\":{{\"field\":\"float\",{space},\"points\":[[1]],\"weighted\":[[1,1]]}}}}}}"
    );
    assert!(wrong(&items(&both)).contains("either \"points\""));
    let missing = from_bytes(items(&both).as_bytes(), Format::Json).unwrap_err();
    assert_eq!(missing.place, Place::Entry("item 0".into()));
    let number = from_bytes(items("{\"value\":{\"number\":-0}}").as_bytes(), Format::Json).unwrap();
    assert_eq!(number[0].value, Value::Number(Over::Float(0.0)));
}
