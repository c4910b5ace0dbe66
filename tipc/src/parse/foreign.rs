//! Statements as other languages write them: each is one diagnostic, and what it opens or closes counts as what was meant.

use super::jump::{joined, label_of, marked, spread};
use super::statement::intended_shape;
use super::{Parser, narrow};
use crate::code::Code;
use crate::diagnostic::MOST;
use crate::diagnostic::{Diagnostic, Label};
use crate::foreign;
use crate::foreign::Means;
use crate::language::commands::Meaning;
use crate::language::reserved::{JOINT, LOOP, POSITION};
use crate::language::{Edition, Keyword, commands, keywords, names};
use crate::lex::{Kind, Token, foreign_run, lex};
use crate::message::{Commanding, ForeignWord, Message, Naming, Parsing, Suggestion};
use crate::source::Span;
use crate::suggest::nearest;
use crate::syntax::{
    Arithmetic, Relation, Shape, Statement, StatementKind, VariableKind, Word, upper_case,
};
use smol_str::SmolStr;

/// The most statements of a line that may show parts of one text.
const SHOWN: usize = 16;

/// Returns the role of a misspelt word for the statements around it, if it has one.
fn means(command: &str) -> Option<Means> {
    let keyword = keywords::find(command, Edition::default())?;
    Some(match keyword {
        Keyword::DefVar => Means::Declaration(VariableKind::Var),
        Keyword::DefPos => Means::Declaration(VariableKind::Pos),
        Keyword::DefJoint => Means::Declaration(VariableKind::Joint),
        Keyword::If
        | Keyword::ElseIf
        | Keyword::Else
        | Keyword::EndIf
        | Keyword::While
        | Keyword::Wend
        | Keyword::Repeat
        | Keyword::Until
        | Keyword::For
        | Keyword::Next
        | Keyword::Subroutine
        | Keyword::SubEnd => Means::Keyword(keyword),
        _ => return None,
    })
}

