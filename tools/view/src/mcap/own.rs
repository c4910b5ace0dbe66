//! The messages of this project's own: what the program did, and how the robot stands.

use super::foxglove::timestamp;
use super::schema::{File, Type};
use super::wire::Message;
use crate::recording::{Frame, Recording};
use crate::skeleton::Skeleton;
use std::collections::BTreeSet;
use tip_sim::urdf::frame::foot;

const TIME: (&str, &str) = ("timestamp", ".google.protobuf.Timestamp");

/// The file of all of them: those of variables and loads depend on the program and the robot.
pub(super) fn file(recording: &Recording) -> File {
    let state = [
        TIME,
        ("cycle", "int64"),
        ("step", "int64"),
        ("line", "int64"),
        ("statement", "string"),
        ("command", "string"),
        ("flags", "repeated string"),
        ("torque_joints", "repeated string"),
        ("lamps", "repeated int64"),
    ];
    let body = [
        TIME,
        ("x_mm", "double"),
        ("y_mm", "double"),
        ("z_mm", "double"),
        ("roll_deg", "double"),
        ("pitch_deg", "double"),
        ("yaw_deg", "double"),
    ];
    let margin = [TIME, ("margin_mm", "double"), ("falls", "int64")];
    File {
        name: "tip.proto",
        package: "tip",
        has_presence: true,
        needs: &["google/protobuf/timestamp.proto"],
        types: vec![
            Type::row("State", &state, ""),
            Type::row("Body", &body, ""),
            Type::row("Margin", &margin, ""),
            loads_type(&recording.robot),
            Variables::of(&recording.script.scalars).kind(),
        ],
    }
}

fn loads_type(robot: &Skeleton) -> Type {
    let feet = (1..)
        .take(robot.legs.len())
        .map(|leg| (format!("{}_N", foot(leg)), "double".to_owned()));
    let time = (TIME.0.to_owned(), TIME.1.to_owned());
    Type {
        name: "Loads".to_owned(),
        fields: [time].into_iter().chain(feet).collect(),
        ..Type::default()
    }
}

/// `tip.State`
pub(super) struct State<'a> {
    pub(super) cycle: u64,
    pub(super) step: Option<u32>,
    pub(super) line: Option<u32>,
    pub(super) statement: &'a str,
    /// The command that is accepted in this cycle.
    pub(super) command: Option<String>,
    pub(super) frame: Option<&'a Frame>,
    /// Those that are on.
    pub(super) lamps: &'a BTreeSet<u8>,
}

impl State<'_> {
    pub(super) fn message(&self, time: u64) -> Message {
        let mut message = Message::new()
            .message(1, &timestamp(time))
            .number(2, self.cycle);
        if let (Some(step), Some(line)) = (self.step, self.line) {
            message = message
                .number(3, step)
                .number(4, line)
                .text(5, self.statement);
        }
        if let Some(command) = &self.command {
            message = message.text(6, command);
        }
        for flag in self.frame.iter().flat_map(|frame| &frame.flags) {
            message = message.text(7, &flag.to_string());
        }
        for joint in self.frame.iter().flat_map(|frame| &frame.torque_joints) {
            message = message.text(8, &joint.to_string());
        }
        let lamps = self.lamps.iter();
        lamps.fold(message, |message, lamp| message.number(9, *lamp))
    }
}

/// `tip.Body`
pub(super) fn body(time: u64, frame: &Frame) -> Option<Message> {
    let pose = frame.pose?;
    let [x, y, z] = pose.position;
    let values = [x, y, z, pose.roll, pose.pitch, pose.yaw];
    Some(doubles(time, &values))
}

/// `tip.Loads`
pub(super) fn loads(time: u64, frame: &Frame) -> Option<Message> {
    (!frame.loads.is_empty()).then(|| doubles(time, &frame.loads))
}

/// `tip.Margin`
pub(super) fn margin(time: u64, frame: &Frame, falls: u64) -> Option<Message> {
    let message = Message::new().message(1, &timestamp(time));
    Some(message.double(2, frame.margin?).number(3, falls))
}

/// The time, then numbers in the fields from 2 on.
fn doubles(time: u64, values: &[f64]) -> Message {
    let begin = Message::new().message(1, &timestamp(time));
    let values = (2..).zip(values);
    values.fold(begin, |message, (field, value)| {
        message.double(field, *value)
    })
}

/// A field: its name, and its members, each with the place of a scalar. A scalar of its own is a member without a name.
type Field = (String, Vec<(Option<String>, usize)>);

/// The variables of a program as a message: `COUNT` is a field, `P.X` is field `X` of field `P`.
pub(super) struct Variables {
    fields: Vec<Field>,
    values: Vec<Option<f64>>,
}

impl Variables {
    /// None has a value yet.
    pub(super) fn of(scalars: &[String]) -> Self {
        let mut fields: Vec<Field> = Vec::new();
        for (place, name) in scalars.iter().enumerate() {
            let (name, member) = match name.split_once('.') {
                Some((name, member)) => (name, Some(member.to_owned())),
                None => (name.as_str(), None),
            };
            match fields
                .last_mut()
                .filter(|(last, _)| member.is_some() && last == name)
            {
                Some((_, members)) => members.push((member, place)),
                None => fields.push((name.to_owned(), vec![(member, place)])),
            }
        }
        Variables {
            fields,
            values: vec![None; scalars.len()],
        }
    }

    /// A variable has this value from now on.
    pub(super) fn set(&mut self, scalar: usize, value: f64) {
        if let Some(slot) = self.values.get_mut(scalar) {
            *slot = Some(value);
        }
    }

    /// `tip.Variables`: those that have a value.
    pub(super) fn message(&self, time: u64) -> Message {
        let mut message = Message::new().message(1, &timestamp(time));
        for (field, (_, members)) in (2..).zip(&self.fields) {
            message = match members.as_slice() {
                [(None, place)] => self.double(message, field, *place),
                members => {
                    let members = (1..).zip(members);
                    let inner = members.fold(Message::new(), |inner, (field, (_, place))| {
                        self.double(inner, field, *place)
                    });
                    message.message(field, &inner)
                }
            };
        }
        message
    }

    fn double(&self, message: Message, field: u32, place: usize) -> Message {
        match self.values.get(place).copied().flatten() {
            Some(value) => message.double(field, value),
            None => message,
        }
    }

    fn kind(&self) -> Type {
        let mut kind = Type::row("Variables", &[TIME], "");
        for (name, members) in &self.fields {
            let names: Vec<&String> = members
                .iter()
                .filter_map(|(name, _)| name.as_ref())
                .collect();
            if names.is_empty() {
                kind.fields.push((name.clone(), "double".to_owned()));
                continue;
            }
            // A message must not be called as its field is.
            let inner = format!("Of_{name}");
            kind.fields.push((name.clone(), format!("/{inner}")));
            kind.inner.push(Type {
                name: inner,
                fields: names
                    .iter()
                    .map(|name| ((*name).clone(), "double".to_owned()))
                    .collect(),
                ..Type::default()
            });
        }
        kind
    }
}
