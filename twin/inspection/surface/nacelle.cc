#include <algorithm>
#include <cmath>

#include "twin/inspection/surface/block.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {

Surface make(const NacelleSizes& sizes, double patch_m) {
  constexpr double gap_m = 0.5;  // between parts on the sheet
  const Triple<double>& hub_m = sizes.hub_m;
  const double faces_rad = sizes.rotor_faces_rad;
  const double long_m = sizes.length_m.value_or(usual::nacelle_length_m);
  const double wide_m = sizes.width_m.value_or(usual::nacelle_width_m);
  const double tall_m = sizes.tall_m.value_or(usual::nacelle_height_m);
  const double ahead_m = sizes.ahead_m.value_or(usual::nacelle_ahead_m);
  const double rise_m =
      sizes.roof_rise_m.value_or(std::min(usual::nacelle_roof_rise_m, 0.2 * wide_m));
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
  // Roof and floor, beside them the sides one above the other, and below those front and back.
  const double floor_m = wide_m + gap_m, sides_m = 2 * floor_m, row_m = tall_m + gap_m;
  block.faces[5] = FaceSheet{0, 0};
  block.faces[4] = FaceSheet{floor_m, 0};
  block.faces[3] = FaceSheet{sides_m, 0};
  block.faces[2] = FaceSheet{sides_m, row_m};
  block.faces[0] = FaceSheet{sides_m, 2 * row_m};
  block.faces[1] = FaceSheet{sides_m + floor_m, 2 * row_m};
  SurfaceBuilder builder(hub_m);
  add_block(builder, block);
  Sheet sheet;
  sheet.width_m = sides_m + std::max(long_m, wide_m + floor_m);
  sheet.height_m = std::max(long_m, 2 * row_m + tall_m);
  sheet.along = "faces as seen from outside: roof, floor, then the left side";
  sheet.down = "down each face; below the left side: right side, front and back";
  return builder.finish(SurfaceKind::nacelle, sheet);
}

}  // namespace slackwater::twin
