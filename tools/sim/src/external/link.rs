//! The process behind an external plant, and the pipes to it.

use super::protocol::{Ended, MAX_ANSWER_BYTES, Request};
use crate::process_group::ProcessGroup;
use std::ffi::{OsStr, OsString};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};
use tip_runtime::printable::Printable;

/// Time that a process and those that it started have to end after the last line; then they are
/// killed.
const GRACE: Duration = Duration::from_secs(2);
/// Time that a process which has closed its output has to end.
const CLOSE_TIMEOUT: Duration = Duration::from_millis(500);
/// Maximum length of a line of standard error that is passed on in one piece, bytes.
const SAID: u64 = 4096;

/// A process that answers line by line.
pub(super) struct Link {
    process: ProcessGroup,
    /// `None` after the last line.
    lines: Option<Sender<Line>>,
    answers: Receiver<Received>,
    /// Disconnected when standard error has been read to its end.
    said: Receiver<()>,
    asked: Instant,
    /// True if the process gets no time to end by itself.
    skips_grace: bool,
}

/// A line to the process.
struct Line {
    text: String,
    is_answered: bool,
}

/// An answer, or what came in its place.
pub(super) enum Received {
    Line(String),
    /// No answer yet.
    Nothing,
    TooLate,
    End(Ended),
    TooLong,
    NotText,
}

impl Link {
    pub(super) fn start(
        program: &OsStr,
        arguments: &[OsString],
        listener: Arc<dyn Fn(&str) + Send + Sync>,
    ) -> io::Result<Self> {
        let mut command = Command::new(program);
        command.args(arguments);
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut process = ProcessGroup::start(&mut command)?;
        let child = process.child();
        let (lines, to_write) = mpsc::channel();
        let (heard, answers) = mpsc::channel();
        let (saying, said) = mpsc::channel();
        if let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) {
            thread::spawn(move || exchange_lines(input, output, &to_write, &heard));
        }
        if let Some(errors) = child.stderr.take() {
            thread::spawn(move || {
                listen(errors, listener.as_ref());
                drop(saying);
            });
        }
        Ok(Link {
            process,
            lines: Some(lines),
            answers,
            said,
            asked: Instant::now(),
            skips_grace: false,
        })
    }

    /// Sends a line, and expects an answer from now on.
    pub(super) fn request(&mut self, text: String) {
        self.asked = Instant::now();
        self.send(text, true);
    }

    /// Sends a line that has no answer.
    pub(super) fn notify(&mut self, text: String) {
        self.send(text, false);
    }

    fn send(&mut self, text: String, is_answered: bool) {
        // If the process has ended, the missing answer shows that.
        let lines = self.lines.iter();
        lines.for_each(|lines| {
            drop(lines.send(Line {
                text: text.clone(),
                is_answered,
            }))
        });
    }

    /// Waits up to `longest` for the answer to the last request. The answer is too late `within` after the request.
    pub(super) fn answer(&mut self, longest: Duration, within: Duration) -> Received {
        let left = within.saturating_sub(self.asked.elapsed());
        match self.answers.recv_timeout(left.min(longest)) {
            Ok(Received::End(_)) | Err(RecvTimeoutError::Disconnected) => {
                Received::End(self.ended())
            }
            Ok(heard) => heard,
            Err(RecvTimeoutError::Timeout) if self.asked.elapsed() < within => Received::Nothing,
            Err(RecvTimeoutError::Timeout) => Received::TooLate,
        }
    }

    /// Returns the way in which it ended.
    fn ended(&mut self) -> Ended {
        match self.process.wait(CLOSE_TIMEOUT) {
            None => Ended::Closed,
            Some(status) => status.code().map_or(Ended::Killed, Ended::Exit),
        }
    }

    /// Gives the process no time to end by itself.
    pub(super) fn skip_grace(&mut self) {
        self.skips_grace = true;
    }
}

impl Drop for Link {
    /// Sends the last line, closes the input and waits for the end of the process and of those that it started. They
    /// are killed if they do not end in time.
    fn drop(&mut self) {
        self.notify(Request::Bye.line());
        self.lines = None;
        let grace = if self.skips_grace {
            Duration::ZERO
        } else {
            GRACE
        };
        self.process.end(grace);
        // Waits for the last lines of standard error. The wait is limited, since other processes may hold the pipe
        // open.
        let _ = self.said.recv_timeout(CLOSE_TIMEOUT);
    }
}

/// Writes each line and reads its answer, as long as there are lines.
fn exchange_lines(
    mut input: ChildStdin,
    output: ChildStdout,
    lines: &Receiver<Line>,
    heard: &Sender<Received>,
) {
    let mut output = BufReader::new(output);
    for line in lines {
        // If the process does not read any more, the missing answer shows that.
        let _ = input
            .write_all(line.text.as_bytes())
            .and_then(|()| input.flush());
        if line.is_answered && heard.send(read_line(&mut output)).is_err() {
            return;
        }
    }
}

/// Reads the next line.
fn read_line(output: &mut impl BufRead) -> Received {
    let mut bytes = Vec::new();
    let read = output
        .by_ref()
        .take(MAX_ANSWER_BYTES + 1)
        .read_until(b'\n', &mut bytes);
    let is_whole = bytes.pop_if(|byte| *byte == b'\n').is_some();
    match (read, is_whole, String::from_utf8(bytes)) {
        (Ok(read), false, _) if read as u64 > MAX_ANSWER_BYTES => Received::TooLong,
        (Ok(_), true, Ok(line)) => Received::Line(line),
        (Ok(_), true, Err(_)) => Received::NotText,
        // A line without its end was cut off.
        _ => Received::End(Ended::Closed),
    }
}

/// Passes on its output, line by line.
fn listen(errors: ChildStderr, listener: &(dyn Fn(&str) + Send + Sync)) {
    let mut errors = BufReader::new(errors);
    loop {
        let mut bytes = Vec::new();
        let read = errors.by_ref().take(SAID).read_until(b'\n', &mut bytes);
        if !read.is_ok_and(|read| read > 0) {
            return;
        }
        let text = String::from_utf8_lossy(&bytes);
        listener(&Printable::line(text.trim_end()).to_string());
    }
}
