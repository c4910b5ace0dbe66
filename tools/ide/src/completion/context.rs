//! The syntactic position of the cursor, from the text before it on its line.

use crate::Document;
use tipc::language::commands::{self, Command, Form};
use tipc::language::reserved::is_motion_flag;
use tipc::language::{Keyword, keywords};
use tipc::lex::{self, Kind, Piece, Pieces, Token, split_comment};
use tipc::source::Span;
use tipc::syntax::StatementKind;

/// The syntactic position of the cursor.
pub(crate) enum Context {
    /// Line 1, the version of the language.
    Version,
    /// The beginning of a statement.
    Start,
    /// A member of this variable.
    Member(String),
    /// A label that this jump leads to.
    Label(Keyword),
    /// A new name.
    Declaration,
    /// A condition of this statement.
    Condition(Keyword),
    /// A number of FOR, and the particle that may follow.
    Counting(Option<Keyword>),
    /// The variable of FOR or NEXT.
    Counter,
    /// The right side of an equation.
    Right,
    /// A variable between percent signs.
    Placeholder,
    /// An argument of a command; the number of arguments before it.
    Argument(&'static Command, usize),
}

impl Document {
    /// Returns the position of a byte of the text, and the span of the word there; `None` in comments, texts and after END.
    pub(crate) fn completion_context(&self, offset: usize) -> Option<(Context, Span)> {
        let source = &self.loaded.source;
        let text = source.text();
        let offset = (0..=offset.min(text.len()))
            .rev()
            .find(|at| text.is_char_boundary(*at))?;
        let number = self.line_of_cursor(offset);
        let line = source.line(number).span;
        let before = Span::new(line.start, offset.clamp(line.start, line.end));
        let word = self.letters_around(before.end, line);
        match number {
            1 => return Some((Context::Version, Span::new(line.start, line.end))),
            2 => return None,
            _ => {}
        }
        if split_comment(text, before).1.is_some() || self.is_after_end(offset) {
            return None;
        }
        let done = Span::new(line.start, word.start);
        if let Some(rest) = self.slice(done).strip_suffix('.') {
            let name = &rest[rest.trim_end_matches(is_letter).len()..];
            return Some((Context::Member(name.to_owned()), word));
        }
        let last = Pieces::new(text, done, false)
            .in_edition(self.loaded.module.edition)
            .last();
        let context = match last {
            Some(Piece::Statement {
                word: head, span, ..
            }) if !self.is_ended(span.end, done.end) => self.in_statement(head, span, done)?,
            _ => Context::Start,
        };
        Some((context, word))
    }

    /// Returns the line of an offset; the end of a text that ends in a line end is on a line of its own.
    fn line_of_cursor(&self, offset: usize) -> u32 {
        let position = self
            .loaded
            .source
            .position(offset, tipc::source::Unit::Utf8);
        position.line
    }

    fn is_after_end(&self, offset: usize) -> bool {
        let last = self.statements().last();
        last.is_some_and(|last| last.kind == StatementKind::End && offset > last.span.end)
    }

    /// Returns the span of the letters around an offset.
    fn letters_around(&self, at: usize, line: Span) -> Span {
        let before = self.slice(Span::new(line.start, at));
        let after = self.slice(Span::new(at, line.end));
        let start = before.trim_end_matches(is_letter).len() + line.start;
        let end = at + (after.len() - after.trim_start_matches(is_letter).len());
        Span::new(start, end)
    }

    /// Returns true if a `;` ends the statement before an offset.
    fn is_ended(&self, from: usize, to: usize) -> bool {
        from <= to && self.slice(Span::new(from, to)).contains(';')
    }

    fn in_statement(&self, head: Span, span: Span, done: Span) -> Option<Context> {
        let text = self.loaded.source.text();
        let mut tokens = Vec::new();
        lex::lex(
            text,
            Span::new(span.start, done.end.max(span.start)),
            &mut tokens,
        );
        let keyword = keywords::find(self.slice(head), self.loaded.module.edition);
        if let Some(keyword) = keyword {
            return self.after_keyword(keyword, &tokens, Span::new(head.end, done.end));
        }
        if tokens
            .iter()
            .any(|token| matches!(token.kind, Kind::Assign(_)))
        {
            return Some(Context::Right);
        }
        let command = commands::find_in(self.slice(head), self.loaded.module.edition)?;
        let written = tokens.get(1..).unwrap_or_default();
        Some(Context::Argument(
            command,
            self.argument_count(command, written),
        ))
    }

    fn after_keyword(&self, keyword: Keyword, tokens: &[Token], rest: Span) -> Option<Context> {
        let has = |wanted: Keyword| {
            let is_it = |token: &Token| self.slice(token.span).eq_ignore_ascii_case(wanted.word());
            tokens.iter().skip(1).any(is_it)
        };
        Some(match keyword {
            Keyword::Goto
            | Keyword::Gosub
            | Keyword::Call
            | Keyword::StartThread
            | Keyword::StopThread
            | Keyword::WaitThread => Context::Label(keyword),
            Keyword::Define if tokens.is_empty() => Context::Declaration,
            Keyword::Define => Context::Counting(None),
            Keyword::If if has(Keyword::Goto) => Context::Label(Keyword::Goto),
            Keyword::If if has(Keyword::Gosub) => Context::Label(Keyword::Gosub),
            Keyword::If | Keyword::ElseIf if has(Keyword::Then) => return None,
            Keyword::If | Keyword::ElseIf | Keyword::While | Keyword::Until => {
                Context::Condition(keyword)
            }
            Keyword::For if tokens.len() < 2 => Context::Counter,
            Keyword::For if has(Keyword::Step) => Context::Counting(None),
            Keyword::For if has(Keyword::To) => Context::Counting(Some(Keyword::Step)),
            Keyword::For => Context::Counting(Some(Keyword::To)),
            Keyword::Next => Context::Counter,
            Keyword::DefVar
            | Keyword::DefPos
            | Keyword::DefJoint
            | Keyword::Subroutine
            | Keyword::Thread => Context::Declaration,
            Keyword::Message | Keyword::FileMessage
                if self.slice(rest).matches('%').count() % 2 == 1 =>
            {
                Context::Placeholder
            }
            Keyword::Message
            | Keyword::FileMessage
            | Keyword::ThreadEnd
            | Keyword::Rem
            | Keyword::Then
            | Keyword::Else
            | Keyword::EndIf
            | Keyword::Wend
            | Keyword::Repeat
            | Keyword::To
            | Keyword::Step
            | Keyword::SubEnd
            | Keyword::Return
            | Keyword::End
            | Keyword::Exit => return None,
        })
    }

    /// Returns the number of arguments among tokens; flags of motions and signs do not count.
    pub(crate) fn argument_count(&self, command: &Command, tokens: &[Token]) -> usize {
        let has_flags =
            matches!(command.form, Form::Robot(arguments) if arguments.hs || arguments.motion);
        let edition = self.loaded.module.edition;
        let counts = |token: &&Token| {
            let word = self.slice(token.span).to_ascii_uppercase();
            token.kind == Kind::Word && !(has_flags && is_motion_flag(&word, edition))
        };
        tokens.iter().filter(counts).count()
    }
}

fn is_letter(char: char) -> bool {
    char.is_ascii_alphanumeric() || char == '_'
}
