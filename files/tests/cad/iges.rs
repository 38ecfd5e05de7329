//! IGES.

use crate::{after, assert_near, at, plane};
use symspline::SplineSpace;
use symspline_dynamic::{AnySurface, Over, Value};
use symspline_files::{Entry, Format, from_bytes, to_bytes};

const BY_HAND: &str = include_str!("../corpus/iges/by_hand.igs");

#[test]
fn matrices_delimiters_ends_and_names_are_read() {
    let entries = from_bytes(BY_HAND.as_bytes(), Format::Iges).unwrap();
    assert_eq!(entries.len(), 4, "the curve in the parameters of a surface is passed over");
    let name = "a long name / with delimiters! that is broken at the end of a line 1H/";
    assert_eq!(entries[0].name.as_deref(), Some(name));
    // A quarter turn to the left and a shift by (10, 0, 0.5).
    assert_near(&at(&entries[0].value, 0.0), &[10.0, 0.0, 0.5]);
    assert_near(&at(&entries[0].value, 2.0), &[10.0, 3.0, 0.5]);
    assert!(
        matches!(&entries[0].value, Value::Rational(s) if s.weights() == Some(Over::Float(vec![1.0, 0.7, 2.0, 1.0])))
    );
    let Value::Surface(surface) = &entries[1].value else { panic!("{}", entries[1].value) };
    // Point number 2 j + i of the file is P_ij: at u = 1/4 a quarter from (0, 1, 2) to (3, 4, 5).
    let corner = surface.at(&Over::Float(0.25), &Over::Float(0.0)).unwrap();
    assert_eq!(corner, Over::Float(vec![0.75, 1.75, 2.75]));
    let far = surface.at(&Over::Float(0.25), &Over::Float(1.0)).unwrap();
    assert_eq!(far, Over::Float(vec![12.75, 13.75, 14.75]));
    assert_eq!(entries[2].value, plane(SplineSpace::clamped(1, [0.0, 1.0]).unwrap(), &[0.0, 0.0, 1.0, 2.0]));
    // The quarter of the unit circle in the plane z = 2, moved.
    assert_near(&at(&entries[3].value, 0.0), &[10.0, 1.0, 2.5]);
    assert_near(&at(&entries[3].value, 1.0), &[9.0, 0.0, 2.5]);
}

#[test]
fn what_is_wrong_is_told_with_the_line_or_the_entry_of_the_directory() {
    let first = "124/0./-1./0./10.";
    for (old, new, told) in [
        (
            "G      2\n",
            "G      3\n",
            "input:3: the number of the record, in columns 74 to 80, is out of sequence",
        ),
        ("D      1\n", "X      1\n", "input:4: column 73 has none of the letters"),
        ("S      1\n", "C      1\n", "input:1: compressed IGES files are not read"),
        ("S      1\n", "B      1\n", "input:1: binary IGES files are not read"),
        ("D      1\n", "\n", "input:4: the line has fewer than 80 columns"),
        ("D     14P     11", "D     14P     12", "12 records P are told, 11 are there"),
        ("1H//1H!/", "9H//1H!/", "global section: "),
        (
            "     126       2",
            "     126      99",
            "directory entry 3 (entity 126): 2 parameter records from 99 on are told, 11 are there",
        ),
        (
            "     126       2",
            "     126      -2",
            "directory entry 3 (entity 126): 2 parameter records from -2 on",
        ),
        (
            "     126       2",
            "     126       3",
            "directory entry 3 (entity 126): the parameters in line 21 belong to directory entry 5",
        ),
        (
            "     124       1       0       0       0       0        ",
            "     124       1       0       0       0       0       1",
            "or in a circle",
        ),
        (
            "       0       1        00000000D      3",
            "       0       3        00000000D      3",
            "pointer 3 does not refer to an entity 124",
        ),
        (
            "       0       1        00000000D      3",
            "       0       2        00000000D      3",
            "pointer 2 does not refer to an entity 124",
        ),
        (
            "     126                       2       0",
            "     126                       1       0",
            "the parameters have no end",
        ),
        (
            "     126                       2       0",
            "     128                       2       0",
            "input:7: the records of the directory entry tell different kinds",
        ),
        (
            "126/3/2/0",
            "128/3/2/0",
            "directory entry 3 (entity 126): the parameters are those of an entity 128",
        ),
        ("126/3/2/0", "126/9/2/0", "directory entry 3 (entity 126): "),
        ("126/3/2/0", "126/3/9/0", "an upper index of 3 and degree 9 are not possible here"),
        ("126/3/2/0", "126/-/2/0", "parameter 1: '-' is not a whole number"),
        ("128/1/2/1/2", "128/9/9/1/2", "directory entry 9 (entity 128): "),
        ("7.0D-1", "7.0D+9", ""),
        ("7.0D-1", "-7.D-1", "directory entry 3 (entity 126): "),
        ("7.0D-1", "7.0D-x", "parameter 15: '7.0D-x' is not a finite number"),
        ("7.0D-1", "1D9999", "parameter 15: '1D9999' is not a finite number"),
        (
            "0/0/0/0/0./0./0.",
            "0/0/1/0/0./0./0.",
            "the spline is called polynomial, and its weights are not equal",
        ),
        ("0./2./0./0./1./0/1/5!", "0./9./0./0./1./0/1/5!", "directory entry 3 (entity 126): "),
        (
            first,
            "124/x./-1./0./10.",
            "directory entry 3 (entity 126): parameter 1: 'x.' is not a finite number",
        ),
        ("406/1/70H", "406/1/99H", "directory entry 3 (entity 126): the parameters have no end"),
    ] {
        match after(BY_HAND, old, new, Format::Iges) {
            Err(error) => assert!(!told.is_empty() && error.contains(told), "{error} does not tell {told}"),
            Ok(_) => assert!(told.is_empty(), "{new}"),
        }
    }
    let cut = &BY_HAND[..BY_HAND.rfind("S      1G").unwrap()];
    let error = from_bytes(cut.as_bytes(), Format::Iges).unwrap_err().to_string();
    assert!(error.contains("the file ends before its last section"), "{error}");
}

