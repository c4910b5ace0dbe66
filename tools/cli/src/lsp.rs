//! `tip lsp`: the language server, over standard input and output. What it answers comes from `tip-ide`.

mod answers;
mod client;
mod files;
mod findings;
mod open;
mod places;
mod server;
mod shapes;
mod surroundings;
mod tokens;

use super::Status;
use super::error::Error;
use super::framing::{self, Frame};
use super::robot::RobotChoice;
use clap::Args;
use files::Files;
use lsp_server::{ErrorCode, Message, RequestId, Response};
use serde_json::json;
use server::{Incoming, Server, parse};
use std::hint::black_box;
use std::io::{self, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// How long nothing has to be asked before the server finds out what may be asked next: whoever types would wait for that.
const PAUSE: Duration = Duration::from_millis(50);

/// `tip lsp`
#[derive(Debug, Args)]
#[command(
    after_help = "An editor starts it, and talks to it through standard input and output: findings while you type, with fixes,
hover, definition, references, renaming, completion, signature help, hints, folding, colours and formatting.
docs/editors.md shows how to set up VS Code, neovim, helix and emacs.

The robot is that of --robot, of the client's option 'robot', of the nearest tip.toml, or titan8, in this order.

Exit status: 0 after 'shutdown' and 'exit', 1 if the editor goes away without them, 2 wrong usage."
)]
pub(super) struct Lsp {
    /// Talk through standard input and output, as it always does
    #[arg(long)]
    stdio: bool,

    /// The robot of every program: a name that 'tip robot list' shows, or a description
    #[arg(long, value_name = "NAME|FILE.toml")]
    robot: Option<RobotChoice>,
}

/// glibc gives memory back to the kernel, and has to ask for it again with the next text, unless a block of such a size was freed.
const KEPT: usize = 16 << 20;

/// Serves one editor.
pub(super) fn lsp(arguments: &Lsp) -> Result<Status, Error> {
    drop(black_box(Vec::<u8>::with_capacity(KEPT)));
    let mut server = Server::new(Files::new(arguments.robot.clone()));
    let frames = incoming();
    let mut next = frames.recv().ok();
    while let Some(frame) = next {
        let mut waiting = Some(frame);
        // What waits may change the same text again: findings can wait as well.
        while let Some(frame) = waiting {
            if let Some(end) = take(&mut server, frame)? {
                return Ok(end);
            }
            waiting = frames.try_recv().ok();
        }
        let due = catch_unwind(AssertUnwindSafe(|| server.due()));
        send(due.unwrap_or_default())?;
        next = match frames.recv_timeout(PAUSE) {
            Err(RecvTimeoutError::Timeout) => {
                let _ = catch_unwind(AssertUnwindSafe(|| server.rest()));
                frames.recv().ok()
            }
            frame => frame.ok(),
        };
    }
    Ok(Status::Failure)
}

/// The messages of the editor, read beside the work.
fn incoming() -> Receiver<Incoming> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let mut input = io::stdin().lock();
        while let Ok(Some(frame)) = framing::read(&mut input) {
            let message = match frame {
                Frame::Message(bytes) => parse(&bytes),
                Frame::Bad(reason) => Err(reason),
            };
            if sender.send(message).is_err() {
                break;
            }
        }
    });
    receiver
}

/// Answers a message; how the process ends, if it does.
fn take(server: &mut Server<Files>, incoming: Incoming) -> Result<Option<Status>, Error> {
    let message = match incoming {
        Ok(message) => *message,
        Err(reason) => {
            let code = ErrorCode::ParseError as i32;
            let error = json!({ "code": code, "message": reason });
            // Nobody knows to which request it belongs.
            let answer = json!({ "jsonrpc": "2.0", "id": null, "error": error });
            let mut bytes = Vec::new();
            let written = framing::write(&mut bytes, &answer.to_string());
            written.map_err(|error| Error::Failed(error.to_string()))?;
            write(&bytes)?;
            return Ok(None);
        }
    };
    let id = match &message {
        Message::Request(request) => Some(request.id.clone()),
        _ => None,
    };
    // A defect here is one answer less, not the end of a session.
    let answered = catch_unwind(AssertUnwindSafe(|| server.take(message)));
    let answers = match (answered, id) {
        (Ok(answers), _) => answers,
        (Err(_), Some(id)) => vec![defect(id)],
        (Err(_), None) => Vec::new(),
    };
    send(answers)?;
    Ok(server.end().map(|is_proper| match is_proper {
        true => Status::Success,
        false => Status::Failure,
    }))
}

/// The answer where this program failed itself.
fn defect(id: RequestId) -> Message {
    let message = "tip failed; this is a defect of tip, please report it".to_owned();
    Response::new_err(id, ErrorCode::InternalError as i32, message).into()
}

fn send(messages: Vec<Message>) -> Result<(), Error> {
    for message in messages {
        let mut bytes = Vec::new();
        let written = message.write(&mut bytes);
        written.map_err(|error| Error::Failed(error.to_string()))?;
        write(&bytes)?;
    }
    Ok(())
}

fn write(bytes: &[u8]) -> Result<(), Error> {
    let mut out = io::stdout().lock();
    let written = out.write_all(bytes).and_then(|()| out.flush());
    written.map_err(|error| Error::Failed(format!("the editor is gone: {error}")))
}
