#include "fields/base/local_time.h"

#include <date/tz.h>

#include <algorithm>

#include "fields/base/advice.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater {
namespace {

const date::time_zone& zone_of(const void* zone) {
  return *static_cast<const date::time_zone*>(zone);
}

/// What holds at an instant, as if it had just begun. Offsets of the distant past have seconds,
/// those of our times have none.
ClockChange clock_at(const void* zone, UtcTime time) {
  const date::sys_info info =
      zone_of(zone).get_info(std::chrono::floor<std::chrono::seconds>(time));
  return {time, std::chrono::floor<std::chrono::minutes>(info.offset), info.abbrev};
}

std::vector<std::string> known_zones() {
  std::vector<std::string> names;
  for (const date::time_zone& zone : date::get_tzdb().zones) names.push_back(zone.name());
  return names;
}

/// The zone whose last word this is: "Paris" is meant as Europe/Paris; else the nearest name.
std::string advice_on_zone(const std::string& name, const std::vector<std::string>& known) {
  for (const std::string& zone : known) {
    const auto slash = zone.rfind('/');
    if (slash != std::string::npos && lower_case(zone.substr(slash + 1)) == lower_case(name))
      return " (did you mean '" + zone + "'?)";
  }
  return did_you_mean(name, known);
}

}  // namespace

TimeZone TimeZone::named(std::string_view iana_name) {
  const std::string name(iana_name);
  std::vector<std::string> known;
  try {
    known = known_zones();
  } catch (const std::exception& problem) {
    throw Error(ErrorKind::unavailable, std::string("the system's time zones cannot be read (") +
                                            problem.what() + "); install the package tzdata");
  }
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw Error(ErrorKind::invalid_input,
                "found no time zone '" + name + "'" + advice_on_zone(name, known) +
                    "; expected a name of the IANA database, as Europe/Paris or America/New_York");
  }
  return {name, date::locate_zone(name)};
}

std::chrono::minutes TimeZone::offset_at(UtcTime time) const {
  return clock_at(zone_, time).offset;
}

std::string TimeZone::abbreviation_at(UtcTime time) const { return clock_at(zone_, time).name; }

std::string TimeZone::text(UtcTime time) const {
  const ClockChange clock = clock_at(zone_, time);
  const std::string local =
      format_utc(std::chrono::round<std::chrono::minutes>(time) + clock.offset);
  return local.substr(0, 10) + " " + local.substr(11, 5) + " " + clock.name;
}

std::vector<ClockChange> TimeZone::changes(UtcTime from, UtcTime to) const {
  std::vector<ClockChange> found{clock_at(zone_, from)};
  while (true) {
    const date::sys_info info =
        zone_of(zone_).get_info(std::chrono::floor<std::chrono::seconds>(found.back().at));
    if (info.end > std::chrono::floor<std::chrono::seconds>(to)) return found;
    found.push_back(clock_at(zone_, std::chrono::time_point_cast<Duration>(info.end)));
  }
}

}  // namespace slackwater
