//! An editor with one text, as `tip lsp` sees it.

use crate::support::Folder;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

pub(super) const URI: &str = "file:///robot/walk.prg";

/// The columns of an encoding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encoding {
    name: &'static str,
    length: fn(char) -> usize,
}

pub(super) const ENCODINGS: [Encoding; 3] = [
    Encoding {
        name: "utf-8",
        length: char::len_utf8,
    },
    Encoding {
        name: "utf-16",
        length: char::len_utf16,
    },
    Encoding {
        name: "utf-32",
        length: |_| 1,
    },
];

/// An editor with one text.
pub(super) struct Editor {
    pub(super) process: Child,
    pub(super) input: ChildStdin,
    output: BufReader<ChildStdout>,
    encoding: Encoding,
    pub(super) text: String,
    asked: i64,
    version: i64,
}

impl Editor {
    pub(super) fn start(folder: &Folder, encoding: Encoding, options: Value) -> Self {
        let more = json!({ "initializationOptions": options });
        Editor::with(folder, encoding, json!({}), more)
    }

    /// One that can more in its workspace, and says more of itself.
    pub(super) fn with(folder: &Folder, encoding: Encoding, workspace: Value, more: Value) -> Self {
        let mut process = Command::new(env!("CARGO_BIN_EXE_tip"))
            .args(["lsp", "--stdio"])
            .env("XDG_CACHE_HOME", folder.path("cache"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("tip starts");
        let mut editor = Editor {
            input: process.stdin.take().expect("a pipe"),
            output: BufReader::new(process.stdout.take().expect("a pipe")),
            process,
            encoding,
            text: String::new(),
            asked: 0,
            version: 0,
        };
        let capabilities = json!({
            "general": { "positionEncodings": [encoding.name] },
            "workspace": workspace,
            "textDocument": {
                "publishDiagnostics": { "relatedInformation": true, "codeDescriptionSupport": true },
            },
        });
        let mut params =
            json!({ "processId": null, "rootUri": null, "capabilities": capabilities });
        for (name, value) in more.as_object().into_iter().flatten() {
            params[name] = value.clone();
        }
        let answer = editor.ask("initialize", params).expect("it begins");
        assert_eq!(answer["capabilities"]["positionEncoding"], encoding.name);
        editor.tell("initialized", json!({}));
        editor
    }

    pub(super) fn send(&mut self, message: &[u8]) {
        let written = write!(self.input, "Content-Length: {}\r\n\r\n", message.len());
        let written = written.and_then(|()| self.input.write_all(message));
        written
            .and_then(|()| self.input.flush())
            .expect("it listens");
    }

    pub(super) fn receive(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            self.output.read_line(&mut line).expect("it speaks");
            match line.trim().split_once(": ") {
                Some((_, number)) => length = number.parse().expect("a length"),
                None => break,
            }
        }
        let mut bytes = vec![0; length];
        self.output.read_exact(&mut bytes).expect("a whole message");
        serde_json::from_slice(&bytes).expect("JSON")
    }

    pub(super) fn tell(&mut self, method: &str, params: Value) {
        let message = json!({ "jsonrpc": "2.0", "method": method, "params": params });
        self.send(message.to_string().as_bytes());
    }

    /// The result, or the error; findings in between are passed over.
    pub(super) fn ask(&mut self, method: &str, params: Value) -> Result<Value, Value> {
        self.asked += 1;
        let id = self.asked;
        let message = json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params });
        self.send(message.to_string().as_bytes());
        loop {
            let mut answer = self.receive();
            if answer["id"] == id {
                return match answer.get("error") {
                    Some(error) => Err(error.clone()),
                    None => Ok(answer["result"].take()),
                };
            }
        }
    }

    pub(super) fn open(&mut self, text: &str) -> Vec<Value> {
        self.text = text.to_owned();
        let item = json!({ "uri": URI, "languageId": "tip", "version": 0, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": item }));
        self.diagnostics()
    }

    /// The next findings that are sent.
    pub(super) fn diagnostics(&mut self) -> Vec<Value> {
        loop {
            let message = self.receive();
            if message["method"] == "textDocument/publishDiagnostics" {
                assert_eq!(message["params"]["uri"], URI);
                assert_eq!(message["params"]["version"], self.version);
                let found = message["params"]["diagnostics"].as_array();
                return found.expect("a list").clone();
            }
        }
    }

    pub(super) fn position(&self, offset: usize) -> Value {
        let before = &self.text[..offset];
        let start = before.rfind('\n').map_or(0, |at| at + 1);
        let column: usize = before[start..].chars().map(self.encoding.length).sum();
        json!({ "line": before.matches('\n').count(), "character": column })
    }

    pub(super) fn offset(&self, position: &Value) -> usize {
        let number = |name: &str| position[name].as_u64().expect("a number") as usize;
        let line = self
            .text
            .split_inclusive('\n')
            .nth(number("line"))
            .unwrap_or_default();
        let start = line.as_ptr() as usize - self.text.as_ptr() as usize;
        let mut column = 0;
        let mut at = 0;
        for char in line.chars() {
            if column >= number("character") {
                break;
            }
            column += (self.encoding.length)(char);
            at += char.len_utf8();
        }
        assert_eq!(column, number("character"), "a column inside a character");
        if line.is_empty() {
            self.text.len()
        } else {
            start + at
        }
    }

    pub(super) fn slice(&self, range: &Value) -> &str {
        &self.text[self.offset(&range["start"])..self.offset(&range["end"])]
    }

    /// Asks at the nth place of a text.
    pub(super) fn at(
        &mut self,
        method: &str,
        word: &str,
        nth: usize,
        more: Value,
    ) -> Result<Value, Value> {
        let (at, _) = self
            .text
            .match_indices(word)
            .nth(nth)
            .expect("the text has it");
        let mut params = json!({ "textDocument": { "uri": URI }, "position": self.position(at) });
        for (name, value) in more.as_object().into_iter().flatten() {
            params[name] = value.clone();
        }
        self.ask(method, params)
    }

    /// Changes the text as an edit says, here and there; what is found then.
    pub(super) fn apply(&mut self, edit: &Value) -> Vec<Value> {
        let edits = edit["changes"][URI]
            .as_array()
            .expect("edits of this file")
            .clone();
        self.change(edits)
    }

    /// Edits from the last to the first, so that none moves another.
    pub(super) fn change(&mut self, mut edits: Vec<Value>) -> Vec<Value> {
        edits.sort_by_key(|edit| std::cmp::Reverse(self.offset(&edit["range"]["start"])));
        let mut changes = Vec::new();
        for edit in edits {
            let (start, end) = (&edit["range"]["start"], &edit["range"]["end"]);
            let place = self.offset(start)..self.offset(end);
            let new = edit["newText"].as_str().expect("a text");
            changes.push(json!({ "range": edit["range"], "text": new }));
            self.text.replace_range(place, new);
        }
        self.version += 1;
        let document = json!({ "uri": URI, "version": self.version });
        let params = json!({ "textDocument": document, "contentChanges": changes });
        self.tell("textDocument/didChange", params);
        self.diagnostics()
    }

    pub(super) fn end(mut self) -> i32 {
        self.ask("shutdown", Value::Null).expect("it ends");
        self.tell("exit", Value::Null);
        let status = self.process.wait().expect("it was started");
        status.code().expect("no signal")
    }
}
