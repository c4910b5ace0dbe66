//! The messages of a file: those of Foxglove, field by field as published, those of this project, and those of ROS 2; and the
//! descriptions that readers need to decode them.

use prost::Message as _;
use prost::encoding::{bytes, double};
use prost_types::field_descriptor_proto::{Label, Type};
use prost_types::{
    DescriptorProto, EnumDescriptorProto, EnumValueDescriptorProto, FieldDescriptorProto,
    FileDescriptorProto, FileDescriptorSet,
};
use tip_sim::urdf::frame::foot;
use tip_view::{Frame, Recording};

/// Encoding of a topic's messages.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Encoding {
    Foxglove,
    Own,
    /// ROS 2 message, with the text of its definition.
    Ros(&'static str),
}

impl Encoding {
    /// Returns the definition of a message, or the files of messages that it needs, each after
    /// those that it needs itself.
    pub(super) fn definition(self, recording: &Recording) -> Vec<u8> {
        let file = match self {
            Encoding::Ros(definition) => return definition.as_bytes().to_vec(),
            Encoding::Foxglove => vec![time_file(), duration_file(), foxglove_file()],
            Encoding::Own => vec![time_file(), own_file(recording)],
        };
        FileDescriptorSet { file }.encode_to_vec()
    }
}

/// Declares messages, and a function that returns their descriptors. Each field has its label, its type in Protocol Buffers and
/// in Rust, and its number. What is `required` is written even if it is 0: readers need not know the default.
macro_rules! protobuf {
    ($all:ident: $($name:ident {
        $($field:ident: $label:ident $kind:ident $([$($option:tt)*])? $type:ident = $tag:literal,)*
    })*) => {
        $(
            #[derive(Clone, PartialEq, prost::Message)]
            pub(super) struct $name {
                $(
                    #[prost($kind, $label, $($($option)*,)? tag = $tag)]
                    pub(super) $field: labelled!($label $type),
                )*
            }
        )*

        fn $all() -> Vec<prost_types::DescriptorProto> {
            vec![$(message(stringify!($name), vec![$(
                field(stringify!($field), $tag, stringify!($label), stringify!($kind), stringify!($type)),
            )*]),)*]
        }
    };
}

/// The type of a field in Rust.
macro_rules! labelled {
    (required $type:ty) => { $type };
    (optional $type:ty) => { Option<$type> };
    (repeated $type:ty) => { Vec<$type> };
}

/// Returns a file of messages, as `protoc` would describe it.
fn descriptors(
    name: &str,
    package: &str,
    syntax: &str,
    needs: &[&str],
    mut messages: Vec<DescriptorProto>,
) -> FileDescriptorProto {
    for message in &mut messages {
        let inner = message.name().to_owned();
        for field in &mut message.field {
            // A message of the same package, or one that is declared inside of this one.
            if let Some(of) = &mut field.type_name {
                *of = match of.strip_prefix('/') {
                    Some(nested) => format!(".{package}.{inner}.{nested}"),
                    None if matches!(of.as_str(), "Timestamp" | "Duration") => {
                        format!(".google.protobuf.{of}")
                    }
                    None => format!(".{package}.{of}"),
                };
            }
        }
    }
    FileDescriptorProto {
        name: Some(name.to_owned()),
        package: Some(package.to_owned()),
        dependency: needs.iter().map(|&name| name.to_owned()).collect(),
        message_type: messages,
        syntax: Some(syntax.to_owned()),
        ..FileDescriptorProto::default()
    }
}

fn message(name: &str, field: Vec<FieldDescriptorProto>) -> DescriptorProto {
    DescriptorProto {
        name: Some(name.to_owned()),
        field,
        ..DescriptorProto::default()
    }
}

/// Returns a field; `of` names the message that it is, and begins with `/` for one that is declared
/// inside.
fn field(name: &str, number: i32, label: &str, kind: &str, of: &str) -> FieldDescriptorProto {
    let label = match label {
        "repeated" => Label::Repeated,
        _ => Label::Optional,
    };
    let kind = Type::from_str_name(&format!("TYPE_{}", kind.to_uppercase()));
    FieldDescriptorProto {
        name: Some(name.trim_start_matches("r#").to_owned()),
        number: Some(number),
        label: Some(label.into()),
        r#type: kind.map(i32::from),
        type_name: (kind == Some(Type::Message)).then(|| of.to_owned()),
        ..FieldDescriptorProto::default()
    }
}

