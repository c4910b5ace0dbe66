//! Every program of the tests: all names in its text are in the table, once, at their places.

use std::path::{Path, PathBuf};
use std::{env, fs};
use tipc::language::Edition;
use tipc::source::Span;
use tipc::symbols::{DefinitionKind, Symbols, Use};
use tipc::syntax::{Module, StatementKind, VariableKind};
use tipc::{Loaded, Options, Robot, load};

/// Returns the bytes of every program among the tests; none if the package stands alone.
pub(crate) fn programs() -> Vec<(PathBuf, Vec<u8>)> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/language/cases");
    let mut paths = Vec::new();
    if root.is_dir() {
        collect(&root, &mut paths);
    }
    paths
        .into_iter()
        .map(|path| {
            let bytes = fs::read(&path).expect("a readable case");
            (path, bytes)
        })
        .collect()
}

fn collect(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a readable folder") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            collect(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "prg") {
            found.push(path);
        }
    }
}

/// A word of a statement's text that is written like a name.
struct Token<'a> {
    text: &'a str,
    place: Span,
    /// A colon follows it, or a jump before it.
    label: bool,
}

/// Returns the words of all statements, without the texts of REM and MESSAGE but with what stands between percent
/// signs.
fn tokens(loaded: &Loaded) -> Vec<Token<'_>> {
    let text = loaded.source.text();
    let mut found = Vec::new();
    for statement in &loaded.module.statements {
        match &statement.kind {
            StatementKind::Rem => {}
            StatementKind::Message { text: shown } | StatementKind::FileMessage { text: shown } => {
                placeholders(loaded, shown.span, &mut found);
            }
            _ => words(text, statement.span, &mut found),
        }
    }
    found
}

/// `%NAME%` and `%NAME.n%`, n up to 7, of a VAR; in 3.2 of a constant, a struct or a member, too.
fn placeholders<'a>(loaded: &'a Loaded, shown: Span, found: &mut Vec<Token<'a>>) {
    let is_later = loaded.module.edition > Edition::V3_1;
    let kind_of = |name: &str| {
        let mut definitions = loaded.symbols.definitions().iter();
        let named = definitions.find(|it| it.name.eq_ignore_ascii_case(name))?;
        match named.kind {
            DefinitionKind::Variable(kind) => {
                Some(kind).filter(|kind| is_later || *kind == VariableKind::Var)
            }
            DefinitionKind::Constant => Some(VariableKind::Var),
            _ => None,
        }
    };
    let is_shown = |kind: VariableKind, rest: &str| {
        let members: &[&str] = match kind {
            VariableKind::Var => &[],
            VariableKind::Pos => &["X", "Y", "Z"],
            VariableKind::Joint => &["J1", "J2", "J3"],
        };
        let (member, digits) = rest.split_once('.').unwrap_or((rest, "0"));
        let is_digit = |digits: &str| matches!(digits.as_bytes(), [b'0'..=b'7']);
        is_digit(rest) || members.contains(&&*member.to_ascii_uppercase()) && is_digit(digits)
    };
    let text = loaded.source.slice(shown);
    let percents: Vec<usize> = text.match_indices('%').map(|(at, _)| at).collect();
    let mut opening = None;
    for at in percents {
        let inner = opening.map(|start: usize| (start, &text[start..at]));
        opening = Some(at + 1);
        let Some((start, inner)) = inner else {
            continue;
        };
        let (name, digits) = inner.split_once('.').unwrap_or((inner, "0"));
        if kind_of(name).is_some_and(|kind| is_shown(kind, digits)) {
            opening = None;
            let start = shown.start + start;
            found.push(Token {
                text: name,
                place: Span::new(start, start + name.len()),
                label: false,
            });
        }
    }
}

