#include "api/door/people/ground.h"

#include <algorithm>
#include <cmath>

#include "api/door/people/rounded.h"

namespace slackwater::people {
namespace {

using nlohmann::json;

constexpr std::size_t across = 41;
constexpr double least_half_m = 200, most_half_m = 10'000, margin_m = 200;

json triple_json(const twin::Triple<double>& ned_m) {
  return {rounded(ned_m.y, 0.01), rounded(ned_m.x, 0.01), rounded(-ned_m.z, 0.01)};
}

/// Half the width of a square about the origin that has all that stands, lies and goes there.
double half_m(const RunPlace& place, std::span<const Horizontal> vehicles_m) {
  double farthest_m = 0;
  const auto reach = [&](double east_m, double north_m) {
    farthest_m = std::max({farthest_m, std::abs(east_m), std::abs(north_m)});
  };
  for (const Horizontal at_m : vehicles_m) reach(at_m.real(), at_m.imag());
  if (const auto& turbines = place.sampler.environment().turbines)
    for (const Horizontal at_m : turbines->at_m) reach(at_m.real(), at_m.imag());
  for (const twin::MooringLine& line : place.water.lines.moorings)
    reach(line.anchor_m.y, line.anchor_m.x);
  return std::clamp(farthest_m + margin_m, least_half_m, most_half_m);
}

std::optional<double> bed_up_m(const twin::EnvironmentSampler& water, double east_m,
                               double north_m) {
  const BedSample bed = water.bed({north_m, east_m, 0});
  if (bed.status != SampleStatus::ok) return std::nullopt;
  return -bed.water_depth_m;
}

}  // namespace

json bed_json(const RunPlace& place, std::span<const Horizontal> vehicles_m) {
  const double half = half_m(place, vehicles_m), step_m = 2 * half / (across - 1);
  json up_m = json::array();
  bool is_known = false;
  for (std::size_t row = 0; row < across; ++row)
    for (std::size_t column = 0; column < across; ++column) {
      const auto bed = bed_up_m(place.sampler, -half + step_m * static_cast<double>(column),
                                -half + step_m * static_cast<double>(row));
      up_m.push_back(bed ? rounded(*bed, 0.01) : json(nullptr));
      is_known = is_known || bed;
    }
  if (!is_known) return nullptr;
  return {{"east_m", -half},
          {"north_m", -half},
          {"step_m", step_m},
          {"across", across},
          {"up_m", up_m}};
}

json cables_json(const RunPlace& place) {
  json cables = json::array();
  for (const twin::WorkCable& cable : place.water.lines.cables) {
    json route = json::array();
    for (twin::Triple<double> at_m : cable.route_m) {
      at_m.z = -bed_up_m(place.sampler, at_m.y, at_m.x).value_or(-at_m.z);
      if (std::isfinite(at_m.z)) route.push_back(triple_json(at_m));
    }
    if (route.size() < 2) continue;  // nobody knows how deep it lies
    cables.push_back({{"id", cable.id},
                      {"route", route},
                      {"burial_m", cable.burial_m ? json(*cable.burial_m) : json(nullptr)}});
  }
  return cables;
}

json moorings_json(const twin::SiteLines& lines) {
  json moorings = json::array();
  for (const twin::MooringLine& line : lines.moorings)
    moorings.push_back({{"id", line.id},
                        {"fairlead", triple_json(line.fairlead_m)},
                        {"anchor", triple_json(line.anchor_m)}});
  return moorings;
}

}  // namespace slackwater::people
