"""speak_dds.py PROGRAMS DOMAIN: a made-up vehicle of ours and a robot's program on Cyclone DDS in C, both ways."""
import json
import subprocess
import sys

from made_up_vehicle import BATTERY, ODOMETRY, PROFILE, Vehicle, same

STAMP = {"stamp": {"sec": 1717300000, "nanosec": 250000000}}
IN_MAP = {"header": {**STAMP, "frame_id": "map"}}
IN_BODY = {"header": {**STAMP, "frame_id": "rov/base_link"}}
GOAL = "a5" * 16
# Every topic of "Slackwater's names on DDS", as a subscriber that knows nothing of us reads it.
SAID = {
    "/clock": {"clock": STAMP["stamp"]},
    "/rov/odometry": ODOMETRY,
    "/rov/pose": {**IN_MAP, "position": [4, 3, -5], "orientation": ODOMETRY["orientation"]},
    "/rov/battery_state": {**IN_BODY, **BATTERY, "cells": [0, 0]},
    "/rov/imu": {**IN_BODY, "angular_velocity": [.5, -.25, -.125], "linear_acceleration": [1, -2, 9.75],
                 "angular_velocity_covariance": [.5, .5, .5], "linear_acceleration_covariance": [2, 2, 2]},
    "/rov/nav_sat_fix": {**IN_BODY, "status": 0, "service": 1, "position": [48.5, -2.5, 52.],
                         "position_covariance_type": 1},
    "/rov/fluid_pressure": {**IN_BODY, "fluid_pressure": 101325 + 1025 * 9.80665 * 10, "variance": 0},
    "/rov/dvl": {**IN_BODY, "linear": [1, -.5, .25], "covariance": [.0625] * 3 + [-1] * 3},
    "/rov/dvl_water": {**IN_BODY, "linear": [1.25, None, None]},
    "/rov/active_waypoints": {**IN_MAP, "poses": [{**IN_MAP, "position": [2, 1, -3], "orientation": [0, 0, 0, 1]},
                                                  {"position": [20, 10, -30]}]},
    "/rov/mission_state": {"data": '{"task": 1, "says": "on its \\"way\\""}'},
    "/rov/reserve": {**IN_BODY, "energy_left_j": 1e6, "energy_home_j": 4e5, "margin_s": 900,
                     "advice": "come home by 10:40"},
    "/rov/navigate/_action/feedback": {"goal_id": GOAL, "waypoint": 2, "distance_m": 12.5},
    "/rov/navigate/_action/status": {"status_list": [{"goal_id": GOAL, **STAMP, "status": 2}]},
    "/site/current_profile": {**IN_MAP, **PROFILE},
    "/site/wind": {**IN_MAP, "vector": [8., -2., 0]},
    "/site/wave": {**IN_MAP, "hs_m": 1.5, "tp_s": 7, "from_deg": 270},
    "/site/tide_level": {"data": 1.25},
    "/site/turbine_power": {"dim": [{"label": "turbine", "size": 3, "stride": 3}], "data_offset": 0,
                            "data": [5e6, 0, 2.5e6]},
    "/ais": {**IN_MAP, "mmsi": 227000001, "name": "MARIE", "latitude": 48.5, "longitude": -2.5, "sog_m_s": 5.5},
    "ros_discovery_info": {"nodes": [{"namespace": "/", "name": "slackwater"}]},
}


class Peer:
    def __init__(self, programs, domain):
        self.start = [f"{programs}/slackwater_cyclone_peer"]
        self.options = ["--domain", str(domain), "--vehicle", "rov", "--site", "site"]

    def open(self, command, *arguments):
        return subprocess.Popen([*self.start, command, *self.options, *arguments], stdout=subprocess.PIPE, text=True)

    def run(self, command, *arguments):
        done = self.open(command, *arguments)
        out, _ = done.communicate(timeout=60)
        return done.returncode, [json.loads(line) for line in out.splitlines()]


def expect_all_said(code, lines, least_count):
    heard = {line["topic"]: line for line in lines}
    assert heard.keys() == SAID.keys(), heard.keys() ^ SAID.keys()
    for topic, line in heard.items():
        least = 1 if topic == "ros_discovery_info" else least_count  # said when something changes
        assert line["count"] >= least, f"{topic} was heard {line['count']} times"
        same(line["first"], SAID[topic], topic)
        same(line["last"], SAID[topic], topic)
    assert code == 0
    rates = [line["rate_hz"] for topic, line in heard.items() if topic != "ros_discovery_info"]
    print(f"{len(heard)} topics heard in C, {min(rates):.1f} to {max(rates):.1f} times a second")
    return rates


def main():
    programs, domain = sys.argv[1:3]
    peer = Peer(programs, domain)
    # Who is there first: the listener, then the vehicle, and the other way round.
    early = peer.open("listen", "--seconds", "30", "--enough", "1")
    with Vehicle(programs, domain) as vehicle:
        out, _ = early.communicate(timeout=60)
        # The discovery info is said once and stays: one of it must do, so this listener takes its whole time.
        code, lines = peer.run("listen", "--seconds", "3")
        rates = expect_all_said(code, lines, 2)
        assert all(5 < rate < 15 for rate in rates), rates

        peer.run("cmd_vel", "--seconds", "0.5", "1.5", "-0.25", "0.5", "0.125")
        order = vehicle.asked("cmd_vel")
        same(order["numbers"], [1.5, .25, -.5, 0, 0, -.125], "cmd_vel, forward, right, down")
        peer.run("thrusters", "--hz", "0", "0.5", "-1", "0.25")
        thrusters = vehicle.asked("thrusters")
        same(thrusters["numbers"], [.5, -1, .25], "thrusters")
        peer.run("waypoints", "1,2,-3", "10,20,-30")
        same(vehicle.asked("waypoints")["numbers"], [2, 1, 3, 20, 10, 30], "waypoints, north, east, down")
        assert order["client"].startswith("dds ") and order["client"] != thrusters["client"]
        lost = vehicle.asked("lost")
        print(f"commands taken from {order['client']}; a client that left was told: {lost['client']}")
    assert early.returncode == 0, out
    expect_all_said(0, [json.loads(line) for line in out.splitlines()], 1)

    # With nobody there, it says so.
    assert peer.run("cmd_vel", "--wait", "0.5", "1", "0", "0", "0")[0] == 1


if __name__ == "__main__":
    main()
