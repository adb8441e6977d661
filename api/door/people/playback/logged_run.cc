#include "api/door/people/playback/logged_run.h"

#include <algorithm>

namespace slackwater::people {

std::size_t LoggedRun::actions_by(double at_s) const {
  // In the order of their numbers, which is that of their times.
  const auto past = std::partition_point(actions.begin(), actions.end(), [&](const Action& action) {
    return told_at_s(action) <= at_s;
  });
  return static_cast<std::size_t>(past - actions.begin());
}

StatusPlace status_place(const LoggedVehicle& vehicle, const Moment& moment, double at_s) {
  const auto count_by = [&](const auto& of) {
    const auto past = std::partition_point(of.begin(), of.end(),
                                           [&](const auto& one) { return one.from_s <= at_s; });
    return static_cast<std::size_t>(past - of.begin());
  };
  const LoggedRow& row = vehicle.rows[moment.row];
  StatusPlace place;
  place.helm = count_by(vehicle.helms);
  place.stretch = count_by(vehicle.stretches);
  place.camera = count_by(vehicle.cameras);
  if (place.stretch > 0 && vehicle.stretches[place.stretch - 1].to_s <= at_s) place.stretch = 0;
  if (!row.is_there) return place;
  place.task = row.task + 1;
  place.halt = row.halt;
  for (std::size_t i = 0; i < vehicle.alarms.size(); ++i)
    if (vehicle.alarms[i].begin_s <= at_s && at_s <= vehicle.alarms[i].end_s)
      place.alarms.push_back(i);
  return place;
}

VehicleNow vehicle_then(const LoggedVehicle& vehicle, const StatusPlace& place) {
  VehicleNow then;
  then.home_m = vehicle.home_m;
  then.margin_s = std::numeric_limits<double>::quiet_NaN();
  if (place.camera > 0) then.camera = vehicle.cameras[place.camera - 1].pointing;
  if (place.helm > 0) {
    then.mode = vehicle.helms[place.helm - 1].mode;
    then.cause = vehicle.helms[place.helm - 1].cause;
  }
  then.words.halt = twin::name_of(place.halt);
  then.words.tasks = vehicle.tasks;
  then.words.task = place.task > 0 ? place.task - 1 : 0;
  const bool is_done = vehicle.tasks > 0 && then.words.task >= vehicle.tasks;
  if (place.task > 0 && vehicle.tasks > 0) then.words.doing = is_done ? "done" : "task";
  if (place.stretch > 0) {
    const twin::MissionStretch& stretch = vehicle.stretches[place.stretch - 1];
    then.words.phase = stretch.phase;
    if (!stretch.doing.empty()) then.words.doing = stretch.doing;
  }
  if (then.mode != twin::HelmMode::own) {
    then.words.doing = twin::name_of(then.mode);
    then.words.cause = twin::name_of(then.cause);
  }
  if (place.halt != twin::Halt::none) then.words.doing = "halted";
  for (const std::size_t i : place.alarms) {
    AlarmNow& now = then.alarms.emplace_back();
    now.alarm.id = vehicle.alarms[i].mmsi;
    now.alarm.status = twin::AlarmStatus::held;
    // How near it was going to come the log tells of the alarm's beginning alone.
    now.alarm.approach.distance_m = now.alarm.approach.time_s =
        std::numeric_limits<double>::quiet_NaN();
    now.name = vehicle.alarms[i].name;
  }
  return then;
}

}  // namespace slackwater::people
