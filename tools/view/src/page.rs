//! The page that replays a recording.

use crate::bundle;
use crate::recording::Recording;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

impl Recording {
    /// One HTML file that replays this recording: it asks for nothing from anywhere.
    ///
    /// Nothing that a program, its name or its messages say becomes markup or script: all of it is in the packed bytes,
    /// which the page shows as text, but the title, which is escaped.
    pub fn to_page(&self) -> String {
        let title = match self.script.title.trim() {
            "" => &self.script.name,
            title => title,
        };
        let mut page = String::new();
        let whole = bundle::replay();
        let mut rest = whole.as_str();
        for (mark, content) in [
            ("TIP-TITLE", escaped(title)),
            ("TIP-RECORDING", STANDARD.encode(self.packed())),
        ] {
            let (before, after) = rest.split_once(mark).unwrap_or((rest, ""));
            page.push_str(before);
            page.push_str(&content);
            rest = after;
        }
        page.push_str(rest);
        page
    }
}

/// Text as HTML.
fn escaped(text: &str) -> String {
    let mut html = String::new();
    for char in text.chars() {
        match char {
            '&' => html.push_str("&amp;"),
            '<' => html.push_str("&lt;"),
            '>' => html.push_str("&gt;"),
            '"' => html.push_str("&quot;"),
            '\'' => html.push_str("&#39;"),
            char if char.is_control() || matches!(char, '\u{fffe}' | '\u{ffff}') => html.push(' '),
            char => html.push(char),
        }
    }
    html
}
