#include "twin/vehicle/read_cross_flow.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr std::array<std::pair<double, double>, 20> hoerners_curve{
    {{0.0108623, 1.96608}, {0.176606, 1.96573}, {0.353025, 1.89756},  {0.451863, 1.78718},
     {0.472838, 1.58374},  {0.492877, 1.27862}, {0.493252, 1.21082},  {0.558473, 1.08356},
     {0.646401, 0.998631}, {0.833589, 0.87959}, {0.988002, 0.828415}, {1.30807, 0.759941},
     {1.63918, 0.691442},  {1.85998, 0.657076}, {2.31288, 0.630693},  {2.59998, 0.596186},
     {3.00877, 0.586846},  {3.45075, 0.585909}, {3.7379, 0.559877},   {4.00309, 0.559315}}};

/// A number for all strips, or one for each of them.
std::vector<double> read_by_strip(const Config& c, const char* key, Range range,
                                  std::size_t strips) {
  std::vector<double> values = c.numbers(key, range);
  if (values.empty()) c.refuse(key, "expected a number, or one for each strip");
  if (values.size() == 1) values.resize(strips, values.front());
  if (values.size() != strips)
    c.refuse(key, formatted("found {} numbers for {} strips; give one for all or one for each, "
                            "from the stern on",
                            values.size(), strips));
  return values;
}

constexpr Range drag_coefficients{0, 5};
constexpr Range strip_widths_m{0, 100};

/// C_d times the width of each strip across the flow.
std::vector<double> read_drag_areas(const Config& c, const char* width_key, std::size_t strips) {
  std::vector<double> across = read_by_strip(c, "drag_coefficient", drag_coefficients, strips);
  const std::vector<double> width_m = read_by_strip(c, width_key, strip_widths_m, strips);
  for (std::size_t i = 0; i < strips; ++i) across[i] *= width_m[i];
  return across;
}

std::vector<double> read_sections(const Config& c, std::size_t strips) {
  std::vector<double> across = read_by_strip(c, "breadth_m", {1e-3, 100}, strips);
  const std::vector<double> draught_m = read_by_strip(c, "draught_m", {1e-3, 50}, strips);
  for (std::size_t i = 0; i < strips; ++i) {
    const double ratio = 0.5 * across[i] / draught_m[i];
    if (ratio < hoerners_curve.front().first || ratio > hoerners_curve.back().first)
      c.refuse("breadth_m",
               formatted("found {:g} m on a draught of {:g} m, B/2T = {:.3g}; Hoerner's curve goes "
                         "from 0.0109 to 4: give drag_coefficient and depth_m",
                         across[i], draught_m[i], ratio));
    across[i] = hoerner_drag_coefficient(ratio) * draught_m[i];
  }
  return across;
}

void refuse_two_words_for_one_drag(const Config& vehicle, const char* derivative, double found,
                                   const char* strips) {
  if (found == 0) return;
  vehicle.refuse("cross_flow",
                 formatted("found {} beside damping.{}; both are the drag of the same flow: "
                           "leave {} out",
                           strips, derivative, derivative));
}

}  // namespace

double hoerner_drag_coefficient(double half_breadth_per_draught) {
  const double at = std::clamp(half_breadth_per_draught, hoerners_curve.front().first,
                               hoerners_curve.back().first);
  std::size_t i = 0;
  while (i + 2 < hoerners_curve.size() && hoerners_curve[i + 1].first < at) ++i;
  const auto& [x, y] = hoerners_curve[i];
  const auto& [next_x, next_y] = hoerners_curve[i + 1];
  return y + (next_y - y) * (at - x) / (next_x - x);
}

void read_cross_flow(const Config& vehicle, double length_m, Body& body) {
  const auto c = vehicle.optional_child("cross_flow");
  if (!c) return;
  const double from = c->number("from_x_m", {-200, 200});
  const double to = c->number("to_x_m", {-200, 200});
  if (!(to > from)) c->refuse("to_x_m", "expected it forward of from_x_m");
  constexpr double over_the_ends = 1.05;
  if (to - from > over_the_ends * length_m)
    c->refuse("to_x_m", formatted("found strips over {:g} m of a vehicle that is {:g} m long; "
                                  "expected no more. Check the unit",
                                  to - from, length_m));
  CrossFlow& flow = body.cross_flow;
  flow.strips = static_cast<std::size_t>(c->integer("strips", 1, most_cross_flow_strips));
  const auto sway = c->optional_child("sway");
  const auto heave = c->optional_child("heave");
  if (!sway && !heave) c->refuse("sway", "found neither sway nor heave; give one of them or both");
  flow.is_there = true;
  const double strip_m = (to - from) / static_cast<double>(flow.strips);
  const double per_m2 = 0.5 * body.fluid_density_kg_m3 * strip_m;
  for (std::size_t i = 0; i < flow.strips; ++i)
    flow.x_m[i] = from + strip_m * (static_cast<double>(i) + 0.5);
  if (sway) {
    refuse_two_words_for_one_drag(vehicle, "Y_v_abs_v", body.quadratic_damping.linear.y, "sway");
    const auto section = sway->optional_child("section");
    const std::vector<double> across = section ? read_sections(*section, flow.strips)
                                               : read_drag_areas(*sway, "depth_m", flow.strips);
    for (std::size_t i = 0; i < flow.strips; ++i) flow.sway_n_s2_m2[i] = per_m2 * across[i];
  }
  if (heave) {
    refuse_two_words_for_one_drag(vehicle, "Z_w_abs_w", body.quadratic_damping.linear.z, "heave");
    const std::vector<double> across = read_drag_areas(*heave, "breadth_m", flow.strips);
    for (std::size_t i = 0; i < flow.strips; ++i) flow.heave_n_s2_m2[i] = per_m2 * across[i];
  }
}

}  // namespace slackwater::twin
