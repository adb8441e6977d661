"""The service as Python's tools meet it: openapi-spec-validator accepts its definition, and xarray finds in NetCDF answers the
numbers of the CoverageJSON answers to the same query."""

import json
import sys
import urllib.parse
import urllib.request

import numpy as np
import xarray as xr
from openapi_spec_validator import validate

base = sys.argv[1]


def get(path, **query):
    text = urllib.parse.urlencode({key.replace("_", "-"): value for key, value in query.items()})
    with urllib.request.urlopen(base + path + ("?" + text if text else ""), timeout=20) as answer:
        return answer.headers["Content-Type"], answer.read()


definition = json.loads(get("/api")[1])
validate(definition)

EAST = "eastward_sea_water_velocity"
HOURS = "2025-03-10T02:00:00Z/2025-03-10T06:00:00Z"
AREA = "POLYGON((2.39 57.19,2.47 57.19,2.47 57.25,2.39 57.19))"
QUERIES = [
    ("position", dict(coords="POINT(2.41 57.21)", z="0/20", datetime=HOURS)),
    ("position", dict(coords="MULTIPOINT((2.41 57.21),(2.45 57.23))", z="5", datetime=HOURS)),
    ("area", dict(coords=AREA, z="0/20", datetime=HOURS)),
    ("cube", dict(bbox="2.39,57.19,2.47,57.25", z="5,10", datetime=HOURS)),
    ("trajectory", dict(coords="LINESTRING(2.41 57.21,2.45 57.23)", z="5", datetime="2025-03-10T02:00:00Z")),
    ("locations/lone", dict(z="5,10")),
]
PRODUCT = "product-currents-NWSHELF_ANALYSISFORECAST_PHY_004_013"
ASKED = [("currents", query, parameters) for query, parameters in QUERIES]
ASKED += [(PRODUCT, query, parameters) for query, parameters in QUERIES[:4]]


def numbers_of(coverage_json):
    coverages = coverage_json.get("coverages", [coverage_json])
    values = [v for c in coverages for v in c["ranges"][EAST]["values"]]
    return np.sort(np.array([v for v in values if v is not None], dtype=float))


count = 0
for collection, query, parameters in ASKED:
    path = f"/collections/{collection}/{query}"
    media_type, netcdf = get(path, f="NetCDF", **parameters)
    assert media_type == "application/netcdf", media_type
    expected = numbers_of(json.loads(get(path, **parameters)[1]))
    name = f"{query.replace('/', '_')}.nc"
    with open(name, "wb") as file:
        file.write(netcdf)
    with xr.open_dataset(name) as data:
        assert data.attrs["Conventions"] == "CF-1.8"
        assert data[EAST].attrs["units"] in ("m/s", "m s-1"), data[EAST].attrs
        found = np.sort(data[EAST].values.ravel())
        found = found[~np.isnan(found)]
        assert found.size == expected.size > 0, (query, found.size, expected.size)
        assert np.allclose(found, expected, rtol=0, atol=6e-6), query
        count += found.size
print("openapi-spec-validator accepts the definition; xarray finds", count, "numbers in", len(ASKED), "answers")
