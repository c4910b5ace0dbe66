//! TITAN.LOG: the sampled rows of a run.

use super::Sample;
use crate::command::{Port, Target};
use core::fmt;
use std::vec::Vec;

/// Default number of rows: 200 s at 20 ms.
const ROWS: usize = 10_000;

/// A bounded buffer of samples; when it is full, sampling stops (T.I.P. 3.1 §7-10-5).
///
/// `Display` writes a table with one tab between columns and a heading line: `cycle`, `time` (ms),
/// measured angles `J11…` (deg), commands sent `C11…` (deg, or the torque unit under torque
/// control), measured torques `T11…` where the robot senses them, `PAW1…`, `VR1…VR3`, `ANTENNA`
/// (V).
#[derive(Clone, Debug)]
pub struct TitanLog {
    capacity: usize,
    shape: Shape,
    cycles: Vec<u64>,
    /// The values row by row, without the cycle.
    values: Vec<f64>,
}

/// Number of columns of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Shape {
    joints_per_leg: usize,
    joints: usize,
    torques: usize,
    paws: usize,
    knobs: usize,
}

impl Shape {
    fn of(sample: &Sample<'_>) -> Self {
        Shape {
            joints_per_leg: sample.joints_per_leg,
            joints: sample.angles.len(),
            torques: sample.torques.len(),
            paws: sample.paws.len(),
            knobs: sample.knobs.len(),
        }
    }

    /// Returns the number of values in a row: time and antenna, and two for each joint, besides the
    /// rest.
    const fn width(self) -> usize {
        2 + 2 * self.joints + self.torques + self.paws + self.knobs
    }
}

impl Default for TitanLog {
    fn default() -> Self {
        Self::with_capacity(ROWS)
    }
}

impl TitanLog {
    /// Keeps at most `rows` rows. Memory is allocated once, with the first row.
    pub fn with_capacity(rows: usize) -> Self {
        TitanLog {
            capacity: rows,
            shape: Shape::default(),
            cycles: Vec::new(),
            values: Vec::new(),
        }
    }

    /// Returns the number of rows.
    pub const fn len(&self) -> usize {
        self.cycles.len()
    }

    /// Returns true if nothing was sampled.
    pub const fn is_empty(&self) -> bool {
        self.cycles.is_empty()
    }

    /// Adds a row, unless the buffer is full or the row has another shape than those before.
    pub fn push(&mut self, sample: &Sample<'_>) {
        if self.is_empty() {
            self.shape = Shape::of(sample);
            self.cycles.reserve_exact(self.capacity);
            self.values
                .reserve_exact(self.capacity.saturating_mul(self.shape.width()));
        }
        if self.len() >= self.capacity || self.shape != Shape::of(sample) {
            return;
        }
        self.cycles.push(sample.cycle);
        self.values.push(sample.time);
        self.values.extend_from_slice(sample.angles);
        let commands = sample.commands.iter().map(|command| command.value());
        self.values.extend(commands);
        self.values.extend_from_slice(sample.torques);
        self.values.extend_from_slice(sample.paws);
        self.values.extend_from_slice(sample.knobs);
        self.values.push(sample.antenna);
    }

    /// Truncates to `rows` rows; does nothing if there are fewer.
    pub fn truncate(&mut self, rows: usize) {
        self.cycles.truncate(rows);
        self.values
            .truncate(rows.saturating_mul(self.shape.width()));
    }

    fn joint_headings(
        &self,
        f: &mut fmt::Formatter<'_>,
        letter: &str,
        count: usize,
    ) -> fmt::Result {
        for index in 0..count {
            let (leg, joint) = (
                index / self.shape.joints_per_leg.max(1) + 1,
                index % self.shape.joints_per_leg.max(1) + 1,
            );
            write!(f, "\t{letter}{leg}{joint}")?;
        }
        Ok(())
    }

    fn headings(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("cycle\ttime")?;
        self.joint_headings(f, Target::Joint(1, 1).stem(), self.shape.joints)?;
        self.joint_headings(f, "C", self.shape.joints)?;
        self.joint_headings(f, "T", self.shape.torques)?;
        for paw in (1..).take(self.shape.paws) {
            write!(f, "\t{}", Port::Paw(paw))?;
        }
        for knob in (1..).take(self.shape.knobs) {
            write!(f, "\t{}", Port::Knob(knob))?;
        }
        writeln!(f, "\t{}", Port::Antenna)
    }
}

impl fmt::Display for TitanLog {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.headings(f)?;
        let rows = self.values.chunks(self.shape.width());
        for (cycle, row) in self.cycles.iter().zip(rows) {
            write!(f, "{cycle}")?;
            for value in row {
                write!(f, "\t{value:?}")?;
            }
            f.write_str("\n")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hardware::JointCommand;
    use std::string::ToString;

    fn sample(cycle: u64) -> Sample<'static> {
        Sample {
            cycle,
            time: 20.0 * cycle as f64,
            joints_per_leg: 1,
            angles: &[1.5, -2.0],
            commands: const { &[JointCommand::at(1.0), JointCommand::Torque(0.25)] },
            torques: &[],
            paws: &[3.0, 0.0],
            knobs: &[0.5],
            antenna: 0.0,
        }
    }

    // clauses: 7.40 9.5
    #[test]
    fn the_table_has_a_heading_and_one_row_for_each_sample() {
        let mut log = TitanLog::with_capacity(10);
        log.push(&sample(3));
        log.push(&sample(7));
        assert_eq!(
            log.to_string(),
            "cycle\ttime\tJ11\tJ21\tC11\tC21\tPAW1\tPAW2\tVR1\tANTENNA\n\
             3\t60.0\t1.5\t-2.0\t1.0\t0.25\t3.0\t0.0\t0.5\t0.0\n\
             7\t140.0\t1.5\t-2.0\t1.0\t0.25\t3.0\t0.0\t0.5\t0.0\n"
        );
    }

    // clauses: 7.40
    #[test]
    fn sampling_stops_when_the_buffer_is_full() {
        let mut log = TitanLog::with_capacity(2);
        for cycle in 0..5 {
            log.push(&sample(cycle));
        }
        assert_eq!(log.len(), 2);
        let text = log.to_string();
        assert!(text.contains("\n1\t") && !text.contains("\n2\t"));
    }
}
