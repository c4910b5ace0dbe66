//! How values are spelled in XML.

/// A text as an attribute holds it.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Three numbers, each to its last digit.
pub(super) fn vector(of: [f64; 3]) -> String {
    // Adding 0 makes of −0 a plain 0.
    let [x, y, z] = of.map(|number| number + 0.0);
    format!("{x} {y} {z}")
}
