#include "twin/inspection/instrument/clarity.h"

#include <cmath>
#include <string>
#include <string_view>

#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr double usual_diffuse = 0.25;       // of the beam attenuation
constexpr double usual_backscatter = 0.015;  // of the beam attenuation

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
  return -std::log(black_disc_contrast) / black_disc_visibility_m;
}

double beam_attenuation_of_air(double optical_range_m) noexcept {
  return -std::log(0.05) / optical_range_m;
}

Clarity seen_through(const Clarity& own, double visibility_m, Medium medium) noexcept {
  Clarity clarity = own;
  clarity.beam_attenuation_per_m = medium == Medium::water ? beam_attenuation_of_water(visibility_m)
                                                           : beam_attenuation_of_air(visibility_m);
  clarity.diffuse_attenuation_per_m = usual_diffuse * clarity.beam_attenuation_per_m;
  clarity.backscatter_per_m = usual_backscatter * clarity.beam_attenuation_per_m;
  return clarity;
}

double transmission(double beam_attenuation_per_m, double range_m) noexcept {
  return std::exp(-beam_attenuation_per_m * range_m);
}

Clarity read_clarity(const Config& c, Medium medium) {
  refuse_turbidity(c);
  const auto beam = c.optional_number("beam_attenuation_per_m", {0, 50});
  const auto visibility =
      c.optional_number("visibility_m", medium == Medium::water ? Range{0.05, 200} : Range{1, 1e6});
  if (beam.has_value() == visibility.has_value())
    c.refuse("beam_attenuation_per_m",
             std::string("give one of beam_attenuation_per_m and visibility_m, ") +
                 (medium == Medium::water ? "the distance at which a black disc is lost from sight"
                                          : "the meteorological optical range"));
  Clarity clarity;
  clarity.beam_attenuation_per_m = beam ? *beam
                                   : medium == Medium::water
                                       ? beam_attenuation_of_water(*visibility)
                                       : beam_attenuation_of_air(*visibility);
  clarity.daylight = c.optional_number("daylight", {0, 1000}).value_or(1);
  clarity.diffuse_attenuation_per_m = c.optional_number("diffuse_attenuation_per_m", {0, 50})
                                          .value_or(usual_diffuse * clarity.beam_attenuation_per_m);
  clarity.backscatter_per_m = c.optional_number("backscatter_per_m", {0, 50})
                                  .value_or(usual_backscatter * clarity.beam_attenuation_per_m);
  if (clarity.backscatter_per_m > clarity.beam_attenuation_per_m)
    c.refuse("backscatter_per_m",
             formatted("found {:g}, expected at most the beam attenuation, {:g}: what is scattered "
                       "back is part of it",
                       clarity.backscatter_per_m, clarity.beam_attenuation_per_m));
  c.expect_all_read();
  return clarity;
}

}  // namespace slackwater::twin
