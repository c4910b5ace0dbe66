//! How values are spelled in XML.

/// A text as an attribute holds it.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Numbers with blanks between them, each to its last digit.
pub(crate) fn vector(of: impl IntoIterator<Item = f64>) -> String {
    // Adding 0 makes of −0 a plain 0.
    let words = of.into_iter().map(|number| (number + 0.0).to_string());
    words.collect::<Vec<_>>().join(" ")
}
