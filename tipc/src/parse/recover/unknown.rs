//! Statements whose first word the language lacks. Each is read as far as its form shows what was meant, so that it is
//! reported as one mistake. A misspelt keyword opens and closes blocks as the keyword does.

use super::characters::narrow;
use super::control::{joined, marked, spread};
use super::statement::shape;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, MistakeId};
use crate::language::commands::Meaning;
use crate::language::reserved::{JOINT, POSITION};
use crate::language::{Edition, Keyword, commands, keywords, names};
use crate::lex::{Kind, Token, lex};
use crate::message::{Commanding, Message, Naming, Parsing, Suggestion};
use crate::parse::Parser;
use crate::parse::declaration::declared_kind;
use crate::source::Span;
use crate::suggest::nearest;
use crate::syntax::{Arithmetic, Relation, Shape, StatementKind, VariableKind, Word, upper_case};

/// Returns a command as a keyword, if it opens, divides or closes a block.
fn of_block(command: &str) -> Option<Keyword> {
    keywords::find(command, Edition::default()).filter(|keyword| Shape::of(*keyword).is_some())
}

/// Returns true if the rest of a statement fits the keyword that its first word probably means.
fn fits(keyword: Keyword, text: &str, tokens: &[Token]) -> bool {
    let has = |word: Keyword| {
        let is_it = |token: &Token| {
            let text = &text[token.span.start..token.span.end];
            word.is(text)
        };
        tokens.iter().any(is_it)
    };
    match keyword {
        Keyword::For => has(Keyword::To),
        Keyword::If => has(Keyword::Then) || has(Keyword::Goto) || has(Keyword::Gosub),
        Keyword::Next => tokens.len() <= 2,
        Keyword::Else | Keyword::EndIf | Keyword::Wend | Keyword::Repeat | Keyword::SubEnd => {
            tokens.len() == 1
        }
        _ => true,
    }
}

