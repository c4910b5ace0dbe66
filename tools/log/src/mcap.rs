//! A recording as an MCAP file, which Foxglove and Rerun show: `docs/logs.md` lists its topics.

mod messages;
mod scene;

use crate::state::ProgramState;
use ::mcap::records::MessageHeader;
use ::mcap::{McapResult, WriteOptions, Writer};
use messages::{Cdr, Encoding, State, Timestamp, Variables};
use prost::Message;
use scene::Stage;
use std::collections::BTreeMap;
use std::io::{self, Seek, Write};
use tip_sim::FallKind;
use tip_sim::urdf::frame;
use tip_view::{Frame, LogEntry, Occurrence, Recording};

/// Levels of infos and errors in `foxglove.Log`.
const INFO: i32 = 2;
const ERROR: i32 = 4;

/// Writes a recording as MCAP, with the robot as URDF, such as [`urdf::export`](tip_sim::urdf::export) gives. The same
/// recording gives the same bytes.
///
/// # Errors
/// It cannot be written there.
pub fn mcap(recording: &Recording, urdf: &str, out: impl Write + Seek) -> io::Result<()> {
    let file = Log::new(recording, out).and_then(|log| log.write(urdf));
    file.map_err(io::Error::other)
}

/// A file that is being written.
struct Log<'a, W: Write + Seek> {
    recording: &'a Recording,
    writer: Writer<W>,
    channels: BTreeMap<&'static str, Channel>,
    stage: Stage<'a>,
    variables: Variables,
    program: ProgramState<'a>,
    /// Positions of all joints in the frame before, and when that was: rad or m, ns.
    before: Option<(u64, Vec<f64>)>,
}

struct Channel {
    id: u16,
    /// Sequence number of its next message.
    sequence: u32,
}

/// Encoding and description of a topic's messages.
struct Topic {
    name: &'static str,
    schema: &'static str,
    encoding: Encoding,
}

const fn topic(name: &'static str, schema: &'static str, encoding: Encoding) -> Topic {
    Topic {
        name,
        schema,
        encoding,
    }
}

const DESCRIPTION: Topic = topic(
    "/robot_description",
    "std_msgs/msg/String",
    Encoding::Ros(messages::STRING),
);
const JOINTS: Topic = topic(
    "/joint_states",
    "sensor_msgs/msg/JointState",
    Encoding::Ros(messages::JOINT_STATE),
);
const FIXED: Topic = topic("/tf_static", "foxglove.FrameTransforms", Encoding::Foxglove);
const MOVING: Topic = topic("/tf", "foxglove.FrameTransforms", Encoding::Foxglove);
const SCENE: Topic = topic("/scene", "foxglove.SceneUpdate", Encoding::Foxglove);
const MESSAGES: Topic = topic("/tip/messages", "foxglove.Log", Encoding::Foxglove);
const STATE: Topic = topic("/tip/state", "tip.State", Encoding::Own);
const VARIABLES: Topic = topic("/tip/variables", "tip.Variables", Encoding::Own);
const BODY: Topic = topic("/tip/body", "tip.Body", Encoding::Own);
const MARGIN: Topic = topic("/tip/margin", "tip.Margin", Encoding::Own);
const CLEARANCE: Topic = topic("/tip/clearance", "tip.Clearance", Encoding::Own);
const LOADS: Topic = topic("/tip/loads", "tip.Loads", Encoding::Own);
const SLIPS: Topic = topic("/tip/slips", "tip.Slips", Encoding::Own);

impl<'a, W: Write + Seek> Log<'a, W> {
    fn new(recording: &'a Recording, out: W) -> McapResult<Self> {
        let options = WriteOptions::new()
            .compression(None)
            .profile("")
            .library("tip");
        Ok(Log {
            recording,
            writer: options.create(out)?,
            channels: BTreeMap::new(),
            stage: Stage::new(&recording.robot, &recording.scene),
            variables: Variables::of(&recording.script.scalars),
            program: ProgramState::new(recording),
            before: None,
        })
    }

