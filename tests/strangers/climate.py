"""`slackwater climate`, held against the definitions written down a second time in numpy, and against scipy.

climate.py PROGRAM SHARED WORK

Shares of roses and scatter tables have to be equal: both sides count whole steps, numpy by `histogram2d` over edges. Of
extremes:

- the fits by probability-weighted moments are written down a second time, from pairs and triples of the sample;
- scipy's distributions (`genpareto`, `genextreme`, `gumbel_r`) have the quantiles of our fits, to rounding;
- scipy's fits by maximum likelihood, another method, lie within our 90 % intervals on samples of known parameters;
- scipy's L-moments, where this scipy has them, are ours.

The series are made up with a fixed seed, and, where SLACKWATER_SHARED has them, those of alpha ventus and NORA3.
"""

import csv
import json
import os
import pathlib
import subprocess
import sys

import numpy as np
from scipy import special, stats

PROGRAM, SHARED, WORK = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
ALPHA = SHARED / "data/weather_windows/alpha_ventus_weather_2002_2014.csv"
NORA3 = SHARED / "data/nora3/NORA3_wind_wave_lon1.32_lat53.324_20221001_20221231.csv"
HEIGHT, FROM = "sea_surface_wave_significant_height", "sea_surface_wave_from_direction"
PEAK = "sea_surface_wave_period_at_variance_spectral_density_maximum"
# Of each law; `make soak` takes more.
HISTORIES = int(os.environ.get("SLACKWATER_HISTORIES", "2"))
EULER = 0.5772156649015329


