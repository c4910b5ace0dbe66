//! MCAP files of runs, read back: each channel, its schema, and the poses of the run in it.

use mcap::{MessageStream, Schema};
use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::Path;
use tip_runtime::plant::{Block, Scene};
use tip_sim::{Events, Robot, tipc, urdf};
use tip_view::{DurationLimit, FrameRate, Occurrence, Recording, robot_frame};

fn example(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    fs::read_to_string(root.join("examples").join(path)).expect("the example is there")
}

fn record(text: &str, robot: &Robot, cycles: u64) -> Recording {
    let loaded = tipc::load("test.prg", text.as_bytes(), &robot.options());
    let extent = DurationLimit::cycles(cycles);
    let recording = Recording::paced(
        &loaded,
        robot,
        &Events::NONE,
        extent,
        FrameRate::Smooth,
        || true,
    );
    recording.expect("it runs")
}

fn titan() -> Robot {
    Robot::named("titan8").expect("it has a name")
}

fn hand() -> Robot {
    let hand = Robot::named("hand").expect("it has a name");
    hand.with_scene(&Scene::CYLINDER).expect("it grasps")
}

fn bytes(recording: &Recording, robot: &Robot) -> Vec<u8> {
    let mut bytes = Vec::new();
    let written = tip_log::mcap(recording, &urdf::export(robot), Cursor::new(&mut bytes));
    written.expect("memory takes it");
    bytes
}

/// The messages of a topic, each with its time (ns), and their schema.
#[derive(Default)]
struct Channel {
    schema: String,
    encodings: (String, String),
    description: Vec<u8>,
    messages: Vec<(u64, Vec<u8>)>,
}

fn read(bytes: &[u8]) -> BTreeMap<String, Channel> {
    let mut channels: BTreeMap<String, Channel> = BTreeMap::new();
    for message in MessageStream::new(bytes).expect("it is MCAP") {
        let message = message.expect("a message");
        let schema: &Schema<'_> = message.channel.schema.as_ref().expect("each has a schema");
        let channel = channels.entry(message.channel.topic.clone()).or_default();
        channel.schema = schema.name.clone();
        channel.description = schema.data.to_vec();
        channel.encodings = (
            schema.encoding.clone(),
            message.channel.message_encoding.clone(),
        );
        assert_eq!(message.sequence as usize, channel.messages.len());
        channel
            .messages
            .push((message.log_time, message.data.to_vec()));
    }
    channels
}

/// The fields of a message of Protocol Buffers: number and bytes; of a number eight bytes.
fn fields(mut bytes: &[u8]) -> Vec<(u64, Vec<u8>)> {
    fn varint(bytes: &mut &[u8]) -> u64 {
        let mut value = 0;
        for shift in (0..).step_by(7) {
            let (first, rest) = bytes.split_first().expect("the message goes on");
            *bytes = rest;
            value |= u64::from(first & 0x7F) << shift;
            if first & 0x80 == 0 {
                break;
            }
        }
        value
    }
    let mut found = Vec::new();
    while !bytes.is_empty() {
        let tag = varint(&mut bytes);
        let length = match tag & 7 {
            0 => {
                let value = varint(&mut bytes);
                found.push((tag >> 3, value.to_le_bytes().to_vec()));
                continue;
            }
            1 => 8,
            2 => varint(&mut bytes) as usize,
            5 => 4,
            wire => panic!("no wire type {wire}"),
        };
        let (value, rest) = bytes.split_at(length);
        found.push((tag >> 3, value.to_vec()));
        bytes = rest;
    }
    found
}

fn field(bytes: &[u8], number: u64) -> Vec<u8> {
    let found = fields(bytes)
        .into_iter()
        .find(|(found, _)| *found == number);
    found.unwrap_or_else(|| panic!("no field {number}")).1
}

fn doubles(bytes: &[u8]) -> Vec<f64> {
    let parts = fields(bytes).into_iter();
    parts
        .map(|(_, part)| f64::from_le_bytes(part.try_into().expect("a double")))
        .collect()
}