    fn write(mut self, urdf: &str) -> McapResult<()> {
        let text = Cdr::new().text(urdf).into_bytes();
        self.put(&DESCRIPTION, 0, text)?;
        let fixed = scene::fixed(&self.recording.robot);
        self.send(&FIXED, 0, &scene::transforms(0, fixed))?;
        let log = &self.recording.log;
        let mut cycles = log.chunk_by(|one, next| one.cycle == next.cycle).peekable();
        for frame in &self.recording.frames {
            // What happens in a cycle stands before what the robot did until its end.
            while let Some(entries) = cycles.next_if(|of| of[0].cycle <= frame.cycle) {
                self.write_entries(entries)?;
            }
            self.frame(frame)?;
        }
        cycles.try_for_each(|entries| self.write_entries(entries))?;
        self.ending()?;
        self.writer.finish().map(drop)
    }

    /// Writes the motion of the robot until the end of a cycle.
    fn frame(&mut self, frame: &Frame) -> McapResult<()> {
        let (robot, time) = (&self.recording.robot, nanoseconds(frame.time));
        let moving = scene::moving(robot, frame);
        self.send(&MOVING, time, &scene::transforms(time, moving))?;
        let joints = self.joints(time, frame);
        self.put(&JOINTS, time, joints)?;
        let scene = self.stage.update(time, frame);
        self.send(&SCENE, time, &scene)?;
        self.send(&STATE, time, &self.state(time, frame.cycle, Some(frame)))?;
        if let Some(body) = messages::body(time, frame) {
            self.send(&BODY, time, &body)?;
        }
        if let Some(margin) = messages::margin(time, frame, self.program.falls) {
            self.send(&MARGIN, time, &margin)?;
        }
        if let Some(clearance) = messages::clearance(time, frame) {
            self.send(&CLEARANCE, time, &clearance)?;
        }
        for (topic, values) in [(&LOADS, &frame.loads), (&SLIPS, &frame.slips)] {
            if let Some(message) = messages::of_feet(time, values) {
                self.put(topic, time, message)?;
            }
        }
        Ok(())
    }

    /// Returns a `sensor_msgs/msg/JointState`: rad, rad/s and N·m; of a slider m, m/s and 0.
    fn joints(&mut self, time: u64, frame: &Frame) -> Vec<u8> {
        let robot = &self.recording.robot;
        let (mut names, mut positions, mut efforts) = (Vec::new(), Vec::new(), Vec::new());
        for (leg, angles) in (1..).zip(&frame.angles) {
            names.extend((1..).zip(angles).map(|(joint, _)| frame::joint(leg, joint)));
            positions.extend(angles.iter().map(|angle| angle.to_radians()));
        }
        efforts.extend(
            frame
                .torques
                .concat()
                .iter()
                .map(|torque| torque / robot.torque_unit.per_newton_metre()),
        );
        if let (Some(slider), Some(at)) = (&robot.slider, frame.slider) {
            for (name, position) in frame::slide(slider, at) {
                names.push(name.to_owned());
                positions.push(position);
                efforts.push(0.0);
            }
        }
        let velocities = match &self.before {
            Some((before, places)) if *before < time => {
                let seconds = (time - before) as f64 / 1e9;
                let moved = positions.iter().zip(places);
                moved
                    .map(|(now, before)| (now - before) / seconds)
                    .collect()
            }
            _ => vec![0.0; positions.len()],
        };
        const SECOND: u64 = 1_000_000_000;
        let cdr = Cdr::new()
            .number((time / SECOND) as u32)
            .number((time % SECOND) as u32)
            .text("")
            .texts(&names)
            .doubles(&positions)
            .doubles(&velocities)
            .doubles(&efforts);
        self.before = Some((time, positions));
        cdr.into_bytes()
    }

    /// Returns the state of the program in a cycle.
    fn state(&self, time: u64, cycle: u64, frame: Option<&Frame>) -> State {
        let recording = self.recording;
        let program = &self.program;
        let line = program.line(cycle);
        let number = line.and_then(|line| (line as usize).checked_sub(1));
        let statement = number.and_then(|number| recording.script.text.lines().nth(number));
        let command = program.command.filter(|(at, _)| *at == cycle);
        let statement = statement.unwrap_or_default().trim();
        let step = program.step(cycle).filter(|_| line.is_some());
        let flags = frame.iter().flat_map(|frame| &frame.flags);
        let joints = frame.iter().flat_map(|frame| &frame.torque_joints);
        State {
            timestamp: Timestamp::of(time),
            cycle: cycle as i64,
            step: step.map(i64::from),
            line: line.map(i64::from),
            statement: line.map(|_| statement.to_owned()),
            command: command.map(|(_, command)| command.to_string()),
            flags: flags.map(ToString::to_string).collect(),
            torque_joints: joints.map(ToString::to_string).collect(),
            lamps: program.lamps.iter().map(|lamp| i64::from(*lamp)).collect(),
        }
    }

