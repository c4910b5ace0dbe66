//! Declarations: the title before them, names that lack one, values in them, and those that nothing uses.

use super::site::Site;
use crate::message::Fixing;
use tipc::code::Code;
use tipc::diagnostic::{Edit, Fix};
use tipc::lex::{Kind, Token};
use tipc::message::{Message, Naming, Suggestion};
use tipc::source::Span;

pub(super) fn fix(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()) {
        (_, Some(Message::Suggestion(Suggestion::Title))) => {
            let title = site.source.line(2).span.start;
            let edit = Edit::insert(title, site.line_end());
            Some(Fix::certain(Fixing::TitleLine, [edit]))
        }
        (_, Some(Message::Suggestion(Suggestion::Initial { .. }))) => {
            let (name, edit) = initial(site, &site.tokens())?;
            Some(Fix::certain(Fixing::OwnLine { name: name.into() }, [edit]))
        }
        (_, Some(Message::Naming(Naming::DeclareAs { declaration }))) => declare(site, declaration),
        (Message::Naming(Naming::NothingUses), _) if site.diagnostic.code == Code::Unused => {
            unused(site)
        }
        _ => None,
    }
}

/// `DEF_VAR N = 0`: the value as an assignment after the declaration, and the name.
pub(super) fn initial<'a>(site: &Site<'a>, tokens: &[Token]) -> Option<(&'a str, Edit)> {
    let (name, value) = match tokens {
        [_, name, operator, value] if operator.kind == Kind::Assign(None) => (name, value.span),
        [_, name, operator, sign, value]
            if operator.kind == Kind::Assign(None) && !value.spaced =>
        {
            (name, sign.span.to(value.span))
        }
        _ => return None,
    };
    let word = site.slice(name.span);
    let text = format!("{}{word} = {}", site.next_line(), site.slice(value));
    let rest = Span::new(name.span.end, value.end);
    Some((word, Edit::replace(rest, text)))
}

/// Returns a declaration before the first statement that is none.
fn declare(site: &Site<'_>, declaration: &str) -> Option<Fix> {
    let start = site.source.line(site.first_line()?).span.start;
    let title = Fixing::Insert {
        text: declaration.into(),
    };
    let text = format!("{declaration}{}", site.line_end());
    Some(Fix::likely(title, [Edit::insert(start, text)]))
}

/// Returns the name alone, or the whole declaration if it has no other.
fn unused(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let at = tokens.iter().position(|token| token.span == site.span())?;
    let title = Fixing::RemoveDeclaration {
        name: site.text().into(),
    };
    let location = match (at, tokens.get(2)) {
        // Where the line is wrong too, what stands before the name may be no part of it.
        (0, _) => return None,
        (_, None) => declaration(site)?,
        // Of several names, one side's blanks stay.
        (1, Some(next)) => Span::new(tokens[1].span.start, next.span.start),
        (_, Some(_)) => Span::new(tokens[at - 1].span.end, tokens[at].span.end),
    };
    Some(Fix::likely(title, [Edit::remove(location)]))
}

/// Returns the line of a declaration, if it holds nothing else.
fn declaration(site: &Site<'_>) -> Option<Span> {
    let statement = site.statement()?.span;
    let line = site.line();
    let is_alone = site.slice(line.span).trim() == site.slice(statement);
    Some(match is_alone {
        true => line.span.to(line.end),
        false => statement,
    })
}
