#include "twin/climate/scatter.h"

#include <cmath>

#include "fields/base/check.h"
#include "twin/climate/rose.h"

namespace slackwater::twin {

Scatter scatter_of(std::span<const double> first, std::span<const double> first_edges,
                   std::span<const double> second, std::span<const double> second_edges) {
  expects(first.size() == second.size(), "each value has its partner");
  Scatter scatter;
  scatter.counts.assign(first_edges.size() + 1,
                        std::vector<std::size_t>(second_edges.size() + 1, 0));
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (std::isnan(first[i]) || std::isnan(second[i])) {
      ++scatter.missing;
      continue;
    }
    ++scatter.known;
    ++scatter.counts[class_of(first[i], first_edges)][class_of(second[i], second_edges)];
  }
  return scatter;
}

}  // namespace slackwater::twin
