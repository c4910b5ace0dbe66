//! The trace of a run, written to a file or to standard output.

use super::super::error::{Error, is_closed};
use super::super::interrupt;
use super::super::output;
use std::io::{self, BufWriter, IsTerminal, Stdout, Write};
use std::path::{Path, PathBuf};
use tip_runtime::printable::is_control;
use tip_runtime::record::{AtomicFile, Ending, JsonLines, MotionRecord, Sink, Stream};
use tip_sim::Run;

/// The name that stands for standard output.
pub(super) const STANDARD_OUTPUT: &str = "-";

/// A trace that is being written.
pub(super) struct Trace {
    path: PathBuf,
    takes_standard_output: bool,
    is_straight: bool,
    with_motion: bool,
    lines: JsonLines<Stream<BufWriter<Output>>>,
}

/// What its records end with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extras {
    /// A hash of what each joint was sent and measured.
    pub(super) state: bool,
    /// What the simulated robot did.
    pub(super) motion: bool,
}

/// Where it goes.
enum Output {
    Standard(Stdout),
    Terminal(Terminal),
    File(AtomicFile),
}

/// A terminal, on which nothing of a record may act: the same JSON, with escapes in place of such characters.
struct Terminal {
    out: Stdout,
    /// The record so far: a piece of it may end inside a character.
    record: Vec<u8>,
}

impl Trace {
    /// Begins a trace.
    pub(super) fn begin(path: &Path, extras: Extras) -> Result<Self, Error> {
        let out = if path.as_os_str() == STANDARD_OUTPUT {
            Output::standard()
        } else {
            let file = output::begin(path).map_err(|error| Error::cannot_write(path, error))?;
            interrupt::discards(file.part());
            Output::File(file)
        };
        let (takes_standard_output, is_straight) = match &out {
            Output::Standard(_) | Output::Terminal(_) => (true, true),
            Output::File(file) => (false, file.part().is_none()),
        };
        let lines = JsonLines::new(Stream::new(BufWriter::new(out)), extras.state);
        Ok(Trace {
            path: path.to_owned(),
            takes_standard_output,
            is_straight,
            with_motion: extras.motion,
            lines: match extras.motion {
                true => lines.with_motion(),
                false => lines,
            },
        })
    }

    /// Whether it takes standard output for itself.
    pub(super) fn takes_standard_output(&self) -> bool {
        self.takes_standard_output
    }

    /// Whether it is written straight into what may not take it: a pipe, a device, standard output.
    pub(super) fn is_straight(&self) -> bool {
        self.is_straight
    }

    /// Takes the records of the cycles.
    pub(super) fn sink(&mut self) -> &mut dyn Sink {
        &mut self.lines
    }

    /// A cycle is over: its record gets what the robot did, if that was asked for.
    pub(super) fn after(&mut self, run: &Run) {
        if !self.with_motion {
            return;
        }
        let limbs = run.limbs();
        let legs = limbs.as_ref().map_or(&[][..], |limbs| &limbs.angles);
        self.lines.motion(&MotionRecord {
            pose: run.pose(),
            motion: run.motion(),
            joints_per_leg: legs.first().map_or(0, Vec::len),
            angles: &legs.concat(),
            loads: limbs.as_ref().map_or(&[], |limbs| &limbs.loads),
        });
    }

    /// Whether it can still be written.
    pub(super) fn is_open(&self) -> bool {
        self.lines.result().is_ok()
    }

    /// Writes the last record, sees that all of it arrived, and puts the file in its place.
    pub(super) fn end(mut self, ending: Ending, cycles: u64) -> Result<(), Error> {
        self.lines.end(ending, cycles);
        let mut stream = self.lines.into_inner();
        let written = stream.finish().and_then(|()| {
            let out = stream.into_inner().into_inner();
            out.map_err(io::IntoInnerError::into_error)?.close()
        });
        match written {
            Err(error) if !is_closed(&error) => Err(Error::cannot_write(&self.path, error)),
            _ => Ok(()),
        }
    }
}

impl Output {
    fn standard() -> Self {
        let out = io::stdout();
        match out.is_terminal() {
            true => Output::Terminal(Terminal {
                out,
                record: Vec::new(),
            }),
            false => Output::Standard(out),
        }
    }

    fn close(self) -> io::Result<()> {
        match self {
            Output::Standard(_) | Output::Terminal(_) => Ok(()),
            Output::File(file) => file.commit(),
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Output::Standard(out) => out.write(bytes),
            Output::Terminal(terminal) => terminal.write(bytes),
            Output::File(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Output::Standard(out) => out.flush(),
            Output::Terminal(terminal) => terminal.flush(),
            Output::File(file) => file.flush(),
        }
    }
}

impl Write for Terminal {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for byte in bytes {
            self.record.push(*byte);
            if *byte == b'\n' {
                let record = escaped(&String::from_utf8_lossy(&self.record));
                self.record.clear();
                self.out.write_all(record.as_bytes())?;
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// JSON with `\u202e` and its like in place of what acts, which is part of a string there.
fn escaped(record: &str) -> String {
    let mut escaped = String::with_capacity(record.len());
    for c in record.chars() {
        match is_control(c) && c != '\n' {
            true => escaped += &format!("\\u{:04x}", u32::from(c)),
            false => escaped.push(c),
        }
    }
    escaped
}
