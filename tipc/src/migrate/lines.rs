//! Lines to labels and statements, as old programs write them.

use crate::lex::{self, DELIMITERS, Kind, Token, skip_delimiters, word_end};
use crate::source::Source;
use crate::syntax::Span;

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
    /// What stands behind the first word.
    pub(super) text: Span,
}

impl Statement {
    /// Whether an assignment operator stands behind the first word.
    pub(super) fn is_equation(&self) -> bool {
        matches!(self.tokens.get(1), Some(token) if matches!(token.kind, Kind::Assign(_)))
    }

    /// The words that are no labels: a colon right behind a word makes it one.
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
    let mut reader = Reader {
        source,
        single,
        line: first,
        pieces: Vec::new(),
    };
    for line in first..=source.line_count() {
        reader.line = line;
        if reader.line_holds_end() {
            break;
        }
    }
    reader.pieces
}

struct Reader<'a> {
    source: &'a Source,
    single: bool,
    line: u32,
    pieces: Vec<Piece>,
}

impl Reader<'_> {
    fn line_holds_end(&mut self) -> bool {
        let line = self.source.line(self.line).span;
        let text = self.source.slice(line);
        let code = line.start + text.find("//").unwrap_or(text.len());
        let mut start = line.start;
        while start <= code {
            let rest = &self.source.text().as_bytes()[start..code];
            let length = rest.iter().position(|byte| *byte == b';');
            let end = length.map_or(code, |length| start + length);
            match self.piece(start, end, code) {
                After::Piece => start = end + 1,
                After::Line => return false,
                After::End => return true,
            }
        }
        false
    }

    /// Reads what stands before `end`, or, if it is a text, before `code`.
    fn piece(&mut self, start: usize, end: usize, code: usize) -> After {
        let trimmed = self.source.text()[start..end].trim_end_matches(DELIMITERS);
        let bytes = &self.source.text().as_bytes()[..start + trimmed.len()];
        let mut at = skip_delimiters(bytes, start);
        while at < bytes.len() {
            let word = Span::new(at, word_end(bytes, at));
            let keyword = self.source.slice(word).to_ascii_uppercase();
            let is_text = keyword == "MESSAGE" || keyword == "REM";
            let colon = skip_delimiters(bytes, word.end);
            if bytes.get(colon) == Some(&b':') && !(is_text && colon > word.end) {
                let line = self.line;
                self.pieces.push(Piece::Label { name: word, line });
                at = skip_delimiters(bytes, colon + 1);
                continue;
            }
            return self.statement(keyword, word, bytes.len(), if is_text { code } else { end });
        }
        After::Piece
    }

    fn statement(&mut self, keyword: String, word: Span, end: usize, code: usize) -> After {
        let is_text = keyword == "MESSAGE" || keyword == "REM";
        let after = match keyword.as_str() {
            "END" => After::End,
            _ if is_text && self.single => After::Line,
            _ => After::Piece,
        };
        let end = if after == After::Line { code } else { end };
        let mut tokens = Vec::new();
        if !is_text {
            lex::lex(self.source.text(), Span::new(word.start, end), &mut tokens);
        }
        self.pieces.push(Piece::Statement(Statement {
            line: self.line,
            keyword,
            word,
            tokens,
            text: Span::new(word.end, end),
        }));
        after
    }
}

/// What follows a piece.
#[derive(Clone, Copy, PartialEq, Eq)]
enum After {
    /// The next piece.
    Piece,
    /// The next line.
    Line,
    /// Nothing: the program ends.
    End,
}