/// Returns true if the rest of a statement is that of its misspelt keyword.
fn fits(means: &Means, text: &str, tokens: &[Token]) -> bool {
    let Means::Keyword(keyword) = means else {
        return true;
    };
    let has = |word: Keyword| {
        let is_it = |token: &Token| {
            let text = &text[token.span.start..token.span.end];
            text.eq_ignore_ascii_case(word.word())
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
    fn misspelt(&self, word: &str) -> Option<&'static str> {
        let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
        let is_searched = !self.diagnostics.are_many() && word.chars().all(is_letter);
        let names = commands::names(self.module.edition);
        is_searched.then(|| nearest(word, names))?
    }

    /// `# …`, `' …`, `/* … */`: the rest of the line is part of it.
    pub(super) fn foreign_comment(&mut self, span: Span) {
        let text = self.source.slice(span);
        // A `;` and a `//` are part of it, too.
        let line = self.source.slice(Span::new(span.start, self.line.span.end));
        self.in_comment = foreign::comment_of_lines(text)
            .filter(|[opens, closes]| !line[opens.len()..].contains(closes))
            .map(|[_, closes]| closes);
        if let Some(foreign) = foreign_run(self.text, span) {
            self.report_foreign(foreign);
            return self.push(StatementKind::Broken(Shape::Plain), span);
        }
        let first = text.split_whitespace().next().unwrap_or_default();
        let location = Span::new(span.start, span.start + first.len());
        let help = if self.in_comment.is_some() {
            ForeignWord::EachLine
        } else {
            ForeignWord::Comment
        };
        let reason = Commanding::NoCommand { word: first.into() };
        self.report_unknown(location, first, reason, help);
        self.push(StatementKind::Broken(Shape::Plain), span);
    }

    /// Reads a statement that begins with no word of the language, if it is known from other languages.
    pub(super) fn unknown(&mut self, word: Span, tokens: &[Token]) -> Option<StatementKind> {
        let other = self.assignment(tokens).or_else(|| self.brace(word, tokens));
        // Nearly all statements begin with a command: for those no other language is searched.
        if other.is_some() || self.is_command(self.source.slice(word)) {
            return other;
        }
        self.line_number(word, tokens)
            .or_else(|| self.goes_on_declaring(word, tokens))
            .or_else(|| self.goes_on_showing(word))
            .or_else(|| self.foreign_word(word, tokens))
            .or_else(|| self.label_in_pieces(tokens))
            .or_else(|| self.marked_label(tokens))
            .or_else(|| self.after_semicolon(word))
    }

    /// `DEF_VAR A; B`: the name after the `;` was to be declared, too.
    fn goes_on_declaring(&mut self, word: Span, tokens: &[Token]) -> Option<StatementKind> {
        let before = self.module.statements.last()?;
        let StatementKind::Define { kind, .. } = before.kind else {
            return None;
        };
        let text = upper_case(self.source.slice(word));
        let is_name = tokens.len() == 1 && !self.is_command(&text);
        if !is_name || before.line != self.line.number {
            return None;
        }
        let reason = Commanding::NoCommand { word: text.clone() };
        self.report_unknown(word, &text, reason, Parsing::SeparateNames);
        let names = vec![Word {
            node: text,
            span: word,
        }];
        Some(StatementKind::Define {
            kind,
            keyword: word,
            names,
        })
    }

    /// `PRINT "N="; N`: what follows the `;` was to be shown, too.
    fn goes_on_showing(&mut self, word: Span) -> Option<StatementKind> {
        let before = self.module.statements.iter().rev().take(SHOWN);
        let mut line = before.take_while(|it| it.line == self.line.number);
        let shows = |statement: Span| {
            let row = foreign::statement(foreign::name(self.source.slice(statement)));
            row.is_some_and(|row| matches!(row.advice, ForeignWord::ShowText | ForeignWord::KeyIn))
        };
        let is_known = foreign::statement(self.source.slice(word)).is_some();
        // A label or an equation may begin with such a word.
        let is_wrong = |it: &Statement| {
            matches!(
                it.kind,
                StatementKind::Command { .. } | StatementKind::Broken(_)
            )
        };
        let goes_on = !is_known && line.any(|it| is_wrong(it) && shows(it.keyword()));
        goes_on.then_some(StatementKind::Broken(Shape::Plain))
    }

    /// `MAIN-LOOP:`, `MAIN LOOP:`
    fn label_in_pieces(&mut self, tokens: &[Token]) -> Option<StatementKind> {
        let (first, rest) = tokens.split_first()?;
        let word = upper_case(self.source.slice(first.span));
        let is_loop = word == LOOP;
        let is_known = foreign::statement(&word).is_some_and(|_| !is_loop)
            || self.is_command(&word)
            || self.misspelt(&word).is_some();
        if is_known || first.kind != Kind::Word {
            return None;
        }
        let location = spread(self.text, first.span, rest)?;
        let written = upper_case(self.source.slice(location));
        let name = joined(&written);
        let reason = Naming::NoLabelName { word: written };
        let fault = Diagnostic::new(Code::Argument, location, reason).once(label_of(&name));
        self.report(fault.help(Parsing::WriteLabel { name }));
        Some(StatementKind::Broken(Shape::Plain))
    }

    /// `*L1`, `LABEL L1` where a label stands.
    fn marked_label(&mut self, tokens: &[Token]) -> Option<StatementKind> {
        let (location, name) = marked(self.text, tokens).or_else(|| self.label_said(tokens))?;
        let node = name.clone();
        let span = Span::new(location.end - node.len(), location.end);
        let first = tokens.first()?.span;
        let word = upper_case(self.source.slice(first));
        let reason = Commanding::NoCommand { word: word.clone() };
        let fault = Diagnostic::new(Code::UnknownCommand, first, reason).about(word.as_str());
        let fault = fault.once(label_of(&name));
        self.report(fault.help(Parsing::WriteLabel { name }));
        // What jumps there is not wrong.
        Some(StatementKind::Label(Word { node, span }))
    }

    /// `LABEL L1`: where it stands, and the name.
    fn label_said(&self, tokens: &[Token]) -> Option<(Span, SmolStr)> {
        let [word, name] = tokens else {
            return None;
        };
        let said = foreign::begins_label(self.source.slice(word.span));
        let is_name = name.kind == Kind::Word && said;
        is_name.then(|| {
            (
                word.span.to(name.span),
                upper_case(self.source.slice(name.span)),
            )
        })
    }

    /// `; a comment`: nothing but the mark stands before a word that is none of the language.
    fn after_semicolon(&mut self, word: Span) -> Option<StatementKind> {
        let start = self.line.span.start;
        let before = self.source.slice(Span::new(start, word.start));
        let text = upper_case(self.source.slice(word));
        if before.trim() != ";" || self.is_command(&text) {
            return None;
        }
        let reason = Commanding::NoCommand { word: text.clone() };
        self.report_unknown(word, &text, reason, ForeignWord::Comment);
        Some(StatementKind::Broken(Shape::Plain))
    }

    fn foreign_word(&mut self, word: Span, tokens: &[Token]) -> Option<StatementKind> {
        let text = upper_case(self.source.slice(word));
        if self.is_command(&text) {
            return None;
        }
        let (means, help): (_, Message) = match foreign::statement(&text) {
            Some(row) => (row.means, row.advice.clone().into()),
            None => {
                let near = self.misspelt(&text)?;
                (
                    means(near).filter(|means| fits(means, self.text, tokens))?,
                    Suggestion::DidYouMean { near: near.into() }.into(),
                )
            }
        };
        let reason = Commanding::NoCommand { word: text.clone() };
        let kind = match means {
            // The checker knows whether it is a variable.
            Means::Statement => return None,
            // A label without its colon may be such a word, too.
            Means::Declaration(_) if tokens.len() < 2 => return None,
            Means::Keyword(Keyword::Subroutine) | Means::Declaration(_)
                if self.is_routine(means, tokens) =>
            {
                let help = match self.names_main(tokens) {
                    true => ForeignWord::FromTheTop.into(),
                    false if matches!(means, Means::Declaration(_)) => {
                        ForeignWord::Subroutine.into()
                    }
                    false => help,
                };
                self.report_unknown(word, &text, reason, help);
                return Some(self.subroutine_named(word, tokens));
            }
            Means::Keyword(keyword) => {
                StatementKind::Broken(intended_shape(keyword, self.text, tokens))
            }
            Means::Declaration(kind) => match self.second_of_two(tokens) {
                Some((keyword, kind)) => {
                    let help = ForeignWord::InOneWord {
                        word: keyword.into(),
                    };
                    self.report_unknown(word, &text, reason, help);
                    return Some(self.define(kind, word, &tokens[1..], true));
                }
                None => self.define(kind, word, tokens, true),
            },
        };
        self.report_unknown(word, &text, reason, help);
        Some(kind)
    }

    /// `DEF VAR`, which is one word.
    fn second_of_two(&self, tokens: &[Token]) -> Option<(Keyword, VariableKind)> {
        let [first, second, _, ..] = tokens else {
            return None;
        };
        let (first, second) = (
            self.source.slice(first.span),
            self.source.slice(second.span),
        );
        let whole = keywords::find(&format!("{first}_{second}"), self.module.edition)?;
        match means(whole.word())? {
            Means::Declaration(kind) => Some((whole, kind)),
            _ => None,
        }
    }

    /// `END.`
    pub(super) fn is_end_with_dot(&self, word: Span) -> bool {
        let text = self.source.slice(word);
        let bare = text.trim_matches('.');
        bare.len() < text.len() && bare.eq_ignore_ascii_case(Keyword::End.word())
    }

    pub(super) fn end_with_dot(&mut self, word: Span) {
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
    pub(super) fn report_unknown(
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
    pub(super) fn narrow_keyword(&self, word: Span) -> Option<Keyword> {
        let word = self.source.slice(word);
        let narrow = (!word.is_ascii()).then(|| narrow(word))?;
        keywords::find(&narrow, self.module.edition)
    }

    /// `ELSE IF`, which is one word.
    pub(super) fn is_else_if(&self, tokens: &[Token]) -> bool {
        let second = tokens.get(1).map(|token| self.source.slice(token.span));
        second.is_some_and(|word| word.eq_ignore_ascii_case(Keyword::If.word()))
    }

    pub(super) fn report_else_if(&mut self, tokens: &[Token]) {
        let location = match tokens {
            [first, second, ..] => first.span.to(second.span),
            _ => return,
        };
        let word = Keyword::ElseIf;
        let fault = Diagnostic::new(Code::Format, location, ForeignWord::ElseIfInTwo);
        self.report(fault.help(ForeignWord::InOneWord { word: word.into() }));
    }

    /// Returns the word after END on its line.
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

impl Parser<'_> {
    /// Reads an assignment with an operator of another language.
    pub(super) fn assignment(&mut self, tokens: &[Token]) -> Option<StatementKind> {
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
        let assign = ForeignWord::Assign { name: word.clone() };
        let (reason, help): (ForeignWord, Message) =
            match (operator.kind, next.map(|next| next.kind)) {
                (Kind::Arithmetic(sign @ (Arithmetic::Add | Arithmetic::Sub)), Some(second))
                    if second == operator.kind && rest.len() == 1 =>
                {
                    let signs = self.source.slice(both).into();
                    let sign = if sign == Arithmetic::Add { "+" } else { "-" };
                    let help = ForeignWord::Increment {
                        name: word.clone(),
                        sign: sign.into(),
                    };
                    (ForeignWord::NoOperator { sign: signs }, help.into())
                }
                (Kind::Relation(Relation::Eq), _) => {
                    (ForeignWord::CompareAsStatement, assign.into())
                }
                (Kind::Arithmetic(_), Some(Kind::Assign(None))) => {
                    let sign = format!("{}=", self.source.slice(operator.span)).into();
                    let help = ForeignWord::Update { name: word.clone() };
                    (ForeignWord::SplitOperator { sign }, help.into())
                }
                (Kind::Word, Some(Kind::Assign(None)))
                    if self.source.slice(operator.span) == "%" =>
                {
                    let sign = self.source.slice(both).into();
                    (
                        ForeignWord::NoOperator { sign },
                        ForeignWord::Remainder.into(),
                    )
                }
                (Kind::Arithmetic(Arithmetic::Sub), Some(Kind::Relation(Relation::Gt))) => {
                    let member = rest.get(1).map(|member| self.source.slice(member.span));
                    let text = upper_case(&format!("{word}.{}", member.unwrap_or_default()));
                    let sign = self.source.slice(both).into();
                    (
                        ForeignWord::NoOperator { sign },
                        Suggestion::Write { text }.into(),
                    )
                }
                (Kind::Colon, Some(Kind::Assign(None))) => {
                    let sign = self.source.slice(both).into();
                    let fault =
                        Diagnostic::new(Code::Equation, both, ForeignWord::NoOperator { sign });
                    self.report(fault.help(assign));
                    return Some(StatementKind::Broken(Shape::Plain));
                }
                _ => return None,
            };
        self.report_unknown(name.span, &word, reason, help);
        Some(StatementKind::Broken(Shape::Plain))
    }

    /// `A, B = 1, 2`
    fn several_assigned(&mut self, tokens: &[Token]) -> Option<StatementKind> {
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
        let is_known = self.is_command(&name) || foreign::statement(&name).is_some();
        if !are_names || !is_list || is_known {
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
            _ => ForeignWord::AssignEach { name }.into(),
        };
        self.report(fault.help(help));
        Some(StatementKind::Broken(Shape::Plain))
    }

    /// `++A`
    fn increment_before(&mut self, tokens: &[Token]) -> Option<StatementKind> {
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
        let reason = ForeignWord::NoOperator {
            sign: self.source.slice(both).into(),
        };
        let help = ForeignWord::Increment {
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
    /// `10 PTP F1 P`: one mistake, however many lines have a number.
    pub(super) fn line_number(&mut self, word: Span, tokens: &[Token]) -> Option<StatementKind> {
        let text = self.source.slice(word);
        let digits = text.trim_end_matches('.').trim_start_matches(['N', 'n']);
        let is_number = !digits.is_empty() && digits.bytes().all(|it| it.is_ascii_digit());
        let second = self.source.slice(tokens.get(1)?.span);
        let command = commands::find(second);
        if !is_number || command.is_none() && !foreign::is_g_code(second) {
            return None;
        }
        let shape = match command.map(|command| command.meaning) {
            Some(Meaning::Keyword(keyword)) => intended_shape(keyword, self.text, &tokens[1..]),
            _ => Shape::Plain,
        };
        match self.numbered {
            Some(first) => {
                let text = Suggestion::NumberedToo.into();
                // Of too many diagnostics it is omitted.
                if let Some(first) = self.diagnostics.get_mut(first)
                    && first.labels.len() < MOST
                {
                    first.labels.push(Label { span: word, text });
                }
            }
            None => {
                self.numbered = Some(self.diagnostics.len());
                let reason = Commanding::NoCommand { word: text.into() };
                self.report_unknown(word, text, reason, Suggestion::NoNumbers);
            }
        }
        Some(StatementKind::Broken(shape))
    }

    /// `90 END` at the end of the file: its number is reported.
    pub(super) fn ends_with_number(&self) -> bool {
        let last = self.module.statements.last();
        last.filter(|_| self.numbered.is_some())
            .is_some_and(|last| {
                let mut words = self.source.slice(last.span).split_whitespace();
                let is_end = |word: &str| word.eq_ignore_ascii_case(Keyword::End.word());
                matches!(last.kind, StatementKind::Broken(_))
                    && words.next_back().is_some_and(is_end)
            })
    }
}
