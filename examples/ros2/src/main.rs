//! `walk.prg` as a node of a ROS 2 graph: see the README beside it.
#![expect(clippy::disallowed_macros, reason = "an example prints")]

mod feedback;
mod messages;

use feedback::{Feedback, JOINTS, LEGS, name};
use messages::{
    DIAGNOSTICS, Diagnostics, Header, JOINT_STATE, JointState, KeyValue, Status, TEXT,
    TRIGGER_REPLY, TRIGGER_REQUEST, Text, Time, TriggerReply, TriggerRequest,
};
use rustdds::no_key::{DataReaderCdr, DataWriterCdr};
use rustdds::policy::{History, Reliability};
use rustdds::{DomainParticipant, Publisher, QosPolicies, QosPolicyBuilder, Subscriber, TopicKind};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::cell::RefCell;
use std::error::Error;
use std::rc::Rc;
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};
use std::{env, fmt};
use tip_runtime::console::Console;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};
use tip_runtime::machine::Machine;
use tip_runtime::model::titan8::MODEL;
use tip_runtime::program::Program;
use tip_runtime::realtime::Pacer;

tip_macros::include_tip!("../walk/motions/walk.prg");

/// The byte of the ESC key: a halt request.
const ESCAPE: u8 = 0x1B;

type Failure = Box<dyn Error>;

/// Makes topics, readers and writers with the quality that ROS has by default.
struct Graph {
    participant: DomainParticipant,
    publisher: Publisher,
    subscriber: Subscriber,
    qos: QosPolicies,
}

impl Graph {
    fn join(domain: u16) -> Result<Self, Failure> {
        let participant = DomainParticipant::new(domain)?;
        let qos = QosPolicyBuilder::new()
            .reliability(Reliability::Reliable {
                max_blocking_time: rustdds::Duration::from_millis(100),
            })
            .history(History::KeepLast { depth: 10 })
            .build();
        Ok(Graph {
            publisher: participant.create_publisher(&qos)?,
            subscriber: participant.create_subscriber(&qos)?,
            participant,
            qos,
        })
    }

    fn topic(&self, name: &str, kind: &str) -> Result<rustdds::Topic, Failure> {
        let (name, kind) = (name.to_owned(), kind.to_owned());
        let topic = self
            .participant
            .create_topic(name, kind, &self.qos, TopicKind::NoKey);
        Ok(topic?)
    }

    fn writer<D: Serialize>(&self, name: &str, kind: &str) -> Result<DataWriterCdr<D>, Failure> {
        let topic = self.topic(name, kind)?;
        Ok(self.publisher.create_datawriter_no_key_cdr(&topic, None)?)
    }

    fn reader<D: DeserializeOwned + 'static>(
        &self,
        name: &str,
        kind: &str,
    ) -> Result<DataReaderCdr<D>, Failure> {
        let topic = self.topic(name, kind)?;
        Ok(self.subscriber.create_datareader_no_key_cdr(&topic, None)?)
    }
}

/// Takes the next message; one that cannot be read is left out.
fn take<D: DeserializeOwned + 'static>(reader: &mut DataReaderCdr<D>) -> Option<D> {
    let sample = reader.take_next_sample().ok().flatten()?;
    Some(sample.into_value())
}

fn names() -> Vec<String> {
    let legs = (0..LEGS).flat_map(|leg| (0..JOINTS).map(move |joint| name(leg, joint)));
    legs.collect()
}

fn now() -> Time {
    let since = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .unwrap_or_default();
    Time {
        sec: since.as_secs() as i32,
        nanosec: since.subsec_nanos(),
    }
}

/// Commands that were published, and their answers.
#[derive(Debug, Default)]
struct Answers {
    /// Those that wait, oldest first.
    open: Vec<(Time, Instant)>,
    sent: u64,
    answered: u64,
    /// Round trips, µs.
    times: Vec<u32>,
}

/// The joints of the graph.
struct Wires {
    commands: DataWriterCdr<JointState>,
    states: DataReaderCdr<JointState>,
    feedback: Feedback,
    answers: Answers,
}

