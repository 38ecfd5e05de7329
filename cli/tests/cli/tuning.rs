//! `tune`: what fine tuning promises, checked by expressions over what is written.

use crate::program::{Folder, SADDLE};

fn folder(test: &str) -> Folder {
    let folder = Folder::new(test);
    folder.make("c.json", "C", "uniform(3, (0, 0), (1, 2), (3, 3), (5, 3), (7, 2), (8, 0), (9, 1))");
    folder.make("a.json", "a", "uniform(2, 1, 1, 3/2, 2, 1)");
    folder
}

#[test]
fn the_derivative_is_scaled() {
    let folder = folder("tune_free");
    folder.out(&["tune", "--alpha", "a.json", "c.json", "-o", "d.json"]);
    let with = ["c.json", "a.json", "--let", "D=d.json"];
    assert_eq!(folder.value("same(diff(D), a * diff(C))", &with), "1");
    assert_eq!(folder.value("at(D, 0) - at(C, 0)", &with), "(0, 0)");
    // The same scale as a list, and as an entry by name.
    let list = ["--alpha-values", "1,1,3/2,2,1", "--alpha-degree", "2"];
    assert_eq!(
        folder.out(&[&["tune", "c.json"][..], &list].concat()),
        folder.out(&["tune", "--alpha", "a.json:a", "c.json"])
    );
}

#[test]
fn ends_are_held() {
    let folder = folder("tune_held");
    for (hold, orders) in [("points", 0), ("tangents", 1), ("curvatures", 2), ("nearest", 0)] {
        let said = folder.run(&["tune", "--alpha", "a.json", "--hold", hold, "c.json", "-o", "d.json"]);
        assert_eq!(said.code, 0, "{}", said.err);
        let told = if hold == "nearest" { "the scale function is off by" } else { "held by a similarity" };
        assert!(said.err.starts_with(told));
        for order in 0..=orders {
            for end in [0, 1] {
                let gap = format!("at(diff(D, {order}), {end}) - at(diff(C, {order}), {end})");
                assert_eq!(folder.value(&gap, &["c.json", "--let", "D=d.json"]), "(0, 0)", "{hold} {order}");
            }
        }
        let parallel =
            folder.value("same(cross(diff(C), diff(D)), 0 * x(C))", &["c.json", "--let", "D=d.json"]);
        assert_eq!(parallel == "1", hold == "nearest");
    }
    folder.out(&["tune", "--alpha", "a.json", "--hold", "nearest", "--order", "1", "c.json", "-o", "d.json"]);
    assert_eq!(folder.value("at(diff(D), 1) - at(diff(C), 1)", &["c.json", "--let", "D=d.json"]), "(0, 0)");
}

#[test]
fn a_part_is_tuned_and_the_rest_stays() {
    let folder = folder("tune_part");
    for more in [&["--hold", "tangents"][..], &["--hold", "nearest", "--order", "1"], &[]] {
        let part = ["tune", "--alpha-values", "1,1,2,2,1,1", "--on", "1/5,4/5", "c.json", "-o", "d.json"];
        folder.out(&[&part[..], more].concat());
        let with = ["c.json", "--let", "D=d.json"];
        assert_eq!(folder.value("same(restrict(C, 0, 1/5), restrict(D, 0, 1/5))", &with), "1");
        assert_eq!(folder.value("same(restrict(C, 4/5, 1), restrict(D, 4/5, 1))", &with), "1");
        assert_eq!(folder.value("same(C, D)", &with), "0");
    }
    // A file whose domain is the part, and one that is restricted to it.
    folder.make("part.json", "a", "restrict(uniform(2, 1, 1, 3/2, 2, 1), 1/5, 4/5)");
    let local = folder.out(&["tune", "--alpha", "part.json", "--hold", "points", "c.json"]);
    assert_eq!(local, folder.out(&["tune", "--alpha", "a.json", "--on", "1/5,4/5", "c.json"]));
}

#[test]
fn the_degree_is_kept_within_a_tolerance() {
    let folder = folder("tune_within");
    folder.out(&["tune", "--alpha", "a.json", "--hold", "points", "c.json", "-o", "d.json"]);
    let near =
        ["tune", "--alpha", "a.json", "--hold", "points", "--within", "1/100", "c.json", "-o", "e.json"];
    let said = folder.run(&near);
    assert!(said.code == 0 && said.err.starts_with("within "), "{}", said.err);
    assert!(folder.out(&["info", "e.json"]).contains("degree 3,"));
    for x in ["0", "1/7", "2/5", "9/10", "1"] {
        let gap = folder.value(
            &format!("float(abs2(at(D, {x}) - at(E, {x})))"),
            &["--let", "D=d.json", "--let", "E=e.json"],
        );
        assert!(gap.replace("float number ", "").parse::<f64>().unwrap() <= 1e-4, "{x}: {gap}");
    }
}

