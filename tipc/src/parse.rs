//! Parser from lines to statements. It reports every bad line and reads on. It checks the form, not the meaning.
//!
//! The file of each statement begins with its form. `recover` words the diagnostic of a statement that has another
//! form.

mod condition;
mod control;
mod declaration;
mod equation;
pub mod header;
mod line;
mod operand;
mod reader;
mod recover;
mod statement;
mod text;

pub use recover::characters::{LONG_VOWEL, narrow, plain};
pub use recover::comment::{comment_after, comment_mark, is_comment};
pub use recover::control::glued;
pub(crate) use recover::operand::is_unit;

use crate::code::Code;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::language::commands::{self, COMMANDS};
use crate::language::{Edition, Keyword};
use crate::lex::Token;
use crate::message::{Commanding, Parsing, Suggestion};
use crate::source::{Line, Source, Span, first_beyond};
use crate::suggest::{is_near, nearest};
use crate::syntax::{Module, Shape, Statement, StatementKind, StepId};

/// Maximum length of a line, bytes (T.I.P. 3.1 §3).
pub const LINE_LIMIT: usize = 1023;

/// Parses a source, whose line 1 must name version `tip_version` of the language; without one, any edition.
///
/// If line 1 names another version, the module is empty and that is the only diagnostic.
pub fn parse(source: &Source, tip_version: Option<f64>) -> (Module, Diagnostics) {
    let edition = match header::version(source, tip_version) {
        Ok(edition) => edition,
        Err(wrong) => return (Module::default(), vec![*wrong].into()),
    };
    let mut parser = Parser::new(source, edition);
    parser.lines();
    (parser.module, parser.diagnostics)
}

/// Finds the first statement after END, with the label before it. Other text may stand there: it is a note.
pub fn after_end(source: &Source, module: &Module) -> Option<Span> {
    let end = module.statements.last()?;
    let mut parser = Parser::new(source, module.edition);
    let mut label = None;
    for line in source.lines_from(end.line) {
        let start = line.span.start.max(end.span.end);
        let span = Span::new(start, line.span.end);
        parser.line = Line { span, ..line };
        if span.end - start > LINE_LIMIT || parser.pass_comment() {
            continue;
        }
        parser.statements_of_line();
        for statement in std::mem::take(&mut parser.module.statements) {
            let is_label = matches!(statement.kind, StatementKind::Label(_));
            if !is_label && parser.is_statement_after_end(&statement) {
                return Some(label.unwrap_or(statement.span));
            }
            label = is_label.then(|| label.unwrap_or(statement.span));
        }
        parser.module.after_end = None;
        parser.diagnostics = Diagnostics::default();
        parser.is_numbered = false;
    }
    None
}

/// The place where reading goes on after a piece of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flow {
    /// After the piece.
    Continue,
    /// On the next line.
    NextLine,
    /// Nowhere: the piece was END, which ends the program.
    End,
}

struct Parser<'a> {
    source: &'a Source,
    text: &'a str,
    line: Line,
    /// The next statement's step, from 0.
    step: StepId,
    /// The current statement's tokens; kept to use its memory again.
    tokens: Vec<Token>,
    /// The mark that ends the open comment of another language.
    in_comment: Option<&'static str>,
    /// True for each open brace that begins a block. The braces are reported.
    braces: Vec<bool>,
    /// Names with a `-`, as written in declarations, which are reported.
    hyphened: Vec<String>,
    /// True if lines have numbers, which is reported.
    is_numbered: bool,
    /// The last line with an unknown statement whose rest was skipped.
    unknown_line: u32,
    /// True if a text on this line is too long, which is reported.
    is_text_too_long: bool,
    module: Module,
    diagnostics: Diagnostics,
}

impl<'a> Parser<'a> {
    /// Creates a parser before the first line.
    fn new(source: &'a Source, edition: Edition) -> Self {
        Parser {
            source,
            text: source.text(),
            line: source.line(1),
            step: 0,
            tokens: Vec::new(),
            in_comment: None,
            braces: Vec::new(),
            hyphened: Vec::new(),
            is_numbered: false,
            unknown_line: 0,
            is_text_too_long: false,
            module: Module {
                edition,
                title: header::title(source),
                statements: Vec::new(),
                after_end: None,
            },
            diagnostics: Diagnostics::default(),
        }
    }
}

