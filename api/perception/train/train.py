#!/usr/bin/python3
"""Trains a detector on labelled pictures, and writes it as `slackwater detect --by FILE` reads it.

    train.py OUT.yaml --on FOLDER [FOLDER ...] [--kinds corrosion crack] [--seed 1] [--seconds 3000 | --steps 4000]

FOLDER holds pictures and their labels as COCO has them. Beside OUT.yaml come OUT.onnx (raw heads, opset 11) and a model card of
the same name. Wants Debian's python3-torch and python3-pil; no GPU. The same seed, steps, threads and pictures give the same
weights on the same processor; with --seconds the steps depend on it, and the card says how many.
"""

import argparse
import concurrent.futures
import copy
import hashlib
import math
import pathlib
import time

import numpy as np
import torch

from loss import loss
from network import STRIDES, Network, parameters
from pictures import MEAN, SD, Alarming, Pictures, as_input, batch

SIDE, BATCH, AGAIN, BEST_RATE = 352, 8, 2, 2e-3  # AGAIN: of a batch, those that alarmed most before
PROOF_SEED, PROOF_SIDE, PROOF_NUMBERS = 7, 64, 16


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("out", type=pathlib.Path, help="the detector's file, OUT.yaml")
    parser.add_argument("--on", nargs="+", required=True, help="folders of labelled pictures")
    parser.add_argument("--kinds", nargs="+", default=["corrosion", "crack"])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--steps", type=int)
    parser.add_argument("--threads", type=int, default=1, help="of the network; one more makes the crops beside it")
    arguments = parser.parse_args()
    if (arguments.seconds is None) == (arguments.steps is None):
        parser.error("expected either --seconds or --steps")
    if arguments.out.suffix != ".yaml":
        parser.error(f"found {arguments.out}, expected a name that ends in .yaml")
    return arguments


class Batches:
    """Batches to learn from, the next one made while the network learns from the last."""

    def __init__(self, pictures, evened, seed):
        self.pictures, self.evened, self.rng = pictures, evened, np.random.default_rng(seed)
        self.alarming = Alarming()
        self.maker = concurrent.futures.ThreadPoolExecutor(1, initializer=lambda: torch.set_num_threads(1))
        self.coming = self.maker.submit(self.make)

    @torch.no_grad()
    def make(self):
        places = self.alarming.take(self.rng, AGAIN)
        places += [self.pictures.place(self.rng, SIDE) for _ in range(BATCH - len(places))]
        inputs, boxes, labels = batch(self.pictures, places, self.rng, SIDE)
        return places, self.evened(inputs).contiguous(memory_format=torch.channels_last), boxes, labels

    def next(self, alarmed):
        """alarmed: what add() of Alarming is told of the last batch."""
        made = self.coming.result()
        self.alarming.add(*alarmed)
        self.coming = self.maker.submit(self.make)
        return made


def has_bfloat16():
    """Whether the processor multiplies matrices of bfloat16 (AMX): a step takes a third of its time, for the same network."""
    flags = pathlib.Path("/proc/cpuinfo")
    return flags.exists() and "amx_bf16" in flags.read_text().split()


def trained(pictures, arguments):
    """The network, a running mean of its weights over the steps, and how many steps it had."""
    kinds = len(arguments.kinds)
    # Channels last: the convolutions take half as long as with each channel's plane apart.
    network = Network(kinds).to(memory_format=torch.channels_last)
    mean = copy.deepcopy(network)
    half = has_bfloat16()
    batches, alarmed = Batches(pictures, network.evened, arguments.seed), ([], [])
    optimiser = torch.optim.AdamW(network.parameters(), lr=BEST_RATE, weight_decay=1e-2)
    begin, step, told = time.monotonic(), 0, 0.0
    while True:
        spent = time.monotonic() - begin
        share = step / arguments.steps if arguments.steps else spent / arguments.seconds
        if share >= 1:
            return mean.eval(), step
        # Up over the first hundredth, down along a cosine.
        rate = BEST_RATE * min(1.0, 100 * share + 1e-3) * (0.5 + 0.5 * math.cos(math.pi * share))
        for group in optimiser.param_groups:
            group["lr"] = rate
        places, evened, boxes, labels = batches.next(alarmed)
        with torch.autocast("cpu", dtype=torch.bfloat16, enabled=half):
            heads = network.heads_of(evened)
        wrong, alarms = loss([head.float() for head in heads], boxes, labels, kinds)
        alarmed = (alarms, places)
        optimiser.zero_grad()
        wrong.backward()
        torch.nn.utils.clip_grad_norm_(network.parameters(), 5.0)
        optimiser.step()
        step += 1
        keep = min(0.998, step / (step + 10))
        with torch.no_grad():
            for ours, theirs in zip(mean.state_dict().values(), network.state_dict().values()):
                if ours.dtype.is_floating_point:
                    ours.mul_(keep).add_(theirs, alpha=1 - keep)
                else:
                    ours.copy_(theirs)
        if share - told >= 0.02:
            told = share
            print(f"\r{100 * share:3.0f} %  step {step}  loss {float(wrong):.3f}", end="", flush=True)


