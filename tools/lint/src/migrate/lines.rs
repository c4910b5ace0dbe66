//! Lines to labels and statements, as old programs write them.

use super::Migrator;
use super::variables::Variables;
use crate::message::Migrating;
use std::collections::{HashMap, HashSet};
use tipc::language::Edition;
use tipc::language::reserved::is_reserved;
use tipc::lex;
use tipc::lex::{Kind, Pieces, Token, split_comment};
use tipc::source::{Source, Span};

/// A label or a statement.
#[derive(Debug)]
pub(super) enum Piece {
    /// `NAME:`; the place of the name.
    Label {
        name: Span,
        line: u32,
    },
    Statement(Statement),
}

impl Piece {
    pub(super) fn statement(&self) -> Option<&Statement> {
        match self {
            Piece::Statement(statement) => Some(statement),
            Piece::Label { .. } => None,
        }
    }

    pub(super) fn label(&self) -> Option<Span> {
        match self {
            Piece::Label { name, .. } => Some(*name),
            Piece::Statement(_) => None,
        }
    }

    pub(super) fn line(&self) -> u32 {
        match self {
            Piece::Statement(Statement { line, .. }) | Piece::Label { line, .. } => *line,
        }
    }
}

/// A statement; MESSAGE and REM have no tokens but a text.
#[derive(Debug)]
pub(super) struct Statement {
    pub(super) line: u32,
    /// The first word, upper-cased.
    pub(super) keyword: String,
    /// Its place.
    pub(super) word: Span,
    /// Everything, the first word included.
    pub(super) tokens: Vec<Token>,
    /// What follows the first word.
    pub(super) text: Span,
}

impl Statement {
    /// Whether an assignment operator follows the first word.
    pub(super) fn is_equation(&self) -> bool {
        matches!(self.tokens.get(1), Some(token) if matches!(token.kind, Kind::Assign(_)))
    }

    /// The words that are not labels: a colon right after a word makes it one.
    pub(super) fn words(&self) -> impl Iterator<Item = Span> {
        let next = self.tokens.iter().skip(1).map(Some).chain([None]);
        self.tokens
            .iter()
            .zip(next)
            .filter(|(token, next)| token.kind == Kind::Word && !is_colon(*next))
            .map(|(token, _)| token.span)
    }

    /// The labels that it jumps to.
    pub(super) fn jumps(&self) -> impl Iterator<Item = Span> {
        let pairs = self.tokens.windows(2);
        pairs
            .filter(|pair| pair[0].kind == Kind::Word && is_colon(Some(&pair[1])))
            .map(|pair| pair[0].span)
    }

    /// Where it ends.
    pub(super) fn end(&self) -> usize {
        self.tokens
            .last()
            .map_or(self.text.end, |token| token.span.end)
    }
}

fn is_colon(token: Option<&Token>) -> bool {
    token.is_some_and(|token| token.kind == Kind::Colon)
}

/// Everything from line `first` up to END. `single`: `;` does not part a text.
pub(super) fn read(source: &Source, first: u32, single: bool) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for line in source.lines().skip(first.saturating_sub(1) as usize) {
        let (code, _) = split_comment(source.text(), line.span);
        for piece in Pieces::new(source.text(), code, single) {
            let piece = match piece {
                lex::Piece::Label { name, .. } => Piece::Label {
                    name,
                    line: line.number,
                },
                lex::Piece::Statement { word, span, .. } => {
                    Piece::Statement(statement(source, line.number, word, span))
                }
            };
            let ends = piece.statement().is_some_and(|it| it.keyword == "END");
            pieces.push(piece);
            if ends {
                return pieces;
            }
        }
    }
    pieces
}

fn statement(source: &Source, line: u32, word: Span, span: Span) -> Statement {
    let keyword = source.slice(word).to_ascii_uppercase();
    let mut tokens = Vec::new();
    if !matches!(keyword.as_str(), "MESSAGE" | "REM") {
        lex::lex(source.text(), span, &mut tokens);
    }
    Statement {
        line,
        keyword,
        word,
        tokens,
        text: Span::new(word.end, span.end),
    }
}

/// The one word that may be a label all the same.
const LOOP: &str = "LOOP";

