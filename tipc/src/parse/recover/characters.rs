//! Diagnostics of characters that no statement may hold, such as full-width and typographic ones.

use super::comment::{comment_after, comment_mark, ends_in_mark, is_comment};
use super::operand::{is_range, is_unit};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, MistakeId};
use crate::language::names;
use crate::lex::{DELIMITERS, foreign_run, split_comment, word_end};
use crate::message::{Parsing, Suggestion};
use crate::parse::{LINE_LIMIT, Parser};
use crate::source::Span;
use crate::syntax::{StatementKind, Word, upper_case};
use smol_str::SmolStr;

impl Parser<'_> {
    /// Reports characters that only comments and texts may hold.
    pub(in crate::parse) fn report_foreign(&mut self, location: Span) {
        let text = self.source.slice(location);
        let reason = match text.chars().next() {
            Some(first) if first.is_ascii_control() => Parsing::ControlCharacter,
            _ => Parsing::ForeignCharacters,
        };
        let mut diagnostic = Diagnostic::new(Code::Format, location, reason);
        let before = &self.text[self.line.span.start..location.start];
        if let Some(plain) = text.chars().next().and_then(plain) {
            diagnostic = diagnostic.help(Suggestion::Plain { plain });
        } else if text == LONG_VOWEL && self.text[location.end..].starts_with(is_digit) {
            diagnostic = diagnostic.help(Suggestion::Plain { plain: "-" });
        } else if is_range(text) && is_between_digits(before, &self.text[location.end..]) {
            diagnostic = diagnostic.help(Suggestion::CountTo);
        } else if text == "。" && is_between_digits(before, &self.text[location.end..]) {
            diagnostic = diagnostic.help(Suggestion::Plain { plain: "." });
        } else if text.chars().all(is_invisible) {
            diagnostic = diagnostic.help(Suggestion::Invisible);
        } else if self.is_unit(location) {
            diagnostic = diagnostic.help(Suggestion::NoUnit);
        } else if let Some(character) = self.quoted_key(location) {
            diagnostic = diagnostic.help(Suggestion::Character { character });
        } else if text.chars().all(char::is_whitespace) {
            diagnostic = diagnostic.help(Suggestion::PlainBlank);
        } else if ends_in_mark(before)
            || comment_mark(text).is_some_and(|mark| !text[mark.len()..].is_ascii())
        {
            diagnostic = diagnostic.help(Suggestion::Comment);
        } else if let Some(narrow) = half_width(text) {
            diagnostic = diagnostic.once(wide_name(&narrow));
            let narrow = self.narrow_statement(location).unwrap_or(narrow);
            diagnostic = diagnostic.help(Parsing::WriteHalfWidth { narrow });
        } else if self.is_in_foreign_comment(location) {
            diagnostic = diagnostic.help(Suggestion::Comment);
        } else if before.trim().is_empty() && is_sentence(text) && !self.is_named(location) {
            diagnostic = diagnostic.help(Suggestion::CommentOrName);
        } else if text.chars().all(char::is_alphabetic) {
            diagnostic = diagnostic
                .once(MistakeId::Word(text.into()))
                .help(Parsing::PlainNames);
        } else {
            diagnostic = diagnostic.help(Parsing::TakeOut);
        }
        self.report(diagnostic);
    }

    /// Returns the statement around a location in half-width characters, if more than one of its words is full-width.
    pub(in crate::parse) fn narrow_statement(&self, location: Span) -> Option<String> {
        let (code, _) = split_comment(self.text, self.line.span);
        let start = self.text[code.start..location.start].rfind(';');
        let start = start.map_or(code.start, |at| code.start + at + 1);
        let end = self.text[location.end..code.end.max(location.end)].find(';');
        let end = end.map_or(code.end.max(location.end), |at| location.end + at);
        let statement = self.source.slice(Span::new(start, end));
        let words = statement.split_whitespace().collect::<Vec<_>>();
        let wide = words.iter().filter(|word| !word.is_ascii()).count();
        let narrow = narrow(&words.join(" "));
        (wide > 1 && statement.len() <= MAX_SHOWN_BYTES && narrow.is_ascii()).then_some(narrow)
    }

    /// Returns true if a location holds a unit right after a number: `30°`, `100ミリ`.
    pub(in crate::parse) fn is_unit(&self, location: Span) -> bool {
        let before = &self.text[self.line.span.start..location.start];
        before.ends_with(is_digit) && is_unit(self.source.slice(location))
    }

    /// Returns true if a colon or `=` follows: the name is a label, or is assigned.
    pub(in crate::parse) fn is_named(&self, location: Span) -> bool {
        let rest = self.text[location.end..].trim_start();
        rest.starts_with([':', '='])
    }

    /// Returns the key between quotes of typesetting that begin at a location.
    pub(in crate::parse) fn quoted_key(&self, location: Span) -> Option<SmolStr> {
        let mut chars = self.text[location.start..].chars();
        let is_quote = |char: char| matches!(char, '‘' | '’' | '“' | '”');
        let (open, key, close) = (chars.next()?, chars.next()?, chars.next()?);
        let is_key = is_quote(open) && is_quote(close) && key.is_ascii_alphanumeric();
        is_key.then(|| SmolStr::from_iter([key.to_ascii_uppercase()]))
    }

    /// Returns true if a comment of another language begins before a location on its line.
    pub(in crate::parse) fn is_in_foreign_comment(&self, location: Span) -> bool {
        let line = self.line.span;
        let before = self.source.slice(Span::new(line.start, location.start));
        // A line that is too long is not searched.
        let is_after = || before.len() <= LINE_LIMIT && comment_after(before).is_some();
        is_comment(self.source.slice(line).trim()) || is_after()
    }

    /// Reads a name as it was meant to be typed.
    pub(in crate::parse) fn narrow_word(&self, span: Span) -> Word {
        let word = self.source.slice(span);
        Word {
            node: match word.is_ascii() {
                true => upper_case(word),
                false => upper_case(&narrow(word)),
            },
            span,
        }
    }

    /// Reads labels with full-width colons, as in `L1：L2：PTP …`. Returns the first word of the statement after them,
    /// and that statement; `None` if there is none.
    pub(in crate::parse) fn behind_wide_labels(
        &mut self,
        mut word: Span,
        mut span: Span,
    ) -> Option<(Span, Span)> {
        while let Some(name) = self.ends_with_wide_colon(word) {
            (word, span) = self.wide_label(name, word, span)?;
        }
        Some((word, span))
    }

    /// Returns the name of a label with a full-width colon, as in `L1：` or `Ｌ１：`.
    pub(in crate::parse) fn ends_with_wide_colon(&self, word: Span) -> Option<Span> {
        let text = self.source.slice(word);
        let name = &text[..text.find(COLON)?];
        let meant = upper_case(&narrow(name));
        let is_name = names::is_label(&meant) && !self.is_command(&meant);
        is_name.then(|| Span::new(word.start, word.start + name.len()))
    }

    /// Reads a label with a full-width colon and returns the first word of the statement after it, and that statement.
    pub(in crate::parse) fn wide_label(
        &mut self,
        name: Span,
        word: Span,
        span: Span,
    ) -> Option<(Span, Span)> {
        let whole = Span::new(name.start, name.end + COLON.len_utf8());
        let label = self.narrow_word(name);
        let location = foreign_run(self.text, whole).unwrap_or(whole);
        let mistake = wide_name(&narrow(self.source.slice(location)));
        let narrow = narrow(self.source.slice(whole));
        let fault = Diagnostic::new(Code::Format, location, Parsing::ForeignCharacters);
        let fault = fault.once(mistake);
        self.report(fault.help(Parsing::WriteHalfWidth { narrow }));
        self.check_name_length(&label);
        self.push(StatementKind::Label(label), whole);
        let rest = self.source.slice(Span::new(whole.end, span.end));
        let start = span.end - rest.trim_start_matches(DELIMITERS).len();
        if start == span.end {
            return None;
        }
        // A word that holds many colons is not searched for its end again after each.
        let is_same_word =
            start < word.end && self.source.slice(word)[start - word.start..].contains(COLON);
        let end = match is_same_word {
            true => word.end,
            false => word_end(&self.text.as_bytes()[..span.end], start),
        };
        Some((Span::new(start, end), Span::new(start, span.end)))
    }
}

