#pragma once
#include <optional>
#include <string>
#include <vector>

#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// What a product says of the depth of the mixed layer on one day.
struct LayerFigure {
  double depth_m = 0;    ///< > 0
  double log_sigma = 0;  ///< of its logarithm, as the base of the layer that the wind moves; > 0
  std::string source;    ///< "mlotst", "thetao"
};

/// A stated mixed-layer depth (`mlotst`): geometric mean of the day's values, m; nothing without
/// any. The layer that momentum reaches is not the layer that a density step of the last days
/// bounds: the two differ by a factor of 1.5 (Brainerd and Gregg 1995, Deep-Sea Res. I 42, 1521).
[[nodiscard]] std::optional<LayerFigure> stated_layer(const std::vector<double>& depth_m);

/// Where a temperature profile first differs by 0.2 K from that at 10 m (de Boyer Montegut et al.
/// 2004, J. Geophys. Res. 109, C12003), linear between levels; a wide step between levels widens
/// `log_sigma`. Nothing where the profile does not reach below 10 m, or never differs: then the
/// water is mixed as deep as the profile goes, and the base lies somewhere below.
///
/// @param level_m        depths, growing
/// @param temperature_k  as many; NaN where there is none
[[nodiscard]] std::optional<LayerFigure> layer_of_profile(const std::vector<double>& level_m,
                                                          const std::vector<double>& temperature_k);

/// A day's priors with the product's figure in them. Where yesterday taught the depth, its ratio to
/// the product's figure is what was learnt: it is carried to today's figure. Else the figure itself
/// is the prior.
[[nodiscard]] std::vector<KnownParameter> with_layer(std::vector<KnownParameter> known,
                                                     const std::optional<LayerFigure>& yesterday,
                                                     const std::optional<LayerFigure>& today);

}  // namespace slackwater::calibration
