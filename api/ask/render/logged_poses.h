#pragma once
#include <optional>
#include <vector>

#include "ingest/cf/trajectory_file.h"
#include "twin/body/body.h"
#include "twin/inspection/instrument/pose.h"

namespace slackwater::api {

/// What a row of a log says of where a vehicle was.
struct PoseRow {
  twin::Triple<double> position_m;  ///< NED
  twin::EulerAngles turned;
  twin::Triple<double> velocity_m_s;  ///< body axes
  twin::Triple<double> rates_rad_s;   ///< body axes
};
[[nodiscard]] twin::Carriage carriage_of(const PoseRow& row) noexcept;
/// The same of a vehicle now, to the bit as the row that a log would have of it. Nothing where it
/// has come to grief: it is nowhere.
[[nodiscard]] std::optional<twin::Carriage> carriage_as_logged(
    const twin::BodyState<double>& body) noexcept;

/// Where the vehicles of a log were.
class LoggedPoses {
 public:
  /// @throws Error(invalid_input) for a log without times, positions or attitudes
  explicit LoggedPoses(const ingest::TrajectoryFile& log);

  [[nodiscard]] double from_s() const noexcept { return t_s_.front(); }
  [[nodiscard]] double to_s() const noexcept { return t_s_.back(); }
  /// NED of the run: between two rows on the straight way, its angles the short way round,
  /// velocities in between. Nothing where the vehicle was not there at either.
  /// @param t_s  within the rows
  [[nodiscard]] std::optional<twin::Carriage> at(std::size_t vehicle, double t_s) const;

 private:
  [[nodiscard]] std::optional<PoseRow> row(std::size_t vehicle, std::size_t row) const;

  std::vector<double> t_s_;
  const ingest::TrajectoryFile* log_;
};

}  // namespace slackwater::api
