#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/local_time.h"
#include "fields/base/step_clock.h"
#include "fields/geo/geo_point.h"
#include "twin/risk/workability/step_range.h"

namespace slackwater::twin {

/// What counts as light enough, by the elevation of the sun's centre without refraction.
enum class Light {
  sun_up,  ///< the upper limb is above the horizon: -0.833 degrees (34' of refraction, 16' of disc)
  civil,   ///< one can work out of doors without lamps: -6
  nautical,  ///< the horizon can be seen at sea: -12
};
[[nodiscard]] double least_elevation_deg(Light light) noexcept;
/// "sun_up", "civil", "nautical".
[[nodiscard]] std::string_view name_of(Light light) noexcept;
/// @throws Error(invalid_input) for another word
[[nodiscard]] Light parse_light(std::string_view text);

/// The light of one day. Beyond the polar circles there are days without its beginning or end.
struct DayOfLight {
  enum class Kind {
    comes_and_goes,
    always,  ///< polar day, or a night of twilight
    never,   ///< polar night
  };
  Kind kind = Kind::comes_and_goes;
  std::optional<UtcTime> begin;  ///< where it comes: within the twelve hours before noon
  std::optional<UtcTime> end;    ///< where it goes: within the twelve hours after
  UtcTime noon{};                ///< when the sun stands highest, to the minute
};

/// The light about the noon of a day, to a few seconds, but for days when the sun only just touches
/// the threshold.
/// @param day   of the zone's calendar; absent zone: the day whose mean noon at the place's
///              longitude it holds, in UTC
/// Throws nothing but what the zone does.
[[nodiscard]] DayOfLight light_of(const GeoPoint& point, UtcDay day, Light light,
                                  const std::optional<TimeZone>& zone);

/// "05:12 to 21:40 CEST", "light all day", "dark all day".
[[nodiscard]] std::string text_of(const DayOfLight& day, const std::optional<TimeZone>& zone);

/// The steps that are light from their beginning to their end.
[[nodiscard]] StepRanges light_steps(const StepClock& clock, const GeoPoint& point, Light light);

}  // namespace slackwater::twin