impl Wires {
    /// Takes all joint states that have come.
    fn listen(&mut self) {
        while let Some(state) = take(&mut self.states) {
            if !self.feedback.take(&state.name, &state.position) {
                continue;
            }
            // Feedback has the time of the command that it answers.
            let open = &mut self.answers.open;
            if let Some(place) = open
                .iter()
                .position(|(time, _)| *time == state.header.stamp)
            {
                let (_, sent) = open.remove(place);
                open.drain(..place);
                self.answers.answered += 1;
                self.answers.times.push(sent.elapsed().as_micros() as u32);
            }
        }
    }

    fn publish(
        &mut self,
        angles: impl Iterator<Item = f64>,
        rates: impl Iterator<Item = f64>,
    ) -> bool {
        let stamp = now();
        let state = JointState {
            header: Header {
                stamp,
                ..Header::default()
            },
            name: names(),
            position: angles.map(f64::to_radians).collect(),
            velocity: rates.map(f64::to_radians).collect(),
            effort: Vec::new(),
        };
        // Before anyone has answered, and between two peers, no answer is expected.
        if self.feedback.angles().is_ok() {
            self.answers.open.push((stamp, Instant::now()));
            self.answers.sent += 1;
        }
        self.commands.write(state, None).is_ok()
    }
}

impl Hardware<LEGS, JOINTS> for Wires {
    fn read(&mut self, into: &mut Sensors<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        self.listen();
        into.angles = self.feedback.angles().map_err(|(leg, joint)| {
            HardwareFault::new("no feedback on /joint_states").at_joint(leg, joint)
        })?;
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        let parts = outputs
            .joints
            .as_flattened()
            .iter()
            .map(|command| match *command {
                JointCommand::Angle { angle, rate } => (angle, rate),
                JointCommand::Torque(_) => (0.0, 0.0),
            });
        let (angles, rates): (Vec<f64>, Vec<f64>) = parts.unzip();
        let sent = self.publish(angles.into_iter(), rates.into_iter());
        sent.then_some(())
            .ok_or(HardwareFault::new("joint_commands"))
    }

    /// Says nothing more: the controller behind the topic holds its last command.
    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        Ok(())
    }
}

/// Keys that services press; messages go to standard output.
#[derive(Clone, Debug, Default)]
struct Keys(Rc<RefCell<Option<u8>>>);

impl Console for Keys {
    fn key(&mut self, _cycle: u64) -> Option<u8> {
        self.0.borrow_mut().take()
    }

    fn message(&mut self, text: &dyn fmt::Display) {
        println!("{text}");
    }
}

/// A service of the type `std_srvs/srv/Trigger`.
struct Service {
    requests: DataReaderCdr<TriggerRequest>,
    replies: DataWriterCdr<TriggerReply>,
}

impl Service {
    fn new(graph: &Graph, name: &str) -> Result<Self, Failure> {
        Ok(Service {
            requests: graph.reader(&format!("rq/tip/{name}Request"), TRIGGER_REQUEST)?,
            replies: graph.writer(&format!("rr/tip/{name}Reply"), TRIGGER_REPLY)?,
        })
    }

    /// Answers one request, if there is one.
    fn serve(&mut self, act: impl FnOnce() -> Result<(), String>) {
        let Some(request) = take(&mut self.requests) else {
            return;
        };
        let done = act();
        let reply = TriggerReply {
            client: request.client,
            number: request.number,
            success: done.is_ok(),
            message: done.err().unwrap_or_default(),
        };
        // A client that has left needs no answer.
        let _ = self.replies.write(reply, None);
    }
}

