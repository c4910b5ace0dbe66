//! The text of the editor, its file, and what is no request.

use crate::live::bench::{COUNTS, Memory, answer, ask, does, refuses, session_of};
use crate::live::page::Page;
use serde_json::json;
use tip_sim::Robot;
use tip_view::live::{ClientRequest, MOST_BYTES, NoFile, Session, Setup, TextChecker};

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
fn an_editor_is_told_what_words_are_and_what_can_be_written() {
    // The robot emoji is two units of UTF-16; the text is the one that stands there, checked or not.
    let text = "3.1\ntitle \u{1F916}\nDEF_VAR HEIGHT\nHEIGHT = 60 // \u{1F916}\nSTAND_UP HEIGHT\nPTP F1 0 0 HEI\nEND\n";
    let mut session = session_of(COUNTS);
    does(
        &mut session,
        json!({"do": "edit", "text": text, "base": 1, "by": "me"}),
    );
    let hover = ask(&mut session, json!({"do": "hover", "id": 3, "at": [5, 3]}));
    assert_eq!((&hover["id"], &hover["ok"]), (&json!(3), &json!(true)));
    let known = &hover["hover"];
    assert_eq!(
        (&known["from"], &known["to"]),
        (&json!([5, 1]), &json!([5, 9]))
    );
    let said = |language: usize| known["text"][language].as_str().expect("a text");
    assert!(said(0).contains("STAND_UP"), "{known}");
    assert!(!said(1).is_ascii(), "{known}");
    let nothing = ask(&mut session, json!({"do": "hover", "at": [2, 2]}));
    assert_eq!(nothing["hover"], json!(null));
    let offered = ask(&mut session, json!({"do": "complete", "at": [6, 15]}));
    let offers = offered["offers"].as_array().expect("a list");
    let height = offers.iter().find(|offer| offer["label"] == "HEIGHT");
    let height = height.expect("it is declared");
    assert_eq!(
        (
            &height["from"],
            &height["to"],
            &height["text"],
            &height["fills"]
        ),
        (
            &json!([6, 12]),
            &json!([6, 15]),
            &json!("HEIGHT"),
            &json!(false)
        )
    );
    // What has places to fill is a snippet.
    let offered = ask(&mut session, json!({"do": "complete", "at": [5, 1]}));
    let offers = offered["offers"].as_array().expect("a list");
    let stand = offers.iter().find(|offer| offer["label"] == "STAND_UP");
    let stand = stand.expect("a command");
    assert_eq!(stand["fills"], true);
    let described = |language: usize| stand["description"][language].as_str().expect("a text");
    assert!(
        described(0).is_ascii() && !described(1).is_ascii(),
        "{stand}"
    );
    assert!(
        stand["text"]
            .as_str()
            .is_some_and(|text| text.starts_with("STAND_UP ${1:")),
        "{stand}"
    );
    // Places that are not there do no harm.
    for at in [[0, 0], [1, 99], [u32::MAX, u32::MAX]] {
        for what in ["hover", "complete"] {
            let answer = ask(&mut session, json!({"do": what, "at": at}));
            assert_eq!(answer["ok"], true, "{what} {at:?}");
        }
    }
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
        r#"{"do":"event","event":"jump"}"#,
        r#"{"do":"event","event":"PAW9=1"}"#,
        r#"{"do":"edit","text":1,"base":1,"by":""}"#,
    ] {
        assert_eq!(ask(text)["error"], "unknown", "{text}");
    }
    for text in [
        r#"{"do":"speed","times":0}"#,
        r#"{"do":"speed","times":-1}"#,
        r#"{"do":"speed","times":1e300}"#,
        r#"{"do":"event","event":"J99=1"}"#,
        r#"{"do":"event","event":"set NOTHING=1"}"#,
        // Its robot has no mass.
        r#"{"do":"event","event":"push 9 0 0 for 5"}"#,
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

#[test]
fn a_text_is_checked_apart_from_the_run() {
    let mut session = session_of(COUNTS);
    let mut checker = TextChecker::new(Robot::named("titan8").expect("it has a name"));
    session.hand_over();
    let mut check = |session: &mut Session| {
        let unchecked = session.unchecked().expect("a text");
        assert!(session.unchecked().is_none(), "once");
        session.checked(checker.read(unchecked));
        let hover = ClientRequest::read(r#"{"do":"hover","at":[4,1]}"#);
        checker.answer(&hover).expect("it knows")
    };
    assert!(check(&mut session).contains("MESSAGE") || session.unchecked().is_none());
    let edit =
        json!({"do": "edit", "text": "3.1\nother\nREM\nSLEEP 20\nEND\n", "base": 1, "by": "me"});
    does(&mut session, edit);
    session.advance(0.0, || true);
    let restart = ClientRequest::read(r#"{"do":"restart"}"#);
    assert_eq!(
        session.ask(&restart, &mut NoFile),
        None,
        "it is not checked"
    );
    let stop = ClientRequest::read(r#"{"do":"event","event":"key 0x0D"}"#);
    assert!(stop.is_stop() && !restart.is_stop());
    let done = json!({"type": "answer", "ok": true}).to_string();
    let answer: serde_json::Value =
        serde_json::from_str(&session.ask(&stop, &mut NoFile).expect("at once")).expect("JSON");
    assert_eq!(answer.to_string(), done);
    let mut page = Page::default();
    page.look(&session);
    assert_eq!((&page.status["over"], page.runs), (&json!(true), 1));
    let hover = check(&mut session);
    assert!(hover.contains("SLEEP"), "{hover}");
    assert!(session.ask(&restart, &mut NoFile).is_some());
    page.look(&session);
    assert_eq!((page.runs, &page.status["running"]), (2, &json!(2)));
}

#[test]
fn a_file_that_changed_before_a_stop_does_not_run_after_it() {
    let mut session = session_of(COUNTS);
    session.hand_over();
    let mut checker = TextChecker::new(Robot::named("titan8").expect("it has a name"));
    let mut next = |session: &mut Session| {
        let unchecked = session.unchecked().expect("a text");
        session.checked(checker.read(unchecked));
    };
    next(&mut session);
    session.file_changed(b"3.1\nother\nREM\nSLEEP 20\nEND\n");
    does(&mut session, json!({"do": "event", "event": "key 0x0D"}));
    next(&mut session);
    let mut page = Page::default();
    page.look(&session);
    assert_eq!((page.runs, &page.status["over"]), (1, &json!(true)));
    session.file_changed(b"3.1\nthird\nREM\nSLEEP 20\nEND\n");
    next(&mut session);
    page.look(&session);
    assert_eq!((page.runs, &page.status["over"]), (2, &json!(false)));
}

#[test]
fn a_robot_can_be_stopped_however_much_waits() {
    let mut session = session_of(COUNTS);
    for _ in 0..64 {
        does(&mut session, json!({"do": "event", "event": "key F"}));
    }
    let key = json!({"do": "event", "event": "key F"});
    refuses(&mut session, key, "many");
    does(&mut session, json!({"do": "event", "event": "key 0x0D"}));
    let mut page = Page::default();
    page.look(&session);
    assert_eq!(page.status["outcome"]["how"], "emergency");
}
