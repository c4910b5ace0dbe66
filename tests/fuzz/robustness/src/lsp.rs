//! Messages to the language server: each request has one response, and only `exit` ends the session.

use lsp_server::{Message, RequestId};
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
    server.prepare();
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
    assert!(
        server
            .due_diagnostics()
            .iter()
            .all(|message| of(message).is_none())
    );
}
