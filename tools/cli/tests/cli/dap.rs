//! `tip dap`: sessions as an editor has them, and messages that no editor sends.

mod client;

use crate::support::Folder;
pub(crate) use client::Client;
use serde_json::{Value, json};

const PROGRAM: &str = "3.1
歩く
DEF_VAR N
DEF_POS P // tip: allow(W102)
N = 0
L:
N += 1;　MESSAGE あ %N%
IF N < 40 GOTO L:
TEACH_POS F1 P
SLEEP 100
END
";

fn thread() -> Value {
    json!({ "threadId": 1 })
}

fn folder(name: &str) -> (Folder, String) {
    let folder = Folder::new(name).file("walk.prg", PROGRAM);
    let path = folder.path("walk.prg").display().to_string();
    (folder, path)
}

#[test]
fn a_session_goes_forwards_and_back() {
    let (_folder, path) = folder("dap-session");
    let mut client = Client::launched(&path, Value::Null);
    let breakpoints = json!([{ "line": 8, "condition": "N >= 10", "hitCondition": "% 2" }, { "line": 99 }, { "line": 8, "condition": "N = 1" }]);
    let source = json!({ "path": path });
    let placed = client.ask(
        "setBreakpoints",
        json!({ "source": source, "breakpoints": breakpoints }),
    );
    let verified: Vec<_> = placed["breakpoints"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|one| one["verified"].clone())
        .collect();
    assert_eq!(verified, [true, false, false]);
    assert_eq!(client.begin()["reason"], "entry");
    assert_eq!(client.go("continue", thread()).1, 8);
    assert_eq!(client.value("N"), "11");
    assert_eq!(
        client.go("continue", thread()),
        ("breakpoint".to_owned(), 8, 1)
    );
    assert_eq!(client.value("N * 2"), "26");
    assert_eq!(client.go("reverseContinue", thread()).0, "breakpoint");
    assert_eq!(
        (client.value("n"), client.value("N > 11")),
        ("11".to_owned(), "false".to_owned())
    );
    // The second statement of a line; columns are UTF-16 code units.
    assert_eq!(client.go("stepBack", thread()).1, 7);
    let (_, line, column) = client.go("stepBack", thread());
    assert_eq!((line, column), (7, 1));
    // A breakpoint on that second statement; columns are UTF-16 code units.
    let second = json!([{ "line": 7, "column": 9 }]);
    client.ask(
        "setBreakpoints",
        json!({ "source": source, "breakpoints": second }),
    );
    assert_eq!(
        client.go("continue", thread()),
        ("breakpoint".to_owned(), 7, 9)
    );
    // What the program says comes once.
    assert_eq!(client.event("output")["output"], "あ 1\n");
    client.ask("disconnect", Value::Null);
}

#[test]
fn breakpoints_of_another_file_leave_those_of_the_program() {
    let (_folder, path) = folder("dap-files");
    let mut client = Client::launched(&path, Value::Null);
    let set = |path: &str, line: u32| json!({ "source": { "path": path }, "breakpoints": [{ "line": line }] });
    client.ask("setBreakpoints", set(&path, 8));
    // An editor sends the breakpoints of each file that is open.
    let other = path.replace("walk.prg", "turn.prg");
    let placed = client.ask("setBreakpoints", set(&other, 7));
    assert_eq!(placed["breakpoints"][0]["verified"], false);
    client.begin();
    assert_eq!(client.go("continue", thread()).1, 8);
}

#[test]
fn everything_is_said_in_the_language_of_the_client() {
    let (_folder, path) = folder("dap-language");
    let mut client = Client::new();
    let known = client.ask("initialize", json!({ "adapterID": "tip", "locale": "ja" }));
    let filter = &known["exceptionBreakpointFilters"][0];
    assert_eq!(filter["label"], "ロボットの転倒");
    let nothing = client.refusal("threads-of", Value::Null);
    assert!(nothing.contains("threads-of"), "{nothing}");
    let nothing = client.refusal("continue", thread());
    assert_eq!(nothing, "デバッグ中のプログラムがありません");
    client.ask("launch", json!({ "program": path, "stopOnEntry": true }));
    client.begin();
    let scopes = client.ask("scopes", json!({ "frameId": 1 }));
    let scopes = scopes["scopes"].as_array().expect("a list");
    let names: Vec<_> = scopes.iter().map(|scope| scope["name"].clone()).collect();
    assert_eq!(names, ["変数", "ロボット", "制御モードと目標"]);
    for (reference, name, value) in [(1, "N", "未代入"), (2, "時刻", "0 ms"), (3, "J11", "停止")]
    {
        let all = client.ask("variables", json!({ "variablesReference": reference }));
        let all = all["variables"].as_array().expect("a list");
        let one = all.iter().find(|one| one["name"] == name);
        assert_eq!(one.expect("it is shown")["value"], value, "{name}");
    }
    client.ask("continue", thread());
    assert_eq!(
        client.event("stopped")["text"],
        "プログラムは終了しました(END)"
    );
}

