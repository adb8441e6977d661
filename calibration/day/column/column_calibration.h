#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calibration/solve/calibration.h"
#include "calibration/solve/layer_figure.h"
#include "calibration/tide/fitted_tide.h"

namespace slackwater::calibration {

/// Day D at one column under every form that may hold there.
struct ColumnCalibration {
  std::vector<Calibration> forms;  ///< empty where nothing could be fitted
  std::string problem;             ///< why, in words, where there are no forms
  /// Index of the form of greatest probability.
  [[nodiscard]] std::size_t best() const;
};

/// The forms that may hold in this water: the whole column and a mixed layer where surface and bed
/// layer can meet, the mixed layer in deeper water. (The layered steady column has no memory and
/// loses against both on every real day of inertial motion.)
[[nodiscard]] std::vector<SteadyForm> forms_in(double water_depth_m, Angle latitude);

/// Per day.
using LayerOfDays = std::map<UtcDay, LayerFigure>;

/// Removes this tide from the record and calibrates the day, each form with what the `chain_days`
/// days before have taught (calibration/solve/ageing.h): the first of them starts from the general
/// priors.
///
/// @param known  currents up to the end of D, one dataset
/// @param wind   around the chain of days; nothing where none is stored
/// @param layer  what a product says of the mixed layer on those days, where it says anything
/// @param noise_m_s  Chosen::noise_m_s of `known`: values count by it; empty: none is stated
[[nodiscard]] ColumnCalibration calibrate_column(const VectorColumn& known, const FittedTide& tide,
                                                 UtcDay day, Angle latitude, double water_depth_m,
                                                 const std::optional<VectorColumn>& wind,
                                                 const LayerOfDays& layer = {},
                                                 const std::vector<double>& noise_m_s = {});

inline constexpr int chain_days = 3;

}  // namespace slackwater::calibration
