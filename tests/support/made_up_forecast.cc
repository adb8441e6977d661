#include "tests/support/made_up_forecast.h"

#include <array>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::tests {
namespace {

constexpr double top_m = 0.5;
constexpr double bottom_m = 45;
constexpr double remembered = 0.951;  // exp(-1 h / 20 h)

double depth_of(std::size_t level, std::size_t levels) {
  return levels < 2 ? top_m
                    : top_m + (bottom_m - top_m) * static_cast<double>(level) /
                                  static_cast<double>(levels - 1);
}

Horizontal central_current(double depth_m, double hours, double phase) {
  const double angle = 2 * constants::pi * hours / 12.42 + phase;
  return (0.5 - 0.006 * depth_m) * Horizontal(std::cos(angle), 0.4 * std::sin(angle)) +
         Horizontal(0.05, -0.02);
}

/// What a member adds to the central current, over time x depth.
std::vector<Horizontal> departure(Rng& random, const Snapshot& s) {
  std::array<Horizontal, 3> walk{};
  std::vector<Horizontal> result;
  for (std::size_t t = 0; t < s.time.size(); ++t) {
    for (const double depth : s.depth_m) {
      result.push_back(walk[0] + walk[1] * std::exp(-depth / 10) + walk[2] * (depth / bottom_m));
    }
    for (Horizontal& w : walk)
      w = remembered * w + 0.02 * Horizontal(random.normal(), random.normal());
  }
  return result;
}

void add_members(ForecastColumn& column, Rng& random, const Snapshot& s) {
  for (std::size_t m = 1; m < s.members; ++m) {
    const std::vector<Horizontal> more = departure(random, s);
    for (std::size_t o = 0; o < more.size(); ++o) {
      const bool there = has_value(column.current_status[o]);
      column.member_m_s.push_back(there ? column.current_m_s[o] + more[o] : Horizontal{});
    }
    for (const Horizontal wind : column.wind_m_s) {
      column.wind_member_m_s.push_back(wind + Horizontal(random.normal(), random.normal()));
    }
  }
}

ForecastColumn made_up_column(std::size_t index, Rng& random, const Snapshot& s) {
  ForecastColumn column;
  const auto offset = static_cast<double>(index);
  column.point = GeoPoint::from_degrees(48.85 + 0.01 * offset, -2.55);
  column.water_depth_m = index % 2 == 0 ? 50 : 44;
  column.water_depth_source = "site";
  const double phase = random.uniform(0, 6);
  for (std::size_t t = 0; t < s.time.size(); ++t) {
    const auto hours = static_cast<double>(t);
    for (const double depth : s.depth_m) {
      const bool there = depth <= column.water_depth_m;
      column.current_m_s.push_back(there ? central_current(depth, hours, phase) : Horizontal{});
      column.current_sigma_m_s.push_back(there ? 0.02 + 0.0005 * hours : 0);
      column.current_status.push_back(there ? SampleStatus::ok : SampleStatus::below_bed);
    }
    column.wind_m_s.emplace_back(8 + random.normal(), -3 + random.normal());
    column.wind_source.push_back(DataStatus::forecast);
    column.sea.push_back({1.2, 7.5, 240.0});
    column.sea_source.push_back(DataStatus::modelled);
  }
  add_members(column, random, s);
  return column;
}

}  // namespace

Snapshot made_up_forecast(const MadeUpForecast& size) {
  Rng random(size.seed, "tests/made_up_forecast");
  Snapshot s;
  s.site_id = "made_up";
  s.site_name = "Made-up site";
  s.day = parse_day("2025-03-09");
  s.issued = parse_utc("2025-03-10T05:00:00Z");
  s.wind_policy = WindPolicy::best;
  s.headline = "A made-up forecast.";
  s.attributions = {"made up for tests"};
  s.members = size.members;
  s.seed = size.seed;
  for (std::size_t k = 0; k < size.levels; ++k) s.depth_m.push_back(depth_of(k, size.levels));
  for (std::size_t t = 0; t <= size.hours; ++t) {
    s.time.push_back(UtcTime(s.day) + std::chrono::hours(24 + t));
  }
  for (std::size_t c = 0; c < size.columns; ++c) s.columns.push_back(made_up_column(c, random, s));
  return s;
}

void add_made_up_level(Snapshot& forecast) {
  for (std::size_t c = 0; c < forecast.columns.size(); ++c) {
    SeaLevel& level = forecast.columns[c].sea_level;
    for (std::size_t t = 0; t < forecast.time.size(); ++t) {
      const double hours = hours_between(UtcTime{}, forecast.time[t]);
      level.level_m.push_back((1.5 + 0.1 * static_cast<double>(c)) *
                              std::cos(2 * constants::pi * hours / 12.4206));
      level.sigma_m.push_back(0.05 + 0.01 * static_cast<double>(t));
      level.source.push_back(DataStatus::modelled);
    }
  }
}

}  // namespace slackwater::tests
