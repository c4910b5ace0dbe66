//! Fixes: changes of the text that remove a diagnostic. They are derived from the messages of the diagnostic and the
//! statement around its location, not from the checked program.

mod statements;
pub(crate) mod texts;
pub(crate) mod words;

use tipc::diagnostic::{Diagnostic, Edit, Fix};
use tipc::language::Keyword;
use tipc::lex::{BLANKS, Kind, Token, lex};
use tipc::message::Message;
use tipc::parse::LINE_LIMIT;
use tipc::source::{Line, Source, Span};
use tipc::syntax::{Module, Statement};

/// A function that returns the fix of a diagnostic, if it has one.
pub(crate) type Fixer = fn(&Site<'_>) -> Option<Fix>;

/// Sources of fixes. The first one with a fix counts.
const FIXERS: &[Fixer] = &[
    texts::characters,
    texts::messages,
    words::words,
    statements::jumps,
    statements::blocks,
    words::operators,
    statements::declarations,
];

/// Adds a fix to each diagnostic that has one. `of_word` returns the source of fixes for a word of another language.
pub(crate) fn attach(
    source: &Source,
    module: &Module,
    diagnostics: &mut [Diagnostic],
    of_word: fn(&Diagnostic, &Source) -> Option<Fixer>,
) {
    for diagnostic in diagnostics {
        let site = Site {
            source,
            module,
            diagnostic,
        };
        let fix = match of_word(diagnostic, source) {
            Some(fixer) => fixer(&site),
            None => FIXERS.iter().find_map(|fixer| fixer(&site)),
        };
        diagnostic.fixes = fix
            .filter(|fix| is_sound(source, fix))
            .into_iter()
            .collect();
    }
}

/// Returns true if the edits change the text, do not overlap, and insert only ASCII, which is the same in every
/// encoding.
fn is_sound(source: &Source, fix: &Fix) -> bool {
    let is_change = |edit: &Edit| source.slice(edit.span) != edit.text && edit.text.is_ascii();
    let follows = |pair: &[Edit]| pair[0].span.end <= pair[1].span.start;
    !fix.edits.is_empty() && fix.edits.iter().all(is_change) && fix.edits.windows(2).all(follows)
}

/// Maximum length of a statement whose diagnostics are fixed, bytes. A statement may have many diagnostics, each of
/// which reads all of it.
const MAX_STATEMENT_BYTES: usize = 4 * LINE_LIMIT;

/// A diagnostic in its file.
#[derive(Clone, Copy)]
pub(crate) struct Site<'a> {
    source: &'a Source,
    module: &'a Module,
    diagnostic: &'a Diagnostic,
}

impl<'a> Site<'a> {
    fn reason(&self) -> &'a Message {
        &self.diagnostic.reason
    }

    fn help(&self) -> Option<&'a Message> {
        self.diagnostic.help.as_ref()
    }

    /// Returns the location of the diagnostic.
    fn span(&self) -> Span {
        self.diagnostic.span
    }

    fn text(&self) -> &'a str {
        self.slice(self.span())
    }

    fn slice(&self, span: Span) -> &'a str {
        self.source.slice(span)
    }

    fn index(&self) -> Option<usize> {
        self.module.statement_at(self.span().start)
    }

    fn statement(&self) -> Option<&'a Statement> {
        self.index().map(|index| &self.module.statements[index])
    }

    /// Returns the tokens of the statement around the diagnostic; nothing if it is longer than [`MAX_STATEMENT_BYTES`].
    fn tokens(&self) -> Vec<Token> {
        let is_short = |it: &&Statement| it.span.end - it.span.start <= MAX_STATEMENT_BYTES;
        let statement = self.statement().filter(is_short);
        statement.map_or_else(Vec::new, |it| self.tokens_of(it.span))
    }

    fn tokens_of(&self, span: Span) -> Vec<Token> {
        let mut tokens = Vec::new();
        lex(self.source.text(), span, &mut tokens);
        tokens
    }

    fn is(&self, token: &Token, keyword: Keyword) -> bool {
        token.kind == Kind::Word && self.is_word(token.span, keyword)
    }

    fn is_word(&self, span: Span, keyword: Keyword) -> bool {
        self.slice(span).eq_ignore_ascii_case(keyword.word())
    }

    fn line(&self) -> Line {
        let (line, _) = self.source.line_column(self.span().start);
        self.source.line(line)
    }

    fn line_end(&self) -> &'a str {
        match self.slice(self.source.line(1).end) {
            "" => "\n",
            end => end,
        }
    }

    /// Returns the end of a line, and the blanks that the line of the diagnostic begins with.
    fn next_line(&self) -> String {
        let text = self.slice(self.line().span);
        let indent = &text[..text.len() - text.trim_start_matches([' ', '\t']).len()];
        format!("{}{indent}", self.line_end())
    }

    /// Returns `word`, in small letters if the statement begins with small letters.
    fn like(&self, word: &str) -> String {
        let start = self.statement().map_or(self.span(), |it| it.span);
        let letters = || {
            self.slice(start)
                .chars()
                .take_while(|char| !BLANKS.contains(char))
        };
        let small = letters().any(|char| char.is_ascii_lowercase())
            && !letters().any(|char| char.is_ascii_uppercase());
        match small {
            true => word.to_ascii_lowercase(),
            false => word.to_owned(),
        }
    }

    /// Creates an edit that replaces a location by a keyword.
    fn write(&self, location: Span, word: &str) -> Edit {
        Edit::replace(location, self.like(word))
    }

    /// Creates an edit that adds a keyword after the text that ends at `at`.
    fn append(&self, at: usize, word: &str) -> Edit {
        Edit::insert(at, format!(" {}", self.like(word)))
    }
}
