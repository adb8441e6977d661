"""`slackwater workability` on real series, held against the definitions written down a second time in numpy.

workability.py PROGRAM SHARED WORK

Counts, lengths, ratios, waiting times and their percentiles have to be equal, not near: both sides count in whole steps
and interpolate by the same rule (the n-th order statistics, linear, (n - 1) p / 100). numpy.percentile is held against
the same numbers with a tolerance of rounding, since it works out the place between two neighbours in floating point.

Two published programs stand beside, where they mean the same:

- metocean-stats 1.2.0, `weather_window_length`: the time until a task is done, from every step up to the last start. It
  is ours plus the duration, in days; its limit is strict (<); its month is that of the step from which one waits, as ours.
  It counts the wait of the series' very first steps in steps, not hours, so that the two agree for hourly series alone.
  Its `windows` are not ours: it never counts them.
- WOMBAT 0.13.5, `calculate_delay_from_forecast`: the hours to the first window that is long enough, from now on. That is
  our wait of one step; a chain of such delays and durations is our campaign. Its repairs beside it (shifts, crews, travel)
  have no part in ours, and `find_uninterrupted_weather_window` ends at the shift's end, which ours does not.

Of both packages the one function is read from its source: all that they import beside it (matplotlib, jupyter, polars) is
not needed for it.
"""

import ast
import csv
import importlib.util
import json
import pathlib
import subprocess
import sys

import numpy as np

PROGRAM, SHARED, WORK = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
ALPHA = SHARED / "data/weather_windows/alpha_ventus_weather_2002_2014.csv"
NORA3 = SHARED / "data/nora3/NORA3_wind_wave_lon1.32_lat53.324_20221001_20221231.csv"
SIGNS = {"<=": np.less_equal, "<": np.less, ">=": np.greater_equal, ">": np.greater}
HEIGHT, WIND = "sea_surface_wave_significant_height", "wind_speed"
PEAK = "sea_surface_wave_period_at_variance_spectral_density_maximum"


def program(*arguments):
    done = subprocess.run([PROGRAM, "workability", *arguments], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class Series:
    """A table as a test has it: hours since the first, columns, NaN where there is nothing."""

    def __init__(self, start, values, step_h=1):
        self.start = np.datetime64(start, "m")
        self.values = values
        self.step_h = step_h
        self.steps = len(next(iter(values.values())))

    def times(self):
        return self.start + np.arange(self.steps) * np.timedelta64(int(60 * self.step_h), "m")

    def write(self, path, left_out=()):
        """Rows whose number is in `left_out` are not there at all; NaN is an empty cell."""
        left_out = set(left_out)
        with open(path, "w") as out:
            out.write("time," + ",".join(self.values) + "\n")
            for i, time in enumerate(self.times()):
                if i in left_out:
                    continue
                cells = ["" if np.isnan(v[i]) else repr(float(v[i])) for v in self.values.values()]
                out.write(f"{time}Z,{','.join(cells)}\n")


def alpha_ventus():
    with open(ALPHA) as table:
        rows = list(csv.DictReader(table))
    return Series(rows[0]["datetime"], {
        WIND: np.array([float(row["windspeed"]) for row in rows]),
        HEIGHT: np.array([float(row["waveheight"]) for row in rows])})


def nora3():
    with open(NORA3) as table:
        rows = list(csv.DictReader(line for line in table if not line.startswith("#")))
    return Series(rows[0]["time"].replace(" ", "T"), {
        WIND: np.array([float(row["wind_speed_10m"]) for row in rows]),
        HEIGHT: np.array([float(row["hs"]) for row in rows]),
        PEAK: np.array([float(row["tp"]) for row in rows])})


# --- the definitions, a second time ---


def percentile(ascending, percent):
    place, hundredths = divmod((len(ascending) - 1) * percent, 100)
    low = float(ascending[place])
    return low if hundredths == 0 else low + (float(ascending[place + 1]) - low) * hundredths / 100.0


def runs(marks):
    """Beginnings and ends of the runs of a truth array."""
    edges = np.diff(np.concatenate(([0], marks.astype(np.int8), [0])))
    return np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)


def accessible_of(series, limits):
    ok = np.ones(series.steps, bool)
    known = np.ones(series.steps, bool)
    with np.errstate(invalid="ignore"):
        for name, sign, value in limits:
            ok &= SIGNS[sign](series.values[name], value)
            known &= ~np.isnan(series.values[name])
    return ok & known, known


def starts_of(accessible, needed, may_start):
    sums = np.concatenate(([0], np.cumsum(accessible)))
    starts = np.zeros(len(accessible), bool)
    if needed <= len(accessible):
        starts[: len(accessible) - needed + 1] = sums[needed:] - sums[:-needed] == needed
    return starts & may_start


