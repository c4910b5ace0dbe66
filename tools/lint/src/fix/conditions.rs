//! Two conditions in one: `IF A AND B THEN`, `IF A OR B GOTO L1:`.

use super::site::Site;
use crate::message::Fixing;
use tipc::diagnostic::{Edit, Fix};
use tipc::language::Keyword;
use tipc::lex::Token;
use tipc::message::{Habit, Message};
use tipc::source::Span;
use tipc::syntax::Shape;

pub(super) fn fix(site: &Site<'_>) -> Option<Fix> {
    let Message::Habit(Habit::AndOr { word }) = site.reason() else {
        return None;
    };
    let is = |words: [&str; 3]| words.iter().any(|one| one.eq_ignore_ascii_case(word));
    let tokens = site.tokens();
    let at = tokens.iter().position(|it| it.span == site.span())?;
    let (before, after) = (tokens.get(at.checked_sub(1)?)?, tokens.get(at + 1)?);
    site.is(tokens.first()?, Keyword::If).then_some(())?;
    let gap = Span::new(before.span.end, after.span.start);
    let jump = tokens[at..]
        .iter()
        .position(|it| site.is(it, Keyword::Goto) || site.is(it, Keyword::Gosub));
    match jump {
        Some(jump) if is(["OR", "||", "|"]) => either(site, gap, &tokens[at + jump..]),
        Some(_) if is(["AND", "&&", "&"]) => both_jump(site, gap),
        None if is(["AND", "&&", "&"]) => both(site, gap),
        _ => None,
    }
}

/// `IF A OR B GOTO L1:` is two jumps to one label. A GOSUB would be called twice.
fn either(site: &Site<'_>, gap: Span, jump: &[Token]) -> Option<Fix> {
    let (first, last) = (jump.first()?, jump.last()?);
    site.is(first, Keyword::Goto).then_some(())?;
    let jump = site.slice(first.span.to(last.span));
    let text = format!(
        " {jump}{}{} ",
        site.next_line(),
        site.like(Keyword::If.word())
    );
    Some(Fix::likely(Fixing::TwoIfs, [Edit::replace(gap, text)]))
}

/// `IF A AND B GOTO L1:` is an IF inside another one.
fn both_jump(site: &Site<'_>, gap: Span) -> Option<Fix> {
    let end = site.statement()?.span.end;
    let close = format!("{}{}", site.next_line(), site.like(Keyword::EndIf.word()));
    let edits = [Edit::replace(gap, inner(site)), Edit::insert(end, close)];
    Some(Fix::likely(Fixing::TwoIfs, edits))
}

/// `IF A AND B THEN` … `ENDIF`, without any ELSE, is an IF inside another one.
fn both(site: &Site<'_>, gap: Span) -> Option<Fix> {
    let index = site.index()?;
    let mut depth = 0;
    let after = site.module.statements[index + 1..].iter();
    for statement in after.take_while(|_| site.may_look_at(1)) {
        match statement.kind.shape() {
            Shape::If => depth += 1,
            Shape::ElseIf | Shape::Else if depth == 0 => return None,
            Shape::EndIf if depth == 0 => {
                let close = site.slice(statement.span);
                let close = format!("{}{close}", site.next_line());
                let end = Edit::insert(statement.span.end, close);
                let edits = [Edit::replace(gap, inner(site)), end];
                return Some(Fix::likely(Fixing::TwoIfs, edits));
            }
            Shape::EndIf => depth -= 1,
            Shape::Subroutine => return None,
            _ => {}
        }
    }
    None
}

/// What stands between the two conditions then.
fn inner(site: &Site<'_>) -> String {
    let (then, line) = (site.like(Keyword::Then.word()), site.next_line());
    format!(" {then}{line}{} ", site.like(Keyword::If.word()))
}
