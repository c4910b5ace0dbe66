//! The trace: one JSON object a line, with the motion of a simulated robot if it is asked for.

use super::{Cycle, Ending, Sink, state_hash};
use crate::command::{Command, FAST, Target, Value};
use crate::emergency::Emergency;
use crate::plant::{Clearance, Gap, Motion, Pose};
use crate::program::{End, Program};
use core::fmt::{self, Display, Write};
use std::string::String;
use std::vec::Vec;

/// Writes the trace of a run, one record for each cycle and a final one, in a form that two engines
/// share byte for byte. Keys keep their order; keys without content are left out. Numbers are in
/// the shortest form that reads back to the same bits.
#[derive(Clone, Debug)]
pub struct JsonLines<W> {
    out: W,
    result: fmt::Result,
    with_state: bool,
    with_motion: bool,
    /// The last record is not terminated yet.
    is_open: bool,
    /// Bits of every scalar before the step.
    scalars: Vec<Option<u64>>,
    say: Option<String>,
    appended: Option<String>,
    lamp: Option<(u8, bool)>,
    command: String,
}

impl<W: Write> JsonLines<W> {
    /// Writes to `out`; `with_state` ends each record with a hash of commands and measurements.
    pub fn new(out: W, with_state: bool) -> Self {
        JsonLines {
            out,
            result: Ok(()),
            with_state,
            with_motion: false,
            is_open: false,
            scalars: Vec::new(),
            say: None,
            appended: None,
            lamp: None,
            command: String::new(),
        }
    }

    /// Leaves each record open for the keys that [`motion`](Self::motion) adds after the cycle.
    #[must_use]
    pub fn with_motion(mut self) -> Self {
        self.with_motion = true;
        self
    }

    /// Ends the record of the last cycle with the robot's motion. Does nothing if the cycle has no
    /// record.
    pub fn motion(&mut self, motion: &MotionRecord<'_>) {
        if self.is_open && self.result.is_ok() {
            self.result = motion.write(&mut self.out);
        }
        self.close();
    }

    /// Terminates an open record.
    fn close(&mut self) {
        if core::mem::take(&mut self.is_open) && self.result.is_ok() {
            self.result = self.out.write_str("}\n");
        }
    }

    /// Writes the last record; `cycles` is the number of cycle records.
    pub fn end(&mut self, ending: Ending, cycles: u64) {
        self.close();
        let written = self.end_record(ending, cycles);
        self.result = self.result.and(written);
    }

    /// Returns the state of the output.
    ///
    /// # Errors
    /// The writer refused; the records after that place are missing.
    pub const fn result(&self) -> fmt::Result {
        self.result
    }

    /// Returns the writer.
    pub fn get_ref(&self) -> &W {
        &self.out
    }

    /// Returns the writer.
    pub fn get_mut(&mut self) -> &mut W {
        &mut self.out
    }

    /// Returns the writer.
    pub fn into_inner(self) -> W {
        self.out
    }

