//! Reader of the tokens of one statement.

use crate::code::Code;
use crate::diagnostic::{Diagnostic, MistakeId};
use crate::language::{Edition, Keyword, commands};
use crate::lex::{Kind, Token};
use crate::message::phrase::End;
use crate::message::{Message, Parsing, Suggestion};
use crate::source::Span;
use crate::syntax::{Relation, Word, upper_case};
use smol_str::SmolStr;
use tip_runtime::command::READING;

/// The broken part of a statement. Callers choose the help by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Broken {
    /// THEN or a jump is missing after the condition of an IF.
    Then,
    /// Signs of another language that mean this relation.
    Relation(Relation),
    /// A sign without an operand.
    Sign,
    /// Any other part.
    Other,
}

/// Fault of a statement.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    pub(super) broken: Broken,
    pub(super) diagnostic: Box<Diagnostic>,
}

impl Fault {
    /// Names the part that is broken.
    pub(super) fn of(self, broken: Broken) -> Self {
        Fault { broken, ..self }
    }

    /// Names the mistake, which is reported once.
    pub(super) fn once(mut self, mistake: MistakeId) -> Self {
        self.diagnostic.once = Some(mistake);
        self
    }

    /// Adds the help: what to do about it.
    pub(super) fn help(mut self, help: impl Into<Message>) -> Self {
        self.diagnostic.help = Some(help.into());
        self
    }

    /// Adds a help unless there is one.
    pub(super) fn or_help(mut self, help: impl Into<Message>) -> Self {
        self.diagnostic.help.get_or_insert_with(|| help.into());
        self
    }
}

impl From<Diagnostic> for Fault {
    fn from(diagnostic: Diagnostic) -> Self {
        Fault {
            broken: Broken::Other,
            diagnostic: Box::new(diagnostic),
        }
    }
}

/// A piece of a statement, or its fault.
pub(super) type Parsed<T> = Result<T, Fault>;

/// The tokens of a statement, read one by one. All of its faults have one code.
pub(super) struct Reader<'a> {
    /// The text of the source.
    pub(super) text: &'a str,
    tokens: &'a [Token],
    at: usize,
    code: Code,
    /// The edition whose words are read.
    pub(super) edition: Edition,
}

impl<'a> Reader<'a> {
    /// Starts after the `skip` first tokens.
    pub(super) fn new(
        text: &'a str,
        tokens: &'a [Token],
        skip: usize,
        code: Code,
        edition: Edition,
    ) -> Self {
        Reader {
            text,
            tokens,
            at: skip,
            code,
            edition,
        }
    }

    /// Returns true if a word is one of a special variable, well-formed or not.
    pub(super) fn is_reading(&self, word: &str) -> bool {
        self.edition >= Edition::V3_2 && word.starts_with(READING)
    }

    /// Returns true if this reads an equation, whose rules differ from those of arguments.
    pub(super) fn is_equation(&self) -> bool {
        self.code == Code::Equation
    }

    /// Returns the next token, which stays.
    pub(super) fn peek(&self) -> Option<Token> {
        self.tokens.get(self.at).copied()
    }

    /// Returns the token after the next one.
    pub(super) fn peek_second(&self) -> Option<Token> {
        self.tokens.get(self.at + 1).copied()
    }

    /// Takes the next token.
    pub(super) fn take(&mut self) -> Option<Token> {
        let token = self.peek()?;
        self.at += 1;
        Some(token)
    }

    /// Returns the text at a span.
    pub(super) fn slice(&self, span: Span) -> &'a str {
        &self.text[span.start..span.end]
    }

    /// Returns the word at a span, upper-cased.
    pub(super) fn word(&self, span: Span) -> Word {
        Word {
            node: upper_case(self.slice(span)),
            span,
        }
    }

    /// Returns true if the next token is the keyword `word`.
    pub(super) fn at_word(&self, word: Keyword) -> bool {
        self.peek()
            .is_some_and(|token| token.kind == Kind::Word && word.is(self.slice(token.span)))
    }

    /// Takes the keyword `word` if it is next.
    pub(super) fn take_word(&mut self, word: Keyword) -> Option<Span> {
        let token = self.at_word(word).then(|| self.take())?;
        token.map(|token| token.span)
    }

    /// Returns the token before the next one.
    pub(super) fn before(&self) -> Option<Token> {
        self.tokens.get(self.at.checked_sub(1)?).copied()
    }

    /// Returns the tokens that are left.
    pub(super) fn left_tokens(&self) -> &'a [Token] {
        &self.tokens[self.at..]
    }

    /// Returns the number of tokens left.
    pub(super) fn left(&self) -> usize {
        self.tokens.len() - self.at
    }

    /// Returns the next token's location, or the one right after the last token.
    pub(super) fn here(&self) -> Span {
        match (self.peek(), self.tokens.last()) {
            (Some(token), _) => token.span,
            (None, Some(last)) => Span::new(last.span.end, last.span.end),
            (None, None) => Span::default(),
        }
    }

    /// Returns the whole statement.
    pub(super) fn whole(&self) -> Span {
        match self.tokens {
            [first, .., last] => first.span.to(last.span),
            _ => self.here(),
        }
    }

    /// Returns the first word of the statement, upper-cased.
    pub(super) fn first_word(&self) -> SmolStr {
        let first = self.tokens.first().map_or("", |it| self.slice(it.span));
        upper_case(first)
    }

    /// Returns all that is left.
    pub(super) fn rest(&self) -> Span {
        match self.tokens.last() {
            Some(last) if self.left() > 0 => self.here().to(last.span),
            _ => self.here(),
        }
    }

    /// Returns the help for two numbers with only a comma between them, as in `1,000` or `4,5`.
    pub(super) fn comma_number(&self, before: Span, after: Span) -> Option<Suggestion> {
        let is_glued = self.text.get(before.end..after.start) == Some(",");
        let (before, after) = (self.slice(before), self.slice(after));
        let is_number = |text: &str| text.chars().all(|c| c.is_ascii_digit());
        (is_glued && is_number(before) && is_number(after)).then(|| Suggestion::Comma {
            whole: format!("{before}{after}").into(),
            point: format!("{before}.{after}").into(),
        })
    }

    /// Creates a fault of this statement at `span`.
    pub(super) fn fault(&self, span: Span, reason: impl Into<Message>) -> Fault {
        Diagnostic::new(self.code, span, reason).into()
    }

    /// Creates a fault of this statement at `span`, with a help.
    pub(super) fn fault_with_help(
        &self,
        span: Span,
        reason: impl Into<Message>,
        help: impl Into<Message>,
    ) -> Fault {
        self.fault(span, reason).help(help)
    }

    /// Checks that nothing is left. The help is `help`, unless another statement follows.
    pub(super) fn expect_end_or(&self, end: End, help: impl Into<Message>) -> Parsed<()> {
        self.expect_end(end).map_err(|fault| {
            let next = self.slice(self.here());
            match commands::find_in(next, self.edition) {
                Some(_) => fault,
                None => fault.help(help),
            }
        })
    }

    /// Checks that nothing is left.
    pub(super) fn expect_end(&self, end: End) -> Parsed<()> {
        if self.left() == 0 {
            return Ok(());
        }
        let reason = Parsing::NothingBehind { end };
        let help = Parsing::NextStatementElsewhere;
        Err(self.fault_with_help(self.rest(), reason, help))
    }
}
