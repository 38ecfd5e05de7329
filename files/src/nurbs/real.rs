//! Real numbers in the text of CAD files.

/// The shortest decimal that is read back bit by bit, with a decimal point: `1.0`, `-0.0`, `1.0E-7`.
pub(crate) fn written(x: f64) -> String {
    let text = format!("{x:?}");
    match text.split_once('e') {
        Some((digits, exponent)) if digits.contains('.') => format!("{digits}E{exponent}"),
        Some((digits, exponent)) => format!("{digits}.0E{exponent}"),
        None => text,
    }
}

/// The finite number that a text is, with `E`, `D` or no exponent; `None` if it is none, or too large.
pub(crate) fn read(text: &str) -> Option<f64> {
    // Words such as "inf" and "nan" are no numbers of a file.
    let numeric = |b: u8| b.is_ascii_digit() || b"+-.eEdD".contains(&b);
    if !text.bytes().all(numeric) {
        return None;
    }
    let x = match text.contains(['d', 'D']) {
        true => text.replace(['d', 'D'], "E").parse(),
        false => text.parse::<f64>(),
    };
    x.ok().filter(|x| x.is_finite())
}

/// The start of a text for a message.
pub(crate) fn shown(text: &str) -> String {
    const REPEATED: usize = 24;
    match text.chars().nth(REPEATED) {
        Some(_) => text.chars().take(REPEATED).chain("…".chars()).collect(),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_has_a_point_and_comes_back() {
        for (x, text) in [
            (1.0, "1.0"),
            (-0.0, "-0.0"),
            (1e-7, "1.0E-7"),
            (1.5e300, "1.5E300"),
            (0.1 + 0.2, "0.30000000000000004"),
            (5e-324, "5.0E-324"),
        ] {
            assert_eq!(written(x), text);
            assert_eq!(read(text).map(f64::to_bits), Some(x.to_bits()));
        }
    }

    #[test]
    fn other_spellings_are_read_and_words_are_not() {
        for (text, x) in
            [("1.", 1.0), (".5", 0.5), ("+2", 2.0), ("1.E-05", 1e-5), ("1.5D2", 150.0), ("-3d-1", -0.3)]
        {
            assert_eq!(read(text), Some(x), "{text}");
        }
        for text in ["", ".", "inf", "NaN", "1e999", "-1e999", "1e", "0x1", "1,5", "1 2", "infinity"] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