def waits_of(starts):
    """Steps to the next start, -1 where there is none."""
    steps = len(starts)
    here = np.where(starts, np.arange(steps), steps)
    following = np.minimum.accumulate(here[::-1])[::-1]
    return np.where(following < steps, following - np.arange(steps), -1)


def statistics(series, limits, duration_h, contingency_h, hours):
    """All figures, and by month and year."""
    accessible, known = accessible_of(series, limits)
    needed = int(np.ceil((duration_h + contingency_h) / series.step_h))
    times = series.times()
    hour = (times - times.astype("datetime64[D]")) / np.timedelta64(60, "m")
    may_start = np.ones(series.steps, bool) if hours is None else (hour >= hours[0]) & (hour < hours[1])
    starts = starts_of(accessible, needed, may_start)
    waits = waits_of(starts)
    begin, end = runs(accessible)
    storm_begin, storm_end = runs(~accessible)
    has_start = np.array([starts[b:e].any() for b, e in zip(begin, end)], bool)

    def of(here):
        def ratio(part, whole):
            return int(part) / int(whole) if whole else None

        mine = here[begin] if len(begin) else np.zeros(0, bool)
        storms = here[storm_begin] if len(storm_begin) else np.zeros(0, bool)
        lengths = (end - begin)[mine]
        found = np.sort(waits[here & (waits >= 0)])
        wait = dict.fromkeys(["mean", "p10", "p50", "p80", "p90"])
        if len(found):
            wait = {f"p{p}": percentile(found, p) * series.step_h for p in (10, 50, 80, 90)}
            wait["mean"] = int(found.sum()) / len(found) * series.step_h
            theirs = np.percentile(found, [10, 50, 80, 90]) * series.step_h
            assert np.allclose([wait[f"p{p}"] for p in (10, 50, 80, 90)], theirs, rtol=1e-12, atol=1e-9)
        return {
            "steps": int(here.sum()), "missing_steps": int((here & ~known).sum()),
            "accessibility": ratio((here & accessible).sum(), here.sum()),
            "workability": ratio((here & starts).sum(), here.sum()),
            "workable_starts": int((here & starts).sum()),
            "windows": int(mine.sum()), "workable_windows": int((mine & has_start).sum()),
            "mean_window_h": ratio(lengths.sum(), len(lengths)) * series.step_h if len(lengths) else None,
            "longest_window_h": float(lengths.max() * series.step_h) if len(lengths) else 0.0,
            "persistence": ratio((here & starts_of(accessible, needed, np.ones_like(starts))).sum(),
                                 (here & accessible).sum()),
            "storms": int(storms.sum()),
            "longest_storm_h": float((storm_end - storm_begin)[storms].max() * series.step_h) if storms.any() else 0.0,
            "censored_steps": int((here & (waits < 0)).sum()), "waiting_time_h": wait}

    months = times.astype("datetime64[M]").astype(int) % 12 + 1
    years = times.astype("datetime64[Y]").astype(int) + 1970
    answer = of(np.ones(series.steps, bool))
    answer["by_month"] = [dict(of(months == m), month=int(m)) for m in np.unique(months)]
    answer["by_year"] = [dict(of(years == y), year=int(y)) for y in np.unique(years)]
    return answer


def expect_equal(ours, theirs, where):
    """Every figure of `theirs` is in `ours`, the same to the last bit."""
    for key, value in theirs.items():
        if key in ("by_month", "by_year"):
            assert len(ours[key]) == len(value), (where, key)
            for a, b in zip(ours[key], value):
                expect_equal(a, b, f"{where} {key} {b.get('month', b.get('year'))}")
        elif isinstance(value, dict):
            expect_equal(ours[key], value, f"{where} {key}")
        else:
            assert ours[key] == value, f"{where}: {key} is {ours[key]!r}, numpy has {value!r}"


def text_of(limits):
    return [word for name, sign, value in limits for word in ("--limit", f"{name}{sign}{value}")]


def ask(path, limits, duration_h, contingency_h=0, hours=None, more=()):
    minutes = [f"{round(60 * h)}min" for h in (duration_h, contingency_h)]
    shift = [] if hours is None else ["--start-hours", f"{hours[0]}-{hours[1]}"]
    return program(str(path), *text_of(limits), "--duration", minutes[0], "--contingency", minutes[1], *shift, "--json",
                   *more)


