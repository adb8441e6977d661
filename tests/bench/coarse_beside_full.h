#pragma once
#include <cstdint>
#include <string>

#include "tests/bench/bench_report.h"
#include "twin/run/set_up.h"
#include "twin/scenario/scenario.h"

namespace slackwater::bench {

/// A water and a tether of the range that such missions have.
struct TetherCase {
  double surface_m_s = 0;  ///< current; seven tenths of it in 15 m, two at the bed
  double height_m = 0;     ///< significant
  double period_s = 6;     ///< of the peak
  double tether_m = 60;    ///< 0: none
  double depth_m = 10;     ///< of the vehicle
  [[nodiscard]] std::string name() const;
};

inline constexpr double tether_step_s = 0.05;

/// A BlueROV2 goes round and round a pile of 6 m, 8 m from its axis, the winch 22 m south of it.
[[nodiscard]] twin::Scenario tether_scenario(const TetherCase& c, twin::StepDetail detail,
                                             std::uint64_t seed, double duration_s);
/// What it is in: the water of its file.
[[nodiscard]] twin::Surround tether_surround(const twin::Scenario& scenario);

/// The coarse step beside the full one over the range of missions, five minutes each: mean tension
/// at the top, excursions of line and vehicle, and energy, each within 2 % of what it is with the
/// full step, or of 1 N, and 1 m. What one step in a hundred exceeds within 10 %, or 0.5 N; a
/// single tug is no more than twice as hard, but for 20 N. Prints the table, unless it checks
/// alone: then it takes a tenth of the cases.
void check_coarse_beside_full(BenchReport& report);

}  // namespace slackwater::bench
