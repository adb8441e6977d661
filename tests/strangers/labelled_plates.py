"""Pictures of plates with patches of rust, labelled as COCO has it: truth is known, since it was painted."""

import json
import struct
import zlib

import numpy as np

WIDE, HIGH, CATEGORY = 160, 120, 3


def write_png(file, pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    head = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 2, 0, 0, 0)
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def plate(rng):
    """A plate, and the boxes of its patches."""
    pixels = np.full((HIGH, WIDE, 3), 150, np.uint8)
    boxes = []
    for _ in range(rng.integers(0, 5)):
        wide, high = rng.integers(8, 40, 2)
        left, top = rng.integers(0, WIDE - wide), rng.integers(0, HIGH - high)
        brown = np.array([150, 80, 30]) + rng.integers(-20, 20, 3)
        pixels[top : top + high, left : left + wide] = brown
        boxes.append([int(left), int(top), int(wide), int(high)])
    return pixels, boxes


def muddled(boxes, rng):
    """Labels as a bad labeller makes them: some forgotten, some beside, some of a heap."""
    labels = []
    for left, top, wide, high in boxes:
        if rng.random() < 0.25:
            continue
        shift = int(rng.integers(0, max(2, wide // 2))) if rng.random() < 0.5 else 0
        wide = min(wide, WIDE - left - shift)
        labels.append(([left + shift, top, wide, high], int(rng.random() < 0.1)))
    return labels


def write_labelled_plates(folder, many, rng, is_muddled):
    labels = {"categories": [{"id": CATEGORY, "name": "corrosion"}], "images": [], "annotations": []}
    for nth in range(many):
        pixels, boxes = plate(rng)
        write_png(folder / f"{nth}.png", pixels)
        labels["images"].append({"id": nth, "file_name": f"{nth}.png", "width": WIDE, "height": HIGH})
        for box, is_crowd in muddled(boxes, rng) if is_muddled else [(box, 0) for box in boxes]:
            labels["annotations"].append(
                {
                    "id": len(labels["annotations"]) + 1,
                    "image_id": nth,
                    "category_id": CATEGORY,
                    "bbox": box,
                    "area": box[2] * box[3],
                    "iscrowd": is_crowd,
                }
            )
    (folder / "labels.json").write_text(json.dumps(labels))