def climate(*arguments):
    done = subprocess.run([PROGRAM, "climate", *map(str, arguments), "--json"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def write(path, start, step_h, columns):
    times = np.datetime64(start, "m") + np.arange(len(next(iter(columns.values())))) * np.timedelta64(step_h * 60, "m")
    with open(path, "w") as out:
        out.write("time," + ",".join(columns) + "\n")
        for i, time in enumerate(times):
            out.write(f"{time}Z," + ",".join("" if np.isnan(v[i]) else repr(float(v[i])) for v in columns.values()) + "\n")
    return path


# --- roses and tables ---


def expect_rose(rose, size, direction, edges, sectors, calm):
    known = ~np.isnan(size)
    still = known & ((size < calm) | (size == 0))
    lost = known & ~still & np.isnan(direction)
    moving = known & ~still & ~lost
    width = 360 / sectors
    where = np.mod(direction[moving] + width / 2, 360)
    counts, _, _ = np.histogram2d(where, size[moving], bins=[np.arange(sectors + 1) * width, [0, *edges, np.inf]])
    whole = known.sum()
    assert rose["known_steps"] == whole and rose["missing_steps"] == (~known).sum()
    assert rose["calm"]["share"] == still.sum() / whole
    assert rose["no_direction_share"] == lost.sum() / whole
    ours = np.array([sector["by_class"] for sector in rose["sectors"]])
    assert np.array_equal(ours, counts / whole), np.abs(ours - counts / whole).max()
    assert abs(ours.sum() + rose["calm"]["share"] + rose["no_direction_share"] - 1) < 1e-12


def expect_scatter(table, first, first_edges, second, second_edges):
    known = ~np.isnan(first) & ~np.isnan(second)
    counts, _, _ = np.histogram2d(first[known], second[known],
                                  bins=[[0, *first_edges, np.inf], [0, *second_edges, np.inf]])
    assert table["known_steps"] == known.sum()
    ours = np.array(table["per_mille"])
    assert np.allclose(ours, 1000 * counts / known.sum(), rtol=1e-14, atol=0)
    assert abs(ours.sum() - 1000) < 1e-9


def made_up_rose(rng):
    """A wind with gaps, by speed and direction and by components; a tide that turns evenly."""
    steps = 5000
    speed = np.round(rng.weibull(2, steps) * 8, 2)
    direction = np.round(rng.uniform(0, 360, steps) * 8) / 8
    speed[rng.random(steps) < 0.05] = np.nan
    direction[rng.random(steps) < 0.03] = np.nan
    for sectors, edges in ((12, [4, 8, 12, 16, 20, 24]), (16, [5, 10]), (36, [7.5])):
        path = write(WORK / "wind.csv", "2001-01-01", 1, {"wind_speed": speed, "wind_from_direction": direction})
        told = climate(path, "--roses", "--sectors", sectors, "--classes", "wind=" + ",".join(map(str, edges)))
        expect_rose(told["parts"][0]["rose"], speed, direction, edges, sectors, 0.5)
    # Speed and direction of components, away from edges: sines round.
    speed, toward = 0.1 + 0.2 * rng.integers(0, 6, steps) + 0.05, 30.0 * rng.integers(0, 12, steps) + rng.uniform(-14, 14, steps)
    path = write(WORK / "current.csv", "2001-01-01", 1, {
        "eastward_sea_water_velocity": speed * np.sin(np.radians(toward)),
        "northward_sea_water_velocity": speed * np.cos(np.radians(toward))})
    rose = climate(path, "--roses", "--classes", "current=0.2,0.4,0.6")["parts"][0]["rose"]
    assert rose["way"] == "to"
    expect_rose(rose, speed, toward, [0.2, 0.4, 0.6], 12, 0.05)


def real_tables():
    if not NORA3.exists():
        print("no NORA3 in SLACKWATER_SHARED: real tables are not held against numpy")
        return
    with open(NORA3) as table:
        rows = list(csv.DictReader(line for line in table if not line.startswith("#")))
    height, period, direction, wind, wind_from = (
        np.array([float(row[name]) for row in rows])
        for name in ("hs", "tp", "thq", "wind_speed_10m", "wind_direction_10m"))
    told = climate(NORA3, "--assume-utc", "--column", f"hs={HEIGHT}:m", "--column", f"tp={PEAK}:s",
                   "--column", f"thq={FROM}:degree", "--column", "wind_speed_10m=wind_speed:m s-1",
                   "--column", "wind_direction_10m=wind_from_direction:degree")
    parts = {part["of"]: part for part in told["parts"]}
    expect_rose(parts["wind"]["rose"], wind, wind_from, [4, 8, 12, 16, 20, 24], 12, 0.5)
    expect_rose(parts["waves"]["rose"], height, direction, [0.5, 1, 1.5, 2, 3, 4, 6], 12, 0.1)
    height_edges = [0.5 * i for i in range(1, 31)]
    expect_scatter(told["height_by_period"], height, height_edges, period, list(range(1, 26)))
    expect_scatter(told["height_by_direction"], height, height_edges, np.mod(direction + 15, 360),
                   [30 * i for i in range(1, 12)])


# --- extremes, a second time ---


def storms_of(values, threshold, separation):
    above = np.flatnonzero(values > threshold)
    parts = np.split(above, np.flatnonzero(np.diff(above) - 1 >= separation) + 1)
    return np.array([values[part].max() for part in parts if len(part)])


def l_moments(x):
    x = np.sort(x)
    n = len(x)
    i = np.arange(n)
    b0, b1 = x.mean(), (i * x).sum() / (n * (n - 1))
    b2 = (i * (i - 1) * x).sum() / (n * (n - 1) * (n - 2))
    return b0, 2 * b1 - b0, 6 * b2 - 6 * b1 + b0


def near(ours, theirs, what, tolerance=1e-9):
    assert abs(ours - theirs) <= tolerance * max(1, abs(theirs)), f"{what}: {ours!r}, expected {theirs!r}"


def expect_extremes(extremes, values, step_h):
    years = (~np.isnan(values)).sum() * step_h / 8766
    near(extremes["years_known"], years, "years known")
    separation = int(round(extremes["separation_h"] / step_h))
    filled = np.where(np.isnan(values), -1, values)
    for fit in [extremes["peaks"], *extremes["thresholds"]]:
        peaks = storms_of(filled, fit["threshold"], separation)
        assert fit["storms"] == len(peaks), (fit["storms"], len(peaks))
        l1, l2, _ = l_moments(peaks - fit["threshold"])
        near(fit["scale"], l1 * (l1 / l2 - 1), "scale")
        near(fit["shape"], 2 - l1 / l2, "shape")
        near(fit["greatest_seen"], peaks.max(), "greatest storm")
        for one in fit["returns"]:
            assert (one["support"] == "beyond_history") == (one["years"] > 4.04 * years)
            if one["support"] != "supported":
                continue
            share = 1 / (len(peaks) / years * one["years"])
            near(one["value"], fit["threshold"] + stats.genpareto.isf(share, fit["shape"], scale=fit["scale"]),
                 "return value")
            assert one["interval_90"][0] <= one["value"] <= one["interval_90"][1]
    maxima = np.array([year["value"] for year in extremes["annual_maxima"]])
    if "scale" in extremes["gumbel"]:
        l1, l2, _ = l_moments(maxima)
        fit = extremes["gumbel"]
        near(fit["scale"], l2 / np.log(2), "Gumbel's scale")
        near(fit["location"], l1 - EULER * l2 / np.log(2), "Gumbel's location")
        for one in (r for r in fit["returns"] if r["support"] == "supported"):
            near(one["value"], stats.gumbel_r.ppf(np.exp(-1 / one["years"]), fit["location"], fit["scale"]), "Gumbel")
    if "scale" in extremes["gev"]:
        fit = extremes["gev"]
        # Hosking, Wallis and Wood (1985).
        l1, l2, l3 = l_moments(maxima)
        c = 2 / (3 + l3 / l2) - np.log(2) / np.log(3)
        k = 7.8590 * c + 2.9554 * c**2
        scale = l2 * k / ((1 - 2**-k) * special.gamma(1 + k))
        near(fit["shape"], -k, "shape of the generalised extreme value")
        near(fit["scale"], scale, "its scale")
        near(fit["location"], l1 - scale * (1 - special.gamma(1 + k)) / k, "its location")
        for one in (r for r in fit["returns"] if r["support"] == "supported"):
            near(one["value"], stats.genextreme.ppf(np.exp(-1 / one["years"]), -fit["shape"], fit["location"],
                                                    fit["scale"]), "generalised extreme value", 1e-7)
        # Its first two moments are those of the sample, by construction; scipy integrates them.
        law = stats.genextreme(-fit["shape"], fit["location"], fit["scale"])
        near(law.mean(), l_moments(maxima)[0], "mean of the fit", 1e-6)
    return maxima


def made_up_storms(rng, years, shape, scale, per_year=12):
    """Six-hourly, a storm every 1/12 year with a peak of 4 + Pareto."""
    steps = round(years * 8766 / 6)
    values = rng.uniform(0.5, 2.0, steps)
    every = 8766 / per_year / 6
    starts = (np.arange(int(steps / every)) * every + 20).astype(int)
    starts = starts[starts + 10 < steps]
    peaks = np.round(4 + stats.genpareto.rvs(shape, scale=scale, size=len(starts), random_state=rng), 3)
    for start, peak in zip(starts, peaks):
        for offset in range(-4, 5):
            values[start + offset] = peak * (1 - 0.08 * abs(offset))
    return np.round(values, 3), peaks


def extremes_of_known_truth(rng):
    """Within what 90 % intervals allow over some histories, and beside another method of fitting."""
    held = likelihood_held = told_all = 0
    for shape in (-0.15, 0.0, 0.1):
        for _ in range(HISTORIES):
            values, peaks = made_up_storms(rng, 40, shape, 0.9)
            path = write(WORK / "storms.csv", "1980-01-01", 6, {HEIGHT: values})
            extremes = climate(path, "--extremes", "--threshold", "waves=4")["parts"][0]["extremes"]
            expect_extremes(extremes, values, 6)
            excesses = peaks[peaks > 4] - 4
            c, _, s = stats.genpareto.fit(excesses, floc=0)
            for one in extremes["peaks"]["returns"][1:]:
                truth = 4 + stats.genpareto.isf(1 / (12 * one["years"]), shape, scale=0.9)
                likely = 4 + stats.genpareto.isf(1 / (12 * one["years"]), c, scale=s)
                told_all += 1
                held += one["interval_90"][0] <= truth <= one["interval_90"][1]
                likelihood_held += one["interval_90"][0] <= likely <= one["interval_90"][1]
    # Three of each history go together. Of the six by default, each held with 0.89, three are missed once in 50 times, and
    # fewer of more; the seed is fixed.
    print(f"{held} of {told_all} intervals hold the truth, {likelihood_held} scipy's maximum-likelihood value")
    assert held >= 0.65 * told_all and likelihood_held >= 0.95 * told_all


def real_extremes():
    if not ALPHA.exists():
        print("no alpha ventus in SLACKWATER_SHARED: real extremes are not held against scipy")
        return
    with open(ALPHA) as table:
        rows = list(csv.DictReader(table))
    told = climate(ALPHA, "--assume-utc", "--time-column", "datetime", "--column", f"waveheight={HEIGHT}:m",
                   "--column", "windspeed=wind_speed:m s-1", "--extremes")
    for part, column in zip(told["parts"], ("windspeed", "waveheight")):
        values = np.array([float(row[column]) for row in rows])
        years = np.array([int(row["datetime"][:4]) for row in rows])
        maxima = expect_extremes(part["extremes"], values, 1)
        assert np.array_equal(maxima, [values[years == year].max() for year in np.unique(years)])
        location, scale = stats.gumbel_r.fit(maxima)
        for one in part["extremes"]["gumbel"]["returns"][:3]:
            likely = stats.gumbel_r.ppf(np.exp(-1 / one["years"]), location, scale)
            assert one["interval_90"][0] <= likely <= one["interval_90"][1], (part["of"], one, likely)
    assert part["extremes"]["gev"]["why_not"] is not None


def linear_moments_of_scipy(rng):
    if not hasattr(stats, "lmoment"):
        print("this scipy has no L-moments")
        return
    sample = rng.gumbel(5, 1, 37)
    assert np.allclose(l_moments(sample), stats.lmoment(sample, order=[1, 2, 3], standardize=False), rtol=1e-12)


GENERATOR = np.random.default_rng(20250310)
made_up_rose(GENERATOR)
real_tables()
linear_moments_of_scipy(GENERATOR)
extremes_of_known_truth(GENERATOR)
real_extremes()
print("roses, tables and extremes are those of numpy and scipy")