#[test]
fn log_points_say_something_between_the_messages_of_the_program() {
    let (_folder, path) = folder("dap-log");
    let mut client = Client::launched(&path, json!({ "stopOnEntry": false }));
    let logs = json!([
        { "line": 7, "column": 9, "logMessage": "N is {N}" },
        { "line": 8, "condition": "N == 2", "logMessage": "{N > 1} {" },
        { "line": 8, "logMessage": "{HEIGHT}" },
    ]);
    let source = json!({ "path": path });
    let placed = client.ask(
        "setBreakpoints",
        json!({ "source": source, "breakpoints": logs }),
    );
    let verified = |place: usize| placed["breakpoints"][place]["verified"].clone();
    assert_eq!([verified(0), verified(1), verified(2)], [true, true, false]);
    assert_eq!(client.begin()["reason"], "pause");
    for (category, output) in [
        ("console", "N is 1\n"),
        ("stdout", "あ 1\n"),
        ("console", "N is 2\n"),
        ("stdout", "あ 2\n"),
        ("console", "true {\n"),
        ("console", "N is 3\n"),
    ] {
        let event = client.event("output");
        assert_eq!(
            (&event["category"], &event["output"]),
            (&json!(category), &json!(output))
        );
    }
    client.ask("disconnect", Value::Null);
}

#[test]
fn the_end_is_a_place_to_go_back_from() {
    let (_folder, path) = folder("dap-end");
    let mut client = Client::launched(&path, json!({ "stopOnEntry": false }));
    let stopped = client.begin();
    assert_eq!(
        (&stopped["reason"], &stopped["text"]),
        (&json!("pause"), &json!("the program is over (END)"))
    );
    let (reason, line, _) = client.go("stepBack", thread());
    assert_eq!((reason.as_str(), line), ("step", 11));
    assert_eq!(client.go("continue", thread()).0, "pause");
    client.ask("continue", thread());
    assert_eq!(client.event("exited")["exitCode"], 0);
    client.event("terminated");
}

#[test]
fn changes_of_the_past_are_confirmed_by_asking_again() {
    let (_folder, path) = folder("dap-change");
    let mut client = Client::launched(&path, Value::Null);
    client.begin();
    let set = json!({ "variablesReference": 1, "name": "N", "value": "30" });
    client.go("next", thread());
    client.ask("setVariable", set.clone());
    assert_eq!(client.value("N"), "30");
    client.go("next", thread());
    client.go("stepBack", thread());
    let change = json!({ "variablesReference": 1, "name": "N", "value": "35" });
    let reported = client.refusal("setVariable", change.clone());
    assert!(
        reported.contains("later cycles that would be discarded: 1"),
        "{reported}"
    );
    assert_eq!(client.ask("setVariable", change)["value"], "35");
    let repl = |expression: &str| json!({ "expression": expression, "context": "repl" });
    client.ask("evaluate", repl("N = 36"));
    client.go("next", thread());
    client.go("stepBack", thread());
    client.refusal("evaluate", repl("key F"));
    client.ask("evaluate", repl("discard key F"));
    assert_eq!(client.go("evaluate", repl("to 20")).0, "goto");
    let reported = client.refusal(
        "setVariable",
        json!({ "variablesReference": 1, "name": "CHAR_A", "value": "1" }),
    );
    assert!(reported.contains("CHAR_A"), "{reported}");
}

