use super::{Style, classical, human, json, plain, short};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::load::{Options, load};
use crate::message::{Lang, Parsing, Reading};
use crate::robot::Robot;
use crate::source::{Encoding, Source, Span};

fn source(name: &str, text: &str) -> Source {
    Source::decode(name, text.as_bytes(), Encoding::Utf8).0
}

/// Returns a diagnostic at the first occurrence of `location`.
fn at(source: &Source, code: Code, location: &str, reason: &str) -> Diagnostic {
    Diagnostic::new(code, span(source, location), text(reason))
}

/// Returns a message of any text.
fn text(text: &str) -> Reading {
    let error = text.to_owned().into();
    Reading::System { error }
}

fn span(source: &Source, location: &str) -> Span {
    let start = source
        .text()
        .find(location)
        .expect("the place stands in the text");
    Span::new(start, start + location.len())
}

#[track_caller]
fn check_human(source: &Source, diagnostic: &Diagnostic, expected: &str) {
    let shown = human(source, diagnostic, Style::default());
    let trimmed: Vec<&str> = shown.lines().map(str::trim_end).collect();
    assert_eq!(
        trimmed.join("\n").trim_end(),
        expected.trim_matches('\n'),
        "\n{shown}"
    );
}

// clauses: 8.1
#[test]
fn carets_stand_under_the_place_behind_wide_text() {
    let source = source("walk.prg", "3.1\nt\nMESSAGE 日本 // 注\nEND");
    let diagnostic = at(
        &source,
        Code::CommentInMessage,
        "// 注",
        "the text ends here",
    )
    .help(text("move it"));
    check_human(
        &source,
        &diagnostic,
        "
warning[W103]: the comment cuts this MESSAGE text
 --> walk.prg:3:12
  |
3 | MESSAGE 日本 // 注
  |              ^^^^^ the text ends here
  |
  = help: move it
",
    );
}

// clauses: 8.1
#[test]
fn labels_are_shown_near_and_far() {
    let body = "A = 1\n".repeat(60);
    let source = source(
        "walk.prg",
        &format!("3.1\nt\nWHILE KB_HIT\nIF KB_HIT THEN\n{body}END"),
    );
    let diagnostic = at(&source, Code::Structure, "WHILE", "this is never closed")
        .label(span(&source, "IF"), text("inside it"))
        .label(span(&source, "END"), text("the program ends here"));
    check_human(
        &source,
        &diagnostic,
        "
error[E207]: this is never closed
  --> walk.prg:3:1
   |
 3 | WHILE KB_HIT
   | ^^^^^
 4 | IF KB_HIT THEN
   | -- inside it
   |
  ::: walk.prg:65:1
   |
65 | END
   | --- the program ends here
   |
   = note: TIP_ERR:Control structure mismatch (SyntaxError)
",
    );
}

#[test]
fn of_very_many_places_the_first_are_shown() {
    let text = format!("3.1\nt\n{}END", "SLEEP N\n".repeat(5000));
    let loaded = crate::load("many.prg", text.as_bytes(), &crate::Options::default());
    let [finding] = loaded.diagnostics.as_slice() else {
        panic!("{} findings", loaded.diagnostics.len());
    };
    assert_eq!(finding.labels.len(), 4999);
    let shown = human(&loaded.source, finding, Style::default());
    assert_eq!(shown.matches("used here too").count(), 8, "{shown}");
}

#[test]
fn a_place_at_the_end_of_a_line_has_its_caret() {
    let source = source("walk.prg", "3.1\r\nt\r\nA =\r\nEND");
    let location = Span::new(span(&source, "A =").end, span(&source, "A =").end);
    let diagnostic = Diagnostic::new(Code::Equation, location, Parsing::OperandMissing);
    check_human(
        &source,
        &diagnostic,
        "
error[E107-03]: an operand is missing here
 --> walk.prg:3:4
  |
3 | A =
  |    ^
  |
  = note: TIP_ERR:Wrong equation format (PreprocessError)
",
    );
}