/// The places (m) and attitudes (x, y, z, w) by the name of the child, of a `FrameTransforms`.
fn transforms(bytes: &[u8]) -> BTreeMap<String, (String, Vec<f64>, Vec<f64>)> {
    let each = fields(bytes).into_iter().map(|(_, one)| {
        let text = |number| String::from_utf8(field(&one, number)).expect("a name");
        (
            text(3),
            (text(2), doubles(&field(&one, 4)), doubles(&field(&one, 5))),
        )
    });
    each.collect()
}

/// Turns by a quaternion (x, y, z, w): v + 2 q × (q × v + w v).
fn turned(q: &[f64], v: [f64; 3]) -> [f64; 3] {
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    };
    let (u, w) = ([q[0], q[1], q[2]], q[3]);
    let first = cross(u, v);
    let second = cross(u, [0, 1, 2].map(|i| first[i] + w * v[i]));
    [0, 1, 2].map(|i| v[i] + 2.0 * second[i])
}

/// Returns the place of a frame's origin in the world, by the transforms of a moment, m.
fn origin(all: &BTreeMap<String, (String, Vec<f64>, Vec<f64>)>, frame: &str) -> [f64; 3] {
    let (mut at, mut name) = ([0.0; 3], frame.to_owned());
    while let Some((parent, place, turn)) = all.get(&name) {
        let inner = turned(turn, at);
        at = [0, 1, 2].map(|i| place[i] + inner[i]);
        name.clone_from(parent);
    }
    assert_eq!(name, "world");
    at
}

fn near(one: [f64; 3], other: [f64; 3]) -> bool {
    one.iter()
        .zip(other)
        .all(|(one, other)| (one - other).abs() < 1e-9)
}

#[test]
fn each_topic_has_its_schema_and_as_many_messages_as_the_run() {
    let (robot, text) = (titan(), example("walk/motions/walk.prg"));
    let recording = record(&text, &robot, 500);
    let channels = read(&bytes(&recording, &robot));
    let shown: Vec<(&str, &str, usize)> = channels
        .iter()
        .map(|(topic, channel)| {
            (
                topic.as_str(),
                channel.schema.as_str(),
                channel.messages.len(),
            )
        })
        .collect();
    let frames = recording.frames.len();
    assert_eq!(frames, 500, "20 ms a cycle are 50 Hz");
    let cycles = |is: fn(&Occurrence) -> bool| -> Vec<u64> {
        let entries = recording.entries(move |what| is(what).then_some(()));
        entries.map(|(cycle, ())| cycle).collect()
    };
    let steps = cycles(|what| matches!(what, Occurrence::Step(_))).len();
    let mut assigning = cycles(|what| matches!(what, Occurrence::Assigned { .. }));
    assigning.dedup();
    let messages = cycles(|what| matches!(what, Occurrence::Message(_)));
    let said = messages.len() + recording.falls().count() + 1;
    assert_eq!(
        shown,
        [
            ("/joint_states", "sensor_msgs/msg/JointState", frames),
            ("/robot_description", "std_msgs/msg/String", 1),
            ("/scene", "foxglove.SceneUpdate", frames),
            ("/tf", "foxglove.FrameTransforms", frames),
            ("/tf_static", "foxglove.FrameTransforms", 1),
            ("/tip/body", "tip.Body", frames),
            ("/tip/clearance", "tip.Clearance", frames),
            ("/tip/loads", "tip.Loads", frames),
            ("/tip/margin", "tip.Margin", frames),
            ("/tip/messages", "foxglove.Log", said),
            ("/tip/slips", "tip.Slips", frames),
            ("/tip/state", "tip.State", frames + steps),
            ("/tip/variables", "tip.Variables", assigning.len()),
        ]
    );
    for (topic, channel) in &channels {
        let (schema, message) = (channel.encodings.0.as_str(), channel.encodings.1.as_str());
        let is_ros = channel.schema.contains('/');
        let expected = if is_ros {
            ("ros2msg", "cdr")
        } else {
            ("protobuf", "protobuf")
        };
        assert_eq!((schema, message), expected, "{topic}");
        assert!(!channel.description.is_empty(), "{topic}");
        let times = channel.messages.iter().map(|(time, _)| *time);
        assert!(times.is_sorted(), "{topic}");
    }
    let description = &channels["/robot_description"].messages[0].1;
    // Four bytes of CDR, four of the length, and the zero at the end.
    assert_eq!(
        description[8..description.len() - 1],
        *urdf::export(&robot).as_bytes()
    );
}

