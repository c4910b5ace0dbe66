//! `tipc dap`: sessions as an editor has them, and messages that no editor sends.

use crate::support::Folder;
use serde_json::{Value, json};
use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

const PROGRAM: &str = "3.1
歩く
DEF_VAR N
DEF_POS P
N = 0
L:
N += 1;　MESSAGE あ %N%
IF N < 40 GOTO L:
TEACH_POS F1 P
SLEEP 100
END
";

/// An adapter, and what it has sent that nobody has read.
pub(crate) struct Client {
    adapter: Child,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    events: VecDeque<Value>,
    seq: i64,
}

impl Client {
    pub(crate) fn new() -> Self {
        let mut adapter = Command::new(env!("CARGO_BIN_EXE_tipc"))
            .arg("dap")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("tipc runs");
        let output = BufReader::new(adapter.stdout.take().expect("it is a pipe"));
        Client {
            input: adapter.stdin.take(),
            output,
            adapter,
            events: VecDeque::new(),
            seq: 0,
        }
    }

    /// A program that stands before its first step.
    fn launched(program: &str, more: Value) -> Self {
        let mut client = Client::new();
        let capabilities = client.ask("initialize", json!({ "adapterID": "tip" }));
        assert_eq!(capabilities["supportsStepBack"], true);
        assert_eq!(capabilities["supportsLogPoints"], true);
        let mut launch = json!({ "program": program, "stopOnEntry": true });
        for (name, value) in more.as_object().into_iter().flatten() {
            launch[name] = value.clone();
        }
        client.ask("launch", launch);
        client.event("initialized");
        client
    }

    fn begin(&mut self) -> Value {
        self.ask("configurationDone", Value::Null);
        self.event("stopped")
    }

    fn raw(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("it is open");
        input.write_all(bytes).expect("it listens");
        input.flush().expect("it listens");
    }

    fn send(&mut self, message: &str) {
        self.raw(format!("Content-Length: {}\r\n\r\n{message}", message.len()).as_bytes());
    }

    fn read(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            self.output.read_line(&mut line).expect("it answers");
            assert!(!line.is_empty(), "the adapter has gone");
            match line.trim().strip_prefix("Content-Length: ") {
                Some(number) => length = number.parse().expect("a length"),
                None => break,
            }
        }
        let mut message = vec![0; length];
        self.output.read_exact(&mut message).expect("it answers");
        serde_json::from_slice(&message).expect("JSON")
    }

    /// The answer to the next request; events are kept.
    fn response(&mut self) -> Value {
        loop {
            let message = self.read();
            match message["type"].as_str() {
                Some("response") => return message,
                _ => self.events.push_back(message),
            }
        }
    }

    fn request(&mut self, command: &str, arguments: Value) -> Value {
        self.seq += 1;
        let request = json!({ "seq": self.seq, "type": "request", "command": command, "arguments": arguments });
        self.send(&request.to_string());
        let response = self.response();
        assert_eq!(
            (&response["request_seq"], &response["command"]),
            (&json!(self.seq), &json!(command))
        );
        response
    }

    pub(crate) fn ask(&mut self, command: &str, arguments: Value) -> Value {
        let response = self.request(command, arguments);
        assert_eq!(response["success"], true, "{response}");
        response["body"].clone()
    }

    pub(crate) fn refusal(&mut self, command: &str, arguments: Value) -> String {
        let response = self.request(command, arguments);
        assert_eq!(response["success"], false, "{response}");
        response["message"].as_str().expect("a reason").to_owned()
    }

    /// The next event of a name; others stay to be asked for.
    fn event(&mut self, name: &str) -> Value {
        loop {
            let mut events = self.events.iter();
            if let Some(place) = events.position(|event| event["event"] == name) {
                let event = self.events.remove(place).expect("it is there");
                return event["body"].clone();
            }
            let message = self.read();
            self.events.push_back(message);
        }
    }

    /// Moves, and says why it stands and on which line and column.
    fn go(&mut self, command: &str, arguments: Value) -> (String, i64, i64) {
        self.ask(command, arguments);
        let stopped = self.event("stopped");
        let frames = self.ask("stackTrace", json!({ "threadId": 1 }));
        let place = |of: &str| frames["stackFrames"][0][of].as_i64().expect("a number");
        let reason = stopped["reason"].as_str().expect("a reason").to_owned();
        (reason, place("line"), place("column"))
    }

    fn value(&mut self, expression: &str) -> String {
        let body = self.ask(
            "evaluate",
            json!({ "expression": expression, "context": "watch" }),
        );
        body["result"].as_str().expect("a text").to_owned()
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        // The adapter ends when nobody is there any more.
        self.input = None;
        let status = self.adapter.wait().expect("it ends");
        if !std::thread::panicking() {
            assert!(status.success(), "{status}");
        }
    }
}

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
    let told = client.refusal("setVariable", change.clone());
    assert!(
        told.contains("1 cycles have been run after this one"),
        "{told}"
    );
    assert_eq!(client.ask("setVariable", change)["value"], "35");
    let repl = |expression: &str| json!({ "expression": expression, "context": "repl" });
    client.ask("evaluate", repl("N = 36"));
    client.go("next", thread());
    client.go("stepBack", thread());
    client.refusal("evaluate", repl("key F"));
    client.ask("evaluate", repl("discard key F"));
    assert_eq!(client.go("evaluate", repl("to 20")).0, "goto");
    let told = client.refusal(
        "setVariable",
        json!({ "variablesReference": 1, "name": "CHAR_A", "value": "1" }),
    );
    assert!(told.contains("CHAR_A"), "{told}");
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
        let told = client.refusal("launch", json!({ "program": path }));
        assert!(
            told.contains("wrong.prg:3:1") && told.contains(reason),
            "{told}"
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
