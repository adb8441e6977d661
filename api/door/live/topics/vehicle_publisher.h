#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/live/topics/reserve_advice.h"
#include "api/door/live/topics/stream.h"
#include "fields/geo/geo_point.h"
#include "twin/agent/agent.h"

namespace slackwater::live {

/// What all voices of a run share.
struct RunPlace {
  UtcTime epoch;
  GeoPoint origin;
  double geoid_m = 0;  ///< mean sea level above the ellipsoid there
  double step_s = 0;   ///< of the barrier
};

/// What a vehicle is about, in words; what `mission_state` tells.
struct MissionWords {
  std::string_view doing, cause, phase, halt;  ///< cause and phase may be empty
  std::string authority;                       ///< the client at the helm, "" where nobody is
  std::size_t task = 0, tasks = 0, waypoints_taken = 0;
  bool operator==(const MissionWords&) const = default;
  /// api/docs/dds.md has its schema.
  [[nodiscard]] std::string json() const;
};
[[nodiscard]] MissionWords mission_words(const twin::Agent& agent, const twin::AgentState& state,
                                         const std::string& holder);

/// By which what is left of a way is known to be the same as before, without looking at all of it.
struct WayAhead {
  twin::HelmMode mode{};
  twin::Doing doing{};
  double since_s = 0;  ///< the last command of that mode
  std::size_t task = 0, next = 0;
  bool is_done = true;
  std::array<double, 3> to_m{};  ///< the next place
  bool operator==(const WayAhead&) const = default;
};

/// Tells of one vehicle after each barrier: each topic at its own rate, and nothing that nobody
/// hears.
class VehiclePublisher {
 public:
  /// @param name  a token of ROS, of the vehicle alone
  /// @param t_s   of the run, when it begins or the vehicle joins it
  VehiclePublisher(Stream& stream, const RunPlace& place, std::string name,
                   const twin::Agent& agent, const twin::AgentState& at_start, double t_s);
  /// @param holder    the client at its helm, "" where nobody is
  void speak(const twin::Agent& agent, const twin::AgentState& state, const std::string& holder,
             double t_s);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  using ChannelId = Stream::ChannelId;
  void speak_of_instruments(const twin::Agent& agent, const twin::AgentState& state,
                            const dds::Stamp& stamp);
  /// Latched topics, where they change.
  void speak_of_changes(const twin::Agent& agent, const twin::AgentState& state,
                        const std::string& holder, const dds::Stamp& stamp);

  Stream& stream_;
  RunPlace place_;
  std::string name_;
  ReserveAdvice advice_;
  ChannelId odometry_, pose_, battery_, reserve_, mission_, waypoints_;
  ChannelId imu_ = 0, fix_ = 0, pressure_ = 0, dvl_ = 0, dvl_water_ = 0;
  std::uint64_t looked_ = 0;  ///< steps of the instruments that were told of
  double second_s_ = -1;      ///< when it told last of what it tells each second
  int battery_status_ = -1;
  std::optional<MissionWords> mission_said_;
  std::optional<WayAhead> way_said_;
};

/// What is left of the waypoints that it goes by now.
[[nodiscard]] std::vector<twin::Waypoint> waypoints_left(const twin::AgentState& state);

}  // namespace slackwater::live
