//! Standard input and output, exit codes, pipes, completions.

use crate::program::{Folder, Said};
use std::io::Read;

#[test]
fn broken_files_are_told_with_the_place() {
    let folder = Folder::new("broken");
    folder.write("cut.json", "{\"format\": \"symspline\",\n \"version\": 1, \"items\": [");
    let (error, code) = folder.refused(&["info", "cut.json"]);
    assert!(code == 4 && error.starts_with("symspline: cut.json:2:"), "{error}");
    folder.write(
        "knots.json",
        r#"{"format": "symspline", "version": 1, "items": [{"name": "C", "value": {"spline": {"field": "exact",
        "space": {"degree": 1, "knots": ["1", "1", "0", "0"]}, "points": [["1"], ["2"]]}}}]}"#,
    );
    let (error, code) = folder.refused(&["info", "knots.json"]);
    assert!(code == 4 && error.starts_with("symspline: knots.json: item 0 (C): "), "{error}");
    assert_eq!(folder.refused(&["info", "missing.json"]).1, 3);
    assert_eq!(folder.refused(&["info", "what.unknown"]).1, 3);
    let said = folder.given("nonsense", &["info"]);
    assert!(said.code == 4 && said.err.starts_with("symspline: standard input:1:"), "{}", said.err);
    assert_eq!(said.err.lines().count(), 1);
    assert_eq!(folder.refused(&["frobnicate"]).1, 2);
    assert_eq!(folder.refused(&["info", "--from", "unknown", "x"]).1, 2);
}

#[test]
fn commands_work_in_pipes() {
    let folder = Folder::new("pipes");
    let curve = folder.out(&["calc", "bezier((0, 0), (1, 2), (2, 0))"]);
    let tuned = folder.given(&curve, &["tune", "--alpha-values", "1,2", "--alpha-degree", "1", "-"]);
    assert_eq!((tuned.code, tuned.err.as_str()), (0, ""));
    // ∫ (1 + t) (2, 4 - 8 t) = (3, -2/3).
    assert_eq!(folder.given(&tuned.out, &["eval", "--at", "1"]).out, "1\t3\t-2/3\n");
}

#[test]
fn nobody_needs_to_read_to_the_end() {
    let folder = Folder::new("closed");
    folder.make("c.json", "C", "bezier((0, 0), (1, 2), (2, 0))");
    let mut child = folder.command(&["eval", "--grid", "200000", "c.json"]).spawn().unwrap();
    let mut start = [0; 4];
    child.stdout.take().unwrap().read_exact(&mut start).unwrap();
    let said = Said::from(child.wait_with_output().unwrap());
    assert_eq!((said.err.as_str(), said.code), ("", 0));
}

#[test]
fn help_and_completions_name_the_commands() {
    let folder = Folder::new("help");
    let commands =
        ["info", "eval", "calc", "profile", "tune", "shape", "sculpt", "subdivide", "convert", "completions"];
    let help = folder.out(&["--help"]);
    for command in commands {
        assert!(help.contains(&format!("\n  {command} ")), "{command}");
        let own = folder.out(&["help", command]);
        assert!(own.contains("Example") || command == "shape", "{command}");
    }
    for tool in ["reposition", "weight", "warp", "flatten", "bend", "constrain"] {
        assert!(folder.out(&["help", "shape", tool]).contains("Example"), "{tool}");
    }
    assert!(help.contains("JSON (json)") && help.contains("Exit codes"));
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = folder.out(&["completions", shell]);
        assert!(commands.iter().all(|command| script.contains(command)), "{shell}");
    }
    assert_eq!(folder.out(&["--version"]), format!("symspline {}\n", env!("CARGO_PKG_VERSION")));
    // Every function of expressions is told.
    let calc = folder.out(&["help", "calc"]);
    assert!(["diff(f[, k])", "iso_v(S, v)", "same(f, g)"].iter().all(|usage| calc.contains(usage)));
}
