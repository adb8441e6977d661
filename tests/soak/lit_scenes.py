"""Small scenes as the renderer lights them beside mitsuba's paths of light: volpath in a homogeneous medium that scatters to all
sides alike, each path scattered once. The same light is asked for: L = A/pi E of a Lambert face, E of a lamp of intensity
R^2 pi/rho cos, of daylight E0 = pi D/rho on a level face; then L is in the light of a usual place, as theirs."""

import json
import math
import sys

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")

LAMP_RADIUS_M = 0.004
BLOCK = 4  # pixels, averaged: noise is not what is asked of
SAMPLES = 4096
WITHIN = 0.04  # of the light of a block that no edge runs through; noise is 0.5 % of the darkest
MOST_MEAN = 0.004  # of the whole picture


def transform():
    return mi.ScalarTransform4f()


def mesh_of(thing, albedo):
    corners, triangles = np.array(thing["corners"]), np.array(thing["triangles"])
    mesh = mi.Mesh("thing", len(corners), len(triangles), props=properties_of(albedo))
    params = mi.traverse(mesh)
    params["vertex_positions"] = corners.ravel()
    params["faces"] = triangles.ravel()
    params.update()
    return mesh


def properties_of(albedo):
    props = mi.Properties()
    props["bsdf"] = mi.load_dict({"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": albedo}}})
    return props


def lamp_of(lamp, albedo):
    """A small disc: its intensity falls off with the cosine, as a Lambert face's does."""
    at, axis = np.array(lamp["at"]), np.array(lamp["axis"])
    radiance = lamp["range"] ** 2 * math.pi / albedo / (math.pi * LAMP_RADIUS_M**2)
    return {
        "type": "disk",
        "to_world": transform().look_at(origin=at, target=at + axis, up=[0, 0, -1]).scale(LAMP_RADIUS_M),
        "emitter": {"type": "area", "radiance": {"type": "rgb", "value": radiance}},
    }


def daylight_of(scene, albedo):
    level = math.pi * scene["daylight"] / albedo
    to_sun = np.array(scene["to_sun"])
    # The upper half of all directions; rows from the pole that the map's up points at.
    sky = np.zeros((64, 128, 3), dtype=np.float32)
    sky[:32] = (1 - scene["beam"]) * level / math.pi
    return {
        "sky": {
            "type": "envmap",
            "bitmap": mi.Bitmap(sky),
            "to_world": transform().rotate(axis=[1, 0, 0], angle=-90),  # its up is +y: here -z
        },
        "sun": {
            "type": "directional",
            "direction": -to_sun,
            "irradiance": {"type": "rgb", "value": float(scene["beam"] * level / -to_sun[2])},
        },
    }


def light_of(scene, wide, high, horizontal_deg, albedo):
    world = {
        "type": "scene",
        "integrator": {"type": "volpath", "max_depth": 2, "rr_depth": 100, "hide_emitters": True},
        "sensor": {
            "type": "perspective",
            "fov": horizontal_deg,
            "fov_axis": "x",
            "near_clip": 1e-4,  # nothing fades before it
            "to_world": transform().look_at(origin=[0, 0, 0], target=[1, 0, 0], up=[0, 0, -1]),
            "film": {"type": "hdrfilm", "width": wide, "height": high, "rfilter": {"type": "box"}, "pixel_format": "rgb"},
            "sampler": {"type": "independent", "sample_count": SAMPLES},
        },
    }
    if scene["attenuation"] > 0:
        # To all sides alike: half of what is scattered goes back.
        scattered = 2 * scene["backscatter"] / scene["attenuation"]
        medium = {
            "type": "homogeneous",
            "albedo": {"type": "rgb", "value": scattered},
            "sigma_t": {"type": "rgb", "value": scene["attenuation"]},
            "phase": {"type": "isotropic"},
        }
        world["water"] = medium
        world["sensor"]["medium"] = {"type": "ref", "id": "water"}
        world["bounds"] = {
            "type": "cube",
            "to_world": transform().scale(200),
            "bsdf": {"type": "null"},
            "interior": {"type": "ref", "id": "water"},
        }
    for i, thing in enumerate(scene["things"]):
        world[f"thing{i}"] = mesh_of(thing, albedo)
    for i, lamp in enumerate(scene["lamps"]):
        world[f"lamp{i}"] = lamp_of(lamp, albedo)
    if not scene["lamps"]:
        world.update(daylight_of(scene, albedo))
    picture = mi.render(mi.load_dict(world), seed=1)
    return np.array(picture)[:, :, 1]


def blocks(picture):
    high, wide = picture.shape
    return picture.reshape(high // BLOCK, BLOCK, wide // BLOCK, BLOCK)


def evenly_lit(picture):
    """Blocks without the edge of a shadow or a thing in them or beside them: such an edge may cut a pixel whose middle it misses."""
    mean = blocks(picture).mean(axis=(1, 3))
    around = np.pad(mean, 1, mode="edge")
    even = mean > 1e-3 * picture.max()
    for down in range(3):
        for right in range(3):
            beside = around[down : down + mean.shape[0], right : right + mean.shape[1]]
            even &= np.abs(beside - mean) < 0.5 * mean
    return even


def main(path):
    with open(path, encoding="utf-8") as file:
        asked = json.load(file)
    wide, high = asked["wide"], asked["high"]
    print(f"mitsuba {mi.__version__}, {SAMPLES} samples a pixel; ours / theirs by blocks of {BLOCK} x {BLOCK}")
    failed = []
    for scene in asked["scenes"]:
        ours = np.array(scene["light"]).reshape(high, wide)
        theirs = light_of(scene, wide, high, asked["horizontal_deg"], asked["albedo"])
        is_even = evenly_lit(ours) & evenly_lit(theirs)
        ratio = blocks(ours).mean(axis=(1, 3))[is_even] / blocks(theirs).mean(axis=(1, 3))[is_even]
        off, total = np.abs(ratio - 1).max(), ours.sum() / theirs.sum() - 1
        print(
            f"{scene['name']:<38} {is_even.sum():4d} blocks  median {np.median(ratio):.4f}  worst {100 * off:.2f} %  "
            f"all {100 * total:+.2f} %"
        )
        if is_even.sum() < 40 or off > WITHIN or abs(total) > MOST_MEAN:
            failed.append(scene["name"])
    assert not failed, f"lit otherwise: {', '.join(failed)}"


main(sys.argv[1])
