#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/cf/trajectory_file.h"
#include "twin/body/attitude.h"
#include "twin/simulate/scenario.h"

namespace slackwater::api {

struct Extreme {
  double value = 0;
  double t_s = 0;
};

/// The rows of one vehicle's variables, up to the one at which it stopped; those before it joined
/// the run have no numbers.
class VehicleLog {
 public:
  /// @param until_s  the first row from then on is the last one
  VehicleLog(const ingest::TrajectoryFile& log, std::size_t vehicle,
             double until_s = std::numeric_limits<double>::infinity())
      : log_(&log), vehicle_(vehicle) {
    const ingest::TrajectoryFile::Variable* halt = log.find("halt");
    const auto end = std::lower_bound(log.t_s.begin(), log.t_s.end(), until_s);
    rows_ = std::min(static_cast<std::size_t>(end - log.t_s.begin()) + 1, log.t_s.size());
    for (std::size_t t = 0; halt != nullptr && t < rows_; ++t)
      if (of(*halt, t) > 0) rows_ = t + 1;
  }
  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  /// The first row that has a place; the last one where none has.
  [[nodiscard]] std::size_t first() const {
    std::size_t row = 0;
    while (row + 1 < rows_ && !std::isfinite(at("x", row))) ++row;
    return row;
  }
  /// No number where the log has no such variable.
  [[nodiscard]] double at(std::string_view name, std::size_t row) const {
    const ingest::TrajectoryFile::Variable* variable = log_->find(name);
    return variable == nullptr ? std::numeric_limits<double>::quiet_NaN() : of(*variable, row);
  }
  [[nodiscard]] double last(std::string_view name) const { return at(name, rows_ - 1); }

  /// The value of the largest size; nothing where there is no number.
  [[nodiscard]] std::optional<Extreme> largest(std::string_view name) const {
    std::optional<Extreme> found;
    for (std::size_t t = 0; t < rows_; ++t) {
      const double value = at(name, t);
      if (std::isfinite(value) && (!found || std::abs(value) > std::abs(found->value)))
        found = Extreme{value, log_->t_s[t]};
    }
    return found;
  }
  /// NED.
  [[nodiscard]] twin::Triple<double> place_m(std::size_t row) const {
    return {at("y", row), at("x", row), -at("z", row)};
  }

 private:
  [[nodiscard]] double of(const ingest::TrajectoryFile::Variable& variable, std::size_t row) const {
    return variable.values[(vehicle_ * log_->t_s.size() + row) * variable.per];
  }
  const ingest::TrajectoryFile* log_;
  std::size_t vehicle_;
  std::size_t rows_ = 0;
};

/// How near something came, and when.
struct Approach {
  double distance_m = std::numeric_limits<double>::infinity();
  double t_s = 0;
  std::string to;
  std::uint32_t mmsi = 0;  ///< of a vessel
  friend bool operator==(const Approach&, const Approach&) = default;
};
/// Along the straight ways between the rows; to a face. Infinite where there is none.
[[nodiscard]] Approach nearest_structure(const ingest::TrajectoryFile& log,
                                         const VehicleLog& vehicle, const twin::Scenario& scenario);
/// Centre to centre, at the rows of both.
[[nodiscard]] Approach nearest_vehicle(const ingest::TrajectoryFile& log,
                                       const std::vector<VehicleLog>& vehicles, std::size_t i);

}  // namespace slackwater::api
