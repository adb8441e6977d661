"""What is wrong with the network's answer: which cell answers for which box, and the two losses."""

import torch
from torch.nn import functional

from network import STRIDES

# Boxes whose longer side is between these are answered by the strides of 8, 16 and 32; some by two of them.
LONG_PX = {8: (0, 80), 16: (48, 192), 32: (128, float("inf"))}


def points_of(head, stride):
    high, wide = head.shape[-2:]
    y, x = torch.meshgrid(torch.arange(high), torch.arange(wide), indexing="ij")
    return torch.stack([x, y], -1).reshape(-1, 2) * stride + stride / 2


def answers(boxes, labels, points, stride):
    """For each point the number of the box it answers for, -1 for none: the smallest box in whose middle it lies."""
    if len(boxes) == 0:
        return torch.full((len(points),), -1)
    longest = (boxes[:, 2:] - boxes[:, :2]).amax(1)
    is_ours = (longest > LONG_PX[stride][0]) & (longest <= LONG_PX[stride][1])
    middle = (boxes[:, :2] + boxes[:, 2:]) / 2
    away = (points[:, None] - middle[None]).abs()
    # A cell and a half about the middle, and in the box; of a box thinner than a cell, the cells that it crosses.
    reach = torch.minimum(torch.tensor(1.5 * stride), torch.maximum((boxes[:, 2:] - boxes[:, :2]) / 2, torch.tensor(stride / 2)))
    is_in = (away < reach[None]).all(-1) & is_ours[None]
    area = (boxes[:, 2:] - boxes[:, :2]).prod(1)
    cost = torch.where(is_in, area[None].expand_as(is_in), torch.tensor(float("inf")))
    least, nth = cost.min(1)
    return torch.where(least.isinf(), torch.tensor(-1), nth)


def focal(logits, wanted):
    """Lin et al. (2017), with alpha 0.25 and gamma 2, of each logit."""
    share = logits.sigmoid()
    cross = functional.binary_cross_entropy_with_logits(logits, wanted, reduction="none")
    missed = share * (1 - wanted) + (1 - share) * wanted
    weight = 0.25 * wanted + 0.75 * (1 - wanted)
    return weight * missed.pow(2) * cross


def overlap_loss(sides, wanted):
    """1 - GIoU (Rezatofighi et al. 2019, arXiv:1902.09630) of boxes about one point, given by their four sides."""
    area = lambda s: (s[:, 0] + s[:, 2]) * (s[:, 1] + s[:, 3])  # noqa: E731
    least, most = torch.minimum(sides, wanted).clamp(min=0), torch.maximum(sides, wanted)
    shared, hull = area(least), area(most)
    joined = area(sides) + area(wanted) - shared
    return (1 - shared / joined + (hull - joined) / hull).sum()


def loss(heads, boxes, labels, kinds):
    """The loss of a batch, and of each of its pictures what is said of places where nothing is.

    labels: the number of a kind; -1: there may be something, and no answer is wrong there.
    """
    of_kinds, of_boxes, many = 0.0, 0.0, 0
    alarms = [0.0] * len(boxes)
    for head, stride in zip(heads, STRIDES):
        points = points_of(head, stride)
        for nth in range(len(boxes)):
            flat = head[nth].flatten(1).t()
            nearest = answers(boxes[nth], labels[nth], points, stride)
            wanted, counts = torch.zeros(len(points), kinds), torch.ones(len(points), 1)
            hit = nearest >= 0
            if hit.any():
                is_told = labels[nth][nearest.clamp(min=0)] >= 0
                counts[hit & ~is_told] = 0
                hit &= is_told
            if hit.any():
                of = boxes[nth][nearest[hit]]
                wanted[hit, labels[nth][nearest[hit]]] = 1
                at = points[hit]
                # A point beside a thin box answers for it, too: its nearer side is then a hair away.
                to = torch.cat([at - of[:, :2], of[:, 2:] - at], 1).clamp(min=0.25)
                of_boxes = of_boxes + overlap_loss(flat[hit, kinds:].clamp(max=8).exp() * stride, to)
                many += int(hit.sum())
            said = counts * focal(flat[:, :kinds], wanted)
            of_kinds = of_kinds + said.sum()
            alarms[nth] += float(said.detach()[~hit].sum())
    return (of_kinds + 1.5 * of_boxes) / max(1, many), alarms
