//! Syntax of the names that a program chooses itself (T.I.P. 3.1 §4-3, §4-4).

/// Maximum length of a name, bytes.
pub const LIMIT: usize = 32;

/// Returns true if a word, in capital letters, has the form of the name of a variable.
pub fn is_variable(word: &str) -> bool {
    let starts_well = word.starts_with(|first: char| first.is_ascii_uppercase() || first == '_');
    starts_well && is_label(word)
}

/// Returns true if a word, in capital letters, has the form of the name of a label.
pub fn is_label(word: &str) -> bool {
    let is_fit = |byte: u8| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'_';
    !word.is_empty() && word.bytes().all(is_fit)
}

#[cfg(test)]
mod tests {
    use super::{is_label, is_variable};

    // clauses: 3.2
    #[test]
    fn names_are_letters_digits_and_underscores() {
        for name in ["A", "_", "_A", "A_1", "N9"] {
            assert!(is_variable(name) && is_label(name), "{name}");
        }
        for name in ["1", "1A"] {
            assert!(!is_variable(name) && is_label(name), "{name}");
        }
        for name in ["", "A-B", "A B", "A.X", "\u{C4}"] {
            assert!(!is_variable(name) && !is_label(name), "{name}");
        }
    }
}
