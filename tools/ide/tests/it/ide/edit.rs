//! Renaming, fixes, formatting: what changes a text, and leaves the program what it is.

use super::{changed, cursor};
use tip_ide::Document;
use tipc::Options;
use tipc::message::Lang;

/// The statements with another name at the cursor; they still load.
#[track_caller]
fn check(statements: &str, name: &str, expected: &str) {
    let (document, at) = cursor(statements);
    let edits = document.rename(at, name).expect("it can be renamed");
    let after = changed(&document, &edits);
    assert_eq!(after, expected);
    let text = format!("3.1\nTitle\n{after}");
    let again = Document::new("test.prg", &text, &Options::default());
    assert!(again.loaded().program.is_some());
}

#[test]
fn a_name_changes_in_every_place() {
    check(
        "DEF_VAR a, B\nA = 1\nB = -A\nSLEEP $0A\nMESSAGE 歩%A%歩 A\nSLEEP B\nEND\n",
        "Stride",
        "DEF_VAR Stride, B\nStride = 1\nB = -Stride\nSLEEP Stride\nMESSAGE 歩%Stride%歩 A\nSLEEP B\nEND\n",
    );
    check(
        "DEF_POS P\nP.X = 1; P.Y = 2; P.Z = 3\nPTP F1 $0P\nEND\n",
        "TOP",
        "DEF_POS TOP\nTOP.X = 1; TOP.Y = 2; TOP.Z = 3\nPTP F1 TOP\nEND\n",
    );
    check(
        "GOSUB L1:\nIF KB_HIT GOSUB l1:\nEXIT\n$0L1: REM\nRETURN\nEND\n",
        "1ST",
        "GOSUB 1ST:\nIF KB_HIT GOSUB 1ST:\nEXIT\n1ST: REM\nRETURN\nEND\n",
    );
    check(
        "DEF_VAR A\nA = 1\nSLEEP $0A\nEND\n",
        "a",
        "DEF_VAR a\na = 1\nSLEEP a\nEND\n",
    );
}

/// Returns the reason why it cannot be renamed, in both languages.
#[track_caller]
fn check_refused(statements: &str, name: &str, english: &str, japanese: &str) {
    let (document, at) = cursor(statements);
    let reason = document.rename(at, name).expect_err("it is refused");
    assert_eq!(reason.to_string(), english);
    assert_eq!(reason.in_lang(Lang::Japanese).to_string(), japanese);
}

const VARIABLE: &str = "DEF_VAR A, B\nA = 1\nB = 2\nSLEEP $0A\nSLEEP B\nEND\n";

#[test]
fn a_name_that_cannot_be_is_refused_with_a_reason() {
    check_refused(
        VARIABLE,
        "ptp",
        "`PTP` is a word of the language",
        "`PTP` はこの言語の予約語です",
    );
    check_refused(
        VARIABLE,
        "f9",
        "`F9` is a word of the language",
        "`F9` はこの言語の予約語です",
    );
    check_refused(
        VARIABLE,
        "1A",
        "`1A` cannot name a variable",
        "`1A` は変数名に使えません",
    );
    for odd in ["", "A B", "A.X", "Ａ", "歩幅", "A:", "A\nB"] {
        let odd_name = odd.to_ascii_uppercase();
        let english = format!("`{odd_name}` cannot name a variable");
        check_refused(
            VARIABLE,
            odd,
            &english,
            &format!("`{odd_name}` は変数名に使えません"),
        );
    }
    check_refused(
        VARIABLE,
        &"N".repeat(33),
        "a name has at most 32 bytes, this one 33",
        "名前は32バイトまでですが、これは33バイトあります",
    );
    check_refused(
        VARIABLE,
        "b",
        "`B` is declared on line 3; choose another name",
        "`B` は3行目で宣言されています。別の名前にしてください",
    );
}