#[test]
fn what_does_not_load_is_told_in_the_language_of_the_client() {
    let folder = Folder::new("dap-wrong").program("wrong.prg", "A = 1\nEND");
    let path = folder.path("wrong.prg").display().to_string();
    for (locale, reason) in [("en", "is not declared"), ("ja", "宣言")] {
        let mut client = Client::new();
        client.ask(
            "initialize",
            json!({ "adapterID": "tip", "locale": locale }),
        );
        let reported = client.refusal("launch", json!({ "program": path }));
        assert!(
            reported.contains("wrong.prg:3:1") && reported.contains(reason),
            "{reported}"
        );
    }
}

#[test]
fn a_bad_message_is_answered_and_the_session_goes_on() {
    let (_folder, path) = folder("dap-bad");
    let mut client = Client::launched(&path, Value::Null);
    for message in [
        "",
        "{",
        "[]",
        "3",
        "{}",
        "{\"type\":\"request\"}",
        "{\"type\":\"request\",\"seq\":\"a\",\"command\":1}",
        "\u{0}",
    ] {
        client.send(message);
        let response = client.response();
        assert_eq!(
            (&response["success"], &response["request_seq"]),
            (&json!(false), &json!(0)),
            "{message:?}"
        );
    }
    client.raw(b"Content-Length: x\r\n\r\n");
    assert_eq!(client.response()["success"], false);
    // Answers and events are nothing that an adapter asked for.
    client.send("{\"type\":\"event\",\"seq\":1,\"event\":\"x\"}");
    for (command, arguments) in [
        ("dance", Value::Null),
        ("launch", json!({ "program": path })),
        ("attach", json!({})),
        ("setBreakpoints", json!({ "source": 3 })),
        ("stackTrace", json!([])),
        ("variables", json!({ "variablesReference": -7 })),
        ("variables", json!({ "variablesReference": i64::MIN })),
        ("setVariable", json!({ "name": "N" })),
        ("evaluate", json!({ "expression": "" })),
        ("exceptionInfo", thread()),
        ("stepIn", json!({ "granularity": 3 })),
    ] {
        client.refusal(command, arguments);
    }
    let far = json!([{ "line": i64::MAX }, { "line": i64::MIN }, { "line": 0 }]);
    client.ask(
        "setBreakpoints",
        json!({ "source": { "path": path }, "breakpoints": far }),
    );
    client.begin();
    assert_eq!(client.value("N"), "unassigned");
}

#[test]
fn a_program_that_runs_is_paused_and_shows_nothing_while_it_runs() {
    let folder = Folder::new("dap-pause").program("endless.prg", "L:\nGOTO L:\nEND");
    let path = folder.path("endless.prg").display().to_string();
    let mut client = Client::launched(&path, Value::Null);
    client.begin();
    client.ask("continue", thread());
    assert!(client.refusal("stackTrace", thread()).contains("running"));
    client.ask("pause", thread());
    assert_eq!(client.event("stopped")["reason"], "pause");
    client.ask("stackTrace", thread());
    client.ask("continue", thread());
    client.ask("terminate", Value::Null);
    client.event("terminated");
}

#[test]
#[cfg(unix)]
fn breakpoints_bind_by_whatever_path_leads_to_the_program() {
    let (folder, path) = folder("dap-paths");
    std::os::unix::fs::symlink(&path, folder.path("link.prg")).expect("a link");
    std::fs::create_dir(folder.path("x")).expect("a folder");
    for other in ["link.prg", "x/../walk.prg"] {
        let mut client = Client::launched(&path, Value::Null);
        let other = folder.path(other).display().to_string();
        let asked = json!({ "source": { "path": other }, "breakpoints": [{ "line": 8 }] });
        let placed = client.ask("setBreakpoints", asked);
        assert_eq!(placed["breakpoints"][0]["verified"], true, "{other}");
        client.begin();
        assert_eq!(client.go("continue", thread()).1, 8);
        client.ask("disconnect", Value::Null);
    }
}

