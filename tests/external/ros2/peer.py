"""Joints of a ROS 2 graph by Cyclone DDS: they are where they are commanded to be.

Usage: peer.py echo SECONDS | gripper SECONDS | nan SECONDS | empty SECONDS | partial SECONDS | start | refused | halt |
    set NAME=VALUE... | diagnostics
"""

import random
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import float64, int32, int64, sequence, uint8, uint32, uint64
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration


@dataclass
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: int32
    nanosec: uint32


@dataclass
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time
    frame_id: str


@dataclass
class JointState(IdlStruct, typename="sensor_msgs::msg::dds_::JointState_"):
    header: Header
    name: sequence[str]
    position: sequence[float64]
    velocity: sequence[float64]
    effort: sequence[float64]


@dataclass
class Request(IdlStruct, typename="std_srvs::srv::dds_::Trigger_Request_"):
    client: uint64
    number: int64
    unused: uint8


@dataclass
class Reply(IdlStruct, typename="std_srvs::srv::dds_::Trigger_Response_"):
    client: uint64
    number: int64
    success: bool
    message: str


@dataclass
class Text(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str


@dataclass
class KeyValue(IdlStruct, typename="diagnostic_msgs::msg::dds_::KeyValue_"):
    key: str
    value: str


@dataclass
class Status(IdlStruct, typename="diagnostic_msgs::msg::dds_::DiagnosticStatus_"):
    level: uint8
    name: str
    message: str
    hardware_id: str
    values: sequence[KeyValue]


@dataclass
class Diagnostics(IdlStruct, typename="diagnostic_msgs::msg::dds_::DiagnosticArray_"):
    header: Header
    status: sequence[Status]


# What ROS has by default, and the encoding of rmw_cyclonedds.
QOS = Qos(
    Policy.Reliability.Reliable(duration(milliseconds=100)),
    Policy.History.KeepLast(10),
    Policy.DataRepresentation(use_cdrv0_representation=True),
)
graph = DomainParticipant(0)


def topic(name, kind):
    return Topic(graph, name, kind, qos=QOS)


def echo(seconds):
    """Answers each command with its own angles and its own time."""
    commands = DataReader(graph, topic("rt/joint_commands", JointState), qos=QOS)
    states = DataWriter(graph, topic("rt/joint_states", JointState), qos=QOS)
    count, end = 0, time.monotonic() + seconds
    while time.monotonic() < end:
        for command in commands.take_iter(timeout=duration(milliseconds=20)):
            count += 1
            states.write(JointState(command.header, command.name, command.position, [], []))
    print(f"peer: {count} commands")


def mislead(kind, seconds):
    """Publishes joint states that do not say where the robot is."""
    states = DataWriter(graph, topic("rt/joint_states", JointState), qos=QOS)
    joints = [f"J{leg}{joint}" for leg in range(1, 5) for joint in range(1, 4)]
    names, positions = {
        "gripper": (["finger"], [0.0]),
        "nan": (joints, [float("nan")] * 12),
        "empty": (joints, []),
        "partial": (joints[:11], [0.0] * 11),
    }[kind]
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        now = time.time()
        stamp = Time(int(now), int(now % 1 * 1e9))
        states.write(JointState(Header(stamp, ""), names, positions, [], []))
        time.sleep(0.02)
    print(f"peer: {kind}")


def refuse():
    """Calls /tip/start for two seconds of answers, each of which has to be a refusal with a joint's name."""
    requests = DataWriter(graph, topic("rq/tip/startRequest", Request), qos=QOS)
    replies = DataReader(graph, topic("rr/tip/startReply", Reply), qos=QOS)
    client, refused = random.getrandbits(63), 0
    for number in range(40):
        requests.write(Request(client, number, 0))
        for reply in replies.take_iter(timeout=duration(milliseconds=300)):
            if (reply.client, reply.number) != (client, number):
                continue
            if reply.success or not reply.message.startswith("no position of J"):
                sys.exit(f"peer: started: {reply}")
            refused += 1
        if refused == 8:
            print(f"peer: refused {refused} times")
            return
    sys.exit(f"peer: refused {refused} times only")


def call(name):
    """Calls a service, again until it succeeds."""
    requests = DataWriter(graph, topic(f"rq/tip/{name}Request", Request), qos=QOS)
    replies = DataReader(graph, topic(f"rr/tip/{name}Reply", Reply), qos=QOS)
    client = random.getrandbits(63)
    for number in range(50):
        requests.write(Request(client, number, 0))
        for reply in replies.take_iter(timeout=duration(milliseconds=300)):
            if (reply.client, reply.number) == (client, number) and reply.success:
                print(f"peer: {name}")
                return
    sys.exit(f"peer: {name} is not answered")


def assign(texts):
    """Publishes assignments, again and again: nobody says when the node has seen this peer."""
    writer = DataWriter(graph, topic("rt/tip/set", Text), qos=QOS)
    for _ in range(8):
        for text in texts:
            writer.write(Text(text))
        time.sleep(0.25)
    print(f"peer: set {' '.join(texts)}")


def diagnose():
    """Waits until the program has ended; until then it must report that it runs, in more and more cycles."""
    reader = DataReader(graph, topic("rt/diagnostics", Diagnostics), qos=QOS)
    cycles, end = [], time.monotonic() + 90
    while time.monotonic() < end:
        for array in reader.take_iter(timeout=duration(milliseconds=500)):
            [status] = array.status
            values = {each.key: each.value for each in status.values}
            print(f"peer: {status.name} {status.message} level {status.level} {values}")
            if status.level != 0 or status.name != "tip: walk" or not values["answered"].isdigit():
                sys.exit("peer: wrong diagnostics")
            if status.message == "ended":
                if len(cycles) < 3 or cycles != sorted(set(cycles)):
                    sys.exit(f"peer: it did not run: {cycles}")
                return
            if status.message == "runs":
                cycles.append(int(values["cycle"]))
    sys.exit("peer: it did not end")


match sys.argv[1:]:
    case ["echo", seconds]:
        echo(float(seconds))
    case ["gripper" | "nan" | "empty" | "partial" as kind, seconds]:
        mislead(kind, float(seconds))
    case ["refused"]:
        refuse()
    case ["set", *texts]:
        assign(texts)
    case ["diagnostics"]:
        diagnose()
    case [name]:
        call(name)
