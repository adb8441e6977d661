"""Our sun beside NREL's solar position algorithm as pvlib has it (geometric elevation and azimuth, no refraction)."""
import importlib.util
import json
import pathlib
import sys

import numpy as np


def alone(package, module):
    """One module of a package by its file: the rest of the package needs more than is installed."""
    folder = importlib.util.find_spec(package).submodule_search_locations[0]
    spec = importlib.util.spec_from_file_location(module, pathlib.Path(folder) / f"{module}.py")
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


spa = alone("pvlib", "spa")


def utc(text):
    return np.datetime64(text.rstrip("Z"), "ms")


def position(times, latitude, longitude):
    """Elevation without refraction and azimuth, each place at its own time."""
    unix = np.asarray(times, "datetime64[ms]").astype(np.int64) / 1e3
    found = spa.solar_position_numpy(unix, np.array(latitude), np.array(longitude), 0, 1013.25, 12, 69, 0.5667, 1)
    # apparent zenith, zenith, apparent elevation, elevation, azimuth, equation of time
    return found[3], found[4]


def main():
    with open(sys.argv[1]) as file:
        made = json.load(file)
    latitude, longitude, times, elevation, azimuth = zip(*made["positions"])
    theirs, their_azimuth = position([utc(t) for t in times], latitude, longitude)
    off = np.abs(np.array(elevation) - theirs)
    # Near the zenith an azimuth means little: the distance on the sky is what counts.
    turn = (np.array(azimuth) - their_azimuth + 180) % 360 - 180
    sideways = np.abs(turn) * np.cos(np.radians(theirs))
    print(f"sun at {len(off)} places and times: elevation within {off.max():.4f}, azimuth within "
          f"{sideways.max():.4f} degrees of pvlib")
    assert off.max() < 0.015 and sideways.max() < 0.015

    worst_s, passings, whole = 0.0, 0, 0
    for day in made["days"]:
        threshold = day["least_elevation_deg"]
        around = utc(day["noon"]) + np.arange(-720, 721, 5) * np.timedelta64(1, "m")
        where = (day["latitude_deg"], day["longitude_deg"])
        curve, _ = position(around, *where)
        if day["kind"] == 1:  # light all day
            assert curve.min() > threshold - 0.05, day
            whole += 1
        elif day["kind"] == 2:
            assert curve.max() < threshold + 0.05, day
            whole += 1
        for time in (day["begin"], day["end"]):
            if time is None:
                continue
            about = utc(time) + np.array([-60, 0, 60]) * np.timedelta64(1, "s")
            low, here, high = position(about, *where)[0]
            passings += 1
            # How far the sun moves in a second there says how late a passing is.
            slope = abs(high - low) / 120
            if slope > 0.0005:
                worst_s = max(worst_s, abs(here - threshold) / slope)
            assert abs(here - threshold) < 0.02, day
    print(f"{passings} beginnings and ends of light within {worst_s:.0f} s, {whole} days of polar day or night")
    assert passings > 500 and whole > 20 and worst_s < 30


if __name__ == "__main__":
    main()
