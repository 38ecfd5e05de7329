//! STEP.

use crate::{after, plane};
use symspline::SplineSpace;
use symspline_dynamic::{AnySpline, Over, Value};
use symspline_files::{Entry, Format, from_bytes, to_bytes};

const BY_HAND: &str = include_str!("../corpus/step/by_hand.step");

const POINTS: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.5], [3.0, 1.0, 0.0], [4.0, 0.0, 1.0]];

fn curve(space: SplineSpace<f64>) -> Value {
    AnySpline::new(space.into(), 3, Over::Float(POINTS.concat())).unwrap().into()
}

#[test]
fn the_standard_gives_knots_to_curves_without_any() {
    let entries = from_bytes(BY_HAND.as_bytes(), Format::Step).unwrap();
    let names: Vec<_> = entries.iter().map(|entry| entry.name.as_deref()).collect();
    let told = [
        Some("Bézier α 😀"),
        None,
        Some("quasi"),
        Some("rational"),
        Some("ring"),
        None,
        Some("weighed"),
        Some("in the plane"),
    ];
    assert_eq!(names, told);
    assert_eq!(entries[0].value, curve(SplineSpace::bezier(3, 0.0, 1.0).unwrap()));
    assert_eq!(entries[1].value, curve(SplineSpace::new(2, (-2..5).map(f64::from)).unwrap()));
    assert_eq!(entries[2].value, curve(SplineSpace::clamped(2, [0.0, 1.0, 2.0]).unwrap()));
    assert_eq!(entries[4].value, curve(SplineSpace::periodic(2, [0.0, 1.0, 2.0, 3.0], 4.0).unwrap()));
    assert_eq!(entries[7].value, plane(SplineSpace::bezier(1, 0.0, 1.0).unwrap(), &[0.0, 0.5, 1.0, 0.5]));
    let pieces = after(BY_HAND, "3,(#1,#2,#3,#4)", "1,(#1,#2,#3,#4)", Format::Step).unwrap();
    assert_eq!(pieces[0].value, curve(SplineSpace::clamped(1, [0.0, 1.0, 2.0, 3.0]).unwrap()));
    let pieces = after(BY_HAND, "3,(#1,#2,#3,#4)", "2,(#1,#2,#3,#4,#1)", Format::Step).unwrap();
    assert!(pieces[0].value.to_string().contains("degree 2, 5 coefficients on [0, 2]"));
}

#[test]
fn curves_that_are_called_closed_and_are_not_periodic_have_ends() {
    let open =
        after(BY_HAND, "(-2.,-1.,0.,1.,2.,3.,4.,5.,6.)", "(-2.,-1.,0.,1.,2.,3.,4.,5.,6.5)", Format::Step)
            .unwrap();
    assert!(open[4].value.to_string().contains("6 coefficients on [0, 4]"), "{}", open[4].value);
    let word =
        after(BY_HAND, ".UNSPECIFIED.,.T.,.F.,(1,1", ".UNSPECIFIED.,.F.,.F.,(1,1", Format::Step).unwrap();
    assert!(word[4].value.to_string().contains("6 coefficients"));
}