#[test]
fn a_restart_loads_the_program_again_and_keeps_its_breakpoints() {
    let (folder, path) = folder("dap-restart");
    let mut client = Client::launched(&path, Value::Null);
    let source = json!({ "path": path });
    let asked = |lines: Value| json!({ "source": source, "breakpoints": lines });
    client.ask("setBreakpoints", asked(json!([{ "line": 5 }])));
    let lines = json!([{ "line": 99 }, { "line": 8, "condition": "N > 2" }]);
    let placed = client.ask("setBreakpoints", asked(lines))["breakpoints"].clone();
    // Also one that is not placed has a number, for it may be placed in a program that is loaded again.
    let numbers = [&placed[0]["id"], &placed[1]["id"]];
    assert!(numbers[0] != numbers[1] && numbers.iter().all(|it| it.is_u64()));
    client.begin();
    client.ask("continue", thread());
    assert_eq!(
        client.event("stopped")["hitBreakpointIds"],
        json!([numbers[1]])
    );
    assert_eq!(client.value("N"), "3");
    let folder = folder.file("walk.prg", PROGRAM.replace("N += 1", "N += 2"));
    client.ask("restart", json!({}));
    for before in [&placed[0], &placed[1]] {
        let now = client.event("breakpoint");
        assert_eq!(
            (&now["reason"], &now["breakpoint"]),
            (&json!("changed"), before)
        );
    }
    assert_eq!(client.event("stopped")["reason"], "entry");
    client.ask("continue", thread());
    assert_eq!(
        client.event("stopped")["hitBreakpointIds"],
        json!([numbers[1]])
    );
    assert_eq!(
        (client.value("N"), client.value("N > 2")),
        ("4".to_owned(), "true".to_owned())
    );
    // With errors it is refused, and the program of before stays.
    let _folder = folder.file("walk.prg", PROGRAM.replace("N += 1", "N ++"));
    let refused = client.refusal("restart", json!({}));
    assert!(refused.contains("walk.prg:7:"), "{refused}");
    assert_eq!(client.value("N"), "4");
    client.ask("disconnect", Value::Null);
}

/// Two threads, whose steps are on lines of their own. Main program: line 6 in cycle 2, then 7 to 9 in turn. Thread: 11 in
/// cycle 3, 12, 13 in cycle 5, 14 in cycles 6 and 7, 15, 12 in cycle 9.
const TWO: &str = "3.2
two
DEF_VAR A, B
A = 0
B = 0
START_THREAD SIDE:
L:
A += 1
IF A < 20 GOTO L:
EXIT
THREAD SIDE:
AGAIN:
B += 1
SLEEP 40
GOTO AGAIN:
THREADEND
END
";

#[test]
fn a_thread_of_the_program_is_a_thread_of_the_protocol() {
    let folder = Folder::new("dap-threads").file("two.prg", TWO);
    let path = folder.path("two.prg").display().to_string();
    let mut client = Client::launched(&path, Value::Null);
    let source = json!({ "path": path });
    client.ask(
        "setBreakpoints",
        json!({ "source": source, "breakpoints": [{ "line": 13 }] }),
    );
    client.begin();
    let threads = client.ask("threads", Value::Null);
    assert_eq!(threads["threads"], json!([{ "id": 1, "name": "two.prg" }]));
    client.ask("continue", thread());
    let stopped = client.event("stopped");
    assert_eq!(
        (&stopped["reason"], &stopped["threadId"]),
        (&json!("breakpoint"), &json!(2))
    );
    let threads = client.ask("threads", Value::Null);
    assert_eq!(threads["threads"][1], json!({ "id": 2, "name": "SIDE" }));
    let top = |client: &mut Client, thread: i64| {
        let stack = client.ask("stackTrace", json!({ "threadId": thread }));
        let frame = stack["stackFrames"][0].clone();
        (frame["name"].clone(), frame["line"].clone())
    };
    // Before cycle 5.
    assert_eq!(top(&mut client, 1), (json!("two"), json!(9)));
    assert_eq!(top(&mut client, 2), (json!("SIDE"), json!(13)));
    for (request, of, line) in [
        ("next", 2, 14),
        ("next", 2, 15),
        ("next", 1, 7),
        ("stepBack", 2, 15),
        ("stepBack", 2, 14),
    ] {
        client.ask(request, json!({ "threadId": of }));
        assert_eq!(client.event("stopped")["threadId"], of, "{request}");
        assert_eq!(top(&mut client, of).1, line, "{request} {of}");
    }
    client.ask("reverseContinue", thread());
    assert_eq!(client.event("stopped")["threadId"], 2);
    assert_eq!(top(&mut client, 2).1, 13);
    assert_eq!(client.value("B"), "0");
    client.ask("disconnect", Value::Null);
}
