//! Labels and jumps.

use super::site::Site;
use crate::message::Fixing;
use tipc::diagnostic::{Edit, Fix};
use tipc::language::Keyword;
use tipc::lex::BLANKS;
use tipc::message::{Commanding, Message, Parsing, Suggestion};
use tipc::source::Span;

pub(super) fn fix(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()) {
        (Message::Parsing(Parsing::LabelColonMissing | Parsing::NameColonMissing), _) => {
            Some(colon(site))
        }
        (_, Some(Message::Commanding(Commanding::LabelOrEquation))) => bare_label(site),
        (Message::Parsing(Parsing::BlankBeforeColon), _) => {
            let edits = [Edit::replace(site.span(), ":")];
            Some(Fix::certain(Fixing::RemoveBlanks, edits))
        }
        (Message::Suggestion(Suggestion::ThenJumps { .. }), _) => without_then(site),
        (_, Some(Message::Suggestion(Suggestion::WithoutColon { .. }))) => without_colon(site),
        _ => None,
    }
}

/// `START` where something jumps to `START:`.
pub(super) fn bare_label(site: &Site<'_>) -> Option<Fix> {
    let is_alone = site.statement()?.span == site.span();
    (is_alone && site.is_target(site.text())).then(|| colon(site))
}

/// `GOTO L1`, `START`, `L1.`
fn colon(site: &Site<'_>) -> Fix {
    let bare = site.text().trim_end_matches(['.', '-']);
    if bare.len() < site.text().len() {
        let location = Span::new(site.span().start + bare.len(), site.span().end);
        let title = Fixing::Insert { text: ":".into() };
        return Fix::certain(title, [Edit::replace(location, ":")]);
    }
    let title = Fixing::Insert { text: ":".into() };
    Fix::certain(title, [Edit::insert(site.span().end, ":")])
}

/// `IF c THEN GOTO L1:`, `IF c GOTO L1: THEN`.
fn without_then(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let at = tokens.iter().position(|it| site.is(it, Keyword::Then))?;
    let before = tokens.get(at.checked_sub(1)?)?;
    let rest = Span::new(before.span.end, tokens[at].span.end);
    let title = Fixing::Remove {
        text: Keyword::Then.into(),
    };
    Some(Fix::certain(title, [Edit::remove(rest)]))
}

/// `ELSE:`
fn without_colon(site: &Site<'_>) -> Option<Fix> {
    let end = site.span().end;
    let rest = site.slice(Span::new(end, site.line().span.end));
    let blanks = rest.len() - rest.trim_start_matches(BLANKS).len();
    let is_colon = rest[blanks..].starts_with(':');
    let title = Fixing::Remove { text: ":".into() };
    let edit = Edit::remove(Span::new(end, end + blanks + 1));
    is_colon.then(|| Fix::certain(title, [edit]))
}
