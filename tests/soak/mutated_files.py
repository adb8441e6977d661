"""Files of strangers with bytes flipped, set, put in, cut out and moved, each given to the command
that reads its kind, with a time limit: what became of the commands, and of the stores behind them.

    mutated_files.py PROGRAM STORE WORK MUTANTS [SEED [FORMAT]]

Prints a row a format: how many seeds are good as they are, then of mutants how many ended with
which exit code, crashed a reader that was contained, and so on. SLACKWATER_KEEP names a folder for
files that showed something. Exits 1 where a command was killed by a signal, hung, said that the
fault is ours (exit 1), printed control characters, or left its store damaged.
"""

import collections
import concurrent.futures
import os
import pathlib
import random
import shutil
import subprocess
import sys

CORPUS = pathlib.Path(__file__).parents[1] / "fuzz" / "corpus"
LIMIT_S = 90  # a reader of a small file has a minute, and its store seconds
FAULT_OF_OURS = 1

SCENARIO = """
name: Two minutes
seed: 7
duration: 2min
step_s: 0.1
water:
  {water}
waves: {{from: calm}}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {{north_m: 0, east_m: 0, depth_m: 1, heading_deg: 0}}
    tasks: [{{do: hold}}]
"""
MADE_UP = (
    "made_up: {depth_m: 30, current: [{depth_m: 0, east_m_s: 0.2, north_m_s: 0}], "
    "wind: {speed_m_s: 5, from_deg: 270}}"
)


def flip(rng, data):
    for _ in range(rng.choice([1, 2, 8, 32])):
        data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)


def put(rng, data):
    """A number that readers stumble over, or an escape for the terminal."""
    value = rng.choice([b"\xff" * 4, b"\x7f" + b"\xff" * 7, bytes(8), b"\x1b[2J", b"\xc3\x28\x9b"])
    at = rng.randrange(len(data))
    data[at : at + len(value)] = value


def insert(rng, data):
    at = rng.randrange(len(data) + 1)
    data[at:at] = rng.randbytes(rng.choice([1, 4, 64, 1024]))


def delete(rng, data):
    at = rng.randrange(len(data))
    del data[at : at + rng.choice([1, 4, 64, 1024, len(data)])]


def move(rng, data):
    at = rng.randrange(len(data))
    taken = data[at : at + rng.choice([1, 8, 64, 512])]
    del data[at : at + len(taken)]
    to = rng.randrange(len(data) + 1)
    data[to:to] = taken


MUTATIONS = [flip, put, insert, delete, move]


def mutant_of(rng, seed):
    data = bytearray(seed)
    for _ in range(rng.choice([1, 1, 2, 4])):
        if data:
            rng.choice(MUTATIONS)(rng, data)
    return bytes(data)


def has_control_characters(printed):
    try:
        text = printed.decode("utf-8")
    except UnicodeDecodeError:
        return True
    return any((ord(c) < 32 and c not in "\n\t") or 127 <= ord(c) < 160 for c in text)


class Format:
    """One kind of file: its seeds, and the command that reads it."""

    def __init__(self, name, suffix, seeds, command):
        self.name, self.suffix, self.seeds, self.command = name, suffix, seeds, command


def corpus(folder, pattern):
    return [path.read_bytes() for path in sorted((CORPUS / folder).glob(pattern))]


