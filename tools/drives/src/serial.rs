//! A serial port of this machine, which no other program uses.

use crate::bus::Port;
use core::fmt;
use serial2::{KeepSettings, SerialPort};
use std::io;
use std::path::Path;
use std::string::String;
use std::time::{Duration, Instant};
use std::vec::Vec;
use std::{format, fs};

/// A reason why a port cannot be opened.
#[derive(Debug)]
pub enum OpenError {
    /// Another program has it open, as far as the system says which.
    InUse(Option<Process>),
    /// Another reason.
    Io(io::Error),
}

/// A process of this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Process {
    /// Number of the process.
    pub id: u32,
    /// Name of its program.
    pub name: String,
}

impl fmt::Display for OpenError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OpenError::InUse(Some(Process { id, name })) => {
                write!(f, "{name} (process {id}) uses it")
            }
            OpenError::InUse(None) => f.write_str("another process uses it"),
            OpenError::Io(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for OpenError {}

impl From<io::Error> for OpenError {
    fn from(error: io::Error) -> Self {
        OpenError::Io(error)
    }
}

/// A serial port. What comes is buffered here, so that waiting for a byte may take it from the system.
#[derive(Debug)]
pub struct Serial {
    port: SerialPort,
    start: Instant,
    buffer: Vec<u8>,
}

impl Serial {
    /// Opens a port, such as `/dev/ttyUSB0`, for this process alone. Nothing about it changes if another process has it.
    ///
    /// # Errors
    /// There is no such port, it is in use, or the speed is not possible.
    pub fn open(path: &Path, baud: u32) -> Result<Self, OpenError> {
        let opened = SerialPort::open(path, KeepSettings);
        let mut port = opened.map_err(|error| match error.kind() {
            io::ErrorKind::ResourceBusy => OpenError::InUse(user_of(path)),
            _ => OpenError::Io(error),
        })?;
        if !is_ours(&port)? {
            return Err(OpenError::InUse(user_of(path)));
        }
        let mut settings = port.get_configuration()?;
        settings.set_raw();
        settings.set_baud_rate(baud)?;
        port.set_configuration(&settings)?;
        port.set_write_timeout(Duration::from_millis(100))?;
        port.discard_buffers()?;
        Ok(Serial {
            port,
            start: Instant::now(),
            buffer: Vec::new(),
        })
    }

    /// Returns the time for which the adapter at `path` collects bytes before it passes them on, ms; `None` if it states none.
    #[allow(clippy::disallowed_methods, reason = "Linux tells it in a file")]
    pub fn latency_timer(path: &Path) -> Option<u32> {
        let real = fs::canonicalize(path).ok()?;
        let name: String = real.file_name()?.to_string_lossy().into_owned();
        let text = fs::read_to_string(format!("/sys/class/tty/{name}/device/latency_timer"));
        text.ok()?.trim().parse().ok()
    }
}

/// Locks a port; returns false if another process has locked it. `flock` keeps programs away that lock too, those of the system
/// administrator included; the terminal's own lock keeps all others away, except those.
#[cfg(unix)]
fn is_ours(port: &SerialPort) -> io::Result<bool> {
    use rustix::fs::{FlockOperation, flock};
    use rustix::io::Errno;
    match flock(port, FlockOperation::NonBlockingLockExclusive) {
        Err(Errno::WOULDBLOCK) => return Ok(false),
        locked => locked?,
    }
    rustix::termios::ioctl_tiocexcl(port)?;
    Ok(true)
}

/// Ports are exclusive where there is no such lock.
#[cfg(not(unix))]
fn is_ours(_: &SerialPort) -> io::Result<bool> {
    Ok(true)
}

#[cfg(unix)]
impl Drop for Serial {
    /// The terminal's lock would outlive this process where another one keeps the terminal open.
    fn drop(&mut self) {
        let _ = rustix::termios::ioctl_tiocnxcl(&self.port);
    }
}

/// Returns the process that has a file open, where the system lists open files and lets us read the list.
#[allow(clippy::disallowed_methods, reason = "Linux tells it in files")]
fn user_of(path: &Path) -> Option<Process> {
    let path = fs::canonicalize(path).ok()?;
    let folders = fs::read_dir("/proc").ok()?.flatten();
    let mut users = folders.filter_map(|folder| {
        let id: u32 = folder.file_name().to_str()?.parse().ok()?;
        let mut files = fs::read_dir(folder.path().join("fd")).ok()?.flatten();
        let has_it = files.any(|file| fs::read_link(file.path()).is_ok_and(|it| it == path));
        let is_other = id != std::process::id();
        let name = || fs::read_to_string(folder.path().join("comm")).unwrap_or_default();
        (has_it && is_other).then(|| Process {
            id,
            name: String::from(name().trim()),
        })
    });
    users.next()
}

impl embedded_io::ErrorType for Serial {
    type Error = io::Error;
}

impl embedded_io::Read for Serial {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        if self.buffer.is_empty() {
            return self.port.read(into);
        }
        let count = into.len().min(self.buffer.len());
        into[..count].copy_from_slice(&self.buffer[..count]);
        self.buffer.drain(..count);
        Ok(count)
    }
}

impl embedded_io::Write for Serial {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        loop {
            match self.port.write(bytes) {
                // A signal is no fault of the port.
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                written => return written,
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        // Waiting until the last bit has left would cost a round trip; the answer tells.
        Ok(())
    }
}

impl Port for Serial {
    fn now(&mut self) -> u64 {
        self.start.elapsed().as_micros() as u64
    }

    fn wait(&mut self, until: u64) -> io::Result<bool> {
        if !self.buffer.is_empty() {
            return Ok(true);
        }
        let left = until.saturating_sub(self.now());
        // The system counts in ms: rather a part of one too long than too short.
        let left = Duration::from_millis(left.div_ceil(1000));
        self.port.set_read_timeout(left)?;
        let mut bytes = [0; 256];
        match self.port.read(&mut bytes) {
            Ok(0) => Err(io::ErrorKind::UnexpectedEof.into()),
            Ok(count) => {
                self.buffer.extend_from_slice(&bytes[..count]);
                Ok(true)
            }
            Err(error) => match error.kind() {
                io::ErrorKind::TimedOut
                | io::ErrorKind::WouldBlock
                | io::ErrorKind::Interrupted => Ok(false),
                _ => Err(error),
            },
        }
    }
}
