//! What the function answers that a page calls.

use serde_json::{Value, json};
use tip_playground::answer;

fn answered(question: &Value) -> Value {
    serde_json::from_str(&answer(&question.to_string())).expect("answers are JSON")
}

fn program(text: &str) -> Value {
    json!({ "name": "try.prg", "text": text })
}

#[test]
fn a_check_gives_findings_at_their_places_in_the_language_that_is_asked_for() {
    let text = "3.1\nrises\nSTAND_UPP 60\nEND\n";
    for (lang, help) in [("en", "did you mean"), ("ja", "間違い")] {
        let answer = answered(&json!({ "task": "check", "program": program(text), "lang": lang }));
        let finding = &answer["findings"][0];
        assert_eq!(
            (&finding["line"], &finding["column"]),
            (&json!(3), &json!(1))
        );
        assert_eq!(finding["level"], "error");
        assert!(
            finding["help"]
                .as_str()
                .is_some_and(|said| said.contains(help)),
            "{finding}"
        );
        assert_eq!(answer.get("recording"), None);
    }
}

#[test]
fn a_program_with_errors_does_not_run() {
    for task in ["run", "trace"] {
        let answer = answered(&json!({ "task": task, "program": program("3.1\n") }));
        assert_ne!(answer["findings"], json!([]));
        assert_eq!(
            answer.as_object().map(|object| object.len()),
            Some(1),
            "{answer}"
        );
    }
}

#[test]
fn a_trace_is_that_of_the_command_and_ends_where_it_is_told_to() {
    let text = "3.1\nwaits\nMESSAGE hi\nSLEEP 1000\nEND\n";
    let answer = answered(&json!({ "task": "trace", "program": program(text), "cycles": 5 }));
    let trace = answer["trace"].as_str().expect("it runs");
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
fn what_cannot_be_answered_is_an_error_and_no_panic() {
    let wrong = [
        json!({}),
        json!({ "task": "fly", "program": program("") }),
        json!({ "task": "run", "program": program("3.1\nx\nEND\n"), "robot": { "name": "r2d2" } }),
        json!({ "task": "run", "program": program("3.1\nx\nEND\n"), "scene": { "name": "cylinder" } }),
        json!({ "task": "run", "program": program("3.1\nx\nEND\n"), "scene": { "name": "moon" } }),
        json!({ "task": "run", "program": program("3.1\nx\nEND\n"), "events": "soon" }),
        json!({ "task": "run", "program": program("3.1\nx\nEND\n"), "events": "1:PAW9=1" }),
    ];
    for question in wrong {
        assert!(answered(&question)["error"].is_string(), "{question}");
    }
    assert!(answer("not JSON").contains("error"));
}

#[test]
fn the_faults_of_a_description_are_findings() {
    let robot = json!({ "name": "own.toml", "text": "legs = 0\n" });
    let answer =
        answered(&json!({ "task": "check", "program": program("3.1\nx\nEND\n"), "robot": robot }));
    assert!(answer["findings"][0]["file"] == "own.toml", "{answer}");
}
