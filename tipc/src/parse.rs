//! Lines to statements. It never fails and reports every bad line; it judges form, never meaning.

mod arguments;
mod assignment;
mod braces;
mod command;
mod condition;
mod control;
mod declaration;
mod equation;
mod foreign;
pub(crate) mod header;
mod jump;
mod line;
mod message;
mod numbered;
mod operand;
mod reader;
mod relation;
mod routine;
mod shape;
mod signs;
mod statement;
mod wide;

#[cfg(any(feature = "build", feature = "tools"))]
pub(crate) use jump::glued;
#[cfg(feature = "tools")]
pub(crate) use line::LONG_VOWEL;
pub(crate) use line::narrow;

use crate::beside::{FEW, HAS_THREADS, beside};
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::language::Edition;
use crate::lex::Token;
use crate::message::Parsing;
use crate::source::{Line, Source, Span, first_beyond};
use crate::syntax::{Module, Statement, StatementKind, StepId};

/// The most bytes that a line may have (T.I.P. 3.1 §3).
pub(crate) const LINE_LIMIT: usize = 1023;

/// Parses a source for version `tip_version` of the language.
///
/// If line 1 names another version, the module is empty and that is the only diagnostic.
pub fn parse(source: &Source, tip_version: f64) -> (Module, Findings) {
    if let Err(wrong) = header::version(source, tip_version) {
        return (Module::default(), vec![*wrong].into());
    }
    let mut parser = Parser::new(source, tip_version);
    let keep = &mut |_: &mut Vec<Statement>| ();
    match halves(source) {
        None => {
            parser.lines(Part::WHOLE, keep);
        }
        Some((first, second)) => {
            let read_first = || parser.lines(first, keep);
            let (flow, later) = beside(read_first, || {
                let mut later = Parser::new(source, tip_version);
                later.lines(second, &mut |_| ());
                (later.module, later.diagnostics)
            });
            match flow {
                Flow::End => {}
                _ if parser.diagnostics.is_empty() => parser.append(later),
                // What is wrong in the first half may say what is meant in the second one.
                _ => {
                    parser.lines(second, keep);
                }
            }
        }
    }
    (parser.module, parser.diagnostics)
}

/// The halves of a long program.
fn halves(source: &Source) -> Option<(Part, Part)> {
    let count = source.line_count();
    let middle = count / 2 + 1;
    let first = Part {
        end: middle,
        ..Part::WHOLE
    };
    let second = Part {
        first: middle,
        ..Part::WHOLE
    };
    (HAS_THREADS && count as usize >= FEW).then_some((first, second))
}

/// Some lines of a program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part {
    /// Its first line, from 1.
    pub(crate) first: u32,
    /// The line after it.
    pub(crate) end: u32,
}

impl Part {
    /// All of them.
    pub(crate) const WHOLE: Part = Part {
        first: 1,
        end: u32::MAX,
    };
}

/// The same of some lines, whose steps count from 0; after each of them `take` may take the statements that were read since.
#[cfg(feature = "tools")]
pub(crate) fn parse_part(
    source: &Source,
    tip_version: f64,
    part: Part,
    take: &mut dyn FnMut(&mut Vec<Statement>),
) -> (Module, Findings) {
    if let Err(wrong) = header::version(source, tip_version) {
        return (Module::default(), vec![*wrong].into());
    }
    let mut parser = Parser::new(source, tip_version);
    parser.lines(part, take);
    (parser.module, parser.diagnostics)
}

/// What is at the end of a piece of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flow {
    /// The program goes on.
    Continue,
    /// The rest of the line does not count.
    NextLine,
    /// END: the rest of the file does not count.
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
    /// What ends the comment of another language that has begun.
    in_comment: Option<&'static str>,
    /// The braces that are open, which are reported: whether each begins a block.
    braces: Vec<bool>,
    /// Names with a `-`, as written in declarations, which are reported.
    hyphened: Vec<String>,
    /// The finding about lines with numbers.
    numbered: Option<usize>,
    module: Module,
    diagnostics: Findings,
}

impl<'a> Parser<'a> {
    /// Before the first line.
    fn new(source: &'a Source, tip_version: f64) -> Self {
        Parser {
            source,
            text: source.text(),
            line: source.line(1),
            step: 0,
            tokens: Vec::new(),
            in_comment: None,
            braces: Vec::new(),
            hyphened: Vec::new(),
            numbered: None,
            module: Module {
                edition: Edition::of(tip_version),
                title: header::title(source),
                statements: Vec::new(),
                after_end: None,
            },
            diagnostics: Findings::default(),
        }
    }
}

impl Parser<'_> {
    fn lines(&mut self, part: Part, take: &mut dyn FnMut(&mut Vec<Statement>)) -> Flow {
        let lines = self.source.lines_from(part.first);
        for line in lines.take_while(|line| line.number < part.end) {
            self.line = line;
            self.check_length();
            if line.number > 2 && !self.is_in_comment() {
                let flow = self.statements_of_line();
                take(&mut self.module.statements);
                if flow == Flow::End {
                    return flow;
                }
            }
        }
        // A comment of another language that never ends has swallowed it.
        let goes_on = part.end <= self.source.line_count();
        if !goes_on && self.in_comment.is_none() && !self.ends_with_number() {
            self.report_missing_end();
        }
        Flow::Continue
    }

    /// Takes the statements of the lines that follow, and what was found there.
    fn append(&mut self, (module, diagnostics): (Module, Findings)) {
        let steps = self.step;
        let moved = module.statements.into_iter().map(|it| Statement {
            step: it.step + steps,
            ..it
        });
        self.module.statements.extend(moved);
        self.module.after_end = module.after_end;
        self.diagnostics.append(diagnostics);
    }

    /// Whether the line belongs to a comment of another language, `/* … */`, whose start is reported.
    fn is_in_comment(&mut self) -> bool {
        let Some(closes) = self.in_comment else {
            return false;
        };
        if self.source.slice(self.line.span).contains(closes) {
            self.in_comment = None;
        }
        true
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
        let place = self.trim(self.line.span, char::is_whitespace);
        let missing = Diagnostic::new(Code::NoEnd, place, Parsing::ProgramEndsHere);
        self.report(missing.help(Parsing::PutEnd));
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

    /// `span` without the characters at its ends that `drop` names.
    fn trim(&self, span: Span, drop: impl Fn(char) -> bool) -> Span {
        let text = self.source.slice(span);
        let kept = text.trim_end_matches(&drop);
        let end = span.start + kept.len();
        Span::new(end - kept.trim_start_matches(&drop).len(), end)
    }
}

#[cfg(test)]
mod tests;
