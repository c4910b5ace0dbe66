//! Messages to the language server: each request has one response, and only `exit` ends the session.

use lsp_server::{Message, Notification, Request, RequestId};
use serde_json::json;
use std::path::Path;
use std::rc::Rc;
use tip_ide::lsp::{RobotConfig, Server, Workspace, parse};
use tip_ide::transport::{self, Frame};
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::{Options, Robot};

/// A workspace without files.
struct Nowhere;

impl Workspace for Nowhere {
    fn robot(&mut self, _: Option<&Path>, configured: Option<&str>, _: Lang) -> Rc<RobotConfig> {
        let robot = configured.and_then(Robot::from_name);
        Rc::new(RobotConfig {
            options: Options {
                robot: robot.unwrap_or_default(),
                ..Options::default()
            },
            robot: tip_sim::Robot::named(robot.unwrap_or_default().name()).ok(),
            error: configured.filter(|_| robot.is_none()).map(str::to_owned),
        })
    }

    fn other_robot(&mut self, _: &Path, _: Option<&str>) -> Option<Diagnostic> {
        None
    }

    fn page(&mut self, code: &str, _: Lang) -> Option<String> {
        Some(format!("page:{code}"))
    }

    fn encoding(&mut self, path: &Path) -> Option<String> {
        path.is_absolute().then(String::new)
    }

    fn invalidate(&mut self) {}

    fn is_running(&mut self, _: u32) -> bool {
        true
    }
}

/// Serves a client that sends each line of the bytes as a message, and one that sends the bytes as they are.
///
/// # Panics
/// A request has no response, or a notification has one.
pub fn examine(bytes: &[u8]) {
    let framed: Vec<u8> = bytes
        .split(|byte| *byte == b'\n')
        .flat_map(|line| {
            let head = format!("Content-Length: {}\r\n\r\n", line.len());
            [head.as_bytes(), line].concat()
        })
        .collect();
    serve(&framed);
    serve(bytes);
}

fn serve(stream: &[u8]) {
    let mut server = Server::new(Nowhere);
    let mut stream = stream;
    while let Ok(Some(frame)) = transport::read(&mut stream) {
        let message = match frame {
            Frame::Message(bytes) => parse(&bytes),
            Frame::Malformed(reason) => Err(reason),
        };
        match message {
            Ok(message) => answered(&mut server, *message),
            Err(reason) => assert!(!reason.is_empty()),
        }
        if server.exit().is_some() {
            break;
        }
    }
    for uri in server.open() {
        server.prepare(&uri);
    }
}

fn answered(server: &mut Server<Nowhere>, message: Message) {
    let asked = match &message {
        Message::Request(request) => vec![request.id.clone()],
        _ => Vec::new(),
    };
    let answers = server.handle(message);
    let of = |message: &Message| match message {
        Message::Response(response) => Some(response.id.clone()),
        _ => None,
    };
    let answers: Vec<RequestId> = answers.iter().filter_map(of).collect();
    assert_eq!(answers, asked);
    for uri in server.take_due() {
        let found = server.diagnostics(&uri);
        assert!(found.iter().all(|message| of(message).is_none()));
    }
}

/// Opens a program, asks everything that an editor asks of it, and changes it once.
///
/// # Panics
/// A request has no response.
pub fn edit(program: &str) {
    const URI: &str = "file:///edited.prg";
    let mut server = Server::new(Nowhere);
    let file = json!({ "uri": URI });
    let last = program.lines().count();
    let end = json!({ "line": last, "character": 0 });
    let middle = json!({ "line": last / 2, "character": 3 });
    let whole = json!({ "start": { "line": 0, "character": 0 }, "end": end });
    let item = json!({ "uri": URI, "languageId": "tip", "version": 1, "text": program });
    let change = json!({ "range": { "start": middle, "end": middle }, "text": "X" });
    let version = json!({ "uri": URI, "version": 2 });
    let context = json!({ "diagnostics": [] });
    let options = json!({ "tabSize": 2, "insertSpaces": true });
    let at = json!({ "textDocument": file, "position": middle });
    let requests = [
        ("textDocument/hover", at.clone()),
        ("textDocument/completion", at.clone()),
        ("textDocument/signatureHelp", at.clone()),
        ("textDocument/definition", at.clone()),
        (
            "textDocument/references",
            json!({ "textDocument": file, "position": middle, "context": { "includeDeclaration": true } }),
        ),
        ("textDocument/documentHighlight", at.clone()),
        (
            "textDocument/rename",
            json!({ "textDocument": file, "position": middle, "newName": "NEW" }),
        ),
        (
            "textDocument/documentSymbol",
            json!({ "textDocument": file }),
        ),
        ("textDocument/foldingRange", json!({ "textDocument": file })),
        (
            "textDocument/semanticTokens/full",
            json!({ "textDocument": file }),
        ),
        (
            "textDocument/inlayHint",
            json!({ "textDocument": file, "range": whole }),
        ),
        (
            "textDocument/codeAction",
            json!({ "textDocument": file, "range": whole, "context": context }),
        ),
        (
            "textDocument/formatting",
            json!({ "textDocument": file, "options": options }),
        ),
    ];
    let start = json!({ "capabilities": {} });
    answered(
        &mut server,
        Request::new(0.into(), "initialize".to_owned(), start).into(),
    );
    let open = json!({ "textDocument": item });
    let open = Notification::new("textDocument/didOpen".to_owned(), open);
    answered(&mut server, open.into());
    for (id, (method, params)) in (1..).zip(requests) {
        answered(
            &mut server,
            Request::new(id.into(), method.to_owned(), params).into(),
        );
    }
    let change = json!({ "textDocument": version, "contentChanges": [change] });
    let change = Notification::new("textDocument/didChange".to_owned(), change);
    answered(&mut server, change.into());
}
