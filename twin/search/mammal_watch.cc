#include "twin/search/mammal_watch.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/curve/named_file.h"

namespace slackwater::twin {
namespace {

std::vector<double> read_falling(const Config& c, std::string_view key, Range range) {
  std::vector<double> values = c.numbers(key, range);
  if (values.size() != MammalWatch::forces)
    c.refuse(key, formatted("found {} numbers, expected {}, one for each Beaufort force from 0",
                            values.size(), MammalWatch::forces));
  if (!std::is_sorted(values.rbegin(), values.rend()))
    c.refuse(key, "found a greater number in a rougher sea; expected it not to grow");
  return values;
}

}  // namespace

double beaufort_force(double wind_10m_m_s) noexcept {
  constexpr double one_m_s = 0.836;
  const double root = std::cbrt(wind_10m_m_s / one_m_s);
  return root * root;
}

double chance_of_cue(const CueSight& sight, double distance_m) noexcept {
  if (!(sight.half_width_m > 0)) return 0;
  const double share = distance_m / sight.half_width_m;
  return sight.chance_at_zero * std::exp(-0.25 * constants::pi * share * share);
}

MammalWatch read_mammal_watch(const std::string& name, const std::filesystem::path& data_folder) {
  const Config c = open_named(name, "mammals: watch", data_folder / "watches");
  MammalWatch watch;
  watch.name = c.text("name");
  (void)c.text("source");
  (void)c.text("status");
  const std::string cue = c.text("cue");
  if (cue != "surfacing" && cue != "call")
    c.refuse("cue", "found " + cue + ", expected surfacing or call");
  watch.cue = cue == "call" ? Cue::call : Cue::surfacing;
  const auto widths = read_falling(c, "half_width_m", {0, 20e3});
  const auto chances = read_falling(c, "chance_at_zero", {0, 1});
  for (std::size_t i = 0; i < MammalWatch::forces; ++i) watch.by_force[i] = {widths[i], chances[i]};
  c.expect_all_read();
  return watch;
}

CueSight sight_at(const MammalWatch& watch, double wind_10m_m_s) noexcept {
  const double force = beaufort_force(wind_10m_m_s);
  const double below = std::floor(force);
  if (!(below < MammalWatch::forces)) return {};
  const auto i = static_cast<std::size_t>(below);
  const CueSight& a = watch.by_force[i];
  const CueSight b = i + 1 < MammalWatch::forces ? watch.by_force[i + 1] : CueSight{};
  const double share = force - below;
  return {a.half_width_m + share * (b.half_width_m - a.half_width_m),
          a.chance_at_zero + share * (b.chance_at_zero - a.chance_at_zero)};
}

double chance_in_watch(const CueSight& sight, double radius_m, double watch_s, double cue_every_s) {
  // Simpson's rule, an even number of intervals.
  constexpr int intervals = 200;
  const double step_m = radius_m / intervals;
  double missed = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double r = i * step_m;
    const double weight = i == 0 || i == intervals ? 1 : (i % 2 == 1 ? 4 : 2);
    missed += weight * r * std::exp(-chance_of_cue(sight, r) * watch_s / cue_every_s);
  }
  return 1 - 2 / (radius_m * radius_m) * missed * step_m / 3;
}

void step_noise(const NoiseRule& rule, double t_s, double dt_s, bool is_seen, bool watched,
                NoiseGate& gate) noexcept {
  if (is_seen || !watched) gate.clear_since_s = t_s;
  if (gate.is_on != 0) {
    gate.noise_s += dt_s;
    if (is_seen) gate.stops += 1;
    if (is_seen || !watched || gate.noise_s >= rule.wanted_s) gate.is_on = 0;
    return;
  }
  if (watched && !is_seen && t_s - gate.clear_since_s >= rule.watch_s &&
      gate.noise_s < rule.wanted_s)
    gate.is_on = 1;
}

}  // namespace slackwater::twin