    /// Writes the entries of one cycle. Each of its messages has the values and lamps of its end.
    fn write_entries(&mut self, entries: &'a [LogEntry]) -> McapResult<()> {
        let cycle = entries[0].cycle;
        let time = nanoseconds(self.recording.time(cycle));
        entries.iter().for_each(|entry| self.program.take(entry));
        let is_set = |entry: &LogEntry| matches!(entry.what, Occurrence::Assigned { .. });
        if entries.iter().any(is_set) {
            let variables = self.variables.message(time, &self.program.values);
            self.put(&VARIABLES, time, variables)?;
        }
        for entry in entries {
            match &entry.what {
                Occurrence::Step(_) => self.send(&STATE, time, &self.state(time, cycle, None))?,
                Occurrence::Message(text) => self.say(cycle, INFO, text)?,
                Occurrence::Fall { kind, .. } => {
                    let kind = kind.unwrap_or(FallKind::Fell);
                    self.say(cycle, ERROR, &kind.to_string())?;
                }
                Occurrence::Collision(Some([one, other])) => {
                    self.say(cycle, ERROR, &format!("{one} and {other} overlap"))?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// Writes a `foxglove.Log`.
    fn say(&mut self, cycle: u64, level: i32, text: &str) -> McapResult<()> {
        let (script, time) = (
            &self.recording.script,
            nanoseconds(self.recording.time(cycle)),
        );
        let message = messages::Log {
            timestamp: Timestamp::of(time),
            level,
            message: text.to_owned(),
            name: self.recording.robot.name.clone(),
            file: script.name.clone(),
            line: self.program.line(cycle).unwrap_or_default(),
        };
        self.send(&MESSAGES, time, &message)
    }

    /// Writes the end of the run, among the messages.
    fn ending(&mut self) -> McapResult<()> {
        let recording = self.recording;
        let level = if recording.outcome.is_emergency() {
            ERROR
        } else {
            INFO
        };
        self.say(recording.cycles, level, &recording.outcome.to_string())
    }

    fn send(&mut self, topic: &Topic, time: u64, message: &impl Message) -> McapResult<()> {
        self.put(topic, time, message.encode_to_vec())
    }

    /// Writes a message at a time of the run, ns.
    fn put(&mut self, topic: &Topic, time: u64, bytes: Vec<u8>) -> McapResult<()> {
        let channel = match self.channels.get_mut(topic.name) {
            Some(channel) => channel,
            None => {
                let id = self.open(topic)?;
                let channel = Channel { id, sequence: 0 };
                self.channels.entry(topic.name).or_insert(channel)
            }
        };
        let header = MessageHeader {
            channel_id: channel.id,
            sequence: channel.sequence,
            log_time: time,
            publish_time: time,
        };
        channel.sequence += 1;
        self.writer.write_to_known_channel(&header, &bytes)
    }

    /// Opens the channel of a topic.
    fn open(&mut self, topic: &Topic) -> McapResult<u16> {
        let (schema_encoding, encoding) = match topic.encoding {
            Encoding::Ros(_) => ("ros2msg", "cdr"),
            Encoding::Foxglove | Encoding::Own => ("protobuf", "protobuf"),
        };
        // A schema that is there already is not written again.
        let data = topic.encoding.definition(self.recording);
        let schema = self
            .writer
            .add_schema(topic.schema, schema_encoding, &data)?;
        self.writer
            .add_channel(schema, topic.name, encoding, &BTreeMap::new())
    }
}

/// Converts ms to ns.
fn nanoseconds(milliseconds: f64) -> u64 {
    (milliseconds * 1e6).round() as u64
}
