"""`slackwater detect --score`, held against the evaluation of COCO (pycocotools).

detect.py PROGRAM WORK

Plates of grey with patches of several browns, some of which are labelled as corrosion, some not, some labels elsewhere, some
crowds, some pictures without a label: so that finds are right, wrong, doubled and of any confidence. Both programs have the same
labels and the same finds (`--out`), and must say the same average precision, to 1e-9.
"""

import contextlib
import io
import json
import pathlib
import struct
import subprocess
import sys
import zlib

import numpy as np
from pycocotools.coco import COCO
from pycocotools.cocoeval import COCOeval

PROGRAM, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
RNG = np.random.default_rng(20261128)
WIDE, HIGH, PICTURES = 160, 120, 120


def write_png(file, pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    head = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 2, 0, 0, 0)
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def plate():
    """A plate, and the boxes of its patches."""
    pixels = np.full((HIGH, WIDE, 3), 150, np.uint8)
    boxes = []
    for _ in range(RNG.integers(0, 5)):
        wide, high = RNG.integers(8, 40, 2)
        left, top = RNG.integers(0, WIDE - wide), RNG.integers(0, HIGH - high)
        brown = np.array([150, 80, 30]) + RNG.integers(-20, 20, 3)
        pixels[top : top + high, left : left + wide] = brown
        boxes.append([int(left), int(top), int(wide), int(high)])
    return pixels, boxes


labels = {"categories": [{"id": 3, "name": "corrosion"}], "images": [], "annotations": []}
for nth in range(PICTURES):
    pixels, boxes = plate()
    name = f"{nth}.png"
    write_png(WORK / name, pixels)
    labels["images"].append({"id": nth, "file_name": name, "width": WIDE, "height": HIGH})
    for left, top, wide, high in boxes:
        if RNG.random() < 0.25:
            continue
        shift = int(RNG.integers(0, max(2, wide // 2))) if RNG.random() < 0.5 else 0
        wide = min(wide, WIDE - left - shift)
        labels["annotations"].append(
            {
                "id": len(labels["annotations"]) + 1,
                "image_id": nth,
                "category_id": 3,
                "bbox": [left + shift, top, wide, high],
                "area": wide * high,
                "iscrowd": int(RNG.random() < 0.1),
            }
        )
(WORK / "labels.json").write_text(json.dumps(labels))

results = WORK / "results" / "finds.json"
results.parent.mkdir()
done = subprocess.run(
    [PROGRAM, "detect", "--score", str(WORK), "--by", "corrosion_by_colour", "--out", str(results), "--json"],
    capture_output=True,
    text=True,
)
assert done.returncode == 0, done.stderr
ours = json.loads(done.stdout)["kinds"][0]

with contextlib.redirect_stdout(io.StringIO()):
    truth = COCO(str(WORK / "labels.json"))
    evaluation = COCOeval(truth, truth.loadRes(str(results)), "bbox")
    evaluation.evaluate()
    evaluation.accumulate()
# precision[threshold, recall, category, area, most finds]: overlap 0.5, all areas, 100.
precision = evaluation.eval["precision"][0, :, 0, 0, 2]
theirs = float(precision.mean())
recall = float(evaluation.eval["recall"][0, 0, 0, 2])

assert 0.1 < theirs < 0.95, f"nothing to tell apart: {theirs}"
assert abs(ours["ap50"]["value"] - theirs) < 1e-9, (ours["ap50"], theirs)
assert abs(ours["recall"] - recall) < 1e-9, (ours["recall"], recall)
low, high = ours["ap50"]["interval_95"]
assert low < theirs < high, (low, theirs, high)
print(f"AP50 {theirs:.4f} of {ours['labels']} labels and {ours['found']} finds, both alike")
