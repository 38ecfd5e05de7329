//! Small changes of files, drawn from a seed.

use std::ops::Range;

/// What numbers are replaced by.
const NUMBERS: [&str; 20] = [
    "NaN",
    "inf",
    "-inf",
    "1e999",
    "-1",
    "0",
    "-0.0",
    "18446744073709551615",
    "5e-324",
    "1e308",
    "0.1",
    "99999999999999999999/7",
    "4294967295",
    "-2147483648",
    "1e-999",
    "'",
    "(",
    ",",
    ";",
    "$",
];

/// A generator of numbers (splitmix64).
#[derive(Debug)]
pub struct Dice(pub u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `end`, or 0.
    pub fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }

    /// Two places in order.
    fn range(&mut self, end: usize) -> (usize, usize) {
        let (a, b) = (self.below(end + 1), self.below(end + 1));
        (a.min(b), a.max(b))
    }
}

/// A changed file: one change, or a few.
pub fn mutated(file: &[u8], other: &[u8], dice: &mut Dice) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for _ in 0..=dice.below(3) {
        change(&mut bytes, other, dice);
    }
    bytes
}

fn change(bytes: &mut Vec<u8>, other: &[u8], dice: &mut Dice) {
    let length = bytes.len();
    match dice.below(11) {
        0 if length > 0 => bytes[dice.below(length)] ^= 1 << dice.below(8),
        1 => bytes.truncate(dice.below(length + 1)),
        2 => {
            let (a, b) = dice.range(length);
            bytes.drain(a..b.min(a + 40));
        }
        3 => {
            let (a, b) = dice.range(length);
            let part = bytes[a..b.min(a + 200)].to_vec();
            let at = dice.below(length + 1);
            bytes.splice(at..at, part);
        }
        4 => {
            let ((a, b), at) = (dice.range(other.len()), dice.below(length + 1));
            bytes.splice(at..at, other[a..b.min(a + 200)].iter().copied());
        }
        5 => {
            // The same letter very often: brackets nested deep, long numbers, long lines.
            let at = dice.below(length + 1);
            let letter = *b"[{(<0123456789 \n\\-e.".get(dice.below(20)).expect("twenty letters");
            bytes.splice(at..at, std::iter::repeat_n(letter, 1 << dice.below(15)));
        }
        6 | 7 => {
            let Some(place) = some_number(bytes, dice) else { return };
            // Other digits: counts, pointers and references go wrong, columns stay.
            let digits = bytes[place].iter_mut().filter(|byte| byte.is_ascii_digit());
            digits.for_each(|byte| *byte = b'0' + dice.below(10) as u8);
        }
        _ => {
            let Some(place) = some_number(bytes, dice) else { return };
            let drawn = match dice.below(2) {
                0 => NUMBERS[dice.below(NUMBERS.len())].to_owned(),
                _ => dice.below(40).to_string(),
            };
            bytes.splice(place, drawn.into_bytes());
        }
    }
}

/// The place of a number.
fn some_number(bytes: &[u8], dice: &mut Dice) -> Option<Range<usize>> {
    let is_part = |byte: &u8| byte.is_ascii_digit() || b"+-.eE".contains(byte);
    let starts: Vec<usize> = (0..bytes.len())
        .filter(|&i| bytes[i].is_ascii_digit() && (i == 0 || !is_part(&bytes[i - 1])))
        .collect();
    let start = *starts.get(dice.below(starts.len()))?;
    Some(start..start + bytes[start..].iter().take_while(|byte| is_part(byte)).count())
}
