#pragma once
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "fields/base/numbers/random.h"
#include "fields/service/snapshot.h"

namespace slackwater::tests {

/// The truth at a stamp and level of a column; NaN where there is none.
using TruthAt = std::function<Horizontal(UtcTime, std::size_t level)>;

/// One day of lead, from the members and from the normal law of the same forecast.
struct LeadDayTally {
  double n = 0;  ///< components
  double held_normal = 0;
  double held_members = 0;
  double crps_normal = 0;
  double crps_members = 0;
  double square = 0;
  double sigma_square = 0;

  [[nodiscard]] double coverage_normal() const { return held_normal / n; }
  [[nodiscard]] double coverage_members() const { return held_members / n; }
};

/// Mean squares of increments of the members' departures and of the truth minus the centre.
struct Increments {
  double members = 0;
  double truth = 0;

  /// Standard deviation of the members' against the truth's.
  [[nodiscard]] double ratio() const;
};

/// Energy and variogram scores of the first day's path, of the members and of plants: members whose
/// values are dealt anew at every time, or at every level, by which each value keeps its law.
struct PathScores {
  double energy = 0;
  double variogram_time = 0;
  double variogram_depth = 0;
};

/// How the members of many forecasts met their truths, as they are handed to the vehicles
/// (ForecastColumn::member_m_s).
class MemberTally {
 public:
  /// Adds a column of a forecast; stamps at which the truth has no value are passed over.
  void add(const Snapshot& snapshot, const ForecastColumn& column, const TruthAt& truth);
  void add(const MemberTally& other);

  static constexpr std::array lag_h{1, 3, 6, 12};
  static constexpr std::array layer_m{6.0, 12.0, 25.0, 60.0};  ///< distance of levels, up to

  std::vector<LeadDayTally> lead_day = std::vector<LeadDayTally>(3);
  std::vector<double> daily_coverage;  ///< of each forecast's first day, by the normal law
  std::array<Increments, lag_h.size()> in_time;
  std::array<Increments, layer_m.size()> in_depth;
  PathScores as_drawn, dealt_over_times, dealt_over_levels;
  double paths = 0;

  void print(const std::string& name) const;

 private:
  void add_values(const Snapshot& snapshot, const ForecastColumn& column, const TruthAt& truth);
  void add_increments(const Snapshot& snapshot, const ForecastColumn& column, const TruthAt& truth);
  void add_path(const Snapshot& snapshot, const ForecastColumn& column, const TruthAt& truth);
};

}  // namespace slackwater::tests