    fn end_record(&mut self, ending: Ending, cycles: u64) -> fmt::Result {
        let out = &mut self.out;
        match ending {
            Ending::Program(End::End) => out.write_str(r#"{"end":"END""#)?,
            Ending::Program(End::Exit) => out.write_str(r#"{"end":"EXIT""#)?,
            Ending::Interrupted => out.write_str(r#"{"end":"INTERRUPTED""#)?,
            Ending::Limit => out.write_str(r#"{"end":"LIMIT""#)?,
            Ending::Emergency(Emergency {
                fault,
                step,
                thread,
                ..
            }) => {
                out.write_str(r#"{"end":"EMERGENCY","error":"#)?;
                string(out, &fault)?;
                write!(out, r#","kind":"{}""#, fault.kind())?;
                if let Some(thread) = thread {
                    out.write_str(r#","thread":"#)?;
                    string(out, &thread.as_str())?;
                }
                write!(out, r#","step":{step}"#)?;
            }
        }
        writeln!(out, r#","cycles":{cycles}}}"#)
    }

    fn cycle_record(&mut self, cycle: &Cycle<'_>) -> fmt::Result {
        write!(self.out, r#"{{"cycle":{}"#, cycle.sample.cycle)?;
        if cycle.sub > 0 {
            write!(self.out, r#","sub":{}"#, cycle.sub)?;
        }
        if let Some(thread) = cycle.thread {
            self.out.write_str(r#","thread":"#)?;
            string(&mut self.out, &thread)?;
        }
        write!(self.out, r#","step":{}"#, cycle.step)?;
        if let Some(next) = cycle.next {
            write!(self.out, r#","next":{next}"#)?;
        }
        self.changes(cycle.program)?;
        let out = &mut self.out;
        if let Some(text) = &self.say {
            out.write_str(r#","say":"#)?;
            string(out, text)?;
        }
        if let Some(text) = &self.appended {
            out.write_str(r#","out":"#)?;
            string(out, text)?;
        }
        if let Some((device, on)) = self.lamp {
            write!(out, r#","lamp":{{"{device}":{on}}}"#)?;
        }
        if !self.command.is_empty() {
            write!(out, r#","cmd":[{}]"#, self.command)?;
        }
        if self.with_state && cycle.last {
            let hash = state_hash(cycle.sample.commands, cycle.sample.angles);
            write!(out, r#","state":"{hash:016x}""#)?;
        }
        Ok(())
    }

    fn formatted(&mut self, text: &dyn Display) -> String {
        let mut line = String::new();
        let written = write!(line, "{text}");
        self.result = self.result.and(written);
        line
    }

    /// Writes the key `set`: the assignments of the step, without those of the host before it.
    fn changes(&mut self, program: &dyn Program) -> fmt::Result {
        let mut opening = r#","set":{"#;
        for (index, before) in self.scalars.iter().enumerate() {
            let Some((name, Some(value))) = program.scalar(index) else {
                continue;
            };
            if *before == Some(value.to_bits()) {
                continue;
            }
            self.out.write_str(opening)?;
            string(&mut self.out, &name)?;
            write!(self.out, ":{value:?}")?;
            opening = ",";
        }
        if opening == "," {
            self.out.write_str("}")?;
        }
        Ok(())
    }
}

impl<W: Write> Sink for JsonLines<W> {
    fn begin(&mut self, program: &dyn Program) {
        self.say = None;
        self.appended = None;
        self.lamp = None;
        self.command.clear();
        self.scalars.clear();
        let scalars = (0..).map_while(|index| program.scalar(index));
        self.scalars
            .extend(scalars.map(|(_, value)| value.map(f64::to_bits)));
    }

    fn command(&mut self, command: &Command<'_>) {
        let written = write_command(&mut self.command, command);
        self.result = self.result.and(written);
    }

    fn say(&mut self, text: &dyn Display) {
        self.say = Some(self.formatted(text));
    }

    fn out(&mut self, text: &dyn Display) {
        self.appended = Some(self.formatted(text));
    }

    fn lamp(&mut self, device: u8, on: bool) {
        self.lamp = Some((device, on));
    }

    fn cycle(&mut self, cycle: &Cycle<'_>) {
        self.close();
        if self.result.is_ok() {
            self.result = self.cycle_record(cycle);
            self.is_open = true;
        }
        if !self.with_motion || !cycle.last {
            self.close();
        }
    }
}

/// Writes the members of `cmd`.
fn write_command(out: &mut String, command: &Command<'_>) -> fmt::Result {
    write!(out, r#""{}""#, command.op)?;
    if command.hs {
        write!(out, r#","{FAST}""#)?;
    }
    match command.target {
        Target::None => out.write_str(",null")?,
        target => write!(out, r#","{target}""#)?,
    }
    for value in command.values {
        match value {
            Value::Absolute(_) | Value::Fixed(_) => write!(out, ",{value}")?,
            Value::Relative(_) => write!(out, r#","{value}""#)?,
        }
    }
    Ok(())
}

/// Writes a JSON string; characters beyond ASCII stay as they are (RFC 8259 §7).
fn string(out: &mut impl Write, text: &dyn Display) -> fmt::Result {
    out.write_char('"')?;
    write!(Escaped(out), "{text}")?;
    out.write_char('"')
}

struct Escaped<'a, W>(&'a mut W);

impl<W: Write> Write for Escaped<'_, W> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for character in text.chars() {
            match character {
                '"' => self.0.write_str("\\\"")?,
                '\\' => self.0.write_str("\\\\")?,
                '\n' => self.0.write_str("\\n")?,
                '\r' => self.0.write_str("\\r")?,
                '\t' => self.0.write_str("\\t")?,
                '\0'..='\x1F' => write!(self.0, "\\u{:04x}", u32::from(character))?,
                _ => self.0.write_char(character)?,
            }
        }
        Ok(())
    }
}

/// The motion of a simulated robot in a cycle. Joints come leg by leg.
#[derive(Clone, Copy, Debug)]
pub struct MotionRecord<'a> {
    /// Pose of the body; `None` for a robot that stays where it is.
    pub pose: Option<Pose>,
    /// Motion of the body, if known.
    pub motion: Option<Motion>,
    /// Number of joints of each leg.
    pub joints_per_leg: usize,
    /// True joint angles, deg; empty if unknown.
    pub angles: &'a [f64],
    /// The load of each foot or the contact force of each fingertip, N; empty if unknown.
    pub loads: &'a [f64],
    /// The distances between the parts of the robot, if measured.
    pub clearance: Option<Clearance>,
}

impl MotionRecord<'_> {
    /// Writes the keys `pose`, `angles`, `loads`, `clearance`, `nearest`, `margin` and `falls`, each after a comma; then `zmp`,
    /// and `collisions`, `tips`, `slides`, `crossings`, `hurries` and `strays` once they are above 0.
    pub(super) fn write(&self, out: &mut impl Write) -> fmt::Result {
        if let Some(pose) = &self.pose {
            let [x, y, z] = pose.position;
            let pose = [x, y, z, pose.roll, pose.pitch, pose.yaw];
            out.write_str(r#","pose":"#)?;
            numbers(out, &pose)?;
        }
        if !self.angles.is_empty() {
            let mut opening = r#","angles":["#;
            for leg in self.angles.chunks(self.joints_per_leg.max(1)) {
                out.write_str(opening)?;
                numbers(out, leg)?;
                opening = ",";
            }
            out.write_char(']')?;
        }
        if !self.loads.is_empty() {
            out.write_str(r#","loads":"#)?;
            numbers(out, self.loads)?;
        }
        if let Some(clearance) = &self.clearance {
            let Gap {
                distance,
                parts: [one, other],
            } = clearance.now;
            write!(out, r#","clearance":{}"#, Number(distance))?;
            write!(out, r#","nearest":["{one}","{other}"]"#)?;
            counts(out, [("collisions", clearance.collisions)])?;
        }
        if let Some(Motion { margin, falls, .. }) = &self.motion {
            write!(out, r#","margin":{},"falls":{falls}"#, Number(*margin))?;
        }
        let Some(Motion {
            tracking_errors,
            unmodelled,
            ..
        }) = self.motion
        else {
            return Ok(());
        };
        if let Some(unmodelled) = unmodelled {
            write!(out, r#","zmp":{}"#, Number(unmodelled.zmp_margin))?;
            counts(
                out,
                [
                    ("tips", unmodelled.tips),
                    ("slides", unmodelled.slides),
                    ("crossings", unmodelled.crossings),
                ],
            )?;
        }
        counts(
            out,
            [
                ("hurries", tracking_errors.hurries),
                ("strays", tracking_errors.strays),
            ],
        )
    }
}

/// Writes the counts that are above 0.
fn counts<const N: usize>(out: &mut impl Write, counts: [(&str, u32); N]) -> fmt::Result {
    for (key, count) in counts.into_iter().filter(|(_, count)| *count > 0) {
        write!(out, r#","{key}":{count}"#)?;
    }
    Ok(())
}

/// A JSON number in the shortest form that reads back to the same bits; JSON has no infinity, which
/// becomes `null`.
struct Number(f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_finite() {
            write!(f, "{:?}", self.0)
        } else {
            f.write_str("null")
        }
    }
}

/// Writes an array.
fn numbers(out: &mut impl Write, values: &[f64]) -> fmt::Result {
    let mut opening = '[';
    for value in values {
        write!(out, "{opening}{}", Number(*value))?;
        opening = ',';
    }
    out.write_char(']')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::Fault;
    use crate::hardware::JointCommand;
    use crate::model::titan8;
    use crate::program::{Context, Flow, Signature};
    use crate::record::Sample;

    struct Variables(Vec<(&'static str, Option<f64>)>);

    impl Program for Variables {
        fn signature(&self) -> Signature {
            titan8::MODEL.signature()
        }
        fn name(&self) -> &str {
            ""
        }
        fn title(&self) -> &str {
            ""
        }
        fn at(&self) -> u32 {
            0
        }
        fn step(&mut self, _: &mut dyn Context) -> Result<Flow, Fault> {
            Ok(Flow::Next)
        }
        fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
            self.0.get(i).copied()
        }
        fn set_scalar(&mut self, i: usize, value: f64) {
            self.0[i].1 = Some(value);
        }
        fn line(&self, _: u32) -> u32 {
            0
        }
        fn reset(&mut self) {}
    }

    fn cycle(number: u64, step: u32, next: Option<u32>, program: &Variables) -> Cycle<'_> {
        Cycle {
            sub: 0,
            last: true,
            thread: None,
            step,
            next,
            program,
            sample: Sample {
                cycle: number,
                time: 0.0,
                joints_per_leg: 1,
                angles: &[0.0],
                commands: const { &[JointCommand::at(0.0)] },
                torques: &[],
                paws: &[],
                knobs: &[],
                antenna: 0.0,
            },
        }
    }

    // clauses: 3.3 3.4
    #[test]
    fn set_holds_what_changed_bit_by_bit_in_declaration_order() {
        let mut program = Variables(std::vec![
            ("VAR_KEY", None),
            ("A", None),
            ("P.X", Some(0.0)),
            ("Q.J2", Some(4.0)),
        ]);
        let mut trace = JsonLines::new(String::new(), false);
        trace.begin(&program);
        program.0[3].1 = Some(0.1 + 0.2);
        program.0[2].1 = Some(-0.0);
        program.0[1].1 = Some(1.0);
        trace.cycle(&cycle(0, 0, Some(1), &program));
        // Assigned again with the value that it has: no change.
        trace.begin(&program);
        program.0[1].1 = Some(1.0);
        trace.cycle(&cycle(1, 1, Some(2), &program));
        trace.begin(&program);
        program.0[0].1 = Some(65.0);
        trace.cycle(&cycle(2, 2, Some(3), &program));
        assert_eq!(
            trace.into_inner(),
            "{\"cycle\":0,\"step\":0,\"next\":1,\"set\":{\"A\":1.0,\"P.X\":-0.0,\"Q.J2\":0.30000000000000004}}\n\
         {\"cycle\":1,\"step\":1,\"next\":2}\n\
         {\"cycle\":2,\"step\":2,\"next\":3,\"set\":{\"VAR_KEY\":65.0}}\n"
        );
    }

    #[test]
    fn state_ends_the_record_in_sixteen_digits() {
        let program = Variables(std::vec![("VAR_KEY", None)]);
        let mut trace = JsonLines::new(String::new(), true);
        trace.begin(&program);
        let mut record = cycle(0, 0, Some(1), &program);
        record.sample.commands = &[];
        record.sample.angles = &[];
        trace.say(&"x");
        trace.cycle(&record);
        assert_eq!(
            trace.into_inner(),
            "{\"cycle\":0,\"step\":0,\"next\":1,\"say\":\"x\",\"state\":\"cbf29ce484222325\"}\n"
        );
    }

    // clauses: 8.1
    #[test]
    fn the_last_record_says_how_it_ended() {
        let last = |ending| {
            let mut trace = JsonLines::new(String::new(), true);
            trace.end(ending, 12);
            trace.into_inner()
        };
        assert_eq!(
            last(Ending::Program(End::End)),
            "{\"end\":\"END\",\"cycles\":12}\n"
        );
        assert_eq!(
            last(Ending::Program(End::Exit)),
            "{\"end\":\"EXIT\",\"cycles\":12}\n"
        );
        assert_eq!(
            last(Ending::Interrupted),
            "{\"end\":\"INTERRUPTED\",\"cycles\":12}\n"
        );
        assert_eq!(last(Ending::Limit), "{\"end\":\"LIMIT\",\"cycles\":12}\n");
        let emergency = Emergency {
            fault: Fault::OutOfReach(Target::Foot(1)),
            step: 4,
            cycle: 12,
            thread: None,
            stop_fault: None,
        };
        assert_eq!(
            last(Ending::Emergency(emergency)),
            "{\"end\":\"EMERGENCY\",\"error\":\"Out of reach F1\",\"kind\":\"RobotError\",\"step\":4,\"cycles\":12}\n"
        );
    }

    #[test]
    fn a_writer_that_refuses_is_remembered() {
        struct Full;
        impl Write for Full {
            fn write_str(&mut self, _: &str) -> fmt::Result {
                Err(fmt::Error)
            }
        }
        let mut trace = JsonLines::new(Full, false);
        assert_eq!(trace.result(), Ok(()));
        trace.end(Ending::Limit, 0);
        assert_eq!(trace.result(), Err(fmt::Error));
    }

    #[test]
    fn numbers_that_json_lacks_are_null() {
        let mut out = String::new();
        let all = [1.5, f64::NAN, -0.0, f64::INFINITY, f64::NEG_INFINITY, 1e300];
        assert_eq!(numbers(&mut out, &all), Ok(()));
        assert_eq!(out, "[1.5,null,-0.0,null,null,1e300]");
    }
}
