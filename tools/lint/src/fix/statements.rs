//! Fixes of labels and jumps, blocks, words that stand alone on their lines, and declarations.

use super::Site;
use crate::message::Fixing;
use tipc::code::Code;
use tipc::diagnostic::{Edit, Fix};
use tipc::language::Keyword;
use tipc::lex::{BLANKS, Kind, Token};
use tipc::message::phrase::End;
use tipc::message::{Message, Naming, Parsing, Suggestion};
use tipc::source::Span;
use tipc::syntax::{Shape, StatementKind};

/// Returns the fix of a label or jump.
pub(super) fn jumps(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()) {
        (Message::Parsing(Parsing::LabelColonMissing | Parsing::NameColonMissing), _) => {
            Some(with_colon(site))
        }
        (Message::Parsing(Parsing::BlankBeforeColon), _) => {
            let edits = [Edit::replace(site.span(), ":")];
            Some(Fix::certain(Fixing::RemoveBlanks, edits))
        }
        (Message::Suggestion(Suggestion::ThenJumps { .. }), _) => without_then(site),
        (_, Some(Message::Suggestion(Suggestion::WithoutColon { .. }))) => without_colon(site),
        _ => None,
    }
}

/// Returns the fix that adds a colon: `GOTO L1`, `START`, `L1.`.
fn with_colon(site: &Site<'_>) -> Fix {
    let bare = site.text().trim_end_matches(['.', '-']);
    let rest = Span::new(site.span().start + bare.len(), site.span().end);
    let title = Fixing::Insert { text: ":".into() };
    Fix::certain(title, [Edit::replace(rest, ":")])
}

/// Returns the fix that removes THEN: `IF c THEN GOTO L1:`, `IF c GOTO L1: THEN`.
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

/// Returns the fix that removes a colon: `ELSE:`.
fn without_colon(site: &Site<'_>) -> Option<Fix> {
    let end = site.span().end;
    let rest = site.slice(Span::new(end, site.line().span.end));
    let blanks = rest.len() - rest.trim_start_matches(BLANKS).len();
    let is_colon = rest[blanks..].starts_with(':');
    let title = Fixing::Remove { text: ":".into() };
    let edit = Edit::remove(Span::new(end, end + blanks + 1));
    is_colon.then(|| Fix::certain(title, [edit]))
}

/// Returns the fix of a THEN, of a word that stands alone on its line, or of END.
pub(super) fn blocks(site: &Site<'_>) -> Option<Fix> {
    match (site.reason(), site.help()) {
        (Message::Parsing(Parsing::ThenOrJumpBelongsHere | Parsing::ThenBelongsHere), _) => {
            then(site)
        }
        (Message::Suggestion(Suggestion::NoColon), _) => colon(site),
        (
            Message::Parsing(Parsing::NothingBehind {
                end: End::Condition,
            }),
            _,
        ) => after_condition(site),
        (Message::Suggestion(Suggestion::OneLineIf), _) => one_line_if(site),
        (Message::Parsing(Parsing::NotAlone { .. }), _) => alone(site),
        (Message::Parsing(Parsing::ProgramEndsHere), _) => end(site),
        _ => None,
    }
}

/// Returns the fix that adds THEN to `IF c`.
fn then(site: &Site<'_>) -> Option<Fix> {
    let title = Fixing::Insert {
        text: Keyword::Then.into(),
    };
    let then = site.append(site.span().start, Keyword::Then.word());
    site.text().is_empty().then(|| Fix::certain(title, [then]))
}

/// Returns the fix of a colon after a condition: `IF c:`, `WHILE c:`.
fn colon(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let first = tokens.first()?;
    let fix = removed(site, site.span());
    let branches = site.is(first, Keyword::If) || site.is(first, Keyword::ElseIf);
    if !branches || tokens.iter().any(|it| site.is(it, Keyword::Then)) {
        return Some(fix);
    }
    let location = fix.edits.first()?.span;
    let then = format!(" {}", site.like(Keyword::Then.word()));
    let title = Fixing::Replace {
        old: ":".into(),
        new: Keyword::Then.into(),
    };
    Some(Fix::certain(title, [Edit::replace(location, then)]))
}

/// Returns the fix that removes words after a condition: `WHILE c DO`.
fn after_condition(site: &Site<'_>) -> Option<Fix> {
    let openers = ["DO", Keyword::Then.word()];
    let text = site.text();
    let is_opener = openers.iter().any(|it| it.eq_ignore_ascii_case(text));
    is_opener.then(|| removed(site, site.span()))
}

/// Creates a fix that removes something, and the blanks before it.
fn removed(site: &Site<'_>, location: Span) -> Fix {
    let before = site.tokens().into_iter().map(|token| token.span.end);
    let before = before.take_while(|end| *end <= location.start).last();
    let start = before.unwrap_or(location.start);
    let title = Fixing::Remove {
        text: site.slice(location).into(),
    };
    Fix::certain(title, [Edit::remove(Span::new(start, location.end))])
}