protobuf! { time:
    Timestamp {
        seconds: required int64 i64 = 1,
        nanos: required int32 i32 = 2,
    }
}

protobuf! { durations:
    Duration {
        seconds: required int64 i64 = 1,
        nanos: required int32 i32 = 2,
    }
}

protobuf! { all:
    Vector3 {
        x: required double f64 = 1,
        y: required double f64 = 2,
        z: required double f64 = 3,
    }
    Point3 {
        x: required double f64 = 1,
        y: required double f64 = 2,
        z: required double f64 = 3,
    }
    Quaternion {
        x: required double f64 = 1,
        y: required double f64 = 2,
        z: required double f64 = 3,
        w: required double f64 = 4,
    }
    Color {
        r: required double f64 = 1,
        g: required double f64 = 2,
        b: required double f64 = 3,
        a: required double f64 = 4,
    }
    Pose {
        position: required message Vector3 = 1,
        orientation: required message Quaternion = 2,
    }
    KeyValuePair {
        key: required string String = 1,
        value: required string String = 2,
    }
    ArrowPrimitive {
        pose: required message Pose = 1,
        shaft_length: required double f64 = 2,
        shaft_diameter: required double f64 = 3,
        head_length: required double f64 = 4,
        head_diameter: required double f64 = 5,
        color: required message Color = 6,
    }
    CubePrimitive {
        pose: required message Pose = 1,
        size: required message Vector3 = 2,
        color: required message Color = 3,
    }
    SpherePrimitive {
        pose: required message Pose = 1,
        size: required message Vector3 = 2,
        color: required message Color = 3,
    }
    CylinderPrimitive {
        pose: required message Pose = 1,
        size: required message Vector3 = 2,
        bottom_scale: required double f64 = 3,
        top_scale: required double f64 = 4,
        color: required message Color = 5,
    }
    LinePrimitive {
        r#type: optional int32 i32 = 1,
        pose: required message Pose = 2,
        thickness: required double f64 = 3,
        scale_invariant: required bool bool = 4,
        points: repeated message Point3 = 5,
        color: required message Color = 6,
        colors: repeated message Color = 7,
        indices: repeated fixed32 u32 = 8,
    }
    TriangleListPrimitive {
        pose: required message Pose = 1,
        points: repeated message Point3 = 2,
        color: required message Color = 3,
        colors: repeated message Color = 4,
        indices: repeated fixed32 u32 = 5,
    }
    TextPrimitive {
        pose: required message Pose = 1,
        billboard: required bool bool = 2,
        font_size: required double f64 = 3,
        scale_invariant: required bool bool = 4,
        color: required message Color = 5,
        text: required string String = 6,
    }
    ModelPrimitive {
        pose: required message Pose = 1,
        scale: required message Vector3 = 2,
        color: required message Color = 3,
        override_color: required bool bool = 4,
        url: required string String = 5,
        media_type: required string String = 6,
        data: required bytes Bytes = 7,
    }
    SceneEntityDeletion {
        timestamp: required message Timestamp = 1,
        r#type: required int32 i32 = 2,
        id: required string String = 3,
    }
    SceneEntity {
        timestamp: required message Timestamp = 1,
        frame_id: required string String = 2,
        id: required string String = 3,
        lifetime: optional message Duration = 4,
        frame_locked: optional bool bool = 5,
        metadata: repeated message KeyValuePair = 6,
        arrows: repeated message ArrowPrimitive = 7,
        cubes: repeated message CubePrimitive = 8,
        spheres: repeated message SpherePrimitive = 9,
        cylinders: repeated message CylinderPrimitive = 10,
        lines: repeated message LinePrimitive = 11,
        triangles: repeated message TriangleListPrimitive = 12,
        texts: repeated message TextPrimitive = 13,
        models: repeated message ModelPrimitive = 14,
    }
    SceneUpdate {
        deletions: repeated message SceneEntityDeletion = 1,
        entities: repeated message SceneEntity = 2,
    }
    FrameTransform {
        timestamp: required message Timestamp = 1,
        parent_frame_id: required string String = 2,
        child_frame_id: required string String = 3,
        translation: required message Vector3 = 4,
        rotation: required message Quaternion = 5,
    }
    FrameTransforms {
        transforms: repeated message FrameTransform = 1,
    }
    Log {
        timestamp: required message Timestamp = 1,
        level: required int32 i32 = 2,
        message: required string String = 3,
        name: required string String = 4,
        file: required string String = 5,
        line: required fixed32 u32 = 6,
    }
}

