//! Foxglove's messages, field by field as published.

use super::proto::{self, protobuf};
use prost_types::field_descriptor_proto::Type;
use prost_types::{EnumDescriptorProto, EnumValueDescriptorProto, FileDescriptorProto};

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
pub(super) const TIME: &str = "google/protobuf/timestamp.proto";
const DURATION: &str = "google/protobuf/duration.proto";

pub(super) fn time_file() -> FileDescriptorProto {
    proto::file(TIME, "google.protobuf", "proto3", &[], time())
}

pub(super) fn duration_file() -> FileDescriptorProto {
    proto::file(DURATION, "google.protobuf", "proto3", &[], durations())
}

/// Returns the descriptors of Foxglove's messages.
pub(super) fn file() -> FileDescriptorProto {
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
    proto::file("foxglove.proto", "foxglove", "proto3", &needs, messages)
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