# Ten pairs of limits and durations: the published ones of twin/docs/operations.md, shorter, longer, strict, hardly ever
# and nearly always.
PAIRS = [
    ([(HEIGHT, "<=", 1.5)], 12, 0, None),
    ([(HEIGHT, "<=", 1.5), (WIND, "<=", 12)], 3, 1, (6, 18)),
    ([(HEIGHT, "<=", 2.0), (WIND, "<=", 16)], 7.5, 0, None),
    ([(HEIGHT, "<", 1.0), (WIND, "<", 10)], 1.5, 0, (6, 18)),
    ([(HEIGHT, "<=", 2.5)], 60, 0, None),
    ([(HEIGHT, "<=", 2.0), (WIND, "<=", 10)], 52, 4, None),
    ([(WIND, "<=", 8)], 0.5, 0, (8, 16)),
    ([(HEIGHT, "<=", 0.5)], 24, 0, None),
    ([(HEIGHT, "<=", 9.0)], 1, 0, None),
    ([(HEIGHT, ">=", 1.0), (HEIGHT, "<=", 1.5), (WIND, ">", 3)], 4, 0, (0, 24)),
]


def with_gaps(series, seed):
    """A series with holes: whole rows, single values, a month, over the new year, and the last hours but one."""
    rng = np.random.default_rng(seed)
    values = {name: column.copy() for name, column in series.values.items()}
    left_out = set()
    for _ in range(20):
        begin = int(rng.integers(1, series.steps - 100))
        left_out.update(range(begin, begin + int(rng.integers(1, 60))))
    times = series.times()
    new_year = int(np.flatnonzero(times.astype("datetime64[Y]") != times[0].astype("datetime64[Y]"))[0]) \
        if times[-1].astype("datetime64[Y]") != times[0].astype("datetime64[Y]") else series.steps // 2
    left_out.update(range(new_year - 3, new_year + 5))
    left_out.update(range(series.steps // 3, series.steps // 3 + min(720, series.steps // 10)))
    left_out.update(range(series.steps - 30, series.steps - 1))
    for column in values.values():
        for i in left_out:
            column[i] = np.nan
        column[rng.integers(1, series.steps - 1, 200)] = np.nan
    return Series(series.start, values, series.step_h), left_out


def worked_example():
    """twin/docs/operations.md, section 3: windows [0, 3) and [4, 8), 7 of 9 accessible, starts at 0, 4 and 5."""
    series = Series("2002-01-01T00:00", {HEIGHT: np.array([1.2, 1.2, 1.2, 1.8, 1.0, 1.0, 1.0, 1.0, 1.9])})
    series.write(WORK / "example.csv")
    found = ask(WORK / "example.csv", [(HEIGHT, "<=", 1.5)], 3)
    assert (found["windows"], found["accessibility"], found["workability"]) == (2, 7 / 9, 3 / 9), found
    assert found["workable_starts"] == 3 and found["longest_window_h"] == 4 and found["mean_window_h"] == 3.5, found


def real_series(name, series, path, more):
    for limits, duration_h, contingency_h, hours in PAIRS:
        ours = ask(path, limits, duration_h, contingency_h, hours, more)
        expect_equal(ours, statistics(series, limits, duration_h, contingency_h, hours), f"{name} {limits}")
    holed, left_out = with_gaps(series, 2025)
    holed.write(WORK / "holes.csv", left_out)
    for limits, duration_h, contingency_h, hours in PAIRS:
        ours = ask(WORK / "holes.csv", limits, duration_h, contingency_h, hours)
        theirs = statistics(holed, limits, duration_h, contingency_h, hours)
        assert theirs["missing_steps"] >= len(left_out)
        expect_equal(ours, theirs, f"{name} with holes {limits}")
    print(f"{name}: {series.steps} steps, ten limit/duration pairs, and again with {len(left_out)} rows taken out: equal")


def other_steps(series):
    """Three-hourly, where durations are rounded up to whole steps."""
    coarse = Series(series.start, {name: column[::3] for name, column in series.values.items()}, 3)
    coarse.write(WORK / "coarse.csv")
    for limits, duration_h, contingency_h, hours in PAIRS:
        expect_equal(ask(WORK / "coarse.csv", limits, duration_h, contingency_h, hours),
                     statistics(coarse, limits, duration_h, contingency_h, hours), f"three-hourly {limits}")
    print("three-hourly: equal")


def netcdf(series):
    """The same as CF NetCDF in single precision, in other units, over two files."""
    import netCDF4
    cut = series.steps // 2
    paths = []
    for part in (slice(0, cut), slice(cut, None)):
        path = WORK / f"part{len(paths)}.nc"
        with netCDF4.Dataset(path, "w") as out:
            times = series.times()[part]
            out.createDimension("time", len(times))
            out.createVariable("time", "f8", ("time",))
            out["time"].units = "minutes since 2000-01-01"
            out["time"][:] = (times - np.datetime64("2000-01-01T00:00", "m")) / np.timedelta64(1, "m")
            for name, unit, factor in ((HEIGHT, "cm", 100), (WIND, "m s-1", 1)):
                out.createVariable(name, "f4", ("time",))
                out[name].setncatts({"units": unit, "standard_name": name})
                out[name][:] = (series.values[name][part] * factor).astype(np.float32)
        paths.append(str(path))
    for limits, duration_h, contingency_h, hours in PAIRS:
        ours = ask(paths[1], limits, duration_h, contingency_h, hours, [paths[0]])
        expect_equal(ours, statistics(series, limits, duration_h, contingency_h, hours), f"NetCDF {limits}")
    print("as NetCDF in centimetres and single precision, in two files: equal")


def function_of(module, name):
    """One function of an installed package, compiled by itself; nothing where the package is not there."""
    top, _, rest = module.partition(".")
    found = importlib.util.find_spec(top)
    if found is None:
        return None
    path = pathlib.Path(found.submodule_search_locations[0]).joinpath(*rest.split(".")).with_suffix(".py")
    tree = ast.parse(path.read_text())
    wanted = [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name in name]
    assert len(wanted) == len(name), f"{module} has no {name}"
    world = {"np": np}
    exec(compile(ast.Module(body=wanted, type_ignores=[]), str(path), "exec"), world)
    return world[name[-1]]


def beside_metocean_stats(series, path, more):
    theirs = function_of("metocean_stats.stats.general", ["weather_window_length"])
    if theirs is None:
        print("metocean-stats is not installed: not compared")
        return

    class Months:
        month = series.times().astype("datetime64[M]").astype(int) % 12 + 1

    class Column(np.ndarray):
        index = Months

    for limit, duration_h in ((1.5, 12), (2.0, 24), (1.0, 3)):
        column = series.values[HEIGHT].view(Column)
        ours = ask(path, [(HEIGHT, "<", limit)], duration_h, more=more)
        for month in (None, 1, 7):
            here = ours if month is None else ours["by_month"][month - 1]
            wait = here["waiting_time_h"]
            found = np.array(theirs(column, limit, duration_h, 1, month)) * 24 - duration_h
            mine = [wait["mean"], wait["p10"], wait["p50"], wait["p90"]]
            assert np.allclose(found, mine, rtol=1e-9, atol=1e-9), (limit, duration_h, month, found, mine)
    print("metocean-stats, weather_window_length: the same mean, P10, P50, P90, overall and by month")


def beside_wombat(series, path, more):
    theirs = function_of("wombat.core.service_equipment", ["consecutive_groups", "calculate_delay_from_forecast"])
    if theirs is None:
        print("WOMBAT is not installed: not compared")
        return
    limits = [(HEIGHT, "<=", 1.5), (WIND, "<=", 12)]
    clear, _ = accessible_of(series, limits)
    durations = [3, 7, 22, 3, 26]
    (WORK / "campaign.yaml").write_text(
        "name: repairs\nbegin: [01-15, 04-01, 10-01]\nteams: [1, 2, 3]\n"
        "limits: ['{}<=1.5', '{}<=12']\ntasks:\n".format(HEIGHT, WIND)
        + "".join(f"  - {{name: t{i}, duration: {d}h}}\n" for i, d in enumerate(durations)))
    ours = program(str(path), "--campaign", str(WORK / "campaign.yaml"), "--json", *more)
    times = series.times()
    chains = 0
    for season in ours["seasons"]:
        elapsed = []
        for year in season["by_year"]:
            begin = int(np.flatnonzero(times == np.datetime64(year["begin"][:16], "m"))[0])
            # A vessel each; the next repair goes to the one that is free first, as in WOMBAT's queue.
            free = [begin] * season["teams"]
            for duration_h in durations:
                i = free.index(min(free))
                found, delay = theirs(clear[free[i]:], duration_h)
                assert found or year["end"] is None
                free[i] += int(delay) + duration_h
                if not found:
                    break
            else:
                assert year["elapsed_h"] == max(free) - begin, (year, max(free) - begin)
                elapsed.append(max(free) - begin)
                chains += 1
        elapsed.sort()
        for p in (10, 50, 80, 90):
            assert season["elapsed_h"][f"p{p}"] == percentile(elapsed, p), season
    print(f"WOMBAT, calculate_delay_from_forecast: the same end of {chains} chains of five repairs, by fleets of one to three")


def main():
    alpha = alpha_ventus()
    alpha_columns = ["--time-column", "datetime", "--assume-utc", "--column", f"windspeed={WIND}:m s-1",
                     "--column", f"waveheight={HEIGHT}:m"]
    worked_example()
    real_series("alpha ventus", alpha, ALPHA, alpha_columns)
    real_series("NORA3", nora3(), NORA3, ["--assume-utc", "--column", f"wind_speed_10m={WIND}:m s-1", "--column",
                                          f"hs={HEIGHT}:m"])
    other_steps(alpha)
    netcdf(alpha)
    beside_metocean_stats(alpha, ALPHA, alpha_columns)
    beside_wombat(alpha, ALPHA, alpha_columns)


if __name__ == "__main__":
    main()