/// Returns the fix that breaks `IF c THEN A = 1` into lines. An ELSE and an ENDIF may follow on the same line.
fn one_line_if(site: &Site<'_>) -> Option<Fix> {
    let index = site.index()?;
    let statement = &site.module.statements[index];
    let next = site.module.statements.get(index + 1);
    if next.is_some_and(|next| next.line == statement.line) {
        return None;
    }
    let tokens = site.tokens();
    let is = |token: &Token, word| site.is(token, word);
    let then = tokens.iter().position(|it| is(it, Keyword::Then))?;
    let closed = tokens.last().is_some_and(|it| is(it, Keyword::EndIf));
    let goes_on = next.is_some_and(|next| {
        matches!(
            next.kind.shape(),
            Shape::Else | Shape::ElseIf | Shape::EndIf
        )
    });
    let line = site.next_line();
    let inside = format!("{line}  ");
    let mut edits = Vec::new();
    for pair in tokens[then..].windows(2) {
        let [before, after] = pair else {
            continue;
        };
        let gap = Span::new(before.span.end, after.span.start);
        if is(after, Keyword::Else) || is(after, Keyword::EndIf) {
            edits.push(Edit::replace(gap, line.as_str()));
        } else if is(before, Keyword::Then) || is(before, Keyword::Else) {
            edits.push(Edit::replace(gap, inside.as_str()));
        }
    }
    if !closed && !goes_on {
        let close = format!("{line}{}", site.like(Keyword::EndIf.word()));
        edits.push(Edit::insert(statement.span.end, close));
    }
    Some(Fix::certain(Fixing::Block, edits))
}

/// Returns the fix that gives a word a line of its own: `ELSE A = 1`, `WHILE c; A = 1; WEND`.
fn alone(site: &Site<'_>) -> Option<Fix> {
    let index = site.index()?;
    let statements = &site.module.statements;
    let statement = &statements[index];
    let other = site.diagnostic.labels.first()?.span;
    let line = site.next_line();
    let mut edits = Vec::new();
    let mut part = |from: usize, to: usize| {
        let gap = Span::new(from, to);
        let is_gap = site
            .slice(gap)
            .chars()
            .all(|char| matches!(char, ' ' | '\t' | ';' | ','));
        is_gap.then(|| edits.push(Edit::replace(gap, line.as_str())))
    };
    if statement.span.start <= other.start && other.end <= statement.span.end {
        part(site.span().end, other.start)?;
        return Some(Fix::certain(Fixing::OwnLines, edits));
    }
    let is_here = |at: usize| {
        let neighbour = statements.get(at).filter(|it| it.line == statement.line);
        neighbour.filter(|it| !matches!(it.kind, StatementKind::Label(_)))
    };
    if let Some(before) = index.checked_sub(1).and_then(is_here) {
        part(before.span.end, statement.span.start)?;
    }
    if let Some(after) = is_here(index + 1) {
        part(statement.span.end, after.span.start)?;
    }
    Some(Fix::certain(Fixing::OwnLines, edits))
}

/// Returns the fix that adds END on a line after the last one.
fn end(site: &Site<'_>) -> Option<Fix> {
    let count = site.source.line_count();
    // On line 2 it would be the title.
    if count < 2 {
        return None;
    }
    let last = site.source.line(count);
    let (line_end, word) = (site.line_end(), Keyword::End.word());
    let text = match site.slice(last.end) {
        "" => format!("{line_end}{word}{line_end}"),
        _ => format!("{word}{line_end}"),
    };
    let title = Fixing::Insert {
        text: Keyword::End.into(),
    };
    let at = site.source.text().len();
    Some(Fix::certain(title, [Edit::insert(at, text)]))
}

/// Returns the fix of a missing title, a missing declaration, a value in a declaration, or an unused declaration.
pub(super) fn declarations(site: &Site<'_>) -> Option<Fix> {
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

/// Returns the name of `DEF_VAR N = 0`, and an edit that turns the value into an assignment after the declaration.
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

/// Returns the fix that adds a declaration before the first statement that is not one.
fn declare(site: &Site<'_>, declaration: &str) -> Option<Fix> {
    let mut statements = site.module.statements.iter();
    let first = statements.find(|it| !matches!(it.kind, StatementKind::Define { .. }))?;
    let start = site.source.line(first.line).span.start;
    let title = Fixing::Insert {
        text: declaration.into(),
    };
    let text = format!("{declaration}{}", site.line_end());
    Some(Fix::likely(title, [Edit::insert(start, text)]))
}

/// Returns the fix that removes an unused name, or the whole declaration if it has no other name.
fn unused(site: &Site<'_>) -> Option<Fix> {
    let tokens = site.tokens();
    let at = tokens.iter().position(|token| token.span == site.span())?;
    let title = Fixing::RemoveDeclaration {
        name: site.text().into(),
    };
    let location = match (at, tokens.get(2)) {
        // If the line is wrong as well, the text before the name may not belong to it.
        (0, _) => return None,
        (_, None) => declaration(site)?,
        // The blanks on one side of the name stay between its neighbours.
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
