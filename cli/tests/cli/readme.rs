//! The commands of the README, in their order, in one folder: each gives what stands below it.

use crate::program::{self, Folder};
use std::process::Command;

const README: &str = include_str!("../../README.md");

/// The commands in blocks of the kind `console`, with the lines that stand below them.
fn commands() -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    let blocks = README.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    for line in blocks.flat_map(str::lines) {
        match (line.strip_prefix("$ "), line.strip_prefix("> "), found.last_mut()) {
            (Some(command), ..) => found.push((command.to_owned(), String::new())),
            (_, Some(more), Some((command, _))) => *command += &format!("\n{more}"),
            (.., Some((_, output))) => *output += &format!("{line}\n"),
            (.., None) => panic!("a block starts with {line}"),
        }
    }
    found
}

#[test]
fn commands_of_the_readme_give_what_it_says() {
    let folder = Folder::new("readme");
    let commands = commands();
    assert!(commands.len() > 30);
    for (command, output) in commands {
        let run = Command::new("sh")
            .args(["-c", &command])
            .current_dir(&folder.0)
            .env("PATH", program::path())
            .output()
            .unwrap();
        let error = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(String::from_utf8_lossy(&run.stdout), output, "{command}\n{error}");
        assert!(!error.contains("symspline: ") && !error.contains("error: "), "{command}\n{error}");
    }
}
