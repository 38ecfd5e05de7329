//! `info`, `eval` and `profile`.

use crate::program::{CUBE, Folder, SADDLE};
use serde_json::{Value, json};

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn info_tells_kinds_knots_boxes_and_lengths() {
    let folder = Folder::new("info");
    folder.make("c.json", "C", "insert(bezier((0, 0), (1, 2), (2, 0)), 1/2, 1/2)");
    let facts = &parsed(&folder.out(&["info", "--json", "c.json"]))[0];
    assert_eq!(facts["kind"], "curve");
    assert_eq!(facts["field"], "exact");
    assert_eq!(facts["dimension"], 2);
    assert_eq!(facts["parameters"][0]["knots"], json!([["0", 3], ["1/2", 2], ["1", 3]]));
    // The parabola y = x (2 - x) over [0, 2].
    let length = 5_f64.sqrt() + 2_f64.asinh() / 2.0;
    assert!((facts["length"].as_f64().unwrap() - length).abs() < 1e-11);
    assert!((facts["box"][1][1].as_f64().unwrap() - 1.0).abs() < 1e-9);
    folder.write("cube.json", CUBE);
    let facts = &parsed(&folder.out(&["info", "--json", "cube.json"]))[0];
    assert_eq!((&facts["vertices"], &facts["edges"], &facts["faces"]), (&json!(8), &json!(12), &json!(6)));
    assert_eq!(
        (&facts["closed"], &facts["box"]),
        (&json!(true), &json!([[-1.0, 1.0], [-1.0, 1.0], [-1.0, 1.0]]))
    );
    folder.write("saddle.json", SADDLE);
    let text = folder.out(&["info", "--float", "saddle.json"]);
    assert!(text.starts_with(
        "item 0 (S): float surface in 3 dimensions\n  u: degree 1, 2 coefficients on [0, 1], clamped\n"
    ));
    assert!(text.contains("  v knots: 0 (2), 1 (2)\n  box: [0.0, 1.0] x [0.0, 1.0] x [0.0, 1.0]\n"));
}

#[test]
fn entries_are_chosen_by_name_or_number() {
    let folder = Folder::new("entries");
    let two = folder
        .out(&["calc", "1", "--json"])
        .replace("}]", "}, {\"name\": \"half\", \"value\": {\"number\": \"1/2\"}}]");
    folder.write("two.json", &two);
    assert_eq!(parsed(&folder.out(&["info", "--json", "two.json"])).as_array().unwrap().len(), 2);
    for chosen in [["--name", "half"], ["--item", "1"]] {
        let facts = parsed(&folder.out(&["info", "--json", "two.json", chosen[0], chosen[1]]));
        assert_eq!((&facts[0]["item"], &facts[0]["value"]), (&json!(1), &json!("1/2")));
    }
    let (error, code) = folder.refused(&["info", "--name", "third", "two.json"]);
    assert_eq!(
        (error.as_str(), code),
        ("symspline: two.json: there is no such entry; there is item 0, item 1 (half)\n", 1)
    );
    // What is wrong with a chosen entry is told of it.
    for command in [&["eval", "--at", "0"][..], &["subdivide"], &["tune", "--alpha-values", "1,1,1,1"]] {
        let (error, code) = folder.refused(&[command, &["--item", "1", "two.json"]].concat());
        assert!(code == 1 && error.starts_with("symspline: two.json: item 1 (half): "), "{error}");
    }
    let (error, code) = folder.refused(&["eval", "--at", "0", "two.json"]);
    let listed =
        "symspline: two.json: choose an entry with --name or --item: there is item 0, item 1 (half)\n";
    assert_eq!((error.as_str(), code), (listed, 1));
}