#[test]
fn a_place_far_into_an_endless_line_is_named_without_its_line() {
    let source = source("walk.prg", &format!("{}X", "あ".repeat(5000)));
    let diagnostic = at(&source, Code::Format, "X", "too far");
    let shown = human(&source, &diagnostic, Style::default());
    assert!(shown.contains("--> walk.prg:1:5001"), "{shown}");
    assert!(shown.contains("too far"), "{shown}");
}

#[test]
fn colour_is_only_there_when_asked_for() {
    let source = source("walk.prg", "3.1\nt\nEND");
    let diagnostic = at(&source, Code::Format, "END", "why");
    assert!(!human(&source, &diagnostic, Style::default()).contains('\u{1B}'));
    assert!(human(&source, &diagnostic, Style::default().colour(true)).contains('\u{1B}'));
}

// clauses: 8.1
#[test]
fn the_classical_line_follows_the_location() {
    let source = source("dir/walk.prg", "3.1\nt\n　あGOTO X:\nEND");
    let error = at(&source, Code::UnknownLabel, "X", "nowhere").about("X");
    assert_eq!(
        classical(&source, &error),
        "dir/walk.prg:3:8: error: TIP_ERR:Label \"X\" does not exist (SyntaxError)"
    );
    let warning = at(&source, Code::Unused, "X", "here").about("X");
    assert_eq!(
        classical(&source, &warning),
        "dir/walk.prg:3:8: warning: variable \"X\" is declared but never used"
    );
}

// clauses: 8.1
#[test]
fn short_is_the_reason_and_the_classical_message_after_the_location() {
    let source = source("dir/walk.prg", "3.1\nt\n　あGOTO X:\nEND");
    let error = at(&source, Code::UnknownLabel, "X", "nowhere").about("X");
    assert_eq!(
        short(&source, &error, Lang::English),
        "dir/walk.prg:3:8: error[E202]: nowhere (TIP_ERR:Label \"X\" does not exist)"
    );
    let warning = at(&source, Code::Unused, "X", "here").about("X");
    assert_eq!(
        short(&source, &warning, Lang::English),
        "dir/walk.prg:3:8: warning[W101]: variable \"X\" is declared but never used"
    );
    assert_eq!(
        short(&source, &warning, Lang::Japanese),
        "dir/walk.prg:3:8: warning[W101]: 変数 \"X\" は宣言されていますが、使われていません"
    );
}

// clauses: 8.1
#[test]
fn people_read_in_their_language() {
    let source = source("walk.prg", "3.1\nt\nWHILE KB_HIT DO\nEND");
    let location = span(&source, "DO");
    let error = Diagnostic::new(Code::Argument, location, Parsing::ThenBelongsHere)
        .help(Parsing::LeavePlusOut)
        .label(span(&source, "WHILE"), Parsing::TextEndsHere);
    let shown = human(&source, &error, Style::default().lang(Lang::Japanese));
    let expected = "
エラー[E205-17]: ここにはTHENを書きます
 --> walk.prg:3:14
  |
3 | WHILE KB_HIT DO
  | -----        ^^
  | |
  | 文字列はここで終わります
  |
  = ヘルプ: `+` を取ってください
  = 注: TIP_ERR:Wrong argument (SyntaxError)
";
    assert_eq!(shown.trim_end(), expected.trim());
}

// clauses: 8.1
#[test]
fn json_is_one_object_on_one_line() {
    let source = source("a\"b\\.prg", "3.1\nt\nあ X\nEND");
    let error = at(&source, Code::UnknownVariable, "X", "nowhere")
        .about("X")
        .help(text("two\nlines\t日"))
        .label(span(&source, "t"), text("there"));
    assert_eq!(
        json(&source, &error, Some(Robot::Titan8), Lang::English),
        concat!(
            r#"{"level":"error","kind":"SyntaxError","message":"unknown variable \"X\"","code":"E206","#,
            r#""file":"a\"b\\.prg","line":3,"column":3,"help":"two\u000alines\u0009日","#,
            r#""reason":"nowhere","class":"E206","#,
            r#""range":{"start":{"byte":10,"line":3,"column":3,"utf8":5,"utf16":3},"#,
            r#""end":{"byte":11,"line":3,"column":4,"utf8":6,"utf16":4}},"#,
            r#""labels":[{"text":"there","#,
            r#""range":{"start":{"byte":4,"line":2,"column":1,"utf8":1,"utf16":1},"#,
            r#""end":{"byte":5,"line":2,"column":2,"utf8":2,"utf16":2}}}],"fixes":[],"encoding":"UTF-8","#,
            r#""robot":"titan8","related":[],"page":"tip explain E206"}"#
        )
    );
    let warning = at(&source, Code::CommentInMessage, "3.1", "here");
    assert_eq!(
        json(&source, &warning, None, Lang::Japanese),
        concat!(
            r#"{"level":"warning","message":"the comment cuts this MESSAGE text","code":"W103","#,
            r#""file":"a\"b\\.prg","line":1,"column":1,"reason":"here","class":"W103","#,
            r#""range":{"start":{"byte":0,"line":1,"column":1,"utf8":1,"utf16":1},"#,
            r#""end":{"byte":3,"line":1,"column":4,"utf8":4,"utf16":4}},"labels":[],"fixes":[],"encoding":"UTF-8","related":[],"#,
            r#""page":"tip explain W103"}"#
        )
    );
}

