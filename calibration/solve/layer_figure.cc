#include "calibration/solve/layer_figure.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

constexpr double reference_m = 10.0;
constexpr double step_k = 0.2;
constexpr double momentum_log_sigma = 0.4;
constexpr const char* layer_name = "mixed_layer_depth";

}  // namespace

std::optional<LayerFigure> stated_layer(const std::vector<double>& depth_m) {
  double logarithms = 0;
  double count = 0;
  for (const double depth : depth_m) {
    if (!(depth > 0) || !std::isfinite(depth)) continue;
    logarithms += std::log(depth);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return LayerFigure{std::exp(logarithms / count), momentum_log_sigma, "mlotst"};
}

std::optional<LayerFigure> layer_of_profile(const std::vector<double>& level_m,
                                            const std::vector<double>& temperature_k) {
  expects(level_m.size() == temperature_k.size(), "a temperature for every level");
  double last_m = 0;
  double last_k = 0;
  double at_reference_k = 0;
  bool begun = false;
  bool is_below = false;
  for (std::size_t i = 0; i < level_m.size(); ++i) {
    const double depth = level_m[i];
    const double kelvin = temperature_k[i];
    if (!std::isfinite(kelvin)) continue;
    if (!is_below && depth >= reference_m) {
      is_below = true;
      at_reference_k = begun && depth > last_m
                           ? last_k + (kelvin - last_k) * (reference_m - last_m) / (depth - last_m)
                           : kelvin;
      last_m = begun ? reference_m : depth;
      last_k = at_reference_k;
    }
    if (is_below && std::abs(kelvin - at_reference_k) >= step_k) {
      const double before = std::abs(last_k - at_reference_k);
      const double after = std::abs(kelvin - at_reference_k);
      const double depth_m = last_m + (depth - last_m) * (step_k - before) / (after - before);
      const double spacing = (depth - last_m) / (std::sqrt(12.0) * depth_m);
      return LayerFigure{depth_m, std::hypot(momentum_log_sigma, spacing), "thetao"};
    }
    last_m = depth;
    last_k = kelvin;
    begun = true;
  }
  return std::nullopt;
}

std::vector<KnownParameter> with_layer(std::vector<KnownParameter> known,
                                       const std::optional<LayerFigure>& yesterday,
                                       const std::optional<LayerFigure>& today) {
  if (!today) return known;
  const auto found = std::find_if(known.begin(), known.end(),
                                  [](const KnownParameter& k) { return k.name == layer_name; });
  if (found == known.end()) {
    known.push_back({layer_name, today->depth_m, today->log_sigma, today->source + " of the day"});
  } else if (yesterday) {
    found->value *= today->depth_m / yesterday->depth_m;
    found->source = "the day before, aged, moved as " + today->source + " moved";
  }
  return known;
}

}  // namespace slackwater::calibration