#[test]
fn records_have_80_columns_and_break_after_delimiters() {
    let space = SplineSpace::uniform_periodic(3, 7, -1.0, 1.0 / 3.0).unwrap();
    let coords: Vec<f64> = (1..15).map(|i| 1.0 / f64::from(i)).collect();
    let name = "a name of more than one record: ".repeat(4);
    let entry = Entry::named(name, plane(space, &coords));
    let bytes = to_bytes(std::slice::from_ref(&entry), Format::Iges).unwrap();
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert!(text.lines().all(|line| line.len() == 80));
    let parameters = text.lines().filter(|line| line.as_bytes()[72] == b'P' && line[64..72].trim() == "1");
    assert!(parameters.clone().count() > 5);
    assert!(parameters.map(|line| line[..64].trim_end()).all(|data| data.ends_with([',', ';'])));
    assert_eq!(from_bytes(&bytes, Format::Iges).unwrap(), [entry]);
}

#[test]
fn letters_beyond_ascii_and_plane_surfaces_have_no_room() {
    let line = || SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let entry = Entry::named("é", plane(line(), &[0.0; 4]));
    assert_eq!(
        to_bytes(&[entry], Format::Iges).unwrap_err().to_string(),
        "input: item 0: IGES files hold no name \"é\""
    );
    let flat = AnySurface::new(line().into(), line().into(), 2, Over::Float(vec![0.0; 8])).unwrap();
    let error = to_bytes(&[Value::from(flat).into()], Format::Iges).unwrap_err().to_string();
    assert_eq!(error, "input: item 0: IGES files hold no surface in the plane");
}

#[test]
fn the_end_of_an_arc_that_misses_the_circle_counts_as_a_direction() {
    let entries =
        after(BY_HAND, "100/2./0./0./1./0./0./1.!", "100/0./0./0./1./0./0./2.!", Format::Iges).unwrap();
    assert_near(&at(&entries[3].value, 1.0), &[9.0, 0.0, 0.5]);
}

/// Records of a section, numbered.
fn section(letter: char, records: &[String]) -> String {
    records.iter().enumerate().map(|(i, record)| format!("{record:<72}{letter}{:>7}\n", i + 1)).collect()
}

/// Lines that all refer to one name, of so many letters.
fn with_one_name(lines: usize, letters: usize) -> String {
    let name = format!("406,1,{letters}H{};", "x".repeat(letters));
    let parts: Vec<&str> =
        name.as_bytes().chunks(64).map(|part| std::str::from_utf8(part).unwrap()).collect();
    let mut parameters: Vec<String> = parts.iter().map(|part| format!("{part:<64}{:>8}", 1)).collect();
    let entry = |kind: usize, first: usize, count: usize, form: usize| {
        let numbers = [first, 0, 0, 0, 0, 0, 0].map(|n| format!("{n:>8}")).concat();
        [format!("{kind:>8}{numbers}00000000"), format!("{kind:>8}{:>8}{:>8}{count:>8}{form:>8}", 0, 0)]
    };
    let mut directory = entry(406, 1, parts.len(), 15).to_vec();
    for _ in 0..lines {
        directory.extend(entry(110, parameters.len() + 1, 1, 0));
        parameters.push(format!("{:<64}{:>8}", "110,0.,0.,0.,1.,2.,0.,0,1,1;", directory.len() - 1));
    }
    let start = section('S', &["lines".into()]) + &section('G', &["1H,,1H;;".into()]);
    let end = format!("S      1G      1D{:>7}P{:>7}", directory.len(), parameters.len());
    start + &section('D', &directory) + &section('P', &parameters) + &section('T', &[end])
}

#[test]
fn a_name_of_many_entities_does_not_fill_the_memory() {
    let few = from_bytes(with_one_name(3, 1000).as_bytes(), Format::Iges).unwrap();
    assert!(few.len() == 3 && few.iter().all(|entry| entry.name.as_deref() == Some(&*"x".repeat(1000))));
    let error = from_bytes(with_one_name(200, 100_000).as_bytes(), Format::Iges).unwrap_err().to_string();
    assert!(error.contains("the names of the file are too long for so many entities"), "{error}");
}