#[test]
fn what_has_no_name_of_its_own_is_refused() {
    check_refused(
        "SLE$0EP 10\nEND\n",
        "A",
        "`SLEEP` is a word of the language and cannot be renamed",
        "`SLEEP` はこの言語の語なので、名前は変えられません",
    );
    check_refused(
        "KEY_IN\nSLEEP $0VAR_KEY\nEND\n",
        "A",
        "`VAR_KEY` is a word of the language and cannot be renamed",
        "`VAR_KEY` はこの言語の語なので、名前は変えられません",
    );
    check_refused(
        "SLEEP 1$00\nEND\n",
        "A",
        "there is no name to rename here",
        "ここには変更できる名前がありません",
    );
    let english =
        "GOTO without a label leads to LOOP: another name would change what the program does";
    let japanese = "ラベルのないGOTOはLOOPへ飛びます。名前を変えるとプログラムの動作が変わります";
    check_refused("LO$0OP:\nREM\nGOTO\nEND\n", "A", english, japanese);
    check_refused("L$01:\nREM\nGOTO L1:\nEND\n", "LOOP", english, japanese);
}

#[test]
fn a_name_that_means_something_else_somewhere_is_refused() {
    // Among the arguments of a motion R is always the flag.
    check_refused(
        "DEF_VAR S\nS = 1\nPTP F1 $0S 200 -200\nEND\n",
        "R",
        "the name `R` would change the meaning of the program",
        "名前を `R` にすると別のプログラムになってしまいます",
    );
    // A MESSAGE has at most 70 bytes.
    let long = format!("DEF_VAR A\nA = 1\nMESSAGE {} %$0A%\nEND\n", "x".repeat(66));
    check_refused(
        &long,
        "STRIDE",
        "the name `STRIDE` would change the meaning of the program",
        "名前を `STRIDE` にすると別のプログラムになってしまいます",
    );
}

/// The statements after the fixes at the cursor.
#[track_caller]
fn check_fix(statements: &str, expected: &[&str]) {
    let (document, at) = cursor(statements);
    let place = tipc::source::Span::new(at, at);
    let actions = document.code_actions(place);
    let texts = actions
        .iter()
        .map(|action| changed(&document, &action.edits));
    assert_eq!(texts.collect::<Vec<_>>(), expected);
}

#[test]
fn a_fix_is_that_of_the_diagnostic_at_the_cursor() {
    check_fix(
        "IF KB_HIT$0\nREM\nEND IF\nEND\n",
        &["IF KB_HIT THEN\nREM\nEND IF\nEND\n"],
    );
    check_fix("REM$0\nEND\n", &[]);
}

#[test]
fn all_certain_fixes_are_one_change() {
    let (document, _) = cursor("wait\nIF KB_HIT\nREM\nEND IF\nEND\n$0");
    let action = document.fix_all().expect("there are fixes");
    let fixed = "wait\nIF KB_HIT THEN\nREM\nENDIF\nEND\n";
    // What cannot be put right stays.
    assert_eq!(changed(&document, &action.edits), fixed);
    // Lines between them are left alone.
    assert_eq!(action.edits.len(), 2);
    let (document, _) = cursor("REM\nEND\n$0");
    assert_eq!(document.fix_all(), None);
}

#[test]
fn formatting_changes_only_the_lines_that_need_it() {
    let (document, _) = cursor("def_var n\r\nREM\r\nfor n=1 to 3\r\nrem\r\nnext\r\nend\r\n$0");
    let edits = document.format().expect("a program");
    let formatted = "DEF_VAR N\r\nREM\r\nFOR N = 1 TO 3\r\n  REM\r\nNEXT\r\nEND\r\n";
    assert_eq!(changed(&document, &edits), formatted);
    assert_eq!(edits.len(), 5);
    let (document, _) = cursor("SLEEP\nEND\n$0");
    let refusal = document.format().expect_err("it has errors");
    assert!(
        refusal
            .to_string()
            .contains("a program with errors cannot be formatted")
    );
}
