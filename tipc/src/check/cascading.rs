//! Merges diagnostics that follow from another one: one mistake, one diagnostic.

use super::title;
use crate::code::Code;
use crate::diagnostic::by_location;
use crate::diagnostic::{Diagnostic, Diagnostics, Label};
use crate::foreign;
use crate::language::{Keyword, commands};
use crate::lex::{Kind, Token, lex, split_comment};
use crate::message::{Commanding, ForeignWord, Message, Naming, Parsing, Structuring, Suggestion};
use crate::source::{Source, Span};
use crate::suggest::is_near;
use crate::syntax::{Module, OperandKind, StatementKind, upper_case};
use smol_str::SmolStr;
use std::collections::{HashMap, HashSet};

/// Merges the diagnostics about one name into one, at its first location.
pub(super) fn merge(source: &Source, module: &Module, found: &mut Diagnostics) {
    by_location(found);
    // What ends no block here may be reported as such already.
    found.dedup_by(|second, first| {
        second.code == Code::UnknownCommand
            && (second.code, second.span) == (first.code, first.span)
    });
    labels_without_colon(source, module, found);
    labels_after_end(source, module, found);
    parts_of_statements(found);
    endless_loops(source, found);
    long_texts(source, found);
    arrays_declared(source, found);
    reversed_loops(found);
    crossed_loops(source, found);
    broken_lines(source, found);
    declared_in_title(source, module, found);
    repeated(found);
    declared_again(source, module, found);
    with_sign(source, found);
    called_loop(found);
    flags(source, module, found);
    title::blame(source, module, found);
    last_word(found);
}

/// `START` where `START:` was meant: the jumps to it are not wrong.
fn labels_without_colon(source: &Source, module: &Module, found: &mut Diagnostics) {
    let is_broken = |it: &&Diagnostic| it.reason == Parsing::LabelColonMissing.into();
    let broken = found.iter().filter(is_broken);
    let broken: HashSet<_> = broken.map(|it| upper_case(source.slice(it.span))).collect();
    let mut jumps: HashMap<String, Vec<Span>> = HashMap::new();
    for diagnostic in found.iter().filter(|it| it.code == Code::UnknownLabel) {
        let name = diagnostic.subject.clone().unwrap_or_default();
        jumps.entry(name).or_default().push(diagnostic.span);
    }
    let mut meant = HashSet::new();
    for diagnostic in found
        .iter_mut()
        .filter(|it| it.code == Code::UnknownCommand)
    {
        let name = diagnostic.subject.as_deref().unwrap_or_default();
        // `L1.`
        let name = name.trim_end_matches(['.', '-']);
        // The first word of that name is the label, so that no jump is listed twice.
        let is_alone = is_alone(module, diagnostic.span);
        let locations = is_alone.then(|| jumps.remove(name)).flatten();
        // A jump without its colon is another mistake.
        let is_jumped_to = is_alone && broken.contains(name);
        if locations.is_none() && !is_jumped_to {
            continue;
        }
        let name = name.to_owned();
        meant.insert(name.clone());
        diagnostic.reason = Parsing::LabelColonMissing.into();
        diagnostic.help = Some(Parsing::WriteLabel { name: name.into() }.into());
        let locations = locations.into_iter().flatten();
        let labels = locations.map(|span| label(span, Structuring::JumpsHere));
        diagnostic.labels.extend(labels);
    }
    found.retain(|diagnostic| {
        let name = diagnostic.subject.as_ref();
        diagnostic.code != Code::UnknownLabel || !name.is_some_and(|name| meant.contains(name))
    });
}

