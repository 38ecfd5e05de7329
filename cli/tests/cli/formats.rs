//! All formats: what is in the files of `files/tests/corpus`, and what comes back from each format that was written.

use crate::program::{CUBE, Folder, SADDLE};
use serde_json::{Value, json};

/// A file of the corpus.
fn corpus(file: &str) -> String {
    format!("{}/../files/tests/corpus/{file}", env!("CARGO_MANIFEST_DIR"))
}

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Kind and dimension of each entry.
fn kinds(folder: &Folder, file: &str) -> Vec<String> {
    let facts = parsed(&folder.out(&["info", "--json", file]));
    let kind = |entry: &Value| format!("{} {}", entry["kind"].as_str().unwrap(), entry["dimension"]);
    facts.as_array().unwrap().iter().map(kind).collect()
}

#[test]
fn files_made_by_hand_hold_what_their_text_says() {
    let folder = Folder::new("formats_read");
    let at = |file: &str, more: &[&str]| folder.out(&[&["eval", &corpus(file)][..], more].concat());
    // The vertex of the parabola (0, 0), (1, 2), (3, 0) in the middle: (1 + 3/4 - 1/2, 1).
    assert_eq!(at("geomdl/curves.geomdl.json", &["--item", "0", "--at", "1/2"]), "0.5\t1.25\t1\n");
    // The line of entity 110, the Bezier curve #20 with its name in three alphabets, and entries of the library's own form.
    let line = folder.out(&["info", "--json", &corpus("iges/by_hand.igs")]);
    assert!(line.contains("a long name / with delimiters! that is broken at the end of a line"), "{line}");
    assert_eq!(at("step/by_hand.step", &["--name", "Bézier α 😀", "--at", "1/2"]), "0.5\t2\t0.45\t-0.0625\n");
    assert_eq!(at("json/all.json", &["--name", "C", "--at", "1/6"]), "1/6\t1/2\t5/4\n");
    // The circle about (5, 6) with radius 7, read from standard input.
    let svg = std::fs::read_to_string(corpus("svg/shapes.svg")).unwrap();
    let said = folder.given(&svg, &["eval", "--from", "svg", "--item", "2", "--grid", "9"]);
    for row in said.out.lines() {
        let [_, x, y] = row.split('\t').map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>()[..] else {
            panic!()
        };
        assert!(((x - 5.0).hypot(y - 6.0) - 7.0).abs() < 1e-12, "{row}");
    }
    assert_eq!((said.out.lines().count(), said.err.as_str()), (9, ""));
    let kinds = |file: &str| kinds(&folder, &corpus(file));
    assert_eq!(kinds("obj/mixed.obj"), ["curve 3", "mesh 3"]);
    assert_eq!(kinds("geomdl/surface.geomdl.json").len(), 1);
    assert_eq!(kinds("dxf/periodic.dxf"), ["rational curve 2", "curve 2", "rational curve 3"]);
}

#[test]
fn every_file_is_told_of() {
    let folder = Folder::new("formats_info");
    let files = [
        "dxf/ezdxf.dxf",
        "iges/occt_curve.iges",
        "iges/occt_surface.iges",
        "step/occt_curve.step",
        "step/occt_surface.step",
    ];
    let more =
        ["obj/free_form.obj", "obj/mesh.obj", "svg/paths.svg", "json/all.json", "geomdl/curves.geomdl.json"];
    for file in files.into_iter().chain(more) {
        let facts = parsed(&folder.out(&["info", "--json", &corpus(file)]));
        let entries = facts.as_array().unwrap();
        assert!(!entries.is_empty());
        for entry in entries {
            // The half circle of `all.json` has a control point at infinity: its length is known, its box is not found.
            let is_measured = ["box", "value", "box_problem"].iter().any(|fact| entry.get(fact).is_some());
            assert_eq!(
                entry.get("box_problem").is_some(),
                file == "json/all.json" && entry["item"] == 6,
                "{entry}"
            );
            assert!(is_measured, "{file}: {entry}");
            let is_curve = entry["kind"].as_str().unwrap().ends_with("curve");
            assert_eq!(entry.get("length").is_some(), is_curve, "{file}: {entry}");
        }
        // For people there is a paragraph for each.
        let text = folder.out(&["info", &corpus(file)]);
        assert_eq!(text.split("\n\n").count(), entries.len(), "{text}");
        // Names do not steer terminals.
        assert!(
            !text.contains('\0') && (file != "json/all.json" || text.contains("item 9 (m\\u{0}): ")),
            "{text}"
        );
    }
}

