//! `tip lsp`, as an editor talks to it: columns of three encodings, sessions from beginning to end, and bad messages.

mod editor;

use crate::support::Folder;
use editor::{ENCODINGS, Editor, URI};
use serde_json::{Value, json};

/// Full width, half-width kana, a surrogate pair, CRLF and a tab.
const TEXT: &str = "3.1\r\n歩くｱ🤖\r\nDEF_VAR STRIDE // 歩幅ｱ🤖\r\nSTRIDE = 40\r\n\tMESSAGE ｱ歩🤖 %STRIDE% mm %STRIDE%\r\n\
                    SLEP　STRIDE\r\nIF KB_HIT\r\nREM\r\nENDIF\r\nEND\r\n";

fn codes(found: &[Value]) -> Vec<&str> {
    found
        .iter()
        .map(|one| one["code"].as_str().expect("a code"))
        .collect()
}

/// Returns the results of a session, without columns.
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
        let at = editor.text.find(word).expect("the text has it");
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
fn diagnostics_that_are_omitted_are_counted_at_the_last_one() {
    let folder = Folder::new("lsp-omitted");
    let mut editor = Editor::start(&folder, ENCODINGS[1], Value::Null);
    let found = editor.open(&format!("3.1\nTitle\n{}END\n", "FOO\n".repeat(1_500)));
    assert_eq!(found.len(), 1_001);
    assert_eq!(found[1_000]["severity"], 3);
    assert_eq!(found[1_000]["message"], "... and 500 more findings");
    assert_eq!(found[1_000]["range"], found[999]["range"]);
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
    assert_eq!(codes(&editor.diagnostics()), [""; 0]);
    assert_eq!(editor.end(), 0);
    let mut editor = Editor::start(&folder, ENCODINGS[1], json!({ "robot": "hand" }));
    assert_eq!(codes(&editor.open(text)), [""; 0]);
    assert_eq!(editor.end(), 0);
}

#[test]
fn a_broken_tip_toml_is_complained_of_until_the_editor_says_that_it_has_changed() {
    let text = "3.1\nTitle\nDEF_VAR T\nTEACH_TORQUE J11 T\nSLEEP T\nEND\n";
    let folder = Folder::new("lsp-toml")
        .file("tip.toml", "robot = 3\n")
        .file("walk.prg", text);
    let uri = format!("file://{}", folder.path("walk.prg").display());
    let workspace = json!({ "didChangeWatchedFiles": { "dynamicRegistration": true } });
    let more = json!({ "locale": "ja" });
    let mut editor = Editor::with(&folder, ENCODINGS[1], workspace, more);
    let asked = editor.receive();
    assert_eq!(asked["method"], "client/registerCapability");
    let wanted = &asked["params"]["registrations"][0];
    assert_eq!(wanted["method"], "workspace/didChangeWatchedFiles");
    let answer = json!({ "jsonrpc": "2.0", "id": asked["id"], "result": null });
    editor.send(answer.to_string().as_bytes());
    let item = json!({ "uri": uri, "languageId": "tip", "version": 0, "text": text });
    editor.tell("textDocument/didOpen", json!({ "textDocument": item }));
    let found = editor.receive()["params"]["diagnostics"].take();
    assert_eq!(found[0]["code"], "E204-02");
    let said = editor.receive()["params"]["message"].take();
    let said = said.as_str().expect("a text");
    assert!(said.contains("tip.toml:1:9") && !said.is_ascii(), "{said}");
    let folder = folder.file("tip.toml", "robot = \"hand\"\n");
    let uri = format!("file://{}", folder.path("tip.toml").display());
    let changes = json!({ "changes": [{ "uri": uri, "type": 2 }] });
    editor.tell("workspace/didChangeWatchedFiles", changes);
    assert_eq!(editor.receive()["params"]["diagnostics"], json!([]));
    assert_eq!(editor.end(), 0);
}

#[test]
fn a_mark_before_the_text_has_a_column_if_the_editor_sends_it() {
    let folder = Folder::new("lsp-mark");
    for encoding in ENCODINGS {
        let mut editor = Editor::start(&folder, encoding, Value::Null);
        let found = editor.open("\u{FEFF}4.0\nTitle\nSLEP 1\nEND\n");
        let slices: Vec<_> = found.iter().map(|it| editor.slice(&it["range"])).collect();
        assert_eq!(slices, ["4.0"], "{encoding:?}");
        let found = editor.open("\u{FEFF}3.1\nTitle\nSLEP 1\nEND\n");
        assert_eq!(editor.slice(&found[0]["range"]), "SLEP", "{encoding:?}");
        assert_eq!(editor.end(), 0);
    }
}

#[test]
fn the_encoding_is_that_of_the_nearest_tip_toml() {
    let said = "[[programs]]\nfiles = \"old/*\"\nencoding = \"shift_jis\"\n";
    let folder = Folder::new("lsp-encoding")
        .file("tip.toml", said)
        .file("broken/tip.toml", "encoding = 1\n");
    let mut editor = Editor::start(&folder, ENCODINGS[1], Value::Null);
    let mut asked = |path: &str| {
        let uri = format!("file://{}", folder.path(path).display());
        editor.ask("tip/encoding", json!({ "uri": uri }))
    };
    assert_eq!(asked("old/two%20words.prg"), Ok(json!("shift_jis")));
    for path in ["new.prg", "old/deep/a.prg", "broken/a.prg"] {
        assert_eq!(asked(path), Ok(Value::Null), "{path}");
    }
    assert_eq!(
        editor.ask("tip/encoding", json!({ "uri": "untitled:1" })),
        Ok(Value::Null)
    );
    assert!(editor.ask("tip/encoding", json!({})).is_err());
    assert_eq!(editor.end(), 0);
}

