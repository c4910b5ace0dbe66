//! The Language Server Protocol over any transport. The answers come from [`Document`](crate::Document); this module serves a
//! connection and states what it needs of the machine. The session is in `server`, requests are in `requests`, and values of the
//! protocol are made in `convert`. Files are read by the [`Workspace`] alone.

mod client;
mod convert;
mod requests;
mod server;

pub use server::{Incoming, Server, parse};

use crate::transport::{Connection, Frame};
use lsp_server::{ErrorCode, Message, Notification, RequestId, Response};
use serde_json::json;
use std::io::{self, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::rc::Rc;
use std::sync::mpsc::RecvTimeoutError;
use std::time::Duration;
use tipc::Options;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;

/// Idle time before hovers and hints are prepared: while the user types, that would delay the answers.
const IDLE: Duration = Duration::from_millis(50);

/// The robots, settings and pages that a server needs from the machine that it runs on.
pub trait Workspace {
    /// Returns the robot of the program at `path`, if it is a file; `configured` is the robot of the editor's settings. Errors
    /// are in `lang`.
    fn robot(
        &mut self,
        path: Option<&Path>,
        configured: Option<&str>,
        lang: Lang,
    ) -> Rc<RobotConfig>;

    /// Returns the warning that the crate around a file compiles it for another robot; `configured` is the robot of the editor's
    /// settings.
    fn other_robot(&mut self, path: &Path, configured: Option<&str>) -> Option<Diagnostic>;

    /// Returns the address of the page that explains a code.
    fn page(&mut self, code: &str, lang: Lang) -> Option<String>;

    /// Returns the name of the encoding that the nearest `tip.toml` gives to a file.
    fn encoding(&mut self, path: &Path) -> Option<String>;

    /// Returns true if a process of this machine runs.
    fn is_running(&mut self, process: u32) -> bool;

    /// Drops what was read from files, since some have changed.
    fn invalidate(&mut self);
}

/// The robot that a program is checked for.
#[derive(Debug)]
pub struct RobotConfig {
    /// The options of the compiler.
    pub options: Options,
    /// The robot with its geometry, for warnings about its reach.
    pub robot: Option<tip_sim::Robot>,
    /// The reason why it is the default robot instead of the configured one.
    pub error: Option<String>,
}

/// Time between two looks for the client's process.
const PATIENCE: Duration = Duration::from_secs(2);

/// Serves a client until it sends `exit`, closes the stream, or its process ends. Returns true if it sent `shutdown` before `exit`.
///
/// # Errors
/// The client cannot be answered.
pub fn serve<W: Write>(
    mut connection: Connection<W>,
    workspace: impl Workspace,
) -> io::Result<bool> {
    let mut server = Server::new(workspace);
    let mut next = wait(&connection, &mut server);
    while let Some(frame) = next {
        let mut waiting = Some(frame);
        // A waiting message may change the same text again, so diagnostics are computed after the last of them.
        while let Some(frame) = waiting {
            handle(&mut connection, &mut server, frame)?;
            if let Some(is_proper) = server.exit() {
                return Ok(is_proper);
            }
            waiting = connection.poll().ok();
        }
        for uri in server.take_due() {
            let found = catch_unwind(AssertUnwindSafe(|| server.diagnostics(&uri)));
            send(&mut connection, found.unwrap_or_else(|_| failed_on(&uri)))?;
        }
        next = match connection.wait_for(IDLE) {
            Err(RecvTimeoutError::Timeout) => {
                for uri in server.open() {
                    let _ = catch_unwind(AssertUnwindSafe(|| server.prepare(&uri)));
                }
                wait(&connection, &mut server)
            }
            frame => frame.ok(),
        };
    }
    Ok(false)
}

/// Waits for the next frame; `None` at the end of the stream or of the client.
fn wait<W: Write>(
    connection: &Connection<W>,
    server: &mut Server<impl Workspace>,
) -> Option<Frame> {
    loop {
        match connection.wait_for(PATIENCE) {
            Err(RecvTimeoutError::Timeout) if server.has_client() => {}
            frame => return frame.ok(),
        }
    }
}

/// Answers one message.
fn handle<W: Write>(
    connection: &mut Connection<W>,
    server: &mut Server<impl Workspace>,
    frame: Frame,
) -> io::Result<()> {
    let incoming = match frame {
        Frame::Message(bytes) => parse(&bytes),
        Frame::Malformed(reason) => Err(reason),
    };
    let message = match incoming {
        Ok(message) => *message,
        Err(reason) => {
            let code = ErrorCode::ParseError as i32;
            let error = json!({ "code": code, "message": reason });
            // The request that it belongs to is unknown.
            let answer = json!({ "jsonrpc": "2.0", "id": null, "error": error });
            return connection.send(&answer.to_string());
        }
    };
    let id = match &message {
        Message::Request(request) => Some(request.id.clone()),
        _ => None,
    };
    // A panic costs one answer, not the session.
    let answered = catch_unwind(AssertUnwindSafe(|| server.handle(message)));
    let answers = match (answered, id) {
        (Ok(answers), _) => answers,
        (Err(_), Some(id)) => vec![internal_error(id)],
        (Err(_), None) => Vec::new(),
    };
    send(connection, answers)
}

/// The text about a panic.
const DEFECT: &str = "tip failed; this is a defect of tip, please report it";

fn internal_error(id: RequestId) -> Message {
    Response::new_err(id, ErrorCode::InternalError as i32, DEFECT.to_owned()).into()
}

/// Returns the message that a program could not be checked. The others are.
fn failed_on(uri: &str) -> Vec<Message> {
    let params = json!({ "type": 1, "message": format!("{uri}: {DEFECT}") });
    vec![Notification::new("window/logMessage".to_owned(), params).into()]
}

fn send<W: Write>(connection: &mut Connection<W>, messages: Vec<Message>) -> io::Result<()> {
    messages
        .iter()
        .try_for_each(|message| message.write(&mut connection.output))
}
