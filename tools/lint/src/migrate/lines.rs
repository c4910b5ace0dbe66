//! Lines to labels and statements, as old programs write them.

use tipc::lex::{self, Kind, Pieces, Token, split_comment};
use tipc::source::{Source, Span};

/// A label or a statement.
#[derive(Debug)]
pub(super) enum Piece {
    /// `NAME:`; the location of the name.
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
    /// Its location.
    pub(super) word: Span,
    /// Everything, the first word included.
    pub(super) tokens: Vec<Token>,
    /// Text after the first word.
    pub(super) text: Span,
}

impl Statement {
    /// Returns true if an assignment operator follows the first word.
    pub(super) fn is_equation(&self) -> bool {
        matches!(self.tokens.get(1), Some(token) if matches!(token.kind, Kind::Assign(_)))
    }

    /// Returns the words that are not labels: a colon right after a word makes it one.
    pub(super) fn words(&self) -> impl Iterator<Item = Span> {
        let next = self.tokens.iter().skip(1).map(Some).chain([None]);
        self.tokens
            .iter()
            .zip(next)
            .filter(|(token, next)| token.kind == Kind::Word && !is_colon(*next))
            .map(|(token, _)| token.span)
    }

    pub(super) fn jumps(&self) -> impl Iterator<Item = Span> {
        let pairs = self.tokens.windows(2);
        pairs
            .filter(|pair| pair[0].kind == Kind::Word && is_colon(Some(&pair[1])))
            .map(|pair| pair[0].span)
    }

    pub(super) fn end(&self) -> usize {
        self.tokens
            .last()
            .map_or(self.text.end, |token| token.span.end)
    }
}

fn is_colon(token: Option<&Token>) -> bool {
    token.is_some_and(|token| token.kind == Kind::Colon)
}

/// Reads everything from line `first` up to END. `single`: `;` does not part a text.
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
