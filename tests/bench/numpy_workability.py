"""The question of workability_bench in vectorised numpy, for comparison.

numpy_workability.py FOLDER REPEATS: reads height.bin and wind.bin (raw doubles, an hour each, NaN missing), month.bin and
year.bin (raw int64 of each hour) and pairs.json, a list of [height limit, wind limit, steps]; prints {"seconds", "answers"}:
processor time of all pairs, the median, and of each pair its figures overall, by month and by year: [steps, accessible,
starts, windows, workable windows, longest window, censored, waits, sum of waits, p10, p50, p80, p90].

Whole arrays throughout, no loop over hours; waits are whole numbers, so they are counted (bincount) and not sorted.
"""
import json
import os
import sys
import time

import numpy as np


def percentiles(counts, total):
    below = np.cumsum(counts)
    found = []
    for percent in (10, 50, 80, 90):
        place, hundredths = divmod((total - 1) * percent, 100)
        low = int(np.searchsorted(below, place, side="right"))
        high = int(np.searchsorted(below, place + 1, side="right")) if hundredths else low
        found.append(low + (high - low) * hundredths / 100.0)
    return found


def answer(height, wind, height_limit, wind_limit, needed, groups):
    ok = (height <= height_limit) & (wind <= wind_limit)
    steps = len(ok)
    edges = np.diff(ok.view(np.int8), prepend=0, append=0)
    begin = np.flatnonzero(edges == 1)
    length = np.flatnonzero(edges == -1) - begin
    sums = np.concatenate(([0], np.cumsum(ok, dtype=np.int32)))
    starts = np.zeros(steps, bool)
    starts[: steps - needed + 1] = sums[needed:] - sums[:-needed] == needed
    hours = np.arange(steps, dtype=np.int32)
    following = np.minimum.accumulate(np.where(starts, hours, steps)[::-1])[::-1]
    waits = following - hours
    waits = np.where(following < steps, waits, -1)
    longest = int(waits.max()) + 1
    answers = []
    for group, count in groups:
        known = waits >= 0
        table = np.bincount(group[known] * longest + waits[known], minlength=count * longest).reshape(count, longest)
        of_windows = group[begin]
        columns = [np.bincount(group, minlength=count), np.bincount(group[ok], minlength=count),
                   np.bincount(group[starts], minlength=count), np.bincount(of_windows, minlength=count),
                   np.bincount(of_windows[length >= needed], minlength=count), np.zeros(count, int),
                   np.bincount(group[~known], minlength=count), table.sum(axis=1), table @ np.arange(longest)]
        np.maximum.at(columns[5], of_windows, length)
        for g in range(count):
            row = [int(column[g]) for column in columns]
            answers.append(row + (percentiles(table[g], row[7]) if row[7] else [-1, -1, -1, -1]))
    return answers


def main():
    folder, repeats = sys.argv[1], int(sys.argv[2])

    def read(name, kind=float):
        return np.fromfile(os.path.join(folder, name + ".bin"), dtype=kind)

    height, wind = read("height"), read("wind")
    month, year = read("month", np.int64), read("year", np.int64)
    groups = [(np.zeros(len(height), np.int64), 1), (month - 1, 12), (year - year[0], int(year[-1] - year[0]) + 1)]
    with open(os.path.join(folder, "pairs.json")) as file:
        pairs = json.load(file)
    seconds = []
    for _ in range(repeats):
        begin = time.process_time()
        answers = [answer(height, wind, *pair, groups) for pair in pairs]
        seconds.append(time.process_time() - begin)
    print(json.dumps({"seconds": float(np.median(seconds)), "answers": answers}))


if __name__ == "__main__":
    main()