/// Labels that stand after END are one mistake: END stands too early.
fn labels_after_end(source: &Source, module: &Module, found: &mut Diagnostics) {
    let is_missing = |diagnostic: &Diagnostic| diagnostic.code == Code::UnknownLabel;
    let end = module.statements.last();
    let Some(end) = end.filter(|it| it.kind == StatementKind::End && found.iter().any(is_missing))
    else {
        return;
    };
    let after = labels_in(source, Span::new(end.span.end, source.text().len()));
    let mut first: Option<Diagnostic> = None;
    found.retain_mut(|diagnostic| {
        let name = diagnostic.subject.as_deref().unwrap_or_default();
        let Some(location) = after.get(name).filter(|_| is_missing(diagnostic)) else {
            return true;
        };
        match &mut first {
            Some(first) => {
                first.labels.push(label(diagnostic.span, Naming::AlsoHere));
            }
            None => {
                let diagnostic = diagnostic.clone();
                let diagnostic = diagnostic.label(end.span, ForeignWord::EndsTheText);
                first = Some(
                    diagnostic
                        .label(*location, ForeignWord::StandsAfterEnd)
                        .help(ForeignWord::AfterEnd),
                );
            }
        }
        false
    });
    found.extend(first);
    by_location(found);
}

/// Returns the labels and the names of SUBROUTINEs in a part of the text, each at its first location.
fn labels_in(source: &Source, span: Span) -> HashMap<String, Span> {
    let mut all = HashMap::new();
    let mut tokens = Vec::new();
    let lines = source.lines().map(|line| line.span);
    for line in lines.filter(|line| line.start >= span.start) {
        tokens.clear();
        let (code, _) = split_comment(source.text(), line);
        lex(source.text(), code, &mut tokens);
        let word = |token: &Token| upper_case(source.slice(token.span));
        let name = match tokens.as_slice() {
            [name, colon, ..] if colon.kind == Kind::Colon => name,
            [first, name, ..] if word(first) == Keyword::Subroutine.word() => name,
            _ => continue,
        };
        all.entry(word(name).to_string()).or_insert(name.span);
    }
    all
}

/// `CASE` belongs to the SWITCH before it: one statement of another language is one mistake.
fn parts_of_statements(found: &mut Diagnostics) {
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    let mut begun: Option<usize> = None;
    for diagnostic in found.drain(..) {
        let word = diagnostic.subject.clone().unwrap_or_default();
        let is_unknown = diagnostic.code == Code::UnknownCommand;
        if let Some(first) = begun.map(|at| &mut kept[at])
            && (is_unknown && foreign::goes_on(first.subject.as_deref().unwrap_or_default(), &word)
                || first.help == Some(ForeignWord::Loops.into()) && ends_do(first, &diagnostic)
                || first.help == Some(ForeignWord::FromTheTop.into())
                    && first.help == diagnostic.help)
        {
            first
                .labels
                .push(label(diagnostic.span, ForeignWord::GoesOn));
            continue;
        }
        if is_unknown && foreign::statement(&word).is_some() {
            begun = Some(kept.len());
        }
        kept.push(diagnostic);
    }
    **found = kept;
}

/// `DO` … `UNTIL A > 3`, which ends a REPEAT here; `DO` … `WHILE A < 3`, which begins another loop here.
fn ends_do(begun: &Diagnostic, diagnostic: &Diagnostic) -> bool {
    let (opener, word) = (Keyword::Repeat, Keyword::Until);
    let until = Structuring::NothingOpen { opener, word };
    let opener = Keyword::While;
    diagnostic.reason == until.into()
        || begun.labels.is_empty() && diagnostic.reason == Structuring::NotClosed { opener }.into()
}

/// `WHILE TRUE:`: that it repeats for ever is said, and so its colon does not matter.
fn endless_loops(source: &Source, found: &mut Diagnostics) {
    let line_of = |diagnostic: &Diagnostic| source.line_column(diagnostic.span.start).0;
    let forever = found
        .iter()
        .filter(|it| it.help == Some(ForeignWord::Forever.into()));
    let lines: HashSet<u32> = forever.map(line_of).collect();
    found.retain(|it| it.reason != ForeignWord::NoColon.into() || !lines.contains(&line_of(it)));
}

/// Merges what follows from a line that is too long into the diagnostic of its text.
fn long_texts(source: &Source, found: &mut Diagnostics) {
    let line_of = |diagnostic: &Diagnostic| source.line_column(diagnostic.span.start).0;
    let texts = found.iter().filter(|it| it.code == Code::LongString);
    let lines: HashSet<u32> = texts.map(line_of).collect();
    let is_long =
        |it: &Diagnostic| matches!(it.reason, Message::Parsing(Parsing::LineTooLong { .. }));
    found.retain(|it| !is_long(it) || !lines.contains(&line_of(it)));
}

