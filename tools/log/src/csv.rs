//! A recording as a table: a row for each frame, a column for each figure, after RFC 4180. `docs/logs.md` lists the columns.

use crate::state::ProgramState;
use std::fmt::Display;
use std::io::{self, Write};
use tip_runtime::model::TorqueUnit;
use tip_sim::urdf::frame::{foot, joint};
use tip_view::{Frame, LogEntry, Recording};

/// Writes the frames of a recording as CSV: [`FrameRate`](tip_view::FrameRate) says which cycles have one.
///
/// # Errors
/// It cannot be written there.
pub fn csv(recording: &Recording, mut out: impl Write) -> io::Result<()> {
    let mut table = Table::new(recording);
    write_row(&mut out, &table.head())?;
    for frame in &recording.frames {
        write_row(&mut out, &table.row(frame))?;
    }
    out.flush()
}

/// Fields with commas, quotes or ends of lines are quoted.
fn write_row(out: &mut impl Write, fields: &[String]) -> io::Result<()> {
    for (place, field) in fields.iter().enumerate() {
        let comma = if place > 0 { "," } else { "" };
        match field.contains([',', '"', '\r', '\n']) {
            true => write!(out, "{comma}\"{}\"", field.replace('"', "\"\""))?,
            false => write!(out, "{comma}{field}")?,
        }
    }
    out.write_all(b"\r\n")
}

/// The state that is kept from row to row.
struct Table<'a> {
    recording: &'a Recording,
    program: ProgramState<'a>,
    /// The entries of the log after the last row.
    to_come: &'a [LogEntry],
    /// The cycle after that of the last row.
    from: u64,
    /// True if the distances between the parts of the robot are known.
    has_gap: bool,
}

impl<'a> Table<'a> {
    fn new(recording: &'a Recording) -> Self {
        Table {
            recording,
            program: ProgramState::new(recording),
            to_come: &recording.log,
            from: 0,
            has_gap: recording.frames.iter().any(|frame| frame.gap.is_some()),
        }
    }

    fn head(&self) -> Vec<String> {
        let robot = &self.recording.robot;
        let mut head: Vec<String> = [
            "cycle", "time_ms", "step", "line", "command", "message", "flags", "lamps",
        ]
        .map(str::to_owned)
        .into();
        let mut add = |names: &[&str], before: &str| {
            head.extend(names.iter().map(|name| format!("{before}{name}")));
        };
        if robot.body.is_some() {
            add(
                &[
                    "x_mm",
                    "y_mm",
                    "z_mm",
                    "roll_deg",
                    "pitch_deg",
                    "yaw_deg",
                    "margin_mm",
                    "falls",
                ],
                "",
            );
        }
        if self.has_gap {
            add(&["clearance_mm", "nearest"], "");
        }
        let joints = || {
            let legs = (1..).zip(&robot.legs);
            legs.flat_map(|(leg, limb)| (1..).zip(&limb.joints).map(move |(of, _)| joint(leg, of)))
        };
        joints().for_each(|joint| add(&["_deg"], &joint));
        // As in the names of columns everywhere: letters alone.
        let unit = match robot.torque_unit {
            TorqueUnit::NewtonMetre => "Nm",
            TorqueUnit::MillinewtonMetre => "mNm",
        };
        joints().for_each(|joint| add(&[&format!("_{unit}")], &joint));
        for leg in (1..).take(robot.legs.len()) {
            add(&["_x_mm", "_y_mm", "_z_mm", "_N"], &foot(leg));
            if robot.body.is_some() {
                add(&["_slip_mm"], &foot(leg));
            }
        }
        if robot.slider.is_some() {
            add(&["x_mm", "y_mm", "z_mm"], "FLOOR_");
        }
        for (number, _) in (1..).zip(self.recording.scene.objects.iter().flatten()) {
            add(&["_x_mm", "_y_mm", "_deg"], &format!("object{number}"));
        }
        head.extend(self.recording.script.scalars.iter().cloned());
        head
    }

