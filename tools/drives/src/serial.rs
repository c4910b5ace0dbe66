//! A serial port of this machine.

use crate::bus::Port;
use serial2::SerialPort;
use std::io;
use std::path::Path;
use std::string::String;
use std::time::{Duration, Instant};
use std::vec::Vec;
use std::{format, fs};

/// A serial port. What comes is buffered here, so that waiting for a byte may take it from the system.
#[derive(Debug)]
pub struct Serial {
    port: SerialPort,
    start: Instant,
    buffer: Vec<u8>,
}

impl Serial {
    /// Opens a port, such as `/dev/ttyUSB0`.
    ///
    /// # Errors
    /// There is no such port, it is in use, or the speed is not possible.
    pub fn open(path: &Path, baud: u32) -> io::Result<Self> {
        let mut port = SerialPort::open(path, baud)?;
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
        self.port.write(bytes)
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
