//! `tip dap`: a debugger behind the Debug Adapter Protocol, on standard input and output.

mod breakpoints;
mod changes;
mod launch;
mod message;
mod moves;
mod session;
mod shown;

use super::Status;
use super::error::{self, Error};
use super::framing::{self, Frame};
use clap::Args;
use launch::Files;
use session::Session;
use std::io::{self, BufReader};
use std::sync::mpsc::{Receiver, TryRecvError, sync_channel};
use std::thread;

/// `tip dap`
#[derive(Debug, Args)]
#[command(
    after_help = "Editors start it; it speaks the Debug Adapter Protocol on standard input and output.
A launch names what 'tip run' has as options:

  { \"request\": \"launch\", \"program\": \"walk.prg\", \"robot\": \"titan8\", \"scene\": \"cylinder\",
    \"events\": \"10:key F, 300:VR1=8\", \"stopOnEntry\": true, \"stopOnFall\": true }

In the console of the debugger: an expression such as STRIDE + 5 or STRIDE > 80, N = 5, key F,
VR1=8, halt, to 300 (a cycle). See docs/debugging.md."
)]
pub(super) struct Dap {}

/// Serves a client until it says goodbye.
pub(super) fn dap(_: &Dap) -> Result<Status, Error> {
    let (sender, frames) = sync_channel(64);
    // It ends with the process, or when the client closes its end.
    thread::spawn(move || {
        let mut input = BufReader::new(io::stdin());
        while let Ok(Some(frame)) = framing::read(&mut input) {
            if sender.send(frame).is_err() {
                return;
            }
        }
    });
    match serve(&frames) {
        Ok(()) => Ok(Status::Success),
        Err(error) if error::is_closed(&error) => Ok(Status::Success),
        Err(error) => Err(Error::Failed(format!(
            "the client cannot be answered: {error}"
        ))),
    }
}

fn serve(frames: &Receiver<Frame>) -> io::Result<()> {
    let mut session = Session::new(Files);
    let mut output = io::stdout().lock();
    while !session.is_over() {
        let next = match session.is_going() {
            // What is under way goes on where nobody asks for anything.
            true => frames.try_recv(),
            false => frames.recv().map_err(|_| TryRecvError::Disconnected),
        };
        match next {
            Ok(Frame::Message(message)) => session.handle(&message),
            Ok(Frame::Bad(_)) => session.broken(),
            Err(TryRecvError::Empty) => session.work(),
            Err(TryRecvError::Disconnected) => return Ok(()),
        }
        for message in session.sent() {
            framing::write(&mut output, &message)?;
        }
    }
    Ok(())
}
