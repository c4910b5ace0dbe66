//! The messages of this project's own: what the program did, and how the robot stands.

use super::foxglove::{TIME, Timestamp};
use super::proto::{self, message, protobuf};
use prost::encoding::{bytes, double};
use prost_types::{DescriptorProto, FieldDescriptorProto, FileDescriptorProto};
use tip_sim::urdf::frame::foot;
use tip_view::{Frame, Recording};

protobuf! { same:
    State {
        timestamp: required message Timestamp = 1,
        cycle: required int64 i64 = 2,
        step: optional int64 i64 = 3,
        line: optional int64 i64 = 4,
        statement: optional string String = 5,
        command: optional string String = 6,
        flags: repeated string String = 7,
        torque_joints: repeated string String = 8,
        lamps: repeated int64 [packed = "false"] i64 = 9,
    }
    Body {
        timestamp: required message Timestamp = 1,
        x_mm: required double f64 = 2,
        y_mm: required double f64 = 3,
        z_mm: required double f64 = 4,
        roll_deg: required double f64 = 5,
        pitch_deg: required double f64 = 6,
        yaw_deg: required double f64 = 7,
    }
    Margin {
        timestamp: required message Timestamp = 1,
        margin_mm: required double f64 = 2,
        falls: required int64 i64 = 3,
    }
}

/// Returns the file of all of them.
pub(super) fn file(recording: &Recording) -> FileDescriptorProto {
    let feet = (1..).take(recording.robot.legs.len());
    let feet = (2..).zip(feet.map(|leg| format!("{}_N", foot(leg))));
    let mut loads = vec![time_field()];
    loads.extend(feet.map(|(number, name)| number_field(&name, number)));
    let mut messages = same();
    messages.push(message("Loads", loads));
    messages.push(Variables::of(&recording.script.scalars).descriptor());
    proto::file("tip.proto", "tip", "proto2", &[TIME], messages)
}

fn time_field() -> FieldDescriptorProto {
    proto::field("timestamp", 1, "required", "message", "Timestamp")
}

fn number_field(name: &str, number: i32) -> FieldDescriptorProto {
    proto::field(name, number, "optional", "double", "")
}

/// Returns a `tip.Body`.
pub(super) fn body(time: u64, frame: &Frame) -> Option<Body> {
    let pose = frame.pose?;
    let [x_mm, y_mm, z_mm] = pose.position;
    Some(Body {
        timestamp: Timestamp::of(time),
        x_mm,
        y_mm,
        z_mm,
        roll_deg: pose.roll,
        pitch_deg: pose.pitch,
        yaw_deg: pose.yaw,
    })
}

/// Returns a `tip.Margin`.
pub(super) fn margin(time: u64, frame: &Frame, falls: usize) -> Option<Margin> {
    Some(Margin {
        timestamp: Timestamp::of(time),
        margin_mm: frame.margin?,
        falls: falls as i64,
    })
}

/// Returns `tip.Loads`.
pub(super) fn loads(time: u64, frame: &Frame) -> Option<Vec<u8>> {
    let mut message = begun(time);
    for (field, load) in (2..).zip(&frame.loads) {
        double::encode(field, load, &mut message);
    }
    (!frame.loads.is_empty()).then_some(message)
}

/// Returns a message whose first field is its time.
fn begun(time: u64) -> Vec<u8> {
    let mut message = Vec::new();
    prost::encoding::message::encode(1, &Timestamp::of(time), &mut message);
    message
}

/// A field: its name, and its members, each with the place of a scalar. A scalar of its own is a member without a name.
type Field = (String, Vec<(Option<String>, usize)>);

/// The variables of a program as a message: `COUNT` is a field, `P.X` is field `X` of field `P`.
pub(super) struct Variables {
    fields: Vec<Field>,
    values: Vec<Option<f64>>,
}

impl Variables {
    /// Creates variables that have no values yet.
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

    /// Sets the value of a variable from now on.
    pub(super) fn set(&mut self, scalar: usize, value: f64) {
        if let Some(slot) = self.values.get_mut(scalar) {
            *slot = Some(value);
        }
    }

    /// Returns `tip.Variables`: those that have a value.
    pub(super) fn message(&self, time: u64) -> Vec<u8> {
        let mut message = begun(time);
        for (field, (_, members)) in (2..).zip(&self.fields) {
            match members.as_slice() {
                [(None, place)] => self.encode(field, *place, &mut message),
                members => {
                    let mut inner = Vec::new();
                    for (field, (_, place)) in (1..).zip(members) {
                        self.encode(field, *place, &mut inner);
                    }
                    bytes::encode(field, &inner, &mut message);
                }
            }
        }
        message
    }

    fn encode(&self, field: u32, place: usize, message: &mut Vec<u8>) {
        if let Some(Some(value)) = self.values.get(place) {
            double::encode(field, value, message);
        }
    }

    fn descriptor(&self) -> DescriptorProto {
        let (mut fields, mut inner) = (vec![time_field()], Vec::new());
        for (number, (name, members)) in (2..).zip(&self.fields) {
            let names = members.iter().filter_map(|(name, _)| name.as_ref());
            let names = (1..).zip(names);
            let names: Vec<_> = names
                .map(|(number, name)| number_field(name, number))
                .collect();
            if names.is_empty() {
                fields.push(number_field(name, number));
                continue;
            }
            // A message must not be called as its field is.
            let of = format!("Of_{name}");
            fields.push(proto::field(
                name,
                number,
                "optional",
                "message",
                &format!("/{of}"),
            ));
            inner.push(message(&of, names));
        }
        DescriptorProto {
            nested_type: inner,
            ..message("Variables", fields)
        }
    }
}
