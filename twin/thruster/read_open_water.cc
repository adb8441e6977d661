#include "twin/thruster/read_open_water.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr Range thrust_coefficient_range{-1, 2};
constexpr Range torque_coefficient_range{-0.5, 1};
constexpr double highest_ratio = 3;

/// K_T and K_Q at evenly spaced J from 0 on; K_Q may be left out.
struct Coefficients {
  UniformAxis ratio;
  std::vector<double> thrust;
  std::vector<double> torque;
};

Coefficients read_tabulated(const Config& c) {
  const std::vector<double> ratio = c.numbers("J", {0, highest_ratio});
  const std::vector<double> thrust = c.numbers("K_T", thrust_coefficient_range);
  const std::vector<double> torque = c.numbers("K_Q", torque_coefficient_range);
  if (ratio.size() < 2 || thrust.size() != ratio.size() ||
      !(torque.empty() || torque.size() == ratio.size())) {
    c.refuse("J", formatted("found {} of J, {} of K_T and {} of K_Q; give one of each for two J at "
                            "least, or no K_Q",
                            ratio.size(), thrust.size(), torque.size()));
  }
  if (ratio.front() != 0)
    c.refuse("J", formatted("begins at {:g}; give K_T at J = 0, at rest, first", ratio.front()));
  if (std::adjacent_find(ratio.begin(), ratio.end(), std::greater_equal<>()) != ratio.end())
    c.refuse("J", "give the advance ratios in rising order");
  const auto axis = uniform_axis_through(ratio, 1001);
  if (!axis) c.refuse("J", "they have no common step; round them");
  Coefficients out{*axis, on_axis(*axis, ratio, thrust), {}};
  if (!torque.empty()) out.torque = on_axis(*axis, ratio, torque);
  return out;
}

/// c0 + c1 J + c2 J^2 ..., straight between places where it is not straight itself.
Coefficients read_powers(const Config& c) {
  const std::vector<double> thrust = c.numbers("K_T", {-1e3, 1e3});
  const std::vector<double> torque = c.numbers("K_Q", {-1e3, 1e3});
  const double most = c.number("most_J", {0.05, highest_ratio});
  constexpr std::size_t most_powers = 10;
  if (thrust.empty() || thrust.size() > most_powers || torque.size() > most_powers)
    c.refuse("K_T", formatted("found {} coefficients of K_T and {} of K_Q; give c0, c1, ... of the "
                              "powers of J, {} at most, or a table with J",
                              thrust.size(), torque.size(), most_powers));
  const std::size_t count = std::max(thrust.size(), torque.size()) > 2 ? 201 : 2;
  Coefficients out;
  out.ratio = {0, most / static_cast<double>(count - 1), count};
  const auto spread_out = [&](const std::vector<double>& powers, std::string_view key,
                              Range range) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count && !powers.empty(); ++i) {
      double value = 0;
      for (auto power = powers.rbegin(); power != powers.rend(); ++power)
        value = value * out.ratio.at(i) + *power;
      if (!(value >= range.low && value <= range.high))
        c.refuse(key, formatted("comes to {:g} at J = {:g}; expected {:g} to {:g}", value,
                                out.ratio.at(i), range.low, range.high));
      values.push_back(value);
    }
    return values;
  };
  out.thrust = spread_out(thrust, "K_T", thrust_coefficient_range);
  out.torque = spread_out(torque, "K_Q", torque_coefficient_range);
  return out;
}

/// More turns push more: K_T/J^2 falls, or the shaft for a thrust could not be found.
void expect_thrust_to_fall(const Config& c, const Coefficients& k) {
  if (!(k.thrust.front() >= 0.01))
    c.refuse("K_T", formatted("found {:g} at J = 0; expected 0.01 at least, counted positive "
                              "the way the shaft turns",
                              k.thrust.front()));
  for (std::size_t i = 2; i < k.ratio.count; ++i) {
    const double before = k.ratio.at(i - 1), ratio = k.ratio.at(i);
    if (k.thrust[i] > 0 && k.thrust[i] * before * before >= k.thrust[i - 1] * ratio * ratio) {
      c.refuse("K_T",
               formatted("rises from {:g} at J = {:g} to {:g} at J = {:g}, so that more turns "
                         "would push less; expected it to fall with J",
                         k.thrust[i - 1], before, k.thrust[i], ratio));
    }
  }
}

