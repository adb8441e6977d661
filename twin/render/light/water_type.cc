#include "twin/render/light/water_type.h"

#include <algorithm>

#include "twin/curve/named_file.h"

namespace slackwater::twin {

WaterType read_water_type(const Config& config) {
  WaterType type;
  type.name = config.text("name");
  type.source = config.text("source");
  type.status = config.text("status");
  const Config k = config.child("diffuse_attenuation_per_m");
  // Pure water takes 0.2 of red light and some thousandths of blue; nothing is clearer.
  type.diffuse_attenuation_per_m = {k.number("red_600_nm", {0.15, 20}),
                                    k.number("green_550_nm", {0.04, 20}),
                                    k.number("blue_450_nm", {0.01, 20})};
  config.expect_all_read();
  return type;
}

WaterType read_named_water_type(const std::string& name, const std::filesystem::path& data_folder) {
  return read_water_type(open_named(name, "water type", data_folder / "waters"));
}

ColouredClarity coloured(const Clarity& clarity, const WaterType& type) noexcept {
  constexpr double mean_cosine = 0.83;
  ColouredClarity out;
  out.backscatter_per_m = clarity.backscatter_per_m;
  out.daylight = clarity.daylight;
  for (std::size_t i = 0; i < out.beam_attenuation_per_m.size(); ++i) {
    const double shape = type.diffuse_attenuation_per_m[i] / type.diffuse_attenuation_per_m[green];
    out.diffuse_attenuation_per_m[i] = clarity.diffuse_attenuation_per_m * shape;
    out.beam_attenuation_per_m[i] =
        std::max(clarity.backscatter_per_m,
                 clarity.beam_attenuation_per_m +
                     mean_cosine * clarity.diffuse_attenuation_per_m * (shape - 1));
  }
  return out;
}

ColouredClarity colourless(const Clarity& clarity) noexcept {
  const double c = clarity.beam_attenuation_per_m;
  return {{c, c, c}, {0, 0, 0}, clarity.backscatter_per_m, clarity.daylight};
}

}  // namespace slackwater::twin