// clauses: 8.1
#[test]
fn the_same_mistake_elsewhere_is_related() {
    let text = "3.1\nt\nSLEEP N\n  SLEEP N\nEND";
    let loaded = crate::load("walk.prg", text.as_bytes(), &crate::Options::default());
    let [finding] = loaded.diagnostics.as_slice() else {
        panic!("{:#?}", loaded.diagnostics);
    };
    let object = json(&loaded.source, finding, loaded.robot, Lang::English);
    let related = r#""related":[{"file":"walk.prg","line":4,"column":9,"text":"used here too"}]"#;
    assert!(object.contains(related), "{object}");
    // What only explains a mistake is not.
    let text = "3.1\nt\nL1:\nL1:\nEND";
    let loaded = crate::load("walk.prg", text.as_bytes(), &crate::Options::default());
    let object = json(&loaded.source, &loaded.diagnostics[0], None, Lang::English);
    assert!(
        object.contains(r#"[{"text":"first declared here","#),
        "{object}"
    );
    assert!(object.contains(r#""related":[],"#), "{object}");
}

// clauses: 8.1
#[test]
fn bytes_are_those_of_the_file() {
    // 歩 is 3 bytes of UTF-8, but 2 of Shift_JIS.
    let bytes = b"3.1\n\x95\xE0\nX\nEND";
    let (source, _) = Source::decode("sjis.prg", bytes, Encoding::ShiftJis);
    let found = json(
        &source,
        &at(&source, Code::Format, "X", "why"),
        None,
        Lang::English,
    );
    assert!(found.contains(r#""start":{"byte":7,"line":3,"#), "{found}");
    assert!(found.contains(r#""encoding":"Shift_JIS","#), "{found}");
    let (source, _) = Source::decode("bom.prg", b"\xEF\xBB\xBF3.1\n", Encoding::Utf8);
    let found = json(
        &source,
        &at(&source, Code::Format, "3.1", "why"),
        None,
        Lang::English,
    );
    assert!(
        found.contains(r#""start":{"byte":3,"line":1,"column":1,"utf8":1,"#),
        "{found}"
    );
}

// clauses: 8.1
#[test]
fn what_could_act_on_a_terminal_is_an_escape() {
    let source = source(
        "a\nb\u{9b}.prg",
        "3.1\nt\nあ\u{1b}[2J\u{202e}\tX // \u{8}\u{7f}\nEND",
    );
    let error = at(&source, Code::UnknownVariable, "X", "no\u{1b}where").about("X\u{200f}");
    let line = r#"a\u{a}b\u{9b}.prg:3:8: error[E206]: no\u{1b}where (TIP_ERR:unknown variable "X\u{200f}")"#;
    assert_eq!(short(&source, &error, Lang::English), line);
    let line =
        r#"a\u{a}b\u{9b}.prg:3:8: error: TIP_ERR:unknown variable "X\u{200f}" (SyntaxError)"#;
    assert_eq!(classical(&source, &error), line);
    let expected = r#"
error[E206]: no\u{1b}where
 --> a\u{a}b\u{9b}.prg:3:23
  |
3 | あ\u{1b}[2J\u{202e}    X // \u{8}\u{7f}
  |                        ^
  |
  = note: TIP_ERR:unknown variable "X\u{200f}" (SyntaxError)"#;
    let expected = expected.replace(
        ":3:23",
        &location(&human(&source, &error, Style::default())),
    );
    check_human(&source, &error, &expected);
    let object = json(&source, &error, Some(Robot::Titan8), Lang::English);
    assert!(
        object.contains(r#""file":"a\u000ab\u009b.prg""#),
        "{object}"
    );
    assert!(object.contains(r#"X\u200f"#), "{object}");
}

/// `:LINE:COLUMN` of the first location: columns count what is shown.
fn location(shown: &str) -> String {
    let line = shown.lines().nth(1).unwrap_or_default();
    let at = line.find(".prg").map_or(0, |at| at + ".prg".len());
    line[at..].trim_end().to_owned()
}

#[test]
fn helps_fit_a_terminal() {
    let text = "3.1\nt\nWHILE N > 1 AND N < 5\nWEND\nEND";
    let loaded = crate::load("walk.prg", text.as_bytes(), &crate::Options::default());
    let and = &loaded
        .diagnostics
        .iter()
        .find(|one| one.code == Code::Argument);
    let and = and.expect("the AND is wrong");
    let helps = |lang, width| {
        let style = Style::default().lang(lang).width(width);
        let shown = human(&loaded.source, and, style);
        let lines = shown.lines().skip_while(|line| !line.starts_with("  = "));
        let helps = lines.take_while(|line| !line.contains("TIP_ERR"));
        helps.map(str::to_owned).collect::<Vec<_>>()
    };
    for lang in Lang::ALL {
        let whole = helps(*lang, None);
        assert_eq!(whole.len(), 1, "{whole:?}");
        for width in [40, 60, 80] {
            let lines = helps(*lang, Some(width));
            let beyond = |line: &&String| crate::source::first_beyond(line, width).is_some();
            assert_eq!(lines.iter().find(beyond), None, "{lines:#?}");
            // Nothing is lost, and nothing but blanks is new.
            let words = |lines: &[String]| lines.concat().replace(' ', "");
            assert_eq!(words(&lines), words(&whole));
        }
    }
}

#[test]
fn headlines_break_where_the_terminal_ends() {
    let text = "3.1\nheadline\nSETUP_OF_THE_WHOLE_ROBOT = 1\nEND\n";
    let loaded = crate::load("wide.prg", text.as_bytes(), &crate::Options::default());
    for lang in [Lang::English, Lang::Japanese] {
        let style = Style::default().lang(lang).width(Some(40));
        let shown = human(&loaded.source, &loaded.diagnostics[0], style);
        let arrow = shown.lines().position(|line| line.contains("-->"));
        let headline: Vec<&str> = shown.lines().take(arrow.expect("a place")).collect();
        assert!(headline.len() > 1, "{shown}");
        let beyond = |line: &&str| crate::source::first_beyond(line, 40).is_some();
        assert!(!headline.iter().any(beyond), "{shown}");
    }
}

fn rendered(statements: &str) -> String {
    let text = format!("3.1\nA title\n{statements}\nEND\n");
    let loaded = load("walk.prg", text.as_bytes(), &Options::default());
    plain(&loaded.source, &loaded.diagnostics[0], Lang::English)
}

#[test]
fn an_error_is_shown_with_its_line_its_help_and_the_classical_message() {
    let expected = "E204-01: `FLY` is not a command
 --> walk.prg:3:1
  |
3 | FLY F1 10
  | ^^^
  |
  = help: a label ends with a colon, an equation has `=` after its variable
  = note: TIP_ERR:Unknown command \"FLY\" (SyntaxError)
";
    assert_eq!(rendered("FLY F1 10"), expected);
}

#[test]
fn carets_stand_below_the_place_whatever_is_before_it() {
    let text = rendered("\tSLEEP 歩");
    let lines = "\n3 |     SLEEP 歩\n  |           ^^\n  |\n";
    assert!(text.contains(lines), "{text}");
}

#[test]
fn other_places_are_listed() {
    let text = rendered("GOTO UP:\nGOSUB UP:");
    assert!(text.contains("\n  = walk.prg:4:7: "), "{text}");
}