def proof_picture():
    """The picture of api/perception/network.h: byte k is (2654435761 (k + 1) + 40503 seed mod 2^32) / 2^24."""
    k = np.arange(PROOF_SIDE * PROOF_SIDE * 3, dtype=np.uint64)
    numbers = ((2654435761 * (k + 1) + 40503 * PROOF_SEED) % 2**32) >> 24
    return numbers.reshape(PROOF_SIDE, PROOF_SIDE, 3).astype(np.float64) / 255


def proof_of(network):
    rows = []
    with torch.no_grad():
        heads = network(as_input(proof_picture())[None])
    for head, stride in zip(heads, STRIDES):
        flat = head.flatten().numpy()
        at = np.linspace(0, flat.size - 1, PROOF_NUMBERS).astype(int)
        numbers = ", ".join(f"{float(flat[i]):.6f}" for i in at)
        rows.append(f"    - {{output: stride_{stride}, at: [{', '.join(map(str, at))}],\n       is: [{numbers}]}}")
    return "\n".join(rows)


def write(network, steps, pictures, arguments):
    onnx = arguments.out.with_suffix(".onnx")
    torch.onnx.export(
        network,
        torch.zeros(1, 3, SIDE, SIDE),
        str(onnx),
        opset_version=11,
        input_names=["picture"],
        output_names=[f"stride_{stride}" for stride in STRIDES],
        dynamic_axes={"picture": {2: "high", 3: "wide"}},
    )
    digest = hashlib.sha256(onnx.read_bytes()).hexdigest()
    grids = "\n".join(f"  - {{output: stride_{stride}, stride_px: {stride}}}" for stride in STRIDES)
    arguments.out.write_text(
        f"""# Written by api/perception/train/train.py; see {arguments.out.with_suffix('.md').name} beside it.
name: {arguments.out.stem}
source: trained by api/perception/train on {len(pictures)} labelled pictures, from nothing
by: network
file: {onnx.name}
sha256: {digest}
kinds: [{', '.join(arguments.kinds)}]
input: {{mean: [{', '.join(map(str, MEAN))}], sd: [{', '.join(map(str, SD))}], multiple_of: {STRIDES[-1]}}}
grids:
{grids}
test:
  seed: {PROOF_SEED}
  wide: {PROOF_SIDE}
  high: {PROOF_SIDE}
  heads:
{proof_of(network)}
"""
    )
    labelled = [sum(int((labels == nth).sum()) for labels in pictures.labels) for nth in range(len(arguments.kinds))]
    empty = sum(len(labels) == 0 for labels in pictures.labels)
    arguments.out.with_suffix(".md").write_text(
        f"""# {arguments.out.stem}

A detector of {' and '.join(arguments.kinds)} in pictures, {parameters(network):,} parameters, {onnx.stat().st_size:,} bytes.

| | |
|---|---|
| made by | `api/perception/train/train.py`, seed {arguments.seed}, {steps:,} steps of {BATCH} crops of {SIDE} pixels, {AGAIN} of them where it had said most of nothing |
| learned from | {len(pictures):,} labelled pictures, {empty:,} without a label; {', '.join(f'{many:,} of {kind}' for kind, many in zip(arguments.kinds, labelled))} |
| says nothing | of pictures of another kind until `slackwater detect --score FOLDER` was run on them |
| licence | that of the pictures it learned from; no weights of others |
"""
    )


def main():
    arguments = read_arguments()
    torch.manual_seed(arguments.seed)
    torch.set_num_threads(arguments.threads)
    torch.use_deterministic_algorithms(True)
    pictures = Pictures(arguments.on, arguments.kinds)
    network, steps = trained(pictures, arguments)
    write(network, steps, pictures, arguments)
    print(f"\r{arguments.out}: {steps} steps, {parameters(network)} parameters")


if __name__ == "__main__":
    main()
