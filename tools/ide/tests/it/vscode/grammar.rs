//! The grammar of TextMate: the classes of [`tip_ide::TokenClass`], as far as a line tells them.

use crate::vscode::rule::Rule;
use serde::Serialize;
use std::collections::BTreeMap;
use tip_runtime::command::{Flag, MAX, READING, Target};
use tipc::language::commands::{COMMANDS, Command, Form, Meaning};
use tipc::language::flags::{self, FLAGS};
use tipc::language::keywords::KEYWORDS;
use tipc::language::reserved::{JOINT, Kind, POSITION, RESERVED, motion_flags};
use tipc::language::{Keyword, functions, inputs};

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Grammar {
    name: &'static str,
    scope_name: &'static str,
    file_types: [&'static str; 1],
    patterns: Vec<Rule>,
    repository: BTreeMap<&'static str, Rule>,
}

/// The separators of words.
const BLANK: &str = r"[ \t,\x{3000}]";
/// The beginning and the end of a word.
const BEFORE: &str = "(?<![A-Za-z0-9_.])";
const AFTER: &str = "(?![A-Za-z0-9_.])";
/// The end of a statement.
const END: &str = "(?=;|//|$)";
const NAME: &str = "[A-Z0-9_]+";

const KEYWORD: &str = "keyword.control";
const COMMAND: &str = "support.function.command";
const LABEL: &str = "entity.name.label";
const TEXT: &str = "string.unquoted";
const COMMENT: &str = "comment.line.double-slash";
const NUMBER: &str = "constant.numeric";

pub(crate) fn grammar() -> Grammar {
    let first = ["header", "comment", "separator", "text"];
    let then = ["label", "end", "motion", "statement"];
    let patterns = first.into_iter().chain(then).map(Rule::include);
    Grammar {
        name: "T.I.P.",
        scope_name: "source.tip",
        file_types: ["prg"],
        patterns: patterns.collect(),
        repository: BTreeMap::from([
            ("header", header()),
            ("comment", Rule::named(COMMENT, "//.*$")),
            (
                "separator",
                Rule::named("punctuation.terminator.statement", ";"),
            ),
            ("text", text()),
            ("label", label()),
            ("end", end()),
            ("motion", motion()),
            ("statement", statement()),
            ("words", words()),
        ]),
    }
}

/// The version on line 1, and the title on line 2.
fn header() -> Rule {
    let version = r"\A[ \t\x{3000}]*([0-9][0-9.]*)";
    Rule::stretch(version, "^(.*)$", vec![Rule::include("comment")])
        .begins_with(1, &format!("{NUMBER}.version"))
        .ends_with(1, &format!("{TEXT}.title"))
}

/// MESSAGE, F_MESSAGE and REM, which texts follow.
fn text() -> Rule {
    let begin = |keyword: Keyword| format!("(?i)({keyword})(?={BLANK}|;|//|$)");
    let member = format!("(?:\\.(?:{}|{JOINT}[0-9]))?", any(POSITION));
    let placeholder = format!("(?i)%({READING}?[A-Z_][A-Z0-9_]*){member}(?:\\.[0-7])?%");
    let placeholder = Rule::parts(placeholder, &[(1, "variable.other")]);
    let shown = |keyword, patterns| {
        Rule::stretch(begin(keyword), END, patterns)
            .begins_with(1, KEYWORD)
            .holds(TEXT)
    };
    Rule::list(vec![
        shown(Keyword::Message, vec![placeholder.clone()]),
        shown(Keyword::FileMessage, vec![placeholder]),
        shown(Keyword::Rem, Vec::new()),
    ])
}

fn label() -> Rule {
    let pattern = format!("(?i)({NAME}){BLANK}*(:)(?!=)");
    Rule::parts(pattern, &[(1, LABEL), (2, "punctuation.separator.label")])
}

/// END, after which nothing is read.
fn end() -> Rule {
    let begin = format!(
        "(?i)({}){AFTER}(?:[^/\\r\\n]|/(?!/))*(//.*)?$",
        Keyword::End
    );
    Rule::stretch(begin, "(?!)", Vec::new())
        .begins_with(1, KEYWORD)
        .begins_with(2, COMMENT)
        .holds("meta.after-end")
}

/// The commands among whose arguments a few letters are flags.
fn motion() -> Rule {
    let has_flags = |row: &&Command| matches!(row.form, Form::Robot(of) if of.hs || of.motion);
    let names = COMMANDS.iter().filter(has_flags).flat_map(spellings);
    let begin = format!("(?i)({}){AFTER}", any(names));
    let flags = Rule::named("storage.modifier", word(&any(motion_flags())));
    Rule::stretch(begin, END, vec![flags, Rule::include("words")]).begins_with(1, COMMAND)
}

fn statement() -> Rule {
    let jumps = [
        Keyword::Subroutine,
        Keyword::Call,
        Keyword::Goto,
        Keyword::Gosub,
        Keyword::Thread,
        Keyword::StartThread,
        Keyword::StopThread,
        Keyword::WaitThread,
    ];
    let jumps = any(jumps.map(Keyword::word));
    let jump = format!("(?i){BEFORE}({jumps}){BLANK}+({NAME})");
    let jump = Rule::parts(jump, &[(1, KEYWORD), (2, LABEL)]);
    let begin = r"(?=[^ \t,\x{3000};\r\n])";
    Rule::stretch(begin, END, vec![jump, Rule::include("words")])
}

fn words() -> Rule {
    let named = |scope: &str, words: String| Rule::named(scope, word(&words));
    let commands = COMMANDS
        .iter()
        .filter(|row| !matches!(row.meaning, Meaning::Keyword(_)));
    let variable = format!(
        "(?i){BEFORE}([A-Z_][A-Z0-9_]*)(?:\\.({}|{JOINT}[0-9]+){AFTER})?",
        any(POSITION)
    );
    let parts = [(1, "variable.other"), (2, "variable.other.member")];
    let member = format!("(?:\\.({}|{JOINT}[0-9]+){AFTER})?", any(POSITION));
    let reading = format!("(?i)({READING}[A-Z0-9_]+){member}");
    let number = format!("(?i){BEFORE}(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:E[-+]?[0-9]+)?{AFTER}");
    Rule::list(vec![
        named(KEYWORD, any(KEYWORDS.iter().map(|row| row.word))),
        named(COMMAND, any(commands.flat_map(spellings))),
        named("support.function.math", any(functions::words())),
        named("variable.language.flag", flag()),
        named("constant.language.target", any(targets())),
        named("constant.language.input", any(inputs::named())),
        named("constant.language.key", any(constants())),
        Rule::named(NUMBER, number),
        Rule::parts(
            reading,
            &[
                (1, "variable.language.reading"),
                (2, "variable.other.member"),
            ],
        ),
        Rule::parts(variable, &parts),
        Rule::named("keyword.operator", "<>|[-+*/=<>]=|[-+*/=<>!]"),
        Rule::named("invalid.illegal", r"[^\x00-\x7F\x{3000}]+"),
    ])
}

fn spellings(row: &'static Command) -> impl Iterator<Item = &'static str> {
    [Some(row.name), row.alias].into_iter().flatten()
}

/// Returns the pattern of a target with any number.
fn target(of: Target) -> String {
    let digit = format!("[1-{MAX}]");
    match of {
        Target::Foot(_) => format!("{}{digit}", of.stem()),
        Target::Joint(..) => format!("{}{digit}{digit}", of.stem()),
        Target::None | Target::All | Target::Floor => of.stem().to_owned(),
    }
}

fn targets() -> impl Iterator<Item = String> {
    RESERVED.iter().filter_map(|row| match row.kind {
        Kind::Target(of) => Some(target(of)),
        _ => None,
    })
}

fn flag() -> String {
    let floor = target(Target::Floor);
    let awaited = any(targets().filter(|target| *target != floor));
    let families = FLAGS.iter().filter(|row| row.is_family());
    let families = families.map(|row| match row.flag {
        Flag::Special(_) => format!("{}[0-9]", row.word()),
        flag => {
            let stems = [Some(flag.stem()), flag.other_stem()];
            format!("(?:{})(?:{awaited})", any(stems.into_iter().flatten()))
        }
    });
    any(flags::words().map(str::to_owned).chain(families))
}

fn constants() -> impl Iterator<Item = String> {
    RESERVED.iter().filter_map(|row| match row.kind {
        Kind::Constant(_) => Some(row.word.to_owned()),
        Kind::Characters => Some(format!("{}[0-9A-Z]", row.word)),
        _ => None,
    })
}

/// One of these.
fn any(words: impl IntoIterator<Item = impl ToString>) -> String {
    let words: Vec<String> = words.into_iter().map(|word| word.to_string()).collect();
    words.join("|")
}

/// Whole words, in capital letters or not.
fn word(alternatives: &str) -> String {
    format!("(?i){BEFORE}(?:{alternatives}){AFTER}")
}
