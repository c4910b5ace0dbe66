//! The pages without what they show, as `build.rs` packs them.

use miniz_oxide::inflate::decompress_to_vec;

/// The page that replays a recording. Between two of its marks stands what the mark names.
pub(crate) fn replay() -> String {
    unpacked(include_bytes!(concat!(env!("OUT_DIR"), "/page.html")))
}

/// The page that shows a session.
pub(crate) fn live() -> String {
    unpacked(include_bytes!(concat!(env!("OUT_DIR"), "/live.html")))
}

fn unpacked(packed: &[u8]) -> String {
    let page = decompress_to_vec(packed).unwrap_or_default();
    String::from_utf8(page).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pages_are_those_that_their_sources_make() {
        assert_eq!(replay(), include_str!("../page/dist/page.html"));
        assert_eq!(live(), include_str!("../page/dist/live.html"));
    }
}
