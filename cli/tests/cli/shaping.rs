//! `shape` and `sculpt`: what each tool promises.

use crate::program::{Folder, SADDLE};

const CURVE: &str = "uniform(3, (0, 0), (1, 2), (3, 3), (5, 3), (7, 2), (8, 0), (9, 1))";

fn folder(test: &str) -> Folder {
    let folder = Folder::new(test);
    folder.make("c.json", "C", CURVE);
    folder.write("s.json", SADDLE);
    folder
}

/// What an expression over the curve `C` and the new one `D` is.
fn after(folder: &Folder, arguments: &[&str], expression: &str) -> String {
    folder.out(&[arguments, &["-o", "d.json"]].concat());
    folder.value(expression, &["c.json", "--let", "D=d.json"])
}

#[test]
fn points_are_repositioned() {
    let folder = folder("reposition");
    let gap = "at(D, 2/5) - at(C, 2/5)";
    for with in [
        &["--with", "nearest"][..],
        &["--with", "neighbours"],
        &["--with", "one", "--index", "2"],
        &["--between", "1/5,3/5"],
    ] {
        let arguments =
            [&["shape", "reposition", "--at", "2/5", "--by", "-1/3,2", "c.json"][..], with].concat();
        assert_eq!(after(&folder, &arguments, gap), "(-1/3, 2)", "{with:?}");
    }
    assert_eq!(
        folder.value("same(restrict(C, 3/5, 1), restrict(D, 3/5, 1))", &["c.json", "--let", "D=d.json"]),
        "1"
    );
    folder.out(&["shape", "reposition", "--at", "1/3:1/4", "--by", "0,0,1", "s.json", "-o", "t.json"]);
    assert_eq!(
        folder.value("at(T, 1/3, 1/4) - at(S, 1/3, 1/4)", &["s.json", "--let", "T=t.json"]),
        "(0, 0, 1)"
    );
    assert_eq!(
        folder.refused(&["shape", "reposition", "--at", "1/2", "--by", "0,1", "--with", "one", "c.json"]).1,
        2
    );
    assert_eq!(folder.refused(&["shape", "reposition", "--at", "1/2", "--by", "0,1,2", "c.json"]).1, 1);
    assert_eq!(folder.refused(&["shape", "reposition", "--at", "1/2", "--by", "0,1", "s.json"]).1, 2);
}

#[test]
fn weights_take_points_to_control_points() {
    let folder = folder("weight");
    let arguments = ["shape", "weight", "--at", "1/2", "--index", "3", "--fraction", "1/3", "c.json"];
    assert_eq!(after(&folder, &arguments, "3 * at(D, 1/2) - 2 * at(C, 1/2) - (5, 3)"), "(0, 0)");
    let (error, code) =
        folder.refused(&["shape", "weight", "--at", "1/2", "--index", "3", "--fraction", "1", "c.json"]);
    assert!(code == 1 && error.starts_with("symspline: c.json: "), "{error}");
    folder.out(&[
        "shape",
        "weight",
        "--at",
        "1/2:1/2",
        "--index",
        "1:1",
        "--fraction",
        "1/2",
        "s.json",
        "-o",
        "t.json",
    ]);
    // Half the way from (1/2, 1/2, 1/4) to (1, 1, 1).
    assert_eq!(folder.value("at(T, 1/2, 1/2)", &["--let", "T=t.json"]), "(3/4, 3/4, 5/8)");
}

#[test]
fn warps_stay_in_their_regions() {
    let folder = folder("warp");
    let arguments =
        ["shape", "warp", "--on", "1/4,3/4", "--by", "0,2", "--insert", "12", "--bump", "4", "c.json"];
    assert_eq!(after(&folder, &arguments, "same(restrict(C, 3/4, 1), restrict(D, 3/4, 1))"), "1");
    let raised = folder.value("y(at(D, 1/2) - at(C, 1/2))", &["c.json", "--let", "D=d.json", "--float"]);
    assert!((1.0..=2.0).contains(&raised.parse::<f64>().unwrap()), "{raised}");
    // Nothing moves aside.
    assert_eq!(folder.value("same(x(C), x(D))", &["c.json", "--let", "D=d.json"]), "1");
    let flat = ["shape", "warp", "--on", "0:0,1:1", "--by", "0,0,1", "--insert", "5", "s.json"];
    assert!(folder.run(&flat).err.contains("10 knots inserted"));
}

#[test]
fn flat_parts_are_flat() {
    let folder = folder("flatten");
    let arguments = [
        "shape",
        "flatten",
        "--onto-point",
        "0,2",
        "--direction",
        "1,0",
        "--side",
        "positive",
        "--insert",
        "9",
        "c.json",
    ];
    assert_eq!(after(&folder, &arguments, "same(y(restrict(D, 3/10, 1/2)), const(2, 3/10, 1/2))"), "1");
    assert_eq!(folder.value("same(C, D)", &["c.json", "--let", "D=d.json"]), "0");
    let by_normal: Vec<&str> = arguments
        .iter()
        .map(|a| match *a {
            "--direction" => "--normal",
            "1,0" => "0,1",
            a => a,
        })
        .collect();
    assert_eq!(folder.out(&by_normal), folder.out(&arguments));
    folder.out(&["shape", "flatten", "--onto-point", "0,0,5", "--normal", "0,0,1", "s.json", "-o", "t.json"]);
    assert_eq!(folder.value("at(z(T), 1/3, 1/5)", &["--let", "T=t.json"]), "5");
    let on = ["shape", "flatten", "--onto-point", "0,0", "--direction", "1,0", "--on", "1/4,1", "c.json"];
    assert_eq!(after(&folder, &on, "same(restrict(C, 0, 1/4), restrict(D, 0, 1/4))"), "1");
}

