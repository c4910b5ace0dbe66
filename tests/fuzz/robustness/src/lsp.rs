//! Messages of editors: each request is answered once, and nothing ends the session but its end. The sources are those of the
//! command, which is no library.

#[path = "../../../../tools/cli/src/lsp/answers.rs"]
mod answers;
#[path = "../../../../tools/cli/src/lsp/client.rs"]
mod client;
#[path = "../../../../tools/cli/src/lsp/findings.rs"]
mod findings;
#[path = "../../../../tools/cli/src/lsp/open.rs"]
mod open;
#[path = "../../../../tools/cli/src/lsp/places.rs"]
mod places;
#[path = "../../../../tools/cli/src/lsp/server.rs"]
mod server;
#[path = "../../../../tools/cli/src/lsp/shapes.rs"]
mod shapes;
#[path = "../../../../tools/cli/src/lsp/surroundings.rs"]
mod surroundings;
#[path = "../../../../tools/cli/src/lsp/tokens.rs"]
mod tokens;

use crate::framing::{self, Frame};
use lsp_server::{Message, RequestId};
use server::{Server, parse};
use std::path::Path;
use std::rc::Rc;
use surroundings::{Chosen, Surroundings};
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::{Options, Robot};

/// Surroundings of a program where there are no files.
struct Nowhere;

impl Surroundings for Nowhere {
    fn robot(&mut self, _: Option<&Path>, asked: Option<&str>, _: Lang) -> Rc<Chosen> {
        let robot = asked.and_then(Robot::from_name);
        Rc::new(Chosen {
            options: Options {
                robot: robot.unwrap_or_default(),
                ..Options::default()
            },
            robot: tip_sim::Robot::named(robot.unwrap_or_default().name()).ok(),
            complaint: asked.filter(|_| robot.is_none()).map(str::to_owned),
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

    fn forget(&mut self) {}
}

/// Serves an editor that says each line of the bytes, and then one that sends the bytes as they are.
///
/// # Panics
/// A request is not answered, or something is answered that is none.
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
    while let Ok(Some(frame)) = framing::read(&mut stream) {
        let message = match frame {
            Frame::Message(bytes) => parse(&bytes),
            Frame::Bad(reason) => Err(reason),
        };
        match message {
            Ok(message) => answered(&mut server, *message),
            Err(reason) => assert!(!reason.is_empty()),
        }
        if server.end().is_some() {
            break;
        }
    }
    server.rest();
}

fn answered(server: &mut Server<Nowhere>, message: Message) {
    let asked = match &message {
        Message::Request(request) => vec![request.id.clone()],
        _ => Vec::new(),
    };
    let answers = server.take(message);
    let of = |message: &Message| match message {
        Message::Response(response) => Some(response.id.clone()),
        _ => None,
    };
    let answers: Vec<RequestId> = answers.iter().filter_map(of).collect();
    assert_eq!(answers, asked);
    assert!(server.due().iter().all(|message| of(message).is_none()));
}