/// `DIM A(10)`: that there are no arrays is the mistake.
fn arrays_declared(source: &Source, found: &mut Diagnostics) {
    let line_of = |diagnostic: &Diagnostic| source.line_column(diagnostic.span.start).0;
    let is_array = |it: &&Diagnostic| {
        matches!(
            it.help,
            Some(Message::ForeignWord(ForeignWord::NoArray { .. }))
        )
    };
    let arrays: HashSet<u32> = found.iter().filter(is_array).map(line_of).collect();
    found.retain(|it| {
        it.help != Some(ForeignWord::Declare.into()) || !arrays.contains(&line_of(it))
    });
}

/// Merges UNTIL with its REPEAT after it, or `REPEAT` … `WHILE A < 3`, if nothing else is wrong with the structure.
fn reversed_loops(found: &mut Diagnostics) {
    let is_structure = |it: &&Diagnostic| it.code == Code::Structure;
    let both: Vec<&Diagnostic> = found.iter().filter(is_structure).collect();
    let [first, second] = both.as_slice() else {
        return;
    };
    let (end, repeat) = match (&first.reason, &second.reason) {
        (
            Message::Structuring(Structuring::NothingOpen {
                opener: Keyword::Repeat,
                ..
            }),
            Message::Structuring(Structuring::NotClosed {
                opener: Keyword::Repeat,
            }),
        ) => (first.span, second.span),
        (
            Message::Structuring(Structuring::NotClosed {
                opener: Keyword::Repeat,
            }),
            Message::Structuring(Structuring::NotClosed {
                opener: Keyword::While,
            }),
        ) => (second.span, first.span),
        _ => return,
    };
    found.retain(|it| it.code != Code::Structure || it.span != repeat);
    let word = Keyword::Repeat;
    for diagnostic in found.iter_mut().filter(|it| it.span == end) {
        diagnostic.labels = vec![label(repeat, Structuring::StandsHere { word })];
        diagnostic.help = Some(ForeignWord::UntilCloses.into());
    }
}

/// `FOR A`, `FOR B`, `NEXT A`, `NEXT B`: two that name each other's variable are in the wrong order, which is one mistake.
fn crossed_loops(source: &Source, found: &mut Diagnostics) {
    let names = |it: &Diagnostic| match &it.reason {
        Message::Structuring(Structuring::NextNames { name }) => {
            let own = it.labels.first()?.span;
            Some((name.clone(), upper_case(source.slice(own))))
        }
        _ => None,
    };
    let all: Vec<_> = found.iter().map(names).collect();
    // Where each pair is named, the first location last.
    let mut locations: HashMap<(SmolStr, SmolStr), Vec<usize>> = HashMap::new();
    for (at, named) in all.iter().enumerate().rev() {
        if let Some(named) = named {
            locations.entry(named.clone()).or_default().push(at);
        }
    }
    let mut joined = HashSet::new();
    for (at, named) in all.into_iter().enumerate() {
        let Some((outer, inner)) = named.filter(|_| !joined.contains(&at)) else {
            continue;
        };
        let other = locations.get_mut(&(inner.clone(), outer.clone()));
        let after = other.and_then(|other| {
            while other.last().is_some_and(|it| *it <= at) {
                other.pop();
            }
            other.pop()
        });
        if let Some(second) = after {
            let location = found[second].span;
            found[at].labels.push(label(location, Naming::AlsoHere));
            found[at].help = Some(ForeignWord::InnerFirst { inner, outer }.into());
            joined.insert(second);
        }
    }
    let mut at = 0..;
    found.retain(|_| at.next().is_none_or(|at| !joined.contains(&at)));
}

