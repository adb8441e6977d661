#pragma once
#include <span>
#include <vector>

#include "twin/run/run.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater::twin {

/// Why an alarm is over.
enum class AlarmEnd : std::uint8_t {
  still_on,  ///< at the last look
  clear,     ///< the limits and their margin are left
  lost,      ///< nobody knows any more where the vessel is
  halted,    ///< the vehicle goes no further
};
[[nodiscard]] std::string_view name_of(AlarmEnd end) noexcept;

/// An alarm of one vehicle about one vessel, from when it was raised until it was over.
struct AlarmRecord {
  std::size_t vehicle = 0;  ///< of the run
  std::uint32_t mmsi = 0;
  double begin_s = 0;
  double end_s = 0;  ///< still on: the last look
  AlarmEnd end = AlarmEnd::still_on;
  double cpa_m = 0;             ///< as foreseen when it was raised
  double tcpa_s = 0;            ///< from `begin_s`
  double least_distance_m = 0;  ///< as it came, at a look while the alarm was on
  double least_distance_s = 0;  ///< when
};

/// Looks out for the traffic from every vehicle of a run, in the plane, whatever its depth or
/// height. An observer: it changes nothing of the run, and what it keeps is a value for a
/// checkpoint.
class TrafficWatch {
 public:
  /// How often it looks, to the whole step: a few metres of a fast vessel's way.
  static constexpr double every_s = 1;

  /// @param not_of_concern  for each vehicle: whom it raises no alarm about
  TrafficWatch(std::vector<TrafficVessel> vessels, const AlarmLimits& limits,
               std::vector<std::vector<std::uint32_t>> not_of_concern, const TrackRule& rule = {});

  /// @param t_s       since the epoch, later than that of the last look
  /// @param vehicles  as before; those that joined the run since come last
  void look(double t_s, std::span<const Seen> vehicles);

  struct State {
    std::vector<std::vector<Alarm>> alarms;  ///< of each vehicle, at the last look
    std::vector<AlarmRecord> records;        ///< by their beginning, then by vehicle
  };
  [[nodiscard]] const State& state() const noexcept { return state_; }
  /// Goes on from there. @throws ContractViolation for that of fewer vehicles
  void restore(State state);
  [[nodiscard]] std::span<const AlarmRecord> records() const noexcept { return state_.records; }

 private:
  AlarmRecord& open_record(std::size_t vehicle, std::uint32_t mmsi);
  void make_room(std::size_t vehicles);
  void look_from(std::size_t vehicle, double t_s, const Seen& own);

  std::vector<TrafficVessel> vessels_;
  AlarmLimits limits_;
  std::vector<std::vector<std::uint32_t>> not_of_concern_;
  TrackRule rule_;
  State state_;
  TrafficPicture picture_;
  std::vector<Contact> contacts_;
};

/// Lets it look at the barriers of a run, which it must outlive, and at once where the run is at
/// its start: one that was taken up from a checkpoint has a watch that was too.
void keep_watch(TrafficWatch& watch, Run& run, double step_s);

}  // namespace slackwater::twin
