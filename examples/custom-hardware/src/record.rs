//! A table of targets against measurements, written while the robot runs.

use crate::description::{JOINTS, LEGS};
use std::io::{self, Write};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Outputs, Sensors};

/// Any hardware, with a CSV row written for each cycle.
#[derive(Debug)]
pub struct Recorded<H, W> {
    inner: H,
    table: W,
    measured: [[f64; JOINTS]; LEGS],
    time: f64,
    failure: Option<io::Error>,
}

impl<H, W: Write> Recorded<H, W> {
    /// Records `inner` into `table`, whose header is written here.
    ///
    /// # Errors
    /// `table` cannot be written.
    pub fn new(inner: H, mut table: W) -> io::Result<Self> {
        writeln!(table, "{}", header())?;
        Ok(Recorded {
            inner,
            table,
            measured: [[0.0; JOINTS]; LEGS],
            time: 0.0,
            failure: None,
        })
    }

    /// The hardware that is recorded.
    pub fn inner_mut(&mut self) -> &mut H {
        &mut self.inner
    }

    /// Ends the table.
    ///
    /// # Errors
    /// The first error that writing met; the rows after it are missing.
    pub fn finish(&mut self) -> io::Result<()> {
        match self.failure.take() {
            Some(error) => Err(error),
            None => self.table.flush(),
        }
    }

    /// A full disk must not stop a robot in mid-motion: the error waits for [`finish`](Self::finish).
    fn note(&mut self, outputs: &Outputs<LEGS, JOINTS>) {
        if self.failure.is_none() {
            self.failure = self.row(outputs).err();
        }
        self.time += outputs.period;
    }

    fn row(&mut self, outputs: &Outputs<LEGS, JOINTS>) -> io::Result<()> {
        write!(self.table, "{}", self.time)?;
        let told = outputs.joints.iter().flatten();
        for (target, measured) in told.zip(self.measured.iter().flatten()) {
            write!(self.table, ",{:.3},{measured:.3}", target.value())?;
        }
        writeln!(self.table)
    }
}

impl<H: Hardware<LEGS, JOINTS>, W: Write> Hardware<LEGS, JOINTS> for Recorded<H, W> {
    fn read(&mut self, into: &mut Sensors<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        self.inner.read(into)?;
        self.measured = into.angles;
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        self.note(outputs);
        self.inner.write(outputs)
    }

    fn stop(&mut self, why: &Fault) {
        self.inner.stop(why);
    }
}

fn header() -> String {
    let mut header = String::from("time_ms");
    for leg in 1..=LEGS {
        for joint in 1..=JOINTS {
            header += &format!(",J{leg}{joint}_target,J{leg}{joint}_measured");
        }
    }
    header
}
