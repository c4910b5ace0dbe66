//! `tipc lsp`, as an editor talks to it: columns of three encodings, sessions from beginning to end, and bad messages.

use crate::support::Folder;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// Full width, half-width kana, a surrogate pair, CRLF and a tab.
const TEXT: &str = "3.1\r\n歩くｱ🤖\r\nDEF_VAR STRIDE // 歩幅ｱ🤖\r\nSTRIDE = 40\r\n\tMESSAGE ｱ歩🤖 %STRIDE% mm %STRIDE%\r\n\
                    SLEP　STRIDE\r\nIF KB_HIT\r\nREM\r\nENDIF\r\nEND\r\n";

const URI: &str = "file:///robot/walk.prg";

/// The columns of an encoding.
#[derive(Clone, Copy, Debug)]
struct Encoding {
    name: &'static str,
    length: fn(char) -> usize,
}

const ENCODINGS: [Encoding; 3] = [
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
struct Editor {
    process: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    encoding: Encoding,
    text: String,
    asked: i64,
    version: i64,
}

impl Editor {
    fn start(folder: &Folder, encoding: Encoding, options: Value) -> Self {
        let mut process = Command::new(env!("CARGO_BIN_EXE_tipc"))
            .args(["lsp", "--stdio"])
            .env("XDG_CACHE_HOME", folder.path("cache"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("tipc starts");
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
            "textDocument": {
                "publishDiagnostics": { "relatedInformation": true, "codeDescriptionSupport": true },
            },
        });
        let params = json!({
            "processId": null, "rootUri": null, "capabilities": capabilities, "initializationOptions": options,
        });
        let answer = editor.ask("initialize", params).expect("it begins");
        assert_eq!(answer["capabilities"]["positionEncoding"], encoding.name);
        editor.tell("initialized", json!({}));
        editor
    }

    fn send(&mut self, message: &[u8]) {
        let written = write!(self.input, "Content-Length: {}\r\n\r\n", message.len());
        let written = written.and_then(|()| self.input.write_all(message));
        written
            .and_then(|()| self.input.flush())
            .expect("it listens");
    }

    fn receive(&mut self) -> Value {
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

    fn tell(&mut self, method: &str, params: Value) {
        let message = json!({ "jsonrpc": "2.0", "method": method, "params": params });
        self.send(message.to_string().as_bytes());
    }

    /// The result, or the error; findings in between are passed over.
    fn ask(&mut self, method: &str, params: Value) -> Result<Value, Value> {
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

    fn open(&mut self, text: &str) -> Vec<Value> {
        self.text = text.to_owned();
        let item = json!({ "uri": URI, "languageId": "tip", "version": 0, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": item }));
        self.findings()
    }

    /// The next findings that are sent.
    fn findings(&mut self) -> Vec<Value> {
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

    fn position(&self, offset: usize) -> Value {
        let before = &self.text[..offset];
        let start = before.rfind('\n').map_or(0, |at| at + 1);
        let column: usize = before[start..].chars().map(self.encoding.length).sum();
        json!({ "line": before.matches('\n').count(), "character": column })
    }

    fn offset(&self, position: &Value) -> usize {
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

    fn slice(&self, range: &Value) -> &str {
        &self.text[self.offset(&range["start"])..self.offset(&range["end"])]
    }

    /// Asks at the nth place of a text.
    fn at(&mut self, method: &str, word: &str, nth: usize, more: Value) -> Result<Value, Value> {
        let (at, _) = self
            .text
            .match_indices(word)
            .nth(nth)
            .expect("it stands there");
        let mut params = json!({ "textDocument": { "uri": URI }, "position": self.position(at) });
        for (name, value) in more.as_object().into_iter().flatten() {
            params[name] = value.clone();
        }
        self.ask(method, params)
    }

    /// Changes the text as an edit says, here and there; what is found then.
    fn apply(&mut self, edit: &Value) -> Vec<Value> {
        let edits = edit["changes"][URI]
            .as_array()
            .expect("edits of this file")
            .clone();
        self.change(edits)
    }

    /// Edits from the last to the first, so that none moves another.
    fn change(&mut self, mut edits: Vec<Value>) -> Vec<Value> {
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
        self.findings()
    }

    fn end(mut self) -> i32 {
        self.ask("shutdown", Value::Null).expect("it ends");
        self.tell("exit", Value::Null);
        let status = self.process.wait().expect("it was started");
        status.code().expect("no signal")
    }
}

fn codes(found: &[Value]) -> Vec<&str> {
    found
        .iter()
        .map(|one| one["code"].as_str().expect("a code"))
        .collect()
}

/// What a session comes to, without columns.
fn session(editor: &mut Editor) -> Vec<String> {
    let mut log = Vec::new();
    for found in editor.open(TEXT) {
        let (code, slice) = (&found["code"], editor.slice(&found["range"]));
        log.push(format!("{code} {slice:?} {}", found["message"]));
        let page = found["codeDescription"]["href"]
            .as_str()
            .expect("an address");
        assert!(page.ends_with(&format!("/en/{}.md", code.as_str().expect("a code"))));
    }
    let hover = editor
        .at("textDocument/hover", "STRIDE", 3, json!({}))
        .expect("an answer");
    log.push(format!("hover {:?}", editor.slice(&hover["range"])));
    let context = json!({ "context": { "includeDeclaration": true } });
    let found = editor
        .at("textDocument/references", "STRIDE", 4, context)
        .expect("an answer");
    for place in found.as_array().expect("a list") {
        log.push(format!("reference {:?}", editor.slice(&place["range"])));
    }
    let edit = editor.at(
        "textDocument/rename",
        "STRIDE",
        3,
        json!({ "newName": "LENGTH" }),
    );
    let found = editor.apply(&edit.expect("a change"));
    log.push(format!("renamed {:?} {:?}", editor.text, codes(&found)));
    for word in ["SLEP", "\r\nREM"] {
        let at = editor.text.find(word).expect("it stands there");
        let place = editor.position(at);
        let params = json!({
            "textDocument": { "uri": URI }, "range": { "start": place, "end": place },
            "context": { "diagnostics": [] },
        });
        let actions = editor
            .ask("textDocument/codeAction", params)
            .expect("an answer");
        let action = &actions[0];
        let found = editor.apply(&action["edit"]);
        log.push(format!("{} {:?}", action["title"], codes(&found)));
    }
    let options = json!({ "textDocument": { "uri": URI }, "options": { "tabSize": 2, "insertSpaces": true } });
    let edits = editor
        .ask("textDocument/formatting", options)
        .expect("a program");
    let found = editor.change(edits.as_array().expect("edits").clone());
    log.push(format!("formatted {:?} {:?}", editor.text, codes(&found)));
    let whole = json!({ "textDocument": { "uri": URI } });
    let tokens = editor
        .ask("textDocument/semanticTokens/full", whole)
        .expect("an answer");
    let numbers: Vec<u64> = tokens["data"]
        .as_array()
        .map(|all| all.iter().filter_map(Value::as_u64).collect())
        .expect("a list");
    let (mut line, mut column) = (0, 0);
    for token in numbers.chunks(5) {
        column = if token[0] > 0 {
            token[1]
        } else {
            column + token[1]
        };
        line += token[0];
        let place = |column| json!({ "line": line, "character": column });
        let range = json!({ "start": place(column), "end": place(column + token[2]) });
        log.push(format!(
            "{:?} {} {}",
            editor.slice(&range),
            token[3],
            token[4]
        ));
    }
    log
}

#[test]
fn answers_are_the_same_in_every_encoding() {
    let folder = Folder::new("lsp-encodings");
    let logs = ENCODINGS.map(|encoding| {
        let mut editor = Editor::start(&folder, encoding, Value::Null);
        let log = session(&mut editor);
        assert_eq!(editor.end(), 0);
        log
    });
    assert_eq!(logs[0], logs[1]);
    assert_eq!(logs[1], logs[2]);
    let log = &logs[0];
    assert_eq!(
        log[0],
        "\"E204-01\" \"SLEP\" \"`SLEP` is not a command\\ndid you mean `SLEEP`?\""
    );
    let renamed = TEXT.replace("STRIDE", "LENGTH");
    assert!(
        log.contains(&format!("renamed {renamed:?} [\"E204-01\", \"E205-17\"]")),
        "{log:#?}"
    );
    let formatted = "3.1\r\n歩くｱ🤖\r\nDEF_VAR LENGTH  // 歩幅ｱ🤖\r\nLENGTH = 40\r\nMESSAGE ｱ歩🤖 %LENGTH% mm %LENGTH%\r\n\
                     SLEEP LENGTH\r\nIF KB_HIT THEN\r\n  REM\r\nENDIF\r\nEND\r\n";
    assert!(
        log.contains(&format!("formatted {formatted:?} []")),
        "{log:#?}"
    );
    assert_eq!(
        log.iter()
            .filter(|line| *line == "reference \"STRIDE\"")
            .count(),
        5
    );
    assert!(log.contains(&"\"ｱ歩🤖 %\" 10 0".to_owned()), "{log:#?}");
}

#[test]
fn a_bad_message_gets_an_error_and_the_session_goes_on() {
    let folder = Folder::new("lsp-bad");
    let mut editor = Editor::start(&folder, ENCODINGS[1], Value::Null);
    editor.open("3.1\nTitle\nEND\n");
    let code = |answer: Result<Value, Value>| answer.expect_err("an error")["code"].clone();
    assert_eq!(code(editor.ask("textDocument/dance", json!({}))), -32601);
    assert_eq!(code(editor.ask("textDocument/hover", json!([1]))), -32602);
    let elsewhere = json!({ "textDocument": { "uri": "file:///none" }, "position": { "line": 0, "character": 0 } });
    assert_eq!(code(editor.ask("textDocument/hover", elsewhere)), -32602);
    assert_eq!(code(editor.ask("initialize", json!({}))), -32600);
    editor.send(b"{");
    assert_eq!(editor.receive()["error"]["code"], -32700);
    editor.send(br#"{"jsonrpc":"2.0","id":{},"method":"shutdown"}"#);
    assert_eq!(editor.receive()["error"]["code"], -32700);
    editor.tell("textDocument/didChange", json!({ "contentChanges": 7 }));
    let beyond = json!({ "textDocument": { "uri": URI }, "position": { "line": 4_294_967_295_u32, "character": 4_294_967_295_u32 } });
    assert_eq!(editor.ask("textDocument/hover", beyond), Ok(Value::Null));
    assert_eq!(editor.end(), 0);
}

#[test]
fn the_robot_is_that_of_the_settings() {
    let folder = Folder::new("lsp-robot");
    let text = "3.1\nTitle\nDEF_VAR T\nTEACH_TORQUE J11 T\nSLEEP T\nEND\n";
    let mut editor = Editor::start(&folder, ENCODINGS[1], Value::Null);
    assert_eq!(codes(&editor.open(text)), ["E204-02"]);
    let settings = json!({ "settings": { "tip": { "robot": "hand" } } });
    editor.tell("workspace/didChangeConfiguration", settings);
    assert_eq!(codes(&editor.findings()), [""; 0]);
    assert_eq!(editor.end(), 0);
    let mut editor = Editor::start(&folder, ENCODINGS[1], json!({ "robot": "hand" }));
    assert_eq!(codes(&editor.open(text)), [""; 0]);
    assert_eq!(editor.end(), 0);
}

#[test]
fn an_editor_that_goes_away_ends_the_server() {
    let folder = Folder::new("lsp-gone");
    let mut editor = Editor::start(&folder, ENCODINGS[0], Value::Null);
    editor.tell("exit", Value::Null);
    assert_eq!(
        editor.process.wait().expect("it was started").code(),
        Some(1)
    );
    let Editor {
        mut process, input, ..
    } = Editor::start(&folder, ENCODINGS[0], Value::Null);
    drop(input);
    assert_eq!(process.wait().expect("it was started").code(), Some(1));
}