#[test]
fn letters_become_curves() {
    let folder = Folder::new("letters");
    let font = corpus("font/letters.ttf");
    folder.out(&["convert", "--text", "o||", &font, "text.json"]);
    let facts = parsed(&folder.out(&["info", "--json", "text.json"]));
    let names: Vec<&str> =
        facts.as_array().unwrap().iter().map(|entry| entry["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["o", "o", "|", "|"]);
    // By fontTools: the o lies in [113, 1141] x [-29, 1147] with advance 1253, the bar in [260, 430] x [-483, 1565] with advance 690.
    let boxes: Vec<Vec<f64>> = facts
        .as_array()
        .unwrap()
        .iter()
        .map(|entry| {
            entry["box"]
                .as_array()
                .unwrap()
                .iter()
                .flat_map(|range| [0, 1].map(|i| range[i].as_f64().unwrap().round()))
                .collect()
        })
        .collect();
    assert!(boxes.contains(&vec![113.0, 1141.0, -29.0, 1147.0]), "{boxes:?}");
    assert_eq!(boxes[2], [1253.0 + 260.0, 1253.0 + 430.0, -483.0, 1565.0]);
    assert_eq!(boxes[3], [1943.0 + 260.0, 1943.0 + 430.0, -483.0, 1565.0]);
    // Outlines are exact, so they are drawn and computed with.
    assert!(folder.out(&["convert", "--exact", "--text", "8", &font, "-"]).contains("\"exact\""));
    folder.out(&["convert", "--text", "aé8", &font, "text.svg"]);
    // In SVG the y axis points down: letters are turned over for it.
    folder.out(&["convert", "--text", "|", "--turn-over", &font, "bar.svg"]);
    let bar = &parsed(&folder.out(&["info", "--json", "bar.svg"]))[0]["box"];
    assert_eq!(*bar, json!([[260.0, 430.0], [-1565.0, 483.0]]));
    folder.write("cube.json", CUBE);
    assert_eq!(folder.refused(&["convert", "--turn-over", "cube.json", "x.json"]).1, 1);
    // a has two contours, é three, 8 three.
    assert_eq!(kinds(&folder, "text.svg"), vec!["curve 2"; 8]);
    let from_pipe = std::process::Command::new("sh")
        .args(["-c", "symspline convert --text o - - < \"$0\"", &font])
        .env("PATH", crate::program::path())
        .output()
        .unwrap();
    assert_eq!(from_pipe.status.code(), Some(0));
    let cases: [(&[&str], i32, &str); 4] = [
        (&["convert", &font, "x.json"], 2, "a font holds letters, not curves"),
        (&["info", &font], 2, "a text must tell which"),
        (
            &["convert", "--text", "oß", &font, "x.json"],
            4,
            "letters.ttf: letter 'ß': the font has no such letter",
        ),
        (&["convert", "--text", "o", "text.svg", "x.json"], 4, "symspline: text.svg: font: "),
    ];
    for (arguments, code, problem) in cases {
        let (error, found) = folder.refused(arguments);
        assert!(found == code && error.contains(problem), "{arguments:?}: {found} {error}");
    }
    assert_eq!(folder.refused(&["convert", "text.json", "text.ttf"]).1, 3);
}

#[test]
fn curves_and_surfaces_come_back() {
    let folder = Folder::new("formats_back");
    folder.make("arch.json", "C", "uniform(2, (0, 0), (1, 2), (3, -1/2), (4, 0))");
    folder.make(
        "quarter.json",
        "Q",
        "curve(1 - param(0, 1) * param(0, 1), 2 * param(0, 1)) / (1 + param(0, 1) * param(0, 1))",
    );
    folder.write("saddle.json", SADDLE);
    let near = |text: &str, other: &str, tolerance: f64| {
        let numbers = |text: &str| -> Vec<f64> {
            let value = |x: &str| x.parse::<symspline::Q>().unwrap().to_f64();
            text.split_whitespace().map(|x| x.parse().unwrap_or_else(|_| value(x))).collect()
        };
        let (text, other) = (numbers(text), numbers(other));
        // Formats of space have a third coordinate, 0.
        text.iter().zip(&other).all(|(x, y)| (x - y).abs() <= tolerance)
    };
    let eval = |file: &str, at: &str| folder.out(&["eval", "--at", at, file]);
    for format in ["geomdl.json", "obj", "svg", "dxf", "step", "iges", "json"] {
        for (curve, tolerance) in [("arch", 1e-14), ("quarter", if format == "svg" { 1e-5 } else { 1e-14 })] {
            let file = format!("{curve}.{format}");
            if format != "json" {
                folder.out(&["convert", &format!("{curve}.json"), &file]);
            }
            // SVG has Bezier curves alone: the parameters may run differently, the ends are the same.
            let places: &[&str] = if format == "svg" { &["0"] } else { &["0", "1/3", "9/10"] };
            for at in places {
                let (now, before) = (eval(&file, at), eval(&format!("{curve}.json"), at));
                assert!(near(&now, &before, tolerance), "{file}: {now} {before}");
            }
            let length =
                |file: &str| parsed(&folder.out(&["info", "--json", file]))[0]["length"].as_f64().unwrap();
            assert!(
                (length(&file) - length(&format!("{curve}.json"))).abs() < tolerance.max(1e-10),
                "{file}"
            );
        }
        if !["svg", "dxf", "json"].contains(&format) {
            let file = format!("saddle.{format}");
            folder.out(&["convert", "saddle.json", &file]);
            assert!(
                near(
                    &eval(&file, "1/2:1/3"),
                    "0.5 0.3333333333333333 0.5 0.3333333333333333 0.16666666666666666",
                    1e-14
                ),
                "{file}"
            );
        }
    }
    // Commands read and write every format, and fit in pipes: what is not JSON must be told.
    folder.out(&[
        "tune",
        "--float",
        "--alpha-values",
        "1,2",
        "--alpha-degree",
        "1",
        "arch.step",
        "-o",
        "tuned.iges",
    ]);
    let svg = folder.out(&["convert", "arch.json", "-", "--to", "svg"]);
    assert!(
        svg.contains("<svg")
            && folder.given(&svg, &["info", "--from", "svg"]).out.contains("curve in 2 dimensions")
    );
    let said = folder.given(&svg, &["calc", "at(C, 0)", "--let", "C=-", "--from", "svg"]);
    assert_eq!(said.out, "(0, 0)\n", "{}", said.err);
}

#[test]
fn surfaces_become_triangles_and_meshes_files() {
    let folder = Folder::new("formats_mesh");
    folder.write("saddle.json", SADDLE);
    folder.write("cube.json", CUBE);
    for shape in ["saddle", "cube"] {
        let made = |ending: &str| {
            let file = format!("{shape}.{ending}");
            folder.out(&["convert", &format!("{shape}.json"), &file]);
            std::fs::read(folder.0.join(file)).unwrap()
        };
        let stl = made("stl");
        let count = u32::from_le_bytes(stl[80..84].try_into().unwrap()) as usize;
        assert!(stl.len() == 84 + 50 * count && count >= 2, "{count} triangles, {} bytes", stl.len());
        let ply = made("ply");
        assert!(ply.starts_with(b"ply\n"));
        let gltf = made("glb");
        assert!(gltf.starts_with(b"glTF\x02\0\0\0"));
        assert_eq!(u32::from_le_bytes(gltf[8..12].try_into().unwrap()) as usize, gltf.len());
        if shape == "cube" {
            // Twelve triangles: two for each side.
            assert_eq!(count, 12);
        }
    }
    folder.out(&["convert", "cube.json", "cube.obj"]);
    folder.out(&["subdivide", "--exact", "cube.obj", "-o", "fine.obj"]);
    let facts = &parsed(&folder.out(&["info", "--json", "fine.obj"]))[0];
    assert_eq!(
        (&facts["kind"], &facts["vertices"], &facts["closed"]),
        (&json!("mesh"), &json!(26), &json!(true))
    );
}

#[test]
fn what_has_no_room_is_refused_and_nothing_is_written() {
    let folder = Folder::new("formats_refused");
    folder.write("saddle.json", SADDLE);
    folder.write("cube.json", CUBE);
    folder.make("number.json", "n", "1/3");
    folder.write("given.stl", "solid nothing\nendsolid nothing\n");
    let cases = [
        ("saddle.json", "x.svg", 1, "x.svg: item 0: SVG files hold no "),
        ("saddle.json", "x.dxf", 1, "x.dxf: item 0: DXF files hold no "),
        ("cube.json", "x.step", 1, "x.step: item 0: STEP files hold no "),
        ("cube.json", "x.iges", 1, "x.iges: item 0: IGES files hold no "),
        ("number.json", "x.obj", 1, "x.obj: item 0: OBJ files hold no "),
        ("number.json", "x.stl", 1, "x.stl: item 0: STL files hold no "),
        ("cube.json", "x.xyz", 3, "x.xyz: no format is known by this name; these are: "),
        ("given.stl", "x.json", 3, "given.stl: STL files are not read"),
    ];
    for (from, to, code, problem) in cases {
        let (error, found) = folder.refused(&["convert", from, to]);
        assert!(
            found == code && error.starts_with(&format!("symspline: {problem}")),
            "{from} {to}: {found} {error}"
        );
        assert!(!folder.0.join(to).exists());
    }
    // A value that cannot be written is refused; no file is at fault.
    let (error, code) = folder.refused(&["calc", "bezier((0, 0), (1e400, 1))", "-o", "x.svg"]);
    assert_eq!((error.as_str(), code), ("symspline: x.svg: item 0: value 0 is not a finite number\n", 1));
}

#[test]
fn broken_files_of_each_format_are_told_with_the_place() {
    let folder = Folder::new("formats_broken");
    let cases = [
        ("cut.svg", "<svg>\n<path d='M0 0 L'/></svg>", "cut.svg:2"),
        ("v.obj", "v 1 2 3\nv 1 x 3\n", "v.obj:2"),
        ("cut.step", "ISO-10303-21;\nHEADER;\n", "cut.step"),
        (
            "cut.geomdl.json",
            "{\"shape\": {\"type\": \"curve\",\n \"data\": [{\"degree\": }]}}",
            "cut.geomdl.json:2:",
        ),
        ("cut.dxf", "0\nSECTION\n2\nENTITIES\n0\nSPLINE\n71\nthree\n", "cut.dxf:8"),
    ];
    for (file, text, place) in cases {
        folder.write(file, text);
        for command in [&["info"][..], &["eval", "--at", "0"], &["profile"]] {
            let (error, code) = folder.refused(&[command, &[file]].concat());
            assert!(code == 4 && error.starts_with(&format!("symspline: {place}")), "{code} {error}");
            assert_eq!(error.lines().count(), 1, "{error}");
        }
    }
}
