//! The floors of the library: a module uses only what stands above it.
//!
//! `src/lib.rs` lists the modules from the ground up, and so does each module that has modules of its own. Of two
//! modules, follow the paths from the crate down to where they part: there the one that is used must be listed first.
//! A module may use what its ancestors hold and, to pass it on, what its own modules hold. Checked are paths in code
//! that begin with `crate::`, `super::` or `self::`; comments, texts and `#[cfg(test)]` items are not code here. Method
//! calls have no path, so a method defined further down is not seen. Files named `tests.rs` are left alone.
//!
//! Besides, only the edges read, write and print, and a long file needs a reason.

use std::collections::{BTreeMap, HashMap};
use std::fs;
use std::path::Path;

/// Modules that may touch files and the terminal.
const EDGES: [&str; 2] = ["io", "plot"];

/// The number of lines at which a file needs a reason.
const LINES: usize = 400;

/// Longer files, each with the reason.
const LONGER: [(&str, &str); 0] = [];

/// The sources: paths below `src` with `/`, and texts.
type Tree = BTreeMap<String, String>;

fn read(folder: &Path, prefix: &str, tree: &mut Tree) {
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry")) {
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            read(&entry.path(), &format!("{name}/"), tree);
        } else if name.ends_with(".rs") {
            tree.insert(name, fs::read_to_string(entry.path()).expect("a text"));
        }
    }
}

/// The module path of a file: `ops/mod.rs` and `ops.rs` are `["ops"]`, `lib.rs` is the crate.
fn module(file: &str) -> Vec<&str> {
    let stem = file.trim_end_matches(".rs");
    let stem = stem.strip_suffix("/mod").unwrap_or(stem);
    if stem == "lib" { Vec::new() } else { stem.split('/').collect() }
}

/// The text with comments, text and character literals blanked and without `#[cfg(test)]` items; lines stay in place.
fn code(source: &str) -> String {
    let bytes = source.as_bytes();
    let mut code = bytes.to_vec();
    let mut at = 0;
    while at < bytes.len() {
        let rest = &source[at..];
        let end = at + literal(rest).unwrap_or(0);
        code[at..end].iter_mut().filter(|b| **b != b'\n').for_each(|b| *b = b' ');
        at = end.max(at + rest.chars().next().map_or(1, char::len_utf8));
    }
    let mut code = String::from_utf8(code).expect("whole literals are blanked");
    while let Some(start) = code.find("#[cfg(test)]") {
        let end = start + item(&code[start..]);
        let blank: String = code[start..end].chars().map(|c| if c == '\n' { c } else { ' ' }).collect();
        code.replace_range(start..end, &blank);
    }
    code
}

/// The length of the comment or literal that `text` starts with.
fn literal(text: &str) -> Option<usize> {
    let until =
        |from: usize, close: &str| text[from..].find(close).map_or(text.len(), |i| from + i + close.len());
    let quoted = |quote: char| {
        let mut escaped = false;
        let close = |(i, c): (usize, char)| {
            let closes = c == quote && !escaped;
            escaped = c == '\\' && !escaped;
            closes.then_some(i + c.len_utf8())
        };
        text.char_indices().skip(1).find_map(close).unwrap_or(text.len())
    };
    if text.starts_with("//") {
        return Some(text.find('\n').unwrap_or(text.len()));
    }
    if text.starts_with("/*") {
        return Some(until(2, "*/"));
    }
    for hashes in 0..3 {
        let hashes = "#".repeat(hashes);
        let open = format!("r{hashes}\"");
        if text.starts_with(&open) {
            return Some(until(open.len(), &format!("\"{hashes}")));
        }
    }
    match text.chars().next()? {
        '"' => Some(quoted('"')),
        // A character, not a lifetime.
        '\'' if text[1..].starts_with('\\') || text.chars().nth(2) == Some('\'') => Some(quoted('\'')),
        _ => None,
    }
}

/// The length of the item that `text` starts with: to its first `;`, or through its braces.
fn item(text: &str) -> usize {
    let mut depth = 0;
    for (i, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 1 => return i + 1,
            '}' => depth -= 1,
            ';' if depth == 0 => return i + 1,
            _ => {}
        }
    }
    text.len()
}

