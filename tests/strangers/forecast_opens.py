"""The forecast file as strangers' tools see it: xarray reads it, and its numbers are those of `profile --json`."""

import json
import subprocess
import sys

import numpy as np
import xarray as xr

program, store, site, forecast_file = sys.argv[1:5]

with xr.open_dataset(forecast_file) as data:
    assert data.attrs["Conventions"] == "CF-1.8", data.attrs["Conventions"]
    for component in ("eastward", "northward"):
        name = component + "_sea_water_velocity"
        holders = [v for v in data.data_vars
                   if data[v].attrs.get("standard_name") == name and data[v].dims == ("time", "depth")]
        assert holders == [name], holders
        assert data[name].attrs["units"] == "m s-1"
        for quantile in ("_p10", "_p50", "_p90"):
            assert data[name + quantile].dims == ("time", "depth")
        assert bool((data[name + "_p10"] <= data[name + "_p90"]).all())
    assert data["time"].size == 73, data["time"].size
    assert str(data["time"].dtype).startswith("datetime64")
    steps = np.diff(data["time"].values) / np.timedelta64(1, "h")
    assert np.all(steps == 1.0), steps
    assert data["depth"].attrs["positive"] == "down"
    assert data["station_name"].dtype.kind in "SO"

    stamp = data["time"].values[7]
    text = np.datetime_as_string(stamp, unit="s") + "Z"
    answer = json.loads(
        subprocess.run([program, "--store", store, "profile", "--site", site, "--time", text, "--json"],
                       check=True, capture_output=True, text=True).stdout)
    levels = [level for level in answer["levels"] if level["status"] == "ok"]
    assert len(levels) > 5, len(levels)
    for level in levels:
        cell = data.sel(time=stamp).sel(depth=level["depth_m"], method="nearest")
        for component in ("eastward", "northward"):
            name = component + "_sea_water_velocity"
            assert abs(float(cell[name]) - level[name]["value"]) < 1e-6, (level, float(cell[name]))
print("xarray agrees with profile at", text, "on", len(levels), "levels")
