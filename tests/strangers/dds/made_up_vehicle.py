"""The made-up vehicle as a process, what it says, and how numbers are compared."""
import json
import math
import queue
import subprocess
import threading

# Of tests/api/door/dds/vehicle_for_tests.h and site_for_tests.h, turned to ENU and forward, left, up by hand.
ODOMETRY = {
    "header": {"stamp": {"sec": 1717300000, "nanosec": 250000000}, "frame_id": "map"},
    "child_frame_id": "rov/base_link",
    "position": [4, 3, -5], "orientation": [math.sqrt(.5), 0, 0, math.sqrt(.5)],
    "linear": [1.5, -.25, .5], "angular": [.125, -.5, .25],
}
BATTERY = {
    "voltage": 15.5, "temperature": None, "current": -8.25, "charge": 12, "capacity": 16, "design_capacity": 16,
    "percentage": .75, "power_supply_status": 2, "power_supply_health": 1, "power_supply_technology": 2,
    "present": True, "location": "hull", "serial_number": "",
}
SPREAD = .125 * 1.2815515655446004
PROFILE = {
    "instance": "test 2025-06-01 issued 2025-06-02T05:00:00Z", "latitude": 48.5, "longitude": -2.5,
    "depth_m": [0, 10], "east_m_s": [.5, .25], "north_m_s": [-.125, -.25],
    "east_p10": [.5 - SPREAD, .25 - SPREAD], "east_p90": [.5 + SPREAD, .25 + SPREAD],
    "north_p10": [-.125 - SPREAD, -.25 - SPREAD], "north_p90": [-.125 + SPREAD, -.25 + SPREAD],
}


def same(found, wanted, where):
    """All that is wanted is there, numbers to rounding."""
    if isinstance(wanted, dict):
        for key, value in wanted.items():
            assert key in found, f"{where}: no {key} in {found}"
            same(found[key], value, f"{where}.{key}")
    elif isinstance(wanted, list):
        assert len(found) == len(wanted), f"{where}: {found}, not {wanted}"
        for i, (one, other) in enumerate(zip(found, wanted)):
            same(one, other, f"{where}[{i}]")
    elif isinstance(wanted, float):
        assert found is not None and abs(found - wanted) < 1e-12 * max(1, abs(wanted)), f"{where}: {found}, not {wanted}"
    else:
        assert found == wanted, f"{where}: {found!r}, not {wanted!r}"


class Vehicle:
    """Says all it has to say while it lives, and tells what was asked of it."""

    def __init__(self, programs, domain):
        self.process = subprocess.Popen([f"{programs}/slackwater_made_up_vehicle", str(domain), "120"],
                                        stdout=subprocess.PIPE, text=True)
        self.orders = queue.Queue()
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            self.orders.put(json.loads(line))

    def asked(self, what):
        """The next order of that kind. @throws queue.Empty"""
        while True:
            order = self.orders.get(timeout=20)
            if order["asked"] == what:
                return order

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
