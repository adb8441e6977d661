#include "twin/run/traffic_watch.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {

std::string_view name_of(AlarmEnd end) noexcept {
  switch (end) {
    case AlarmEnd::still_on:
      return "still_on";
    case AlarmEnd::clear:
      return "clear";
    case AlarmEnd::lost:
      return "lost";
    case AlarmEnd::halted:
      return "halted";
  }
  return "unknown";
}

TrafficWatch::TrafficWatch(std::vector<TrafficVessel> vessels, const AlarmLimits& limits,
                           std::vector<std::vector<std::uint32_t>> not_of_concern,
                           const TrackRule& rule)
    : vessels_(std::move(vessels)),
      limits_(limits),
      not_of_concern_(std::move(not_of_concern)),
      rule_(rule) {
  state_.alarms.resize(not_of_concern_.size());
}

AlarmRecord& TrafficWatch::open_record(std::size_t vehicle, std::uint32_t mmsi) {
  const auto found = std::find_if(
      state_.records.rbegin(), state_.records.rend(),
      [&](const AlarmRecord& record) { return record.vehicle == vehicle && record.mmsi == mmsi; });
  expects(found != state_.records.rend() && found->end == AlarmEnd::still_on,
          "an alarm that is on has a record");
  return *found;
}

void TrafficWatch::look_from(std::size_t vehicle, double t_s, const Seen& own) {
  const bool is_halted = own.halt != Halt::none;
  const auto& ignored = not_of_concern_[vehicle];
  contacts_.clear();
  for (const Contact& contact : picture_.contacts)
    if (!is_halted && std::find(ignored.begin(), ignored.end(), contact.id) == ignored.end())
      contacts_.push_back(contact);
  std::vector<Alarm>& before = state_.alarms[vehicle];
  std::vector<Alarm> now = alarms({own.position_m, own.velocity_m_s}, contacts_, limits_, before);
  const auto close = [&](std::uint32_t mmsi, AlarmEnd why) {
    AlarmRecord& record = open_record(vehicle, mmsi);
    record.end_s = t_s;
    record.end = why;
  };
  for (const Alarm& alarm : before) {
    const bool goes_on = std::any_of(now.begin(), now.end(),
                                     [&](const Alarm& other) { return other.id == alarm.id; });
    if (!goes_on) close(alarm.id, AlarmEnd::clear);
  }
  for (const Alarm& alarm : now) {
    if (alarm.status == AlarmStatus::lost) {
      close(alarm.id, is_halted ? AlarmEnd::halted : AlarmEnd::lost);
      continue;
    }
    const auto contact = std::find_if(contacts_.begin(), contacts_.end(),
                                      [&](const Contact& c) { return c.id == alarm.id; });
    const double distance_m = std::hypot(contact->motion.position_m.x - own.position_m.x,
                                         contact->motion.position_m.y - own.position_m.y);
    if (alarm.status == AlarmStatus::raised)
      state_.records.push_back({vehicle, alarm.id, t_s, t_s, AlarmEnd::still_on,
                                alarm.approach.distance_m, alarm.approach.time_s, distance_m, t_s});
    AlarmRecord& record = open_record(vehicle, alarm.id);
    record.end_s = t_s;
    if (distance_m < record.least_distance_m) {
      record.least_distance_m = distance_m;
      record.least_distance_s = t_s;
    }
  }
  std::erase_if(now, [](const Alarm& alarm) { return alarm.status == AlarmStatus::lost; });
  before = std::move(now);
}

void TrafficWatch::look(double t_s, std::span<const Seen> vehicles) {
  expects(vehicles.size() >= state_.alarms.size(), "the vehicles of the watch");
  make_room(vehicles.size());
  populate(vessels_, t_s, rule_, picture_);
  for (std::size_t i = 0; i < vehicles.size(); ++i) look_from(i, t_s, vehicles[i]);
}

void TrafficWatch::restore(State state) {
  expects(state.alarms.size() >= state_.alarms.size(), "a watch of this run's vehicles");
  state_ = std::move(state);
  make_room(state_.alarms.size());
}

/// Those that joined the run are concerned by everybody.
void TrafficWatch::make_room(std::size_t vehicles) {
  state_.alarms.resize(vehicles);
  not_of_concern_.resize(vehicles);
}

void keep_watch(TrafficWatch& watch, Run& run, double step_s) {
  if (run.steps_made() == 0) watch.look(run.time_s(), run.seen());
  const auto every =
      static_cast<std::uint64_t>(std::max(1LL, std::llround(TrafficWatch::every_s / step_s)));
  run.at_barrier([&watch, &run, every](const StepTime& time) {
    if ((time.step + 1) % every == 0) watch.look(time.end_s(), run.seen());
  });
}

}  // namespace slackwater::twin
