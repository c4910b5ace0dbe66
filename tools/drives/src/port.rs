//! A port of either kind: a serial port, or simulated servos in this process.

use crate::bus::Port;
use crate::serial::Serial;
use crate::simulated::MemoryPort;
use core::convert::Infallible;
use std::boxed::Box;
use std::io;

/// The name of a port with simulated servos.
pub const SIMULATED: &str = "simulated";

/// A serial port, or simulated servos.
#[derive(Debug)]
pub enum AnyPort {
    /// A serial port.
    Serial(Serial),
    /// Simulated servos, whose time passes when it is waited for.
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