fn main() -> Result<(), Failure> {
    let mut arguments = env::args().skip(1);
    let cycles: u64 = arguments.next().map_or(Ok(u64::MAX), |it| it.parse())?;
    let domain = env::var("ROS_DOMAIN_ID").map_or(Ok(0), |it| it.parse())?;
    let graph = Graph::join(domain)?;
    let wires = Wires {
        commands: graph.writer("rt/joint_commands", JOINT_STATE)?,
        states: graph.reader("rt/joint_states", JOINT_STATE)?,
        feedback: Feedback::default(),
        answers: Answers::default(),
    };
    let keys = Keys::default();
    let mut start = Service::new(&graph, "start")?;
    let mut halt = Service::new(&graph, "halt")?;
    let mut set: DataReaderCdr<Text> = graph.reader("rt/tip/set", TEXT)?;
    let diagnostics: DataWriterCdr<Diagnostics> = graph.writer("rt/diagnostics", DIAGNOSTICS)?;
    let mut robot = Machine::new(Walk::new(), &MODEL, wires, keys.clone(), ())?;
    println!("waiting for feedback on /joint_states and for the service /tip/start");

    let (mut pacer, mut is_started) = (Pacer::start(), false);
    for cycle in 0..cycles {
        robot.hardware_mut().feedback.grow_older();
        let feedback = robot.hardware().feedback.angles();
        start.serve(|| {
            is_started |= feedback.is_ok();
            let missing = |(leg, joint)| format!("no position of J{leg}{joint} on /joint_states");
            feedback.map(|_| ()).map_err(missing)
        });
        halt.serve(|| {
            *keys.0.borrow_mut() = Some(ESCAPE);
            is_started
                .then_some(())
                .ok_or_else(|| "not started".to_owned())
        });
        while let Some(Text { data }) = take(&mut set) {
            let assigned = data.split_once('=').and_then(|(name, value)| {
                let value = value.trim().parse().ok()?;
                robot.program_mut().set(name.trim(), value).ok()
            });
            println!(
                "set {data}: {}",
                if assigned.is_some() {
                    "done"
                } else {
                    "refused"
                }
            );
        }
        let goes_on = if is_started {
            robot.cycle().is_running()
        } else {
            let initial = MODEL.legs.map(|leg| leg.initial);
            let angles = initial.as_flattened().iter().copied();
            let wires = robot.hardware_mut();
            wires.publish(angles, [0.0; LEGS * JOINTS].into_iter());
            true
        };
        if cycle % 50 == 0 || !goes_on {
            let message = match robot.emergency() {
                Some(emergency) => emergency.to_string(),
                None if !goes_on => "ended".to_owned(),
                None if is_started => "runs".to_owned(),
                None => "waits".to_owned(),
            };
            let level = if robot.emergency().is_some() { 2 } else { 0 };
            let values = [
                ("cycle", robot.cycles().to_string()),
                ("overruns", pacer.overruns().to_string()),
                ("answered", robot.hardware().answers.answered.to_string()),
            ];
            let values = values.map(|(key, value)| KeyValue {
                key: key.to_owned(),
                value,
            });
            let status = Status {
                level,
                name: "tip: walk".to_owned(),
                message,
                hardware_id: MODEL.name.to_owned(),
                values: values.into(),
            };
            let header = Header {
                stamp: now(),
                ..Header::default()
            };
            let status = vec![status];
            let _ = diagnostics.write(Diagnostics { header, status }, None);
        }
        let due = pacer.due(robot.period());
        while Instant::now() < due {
            robot.hardware_mut().listen();
            sleep(Duration::from_micros(500));
        }
        if !goes_on {
            break;
        }
    }
    let answers = &mut robot.hardware_mut().answers;
    answers.times.sort_unstable();
    let part = |part: f64| {
        let place = (answers.times.len() as f64 * part) as usize;
        let time = answers.times.get(place).or(answers.times.last());
        time.map_or(f64::NAN, |time| f64::from(*time) / 1000.0)
    };
    let (p50, p99) = (part(0.5), part(0.99));
    let Answers { sent, answered, .. } = answers;
    println!("{sent} commands, {answered} answered, p50 {p50:.2} ms, p99 {p99:.2} ms");
    let cycles = robot.cycles();
    println!("{cycles} cycles, {} overruns", pacer.overruns());
    match robot.emergency() {
        Some(emergency) => Err(emergency.to_string().into()),
        None => Ok(()),
    }
}
