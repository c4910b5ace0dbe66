//! The page of a run: one HTML file that replays a recording, or shows a session.

use crate::recording::Recording;
use crate::updates;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::deflate::compress_to_vec;
use serde::Serialize;
use similar::TextDiff;
use tip_runtime::printable::Printable;

/// The page without its script and what it shows.
const PAGE: &str = include_str!("../page/dist/page.html");

/// The page of a table of runs, which has its own script.
const SWEEP: &str = include_str!("../page/sweep.html");

/// Largest number of runs that the page of a table holds.
pub const MAX_RUNS: usize = 50_000;

/// The script, deflated by `build.rs`.
const SCRIPT: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/page.js"));

impl Recording {
    /// Returns one HTML file that replays this recording and makes no network requests.
    ///
    /// Nothing that a program, its name or its messages say becomes markup or script: all of it is in the packed bytes,
    /// which the page shows as text, but the title, which is escaped.
    pub fn to_page(&self) -> String {
        self.page_with("")
    }

    /// Returns the page that replays this recording with another one next to it: plots over each other, the other robot as
    /// a ghost, the difference of the programs.
    pub fn to_comparison(&self, other: &Recording) -> String {
        let diff = updates::json(&self.program_diff(other));
        let lines = [other.updates(), diff].join("\n");
        self.page_with(&STANDARD.encode(compress_to_vec(lines.as_bytes(), 9)))
    }

    /// Returns the unified diff from this run's program to another one's, without context; empty if they are equal.
    pub fn program_diff(&self, other: &Recording) -> String {
        let (one, other) = (&self.script, &other.script);
        let diff = TextDiff::from_lines(&*one.text, &*other.text);
        let names = [one, other].map(|script| Printable::line(&script.name).to_string());
        let [from, to] = &names;
        let mut diff = diff.unified_diff();
        diff.context_radius(0).header(from, to).to_string()
    }

    fn page_with(&self, other: &str) -> String {
        let title = match self.script.title.trim() {
            "" => &self.script.name,
            title => title,
        };
        let recording = STANDARD.encode(self.packed());
        page("live", &escaped(title), &recording, other)
    }

    /// Returns the [updates](Self::updates) deflated (RFC 1951), as the page holds them.
    pub fn packed(&self) -> Vec<u8> {
        compress_to_vec(self.updates().as_bytes(), 9)
    }
}

/// The table of a sweep, as its page shows it.
#[derive(Debug, Serialize)]
pub struct SweepTable<C, R, G> {
    /// The columns: a list of objects with `name`, `unit`, `type` and `meaning`.
    pub columns: C,
    /// The cells of each row, the worst first; at most [`MAX_RUNS`].
    pub rows: R,
    /// The kind of each row, one letter each: `x` failed, `f` is on the Pareto front or the best one, `.` is another result.
    pub kinds: String,
    /// The goals and conditions of the front: an object with the lists `goals` and `where`.
    pub ranking: G,
    /// The command that replays a run if ` --case N` is added.
    pub command: String,
    /// 1, or the distance of the rows that were taken from a larger table.
    pub every: u64,
    /// The server of the page has the page of each run, `case/N`.
    pub is_served: bool,
}

/// Returns one HTML file that shows a table of runs, as `tip sweep` writes it, and makes no network requests.
pub fn sweep_page(
    name: &str,
    table: &SweepTable<impl Serialize, impl Serialize, impl Serialize>,
) -> String {
    // The data has string keys and no values that JSON lacks; nothing in it ends the script element.
    let data = serde_json::to_string(table).unwrap_or_default();
    let data = data.replace('<', "\\u003c");
    let (before, after) = SWEEP.split_once("TIP-DATA").unwrap_or((SWEEP, ""));
    before.replace("TIP-TITLE", &escaped(name)) + &data + after
}

/// Returns the page that shows a session at the other end of a WebSocket.
pub(crate) fn live() -> String {
    page("replay", "tip serve", "", "")
}

/// Returns the page without what is marked as another kind's.
fn page(other_kind: &str, title: &str, recording: &str, compared: &str) -> String {
    let mut page = String::new();
    let mut rest = PAGE;
    let (begin, end) = (
        format!("<!--{other_kind}-->"),
        format!("<!--/{other_kind}-->"),
    );
    while let Some((before, marked)) = rest.split_once(&begin) {
        page.push_str(before);
        rest = marked.split_once(&end).map_or("", |(_, after)| after);
    }
    page.push_str(rest);
    for kind in ["replay", "live"] {
        page = page.replace(&format!("<!--{kind}-->"), "");
        page = page.replace(&format!("<!--/{kind}-->"), "");
    }
    // The last mark first: nothing that is filled in is looked through for marks.
    let script = STANDARD.encode(SCRIPT);
    for (mark, content) in [
        ("TIP-SCRIPT", script.as_str()),
        ("TIP-COMPARED", compared),
        ("TIP-RECORDING", recording),
        ("TIP-TITLE", title),
    ] {
        if let Some(at) = page.find(mark) {
            page.replace_range(at..at + mark.len(), content);
        }
    }
    page
}

/// Escapes text for HTML.
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

#[cfg(test)]
mod tests {
    use super::*;
    use miniz_oxide::inflate::decompress_to_vec;

    #[test]
    fn the_script_is_the_one_that_its_sources_make() {
        let script = decompress_to_vec(SCRIPT).expect("it is deflated");
        assert!(script == include_bytes!("../page/dist/page.js"));
    }

    #[test]
    fn each_kind_of_page_has_what_is_its_own() {
        let (replay, live) = (page("live", "x", "y", "z"), live());
        for (part, is_of_replay, is_of_live) in [
            ("id=\"recording\">y<", true, false),
            ("id=\"compared\">z<", true, false),
            ("id=\"export\"", true, false),
            ("connect-src", false, true),
            ("id=\"stop\"", false, true),
            ("id=\"lost\"", false, true),
            ("<style>main{", false, true),
            ("TIP-", false, false),
            ("<!--live", false, false),
            ("<!--/replay", false, false),
        ] {
            assert_eq!(replay.contains(part), is_of_replay, "{part}");
            assert_eq!(live.contains(part), is_of_live, "{part}");
        }
    }
}