#[test]
fn of_very_many_labels_those_that_fit_what_is_typed_are_offered() {
    let folder = Folder::new("lsp-offers");
    let labels: String = (0..400)
        .map(|number| format!("L{number}:\nREM\n"))
        .collect();
    let mut editor = Editor::start(&folder, ENCODINGS[1], Value::Null);
    let mut offered = |typed: &str| {
        editor.open(&format!("3.1\nTitle\n{labels}GOTO {typed}\nEND\n"));
        let at = editor.position(editor.text.find("\nEND").expect("the text has it"));
        let params = json!({ "textDocument": { "uri": URI }, "position": at });
        let answer = editor.ask("textDocument/completion", params);
        let answer = answer.expect("an answer");
        assert_eq!(answer["isIncomplete"], true);
        let items = answer["items"].as_array().expect("a list");
        let label = |item: &Value| item["label"].as_str().expect("a label").to_owned();
        items.iter().map(label).collect::<Vec<_>>()
    };
    assert_eq!(offered("").len(), 150);
    // L39; L309 to L399 and L390 to L398; L139, L239.
    assert_eq!(offered("l39").len(), 1 + 10 + 9 + 2);
    assert_eq!(offered("L399"), ["L399"]);
    assert_eq!(offered("M"), [""; 0]);
    assert_eq!(editor.end(), 0);
}

#[test]
fn what_only_the_robot_and_the_crate_know_is_warned_of_as_tip_check_does() {
    let folder = Folder::new("lsp-crate")
        .file("Cargo.toml", "[package]\nname = \"around\"\n")
        .file("tip.toml", "robot = \"titan8\"\n")
        .file(
            "src/lib.rs",
            "include_tip!(\"../walk.prg\", robot = \"hand\");",
        );
    let uri = format!("file://{}", folder.path("walk.prg").display());
    let text = "3.1\nTitle\nPTP F1 -2000 200 -200\nSPECIAL 30\nEND\n";
    let folder = folder.file("walk.prg", text);
    let warned = |options: Value| {
        let mut editor = Editor::start(&folder, ENCODINGS[1], options);
        let item = json!({ "uri": uri, "languageId": "tip", "version": 0, "text": text });
        editor.tell("textDocument/didOpen", json!({ "textDocument": item }));
        let found = editor.receive()["params"]["diagnostics"].take();
        assert_eq!(editor.end(), 0);
        let found = found.as_array().expect("a list").clone();
        codes(&found).join(" ")
    };
    assert_eq!(warned(Value::Null), "W125 W122 W123");
    // An editor that names the robot itself needs no tip.toml.
    assert_eq!(warned(json!({ "robot": "titan8" })), "W122 W123");
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

#[test]
fn an_unfinished_program_is_not_formatted_and_lines_are_formatted_alone() {
    let folder = Folder::new("lsp-format");
    let mut editor = Editor::start(&folder, ENCODINGS[1], Value::Null);
    let options = json!({ "tabSize": 2, "insertSpaces": true });
    let whole = json!({ "textDocument": { "uri": URI }, "options": options });
    editor.open("3.1\nTitle\nIF KB_HIT\n  sleep 5\n");
    assert_eq!(
        editor.ask("textDocument/formatting", whole),
        Ok(Value::Null)
    );
    editor.change(vec![json!({
        "range": { "start": { "line": 0, "character": 0 }, "end": { "line": 3, "character": 9 } },
        "newText": "3.1\nTitle\nsleep 5\nsleep 6\nsleep 7\nEND",
    })]);
    let lines = json!({
        "textDocument": { "uri": URI }, "options": options,
        "range": { "start": { "line": 3, "character": 2 }, "end": { "line": 3, "character": 4 } },
    });
    let edits = editor
        .ask("textDocument/rangeFormatting", lines)
        .expect("edits");
    editor.change(edits.as_array().expect("a list").clone());
    assert_eq!(editor.text, "3.1\nTitle\nsleep 5\nSLEEP 6\nsleep 7\nEND\n");
    assert_eq!(editor.end(), 0);
}

#[test]
fn files_have_three_forms_of_addresses() {
    // The robot of the tip.toml beside the file decides.
    let folder = Folder::new("lsp-addresses").file("tip.toml", "robot = \"generic\"\n");
    let mut editor = Editor::start(&folder, ENCODINGS[1], Value::Null);
    let path = folder.path("walk.prg").display().to_string();
    for uri in [
        format!("file://{path}"),
        format!("file:{path}"),
        format!("file://localhost{path}"),
    ] {
        let text = "3.1\nTitle\nTORQUE J11 1\nEND\n";
        let item = json!({ "uri": uri, "languageId": "tip", "version": 1, "text": text });
        editor.tell("textDocument/didOpen", json!({ "textDocument": item }));
        let published = editor.receive();
        assert_eq!(published["params"]["uri"], json!(uri));
        assert_eq!(published["params"]["diagnostics"], json!([]), "{uri}");
    }
    assert_eq!(editor.end(), 0);
}

#[test]
#[cfg(unix)]
fn the_server_ends_when_the_process_of_its_client_has_ended() {
    let folder = Folder::new("lsp-process");
    let mut gone = std::process::Command::new("true")
        .spawn()
        .expect("it starts");
    let process = json!({ "processId": gone.id() });
    gone.wait().expect("it ends");
    let mut editor = Editor::with(&folder, ENCODINGS[1], json!({}), process);
    // Its input stays open.
    assert_eq!(editor.process.wait().expect("it ends").code(), Some(1));
}
