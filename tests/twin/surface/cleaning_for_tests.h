#pragma once
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/surface/cleaning_outcome.h"

namespace slackwater::tests {

/// A pile of 6 m in 35 m of water.
inline const twin::Structure& test_pile() {
  static const twin::Structure pile = twin::Cylinder{0, 0, 3, -20, 35};
  return pile;
}

/// A place beside it, so far along the face from north, clockwise.
inline twin::Triple<double> beside_pile(double along_m, double down_m, double off_m = 0.8) {
  const double bearing = along_m / 3;
  return {(3 + off_m) * std::cos(bearing), (3 + off_m) * std::sin(bearing), down_m};
}

/// A patch 4 to 8 m deep with a decimetre of growth, and a tool of 0.4 m.
inline std::string cleaning_yaml(const std::string& removal = "removal_mm_m2_h: 6000",
                                 const std::string& more = "") {
  return "from: {depth_m: 4}\nto: {depth_m: 8}\n"
         "growth: {source: test, status: estimate, density_kg_m3: 1300, by_depth: "
         "[{thickness_mm: 100}]}\n"
         "tool: {swath_m: 0.4, reach_m: 1, " +
         removal + ", source: test, status: estimate}\n" + more;
}

inline twin::CleaningPlan cleaning_plan(const std::string& yaml) {
  const Config config = Config::parse(yaml, "cleaning.yaml");
  const twin::CleaningPlan plan = twin::read_cleaning(config);
  config.expect_all_read();
  return plan;
}

/// Ready for work that goes a quarter round at that speed along the face.
inline twin::Cleaning ready_for(const twin::CleaningPlan& plan, double speed_m_s = 0.05,
                                double down_m = 6) {
  const double out = 3.8 / 3;  // the vehicle's way is longer than the tool's
  std::vector<twin::Waypoint> way;
  for (int i = 0; i <= 200; ++i)
    way.push_back({beside_pile(0.005 * i * 1.5 * constants::pi, down_m), out * speed_m_s, 0});
  return twin::ready_cleaning(plan, {&test_pile(), 1}, way);
}

/// Carries the tool along the face at that speed, looking every `dt_s`.
inline void pass(const twin::Cleaning& cleaning, double from_m, double to_m, double down_m,
                 double speed_m_s, double dt_s, twin::CleaningState& state) {
  const double time_s = std::abs(to_m - from_m) / speed_m_s;
  const auto steps = static_cast<int>(std::ceil(time_s / dt_s - 1e-9));
  for (int i = 0; i <= steps; ++i) {
    const double share = std::min(1.0, i * dt_s / time_s);
    const double since_s = i < steps ? dt_s : time_s - (steps - 1) * dt_s;
    twin::clean(cleaning, true, beside_pile(from_m + share * (to_m - from_m), down_m), since_s,
                state);
  }
  twin::clean(cleaning, false, beside_pile(to_m, down_m), dt_s, state);
}

}  // namespace slackwater::tests