fn words<'a>(text: &'a str, statement: Span, found: &mut Vec<Token<'a>>) {
    let is_name = |char: char| char.is_ascii_alphanumeric() || char == '_';
    let mut behind_jump = false;
    let mut at = statement.start;
    while at < statement.end {
        let rest = &text[at..statement.end];
        let length = rest.find(|char| !is_name(char)).unwrap_or(rest.len());
        if length == 0 {
            at += rest.chars().next().map_or(1, char::len_utf8);
            continue;
        }
        let word = &rest[..length];
        let is_member = text[..at].ends_with('.');
        let is_number = word.starts_with(|first: char| first.is_ascii_digit());
        let colon = text[at + length..]
            .trim_start_matches([' ', '\t', '\u{3000}', ','])
            .starts_with(':');
        let can_be_name = colon || !is_number;
        if can_be_name && !is_member {
            found.push(Token {
                text: word,
                place: Span::new(at, at + length),
                label: behind_jump || colon,
            });
        }
        behind_jump = [
            "GOTO",
            "GOSUB",
            "CALL",
            "START_THREAD",
            "STOP_THREAD",
            "WAIT_THREAD",
        ]
        .iter()
        .any(|jump| word.eq_ignore_ascii_case(jump));
        at += length;
    }
}

/// Returns true if a definition has the name of a token.
fn is_declared(symbols: &Symbols, token: &Token<'_>) -> bool {
    symbols.definitions().iter().any(|definition| {
        let fits = match definition.kind {
            DefinitionKind::Variable(_) | DefinitionKind::Constant => !token.label,
            DefinitionKind::Label | DefinitionKind::Subroutine | DefinitionKind::Thread => {
                token.label
            }
        };
        fits && definition.name.eq_ignore_ascii_case(token.text)
    })
}

/// Flags of motion commands, which may be names of variables too.
fn is_flag(token: &Token<'_>) -> bool {
    !token.label
        && ["R", "A", "HS"]
            .iter()
            .any(|flag| token.text.eq_ignore_ascii_case(flag))
}

/// Checks what is true of every table, also of a program that is refused.
fn check_locations(loaded: &Loaded, case: &Path) {
    let symbols = &loaded.symbols;
    let mut last = 0;
    for it in symbols.all_uses() {
        let place = it.span;
        assert!(
            place.start >= last,
            "order or overlap in {}",
            case.display()
        );
        last = place.end;
        let written = loaded.source.slice(place);
        let name = &symbols.definition(it.definition).name;
        let is_named = written.is_empty() || written.eq_ignore_ascii_case(name);
        assert!(is_named, "`{written}` is not {name} in {}", case.display());
        assert!(is_in_statement(&loaded.module, place), "{}", case.display());
    }
    for definition in symbols.definitions() {
        if let Some(place) = definition.span {
            let named: Vec<&Use> = symbols
                .all_uses()
                .iter()
                .filter(|it| it.span == place)
                .collect();
            assert_eq!(named.len(), 1, "{} in {}", definition.name, case.display());
        }
    }
}

fn is_in_statement(module: &Module, place: Span) -> bool {
    let statement = module.statement_at(place.start);
    statement.is_some_and(|index| place.end <= module.statements[index].span.end)
}

#[test]
fn every_name_is_in_the_table_once_and_at_its_location() {
    let mut compared = 0;
    for (path, bytes) in programs() {
        for robot in Robot::ALL {
            let options = Options {
                robot: *robot,
                ..Options::default()
            };
            let loaded = load("case.prg", &bytes, &options);
            check_locations(&loaded, &path);
            if loaded.program.is_none() {
                continue;
            }
            let expected: Vec<Span> = tokens(&loaded)
                .iter()
                .filter(|token| is_declared(&loaded.symbols, token) && !is_flag(token))
                .map(|token| token.place)
                .collect();
            let is_flag_name = |it: &Use| {
                let token = Token {
                    text: loaded.source.slice(it.span),
                    place: it.span,
                    label: false,
                };
                is_flag(&token) && is_declared(&loaded.symbols, &token)
            };
            let found: Vec<Span> = loaded
                .symbols
                .all_uses()
                .iter()
                .filter(|it| it.span.start < it.span.end && !is_flag_name(it))
                .map(|it| it.span)
                .collect();
            let text = |places: &[Span]| -> Vec<String> {
                places
                    .iter()
                    .map(|place| {
                        format!(
                            "{:?} {}",
                            loaded.source.line_column(place.start),
                            loaded.source.slice(*place)
                        )
                    })
                    .collect()
            };
            assert_eq!(text(&found), text(&expected), "{}", path.display());
            compared += expected.len();
        }
    }
    let is_alone = programs().is_empty();
    assert!(is_alone || compared > 10_000, "{compared} names");
}
