//! The text of the editor, its file, and what is no request.

use crate::bench::{COUNTS, Memory, answer, does, refuses, session_of};
use crate::page::Page;
use serde_json::json;
use tip_sim::Robot;
use tip_view::live::{MOST_BYTES, NoFile, Session, Setup};

#[test]
fn an_error_is_found_where_it_is_and_goes_when_it_is_put_right() {
    let mut session = session_of("3.1\ntitle\nREM\nEND\n");
    let mut page = Page::default();
    page.look(&session);
    assert_eq!(
        (page.text.as_str(), page.good),
        ("3.1\ntitle\nREM\nEND\n", true)
    );
    // The robot emoji is two units of UTF-16.
    let wrong = "3.1\ntitle\nREM\nMESSAGE \u{1F916} %f03X%\nPTTP F1\nEND\n";
    does(
        &mut session,
        json!({"do": "edit", "text": wrong, "base": 1, "by": "me"}),
    );
    page.look(&session);
    assert_eq!(
        (page.text.as_str(), page.findings.len()),
        (wrong, 0),
        "not yet checked"
    );
    session.advance(0.0, || true);
    page.look(&session);
    assert!(!page.good);
    let found = page
        .findings
        .iter()
        .find(|it| it["from"] == json!([5, 1]))
        .expect("on line 5");
    assert_eq!(
        (&found["level"], &found["to"]),
        (&json!("error"), &json!([5, 5]))
    );
    let texts = found["text"].as_array().expect("two languages");
    assert!(
        texts[0].as_str().is_some_and(|text| text.contains("PTTP")),
        "{found}"
    );
    assert!(
        texts[1].as_str().is_some_and(|text| !text.is_ascii()),
        "{found}"
    );
    assert_eq!(page.status["changed"], true);
    refuses(&mut session, json!({"do": "restart"}), "errors");
    refuses(
        &mut session,
        json!({"do": "edit", "text": "", "base": 1, "by": "you"}),
        "stale",
    );
    let right = "3.1\nother\nREM\nEND\n";
    does(
        &mut session,
        json!({"do": "edit", "text": right, "base": 2, "by": "me"}),
    );
    session.advance(0.0, || true);
    page.look(&session);
    assert_eq!((page.findings.len(), page.good, page.runs), (0, true, 1));
    does(&mut session, json!({"do": "restart"}));
    page.look(&session);
    assert_eq!((page.runs, &page.status["running"]), (2, &json!(3)));
}

#[test]
fn saving_keeps_the_encoding_and_a_refusal_changes_nothing() {
    let bytes = b"3.1\r\n\x95\xE0\x82\xAD\r\nREM\r\nEND\r\n\x1A";
    let robot = Robot::named("titan8").expect("it has a name");
    let mut session = Session::new(Setup::new("a.prg", bytes, robot)).expect("a program");
    let mut host = Memory {
        bytes: bytes.to_vec(),
        refuses: true,
    };
    let edited = "3.1\n歩く\nREM\nREM 2\nEND\n";
    does(
        &mut session,
        json!({"do": "edit", "text": edited, "base": 1, "by": "me"}),
    );
    let save = r#"{"do":"save","id":7}"#;
    let refused = answer(&mut session, save, &mut host);
    let expected = json!({"type": "answer", "id": 7, "ok": false, "error": "unsaved", "detail": "the disk is full"});
    assert_eq!(refused, expected);
    host.refuses = false;
    assert_eq!(answer(&mut session, save, &mut host)["ok"], true);
    assert_eq!(
        host.bytes,
        b"3.1\r\n\x95\xE0\x82\xAD\r\nREM\r\nREM 2\r\nEND\r\n\x1A"
    );
    let mut page = Page::default();
    page.look(&session);
    assert_eq!(page.status["changed"], false);
    does(
        &mut session,
        json!({"do": "edit", "text": "3.1\n\u{1F916}\nEND\n", "base": 2, "by": "me"}),
    );
    let refused = answer(&mut session, save, &mut host);
    assert_eq!(
        (&refused["error"], &refused["detail"]),
        (&json!("unspelled"), &json!("\u{1F916}"))
    );
}

#[test]
fn a_changed_file_runs_unless_the_text_was_edited() {
    let mut session = session_of(COUNTS);
    let mut page = Page::default();
    page.look(&session);
    session.file_changed(COUNTS.as_bytes());
    assert_eq!(page.look(&session), 0, "nothing has changed");
    session.file_changed(b"3.1\nnew\nREM\nEND\n");
    page.look(&session);
    assert_eq!((page.runs, page.text.as_str()), (2, "3.1\nnew\nREM\nEND\n"));
    session.file_changed(b"3.1\nbad\nREEM\nEND\n");
    page.look(&session);
    assert_eq!((page.runs, page.good, page.findings.len()), (2, false, 1));
    let version = page.version;
    does(
        &mut session,
        json!({"do": "edit", "text": "3.1\nmine\nREM\nEND\n", "base": version, "by": "me"}),
    );
    session.file_changed(b"3.1\ntheirs\nREM\nEND\n");
    page.look(&session);
    assert_eq!(
        (page.text.as_str(), &page.status["overtaken"]),
        ("3.1\nmine\nREM\nEND\n", &json!(true))
    );
    let mut host = Memory {
        bytes: b"3.1\ntheirs\nREM\nEND\n".to_vec(),
        refuses: false,
    };
    assert_eq!(
        answer(&mut session, r#"{"do":"reload"}"#, &mut host)["ok"],
        true
    );
    page.look(&session);
    assert_eq!((page.runs, &page.status["overtaken"]), (3, &json!(false)));
}

#[test]
fn what_is_no_request_is_refused() {
    let mut session = session_of(COUNTS);
    let mut ask = |text: &str| answer(&mut session, text, &mut NoFile);
    for text in [
        "",
        "[]",
        "{",
        "\"play\"",
        "null",
        "{\"id\":-1}",
        "{\"id\":\"a\"}",
        &"[".repeat(100_000),
    ] {
        assert_eq!(ask(text)["error"], "malformed", "{text:.20}");
    }
    for text in [
        "{}",
        r#"{"do":"jump"}"#,
        r#"{"do":"play","fast":true}"#,
        r#"{"do":"step"}"#,
        r#"{"do":"step","cycles":1.5}"#,
        r#"{"do":"edit","text":1,"base":1,"by":""}"#,
    ] {
        assert_eq!(ask(text)["error"], "unknown", "{text}");
    }
    for text in [
        r#"{"do":"speed","times":0}"#,
        r#"{"do":"speed","times":-1}"#,
        r#"{"do":"speed","times":1e300}"#,
        r#"{"do":"event","event":"jump"}"#,
        r#"{"do":"event","event":"PAW9=1"}"#,
        r#"{"do":"event","event":"set NOTHING=1"}"#,
        r#"{"do":"go","cycle":18446744073709551615}"#,
    ] {
        assert_eq!(ask(text)["error"], "impossible", "{text}");
    }
    let long = format!(r#"{{"do":"{}"}}"#, "x".repeat(MOST_BYTES));
    assert_eq!(ask(&long)["error"], "long");
    assert_eq!(ask(r#"{"do":"save"}"#)["error"], "unsaved");
    assert_eq!(ask(r#"{"do":"jump","id":3}"#)["id"], 3);
    for _ in 0..64 {
        assert_eq!(ask(r#"{"do":"event","event":"key A"}"#)["ok"], true);
    }
    assert_eq!(ask(r#"{"do":"event","event":"key A"}"#)["error"], "many");
}
