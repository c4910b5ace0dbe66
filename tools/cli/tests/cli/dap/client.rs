//! A client of `tip dap`, as far as tests need one.

use serde_json::{Value, json};
use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

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
        let mut adapter = Command::new(env!("CARGO_BIN_EXE_tip"))
            .arg("dap")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("tip runs");
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
    pub(crate) fn launched(program: &str, more: Value) -> Self {
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

    pub(crate) fn begin(&mut self) -> Value {
        self.ask("configurationDone", Value::Null);
        self.event("stopped")
    }

    pub(crate) fn raw(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("it is open");
        input.write_all(bytes).expect("it listens");
        input.flush().expect("it listens");
    }

    pub(crate) fn send(&mut self, message: &str) {
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
    pub(crate) fn response(&mut self) -> Value {
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
    pub(crate) fn event(&mut self, name: &str) -> Value {
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
    pub(crate) fn go(&mut self, command: &str, arguments: Value) -> (String, i64, i64) {
        self.ask(command, arguments);
        let stopped = self.event("stopped");
        let frames = self.ask("stackTrace", json!({ "threadId": 1 }));
        let place = |of: &str| frames["stackFrames"][0][of].as_i64().expect("a number");
        let reason = stopped["reason"].as_str().expect("a reason").to_owned();
        (reason, place("line"), place("column"))
    }

    pub(crate) fn value(&mut self, expression: &str) -> String {
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
