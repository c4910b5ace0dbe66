//! Opens the serial ports of `tip drives` and of runs on a robot.

use super::realtime;
use crate::error::Error;
use crate::message::Driving;
use std::path::Path;
use tip_drives::port::{AnyPort, SIMULATED};
use tip_drives::serial::{OpenError, Process, Serial};
use tipc::message::Lang;

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
        realtime::warn([Driving::Adapter { time }], lang);
    }
    Ok(AnyPort::Serial(opened))
}
