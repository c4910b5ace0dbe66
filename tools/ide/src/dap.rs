//! The Debug Adapter Protocol over any transport: a debugger for editors. This module serves a connection and states what it needs
//! of the machine. The session is in `session`; the requests are in `breakpoints`, `execution` and `inspection`, which alone use
//! the debugger of `tip-sim`. Programs are loaded by the [`Launcher`] alone.

mod breakpoints;
mod execution;
mod inspection;
mod protocol;
mod session;

pub use protocol::Launch;
pub use session::Session;

use crate::transport::{Connection, Frame};
use std::fmt;
use std::io::{self, Write};
use std::sync::mpsc::TryRecvError;
use tip_sim::debug::Debugger;
use tipc::message::Lang;
use tipc::source::Source;

/// A loaded program on its robot.
pub struct Debuggee {
    /// The debugger of the program.
    pub debugger: Debugger,
    /// The source of the program.
    pub source: Source,
    /// The path of its file, as the client gave it.
    pub path: String,
    /// The warnings about it, one line each.
    pub warnings: String,
}

impl fmt::Debug for Debuggee {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut debuggee = f.debug_struct("Debuggee");
        debuggee.field("path", &self.path).finish_non_exhaustive()
    }
}

/// Loads programs for a session.
pub trait Launcher {
    /// Loads a program.
    ///
    /// # Errors
    /// The reason why it cannot be run, in `lang`.
    fn launch(&mut self, launch: &Launch, lang: Lang) -> Result<Debuggee, String>;

    /// Returns true if two paths lead to the same file.
    fn is_same_file(&self, one: &str, other: &str) -> bool;
}

/// Serves a client until it disconnects or closes the stream.
///
/// # Errors
/// The client cannot be answered.
pub fn serve<W: Write>(mut connection: Connection<W>, launcher: impl Launcher) -> io::Result<()> {
    let mut session = Session::new(launcher);
    while !session.is_over() {
        let next = match session.is_running() {
            // The program runs on while no request is waiting.
            true => connection.poll(),
            false => connection.wait().ok_or(TryRecvError::Disconnected),
        };
        match next {
            Ok(Frame::Message(message)) => session.handle(&message),
            Ok(Frame::Malformed(_)) => session.handle_malformed(),
            Err(TryRecvError::Empty) => session.work(),
            Err(TryRecvError::Disconnected) => return Ok(()),
        }
        for message in session.take_output() {
            connection.send(&message)?;
        }
    }
    Ok(())
}
