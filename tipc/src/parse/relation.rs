//! Relations as other languages write them: what follows is read as if the one that is meant stood there.

use crate::diagnostic::Diagnostic;
use crate::lex::{Kind, Token};
use crate::message::{Habit, Message, Parsing};
use crate::source::Span;
use crate::syntax::Relation;

/// The tokens of a statement with the relation that was meant, if that is what is wrong with it: `IF A = 1 GOTO L1`.
pub(super) fn meant(fault: &Diagnostic, tokens: &[Token]) -> Option<Vec<Token>> {
    let relation = match (&fault.reason, fault.help.as_ref()?) {
        (
            Message::Parsing(Parsing::AssignsComparesNothing),
            Message::Parsing(Parsing::Relations),
        ) => Relation::Eq,
        (_, Message::Habit(Habit::WriteRelation { relation })) => of_sign(relation)?,
        (Message::Habit(Habit::NotEqual), _) => Relation::Ne,
        _ => return None,
    };
    let first = tokens
        .iter()
        .position(|it| it.span.start == fault.span.start)?;
    let is_operand = |at: usize| tokens.get(at).is_some_and(|it| it.kind == Kind::Word);
    let rest = tokens[first..].iter();
    let within = rest.take_while(|it| it.span.end <= fault.span.end).count();
    // `!` and `=`
    let signs = match is_operand(first + within.max(1)) {
        true => within.max(1),
        false => within + 1,
    };
    let end = first + signs;
    if !is_operand(first.checked_sub(1)?) || !is_operand(end) {
        return None;
    }
    let span = Span::new(fault.span.start, tokens[end - 1].span.end);
    let sign = Token {
        kind: Kind::Relation(relation),
        span,
        spaced: tokens[first].spaced,
    };
    let (before, after) = (&tokens[..first], &tokens[end..]);
    Some([before, &[sign], after].concat())
}

fn of_sign(sign: &str) -> Option<Relation> {
    Some(match sign {
        "==" => Relation::Eq,
        "<>" => Relation::Ne,
        "<" => Relation::Lt,
        ">" => Relation::Gt,
        "<=" => Relation::Le,
        ">=" => Relation::Ge,
        _ => return None,
    })
}
