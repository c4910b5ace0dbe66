//! Assignments as other languages write them: `A++`, `A == 1`, `A := 1`, `A + = 1`.

use super::Parser;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::foreign;
use crate::language::reserved::{JOINT, POSITION};
use crate::language::{commands, names};
use crate::lex::{Kind, Token};
use crate::message::{Habit, Instead, Message, Parsing};
use crate::syntax::{Arithmetic, Relation, Shape, StatementKind, upper_case};

impl Parser<'_> {
    /// An assignment with an operator of another language.
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
        let assign = Habit::Assign { name: word.clone() };
        let (reason, help): (Habit, Message) = match (operator.kind, next.map(|next| next.kind)) {
            (Kind::Arithmetic(sign @ (Arithmetic::Add | Arithmetic::Sub)), Some(second))
                if second == operator.kind && rest.len() == 1 =>
            {
                let signs = self.source.slice(both).into();
                let sign = if sign == Arithmetic::Add { "+" } else { "-" };
                let help = Habit::Increment {
                    name: word.clone(),
                    sign: sign.into(),
                };
                (Habit::NoOperator { sign: signs }, help.into())
            }
            (Kind::Relation(Relation::Eq), _) => (Habit::CompareAsStatement, assign.into()),
            (Kind::Arithmetic(_), Some(Kind::Assign(None))) => {
                let sign = format!("{}=", self.source.slice(operator.span)).into();
                let help = Habit::Update { name: word.clone() };
                (Habit::SplitOperator { sign }, help.into())
            }
            (Kind::Word, Some(Kind::Assign(None))) if self.source.slice(operator.span) == "%" => {
                let sign = self.source.slice(both).into();
                (Habit::NoOperator { sign }, Habit::Remainder.into())
            }
            (Kind::Arithmetic(Arithmetic::Sub), Some(Kind::Relation(Relation::Gt))) => {
                let member = rest.get(1).map(|member| self.source.slice(member.span));
                let text = upper_case(&format!("{word}.{}", member.unwrap_or_default()));
                let sign = self.source.slice(both).into();
                (Habit::NoOperator { sign }, Instead::Write { text }.into())
            }
            (Kind::Colon, Some(Kind::Assign(None))) => {
                let sign = self.source.slice(both).into();
                let fault = Diagnostic::new(Code::Equation, both, Habit::NoOperator { sign });
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
        let place = first.span.to(last.span);
        let text = self.source.slice(place);
        let is_list = text.matches(',').count() + 1 == names.len();
        let name = upper_case(word(first));
        let is_known = commands::find(&name).is_some() || foreign::statement(&name).is_some();
        if !are_names || !is_list || is_known {
            return None;
        }
        let fault = Diagnostic::new(Code::Equation, place, Parsing::OneVariableLeft);
        let member = upper_case(word(last));
        let help: Message = match names {
            // `P,X = 1`
            [_, _] if is_member(&member) && !is_list_after(tokens, equals) => {
                let text = format!("{name}.{member}").into();
                Instead::Write { text }.into()
            }
            _ => Habit::AssignEach { name }.into(),
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
        let reason = Habit::NoOperator {
            sign: self.source.slice(both).into(),
        };
        let help = Habit::Increment {
            name: upper_case(self.source.slice(name.span)),
            sign: sign.into(),
        };
        self.report_unknown(both, sign, reason, help);
        Some(StatementKind::Broken(Shape::Plain))
    }
}

/// Whether several values follow the `=`.
fn is_list_after(tokens: &[Token], equals: usize) -> bool {
    let after = tokens[equals + 1..].iter();
    after.filter(|it| it.kind == Kind::Word).count() > 1
}

/// Whether a word is a member of a POS or JOINT.
fn is_member(word: &str) -> bool {
    let is_joint = |rest: &str| rest.len() == 1 && rest.bytes().all(|it| it.is_ascii_digit());
    POSITION.contains(&word) || word.strip_prefix(JOINT).is_some_and(is_joint)
}
