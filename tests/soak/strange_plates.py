"""Plates of steel under water with rust and cracks, lit by mitsuba (volpath, scattered up to eight times), labelled as COCO has
them. Nothing of it is the twin's: noise by its spectrum, rust where noise is high within an ellipse, cracks that wander.

    strange_plates.py FOLDER PLATES
"""

import json
import math
import pathlib
import sys

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")
sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "strangers"))
from labelled_plates import write_png  # noqa: E402

WIDE, HIGH, HALF_FIELD_RAD = 640, 360, math.radians(32)
TEXELS_A_M = 800
PASSES, SAMPLES = 7, 8  # the median of the passes: few paths near a lamp carry far too much light
KINDS = {1: "corrosion", 2: "crack"}


def noise(rng, shape, slope):
    """Noise with a spectrum of 1/f^slope, 0 to 1."""
    f = np.hypot(np.fft.fftfreq(shape[0])[:, None], np.fft.rfftfreq(shape[1])[None])
    f[0, 0] = 1
    waves = rng.standard_normal(f.shape) + 1j * rng.standard_normal(f.shape)
    waves[0, 0] = 0
    made = np.fft.irfft2(waves / f**slope, shape)
    return np.clip(0.5 + 0.2 * made / made.std(), 0, 1)


def mixed(share, dark, light):
    return np.array(dark) + share[..., None] * (np.array(light) - np.array(dark))


def rusted(rng, where_m, size_m, texture):
    ragged = noise(rng, texture.shape[:2], 1.6)
    along = rng.uniform(0, math.pi)
    x, y = where_m
    a = (x * math.cos(along) + y * math.sin(along)) / (size_m / 2)
    b = (y * math.cos(along) - x * math.sin(along)) / (rng.uniform(0.25, 0.45) * size_m)
    is_rust = a * a + b * b + 1.2 * (ragged - 0.5) < 0.8
    rust = mixed(noise(rng, texture.shape[:2], 1.0), (0.14, 0.05, 0.02), (0.40, 0.18, 0.07))
    texture[is_rust] = rust[is_rust]
    return is_rust


def cracked(rng, where_m, size_m, texture):
    """A way of short legs that turn a little, 1/40 as wide as long in the middle and pointed at its ends."""
    x, y = where_m
    is_crack = np.zeros(x.shape, bool)
    course, legs = rng.uniform(0, 2 * math.pi), 24
    at = -0.5 * size_m * np.array([math.cos(course), math.sin(course)])
    for leg in range(legs):
        course += rng.normal(0, 0.15)
        way = size_m / legs * np.array([math.cos(course), math.sin(course)])
        width = size_m / 40 * math.sin(math.pi * (leg + 0.8) / (legs + 0.6))
        along = np.clip(((x - at[0]) * way[0] + (y - at[1]) * way[1]) / (way @ way), 0, 1)
        is_crack |= np.hypot(x - at[0] - along * way[0], y - at[1] - along * way[1]) < max(0.0008, width / 2)
        at = at + way
    texture[is_crack] = 0.012
    return is_crack


def plate_of(rng, wide_m, high_m):
    """Its colours, and a mask for each of its defects with the number of its kind."""
    shape = round(high_m * TEXELS_A_M), round(wide_m * TEXELS_A_M)
    y, x = np.meshgrid((np.arange(shape[0]) + 0.5) / TEXELS_A_M, (np.arange(shape[1]) + 0.5) / TEXELS_A_M, indexing="ij")
    texture = mixed(noise(rng, shape, 1.3), (0.06, 0.065, 0.06), (0.17, 0.17, 0.15))
    grown = np.clip(8 * (noise(rng, shape, 1.8) - 0.62), 0, 1)[..., None]
    texture = texture + grown * (mixed(noise(rng, shape, 0.9), (0.05, 0.07, 0.03), (0.25, 0.23, 0.14)) - texture)
    marks, taken = [], []
    for _ in range(rng.integers(0, 4)):
        kind = int(rng.integers(1, 3))
        size_m = float(rng.uniform(0.10, 0.35) if kind == 1 else rng.uniform(0.15, 0.45))
        middle = rng.uniform(0.25, 0.75, 2) * (wide_m, high_m)
        if any(math.hypot(*(middle - other)) < 0.5 * (size_m + theirs) for other, theirs in taken):
            continue
        taken.append((middle, size_m))
        mark = (rusted if kind == 1 else cracked)(rng, (x - middle[0], y - middle[1]), size_m, texture)
        marks.append((kind, mark))
    return texture, marks


