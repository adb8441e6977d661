"""A forecast with an ensemble as xarray sees it: one column, then several."""

import sys

import numpy as np
import xarray as xr


def check(path, dims):
    with xr.open_dataset(path) as data:
        assert list(data["realization"].values) == list(range(1, 21)), data["realization"].values
        for component in ("eastward", "northward"):
            name = component + "_sea_water_velocity"
            holders = {v: data[v].dims for v in data.data_vars if data[v].attrs.get("standard_name") == name}
            assert holders == {name: dims, name + "_member": dims + ("realization",)}, holders
            central, members = data[name], data[name + "_member"]
            assert members.attrs["units"] == "m s-1"
            # A member stands where the central forecast does, and starts from it (to half of 2^-13 m/s).
            assert bool((members.isnull() == central.isnull()).all())
            start = np.abs(members - central).isel(time=0)
            assert float(start.max()) <= 2.0**-14, float(start.max())
            assert float((members.max("realization") - members.min("realization")).isel(time=-1).max()) > 0.05
            wind = component + "_wind"
            wind_dims = tuple(d for d in dims if d != "depth")
            assert data[wind].dims == wind_dims, data[wind].dims
            assert data[wind + "_member"].dims == wind_dims + ("realization",)
        assert set(data["realization"].attrs) >= {"standard_name", "long_name"}


check(sys.argv[1], ("time", "depth"))
check(sys.argv[2], ("time", "depth", "column"))
print("xarray finds 20 members beside the central one")
