//! A diagnostic as people read it: the lines, carets under the place, the reason, the help.

use crate::code::Level;
use crate::diagnostic::Diagnostic;
use crate::source::{Source, Span};
use annotate_snippets::{AnnotationKind, Group, Level as Title, Origin, Renderer, Snippet};
use std::ops::Range;

/// The most lines between two places that are still shown as one snippet.
const NEAR: u32 = 30;
/// The most bytes of a line that are shown.
const SHOWN: usize = 4096;

/// Some lines, with a line end after each, and where they are. Lines are put together again, so that an old
/// carriage return does not blur them, and that a far place or an endless line does not drag the whole file along.
struct Window {
    first: u32,
    text: String,
    lines: Vec<Range<usize>>,
}

impl Window {
    fn new(source: &Source, first: u32, last: u32) -> Self {
        let mut window = Window {
            first,
            text: String::new(),
            lines: Vec::new(),
        };
        for line in first..=last {
            let text = source.line_text(line);
            let start = window.text.len();
            window.text += shown(text);
            window.lines.push(start..window.text.len());
            window.text.push('\n');
        }
        window
    }

    /// Where a span of the source, cut to its first line, is in the window; `None` if elsewhere.
    fn range(&self, source: &Source, span: Span) -> Option<Range<usize>> {
        let (line, _) = source.line_column(span.start);
        let shown = self.lines.get(line.checked_sub(self.first)? as usize)?;
        let base = source.line(line).span.start;
        let start = shown.start + span.start.saturating_sub(base);
        let end = shown.start + span.end.saturating_sub(base);
        (start <= shown.end).then(|| start..end.clamp(start, shown.end))
    }
}

/// The part of a line that is shown.
fn shown(line: &str) -> &str {
    let mut end = line.len().min(SHOWN);
    while !line.is_char_boundary(end) {
        end -= 1;
    }
    &line[..end]
}

/// The diagnostic in the style of rustc, with colours for a terminal if `colour`; it ends with a line end.
pub fn human(source: &Source, diagnostic: &Diagnostic, colour: bool) -> String {
    let windows = windows(source, diagnostic);
    let level = match diagnostic.level() {
        Level::Error => Title::ERROR,
        Level::Warning => Title::WARNING,
    };
    let title = level
        .primary_title(diagnostic.title())
        .id(diagnostic.code.id());
    let mut group = Group::with_title(title);
    if windows[0].range(source, diagnostic.span).is_none() {
        group = group
            .element(origin(source, diagnostic))
            .element(Title::NOTE.message(diagnostic.reason.to_string()));
    }
    for window in &windows {
        group = group.element(snippet(source, diagnostic, window));
    }
    if let Some(help) = &diagnostic.help {
        group = group.element(Title::HELP.message(help.to_string()));
    }
    let renderer = if colour {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    let mut out = renderer.render(&[group]);
    out.push('\n');
    out
}

/// The place alone, for one that cannot be shown.
fn origin<'a>(source: &'a Source, diagnostic: &Diagnostic) -> Origin<'a> {
    let (line, column) = source.line_column(diagnostic.span.start);
    Origin::path(source.name())
        .line(line as usize)
        .char_column(column as usize)
}

/// The window around the diagnostic's own place, then one for each label that is far from it.
fn windows(source: &Source, diagnostic: &Diagnostic) -> Vec<Window> {
    let line = |span: Span| source.line_column(span.start).0;
    let own = line(diagnostic.span);
    let labels = || diagnostic.labels.iter().map(|label| line(label.span));
    let near = |other: &u32| other.abs_diff(own) <= NEAR;
    let first = labels().filter(near).fold(own, u32::min);
    let last = labels().filter(near).fold(own, u32::max);
    let mut far: Vec<u32> = labels().filter(|other| !near(other)).collect();
    far.sort_unstable();
    far.dedup();
    let own = Window::new(source, first, last);
    let far = far.iter().map(|line| Window::new(source, *line, *line));
    std::iter::once(own).chain(far).collect()
}

fn snippet<'a>(
    source: &'a Source,
    diagnostic: &'a Diagnostic,
    window: &'a Window,
) -> Snippet<'a, annotate_snippets::Annotation<'a>> {
    let primary = window.range(source, diagnostic.span).map(|range| {
        AnnotationKind::Primary
            .span(range)
            .label(diagnostic.reason.to_string())
    });
    let labels = diagnostic.labels.iter().filter_map(|label| {
        let range = window.range(source, label.span)?;
        let kind = AnnotationKind::Context;
        Some(kind.span(range).label(label.text.to_string()))
    });
    Snippet::source(window.text.as_str())
        .line_start(window.first as usize)
        .path(source.name())
        .annotations(primary.into_iter().chain(labels))
}
