"""samples_open.py SAMPLES: xarray reads what `slackwater sample --members` wrote; values are there where the status is ok."""
import sys

import numpy
import xarray

data = xarray.open_dataset(sys.argv[1])
status = data["sea_water_velocity_status"]
assert status.dims == ("point", "time", "depth"), status.dims
is_ok = (status == 0).values
assert is_ok.any() and not is_ok.all(), "water at the first point, below its bed, and a point outside"
assert set(numpy.unique(status.values[1])) == {4}, "the second point is outside the area"
for component in ("eastward", "northward"):
    name = component + "_sea_water_velocity"
    central = data[name]
    assert central.attrs["standard_name"] == name and central.attrs["units"] == "m s-1"
    assert (numpy.isfinite(central.values) == is_ok).all(), name
    members = data[name + "_member"]
    assert members.dims == ("realization", "point", "time", "depth"), members.dims
    assert (numpy.isfinite(members.values) == is_ok).all(), "of a member"
    at_one_place = members.values[:, 0][:, is_ok[0]]
    assert numpy.ptp(at_one_place, axis=0).max() > 0, "members that differ"
assert data["realization"].values[0] == 1
assert str(data["time"].dtype).startswith("datetime64")
print("xarray: samples over", dict(data.sizes))
