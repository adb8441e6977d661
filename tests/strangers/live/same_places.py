"""same_places.py LOG.nc SEEN.json: the places that viewers saw ([[vehicle, time, [x, y, z]], ...]) are those of the log."""
import datetime
import json
import sys

import netCDF4

log = netCDF4.Dataset(sys.argv[1])
names = ["".join(c.decode() for c in row if c).strip("\0 ") for row in log["trajectory"][:].filled(b"")]
begin = netCDF4.num2date(log["time"][0], log["time"].units, only_use_cftime_datetimes=False)
begin_s = begin.replace(tzinfo=datetime.timezone.utc).timestamp()
row_at = {round(float(t - log["time"][0]), 3): i for i, t in enumerate(log["time"][:])}

compared, worst_m, way_m = {name: 0 for name in names}, 0.0, 0.0
for name, stamp_s, position in json.load(open(sys.argv[2])):
    row = row_at.get(round(stamp_s - begin_s, 3))
    if row is None:  # the log has one step of ten
        continue
    vehicle = names.index(name)
    logged = [float(log[axis][vehicle, row]) for axis in "xyz"]
    worst_m = max(worst_m, max(abs(a - b) for a, b in zip(position, logged)))
    way_m = max(way_m, max(abs(float(log[axis][vehicle, row] - log[axis][vehicle, 0])) for axis in "xyz"))
    compared[name] += 1
# Two viewers, five seconds each, two rows a second.
assert all(count >= 16 for count in compared.values()), compared
assert way_m > 0.01, f"nothing moved, {way_m} m: any row would do"
assert worst_m < 1e-6, worst_m
print(f"viewers of npm saw {compared} places of the log, within {worst_m:.1e} m, on ways of {way_m:.2f} m")
