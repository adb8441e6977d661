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
import subprocess
import sys

import numpy as np
from pycocotools.coco import COCO
from pycocotools.cocoeval import COCOeval

from labelled_plates import write_labelled_plates

PROGRAM, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
RNG = np.random.default_rng(20261128)
PICTURES = 120


write_labelled_plates(WORK, PICTURES, RNG, is_muddled=True)

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
