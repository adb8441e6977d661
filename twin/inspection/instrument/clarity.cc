#include "twin/inspection/instrument/clarity.h"

#include <cmath>
#include <string>
#include <string_view>

namespace slackwater::twin {
namespace {

void refuse_turbidity(const Config& c) {
  for (const std::string_view key : {"turbidity", "turbidity_ntu", "turbidity_fnu"})
    if (c.has(key))
      c.refuse(key,
               "turbidity cannot be turned into attenuation without measurements of that water; "
               "give beam_attenuation_per_m, or visibility_m of a black disc");
  for (const std::string_view key : {"beam_attenuation", "visibility", "diffuse_attenuation"})
    if (c.has(key)) {
      const bool is_range = key == "visibility";
      c.refuse(key, "has no unit; write " + std::string(key) + (is_range ? "_m" : "_per_m"));
    }
}

}  // namespace

double beam_attenuation_of_water(double black_disc_visibility_m) noexcept {
  return 4.8 / black_disc_visibility_m;
}

double beam_attenuation_of_air(double optical_range_m) noexcept {
  return -std::log(0.05) / optical_range_m;
}

double transmission(double beam_attenuation_per_m, double range_m) noexcept {
  return std::exp(-beam_attenuation_per_m * range_m);
}

Clarity read_clarity(const Config& c) {
  refuse_turbidity(c);
  const auto beam = c.optional_number("beam_attenuation_per_m", {0, 50});
  const auto visibility = c.optional_number("visibility_m", {0.05, 200});
  if (beam.has_value() == visibility.has_value())
    c.refuse("beam_attenuation_per_m",
             "give one of beam_attenuation_per_m and visibility_m, the distance at which a black "
             "disc is lost from sight");
  Clarity clarity;
  clarity.beam_attenuation_per_m = beam ? *beam : beam_attenuation_of_water(*visibility);
  clarity.daylight = c.optional_number("daylight", {0, 1}).value_or(1);
  clarity.diffuse_attenuation_per_m = c.optional_number("diffuse_attenuation_per_m", {0, 50})
                                          .value_or(clarity.beam_attenuation_per_m / 4);
  c.expect_all_read();
  return clarity;
}

}  // namespace slackwater::twin
