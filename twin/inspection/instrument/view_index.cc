#include "twin/inspection/instrument/view_index.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace slackwater::twin {
namespace {

constexpr std::uint32_t most_of_block = 32;

struct Extent {
  Triple<double> low_m;
  Triple<double> high_m;
};

class Halving {
 public:
  Halving(const std::vector<Patch>& patches, ViewIndex& index) : all_(patches), index_(index) {}

  void halve(std::uint32_t first, std::uint32_t end) {
    const Extent extent = extent_of(first, end);
    if (end - first <= most_of_block) {
      index_.blocks.push_back(block_of(first, end, extent));
      return;
    }
    const Triple<double> size = extent.high_m - extent.low_m;
    double Triple<double>::*axis = &Triple<double>::x;
    if (size.y > size.*axis) axis = &Triple<double>::y;
    if (size.z > size.*axis) axis = &Triple<double>::z;
    const std::uint32_t middle = first + (end - first) / 2;
    // By number where two are level: the same order on every library.
    std::sort(begin() + first, begin() + end, [&](std::uint32_t a, std::uint32_t b) {
      const double at_a = all_[a].centre_m.*axis, at_b = all_[b].centre_m.*axis;
      return at_a < at_b || (at_a == at_b && a < b);
    });
    halve(first, middle);
    halve(middle, end);
  }

 private:
  [[nodiscard]] std::vector<std::uint32_t>::iterator begin() const {
    return index_.patches.begin();
  }
  [[nodiscard]] const Triple<double>& centre(std::uint32_t place) const {
    return all_[index_.patches[place]].centre_m;
  }
  [[nodiscard]] Extent extent_of(std::uint32_t first, std::uint32_t end) const {
    Extent extent{centre(first), centre(first)};
    for (std::uint32_t i = first; i < end; ++i) {
      const Triple<double>& c = centre(i);
      extent.low_m = {std::min(extent.low_m.x, c.x), std::min(extent.low_m.y, c.y),
                      std::min(extent.low_m.z, c.z)};
      extent.high_m = {std::max(extent.high_m.x, c.x), std::max(extent.high_m.y, c.y),
                       std::max(extent.high_m.z, c.z)};
    }
    return extent;
  }
  [[nodiscard]] ViewIndex::Block block_of(std::uint32_t first, std::uint32_t end,
                                          const Extent& extent) const {
    ViewIndex::Block block{0.5 * (extent.low_m + extent.high_m), 0, first, end};
    for (std::uint32_t i = first; i < end; ++i)
      block.radius_m = std::max(block.radius_m, length_of(centre(i) - block.centre_m));
    block.radius_m *= 1 + 1e-12;  // what rounding took
    return block;
  }

  const std::vector<Patch>& all_;
  ViewIndex& index_;
};

}  // namespace

ViewIndex view_index(const Surface& surface) {
  ViewIndex index;
  index.patches.resize(surface.patches.size());
  std::iota(index.patches.begin(), index.patches.end(), 0U);
  if (!index.patches.empty())
    Halving(surface.patches, index).halve(0, static_cast<std::uint32_t>(index.patches.size()));
  return index;
}

}  // namespace slackwater::twin
