//! No bytes make a reader panic or hang, and what it accepts can be written and read again.
//!
//! Each format that is read has a folder of small files, `tests/corpus/<first ending>`. They are changed at random, with a fixed seed,
//! for `SYMSPLINE_FUZZ_SECONDS` a format, 2 unless told. `SYMSPLINE_FUZZ_SEED` draws others. The same law is checked by `fuzz/` with libFuzzer.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod law;
mod mutate;

use mutate::{Dice, mutated};
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};
use symspline_files::Format;

/// How long an answer may take, in this profile and with all formats at once.
const PATIENCE: Duration = Duration::from_secs(20);
/// How much memory all of it may take, in kilobytes.
const MEMORY: u64 = 1 << 21;

fn corpus(format: Format) -> Vec<Vec<u8>> {
    let name = if format == Format::Geomdl { "geomdl" } else { format.endings()[0] };
    let name = if format == Format::Font { "font" } else { name };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus").join(name);
    let files = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<_> = files.map(|file| file.unwrap().path()).collect();
    paths.retain(|path| !path.to_string_lossy().contains("LICENSE"));
    paths.sort();
    paths.iter().map(|path| fs::read(path).unwrap()).collect()
}

fn read_formats() -> impl Iterator<Item = Format> {
    Format::all().filter(|format| format.is_read())
}

fn setting(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().map_or(otherwise, |text| text.parse().unwrap())
}

#[test]
fn files_of_the_corpus_are_accepted() {
    for format in read_formats() {
        let files = corpus(format);
        assert!(!files.is_empty(), "{format:?} has no corpus");
        for (i, file) in files.iter().enumerate() {
            let refused = law::read(file, format).err().map(|error| error.to_string());
            assert!(law::holds(file, format), "{format:?}, file {i}: {refused:?}");
        }
    }
}

#[test]
fn no_bytes_make_a_reader_panic() {
    std::thread::scope(|scope| {
        let threads: Vec<_> = read_formats().map(|format| scope.spawn(move || attacked(format))).collect();
        for thread in threads {
            thread.join().unwrap();
        }
    });
    if let Ok(status) = fs::read_to_string("/proc/self/status") {
        let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
        let peak: u64 = peak.trim().trim_end_matches(" kB").parse().unwrap();
        assert!(peak < MEMORY, "{peak} kB");
    }
}

fn attacked(format: Format) {
    let files = corpus(format);
    let mut dice = Dice(setting("SYMSPLINE_FUZZ_SEED", 20262));
    let end = Instant::now() + Duration::from_secs(setting("SYMSPLINE_FUZZ_SECONDS", 2));
    let (mut count, mut accepted) = (0, 0);
    while Instant::now() < end {
        let [file, other] = [(); 2].map(|()| &files[dice.below(files.len())]);
        let bytes = mutated(file, other, &mut dice);
        let start = Instant::now();
        let held = catch_unwind(AssertUnwindSafe(|| law::holds(&bytes, format)));
        let spent = start.elapsed();
        let Ok(held) = held else {
            panic!("{format:?} fails on its case {count}:\n{}", String::from_utf8_lossy(&bytes));
        };
        assert!(spent < PATIENCE, "{format:?} took {spent:?}:\n{}", String::from_utf8_lossy(&bytes));
        (count, accepted) = (count + 1, accepted + usize::from(held));
    }
    // Changes that all are refused would show little.
    assert!(accepted * 1000 > count, "{format:?}: {accepted} of {count} are accepted");
    eprintln!("{format:?}: {accepted} of {count} changed files are accepted");
}
