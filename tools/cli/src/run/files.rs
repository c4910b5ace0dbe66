//! The files of a run: checks of their paths, the log files of `--out-dir`, and the trace.

use crate::error::{Error, is_closed};
use crate::input::is_standard;
use crate::run::Run;
use crate::{interrupt, output};
use std::ffi::OsStr;
use std::fs;
use std::io::{self, BufWriter, IsTerminal, Stdout, Write};
use std::path::{Component, Path, PathBuf};
use tip_lint::listing;
use tip_runtime::console::{LogError, LogFiles};
use tip_runtime::record::{AtomicFile, Ending, JsonLines, MotionRecord, Sink, Stream};
use tipc::Loaded;

/// Returns an error if an output of the run is one of its inputs, or another output.
pub(super) fn check(arguments: &Run) -> Result<(), Error> {
    let inputs = arguments.run.files();
    let logs = arguments.out_dir.as_deref().map(logs).unwrap_or_default();
    for log in &logs {
        output::refuse_inputs(log, &inputs)?;
    }
    let trace = arguments.trace.as_deref();
    let Some(trace) = trace.filter(|path| !is_standard(path)) else {
        return Ok(());
    };
    output::refuse_inputs(trace, &inputs)?;
    match logs.iter().find(|log| is_place(trace, log)) {
        Some(log) => {
            let name = log.file_name().unwrap_or_default().to_string_lossy();
            let reason = format!("this is the run's own {name}");
            Err(Error::cannot_write(trace, reason))
        }
        None => Ok(()),
    }
}

fn logs(folder: &Path) -> Vec<PathBuf> {
    let names = LogFiles::<()>::NAMES.iter();
    names.map(|name| folder.join(name)).collect()
}

/// Returns true if two paths lead to the same file, or would if it existed.
fn is_place(one: &Path, other: &Path) -> bool {
    let folder = |path: &Path| match path.parent() {
        Some(folder) if folder.as_os_str().is_empty() => fs::canonicalize("."),
        Some(folder) => fs::canonicalize(folder),
        None => fs::canonicalize(path),
    };
    let is_one_folder =
        matches!((folder(one), folder(other)), (Ok(one), Ok(other)) if one == other);
    output::is_same(one, other) || is_one_folder && one.file_name() == other.file_name()
}

/// Claims `folder` for the files of one program and writes its warnings.
pub(super) fn claim(folder: &Path, loaded: &Loaded) -> Result<LogFiles<()>, Error> {
    fs::create_dir_all(folder).map_err(|reason| Error::cannot_write(folder, reason))?;
    let name = seen_from(folder, Path::new(loaded.source.name()));
    let mut files = LogFiles::claim(folder, &name, ()).map_err(error)?;
    files.warnings(&listing::warnings(&loaded.source, &loaded.diagnostics));
    files
        .take_error()
        .map_or(Ok(files), |failed| Err(error(failed)))
}

/// Returns the path of the program from the folder, with `/` everywhere: two programs never share it, and it stays true when both
/// move.
fn seen_from(folder: &Path, program: &Path) -> String {
    let path = match (fs::canonicalize(folder), fs::canonicalize(program)) {
        (Ok(folder), Ok(program)) => relative(&folder, &program),
        // One of them was removed after reading; the given path is good enough.
        _ => program.to_owned(),
    };
    let parts = path.iter().map(OsStr::to_string_lossy);
    parts.collect::<Vec<_>>().join("/")
}

/// Returns the path from `folder` to `file`, both absolute; `file` itself if they have no common root.
fn relative(folder: &Path, file: &Path) -> PathBuf {
    let common = folder
        .components()
        .zip(file.components())
        .take_while(|(folder, file)| folder == file)
        .count();
    if common == 0 {
        return file.to_owned();
    }
    let up = folder.components().skip(common);
    let down = file.components().skip(common);
    up.map(|_| Component::ParentDir).chain(down).collect()
}

/// Completes the files; returns the first error of all writing.
pub(super) fn finish(files: &mut LogFiles<()>) -> Result<(), Error> {
    files.flush();
    files
        .take_error()
        .map_or(Ok(()), |failed| Err(error(failed)))
}

fn error(LogError { path, reason }: LogError) -> Error {
    Error::cannot_write(&path, reason)
}

/// A trace that is being written.
pub(crate) struct Trace {
    path: PathBuf,
    takes_standard_output: bool,
    is_straight: bool,
    with_motion: bool,
    lines: JsonLines<Stream<BufWriter<Output>>>,
}

/// The destination of a trace.
enum Output {
    Standard(Stdout),
    Terminal(Terminal),
    File(AtomicFile),
}

/// A terminal; control characters of a record are escaped.
struct Terminal {
    out: Stdout,
    /// The record so far: a write may end inside a character.
    record: Vec<u8>,
}

impl Trace {
    /// Opens a trace, with a hash of the robot's state and its motion in each record if they are asked for.
    pub(crate) fn begin(path: &Path, with_state: bool, with_motion: bool) -> Result<Self, Error> {
        let out = if is_standard(path) {
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
        let lines = JsonLines::new(Stream::new(BufWriter::new(out)), with_state);
        Ok(Trace {
            path: path.to_owned(),
            takes_standard_output,
            is_straight,
            with_motion,
            lines: match with_motion {
                true => lines.with_motion(),
                false => lines,
            },
        })
    }

    /// Returns true if it uses standard output.
    pub(super) fn takes_standard_output(&self) -> bool {
        self.takes_standard_output
    }

    /// Returns true if it is written directly to a pipe, a device or standard output, which may block.
    pub(super) fn is_straight(&self) -> bool {
        self.is_straight
    }

    /// Returns the sink of the records.
    pub(crate) fn sink(&mut self) -> &mut dyn Sink {
        &mut self.lines
    }

    /// Adds the motion to the record of a cycle, if it was asked for.
    pub(crate) fn after(&mut self, run: &tip_sim::Run) {
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
            clearance: run.clearance(),
        });
    }

    /// Returns true if it can still be written.
    pub(super) fn is_open(&self) -> bool {
        self.lines.result().is_ok()
    }

    /// Writes the last record, and puts the complete file in its place.
    pub(crate) fn end(mut self, ending: Ending, cycles: u64) -> Result<(), Error> {
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
                let record = output::escaped(&String::from_utf8_lossy(&self.record));
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
