#include "api/door/edr/read/distance.h"

#include <algorithm>
#include <array>
#include <string>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/number.h"

namespace slackwater::api::edr {
namespace {

constexpr std::size_t most_bytes = 64;
/// Half the circumference of the earth, rounded up.
constexpr double max_distance_m = 20'040'000;

struct Unit {
  std::string_view name;
  double metres;
};

/// International mile, foot and yard (1959); nautical mile (1929).
constexpr std::array units_known{Unit{"m", 1.0},
                                 Unit{"metre", 1.0},
                                 Unit{"metres", 1.0},
                                 Unit{"meter", 1.0},
                                 Unit{"meters", 1.0},
                                 Unit{"km", 1000.0},
                                 Unit{"kilometre", 1e3},
                                 Unit{"kilometres", 1e3},
                                 Unit{"kilometer", 1e3},
                                 Unit{"kilometers", 1e3},
                                 Unit{"mi", 1609.344},
                                 Unit{"mile", 1609.344},
                                 Unit{"miles", 1609.344},
                                 Unit{"nmi", 1852.0},
                                 Unit{"nm", 1852.0},
                                 Unit{"nautical mile", 1852.0},
                                 Unit{"nautical miles", 1852.0},
                                 Unit{"ft", 0.3048},
                                 Unit{"foot", 0.3048},
                                 Unit{"feet", 0.3048},
                                 Unit{"yd", 0.9144},
                                 Unit{"yard", 0.9144},
                                 Unit{"yards", 0.9144}};

constexpr std::array<std::string_view, 6> offered{"m", "km", "mi", "nmi", "ft", "yd"};

char lower_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

double metres_of(std::string_view parameter, std::string_view units) {
  std::string name(units);
  std::transform(name.begin(), name.end(), name.begin(), lower_letter);
  const auto found = std::find_if(units_known.begin(), units_known.end(),
                                  [&](const Unit& unit) { return unit.name == name; });
  if (found == units_known.end()) {
    throw bad_parameter(parameter, units, "one of m, km, mi, nmi, ft, yd");
  }
  return found->metres;
}

}  // namespace

std::span<const std::string_view> distance_units() noexcept { return offered; }

double parse_distance_m(std::string_view parameter, std::string_view value,
                        std::string_view units_parameter, std::string_view units) {
  expect_short(parameter, value, most_bytes);
  expect_short(units_parameter, units, most_bytes);
  const double metres = metres_of(units_parameter, units);
  const auto number = number_of(value);
  if (!number || !(*number > 0)) {
    throw bad_parameter(
        parameter, value,
        "a number greater than 0, such as 10 (with " + std::string(units_parameter) + "=km)");
  }
  const double distance_m = *number * metres;
  if (!(distance_m <= max_distance_m)) {
    throw bad_parameter(parameter, value, "at most 20040 km, half the way round the globe");
  }
  return distance_m;
}

}  // namespace slackwater::api::edr
