//! Comments as other languages write them.

use crate::language::{Edition, flags};
use crate::lex::foreign_run;
use crate::message::{Commanding, Suggestion};
use crate::parse::Parser;
use crate::source::Span;
use crate::syntax::{Shape, StatementKind, upper_case};

/// The marks of comments in other languages.
const MARKS: &[&str] = &[
    "#", "'", "/*", "*/", "--", "%", "(*", "\"\"\"", "\\\\", "・・", "／／", "※", "＃", "’",
];

/// The marks that also begin a comment after a statement.
const AFTER: &[&str] = &["#", "'", "／／", "※", "＃", "’"];

/// Openers and closers of comments of several lines.
const OF_LINES: &[[&str; 2]] = &[["/*", "*/"], ["\"\"\"", "\"\"\""], ["'''", "'''"]];

/// The mark of comments in Fortran and Modula; the language negates flags with it.
const BANG: &str = "!";

/// Returns true if a statement is a comment in another language.
pub fn is_comment(statement: &str) -> bool {
    MARKS.iter().any(|mark| statement.starts_with(mark)) || is_banged(statement)
}

/// Returns true for a comment such as `! text`, but not for `!KB_HIT`.
fn is_banged(statement: &str) -> bool {
    let mut words = statement.strip_prefix(BANG).unwrap_or_default().split(' ');
    let first = upper_case(words.next().unwrap_or_default());
    words.next().is_some() && flags::find(&first, Edition::default()).is_none()
}

/// Returns true if a comment of another language, or what is taken for one, begins where this part of a line ends.
pub(in crate::parse) fn ends_in_mark(part: &str) -> bool {
    let part = part.trim_end();
    part.ends_with(';') || MARKS.iter().any(|mark| part.ends_with(mark))
}

/// Returns the mark that a comment of another language begins with.
pub fn comment_mark(comment: &str) -> Option<&'static str> {
    let mut marks = MARKS.iter().copied().chain([BANG]);
    marks.find(|mark| comment.starts_with(mark))
}

/// Returns the start of a comment of another language after a statement, if there is one.
pub fn comment_after(line: &str) -> Option<usize> {
    let starts = |at: &usize| AFTER.iter().any(|mark| line[*at..].starts_with(mark));
    let after_blank = line.match_indices([' ', '\t']).map(|(at, _)| at + 1);
    after_blank.into_iter().find(starts)
}

impl Parser<'_> {
    /// Returns true if the line belongs to a comment of another language, `/* … */`, whose start is reported.
    pub(in crate::parse) fn pass_comment(&mut self) -> bool {
        let Some(closes) = self.in_comment else {
            return false;
        };
        if self.source.slice(self.line.span).contains(closes) {
            self.in_comment = None;
        }
        true
    }

    /// Reports a comment of another language, which takes the rest of the line: `# …`, `' …`, `/* … */`.
    pub(in crate::parse) fn foreign_comment(&mut self, span: Span) {
        let text = self.source.slice(span);
        // It includes each `;` and `//` of the line.
        let line = self.source.slice(Span::new(span.start, self.line.span.end));
        let mut marks = OF_LINES.iter();
        self.in_comment = marks
            .find(|[opens, _]| text.starts_with(opens))
            .filter(|[opens, closes]| !line[opens.len()..].contains(closes))
            .map(|[_, closes]| *closes);
        self.push(StatementKind::Broken(Shape::Plain), span);
        if let Some(foreign) = foreign_run(self.text, span) {
            return self.report_foreign(foreign);
        }
        let first = text.split_whitespace().next().unwrap_or_default();
        let location = Span::new(span.start, span.start + first.len());
        let help = match self.in_comment {
            Some(_) => Suggestion::EachLine,
            None => Suggestion::Comment,
        };
        let reason = Commanding::NoCommand { word: first.into() };
        self.report_unknown(location, first, reason, help);
    }
}

#[cfg(test)]
mod tests {
    use super::is_comment;

    #[test]
    pub(in crate::parse) fn comments_of_other_languages_are_known() {
        for text in ["# x", "#x", "'x", "/* x */", "-- x", "% x", "! x", "!x y"] {
            assert!(is_comment(text), "{text}");
        }
        for text in [
            "A = 1",
            "PTP F1",
            "-A = 1",
            "!KB_HIT",
            "!KB_HIT GOTO L1:",
            "!x",
        ] {
            assert!(!is_comment(text), "{text}");
        }
    }
}