/// The modules that a text declares as files of their own, in order.
fn declared(code: &str) -> Vec<String> {
    let declaration = |line: &str| {
        let (visibility, name) = line.trim().strip_suffix(';')?.split_once("mod ")?;
        let visible = visibility.is_empty() || visibility.starts_with("pub") && visibility.ends_with(' ');
        visible.then(|| name.trim().to_string())
    };
    code.lines().filter_map(declaration).collect()
}

/// The paths in a text that begin with `root::`, groups in braces expanded, each with its line.
fn paths(code: &str, root: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices(&format!("{root}::")) {
        let inside = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
        if !code[..at].ends_with(inside) {
            let (line, mut here) = (code[..at].matches('\n').count() + 1, Vec::new());
            expand(&code[at..], "", &mut here);
            found.extend(here.into_iter().map(|path| (line, path)));
        }
    }
    found
}

/// Adds the paths of the import tree that `text` starts with, each behind `prefix`; returns the length of the tree.
fn expand(text: &str, prefix: &str, found: &mut Vec<String>) -> usize {
    let start = text.len() - text.trim_start().len();
    if text[start..].starts_with('{') {
        let mut at = start + 1;
        loop {
            at += text[at..].len() - text[at..].trim_start_matches([',', ' ', '\n']).len();
            if text[at..].starts_with('}') || at >= text.len() {
                return at + 1;
            }
            at += expand(&text[at..], prefix, found).max(1);
            // A new name, if any.
            at += text[at..].find([',', '}']).unwrap_or(text.len() - at);
        }
    }
    let name = |c: char| c.is_alphanumeric() || c == '_' || c == '*';
    let end = start + text[start..].find(|c| !name(c)).unwrap_or(text.len() - start);
    let path = format!("{prefix}{}", &text[start..end]);
    match text[end..].strip_prefix("::") {
        Some(rest) if rest.starts_with(|c: char| name(c) || c == '{') => {
            end + 2 + expand(rest, &format!("{path}::"), found)
        }
        _ => {
            found.push(path);
            end
        }
    }
}

/// What is wrong with a tree of sources, as `file:line: what`.
fn violations(tree: &Tree) -> Vec<String> {
    let tree: Vec<(&str, &str, String)> = tree
        .iter()
        .filter(|(file, _)| !file.ends_with("/tests.rs"))
        .map(|(file, text)| (file.as_str(), text.as_str(), code(text)))
        .collect();
    // The place of every module in the list of its parent.
    let mut places: HashMap<Vec<String>, usize> = HashMap::new();
    for (file, _, code) in &tree {
        for (place, name) in declared(code).into_iter().enumerate() {
            places.insert(module(file).into_iter().map(String::from).chain([name]).collect(), place);
        }
    }
    let mut wrong = Vec::new();
    for (file, text, code) in &tree {
        let user: Vec<String> = module(file).into_iter().map(String::from).collect();
        if !user.is_empty() && !places.contains_key(&user) {
            wrong.push(format!("{file}:1: no module lists this file"));
            continue;
        }
        let internal = ["crate", "super", "self"].into_iter().flat_map(|root| paths(code, root));
        for (line, path) in internal {
            if let Some(what) = forbidden(&user, &path, &places) {
                wrong.push(format!("{file}:{line}: {path} {what}"));
            }
        }
        if !user.first().is_some_and(|floor| EDGES.contains(&floor.as_str())) {
            wrong.extend(
                touched(code)
                    .into_iter()
                    .map(|(line, what)| format!("{file}:{line}: {what} below the edges")),
            );
        }
        let lines = text.lines().count();
        if lines > LINES && !LONGER.iter().any(|(long, _)| long == file) {
            wrong
                .push(format!("{file}:{lines}: more than {LINES} lines: look for the second concept inside"));
        }
    }
    wrong
}

/// Why module `user` may not use `path`, if so.
fn forbidden(user: &[String], path: &str, places: &HashMap<Vec<String>, usize>) -> Option<String> {
    let mut used: Vec<String> = user.to_vec();
    let mut names = path.split("::").peekable();
    while let Some(root) = names.next_if(|name| ["crate", "super", "self"].contains(name)) {
        match root {
            "crate" => used.clear(),
            "super" => used.truncate(used.len().saturating_sub(1)),
            _ => {}
        }
    }
    for name in names {
        used.push(name.to_string());
        if !places.contains_key(&used) {
            used.pop();
            break;
        }
    }
    if used.is_empty() && !user.is_empty() && path.starts_with("crate::") {
        return Some("goes through the crate's own exports: name the module".into());
    }
    let parted = user.iter().zip(&used).take_while(|(a, b)| a == b).count();
    if parted == user.len() || parted == used.len() {
        return None;
    }
    let [mine, theirs] = [user, &used].map(|path| places[&path[..=parted]]);
    (theirs > mine).then(|| format!("stands below {}", user[..=parted].join("::")))
}

