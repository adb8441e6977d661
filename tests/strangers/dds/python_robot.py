"""python_robot.py PROGRAMS DOMAIN: a made-up vehicle of ours and a robot's program in Python, with cyclonedds of PyPI.
The types are written down here once more, by interop's field order."""
import dataclasses
import math
import sys
import time
from dataclasses import dataclass

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct, types
from cyclonedds.idl.annotations import final
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from made_up_vehicle import BATTERY, ODOMETRY, PROFILE, Vehicle, same


@dataclass
@final
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: types.int32
    nanosec: types.uint32


@dataclass
@final
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time
    frame_id: str


@dataclass
@final
class Vector3(IdlStruct, typename="geometry_msgs::msg::dds_::Vector3_"):
    x: types.float64
    y: types.float64
    z: types.float64


@dataclass
@final
class Quaternion(IdlStruct, typename="geometry_msgs::msg::dds_::Quaternion_"):
    x: types.float64
    y: types.float64
    z: types.float64
    w: types.float64


@dataclass
@final
class Pose(IdlStruct, typename="geometry_msgs::msg::dds_::Pose_"):
    position: Vector3
    orientation: Quaternion


@dataclass
@final
class PoseWithCovariance(IdlStruct, typename="geometry_msgs::msg::dds_::PoseWithCovariance_"):
    pose: Pose
    covariance: types.array[types.float64, 36]


@dataclass
@final
class Twist(IdlStruct, typename="geometry_msgs::msg::dds_::Twist_"):
    linear: Vector3
    angular: Vector3


@dataclass
@final
class TwistWithCovariance(IdlStruct, typename="geometry_msgs::msg::dds_::TwistWithCovariance_"):
    twist: Twist
    covariance: types.array[types.float64, 36]


@dataclass
@final
class Odometry(IdlStruct, typename="nav_msgs::msg::dds_::Odometry_"):
    header: Header
    child_frame_id: str
    pose: PoseWithCovariance
    twist: TwistWithCovariance


@dataclass
@final
class BatteryState(IdlStruct, typename="sensor_msgs::msg::dds_::BatteryState_"):
    header: Header
    voltage: types.float32
    temperature: types.float32
    current: types.float32
    charge: types.float32
    capacity: types.float32
    design_capacity: types.float32
    percentage: types.float32
    power_supply_status: types.uint8
    power_supply_health: types.uint8
    power_supply_technology: types.uint8
    present: bool
    cell_voltage: types.sequence[types.float32]
    cell_temperature: types.sequence[types.float32]
    location: str
    serial_number: str


@dataclass
@final
class CurrentProfile(IdlStruct, typename="slackwater_msgs::msg::dds_::CurrentProfile_"):
    header: Header
    instance: str
    latitude: types.float64
    longitude: types.float64
    depth_m: types.sequence[types.float64]
    east_m_s: types.sequence[types.float64]
    north_m_s: types.sequence[types.float64]
    east_p10: types.sequence[types.float64]
    east_p90: types.sequence[types.float64]
    north_p10: types.sequence[types.float64]
    north_p90: types.sequence[types.float64]


RELIABLE = Policy.Reliability.Reliable(duration(milliseconds=100))
STATE = Qos(RELIABLE, Policy.Durability.Volatile, Policy.History.KeepLast(10))
LATCHED = Qos(RELIABLE, Policy.Durability.TransientLocal, Policy.History.KeepLast(1))


def first(reader, seconds=20):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for sample in reader.take(N=1):
            return sample
        time.sleep(.01)
    raise TimeoutError("nothing was heard")


def plain(value):
    """As JSON has it: NaN is null."""
    if dataclasses.is_dataclass(value):
        return {f.name: plain(getattr(value, f.name)) for f in dataclasses.fields(value)}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    return None if isinstance(value, float) and math.isnan(value) else value


def numbers(value):
    return list(plain(value).values())


def main():
    programs, domain = sys.argv[1:3]
    participant = DomainParticipant(int(domain))
    odometry = DataReader(participant, Topic(participant, "rt/rov/odometry", Odometry), STATE)
    with Vehicle(programs, domain) as vehicle:
        heard = first(odometry)
        same({"header": plain(heard.header), "child_frame_id": heard.child_frame_id,
              "position": numbers(heard.pose.pose.position), "orientation": numbers(heard.pose.pose.orientation),
              "linear": numbers(heard.twist.twist.linear), "angular": numbers(heard.twist.twist.angular)},
             ODOMETRY, "odometry")
        # These come late: what was said last is there for them.
        battery = DataReader(participant, Topic(participant, "rt/rov/battery_state", BatteryState), LATCHED)
        same(plain(first(battery)), BATTERY, "battery_state")
        profile = DataReader(participant, Topic(participant, "rt/site/current_profile", CurrentProfile), LATCHED)
        same(plain(first(profile)), PROFILE, "current_profile")

        writer = DataWriter(participant, Topic(participant, "rt/rov/cmd_vel", Twist), STATE)
        for _ in range(100):
            writer.write(Twist(Vector3(1.5, .25, -.5), Vector3(0, 0, .5)))
            time.sleep(.05)
            if not vehicle.orders.empty():
                break
        same(vehicle.asked("cmd_vel")["numbers"], [1.5, -.25, .5, 0, 0, -.5], "cmd_vel, forward, right, down")
    print("odometry, battery and current profile read in Python, a velocity asked for")


if __name__ == "__main__":
    main()
