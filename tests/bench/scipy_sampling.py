"""The samples of field_bench with scipy.interpolate.RegularGridInterpolator, for comparison.

scipy_sampling.py FOLDER REPEATS: reads axes t, z, y, x, components u and v over them, and points (t, z, y, x), all
as raw doubles NAME.bin; writes found.bin (u then v at the points) and prints {"batch_s", "profile_s"}: processor time of
all points at once, and of one call with the first 50 of them as a user asks a profile, u and v each, medians.
"""
import json
import os
import sys
import time

import numpy as np
from scipy.interpolate import RegularGridInterpolator


def main():
    folder, repeats = sys.argv[1], int(sys.argv[2])

    def read(name):
        return np.fromfile(os.path.join(folder, name + ".bin"))

    axes = tuple(read(name) for name in "tzyx")
    shape = tuple(len(axis) for axis in axes)
    parts = [RegularGridInterpolator(axes, read(name).reshape(shape)) for name in "uv"]
    points = read("points").reshape(-1, 4)

    def timed(some, times):
        seconds = []
        for _ in range(times):
            begin = time.process_time()
            found = [part(some) for part in parts]
            seconds.append(time.process_time() - begin)
        return found, float(np.median(seconds))

    profile_s = timed(points[:50], 20 * repeats)[1]
    found, batch_s = timed(points, repeats)
    np.concatenate(found).tofile(os.path.join(folder, "found.bin"))
    print(json.dumps({"batch_s": batch_s, "profile_s": profile_s}))


if __name__ == "__main__":
    main()
