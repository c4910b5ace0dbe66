//! Texts and numbers in XML files that are written.

/// Returns a text with U+FFFD in place of each character that XML cannot hold, escaped or not: control characters and what
/// Unicode reserves for no character.
pub fn permitted(text: &str) -> String {
    let is_permitted = |char| match char {
        '\t' | '\n' | '\r' => true,
        // Surrogates are no characters of Rust.
        char => char >= ' ' && !matches!(char, '\u{fffe}' | '\u{ffff}'),
    };
    let permitted = |char| match is_permitted(char) {
        true => char,
        false => char::REPLACEMENT_CHARACTER,
    };
    text.chars().map(permitted).collect()
}

/// Escapes a text for an attribute.
pub(crate) fn escaped(text: &str) -> String {
    permitted(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Formats numbers with blanks between them, each to its last digit.
pub(crate) fn vector(of: impl IntoIterator<Item = f64>) -> String {
    // Adding 0 makes of −0 a plain 0.
    let words = of.into_iter().map(|number| (number + 0.0).to_string());
    words.collect::<Vec<_>>().join(" ")
}
