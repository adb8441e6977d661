#include <cmath>

#include "api/door/people/playback/playback.h"
#include "api/door/people/told.h"

// What is about the vehicles of a log that is watched again. With the lock held.

namespace slackwater::people {
namespace {

using nlohmann::json;

constexpr double around_every_s = 1;             ///< of the run
constexpr Milliseconds around_soonest_ms = 200;  ///< of the clock: at most so often

}  // namespace

json Playback::place_facts() const {
  if (found_.surround) return found_.surround->facts();
  return {{"water", {{"missing", found_.missing}}},
          {"turbines", nullptr},
          {"sea", nullptr},
          {"bed", nullptr},
          {"cables", json::array()},
          {"moorings", json::array()}};
}

/// Who led the weather last by then.
std::string Playback::weather_by(double at_s) const {
  std::string who;
  for (const Action& action : run_.actions)
    if (action.what == "weather" && action.is_taken && action.time_s <= at_s) who = action.who;
  return who;
}

Playback::Around Playback::around_at(double at_s) {
  Surroundings around;
  std::optional<FarmNow> farm;
  if (found_.surround) {
    const Moment moment = moment_of(run_.t_s, at_s);
    std::vector<Horizontal> vehicles_m;
    for (const LoggedVehicle& vehicle : run_.vehicles)
      if (const auto pose = pose_at(vehicle.rows, moment))
        vehicles_m.emplace_back(pose->east_m, pose->north_m);
    around = found_.surround->at(at_s, vehicles_m);
    farm = found_.surround->farm(around);
  } else if (run_.origin) {
    // Of place and time alone.
    around.sun = sun_at(*run_.origin, run_.start, at_s);
  } else {
    return {nullptr, nullptr};
  }
  return {weather_json(around, at_s, farm, weather_by(at_s)),
          found_.surround ? traffic_json(around) : json(nullptr)};
}

void Playback::tell_around(Viewer& viewer, double at_s) {
  const Milliseconds now = clock();
  const bool is_near = std::fabs(at_s - viewer.around_at_s) < around_every_s;  // not when it is nan
  if (is_near || (std::isfinite(viewer.around_at_s) && now < viewer.around_at + around_soonest_ms))
    return;
  viewer.around_at_s = at_s;
  viewer.around_at = now;
  Around is = around_at(at_s);
  for (auto& [told, is_now] : {std::pair(&viewer.weather_told, &is.weather),
                               std::pair(&viewer.traffic_told, &is.traffic)}) {
    if (*told == *is_now || is_now->is_null()) continue;
    *told = std::move(*is_now);
    tell(viewer, *told);
  }
}

}  // namespace slackwater::people
