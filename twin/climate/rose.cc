#include "twin/climate/rose.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/check.h"
#include "fields/base/turn.h"

namespace slackwater::twin {

std::size_t class_of(double value, std::span<const double> edges) noexcept {
  return static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), value) -
                                  edges.begin());
}

std::size_t sector_of(double direction_deg, std::size_t sectors) noexcept {
  const auto count = static_cast<double>(sectors);
  // Half a sector is added before the turn is divided: 345 degrees are exactly an edge of twelve.
  const double from_edge = compass_deg(direction_deg + 180 / count);
  return std::min(static_cast<std::size_t>(from_edge * count / 360), sectors - 1);
}

std::size_t Rose::in_sector(std::size_t sector) const {
  return std::accumulate(sectors[sector].begin(), sectors[sector].end(), std::size_t{0});
}

std::size_t Rose::in_class(std::size_t size_class) const {
  std::size_t sum = 0;
  for (const std::vector<std::size_t>& sector : sectors) sum += sector[size_class];
  return sum;
}

std::size_t Rose::known() const {
  std::size_t sum = calm + no_direction;
  for (std::size_t s = 0; s < sectors.size(); ++s) sum += in_sector(s);
  return sum;
}

Rose rose_of(std::span<const double> sizes, std::span<const double> directions_deg,
             const RoseClasses& classes) {
  expects(sizes.size() == directions_deg.size(), "each size has its direction");
  expects(classes.sectors > 0 && std::is_sorted(classes.edges.begin(), classes.edges.end()),
          "a rose has sectors, and edges that ascend");
  Rose rose;
  rose.sectors.assign(classes.sectors, std::vector<std::size_t>(classes.edges.size() + 1, 0));
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double size = sizes[i];
    if (std::isnan(size))
      ++rose.missing;
    else if (size < classes.calm || size == 0)
      ++rose.calm;
    else if (std::isnan(directions_deg[i]))
      ++rose.no_direction;
    else
      ++rose.sectors[sector_of(directions_deg[i], classes.sectors)][class_of(size, classes.edges)];
  }
  return rose;
}

}  // namespace slackwater::twin
