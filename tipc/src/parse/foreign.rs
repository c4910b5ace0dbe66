//! Statements as other languages write them: each is one finding, and what it opens or closes counts as what was meant.

use super::Parser;
use super::shape::meant;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::foreign::{self, Means};
use crate::language::{Keyword, commands, keywords};
use crate::lex::{Kind, Token, foreign_run, lex};
use crate::message::{Commanding, Habit, Message};
use crate::source::Span;
use crate::syntax::{Arithmetic, Relation, Shape, StatementKind, Word, upper_case};

/// How a comment of other languages begins that may have several lines.
const OPENS: &str = "/*";

impl Parser<'_> {
    /// `# …`, `' …`, `/* … */`: the rest of the line is part of it.
    pub(super) fn foreign_comment(&mut self, span: Span) {
        let text = self.source.slice(span);
        // A `;` and a `//` are part of it, too.
        let line = self.source.slice(Span::new(span.start, self.line.span.end));
        self.in_comment = text.starts_with(OPENS) && !line.contains("*/");
        if let Some(foreign) = foreign_run(self.text, span) {
            self.report_foreign(foreign);
            return self.push(StatementKind::Broken(Shape::Plain), span);
        }
        let first = text.split_whitespace().next().unwrap_or_default();
        let place = Span::new(span.start, span.start + first.len());
        let help = if self.in_comment {
            Habit::EachLine
        } else {
            Habit::Comment
        };
        let reason = Commanding::NoCommand { word: first.into() };
        self.report_unknown(place, first, reason, help);
        self.push(StatementKind::Broken(Shape::Plain), span);
    }

    /// A statement that begins with no word of the language, if it is known from other languages.
    pub(super) fn unknown(&mut self, word: Span, tokens: &[Token]) -> Option<StatementKind> {
        self.assignment(tokens)
            .or_else(|| self.foreign_word(word, tokens))
    }

    fn foreign_word(&mut self, word: Span, tokens: &[Token]) -> Option<StatementKind> {
        let text = upper_case(self.source.slice(word));
        if commands::find(&text).is_some() {
            return None;
        }
        let row = foreign::statement(&text)?;
        let reason = Commanding::NoCommand { word: text.clone() };
        match row.means {
            // The checker knows whether it is a variable.
            Means::Statement => None,
            Means::Keyword(Keyword::Subroutine) => {
                self.report_unknown(word, &text, reason, row.habit.clone());
                Some(self.subroutine_named(word, tokens))
            }
            Means::Keyword(keyword) => {
                self.report_unknown(word, &text, reason, row.habit.clone());
                Some(StatementKind::Broken(meant(keyword)))
            }
            // A label without its colon may be such a word, too.
            Means::Declaration(_) if tokens.len() < 2 => None,
            Means::Declaration(kind) => {
                self.report_unknown(word, &text, reason, row.habit.clone());
                let is_name = |token: &&Token| {
                    let text = self.source.slice(token.span);
                    !text.starts_with(|first: char| first.is_ascii_digit())
                };
                let names: Vec<Token> = tokens.iter().filter(is_name).copied().collect();
                Some(self.define(kind, word, &names, true))
            }
        }
    }

    /// A routine that begins with another word: what calls it is not wrong.
    fn subroutine_named(&self, word: Span, tokens: &[Token]) -> StatementKind {
        let name = tokens.get(1).filter(|token| token.kind == Kind::Word);
        let Some(name) = name else {
            return StatementKind::Broken(Shape::Subroutine);
        };
        StatementKind::Subroutine {
            keyword: word,
            name: Word {
                node: upper_case(self.source.slice(name.span)),
                span: name.span,
            },
        }
    }

    /// `A++`, `A--` and `A == 1`.
    fn assignment(&mut self, tokens: &[Token]) -> Option<StatementKind> {
        let [name, operator, rest @ ..] = tokens else {
            return None;
        };
        let word = upper_case(self.source.slice(name.span));
        let (reason, help) = match (operator.kind, rest) {
            (Kind::Arithmetic(sign @ (Arithmetic::Add | Arithmetic::Sub)), [second])
                if second.kind == operator.kind =>
            {
                let sign = if sign == Arithmetic::Add { "+" } else { "-" };
                let help = Habit::Increment {
                    name: word.clone(),
                    sign: sign.into(),
                };
                let place = operator.span.to(second.span);
                let sign = self.source.slice(place).into();
                (Habit::NoOperator { sign }, help)
            }
            (Kind::Relation(Relation::Eq), _) => {
                let name = word.clone();
                (Habit::CompareAsStatement, Habit::Assign { name })
            }
            _ => return None,
        };
        if name.kind != Kind::Word {
            return None;
        }
        self.report_unknown(name.span, &word, reason, help);
        Some(StatementKind::Broken(Shape::Plain))
    }

    /// A first word that the language lacks.
    fn report_unknown(
        &mut self,
        place: Span,
        word: &str,
        reason: impl Into<Message>,
        help: impl Into<Message>,
    ) {
        let fault = Diagnostic::new(Code::UnknownCommand, place, reason);
        self.report(fault.about(word).help(help));
    }

    /// The keyword that a first word in full-width letters is meant to be.
    pub(super) fn narrow_keyword(&self, word: Span) -> Option<Keyword> {
        let narrow = super::line::narrow(self.source.slice(word));
        keywords::find(&narrow, self.module.edition)
    }

    /// `ELSE IF`, which is one word.
    pub(super) fn is_else_if(&self, tokens: &[Token]) -> bool {
        let second = tokens.get(1).map(|token| self.source.slice(token.span));
        second.is_some_and(|word| word.eq_ignore_ascii_case(Keyword::If.word()))
    }

    pub(super) fn report_else_if(&mut self, tokens: &[Token]) {
        let place = match tokens {
            [first, second, ..] => first.span.to(second.span),
            _ => return,
        };
        let word = Keyword::ElseIf;
        let fault = Diagnostic::new(Code::Format, place, Habit::ElseIfInTwo);
        self.report(fault.help(Habit::InOneWord { word: word.into() }));
    }

    /// The word after END on its line.
    pub(super) fn word_after(&self, word: Span, span: Span) -> Option<Word> {
        let mut tokens = Vec::new();
        lex(
            self.text,
            Span::new(word.end, span.end.max(word.end)),
            &mut tokens,
        );
        let first = tokens.first().filter(|token| token.kind == Kind::Word)?;
        Some(Word {
            node: upper_case(self.source.slice(first.span)),
            span: first.span,
        })
    }
}
