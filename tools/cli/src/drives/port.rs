//! The ports of `tip drives` and of runs on a robot: a serial port, or simulated servos in this process.

use super::realtime;
use crate::error::Error;
use crate::message::Driving;
use std::convert::Infallible;
use std::io;
use std::path::Path;
use tip_drives::bus::Port;
use tip_drives::serial::{OpenError, Process, Serial};
use tip_drives::simulated::MemoryPort;
use tipc::message::Lang;

/// The name of a port with simulated servos.
pub(super) const SIMULATED: &str = "simulated";

/// A serial port, or simulated servos.
#[derive(Debug)]
pub(crate) enum AnyPort {
    Serial(Serial),
    Memory(Box<MemoryPort>),
}

fn never<T>(never: Result<T, Infallible>) -> io::Result<T> {
    never.map_err(|never| match never {})
}

impl embedded_io::ErrorType for AnyPort {
    type Error = io::Error;
}

impl embedded_io::Read for AnyPort {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match self {
            AnyPort::Serial(port) => port.read(into),
            AnyPort::Memory(port) => never(port.read(into)),
        }
    }
}

impl embedded_io::Write for AnyPort {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            AnyPort::Serial(port) => port.write(bytes),
            AnyPort::Memory(port) => never(port.write(bytes)),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            AnyPort::Serial(port) => port.flush(),
            AnyPort::Memory(port) => never(port.flush()),
        }
    }
}

impl Port for AnyPort {
    fn now(&mut self) -> u64 {
        match self {
            AnyPort::Serial(port) => port.now(),
            AnyPort::Memory(port) => port.now(),
        }
    }

    fn wait(&mut self, until: u64) -> io::Result<bool> {
        match self {
            AnyPort::Serial(port) => port.wait(until),
            AnyPort::Memory(port) => never(port.wait(until)),
        }
    }
}

pub(crate) fn open_serial(port: &str, baud: u32, lang: Lang) -> Result<AnyPort, Error> {
    let opened = Serial::open(Path::new(port), baud).map_err(|error| {
        let name = port.to_owned().into();
        let reason = match error {
            _ if port.split(':').next() == Some(SIMULATED) => Driving::NoSimulatedPort,
            OpenError::InUse(Some(Process { id, name: process })) => Driving::PortInUse {
                port: name,
                process: process.into(),
                id,
            },
            OpenError::InUse(None) => Driving::PortTaken { port: name },
            OpenError::Io(error) => Driving::CannotOpen {
                port: name,
                error: error.to_string().into(),
            },
        };
        Error::failed(reason, lang)
    })?;
    if let Some(time) = Serial::latency_timer(Path::new(port)).filter(|time| *time > 2) {
        realtime::warn(&[Driving::Adapter { time }], lang);
    }
    Ok(AnyPort::Serial(opened))
}