#[test]
fn bends_bring_control_points_to_circles() {
    let folder = folder("bend");
    // With cross ratio 1 all control points come to lie on the circle, along rays from the centre: (0, 5/2) stays.
    folder.make(
        "line.json",
        "C",
        "uniform(1, (-18, 5/2), (-12, 5/2), (-6, 5/2), (0, 5/2), (6, 5/2), (12, 5/2), (18, 5/2))",
    );
    folder.out(&[
        "shape",
        "bend",
        "--centre",
        "0,0",
        "--radius",
        "5/2",
        "--without-tails",
        "--on",
        "1/6,5/6",
        "line.json",
        "-o",
        "d.json",
    ]);
    let with = ["line.json", "--let", "D=d.json"];
    assert_eq!(folder.value("at(D, 1/2)", &with), "(0, 5/2)");
    assert_eq!(folder.value("abs2(at(D, 2/3))", &with), "25/4");
    assert_eq!(folder.value("at(C, 0) - at(D, 0)", &with), "(0, 0)");
    assert_eq!(
        folder.refused(&["shape", "bend", "--centre", "0,0", "--radius", "1", "--on", "0:0,1:1", "c.json"]).1,
        2
    );
}

#[test]
fn constraints_are_met() {
    let folder = folder("constrain");
    let arguments = [
        "shape",
        "constrain",
        "--at",
        "2/5",
        "--order",
        "0",
        "--change",
        "0,0",
        "--at",
        "2/5",
        "--order",
        "1",
        "--change",
        "-1,4",
        "--hold",
        "0",
        "--hold",
        "6",
        "c.json",
    ];
    assert_eq!(after(&folder, &arguments, "at(diff(D), 2/5) - at(diff(C), 2/5)"), "(-1, 4)");
    assert_eq!(folder.value("at(D, 2/5) - at(C, 2/5)", &["c.json", "--let", "D=d.json"]), "(0, 0)");
    assert_eq!(folder.value("at(D, 0) - at(C, 0)", &["c.json", "--let", "D=d.json"]), "(0, 0)");
    let plain = ["shape", "constrain", "--at", "1/2", "--change", "1,1", "c.json"];
    assert_eq!(after(&folder, &plain, "at(D, 1/2) - at(C, 1/2)"), "(1, 1)");
    assert_eq!(
        folder.refused(&["shape", "constrain", "--at", "1/2", "--at", "1/3", "--change", "1,1", "c.json"]).1,
        2
    );
}

#[test]
fn sculpted_points_go_where_they_are_pulled() {
    let folder = folder("sculpt");
    let said =
        folder.run(&["sculpt", "--at", "1/2", "--target", "5,5", "--bending", "2", "c.json", "-o", "d.json"]);
    assert_eq!(said.code, 0);
    assert_eq!(folder.value("at(D, 1/2)", &["--let", "D=d.json"]), "(5, 5)");
    assert_eq!(folder.value("at(D, 1) - at(C, 1)", &["c.json", "--let", "D=d.json"]), "(0, 0)");
    // The force that is told does the same.
    let force = said.err.trim().strip_prefix("force: (").unwrap().trim_end_matches(')').to_owned();
    let pushed = folder.out(&["sculpt", "--at", "1/2", "--force", &force, "--bending", "2", "c.json"]);
    assert_eq!(pushed, std::fs::read_to_string(folder.0.join("d.json")).unwrap());
    // A short reach holds what is far away; so does hardness of what it reaches.
    let short = ["sculpt", "--at", "1/10", "--target", "0,1", "--reach", "2", "c.json"];
    assert_eq!(after(&folder, &short, "same(restrict(C, 3/4, 1), restrict(D, 3/4, 1))"), "1");
    let within = [
        "sculpt",
        "--at",
        "1/2",
        "--target",
        "5,5",
        "--within",
        "1/2",
        "--hardness",
        "1",
        "--spread",
        "point",
        "c.json",
    ];
    assert_eq!(after(&folder, &within, "at(D, 1/2)"), "(5, 5)");
    assert_eq!(folder.refused(&["sculpt", "--at", "1/2", "c.json"]).1, 2);
    assert_eq!(folder.refused(&["sculpt", "--at", "1/2", "--target", "1,1", "--bending=-1", "c.json"]).1, 1);
    folder.make("f.json", "f", "bezier(0, 1)");
    let (error, code) = folder.refused(&["sculpt", "--at", "1/2", "--target", "1", "f.json"]);
    assert_eq!(
        (error.as_str(), code),
        ("symspline: f.json: a curve or surface is expected, not a function\n", 1)
    );
}