#[test]
fn eval_gives_values_and_derivatives() {
    let folder = Folder::new("eval");
    folder.make("c.json", "C", "bezier((0, 0), (1, 2), (2, 0))");
    assert_eq!(
        folder.out(&["eval", "--at", "1/3, 1e-1", "--derivatives", "2", "c.json"]),
        "1/3\t0\t2/3\t8/9\n1/3\t1\t2\t4/3\n1/3\t2\t0\t-8\n1/10\t0\t1/5\t9/25\n1/10\t1\t2\t16/5\n1/10\t2\t0\t-8\n"
    );
    assert_eq!(folder.out(&["eval", "--grid", "3", "c.json"]), "0\t0\t0\n1/2\t1\t1\n1\t2\t0\n");
    let rows = parsed(&folder.out(&["eval", "--grid", "3", "--float", "--json", "c.json"]));
    assert_eq!(rows[1], json!({"at": [0.5], "value": [1.0, 1.0]}));
    folder.write("saddle.json", SADDLE);
    assert_eq!(folder.out(&["eval", "--at", "1/2:1/3", "saddle.json"]), "1/2\t1/3\t1/2\t1/3\t1/6\n");
    assert_eq!(folder.out(&["eval", "--grid", "2", "saddle.json"]).lines().last(), Some("1\t1\t1\t1\t1"));
    // Rows of one u, one after the other.
    assert_eq!(folder.out(&["eval", "--grid", "3", "saddle.json"]).lines().nth(1), Some("0\t1/2\t0\t1/2\t0"));
    let rows =
        parsed(&folder.out(&["eval", "--at", "1/2:1/3", "--derivatives", "1", "--json", "saddle.json"]));
    assert_eq!(rows[2], json!({"at": ["1/2", "1/3"], "order": [1, 0], "value": ["1", "0", "1/3"]}));
    assert_eq!(folder.refused(&["eval", "--at", "1/2", "saddle.json"]).1, 2);
    assert_eq!(folder.refused(&["eval", "--at", "2", "c.json"]).1, 1);
    assert_eq!(folder.refused(&["eval", "c.json"]).1, 2);
}

#[test]
fn profiles_have_the_events_of_known_curves() {
    let folder = Folder::new("profile");
    // y = x² has the curvature 2 at its vertex; run backwards the sign changes.
    folder.make("parabola.json", "P", "reparam(bezier((-1, 1), (0, -1), (1, 1)), -1, 1)");
    let table = "item 0 (P)\nevent    parameter  curvature\nmaximum  0          2.000000000\n";
    assert_eq!(folder.out(&["profile", "parabola.json"]), table);
    // y = x³: an inflection at 0, and extrema where 45 x⁴ = 1.
    folder.make("cubic.json", "C", "reparam(bezier((-1, -1), (-1/3, 1), (1/3, -1), (1, 1)), -1, 1)");
    for field in ["--exact", "--float"] {
        let events = parsed(&folder.out(&["profile", "--json", field, "cubic.json"]))[0]["events"].clone();
        let kinds: Vec<&str> =
            events.as_array().unwrap().iter().map(|e| e["kind"].as_str().unwrap()).collect();
        assert_eq!(kinds, ["minimum", "inflection", "maximum"]);
        let x = 45_f64.powf(-0.25);
        let curvature = 6.0 * x / (1.0 + 9.0 * x.powi(4)).powf(1.5);
        let bounds: Vec<f64> = [0, 1].map(|i| events[2]["curvature"][0][i].as_f64().unwrap()).to_vec();
        assert!(
            bounds[0] <= curvature && curvature <= bounds[1] && bounds[1] - bounds[0] < 1e-6,
            "{bounds:?}"
        );
    }
    // Corners and other kinds; a curve in space; a circle has no events.
    folder.make("corner.json", "K", "uniform(1, (0, 0), (1, 0), (1, 1))");
    assert!(folder.out(&["profile", "corner.json"]).contains("corner  1/2        turns by 1.570796 rad"));
    let smooth = folder.out(&["profile", "--smooth", "1.6", "corner.json"]);
    assert!(!smooth.contains("corner"));
    folder.make(
        "twisted.json",
        "T",
        "reparam(bezier((-1, 1, -1), (-1/3, -1/3, 1), (1/3, -1/3, -1), (1, 1, 1)), -1, 1)",
    );
    assert!(folder.out(&["profile", "twisted.json"]).contains(" 0 "));
    assert_eq!(folder.refused(&["profile", "--smooth", "nan", "corner.json"]).1, 1);
}

#[test]
fn pictures_are_drawn() {
    let folder = Folder::new("pictures");
    folder.make("arch.json", "C", "bezier((0, 0), (1, 2), (2, 0))");
    folder.out(&["profile", "--picture", "arch.svg", "arch.json"]);
    let svg = std::fs::read_to_string(folder.0.join("arch.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("minimum") && svg.contains("item 0 (C)"));
    folder.out(&["profile", "--picture", "arch.png", "--float", "arch.json"]);
    assert!(std::fs::read(folder.0.join("arch.png")).unwrap().starts_with(b"\x89PNG"));
    let said = folder.run(&["profile", "--picture", "arch.gif", "arch.json"]);
    assert_eq!((said.err.as_str(), said.code), ("symspline: arch.gif: pictures are .svg or .png\n", 2));
    // The same commands, the same bytes.
    folder.out(&["profile", "--picture", "again.svg", "arch.json"]);
    assert_eq!(std::fs::read_to_string(folder.0.join("again.svg")).unwrap(), svg);
}
