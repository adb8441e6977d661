#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "twin/inspection/surface/block.h"
#include "twin/inspection/surface/read_shape.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {

Surface make_nacelle(const Config& config, double patch_m) {
  constexpr double degree = constants::pi / 180;
  constexpr double gap_m = 0.5;  // between parts on the sheet
  const Triple<double> hub_m = read_point(config);
  const double faces_rad = config.number("rotor_faces_deg", {-360, 360}) * degree;
  const double long_m = length_or(config, "length_m", usual::nacelle_length_m);
  const double wide_m = length_or(config, "width_m", usual::nacelle_width_m);
  const double tall_m = length_or(config, "tall_m", usual::nacelle_height_m);
  const double ahead_m = length_or(config, "ahead_m", usual::nacelle_ahead_m, {-100, 100});
  const double rise_m = length_or(
      config, "roof_rise_m", std::min(usual::nacelle_roof_rise_m, 0.2 * wide_m), {0, 0.5 * wide_m});
  const Triple<double> ahead{std::cos(faces_rad), std::sin(faces_rad), 0};
  const Triple<double> right{-std::sin(faces_rad), std::cos(faces_rad), 0};
  Block block;
  block.size_m = {long_m, wide_m, tall_m};
  const auto box = box_at(hub_m + (ahead_m - 0.5 * long_m) * ahead, ahead, right, block.size_m);
  // The roof is a parabola across, and what is below it is stretched.
  block.at = [=](double u, double v, double w) {
    Triple<double> at = box(u, v, w);
    at.z -= rise_m * (1 - v * v) * 0.5 * (1 - w);
    return at;
  };
  block.patch_m = patch_m;
  // Left side, roof, right side and floor hang together; front and back to the right of them.
  const double sides_m = 3 * gap_m;
  block.faces[3] = FaceSheet{0, 0};
  block.faces[5] = FaceSheet{0, tall_m + gap_m};
  block.faces[2] = FaceSheet{0, tall_m + wide_m + 2 * gap_m};
  block.faces[4] = FaceSheet{0, 2 * tall_m + wide_m + sides_m};
  const double beside_m = std::max(long_m, wide_m) + gap_m;
  block.faces[0] = FaceSheet{beside_m, 0};
  block.faces[1] = FaceSheet{beside_m, tall_m + gap_m};
  SurfaceBuilder builder(hub_m);
  add_block(builder, block);
  Sheet sheet;
  sheet.width_m = beside_m + wide_m;
  sheet.height_m = 2 * tall_m + 2 * wide_m + sides_m;
  sheet.along = "along each face: left side, roof, right side, floor; beside: front, back";
  sheet.down = "down each face";
  sheet.top_z_m = hub_m.z - 0.5 * tall_m;
  return builder.finish(SurfaceKind::nacelle, sheet);
}

}  // namespace slackwater::twin