/// Merges the line after a statement that breaks off: `PTP F1` and `391 201 -150` are one mistake.
fn broken_lines(source: &Source, found: &mut Diagnostics) {
    let line_of = |diagnostic: &Diagnostic| source.line_column(diagnostic.span.start).0;
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    for diagnostic in found.drain(..) {
        let word = diagnostic.subject.as_deref().unwrap_or_default();
        let is_rest = word.starts_with(|c: char| c.is_ascii_digit() || c == '-');
        match kept.last_mut() {
            Some(before)
                if diagnostic.code == Code::UnknownCommand
                    && matches!(before.code, Code::Argument | Code::UnknownVariable)
                    && is_rest
                    && line_of(before) + 1 == line_of(&diagnostic) =>
            {
                before
                    .labels
                    .push(label(diagnostic.span, ForeignWord::GoesOnHere));
                before.help = Some(ForeignWord::OneLine.into());
            }
            _ => kept.push(diagnostic),
        }
    }
    **found = kept;
}

/// Returns true if a statement at this location is this word alone.
fn is_alone(module: &Module, location: Span) -> bool {
    let statement = module
        .statement_at(location.start)
        .map(|at| &module.statements[at]);
    statement.is_some_and(|it| {
        it.span == location
            && matches!(&it.kind, StatementKind::Command { arguments, .. } if arguments.is_empty())
            || is_before_command(&it.kind)
    })
}

/// `L1 MESSAGE text`: a command follows the word.
fn is_before_command(kind: &StatementKind) -> bool {
    let StatementKind::Command { arguments, .. } = kind else {
        return false;
    };
    let first = arguments.first().map(|argument| &argument.kind);
    matches!(first, Some(OperandKind::Name(word)) if commands::find(word).is_some())
}

fn label(span: Span, text: impl Into<Message>) -> Label {
    Label {
        span,
        text: text.into(),
    }
}

/// Merges the word that was to be END at the end of the text, STOP or EDN, with the missing END.
pub(super) fn last_word(found: &mut Diagnostics) {
    let Some(missing) = found.iter().position(|it| it.code == Code::NoEnd) else {
        return;
    };
    let location = found[missing].span;
    let unknown = |it: &Diagnostic| it.span == location && it.code == Code::UnknownCommand;
    let Some(word) = found.iter().position(unknown) else {
        return;
    };
    let ends = [ForeignWord::Stop, ForeignWord::Exit].map(Message::from);
    let end = Keyword::End.word();
    let subject = found[word].subject.as_deref();
    if subject.is_some_and(|subject| is_near(subject, end)) {
        found[word].help = Some(Suggestion::DidYouMean { near: end.into() }.into());
        found.remove(missing);
    } else if found[word]
        .help
        .as_ref()
        .is_some_and(|help| ends.contains(help))
    {
        found.remove(word);
    }
}

/// Merges the uses of a name that line 2 would declare, if it were not the title.
fn declared_in_title(source: &Source, module: &Module, found: &mut Diagnostics) {
    let in_title = title::declared(source, module);
    for diagnostic in found.iter_mut() {
        let name = diagnostic.subject.as_deref().unwrap_or_default();
        let is_unknown = diagnostic.code == Code::UnknownVariable;
        if let Some(location) = in_title.get(name).filter(|_| is_unknown) {
            diagnostic
                .labels
                .push(label(*location, ForeignWord::TitleHere));
            diagnostic.help = Some(ForeignWord::Title.into());
        }
    }
}

/// Diagnostics of one mistake are one diagnostic at the first location, and the best guess of the type of a name is its help.
fn repeated(found: &mut Diagnostics) {
    let mut first_of: HashMap<SmolStr, usize> = HashMap::new();
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    for diagnostic in found.drain(..) {
        let first = diagnostic.once.as_ref().and_then(|once| first_of.get(once));
        match first.map(|at| &mut kept[*at]) {
            Some(first) => {
                first.labels.push(label(diagnostic.span, Naming::AlsoHere));
                if is_open(first.help.as_ref()) && is_guess(diagnostic.help.as_ref()) {
                    first.help = diagnostic.help;
                }
            }
            None => {
                first_of.extend(diagnostic.once.clone().map(|once| (once, kept.len())));
                kept.push(diagnostic);
            }
        }
    }
    **found = kept;
}

/// Returns true if a help leaves the type open.
fn is_open(help: Option<&Message>) -> bool {
    matches!(help, Some(Message::Naming(Naming::Declare { .. })))
}

/// Returns true if a help names one type.
fn is_guess(help: Option<&Message>) -> bool {
    matches!(help, Some(Message::Naming(Naming::DeclareAs { .. })))
}

