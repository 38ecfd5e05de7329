//! DXF.

use crate::{after, assert_near, at, plane};
use std::f64::consts::FRAC_1_SQRT_2;
use symspline::SplineSpace;
use symspline_dynamic::Value;
use symspline_files::{Entry, Format, from_bytes};

const PERIODIC: &str = include_str!("../corpus/dxf/periodic.dxf");

fn read(entities: &str) -> Result<Vec<Entry>, String> {
    let groups = entities
        .split(';')
        .flat_map(|group| group.split_once('='))
        .map(|(code, value)| format!("{code}\n{value}\n"));
    let text = format!("0\nSECTION\n2\nENTITIES\n{}0\nENDSEC\n0\nEOF\n", groups.collect::<String>());
    from_bytes(text.as_bytes(), Format::Dxf).map_err(|error| error.to_string())
}

fn one(entity: &str) -> Value {
    let mut entries = read(entity).unwrap();
    assert_eq!(entries.len(), 1);
    entries.remove(0).value
}

#[test]
fn flags_tell_plane_and_periodic_curves_and_blocks_and_layers_names() {
    let entries = from_bytes(PERIODIC.as_bytes(), Format::Dxf).unwrap();
    let names: Vec<_> = entries.iter().map(|entry| entry.name.as_deref()).collect();
    assert_eq!(names, [Some("nut"), Some("rings"), Some("a é")]);
    let ring = SplineSpace::periodic(2, [0.0, 1.0, 2.0], 3.0).unwrap();
    assert_eq!(entries[1].value, plane(ring, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.5]));
    // The fourth control point is the first once more; if it is not, the curve is the same function with ends.
    let open = after(PERIODIC, " 40\r\n5\r\n", " 40\r\n5.5\r\n", Format::Dxf).unwrap();
    assert!(open[1].value.to_string().contains("5 coefficients on [0, 3]"), "{}", open[1].value);
    let in_space = after(PERIODIC, "230\r\n1.\r\n", "230\r\n-1\r\n", Format::Dxf).unwrap();
    assert_eq!(in_space[1].value.dim(), 3);
}

#[test]
fn what_is_wrong_is_told_with_its_line() {
    let long = "x".repeat(1800);
    for (old, new, told) in [
        (" 72\r\n8\r\n", " 72\r\n9\r\n", "input:48: SPLINE: 9 knots are told, 8 are there"),
        (
            " 73\r\n5\r\n",
            " 73\r\n99999999999\r\n",
            "input:48: SPLINE: 99999999999 control points are told, 5 are there",
        ),
        (
            " 71\r\n2\r\n",
            " 71\r\n3\r\n",
            "input:48: SPLINE: 8 knots and 5 control points do not make degree 3",
        ),
        (" 71\r\n2\r\n", " 71\r\n-1\r\n", "input:48: SPLINE: a degree of -1 is not possible"),
        (" 71\r\n2\r\n", " 71\r\n2.0\r\n", "input:66: group 71: '2.0' is not a whole number"),
        (" 40\r\n3E0\r\n", " 40\r\n1e999\r\n", "input:88: group 40: '1e999' is not a finite number"),
        (" 40\r\n3E0\r\n", " 40\r\nnan\r\n", "input:88: group 40: 'nan' is not a finite number"),
        (" 40\r\n3E0\r\n", " 40\r\n0.5\r\n", "input:48: knot 5 is smaller than the knot before it"),
        (" 20\r\n1.5\r\n", " 21\r\n1.5\r\n", "has no group 20"),
        (" 41\r\n0.5\r\n", " 41\r\n-0.5\r\n", "weight"),
        (" 41\r\n0.5\r\n", "", "2 control points have 1 weights"),
        ("EOF", "EOT", "'EOT' stands outside of all sections"),
        ("  0\r\nEOF\r\n", "", "the file ends before its end mark, EOF"),
        ("  0\r\nENDSEC\r\n  0\r\nEOF", "  0\r\nEOF", "the file ends before the section ENTITIES does"),
        ("ENDBLK\r\n  0\r\nENDSEC\r\n", "ENDBLK\r\n", "a section begins before the last one ends"),
        (" 72\r\n8\r\n", "7x\r\n8\r\n", "'7x' is not a group code"),
        (" 72\r\n8\r\n", "-2147483648\r\n8\r\n", "'-2147483648' is not a group code"),
        ("nut", long.as_str(), "input:22: a block has a name of 1800 bytes"),
    ] {
        let error = after(PERIODIC, old, new, Format::Dxf).unwrap_err();
        assert!(error.contains(told), "{error} does not tell {told}");
    }
    let binary = from_bytes(b"AutoCAD Binary DXF\r\n\x1a\0", Format::Dxf).unwrap_err();
    assert_eq!(binary.to_string(), "input:1: binary DXF files are not read");
}