    fn row(&mut self, frame: &Frame) -> Vec<String> {
        let recording = self.recording;
        let cycle = frame.cycle;
        let count = self.to_come.partition_point(|entry| entry.cycle <= cycle);
        let (done, to_come) = self.to_come.split_at(count);
        self.to_come = to_come;
        done.iter().for_each(|entry| self.program.take(entry));
        let program = &self.program;
        let command = program.command.filter(|(at, _)| *at >= self.from);
        let mut row = vec![
            cycle.to_string(),
            number(frame.time),
            some(program.step(cycle)),
            some(program.line(cycle)),
            some(command.map(|(_, command)| command)),
            shown(program.message),
            words(&frame.flags),
            words(&program.lamps),
        ];
        self.from = cycle + 1;
        row.extend(self.body(frame));
        if self.has_gap {
            let distance = frame.gap.map(|gap| measured(gap.distance));
            row.extend([distance.unwrap_or_default(), some(frame.gap)]);
        }
        row.extend(frame.angles.iter().flatten().map(|angle| measured(*angle)));
        row.extend(
            frame
                .torques
                .iter()
                .flatten()
                .map(|torque| measured(*torque)),
        );
        for (leg, foot) in recording.robot.feet(frame).enumerate() {
            row.extend(foot.map(measured));
            row.push(
                frame
                    .loads
                    .get(leg)
                    .map(|load| measured(*load))
                    .unwrap_or_default(),
            );
            if recording.robot.body.is_some() {
                let slip = frame.slips.get(leg).copied();
                row.push(slip.map(measured).unwrap_or_default());
            }
        }
        row.extend(frame.slider.iter().flatten().map(|at| measured(*at)));
        for thing in &frame.objects {
            let [x, y, _] = thing.position;
            row.extend([x, y, thing.angle].map(measured));
        }
        row.extend(
            self.program
                .values
                .iter()
                .map(|value| value.map(number).unwrap_or_default()),
        );
        row
    }

    fn body(&self, frame: &Frame) -> Vec<String> {
        if self.recording.robot.body.is_none() {
            return Vec::new();
        }
        let falls = self.program.falls;
        let pose = frame.pose.map(|pose| {
            let [x, y, z] = pose.position;
            [x, y, z, pose.roll, pose.pitch, pose.yaw]
        });
        let pose = pose.map_or([const { String::new() }; 6], |pose| pose.map(measured));
        let margin = frame.margin.map(measured).unwrap_or_default();
        pose.into_iter()
            .chain([margin, falls.to_string()])
            .collect()
    }
}

/// Returns a text that spreadsheets show: an apostrophe comes before one that they would take for a
/// formula. A number stays one.
fn shown(text: &str) -> String {
    let begins = ['=', '+', '-', '@', '\t', '\r', '\n', '＝', '＋', '－', '＠'];
    let is_number = text.parse().is_ok_and(f64::is_finite);
    match text.starts_with(begins) && !is_number {
        true => format!("'{text}"),
        false => text.to_owned(),
    }
}

/// Least size of a measured number, in mm, deg, N, N·m or mN·m. What is smaller is an error of rounding.
const MIN_MEASURED: f64 = 1e-9;

/// Returns a measured number.
fn measured(value: f64) -> String {
    number(if value.abs() < MIN_MEASURED {
        0.0
    } else {
        value
    })
}

/// Returns a number that reads back to the same bits; −0 is 0. What is no number is an empty field.
fn number(value: f64) -> String {
    // What is far from 1 has an exponent, in place of a row of zeros.
    match value.abs() {
        size if !size.is_finite() => String::new(),
        0.0 => "0".to_owned(),
        size if (1e-5..1e16).contains(&size) => value.to_string(),
        _ => format!("{value:e}"),
    }
}

fn some(value: Option<impl Display>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

fn words<T: Display>(words: impl IntoIterator<Item = T>) -> String {
    let words: Vec<String> = words.into_iter().map(|word| word.to_string()).collect();
    words.join(" ")
}
