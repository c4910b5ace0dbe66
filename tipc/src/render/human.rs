//! A diagnostic as people read it: the lines, carets under the location, the reason, the help.

use super::{printable, shown};
use crate::code::Level;
use crate::diagnostic::Diagnostic;
use crate::message::Lang;
use crate::source::{Source, Span, first_beyond};
use annotate_snippets::{AnnotationKind, Group, Level as Title, Origin, Renderer, Snippet};
use std::ops::Range;

/// Maximum number of lines between two locations that are shown in one excerpt.
const NEAR: u32 = 30;
/// Maximum number of other locations that are shown.
const LOCATIONS: usize = 8;

/// Some lines of a source, each with a line end, and their places. Only these lines are copied, with plain line ends:
/// annotate-snippets would show carriage returns and copy the whole file.
struct Excerpt {
    first: u32,
    text: String,
    lines: Vec<Shown>,
}

/// A line of an excerpt.
struct Shown {
    /// Its bytes in the source.
    span: Span,
    /// Its bytes in the text of the excerpt.
    range: Range<usize>,
}

impl Excerpt {
    fn new(source: &Source, first: u32, last: u32) -> Self {
        let mut window = Excerpt {
            first,
            text: String::new(),
            lines: Vec::new(),
        };
        let count = (last - first) as usize + 1;
        for line in source.lines_from(first).take(count) {
            let start = window.text.len();
            window.text += &printable(shown(source.slice(line.span)));
            window.lines.push(Shown {
                span: line.span,
                range: start..window.text.len(),
            });
            window.text.push('\n');
        }
        window
    }

    /// Returns the range of a span in the excerpt, cut to its first line; `None` if it is elsewhere.
    fn range(&self, source: &Source, span: Span) -> Option<Range<usize>> {
        let after = self.lines.partition_point(|it| it.span.start <= span.start);
        let line = &self.lines[after.checked_sub(1)?];
        if after == self.lines.len() && source.start_of_line_at(span.start) != line.span.start {
            return None;
        }
        let (text, shown) = (source.slice(line.span), &line.range);
        let location =
            |offset: usize| shown.start + width(text, offset.saturating_sub(line.span.start));
        let (start, end) = (location(span.start), location(span.end));
        (start <= shown.end).then(|| start..end.clamp(start, shown.end))
    }
}

/// Returns how many bytes of a window the first `bytes` of a line take; as many as there are beyond its shown part.
fn width(line: &str, bytes: usize) -> usize {
    let line = shown(line);
    match line.get(..bytes) {
        Some(start) => printable(start).len(),
        None => printable(line).len() + bytes.saturating_sub(line.len()),
    }
}

/// Renders the diagnostic in the style of rustc: its headline, the lines with carets, the help, and as a note the
/// classical message. It ends with a line end.
pub fn human(source: &Source, diagnostic: &Diagnostic, style: Style) -> String {
    let windows = windows(source, diagnostic);
    let name = printable(source.name());
    let headline = printable(diagnostic.headline(style.lang));
    let headline = wrapped(
        &headline,
        style.width,
        before_headline(diagnostic, style.lang),
    );
    let title = level(diagnostic.level(), style.lang)
        .primary_title(headline)
        .id(diagnostic.id());
    let mut group = Group::with_title(title);
    if windows[0].range(source, diagnostic.span).is_none() {
        group = group.element(origin(&name, source, diagnostic));
        if let Some(text) = at_location(diagnostic, style.lang) {
            group = group.element(note(style.lang).message(text));
        }
    }
    for window in &windows {
        group = group.element(snippet(&name, source, diagnostic, window, style.lang));
    }
    if let Some(help) = &diagnostic.help {
        let name = style.lang.pick("help", "ヘルプ");
        let help = printable(help.in_lang(style.lang));
        let help = wrapped(&help, style.width, before_help(&windows, name));
        group = group.element(Title::HELP.with_name(name).message(help));
    }
    if diagnostic.level() == Level::Error {
        group = group.element(note(style.lang).message(printable(diagnostic.title())));
    }
    let renderer = match style.colour {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    let renderer = match style.width {
        Some(width) => renderer.term_width(width),
        None => renderer,
    };
    let mut out = renderer.render(&[group]);
    out.push('\n');
    out
}

/// Returns the columns before the text of a help: those of line numbers, a sign, and its name.
fn before_help(windows: &[Excerpt], name: &str) -> usize {
    let ends = windows
        .iter()
        .map(|window| window.first as usize + window.lines.len() - 1);
    let digits = ends.max().unwrap_or_default().to_string().len();
    digits + " = : ".len() + columns(name)
}

/// Returns the columns before the text of a headline: those of the level and the code.
fn before_headline(diagnostic: &Diagnostic, lang: Lang) -> usize {
    let level = level_name(diagnostic.level(), lang);
    columns(level) + "[]: ".len() + diagnostic.id().len()
}

/// Returns the width in columns of a name in half-width and full-width characters.
fn columns(name: &str) -> usize {
    let columns = if name.is_ascii() { 1 } else { 2 };
    columns * name.chars().count()
}

fn level(level: Level, lang: Lang) -> Title<'static> {
    let title = match level {
        Level::Error => Title::ERROR,
        Level::Warning => Title::WARNING,
    };
    title.with_name(level_name(level, lang))
}

