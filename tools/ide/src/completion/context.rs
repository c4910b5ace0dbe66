//! The syntactic position of the cursor: what the statement before it may go on with.

use super::is_letter;
use crate::Document;
use tip_runtime::command::{READING, Reading, Target, Teach};
use tipc::language::commands::{self, Command, Form};
use tipc::language::functions::{self, Operation};
use tipc::language::reserved::{self, is_motion_flag};
use tipc::language::{Keyword, flags, keywords};
use tipc::lex::{self, Kind, Piece, Pieces, Token, split_comment};
use tipc::source::{Span, Unit};
use tipc::symbols::DefinitionKind;
use tipc::syntax::{Arithmetic, StatementKind, VariableKind, upper_case};

/// The syntactic position of the cursor. An offset is that of the statement.
pub(super) enum Context {
    /// Line 1, the version of the language.
    Version,
    /// The beginning of a statement.
    Start(usize),
    /// A member of this variable.
    Member(String),
    /// A label that this jump leads to.
    Label(Keyword, usize),
    /// A condition.
    Condition,
    /// An event flag.
    Flag,
    /// A number.
    Scalar,
    /// A constant or VAR, no member.
    Plain,
    /// A whole variable of one of these types.
    Whole(&'static [VariableKind]),
    /// A constant.
    Constant(usize),
    /// One of these words.
    Keywords(&'static [Keyword]),
    /// The variable of FOR.
    Counter,
    /// The variable of NEXT.
    Counted(usize),
    /// The right side of an equation of a type.
    Right(VariableKind),
    /// A variable between percent signs.
    Placeholder,
    /// An argument of a command.
    Argument(&'static Command, Written),
}

/// The arguments before the cursor.
pub(super) struct Written {
    /// The words, without signs, in capital letters.
    pub(super) words: Vec<String>,
    /// A sign precedes the cursor.
    pub(super) is_signed: bool,
}

impl Document {
    /// Returns the position of a byte of the text, and the span of the word there; `None` in comments, texts and after END.
    pub(super) fn completion_context(&self, offset: usize) -> Option<(Context, Span)> {
        let source = &self.loaded.source;
        let text = source.text();
        let offset = (0..=offset.min(text.len()))
            .rev()
            .find(|at| text.is_char_boundary(*at))?;
        // The end of a text that ends in a line end is on a line of its own.
        let number = source.position(offset, Unit::Utf8).line;
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
            .in_edition(self.edition())
            .last();
        let context = match last {
            Some(Piece::Statement {
                word: head, span, ..
            }) if !self.is_ended(span.end, done.end) => self.in_statement(head, span, done)?,
            _ => Context::Start(word.start),
        };
        Some((context, word))
    }

    fn is_after_end(&self, offset: usize) -> bool {
        let last = self.statements().last();
        last.is_some_and(|last| last.kind == StatementKind::End && offset > last.span.end)
    }

    /// Returns the span of the letters around an offset.
    fn letters_around(&self, at: usize, line: Span) -> Span {
        let before = self.slice(Span::new(line.start, at));
        let after = self.slice(Span::new(at, line.end));
        let name = before.trim_end_matches(is_letter);
        let start = name.strip_suffix(READING).unwrap_or(name).len() + line.start;
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
        let edition = self.edition();
        if let Some(keyword) = keywords::find(self.slice(head), edition) {
            let rest = Span::new(head.end, done.end.max(head.end));
            return self.after_keyword(keyword, tokens.get(1..)?, head.start, rest);
        }
        if let [target, assign, rest @ ..] = tokens.as_slice()
            && matches!(assign.kind, Kind::Assign(_))
        {
            return self.in_equation(*target, rest);
        }
        let command = commands::find_in(self.slice(head), edition)?;
        let rest = tokens.get(1..)?;
        let signs = [Kind::Word, Kind::Arithmetic(Arithmetic::Sub)];
        if rest.iter().any(|token| !signs.contains(&token.kind)) {
            return None;
        }
        let words = rest.iter().filter(|token| token.kind == Kind::Word);
        let written = Written {
            words: words.map(|token| self.upper(*token)).collect(),
            is_signed: rest.last().is_some_and(|last| last.kind != Kind::Word),
        };
        Some(Context::Argument(command, written))
    }

    fn upper(&self, token: Token) -> String {
        upper_case(self.slice(token.span)).into()
    }

    fn after_keyword(
        &self,
        keyword: Keyword,
        tokens: &[Token],
        start: usize,
        rest: Span,
    ) -> Option<Context> {
        let place = |wanted: Keyword| {
            let is_it = |token: &Token| self.slice(token.span).eq_ignore_ascii_case(wanted.word());
            tokens.iter().position(is_it)
        };
        match keyword {
            Keyword::Goto
            | Keyword::Gosub
            | Keyword::Call
            | Keyword::StartThread
            | Keyword::StopThread
            | Keyword::WaitThread => tokens.is_empty().then_some(Context::Label(keyword, start)),
            Keyword::Define => match tokens {
                [_] => Some(Context::Constant(start)),
                [_, sign] if sign.kind == Kind::Arithmetic(Arithmetic::Sub) => {
                    Some(Context::Constant(start))
                }
                _ => None,
            },
            Keyword::If | Keyword::ElseIf | Keyword::While | Keyword::Until => {
                for jump in [Keyword::Goto, Keyword::Gosub] {
                    if let Some(place) = place(jump).filter(|_| keyword == Keyword::If) {
                        let is_last = place + 1 == tokens.len();
                        return is_last.then_some(Context::Label(jump, start));
                    }
                }
                self.in_condition(keyword, tokens)
            }
            Keyword::For => self.in_for(tokens, [place(Keyword::To), place(Keyword::Step)]),
            Keyword::Next => tokens.is_empty().then_some(Context::Counted(start)),
            Keyword::Message | Keyword::FileMessage => {
                let is_open = self.slice(rest).matches('%').count() % 2 == 1;
                is_open.then_some(Context::Placeholder)
            }
            _ => None,
        }
    }

    fn in_condition(&self, keyword: Keyword, tokens: &[Token]) -> Option<Context> {
        let after: &[Keyword] = match keyword {
            Keyword::If => &[Keyword::Then, Keyword::Goto, Keyword::Gosub],
            Keyword::ElseIf => &[Keyword::Then],
            _ => &[],
        };
        let after = (!after.is_empty()).then_some(Context::Keywords(after));
        let is_flag = |word: Token| {
            let word = self.upper(word);
            self.kind_of(&word).is_none() && flags::find(&word, self.edition()).is_some()
        };
        match without_signs(tokens)?[..] {
            [] if tokens.is_empty() => Some(Context::Condition),
            [] => Some(Context::Scalar),
            [not] if not.kind == Kind::Not => Some(Context::Flag),
            [not, _] if not.kind == Kind::Not => after,
            [word] if is_flag(word) => after,
            [_, relation] if matches!(relation.kind, Kind::Relation(_)) => Some(Context::Scalar),
            [_, relation, last] if matches!(relation.kind, Kind::Relation(_)) => {
                after.filter(|_| last.kind == Kind::Word)
            }
            _ => None,
        }
    }

    fn in_for(&self, tokens: &[Token], [to, step]: [Option<usize>; 2]) -> Option<Context> {
        let (from, next) = match (to, step) {
            (None, None) if tokens.is_empty() => return Some(Context::Counter),
            (None, None) => match tokens {
                [_, assign, ..] if assign.kind == Kind::Assign(None) => (2, Some(&[Keyword::To])),
                _ => return None,
            },
            (Some(to), None) => (to + 1, Some(&[Keyword::Step])),
            (_, Some(step)) => (step + 1, None),
        };
        match without_signs(&tokens[from..])?[..] {
            [] => Some(Context::Scalar),
            [_] => next.map(|next| Context::Keywords(next)),
            _ => None,
        }
    }

    fn in_equation(&self, target: Token, tokens: &[Token]) -> Option<Context> {
        let kind = self.kind_of(&self.upper(target))?;
        let operand = match kind {
            VariableKind::Var => Context::Scalar,
            VariableKind::Pos => Context::Whole(&[VariableKind::Pos]),
            VariableKind::Joint => Context::Whole(&[VariableKind::Joint]),
        };
        let [first, rest @ ..] = tokens else {
            return Some(Context::Right(kind));
        };
        let function = match first.kind {
            Kind::Word => functions::find(self.slice(first.span), self.edition()),
            _ => None,
        };
        if let Some(function) = function {
            let given = without_signs(rest)?.len();
            let is_signed = rest.last().is_some_and(|last| last.kind != Kind::Word);
            if given >= function.operands() {
                return None;
            }
            return match (function, given) {
                (Operation::Norm | Operation::UnitVect | Operation::Rotate(_), 0) if is_signed => {
                    None
                }
                (Operation::Norm, _) => {
                    Some(Context::Whole(&[VariableKind::Pos, VariableKind::Joint]))
                }
                (Operation::UnitVect | Operation::Rotate(_), 0) => {
                    Some(Context::Whole(&[VariableKind::Pos]))
                }
                (Operation::Rotate(_), _) => Some(Context::Plain),
                _ => Some(Context::Scalar),
            };
        }
        let is_sign = |token: &Token| token.kind == Kind::Arithmetic(Arithmetic::Sub);
        let is_operator = |token: &Token| matches!(token.kind, Kind::Arithmetic(_));
        let is_scalar = kind == VariableKind::Var;
        match tokens {
            [sign] if is_sign(sign) => is_scalar.then_some(operand),
            [word, operator] if word.kind == Kind::Word && is_operator(operator) => Some(operand),
            [word, operator, sign] if word.kind == Kind::Word && is_operator(operator) => {
                (is_scalar && is_sign(sign)).then_some(operand)
            }
            [sign, word, operator] if is_sign(sign) && word.kind == Kind::Word => {
                (is_scalar && is_operator(operator)).then_some(operand)
            }
            _ => None,
        }
    }

    /// Returns the type of an operand in capital letters; `None` if it is none.
    pub(super) fn kind_of(&self, operand: &str) -> Option<VariableKind> {
        if operand.contains('.') || operand.starts_with(|char: char| char.is_ascii_digit()) {
            return Some(VariableKind::Var);
        }
        let edition = self.edition();
        if let Some(reading) = reserved::reading(operand, edition) {
            return Some(reading_kind(reading));
        }
        if reserved::constant(operand, edition).is_some() {
            return Some(VariableKind::Var);
        }
        let mut definitions = self.loaded.symbols.definitions().iter();
        definitions.find_map(|it| match it.kind {
            _ if it.name != operand => None,
            DefinitionKind::Variable(kind) => Some(kind),
            DefinitionKind::Constant => Some(VariableKind::Var),
            _ => None,
        })
    }

    /// Returns the number of arguments among tokens; flags of motions and signs do not count.
    pub(crate) fn argument_count(&self, command: &Command, tokens: &[Token]) -> usize {
        let edition = self.edition();
        let has_flags = matches!(command.form_in(edition), Form::Robot(arguments) if arguments.hs || arguments.motion);
        let counts = |token: &&Token| {
            let word = self.slice(token.span).to_ascii_uppercase();
            token.kind == Kind::Word && !(has_flags && is_motion_flag(&word, edition))
        };
        tokens.iter().filter(counts).count()
    }
}

/// Returns the tokens without signs; `None` if another operator stands among them.
fn without_signs(tokens: &[Token]) -> Option<Vec<Token>> {
    let is_bad = |token: &Token| match token.kind {
        Kind::Word | Kind::Relation(_) | Kind::Not => false,
        kind => kind != Kind::Arithmetic(Arithmetic::Sub),
    };
    if tokens.iter().any(is_bad) {
        return None;
    }
    let is_sign = |token: &&Token| matches!(token.kind, Kind::Arithmetic(_));
    Some(
        tokens
            .iter()
            .filter(|token| !is_sign(token))
            .copied()
            .collect(),
    )
}

/// Returns the type of a special variable.
pub(super) const fn reading_kind(reading: Reading) -> VariableKind {
    match reading {
        Reading::Measured(Teach::Position | Teach::Force, _) => VariableKind::Pos,
        Reading::Measured(_, Target::Joint(..)) | Reading::Timer(_) => VariableKind::Var,
        Reading::Measured(..) => VariableKind::Joint,
    }
}
