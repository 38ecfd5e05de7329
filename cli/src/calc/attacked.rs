//! No text makes the evaluator panic, hang or fill the memory.
//!
//! Expressions are changed at random, from a fixed seed, for `SYMSPLINE_FUZZ_SECONDS`, 2 unless told.

use crate::calc::evaluate::{Names, evaluate};
use crate::calc::functions::FUNCTIONS;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use symspline_dynamic::Value;
use symspline_files::{Entry, Format, Problem, from_bytes, to_bytes};

/// How long an answer may take, in this profile and on a busy machine.
const PATIENCE: Duration = Duration::from_secs(20);

/// What is changed: each function of expressions stands in one of them.
const SEEDS: [&str; 16] = [
    "P0 + integral(alpha * diff(C))",
    "at(C, 0) + integral(a * diff(float(C), 2), 1/3, 2.5e-1)",
    "same(diff(C @ (t / 2)), 1/2 * diff(C) @ (t / 2))",
    "inner(C, reverse(C)) + dot((1, 2), (3, -4)) * cross((1, 2), (3, 4))",
    "reduce(elevate(uniform(2, 1, 3, 2, 5), 3), 2)",
    "simplify(insert(C, 1/7, 5/6)) - clamp(C)",
    "join(restrict(C, 0, 1/2), restrict(C, 1/2, 1))",
    "curve(x(C), coord(C, 1)) / (1 + t * t)",
    "same(rational(C, 1 + t), rational(C)) + same(t, t)",
    "polynomial(rational(C, 1 + t * t), 1e-3)",
    "cross(du(S), dv(S)) + abs2(S) * S",
    "at(iso_u(S, 1/2), 1/3) - at(S, 1/2, 1/3) + at(iso_v(transpose(S), 1/2), 1/3)",
    "z(S @ curve(param(0, 1), param(0, 1))) + compose(t, t)",
    "length(C) + float(1/3) * 2 - exact(float(0.1))",
    "bezier((0, 0), (1, 2), (2, 0)) - const((1, 2), 0, 1)",
    "reparam(-y(reparam(C, 0, 3)), 0, 1) * R / abs2(1 + t) ",
];

/// What is put in: small parts of expressions, and what should not be there.
const PIECES: [&str; 40] = [
    "2^999999999",
    "1e999999999",
    "1e400",
    "1e-400",
    "1e308",
    "99999999999999999999/7",
    "0",
    "1",
    "-1",
    "1/2",
    "0.1",
    "512",
    "1000000",
    "18446744073709551616",
    "NaN",
    "(",
    ")",
    ",",
    "+",
    "-",
    "*",
    "/",
    "@",
    "C",
    "S",
    "t",
    "R",
    "alpha",
    "P0",
    "M",
    "α",
    "🙂",
    "\u{202e}",
    "\u{301}",
    "\n",
    "\t",
    "\0",
    "abs2(",
    "t @ ",
    "float(",
];

/// One change of a text, drawn as numbers: what is done, where, and with what.
type Change = (u8, prop::sample::Index, prop::sample::Index, prop::sample::Index);

fn changed(text: &str, other: &str, (what, from, to, piece): &Change) -> String {
    let ends: Vec<usize> = text.char_indices().map(|(at, _)| at).chain([text.len()]).collect();
    let (a, b) = (ends[from.index(ends.len())], ends[to.index(ends.len())]);
    let (a, b) = (a.min(b), a.max(b));
    let piece_text = *piece.get(&PIECES);
    match what {
        0 => format!("{}{}", &text[..a], &text[b..]),
        1 => format!("{}{}", &text[..b], &text[a..]),
        2 => text[..a].to_owned(),
        3 => format!("{}{}{}", &text[..a], piece_text.repeat(1 << (b - a).min(12)), &text[a..]),
        4 => format!("{}({other}){}", &text[..a], &text[a..]),
        5 => format!("{}({text})", piece.get(&FUNCTIONS).name),
        6 => format!("({text}) @ ({other})"),
        7 => format!("({text}) * ({other})"),
        _ => format!("{}{piece_text}{}", &text[..a], &text[a..]),
    }
}

fn texts() -> impl Strategy<Value = String> {
    let place = any::<prop::sample::Index>;
    let change = (0..14_u8, place(), place(), place());
    (place(), place(), prop::collection::vec(change, 0..5)).prop_map(|(seed, other, changes)| {
        let other = other.get(&SEEDS);
        changes.iter().fold((*seed.get(&SEEDS)).to_owned(), |text, change| changed(&text, other, change))
    })
}

