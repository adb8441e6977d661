#include "fields/wave/variance_division.h"

#include <algorithm>

#include "fields/base/check.h"

namespace slackwater {
namespace {

/// The areas under S and under q up to each point of the table.
struct Cumulated {
  std::vector<double> variance;
  std::vector<double> mass;
};

/// Trapezoids of omega^power S.
std::vector<double> areas_below(const DensityTable& table, bool squared_frequency) {
  std::vector<double> area(table.frequency_rad_s.size(), 0.0);
  const auto height = [&](std::size_t i) {
    const double omega = table.frequency_rad_s[i];
    return table.density_m2_s[i] * (squared_frequency ? omega * omega : 1.0);
  };
  for (std::size_t i = 1; i < area.size(); ++i) {
    const double width = table.frequency_rad_s[i] - table.frequency_rad_s[i - 1];
    area[i] = area[i - 1] + 0.5 * width * (height(i - 1) + height(i));
  }
  return area;
}

Cumulated cumulate(const DensityTable& table) {
  Cumulated sum{areas_below(table, false), {}};
  const std::vector<double> second = areas_below(table, true);
  for (std::size_t i = 0; i < second.size(); ++i) {
    sum.mass.push_back(0.5 * sum.variance[i] / sum.variance.back() +
                       0.5 * second[i] / second.back());
  }
  return sum;
}

/// A place on the frequency axis: the cell of the table and the share of it that lies below.
struct Position {
  std::size_t cell = 0;
  double share = 0;
};

Position position_of(const std::vector<double>& mass, double wanted) {
  const auto after = std::lower_bound(mass.begin() + 1, mass.end() - 1, wanted);
  const auto cell = static_cast<std::size_t>(after - mass.begin()) - 1;
  const double width = mass[cell + 1] - mass[cell];
  return {cell, width > 0 ? std::clamp((wanted - mass[cell]) / width, 0.0, 1.0) : 1.0};
}

double value_at(const std::vector<double>& table, Position at) {
  return table[at.cell] + at.share * (table[at.cell + 1] - table[at.cell]);
}

}  // namespace

std::vector<VarianceShare> divide_variance(const DensityTable& table, std::size_t count, Rng& rng) {
  expects(count >= 1, "a spectrum is divided into one share or more");
  expects(table.frequency_rad_s.size() >= 2 &&
              table.frequency_rad_s.size() == table.density_m2_s.size(),
          "a density table has two points or more, and a density at each");
  const Cumulated sum = cumulate(table);
  std::vector<VarianceShare> shares;
  if (!(sum.variance.back() > 0)) return shares;
  const double cell_mass = 1.0 / static_cast<double>(count);
  double below = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double start = static_cast<double>(i) * cell_mass;
    const double drawn = start + cell_mass * rng.uniform(0.25, 0.75);
    const double up_to = i + 1 == count
                             ? sum.variance.back()
                             : value_at(sum.variance, position_of(sum.mass, start + cell_mass));
    shares.push_back(
        {value_at(table.frequency_rad_s, position_of(sum.mass, drawn)), up_to - below});
    below = up_to;
  }
  return shares;
}

}  // namespace slackwater