/// What the shaft gives is what a loss-free disc needs at least, a nozzle the root of 2 less; and
/// at rest no propeller needs seven times that.
void expect_power_of_this_world(const Config& c, const Coefficients& k) {
  constexpr double least = 0.7, most_at_rest = 7;
  for (std::size_t i = 0; i < k.torque.size(); ++i) {
    const double ratio = k.ratio.at(i), thrust = k.thrust[i];
    if (!(thrust > 0)) continue;
    const double ideal = thrust *
                         (ratio / 2 + std::sqrt(ratio * ratio / 4 + 2 * thrust / constants::pi)) /
                         (2 * constants::pi);
    const double share = k.torque[i] / ideal;
    if (share >= least && (ratio > 0 || share <= most_at_rest)) continue;
    c.refuse(
        "K_Q",
        formatted("found {:g} at J = {:g}, {:.3g} times the {:.3g} that a loss-free disc takes "
                  "for K_T = {:g}; expected {:g} at least, and at rest {:g} at most. Check "
                  "that it is K_Q and not 10 K_Q, and J",
                  k.torque[i], ratio, share, ideal, thrust, least, most_at_rest));
  }
}

Coefficients read_coefficients(const Config& c) {
  Coefficients k = c.has("J") ? read_tabulated(c) : read_powers(c);
  expect_thrust_to_fall(c, k);
  expect_power_of_this_world(c, k);
  // Faster still it pushes nothing: held above 0 it would give more than its shaft.
  if (k.thrust.back() > 0) {
    ++k.ratio.count;
    k.thrust.push_back(0);
    if (!k.torque.empty()) k.torque.push_back(k.torque.back());
  }
  return k;
}

/// The same with a share of the thrust and the torque.
Coefficients scaled(Coefficients k, double share) {
  for (auto* values : {&k.thrust, &k.torque})
    for (double& value : *values) value *= share;
  return k;
}

void append_steps(const Coefficients& k, double thrust_unit, double torque_unit,
                  std::vector<double>& step) {
  const auto at = [&](const std::vector<double>& values, std::size_t i) {
    return values.empty() ? 0.0 : values[std::min(i, values.size() - 1)];
  };
  for (std::size_t i = 0; i < k.ratio.count; ++i) {
    step.insert(step.end(), {thrust_unit * at(k.thrust, i), thrust_unit * at(k.thrust, i + 1),
                             torque_unit * at(k.torque, i), torque_unit * at(k.torque, i + 1)});
  }
}

}  // namespace

OpenWater read_open_water(const Config& c, double diameter_m, double density_kg_m3) {
  const Config ahead_of = c.child("open_water");
  const Coefficients ahead = read_coefficients(ahead_of);
  Coefficients astern;
  if (const auto astern_of = c.optional_child("astern")) {
    astern = read_coefficients(*astern_of);
    if (astern.torque.empty() != ahead.torque.empty())
      astern_of->refuse("K_Q", "give it both in open_water and in astern, or in neither");
    if (c.has("astern_share"))
      c.refuse("astern_share", "`astern` says what it does astern; leave one of the two out");
  } else {
    astern = scaled(ahead, c.optional_number("astern_share", {0.05, 1.5}).value_or(1));
  }
  OpenWater water;
  water.has_torque = !ahead.torque.empty();
  water.ahead_ratio = ahead.ratio;
  water.astern_ratio = astern.ratio;
  water.diameter_m = diameter_m;
  // Of n in turns per second to radians per second.
  const double thrust_unit =
      density_kg_m3 * std::pow(diameter_m, 4) / (4 * constants::pi * constants::pi);
  append_steps(ahead, thrust_unit, thrust_unit * diameter_m, water.step);
  append_steps(astern, thrust_unit, thrust_unit * diameter_m, water.step);
  water.flow_share = 1 - c.optional_number("wake_fraction", {-0.5, 0.9}).value_or(0);
  water.thrust_share = 1 - c.optional_number("thrust_deduction", {-0.2, 0.9}).value_or(0);
  if (!water.has_torque && c.has("torque_share"))
    c.refuse("torque_share", "without K_Q nobody knows the torque; give K_Q, or leave it out");
  water.torque_share = c.optional_number("torque_share", {0, 1}).value_or(1);
  return water;
}

}  // namespace slackwater::twin
