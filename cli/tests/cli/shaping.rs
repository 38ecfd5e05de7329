//! `shape` and `sculpt`: what each tool promises.

use crate::program::{Folder, SADDLE};
use serde_json::Value;

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

/// A fraction as a float.
fn float(number: &Value) -> f64 {
    number.as_str().unwrap().parse::<symspline::Q>().unwrap().to_f64()
}

/// The bump of a weight: the uniform cubic B-spline over [0, 1], by truncated powers, as a rational one, over its greatest value.
fn bump(t: f64, weight: f64) -> f64 {
    let powers = [1.0, -4.0, 6.0, -4.0, 1.0].into_iter().zip([0.0, 1.0, 2.0, 3.0, 4.0]);
    let hill = powers.map(|(factor, k)| factor * (4.0 * t - k).max(0.0).powi(3)).sum::<f64>() / 6.0;
    let weighed = |n: f64| weight * n / (weight * n + 1.0 - n);
    weighed(hill) / weighed(2.0 / 3.0)
}

#[test]
fn warps_stay_in_their_regions() {
    let folder = folder("warp");
    let arguments =
        ["shape", "warp", "--on", "1/4,3/4", "--by", "0,2", "--insert", "12", "--bump", "4", "c.json"];
    assert_eq!(after(&folder, &arguments, "same(restrict(C, 3/4, 1), restrict(D, 3/4, 1))"), "1");
    // Each control point moves by the bump at its node, the mean of its inner knots, if its influence ends in the region.
    let moved = folder.out(&["calc", "--json", "D - C", "c.json", "--let", "D=d.json"]);
    let moved: Value = serde_json::from_str(&moved).unwrap();
    let moved = &moved["items"][0]["value"]["spline"];
    let knots: Vec<f64> = moved["space"]["knots"].as_array().unwrap().iter().map(float).collect();
    let points = moved["points"].as_array().unwrap();
    assert_eq!((knots.len(), points.len()), (11 + 12, 7 + 12));
    for (i, point) in points.iter().enumerate() {
        let node = knots[i + 1..i + 4].iter().sum::<f64>() / 3.0;
        let is_inside = knots[i] >= 0.25 && knots[i + 4] <= 0.75;
        let height = if is_inside { 2.0 * bump((node - 0.25) * 2.0, 4.0) } else { 0.0 };
        assert!((float(&point[1]) - height).abs() < 1e-14, "{i}: {point}, not {height}");
    }
    // Nothing moves aside.
    assert_eq!(folder.value("same(x(C), x(D))", &["c.json", "--let", "D=d.json"]), "1");
    let flat =
        ["shape", "warp", "--on", "0:0,1:1", "--by", "0,0,1", "--insert", "5", "s.json", "-o", "t.json"];
    assert!(folder.run(&flat).err.contains("25 control points moved, 10 knots inserted"));
    // Of degree 1 the top is a control point; the boundary stays.
    let gap =
        |at: &str| folder.value(&format!("at(T, {at}) - at(S, {at})"), &["s.json", "--let", "T=t.json"]);
    assert_eq!((gap("1/2, 1/2"), gap("1/3, 1")), ("(0, 0, 1)".to_owned(), "(0, 0, 0)".to_owned()));
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
    // (6, 5/2) is 13/2 away, so s = 5/13, and with the ratio 2 it goes to the share 2 s / (1 + s) = 5/9 of itself.
    let half = [
        "shape",
        "bend",
        "--centre",
        "0,0",
        "--radius",
        "5/2",
        "--ratio",
        "2",
        "--on",
        "1/6,5/6",
        "line.json",
    ];
    folder.out(&[&half[..], &["--without-tails", "-o", "d.json"]].concat());
    assert_eq!(folder.value("at(D, 2/3)", &with), "(10/3, 25/18)");
    // With tails the ends are carried along, which takes square roots.
    folder.out(&[&half[..], &["--float", "-o", "d.json"]].concat());
    assert_ne!(folder.value("at(D, 0)", &with), "(-18, 2.5)");
    assert_eq!(folder.refused(&half).1, 1);
    // Along v as along u of the transposed surface.
    folder.out(&["calc", "transpose(S)", "s.json", "-o", "t.json"]);
    let bend = ["shape", "bend", "--float", "--insert", "3", "--centre", "0,0,-5", "--radius", "5"];
    folder.out(&[&bend[..], &["--along", "v", "s.json", "-o", "bent_s.json"]].concat());
    folder.out(&[&bend[..], &["t.json", "-o", "bent_t.json"]].concat());
    let with = ["A=bent_s.json", "B=bent_t.json"];
    for (place, other) in [("1/3, 1/7", "1/7, 1/3"), ("1, 1/2", "1/2, 1")] {
        let gap = folder.value(&format!("abs2(at(A, {place}) - at(B, {other}))"), &with);
        assert!(gap.parse::<f64>().unwrap() < 1e-24, "{gap}");
    }
    assert_ne!(folder.value("at(A, 1/3, 1/7) - at(B, 1/3, 1/7)", &with), "(0, 0, 0)");
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
    // A control point that would move stays where it is held, the third from the start.
    let third = || {
        let moved = folder.out(&["calc", "--json", "D - C", "c.json", "--let", "D=d.json"]);
        let moved: Value = serde_json::from_str(&moved).unwrap();
        moved["items"][0]["value"]["spline"]["points"][2].clone()
    };
    folder.out(&["shape", "constrain", "--at", "1/2", "--change", "1,1", "c.json", "-o", "d.json"]);
    assert_ne!(third(), serde_json::json!(["0", "0"]));
    folder.out(&[
        "shape",
        "constrain",
        "--hold",
        "2",
        "--at",
        "1/2",
        "--change",
        "1,1",
        "c.json",
        "-o",
        "d.json",
    ]);
    assert_eq!(third(), serde_json::json!(["0", "0"]));
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

#[test]
fn the_work_of_a_pull_is_its_energy() {
    let folder = folder("work");
    let pull = [
        "sculpt",
        "--at",
        "2/5",
        "--target",
        "5,5",
        "--stretching",
        "2",
        "--bending",
        "1/300",
        "--hardness",
        "7",
    ];
    let said = folder.run(&[&pull[..], &["--spread", "point", "c.json", "-o", "d.json"]].concat());
    let force = said.err.trim().strip_prefix("force: ").unwrap();
    // force · movement = 7 ∫ f² + 2 ∫ f'² + 1/300 ∫ f''², where f is the deformation.
    let work = format!("dot({force}, at(D, 2/5) - at(C, 2/5))");
    let energy = |f: &str| {
        let part = |order: usize| format!("inner(diff({f}, {order}), diff({f}, {order}))");
        format!("(7 * {} + 2 * {} + {} / 300)", part(0), part(1), part(2))
    };
    let with = ["c.json", "D=d.json", "E=e.json"];
    folder.out(&[&pull[..], &["c.json", "-o", "e.json"]].concat());
    assert_eq!(folder.value(&format!("{work} - {}", energy("(D - C)")), &with), "0");
    // It is the least one: another way to spread the force takes more.
    let more = folder.value(&format!("{} - {}", energy("(E - C)"), energy("(D - C)")), &with);
    assert!(more.parse::<symspline::Q>().unwrap() > symspline::Q::from(0), "{more}");
}
