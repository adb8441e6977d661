#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/block.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {

Surface make(const AnodesSizes& sizes, double patch_m) {
  constexpr double gap_m = 0.2;  // between bars on the sheet
  const Upright& upright = sizes.upright;
  expect_goes_down(upright);
  const double pile_m = sizes.radius_m;
  const int bars = sizes.bars.value_or(usual::anode_bars);
  const int rows = sizes.rows.value_or(usual::anode_rows);
  const double first_rad = sizes.first_bearing_rad.value_or(0);
  const double length_m = sizes.length_m.value_or(usual::anode_length_m);
  const double width_m = sizes.width_m.value_or(usual::anode_width_m);
  const double off_m = sizes.off_m.value_or(usual::anode_off_m);
  if (off_m < 0.5 * width_m)
    throw Unmakeable{"off_m", formatted("{:g} m from the pile to the middle of bars of {:g} m puts "
                                        "them into it; give at least half their width",
                                        off_m, width_m)};
  const double apart_m = (upright.bottom_m - upright.top_m) / (rows + 1);
  if (apart_m < length_m && rows > 1)
    throw Unmakeable{"rows", formatted("are {:g} m apart, and the bars {:g} m long; take fewer, or "
                                       "a longer way from `from` to `to`",
                                       apart_m, length_m)};
  if (bars * width_m > 2 * constants::pi * (pile_m + off_m))
    throw Unmakeable{
        "bars", formatted("{} of {:g} m do not fit round the pile; take fewer", bars, width_m)};
  SurfaceBuilder builder({upright.north_m, upright.east_m, upright.top_m});
  for (int row = 0; row < rows; ++row)
    for (int bar = 0; bar < bars; ++bar) {
      const double bearing = first_rad + 2 * constants::pi * bar / bars;
      const Triple<double> out{std::cos(bearing), std::sin(bearing), 0};
      Triple<double> middle_m =
          Triple<double>{upright.north_m, upright.east_m, 0} + (pile_m + off_m) * out;
      middle_m.z = upright.top_m + (row + 1) * apart_m;
      Block block;
      block.size_m = {width_m, width_m, length_m};
      block.at = box_at(middle_m, out, {-out.y, out.x, 0}, block.size_m);
      block.patch_m = patch_m;
      const double left_m = bar * (3 * width_m + gap_m), top_m = row * (length_m + gap_m);
      // As seen from outside: its right side is to the left of its front.
      block.faces[2] = FaceSheet{left_m, top_m};
      block.faces[0] = FaceSheet{left_m + width_m, top_m};
      block.faces[3] = FaceSheet{left_m + 2 * width_m, top_m};
      add_block(builder, block);
    }
  Sheet sheet;
  sheet.width_m = bars * (3 * width_m + gap_m) - gap_m;
  sheet.height_m = rows * (length_m + gap_m) - gap_m;
  sheet.along = "bars clockwise, of each: a side, the front, a side";
  sheet.down = "rows downwards, along each bar";
  sheet.first_bearing_rad = first_rad;
  return builder.finish(SurfaceKind::anodes, sheet);
}

}  // namespace slackwater::twin
