//! Texts with holes, `<<name>>`.

/// The text with its holes filled.
pub(super) fn fill(text: &str, holes: &[(&str, &str)]) -> String {
    let fill_one =
        |text: String, (name, value): &(&str, &str)| text.replace(&format!("<<{name}>>"), value);
    holes.iter().fold(text.to_owned(), fill_one)
}
