"""Joints of a ROS 2 graph by Cyclone DDS: they are where they are commanded to be. Usage: peer.py echo | start | halt SECONDS"""

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


match sys.argv[1:]:
    case ["echo", seconds]:
        echo(float(seconds))
    case [name]:
        call(name)
