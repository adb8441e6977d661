#include "api/door/cli/run/clearance_print.h"

#include <cstdio>

#include "api/show/rehearse/account_text.h"
#include "api/show/rehearse/run_clock.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// "closest to a vehicle 3.2 m (guard, 06:12:10Z), a structure 12.0 m (pile, 06:10:00Z)".
std::string closest_text(const twin::Closest& closest, UtcTime start) {
  std::vector<std::string> parts;
  const auto add = [&](const char* what, const std::optional<twin::Approach>& near) {
    if (near)
      parts.push_back(formatted("{} {:.1f} m ({}, {}Z)", what, near->distance_m, name_of(*near),
                                time_of_day(start, near->t_s)));
  };
  add("a vehicle", closest.vehicle);
  add("a structure", closest.structure);
  add("a vessel", closest.vessel);
  add("a tether", closest.tether);
  return parts.empty() ? std::string() : "closest to " + joined(parts, ", ");
}

}  // namespace

void print_clearance(const twin::RunAccount& account) {
  for (const twin::VehicleAccount& vehicle : account.vehicles) {
    std::vector<std::string> parts;
    if (std::string text = closest_text(vehicle.closest, account.start); !text.empty())
      parts.push_back(std::move(text));
    if (vehicle.clearance) {
      parts.push_back("clearance alarms: " + alarms_text(*vehicle.clearance));
      if (vehicle.clearance->changed_s > 0)
        parts.push_back(formatted("made to keep clear for {:.0f} s", vehicle.clearance->changed_s));
    }
    if (!parts.empty()) std::printf("%s: %s\n", vehicle.name.c_str(), joined(parts, "; ").c_str());
  }
}

}  // namespace slackwater::api
