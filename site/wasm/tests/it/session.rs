//! The session that a page without a server has, and traces.

use serde_json::{Value, json};
use tip_playground::{Playground, trace};

/// Waits for a key, and says so.
const KEYS: &str = "3.1\nkeys\nDEF_VAR K\nKEY_IN K\nMESSAGE key\nSLEEP 2000\nEND\n";

fn wanted(text: &str) -> Value {
    json!({ "program": { "name": "try.prg", "text": text } })
}

fn opened(wanted: &Value) -> Playground {
    let mut playground = Playground::default();
    playground.open(&wanted.to_string()).expect("it can be had");
    playground
}

/// All that the page does not know yet.
fn updates(playground: &mut Playground) -> Vec<Value> {
    let mut all = Vec::new();
    while let Some(update) = playground.update() {
        all.push(serde_json::from_str(&update).expect("JSON"));
    }
    all
}

/// The last update of a kind.
fn last(updates: &[Value], kind: &str) -> Value {
    let mut found = updates.iter().filter(|update| update["type"] == kind);
    found.next_back().cloned().unwrap_or_default()
}

fn asked(playground: &mut Playground, request: &Value) -> Value {
    let answer = playground.request(&request.to_string());
    serde_json::from_str(&answer.expect("there is a session")).expect("JSON")
}

#[test]
fn a_session_plays_at_once_and_takes_what_its_page_does() {
    let mut playground = opened(&wanted(KEYS));
    let first = updates(&mut playground);
    assert_eq!(first[0]["type"], "run");
    assert_eq!(last(&first, "status")["playing"], true);
    // A cycle takes 20 ms.
    playground.advance(200.0, || true);
    assert_eq!(last(&updates(&mut playground), "more")["cycles"], 11);
    let answer = asked(&mut playground, &json!({ "do": "event", "event": "key F" }));
    assert_eq!(answer["ok"], true);
    playground.advance(60.0, || true);
    let said = last(&updates(&mut playground), "more");
    assert_eq!(said["log"]["message"][1][0], "key", "{said}");
    let answer = asked(&mut playground, &json!({ "do": "step", "cycles": -1 }));
    assert_eq!(answer["ok"], true);
    let back = updates(&mut playground);
    assert_eq!(last(&back, "more")["cycles"], 13);
    assert_eq!(last(&back, "status")["playing"], false);
}

#[test]
fn a_text_with_errors_stands_in_the_editor_and_runs_when_it_is_put_right() {
    let wrong = "3.1\nrises\nSTAND_UPP 60\nEND\n";
    let mut playground = opened(&wanted(wrong));
    playground.advance(0.0, || true);
    let shown = updates(&mut playground);
    assert_eq!(last(&shown, "text")["text"], wrong);
    let found = &last(&shown, "findings")["findings"][0];
    assert_eq!(
        (&found["from"], &found["level"]),
        (&json!([3, 1]), &json!("error"))
    );
    let restart = json!({ "do": "restart" });
    assert_eq!(asked(&mut playground, &restart)["error"], "errors");
    let version = &last(&shown, "text")["version"];
    let right = json!({ "do": "edit", "text": "3.1\nrises\nSTAND_UP 60\nEND\n", "base": version, "by": "me" });
    assert_eq!(asked(&mut playground, &right)["ok"], true);
    assert_eq!(asked(&mut playground, &restart)["ok"], true);
    assert_eq!(
        last(&updates(&mut playground), "run")["script"]["title"],
        "rises"
    );
}

#[test]
fn another_robot_takes_the_place_of_the_one_before() {
    let mut playground = opened(&wanted(KEYS));
    updates(&mut playground);
    let mut other = wanted("3.1\nclosed\nEND\n");
    other["robot"] = json!({ "name": "hand" });
    other["scene"] = json!({ "name": "cylinder" });
    playground.open(&other.to_string()).expect("it can be had");
    let shown = updates(&mut playground);
    let run = &shown[0];
    assert_eq!(
        (&run["type"], &run["robot"]["name"]),
        (&json!("run"), &json!("hand"))
    );
    assert_eq!(run["scene"]["objects"].as_array().map(Vec::len), Some(1));
}

#[test]
fn what_cannot_be_had_is_an_error_and_the_session_goes_on() {
    let program = json!({ "name": "x.prg", "text": "3.1\nx\nSLEEP 1000\nEND\n" });
    let wrong = [
        json!({}),
        json!({ "program": program, "robot": { "name": "r2d2" } }),
        json!({ "program": program, "robot": { "name": "own.toml", "text": "legs = 0\n" } }),
        json!({ "program": program, "scene": { "name": "cylinder" } }),
        json!({ "program": program, "scene": { "name": "moon" } }),
        json!({ "program": program, "events": "soon" }),
        json!({ "program": program, "events": "1:PAW9=1" }),
    ];
    let mut playground = opened(&wanted(KEYS));
    updates(&mut playground);
    for one in wrong {
        let error = playground.open(&one.to_string()).expect_err("it is wrong");
        assert!(!error.is_empty(), "{one}");
    }
    assert!(playground.open("not JSON").is_err());
    playground.advance(200.0, || true);
    assert_eq!(last(&updates(&mut playground), "more")["cycles"], 11);
    assert_eq!(Playground::default().request("{}"), None);
}

#[test]
fn the_faults_of_a_description_are_named_with_their_places() {
    let mut one = wanted("3.1\nx\nEND\n");
    one["robot"] = json!({ "name": "own.toml", "text": "legs = 0\n" });
    let error = Playground::default().open(&one.to_string());
    let error = error.expect_err("there is no such robot");
    assert!(error.starts_with("own.toml:"), "{error}");
}

#[test]
fn a_trace_is_that_of_the_command_and_ends_where_it_is_asked_to() {
    let mut one = wanted("3.1\nwaits\nMESSAGE hi\nSLEEP 1000\nEND\n");
    one["cycles"] = json!(5);
    let trace = trace(&one.to_string()).expect("it runs");
    let records: Vec<Value> = trace
        .lines()
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    assert_eq!(records.len(), 6, "{trace}");
    assert_eq!(records[0]["say"], "hi");
    assert!(
        records[0].get("state").is_some(),
        "with what the joints did: {trace}"
    );
    assert_eq!(records[5], json!({ "end": "LIMIT", "cycles": 5 }));
}

#[test]
fn a_program_with_errors_leaves_no_trace() {
    assert!(trace(&wanted("3.1\n").to_string()).is_err());
}