impl Parser<'_> {
    /// Returns the command whose name is nearest to a word of letters. Names with digits are rather labels.
    pub(in crate::parse) fn misspelt(&self, word: &str) -> Option<&'static str> {
        let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
        let is_searched = !self.diagnostics.are_many() && word.chars().all(is_letter);
        let names = commands::names(self.module.edition);
        is_searched.then(|| nearest(word, names))?
    }

    /// Reads a statement whose first word the language lacks, if its form shows what was meant.
    pub(in crate::parse) fn unknown(
        &mut self,
        word: Span,
        tokens: &[Token],
    ) -> Option<StatementKind> {
        let other = self.assignment(tokens).or_else(|| self.brace(word, tokens));
        // The other searches take time, and nearly all statements begin with a command.
        if other.is_some() || self.is_command(self.source.slice(word)) {
            return other;
        }
        self.line_number(word, tokens)
            .or_else(|| self.rest_of_unknown(word))
            .or_else(|| self.intended(word, tokens))
            .or_else(|| self.label_in_pieces(tokens))
            .or_else(|| self.marked_label(tokens))
            .or_else(|| self.after_semicolon(word))
    }

    /// Reads a statement after an unknown one on the same line as part of that, as in `PRINT "N="; N`.
    pub(in crate::parse) fn rest_of_unknown(&mut self, word: Span) -> Option<StatementKind> {
        let before = self.module.statements.last()?;
        let is_unknown = match &before.kind {
            StatementKind::Command { name, .. } => {
                name.span != before.span
                    && !self.is_command(&name.node)
                    && self.misspelt(&name.node).is_none()
            }
            // The parts after the second one follow a part that was skipped here.
            StatementKind::Broken(Shape::Plain) => self.unknown_line == before.line,
            _ => false,
        };
        let is_rest = is_unknown && before.line == self.line.number;
        let is_known = || {
            self.misspelt(&upper_case(self.source.slice(word)))
                .is_some()
        };
        let goes_on = is_rest && !is_known();
        if goes_on {
            self.unknown_line = self.line.number;
        }
        goes_on.then_some(StatementKind::Broken(Shape::Plain))
    }

    /// Reads a statement whose first word is a keyword misspelt, in two words, or glued to a parenthesis, as a
    /// statement of that keyword.
    pub(in crate::parse) fn intended(
        &mut self,
        word: Span,
        tokens: &[Token],
    ) -> Option<StatementKind> {
        let text = upper_case(self.source.slice(word));
        let reason = Commanding::NoCommand { word: text.clone() };
        if let Some((keyword, kind)) = self.second_of_two(tokens) {
            let help = Suggestion::InOneWord {
                word: keyword.into(),
            };
            self.report_unknown(word, &text, reason, help);
            return Some(self.define(kind, word, &tokens[1..], true));
        }
        let called = text
            .split_once('(')
            .and_then(|(name, _)| commands::find_in(name, self.module.edition));
        let (near, help): (_, Message) = match called.map(|command| command.name) {
            Some(command) => (command, Suggestion::Glued { command }.into()),
            None => {
                let near = self.misspelt(&text)?;
                (near, Suggestion::DidYouMean { near: near.into() }.into())
            }
        };
        let keyword = of_block(near).filter(|it| fits(*it, self.text, tokens))?;
        let fault = Diagnostic::new(Code::UnknownCommand, word, reason).about(&*text);
        self.report(match called {
            Some(_) => fault.help(help),
            None => fault.guess(help),
        });
        Some(match keyword {
            Keyword::Subroutine => self.broken_subroutine(word, tokens),
            keyword => StatementKind::Broken(shape(Some(keyword), self.text, tokens)),
        })
    }

    /// Reads a label with blanks or a `-`: `MAIN-LOOP:`.
    pub(in crate::parse) fn label_in_pieces(&mut self, tokens: &[Token]) -> Option<StatementKind> {
        let (first, rest) = tokens.split_first()?;
        let word = upper_case(self.source.slice(first.span));
        let is_known = self.is_command(&word) || self.misspelt(&word).is_some();
        // `SUB WALK:` is probably a statement of another language.
        let is_apart = rest.first().is_none_or(|next| next.kind == Kind::Word);
        if is_known || is_apart || first.kind != Kind::Word {
            return None;
        }
        let location = spread(self.text, first.span, rest)?;
        let written = upper_case(self.source.slice(location));
        let name = joined(&written);
        let reason = Naming::NoLabelName { word: written };
        let fault = Diagnostic::new(Code::Argument, location, reason)
            .once(MistakeId::ForeignLabel(name.clone()));
        self.report(fault.help(Parsing::WriteLabel { name }));
        Some(StatementKind::Broken(Shape::Plain))
    }

    /// Reads a label that is marked as in another language: `*L1`.
    pub(in crate::parse) fn marked_label(&mut self, tokens: &[Token]) -> Option<StatementKind> {
        let (location, name) = marked(self.text, tokens)?;
        let node = name.clone();
        let span = Span::new(location.end - node.len(), location.end);
        let first = tokens.first()?.span;
        let word = upper_case(self.source.slice(first));
        let reason = Commanding::NoCommand { word: word.clone() };
        let fault = Diagnostic::new(Code::UnknownCommand, first, reason).about(word.as_str());
        let fault = fault.once(MistakeId::ForeignLabel(name.clone()));
        self.report(fault.help(Parsing::WriteLabel { name }));
        // The label is declared, so that jumps to it are not reported.
        Some(StatementKind::Label(Word { node, span }))
    }

    /// Reads a comment of another language: `; a comment`. Only the semicolon stands before an unknown word.
    pub(in crate::parse) fn after_semicolon(&mut self, word: Span) -> Option<StatementKind> {
        let start = self.line.span.start;
        let before = self.source.slice(Span::new(start, word.start));
        let text = upper_case(self.source.slice(word));
        if before.trim() != ";" || self.is_command(&text) {
            return None;
        }
        let reason = Commanding::NoCommand { word: text.clone() };
        self.report_unknown(word, &text, reason, Suggestion::Comment);
        Some(StatementKind::Broken(Shape::Plain))
    }

    /// Returns the declaration that the first two words make as one word, as in `DEF VAR`.
    pub(in crate::parse) fn second_of_two(
        &self,
        tokens: &[Token],
    ) -> Option<(Keyword, VariableKind)> {
        let [first, second, _, ..] = tokens else {
            return None;
        };
        let (first, second) = (
            self.source.slice(first.span),
            self.source.slice(second.span),
        );
        let whole = keywords::find(&format!("{first}_{second}"), self.module.edition)?;
        declared_kind(whole).map(|kind| (whole, kind))
    }

    /// Returns true for END with a dot: `END.`.
    pub(in crate::parse) fn is_end_with_dot(&self, word: Span) -> bool {
        let text = self.source.slice(word);
        let bare = text.trim_matches('.');
        bare.len() < text.len() && Keyword::End.is(bare)
    }

    pub(in crate::parse) fn end_with_dot(&mut self, word: Span) {
        let text = upper_case(self.source.slice(word));
        let reason = Commanding::NoCommand { word: text.clone() };
        let near = Keyword::End.word();
        self.report_unknown(
            word,
            &text,
            reason,
            Suggestion::DidYouMean { near: near.into() },
        );
        self.push(StatementKind::End, word);
    }

    /// Reports a first word that the language lacks.
    pub(in crate::parse) fn report_unknown(
        &mut self,
        location: Span,
        word: &str,
        reason: impl Into<Message>,
        help: impl Into<Message>,
    ) {
        let fault = Diagnostic::new(Code::UnknownCommand, location, reason);
        self.report(fault.about(word).help(help));
    }

    /// Returns the keyword that a first word in full-width letters is meant to be.
    pub(in crate::parse) fn narrow_keyword(&self, word: Span) -> Option<Keyword> {
        let word = self.source.slice(word);
        let narrow = (!word.is_ascii()).then(|| narrow(word))?;
        keywords::find(&narrow, self.module.edition)
    }

    /// Returns true if the second word is IF, as in `ELSE IF`, which should be one word.
    pub(in crate::parse) fn is_else_if(&self, tokens: &[Token]) -> bool {
        let second = tokens.get(1).map(|token| self.source.slice(token.span));
        second.is_some_and(|word| Keyword::If.is(word))
    }

    pub(in crate::parse) fn report_else_if(&mut self, tokens: &[Token]) {
        let location = match tokens {
            [first, second, ..] => first.span.to(second.span),
            _ => return,
        };
        let word = Keyword::ElseIf;
        let fault = Diagnostic::new(Code::Format, location, Suggestion::ElseIfInTwo);
        self.report(fault.help(Suggestion::InOneWord { word: word.into() }));
    }

    /// Returns the word after END on its line.
    pub(in crate::parse) fn word_after(&self, word: Span, span: Span) -> Option<Word> {
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

    /// Reads an assignment with an operator of another language.
    pub(in crate::parse) fn assignment(&mut self, tokens: &[Token]) -> Option<StatementKind> {
        let [name, operator, rest @ ..] = tokens else {
            return None;
        };
        if name.kind != Kind::Word {
            return self.increment_before(tokens);
        }
        if operator.kind == Kind::Word
            && let Some(several) = self.several_assigned(tokens)
        {
            return Some(several);
        }
        let next = rest.first();
        let both = operator
            .span
            .to(next.map_or(operator.span, |next| next.span));
        let assigns = next.is_some_and(|next| next.kind == Kind::Assign(None));
        if operator.kind == Kind::Word && !assigns {
            return None;
        }
        let word = upper_case(self.source.slice(name.span));
        let assign = Suggestion::Assign { name: word.clone() };
        let (reason, help): (Suggestion, Message) =
            match (operator.kind, next.map(|next| next.kind)) {
                (Kind::Arithmetic(sign @ (Arithmetic::Add | Arithmetic::Sub)), Some(second))
                    if second == operator.kind && rest.len() == 1 =>
                {
                    let signs = self.source.slice(both).into();
                    let sign = if sign == Arithmetic::Add { "+" } else { "-" };
                    let help = Suggestion::Increment {
                        name: word.clone(),
                        sign: sign.into(),
                    };
                    (Suggestion::NoOperator { sign: signs }, help.into())
                }
                (Kind::Relation(Relation::Eq), _) => {
                    (Suggestion::CompareAsStatement, assign.into())
                }
                (Kind::Arithmetic(_), Some(Kind::Assign(None))) => {
                    let sign = format!("{}=", self.source.slice(operator.span)).into();
                    let help = Suggestion::Update { name: word.clone() };
                    (Suggestion::SplitOperator { sign }, help.into())
                }
                (Kind::Word, Some(Kind::Assign(None)))
                    if self.source.slice(operator.span) == "%" =>
                {
                    let sign = self.source.slice(both).into();
                    (
                        Suggestion::NoOperator { sign },
                        Suggestion::Remainder.into(),
                    )
                }
                (Kind::Arithmetic(Arithmetic::Sub), Some(Kind::Relation(Relation::Gt))) => {
                    let member = rest.get(1).map(|member| self.source.slice(member.span));
                    let text = upper_case(&format!("{word}.{}", member.unwrap_or_default()));
                    let sign = self.source.slice(both).into();
                    (
                        Suggestion::NoOperator { sign },
                        Suggestion::Write { text }.into(),
                    )
                }
                (Kind::Colon, Some(Kind::Assign(None))) => {
                    let sign = self.source.slice(both).into();
                    let fault =
                        Diagnostic::new(Code::Equation, both, Suggestion::NoOperator { sign });
                    self.report(fault.help(assign));
                    return Some(StatementKind::Broken(Shape::Plain));
                }
                _ => return None,
            };
        self.report_unknown(name.span, &word, reason, help);
        Some(StatementKind::Broken(Shape::Plain))
    }

    /// Reads an assignment of several variables: `A, B = 1, 2`.
    pub(in crate::parse) fn several_assigned(&mut self, tokens: &[Token]) -> Option<StatementKind> {
        let equals = tokens.iter().position(|it| it.kind == Kind::Assign(None))?;
        let (names, _) = tokens.split_at(equals);
        let word = |token: &Token| self.source.slice(token.span);
        let are_names = names
            .iter()
            .all(|it| names::is_variable(&upper_case(word(it))));
        let (first, last) = (names.first()?, names.last()?);
        let location = first.span.to(last.span);
        let text = self.source.slice(location);
        let is_list = text.matches(',').count() + 1 == names.len();
        let name = upper_case(word(first));
        if !are_names || !is_list || self.is_command(&name) {
            return None;
        }
        let fault = Diagnostic::new(Code::Equation, location, Parsing::OneVariableLeft);
        let member = upper_case(word(last));
        let help: Message = match names {
            // `P,X = 1`
            [_, _] if is_member(&member) && !is_list_after(tokens, equals) => {
                let text = format!("{name}.{member}").into();
                Suggestion::Write { text }.into()
            }
            _ => Suggestion::AssignEach { name }.into(),
        };
        self.report(fault.help(help));
        Some(StatementKind::Broken(Shape::Plain))
    }

    /// Reads an increment with its signs in front: `++A`.
    pub(in crate::parse) fn increment_before(&mut self, tokens: &[Token]) -> Option<StatementKind> {
        let [first, second, name] = tokens else {
            return None;
        };
        let is_sign = matches!(
            first.kind,
            Kind::Arithmetic(Arithmetic::Add | Arithmetic::Sub)
        );
        if !is_sign || second.kind != first.kind || second.spaced || name.kind != Kind::Word {
            return None;
        }
        let sign = self.source.slice(first.span);
        let both = first.span.to(second.span);
        let reason = Suggestion::NoOperator {
            sign: self.source.slice(both).into(),
        };
        let help = Suggestion::Increment {
            name: upper_case(self.source.slice(name.span)),
            sign: sign.into(),
        };
        self.report_unknown(both, sign, reason, help);
        Some(StatementKind::Broken(Shape::Plain))
    }
}