#[test]
fn transforms_put_the_feet_where_the_run_has_them() {
    let hexapod = Robot::from_description(&example("six-legs/hexapod.toml")).expect("a robot");
    for (text, robot) in [
        (example("walk/motions/walk.prg"), titan()),
        (example("six-legs/motions/tripod.prg"), hexapod),
        (example("grasp/motions/grasp.prg"), hand()),
    ] {
        let recording = record(&text, &robot, 700);
        let channels = read(&bytes(&recording, &robot));
        let still = transforms(&channels["/tf_static"].messages[0].1);
        let moving = &channels["/tf"].messages;
        assert_eq!(moving.len(), recording.frames.len());
        for (frame, (time, message)) in recording.frames.iter().zip(moving) {
            assert_eq!(*time, (frame.time * 1e6).round() as u64);
            let mut all = transforms(message);
            all.extend(still.clone());
            for (number, (leg, angles)) in (1..).zip(recording.robot.legs.iter().zip(&frame.angles))
            {
                let foot = leg.foot(angles);
                // Forward is x, left is y; of the hand, which is bolted down, y is the height.
                let expected = match &frame.pose {
                    Some(pose) => {
                        let [right, forward, up] = robot_frame(pose).point(foot);
                        [forward, -right, up]
                    }
                    None => [-foot[2], -foot[0], foot[1]],
                };
                let at = origin(&all, &format!("F{number}")).map(|metres| metres * 1000.0);
                assert!(
                    near(at, expected),
                    "{} F{number}: {at:?} is not {expected:?}",
                    robot.name()
                );
            }
        }
    }
}

/// Decodes joint states as a reader of ROS 2 does.
#[test]
fn joint_states_are_those_of_the_run() {
    let robot = hand();
    let recording = record(&example("grasp/motions/grasp.prg"), &robot, 700);
    let channels = read(&bytes(&recording, &robot));
    let (_, message) = channels["/joint_states"]
        .messages
        .last()
        .expect("the last cycle");
    let frame = recording.frames.last().expect("the last cycle");
    let body = &message[4..];
    let mut at = 8;
    let number = |at: &mut usize| {
        *at = at.next_multiple_of(4);
        let value = u32::from_le_bytes(body[*at..*at + 4].try_into().expect("four bytes"));
        *at += 4;
        value as usize
    };
    // The name of a frame: nothing but its zero.
    at += number(&mut at);
    let names: Vec<String> = (0..number(&mut at))
        .map(|_| {
            let length = number(&mut at);
            let name = String::from_utf8_lossy(&body[at..at + length - 1]).into_owned();
            at += length;
            name
        })
        .collect();
    assert_eq!(names[..4], ["J11", "J12", "J13", "J21"]);
    assert_eq!((names.len(), names[9].as_str()), (10, "floor_y"));
    let mut lists = Vec::new();
    for _ in 0..3 {
        assert_eq!(number(&mut at), 10);
        at = at.next_multiple_of(8);
        let list: Vec<f64> = body[at..at + 80]
            .chunks(8)
            .map(|bytes| f64::from_le_bytes(bytes.try_into().expect("eight bytes")))
            .collect();
        at += 80;
        lists.push(list);
    }
    assert_eq!(at, body.len(), "nothing is left");
    for (joint, angle) in frame.angles.iter().flatten().enumerate() {
        assert!((lists[0][joint] - angle.to_radians()).abs() < 1e-12);
    }
    // The slider began at −130 mm; torques of the hand are in mN·m.
    let slider = frame.slider.expect("it has one");
    assert!((lists[0][9] - (slider[1] + 130.0) / 1000.0).abs() < 1e-12);
    for (joint, torque) in frame.torques.iter().flatten().enumerate() {
        assert!((lists[2][joint] - torque / 1000.0).abs() < 1e-12);
    }
}