def lit(texture, wide_m, high_m, away_m, rng):
    """The light of a plate square before the camera, a lamp above the lens."""
    visibility_m = rng.uniform(3, 10)
    day = rng.uniform(0, 0.5) * np.array([0.3, 1, 0.9])
    c = 4.8 / visibility_m * np.array([1.6, 1.0, 1.1])
    up = mi.ScalarTransform4f()
    lamp = up.look_at(origin=[0, 0.2, 0], target=[0, 0, away_m], up=[0, 0, 1]).scale(0.05)
    scene = {
        "type": "scene",
        "integrator": {"type": "volpath", "max_depth": 8, "hide_emitters": True},
        "water": {
            "type": "homogeneous",
            "albedo": {"type": "rgb", "value": [0.45, 0.65, 0.55]},
            "sigma_t": {"type": "rgb", "value": (c / c.max()).tolist()},  # at most 1
            "scale": float(c.max()),
            "phase": {"type": "hg", "g": 0.85},
        },
        "bounds": {
            "type": "cube",
            "to_world": up.scale(50),
            "bsdf": {"type": "null"},
            "interior": {"type": "ref", "id": "water"},
        },
        "sensor": {
            "type": "perspective",
            "fov": math.degrees(2 * HALF_FIELD_RAD),
            "fov_axis": "x",
            "near_clip": 1e-3,
            "to_world": up.look_at(origin=[0, 0, 0], target=[0, 0, 1], up=[0, 1, 0]),
            "film": {"type": "hdrfilm", "width": WIDE, "height": HIGH, "rfilter": {"type": "box"}, "pixel_format": "rgb"},
            "sampler": {"type": "independent", "sample_count": SAMPLES},
            "medium": {"type": "ref", "id": "water"},
        },
        # Its left is the picture's left: a rectangle looks along +z, and is seen from before it.
        "plate": {
            "type": "rectangle",
            "to_world": up.translate([0, 0, away_m]).rotate([0, 1, 0], 180).scale([wide_m / 2, high_m / 2, 1]),
            "bsdf": {
                "type": "diffuse",
                "reflectance": {"type": "bitmap", "bitmap": mi.Bitmap(texture[::-1].astype(np.float32)), "raw": True},
            },
        },
        "lamp": {
            "type": "disk",
            "to_world": lamp,
            "emitter": {"type": "area", "radiance": {"type": "rgb", "value": 320.0}},
        },
        "day": {"type": "constant", "radiance": {"type": "rgb", "value": day.tolist()}},
    }
    world, seed = mi.load_dict(scene), int(rng.integers(1 << 30))
    return np.median([np.array(mi.render(world, seed=seed + i)) for i in range(PASSES)], axis=0)


def developed(light, rng):
    electrons = np.minimum(light * 0.18 / light.mean(), 1) * 10000
    value = np.clip(rng.normal(electrons, np.sqrt(electrons + 25)) / 10000, 0, 1)
    written = np.where(value <= 0.0031308, 12.92 * value, 1.055 * value ** (1 / 2.4) - 0.055)
    return np.rint(255 * written).astype(np.uint8)


def box_of(mark, wide_m, high_m, away_m):
    """Of a mask on the plate, in pixels of the picture; none where the picture cuts it off."""
    rows, columns = np.nonzero(mark)
    focal = WIDE / 2 / math.tan(HALF_FIELD_RAD)
    u = WIDE / 2 + focal * ((columns + 0.5) / TEXELS_A_M - wide_m / 2) / away_m
    v = HIGH / 2 + focal * ((rows + 0.5) / TEXELS_A_M - high_m / 2) / away_m
    left, top, right, bottom = u.min(), v.min(), u.max() + 1, v.max() + 1
    if left < 0 or top < 0 or right > WIDE or bottom > HIGH:
        return None
    return [float(left), float(top), float(right - left), float(bottom - top)]


def main(folder, plates):
    rng = np.random.default_rng(11)
    labels = {"categories": [{"id": i, "name": name} for i, name in KINDS.items()], "images": [], "annotations": []}
    for nth in range(plates):
        away_m = float(rng.uniform(0.5, 1.4))
        wide_m, high_m = 2.4 * away_m * math.tan(HALF_FIELD_RAD), 2.4 * away_m * math.tan(HALF_FIELD_RAD) * HIGH / WIDE
        texture, marks = plate_of(rng, wide_m, high_m)
        write_png(folder / f"{nth}.png", developed(lit(texture, wide_m, high_m, away_m, rng), rng))
        labels["images"].append({"id": nth, "file_name": f"{nth}.png", "width": WIDE, "height": HIGH})
        for kind, mark in marks:
            box = box_of(mark, wide_m, high_m, away_m)
            if box:
                one = {"id": len(labels["annotations"]) + 1, "image_id": nth, "category_id": kind, "bbox": box}
                labels["annotations"].append(one | {"area": box[2] * box[3], "iscrowd": 0})
        print(f"\r{nth + 1} of {plates} plates", end="", flush=True)
    (folder / "labels.json").write_text(json.dumps(labels))
    print()


main(pathlib.Path(sys.argv[1]), int(sys.argv[2]))