/// Returns true if several values follow the `=`.
fn is_list_after(tokens: &[Token], equals: usize) -> bool {
    let after = tokens[equals + 1..].iter();
    after.filter(|it| it.kind == Kind::Word).count() > 1
}

/// Returns true if a word is a member of a POS or JOINT.
fn is_member(word: &str) -> bool {
    let is_joint = |rest: &str| rest.len() == 1 && rest.bytes().all(|it| it.is_ascii_digit());
    POSITION.contains(&word) || word.strip_prefix(JOINT).is_some_and(is_joint)
}

impl Parser<'_> {
    /// Reads a statement after a line number, as in `10 PTP F1 P`. All line numbers are one mistake.
    pub(in crate::parse) fn line_number(
        &mut self,
        word: Span,
        tokens: &[Token],
    ) -> Option<StatementKind> {
        let text = self.source.slice(word);
        let digits = text.trim_end_matches('.').trim_start_matches(['N', 'n']);
        let is_number = !digits.is_empty() && digits.bytes().all(|it| it.is_ascii_digit());
        let second = self.source.slice(tokens.get(1)?.span);
        let command = commands::find_in(second, self.module.edition);
        if !is_number || command.is_none() {
            return None;
        }
        let shape = match command.map(|command| command.meaning) {
            Some(Meaning::Keyword(keyword)) => shape(Some(keyword), self.text, &tokens[1..]),
            _ => Shape::Plain,
        };
        self.is_numbered = true;
        let reason = Commanding::NoCommand { word: text.into() };
        let fault = Diagnostic::new(Code::UnknownCommand, word, reason).about(text);
        let fault = fault
            .once(MistakeId::LineNumbers)
            .again(Suggestion::NumberedToo);
        self.report(fault.help(Suggestion::NoNumbers));
        Some(StatementKind::Broken(shape))
    }

    /// Returns true if the last statement is END after a line number, as in `90 END`, which is reported.
    pub(in crate::parse) fn ends_with_number(&self) -> bool {
        let last = self.module.statements.last();
        last.filter(|_| self.is_numbered).is_some_and(|last| {
            let mut words = self.source.slice(last.span).split_whitespace();
            let last_word = words.next_back().unwrap_or_default();
            matches!(last.kind, StatementKind::Broken(_)) && Keyword::End.is(last_word)
        })
    }
}