type Bytes = Vec<u8>;

/// Enumerations are numbers in messages: the message, the field, the enumeration, and its values from 0 with blanks between.
const ENUMERATIONS: [[&str; 4]; 3] = [
    [
        "LinePrimitive",
        "type",
        "Type",
        "LINE_STRIP LINE_LOOP LINE_LIST",
    ],
    ["SceneEntityDeletion", "type", "Type", "MATCHING_ID ALL"],
    [
        "Log",
        "level",
        "Level",
        "UNKNOWN DEBUG INFO WARNING ERROR FATAL",
    ],
];

/// The file of time, which messages of all files need.
const TIME: &str = "google/protobuf/timestamp.proto";
const DURATION: &str = "google/protobuf/duration.proto";

fn time_file() -> FileDescriptorProto {
    descriptors(TIME, "google.protobuf", "proto3", &[], time())
}

fn duration_file() -> FileDescriptorProto {
    descriptors(DURATION, "google.protobuf", "proto3", &[], durations())
}

/// Returns the descriptors of Foxglove's messages.
fn foxglove_file() -> FileDescriptorProto {
    let mut messages = all();
    for [name, field, enumeration, values] in ENUMERATIONS {
        for message in messages.iter_mut().filter(|message| message.name() == name) {
            for of in message.field.iter_mut().filter(|of| of.name() == field) {
                of.r#type = Some(Type::Enum.into());
                of.type_name = Some(format!("/{enumeration}"));
            }
            let values = (0..).zip(values.split_whitespace());
            let value = |(number, name): (i32, &str)| EnumValueDescriptorProto {
                name: Some(name.to_owned()),
                number: Some(number),
                options: None,
            };
            message.enum_type = vec![EnumDescriptorProto {
                name: Some(enumeration.to_owned()),
                value: values.map(value).collect(),
                ..EnumDescriptorProto::default()
            }];
        }
    }
    let needs = [TIME, DURATION];
    descriptors("foxglove.proto", "foxglove", "proto3", &needs, messages)
}

impl Timestamp {
    /// Creates a moment of the run, ns.
    pub(super) const fn of(nanoseconds: u64) -> Self {
        const SECOND: u64 = 1_000_000_000;
        Timestamp {
            seconds: (nanoseconds / SECOND) as i64,
            nanos: (nanoseconds % SECOND) as i32,
        }
    }
}

impl From<[f64; 3]> for Vector3 {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Vector3 { x, y, z }
    }
}

impl From<[f64; 3]> for Point3 {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Point3 { x, y, z }
    }
}

impl From<[f64; 4]> for Quaternion {
    fn from([x, y, z, w]: [f64; 4]) -> Self {
        Quaternion { x, y, z, w }
    }
}

impl From<[f64; 4]> for Color {
    fn from([r, g, b, a]: [f64; 4]) -> Self {
        Color { r, g, b, a }
    }
}

impl Pose {
    /// Creates a pose at a place (m), turned by a quaternion.
    pub(super) fn new(at: [f64; 3], turned: [f64; 4]) -> Self {
        Pose {
            position: at.into(),
            orientation: turned.into(),
        }
    }
}

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
    Clearance {
        timestamp: required message Timestamp = 1,
        clearance_mm: required double f64 = 2,
        parts: repeated string String = 3,
    }
}

/// Returns the file of the own messages.
fn own_file(recording: &Recording) -> FileDescriptorProto {
    let feet = (1..).take(recording.robot.legs.len());
    let of_feet = |unit: &str| {
        let names = feet.clone().map(|leg| format!("{}_{unit}", foot(leg)));
        let fields = (2..)
            .zip(names)
            .map(|(number, name)| number_field(&name, number));
        [time_field()].into_iter().chain(fields).collect()
    };
    let mut messages = same();
    messages.push(message("Loads", of_feet("N")));
    messages.push(message("Slips", of_feet("mm")));
    messages.push(Variables::of(&recording.script.scalars).descriptor());
    descriptors("tip.proto", "tip", "proto2", &[TIME], messages)
}

fn time_field() -> FieldDescriptorProto {
    field("timestamp", 1, "required", "message", "Timestamp")
}

