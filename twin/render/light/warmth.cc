#include "twin/render/light/warmth.h"

#include "twin/curve/named_file.h"

namespace slackwater::twin {
namespace {

constexpr double zero_celsius_k = 273.15;

double kelvin_of(const Config& c, const char* key, Range celsius) {
  return zero_celsius_k + c.number(key, celsius);
}

}  // namespace

Warmth read_warmth(const Config& config) {
  Warmth warmth;
  warmth.name = config.text("name");
  warmth.source = config.text("source");
  warmth.status = config.text("status");
  warmth.air_k = kelvin_of(config, "air_c", {-40, 55});
  warmth.sky_overhead_k = kelvin_of(config, "sky_overhead_c", {-100, 40});
  warmth.cloud_k = kelvin_of(config, "cloud_c", {-60, 40});
  if (warmth.sky_overhead_k > warmth.air_k)
    config.refuse("sky_overhead_c", "is warmer than air_c; the air radiates what the sky does");
  warmth.attenuation_per_m = config.number("attenuation_per_km", {0, 100}) / 1000;
  const Config surfaces = config.child("surfaces");
  for (std::size_t i = 1; i < materials; ++i) {
    const Config one = surfaces.child(name_of(static_cast<Material>(i)));
    warmth.surfaces[i].temperature_k = kelvin_of(one, "temperature_c", {-60, 150});
    warmth.surfaces[i].in_sun_k = one.optional_number("in_sun_k", {0, 100}).value_or(0);
    warmth.surfaces[i].emissivity = one.number("emissivity", {0.02, 1});
  }
  warmth.surfaces[0] = {warmth.air_k, 0, 1};  // of no material: as a black body as warm as the air
  config.expect_all_read();
  return warmth;
}

Warmth read_named_warmth(const std::string& name, const std::filesystem::path& data_folder) {
  return read_warmth(open_named(name, "warmth", data_folder / "warmth"));
}

}  // namespace slackwater::twin