/// Removes what follows from a second declaration: the name is not of the type, or not the SUBROUTINE, that its uses
/// mean.
pub(super) fn declared_again(source: &Source, module: &Module, found: &mut Diagnostics) {
    let is_again =
        |it: &&Diagnostic| matches!(it.reason, Message::Naming(Naming::DeclaredAgain { .. }));
    let again: HashSet<String> = found
        .iter()
        .filter(is_again)
        .map(|it| source.slice(it.span).to_ascii_uppercase())
        .collect();
    if again.is_empty() {
        return;
    }
    let names_one = |location: Span| {
        let statement = module.statement_at(location.start)?;
        let text = source.slice(module.statements[statement].span);
        let is_end = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
        let mut words = text.split(is_end).map(str::to_ascii_uppercase);
        words.any(|word| again.contains(&word)).then_some(())
    };
    found.retain(|it| {
        let follows = match &it.reason {
            Message::Commanding(_) | Message::Calculating(_) => true,
            Message::Structuring(reason) => matches!(reason, Structuring::PlainLabel { .. }),
            _ => it.code == Code::RunsInto,
        };
        !follows || names_one(it.span).is_none()
    });
}

/// `DEF_VAR A$`, and wherever `A$` stands.
pub(super) fn with_sign(source: &Source, found: &mut Diagnostics) {
    let mut first_of: HashMap<String, usize> = HashMap::new();
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(found.len());
    for diagnostic in found.drain(..) {
        match &diagnostic.reason {
            Message::Naming(Naming::NoVariableName { word }) => {
                first_of.entry(word.to_string()).or_insert(kept.len());
            }
            Message::Parsing(Parsing::ForeignInName { .. }) => {
                let word = word_at(source, diagnostic.span);
                let name = source.slice(word).to_ascii_uppercase();
                if let Some(first) = first_of.get(&name) {
                    kept[*first].labels.push(label(word, Naming::AlsoHere));
                    continue;
                }
            }
            _ => {}
        }
        kept.push(diagnostic);
    }
    **found = kept;
}

/// Returns the name that a sign ends.
fn word_at(source: &Source, sign: Span) -> Span {
    let before = &source.text()[..sign.start];
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let start = before.trim_end_matches(is_name).len();
    Span::new(start, sign.end)
}

/// `SUBROUTINE LOOP:` and its calls.
pub(super) fn called_loop(found: &mut Diagnostics) {
    let is_named = |it: &Diagnostic| it.reason == Naming::SubroutineLoop.into();
    let is_called = |it: &Diagnostic| it.reason == Structuring::LoopForGoto.into();
    if !found.iter().any(is_named) {
        return;
    }
    let calls = found.iter().filter(|it| is_called(it));
    let labels: Vec<_> = calls.map(|it| label(it.span, Naming::AlsoHere)).collect();
    found.retain(|it| !is_called(it));
    if let Some(named) = found.iter_mut().find(|it| is_named(it)) {
        named.labels.extend(labels);
    }
}

/// `PTP F1 R 0 0` with a variable R: that R is a flag there explains the missing number.
pub(super) fn flags(source: &Source, module: &Module, found: &mut Diagnostics) {
    let statement = |span: Span| module.statement_at(span.start);
    let mut explained = HashSet::new();
    for at in 0..found.len() {
        let (flag, used) = match (found[at].code, found[at].labels.first()) {
            (Code::FlagName, Some(used)) => (found[at].span, used.span),
            _ => continue,
        };
        let is_there = |it: &&mut Diagnostic| {
            let is_few = matches!(it.reason, Message::Commanding(Commanding::TooFew { .. }));
            is_few && it.span != used && statement(it.span) == statement(used)
        };
        if let Some(fault) = found.iter_mut().find(is_there) {
            let name = source.slice(used).to_ascii_uppercase().into();
            fault.labels.push(label(used, Suggestion::FlagHere));
            fault.help = Some(Suggestion::OtherName { name }.into());
            explained.insert(flag);
        }
    }
    found.retain(|it| it.code != Code::FlagName || !explained.contains(&it.span));
}
