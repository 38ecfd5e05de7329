//! The gallery shows every example, and every picture it has.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The names in a folder that end in `ending`, without it.
fn names(folder: &str, ending: &str) -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").file_name());
    entries.filter_map(|name| Some(name.to_string_lossy().strip_suffix(ending)?.to_owned())).collect()
}

/// The words of the gallery between `before` and `after`.
fn words(before: &str, after: &str) -> BTreeSet<String> {
    let text = include_str!("../docs/gallery.md");
    text.split(before).skip(1).filter_map(|rest| Some(rest.split_once(after)?.0.to_owned())).collect()
}

#[test]
fn every_example_is_shown() {
    let shown = words("--example ", "`");
    let shown = shown.iter().map(|line| line.split(' ').next().unwrap_or_default().to_owned());
    // "NAME" stands for all of them.
    assert_eq!(shown.filter(|name| name != "NAME").collect::<BTreeSet<_>>(), names("examples", ".rs"));
}

#[test]
fn every_picture_is_shown() {
    assert_eq!(words("(gallery/", ".png)"), names("docs/gallery", ".png"));
}
