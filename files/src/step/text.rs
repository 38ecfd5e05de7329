//! Texts, whose letters beyond ASCII are written by number.

/// The text that stands between two marks. What is no letter by number is kept as it stands.
pub(super) fn read(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).replace("''", "'");
    let mut out = String::with_capacity(text.len());
    let mut rest = text.as_str();
    while let Some(at) = rest.find('\\') {
        out.push_str(&rest[..at]);
        let (letters, length) = escaped(&rest[at..]).unwrap_or(("\\".to_owned(), 1));
        out.push_str(&letters);
        rest = &rest[at + length..];
    }
    out.push_str(rest);
    out
}

/// The letters that are written by number here, and how long that is.
fn escaped(text: &str) -> Option<(String, usize)> {
    if text.starts_with("\\\\") {
        return Some(("\\".to_owned(), 2));
    }
    if let Some(rest) = text.strip_prefix("\\S\\") {
        let letter = rest.chars().next().filter(char::is_ascii)?;
        return Some((char::from(letter as u8 | 0x80).to_string(), 4));
    }
    if let Some(rest) = text.strip_prefix("\\X\\") {
        let code = u8::from_str_radix(rest.get(..2)?, 16).ok()?;
        return Some((char::from(code).to_string(), 5));
    }
    let (digits, size) = match (text.strip_prefix("\\X2\\"), text.strip_prefix("\\X4\\")) {
        (Some(rest), _) => (rest, 4),
        (_, Some(rest)) => (rest, 8),
        _ => return None,
    };
    let digits = &digits[..digits.find("\\X0\\")?];
    if digits.len() % size != 0 || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
        return None;
    }
    let codes = digits.as_bytes().chunks_exact(size).map(|code| {
        u32::from_str_radix(std::str::from_utf8(code).expect("hexadecimal digits"), 16)
            .expect("at most eight of them")
    });
    let letters = match size {
        4 => String::from_utf16(&codes.map(|code| code as u16).collect::<Vec<_>>()).ok()?,
        _ => codes.map(char::from_u32).collect::<Option<_>>()?,
    };
    Some((letters, digits.len() + 8))
}

/// The text between its marks.
pub(super) fn written(text: &str) -> String {
    let mut out = String::from("'");
    for letter in text.chars() {
        match letter {
            '\'' => out.push_str("''"),
            '\\' => out.push_str("\\\\"),
            ' '..='~' => out.push(letter),
            _ if (letter as u32) < 0x1_0000 => out.push_str(&format!("\\X2\\{:04X}\\X0\\", letter as u32)),
            _ => out.push_str(&format!("\\X4\\{:08X}\\X0\\", letter as u32)),
        }
    }
    out.push('\'');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_come_back() {
        for text in ["", "it's", "a\\b", "é€😀\n\t", "\\X2\\", "''", "\\"] {
            let form = written(text);
            assert!(form.is_ascii());
            assert_eq!(read(&form.as_bytes()[1..form.len() - 1]), text);
        }
    }

    #[test]
    fn all_forms_are_read_and_what_is_none_is_kept() {
        let form = br"\X\E9\S\i\X2\00E920AC\X0\\X4\0001F600\X0\";
        assert_eq!(read(form), "éé\u{e9}€😀");
        for kept in [
            r"\X2\00E\X0\",
            r"\X2\D83D\X0\",
            r"\X4\00110000\X0\",
            r"C:\parts",
            r"\X\é",
            r"\X2\00E9",
            r"\S\é",
            r"\",
        ] {
            assert_eq!(read(kept.as_bytes()), kept);
        }
    }
}