impl Migrator<'_> {
    /// Gives such labels another name, wherever they are.
    pub(super) fn labels(&mut self, pieces: &[Piece]) {
        let upper = |span: Span| self.source.slice(span).to_ascii_uppercase();
        let declared: Vec<Span> = pieces.iter().filter_map(Piece::label).collect();
        let names: HashSet<String> = declared.iter().map(|span| upper(*span)).collect();
        let statements = pieces.iter().filter_map(Piece::statement);
        let jumps = statements.flat_map(|statement| statement.jumps());
        let mut free: HashMap<String, String> = HashMap::new();
        for span in jumps.chain(declared).collect::<Vec<Span>>() {
            let name = self.source.slice(span).to_ascii_uppercase();
            let clashes =
                names.contains(&name) && name != LOOP && is_reserved(&name, Edition::V3_1);
            if clashes {
                let new = free.entry(name.clone());
                let new = new.or_insert_with(|| free_name(&name, &names)).clone();
                self.rename(span, &new);
                self.change(span, Migrating::Label { name, new });
            }
        }
    }
}

/// A name that no label has.
fn free_name(name: &str, names: &HashSet<String>) -> String {
    let candidates = (1..).map(|number| format!("{name}_{number}"));
    let mut free = candidates.filter(|candidate| !names.contains(candidate));
    free.next().unwrap_or_default()
}

/// `%fnn%` or `%dnn%`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Placeholder {
    /// Where it starts in the text.
    pub(super) start: usize,
    /// Where it ends.
    pub(super) end: usize,
    /// With decimals.
    pub(super) real: bool,
    /// The number of the VAR.
    pub(super) digits: String,
}

/// The old placeholders of a text, from left to right.
pub(super) fn old_placeholders(text: &str) -> Vec<Placeholder> {
    let mut found = Vec::new();
    let mut start = 0;
    while let Some(percent) = text[start..].find('%') {
        start += percent;
        match placeholder(&text[start..]) {
            Some((real, digits)) => {
                let end = start + "%f%".len() + digits.len();
                found.push(Placeholder {
                    start,
                    end,
                    real,
                    digits: digits.to_owned(),
                });
                start = end;
            }
            None => start += 1,
        }
    }
    found
}

fn placeholder(text: &str) -> Option<(bool, &str)> {
    let (word, _) = text.strip_prefix('%')?.split_once('%')?;
    let (real, digits) = match (word.strip_prefix('f'), word.strip_prefix('d')) {
        (Some(digits), _) => (true, digits),
        (None, Some(digits)) => (false, digits),
        (None, None) => return None,
    };
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then_some((real, digits))
}

/// How many decimals `%fnn%` shows: as C's `%f`, whose letter it is.
const DECIMALS: u8 = 6;

impl Migrator<'_> {
    /// Placeholders of today, and what would be read otherwise today.
    pub(super) fn message(&mut self, statement: &Statement, variables: &Variables) {
        let text = self.slice(statement.text).to_owned();
        let place =
            |start, end| Span::new(statement.text.start + start, statement.text.start + end);
        if let Some(at) = text.find(';') {
            self.question(place(at, at + 1), Migrating::Semicolon);
        }
        let old = old_placeholders(&text);
        let behind = old
            .iter()
            .map(|placeholder| placeholder.start)
            .chain([text.len()]);
        let before = [0]
            .into_iter()
            .chain(old.iter().map(|placeholder| placeholder.end));
        for (start, end) in before.zip(behind) {
            if let Some(name) = names_a_variable(&text[start..end], variables) {
                self.question(place(start, end), Migrating::PlainText { name });
            }
        }
        for placeholder in &old {
            let span = place(placeholder.start, placeholder.end);
            let name = variables.var(&placeholder.digits).unwrap_or_default();
            let new = if placeholder.real {
                format!("%{name}.{DECIMALS}%")
            } else {
                format!("%{name}%")
            };
            self.edits.replace(span, new.as_str());
            let old = text[placeholder.start..placeholder.end].to_owned();
            self.change(span, Migrating::Placeholder { old, new });
        }
    }
}

/// A variable that plain text would show today.
fn names_a_variable(text: &str, variables: &Variables) -> Option<String> {
    let words = text.split('%').skip(1);
    let closed = text.matches('%').count().saturating_sub(1);
    words
        .take(closed)
        .map(|word| {
            word.split('.')
                .next()
                .unwrap_or_default()
                .to_ascii_uppercase()
        })
        .find(|name| variables.is_var(name))
}
