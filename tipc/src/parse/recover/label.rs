//! Diagnostics of colons that end no label: after words of the language, before the name, after full-width names.

use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::Meaning;
use crate::language::{Keyword, commands, keywords, names};
use crate::lex::{DELIMITERS, foreign_run, split_comment};
use crate::message::{Message, Naming, Parsing, Suggestion};
use crate::parse::{Flow, Parser};
use crate::source::Span;
use crate::syntax::{Shape, StatementKind, upper_case};

impl Parser<'_> {
    /// Reads a colon at the end of `span` that does not end the name of a label; `None` if it does.
    pub(in crate::parse) fn no_label(&mut self, word: Span, span: Span) -> Option<Flow> {
        let keyword = keywords::find(self.source.slice(word), self.module.edition);
        let (shape, flow) = match keyword {
            Some(Keyword::Else) => (Shape::Else, Flow::Continue),
            Some(Keyword::EndIf) => (Shape::EndIf, Flow::Continue),
            Some(Keyword::Wend) => (Shape::Wend, Flow::Continue),
            // The rest of the line is a text.
            Some(keyword) if keyword.takes_text() => (Shape::Plain, Flow::NextLine),
            _ => {
                return match self.after_colon(word, span) {
                    Some(help) => Some(self.command_with_colon(word, span, help)),
                    None => self.odd_name(word, span),
                };
            }
        };
        let word_of = upper_case(self.source.slice(word));
        let reason = Naming::WordOfLanguage {
            word: word_of.clone(),
        };
        let help = Suggestion::WithoutColon { word: word_of };
        self.report(Diagnostic::new(Code::Argument, word, reason).help(help));
        self.push(StatementKind::Broken(shape), span);
        Some(flow)
    }

    /// Reads a colon without a name, or after a full-width one: `:`, `Ｌ１:`.
    pub(in crate::parse) fn odd_name(&mut self, word: Span, span: Span) -> Option<Flow> {
        if word.start == word.end {
            return Some(self.nameless(span));
        }
        let foreign = foreign_run(self.text, word)?;
        self.report_foreign(foreign);
        let name = self.narrow_word(word);
        self.push(
            match names::is_label(&name.node) {
                true => StatementKind::Label(name),
                false => StatementKind::Broken(Shape::Plain),
            },
            span,
        );
        Some(Flow::Continue)
    }

    /// Suggests a replacement for a command with a colon, if its arguments follow: `SLEEP: 100`, `GOTO :L1`.
    pub(in crate::parse) fn after_colon(&self, word: Span, span: Span) -> Option<Message> {
        let text = self.source.slice(word);
        let command = commands::find_in(text, self.module.edition)?;
        let (code, _) = split_comment(self.text, self.line.span);
        let rest = self
            .source
            .slice(Span::new(span.end, code.end.max(span.end)));
        let next = rest.split(DELIMITERS).find(|next| !next.is_empty())?;
        let is_apart = word.end + 1 < span.end;
        let word = upper_case(text);
        match command.meaning {
            Meaning::Keyword(Keyword::Goto | Keyword::Gosub | Keyword::Call) => {
                let name = upper_case(next.trim_end_matches(':'));
                Some(Parsing::WriteLabel { name }.into())
            }
            Meaning::Keyword(Keyword::Return | Keyword::Exit) if is_apart => {
                Some(Suggestion::ColonSeparates.into())
            }
            Meaning::Keyword(_) => None,
            _ if is_apart => Some(Suggestion::ColonSeparates.into()),
            _ => Some(Suggestion::WithoutColon { word }.into()),
        }
    }

    pub(in crate::parse) fn command_with_colon(
        &mut self,
        word: Span,
        span: Span,
        help: Message,
    ) -> Flow {
        let reason = Naming::WordOfLanguage {
            word: upper_case(self.source.slice(word)),
        };
        self.report(Diagnostic::new(Code::Argument, word, reason).help(help));
        self.push(StatementKind::Broken(Shape::Plain), span);
        Flow::NextLine
    }

    /// Reads a colon without a name before it, or with one after it: `:L1`.
    pub(in crate::parse) fn nameless(&mut self, colon: Span) -> Flow {
        let fault = Diagnostic::new(Code::Argument, colon, Parsing::LabelNameMissing);
        self.push(StatementKind::Broken(Shape::Plain), colon);
        let next = self.text[colon.end..self.line.span.end.max(colon.end)].trim();
        let is_name = |it: u8| it.is_ascii_alphanumeric() || it == b'_';
        if next.is_empty() || !next.bytes().all(is_name) || self.is_command(next) {
            self.report(fault);
            return Flow::Continue;
        }
        let name = upper_case(next);
        self.report(fault.help(Parsing::WriteLabel { name }));
        Flow::NextLine
    }
}
