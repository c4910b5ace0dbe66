"""Reads MCAP files with PyPI's mcap and mcap-protobuf-support: each message is decoded by the schema in the file."""

import csv
import math
import pathlib
import struct
import sys
from collections import Counter

from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

MOVING = {"/tf", "/joint_states", "/scene"}


def examine(path):
    counts, frames, places, last = Counter(), set(), 0, {}
    lean = 0.0
    with path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()], validate_crcs=True)
        summary = reader.get_summary()
        for schema, channel, message in reader.iter_messages():
            counts[channel.topic] += 1
            if schema.encoding == "ros2msg":
                assert message.data[:4] == b"\0\1\0\0", channel.topic
                last[channel.topic] = message.data
    with path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        protobuf = [topic for topic in counts if topic not in ("/robot_description", "/joint_states")]
        for schema, channel, message, decoded in reader.iter_decoded_messages(topics=protobuf):
            if schema.name == "foxglove.FrameTransforms":
                for transform in decoded.transforms:
                    frames.add((transform.parent_frame_id, transform.child_frame_id))
                    rotation = transform.rotation
                    size = rotation.x**2 + rotation.y**2 + rotation.z**2 + rotation.w**2
                    assert abs(size - 1) < 1e-9, transform
                    assert transform.timestamp.ToNanoseconds() == message.log_time
            elif schema.name == "foxglove.SceneUpdate":
                blocks = [entity for entity in decoded.entities if entity.id == "blocks"]
                # The upper sides of those of step.toml are 15 and 120 mm above the floor, and the log is in metres.
                middles = [round(cube.pose.position.z, 9) for entity in blocks for cube in entity.cubes]
                assert middles == ([0.0075, 0.06] if path.stem == "step" else []), middles
                assert all(entity.frame_id == "world" for entity in blocks)
                for entity in decoded.entities:
                    for arrow in entity.arrows:
                        turned = arrow.pose.orientation
                        lean = max(lean, math.hypot(turned.x, turned.z), abs(turned.y + turned.w))
                    places += len(entity.arrows) + len(entity.cubes) + len(entity.cylinders)
                    places += sum(len(line.points) for line in entity.lines)
            else:
                last[channel.topic] = decoded
    assert counts == Counter({summary.channels[i].topic: n for i, n in summary.statistics.channel_message_counts.items()})
    assert len({counts[topic] for topic in MOVING}) == 1, counts
    children = [child for _, child in frames]
    assert len(children) == len(set(children)), "a tree"
    assert {parent for parent, _ in frames} - set(children) == {"world"}, frames
    # The ground pushes straight up in a simulation without mass. Friction leans what it pushes with mass, and fingers push as they like.
    assert (lean > 0.1) == (path.stem in ("grasp", "step")), (path, lean)
    length = struct.unpack("<I", last["/robot_description"][4:8])[0]
    urdf = last["/robot_description"][8 : 8 + length - 1].decode()
    for child in children:
        if child != "floor":
            assert f'<link name="{child}"' in urdf, child
    assert places > 0 and last["/tip/messages"].message, path
    assert last["/tip/state"].line > 0 and len(last["/tip/variables"].ListFields()) > 1
    print(f"{path.name}: {sum(counts.values())} messages in {len(counts)} topics, {len(frames)} frames, {places} things in the scene")


def examine_table(path):
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file, strict=True))
    cycles = [int(row["cycle"]) for row in rows]
    assert cycles[:3] == [0, 7, 14], cycles[:3]
    assert all(float(row["J11_deg"]) is not None and None not in row for row in rows)
    print(f"{path.name}: {len(rows)} rows of {len(rows[0])} columns")


folder = pathlib.Path(sys.argv[1])
for path in sorted(folder.glob("*.mcap")):
    examine(path)
for path in sorted(folder.glob("*.csv")):
    examine_table(path)
