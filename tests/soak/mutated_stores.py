"""Stores with one file damaged, a forecast's or the catalogue: does a command that reads them live,
and does `store check` find it?

    mutated_stores.py PROGRAM STORE WORK MUTANTS [SEED]

Prints a row for each. A changed file of a forecast must be found. In the catalogue a change may be
where nothing is stored: then all its rows are `as they were`, and there is nothing to find. Of rows
that are not, and are missed, the first that differs is shown.
SLACKWATER_KEEP names a folder for files that showed something. Exits 1 where a command was killed,
hung, said that the fault is ours, printed control characters, or missed what must be found.
"""

import collections
import json
import pathlib
import random
import shutil
import sqlite3
import subprocess
import sys

from mutated_files import FAULT_OF_OURS, has_control_characters, keep, mutant_of, outcome_of

CATALOGUE = "catalogue.sqlite"


def damaged_copy(store, copy, name, data):
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(store, copy, copy_function=lambda a, b: pathlib.Path(b).hardlink_to(a))
    for beside in copy.glob(CATALOGUE + "*"):  # its log and shared memory are written to
        beside.unlink()
    shutil.copy(store / CATALOGUE, copy / CATALOGUE)
    (copy / name).unlink()
    (copy / name).write_bytes(data)


def rows_of(catalogue):
    """All that it holds, as statements of SQL."""
    with sqlite3.connect(f"file:{catalogue}?mode=ro&immutable=1", uri=True) as opened:
        return list(opened.iterdump())


def change_of(was, catalogue):
    """The first row that differs; empty: none does."""
    try:
        rows = rows_of(catalogue)
    except sqlite3.Error as error:
        return str(error)
    unlike = [f"{a[:200]!r} -> {b[:200]!r}" for a, b in zip(was, rows) if a != b]
    return unlike[0] if unlike else "" if len(rows) == len(was) else "another number of rows"


def tally_of(run, store, work, names, mutants, seed):
    rng = random.Random(f"{seed} {names[0]}")
    was_rows = rows_of(store / CATALOGUE)
    tally = collections.Counter()
    examples = {}
    for i in range(mutants):
        name = rng.choice(names)
        was = (store / name).read_bytes()
        data = mutant_of(rng, was)
        if data == was:
            continue
        tally["mutants"] += 1
        copy = work / "damaged" / "store"
        damaged_copy(store, copy, name, data)
        change = change_of(was_rows, copy / name) if name == CATALOGUE else name
        for what in ("profile", "check"):
            code, printed = run(copy, what)
            has_controls = has_control_characters(printed)
            tally[what, code] += 1
            tally["control"] += has_controls
            if (what, code) == ("check", 0):
                tally["missed" if change else "as it was"] += 1
                if change:
                    print(f"    missed: {change}")
            if has_controls or not isinstance(code, int) or code == FAULT_OF_OURS:
                kept = work / "damaged" / f"{i} {pathlib.Path(name).name}"
                shutil.copy(copy / name, kept)
                examples.setdefault((what, code, has_controls), (kept, printed[-300:]))
    return tally, examples


def main(program, store, work, mutants, seed=2026):
    store, work = pathlib.Path(store), pathlib.Path(work)
    listed = json.loads(
        subprocess.run([program, "--store", store, "store", "list", "--json"], check=True,
                       capture_output=True).stdout
    )
    newest = listed["forecasts"][-1]

    def run(copy, what):
        profile = ["profile", "--site", newest["site"], "--time", newest["valid_from"]]
        arguments = profile if what == "profile" else ["store", "check"]
        return outcome_of([program, "--store", copy, *arguments])

    sums = [each["content_sha256"] for each in listed["forecasts"]]
    (work / "damaged").mkdir()
    codes = [0, 3, 4, 5, FAULT_OF_OURS]
    columns = ["mutants", *(f"profile {code}" for code in codes), "found", "as it was", "missed", "killed",
               "hung", "control"]
    print(" " * 18 + "".join(f"{column:>10}" for column in columns))
    has_failed = False
    for title, names in [("issued forecast", [f"files/{s[:2]}/{s}.nc" for s in sums]),
                         ("catalogue", [CATALOGUE])]:
        tally, examples = tally_of(run, store, work, names, int(mutants), seed)
        missed, unchanged = tally["missed"], tally["as it was"]
        faults = tally["profile", FAULT_OF_OURS] + tally["check", FAULT_OF_OURS]
        killed = sum(n for key, n in tally.items() if str(key[1]).startswith("signal"))
        hung = tally["profile", "hung"] + tally["check", "hung"]
        row = [tally["mutants"], *(tally["profile", code] for code in codes),
               tally["mutants"] - missed - unchanged, unchanged, missed, killed, hung,
               tally["control"]]
        print(f"{title:18}" + "".join(f"{n:>10}" for n in row), flush=True)
        for what, (file, printed) in examples.items():
            print(f"    {what}: {file.name}: {printed!r}")
            keep(file)
        has_failed |= faults + killed + hung + tally["control"] > 0
        has_failed |= title != "catalogue" and missed > 0
    return 1 if has_failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