#[test]
fn references_and_parameters_that_are_wrong_are_told_with_the_instance() {
    for (old, new, told) in [
        ("#20=BEZIER_CURVE", "#1=BEZIER_CURVE", "#1 is defined twice"),
        ("2,(#1,#2,#3,#4),", "2,(#1,#2,#3,#99),", "input: #21: #99 is referred to and not there"),
        ("2,(#1,#2,#3,#4),", "2,(#1,#2,#3,#21),", "input: #21: #21 is not a CARTESIAN_POINT"),
        ("2,(#1,#2,#3,#4),", "2,(#1,#2,#3,#40),", "input: #21: #40 has another number of coordinates"),
        ("2,(#1,#2,#3,#4),", "2,(#1,#2,#3,4),", "input: #21: a reference was expected"),
        ("2,(#1,#2,#3,#4),", "2,#1,", "input: #21: a list was expected"),
        ("2,(#1,#2,#3,#4),", "-2,(#1,#2,#3,#4),", "input: #21: -2 was not expected: it is negative"),
        ("2,(#1,#2,#3,#4),", "99999,(#1,#2,#3,#4),", "input: #21: a degree of 99999 is not possible"),
        ("2,(#1,#2,#3,#4),", "4,(#1,#2,#3,#4),", "input: #21: 4 control points do not make degree 4"),
        (
            "3,(#1,#2,#3,#4),",
            "2,(#1,#2,#3,#4),",
            "input: #20: 4 control points do not make pieces of degree 2",
        ),
        ("(4.,0.,1.)", "(4.,NaN,1.)", "#4: '(' was expected"),
        ("(4.,0.,1.)", "(4.,1.E999,1.)", "input: #20: #4: '1.E999' is not a finite number"),
        ("(4.,0.,1.)", "(4.,'0.',1.)", "input: #20: #4: a number was expected"),
        ("(4.,0.,1.)", "(4.)", "input: #20: #4: 1 coordinates; there may be two or three"),
        (
            "(1,1,1,1,1,1,1,1,1)",
            "(1,1,1,1,1,1,1,1,4000000000)",
            "input: #24: the multiplicities make 4000000008 knots, not 9",
        ),
        (
            "(1,1,1,1,1,1,1,1,1)",
            "(1,1,1,1,1,1,1,1,9223372036854775807)",
            "input: #24: the multiplicities make",
        ),
        ("(1,1,1,1,1,1,1,1,1)", "(1,1,1,1,1,1,1,2,0)", "or one of them is zero"),
        ("(1,1,1,1,1,1,1,1,1)", "(1,1,1,1,1,1,1,2)", "input: #24: 9 knots have 8 multiplicities"),
        ("-2.,-1.,0.,1.,2.", "-2.,-1.,-1.,1.,2.", "input: #24: knot 2 is not greater"),
        ("(1.,0.5,1.)", "(1.,0.5)", "input: #23: 3 control points have 2 weights"),
        ("(1.,0.5,1.)", "(1.,-0.5,1.)", "input: #23: "),
        ("((1.,2.),(3.,4.))", "((1.,2.,3.),(4.))", "input: #31: the rows of weights"),
        (
            "((#1,#2,#3),(#2,#3,#4))",
            "((#1,#2,#3),(#2,#3))",
            "input: #30: row 1 of the control points has 2 points, not 3",
        ),
        ("BEZIER_CURVE()CURVE()", "CURVE()", "input: #23: no part tells the knots"),
        ("QUASI_UNIFORM_CURVE", "B_SPLINE_CURVE", "input: #22: no part tells the knots"),
        ("'quasi',2,", "'quasi',", "input: #22: QUASI_UNIFORM_CURVE has 6 parameters or more"),
        ("((1),(2,(3)))", "((1),(2,(3))", "a bracket is not closed"),
        ("DATA;", "DATE;", "'END-ISO-10303-21' stands in a section"),
        ("ISO-10303-21;", "ISO-10303-22;", "input:1:12: the file does not begin with"),
        ("ENDSEC;\nEND-ISO-10303-21;\n", "", "the file ends too early"),
    ] {
        match after(BY_HAND, old, new, Format::Step) {
            Err(error) => assert!(error.contains(told), "{error} does not tell {told}"),
            // DATE is a section of no interest, whose end is that of the data.
            Ok(entries) => assert!(new == "DATE;" && entries.is_empty(), "{new}"),
        }
    }
}

#[test]
fn brackets_without_end_and_long_lists_are_no_harm() {
    let deep = "(".repeat(1_000_000);
    let error = after(BY_HAND, "((1),(2,(3)))", &deep, Format::Step).unwrap_err();
    assert!(error.contains("more than 64 brackets"), "{error}");
    let nested = format!("{}1{}", "(".repeat(70), ")".repeat(70));
    assert!(
        after(BY_HAND, "(#1,#2,#3,#4)", &nested, Format::Step).unwrap_err().contains("more than 64 brackets")
    );
    // A point with a name of a megabyte that is used ten thousand times is read once.
    let point = format!("#1=CARTESIAN_POINT('{}',", "x".repeat(1 << 20));
    let text = BY_HAND.replacen("#1=CARTESIAN_POINT('',", &point, 1);
    let list = format!("2,({}#2,#3,#4),", "#1,".repeat(10_000));
    assert!(
        after(&text, "2,(#1,#2,#3,#4),", &list, Format::Step).unwrap()[1]
            .value
            .to_string()
            .contains("10003 coefficients")
    );
}

#[test]
fn curves_of_the_plane_are_written_in_space_and_jumps_refused() {
    let line = SplineSpace::bezier(1, 0.0, 1.0).unwrap();
    let entry = Entry::named("it's", plane(line.clone(), &[1.0, 2.0, 3.0, 4.0]));
    let again = from_bytes(&to_bytes(&[entry], Format::Step).unwrap(), Format::Step).unwrap();
    let in_space = AnySpline::new(line.into(), 3, Over::Float(vec![1.0, 2.0, 0.0, 3.0, 4.0, 0.0])).unwrap();
    assert_eq!(again, [Entry::named("it's", in_space)]);
    let torn = SplineSpace::new(1, [0.0, 0.0, 1.0, 1.0, 2.0, 2.0]).unwrap();
    let error = to_bytes(&[plane(torn, &[0.0; 8]).into()], Format::Step).unwrap_err();
    assert_eq!(error.to_string(), "input: item 0: STEP files hold no curve with a jump");
}