#[test]
fn closed_curves_stay_closed() {
    let folder = Folder::new("tune_closed");
    folder.write(
        "ring.json",
        r#"{"format": "symspline", "version": 1, "items": [{"name": "R", "value": {"spline": {"field": "float",
        "space": {"degree": 3, "knots": [0, 1, 2, 3, 4, 5], "end": 6},
        "points": [[4, 0], [2, 3], [-2, 3], [-4, 0], [-2, -3], [2, -3]]}}}]}"#,
    );
    folder.write(
        "scale.json",
        r#"{"format": "symspline", "version": 1, "items": [{"value": {"spline": {"field": "float",
        "space": {"degree": 2, "knots": [0, 1, 2, 3, 4, 5], "end": 6}, "points": [[1], [1.5], [1], [1], [1], [1]]}}}]}"#,
    );
    folder.out(&["tune", "--alpha", "scale.json", "--hold", "closed", "ring.json", "-o", "d.json"]);
    assert!(folder.out(&["info", "d.json"]).contains("periodic"));
    assert_eq!(
        folder.refused(&["tune", "--alpha", "scale.json", "--hold", "closed", "--exact", "ring.json"]).1,
        1
    );
    // By the nearest scale, exactly: the ends of the tuned curve meet.
    folder.out(&[
        "tune",
        "--alpha-values",
        "1,1.5,1,1",
        "--hold",
        "nearest",
        "--exact",
        "ring.json",
        "-o",
        "e.json",
    ]);
    assert_eq!(folder.value("at(E, 6) - at(E, 0)", &["--let", "E=e.json"]), "(0, 0)");
}

#[test]
fn surfaces_are_tuned_along_paths() {
    let folder = Folder::new("tune_surface");
    folder.write("s.json", SADDLE);
    let rows = ["--alpha-values", "1,1,1;1,3,1;1,1,1", "--alpha-degree", "2"];
    for (path, law) in [("uv", "same(dv(T), a * dv(S))"), ("vu", "same(du(T), a * du(S))")] {
        folder.out(&[&["tune", "--path", path, "s.json", "-o", "t.json"][..], &rows].concat());
        folder.write("a.json", &ALPHA.replace('#', &alpha_points()));
        assert_eq!(folder.value(law, &["s.json", "a.json", "--let", "T=t.json"]), "1", "{path}");
    }
    // Held edges stay; exact surfaces in space are not turned, and it is said why.
    let held = [&["tune", "--float", "--hold", "points", "s.json", "-o", "t.json"][..], &rows].concat();
    assert!(folder.run(&held).err.starts_with("control points at edges were forced by at most"));
    for edge in ["iso_u(T, 0) - iso_u(S, 0)", "iso_v(T, 1) - iso_v(S, 1)"] {
        let gap =
            folder.value(&format!("abs2(at({edge}, 1/3))"), &["s.json", "--float", "--let", "T=t.json"]);
        assert!(gap.parse::<f64>().unwrap() < 1e-24, "{edge}: {gap}");
    }
    let (error, code) = folder.refused(&[&["tune", "--hold", "points", "s.json"][..], &rows].concat());
    assert!(code == 1 && error.contains("needs square roots: use --float, or --hold nearest"), "{error}");
}

/// The scale function with a bump of the list above.
const ALPHA: &str = r#"{"format": "symspline", "version": 1, "items": [{"name": "a", "value": {"surface": {"field": "exact",
    "u": {"degree": 2, "knots": ["0", "0", "0", "1", "1", "1"]}, "v": {"degree": 2, "knots": ["0", "0", "0", "1", "1", "1"]},
    "points": [#]}}}]}"#;

fn alpha_points() -> String {
    (0..9).map(|i| if i == 4 { "[\"3\"]" } else { "[\"1\"]" }).collect::<Vec<_>>().join(", ")
}

#[test]
fn what_is_no_scale_is_refused() {
    let folder = folder("tune_refused");
    let cases: [(&[&str], i32, &str); 7] = [
        (&["--alpha-values", "1,-1", "--alpha-degree", "1"], 1, "not positive"),
        (&["--alpha-values", "1,1"], 2, "degree 3 takes 4 or more"),
        (&["--alpha-values", "1,1;1"], 2, "row 1 has 1 numbers, the first 2"),
        (&["--alpha", "c.json"], 1, "a scale function has numbers as values, this curve has points"),
        (&["--alpha", "nowhere.json"], 3, "nowhere.json: No such file"),
        (&["--alpha-values", "1,1,1,1", "--on", "1/2,1/4"], 1, ""),
        (&[], 2, "--alpha"),
    ];
    for (arguments, code, problem) in cases {
        let (error, found) = folder.refused(&[&["tune", "c.json"][..], arguments].concat());
        assert!(found == code && error.contains(problem), "{arguments:?}: {found} {error}");
    }
    folder.out(&["calc", "float(a)", "a.json", "-o", "float.json"]);
    let (error, code) = folder.refused(&["tune", "--alpha", "float.json", "c.json"]);
    assert_eq!(
        (error.as_str(), code),
        ("symspline: c.json: the curve is exact and the scale function float: use --exact or --float\n", 1)
    );
    let signed = ["tune", "--alpha-values", "1,-1", "--alpha-degree", "1", "--signed", "c.json"];
    assert_eq!(folder.run(&signed).code, 0);
    folder.make("r.json", "R", "rational(bezier((0, 0), (1, 1)))");
    assert_eq!(folder.refused(&["tune", "--alpha-values", "1,1,1,1", "r.json"]).1, 1);
}
