"""The detector's network: anchor-free, three strides, about a quarter of a million parameters.

    picture -> evened, 1/2 -> stage (1/4) -> stage (1/8) -> stage (1/16) -> stage (1/32)
                                                |               |               |        1 x 1
                                                +<-----up-------+<-----up-------+        sums of 36
                                              head            head            head

A block is a residual of two 3 x 3 (He et al. 2016, arXiv:1512.03385), the sums a feature pyramid (Lin et al. 2017,
arXiv:1612.03144). A head says for each of its cells the logits of the kinds and four distances, in logarithms of the stride, from
its point to the sides of the box (Tian et al. 2019, arXiv:1904.01355). Only operations that OpenCV 4.6 computes as torch does:
convolutions, ReLU, arithmetic, square roots, nearest upsampling. What learns are full convolutions: without a graphics card the
way back through those of groups takes longer than it does through them, for a tenth of the products.

Beside its colours the network sees them evened: less their mean about each place, over their standard deviation there. In murky
water a crack may be darker than what is about it by a hundredth of the light, and by more than the noise all the same.
"""

import torch
from torch import nn

STRIDES = (8, 16, 32)
WIDTH = 36  # of the pyramid


def conv(inner, outer, side=3, stride=1):
    return nn.Sequential(nn.Conv2d(inner, outer, side, stride, side // 2, bias=False), nn.BatchNorm2d(outer), nn.ReLU())


class Evened(nn.Module):
    """To a picture's colours those less their mean in a square about each pixel, over their standard deviation in it."""

    SIDE, LEAST = 17, 0.003  # pixels; a variance about that of the noise in good light

    def __init__(self):
        super().__init__()
        row = torch.full((3, 1, 1, self.SIDE), 1 / self.SIDE)
        self.register_buffer("row", row)
        self.register_buffer("column", row.transpose(2, 3).contiguous())

    def mean(self, x):
        reach = self.SIDE // 2
        if not torch.onnx.is_in_onnx_export():  # the same by running sums, which take half as long
            across = nn.functional.pad(x, (reach + 1, reach)).cumsum(3)
            across = across[..., self.SIDE :] - across[..., : -self.SIDE]
            down = nn.functional.pad(across, (0, 0, reach + 1, reach)).cumsum(2)
            return (down[..., self.SIDE :, :] - down[..., : -self.SIDE, :]) / self.SIDE**2
        along = nn.functional.conv2d(x, self.row, padding=(0, reach), groups=3)
        return nn.functional.conv2d(along, self.column, padding=(reach, 0), groups=3)

    def forward(self, picture):
        off = picture - self.mean(picture)
        return torch.cat([picture, off / torch.sqrt(self.mean(off * off) + self.LEAST)], 1)


class Block(nn.Module):
    def __init__(self, width):
        super().__init__()
        self.way = nn.Sequential(conv(width, width), nn.Conv2d(width, width, 3, 1, 1, bias=False), nn.BatchNorm2d(width))

    def forward(self, x):
        return nn.functional.relu(x + self.way(x))


def stage(inner, outer, blocks):
    return nn.Sequential(conv(inner, outer, 3, 2), *(Block(outer) for _ in range(blocks)))


class Head(nn.Module):
    def __init__(self, kinds):
        super().__init__()
        self.way = conv(WIDTH, WIDTH)
        self.out = nn.Conv2d(WIDTH, kinds + 4, 1)
        nn.init.normal_(self.out.weight, 0, 0.01)
        nn.init.constant_(self.out.bias, 0.5)
        # A share of one in a hundred at the beginning: Lin et al. (2017), arXiv:1708.02002, 4.1.
        nn.init.constant_(self.out.bias[:kinds], -4.6)

    def forward(self, x):
        return self.out(self.way(x))


def up(x):
    return nn.functional.interpolate(x, scale_factor=2.0, mode="nearest")


class Network(nn.Module):
    def __init__(self, kinds):
        super().__init__()
        self.evened = Evened()
        self.quarter = nn.Sequential(conv(6, 16, 3, 2), stage(16, 24, 1))
        self.eighth = stage(24, 40, 2)
        self.sixteenth = stage(40, 48, 1)
        self.last = stage(48, 48, 1)
        self.aside = nn.ModuleList([nn.Conv2d(width, WIDTH, 1) for width in (40, 48, 48)])
        self.heads = nn.ModuleList([Head(kinds) for _ in STRIDES])

    def forward(self, picture):
        return self.heads_of(self.evened(picture))

    def heads_of(self, evened):
        eighth = self.eighth(self.quarter(evened))
        sixteenth = self.sixteenth(eighth)
        coarse = self.aside[2](self.last(sixteenth))
        middle = self.aside[1](sixteenth) + up(coarse)
        fine = self.aside[0](eighth) + up(middle)
        return self.heads[0](fine), self.heads[1](middle), self.heads[2](coarse)


def parameters(network):
    return sum(p.numel() for p in network.parameters())


if __name__ == "__main__":
    net = Network(2)
    print(parameters(net), [tuple(head.shape) for head in net(torch.zeros(1, 3, 64, 96))])