fn level_name(level: Level, lang: Lang) -> &'static str {
    match level {
        Level::Error => lang.pick("error", "エラー"),
        Level::Warning => lang.pick("warning", "警告"),
    }
}

fn note(lang: Lang) -> Title<'static> {
    Title::NOTE.with_name(lang.pick("note", "注"))
}

/// Returns the text at the location itself: nothing for an error, whose reason is the headline.
fn at_location(diagnostic: &Diagnostic, lang: Lang) -> Option<String> {
    let is_warning = diagnostic.level() == Level::Warning;
    is_warning.then(|| printable(diagnostic.reason.in_lang(lang)))
}

/// Renders the location alone, for one that cannot be shown.
fn origin<'a>(name: &'a str, source: &Source, diagnostic: &Diagnostic) -> Origin<'a> {
    let (line, column) = source.line_column(diagnostic.span.start);
    Origin::path(name)
        .line(line as usize)
        .char_column(column as usize)
}

/// Returns the window around the diagnostic's own location, then one for each label that is far from it.
fn windows(source: &Source, diagnostic: &Diagnostic) -> Vec<Excerpt> {
    let line = |span: Span| source.line_column(span.start).0;
    let own = line(diagnostic.span);
    let labels = || {
        diagnostic
            .labels
            .iter()
            .take(LOCATIONS)
            .map(|label| line(label.span))
    };
    let near = |other: &u32| other.abs_diff(own) <= NEAR;
    let first = labels().filter(near).fold(own, u32::min);
    let last = labels().filter(near).fold(own, u32::max);
    let mut far: Vec<u32> = labels().filter(|other| !near(other)).collect();
    far.sort_unstable();
    far.dedup();
    let own = Excerpt::new(source, first, last);
    let far = far.iter().map(|line| Excerpt::new(source, *line, *line));
    std::iter::once(own).chain(far).collect()
}

fn snippet<'a>(
    name: &'a str,
    source: &Source,
    diagnostic: &Diagnostic,
    window: &'a Excerpt,
    lang: Lang,
) -> Snippet<'a, annotate_snippets::Annotation<'a>> {
    let primary = window.range(source, diagnostic.span).map(|range| {
        AnnotationKind::Primary
            .span(range)
            .label(at_location(diagnostic, lang))
    });
    let labels = diagnostic
        .labels
        .iter()
        .take(LOCATIONS)
        .filter_map(|label| {
            let range = window.range(source, label.span)?;
            let kind = AnnotationKind::Context;
            Some(kind.span(range).label(printable(label.text.in_lang(lang))))
        });
    Snippet::source(window.text.as_str())
        .line_start(window.first as usize)
        .path(name)
        .annotations(primary.into_iter().chain(labels))
}

/// The language, the colours and the width of what is shown to people.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Style {
    /// The language of reasons and helps.
    pub lang: Lang,
    /// True if colours are used, for a terminal.
    pub colour: bool,
    /// The columns that a line may fill, if there is a limit.
    pub width: Option<usize>,
}

impl Style {
    /// Sets the language.
    #[must_use]
    pub fn lang(mut self, lang: Lang) -> Self {
        self.lang = lang;
        self
    }

    /// Sets whether colours are used.
    #[must_use]
    pub fn colour(mut self, colour: bool) -> Self {
        self.colour = colour;
        self
    }

    /// Sets the width of lines, columns.
    #[must_use]
    pub fn width(mut self, width: Option<usize>) -> Self {
        self.width = width;
        self
    }
}

/// The fewest columns that a text is broken for.
const MIN_COLUMNS: usize = 20;

/// Returns the text with line breaks, so that each line fits into what `used` columns leave of the width. It breaks at
/// blanks and beside full-width characters, not inside of code between backquotes.
fn wrapped(text: &str, width: Option<usize>, used: usize) -> String {
    let room = width.and_then(|width| width.checked_sub(used));
    let Some(room) = room.filter(|room| *room >= MIN_COLUMNS) else {
        return text.to_owned();
    };
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(beyond) = first_beyond(rest, room) {
        let breaks = |at: &usize| rest.is_char_boundary(*at) && may_break(rest, *at);
        let at = (1..=beyond).rev().find(breaks).unwrap_or(beyond);
        let (line, after) = rest.split_at(at);
        out += line.trim_end();
        out.push('\n');
        rest = after.trim_start();
    }
    out + rest
}

/// Returns true if a line may end before the byte `at`.
fn may_break(text: &str, at: usize) -> bool {
    let (line, rest) = text.split_at(at);
    let is_in_code = line.matches('`').count() % 2 == 1;
    let (Some(before), Some(after)) = (line.chars().next_back(), rest.chars().next()) else {
        return false;
    };
    let is_wide = !before.is_ascii() || !after.is_ascii();
    let sticks = "、。)…".contains(after) || before == '(';
    !is_in_code && (before == ' ' || is_wide && !sticks)
}