#[test]
fn variables_and_states_are_those_of_the_program() {
    let text = "3.1\nNames\nDEF_VAR COUNT, UNUSED\nDEF_POS P\nCOUNT = 7\nP.Y = 0.5\nLAMP_ON 2\nMESSAGE lamp 2 is on\nPTP_ANGLE J11 3\nEND\n";
    let robot = titan();
    let recording = record(text, &robot, 100);
    let channels = read(&bytes(&recording, &robot));
    let names = &recording.script.scalars;
    let place = |name: &str| names.iter().position(|known| known == name);
    let (count, unused) = (place("COUNT"), place("UNUSED"));
    assert!(count < unused && unused < place("P.X"), "{names:?}");
    let (_, last) = channels["/tip/variables"]
        .messages
        .last()
        .expect("two assignments");
    // Field 1 is the time; P is one field with X, Y and Z in it.
    let field_of = |place: Option<usize>| place.expect("a variable") as u64 + 2;
    assert_eq!(
        doubles(&[&[9], &field(last, field_of(count))[..]].concat()),
        [7.0]
    );
    let present: Vec<u64> = fields(last).iter().map(|(number, _)| *number).collect();
    assert!(!present.contains(&field_of(unused)), "{present:?}");
    let inner = fields(&field(last, field_of(place("P.X"))));
    assert_eq!(inner, [(2, 0.5f64.to_le_bytes().to_vec())]);

    let text_of = |bytes: &[u8], number| String::from_utf8(field(bytes, number)).expect("text");
    let states = &channels["/tip/state"].messages;
    let commanding = states
        .iter()
        .find(|(_, state)| fields(state).iter().any(|(n, _)| *n == 6));
    let (time, state) = commanding.expect("a command");
    // The fifth step runs in the fifth cycle, on line 9.
    assert_eq!(*time, 80_000_000);
    assert_eq!(text_of(state, 6), "PTP_ANGLE J11 3.0");
    assert_eq!(text_of(state, 5), "PTP_ANGLE J11 3");
    assert_eq!(field(state, 4), 9u64.to_le_bytes());
    assert_eq!(field(state, 9), 2u64.to_le_bytes(), "its lamp is on");
    let (_, said) = &channels["/tip/messages"].messages[0];
    assert_eq!(text_of(said, 3), "lamp 2 is on");
    assert_eq!(
        field(said, 6),
        8u32.to_le_bytes(),
        "the line of the message"
    );
    let (_, end) = channels["/tip/messages"].messages.last().expect("the end");
    assert_eq!(text_of(end, 3), "END");
}

#[test]
fn the_same_run_gives_the_same_bytes() {
    let (robot, text) = (titan(), example("walk/motions/walk.prg"));
    let file = || bytes(&record(&text, &robot, 200), &robot);
    assert!(file() == file());
}

#[test]
fn blocks_of_a_scene_are_cubes_of_every_update() {
    // 200 mm wide and 600 mm long, ahead of the robot; the floor under it rises by 1 mm in 100 from 3 mm at y = 300.
    let block = Block {
        x: [-100.0, 100.0],
        y: [300.0, 900.0],
        height: 43.0,
    };
    let mut scene = Scene::EMPTY.with_block(block).expect("there is room");
    scene.floor.slope = [0.0, 0.01];
    let robot = titan().with_scene(&scene).expect("it walks there");
    let recording = record("3.1\nwaits\nSLEEP 100\nEND\n", &robot, 10);
    let channels = read(&bytes(&recording, &robot));
    let updates = &channels["/scene"].messages;
    assert!(updates.len() > 1);
    for (_, update) in updates {
        let entities = fields(update)
            .into_iter()
            .filter(|(number, _)| *number == 2);
        let named = entities.map(|(_, entity)| entity);
        let mut blocks = named.filter(|entity| field(entity, 3) == b"blocks");
        let blocks = blocks.next().expect("they are there");
        assert_eq!(field(&blocks, 2), b"world");
        // Forward, left and up, in metres.
        let (cube, at) = (field(&blocks, 8), [0.6, 0.0, 0.023]);
        let axes = |vector: &[u8]| doubles(vector).try_into().expect("three axes");
        assert!(near(axes(&field(&field(&cube, 1), 1)), at));
        assert!(near(axes(&field(&cube, 2)), [0.6, 0.2, 0.04]));
    }
}
