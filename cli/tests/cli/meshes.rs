//! `subdivide` and `convert`.

use crate::program::{CUBE, Folder, SADDLE};
use serde_json::Value;

fn mesh(text: &str) -> Value {
    serde_json::from_str::<Value>(text).unwrap()["items"][0]["value"]["mesh"].clone()
}

#[test]
fn cubes_are_subdivided() {
    let folder = Folder::new("subdivide");
    folder.write("cube.json", CUBE);
    let counts = |arguments: &[&str]| {
        let text = folder.out(&[&["subdivide", "cube.json"][..], arguments].concat());
        let mesh = mesh(&text);
        (mesh["points"].as_array().unwrap().len(), mesh["faces"].as_array().unwrap().len())
    };
    // Catmull-Clark: a vertex for each vertex, edge and face; a face for each corner. Doo-Sabin: a vertex for each corner.
    assert_eq!(counts(&[]), (26, 24));
    assert_eq!(counts(&["--depth", "3"]), (386, 384));
    assert_eq!(counts(&["--scheme", "doo-sabin"]), (24, 26));
    assert_eq!(counts(&["--scheme", "doo-sabin", "--depth", "2"]), (96, 98));
    // The limit of a vertex with three quadrilaterals: (9 v + 4 Σ e + Σ f) / 24, here 1/2 of the vertex.
    let limit = mesh(&folder.out(&["subdivide", "--depth", "0", "--limit", "cube.json"]));
    assert_eq!(limit["points"][7], serde_json::json!(["1/2", "1/2", "1/2"]));
    // The new vertex of a corner: (v (n - 3) + 2 R + Q) / n with R = (1/3, 1/3, 1/3) + ..., by hand 5/9.
    let fine = mesh(&folder.out(&["subdivide", "cube.json"]));
    let corner = serde_json::json!(["5/9", "5/9", "5/9"]);
    assert!(fine["points"].as_array().unwrap().contains(&corner));
    assert_eq!(folder.refused(&["subdivide", "--depth", "60", "cube.json"]).1, 1);
    folder.write("s.json", SADDLE);
    assert_eq!(folder.refused(&["subdivide", "s.json"]).1, 1);
}

#[test]
fn boundaries_are_open_smooth_or_have_corners() {
    let folder = Folder::new("boundaries");
    folder.write(
        "square.json",
        r#"{"format": "symspline", "version": 1, "items": [{"value": {"mesh": {"field": "float",
        "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "faces": [[0,1,2,3]]}}}]}"#,
    );
    let corner = |boundary: &str| {
        let fine = mesh(&folder.out(&["subdivide", "--boundary", boundary, "square.json"]));
        fine["points"].as_array().unwrap().contains(&serde_json::json!([0.0, 0.0, 0.0]))
    };
    assert!(corner("corners") && !corner("smooth"));
    assert_eq!(folder.refused(&["subdivide", "--boundary", "round", "square.json"]).1, 2);
    // Sixteen points of a square lattice are the control points of one bicubic patch, over the face in the middle.
    let points: Vec<String> = (0..16).map(|i| format!("[{}, {}, 0]", i % 4, i / 4)).collect();
    let faces: Vec<String> =
        [0, 1, 2, 4, 5, 6, 8, 9, 10].map(|i| format!("[{i}, {}, {}, {}]", i + 1, i + 5, i + 4)).to_vec();
    folder.write(
        "lattice.json",
        &format!(
            r#"{{"format": "symspline", "version": 1, "items": [{{"value": {{"mesh": {{"field": "exact",
            "points": [{}], "faces": [{}]}}}}}}]}}"#,
            points.join(", "),
            faces.join(", ")
        ),
    );
    for (boundary, range) in [("open", [1.0, 2.0]), ("smooth", [0.0, 3.0])] {
        folder.out(&["subdivide", "--limit", "--boundary", boundary, "lattice.json", "-o", "fine.json"]);
        let facts: Value = serde_json::from_str(&folder.out(&["info", "--json", "fine.json"])).unwrap();
        assert_eq!(facts[0]["box"], serde_json::json!([range, range, [0.0, 0.0]]), "{boundary}");
    }
}

#[test]
fn files_are_converted() {
    let folder = Folder::new("convert");
    folder.write("cube.json", CUBE);
    folder.out(&["convert", "--float", "cube.json", "float.json"]);
    assert!(folder.out(&["info", "float.json"]).starts_with("item 0: float mesh"));
    folder.out(&["convert", "--exact", "float.json", "exact.json"]);
    assert_eq!(folder.out(&["convert", "exact.json", "-"]), folder.out(&["convert", "cube.json", "-"]));
    let cube = folder.given(CUBE, &["convert", "--from", "json", "--to", "json", "-", "-"]);
    assert_eq!((cube.code, &cube.out), (0, &folder.out(&["convert", "cube.json", "-"])));
    assert_eq!(folder.refused(&["convert", "cube.json", "cube.unknown"]).1, 3);
    assert_eq!(folder.refused(&["convert", "cube.unknown", "cube.json"]).1, 3);
    assert_eq!(folder.refused(&["convert", "cube.json", "nowhere/cube.json"]).1, 3);
    assert_eq!(folder.refused(&["convert", "--to", "unknown", "cube.json", "-"]).1, 2);
}