def formats_of(program, store, work):
    """Beside the corpus there are files that the program wrote: they get further."""

    def run(*arguments):
        subprocess.run([program, "--store", store, *map(str, arguments)], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    scenario, log, bag = work / "seed.yaml", work / "seed.nc", work / "seed.mcap"
    checkpoint = work / "seed.checkpoint"
    scenario.write_text(SCENARIO.format(water=MADE_UP))
    run("simulate", scenario, "--out", log)
    run("simulate", scenario, "--checkpoint", checkpoint, "--checkpoint-at", "1min", "--out",
        work / "begun.nc")
    run("replay", log, "--record", bag)
    issued = [
        path.read_bytes()
        for path in sorted((store / "files").rglob("*.nc"))
        if b"slackwater_headline" in path.read_bytes()
    ][:2]

    def ingest(file):
        return ["ingest", file]

    def run_in(file):
        there = file.with_suffix(".yaml")
        there.write_text(SCENARIO.format(water=f"forecast: {{file: {file.name}}}"))
        return ["simulate", there, "--out", file.with_suffix(".log.nc")]

    def play(file):
        return ["live", scenario, "--real-time-factor", "0", "--play-traffic", file]

    def go_on(file):
        return ["simulate", scenario, "--restore", file, "--out", file.with_suffix(".nc")]

    return [
        Format("NetCDF, classic", ".nc", corpus("netcdf", "*.c[ld]*.nc"), ingest),
        Format("NetCDF-4", ".nc", corpus("netcdf", "*.nc4.nc"), ingest),
        Format("GRIB", ".grib", corpus("grib", "*.grib"), ingest),
        Format("forecast", ".nc", corpus("forecast_file", "*.nc") + 10 * issued, run_in),
        Format("log of a run", ".nc", [log.read_bytes()], lambda file: ["replay", file]),
        Format("checkpoint", ".checkpoint", [checkpoint.read_bytes()], go_on),
        Format("MCAP", ".mcap", corpus("mcap", "*.mcap") + 5 * [bag.read_bytes()], play),
        Format("AIS", ".txt", corpus("ais", "seed_*"),
               lambda file: ["ais", file, "--site", "synthetic", "--at", "2025-03-09T12:00:00Z"]),
    ]


def outcome_of(command):
    try:
        done = subprocess.run(command, capture_output=True, timeout=LIMIT_S,
                              stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return "hung", b""
    printed = done.stdout + done.stderr
    if done.returncode < 0:
        return f"signal {-done.returncode}", printed
    return done.returncode, printed


def tally_of(program, store, work, one, mutants, seed):
    """All mutants of one format in turn, on a store of its own."""
    rng = random.Random(f"{seed} {one.name}")
    own_store = work / f"store of {one.name}"
    shutil.copytree(store, own_store)
    folder = work / f"files of {one.name}"
    folder.mkdir()
    tally = collections.Counter()
    examples = {}

    def outcome(i, data):
        file = folder / f"{i}{one.suffix}"
        file.write_bytes(data)
        command = [program, "--store", own_store, *map(str, one.command(file))]
        return file, *outcome_of(command)

    for i, seed_bytes in enumerate(sorted(set(one.seeds))):
        _, code, _ = outcome(f"seed{i}", seed_bytes)
        tally["seeds"] += 1
        tally["good"] += code == 0
    for i in range(mutants):
        file, code, printed = outcome(i, mutant_of(rng, rng.choice(one.seeds)))
        tally[code] += 1
        tally["contained"] += b" crashed the " in printed
        tally["control"] += has_control_characters(printed)
        is_bad = not isinstance(code, int) or code == FAULT_OF_OURS
        if is_bad or has_control_characters(printed):
            examples.setdefault((code, has_control_characters(printed)), (file, printed[-300:]))
        else:
            for made in folder.glob(f"{i}.*"):
                made.unlink()
    code, printed = outcome_of([program, "--store", own_store, "store", "check"])
    tally["damaged"] = int(code != 0)
    if code != 0:
        examples["store"] = (own_store, printed[-300:])
    return tally, examples


def keep(file):
    folder = os.environ.get("SLACKWATER_KEEP")
    if folder and file.is_file():
        shutil.copy(file, pathlib.Path(folder) / f"{file.parent.name} {file.name}")


def main(program, store, work, mutants, seed=2026, only=""):
    store, work, mutants = pathlib.Path(store), pathlib.Path(work), int(mutants)
    codes = [0, 2, 3, 4, 5, FAULT_OF_OURS]
    columns = ["seeds", "good", "mutants", *(f"exit {code}" for code in codes), "contained",
               "killed", "hung", "control", "damaged"]
    print(" " * 18 + "".join(f"{column:>10}" for column in columns))
    formats = [one for one in formats_of(program, store, work) if only in one.name]
    has_failed = False
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        tallies = pool.map(
            lambda one: tally_of(program, store, work, one, mutants, seed), formats)
        for one, (tally, examples) in zip(formats, tallies):
            killed = sum(n for code, n in tally.items() if str(code).startswith("signal"))
            bad = [killed, tally["hung"], tally["control"], tally["damaged"]]
            row = [tally["seeds"], tally["good"], mutants, *(tally[code] for code in codes),
                   tally["contained"], *bad]
            print(f"{one.name:18}" + "".join(f"{n:>10}" for n in row), flush=True)
            for what, (file, printed) in examples.items():
                print(f"    {what}: {file.name}: {printed!r}")
                keep(file)
            has_failed |= any(bad) or tally[FAULT_OF_OURS] > 0
    return 1 if has_failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
