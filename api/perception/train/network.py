"""The detector's network: anchor-free, two strides, about a quarter of a million parameters.

    picture -> stem (1/2) -> stage (1/4) -> stage (1/8) ---------------+-> head of stride 8
                                              |                        ^
                                              +-> stage (1/16) --up----+
                                                     +------------------> head of stride 16

A block is a residual of 1 x 1, depthwise 3 x 3, 1 x 1 (Sandler et al. 2018, arXiv:1801.04381). A head says for each of its
cells the logits of the kinds and four distances, in logarithms of the stride, from its point to the sides of the box (Tian et al.
2019, arXiv:1904.01355). Only operations that OpenCV 4.6 computes as torch does: convolutions, SiLU, addition, nearest upsampling.
"""

import torch
from torch import nn

STRIDES = (8, 16)


def conv(inner, outer, side=3, stride=1, groups=1):
    return nn.Sequential(
        nn.Conv2d(inner, outer, side, stride, side // 2, groups=groups, bias=False), nn.BatchNorm2d(outer), nn.SiLU()
    )


class Block(nn.Module):
    def __init__(self, width, expand=2):
        super().__init__()
        wide = width * expand
        self.way = nn.Sequential(
            conv(width, wide, 1), conv(wide, wide, 3, groups=wide), nn.Conv2d(wide, width, 1, bias=False), nn.BatchNorm2d(width)
        )

    def forward(self, x):
        return x + self.way(x)


def stage(inner, outer, blocks):
    return nn.Sequential(conv(inner, outer, 3, 2), *(Block(outer) for _ in range(blocks)))


class Head(nn.Module):
    def __init__(self, width, kinds):
        super().__init__()
        self.way = nn.Sequential(conv(width, width, 3, groups=width), conv(width, width, 1))
        self.out = nn.Conv2d(width, kinds + 4, 1)
        nn.init.zeros_(self.out.weight)
        nn.init.constant_(self.out.bias, 0.5)
        # A share of one in a hundred at the beginning: Lin et al. (2017), arXiv:1708.02002, 4.1.
        nn.init.constant_(self.out.bias[:kinds], -4.6)

    def forward(self, x):
        return self.out(self.way(x))


class Network(nn.Module):
    def __init__(self, kinds):
        super().__init__()
        self.stem = conv(3, 16, 3, 2)
        self.quarter = stage(16, 24, 1)
        self.eighth = stage(24, 48, 2)
        self.sixteenth = stage(48, 96, 3)
        self.down = conv(96, 48, 1)
        self.join = Block(48)
        self.heads = nn.ModuleList([Head(48, kinds), Head(96, kinds)])

    def forward(self, picture):
        eighth = self.eighth(self.quarter(self.stem(picture)))
        sixteenth = self.sixteenth(eighth)
        up = nn.functional.interpolate(self.down(sixteenth), scale_factor=2.0, mode="nearest")
        return self.heads[0](self.join(eighth + up)), self.heads[1](sixteenth)


def parameters(network):
    return sum(p.numel() for p in network.parameters())


if __name__ == "__main__":
    net = Network(2)
    print(parameters(net), [tuple(head.shape) for head in net(torch.zeros(1, 3, 64, 96))])
