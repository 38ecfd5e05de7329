//! Spoilt files are refused or read, without panic and in time.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};
use symspline_files::{Format, from_bytes, to_bytes};

const MUTATIONS: usize = 1200;

/// Words that are put in the place of numbers.
const WORDS: [&str; 24] = [
    "NaN",
    "inf",
    "1e999",
    "-1e999",
    "1e-999",
    "-1",
    "0",
    "1",
    "2",
    "3",
    "4294967295",
    "99999999999999999999",
    "9223372036854775807",
    "1e308",
    "5e-324",
    "-0.0",
    "0.1",
    "'",
    "(",
    ")",
    ",",
    ";",
    "#1",
    "$",
];

struct Dice(u64);

impl Dice {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound.max(1) as u64) as usize
    }

    fn range(&mut self, length: usize, longest: usize) -> std::ops::Range<usize> {
        let start = self.below(length);
        start..(start + 1 + self.below(longest)).min(length)
    }

    /// The place of some number of a text: in IGES it keeps its columns.
    fn number(&mut self, bytes: &[u8]) -> std::ops::Range<usize> {
        let digit = |b: &u8| b.is_ascii_digit() || b"+-.#".contains(b);
        let from = self.below(bytes.len());
        let start = from + bytes[from..].iter().position(digit).unwrap_or(0);
        start..start + bytes[start..].iter().take_while(|b| digit(b)).count()
    }

    fn spoil(&mut self, bytes: &mut Vec<u8>, other: &[u8]) {
        if bytes.is_empty() {
            return;
        }
        match self.below(8) {
            0 => bytes.truncate(self.below(bytes.len())),
            1 => {
                let at = self.below(bytes.len());
                bytes[at] ^= 1 << self.below(8);
            }
            2 => drop(bytes.drain(self.range(bytes.len(), 200))),
            3 => {
                let (copied, at) = (self.range(bytes.len(), 400), self.below(bytes.len()));
                let copied = bytes[copied].to_vec();
                bytes.splice(at..at, copied);
            }
            4 => {
                let (copied, at) = (self.range(other.len(), 400), self.below(bytes.len()));
                bytes.splice(at..at, other[copied].iter().copied());
            }
            5 | 6 => {
                let (place, word) = (self.number(bytes), WORDS[self.below(WORDS.len())]);
                bytes.splice(place, word.bytes());
            }
            _ => {
                // One digit for another: counts, pointers and references go wrong, columns stay.
                let place = self.number(bytes);
                bytes[place]
                    .iter_mut()
                    .filter(|b| b.is_ascii_digit())
                    .for_each(|b| *b = b'0' + self.below(10) as u8);
            }
        }
    }
}

fn spoilt_files_are_no_harm(folder: &str, format: Format) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus").join(folder);
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()).collect();
    paths.sort();
    let corpus: Vec<Vec<u8>> = paths.iter().map(|path| fs::read(path).unwrap()).collect();
    let (mut dice, mut read, mut refused) = (Dice(0x9e37_79b9_7f4a_7c15), 0, 0);
    for original in &corpus {
        assert!(!from_bytes(original, format).unwrap().is_empty());
        for _ in 0..MUTATIONS {
            let mut bytes = original.clone();
            for _ in 0..1 + dice.below(3) {
                let other = &corpus[dice.below(corpus.len())];
                dice.spoil(&mut bytes, other);
            }
            let start = Instant::now();
            match from_bytes(&bytes, format) {
                Ok(entries) => {
                    read += 1;
                    // What was read and has room is read again.
                    if let Ok(written) = to_bytes(&entries, format) {
                        assert_eq!(from_bytes(&written, format).unwrap().len(), entries.len());
                    }
                }
                Err(error) => {
                    refused += 1;
                    assert!(!error.to_string().is_empty());
                }
            }
            assert!(start.elapsed() < Duration::from_secs(5), "{}", String::from_utf8_lossy(&bytes));
        }
    }
    // Neither is rare: the mutations are not all trivial.
    assert!(read * 50 > refused && refused * 50 > read, "{read} are read, {refused} refused");
}

#[test]
fn spoilt_dxf_is_no_harm() {
    spoilt_files_are_no_harm("dxf", Format::Dxf);
}

#[test]
fn spoilt_step_is_no_harm() {
    spoilt_files_are_no_harm("step", Format::Step);
}

#[test]
fn spoilt_iges_is_no_harm() {
    spoilt_files_are_no_harm("iges", Format::Iges);
}
