#!/usr/bin/env python3
"""An agent in another process, over Cyclone DDS: flies a square with a vehicle of `slackwater live`, in lock-step.

    pip install cyclonedds
    slackwater live pile.yaml --dds-domain 7 &
    python3 square_agent.py --domain 7 --vehicle rov --side 10

It asks for the helm, then answers each observation with a velocity through the water towards the next corner, and ends
when it is round. Exit 0: it came round; 1: it was refused, or lost its vehicle.
"""
import argparse
import math
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import float64, int32, sequence, uint8, uint32, uint64
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic


# Each under the name that ROS 2 has for it on DDS.
@dataclass
@final
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: int32 = 0
    nanosec: uint32 = 0


@dataclass
@final
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time
    frame_id: str = ""


@dataclass
@final
class Vector3(IdlStruct, typename="geometry_msgs::msg::dds_::Vector3_"):
    x: float64 = 0
    y: float64 = 0
    z: float64 = 0


@dataclass
@final
class Quaternion(IdlStruct, typename="geometry_msgs::msg::dds_::Quaternion_"):
    x: float64
    y: float64
    z: float64
    w: float64


@dataclass
@final
class Pose(IdlStruct, typename="geometry_msgs::msg::dds_::Pose_"):
    position: Vector3
    orientation: Quaternion


@dataclass
@final
class PoseStamped(IdlStruct, typename="geometry_msgs::msg::dds_::PoseStamped_"):
    header: Header
    pose: Pose


@dataclass
@final
class Twist(IdlStruct, typename="geometry_msgs::msg::dds_::Twist_"):
    linear: Vector3
    angular: Vector3


@dataclass
@final
class Path(IdlStruct, typename="nav_msgs::msg::dds_::Path_"):
    header: Header
    poses: sequence[PoseStamped]


@dataclass
@final
class HostRequest(IdlStruct, typename="slackwater_msgs::msg::dds_::HostRequest_"):
    token: uint64
    version: uint32
    role: uint8
    timeout_s: float64


@dataclass
@final
class HostAnswer(IdlStruct, typename="slackwater_msgs::msg::dds_::HostAnswer_"):
    token: uint64
    success: bool
    message: str
    version: uint32
    step_s: float64


@dataclass
@final
class AgentObservation(IdlStruct, typename="slackwater_msgs::msg::dds_::AgentObservation_"):
    header: Header
    step: uint64
    pose: Pose
    twist: Twist
    state_of_charge: float64
    voltage: float64
    altitude_m: float64
    doing: str


@dataclass
@final
class AgentCommand(IdlStruct, typename="slackwater_msgs::msg::dds_::AgentCommand_"):
    step: uint64
    kind: uint8
    velocity: Twist
    thrusters: sequence[float64]
    path: Path


AGENT, LEAVE, VELOCITY, HOLD = 1, 0, 1, 4
RELIABLE = Qos(Policy.Reliability.Reliable(1_000_000_000), Policy.History.KeepLast(10))


def towards(pose, corner, speed):
    """Ahead, to the left and up, in the vehicle's axes (its heading: REP-103, counted from east to north)."""
    q = pose.orientation
    yaw = math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))
    east, north, up = (c - p for c, p in zip(corner, (pose.position.x, pose.position.y, pose.position.z)))
    away = math.hypot(east, north)
    way = math.atan2(north, east) - yaw
    made = min(speed, 0.5 * away)
    return Twist(Vector3(made * math.cos(way), made * math.sin(way), max(-0.2, min(0.2, 0.3 * up))), Vector3()), away


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--domain", type=int, default=0)
    options.add_argument("--vehicle", default="rov")
    options.add_argument("--side", type=float, default=10)
    options.add_argument("--speed", type=float, default=0.4)
    options.add_argument("--patience", type=float, default=30, help="seconds of silence that end it")
    asked = options.parse_args()
    participant = DomainParticipant(asked.domain)

    def topic(what, kind):
        return Topic(participant, f"rt/{asked.vehicle}/host/{what}", kind)
    request = DataWriter(participant, topic("request", HostRequest), qos=RELIABLE)
    command = DataWriter(participant, topic("command", AgentCommand), qos=RELIABLE)
    answers = DataReader(participant, topic("answer", HostAnswer), qos=RELIABLE)
    observations = DataReader(participant, topic("observation", AgentObservation), qos=RELIABLE)

    token, until, corners, heard = time.time_ns(), time.monotonic() + asked.patience, None, False
    while time.monotonic() < until:
        if not heard:
            # Until it is answered: the other side may not know of us yet.
            request.write(HostRequest(token=token, version=1, role=AGENT, timeout_s=1.0))
            time.sleep(0.2)
        for answer in answers.take():
            if answer.token == token and not heard:
                print(answer.message, file=sys.stderr)
                if not answer.success:
                    return 1
                heard = True
        for seen in observations.take():
            until = time.monotonic() + asked.patience
            here = seen.pose.position
            if corners is None:
                corners = [(here.x + e * asked.side, here.y + n * asked.side, here.z)
                           for e, n in ((1, 0), (1, 1), (0, 1), (0, 0))]
            velocity, away = towards(seen.pose, corners[0], asked.speed)
            if away < 0.7:
                corners.pop(0)
                print(f"{4 - len(corners)} of 4 corners at {here.x:.1f} {here.y:.1f}", file=sys.stderr)
            path = Path(Header(Time()), [])
            kind = VELOCITY if corners else HOLD
            command.write(AgentCommand(seen.step, kind, velocity, [], path))
            if not corners:
                # Said, so that no step waits for us any more.
                request.write(HostRequest(token=token, version=1, role=LEAVE, timeout_s=1.0))
                time.sleep(0.5)
                return 0
        time.sleep(0.0005)
    return 1


if __name__ == "__main__":
    sys.exit(main())