fn number_field(name: &str, number: i32) -> FieldDescriptorProto {
    field(name, number, "optional", "double", "")
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
pub(super) fn margin(time: u64, frame: &Frame, falls: u32) -> Option<Margin> {
    Some(Margin {
        timestamp: Timestamp::of(time),
        margin_mm: frame.margin?,
        falls: falls.into(),
    })
}

/// Returns a `tip.Clearance`.
pub(super) fn clearance(time: u64, frame: &Frame) -> Option<Clearance> {
    let gap = frame.gap?;
    Some(Clearance {
        timestamp: Timestamp::of(time),
        clearance_mm: gap.distance,
        parts: gap.parts.map(|part| part.to_string()).into(),
    })
}

/// Returns `tip.Loads` or `tip.Slips`: a number of each foot.
pub(super) fn of_feet(time: u64, values: &[f64]) -> Option<Vec<u8>> {
    let mut message = begun(time);
    for (field, value) in (2..).zip(values) {
        double::encode(field, value, &mut message);
    }
    (!values.is_empty()).then_some(message)
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
pub(super) struct Variables(Vec<Field>);

impl Variables {
    /// Returns the fields of these variables.
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
        Variables(fields)
    }

    /// Returns `tip.Variables`: those that have a value.
    pub(super) fn message(&self, time: u64, values: &[Option<f64>]) -> Vec<u8> {
        let encode = |field, place: usize, message: &mut Vec<u8>| {
            if let Some(Some(value)) = values.get(place) {
                double::encode(field, value, message);
            }
        };
        let mut message = begun(time);
        for (field, (_, members)) in (2..).zip(&self.0) {
            match members.as_slice() {
                [(None, place)] => encode(field, *place, &mut message),
                members => {
                    let mut inner = Vec::new();
                    for (field, (_, place)) in (1..).zip(members) {
                        encode(field, *place, &mut inner);
                    }
                    bytes::encode(field, &inner, &mut message);
                }
            }
        }
        message
    }

    fn descriptor(&self) -> DescriptorProto {
        let (mut fields, mut inner) = (vec![time_field()], Vec::new());
        for (number, (name, members)) in (2..).zip(&self.0) {
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
            fields.push(field(
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

/// `std_msgs/msg/String`
pub(super) const STRING: &str = "string data\n";

/// `sensor_msgs/msg/JointState`, with what it needs.
pub(super) const JOINT_STATE: &str = "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n\
================================================================================\nMSG: std_msgs/Header\n\
builtin_interfaces/Time stamp\nstring frame_id\n\
================================================================================\nMSG: builtin_interfaces/Time\n\
int32 sec\nuint32 nanosec\n";

/// Little endian, each number at a multiple of its size.
pub(super) struct Cdr(Vec<u8>);

/// Header before the body, which does not count for the multiples.
const HEADER: [u8; 4] = [0, 1, 0, 0];

impl Cdr {
    pub(super) fn new() -> Self {
        Cdr(HEADER.to_vec())
    }

    fn align(&mut self, size: usize) {
        let length = self.0.len() - HEADER.len();
        self.0
            .resize(HEADER.len() + length.next_multiple_of(size), 0);
    }

    /// Appends a `uint32`, or an `int32` that is not negative.
    pub(super) fn number(mut self, value: u32) -> Self {
        self.align(4);
        self.0.extend(value.to_le_bytes());
        self
    }

    /// Appends a `string`; its length counts the zero at the end.
    pub(super) fn text(mut self, text: &str) -> Self {
        self = self.number(text.len() as u32 + 1);
        self.0.extend(text.as_bytes());
        self.0.push(0);
        self
    }

    /// Appends a `string[]`.
    pub(super) fn texts(self, texts: &[String]) -> Self {
        let all = self.number(texts.len() as u32);
        texts.iter().fold(all, |cdr, text| cdr.text(text))
    }

    /// Appends a `float64[]`.
    pub(super) fn doubles(mut self, values: &[f64]) -> Self {
        self = self.number(values.len() as u32);
        for value in values {
            self.align(8);
            self.0.extend(value.to_le_bytes());
        }
        self
    }

    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_at_multiples_of_their_size() {
        let cdr = Cdr::new().text("ab").doubles(&[1.0]).number(7);
        let expected: [&[u8]; 5] = [
            &[0, 1, 0, 0],
            // Three bytes with the zero; one is left out.
            &[3, 0, 0, 0, b'a', b'b', 0, 0],
            // How many; the double begins at 16 of the body.
            &[1, 0, 0, 0, 0, 0, 0, 0],
            &1.0f64.to_le_bytes(),
            &[7, 0, 0, 0],
        ];
        assert_eq!(cdr.into_bytes(), expected.concat());
    }
}