#[test]
fn weights_of_one_may_be_left_out_and_fit_points_alone_are_refused() {
    let line = "0=SPLINE;70=4;71=1;40=0;40=0;40=1;40=1;10=0;20=0;10=1;20=2";
    assert!(matches!(one(line), Value::Rational(_)));
    assert!(matches!(one(&line.replace("70=4", "70=0")), Value::Spline(_)));
    let fitted = read("0=SPLINE;70=0;71=3;74=2;11=0;21=0;11=1;21=1").unwrap_err();
    assert!(fitted.contains("fit points and no control points"), "{fitted}");
}

#[test]
fn arcs_are_where_their_angles_say() {
    let quarter = one("0=ARC;10=1;20=2;40=2;50=90;51=180");
    assert_near(&at(&quarter, 0.0), &[1.0, 4.0]);
    assert_near(&at(&quarter, 0.5), &[1.0 - 2.0 * FRAC_1_SQRT_2, 2.0 + 2.0 * FRAC_1_SQRT_2]);
    // Through 0 degrees, seen from below: the x axis of the arbitrary axis rule points to the left.
    let below = one("0=ARC;10=1;20=2;30=3;40=2;50=315;51=45;210=0;220=0;230=-1");
    assert_near(&at(&below, 0.5), &[-3.0, 2.0, -3.0]);
    let raised = one("0=CIRCLE;10=0;20=0;30=5;40=1");
    assert_near(&at(&raised, 0.25), &[0.0, 1.0, 5.0]);
    let tilted = one("0=CIRCLE;10=0;20=0;30=0;40=1;210=1;220=0;230=0");
    assert_near(&at(&tilted, 0.0), &[0.0, 1.0, 0.0]);
    assert_near(&at(&tilted, 0.25), &[0.0, 0.0, 1.0]);
    for wrong in [
        "0=ARC;10=1;20=2;40=2;50=90",
        "0=CIRCLE;10=1;20=2;40=-1",
        "0=CIRCLE;10=1;20=2;40=1;210=0;220=0;230=0",
        "0=CIRCLE;40=1",
    ] {
        assert!(read(wrong).unwrap_err().starts_with("input:6: "), "{wrong}");
    }
}

#[test]
fn ellipses_have_the_axis_and_the_ratio_of_the_file() {
    let whole = one("0=ELLIPSE;10=1;20=0;11=0;21=4;31=0;40=0.5");
    assert_near(&at(&whole, 0.0), &[1.0, 4.0]);
    assert_near(&at(&whole, 0.25), &[-1.0, 0.0]);
    let quarter = one("0=ELLIPSE;10=1;20=0;30=2;11=0;21=4;31=0;40=0.5;41=0;42=1.5707963267948966");
    assert_near(&at(&quarter, 1.0), &[-1.0, 0.0, 2.0]);
    assert_near(&at(&quarter, 0.5), &[1.0 - 2.0 * FRAC_1_SQRT_2, 4.0 * FRAC_1_SQRT_2, 2.0]);
}

#[test]
fn polylines_bulge_to_the_right_of_the_way_if_positive() {
    let straight = one("0=LWPOLYLINE;90=3;70=0;10=0;20=0;10=1;20=0;10=1;20=1");
    assert_eq!(
        straight,
        plane(SplineSpace::clamped(1, [0.0, 1.0, 2.0]).unwrap(), &[0.0, 0.0, 1.0, 0.0, 1.0, 1.0])
    );
    // A half circle below from 0 to 2, counter-clockwise, a line back.
    let closed = one("0=LWPOLYLINE;90=2;70=1;10=0;20=0;42=1;10=2;20=0");
    assert_near(&at(&closed, 0.5), &[1.0, -1.0]);
    assert_near(&at(&closed, 1.0), &[2.0, 0.0]);
    assert_near(&at(&closed, 1.5), &[1.0, 0.0]);
    assert_near(&at(&closed, 2.0), &[0.0, 0.0]);
    // Three quarters of a circle: the tangent of 67.5 degrees. The centre is to the right of the way.
    let most = one("0=LWPOLYLINE;90=2;70=0;38=1;10=0;20=0;42=2.414213562373095;10=1;20=1");
    let [x, y, z] = at(&most, 0.5)[..] else { panic!("in space") };
    assert_near(&[x, y, z], &[1.0 + FRAC_1_SQRT_2, -FRAC_1_SQRT_2, 1.0]);
    let few = read("0=LWPOLYLINE;90=1;70=0;10=0;20=0").unwrap_err();
    assert!(few.contains("fewer than two vertices"), "{few}");
    assert!(
        read("0=LWPOLYLINE;90=3;70=0;10=0;20=0;10=1;20=1").unwrap_err().contains("3 vertices are told, 2")
    );
}

#[test]
fn lines_are_plane_if_both_ends_are() {
    let line = SplineSpace::clamped(1, [0.0, 1.0]).unwrap();
    assert_eq!(one("0=LINE;10=1;20=2;30=0;11=3;21=4;31=0"), plane(line, &[1.0, 2.0, 3.0, 4.0]));
    assert_eq!(one("0=LINE;10=1;20=2;30=0;11=3;21=4;31=5").dim(), 3);
}
