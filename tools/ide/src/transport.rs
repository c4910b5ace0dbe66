//! The stream to an editor or a debugger: the framing that the Language Server Protocol and the Debug Adapter Protocol share,
//! and a connection that reads and writes it. The meaning of the messages belongs in `lsp` and `dap`.

use std::io::{self, BufRead, Read, Write};
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, channel};
use std::thread;
use std::time::Duration;

/// Maximum length of a message, bytes.
const MAX_MESSAGE: usize = 256 << 20;

/// Maximum length of a header line that is kept, bytes.
const MAX_HEADER_LINE: u64 = 4096;

/// One message of a stream, or the header of one that cannot be read.
#[derive(Debug, PartialEq, Eq)]
pub enum Frame {
    /// The bytes of a message.
    Message(Vec<u8>),
    /// A header without a usable length, and the reason.
    Malformed(String),
}

/// Returns the next message; `None` at the end of the stream.
///
/// # Errors
/// The stream cannot be read.
pub fn read(from: &mut impl BufRead) -> io::Result<Option<Frame>> {
    let mut length = Err("Content-Length is missing".to_owned());
    loop {
        let Some(line) = header_line(from)? else {
            return Ok(None);
        };
        let line = String::from_utf8_lossy(&line);
        match line.split_once(':') {
            Some((name, value)) if name.trim().eq_ignore_ascii_case("Content-Length") => {
                let value = value.trim();
                let number = value.parse::<usize>().ok();
                let number = number.filter(|length| *length <= MAX_MESSAGE);
                length = number.ok_or_else(|| format!("`{value}` is not a length"));
            }
            None if line.trim_end_matches(['\r', '\n']).is_empty() => break,
            _ => {}
        }
    }
    let length = match length {
        Ok(length) => length,
        Err(reason) => return Ok(Some(Frame::Malformed(reason))),
    };
    // Memory grows with the bytes that arrive, not with the announced length.
    let mut message = Vec::new();
    from.take(length as u64).read_to_end(&mut message)?;
    Ok((message.len() == length).then_some(Frame::Message(message)))
}

/// Returns the next header line with its end; `None` at the end of the stream. A line that is too long is cut.
fn header_line(from: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut line = Vec::new();
    from.take(MAX_HEADER_LINE).read_until(b'\n', &mut line)?;
    let mut is_whole = line.ends_with(b"\n") || (line.len() as u64) < MAX_HEADER_LINE;
    while !is_whole {
        let mut rest = Vec::new();
        let read = from.take(MAX_HEADER_LINE).read_until(b'\n', &mut rest)?;
        is_whole = read == 0 || rest.ends_with(b"\n");
    }
    Ok(Some(line).filter(|line| !line.is_empty()))
}

/// Writes a message with its header.
///
/// # Errors
/// The stream cannot be written.
pub fn write(to: &mut impl Write, message: &str) -> io::Result<()> {
    write!(to, "Content-Length: {}\r\n\r\n{message}", message.len())?;
    to.flush()
}

/// A connection to one client.
#[derive(Debug)]
pub struct Connection<W> {
    frames: Receiver<Frame>,
    pub(crate) output: W,
}

impl<W: Write> Connection<W> {
    /// Starts a thread that reads `input` until its end, so that requests can be looked for during other work.
    pub fn new(mut input: impl BufRead + Send + 'static, output: W) -> Self {
        let (sender, frames) = channel();
        thread::spawn(move || {
            while let Ok(Some(frame)) = read(&mut input) {
                if sender.send(frame).is_err() {
                    break;
                }
            }
        });
        Connection { frames, output }
    }

    /// Waits for the next frame; `None` at the end of the stream.
    pub(crate) fn wait(&self) -> Option<Frame> {
        self.frames.recv().ok()
    }

    /// Returns the next frame if it has arrived.
    pub(crate) fn poll(&self) -> Result<Frame, TryRecvError> {
        self.frames.try_recv()
    }

    /// Waits for the next frame, but no longer than `limit`.
    pub(crate) fn wait_for(&self, limit: Duration) -> Result<Frame, RecvTimeoutError> {
        self.frames.recv_timeout(limit)
    }

    /// Sends a message.
    pub(crate) fn send(&mut self, message: &str) -> io::Result<()> {
        write(&mut self.output, message)
    }
}
