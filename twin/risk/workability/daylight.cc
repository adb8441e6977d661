#include "twin/risk/workability/daylight.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "twin/risk/workability/sun_position.h"

namespace slackwater::twin {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

double elevation(const GeoPoint& point, UtcTime time) noexcept {
  return sun_position(point, time).elevation_deg;
}

/// When the sun stands highest within `reach` of a time; with sign -1, lowest. Elevation rises and
/// falls once within half a day either way.
UtcTime highest(const GeoPoint& point, UtcTime about, Duration reach, double sign) {
  UtcTime low = about - reach;
  UtcTime high = about + reach;
  while (high - low > std::chrono::seconds(2)) {
    const Duration third = (high - low) / 3;
    if (sign * elevation(point, low + third) < sign * elevation(point, high - third))
      low += third;
    else
      high -= third;
  }
  return low + (high - low) / 2;
}

/// When the sun passes an elevation between two times at which it is below and above it, or above
/// and below.
UtcTime passing(const GeoPoint& point, UtcTime from, UtcTime to, double threshold_deg) {
  const bool is_above_first = elevation(point, from) >= threshold_deg;
  while (to - from > std::chrono::milliseconds(500)) {
    const UtcTime middle = from + (to - from) / 2;
    ((elevation(point, middle) >= threshold_deg) == is_above_first ? from : to) = middle;
  }
  return from + (to - from) / 2;
}

/// The mean noon of a day: 12:00 by the sun of the place, near 12:00 of the zone.
UtcTime mean_noon(const GeoPoint& point, UtcDay day, const std::optional<TimeZone>& zone) {
  const auto by_the_sun =
      Duration(static_cast<Duration::rep>(point.longitude_deg() / 15 * 3'600'000));
  if (!zone) return UtcTime(day) + hours(12) - by_the_sun;
  const UtcTime clock_noon = UtcTime(day) + hours(12) - zone->offset_at(UtcTime(day) + hours(12));
  // Of the noons by the sun, a day apart, the one nearest to noon by the clock.
  const Duration off = clock_noon - (UtcTime(day) + hours(12) - by_the_sun);
  return clock_noon - off + hours(24) * std::lround(static_cast<double>(off.count()) / 86'400'000);
}

}  // namespace

double least_elevation_deg(Light light) noexcept {
  switch (light) {
    case Light::sun_up:
      return -50.0 / 60;
    case Light::civil:
      return -6;
    case Light::nautical:
      return -12;
  }
  return 0;
}

std::string_view name_of(Light light) noexcept {
  switch (light) {
    case Light::sun_up:
      return "sun_up";
    case Light::civil:
      return "civil";
    case Light::nautical:
      return "nautical";
  }
  return "";
}

Light parse_light(std::string_view text) {
  for (const Light light : {Light::sun_up, Light::civil, Light::nautical})
    if (text == name_of(light)) return light;
  throw Error(ErrorKind::invalid_input, "found '" + std::string(text) +
                                            "' where a kind of daylight was expected: sun_up, "
                                            "civil or nautical");
}

DayOfLight light_of(const GeoPoint& point, UtcDay day, Light light,
                    const std::optional<TimeZone>& zone) {
  const double threshold_deg = least_elevation_deg(light);
  const UtcTime about = mean_noon(point, day, zone);
  DayOfLight found;
  // The sun is at most 17 minutes early or late by the mean one; near the poles its height changes
  // with the date more than with the hour.
  found.noon = highest(point, about, hours(2), 1);
  const UtcTime before = highest(point, found.noon - hours(12), hours(2), -1);
  const UtcTime after = highest(point, found.noon + hours(12), hours(2), -1);
  const bool is_light_at_noon = elevation(point, found.noon) >= threshold_deg;
  if (!is_light_at_noon) {
    found.kind = DayOfLight::Kind::never;
    return found;
  }
  if (elevation(point, before) < threshold_deg)
    found.begin = passing(point, before, found.noon, threshold_deg);
  if (elevation(point, after) < threshold_deg)
    found.end = passing(point, found.noon, after, threshold_deg);
  if (!found.begin && !found.end) found.kind = DayOfLight::Kind::always;
  return found;
}

std::string text_of(const DayOfLight& day, const std::optional<TimeZone>& zone) {
  if (day.kind == DayOfLight::Kind::always) return "light all day";
  if (day.kind == DayOfLight::Kind::never) return "dark all day";
  const auto clock = [&](const std::optional<UtcTime>& time) -> std::string {
    if (!time) return "the night";
    const UtcTime local =
        std::chrono::round<minutes>(*time) + (zone ? zone->offset_at(*time) : minutes(0));
    return format_utc(local).substr(11, 5);
  };
  return clock(day.begin) + " to " + clock(day.end) + " " +
         (zone ? zone->abbreviation_at(day.noon) : "UTC");
}

StepRanges light_steps(const StepClock& clock, const GeoPoint& point, Light light) {
  const double threshold_deg = least_elevation_deg(light);
  StepRanges ranges;
  bool was_light = clock.steps > 0 && elevation(point, clock.first) >= threshold_deg;
  for (std::size_t i = 0; i < clock.steps; ++i) {
    // In between the sun is no lower than at both ends, but about its lowest: the middle tells.
    const bool is_light = elevation(point, clock.time_of(i + 1)) >= threshold_deg;
    if (was_light && is_light &&
        elevation(point, clock.time_of(i) + clock.step / 2) >= threshold_deg) {
      if (!ranges.empty() && ranges.back().end == i)
        ++ranges.back().end;
      else
        ranges.push_back({i, i + 1});
    }
    was_light = is_light;
  }
  return ranges;
}

}  // namespace slackwater::twin