/// Reading, writing and printing in a text.
fn touched(code: &str) -> Vec<(usize, String)> {
    let modules = ["fs", "io", "net", "process", "env"];
    let outside = |path: &String| modules.contains(&path.split("::").nth(1).unwrap_or_default());
    let mut touched: Vec<_> = paths(code, "std").into_iter().filter(|(_, path)| outside(path)).collect();
    for (line, text) in (1..).zip(code.lines()) {
        let printed =
            ["println!", "print!", "eprintln!", "eprint!"].into_iter().find(|name| text.contains(name));
        touched.extend(printed.map(|name| (line, name.to_string())));
    }
    touched
}

#[test]
fn modules_use_only_what_stands_above_them() {
    let mut tree = Tree::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), "", &mut tree);
    assert!(tree.contains_key("lib.rs"), "no sources found");
    let wrong = violations(&tree);
    assert!(wrong.is_empty(), "\n{}\n", wrong.join("\n"));
}

/// A small library in order, with `text` added to the file `at`.
fn with(at: &str, text: &str) -> Vec<String> {
    let sources = [
        ("lib.rs", "pub mod ground;\npub mod ops;\nmod top;\npub mod plot;\npub use ground::G;\n"),
        ("ground.rs", "//! See crate::top.\nmod fine;\nuse fine::F;\n"),
        ("ground/fine.rs", "use super::G;\n"),
        ("ops/mod.rs", "pub(crate) mod first;\npub mod second;\n"),
        ("ops/first.rs", "use crate::ground::{G, fine::F as E};\n"),
        ("ops/second.rs", "use super::first::{self, f};\nuse crate::ops::first::g;\n"),
        ("top.rs", "fn f() { crate::ops::second::f::<u8>(\"crate::plot\", 'x', '\"') } // crate::plot\n"),
        ("plot/mod.rs", "use std::fs;\n"),
    ];
    let mut tree: Tree = sources.into_iter().map(|(file, text)| (file.into(), text.into())).collect();
    tree.entry(at.into()).or_default().push_str(text);
    violations(&tree)
}

#[test]
fn an_ordered_library_passes() {
    assert_eq!(with("lib.rs", ""), [""; 0]);
    assert_eq!(
        with("ground.rs", "#[cfg(test)]\nmod tests {\n use crate::top::f;\n fn g() { println!(); }\n}\n"),
        [""; 0]
    );
}

#[test]
fn disorder_is_found() {
    let only = |at: &str, text: &str, message: &str| assert_eq!(with(at, text), [message]);
    only("ground.rs", "use crate::top::f;\n", "ground.rs:4: crate::top::f stands below ground");
    only("ground.rs", "fn f() { super::ops::g() }\n", "ground.rs:4: super::ops::g stands below ground");
    only(
        "ops/first.rs",
        "use crate::ops::second::f;\n",
        "ops/first.rs:2: crate::ops::second::f stands below ops::first",
    );
    only(
        "ops/first.rs",
        "use super::second::f;\n",
        "ops/first.rs:2: super::second::f stands below ops::first",
    );
    only(
        "ground/fine.rs",
        "use crate::{ground::G, top::T};\n",
        "ground/fine.rs:2: crate::top::T stands below ground",
    );
    only(
        "top.rs",
        "use crate::G;\n",
        "top.rs:2: crate::G goes through the crate's own exports: name the module",
    );
    only("stray.rs", "", "stray.rs:1: no module lists this file");
}

#[test]
fn input_output_and_length_are_found() {
    let only = |at: &str, text: &str, message: &str| assert_eq!(with(at, text), [message]);
    only("top.rs", "use std::fs::File;\n", "top.rs:2: std::fs::File below the edges");
    only("top.rs", "use std::{fmt, io::Write};\n", "top.rs:2: std::io::Write below the edges");
    only("ops/first.rs", "fn f() { println!() }\n", "ops/first.rs:2: println! below the edges");
    let long = "\n".repeat(400);
    only("top.rs", &long, "top.rs:401: more than 400 lines: look for the second concept inside");
}
