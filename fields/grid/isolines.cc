#include "fields/grid/isolines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

#include "fields/base/check.h"

namespace slackwater {
namespace {

/// An edge of the grid, by its lower left node: twice its number, and one more where it goes up.
using Edge = std::size_t;

class Marched {
 public:
  Marched(std::span<const double> x, std::span<const double> y, std::span<const float> values,
          double level)
      : x_(x), y_(y), values_(values), level_(level) {}

  std::vector<Isoline> lines() {
    for (std::size_t j = 0; j + 1 < y_.size(); ++j)
      for (std::size_t i = 0; i + 1 < x_.size(); ++i) cross(i, j);
    std::vector<Isoline> all;
    std::set<Edge> entered;
    for (const auto& [from, to] : next_) entered.insert(to);
    std::vector<Edge> begins;
    for (const auto& [from, to] : next_)
      if (!entered.contains(from)) begins.push_back(from);
    for (const Edge begin : begins) add(walked_from(begin), all);
    while (!next_.empty()) add(walked_from(next_.begin()->first), all);  // what is left is closed
    return all;
  }

 private:
  [[nodiscard]] double value(std::size_t i, std::size_t j) const {
    return static_cast<double>(values_[j * x_.size() + i]);
  }

  /// The lines of a cell, each from the edge it comes in by to the one it goes out by, with what is
  /// higher to its left.
  void cross(std::size_t i, std::size_t j) {
    // Counterclockwise from the lower left; edge k goes from corner k to the next.
    const std::array<double, 4> corner{value(i, j), value(i + 1, j), value(i + 1, j + 1),
                                       value(i, j + 1)};
    if (std::any_of(corner.begin(), corner.end(), [](double v) { return !std::isfinite(v); }))
      return;
    const std::size_t node = j * x_.size() + i;
    const std::array<Edge, 4> edge{2 * node, 2 * (node + 1) + 1, 2 * (node + x_.size()),
                                   2 * node + 1};
    const auto is_high = [&](std::size_t k) { return corner[k % 4] >= level_; };
    // Counterclockwise along the rim: a line comes in where it falls, and goes out where it rises.
    std::vector<std::size_t> falls, rises;
    for (std::size_t k = 0; k < 4; ++k) {
      if (is_high(k) && !is_high(k + 1)) falls.push_back(k);
      if (!is_high(k) && is_high(k + 1)) rises.push_back(k);
    }
    if (falls.empty()) return;
    if (falls.size() == 1) {
      next_[edge[falls[0]]] = edge[rises[0]];
      return;
    }
    const double saddle = (corner[0] * corner[2] - corner[1] * corner[3]) /
                          (corner[0] + corner[2] - corner[1] - corner[3]);
    // Lines around the low corners where the high ones are joined; else around the high ones.
    const std::size_t step = saddle >= level_ ? 1 : 3;
    for (const std::size_t k : falls) next_[edge[k]] = edge[(k + step) % 4];
  }

  [[nodiscard]] std::array<double, 2> point(Edge edge) const {
    const std::size_t node = edge / 2, i = node % x_.size(), j = node / x_.size();
    const bool goes_up = edge % 2 == 1;
    const double a = value(i, j), b = goes_up ? value(i, j + 1) : value(i + 1, j);
    const double share = (level_ - a) / (b - a);
    return goes_up ? std::array{x_[i], y_[j] + share * (y_[j + 1] - y_[j])}
                   : std::array{x_[i] + share * (x_[i + 1] - x_[i]), y_[j]};
  }

  Isoline walked_from(Edge begin) {
    Isoline line{point(begin)};
    Edge at = begin;
    for (auto found = next_.find(at); found != next_.end(); found = next_.find(at)) {
      at = found->second;
      next_.erase(found);
      // A line through a node meets it on two edges.
      if (const auto here = point(at); here != line.back()) line.push_back(here);
    }
    return line;
  }

  static void add(Isoline line, std::vector<Isoline>& all) {
    if (line.size() > 1) all.push_back(std::move(line));
  }

  std::span<const double> x_, y_;
  std::span<const float> values_;
  double level_;
  std::map<Edge, Edge> next_;
};

}  // namespace

std::vector<Isoline> isolines(std::span<const double> x, std::span<const double> y,
                              std::span<const float> values, double level) {
  expects(values.size() == x.size() * y.size(), "a value for each node");
  return Marched(x, y, values, level).lines();
}

}  // namespace slackwater
