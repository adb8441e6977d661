"""NetCDF and CSV answers as strangers' tools see them: xarray and Python's csv find the numbers that were made up
(tests/api/door/edr/made_up_answer.h)."""

import csv
import pathlib
import sys

import numpy as np
import xarray as xr

EAST = "eastward_sea_water_velocity"
NORTH = "northward_sea_water_velocity"
COLUMNS = [EAST, NORTH, EAST + "_p10"]


def made_up(coverage, parameter, count):
    return coverage + 0.125 * parameter - 0.001 * np.arange(count)


def expected(domains, count):
    """For each parameter the values of all domains, one after the other."""
    for p in range(3):
        values = np.concatenate([made_up(c, p, count) for c in range(domains)])
        if p == 1:
            values[::count] = np.nan
        yield values


def check_netcdf(path, kind, domains):
    with xr.open_dataset(path) as data:
        assert data.attrs["Conventions"] == "CF-1.8"
        assert data.attrs["slackwater_instance"] == "20250309T0500Z"
        assert "©" in data.attrs["references"]
        holders = [v for v in data.data_vars if data[v].attrs.get("standard_name") == EAST]
        assert holders == [EAST], holders
        assert str(data["time"].dtype).startswith("datetime64")
        flat, up = kind.endswith("_flat"), kind.endswith("_up")
        level = "altitude" if up else "depth"
        assert (level in data.coords) == (not flat), list(data.coords)
        if not flat:
            assert data[level].attrs["positive"] == ("up" if up else "down")
        if kind.startswith("grid"):
            # Domains a degree apart make one grid, mostly empty; each is cut out again.
            assert data[EAST].dims == (("time",) if flat else ("time", level)) + ("latitude", "longitude")
            for p, name in enumerate(COLUMNS):
                for c in range(domains):
                    part = data[name].isel(longitude=slice(3 * c, 3 * c + 3)).values.ravel()
                    want = made_up(c, p, part.size)
                    assert np.allclose(part[1:], want[1:], atol=1e-12), (path, name)
                    assert np.isnan(part[0]) if p == 1 else part[0] == want[0]
            return
        feature = {"trajectory": "trajectory"}.get(kind.split("_")[0], "timeSeries" if flat else "timeSeriesProfile")
        assert data.attrs["featureType"] == feature, data.attrs["featureType"]
        for name, want in zip(COLUMNS, expected(domains, data[EAST].size // domains)):
            got = data[name].values.ravel()
            assert np.allclose(got, want, atol=1e-12, equal_nan=True), (path, name, got, want)


def check_csv(path, kind, domains):
    with open(path, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    level = {"flat": None, "up": "height_m"}.get(kind.split("_")[-1], "depth_m")
    names = ["longitude", "latitude"] + ([level] if level else []) + ["time"] + [c + " [m/s]" for c in COLUMNS]
    assert list(rows[0]) == names, list(rows[0])
    for name, want in zip(COLUMNS, expected(domains, len(rows) // domains)):
        got = np.array([float(row[name + " [m/s]"] or "nan") for row in rows])
        assert np.allclose(got, want, atol=1e-6, equal_nan=True), (path, name)
    assert np.all(np.array([row["time"] for row in rows], dtype="U20") >= "2025-03-10T00:00:00Z")


count = 0
for path in sorted(pathlib.Path(sys.argv[1]).iterdir()):
    kind, domains = path.stem.rsplit("-", 1)
    check = {".nc": check_netcdf, ".csv": check_csv}.get(path.suffix)
    if check:
        check(path, kind, int(domains))
        count += 1
assert count == 60, count
print("xarray and csv find the numbers of", count, "answers")
