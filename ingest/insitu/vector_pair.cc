#include "ingest/insitu/vector_pair.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/frame.h"

namespace slackwater::ingest {
namespace {

constexpr std::array pairs{
    VectorPair{"sea_water_speed", "sea_water_velocity_to_direction", false,
               "eastward_sea_water_velocity", "northward_sea_water_velocity"},
    // The name before CF standard name table 45; it too is where the water goes to.
    VectorPair{"sea_water_speed", "direction_of_sea_water_velocity", false,
               "eastward_sea_water_velocity", "northward_sea_water_velocity"},
    VectorPair{"sea_water_speed", "sea_water_velocity_from_direction", true,
               "eastward_sea_water_velocity", "northward_sea_water_velocity"},
    VectorPair{"wind_speed", "wind_from_direction", true, "eastward_wind", "northward_wind"},
    VectorPair{"wind_speed", "wind_to_direction", false, "eastward_wind", "northward_wind"},
};

/// Bad beats missing beats unchecked beats good: what is known to be bad stays known.
SampleStatus worse(SampleStatus a, SampleStatus b) {
  for (const SampleStatus s :
       {SampleStatus::suspect, SampleStatus::missing, SampleStatus::not_checked}) {
    if (a == s || b == s) return s;
  }
  return SampleStatus::ok;
}

}  // namespace

const VectorPair* vector_pair_of(std::string_view speed, std::string_view direction) noexcept {
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const VectorPair& pair) {
    return pair.speed == speed && pair.direction == direction;
  });
  return found == pairs.end() ? nullptr : &*found;
}

bool is_vector_speed(std::string_view name) noexcept {
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const VectorPair& pair) { return pair.speed == name; });
}

bool is_vector_direction(std::string_view name) noexcept {
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const VectorPair& pair) { return pair.direction == name; });
}

Components components_of(const VectorPair& pair, const SeriesValues& speed,
                         const SeriesValues& direction) {
  expects(speed.values.size() == direction.values.size(), "a direction for each speed");
  Components out{speed, speed};
  out.east.standard_name = pair.eastward;
  out.north.standard_name = pair.northward;
  out.east.source_name = out.north.source_name = speed.source_name + ", " + direction.source_name;
  for (std::size_t i = 0; i < speed.values.size(); ++i) {
    const double magnitude = speed.values[i];
    const double degrees = direction.values[i];
    SampleStatus status = worse(speed.status[i], direction.status[i]);
    Horizontal vector{constants::nan, constants::nan};
    if (magnitude == 0.0 && has_value(speed.status[i])) {
      status = speed.status[i];
      vector = {0.0, 0.0};
    } else if (magnitude < 0.0 || (!std::isnan(magnitude) && !std::isnan(degrees) &&
                                   (degrees < 0.0 || degrees > 360.0))) {
      status = SampleStatus::suspect;
    } else {
      vector = pair.from ? vector_from_direction(magnitude, degrees)
                         : vector_to_direction(magnitude, degrees);
    }
    out.east.values[i] = static_cast<float>(vector.real());
    out.north.values[i] = static_cast<float>(vector.imag());
    out.east.status[i] = out.north.status[i] = status;
  }
  return out;
}

}  // namespace slackwater::ingest
