//! The commands of the README, in their order, in one folder: each gives what stands below it. And those of the project's README.

use crate::program::{self, Folder};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const README: &str = include_str!("../../README.md");

/// The README of the project, whose lines run in its folder.
const FRONT: &str = include_str!("../../../README.md");

fn shell(command: &str, folder: &Path) -> Output {
    let mut shell = Command::new("sh");
    shell.args(["-c", command]).current_dir(folder).env("PATH", program::path()).output().unwrap()
}

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
        let run = shell(&command, &folder.0);
        let error = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(String::from_utf8_lossy(&run.stdout), output, "{command}\n{error}");
        assert!(!error.contains("symspline: ") && !error.contains("error: "), "{command}\n{error}");
    }
}

#[test]
fn commands_of_the_front_page_do_what_they_should() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    fs::create_dir_all(root.join("target")).unwrap();
    let section = FRONT.split("## From the command line").nth(1).unwrap();
    let block = section.split("```sh\n").nth(1).unwrap().split("```").next().unwrap();
    let commands: Vec<_> = block.lines().filter(|line| line.starts_with("symspline ")).collect();
    assert!(commands.len() > 5);
    for command in commands {
        let run = shell(command, &root);
        let error = String::from_utf8_lossy(&run.stderr);
        assert!(run.status.success() && !error.contains("symspline: "), "{command}\n{error}");
        // What is drawn or written is there, and what is not is said.
        let files = command.split(' ').filter(|word| word.starts_with("target/") && !word.contains(':'));
        let written: Vec<_> = files.map(|file| fs::metadata(root.join(file)).unwrap().len()).collect();
        assert!(written.iter().all(|length| *length > 0), "{command}");
        assert!(!written.is_empty() || !run.stdout.is_empty(), "{command}");
    }
}