fn names() -> Names {
    let bound = [
        ("P0", "(1/2, -1)"),
        ("t", "param(0, 1)"),
        ("alpha", "uniform(2, 1, 3/2, 2, 1)"),
        ("a", "float(uniform(1, 1, 1.5, 1))"),
        ("C", "uniform(3, (0, 0), (1, 2), (3, 3), (5, 3), (7, 2))"),
        ("R", "1 / (1 + param(0, 1))"),
    ];
    let values = bound.map(|(name, text)| (name.to_owned(), evaluate(text, &Names::new()).unwrap().0));
    let rest = br#"{"format": "symspline", "version": 1, "items": [
        {"name": "S", "value": {"surface": {"field": "exact", "u": {"degree": 1, "knots": [0, 0, 1, 1]},
            "v": {"degree": 1, "knots": [0, 0, 1, 1]}, "points": [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 1]]}}},
        {"name": "M", "value": {"mesh": {"field": "float", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]]}}}]}"#;
    let rest = from_bytes(rest, Format::Json).unwrap();
    values.into_iter().chain(rest.into_iter().map(|entry| (entry.name.unwrap(), entry.value))).collect()
}

/// Whether there is a value; it can be written and read again. If there is none, the complaint is about a part of the text.
fn holds(text: &str, names: &Names) -> bool {
    match evaluate(text, names) {
        Ok((value, notes)) => {
            assert!(notes.iter().all(|note| !note.is_empty()));
            is_written(value);
            true
        }
        Err(complaint) => {
            assert!(text.get(complaint.span.clone()).is_some(), "{:?}", complaint.span);
            assert!(!complaint.problem.is_empty());
            assert_eq!(complaint.marked().lines().count(), 2);
            false
        }
    }
}

fn is_written(value: Value) {
    let entries = [Entry::from(value)];
    match to_bytes(&entries, Format::Json) {
        Ok(bytes) => assert_eq!(from_bytes(&bytes, Format::Json).unwrap(), entries),
        Err(error) => {
            assert!(matches!(*error.problem, Problem::Value(_) | Problem::NoRoom { .. }), "{error}");
        }
    }
}

#[test]
fn each_function_is_attacked() {
    let missing: Vec<&str> = FUNCTIONS
        .iter()
        .map(|f| f.name)
        .filter(|name| !SEEDS.concat().contains(&format!("{name}(")))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
    let names = names();
    for seed in SEEDS {
        assert!(holds(seed, &names), "{seed}: {:?}", evaluate(seed, &names));
    }
}

#[test]
fn no_text_makes_the_evaluator_panic() {
    let seconds = std::env::var("SYMSPLINE_FUZZ_SECONDS").map_or(2, |text| text.parse().unwrap());
    let end = Instant::now() + Duration::from_secs(seconds);
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let (mut runner, names) = (TestRunner::new_with_rng(ProptestConfig::default(), rng), names());
    let (mut count, mut accepted) = (0, 0);
    while Instant::now() < end {
        let text = texts().new_tree(&mut runner).unwrap().current();
        let start = Instant::now();
        let held = catch_unwind(AssertUnwindSafe(|| holds(&text, &names)));
        let spent = start.elapsed();
        let Ok(held) = held else { panic!("case {count} fails: {text:?}") };
        assert!(spent < PATIENCE, "case {count} took {spent:?}: {text:?}");
        (count, accepted) = (count + 1, accepted + usize::from(held));
    }
    // Changes that all are refused would show little.
    assert!(accepted * 50 > count, "{accepted} of {count} have values");
    eprintln!("{accepted} of {count} changed expressions have values");
}

#[test]
fn what_is_nested_long_or_huge_is_answered_at_once() {
    let names = names();
    let texts = [
        "(".repeat(100_000),
        "abs2(".repeat(100_000),
        format!("{}7{}", "abs2(".repeat(60), ")".repeat(60)),
        format!("{}7{}", "abs2((1/3, ".repeat(30), "))".repeat(30)),
        format!("{}C{}", "abs2(".repeat(60), ")".repeat(60)),
        format!("{}S{}", "dot(S, ".repeat(60), ")".repeat(60)),
        "t @ ".repeat(50_000) + "t",
        "abs2(t) @ ".repeat(64) + "t",
        vec!["1e400"; 5000].join(" * "),
        "9".repeat(100_000),
        format!("elevate(C, {})", "9".repeat(400)),
        "diff(C, 1e6)".to_owned(),
        "2^999999999".to_owned(),
        "1e999999999".to_owned(),
        "float(1e400) * t".to_owned(),
        "\u{202e}α🙂".repeat(1000),
    ];
    for text in texts {
        let start = Instant::now();
        holds(&text, &names);
        assert!(
            start.elapsed() < PATIENCE,
            "{:?}: {}",
            start.elapsed(),
            text.chars().take(40).collect::<String>()
        );
    }
}
