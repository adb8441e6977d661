#include "api/log/at_limits.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "api/log/account_log.h"
#include "twin/run/set_up.h"

namespace slackwater::api {
namespace {

using twin::Triple;

constexpr double near_share = 0.25;

double overlap_s(const Stretch& a, double from_s, double to_s) {
  return std::max(0.0, std::min(a.to_s, to_s) - std::max(a.from_s, from_s));
}

bool is_within(std::span<const Stretch> stretches, double t_s) {
  return std::any_of(stretches.begin(), stretches.end(), [t_s](const Stretch& stretch) {
    return t_s >= stretch.from_s && t_s <= stretch.to_s;
  });
}

/// A value at each row of a log; what is no number is not looked at.
struct Track {
  std::span<const double> t_s;
  std::span<const Stretch> stretches;

  /// Each row that stands within the stretches, and for how long.
  void each(const std::function<void(std::size_t row, double s)>& look) const {
    for (std::size_t i = 0; i + 1 < t_s.size(); ++i) {
      double s = 0;
      for (const Stretch& stretch : stretches) s += overlap_s(stretch, t_s[i], t_s[i + 1]);
      if (s > 0) look(i, s);
    }
  }
  /// For how long it was so.
  [[nodiscard]] double seconds(const std::function<bool(std::size_t)>& is_so) const {
    double sum_s = 0;
    each([&](std::size_t row, double s) { sum_s += is_so(row) ? s : 0; });
    return sum_s;
  }
  /// How often it became so.
  [[nodiscard]] std::size_t times(const std::function<bool(std::size_t)>& is_so,
                                  const std::function<bool(std::size_t)>& is_not) const {
    std::size_t count = 0;
    for (std::size_t i = 1; i < t_s.size(); ++i)
      if (is_not(i - 1) && is_so(i) && is_within(stretches, t_s[i])) ++count;
    return count;
  }
};

std::vector<Triple<double>> places_of(const twin::VehicleRows& rows) {
  const auto east = rows.column("x"), north = rows.column("y"), up = rows.column("z");
  std::vector<Triple<double>> places;
  for (std::size_t i = 0; i < rows.t_s.size(); ++i) places.push_back({north[i], east[i], -up[i]});
  return places;
}

/// NaN: where it was is not known, or nothing stands there.
std::vector<double> distances_of(std::span<const Triple<double>> places,
                                 std::span<const twin::ScenarioStructure> structures) {
  std::vector<double> distances(places.size(), std::nan(""));
  for (const twin::ScenarioStructure& structure : structures) {
    const twin::Structure shape = twin::shape_of(structure);
    for (std::size_t i = 0; i < places.size(); ++i)
      distances[i] = std::fmin(distances[i], twin::signed_distance_m(shape, places[i]));
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!std::isfinite(places[i].x + places[i].y + places[i].z)) distances[i] = std::nan("");
  return distances;
}

void look_at_stand_off(const Track& track, std::span<const double> distance_m, AtLimits& at) {
  track.each([&](std::size_t i, double) {
    if (std::isfinite(distance_m[i]))
      at.nearest_structure_m =
          std::min(distance_m[i], at.nearest_structure_m.value_or(distance_m[i]));
  });
  if (!at.stand_off_m) return;
  const double least_m = *at.stand_off_m;
  const auto is_inside = [&](std::size_t i) { return distance_m[i] < least_m; };
  const auto is_outside = [&](std::size_t i) { return distance_m[i] >= least_m; };
  at.stand_off_breaches = track.times(is_inside, is_outside);
  at.inside_stand_off_s = track.seconds(is_inside);
  at.near_stand_off_s = track.seconds(
      [&](std::size_t i) { return is_outside(i) && distance_m[i] <= (1 + near_share) * least_m; });
}

void look_at_fence(const Track& track, std::span<const Triple<double>> places,
                   const Triple<double>& home_m, AtLimits& at) {
  const auto from_home_m = [&](std::size_t i) {
    return std::hypot(places[i].x - home_m.x, places[i].y - home_m.y);
  };
  const auto is_out = [&](std::size_t i) { return from_home_m(i) > *at.fence_m; };
  const auto is_in = [&](std::size_t i) { return from_home_m(i) <= *at.fence_m; };
  at.fence_breaches = track.times(is_out, is_in);
  at.outside_fence_s = track.seconds(is_out);
  at.near_fence_s = track.seconds(
      [&](std::size_t i) { return is_in(i) && from_home_m(i) >= (1 - near_share) * *at.fence_m; });
}

std::optional<double> stand_off_of(const twin::ScenarioVehicle& vehicle,
                                   const twin::Scenario& scenario) {
  if (vehicle.conduct && vehicle.conduct->envelope.stand_off_m > 0)
    return vehicle.conduct->envelope.stand_off_m;
  if (scenario.clearance && vehicle.keeps_clear) return scenario.clearance->structure_m;
  return std::nullopt;
}

}  // namespace

std::optional<AtLimits> at_limits_in(const ingest::TrajectoryFile& log, std::size_t vehicle,
                                     const twin::VehicleAccount& account,
                                     const twin::Scenario* scenario,
                                     std::span<const Stretch> stretches) {
  if (scenario == nullptr) return std::nullopt;
  const auto plan =
      std::find_if(scenario->vehicles.begin(), scenario->vehicles.end(),
                   [&](const twin::ScenarioVehicle& one) { return one.name == account.name; });
  if (plan == scenario->vehicles.end()) return std::nullopt;
  AtLimits at;
  const twin::VehicleRows rows = rows_of(log, vehicle);
  const Track track{log.t_s, stretches};
  const std::vector<Triple<double>> places = places_of(rows);
  if (!scenario->structures.empty()) {
    at.stand_off_m = stand_off_of(*plan, *scenario);
    look_at_stand_off(track, distances_of(places, scenario->structures), at);
  }
  if (plan->conduct) {
    const twin::Conduct& conduct = *plan->conduct;
    const bool has_home = conduct.home_m.has_value() || !plan->starts_on_track;
    if (conduct.envelope.fence_m && has_home) {
      at.fence_m = conduct.envelope.fence_m;
      look_at_fence(track, places, conduct.home_m.value_or(plan->start_m), at);
    }
    const auto charge = rows.column("state_of_charge");
    if (account.makeup.has_battery && !charge.empty()) {
      at.reserve_share = conduct.reserve.share;
      at.below_reserve_s =
          track.seconds([&](std::size_t i) { return charge[i] < conduct.reserve.share; });
    }
  }
  for (const twin::MissionEvent& event : account.mission)
    if (event.cause == twin::Cause::limit && is_within(stretches, event.t_s) &&
        (event.kind == twin::ConductEventKind::hold_began ||
         event.kind == twin::ConductEventKind::turned_for_home))
      ++at.limits_broken;
  if (account.halt != twin::Halt::none && is_within(stretches, account.halted_at_s))
    at.stopped_by = twin::name_of(account.halt);
  return at;
}

}  // namespace slackwater::api