impl Parser<'_> {
    fn lines(&mut self) {
        for line in self.source.lines() {
            self.line = line;
            let mut flow = Flow::Continue;
            let is_read = line.number > 2 && !self.pass_comment();
            if is_read {
                self.is_text_too_long = false;
                flow = self.statements_of_line();
            }
            if !is_read || !self.is_text_too_long {
                self.check_length();
            }
            if flow == Flow::End {
                return;
            }
        }
        // END is inside a comment of another language that never ends, which is reported.
        if self.in_comment.is_none() && !self.ends_with_number() {
            self.report_missing_end();
        }
    }

    fn check_length(&mut self) {
        let span = self.line.span;
        let Some(beyond) = first_beyond(self.source.slice(span), LINE_LIMIT) else {
            return;
        };
        let rest = Span::new(span.start + beyond, span.end);
        let reason = Parsing::LineTooLong { limit: LINE_LIMIT };
        let help = Parsing::BreakTheLine;
        self.report(Diagnostic::new(Code::Format, rest, reason).help(help));
    }

    fn report_missing_end(&mut self) {
        // All lines are read, so this is the last one.
        let location = self.trim(self.line.span, char::is_whitespace);
        if self.take_last_word_as_end(location) {
            return;
        }
        let missing = Diagnostic::new(Code::NoEnd, location, Parsing::ProgramEndsHere);
        let is_title = Keyword::End.is(self.module.title.trim());
        self.report(match is_title {
            true => missing
                .label(self.source.line(2).span, Suggestion::TitleHere)
                .help(Suggestion::Title),
            false => missing.help(Parsing::PutEnd),
        });
    }

    /// Reads an unknown word at the end of the text as the missing END, such as `EDN` or `STOP`. Returns true if it
    /// reports that, as it does for a word near to END.
    fn take_last_word_as_end(&mut self, location: Span) -> bool {
        let Some(last) = self.module.statements.last() else {
            return false;
        };
        let StatementKind::Command { name, .. } = &last.kind else {
            return false;
        };
        if last.span != location || name.span != location || self.is_command(&name.node) {
            return false;
        }
        let word = name.node.clone();
        let end = Keyword::End.word();
        let near = nearest(&word, COMMANDS.iter().map(|command| command.name));
        if near.is_some() && !is_near(&word, end) {
            return false;
        }
        self.module.statements.pop();
        if is_near(&word, end) {
            self.push(StatementKind::End, location);
            let reason = Commanding::NoCommand { word: word.clone() };
            let help = Suggestion::DidYouMean { near: end.into() };
            self.report_unknown(location, &word, reason, help);
            return true;
        }
        self.push(StatementKind::Broken(Shape::Plain), location);
        false
    }

    /// Returns true if a statement after END, on the line that was read last, is more than the words of a note.
    fn is_statement_after_end(&self, statement: &Statement) -> bool {
        let span = statement.span;
        let is_wrong = |it: &Diagnostic| {
            it.code.kind().is_some() && span.start <= it.span.start && it.span.start <= span.end
        };
        let is_known = match &statement.kind {
            StatementKind::Command { name, .. } => self.is_command(&name.node),
            StatementKind::End => self.module.after_end.is_none(),
            StatementKind::Rem | StatementKind::Broken(_) => false,
            _ => true,
        };
        is_known && !self.diagnostics.iter().any(is_wrong)
    }

    /// Returns true if a word is a command of the edition.
    fn is_command(&self, word: &str) -> bool {
        commands::find_in(word, self.module.edition).is_some()
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    fn push(&mut self, kind: StatementKind, span: Span) {
        let statement = Statement {
            kind,
            span,
            line: self.line.number,
            step: self.step,
        };
        self.step += u32::from(statement.is_step());
        self.module.statements.push(statement);
    }

    /// Returns `span` without the characters at its ends for which `drop` returns true.
    fn trim(&self, span: Span, drop: impl Fn(char) -> bool) -> Span {
        let text = self.source.slice(span);
        let kept = text.trim_end_matches(&drop);
        let end = span.start + kept.len();
        Span::new(end - kept.trim_start_matches(&drop).len(), end)
    }
}

#[cfg(test)]
mod tests;