/// Character that an IME may type for a minus.
pub const LONG_VOWEL: &str = "ー";

/// The longest statement that is shown whole.
const MAX_SHOWN_BYTES: usize = 120;

/// The colon of full-width text.
const COLON: char = '：';

/// Returns the plain spelling of a typographic character.
pub fn plain(typeset: char) -> Option<&'static str> {
    Some(match typeset {
        '\u{2010}'..='\u{2015}' | '\u{2212}' => "-",
        '×' => "*",
        '÷' => "/",
        '≠' => "<>",
        '≧' | '≥' => ">=",
        '≦' | '≤' => "<=",
        '、' => ",",
        '←' => "=",
        _ => return None,
    })
}

/// Returns true if a character is a full-width or typographic operator.
pub(in crate::parse) fn is_sign(char: char) -> bool {
    let half = narrow_char(char).is_some_and(|it| "=+-*/<>:!".contains(it));
    half || plain(char).is_some_and(|it| it != ",")
}

/// Returns true if a character has no width, so that it is invisible.
fn is_invisible(char: char) -> bool {
    matches!(char, '\u{AD}' | '\u{200B}'..='\u{200F}' | '\u{2060}'..='\u{2064}' | '\u{FEFF}')
}

/// Returns the mistake of a full-width name, with or without its colon.
fn wide_name(narrow: &str) -> MistakeId {
    MistakeId::FullWidth(upper_case(narrow.trim_end_matches(':')))
}

/// Returns the text with half-width letters, digits and signs for full-width ones.
pub fn narrow(text: &str) -> String {
    text.chars()
        .map(|char| narrow_char(char).unwrap_or(char))
        .collect()
}

/// Converts full-width letters, digits or signs to half-width; `None` if there are others.
fn half_width(text: &str) -> Option<String> {
    text.chars().map(narrow_char).collect()
}

/// Returns true if a text is probably a remark in Japanese and not a name: it has hiragana, which joins words.
fn is_sentence(text: &str) -> bool {
    let is_hiragana = |char: char| matches!(char, '\u{3041}'..='\u{3096}');
    text.chars().any(is_hiragana)
}

/// Returns true if a location is inside a number.
fn is_between_digits(before: &str, after: &str) -> bool {
    before.ends_with(is_digit) && after.starts_with(is_digit)
}

fn is_digit(char: char) -> bool {
    char.is_ascii_digit()
}

/// Returns the half-width form of a full-width letter, digit or sign.
fn narrow_char(char: char) -> Option<char> {
    match char {
        '\u{FF01}'..='\u{FF5E}' => char::from_u32(char as u32 - 0xFEE0),
        _ => None,
    }
}
