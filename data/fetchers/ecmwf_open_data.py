"""Wind at 10 m of ECMWF's open data for `slackwater fetch`, by ECMWF's own package, which has no command line.

usage: python3 ecmwf_open_data.py --to TIME --target FILE [--sources ecmwf,aws,google,azure]

The newest run that reaches TIME (UTC, 2025-03-13T00:00:00), every 3 h as far as 144 h and every 6 h beyond, into one GRIB file; of the first
source that has it. Needs `pip install ecmwf-opendata`. https://github.com/ecmwf/ecmwf-opendata; steps: ECMWF, open data real-time forecasts.
"""

import argparse
import math
import sys
from datetime import datetime

FIELDS = ["10u", "10v"]


def steps_to(hours):
    """Steps of a run that reach so many hours."""
    near = list(range(0, 3 * math.ceil(min(hours, 144) / 3) + 1, 3))
    return near + list(range(150, 6 * math.ceil(hours / 6) + 1, 6)) if hours > 144 else near


def fetch(client, until, target):
    run = client.latest(type="fc", step=0, param=FIELDS[0])
    wanted = steps_to((until - run).total_seconds() / 3600)
    # Runs of 06 and 18 UTC end earlier, and the last steps of a run come an hour after its first.
    run = client.latest(type="fc", step=wanted[-1], param=FIELDS[0])
    steps = steps_to((until - run).total_seconds() / 3600)
    client.retrieve(date=run.strftime("%Y-%m-%d"), time=run.hour, type="fc", step=steps, param=FIELDS, target=target)
    return run


def main():
    parser = argparse.ArgumentParser(description="wind of ECMWF's open data")
    parser.add_argument("--to", required=True, type=datetime.fromisoformat)
    parser.add_argument("--target", required=True)
    parser.add_argument("--sources", default="ecmwf,aws,google,azure")
    arguments = parser.parse_args()
    try:
        from ecmwf.opendata import Client
    except ImportError:
        print("the package ecmwf-opendata is not installed", file=sys.stderr)
        return 1
    for source in arguments.sources.split(","):
        try:
            run = fetch(Client(source=source), arguments.to, arguments.target)
            print(f"run of {run:%Y-%m-%dT%H:%MZ} from {source}")
            return 0
        except Exception as problem:  # whatever one source has: the next one is another
            print(f"{source}: {type(problem).__name__}: {problem}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
