//! Foxglove's schemas, field by field as published, and what of them is written.

use super::schema::{File, Type};
use super::wire::Message;

const TIME: &str = ".google.protobuf.Timestamp";
const DURATION: &str = ".google.protobuf.Duration";

type Row = (
    &'static str,
    &'static [(&'static str, &'static str)],
    &'static str,
);

/// The name of each message, its fields, and the values of its enumeration with blanks between.
const ROWS: [Row; 20] = [
    (
        "Vector3",
        &[("x", "double"), ("y", "double"), ("z", "double")],
        "",
    ),
    (
        "Point3",
        &[("x", "double"), ("y", "double"), ("z", "double")],
        "",
    ),
    (
        "Quaternion",
        &[
            ("x", "double"),
            ("y", "double"),
            ("z", "double"),
            ("w", "double"),
        ],
        "",
    ),
    (
        "Color",
        &[
            ("r", "double"),
            ("g", "double"),
            ("b", "double"),
            ("a", "double"),
        ],
        "",
    ),
    (
        "Pose",
        &[("position", "Vector3"), ("orientation", "Quaternion")],
        "",
    ),
    (
        "KeyValuePair",
        &[("key", "string"), ("value", "string")],
        "",
    ),
    (
        "ArrowPrimitive",
        &[
            ("pose", "Pose"),
            ("shaft_length", "double"),
            ("shaft_diameter", "double"),
            ("head_length", "double"),
            ("head_diameter", "double"),
            ("color", "Color"),
        ],
        "",
    ),
    (
        "CubePrimitive",
        &[("pose", "Pose"), ("size", "Vector3"), ("color", "Color")],
        "",
    ),
    (
        "SpherePrimitive",
        &[("pose", "Pose"), ("size", "Vector3"), ("color", "Color")],
        "",
    ),
    (
        "CylinderPrimitive",
        &[
            ("pose", "Pose"),
            ("size", "Vector3"),
            ("bottom_scale", "double"),
            ("top_scale", "double"),
            ("color", "Color"),
        ],
        "",
    ),
    (
        "LinePrimitive",
        &[
            ("type", "enum Type"),
            ("pose", "Pose"),
            ("thickness", "double"),
            ("scale_invariant", "bool"),
            ("points", "repeated Point3"),
            ("color", "Color"),
            ("colors", "repeated Color"),
            ("indices", "repeated fixed32"),
        ],
        "LINE_STRIP LINE_LOOP LINE_LIST",
    ),
    (
        "TriangleListPrimitive",
        &[
            ("pose", "Pose"),
            ("points", "repeated Point3"),
            ("color", "Color"),
            ("colors", "repeated Color"),
            ("indices", "repeated fixed32"),
        ],
        "",
    ),
    (
        "TextPrimitive",
        &[
            ("pose", "Pose"),
            ("billboard", "bool"),
            ("font_size", "double"),
            ("scale_invariant", "bool"),
            ("color", "Color"),
            ("text", "string"),
        ],
        "",
    ),
    (
        "ModelPrimitive",
        &[
            ("pose", "Pose"),
            ("scale", "Vector3"),
            ("color", "Color"),
            ("override_color", "bool"),
            ("url", "string"),
            ("media_type", "string"),
            ("data", "bytes"),
        ],
        "",
    ),
    (
        "SceneEntityDeletion",
        &[("timestamp", TIME), ("type", "enum Type"), ("id", "string")],
        "MATCHING_ID ALL",
    ),
    (
        "SceneEntity",
        &[
            ("timestamp", TIME),
            ("frame_id", "string"),
            ("id", "string"),
            ("lifetime", DURATION),
            ("frame_locked", "bool"),
            ("metadata", "repeated KeyValuePair"),
            ("arrows", "repeated ArrowPrimitive"),
            ("cubes", "repeated CubePrimitive"),
            ("spheres", "repeated SpherePrimitive"),
            ("cylinders", "repeated CylinderPrimitive"),
            ("lines", "repeated LinePrimitive"),
            ("triangles", "repeated TriangleListPrimitive"),
            ("texts", "repeated TextPrimitive"),
            ("models", "repeated ModelPrimitive"),
        ],
        "",
    ),
    (
        "SceneUpdate",
        &[
            ("deletions", "repeated SceneEntityDeletion"),
            ("entities", "repeated SceneEntity"),
        ],
        "",
    ),
    (
        "FrameTransform",
        &[
            ("timestamp", TIME),
            ("parent_frame_id", "string"),
            ("child_frame_id", "string"),
            ("translation", "Vector3"),
            ("rotation", "Quaternion"),
        ],
        "",
    ),
    (
        "FrameTransforms",
        &[("transforms", "repeated FrameTransform")],
        "",
    ),
    (
        "Log",
        &[
            ("timestamp", TIME),
            ("level", "enum Level"),
            ("message", "string"),
            ("name", "string"),
            ("file", "string"),
            ("line", "fixed32"),
        ],
        "UNKNOWN DEBUG INFO WARNING ERROR FATAL",
    ),
];

/// The file of time, which messages of all files need.
pub(super) fn time() -> File {
    let parts = [("seconds", "int64"), ("nanos", "int32")];
    File {
        name: "google/protobuf/timestamp.proto",
        package: "google.protobuf",
        has_presence: false,
        needs: &[],
        types: vec![Type::row("Timestamp", &parts, "")],
    }
}

/// The file of durations.
pub(super) fn duration() -> File {
    let parts = [("seconds", "int64"), ("nanos", "int32")];
    File {
        name: "google/protobuf/duration.proto",
        package: "google.protobuf",
        has_presence: false,
        needs: &[],
        types: vec![Type::row("Duration", &parts, "")],
    }
}

/// Foxglove's file.
pub(super) fn file() -> File {
    File {
        name: "foxglove.proto",
        package: "foxglove",
        has_presence: false,
        needs: &[
            "google/protobuf/timestamp.proto",
            "google/protobuf/duration.proto",
        ],
        types: ROWS
            .map(|(name, fields, values)| Type::row(name, fields, values))
            .into(),
    }
}

/// A moment of the run: ns.
pub(super) fn timestamp(nanoseconds: u64) -> Message {
    const SECOND: u64 = 1_000_000_000;
    Message::new()
        .number(1, nanoseconds / SECOND)
        .number(2, nanoseconds % SECOND)
}

/// `Vector3` or `Point3`: m.
pub(super) fn vector([x, y, z]: [f64; 3]) -> Message {
    Message::new().double(1, x).double(2, y).double(3, z)
}

/// x, y, z, w.
pub(super) fn quaternion([x, y, z, w]: [f64; 4]) -> Message {
    Message::new()
        .double(1, x)
        .double(2, y)
        .double(3, z)
        .double(4, w)
}

/// Red, green, blue and how opaque it is, from 0 to 1.
pub(super) fn colour(rgba: [f64; 4]) -> Message {
    quaternion(rgba)
}

pub(super) fn pose(at: [f64; 3], turned: [f64; 4]) -> Message {
    Message::new()
        .message(1, &vector(at))
        .message(2, &quaternion(turned))
}
