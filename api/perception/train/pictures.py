"""Labelled pictures (COCO) as crops to learn from, and the changes that a camera makes to them."""

import json
import pathlib

import numpy as np
import torch
from PIL import Image

# The input is (rgb / 255 - MEAN) / SD: about what pictures under water have, and no more than a scale.
MEAN, SD = (0.35, 0.40, 0.40), (0.20, 0.20, 0.20)


def sides_of(box):
    return box[..., 2] - box[..., 0], box[..., 3] - box[..., 1]


class Pictures:
    """All pictures of the folders, in memory. kinds: names in the order of the network's logits. A label of -1: a crowd."""

    def __init__(self, folders, kinds):
        self.pixels, self.boxes, self.labels = [], [], []
        for folder in map(pathlib.Path, folders):
            files = [*folder.glob("*.json"), *folder.glob("annotations/*.json")]
            assert len(files) == 1, f"{folder}: found {len(files)} JSON files, expected one"
            read = json.loads(files[0].read_text())
            nth = {c["id"]: kinds.index(c["name"]) for c in read["categories"] if c["name"] in kinds}
            of = {image["id"]: [] for image in read["images"]}
            for one in read["annotations"]:
                if one["category_id"] in nth:
                    left, top, wide, high = one["bbox"]
                    label = -1 if one.get("iscrowd", 0) else nth[one["category_id"]]
                    of[one["image_id"]].append([left, top, left + wide, top + high, label])
            for image in read["images"]:
                file = folder / image["file_name"]
                file = file if file.exists() else folder / "images" / image["file_name"]
                self.pixels.append(np.asarray(Image.open(file).convert("RGB")))
                rows = np.array(of[image["id"]], np.float32).reshape(-1, 5)
                self.boxes.append(rows[:, :4])
                self.labels.append(rows[:, 4].astype(np.int64))
        # Drawn once and begun anywhere: drawing it for each crop takes longer than the rest of the crop.
        self.noise = np.random.default_rng(0).standard_normal(4_000_000, np.float32)
        self.areas = np.cumsum([pixels.shape[0] * pixels.shape[1] for pixels in self.pixels])

    def __len__(self):
        return len(self.pixels)

    def place(self, rng, side):
        """A square of one picture: its number, left, top and scale. A large picture is taken as often as its area is larger. One
        time in three at half the scale; of a picture with labels, two times in three about one."""
        nth = int(np.searchsorted(self.areas, rng.random() * self.areas[-1], side="right"))
        boxes, labels = self.boxes[nth], self.labels[nth]
        scale = 2 if rng.random() < 1 / 3 else 1
        taken = side * scale
        high, wide = (max(taken, pixels) for pixels in self.pixels[nth].shape[:2])
        left, top = int(rng.integers(0, wide - taken + 1)), int(rng.integers(0, high - taken + 1))
        told = np.flatnonzero(labels >= 0)
        if len(told) and rng.random() < 2 / 3:
            about = boxes[told[int(rng.integers(len(told)))]]
            middle = (about[:2] + about[2:]) / 2 + rng.uniform(-0.4, 0.4, 2) * taken
            left = int(np.clip(middle[0] - taken / 2, 0, wide - taken))
            top = int(np.clip(middle[1] - taken / 2, 0, high - taken))
        return nth, left, top, scale

    def crop(self, place, rng, side):
        """What a square of a picture shows, at random mirrored and seen otherwise: pixels, boxes, labels."""
        nth, left, top, scale = place
        pixels, boxes, labels = self.pixels[nth], self.boxes[nth].copy(), self.labels[nth]
        taken = side * scale
        high, wide = pixels.shape[:2]
        if high < taken or wide < taken:
            room = np.zeros((max(high, taken), max(wide, taken), 3), np.uint8)
            room[:high, :wide] = pixels
            pixels = room
        cut = pixels[top : top + taken, left : left + taken].astype(np.float32) / 255
        before = sides_of(boxes)
        boxes = np.clip(boxes - [left, top, left, top], 0, taken)
        after = sides_of(boxes)
        # What is left of a box has to be a good part of it, or nobody could tell what it is.
        kept = (after[0] * after[1] > 0.35 * before[0] * before[1]) & (after[0] > 2 * scale) & (after[1] > scale)
        boxes, labels = boxes[kept] / scale, labels[kept]
        if scale > 1:
            cut = sum(cut[i::scale, j::scale] for i in range(scale) for j in range(scale)) / np.float32(scale**2)
        for axis in (0, 1):
            if rng.random() < 0.5:
                cut = np.flip(cut, 1 - axis)
                boxes[:, [axis, axis + 2]] = side - boxes[:, [axis + 2, axis]]
        return self.seen_otherwise(cut, rng), boxes.astype(np.float32), labels

    def seen_otherwise(self, cut, rng):
        """Another exposure, another white balance, other noise."""
        gain = np.exp(rng.normal(0, 0.15)) * np.exp(rng.normal(0, 0.05, 3))
        cut = np.maximum(cut, np.float32(1e-3)) ** np.float32(np.exp(rng.normal(0, 0.15)))
        cut *= gain.astype(np.float32)
        begin = int(rng.integers(len(self.noise) - cut.size))
        cut += np.float32(abs(rng.normal(0, 0.01))) * self.noise[begin : begin + cut.size].reshape(cut.shape)
        return np.minimum(np.maximum(cut, 0, out=cut), 1, out=cut)


def as_input(pixels):
    """H x W x 3, shares, to the network's input."""
    scaled = (np.ascontiguousarray(pixels, np.float32) - np.float32(MEAN)) / np.float32(SD)
    return torch.from_numpy(scaled).permute(2, 0, 1)


class Alarming:
    """The places of pictures where most was said of nothing, to be looked at again: welds, say, and edges of anodes."""

    MOST = 256

    def __init__(self):
        self.places = []  # (how much was said, place), most first

    def take(self, rng, many):
        """At random, and no longer kept: they come back if they still alarm."""
        at = sorted(rng.choice(len(self.places), min(many, len(self.places)), replace=False), reverse=True)
        return [self.places.pop(nth)[1] for nth in at]

    def add(self, alarms, places):
        self.places = sorted([*self.places, *zip(alarms, places)], reverse=True)[: self.MOST]


def batch(pictures, places, rng, side):
    crops = [pictures.crop(place, rng, side) for place in places]
    return torch.stack([as_input(c[0]) for c in crops]), [torch.from_numpy(c[1]) for c in crops], [
        torch.from_numpy(c[2]) for c in crops
    ]
